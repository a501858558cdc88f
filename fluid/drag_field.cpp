#include "fluid/drag_field.h"

#include "fluid/core/message.h"
#include "fluid/core/validation.h"
#include "fluid/event_log.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vector_relational.hpp>

namespace windrow {

using detail::CellRange, detail::DragSum;

// --- Deposits ----------------------------------------------------------------------------------------------------------------

Result<void> validate(const DragDeposit& deposit) {
    return std::visit([](const auto& kind) { return detail::validate_settings(kind, kind.k_name); }, deposit);
}

glm::dvec3 position_of(const DragDeposit& deposit) {
    const auto* const belt = std::get_if<BeltDrag>(&deposit);
    return belt != nullptr ? belt->start : std::get<PlantDrag>(deposit).position;
}

void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const PlantDrag& plant) {
    if (plant.base >= plant.height)
        reasons.add(detail::FieldPath{&path, "base"}, " is ", plant.base, " m and height ", plant.height,
                    " m: give a base below the height.");
}

void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const BeltDrag& belt) {
    const double length = glm::length(glm::dvec2(belt.end.x - belt.start.x, belt.end.z - belt.start.z));
    if (!(length >= 1e-3 && length <= 1e4))
        reasons.add(detail::FieldPath{&path, "end"}, " is ", length, " m from `start` along x and z: give 0.001 to 10000 m.");
}

void DragChange::add(const CellRange& range) {
    if (range.empty() || whole)
        return;
    if (count < static_cast<int>(ranges.size()))
        ranges[static_cast<std::size_t>(count++)] = range;
    else
        whole = true;
}

// --- The list ----------------------------------------------------------------------------------------------------------------

DragField::DragField(const Box& box)
    : box_(box), list_({"deposit", "removed, or never added"}, k_capacity), grid_(2.0 * static_cast<double>(box.cell_size)) {}

void DragField::make_room(std::size_t more) {
    list_.make_room(more);
    grid_.reserve(list_.capacity());
    drag_.resize(box_.cell_count());
    runs_.resize(static_cast<std::size_t>(box_.cells.y) * static_cast<std::size_t>(box_.cells.z));
    sums_.resize(box_.cell_count());
}

DragId DragField::put(const DragDeposit& deposit) {
    const DragId id = list_.add();
    list_[id.slot].deposit = deposit;
    link(id.slot);
    apply(deposit, false);
    if (log_ != nullptr)
        log_->note(DragAdded{id.unowned(), deposit});
    return id;
}

Result<DragId> DragField::add(const DragDeposit& deposit) {
    DragId id;
    if (auto added = add(std::span(&deposit, 1), std::span(&id, 1)); !added)
        return added.failure();
    return id;
}

Result<void> DragField::add(std::span<const DragDeposit> deposits, std::span<DragId> ids) {
    if (!ids.empty() && ids.size() != deposits.size())
        return Error{detail::message("add got room for ", ids.size(), " handles of ", deposits.size(),
                                     " deposits: give as many, or none.")};
    for (std::size_t n = 0; n < deposits.size(); ++n)
        if (auto valid = validate(deposits[n]); !valid)
            return deposits.size() == 1 ? valid.failure() : valid.failure().after(detail::message("deposit ", n, ": "));
    if (auto room = list_.check_room(deposits.size()); !room)
        return room;
    if (!detail::memory_lasts([&] { make_room(deposits.size()); }))
        return detail::out_of_memory();
    for (std::size_t n = 0; n < deposits.size(); ++n) {
        const DragId id = put(deposits[n]);
        if (!ids.empty())
            ids[n] = id;
    }
    return {};
}

Result<void> DragField::set(DragId id, const DragDeposit& deposit) {
    const auto found = list_.find(id);
    if (!found)
        return found.failure();
    if (auto valid = validate(deposit); !valid)
        return valid;
    apply((*found)->deposit, true);
    grid_.erase(id.slot);
    (*found)->deposit = deposit;
    link(id.slot);
    apply(deposit, false);
    if (log_ != nullptr)
        log_->note(DragSet{id.unowned(), deposit});
    return {};
}

