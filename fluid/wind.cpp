#include "fluid/wind_state.h"

#include "fluid/message.h"
#include "fluid/numerics.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace windrow {
namespace {

constexpr double k_farthest_cells = 1e12;
constexpr float k_most_wind = 1e4f;
constexpr float k_longest_prepared = 1.0f; // [s]
constexpr const char* k_axis_names[3] = {"x", "y", "z"};

template <class Vector>
bool finite(const Vector& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool can_follow(const Sides& sides, int axis) { return !sides.periodic(axis) && !sides.has_solid(axis); }

void check_ambient(detail::Reasons& reasons, glm::vec3 ambient) {
    if (!finite(ambient) || std::max({std::abs(ambient.x), std::abs(ambient.y), std::abs(ambient.z)}) > k_most_wind)
        reasons.add("ambient is ", ambient, " m/s: give finite numbers, at most 1e4 m/s in size.");
}

void check_follow(detail::Reasons& reasons, const std::optional<glm::bvec3>& follow, const Sides& sides) {
    for (int axis = 0; axis < 3 && follow; ++axis)
        if ((*follow)[axis] && !can_follow(sides, axis))
            reasons.add("follow_axes asks the box to follow along ", k_axis_names[axis], ", where a side is ",
                        sides.periodic(axis) ? "periodic" : "solid", ": open both sides of that axis or leave it out",
                        axis == 1 ? " (set_floor moves a floor)." : ".");
}

glm::bvec3 axes_that_follow(const std::optional<glm::bvec3>& follow, const Sides& sides) {
    return follow ? *follow : glm::bvec3(can_follow(sides, 0), can_follow(sides, 1), can_follow(sides, 2));
}

bool in_range(const Config& config, glm::dvec3 point) {
    return finite(point) && std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)}) <= k_farthest_cells * static_cast<double>(config.cell_size);
}

float side_number(const Side& side) { return side.kind == SideKind::open ? 0.0f : side.kind == SideKind::periodic ? 2.0f : 1.0f; }

} // namespace

Result<void> validate(const Config& config) {
    detail::Reasons reasons;
    if (auto box = validate(Box{config.cells, config.cell_size, config.sides}); !box)
        reasons.add(box.error());
    if (!finite(config.centre) || (config.cell_size > 0.0f && !in_range(config, config.centre)))
        reasons.add("centre is ", config.centre, " m: give finite numbers within 1e12 cells of the origin.");
    check_follow(reasons, config.follow_axes, config.sides);
    check_ambient(reasons, config.ambient);
    if (!(config.viscosity >= 0.0f && config.viscosity <= 1e9f))
        reasons.add("viscosity is ", config.viscosity, " m2/s: give 0 to 1e9.");
    if (!(config.settling_time >= 0.0f && config.settling_time <= 1e9f))
        reasons.add("settling_time is ", config.settling_time, " s: give 0 (never) to 1e9.");
    if (!(config.max_cfl > 0.0f && config.max_cfl <= 1e6f))
        reasons.add("max_cfl is ", config.max_cfl, ": give a number above 0, at most 1e6; 2 is accurate.");
    if (config.max_substeps < 1 || config.max_substeps > 64)
        reasons.add("max_substeps is ", config.max_substeps, ": give 1 to 64.");
    if (!reasons.empty())
        return Error{reasons.take()};
    return {};
}

Wind::State::State(const Config& settings, Workspace workspace)
    : config(settings), follow_axes(axes_that_follow(settings.follow_axes, settings.sides)), work(std::move(workspace)),
      window{settings.cells, settings.cell_size, {}}, air(work.box().cell_count()), forces(settings.cells) {
    window.origin_cells = window.centred_on(config.centre);
    previous_origin_cells = stepped_origin_cells = window.origin_cells;
    fill_with_ambient();
    // A step of up to k_longest_prepared allocates nothing: what its viscosity needs is made here.
    const DiffusionMethod method = diffusion_method(config.viscosity, k_longest_prepared, config.cell_size);
    if (method != DiffusionMethod::none)
        diffused = cpu::Buffer<glm::vec4>(air.velocity.size());
    if (method == DiffusionMethod::implicit)
        reserve_diffusion(work);
}

void Wind::State::fill_with_ambient() {
    std::fill_n(air.velocity.data(), air.velocity.size(), ambient());
    air.fresh = true;
}

void Wind::State::shift_to(CellIndex origin_cells) {
    const CellIndex shift = origin_cells - window.origin_cells;
    if (shift == CellIndex(0))
        return;
    window.origin_cells = origin_cells;
    const bool beyond = std::abs(shift.x) >= window.cells.x || std::abs(shift.y) >= window.cells.y || std::abs(shift.z) >= window.cells.z;
    if (beyond) {
        fill_with_ambient();
        return;
    }
    shift_field(air.velocity, window.cells, shift, ambient());
    if (!air.fresh) {
        shift_field(air.velocity_old, window.cells, shift, ambient());
        shift_field(air.history, window.cells, shift, glm::vec4(0.0f));
    }
}

