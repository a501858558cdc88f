// A wind on a device inside another wind: the cells of the CPU's, with what stands in the outer box and reaches the inner one; saved
// and loaded; read beyond the box.
#include "tests/fields.h"
#include "tests/parity/wind_parity.h"
#include "tests/tier.h"

#include <array>
#include <glm/geometric.hpp>
#include <iterator>
#include <memory>
#include <random>
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

// Random levels, two or three, with a fan and a block here and there, and what a host calls between frames: the mean wind, gusts, resets,
// walks and jumps, another origin, cells of its own. The stories of the short form were red: a frame without a tick after a reset (.036 of
// the wind), cells that are set before a first step (.009).
TEST_F(WindLevels, OfRandomStoriesHaveTheCellsOfTheCpu) {
    constexpr int k_short[] = {8, 11, 27, 36, 39};
    double largest = 0.0;
    for (int n = 0; n < (test::whole_sweeps() ? 40 : static_cast<int>(std::size(k_short))); ++n) {
        const int seed = test::whole_sweeps() ? n : k_short[n];
        SCOPED_TRACE(seed);
        std::mt19937 chance(static_cast<unsigned>(seed));
        const auto below = [&](int count) { return static_cast<int>(chance() % static_cast<unsigned>(count)); };
        const auto one_in = [&](int count) { return below(count) == 0; };
        const bool floor = !one_in(3), gusty = one_in(2);
        const Boundaries sides = floor ? Boundaries::open_over_floor() : Boundaries::all(BoundaryKind::open);
        const auto level = [&](glm::ivec3 cells, float cell_size, double hz) {
            Config config{.cells = cells, .cell_size = cell_size, .boundaries = sides};
            if (one_in(2))
                config.ticks = {.hz = hz};
            config.pressure_solves = one_in(3) ? 2 : config.pressure_solves;
            config.relaxation_time = one_in(4) ? 5.0f : config.relaxation_time;
            config.max_substeps = one_in(4) ? 2 : config.max_substeps;
            return config;
        };
        std::vector<std::shared_ptr<windrow::Wind>> levels; // around the pair, outermost first
        float cell_size = 4.0f;
        for (int left = one_in(2) ? 2 : 1; left > 0; --left, cell_size /= one_in(3) ? 1.0f : 2.0f) {
            Config config = level(levels.empty() ? glm::ivec3(18, 8, 18) : glm::ivec3(14, 8, 14), cell_size, 10.0 + below(10));
            if (levels.empty()) {
                config.ambient = {static_cast<float>(below(13) - 6), 0.0f, static_cast<float>(below(13) - 6)};
                config.gusts.intensity = gusty ? 0.3f : 0.0f;
                if (floor && one_in(2))
                    config.profile = LogProfile{};
            }
            auto made = windrow::Wind::create(config, levels.empty() ? nullptr : levels.back());
            ASSERT_TRUE(made) << made.error();
            levels.push_back(std::make_shared<windrow::Wind>(*std::move(made)));
        }
        TwoWinds pair = make(level({12, 6, 12}, cell_size, 30.0), one_in(3) ? 2 : 0, {.texel = Texel::single}, levels.back());
        const double bottom = pair.cpu.origin().y;
        const bool fan = !one_in(3), block = one_in(2);
        const auto put_in = [&](auto& wind) {
            if (fan) {
                EXPECT_TRUE(wind.motors().add(DirectionalMotor{
                    .position = {-5.0, bottom + 3.0, 1.0}, .region = Sphere{4.0f}, .law = Drive{.speed = 9.0f}}));
            }
            if (block) {
                EXPECT_TRUE(wind.obstacles().add({.position = {4.0, bottom + 2.0, 2.0}, .shape = Block{{1.5f, 3.0f, 2.0f}}}));
            }
        };
        for (const auto& wind : levels)
            put_in(*wind);
        put_in(pair.cpu);
        put_in(pair.device);
        for (int frames = 0; frames < 12; ++frames) {
            const glm::dvec3 walked(0.4 * frames, 0.0, -0.3 * frames);
            const auto of_all = [&](const auto& call) {
                for (const auto& wind : levels)
                    EXPECT_TRUE(call(*wind));
                pair.both(call);
            };
            const int what = below(9);
            switch (what) {
            case 0:
                EXPECT_TRUE(levels.front()->set_ambient({static_cast<float>(below(9) - 4), 0.0f, 2.0f}));
                break;
            case 1:
                EXPECT_TRUE(levels.front()->set_gusts({.intensity = gusty ? 0.1f * static_cast<float>(below(5)) : 0.0f}));
                break;
            case 2:
                for (const auto& wind : levels)
                    wind->reset();
                pair.reset();
                break;
            case 3:
                pair.follow(walked);
                break;
            case 4:
                of_all([&](auto& wind) { return wind.follow(walked); });
                break;
            case 5:
                of_all([&](auto& wind) { return wind.shift_origin({256.0, 0.0, -128.0}); });
                break;
            default:
                break; // nothing but the frame
            }
            const double dt = one_in(2) ? 0.5 * k_frame : 1.4 * k_frame;
            for (const auto& wind : levels)
                (void)wind->advance(dt);
            if (what == 6)
                pair.set_velocity(test::white_noise(pair.cpu.box().cells, 3.0f, static_cast<unsigned>(frames + 1)));
            frame(pair, dt);
        }
        largest = std::max(largest, pair.largest);
        EXPECT_LE(pair.largest, 1e-5);
    }
    WINDROW_EXPECT_FIGURE("wind_parity.levels.stories", largest, 1e-5);
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
