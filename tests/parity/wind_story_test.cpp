// Stories made up by chance: boxes of any kind, and the calls of a wind in any order between its frames, by ticks and by steps,
// with one to three frames in flight, on both winds alike. A story that fails prints its seed and what happened in it.
#include "tests/parity/wind_parity.h"
#include "tests/tier.h"

#include <random>
#include <sstream>

namespace windrow::vulkan {
namespace {

class StoryChance {
  public:
    explicit StoryChance(std::uint32_t seed) : random_(seed) {}
    int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
    bool one_in(int count) { return below(count) == 0; }
    float between(float low, float high) { return std::uniform_real_distribution<float>(low, high)(random_); }
    glm::vec3 vector(float size) { return {between(-size, size), between(-size, size), between(-size, size)}; }

  private:
    std::mt19937 random_;
};

// Periodic sides tear a wind that differs from place to place where they meet (Config::gusts): there the last bit of a trajectory
// decides between two winds. So a story has periodic boundaries, or a profile and gusts.
Boundaries any_sides(StoryChance& chance, bool periodic) {
    Boundaries boundaries;
    Boundary* const ends[3][2] = {{&boundaries.x_low, &boundaries.x_high},
                                  {&boundaries.y_low, &boundaries.y_high},
                                  {&boundaries.z_low, &boundaries.z_high}};
    for (auto& [low, high] : ends) {
        if (periodic && chance.one_in(3)) {
            low->kind = high->kind = BoundaryKind::periodic;
            continue;
        }
        for (Boundary* side : {low, high})
            if (chance.one_in(3))
                side->kind = chance.one_in(2) ? BoundaryKind::no_slip : BoundaryKind::free_slip;
    }
    return boundaries;
}

// No profile where air sleeps: over one the ambient wind is no steady flow, so that air left at it drifts off unless it sleeps at
// once.
Config any_config(StoryChance& chance, bool periodic, bool sleeps) {
    Config config{.cells = {3 + chance.below(12), 3 + chance.below(9), 3 + chance.below(12)},
                  .cell_size = chance.between(0.5f, 1.5f),
                  .ambient = chance.vector(3.0f)};
    if (!periodic && !sleeps && chance.one_in(2))
        config.profile = LogProfile{};
    config.boundaries = any_sides(chance, periodic);
    if (!periodic && chance.one_in(2))
        config.gusts.intensity = chance.between(0.0f, 0.4f);
    constexpr float viscosities[] = {1.5e-5f, 1.5e-5f, 0.0f, 3e-3f, 0.5f, 20.0f};
    config.viscosity = viscosities[chance.below(6)];
    config.relaxation_time = chance.one_in(4) ? 0.0f : chance.between(0.3f, 20.0f);
    config.scheme = chance.one_in(4) ? Scheme::stable_fluids : Scheme::second_order;
    config.interpolation = chance.one_in(4)   ? Interpolation::linear
                           : chance.one_in(4) ? Interpolation::cubic_32
                                              : Interpolation::cubic;
    config.max_cfl = chance.one_in(3) ? 0.3f : 2.0f;
    return config;
}

Motor any_motor(StoryChance& chance) {
    const glm::dvec3 place(chance.vector(4.0f));
    switch (chance.below(6)) {
    case 0:
        return DirectionalMotor{.position = place, .direction = chance.vector(1.0f)};
    case 1:
        return DirectionalMotor{
            .position = place, .direction = chance.vector(1.0f), .law = Force{.acceleration = chance.between(0.0f, 20.0f)}};
    case 2:
        return VortexMotor{.position = place, .axis = chance.vector(1.0f), .radius = chance.between(1.0f, 5.0f)};
    case 3:
        return JetMotor{.position = place, .direction = chance.vector(1.0f)};
    case 4:
        return OmniMotor{.position = place, .speed = chance.between(-5.0f, 5.0f)};
    default:
        return PressureMotor{.position = place, .speed = chance.between(-10.0f, 10.0f)};
    }
}

class WindStories : public WindParity {
  protected:
    std::ostringstream log;

    // The same call on both, which take it or reject it alike.
    template <class Call>
    void alike(TwoWinds& pair, const char* what, const Call& call) {
        const auto on_cpu = call(pair.cpu), on_device = call(pair.device);
        log << ' ' << what << (on_cpu ? "" : " (rejected)");
        EXPECT_EQ(static_cast<bool>(on_cpu), static_cast<bool>(on_device)) << what;
    }