void Wind::State::change_ambient(glm::vec3 wind) {
    const glm::vec4 before = ambient();
    work.set_ambient(wind);
    const glm::vec4 change = ambient() - before;
    for (glm::vec4& u : std::span<glm::vec4>(air.velocity))
        u += change;
    if (!air.fresh)
        for (glm::vec4& u : std::span<glm::vec4>(air.velocity_old))
            u += change;
}

Wind::Wind(std::unique_ptr<State> state) : state_(std::move(state)) {}
Wind::Wind(Wind&&) noexcept = default;
Wind& Wind::operator=(Wind&&) noexcept = default;
Wind::~Wind() = default;

Result<Wind> Wind::create(const Config& config) {
    if (auto valid = validate(config); !valid)
        return Error{valid.error()};
    auto workspace = Workspace::create(
        {.box = {config.cells, config.cell_size, config.sides}, .ambient = config.ambient, .parallel_for = config.parallel_for});
    if (!workspace)
        return Error{workspace.error()};
    return Wind(std::make_unique<State>(config, *std::move(workspace)));
}

Diagnostics Wind::step(double dt) {
    if (!(dt > 0.0) || !std::isfinite(static_cast<float>(dt)) || static_cast<float>(dt) == 0.0f)
        return {};
    return state_->step(static_cast<float>(dt));
}

Motors& Wind::motors() { return state_->motors; }
const Motors& Wind::motors() const { return state_->motors; }

Result<void> Wind::set_ambient(glm::vec3 ambient) {
    detail::Reasons reasons;
    check_ambient(reasons, ambient);
    if (!reasons.empty())
        return Error{reasons.take()};
    state_->config.ambient = ambient;
    state_->change_ambient(ambient);
    return {};
}

glm::vec3 Wind::ambient() const { return state_->work.ambient(); }

Result<void> Wind::set_sides(const Sides& sides) {
    detail::Reasons reasons;
    if (auto valid = validate(sides); !valid)
        reasons.add(valid.error());
    check_follow(reasons, state_->config.follow_axes, sides);
    if (!reasons.empty())
        return Error{reasons.take()};
    bool same_kinds = true;
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end)
            same_kinds = same_kinds && sides.at(axis, end).kind == state_->config.sides.at(axis, end).kind;
    if (!same_kinds)
        state_->air.fresh = true;
    state_->config.sides = sides;
    state_->follow_axes = axes_that_follow(state_->config.follow_axes, sides);
    return state_->work.set_sides(sides);
}

Result<void> Wind::follow(glm::dvec3 point) {
    if (!in_range(state_->config, point))
        return Error{detail::message("follow point is ", point, " m: give finite numbers within 1e12 cells of the origin.")};
    CellIndex origin = state_->window.centred_on(point);
    for (int axis = 0; axis < 3; ++axis)
        if (!state_->follow_axes[axis])
            origin[axis] = state_->window.origin_cells[axis];
    state_->shift_to(origin);
    return {};
}

Result<void> Wind::set_floor(double height) {
    const Side& floor = state_->config.sides.y_low;
    if (!floor.solid())
        return Error{"set_floor needs a solid low y side: set sides.y_low to free_slip or no_slip, or use follow."};
    if (!in_range(state_->config, {0.0, height, 0.0}))
        return Error{detail::message("floor height is ", height, " m: give a finite number within 1e12 cells of the origin.")};
    CellIndex origin = state_->window.origin_cells;
    origin.y = static_cast<std::int64_t>(std::floor(height / static_cast<double>(state_->config.cell_size) + 0.5));
    state_->shift_to(origin);
    return {};
}

glm::dvec3 Wind::origin() const { return state_->window.origin(); }
const Box& Wind::box() const { return state_->box(); }

