// Same air to the bit: with 1, 2, 3 and 8 threads, again and again, and with another Wind beside it.

#include "fluid/thread_pool.h"
#include "tests/tier.h"
#include "tests/winds.h"

#include <array>
#include <thread>

namespace {

using namespace windrow;
using namespace windrow::test;

std::vector<NamedConfig> determined_scenes() {
    std::vector<NamedConfig> list;
    for (const glm::ivec3 cells : {glm::ivec3(32, 16, 32), glm::ivec3(17, 9, 23)}) {
        const std::string size = '_' + std::to_string(cells.x) + 'x' + std::to_string(cells.y) + 'x' + std::to_string(cells.z);
        const auto add = [&](const char* name, const std::function<void(Config&)>& change) {
            list.push_back({name + size, with({.cells = cells, .ambient = {3.0f, 0.0f, -1.0f}}, change)});
        };
        add("open", [](Config&) {});
        add("viscous_one_pass", [](Config& c) { c.viscosity = 1.0f; });
        add("viscous_implicit_floor", [](Config& c) {
            c.viscosity = 50.0f;
            c.boundaries = Boundaries::open_over_floor();
        });
        add("periodic", [](Config& c) { c.boundaries = Boundaries::all(BoundaryKind::periodic); });
        add("rows", [](Config& c) {
            c.viscosity = 5.0f;
            c.boundaries = Boundaries::open_over_floor();
            c.rows.emplace(Rows{.first = 0.4f, .uniform = 3, .ratio = 1.2f});
            c.roughness.emplace();
        });
        add("stable_fluids_walls", [](Config& c) {
            c.scheme = Scheme::stable_fluids;
            c.boundaries = Boundaries::all(BoundaryKind::no_slip);
        });
    }
    return list;
}

/// A wind with everything in it, advanced one step at a time.
class Storm {
  public:
    Storm(Config config, ParallelFor parallel_for)
        : wind_(made(with(config, [&](Config& c) { c.parallel_for = parallel_for; }))), random_(101) {
        EXPECT_TRUE(wind_.set_velocity(white_noise(config.cells, 4.0f, 102)));
        for (int n = 0; n < 30; ++n) {
            const glm::dvec3 at = random_.point(12.0);
            const Region region = n % 3 == 0   ? Region(Sphere{random_.uniform(0.5f, 5.0f)})
                                  : n % 3 == 1 ? Region(Capsule{.half_axis = random_.vector(4.0f)})
                                               : Region(AlignedBox{});
            DirectionalMotor motor{.position = at, .direction = random_.vector(1.0f), .region = region};
            if (n % 2 == 0)
                motor.law = Force{random_.uniform(-60.0f, 60.0f)};
            EXPECT_TRUE(wind_.motors().add(motor));
        }
        body_ = *wind_.motors().add(WakeMotor{.radius = 1.0f});
    }

    void step() {
        ++count_;
        EXPECT_TRUE(wind_.motors().move(body_, random_.point(8.0)));
        if (count_ % 10 == 0) {
            EXPECT_TRUE(wind_.follow(random_.point(6.0)));
        }
        // Long and short steps: sub-steps, and pivots made again.
        largest_substeps_ = std::max(largest_substeps_, wind_.step(count_ % 5 == 0 ? 0.2 : 1.0 / 60.0).substeps);
    }
    [[nodiscard]] const Wind& wind() const { return wind_; }
    [[nodiscard]] int largest_substeps() const { return largest_substeps_; }

  private:
    Wind wind_;
    Random random_;
    MotorId body_;
    int count_ = 0, largest_substeps_ = 0;
};

class ParallelSame : public testing::TestWithParam<NamedConfig> {};

TEST_P(ParallelSame, AHundredStepsWithAnyNumberOfThreads) {
    const Config& config = GetParam().config;
    const int steps = test::k_sanitized ? 40 : 100;
    std::vector<Field> serial; // every tenth step
    Storm reference(config, {});
    for (int n = 1; n <= steps; ++n) {
        reference.step();
        if (n % 10 == 0)
            serial.push_back(copy(reference.wind().field()));
    }
    EXPECT_TRUE(all_finite(serial.back()));
    EXPECT_GT(reference.largest_substeps(), 1);
    for (const int threads : {1, 2, 3, 8}) {
        ThreadPool pool(threads);
        Storm storm(config, pool.parallel_for());
        for (int n = 1; n <= steps; ++n) {
            storm.step();
            if (n % 10 != 0)
                continue;
            const Field& expected = serial[static_cast<std::size_t>(n / 10 - 1)];
            ASSERT_EQ(cells_that_differ(storm.wind().field(), expected), 0u) << threads << " threads, step " << n;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, ParallelSame, testing::ValuesIn(determined_scenes()),
                         [](const auto& instance) { return instance.param.name; });

TEST(ParallelWinds, TwoWindsShareNothing) {
    const Config config = determined_scenes()[1].config;
    Storm alone(config, {});
    for (int n = 0; n < 40; ++n)
        alone.step();

    Storm first(config, {}), other(determined_scenes()[8].config, {});
    for (int n = 0; n < 40; ++n) {
        first.step();
        other.step();
    }
    EXPECT_EQ(cells_that_differ(first.wind().field(), alone.wind().field()), 0u);

    // At the same time in two threads, on one pool.
    ThreadPool pool(3);
    Storm left(config, pool.parallel_for()), right(config, pool.parallel_for());
    const auto run = [](Storm& storm) {
        for (int n = 0; n < 40; ++n)
            storm.step();
    };
    std::thread beside(run, std::ref(left));
    run(right);
    beside.join();
    EXPECT_EQ(cells_that_differ(left.wind().field(), alone.wind().field()), 0u);
    EXPECT_EQ(cells_that_differ(right.wind().field(), alone.wind().field()), 0u);
}

TEST(ParallelWinds, IndicesInAnyOrderGiveTheSame) {
    // A host may run them backwards: nothing may hang on the order.
    const ParallelFor backwards{[](void*, int count, void (*task)(void*, int), void* argument) {
                                    for (int index = count - 1; index >= 0; --index)
                                        task(argument, index);
                                },
                                nullptr};
    for (const NamedConfig& scene : determined_scenes()) {
        Storm forwards(scene.config, {}), reversed(scene.config, backwards);
        for (int n = 0; n < (test::k_sanitized ? 5 : 20); ++n) { // of one thread
            forwards.step();
            reversed.step();
        }
        EXPECT_EQ(cells_that_differ(forwards.wind().field(), reversed.wind().field()), 0u) << scene.name;
    }
}

// Air that sleeps in gusts is written by whoever reads it first: threads that read at once, one of them in a loop of the wind's own
// pool, find the same cells.
TEST(ParallelReads, OfAirThatSleepsInGustsFindTheSameCells) {
    ThreadPool pool(3);
    Config config{.cells = {12, 8, 10}, .ambient = {4.0f, 0.0f, 1.0f}};
    config.gusts.intensity = 0.3f;
    config.parallel_for = pool.parallel_for();
    for (const bool frames : {false, true}) {
        Wind wind = made(config);
        for (int n = 0; n < 20; ++n) {
            if (frames)
                wind.advance(1.0 / 24.0);
            else
                wind.step(1.0 / 24.0);
            std::array<glm::vec3, 12> read;
            pool.parallel_for()(static_cast<int>(read.size()), [&](int i) {
                read[static_cast<std::size_t>(i)] = wind.velocity({0.3, -0.2, 0.7}) + glm::vec3(wind.field()[5]);
            });
            for (const glm::vec3& one : read)
                ASSERT_EQ(one, read[0]);
        }
    }
}

} // namespace
