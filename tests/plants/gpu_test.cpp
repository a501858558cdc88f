// The plants' formulas on the device against the CPU: one text, 1e5 random inputs; and the include that users' shaders take.
#include "coupling/blade.h"
#include "coupling/plant_numerics.h"
#include "coupling/shell.h"
#include "coupling/tree.h"
#include "shader_words/bend_plants.h"
#include "shader_words/wind_plants.h"
#include "tests/fields.h"
#include "tests/parity/wind_shader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

namespace windrow::vulkan {
namespace {

using test::Random;

// As bend_plants.comp has them, std430.
struct PlantCase {
    glm::vec4 wind, axis, view, place;
    glm::uvec4 key;
};
struct PlantAnswer {
    glm::uvec4 chance;
    glm::vec4 blade_load, blade_position, blade_normal, blade_tangent, shell_load, shell_bent, shell_translated, tree_position,
        tree_normal, masks, strand;
};
struct Classes {
    BladeBlock blade;
    ShellBlock shells;
    TreeBlock tree;
};

Classes classes() {
    const auto grass = Blades::create({.along_wind = 0.8f, .view_bend = 0.4f});
    const auto fur = Shells::create({.droop = 0.01f});
    const auto oak = Tree::create({});
    EXPECT_TRUE(grass && fur && oak);
    return {grass->block(), fur->block(), oak->block()};
}

numerics::WindrowBlade shared(const BladeBlock& block) {
    return {block.size, block.form, block.own, {block.drag.load}};
}
numerics::WindrowShells shared(const ShellBlock& block) {
    return {block.form, block.push, block.sag, {block.drag.load}};
}
numerics::WindrowTree shared(const TreeBlock& block) {
    return {{block.trunk.load}, {block.branch.load}, {block.leaf.load}};
}

PlantAnswer bend_case(const PlantCase& c, const Classes& kinds) {
    using namespace numerics;
    const auto wide = [](glm::vec3 v) { return glm::vec4(v, 0.0f); };
    const glm::vec3 wind(c.wind), axis(c.axis), view(c.view), place(c.place);
    const WindrowBlade blade = shared(kinds.blade);
    const WindrowShells shells = shared(kinds.shells);
    const WindrowTree tree = shared(kinds.tree);
    const float h = c.wind.w;
    const glm::uvec2 hash = windrow_plant_hash({c.key.x, c.key.y});
    PlantAnswer a{};
    a.chance = {hash.x, hash.y, std::bit_cast<std::uint32_t>(windrow_plant_yaw(hash)),
                std::bit_cast<std::uint32_t>(windrow_plant_factor(hash, 0.5f))};
    const glm::vec3 load = windrow_blade_load(blade, axis, hash, wind);
    const WindrowVertex v = windrow_blade_vertex(blade, windrow_blade_plant(blade, axis, hash, load, view), h, c.axis.w);
    a.blade_load = wide(load);
    a.blade_position = wide(v.position);
    a.blade_normal = wide(v.normal);
    a.blade_tangent = wide(v.tangent);
    const glm::vec3 strand = windrow_shell_load(shells, view, c.view.w, wind);
    a.shell_load = wide(strand);
    a.shell_bent = wide(windrow_shell_bent(shells, place, view, h, c.view.w, strand));
    a.shell_translated = wide(windrow_shell_translated(shells, place, view, h, c.view.w, wind));
    const WindrowPart trunk{glm::vec3(0.0f), {0.0f, 1.0f, 0.0f}, 8.0f, 1.0f}, branch{{0.0f, 5.0f, 0.0f}, view, 2.5f, 0.5f},
        leaf{glm::vec3(0.0f, 5.0f, 0.0f) + 2.0f * view, axis, 0.1f, 1.5f};
    const WindrowTreeVertex t = windrow_tree_vertex(tree, trunk, branch, leaf, wind, {leaf.root + 0.1f * h * leaf.axis, view});
    a.tree_position = wide(t.position);
    a.tree_normal = wide(t.normal);
    a.masks = {windrow_mask_power(h, 2.5f), windrow_mask_own(h, 0.5f), windrow_mask_drag(h, 1.5f),
               windrow_mask_droop(h, c.place.w)};
    const glm::vec2 lean = windrow_strand_lean({load.x, load.z}, h, 1.5f),
                    push = windrow_radial_load({c.place.x, c.place.z}, 1.0f, 1.2f);
    a.strand = {lean.x, lean.y, push.x, push.y};
    return a;
}

std::vector<PlantCase> random_cases(std::size_t count) {
    Random random(1);
    std::vector<PlantCase> cases(count);
    for (std::size_t n = 0; n < count; ++n) {
        const float speed = static_cast<float>(random.spread(1e-3, 60.0));
        // Ends of the range among them: still air, roots, tips, upright blades.
        const float h = n % 16 == 0 ? 0.0f : n % 16 == 1 ? 1.0f : random.uniform(0.0f, 1.0f);
        const glm::vec3 axis =
            n % 4 == 0 ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::normalize(glm::vec3(0.0f, 1.0f, 0.0f) + random.vector(0.5f));
        cases[n].wind = glm::vec4(n % 50 == 2 ? glm::vec3(0.0f) : speed * glm::vec3(random.direction()), h);
        cases[n].axis = glm::vec4(axis, random.uniform(-1.0f, 1.0f));
        cases[n].view = glm::vec4(glm::vec3(random.direction()), random.uniform(0.0f, 1.0f));
        cases[n].place = glm::vec4(random.vector(1.0f), static_cast<float>(std::log(random.spread(1e-3, 1e3))));
        cases[n].key = {random.bits(), random.bits(), 0u, 0u};
    }
    return cases;
}

using PlantsOnTheDevice = WindShader;

TEST_F(PlantsOnTheDevice, BendAsOnTheCpu) {
    constexpr std::size_t k_count = 100'000;
    const std::vector<PlantCase> cases = random_cases(k_count);
    const Classes kinds = classes();
    {
        const Buffer of_classes = uploaded(std::span(&kinds, 1));
        const std::array others{storage(2)};
        const std::vector<PlantAnswer> answers = dispatched<PlantAnswer>(shader_words::bend_plants, cases, 1, others,
                                                                         [&](VkDescriptorSet set) { point(set, 2, of_classes); });

        std::size_t chances = 0;
        struct ComparedMember {
            const char* name;
            glm::vec4 PlantAnswer::*member;
            double bound, largest = 0.0;
        };
        // Angles and unit vectors: 1e-5. Metres: of 0.4, 0.03 and 8 m. A place on a tree is known to 1e-6 m, a hundred-thousandth
        // of a leaf, along which the normal turns by up to pi/2 within a third of it.
        ComparedMember compared[] = {{"blade_load_rad", &PlantAnswer::blade_load, 1e-5},
                                     {"blade_position_m", &PlantAnswer::blade_position, 1e-5},
                                     {"blade_normal", &PlantAnswer::blade_normal, 1e-5},
                                     {"blade_tangent", &PlantAnswer::blade_tangent, 1e-5},
                                     {"shell_load_rad", &PlantAnswer::shell_load, 1e-5},
                                     {"shell_bent_m", &PlantAnswer::shell_bent, 1e-5},
                                     {"shell_translated_m", &PlantAnswer::shell_translated, 1e-5},
                                     {"tree_position_m", &PlantAnswer::tree_position, 1e-4},
                                     {"tree_normal", &PlantAnswer::tree_normal, 5e-5},
                                     {"masks", &PlantAnswer::masks, 1e-5},
                                     {"strand", &PlantAnswer::strand, 1e-5}};
        for (std::size_t n = 0; n < k_count; ++n) {
            const PlantAnswer cpu = bend_case(cases[n], kinds);
            chances += cpu.chance != answers[n].chance;
            for (ComparedMember& kind : compared)
                for (int axis = 0; axis < 4; ++axis) {
                    const double a = static_cast<double>((answers[n].*kind.member)[axis]);
                    const double b = static_cast<double>((cpu.*kind.member)[axis]);
                    ASSERT_TRUE(std::isfinite(a) && std::isfinite(b)) << kind.name << " " << n;
                    kind.largest = std::max(kind.largest, std::abs(a - b));
                }
        }
        for (const ComparedMember& kind : compared)
            WINDROW_EXPECT_FIGURE(std::string("plants/gpu/") + kind.name, kind.largest, kind.bound);
        EXPECT_EQ(chances, 0u) << "hash, yaw or stiffness differs by a bit";
    }
}

// Blade, shell and tree in the wind of a moving box, sampled by the user's include, against the CPU's wind and classes.
TEST_F(PlantsOnTheDevice, BendInTheWindOfABoxAsOnTheCpu) {
    const Config config{.cells = {16, 12, 16},
                        .centre = {0.0, 6.0, 0.0},
                        .ambient = {4.0f, 0.0f, 1.0f},
                        .profile = LogProfile{},
                        .gusts = {.intensity = 0.3f, .length = 8.0f}};
    const glm::dvec3 anchor(1.0, 0.0, -2.0);
    const Sampling sampling{.detail = 0.3f};
    constexpr std::size_t k_count = 1000;
    Random random(2);
    std::vector<glm::vec4> places(k_count);
    for (glm::vec4& place : places)
        place = {random.uniform(-12.0f, 12.0f), random.uniform(0.0f, 2.0f), random.uniform(-12.0f, 12.0f), 0.0f};
    const Classes kinds = classes();
    const auto grass = Blades::create({.along_wind = 0.8f, .view_bend = 0.4f});
    const auto fur = Shells::create({.droop = 0.01f});
    const auto oak = Tree::create({});
    const glm::vec3 up{0.0f, 1.0f, 0.0f}, velocity{0.5f, 0.0f, -0.25f}, eye{0.0f, 2.0f, 0.0f};

    auto cpu = windrow::Wind::create(config);
    auto gpu = Wind::create(sharing_host(), config, {.texel = Texel::single, .frames_in_flight = 1});
    ASSERT_TRUE(cpu && gpu);
    // Blade, shell and tree at a place in the CPU's wind as it stands.
    const auto on_cpu = [&](std::size_t n) -> std::array<glm::vec3, 3> {
        const auto on = [&](glm::vec3 place, glm::vec3 own_velocity) {
            const glm::dvec3 world = anchor + glm::dvec3(place);
            return cpu->view().ambient().felt(cpu->velocity(world) - own_velocity, world, sampling);
        };
        const glm::vec3 p(places[n]);
        const PlantKey key{static_cast<std::uint32_t>(n), 5u};
        const glm::vec3 load = grass->load(key, on(p + 0.5f * grass->length(key) * up, velocity));
        const glm::vec3 blade = p + grass->vertex(key, load, 1.0f, 0.5f, glm::normalize(p - eye)).position;
        const glm::vec3 shell = fur->bent(p, up, fur->height(7), 0.8f, fur->load(up, 0.8f, on(p, velocity)));
        // Each part feels its own wind, as Tree::vertices has it.
        const TreePart parts[] = {{.length = 8.0f, .stiffness = 1.0f},
                                  {.root = {0.0f, 2.0f, 0.0f}, .axis = {1.0f, 0.0f, 0.0f}, .length = 2.5f, .stiffness = 1.0f},
                                  {.root = {1.0f, 2.0f, 0.0f}, .axis = {0.0f, 0.0f, 1.0f}, .length = 0.1f, .stiffness = 1.0f}};
        glm::vec4 winds[3];
        for (std::size_t k = 0; k < 3; ++k)
            winds[k] = glm::vec4(on(p + parts[k].root + 0.5f * parts[k].length * parts[k].axis, glm::vec3(0.0f)), 0.0f);
        const glm::vec4 rest[] = {{1.0f, 2.0f, 0.1f, 0.0f}}, normal[] = {glm::vec4(up, 0.0f)};
        const Tree::PartIndices bearers[] = {{.trunk = 0, .branch = 1, .leaf = 2}};
        glm::vec4 leaf[1], turned[1];
        EXPECT_TRUE(oak->vertices(parts, winds, {rest, normal, bearers}, leaf, turned));
        return {blade, shell, glm::vec3(leaf[0])};
    };
    std::vector<std::array<glm::vec3, 3>> before(k_count);
    {
        const std::vector<glm::vec4> device_has = [&] {
            for (windrow::Motors* motors : {&cpu->motors(), &gpu->motors()})
                EXPECT_TRUE(motors->add(JetMotor{.position = {-3.0, 1.0, 0.0}}));
            for (int n = 0; n < 20; ++n) {
                for (std::size_t place = 0; n == 19 && place < k_count; ++place)
                    before[place] = on_cpu(place);
                run([&](VkCommandBuffer commands) { held(gpu->record(commands, {.dt = 1.0 / 30.0})); });
                (void)cpu->advance(1.0 / 30.0);
            }
            const Buffer of_classes = uploaded(std::span(&kinds, 1));
            return sampled(shader_words::wind_plants, *gpu, TextureSet::vectors, places, 6, gpu->frame_block(anchor, sampling),
                           {storage(2)}, [&](VkDescriptorSet set) { point(set, 2, of_classes); });
        }();

        // Winds agree to 1e-5 m/s of both samplings and 1e-4 of the steps; a blade of 0.3 m leans by 0.1 m a metre a second at
        // most, the fur by less, and so does the leaf, 2 m up a trunk of 8.
        const char* kinds_of[] = {"blade", "shell", "tree"};
        for (std::size_t k = 0; k < 3; ++k) {
            double now_most = 0.0, before_most = 0.0, moved = 0.0;
            for (std::size_t n = 0; n < k_count; ++n) {
                const glm::vec3 now = on_cpu(n)[k], device_now(device_has[6 * n + k]), device_before(device_has[6 * n + 3 + k]);
                now_most = std::max(now_most, static_cast<double>(glm::length(device_now - now)));
                before_most = std::max(before_most, static_cast<double>(glm::length(device_before - before[n][k])));
                moved = std::max(moved, static_cast<double>(glm::length(now - before[n][k])));
            }
            const std::string name = std::string("plants/gpu/") + kinds_of[k] + "_in_the_box";
            WINDROW_EXPECT_FIGURE(name + "_m", now_most, 1e-5);
            WINDROW_EXPECT_FIGURE(name + "_the_frame_before_m", before_most, 1e-5);
            // The frames differ by more than the bound: neither passes for the other.
            EXPECT_GT(test::figure(name + "_moved_m", moved), 2e-5);
        }
    }
}

} // namespace
} // namespace windrow::vulkan