Result<void> DragField::remove(DragId id) {
    const auto found = list_.find(id);
    if (!found)
        return found.failure();
    apply((*found)->deposit, true);
    grid_.erase(id.slot);
    list_.release(id.slot);
    if (log_ != nullptr)
        log_->note(DragRemoved{id.unowned()});
    return {};
}

Result<void> DragField::check(DragId id) const {
    const auto found = list_.find(id);
    return found ? Result<void>() : found.failure();
}

const DragDeposit* DragField::find(DragId id) const {
    const auto found = list_.find(id);
    return found ? &(*found)->deposit : nullptr;
}

void DragField::link(std::uint32_t index) {
    const detail::DragSquare square = detail::square_around(list_[index].deposit, box_.cell_size);
    grid_.insert(index, {square.centre.x, 0.0, square.centre.z}, square.half);
}

// Of a list that came from elsewhere; its room is made.
void DragField::link_all() {
    grid_ = detail::ObstacleGrid(2.0 * static_cast<double>(box_.cell_size));
    grid_.reserve(list_.capacity());
    for (std::uint32_t index = 0; index < list_.size(); ++index)
        if (list_[index].used)
            link(index);
    filled_ = false;
}

void DragField::shift_origin(glm::dvec3 offset) {
    for (std::uint32_t index = 0; index < list_.size(); ++index) {
        if (!list_[index].used)
            continue;
        grid_.erase(index);
        if (auto* const plant = std::get_if<PlantDrag>(&list_[index].deposit))
            plant->position += offset;
        else if (auto* const belt = std::get_if<BeltDrag>(&list_[index].deposit)) {
            belt->start += offset;
            belt->end += offset;
        }
        link(index);
    }
    filled_ = false; // as a wind that is loaded there finds them, to the bit
}

std::size_t DragField::memory_bytes() const {
    return list_.memory_bytes() + grid_.memory_bytes() + sums_.capacity() * sizeof(DragSum) + drag_.capacity() * sizeof(float) +
           runs_.capacity() * sizeof(DragCells::Run);
}

// --- The cells ---------------------------------------------------------------------------------------------------------------

void DragField::apply(const DragDeposit& deposit, bool out) {
    if (filled_)
        edited_.add(detail::add_drag(deposit, lattice_, {glm::ivec3(0), box_.cells}, out, sums_));
}

DragCells DragField::cells_in(const Window& window, const Boundaries& boundaries) {
    if (sums_.empty() || (list_.count() == 0 && !any_ && edited_.empty())) {
        filled_ = false;
        return {};
    }
    const glm::bvec3 repeats(boundaries.periodic(0), boundaries.periodic(1), boundaries.periodic(2));
    const CellIndex by = window.origin_cells - lattice_.window.origin_cells;
    const bool within = glm::all(glm::lessThan(glm::abs(by), CellIndex(box_.cells))) && (box_.rows == nullptr || by.y == 0);
    const CellRange all{glm::ivec3(0), box_.cells};
    if (!filled_ || !within || repeats != lattice_.repeats) {
        lattice_ = {window, repeats};
        std::fill(sums_.begin(), sums_.end(), DragSum{0});
        fill(all);
        convert(all);
        change_ = {.whole = true};
        filled_ = true;
    } else {
        convert(edited_);
        change_.add(edited_);
        lattice_.window = window;
        if (by != CellIndex(0))
            move(glm::ivec3(by));
    }
    edited_ = {};
    any_ = std::any_of(runs_.begin(), runs_.end(), [](DragCells::Run run) { return run.low < run.high; });
    return any_ ? DragCells{drag_, runs_} : DragCells{};
}

// Adds all deposits to the cells of a range, which have none.
void DragField::fill(const CellRange& range) {
    const auto add = [&](std::uint32_t index) {
        if (list_[index].used)
            (void)detail::add_drag(list_[index].deposit, lattice_, range, false, sums_);
    };
    if (glm::any(lattice_.repeats)) {
        for (std::uint32_t index = 0; index < list_.size(); ++index)
            add(index);
        return;
    }
    const glm::dvec3 low = lattice_.window.origin();
    const auto h = static_cast<double>(box_.cell_size);
    grid_.find({low.x + h * range.low.x, 0.0, low.z + h * range.low.z}, {low.x + h * range.high.x, 0.0, low.z + h * range.high.z},
               add);
}

