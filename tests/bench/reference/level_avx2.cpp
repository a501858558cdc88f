#define WINDROW_LEVEL avx2
#include "tests/bench/reference/level.inl"
