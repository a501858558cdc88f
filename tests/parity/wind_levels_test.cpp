// A wind on a device inside another wind: the cells of the CPU's, with what stands in the outer box and reaches the inner one; saved
// and loaded; read beyond the box.
#include "tests/parity/wind_parity.h"
#include "tests/tier.h"

#include <array>
#include <glm/geometric.hpp>
#include <memory>
#include <vector>

namespace windrow::vulkan {
namespace {

enum class Stands : std::uint8_t { nothing, bush, block };
constexpr const char* k_names[] = {"nothing", "bush", "block"};

class WindLevels : public WindParity {
  protected:
    static constexpr double k_frame = 1.0 / 30.0;

    static std::shared_ptr<windrow::Wind> around(bool gusts) {
        auto made = windrow::Wind::create({.cells = {20, 8, 20},
                                           .cell_size = 2.0f,
                                           .boundaries = Boundaries::open_over_floor(),
                                           .ambient = {6.0f, 0.0f, 1.0f},
                                           .profile = LogProfile{},
                                           .gusts = {.intensity = gusts ? 0.2f : 0.0f},
                                           .ticks = {.hz = 10.0}});
        EXPECT_TRUE(made) << made.error();
        return std::make_shared<windrow::Wind>(*std::move(made));
    }
    static Config inside() { return {.cells = {16, 8, 14}, .boundaries = Boundaries::open_over_floor()}; }

