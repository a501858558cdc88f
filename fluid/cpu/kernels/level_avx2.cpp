#define WINDROW_LEVEL avx2
#define WINDROW_LEVEL_NAME "avx2"
#include "fluid/cpu/kernels/level.inl"
