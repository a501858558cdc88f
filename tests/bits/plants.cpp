// Plants in winds of whole numbers: what bends and what swings, each as a batch.
#include "coupling/blade.h"
#include "coupling/cascade.h"
#include "coupling/ground_memory.h"
#include "coupling/plant_classes.h"
#include "coupling/shell.h"
#include "coupling/spring.h"
#include "coupling/tree.h"
#include "tests/bits/stories.h"

#include <glm/geometric.hpp>

namespace windrow::bits {
namespace {

constexpr std::size_t k_plants = 500;

std::vector<glm::vec4> vectors(std::uint32_t seed, float size, std::size_t count = k_plants) {
    Numbers numbers(seed);
    std::vector<glm::vec4> list(count);
    for (glm::vec4& one : list) {
        const float x = numbers.between(-size, size), y = numbers.between(-0.2f * size, 0.2f * size);
        one = {x, y, numbers.between(-size, size), numbers.between(0.0f, 1.0f)};
    }
    return list;
}

std::vector<glm::vec4> normals(std::uint32_t seed) {
    std::vector<glm::vec4> list = vectors(seed, 1.0f);
    for (glm::vec4& one : list)
        one = glm::vec4(glm::normalize(glm::vec3(one) + glm::vec3(0.0f, 1.5f, 0.0f)), 0.0f);
    return list;
}

void blades(Hashes& hashes, const ParallelFor& parallel_for) {
    const std::vector<glm::vec4> winds = vectors(1, 12.0f), roots = vectors(2, 30.0f);
    std::vector<PlantKey> keys;
    for (std::uint32_t n = 0; n < k_plants; ++n)
        keys.emplace_back(n * 7919u, n ^ 0x5bd1e995u);
    const std::vector<float> heights{0.0f, 0.3f, 0.7f, 1.0f};
    for (const auto& [name, drag] : {std::pair("grass", grass()), std::pair("reed", reed())}) {
        const Blades blades = must(Blades::create({.stalk = drag, .along_wind = 0.6f, .view_bend = 0.4f}));
        std::vector<glm::vec4> loads(k_plants), places(8 * k_plants), sides(8 * k_plants);
        must(blades.loads(keys, winds, loads, parallel_for));
        must(blades.vertices(keys, roots, loads, heights, {places, sides}, {0.6f, -0.8f, 0.0f}, parallel_for));
        hashes.add(std::string("blades/") + name + "/loads", loads);
        hashes.add(std::string("blades/") + name + "/places", places);
        hashes.add(std::string("blades/") + name + "/normals", sides);
    }
}

void shells(Hashes& hashes, const ParallelFor& parallel_for) {
    const std::vector<glm::vec4> skin = vectors(3, 1.0f), up = normals(4), winds = vectors(5, 8.0f);
    ShellSettings settings{.spacing = 1.3f, .push_exponent = 2.3f, .droop = 0.004f};
    settings.strand.vogel_exponent = -0.7f;
    const Shells shells = must(Shells::create(settings));
    std::vector<glm::vec4> loads(k_plants), out(k_plants);
    must(shells.loads({skin, up}, winds, loads, parallel_for));
    hashes.add("shells/loads", loads);
    must(shells.bent({skin, up}, shells.height(20), loads, out, parallel_for));
    hashes.add("shells/bent", out);
    must(shells.translated({skin, up}, shells.height(9), winds, out, parallel_for));
    hashes.add("shells/translated", out);
}

void tree(Hashes& hashes, const ParallelFor& parallel_for) {
    const Tree tree = must(Tree::create({}));
    const std::vector<TreePart> parts{
        {.axis = {0.0f, 1.0f, 0.0f}, .length = 6.0f, .stiffness = 1.0f},
        {.root = {0.0f, 3.0f, 0.0f}, .axis = {0.8f, 0.6f, 0.0f}, .length = 2.0f, .stiffness = 1.5f},
        {.root = {1.0f, 4.0f, 0.2f}, .axis = {0.0f, 0.6f, 0.8f}, .length = 0.2f, .stiffness = 2.0f}};
    const std::vector<glm::vec4> winds = vectors(6, 9.0f, 3), up = normals(7);
    std::vector<glm::vec4> rest = vectors(8, 2.0f), places(k_plants), turned(k_plants);
    std::vector<Tree::PartIndices> bearers;
    for (std::size_t n = 0; n < k_plants; ++n) {
        rest[n].y += 4.0f;
        bearers.push_back({0, n % 2 == 0 ? 1 : Tree::PartIndices::k_none, n % 4 == 0 ? 2 : Tree::PartIndices::k_none});
    }
    must(tree.vertices(parts, winds, {rest, up, bearers}, places, turned, parallel_for));
    hashes.add("tree/places", places);
    hashes.add("tree/normals", turned);
}

void springs_and_cascade(Hashes& hashes, const ParallelFor& parallel_for) {
    std::vector<float> place(k_plants), velocity(k_plants), before(k_plants), now(k_plants);
    std::vector<double> exact(k_plants), exact_velocity(k_plants), target(k_plants);
    Cascade tail = must(Cascade::create({.stages = 24, .lag = 0.4}, {}));
    Numbers numbers(10);
    for (int frame = 0; frame < 60; ++frame) {
        const double duration = frame % 7 == 6 ? 0.4 : 1.0 / 60.0;
        for (std::size_t n = 0; n < k_plants; ++n) {
            before[n] = now[n];
            now[n] = numbers.between(-1.0f, 1.0f);
            target[n] = static_cast<double>(now[n]);
        }
        for (const SpringClass& spring : {springs::wheat, SpringClass{2.0, 1.0}, SpringClass{0.7, 3.0}}) {
            const SpringStep step = must(spring_step(spring, duration));
            must(advance_springs<float>(step, {place, velocity, before, now}, parallel_for));
            must(advance_springs<double>(step, {exact, exact_velocity, target, target}, parallel_for));
        }
        must(tail.advance(duration, {.position = {swing(frame, 31), 0.5 * swing(frame, 20), 0.0},
                                     .rotation = {swing(frame, 26), 0.2, 0.0, 1.0},
                                     .scale = 1.2}));
    }
    hashes.add("springs/places", place);
    hashes.add("springs/velocities", velocity);
    hashes.add("springs/places_in_double", exact);
    hashes.add("cascade/poses", std::as_bytes(tail.shader_poses({0.5, 0.0, 0.0})));
}

void ground(Hashes& hashes, const ParallelFor& parallel_for) {
    GroundMemory ground = must(GroundMemory::create({.texels = 48}, parallel_for));
    Numbers numbers(11);
    for (int frame = 0; frame < 90; ++frame) {
        const glm::dvec3 here(0.05 * frame, 0.0, swing(frame, 40)), there(0.05 * (frame - 1), 0.0, swing(frame + 39, 40));
        const std::vector<GroundWalker> walkers{{.position = here, .previous = there},
                                                {.position = -here, .previous = -there, .foot_height = 0.2f, .weight = 0.7f}};
        must(ground.follow(here));
        std::vector<glm::vec2> leans(48 * 48);
        for (glm::vec2& lean : leans) {
            lean.x = numbers.between(-0.5f, 0.5f);
            lean.y = numbers.between(-0.5f, 0.5f);
        }
        must(ground.advance({.duration = frame % 5 == 4 ? 0.1 : 1.0 / 60.0, .walkers = walkers, .wind_lean = {0.2f, 0.1f}},
                            leans));
    }
    hashes.add("ground/texels", std::as_bytes(ground.texels()));
}

} // namespace

std::vector<Hash> plants(ParallelFor parallel_for) {
    Hashes hashes("plants");
    blades(hashes, parallel_for);
    shells(hashes, parallel_for);
    tree(hashes, parallel_for);
    springs_and_cascade(hashes, parallel_for);
    ground(hashes, parallel_for);
    return hashes.list();
}

} // namespace windrow::bits
