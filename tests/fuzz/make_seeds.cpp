// Writes the binary seeds of the fuzz targets into a folder: snapshots, event logs, and a mesh as GLB.
#include "coupling/cascade.h"
#include "coupling/ground_memory.h"
#include "fluid/event_log.h"
#include "fluid/saved_parts.h"
#include "fluid/wind.h"
#include "vegetation/tests/fur/fixtures.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <vector>

namespace {

using namespace windrow;
namespace mesh = vegetation::fur::test;

std::filesystem::path seeds;

void write(const char* name, std::string_view bytes) {
    std::filesystem::create_directories((seeds / name).parent_path());
    std::ofstream(seeds / name, std::ios::binary) << bytes;
}

void write(const char* name, const Result<std::vector<std::byte>>& bytes) {
    write(name, std::string_view(reinterpret_cast<const char*>(bytes->data()), bytes->size()));
}

Wind made(const Config& config) {
    auto wind = Wind::create(config);
    if (!wind)
        std::fprintf(stderr, "%s\n", wind.error().c_str());
    return *std::move(wind);
}

void add_motors(Wind& wind) {
    const Envelope gust{.attack = 0.25f, .hold = 40.0f, .decay = 0.5f};
    const glm::vec3 aslant(1.0f, 0.5f, -2.0f);
    const Motor motors[] = {
        DirectionalMotor{.direction = aslant, .region = Sphere{3.0f}, .law = Force{12.0f}},
        DirectionalMotor{.region = Capsule{.half_axis = aslant}, .envelope = gust, .turbulence = {.intensity = 0.3f}},
        DirectionalMotor{.region = AlignedBox{{1.0f, 2.0f, 3.0f}}},
        DirectionalMotor{.region = Cone{}, .law = Drive{.speed = -3.0f, .rate = 2.0f}},
        WakeMotor{.radius = 1.2f, .law = WakeForce{2.0f}},
        WakeMotor{.radius = 0.9f},
        JetMotor{.direction = aslant, .envelope = gust},
        VortexMotor{.axis = aslant, .lift = 0.5f, .law = Force{5.0f}},
        OmniMotor{.speed = 3.0f, .envelope = gust},
        PressureMotor{.duration = 0.4f},
    };
    for (const Motor& motor : motors)
        (void)wind.motors().add(motor);
}

void add_obstacles(Wind& wind) {
    const glm::quat aslant(1.0f, 0.5f, -2.0f, 0.0f);
    const MeshData tetrahedron{.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                               .triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
    const Obstacle obstacles[] = {
        {.position = {0.5, 0.0, 0.0}, .orientation = aslant},
        {.shape = Sphere{0.75f}, .surface = Surface::no_slip},
        {.shape = Capsule{.half_axis = {0.0f, 1.0f, 0.5f}}},
        {.shape = Cylinder{}},
        {.shape = MeshShape{*TriangleMesh::create(tetrahedron), 1.5f}},
        {.shape = VoxelShape{*VoxelGrid::create({.cells = {2, 1, 2}, .closed = {1, 1, 0, 1}}), 0.5f}},
        {.shape = Ground{*HeightMap::create(HeightData{{2, 2}, 1.0f, {0.0f, 0.5f, 0.0f, 0.0f}})}},
        {.orientation = aslant, .shape = Plate{}},
    };
    ObstacleId last;
    for (const Obstacle& obstacle : obstacles)
        last = *wind.obstacles().add(obstacle);
    (void)wind.obstacles().move(last, {0.25, 0.0, 0.5}, {1.0f, 0.0f, 0.0f, 0.0f});
}

/// Snapshots of the smallest boxes: most bytes are then state and not cells.
void write_snapshots() {
    write("snapshot/fresh", made({.cells = {3, 3, 3}}).save());
    Wind stepped = made({.cells = {3, 4, 3}, .boundaries = Boundaries::open_over_floor(), .ambient = {2.0f, 0.0f, 1.0f}});
    add_motors(stepped);
    for (int n = 0; n < 3; ++n)
        (void)stepped.step(1.0 / 60.0);
    write("snapshot/motors", stepped.save());
    Wind built = made({.cells = {3, 4, 3}, .ambient = {2.0f, 0.0f, 1.0f}});
    add_obstacles(built);
    (void)built.step(1.0 / 60.0);
    write("snapshot/obstacles", built.save());
    Wind ticking = made({.cells = {3, 3, 3}, .ambient = {1.0f, 0.0f, 0.0f}, .ticks = {.hz = 30.0}});
    (void)ticking.follow({0.5, 0.0, 0.0});
    (void)ticking.advance(0.05);
    write("snapshot/ticks", ticking.save());
    Config config{.cells = {2, 3, 2}, .boundaries = Boundaries::open_over_floor(), .ambient = {3.0f, 0.0f, 0.0f}};
    config.profile = LogProfile{};
    config.canopy = Canopy{};
    config.gusts.intensity = 0.25f;
    config.scheme = Scheme::stable_fluids;
    Wind gusty = made(config);
    (void)gusty.step(1.0 / 60.0);
    write("snapshot/gusts", gusty.save());
}

/// Calls of a host on the box of the target, each kind once.
void write_logs() {
    write("event_log/empty", EventLog().to_bytes());
    Wind wind = made({.cells = {3, 3, 3}});
    EventLog log;
    wind.record_to(&log);
    add_motors(wind);
    add_obstacles(wind);
    write("event_log/motors", log.to_bytes());
    log.clear();
    Wind calls = made({.cells = {3, 3, 3}});
    calls.record_to(&log);
    const auto wake = calls.motors().add(WakeMotor{.radius = 1.2f});
    (void)calls.motors().set(*wake, WakeMotor{.radius = 0.8f});
    (void)calls.motors().move(*wake, {1.0, 0.0, 0.5});
    const auto body = calls.obstacles().add({.shape = Sphere{0.75f}});
    (void)calls.obstacles().set(*body, {.shape = Plate{}});
    (void)calls.obstacles().move(*body, {0.5, 0.0, 0.0});
    (void)calls.obstacles().move(*body, {0.5, 0.0, 0.5}, {1.0f, 1.0f, 0.0f, 0.0f});
    (void)calls.follow({0.25, 0.0, 0.0});
    (void)calls.set_ambient({1.0f, 0.0f, 2.0f});
    (void)calls.set_boundaries(Boundaries::open_over_floor());
    (void)calls.set_floor(-1.0);
    (void)calls.step(1.0 / 60.0);
    (void)calls.motors().remove(*wake);
    (void)calls.obstacles().remove(*body);
    (void)calls.advance(0.02);
    calls.reset();
    write("event_log/calls", log.to_bytes());
    log.clear();
    (void)calls.set_velocity(std::vector<glm::vec4>(27, glm::vec4(1.0f, 0.0f, 0.0f, 0.0f)));
    (void)calls.set_gusts({.intensity = 0.2f});
    (void)calls.step(1.0 / 60.0);
    write("event_log/fields", log.to_bytes());
}

/// Small states in mid-motion, and two of them in one file.
void write_saved() {
    auto ground = *GroundMemory::create({.texels = 8, .texel_size = 1.0f});
    const GroundWalker walker{.position = {0.2, 0.0, 0.1}};
    for (int n = 0; n < 2; ++n)
        (void)ground.advance({.duration = 0.02, .walkers = {&walker, 1}, .wind_lean = {0.1f, 0.0f}});
    write("saved/ground", ground.save());
    auto tail = *Cascade::create({.stages = 2}, {});
    (void)tail.advance(0.02, {.position = {0.1, 0.0, 0.0}});
    write("saved/cascade", tail.save());
    std::vector<float> place{0.1f, 0.2f}, velocity{0.0f, 1.0f}, target{0.3f, 0.0f};
    write("saved/springs", save_springs<float>({place, velocity, target, target}));
    const auto one = tail.save();
    const SavedPart parts[] = {{"tail", *one}, {"none", {}}};
    write("saved/parts", join_parts(parts));
}

} // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::fprintf(stderr, "usage: %s FOLDER\n", arguments[0]);
        return 2;
    }
    seeds = arguments[1];
    write_snapshots();
    write_logs();
    write_saved();
    write("glb/cube", mesh::cube_glb());
    return 0;
}
