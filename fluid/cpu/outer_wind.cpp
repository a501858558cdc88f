#include "fluid/cpu/outer_wind.h"

#include "fluid/core/numerics.h"
#include "fluid/core/wind_core.h"
#include "fluid/cpu/cells.h"
#include "fluid/grid/box_rules.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <utility>

namespace windrow::cpu {

/// The outer wind that is shown now.
class AirOfNow {
  public:
    explicit AirOfNow(Cells& outer) : outer_(outer), view_(outer.shown_view(false)), ambient_(outer.shown_ambient()) {}

    [[nodiscard]] const WindView& view() const { return view_; }
    [[nodiscard]] float pressure(std::size_t cell) const { return outer_.shown_pressure(cell); }
    /// [m/s] A at places, as it is part of the cells. `scratch`: as many.
    void ambient(std::span<const glm::dvec3> places, std::span<glm::vec3> winds, std::span<glm::vec3> scratch) const {
        ambient_.now.velocity(places, winds);
        if (ambient_.factor == 1.0f)
            return;
        ambient_.before.velocity(places, scratch);
        for (std::size_t n = 0; n < places.size(); ++n)
            winds[n] = scratch[n] + ambient_.factor * (winds[n] - scratch[n]);
    }
    template <class Visit>
    void for_each_filled(const Visit& visit) const {
        outer_.for_each_filled(visit);
    }

