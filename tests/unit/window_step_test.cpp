// A step of a box that has followed equals copy, then step, to the bit: the copy made by hand, with the history that the
// second-order step carries, and the step put together from the public pieces.

#include "fluid/core/solve_policy.h"
#include "fluid/cpu/acting.h"
#include "tests/winds.h"

#include <optional>

namespace {

using namespace windrow;
using namespace windrow::test;

/// The air on arrays of the test's own. Each step is that of cpu/step.cpp in one part.
class AirByHand {
  public:
    AirByHand(const Config& config, glm::dvec3 origin)
        : config_(config),
          work_(Workspace::create({.box = {config.cells, config.cell_size, config.boundaries}, .ambient = config.ambient})),
          window_{config.cells, config.cell_size, CellIndex(glm::round(origin / double(config.cell_size)))},
          sources_(config.cells), ambient_(work_->ambient(), 0.0f), u_(cell_count(config.cells), ambient_), old_(u_),
          history_(u_.size(), glm::vec4(0.0f)), diffused_(u_) {}

    [[nodiscard]] Motors& motors() { return motors_; }
    [[nodiscard]] const Field& field() const { return u_; }
    void set(const Field& field) {
        u_ = field;
        fresh_ = true;
    }

    void step(float dt) {
        motors_.begin_frame(0.0, dt);
        const auto reached = motors_.tick(dt, window_, config_.boundaries);
        const auto& tile = motors_.tile({});
        sources_.gather(reached, Box{.cells = window_.cells, .cell_size = window_.cell_size}, u_,
                        {tile ? tile->texels().data() : nullptr}, {});
        if (fresh_) {
            perform(dt);
            std::swap(u_, old_);
            for (std::size_t n = 0; n < u_.size(); ++n)
                old_[n] = 2.0f * u_[n] - old_[n];
        }
        perform(dt);
    }

    void perform(float dt) {
        const bool spreads = *diffuse(*work_, u_, config_.viscosity, dt, diffused_) != DiffusionMethod::none;
        Transport transport{
            .carried = spreads ? diffused_ : u_, .velocity = u_, .dt = dt, .interpolation = config_.interpolation};
        if (const float time = relaxation_time(config_, false); time > 0.0f)
            transport.relaxation = 1.0f / (1.0f + dt / time);
        const numerics::WindrowPast past = numerics::windrow_past(fresh_ ? 0.0f : dt / dt_old_);
        if (fresh_)
            history_.assign(u_.size(), glm::vec4(0.0f));
        else
            transport.velocity_old = old_;
        transport.extrapolation = past.scale;
        transport.history = history_;
        transport.history_scale = fresh_ ? 1.0f : past.scale;
        const ParallelFor serial;
        const cpu::Acting acting(sources_, {.cells = config_.cells, .dt = dt, .parallel_for = &serial});
        const auto departing = [&](std::size_t n, glm::ivec3, std::span<glm::vec4> winds) {
            for (std::size_t i = 0; i < winds.size(); ++i) {
                const glm::vec4 u = transport.carried[n + i], rest(glm::vec3(ambient_), 0.0f);
                winds[i] = transport.relaxation != 1.0f ? rest + transport.relaxation * (u - rest) : u;
            }
            return true;
        };
        acting.depart(departing, {}, transport.history_scale, history_);
        Field arrived(u_.size());
        advect(*work_, transport, arrived);
        const auto nothing = [](std::size_t, glm::ivec3, std::span<glm::vec4>) { return false; };
        acting.arrive(nothing, transport.history_scale, history_, arrived);
        Field slope(u_.size());
        project(*work_, arrived, slope);
        for (std::size_t n = 0; n < slope.size(); ++n)
            history_[n] = past.weight * slope[n] + past.kept * history_[n];
        old_ = u_;
        u_ = arrived;
        fresh_ = false;
        dt_old_ = dt;
    }

    void copy_to(glm::dvec3 origin) {
        const CellIndex place(glm::round(origin / double(config_.cell_size)));
        const CellIndex shift = place - window_.origin_cells;
        window_.origin_cells = place;
        u_ = copied(u_, shift, ambient_);
        // A cell that is new has no past: its last wind is its wind, its history 0.
        old_ = copied(old_, shift, ambient_);
        history_ = copied(history_, shift, glm::vec4(0.0f));
    }

  private:
    [[nodiscard]] Field copied(const Field& from, CellIndex shift, glm::vec4 outside) const {
        Field to(from.size(), outside);
        const glm::ivec3 cells = config_.cells;
        const Box& box = work_->box();
        for_each_cell(cells, [&](int i, int j, int k) {
            const CellIndex source = CellIndex(i, j, k) + shift;
            if (glm::all(glm::greaterThanEqual(source, CellIndex(0))) && glm::all(glm::lessThan(source, CellIndex(cells))))
                to[box.index(i, j, k)] = from[box.index(int(source.x), int(source.y), int(source.z))];
        });
        return to;
    }