    void ask(TwoWinds& pair, StoryChance& chance, bool periodic, std::vector<TwoWinds::Ids>& motors) {
        switch (chance.below(10)) {
        case 0:
        case 1:
        case 2: {
            const glm::dvec3 to = glm::dvec3(chance.vector(chance.one_in(8) ? 60.0f : 5.0f));
            return alike(pair, "follow", [&](auto& wind) { return wind.follow(to); });
        }
        case 3: {
            const glm::vec3 wind_to = chance.one_in(5) ? glm::vec3(0.0f) : chance.vector(4.0f);
            return alike(pair, "set_ambient", [&](auto& wind) { return wind.set_ambient(wind_to); });
        }
        case 4: {
            if (periodic)
                return;
            const Gusts gusts{.intensity = chance.one_in(3) ? 0.0f : chance.between(0.0f, 0.4f),
                              .seed = static_cast<std::uint32_t>(chance.below(2))};
            return alike(pair, "set_gusts", [&](auto& wind) { return wind.set_gusts(gusts); });
        }
        case 5: {
            const Boundaries boundaries = any_sides(chance, periodic);
            return alike(pair, "set_boundaries", [&](auto& wind) { return wind.set_boundaries(boundaries); });
        }
        case 6: {
            const double height = static_cast<double>(chance.between(-6.0f, 3.0f));
            return alike(pair, "set_floor", [&](auto& wind) { return wind.set_floor(height); });
        }
        case 7: {
            if (!chance.one_in(4))
                return;
            std::vector<glm::vec4> field(pair.cpu.box().cell_count());
            for (glm::vec4& u : field)
                u = glm::vec4(chance.vector(3.0f), 0.0f);
            if (chance.one_in(3))
                field[field.size() / 2].y = std::nanf("");
            return alike(pair, "set_velocity", [&](auto& wind) { return wind.set_velocity(field); });
        }
        case 8:
            if (!chance.one_in(4))
                return;
            log << " reset";
            pair.reset();
            return;
        default:
            if (!motors.empty() && chance.one_in(2)) {
                log << " remove";
                EXPECT_TRUE(pair.cpu.motors().remove(motors.back().first));
                EXPECT_TRUE(pair.device.motors().remove(motors.back().second));
                motors.pop_back();
                return;
            }
            const Motor motor = any_motor(chance);
            log << " add";
            const auto ids = pair.add(motor);
            if (motor.index() != 5) // which ends by itself
                motors.push_back(ids);
        }
    }

    // Largest difference of a story, in shares of the largest speed of its frame (of 1 m/s where there is less).
    double live(std::uint32_t seed, float sleep_speed, double bound) {
        StoryChance chance(seed);
        log.str("");
        const bool periodic = chance.one_in(3);
        Config config = any_config(chance, periodic, sleep_speed > 0.0f);
        config.sleep_speed = sleep_speed;
        const int in_flight = chance.below(4); // 0: each frame is waited for
        auto cpu = windrow::Wind::create(config);
        auto gpu = Wind::create(
            own->host(), config,
            {.texel = Texel::single, .frames_in_flight = std::max(in_flight, 1), .gusts = true, .queries = ReadBack::cells});
        EXPECT_TRUE(cpu && gpu);
        TwoWinds pair{*std::move(cpu), *std::move(gpu), std::max(in_flight, 1),
                      in_flight > 0 ? std::make_unique<Submitter>(own->host(), in_flight) : nullptr};
        pair.min = 1.0;
        log << " cells " << config.cells.x << ' ' << config.cells.y << ' ' << config.cells.z << ", viscosity " << config.viscosity
            << ", relaxation " << *config.relaxation_time << ", max_cfl " << config.max_cfl << ", profile "
            << config.profile.has_value() << ", gusts " << config.gusts.intensity << ", classic "
            << (config.scheme == Scheme::stable_fluids) << ", "
            << k_words<Interpolation>[static_cast<std::size_t>(config.interpolation)] << ", in flight " << in_flight;
        std::vector<TwoWinds::Ids> motors;
        bool ticks = chance.one_in(2);
        for (int n = 0; n < 40 && !HasFailure(); ++n) {
            log << "\n  " << n << ':';
            for (int asked = chance.below(4); asked > 0; --asked)
                ask(pair, chance, periodic, motors);
            if (chance.one_in(12))
                ticks = !ticks;
            const double dt = ticks && chance.one_in(8) ? 0.0 : static_cast<double>(chance.between(0.004f, 0.08f));
            log << (ticks ? " frame " : " step ") << dt;
            const auto pass = [&](double duration) { ticks ? frame(pair, duration) : step(pair, duration); };
            pass(dt);
            EXPECT_EQ(pair.cpu_sleeps, pair.device_sleeps);
            log << "  [" << pair.last << ']';
            if (!(pair.last <= bound))
                break;
        }
        if (pair.submitter)
            pair.submitter->wait();
        return pair.largest;
    }

    void try_many(const char* name, std::uint32_t first, float sleep_speed, double bound) {
        double worst = 0.0;
        const auto count = static_cast<std::uint32_t>(test::sampled(40, 4));
        for (std::uint32_t seed = first; seed < first + count && !HasFailure(); ++seed) {
            const double largest = live(seed, sleep_speed, bound);
            EXPECT_LE(largest, bound) << "seed " << seed << log.str();
            if (HasFailure())
                std::printf("seed %u%s\n", seed, log.str().c_str());
            worst = std::max(worst, largest);
        }
        WINDROW_EXPECT_FIGURE(std::string("wind_parity.stories_") + name, worst, bound);
    }
};

TEST_F(WindStories, OfAirThatNeverSleeps) {
    try_many("awake", 1000, 0.0f, 1e-5);
}

// Both fall asleep with the same tick: what wakes the one a tick later finds no past, and so with the other.
TEST_F(WindStories, OfAirThatSleeps) {
    try_many("asleep", 2000, 1e-3f, 1e-5);
}

} // namespace
} // namespace windrow::vulkan
