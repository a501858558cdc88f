#define WINDROW_LEVEL baseline
#include "tests/bench/reference/level.inl"
