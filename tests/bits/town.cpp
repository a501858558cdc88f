// Obstacles of every shape on terrain, at rest, moving and turning, in a box with rows of its own that follows and sinks.
#include "fluid/wind.h"
#include "tests/bits/stories.h"

#include <memory>

namespace windrow::bits {
namespace {

constexpr int k_town_frames = 80;

MeshData tetrahedron() {
    return {.vertices = {{-1.5f, -1.0f, -1.2f}, {1.7f, -1.0f, -1.0f}, {0.0f, -1.0f, 1.9f}, {0.2f, 2.2f, 0.0f}},
            .triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
}

VoxelData stairs() {
    VoxelData data{.cells = {5, 4, 3}, .closed = std::vector<std::uint8_t>(60)};
    for (int z = 0; z < 3; ++z)
        for (int y = 0; y < 4; ++y)
            for (int x = y; x < 5; ++x)
                data.closed[static_cast<std::size_t>((z * 4 + y) * 5 + x)] = 1;
    return data;
}

HeightData hills() {
    HeightData data{.corners = {23, 19}, .spacing = 2.0f};
    Numbers numbers(5);
    for (int z = 0; z < 19; ++z)
        for (int x = 0; x < 23; ++x)
            data.heights.push_back(numbers.between(0.0f, 0.8f) + static_cast<float>(1.5 + 1.5 * swing(x + z, 16)));
    return data;
}

struct Town {
    std::vector<ObstacleId> all;
    ObstacleId mill, train, door;
};

Town build(Obstacles& obstacles) {
    Town town;
    const auto add = [&](const Obstacle& obstacle) {
        town.all.push_back(must(obstacles.add(obstacle)));
        return town.all.back();
    };
    (void)add({.position = {-20.0, -1.0, -18.0}, .shape = Ground{must(HeightMap::create(hills())), glm::vec3(1.0f)}});
    (void)add({.position = {-6.0, 3.0, -5.0}, .shape = Sphere{2.1f}});
    (void)add({.position = {-2.0, 4.0, 7.0}, .shape = Capsule{.half_axis = {1.0f, 1.0f, 0.5f}, .radius = 0.8f}});
    (void)add({.position = {3.0, 3.0, -7.0}, .orientation = {0.9f, 0.1f, 0.3f, 0.0f}, .shape = Block{{2.0f, 3.0f, 1.5f}}});
    (void)add({.position = {-8.0, 3.0, 5.0}, .shape = Cylinder{.radius = 0.4f, .half_length = 3.0f}}); // thinner than a cell
    (void)add({.position = {6.5, 3.0, 6.0},
               .shape = MeshShape{must(TriangleMesh::create(tetrahedron())), 1.2f},
               .surface = Surface::no_slip});
    (void)add({.position = {0.5, 3.5, 0.0}, .shape = VoxelShape{must(VoxelGrid::create(stairs())), 0.7f}});
    town.mill = add({.position = {8.0, 5.0, -2.0}, .shape = Plate{{2.5f, 1.2f}}});
    town.train = add({.position = {-9.0, 3.5, 0.0}, .shape = Block{{1.6f, 1.2f, 1.0f}}, .surface = Surface::no_slip});
    town.door = add({.position = {2.0, 3.0, 4.0}, .shape = Plate{{1.0f, 1.5f}}});
    return town;
}

void hash_forces(Hashes& hashes, const std::string& frame, const Wind& wind, const Town& town) {
    std::vector<float> forces;
    for (const ObstacleId id : town.all)
        if (const auto of = wind.force_on(id)) // one is removed on the way
            forces.insert(forces.end(),
                          {of->force.x, of->force.y, of->force.z, of->moment.x, of->moment.y, of->moment.z, of->pressure});
    hashes.add("forces/" + frame, forces);
}

} // namespace

std::vector<Hash> town(Simd level, ParallelFor parallel_for) {
    Hashes hashes("town");
    Wind wind = must(Wind::create({.cells = {27, 15, 22},
                                   .boundaries = Boundaries::open_over_floor(),
                                   .ambient = {7.0f, 0.0f, -2.0f},
                                   .profile = LogProfile{.roughness_length = 0.1f},
                                   .gusts = {.intensity = 0.15f},
                                   .roughness = Roughness{.length = 0.2f},
                                   .rows = Rows{.first = 0.6f, .uniform = 6, .ratio = 1.13f},
                                   .viscosity = 0.02f,
                                   .simd = level,
                                   .parallel_for = parallel_for}));
    const Town town = build(wind.obstacles());
    (void)must(wind.motors().add(OmniMotor{.position = {-3.0, 4.0, 2.0}, .speed = 2.0f}));
    const MotorId wake = must(wind.motors().add(WakeMotor{.position = {-9.0, 3.5, 0.0}, .radius = 1.2f}));
    for (int frame = 0; frame < k_town_frames; ++frame) {
        const double turn = 0.2 * frame;
        must(wind.obstacles().move(town.mill, {8.0, 5.0, -2.0}, {1.0f, static_cast<float>(0.3 * turn), 0.2f, -0.4f}));
        const glm::dvec3 train(-9.0 + 0.13 * frame, 3.5, 1.5 * swing(frame, 50));
        must(wind.obstacles().move(town.train, train));
        must(wind.motors().move(wake, train));
        must(wind.obstacles().move(town.door, {2.0, 3.0, 4.0}, {1.0f, 0.0f, static_cast<float>(swing(frame, 30)), 0.0f}));
        if (frame == 25)
            must(wind.obstacles().set(town.all[1], {.position = {-5.0, 3.0, -4.0}, .shape = Block{{1.0f, 2.0f, 1.0f}}}));
        if (frame == 60)
            must(wind.obstacles().remove(town.all[2]));
        if (frame == 30)
            must(wind.set_floor(-0.6));
        must(wind.follow({0.03 * frame, 0.0, 0.0}));
        wind.advance(frame % 3 == 0 ? 1.0 / 24.0 : 1.0 / 90.0);
        if (frame == 40) {
            const std::vector<std::byte> saved = must(wind.save());
            hashes.add("snapshot/40", saved);
            wind = must(Wind::load(saved, parallel_for));
        }
        if (frame == 20 || frame == 70) {
            hashes.add("cells/" + std::to_string(frame), std::as_bytes(wind.field()));
            hash_forces(hashes, std::to_string(frame), wind, town);
        }
    }
    std::vector<float> inside(wind.box().cell_count());
    must(wind.write_obstacles(inside));
    hashes.add("inside/end", inside);
    hashes.add("cells/end", std::as_bytes(wind.field()));
    hashes.add("snapshot/end", must(wind.save()));
    return hashes.list();
}

} // namespace windrow::bits