// The box has moved by less than its size: cells that stay keep their sums, slabs of new ones are filled.
void DragField::move(glm::ivec3 by) {
    const glm::ivec3 cells = box_.cells;
    const auto row_at = [&](int j, int k) { return (static_cast<std::ptrdiff_t>(k) * cells.y + j) * cells.x; };
    const glm::ivec3 low = glm::max(-by, glm::ivec3(0)), high = glm::min(cells - by, cells); // of cells that stay
    const auto in_order = [](int first, int end, int way, const auto& use) {
        for (int n = 0; n < end - first; ++n)
            use(way >= 0 ? first + n : end - 1 - n);
    };
    in_order(low.z, high.z, by.z, [&](int k) {
        in_order(low.y, high.y, by.y, [&](int j) {
            const auto count = static_cast<std::size_t>(high.x - low.x);
            const std::ptrdiff_t to = row_at(j, k) + low.x, from = row_at(j + by.y, k + by.z) + low.x + by.x;
            std::memmove(sums_.data() + to, sums_.data() + from, count * sizeof(DragSum));
            std::memmove(drag_.data() + to, drag_.data() + from, count * sizeof(float));
        });
    });
    for (int n = 0; n < change_.count; ++n) {
        CellRange& range = change_.ranges[static_cast<std::size_t>(n)];
        range = {glm::clamp(range.low - by, glm::ivec3(0), cells), glm::clamp(range.high - by, glm::ivec3(0), cells)};
    }
    CellRange left{glm::ivec3(0), cells};
    for (int axis = 0; axis < 3; ++axis) {
        CellRange slab = left;
        if (by[axis] > 0)
            left.high[axis] = slab.low[axis] = cells[axis] - by[axis];
        else if (by[axis] < 0)
            left.low[axis] = slab.high[axis] = -by[axis];
        else
            continue;
        for (int k = slab.low.z; k < slab.high.z; ++k)
            for (int j = slab.low.y; j < slab.high.y; ++j)
                std::fill_n(sums_.begin() + row_at(j, k) + slab.low.x, slab.high.x - slab.low.x, DragSum{0});
        fill(slab);
        convert(slab);
        change_.add(slab);
    }
    convert({glm::ivec3(0), glm::ivec3(0, cells.y, cells.z)}); // the runs of all rows
}

// Floats of a range, and the runs of its rows.
void DragField::convert(const CellRange& range) {
    const glm::ivec3 cells = box_.cells;
    for (int k = range.low.z; k < range.high.z; ++k)
        for (int j = range.low.y; j < range.high.y; ++j) {
            const std::size_t row = static_cast<std::size_t>(k) * static_cast<std::size_t>(cells.y) + static_cast<std::size_t>(j);
            const std::size_t first = row * static_cast<std::size_t>(cells.x);
            float* const drag = drag_.data() + first;
            for (int i = range.low.x; i < range.high.x; ++i)
                drag[i] =
                    static_cast<float>(static_cast<double>(sums_[first + static_cast<std::size_t>(i)]) * detail::k_drag_unit);
            int low = 0, high = cells.x;
            while (low < high && !(drag[low] > 0.0f))
                ++low;
            while (low < high && !(drag[high - 1] > 0.0f))
                --high;
            runs_[row] = {static_cast<std::uint16_t>(low), static_cast<std::uint16_t>(high)};
        }
}

Result<DragForce> DragField::force_on(DragId id, const Window& window, const Boundaries& boundaries,
                                      std::span<const glm::vec4> velocity) const {
    const auto found = list_.find(id);
    if (!found)
        return found.failure();
    const glm::bvec3 repeats(boundaries.periodic(0), boundaries.periodic(1), boundaries.periodic(2));
    return detail::drag_force((*found)->deposit, {window, repeats}, velocity);
}

} // namespace windrow
