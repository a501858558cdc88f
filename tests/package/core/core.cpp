// The core in another project's build, and nothing else.
#include "fluid/wind.h"

int main() {
    auto wind = windrow::Wind::create({.cells = {8, 8, 8}, .ambient = {3.0f, 0.0f, 0.0f}});
    if (!wind)
        return 1;
    wind->step(1.0 / 60.0);
    return wind->velocity({0.0, 0.0, 0.0}).x > 2.9f ? 0 : 1;
}