  private:
    Cells& outer_;
    WindView view_;
    Cells::ShownAmbient ambient_;
};

namespace {

// Cells of a line that is blended along x, on the stack.
constexpr int k_longest_line = 2 * k_max_axis_cells;
constexpr float k_no_wind = 1e6f; // [m/s] a hundred times what an ambient wind may be

// A cell in one register.
typedef float Four __attribute__((vector_size(16)));
typedef float FourUnaligned __attribute__((vector_size(16), aligned(4), may_alias));

inline Four four(const float* cell) {
    return *reinterpret_cast<const FourUnaligned*>(cell);
}
inline Four four(const glm::vec4& cell) {
    return four(&cell.x);
}
inline void put_four(Four value, glm::vec4& cell) {
    *reinterpret_cast<FourUnaligned*>(&cell.x) = value;
}
inline Four blend_four(Four a, Four b, float t) {
    return a + t * (b - a);
}

int around_period(int index, int count) {
    if (index >= 0 && index < count)
        return index;
    const int rest = index % count;
    return rest < 0 ? rest + count : rest;
}

} // namespace

OuterWind::OuterWind(const Box& box, Cells& outer) : OuterWind(box, outer, {&now_, &from_, &to_, &carried_, &traced_}) {
    outer.keep_pressure();
}

// `fields`: beside end_, which alone a level further out samples.
OuterWind::OuterWind(const Box& box, Cells& outer, std::initializer_list<Buffer<glm::vec4>*> fields) : box_(box), outer_(outer) {
    const glm::ivec3 padded = box.cells + k_halo;
    const auto cells =
        static_cast<std::size_t>(padded.x) * static_cast<std::size_t>(padded.y) * static_cast<std::size_t>(padded.z);
    end_ = Buffer<glm::vec4>(cells);
    for (Buffer<glm::vec4>* const field : fields)
        *field = Buffer<glm::vec4>(cells);
    if (Cells* const around = outer.outer_cells())
        further_.reset(new OuterWind(box, *around, {}));
    // As much of the outer box as may lie around this one: a step does not allocate.
    const Box& around = outer.box();
    std::size_t most = 1;
    for (int axis = 0; axis < 3; ++axis) {
        places_[static_cast<std::size_t>(axis)].resize(static_cast<std::size_t>(padded[axis]));
        const double ratio = static_cast<double>(box.cell_size) / static_cast<double>(around.cell_size);
        const auto spanned = static_cast<int>(std::min(std::ceil(padded[axis] * ratio), 1.0 * k_longest_line)) + 3;
        const int count = (around.rows || box.rows) && axis == 1 ? around.cells.y : spanned;
        most *= static_cast<std::size_t>(around.boundaries.periodic(axis) ? count : std::min(count, around.cells[axis]));
        if (axis == 0) {
            points_.reserve(static_cast<std::size_t>(count));
            winds_.reserve(static_cast<std::size_t>(count));
            winds_before_.reserve(static_cast<std::size_t>(count));
        }
    }
    brick_.reserve(most);
}

std::size_t OuterWind::memory_bytes() const {
    std::size_t bytes = brick_.capacity() * sizeof(glm::vec4) + points_.capacity() * sizeof(glm::dvec3) +
                        (winds_.capacity() + winds_before_.capacity()) * sizeof(glm::vec3);
    for (const Buffer<glm::vec4>* field : {&now_, &end_, &from_, &to_, &carried_, &traced_})
        bytes += field->bytes();
    for (const std::vector<Place>& places : places_)
        bytes += places.capacity() * sizeof(Place);
    return bytes + (further_ ? further_->memory_bytes() : 0);
}

// --- Reading the outer wind --------------------------------------------------------------------------------------------------

// The share along an axis is that of the outer view's own sampling (kernels/box_points.inl).
void OuterWind::place(const Window& window, const AirOfNow& air) {
    const Box& box = air.view().box();
    const Window outer = air.view().window();
    const BlendZone zone = air.view().blend_zone();
    for (int axis = 0; axis < 3; ++axis) {
        const int count = box.cells[axis];
        const bool periodic = box.boundaries.periodic(axis);
        const auto is_open = [&](int end) { return box.boundaries.at(axis, end).kind == BoundaryKind::open; };
        int lowest = k_longest_line, highest = -k_longest_line;
        std::vector<Place>& places = places_[static_cast<std::size_t>(axis)];
        // Of a periodic axis, the period that the box begins in.
        const glm::dvec3 first = window.centre(-k_halo_low, -k_halo_low, -k_halo_low);
        const double periods = periodic ? count * std::floor(outer.local(first)[axis] / count) : 0.0;
        for (std::size_t n = 0; n < places.size(); ++n) {
            const int cell = static_cast<int>(n) - k_halo_low;
            const glm::dvec3 centre = window.centre(cell, cell, cell);
            const double local = outer.local(centre)[axis] - periods;
            const double sample = periodic ? local - 0.5 : std::clamp(local, 0.5, count - 0.5) - 0.5;
            Place& at = places[n];
            at.low = static_cast<int>(std::floor(sample));
            if (!periodic)
                at.low = std::clamp(at.low, 0, std::max(0, count - 2));
            at.between = count > 1 ? static_cast<float>(sample - at.low) : 0.0f;
            at.share = numerics::windrow_edge_share(is_open(0) ? static_cast<float>(1.0 + local) : 1.0f,
                                                    is_open(1) ? static_cast<float>(1.0 + count - local) : 1.0f, 0.0f);
            if (zone.reach[axis] > 0.0f) {
                const auto from_point =
                    static_cast<float>((centre[axis] - zone.point[axis]) / static_cast<double>(box.cell_size));
                at.share *= numerics::windrow_edge_share((zone.reach[axis] + from_point) / zone.width,
                                                         (zone.reach[axis] - from_point) / zone.width, 1.0f);
            }
            lowest = std::min(lowest, at.low);
            highest = std::max(highest, at.low + (count > 1 ? 1 : 0));
        }
        brick_low_[axis] = lowest;
        brick_cells_[axis] = highest - lowest + 1;
    }
}

// D and p at the outer cells around the box; beside bodies the air as it is read there (fluid/solids/reading.h).
void OuterWind::fill_brick(const AirOfNow& air) {
    const WindView& view = air.view();
    const Box& box = view.box();
    const AmbientWind& ambient = view.ambient();
    const std::span<const glm::vec4> field = view.field();
    const glm::ivec3 size = brick_cells_;
    brick_.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * static_cast<std::size_t>(size.z));
    points_.resize(static_cast<std::size_t>(size.x));
    winds_.resize(points_.size());
    winds_before_.resize(points_.size());
    const auto outer_cell = [&](int axis, int n) { return around_period(brick_low_[axis] + n, box.cells[axis]); };
    const auto ambient_of = [&](int j, int k) {
        const glm::dvec3 first = view.window().centre(outer_cell(0, 0), outer_cell(1, j), outer_cell(2, k));
        if (!ambient.gusting()) {
            std::fill(winds_.begin(), winds_.end(), ambient.profile_at(first.y) * ambient.mean());
            return;
        }
        for (int i = 0; i < size.x; ++i)
            points_[static_cast<std::size_t>(i)] = view.window().centre(outer_cell(0, i), outer_cell(1, j), outer_cell(2, k));
        air.ambient(points_, winds_, winds_before_);
    };
    std::size_t at = 0;
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j) {
            ambient_of(j, k);
            for (int i = 0; i < size.x; ++i, ++at) {
                const std::size_t n = box.index(outer_cell(0, i), outer_cell(1, j), outer_cell(2, k));
                brick_[at] = glm::vec4(glm::vec3(field[n]) - winds_[static_cast<std::size_t>(i)], air.pressure(n));
            }
        }
    const auto fill = [&](std::uint32_t cell, glm::vec3 filled) {
        const auto n = static_cast<int>(cell);
        const glm::ivec3 place(n % box.cells.x, n / box.cells.x % box.cells.y, n / (box.cells.x * box.cells.y));
        glm::ivec3 in_brick = place - brick_low_;
        for (int axis = 0; axis < 3; ++axis)
            if (box.boundaries.periodic(axis))
                in_brick[axis] = around_period(in_brick[axis], box.cells[axis]);
        if (glm::any(glm::lessThan(in_brick, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(in_brick, size)))
            return;
        const glm::vec3 change = filled - glm::vec3(field[cell]);
        brick_[(static_cast<std::size_t>(in_brick.z) * static_cast<std::size_t>(size.y) + static_cast<std::size_t>(in_brick.y)) *
                   static_cast<std::size_t>(size.x) +
               static_cast<std::size_t>(in_brick.x)] += glm::vec4(change, 0.0f);
    };
    air.for_each_filled(std::ref(fill)); // no copy: a step does not allocate
    // What is not finite or too fast stays out: the outer wind's next step repairs or limits it.
    for (glm::vec4& at_cell : brick_)
        if (!(std::abs(at_cell.x) + std::abs(at_cell.y) + std::abs(at_cell.z) < k_no_wind &&
              std::abs(at_cell.w) < k_no_wind * k_no_wind))
            at_cell = glm::vec4(0.0f);
}

