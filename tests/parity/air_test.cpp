// The air on the device against the air on the CPU: the same start, the same motors, tick by tick.
#include "fluid/vulkan/air.h"
#include "fluid/wind_state.h"
#include "tests/parity/wind_parity.h"
#include "tests/tier.h"
#include "tests/winds.h"

namespace windrow::vulkan {
namespace {

// One wind twice. What the host's side of a Wind does is taken from the CPU's: its motors, its box, its ambient wind.
class Twin {
  public:
    Twin(OwnDevice& gpu, const Config& config) : Twin(gpu, config, config) {}
    Twin(OwnDevice& gpu, const Config& config, const Config& on_cpu)
        : gpu_(gpu), wind_(*windrow::Wind::create(on_cpu)), motors_() {
        auto air = Air::create(gpu.host(), config, {.reads = {.kind = ReadBack::cells, .cells = config.cells}});
        EXPECT_TRUE(air) << air.error();
        air_ = *std::move(air);
        apply(CellChange::Kind::fill);
    }

    windrow::Wind& wind() { return wind_; }

    void set_velocity(std::span<const glm::vec4> field) {
        ASSERT_TRUE(wind_.set_velocity(field));
        apply(CellChange::Kind::set, field);
    }

    void add(const Motor& motor) {
        ASSERT_TRUE(wind_.motors().add(motor));
        ASSERT_TRUE(motors_.add(motor));
    }

    // Both by a step; the device by as many sub-steps as the CPU chose, unless it shall choose itself.
    void step(double dt, bool forced = true) {
        const WindCore& core = wind_.state().core;
        AmbientWind ambient = core.ambient; // as it is at the start
        const std::uint64_t sources_before = core.source_name;
        diagnostics_ = wind_.step(dt);
        const std::uint64_t sources = core.source_name;
        motors_.begin_frame(0.0, dt);
        const Window window = core.window();
        const auto reached = motors_.tick(dt, window, core.config.boundaries);
        air_->force_substeps(forced ? diagnostics_.substeps : 0);
        record({.duration = dt,
                .motors = reached,
                .tile = motors_.tile(ambient.tile()),
                .ambient = &ambient,
                .window = &window,
                .relaxation_time = relaxation_time(core.config, false),
                .renews_sources = sources != sources_before,
                .has_source_flow = sources != 0});
    }

    // The device alone, without motors, in `ambient`, which it advances.
    void step_device(double dt, AmbientWind& ambient, const Air::Recorded& recorded) {
        const WindCore& core = wind_.state().core;
        record({.duration = dt,
                .ambient = &ambient,
                .window = &core.window(),
                .relaxation_time = relaxation_time(core.config, false)},
               recorded);
        ambient.advance(dt);
    }

    // Steps that are recorded together, and shown once.
    void in_one_recording(const std::function<void()>& steps) {
        run([&](VkCommandBuffer commands) {
            air_->begin(0);
            recording_ = commands;
            steps();
            recording_ = VK_NULL_HANDLE;
            show(commands);
        });
        ASSERT_EQ(air_->slot(0).invalidate(), VK_SUCCESS);
    }

    [[nodiscard]] double difference() const {
        const auto bytes = air_->read(0);
        return apart({reinterpret_cast<const glm::vec4*>(bytes.data()), bytes.size() / sizeof(glm::vec4)}, wind_.field());
    }
    [[nodiscard]] AirReport report() const { return air_->report(0); }
    [[nodiscard]] const Diagnostics& diagnostics() const { return diagnostics_; }
    [[nodiscard]] const Air& air() const { return *air_; }

    void run(const std::function<void(VkCommandBuffer)>& record) {
        const auto ran = gpu_.run(record);
        ASSERT_TRUE(ran) << ran.error();
    }

  private:
    void record(const CellStep& step, const Air::Recorded& recorded = {}) {
        if (recording_ != VK_NULL_HANDLE)
            air_->step(recording_, step, recorded);
        else
            in_one_recording([&] { air_->step(recording_, step, recorded); });
    }

    void show(VkCommandBuffer commands) {
        air_->show(commands, 1.0f, frame_ ^= 1, true);
        air_->read_back(commands, {});
        air_->end(commands);
    }

    void apply(CellChange::Kind kind, std::span<const glm::vec4> cells = {}) {
        const WindCore& core = wind_.state().core;
        run([&](VkCommandBuffer commands) {
            air_->apply(commands, {.kind = kind, .ambient = core.ambient, .window = core.window(), .cells = cells});
        });
    }

