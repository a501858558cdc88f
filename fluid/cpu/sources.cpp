#include "fluid/cpu/sources.h"

#include "fluid/box.h"
#include "fluid/core/numerics.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace windrow::cpu {

using detail::MotorReach;

namespace {

// Effect of a motor at a point: its weight, and the direction and size of its push there.
struct Contribution {
    float weight;
    glm::vec3 push;
};

// Weights of a motor along a row of x, written to weights[0] for the first place and on. Shape and law are constants of the loop,
// which has no branches then, so that a compiler vectorises it.
template <std::uint32_t Shape, std::uint32_t Law = numerics::windrow_drive>
void weigh_row(const MotorReach& motor, glm::vec3 row, float cell_size, float* weights) {
    const glm::vec3 centre = motor.centre, extent = motor.extent;
    const float radius = motor.radius, end_radius = motor.end_radius;
    const int low = motor.low.x, high = motor.high.x;
    for (int i = low; i < high; ++i) {
        const glm::vec3 p(row.x + cell_size * static_cast<float>(i), row.y, row.z);
        weights[i - low] = numerics::windrow_motor_weight(Shape, Law, p, centre, extent, radius, end_radius);
    }
}

constexpr void (*k_weigh_row[])(const MotorReach&, glm::vec3, float, float*) = {
    weigh_row<0>, weigh_row<1>, weigh_row<2>, weigh_row<3>, weigh_row<4>, weigh_row<5>, weigh_row<6>}; // by shape

// [m] Where a row of cells is, and how thick.
struct RowPlace {
    glm::vec3 centre; ///< of its first cell
    float low, thickness;
};

RowPlace row_at(const Box& box, int j, int k) {
    RowPlace row{.centre = box.centre(0, j, k), .low = 0.0f, .thickness = 0.0f};
    if (box.rows) {
        row.low = static_cast<float>(box.rows->face(j));
        row.thickness = static_cast<float>(box.rows->thickness(j));
    }
    return row;
}

// push(p, weight) of a motor with its eddies.
template <class Visit>
void with_push(const MotorReach& motor, const numerics::TileView& tile, const Visit& visit) {
    const auto shape = static_cast<std::uint32_t>(motor.shape);
    const auto with_eddies = [&](const auto& steady) {
        visit([&](glm::vec3 p, float weight) {
            glm::vec3 push = steady(p);
            if (motor.eddies > 0.0f)
                push += numerics::windrow_motor_eddies(shape, weight, motor.eddies) *
                        numerics::windrow_tile_at(tile, glm::ivec3(0), motor.tile_place + motor.texels * p);
            return push;
        });
    };
    const glm::vec3 centre = motor.centre, extent = motor.extent, given = motor.push;
    const float radius = motor.radius, end_radius = motor.end_radius, lift = motor.lift;
    if (shape == numerics::windrow_jet || shape == numerics::windrow_vortex)
        with_eddies([&](glm::vec3 p) {
            return numerics::windrow_motor_push(shape, p - centre, given, extent, radius, end_radius, lift);
        });
    else
        with_eddies([&](glm::vec3) { return given; });
}

// Calls visit(i, contribution) for the cells of one row that the motor reaches.
template <class Visit>
void for_each_cell(const MotorReach& motor, const RowPlace& place, float cell_size, const numerics::TileView& tile,
                   const Visit& visit) {
    const glm::vec3 row = place.centre;
    const auto shape = static_cast<std::uint32_t>(motor.shape), law = static_cast<std::uint32_t>(motor.law);
    const int heights =
        numerics::windrow_motor_heights(shape, motor.extent, motor.radius, motor.end_radius, place.thickness, cell_size);
    if (heights > 1) {
        with_push(motor, tile, [&](const auto& push) {
            for (int i = motor.low.x; i < motor.high.x; ++i) {
                Contribution sum{0.0f, glm::vec3(0.0f)};
                for (int k = 0; k < heights; ++k) {
                    const float part = (static_cast<float>(k) + 0.5f) / static_cast<float>(heights);
                    const glm::vec3 p(row.x + cell_size * static_cast<float>(i), place.low + place.thickness * part, row.z);
                    const float weight =
                        numerics::windrow_motor_weight(shape, law, p, motor.centre, motor.extent, motor.radius, motor.end_radius);
                    if (!(weight > 0.0f))
                        continue;
                    sum.weight += weight;
                    sum.push += weight * push(p, weight);
                }
                if (sum.weight > 0.0f)
                    visit(i, Contribution{sum.weight / static_cast<float>(heights), sum.push / sum.weight});
            }
        });
        return;
    }
    std::array<float, k_max_axis_cells> weights;
    const bool axial = shape == numerics::windrow_vortex && motor.law == MotorReach::Law::force;
    (axial ? weigh_row<numerics::windrow_vortex, numerics::windrow_force> : k_weigh_row[shape])(motor, row, cell_size,
                                                                                                weights.data());
    with_push(motor, tile, [&](const auto& push) {
        for (int i = motor.low.x; i < motor.high.x; ++i)
            if (const float weight = weights[i - motor.low.x]; weight > 0.0f)
                visit(i, Contribution{weight, push(glm::vec3(row.x + cell_size * static_cast<float>(i), row.y, row.z), weight)});
    });
}

// Zeroes low <= i < high of a row, and any gap between that range and `cleared`, the range zeroed before.
void clear(glm::vec4* row, int low, int high, int (&cleared)[2]) {
    if (cleared[0] >= cleared[1])
        cleared[0] = cleared[1] = low;
    std::fill(row + std::min(low, cleared[0]), row + cleared[0], glm::vec4(0.0f));
    std::fill(row + cleared[1], row + std::max(high, cleared[1]), glm::vec4(0.0f));
    cleared[0] = std::min(low, cleared[0]);
    cleared[1] = std::max(high, cleared[1]);
}

float largest_component(const glm::vec4& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

} // namespace

SourceField::SourceField(glm::ivec3 cells)
    : cells_(cells), force_(static_cast<std::size_t>(cells.x) * cells.y * cells.z),
      row_holds_force_(static_cast<std::size_t>(cells.y) * cells.z), drives_(force_.size()), kept_(force_.size()),
      row_driven_(row_holds_force_.size()), plane_largest_(static_cast<std::size_t>(cells.z)),
      plane_largest_driven_(plane_largest_.size()), expansion_(force_.size()) {}

std::size_t SourceField::memory_bytes() const {
    return force_.bytes() + row_holds_force_.bytes() + drives_.bytes() + kept_.bytes() + row_driven_.bytes() +
           plane_largest_.bytes() + plane_largest_driven_.bytes() + expansion_.bytes();
}

std::span<const float> SourceField::expansion() const {
    return any_expansion_ ? std::span<const float>(expansion_) : std::span<const float>();
}

std::span<float> SourceField::expansion() {
    return any_expansion_ ? std::span<float>(expansion_) : std::span<float>();
}

void SourceField::add_force_to(std::span<glm::vec4> velocity, float factor, const ParallelFor& parallel_for) const {
    if (!any_force_)
        return;
    parallel_for(cells_.z, [&](int k) {
        for (int j = 0; j < cells_.y; ++j) {
            const std::size_t row = static_cast<std::size_t>(k) * cells_.y + j;
            if (row_holds_force_[row] == 0)
                continue;
            for (std::size_t n = row * cells_.x; n < (row + 1) * cells_.x; ++n)
                velocity[n] += factor * force_[n];
        }
    });
}

void SourceField::drive(std::span<glm::vec4> velocity, const ParallelFor& parallel_for) const {
    if (!any_drive_)
        return;
    parallel_for(cells_.z, [&](int k) {
        for (int j = 0; j < cells_.y; ++j) {
            const std::size_t row = static_cast<std::size_t>(k) * cells_.y + j;
            for (std::size_t n = row * cells_.x + row_driven_[row].low; n < row * cells_.x + row_driven_[row].high; ++n)
                velocity[n] = glm::vec4(numerics::windrow_driven(glm::vec3(velocity[n]), drives_[n], drives_[n].w), 0.0f);
        }
    });
}

void SourceField::limit_drives(float most) {
    for (std::size_t row = 0; any_drive_ && row < row_driven_.size(); ++row)
        for (std::size_t n = row * cells_.x + row_driven_[row].low; n < row * cells_.x + row_driven_[row].high; ++n) {
            glm::vec4& drive = drives_[n];
            const float largest = std::max({std::abs(drive.x), std::abs(drive.y), std::abs(drive.z)});
            if (largest > most * drive.w)
                drive = glm::vec4(most * drive.w / largest * glm::vec3(drive), drive.w);
        }
}

void SourceField::leave_out(std::size_t row, std::size_t cell) {
    if (any_force_ && row_holds_force_[row] != 0)
        force_[cell] = glm::vec4(0.0f);
    const std::size_t i = cell - row * cells_.x;
    if (any_drive_ && i >= row_driven_[row].low && i < row_driven_[row].high)
        drives_[cell] = glm::vec4(0.0f);
    if (any_expansion_)
        expansion_[cell] = 0.0f;
}

void SourceField::gather(std::span<const MotorReach> motors, const Box& box, std::span<const glm::vec4> velocity,
                         const numerics::TileView& tile, const ParallelFor& parallel_for,
                         std::span<const Solids::InsideCell> inside) {
    const auto any = [&](MotorReach::Law law) {
        return std::any_of(motors.begin(), motors.end(), [&](const MotorReach& m) { return m.law == law; });
    };
    any_force_ = any(MotorReach::Law::force);
    any_drive_ = any(MotorReach::Law::drive);
    any_expansion_ = any(MotorReach::Law::source);
    largest_force_ = largest_driven_ = 0.0f;
    if (motors.empty())
        return;
    parallel_for(cells_.z, [&](int plane) { gather_plane(motors, box, velocity, tile, inside, plane); });
    for (int k = 0; k < cells_.z; ++k) {
        largest_force_ = std::max(largest_force_, plane_largest_[k]);
        largest_driven_ = std::max(largest_driven_, plane_largest_driven_[k]);
    }
}

void SourceField::gather_plane(std::span<const MotorReach> motors, const Box& box, std::span<const glm::vec4> velocity,
                               const numerics::TileView& tile, std::span<const Solids::InsideCell> inside, int k) {
    // Hundreds of motors reach a box, a few of them a plane. Motors beyond this capacity are searched again in every row, which
    // is only slower.
    std::array<std::uint16_t, 512> near;
    std::size_t near_count = 0;
    bool listed = true;
    for (std::size_t n = 0; n < motors.size() && listed; ++n)
        if (motors[n].low.z <= k && k < motors[n].high.z) {
            listed = near_count < near.size() && n <= 0xffff;
            if (listed)
                near[near_count++] = static_cast<std::uint16_t>(n);
        }
    const std::size_t candidates = listed ? near_count : motors.size();

    const auto first_inside = [&](std::size_t cell) {
        return std::lower_bound(inside.begin(), inside.end(), cell,
                                [](const Solids::InsideCell& one, std::size_t n) { return one.cell < n; });
    };
    const float cell_size = box.cell_size;
    auto next_inside = first_inside(static_cast<std::size_t>(k) * cells_.y * cells_.x);
    plane_largest_[k] = plane_largest_driven_[k] = 0.0f;
    for (int j = 0; j < cells_.y; ++j) {
        const std::size_t row = static_cast<std::size_t>(k) * cells_.y + j;
        glm::vec4* const force_row = force_.data() + row * cells_.x;
        glm::vec4* const drives = drives_.data() + row * cells_.x;
        float* const expansion_row = expansion_.data() + row * cells_.x;
        const RowPlace place = row_at(box, j, k);
        bool holds_force = false;
        int cleared[2] = {cells_.x, 0};
        int drive_low = cells_.x, drive_high = 0;
        if (any_expansion_)
            std::fill_n(expansion_row, cells_.x, 0.0f);
        for (std::size_t n = 0; n < candidates; ++n) {
            const MotorReach& motor = motors[listed ? near[n] : n];
            if (k < motor.low.z || k >= motor.high.z || j < motor.low.y || j >= motor.high.y)
                continue;
            switch (motor.law) {
            case MotorReach::Law::force:
                if (!holds_force)
                    std::fill_n(force_row, cells_.x, glm::vec4(0.0f));
                holds_force = true;
                for_each_cell(motor, place, cell_size, tile,
                              [&](int i, const Contribution& at) { force_row[i] += glm::vec4(at.weight * at.push, 0.0f); });
                break;
            case MotorReach::Law::drive:
                clear(drives, motor.low.x, motor.high.x, cleared);
                for_each_cell(motor, place, cell_size, tile, [&](int i, const Contribution& at) {
                    drive_low = std::min(drive_low, i);
                    drive_high = std::max(drive_high, i + 1);
                    const float exponent = at.weight * motor.amount;
                    drives[i] += glm::vec4(exponent * at.push, exponent);
                });
                break;
            case MotorReach::Law::source:
                for_each_cell(motor, place, cell_size, tile,
                              [&](int i, const Contribution& at) { expansion_row[i] += at.weight * motor.amount; });
                break;
            }
        }
        row_holds_force_[row] = holds_force ? 1 : 0;
        row_driven_[row] = {};
        if (drive_low < drive_high)
            row_driven_[row] = {static_cast<std::uint16_t>(drive_low), static_cast<std::uint16_t>(drive_high)};
        for (; next_inside != inside.end() && next_inside->cell < (row + 1) * cells_.x; ++next_inside)
            leave_out(row, next_inside->cell);
        for (int i = 0; holds_force && i < cells_.x; ++i)
            plane_largest_[k] = std::max(plane_largest_[k], largest_component(force_row[i]));
        for (int i = drive_low; i < drive_high; ++i) {
            // The driven velocity is between u and U: the exponential is only needed where one of them is a new maximum.
            const glm::vec4& u = velocity[row * cells_.x + i];
            const float most = std::max(largest_component(u) * drives[i].w, largest_component(drives[i]));
            if (!(most > plane_largest_driven_[k] * drives[i].w))
                continue;
            const glm::vec3 driven = numerics::windrow_driven(glm::vec3(u), drives[i], drives[i].w);
            if (const float largest = largest_component(glm::vec4(driven, 0.0f)); std::isfinite(largest)) // else it is repaired
                plane_largest_driven_[k] = std::max(plane_largest_driven_[k], largest);
        }
    }
}

void FreeAir::make_room(const Box& box) {
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t size = box.cell_count() / static_cast<std::size_t>(box.cells[axis]);
        for (int end = 0; end < 2; ++end)
            if (Buffer<float>& side = ghosts_[axis][end];
                box.boundaries.at(axis, end).kind == BoundaryKind::open && side.size() != size)
                side = Buffer<float>(size);
    }
}

