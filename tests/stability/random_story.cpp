#include "tests/stability/random_story.h"

#include <cmath>
#include <limits>
#include <tuple>

namespace windrow::test {

int pick(int low, int high) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high + 1));
}

double real(double low, double high) {
    return low + (high - low) * pick(0, 1000) / 1000.0;
}

double spread(double low, double high) {
    return low * std::pow(high / low, pick(0, 1000) / 1000.0);
}

namespace {

// In [-most, most]; shrinks toward 0.
int around(int most) {
    const int n = pick(0, 2 * most);
    return n % 2 == 0 ? -n / 2 : n / 2 + 1;
}

} // namespace

Boundaries some_sides(double wall_speed) {
    Boundaries boundaries;
    Boundary* const ordered[6] = {&boundaries.x_low,  &boundaries.x_high, &boundaries.y_low,
                                  &boundaries.y_high, &boundaries.z_low,  &boundaries.z_high};
    for (int axis = 0; axis < 3; ++axis) {
        const bool periodic = pick(0, 3) == 3;
        for (int end = 0; end < 2; ++end) {
            Boundary& side = *ordered[2 * axis + end];
            side.kind = periodic ? BoundaryKind::periodic : static_cast<BoundaryKind>(pick(0, 2));
            if (side.kind != BoundaryKind::no_slip || wall_speed == 0.0)
                continue;
            for (int along = 0; along < 3; ++along)
                side.wall_velocity[along] = along == axis ? 0.0f : static_cast<float>(around(10) * wall_speed / 10.0);
        }
    }
    return boundaries;
}

namespace {

float single(double value) {
    return static_cast<float>(value);
}

// Around 0, toward which it shrinks; in tenths.
glm::dvec3 point(double size) {
    const int x = around(10), y = around(10), z = around(10);
    return glm::dvec3(x, y, z) * (size / 10.0);
}

glm::vec3 direction() {
    const glm::vec3 any(point(1.0));
    return any == glm::vec3(0.0f) ? glm::vec3(1.0f, 0.0f, 0.0f) : any;
}

Gusts some_gusts(double cell_size) {
    return {.intensity = single(real(0.0, 1.0)), .length = single(cell_size * spread(1.0, 50.0))};
}

// --- Motors; lengths in cells, scaled later ----------------------------------------------------------------------------

float size_in_cells() {
    return single(spread(0.05, 8.0));
}

std::variant<Force, Drive> some_law() {
    if (pick(0, 2) == 2)
        return Force{single(spread(0.1, 1e4)) * (pick(0, 1) == 0 ? 1.0f : -1.0f)};
    return Drive{.speed = single(spread(0.1, 1000.0)) * (pick(0, 1) == 0 ? 1.0f : -1.0f), .rate = single(spread(1e-3, 1e6))};
}

Envelope some_envelope() {
    if (pick(0, 2) < 2)
        return {};
    return {.attack = single(real(0.0, 0.5)), .hold = single(spread(1e-3, 1.0)), .decay = single(real(0.0, 0.5))};
}

Turbulence some_turbulence() {
    switch (pick(0, 3)) {
    case 0:
        return {.intensity = 0.0f};
    case 1:
        return {.intensity = single(real(0.0, 1.0)), .length = single(spread(1e-3, 1e3)), .seed = 77};
    default:
        return {};
    }
}

Region some_region() {
    switch (pick(0, 3)) {
    case 0:
        return Sphere{size_in_cells()};
    case 1:
        return Capsule{glm::vec3(point(4.0)), size_in_cells()};
    case 2:
        return AlignedBox{{size_in_cells(), size_in_cells(), size_in_cells()}};
    default:
        return Cone{direction() * size_in_cells(), size_in_cells(), size_in_cells()};
    }
}

Motor some_motor() {
    const glm::dvec3 at = point(8.0);
    switch (pick(0, 6)) {
    case 0:
    case 1:
        return DirectionalMotor{.position = at,
                                .direction = direction(),
                                .region = some_region(),
                                .law = some_law(),
                                .envelope = some_envelope(),
                                .turbulence = some_turbulence()};
    case 2: {
        WakeMotor wake{.position = at, .radius = size_in_cells()};
        if (pick(0, 2) == 2)
            wake.law = WakeForce{single(spread(0.01, 1e3))};
        else
            wake.law = WakeDrive{.per_metre = single(spread(0.01, 1e4)), .entrainment = single(real(0.0, 2.0))};
        wake.envelope = some_envelope();
        wake.turbulence = some_turbulence();
        return wake;
    }
    case 3:
        return JetMotor{.position = at,
                        .direction = direction(),
                        .length = size_in_cells(),
                        .start_radius = size_in_cells(),
                        .end_radius = size_in_cells(),
                        .law = some_law(),
                        .envelope = some_envelope(),
                        .turbulence = some_turbulence()};
    case 4:
        return VortexMotor{.position = at,
                           .axis = direction(),
                           .radius = size_in_cells(),
                           .half_length = size_in_cells(),
                           .lift = single(around(10)),
                           .law = some_law(),
                           .envelope = some_envelope()};
    case 5:
        return OmniMotor{.position = at,
                         .radius = size_in_cells(),
                         .speed = single(spread(0.1, 1000.0)) * (pick(0, 1) == 0 ? 1.0f : -1.0f),
                         .envelope = some_envelope()};
    default:
        return PressureMotor{.position = at,
                             .radius = size_in_cells(),
                             .speed = single(spread(0.1, 1000.0)) * (pick(0, 1) == 0 ? 1.0f : -1.0f),
                             .duration = single(spread(1e-3, 1.0))};
    }
}

// --- From cells to metres ------------------------------------------------------------------------------------------------

struct Metres {
    double h;
    glm::dvec3 centre;