    /// Before the inner box and across its boundary, so that most of what it does comes in. In both levels, as a scene has it.
    template <class AnyWind>
    static void put(AnyWind& wind, Stands what) {
        if (what == Stands::bush) {
            EXPECT_TRUE(wind.drag().add(PlantDrag{.position = {-9.0, 0.0, 0.0}, .radius = 3.0f, .height = 4.0f, .area = 40.0f}));
        } else if (what == Stands::block) {
            EXPECT_TRUE(wind.obstacles().add({.position = {-8.0, 2.0, 1.0}, .shape = Block{glm::vec3(2.0f)}}));
        }
    }
    static void add_fan(windrow::Wind& outer) {
        EXPECT_TRUE(outer.motors().add(
            DirectionalMotor{.position = {-13.0, 3.0, 2.0}, .region = Sphere{5.0f}, .law = Drive{.speed = 9.0f}}));
    }
};

// Twelve frames of 1/30 s, of which each third has a tick of the outer wind; half a second of it came before.
TEST_F(WindLevels, HaveTheCellsOfTheCpu) {
    for (const Stands what : {Stands::nothing, Stands::bush, Stands::block})
        for (const bool gusts : {false, true})
            for (const bool shifts : {false, true}) {
                const bool first = (what == Stands::block && gusts && shifts) || (what == Stands::bush && !gusts && shifts);
                if (!first && !test::whole_sweeps())
                    continue;
                const auto outer = around(gusts);
                put(*outer, what);
                add_fan(*outer);
                for (int n = 0; n < 15; ++n)
                    (void)outer->advance(k_frame);
                TwoWinds pair = make(inside(), 0, {.texel = Texel::single}, outer);
                put(pair.cpu, what);
                put(pair.device, what);
                windrow::Wind alone = *windrow::Wind::create([&] {
                    Config config = inside();
                    config.ambient = outer->config().ambient;
                    config.profile = outer->config().profile;
                    config.gusts = outer->config().gusts;
                    return config;
                }());
                put(alone, what);
                for (int n = 0; n < 12; ++n) {
                    (void)outer->advance(k_frame);
                    if (shifts) {
                        pair.follow({0.3 * n, 0.0, -0.2 * n});
                        EXPECT_TRUE(alone.follow({0.3 * n, 0.0, -0.2 * n}));
                    }
                    frame(pair, k_frame);
                    (void)alone.advance(k_frame);
                }
                step(pair, k_frame); // compares the last frame
                EXPECT_EQ(pair.compared, 12);
                report(std::string("levels.") + k_names[static_cast<int>(what)] + (gusts ? ".gusts" : "") +
                           (shifts ? ".shifts" : ""),
                       pair, 1e-5);
                const auto view = pair.cpu.view();
                EXPECT_GT(apart(alone.field(), view.field()), 0.1) << "the outer wind does nothing";
            }
}

// In single steps of many sub-steps, with a jump beyond the box, changes between two recordings and a wind that is set anew.
TEST_F(WindLevels, FollowTheOuterWindThroughChanges) {
    const auto outer = around(true);
    add_fan(*outer);
    for (int n = 0; n < 15; ++n)
        (void)outer->advance(k_frame);
    Config config = inside();
    config.cell_size = 0.5f;
    config.relaxation_time = 2.0f;
    TwoWinds pair = make(config, 0, {.texel = Texel::single}, outer);
    for (int n = 0; n < 10; ++n) {
        (void)outer->advance(2.0 * k_frame);
        if (n == 3) {
            pair.follow({0.6, 0.0, 0.0});
            pair.follow({1.3, 0.0, -0.7});
        } else if (n == 5) {
            ASSERT_TRUE(outer->set_ambient({5.0f, 0.0f, 2.0f})); // both take it
        } else if (n == 7) {
            pair.follow({-9.0, 0.0, 4.0});
        } else if (n == 8) {
            pair.reset();
        }
        step(pair, n % 2 == 0 ? 2.0 * k_frame : k_frame);
    }
    (void)outer->advance(k_frame);
    step(pair, k_frame);
    EXPECT_EQ(pair.compared, 10);
    report("levels.changes", pair, 1e-5);
}

// As many dispatches as a wind without an outer one, and what it takes of memory is what was asked for.
TEST_F(WindLevels, TakeNoDispatchMore) {
    const auto outer = around(false);
    const auto recorded = [&](bool nested) {
        Config config = inside();
        if (!nested) {
            config.ambient = outer->config().ambient;
            config.profile = outer->config().profile;
        }
        const auto around_it = nested ? outer : nullptr;
        auto made = Wind::create(sharing_host(), config, {}, around_it);
        EXPECT_TRUE(made && made->motors().add(DirectionalMotor{}));
        const auto required = required_bytes(sharing_host(), config, {}, around_it.get());
        EXPECT_TRUE(required);
        EXPECT_EQ(required->memory, made->memory_bytes());
        std::vector<int> counts;
        for (int n = 0; n < 5; ++n) {
            (void)outer->advance(k_frame);
            if (n == 3) {
                EXPECT_TRUE(made->follow({2.0, 0.0, 0.0}));
            }
            run([&](VkCommandBuffer commands) { (void)held(made->record(commands, {.dt = k_frame})); });
            counts.push_back(made->dispatches());
        }
        counts.erase(counts.begin()); // which fills the box
        return counts;
    };
    EXPECT_EQ(recorded(true), recorded(false));
}

// Saved by the device and loaded there, with the same bits, and on the CPU; beside the outer wind's own snapshot.
TEST_F(WindLevels, GoOnFromASnapshot) {
    constexpr Settings settings{.texel = Texel::single, .frames_in_flight = 1, .queries = ReadBack::cells};
    const auto outer = around(true);
    add_fan(*outer);
    auto made = Wind::create(sharing_host(), inside(), settings, outer);
    ASSERT_TRUE(made) << made.error();
    const auto frame = [&](windrow::Wind& large, Wind& small, int n, bool save = false) {
        (void)large.advance(k_frame);
        EXPECT_TRUE(small.follow({0.3 * n, 0.0, 0.0}));
        run([&](VkCommandBuffer commands) { (void)held(small.record(commands, {.dt = k_frame, .slot = 0, .save = save})); });
        (void)small.collect(0);
    };
    for (int n = 0; n < 20; ++n)
        frame(*outer, *made, n, n == 19);
    const auto large = outer->save(), small = made->saved();
    ASSERT_TRUE(large && small);
    const auto outer_again = std::make_shared<windrow::Wind>(*windrow::Wind::load(*large)),
               outer_of_cpu = std::make_shared<windrow::Wind>(*windrow::Wind::load(*large));
    auto again = Wind::load(sharing_host(), *small, settings, outer_again);
    ASSERT_TRUE(again) << again.error();
    auto on_cpu = windrow::Wind::load(*small, {}, outer_of_cpu);
    ASSERT_TRUE(on_cpu) << on_cpu.error();
    for (int n = 20; n < 30; ++n) {
        frame(*outer, *made, n);
        frame(*outer_again, *again, n);
        (void)outer_of_cpu->advance(k_frame);
        ASSERT_TRUE(on_cpu->follow({0.3 * n, 0.0, 0.0}));
        (void)on_cpu->advance(k_frame);
    }
    const auto cells = *made->cells();
    EXPECT_EQ(apart(*again->cells(), cells), 0.0);
    WINDROW_EXPECT_FIGURE("wind_parity.levels.loaded_on_cpu", apart(on_cpu->view().field(), cells), 1e-5);
    EXPECT_NE(Wind::load(sharing_host(), *small, settings).error().find("saved with an outer wind"), std::string::npos);
    Config wrong = inside();
    wrong.ambient = {1.0f, 0.0f, 0.0f};
    EXPECT_NE(Wind::create(sharing_host(), wrong, settings, outer).error().find("outer wind"), std::string::npos);
}

// Beyond the box what is read back is the outer wind, by cells, halves and points.
TEST_F(WindLevels, ReadTheOuterWindBeyondTheBox) {
    const auto outer = around(false);
    add_fan(*outer);
    const glm::dvec3 beyond{-13.0, 3.0, 2.0};
    for (const ReadBack kind : {ReadBack::cells, ReadBack::halves, ReadBack::points}) {
        auto made = Wind::create(sharing_host(), inside(), {.frames_in_flight = 1, .queries = kind}, outer);
        ASSERT_TRUE(made) << made.error();
        EXPECT_EQ(made->velocity(beyond), outer->velocity(beyond));
        for (int n = 0; n < 2; ++n) {
            (void)outer->advance(0.1);
            run([&](VkCommandBuffer commands) {
                (void)held(made->record(commands, {.dt = 0.1, .slot = 0, .points = {&beyond, 1}}));
            });
            (void)made->collect(0);
        }
        const glm::vec3 wanted = outer->velocity(beyond);
        EXPECT_GT(glm::length(wanted - outer->ambient_wind().velocity(beyond)), 0.3f);
        const auto points = made->queried_points();
        const glm::vec3 found = points ? glm::vec3(points->velocities[0]) : made->velocity(beyond);
        EXPECT_LE(glm::length(found - wanted), 1e-5f) << static_cast<int>(kind);
    }
}

} // namespace
} // namespace windrow::vulkan
