// Operations of a wind other than time: changes of the wind around the box, its boundary conditions, place and cells.
#include "fluid/core/wind_core.h"

#include "fluid/core/message.h"
#include "fluid/core/obstacle_record.h"
#include "fluid/solids/solids.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace windrow {
namespace {

constexpr float k_max_wind = 1e4f;
constexpr const char* k_axis_names[3] = {"x", "y", "z"};

template <class Vector>
bool finite(const Vector& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

} // namespace

namespace detail {

bool can_hold_point(const Config& config, glm::dvec3 point) {
    if (!finite(point))
        return false;
    // An invalid cell size is reported by its own check. Along y a box with rows moves by its lowest ones.
    const float lowest = config.rows ? std::min(config.rows->first, config.cell_size) : config.cell_size;
    const double across = std::max(std::abs(point.x), std::abs(point.z));
    return !(config.cell_size > 0.0f) || !(lowest > 0.0f) ||
           (across <= k_farthest_cells * static_cast<double>(config.cell_size) &&
            std::abs(point.y) <= k_farthest_cells * static_cast<double>(lowest));
}

void check_ambient(Reasons& reasons, glm::vec3 ambient) {
    if (!finite(ambient) || std::max({std::abs(ambient.x), std::abs(ambient.y), std::abs(ambient.z)}) > k_max_wind)
        reasons.add("ambient is ", ambient, " m/s: give finite numbers, at most 1e4 m/s in size.");
}

void check_follow(Reasons& reasons, const std::optional<glm::bvec3>& follow, const Boundaries& boundaries, bool rows) {
    if (rows && boundaries.periodic(1))
        reasons.add("rows cannot repeat: give boundaries along y that are not periodic, or no rows.");
    if (rows && follow && follow->y)
        reasons.add("follow_axes has y, but a box with rows keeps its height: leave it out (set_floor moves a floor).");
    for (int axis = 0; axis < 3 && follow; ++axis)
        if ((*follow)[axis] && !can_follow(boundaries, axis))
            reasons.add("follow_axes has ", k_axis_names[axis], ", where a boundary is ",
                        boundaries.periodic(axis) ? "periodic" : "solid", ": open both boundaries of that axis or leave it out",
                        axis == 1 ? " (set_floor moves a floor)." : ".");
}

void check_rows(Reasons& reasons, const Config& config) {
    if (!config.rows)
        return;
    if (config.cells.y > k_max_rows)
        reasons.add("cells has ", config.cells.y, " rows of unequal thickness: give at most ", k_max_rows, ".");
    else if (const auto table = RowTable::create(*config.rows, config.cells.y, config.cell_size);
             !table && validate(*config.rows))
        reasons.add(table.error());
}

Box box_of(const Config& config) {
    Box box{config.cells, config.cell_size, config.boundaries};
    if (config.rows)
        box.rows = *RowTable::create(*config.rows, config.cells.y, config.cell_size);
    return box;
}

} // namespace detail

WindCore::WindCore(const Config& settings, const AmbientWind& wind_around, CellStorage& cells, std::shared_ptr<const Wind> around)
    : config(settings), rows(detail::box_of(settings).rows), place(settings, rows.get()), ambient(wind_around),
      drag({config.cells, config.cell_size, config.boundaries, rows}),
      outer(std::move(around)), box_{config.cells, config.cell_size, config.boundaries, rows}, cells_(cells) {}

void WindCore::start() {
    renew_ambient();
    fill_with_ambient();
}

// --- Changes by the host -----------------------------------------------------------------------------------------------------

void WindCore::change_ambient(glm::vec3 wind) {
    if (config.gusts.intensity > 0.0f) { // gusts scale with the mean wind: the whole wind changes
        take_ambient_out();
        config.ambient = wind;
        put_ambient_in();
        return;
    }
    const glm::vec3 before = mean_wind();
    config.ambient = wind;
    renew_ambient();
    sleep.stir();
    CellChange mean = change(CellChange::Kind::add_change);
    mean.change = mean_wind() - before;
    mean.to_air = !sleep.calm();
    apply(mean);
    if (sleep.calm()) // still ambient, and to the bit
        fill_with_ambient();
}

Result<void> WindCore::set_ambient(glm::vec3 wind) {
    detail::Reasons reasons;
    detail::check_ambient(reasons, wind);
    if (outer)
        reasons.add("set_ambient of a wind with an outer wind: set that of the outermost wind, which all levels take.");
    if (!reasons.empty())
        return Error{reasons.take()};
    if (!has_room({.gusts = &config.gusts}))
        return detail::out_of_memory();
    change_ambient(wind);
    note(AmbientSet{wind});
    return {};
}

Result<void> WindCore::set_gusts(const Gusts& gusts) {
    if (outer)
        return Error{"set_gusts of a wind with an outer wind: set those of the outermost wind, which all levels take."};
    if (auto changed = change_gusts(gusts); !changed)
        return changed;
    note(GustsSet{gusts.intensity, gusts.length, gusts.tile ? gusts.tile->seed() : gusts.seed, gusts.tile != nullptr});
    return {};
}

Result<void> WindCore::change_gusts(const Gusts& gusts) {
    Gusts wanted = gusts;
    if (!wanted.tile && ambient.tile() && ambient.tile()->seed() == gusts.seed)
        wanted.tile = ambient.tile();
    auto renewed = AmbientWind::create({.mean = mean_wind(), .profile = config.profile, .gusts = wanted});
    if (!renewed)
        return renewed.failure();
    if (auto held = cells_.check(gusts); !held)
        return held;
    if (!has_room({.gusts = &gusts}))
        return detail::out_of_memory();
    renewed->set_phase(ambient.phase());
    take_ambient_out();
    config.gusts = gusts;
    ambient = *std::move(renewed);
    put_ambient_in();
    return {};
}

// One ambient wind for all levels: what the outer one has become. Without memory for its gusts, as before.
void WindCore::follow_outer_ambient() {
    Gusts gusts = outer->config().gusts;
    gusts.tile = outer->ambient_wind().tile() ? outer->ambient_wind().tile() : ambient.tile(); // its own is for detail alone
    const auto seed = [](const Gusts& of, const auto& tile) { return tile ? tile->seed() : of.seed; };
    if (gusts.intensity != config.gusts.intensity || gusts.length != config.gusts.length ||
        seed(gusts, gusts.tile) != seed(config.gusts, ambient.tile()))
        (void)change_gusts(gusts);
    if (const glm::vec3 mean = outer->ambient(); mean != config.ambient) // less what its walls close
        change_ambient(mean);
    renew_ambient(); // its walls may have closed, or opened, an axis of the gusts alone
}

Result<void> WindCore::set_boundaries(const Boundaries& boundaries) {
    detail::Reasons reasons;
    if (auto valid = validate(boundaries); !valid)
        reasons.add(valid.error());
    detail::check_follow(reasons, config.follow_axes, boundaries, config.rows.has_value());
    if (!reasons.empty())
        return Error{reasons.take()};
    if (!has_room({.gusts = &config.gusts}))
        return detail::out_of_memory();
    bool same_kinds = true;
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end)
            same_kinds = same_kinds && boundaries.at(axis, end).kind == config.boundaries.at(axis, end).kind;
    if (auto changed = cells_.set_boundaries(boundaries, !same_kinds); !changed)
        return changed;
    if (boundaries.y_low.solid() && !config.boundaries.y_low.solid())
        config.floor = window().origin().y; // the box stays where it is
    config.boundaries = box_.boundaries = boundaries;
    if (!same_kinds)
        speed.note_unknown();
    if (!same_kinds && source_name != 0)
        source_name = 2; // matches no set of sources: their flow is recomputed
    place.follow_axes = detail::axes_that_follow(config, boundaries);
    renew_ambient();
    sleep.wake();
    note(BoundariesSet{boundaries});
    return {};
}

