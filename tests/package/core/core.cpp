// The core in another project's build, and nothing else. The project has a fluid/box.h of its own, and a profiler.
#include "fluid/box.h"

#include <cstdio>
#include <string>
#include <vector>
#include <windrow/fluid/wind.h>

std::vector<std::string> open_zones;
std::string seen;

extern "C" void game_zone_begin(const char* name) {
    open_zones.emplace_back(name);
    for (const std::string& zone : open_zones)
        seen += "/" + zone;
    seen += "\n";
}
extern "C" void game_zone_end() {
    open_zones.pop_back();
}

int main() {
    auto wind = windrow::Wind::create({.cells = {8, 8, 8}, .ambient = {3.0f, 0.0f, 0.0f}, .viscosity = 10.0f});
    if (!wind || game::Box{}.bottles != 12 || !wind->motors().add(windrow::DirectionalMotor{}))
        return 1;
    wind->step(1.0 / 60.0);
    for (const char* stage : {"sources", "diffusion", "advection", "projection"})
        if (seen.find("/windrow step/windrow " + std::string(stage) + "\n") == std::string::npos || !open_zones.empty())
            return std::printf("the profiler has no '%s':\n%s", stage, seen.c_str()), 1;
    return wind->velocity({0.0, 0.0, 0.0}).x > 2.9f ? 0 : 1;
}
