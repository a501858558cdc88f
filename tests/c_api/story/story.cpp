// The story of story_test.py in C++: a second of gusts, a jet and a block in a box that follows; the hash of the wind's snapshot.
#include <cinttypes>
#include <cstdio>
#include <windrow/fluid/wind.h>

int main() {
    auto wind = windrow::Wind::create({.cells = {24, 12, 20},
                                       .cell_size = 0.75f,
                                       .boundaries = windrow::Boundaries::open_over_floor(),
                                       .ambient = {3.0f, 0.0f, 1.0f},
                                       .gusts = {.intensity = 0.2f},
                                       .simd = windrow::Simd::baseline});
    if (!wind)
        return std::fprintf(stderr, "%s\n", wind.error().c_str()), 2;
    const auto block = wind->obstacles().add({.position = {2.0, 1.0, 0.5}, .shape = windrow::Block{{0.5f, 1.0f, 0.8f}}});
    const auto jet = wind->motors().add(windrow::JetMotor{.position = {-3.0, 1.5, 0.0}});
    if (!block || !jet)
        return std::fprintf(stderr, "%s\n", (block ? jet.error() : block.error()).c_str()), 2;
    for (int frame = 0; frame < 60; ++frame) {
        if (!wind->follow({frame / 20.0, 1.0, 0.0}) || !wind->motors().move(*jet, {frame / 16.0 - 3.0, 1.5, 0.0}))
            return 2;
        wind->advance(1.0 / 60.0);
    }
    const auto bytes = wind->save();
    std::uint64_t hash = 0xcbf29ce484222325; // FNV-1a
    for (const std::byte byte : *bytes)
        hash = (hash ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3;
    std::printf("%016" PRIx64 "\n", hash);
}