Result<void> WindCore::follow(glm::dvec3 point) {
    if (!detail::can_hold_point(config, point))
        return Error{detail::message("follow point is ", point, " m: give finite numbers within 1e12 cells of the origin.")};
    if (!has_room({.gusts = &config.gusts}))
        return detail::out_of_memory();
    if (frames)
        frames->follow.move_to(point);
    else
        follow_now(point);
    note(Followed{point});
    return {};
}

Result<void> WindCore::set_floor(double height) {
    const Boundary& floor = config.boundaries.y_low;
    if (!floor.solid())
        return Error{"set_floor needs a solid low y side: set boundaries.y_low to free_slip or no_slip, or use follow."};
    if (!k_world_range.holds(height) || !detail::can_hold_point(config, {0.0, height, 0.0}))
        return Error{
            detail::message("floor height is ", height, " m: give a finite number within 1e12 m and 1e12 cells of the origin.")};
    if (!has_room({.gusts = &config.gusts}))
        return detail::out_of_memory();
    CellIndex origin = place.window.origin_cells;
    origin.y = detail::floor_row(place.window, height);
    shift_to(origin);
    place.point.y = height + 0.5 * place.window.size().y;
    config.floor = height;
    note(FloorSet{height});
    return {};
}

Result<void> WindCore::shift_origin(glm::dvec3 offset) {
    const glm::dvec3 units = window().units(), whole = glm::round(offset / units), nearest = whole * units;
    // By the units of a position 10^6 cells away: a host's own sums are no better.
    if (!glm::all(glm::lessThanEqual(glm::abs(offset - nearest), 1e-6 * units + 1e-12 * glm::abs(offset))))
        return Error{detail::message("shift_origin got (", offset.x, ", ", offset.y, ", ", offset.z,
                                     ") m: give whole cells, such as ", glm::vec3(nearest), " m.")};
    const OriginShift shift{.cells = CellIndex(whole), .offset = nearest};
    const auto stays = [&](glm::dvec3 at) { return detail::in_range(at + nearest, k_world_range.max); };
    bool all = detail::can_hold_point(config, place.point + nearest) && stays({0.0, config.floor, 0.0});
    for (const Motors::Slot& slot : motors.slots())
        all = all && (!slot.used || stays(position_of(slot.motor)));
    for (const Obstacles::Slot& slot : obstacles.slots())
        all = all && (!slot.used || stays(slot.obstacle.position));
    for (const DragField::Slot& slot : drag.slots())
        all = all && (!slot.used || stays(position_of(slot.deposit)));
    if (!all)
        return Error{detail::message("shift_origin by ", offset,
                                     " m moves the box, a motor, an obstacle or a deposit out of 1e12 m: give less.")};
    place.shift_origin(shift);
    shift.move(config.centre);
    config.floor += nearest.y;
    if (config.roughness && config.roughness->map)
        shift.move(config.roughness->map->position);
    shift.move(ambient);
    motors.shift_origin(nearest);
    obstacles.shift_origin(nearest, shift.cells);
    drag.shift_origin(nearest);
    if (frames)
        frames->shift_origin(shift);
    cells_.shift_origin(shift);
    note(OriginShifted{nearest});
    return {};
}