void OuterWind::sample(const Window& window, Buffer<glm::vec4>& to, const ParallelFor& parallel_for) {
    const bool asleep = outer_.asleep(); // D is below its sleep speed
    if (asleep)
        std::fill_n(to.data(), to.size(), glm::vec4(0.0f));
    if (asleep && !further_)
        return;
    const AirOfNow air(outer_);
    place(window, air);
    if (!asleep)
        blend(air, to, parallel_for);
    if (further_ && reaches_beyond())
        add_further(window, to, parallel_for);
}

bool OuterWind::reaches_beyond() const {
    return std::any_of(places_.begin(), places_.end(), [](const std::vector<Place>& along) {
        return std::any_of(along.begin(), along.end(), [](const Place& at) { return at.share < 1.0f; });
    });
}

// Where the outer box ends, the level around it.
void OuterWind::add_further(const Window& window, Buffer<glm::vec4>& to, const ParallelFor& parallel_for) {
    further_->sample(window, further_->end_, parallel_for);
    std::size_t n = 0;
    for (const Place& z : places_[2])
        for (const Place& y : places_[1])
            for (const Place& x : places_[0]) {
                to[n] += (1.0f - x.share * y.share * z.share) * further_->end_[n];
                ++n;
            }
}

void OuterWind::blend(const AirOfNow& air, Buffer<glm::vec4>& to, const ParallelFor& parallel_for) {
    fill_brick(air);
    const std::size_t width = places_[0].size(), height = places_[1].size();
    const std::ptrdiff_t row = brick_cells_.x, plane = row * brick_cells_.y;
    const std::ptrdiff_t up = brick_cells_.y > 1 ? row : 0, deep = brick_cells_.z > 1 ? plane : 0, along = row > 1 ? 1 : 0;
    parallel_for(static_cast<int>(places_[2].size()), [&](int padded) {
        const Place& z = places_[2][static_cast<std::size_t>(padded)];
        std::array<Four, k_longest_line> line;
        for (std::size_t j = 0; j < height; ++j) {
            const Place& y = places_[1][j];
            const glm::vec4* const corner = brick_.data() + (z.low - brick_low_.z) * plane + (y.low - brick_low_.y) * row;
            for (std::ptrdiff_t i = 0; i < row; ++i) {
                const Four near = blend_four(four(corner[i]), four(corner[i + up]), y.between);
                const Four far = blend_four(four(corner[i + deep]), four(corner[i + deep + up]), y.between);
                line[static_cast<std::size_t>(i)] = blend_four(near, far, z.between);
            }
            glm::vec4* const result = to.data() + (static_cast<std::size_t>(padded) * height + j) * width;
            const float share = y.share * z.share;
            for (std::size_t i = 0; i < width; ++i) {
                const Place& x = places_[0][i];
                const Four* const first = line.data() + (x.low - brick_low_.x);
                put_four((share * x.share) * blend_four(first[0], first[along], x.between), result[i]);
            }
        }
    });
}