    void length(float& value) const { value = single(static_cast<double>(value) * h); }
    void length(glm::vec3& value) const { value = glm::vec3(glm::dvec3(value) * h); }
    void place(glm::dvec3& value) const { value = centre + value * h; }

    void operator()(DirectionalMotor& motor) const {
        if (auto* ball = std::get_if<Sphere>(&motor.region))
            length(ball->radius);
        else if (auto* capsule = std::get_if<Capsule>(&motor.region))
            length(capsule->half_axis), length(capsule->radius);
        else if (auto* box = std::get_if<AlignedBox>(&motor.region))
            length(box->half_size);
        else {
            auto& cone = std::get<Cone>(motor.region);
            length(cone.axis), length(cone.start_radius), length(cone.end_radius);
        }
    }
    void operator()(WakeMotor& motor) const { length(motor.radius); }
    void operator()(JetMotor& motor) const { length(motor.length), length(motor.start_radius), length(motor.end_radius); }
    void operator()(VortexMotor& motor) const { length(motor.radius), length(motor.half_length); }
    void operator()(OmniMotor& motor) const { length(motor.radius); }
    void operator()(PressureMotor& motor) const { length(motor.radius); }
    void motor(Motor& any) const {
        std::visit([&](auto& kind) { place(kind.position), (*this)(kind); }, any);
    }