Result<void> WindCore::set_velocity(const std::function<glm::vec3(glm::dvec3)>& velocity_at) {
    std::vector<glm::vec4> own;
    // Not the air's own cells: the function may read the wind, or throw.
    std::span<glm::vec4> cells = cells_.spare();
    if (cells.empty()) {
        if (!detail::memory_lasts([&] { own.resize(box().cell_count()); }))
            return detail::out_of_memory();
        cells = own;
    }
    const glm::ivec3 count = box().cells;
    for (int k = 0; k < count.z; ++k)
        for (int j = 0; j < count.y; ++j)
            for (int i = 0; i < count.x; ++i)
                cells[box().index(i, j, k)] = glm::vec4(velocity_at(window().centre(i, j, k)), 0.0f);
    return set_velocity(cells);
}

Result<void> WindCore::set_velocity(std::span<const glm::vec4> field) {
    if (field.size() != box().cell_count())
        return Error{detail::message("set_velocity got ", field.size(), " cells, but the box has ", box().cell_count(),
                                     ": give box().cell_count().")};
    if (!has_room({.set = true}))
        return detail::out_of_memory();
    CellChange set = change(CellChange::Kind::set);
    set.cells = field;
    apply(set);
    sleep.wake();
    if (frames)
        frames->before_still = false;
    if (log != nullptr)
        log->note_velocity(field);
    return {};
}

void WindCore::reset() {
    fill_with_ambient();
    if (frames)
        apply(CellChange::Kind::fill_before);
    cells_.show_air();
    note(WindReset{});
}

void WindCore::record_to(EventLog* to) {
    log = to;
    motors.record_to(to);
    obstacles.record_to(to);
    drag.record_to(to);
}

// --- Reading -----------------------------------------------------------------------------------------------------------------

namespace detail {

Result<void> check_room(const char* call, std::size_t values, const Box& box) {
    if (values == box.cell_count())
        return {};
    return Error{message(call, " got room for ", values, " cells, but the box has ", box.cell_count(),
                         ": give one array of box().cell_count().")};
}

} // namespace detail

Result<void> WindCore::write_obstacles(std::span<float> cells, const Window& in) const {
    if (auto fits = detail::check_room("write_obstacles", cells.size(), box()); !fits)
        return fits;
    return detail::where_memory_lasts([&]() -> Result<void> {
        std::fill(cells.begin(), cells.end(), 0.0f);
        const auto standing = obstacles.standing_in(in, config.boundaries);
        if (standing.empty())
            return {};
        Solids found(box(), box().cells.x);
        found.place(standing);
        for (const Solids::InsideCell& cell : found.inside())
            cells[cell.cell] = 1.0f;
        return {};
    });
}

BlendZone WindCore::blend_zone(glm::dvec3 point) const {
    return place.blend_zone(point, config.blend_width,
                            frames ? 2.0f : 1.0f); // between ticks, the point is up to a tick behind the box
}

ShownFrame WindCore::shown() const {
    return frames ? frames->shown : ShownFrame{place.window, place.point, ambient, sleep.asleep()};
}

WindowBlock WindCore::window_block(glm::dvec3 anchor, const WindView& view, const WindView& previous_view) const {
    anchor = detail::usable_anchor(anchor);
    WindowBlock block = view.block(anchor);
    if (frames) {
        const WindowBlock before = previous_view.block(anchor);
        block.factor = static_cast<float>(frames->clock.factor(config.ticks));
        block.previous_origin = before.origin;
        block.previous_blend_centre = before.blend_centre;
    } else {
        block.previous_origin = glm::vec3(place.window.origin_at(place.previous.origin_cells) - anchor);
        block.previous_blend_centre = glm::vec3(place.previous.point - anchor);
    }
    return block;
}

FrameBlock WindCore::frame_block(glm::dvec3 anchor, const Sampling& sampling, const WindView& view,
                                 const WindView& previous_view) const {
    return windrow::frame_block(window_block(anchor, view, previous_view), view.ambient().block(anchor, sampling),
                                previous_view.ambient().block(anchor, sampling), rows.get());
}

} // namespace windrow
