// An outside program: the package's own promise of ten lines.
#include <windrow/fluid/wind.h>
#ifdef WITH_COUPLING
#include <windrow/coupling/blade.h>
#endif
#ifdef WITH_VDB
#include <windrow/fluid/vdb/vdb_export.h>
#endif
#ifdef WITH_VULKAN
#include <windrow/fluid/vulkan/own_device.h>
#endif
#include <cstdio>

int main() {
    auto wind = windrow::Wind::create({.cells = {8, 8, 8}, .ambient = {3.0f, 0.0f, 0.0f}});
    if (!wind)
        return std::fprintf(stderr, "%s\n", wind.error().c_str()), 1;
    if (auto fan = wind->motors().add(windrow::DirectionalMotor{.direction = {0.0f, 1.0f, 0.0f}}); !fan)
        return std::fprintf(stderr, "%s\n", fan.error().c_str()), 1;
    wind->step(1.0 / 60.0);
#ifdef WITH_COUPLING
    auto grass = windrow::Blades::create({});
    if (!grass)
        return std::fprintf(stderr, "%s\n", grass.error().c_str()), 1;
    const windrow::PlantKey key = windrow::place_key(1.0f, 2.0f);
    const glm::vec3 load = grass->load(key, wind->velocity({1.0, 0.1, 2.0}));
    if (!(grass->vertex(key, load, 1.0f, 0.0f).position.y > 0.0f))
        return std::fprintf(stderr, "the blade's tip lies in the ground\n"), 1;
#endif
#ifdef WITH_VDB
    if (auto written = windrow::vdb::write(windrow::vdb::grid_of(*wind), "wind.vdb"); !written)
        return std::fprintf(stderr, "%s\n", written.error().c_str()), 1;
#endif
#ifdef WITH_VULKAN
    // The loader is looked for now and not before: where there is none the program runs, and is told.
    if (const auto devices = windrow::vulkan::list_devices(); !devices)
        std::printf("%s\n", devices.error().c_str());
#endif
    return wind->velocity({0.0, 0.0, 0.0}).y > 0.0f ? 0 : 1;
}