    void operator()(story::Add& event) const { motor(event.motor); }
    void operator()(story::Replace& event) const { motor(event.motor); }
    void operator()(story::Move& event) const { place(event.position); }
    void operator()(story::Follow& event) const { place(event.point); }
    void operator()(story::Floor& event) const { event.height = centre.y + event.height * h; }
    void operator()(story::ChangeGusts& event) const { length(event.gusts.length); }
    void operator()(auto&) const {}
};

Story in_metres(Config config, story::StartAir start, std::vector<story::Event> events) {
    const Metres metres{static_cast<double>(config.cell_size), config.centre};
    for (story::Event& event : events)
        std::visit(metres, event);
    return {std::move(config), start, std::move(events)};
}

// --- Events ---------------------------------------------------------------------------------------------------------------

story::Event some_steps() {
    const int count = pick(1, 12);
    return story::Steps{count, pick(0, 9) == 9 ? spread(1e-9, 1e3) : spread(1e-4, 1.0)};
}

// Near, far, and beyond all that a float can tell apart: 1e12 m is as far as a motor goes.
glm::dvec3 some_place() {
    const int far = pick(0, 5);
    return point(far < 4 ? 20.0 : far == 4 ? 1e6 : 1e10);
}

story::Event any_event() {
    switch (pick(0, 20)) {
    case 0:
    case 1:
    case 2:
    case 3:
    case 4:
        return some_steps();
    case 5:
        return story::Advances{pick(1, 6), spread(1e-3, 0.3)};
    case 6:
    case 7:
    case 8:
        return story::Add{some_motor()};
    case 9:
        return story::Replace{pick(0, 5), some_motor()};
    case 10:
    case 11:
        return story::Move{pick(0, 5), pick(0, 5) == 5 ? some_place() : point(8.0)};
    case 12:
        return story::Remove{pick(0, 5)};
    case 13:
    case 14:
        return story::Follow{some_place()};
    case 15:
        return story::ChangeSides{some_sides(10.0)};
    case 16:
        return story::ChangeAmbient{glm::vec3(point(20.0))};
    case 17:
        return story::ChangeGusts{some_gusts(1.0)};
    case 18: {
        constexpr float k_bad[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                                   -std::numeric_limits<float>::infinity()};
        const int cell = pick(0, 20'000);
        return story::Break{cell, k_bad[pick(0, 2)]};
    }
    case 19:
        return story::SaveAndLoad{};
    default:
        if (pick(0, 1) == 0)
            return story::Floor{static_cast<double>(around(20))};
        return story::Reset{};
    }
}

story::StartAir::Pattern some_start(int first) {
    return static_cast<story::StartAir::Pattern>(pick(first, 3));
}

} // namespace

Config any_config() {
    Config config;
    // Half of the boxes are small, where a step costs little and every cell is near a side.
    const int most = pick(0, 1) == 0 ? 8 : 24;
    config.cells = {pick(1, most), pick(1, most), pick(1, most)};
    config.cell_size = single(spread(0.05, 20.0));
    config.viscosity = pick(0, 2) == 0 ? 0.0f : single(spread(1e-5, 1e4));
    config.relaxation_time = pick(0, 1) == 0 ? 0.0f : single(spread(0.1, 100.0));
    config.scheme = pick(0, 3) == 3 ? Scheme::stable_fluids : Scheme::second_order;
    const int read = pick(0, 3);
    config.interpolation = read == 3 ? Interpolation::linear : read == 2 ? Interpolation::cubic_32 : Interpolation::cubic;
    return config;
}

rc::Gen<Story> any_story() {
    const auto config = rc::gen::exec([] {
        Config any = any_config();
        any.boundaries = some_sides(10.0);
        any.ambient = glm::vec3(point(20.0));
        any.centre = point(pick(0, 3) < 3 ? 100.0 : 1e6) * static_cast<double>(any.cell_size);
        if (pick(0, 2) == 2)
            any.profile = LogProfile{single(spread(1e-3, 1.0)), single(spread(1.0, 100.0))};
        if (pick(0, 2) == 2)
            any.gusts = some_gusts(static_cast<double>(any.cell_size));
        if (pick(0, 3) == 3 && !any.boundaries.periodic(1))
            any.roughness =
                Roughness{.length = single(spread(1e-4, 10.0)), .longest_mixing = single(pick(0, 1) * spread(0.1, 10.0))};
        any.blend_width = single(pick(0, 4));
        any.sleep_speed = pick(0, 2) < 2 ? 1e-3f : 0.0f;
        any.jump_speed = 0.0f; // wakes of any speed
        any.max_cfl = pick(0, 1) == 0 ? 2.0f : single(spread(0.5, 50.0));
        any.max_substeps = pick(1, 8);
        any.ticks.hz = spread(5.0, 200.0);
        any.ticks.max_per_call = pick(1, 6);
        if (const int off = pick(0, 19); off >= 15) {
            Stages& stages = any.stages;
            bool* const all[] = {&stages.sources, &stages.relaxation, &stages.diffusion, &stages.advection, &stages.projection};
            *all[off - 15] = false;
        }
        return any;
    });
    const auto start = rc::gen::exec([] {
        const story::StartAir::Pattern kind = some_start(0);
        return story::StartAir{kind, single(spread(0.01, 100.0)), static_cast<std::uint32_t>(pick(1, 1000)), pick(0, 1) == 1};
    });
    const auto events = rc::gen::container<std::vector<story::Event>>(rc::gen::exec([] { return any_event(); }));
    return rc::gen::map(rc::gen::tuple(config, start, events),
                        [](std::tuple<Config, story::StartAir, std::vector<story::Event>> all) {
                            return in_metres(std::get<0>(all), std::get<1>(all), std::get<2>(all));
                        });
}

rc::Gen<Story> calm_story(Config (*config)(), double max_cells) {
    const auto box = rc::gen::exec([config] {
        Config calm = config();
        calm.boundaries = some_sides(0.0);
        calm.max_cfl = 1e6f; // the raw step
        calm.sleep_speed = 0.0f;
        return calm;
    });
    const auto start = rc::gen::exec([] {
        const story::StartAir::Pattern kind = some_start(1);
        return story::StartAir{kind, 1.0f, static_cast<std::uint32_t>(pick(1, 1000)), true};
    });
    const auto event = rc::gen::exec([max_cells]() -> story::Event {
        switch (pick(0, 6)) {
        case 4:
            return story::Follow{point(3.0)};
        case 5:
            return story::ChangeSides{some_sides(0.0)};
        case 6:
            return story::SaveAndLoad{};
        default: {
            const int count = pick(1, 20);
            return story::Steps{count, spread(1e-3, max_cells)}; // in steps of one cell at 1 m/s
        }
        }
    });
    const auto events = rc::gen::container<std::vector<story::Event>>(event);
    return rc::gen::map(rc::gen::tuple(box, start, events),
                        [](std::tuple<Config, story::StartAir, std::vector<story::Event>> all) {
                            for (story::Event& any : std::get<2>(all))
                                if (auto* steps = std::get_if<story::Steps>(&any))
                                    steps->dt *= static_cast<double>(std::get<0>(all).cell_size);
                            return in_metres(std::get<0>(all), std::get<1>(all), std::get<2>(all));
                        });
}

} // namespace windrow::test
