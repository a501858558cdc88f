#define WINDROW_LEVEL avx512
#include "cases/reference/level.inl"
