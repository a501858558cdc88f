#define WINDROW_LEVEL avx512
#include "tests/bench/reference/level.inl"