// --- In time -----------------------------------------------------------------------------------------------------------------

void OuterWind::renew(const Window& window, const ParallelFor& parallel_for) {
    sample(window, now_, parallel_for);
    origin_ = window.origin_cells;
    holds_ = true;
    start_ = next_ = &now_;
}

void OuterWind::move_to(const Window& window, const ParallelFor& parallel_for) {
    if (holds(window))
        return;
    const CellIndex by = window.origin_cells - origin_;
    const glm::ivec3 padded = box_.cells + k_halo;
    if (!holds_ || (box_.rows && by.y != 0) || glm::any(glm::greaterThanEqual(glm::abs(by), CellIndex(padded))))
        return renew(window, parallel_for);
    // Cells that come take the outer wind of now: the time in which the others lag behind is at most a step.
    sample(window, end_, parallel_for);
    std::copy_n(now_.data(), now_.size(), from_.data());
    const glm::ivec3 shift(by);
    std::size_t n = 0;
    for (int k = 0; k < padded.z; ++k)
        for (int j = 0; j < padded.y; ++j)
            for (int i = 0; i < padded.x; ++i, ++n) {
                const glm::ivec3 source = glm::ivec3(i, j, k) + shift;
                const bool stays =
                    glm::all(glm::greaterThanEqual(source, glm::ivec3(0))) && glm::all(glm::lessThan(source, padded));
                now_[n] = stays ? from_[(static_cast<std::size_t>(source.z) * static_cast<std::size_t>(padded.y) +
                                         static_cast<std::size_t>(source.y)) *
                                            static_cast<std::size_t>(padded.x) +
                                        static_cast<std::size_t>(source.x)]
                                : end_[n];
            }
    origin_ = window.origin_cells;
}

void OuterWind::begin_step(const Window& window, float way, const ParallelFor& parallel_for) {
    move_to(window, parallel_for);
    sample(window, end_, parallel_for);
    if (way < 1.0f)
        for (std::size_t n = 0; n < end_.size(); ++n)
            end_[n] = numerics::windrow_outer_between(now_[n], end_[n], way);
}

void OuterWind::begin_part(int part, int parts, const ParallelFor& parallel_for) {
    start_ = part == 0 ? &now_ : &from_;
    next_ = part + 1 == parts ? &end_ : &to_;
    if (parts == 1)
        return;
    const auto between = [&](Buffer<glm::vec4>& field, int at) {
        const float way = static_cast<float>(at) / static_cast<float>(parts);
        const std::size_t plane = field.size() / places_[2].size();
        parallel_for(static_cast<int>(places_[2].size()), [&](int k) {
            const std::size_t first = plane * static_cast<std::size_t>(k);
            for (std::size_t n = first; n < first + plane; ++n)
                field[n] = numerics::windrow_outer_between(now_[n], end_[n], way);
        });
    };
    if (start_ == &from_)
        between(from_, part);
    if (next_ == &to_)
        between(to_, part + 1);
}

void OuterWind::end_step() {
    std::swap(now_, end_);
    start_ = next_ = &now_;
}

void OuterWind::restore(std::span<const float> values, CellIndex origin) {
    std::copy(values.begin(), values.end(), &now_.data()->x);
    origin_ = origin;
    holds_ = true;
    start_ = next_ = &now_;
}

glm::vec4 OuterWind::at(int i, int j, int k) const {
    glm::vec4 change = (*start_)[padded_index(box_.cells, {i, j, k})];
    change.w = 0.0f;
    return change;
}

float OuterWind::pressure_at(int i, int j, int k) const {
    return now_[padded_index(box_.cells, {i, j, k})].w;
}

// --- What a sub-step reads ---------------------------------------------------------------------------------------------------

float OuterWind::height(int row) const {
    return box_.rows ? static_cast<float>(box_.rows->height(row)) : box_.cell_size * static_cast<float>(row);
}

// [m/s^2] dp over an axis at a cell of the box or its halo, one-sided where the halo ends.
float OuterWind::slope(const Buffer<glm::vec4>& of, glm::ivec3 at, int axis) const {
    glm::ivec3 low = at, high = at;
    low[axis] = std::max(at[axis] - 1, -k_halo_low);
    high[axis] = std::min(at[axis] + 1, box_.cells[axis] + k_halo_high - 1);
    const float distance =
        axis == 1 ? height(high.y) - height(low.y) : box_.cell_size * static_cast<float>(high[axis] - low[axis]);
    return numerics::windrow_outer_slope(of[padded_index(box_.cells, low)].w, of[padded_index(box_.cells, high)].w, distance);
}

