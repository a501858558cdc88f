#define WINDROW_LEVEL baseline
#include "cases/reference/level.inl"
