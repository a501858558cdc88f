// A plug-in of an engine: a module that links the installed archives, with its own copy of the library inside.
#include <windrow/fluid/wind.h>

extern "C" __attribute__((visibility("default"))) float wind_at_leaf() {
    auto wind = windrow::Wind::create({.cells = {8, 8, 8}, .ambient = {3.0f, 0.0f, 0.0f}});
    if (!wind)
        return -1.0f;
    wind->step(1.0 / 60.0);
    return wind->velocity({0.0, 0.0, 0.0}).x;
}