void OuterWind::compose(const Around& around, const ParallelFor& parallel_for) {
    factor_ = numerics::windrow_outer_factor(around.dt, !around.fresh);
    const float departs = numerics::windrow_outer_departs(around.dt, !around.fresh);
    const Buffer<glm::vec4>&start = *start_, &next = *next_;
    const glm::ivec3 cells = box_.cells, padded = cells + k_halo;
    constexpr Four k_no_pressure = {1.0f, 1.0f, 1.0f, 0.0f};
    const auto everywhere = [](const Ambient& ambient) {
        return Four{ambient.everywhere.x, ambient.everywhere.y, ambient.everywhere.z, 0.0f};
    };
    const Four carried_mean = everywhere(around.carried), traced_mean = everywhere(around.traced);
    const auto wind_of = [](const Ambient& ambient, Four mean, std::size_t n) {
        return ambient.cells == nullptr ? mean : four(ambient.cells + 4 * n);
    };
    parallel_for(padded.z, [&](int plane) {
        for (int row = 0; row < padded.y; ++row) {
            const int j = row - k_halo_low, k = plane - k_halo_low;
            const bool inside = j >= 0 && j < cells.y && k >= 0 && k < cells.z;
            const std::size_t first = padded_index(cells, {-k_halo_low, j, k});
            // One-sided where the halo ends, as slope().
            const std::ptrdiff_t pitch = padded.x, slab = pitch * padded.y;
            const std::ptrdiff_t below = row > 0 ? pitch : 0, above = row + 1 < padded.y ? pitch : 0;
            const std::ptrdiff_t before = plane > 0 ? slab : 0, behind = plane + 1 < padded.z ? slab : 0;
            const float up = height(above > 0 ? j + 1 : j) - height(below > 0 ? j - 1 : j);
            const float per_y = departs / up, per_x = departs / box_.cell_size;
            const float per_z = before > 0 && behind > 0 ? 0.5f * per_x : per_x;
            const auto halo = [&](int low, int high) {
                for (int column = low; column < high; ++column) {
                    const std::size_t n = first + static_cast<std::size_t>(column);
                    const glm::vec4* const p = start.data() + n;
                    const std::ptrdiff_t left = column > 0 ? 1 : 0, right = column + 1 < padded.x ? 1 : 0;
                    const float per = left + right == 2 ? 0.5f * per_x : per_x;
                    const Four push{per * (p[right].w - p[-left].w), per_y * (p[above].w - p[-below].w),
                                    per_z * (p[behind].w - p[-before].w), 0.0f};
                    put_four(wind_of(around.carried, carried_mean, n) + k_no_pressure * four(*p) - push, carried_[n]);
                    put_four(wind_of(around.traced, traced_mean, n) + k_no_pressure * four(next[n]), traced_[n]);
                }
            };
            if (!inside) {
                halo(0, padded.x);
                continue;
            }
            halo(0, k_halo_low);
            halo(k_halo_low + cells.x, padded.x);
            for (std::size_t n = first + k_halo_low; around.relaxes && n < first + k_halo_low + cells.x; ++n)
                put_four(wind_of(around.carried, carried_mean, n) + k_no_pressure * four(start[n]), carried_[n]);
        }
    });
}

float OuterWind::Sides::potential(glm::ivec3 cell, int axis, int end) const {
    cell[axis] += end == 0 ? -1 : 1;
    return numerics::windrow_outer_potential((*outer_.next_)[padded_index(outer_.box_.cells, cell)].w, outer_.factor_,
                                             outer_.box_.cell_size);
}

float OuterWind::Sides::rise(glm::ivec3 cell, int axis, int end) const {
    glm::ivec3 ghost = cell;
    ghost[axis] += end == 0 ? -1 : 1;
    const Buffer<glm::vec4>& next = *outer_.next_;
    const auto wind = [&](glm::ivec3 at) {
        return numerics::windrow_outer_pushed(next[padded_index(outer_.box_.cells, at)][axis], outer_.factor_,
                                              outer_.slope(next, at, axis));
    };
    return wind(ghost) - wind(cell);
}

} // namespace windrow::cpu
