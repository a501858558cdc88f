#define WINDROW_LEVEL avx512
#define WINDROW_LEVEL_NAME "avx512"
#include "fluid/cpu/kernels/level.inl"
