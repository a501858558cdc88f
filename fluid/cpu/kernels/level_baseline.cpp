#define WINDROW_LEVEL baseline
#define WINDROW_LEVEL_NAME "baseline"
#include "fluid/cpu/kernels/level.inl"