    OwnDevice& gpu_;
    windrow::Wind wind_;
    Motors motors_;
    std::unique_ptr<Air> air_;
    Diagnostics diagnostics_;
    int frame_ = 0;
    VkCommandBuffer recording_ = VK_NULL_HANDLE; ///< of several steps
};

std::vector<glm::vec4> smooth_start(const Config& config) {
    const Box box{config.cells, config.cell_size, config.boundaries};
    std::vector<glm::vec4> field(box.cell_count());
    for (int k = 0; k < config.cells.z; ++k)
        for (int j = 0; j < config.cells.y; ++j)
            for (int i = 0; i < config.cells.x; ++i) {
                const glm::vec3 p = 6.2831853f * (glm::vec3(i, j, k) + 0.5f) / glm::vec3(config.cells);
                field[box.index(i, j, k)] =
                    glm::vec4(config.ambient, 0.0f) + glm::vec4(std::sin(p.y + 1.0f) * std::cos(p.z), 0.7f * std::sin(p.z - p.x),
                                                                0.8f * std::cos(p.x + 0.5f) * std::sin(2.0f * p.y), 0.0f);
            }
    return field;
}

std::vector<test::NamedConfig> settings() {
    const auto with = [](const std::function<void(Config&)>& change) {
        return test::with({.cells = {16, 16, 16}, .ambient = {2.0f, 0.0f, 1.0f}}, change);
    };
    const auto closed = [](BoundaryKind kind, float viscosity = Config{}.viscosity) {
        return Config{.cells = {16, 16, 16}, .boundaries = Boundaries::all(kind), .viscosity = viscosity};
    };
    Config mixed{.cells = {12, 10, 14}, .ambient = {0.0f, 1.0f, 0.0f}};
    mixed.boundaries.x_low.kind = BoundaryKind::free_slip;
    mixed.boundaries.y_low.kind = mixed.boundaries.y_high.kind = BoundaryKind::periodic;
    mixed.boundaries.z_high = {BoundaryKind::no_slip, {1.0f, 0.0f, 0.0f}};
    return {
        {"open", with([](Config&) {})},
        {"default", {.ambient = {3.0f, 0.2f, 1.0f}}},
        {"odd", {.cells = {17, 9, 23}, .boundaries = Boundaries::open_over_floor(), .ambient = {2.0f, 0.0f, -1.0f}}},
        {"periodic", with([](Config& c) { c.boundaries = Boundaries::all(BoundaryKind::periodic); })},
        {"walls", closed(BoundaryKind::no_slip)},
        {"slip", closed(BoundaryKind::free_slip)},
        {"mixed", mixed},
        {"linear", with([](Config& c) { c.interpolation = Interpolation::linear; })},
        {"cubic_32", with([](Config& c) { c.interpolation = Interpolation::cubic_32; })},
        {"classic", with([](Config& c) { c.scheme = Scheme::stable_fluids; })},
        {"viscous", closed(BoundaryKind::no_slip, 1.0f)},
        {"owing", with([](Config& c) { c.viscosity = 1e-3f; })},
        {"syrup", test::with(mixed, [](Config& c) { c.viscosity = 200.0f; })},
        {"syrup_walls",
         test::with(closed(BoundaryKind::no_slip, 20.0f), [](Config& c) { c.boundaries.y_high.wall_velocity.x = 3.0f; })},
        {"profile", with([](Config& c) {
             c.boundaries = Boundaries::open_over_floor();
             c.profile = LogProfile{};
         })},
        {"gusts", with([](Config& c) {
             c.boundaries = Boundaries::open_over_floor();
             c.gusts.intensity = 0.3f;
         })},
    };
}

void add_motors(Twin& twin, const Config& config) {
    const auto h = static_cast<double>(config.cell_size);
    const glm::dvec3 centre = twin.wind().origin() + 0.5 * h * glm::dvec3(config.cells);
    twin.add(DirectionalMotor{.position = centre + glm::dvec3(1.0, 0.5, 0.0), .direction = {0.0f, 0.0f, 1.0f}});
    twin.add(VortexMotor{.position = centre - glm::dvec3(2.0, 0.0, 1.0)});
    twin.add(JetMotor{.position = centre + glm::dvec3(-3.0, 0.0, 2.0), .direction = {1.0f, 0.3f, 0.0f}});
}

using AirParity = Gpu;

TEST_F(AirParity, EveryKindOfBoxAgreesAfterOneStepAndAfterAHundred) {
    for (const test::NamedConfig& setting : settings()) {
        SCOPED_TRACE(setting.name);
        Twin twin(*own, setting.config);
        twin.set_velocity(smooth_start(setting.config));
        add_motors(twin, setting.config);
        twin.step(1.0 / 30.0);
        const double one = twin.difference();
        WINDROW_EXPECT_FIGURE("parity.one_step." + setting.name, one, 1e-5);
        // Between whole runs eight, since scenarios_test.cpp plays the default boxes for longer.
        const bool whole = test::whole_sweeps();
        for (int n = 1; n < (whole ? 100 : 8); ++n)
            twin.step(1.0 / 30.0);
        WINDROW_EXPECT_FIGURE((whole ? "parity.hundred_steps." : "parity.eight_steps.") + setting.name, twin.difference(), 1e-5);
    }
}

// More ticks and motors than a slot has room for: the command buffer writes the blocks of the others.
TEST_F(AirParity, BlocksThatDoNotFitAreWrittenByCommands) {
    const Config config{.cells = {14, 10, 12}, .ambient = {2.0f, 0.0f, 1.0f}};
    Twin twin(*own, config);
    for (int n = 0; n < 30; ++n)
        twin.add(DirectionalMotor{.position = {0.3 * n - 4.0, 0.1 * n, 2.0 - 0.2 * n}, .direction = {0.0f, 0.0f, 1.0f}});
    twin.step(1.0 / 30.0);
    int transfers = twin.air().transfers();
    twin.step(1.0 / 30.0);
    EXPECT_EQ(twin.air().transfers(), transfers) << "a tick by itself has none";
    twin.in_one_recording([&] {
        for (int n = 0; n < 24; ++n)
            twin.step(n % 5 == 4 ? 1.0 / 60.0 : 1.0 / 30.0);
    });
    transfers = twin.air().transfers() - transfers;
    EXPECT_GE(transfers, 24 - 16 + 24 - 128 / 30); // all steps but 16, all lists of 30 motors but 4
    WINDROW_EXPECT_FIGURE("parity.many_ticks_of_a_recording", twin.difference(), 1e-5);
}

// The host foresees too little: one sub-step is recorded where five are needed, then three, then all. The CPU takes each of the
// device's sub-steps as a step of its own: nothing is cut, and all time is made up for.
TEST_F(AirParity, TimeOfSubstepsThatAreNotRecordedIsCarriedOver) {
    const auto fast = [](const std::function<void(Config&)>& change) {
        return test::with({.cells = {16, 12, 14}, .ambient = {250.0f, 0.0f, 100.0f}, .sleep_speed = 0.0f}, change);
    };
    const auto around = [&](const std::function<void(Config&)>& change) { // where the air that it holds stays
        return fast([&](Config& c) {
            c.boundaries = Boundaries::all(BoundaryKind::periodic);
            change(c);
        });
    };
    const test::NamedConfig settings[] = {
        {"gusts", fast([](Config& c) { c.gusts.intensity = 0.05f; })},
        {"periodic", around([](Config&) {})},
        {"viscous", around([](Config& c) { c.viscosity = 0.5f; })},
        {"implicit", around([](Config& c) { c.viscosity = 8.0f; })},
        {"relaxing", around([](Config& c) { c.relaxation_time = 0.5f; })},
    };
    for (const test::NamedConfig& setting : settings) {
        SCOPED_TRACE(setting.name);
        Config on_cpu = setting.config;
        on_cpu.max_cfl *= 1.5f; // the air may be faster in a later sub-step of a tick
        Twin twin(*own, setting.config, on_cpu);
        twin.set_velocity(smooth_start(setting.config));
        AmbientWind ambient = twin.wind().state().core.ambient;
        const double dt = 1.0 / 30.0;
        double carried = 0.0, time = 0.0, longest = 0.0;
        for (int n = 0; n < 12; ++n) {
            twin.step_device(dt, ambient, {.substeps = n < 3 ? 1 : n < 5 ? 3 : 8, .limits = n >= 5});
            const AirReport report = twin.report();
            ASSERT_LE(report.substeps, n < 3 ? 1 : n < 5 ? 3 : 8);
            EXPECT_EQ(report.limited_cells, 0);
            EXPECT_TRUE(n < 5 ? report.carried_time > 0.0f : n < 11 || report.carried_time == 0.0f) << n;
            const double whole = dt + carried - static_cast<double>(report.carried_time);
            carried = static_cast<double>(report.carried_time);
            longest = std::max(longest, carried);
            for (int part = 0; part < report.substeps; ++part)
                ASSERT_EQ(twin.wind().step(whole / report.substeps).substeps, 1);
            time += whole;
        }
        EXPECT_NEAR(time, 12.0 * dt, 1e-6);
        EXPECT_GT(longest, 2.5 * dt);
        WINDROW_EXPECT_FIGURE("parity.carried_over." + setting.name, twin.difference(), 1e-5);
    }
}

} // namespace
} // namespace windrow::vulkan