    Config config_;
    Result<Workspace> work_;
    Window window_;
    Motors motors_;
    cpu::SourceField sources_;
    glm::vec4 ambient_;
    Field u_, old_, history_, diffused_;
    bool fresh_ = true;
    float dt_old_ = 0.0f;
};

std::vector<NamedConfig> cases() {
    const Config base{.cells = {17, 9, 14},
                      .ambient = {2.0f, 0.5f, -1.0f},
                      .viscosity = 0.0f,
                      .relaxation_time = 0.0f,
                      .sleep_speed = 0.0f,
                      .max_cfl = 1e6f};
    return {{"inviscid", base},
            {"relaxation", with(base, [](Config& c) { c.relaxation_time = 5.0f; })},
            {"one_pass", with(base, [](Config& c) { c.viscosity = 1.0f; })},
            {"implicit", with(base, [](Config& c) { c.viscosity = 40.0f; })},
            {"linear", with(base, [](Config& c) { c.interpolation = Interpolation::linear; })},
            {"cubic_32", with(base, [](Config& c) { c.interpolation = Interpolation::cubic_32; })},
            {"floor", with(base, [](Config& c) { c.boundaries = Boundaries::open_over_floor(); })},
            {"mixed", with(base,
                           [](Config& c) {
                               c.boundaries.y_low = {BoundaryKind::no_slip, {0.5f, 0.0f, 0.25f}};
                               c.boundaries.z_low.kind = c.boundaries.z_high.kind = BoundaryKind::periodic;
                               c.viscosity = 1.0f;
                           })},
            {"half_metre", with(base, [](Config& c) { c.cell_size = 0.5f; })}};
}

TEST(WindowStep, AShiftedStepEqualsCopyThenStep) {
    for (const NamedConfig& each : cases()) {
        Wind wind = made(each.config);
        AirByHand by_hand(each.config, wind.origin());
        const Field start = white_noise(each.config.cells, 3.0f, 51);
        ASSERT_TRUE(wind.set_velocity(start));
        by_hand.set(start);
        std::optional<MotorId> body;
        for (Motors* motors : {&wind.motors(), &by_hand.motors()}) {
            ASSERT_TRUE(motors->add(DirectionalMotor{
                .position = {0.3, -0.2, 0.9}, .region = Sphere{3.0f}, .law = Force{30.0f}, .turbulence = k_steady}));
            ASSERT_TRUE(motors->add(DirectionalMotor{
                .position = {-2.3, 0.7, 0.1}, .direction = {0.0f, 1.0f, 1.0f}, .region = AlignedBox{}, .turbulence = k_steady}));
            const auto id = motors->add(WakeMotor{.radius = 1.2f, .law = WakeForce{}});
            ASSERT_TRUE(id);
            body = {.slot = id->slot, .generation = id->generation}; // the same in both
        }
        Random random(52);
        std::size_t differing = 0;
        const double h = each.config.cell_size;
        for (int n = 0; n < 40; ++n) {
            if (n > 2) { // the first steps build a history that the shifts must carry
                const glm::dvec3 centre = wind.origin() + 0.5 * h * glm::dvec3(each.config.cells);
                ASSERT_TRUE(wind.follow(centre + h * glm::round(random.point(3.0))));
                if (each.config.boundaries.y_low.solid()) {
                    ASSERT_TRUE(wind.set_floor(h * random.integer(-4, 1)));
                }
                by_hand.copy_to(wind.origin());
            }
            for (Motors* motors : {&wind.motors(), &by_hand.motors()})
                ASSERT_TRUE(motors->move(*body, {0.1 * n, 0.0, 0.3 * n}));
            const double dt = n % 7 == 6 ? 0.01 : 0.05;
            ASSERT_EQ(wind.step(dt).substeps, 1);
            by_hand.step(static_cast<float>(dt));
            differing += cells_that_differ(wind.field(), by_hand.field());
        }
        ASSERT_TRUE(all_finite(wind.field()));
        EXPECT_GT(largest_speed(wind.field()), 0.5);
        WINDROW_EXPECT_FIGURE("shifted_step_cells_that_differ_" + each.name, double(differing), 0.0);
    }
}

// Once the motors are gone, later steps equal those of a run without motors from the same state.
TEST(WindowStep, SixtyFourMotorsComeAndGo) {
    const Config config{.cells = {16, 12, 14}, .ambient = {1.0f, 0.0f, 0.0f}, .max_cfl = 1e6f};
    Wind wind = made(config);
    AirByHand by_hand(config, wind.origin());
    Random random(53);
    std::vector<MotorId> ids;
    for (int n = 0; n < 64; ++n) {
        const DirectionalMotor motor{.position = random.point(5.0),
                                     .direction = random.vector(1.0f),
                                     .region = Sphere{random.uniform(1.0f, 3.0f)},
                                     .law = n % 2 == 0 ? decltype(DirectionalMotor::law)(Force{20.0f}) : Drive{},
                                     .turbulence = k_steady};
        ids.push_back(added(wind, motor));
        ASSERT_TRUE(by_hand.motors().add(motor));
        wind.step(0.02);
        by_hand.step(0.02f);
    }
    ASSERT_EQ(cells_that_differ(wind.field(), by_hand.field()), 0u);
    EXPECT_GT(largest_speed(wind.field()), 1.5);
    for (const MotorId id : ids)
        ASSERT_TRUE(wind.motors().remove(id));
    by_hand.motors() = Motors{};
    for (int n = 0; n < 20; ++n) {
        EXPECT_EQ(wind.step(0.02).motors_in_reach, 0);
        by_hand.step(0.02f);
        ASSERT_EQ(cells_that_differ(wind.field(), by_hand.field()), 0u) << "step " << n;
    }
}

} // namespace
