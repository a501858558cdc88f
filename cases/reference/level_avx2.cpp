#define WINDROW_LEVEL avx2
#include "cases/reference/level.inl"