void FreeAir::gather(std::span<const MotorReach> motors, const Box& box, std::span<const float> open_parts,
                     const ParallelFor& parallel_for) {
    cells_ = box.cells;
    const float h = box.cell_size;
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end) {
            if (box.boundaries.at(axis, end).kind != BoundaryKind::open)
                continue;
            const int along = axis == 0 ? 1 : 0, across = axis == 2 ? 1 : 2, count = cells_[along];
            Buffer<float>& side = ghosts_[axis][end];
            parallel_for(cells_[across], [&](int row) {
                float* const values = side.data() + static_cast<std::size_t>(row) * count;
                std::fill_n(values, count, 0.0f);
                glm::ivec3 first(0);
                first[axis] = end == 0 ? -1 : cells_[axis];
                first[across] = row;
                glm::vec3 p = box.centre(first.x, first.y, first.z);
                p[along] = 0.0f;
                std::size_t source = 0;
                for (const MotorReach& motor : motors) {
                    if (motor.law != MotorReach::Law::source)
                        continue;
                    const float part = open_parts.empty() ? 1.0f : open_parts[source++];
                    const float over_radius = 1.0f / motor.radius,
                                strength = part * motor.push.x * over_radius / (12.5663706f * h);
                    for (int image = 0; image < 8; ++image) {
                        glm::vec3 from = p - motor.extent;
                        bool stands = true;
                        for (int turned = 0; turned < 3; ++turned) {
                            if ((image >> turned & 1) == 0)
                                continue;
                            stands = stands && box.boundaries.has_solid(turned);
                            const float wall = box.boundaries.at(turned, 1).solid() ? box.size()[turned] : 0.0f;
                            from[turned] = p[turned] - (2.0f * wall - motor.extent[turned]);
                        }
                        if (!stands)
                            continue;
                        const float off = from[axis] * from[axis] + from[across] * from[across], start = from[along];
                        const bool by_rows = along == 1 && box.rows;
                        for (int i = 0; i < count; ++i) {
                            const float way = start + (by_rows ? box.rows->centres()[static_cast<std::size_t>(i)]
                                                               : h * (static_cast<float>(i) + 0.5f));
                            const float squared = (off + way * way) * over_radius * over_radius;
                            values[i] += strength * numerics::windrow_source_potential(squared);
                        }
                    }
                }
            });
        }
}

std::size_t FreeAir::memory_bytes() const {
    std::size_t bytes = 0;
    for (const auto& axis : ghosts_)
        for (const Buffer<float>& side : axis)
            bytes += side.bytes();
    return bytes;
}

} // namespace windrow::cpu