glm::vec3 Wind::velocity(glm::dvec3 position) const {
    const glm::vec3 ambient = state_->work.ambient();
    const Box& box = state_->box();
    glm::dvec3 exact = state_->window.local(position);
    if (!finite(exact))
        return ambient;
    for (int axis = 0; axis < 3; ++axis) // wrapped in double: a float far away holds no share of a cell
        if (box.sides.periodic(axis))
            exact[axis] = std::fmod(exact[axis], static_cast<double>(box.cells[axis]));
    const glm::vec3 local(exact);
    float share = 1.0f;
    glm::ivec3 low(0), high(0);
    glm::vec3 between(0.0f);
    for (int axis = 0; axis < 3; ++axis) {
        const auto cells = static_cast<float>(box.cells[axis]);
        const float low_kind = side_number(box.sides.at(axis, 0)), high_kind = side_number(box.sides.at(axis, 1));
        share *= numerics::windrow_axis_share(local[axis], cells, low_kind, high_kind);
        const float sample = numerics::windrow_axis_sample(local[axis], cells, low_kind) - 0.5f;
        const float below = std::floor(sample);
        between[axis] = sample - below;
        low[axis] = static_cast<int>(below);
        high[axis] = low[axis] + 1;
        if (low_kind == 2.0f) {
            low[axis] = (low[axis] + box.cells[axis]) % box.cells[axis];
            high[axis] = high[axis] % box.cells[axis];
        }
        low[axis] = std::clamp(low[axis], 0, box.cells[axis] - 1);
        high[axis] = std::clamp(high[axis], 0, box.cells[axis] - 1);
    }
    if (share <= 0.0f)
        return ambient;
    const auto cell = [&](int i, int j, int k) { return glm::vec3(state_->air.velocity[box.index(i, j, k)]); };
    const auto line = [&](int j, int k) { return glm::mix(cell(low.x, j, k), cell(high.x, j, k), between.x); };
    const auto plane = [&](int k) { return glm::mix(line(low.y, k), line(high.y, k), between.y); };
    return glm::mix(ambient, glm::mix(plane(low.z), plane(high.z), between.z), share);
}

void Wind::velocity(std::span<const glm::dvec3> positions, std::span<glm::vec3> velocities) const {
    const std::size_t count = std::min(positions.size(), velocities.size());
    for (std::size_t n = 0; n < count; ++n)
        velocities[n] = velocity(positions[n]);
}

std::span<const glm::vec4> Wind::field() const { return std::as_const(state_->air.velocity); }

namespace {

template <class Texel>
Result<void> write_texels(std::span<const glm::vec4> field, std::span<Texel> x, std::span<Texel> y, std::span<Texel> z) {
    for (const auto& texels : {x, y, z})
        if (texels.size() != field.size())
            return Error{detail::message("write_axes got room for ", texels.size(), " texels, but the box has ", field.size(),
                                         " cells: give three arrays of box().cell_count().")};
    extract_axis(field, 0, x);
    extract_axis(field, 1, y);
    extract_axis(field, 2, z);
    return {};
}

} // namespace

Result<void> Wind::write_axes(std::span<float> x, std::span<float> y, std::span<float> z) const { return write_texels(field(), x, y, z); }
Result<void> Wind::write_axes(std::span<std::uint16_t> x, std::span<std::uint16_t> y, std::span<std::uint16_t> z) const {
    return write_texels(field(), x, y, z);
}

WindowBlock Wind::window_block(glm::dvec3 anchor) const {
    const Box& box = state_->box();
    const double h = box.cell_size;
    WindowBlock block;
    block.origin_and_cell_size = {glm::vec3(state_->window.origin() - anchor), box.cell_size};
    block.cells_and_factor = {glm::vec3(box.cells), 1.0f};
    block.previous_origin = {glm::vec3(glm::dvec3(state_->previous_origin_cells) * h - anchor), 0.0f};
    block.ambient = {ambient(), 0.0f};
    for (int axis = 0; axis < 3; ++axis) {
        block.low_sides[axis] = side_number(box.sides.at(axis, 0));
        block.high_sides[axis] = side_number(box.sides.at(axis, 1));
    }
    return block;
}

void Wind::set_velocity(const std::function<glm::vec3(glm::dvec3)>& velocity_at) {
    const Box& box = state_->box();
    for (int k = 0; k < box.cells.z; ++k)
        for (int j = 0; j < box.cells.y; ++j)
            for (int i = 0; i < box.cells.x; ++i)
                state_->air.velocity[box.index(i, j, k)] = glm::vec4(velocity_at(state_->window.centre(i, j, k)), 0.0f);
    state_->air.fresh = true;
}

Result<void> Wind::set_velocity(std::span<const glm::vec4> field) {
    auto& velocity = state_->air.velocity;
    if (field.size() != velocity.size())
        return Error{detail::message("set_velocity got ", field.size(), " cells, but the box has ", velocity.size(), ": give box().cell_count().")};
    std::transform(field.begin(), field.end(), velocity.data(), [](glm::vec4 u) { return glm::vec4(u.x, u.y, u.z, 0.0f); });
    state_->air.fresh = true;
    return {};
}

void Wind::reset() { state_->fill_with_ambient(); }

const Config& Wind::config() const { return state_->config; }

std::size_t Wind::memory_bytes() const {
    return sizeof(State) + state_->work.memory_bytes() + state_->air.memory_bytes() + state_->diffused.bytes() + state_->motors.memory_bytes() +
           state_->forces.memory_bytes();
}

} // namespace windrow
