#include "fluid/vulkan/work_queue.h"

#include "fluid/vulkan/air.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace windrow::vulkan {
namespace {

using Kind = CellChange::Kind;

// Both shifts keep the cells between them in the box: a shift there and back loses the cells that left it.
bool same_way(CellIndex a, CellIndex b) {
    for (int axis = 0; axis < 3; ++axis)
        if ((a[axis] < 0 && b[axis] > 0) || (a[axis] > 0 && b[axis] < 0))
            return false;
    return true;
}

// True where the change alters the kept cells.
bool changes_before(const CellChange& change) {
    return change.kind == Kind::fill_before || change.kind == Kind::set || (change.kind != Kind::fill && change.kept);
}

bool same_change(const CellChange& a, const CellChange& b) {
    // The change depends on its profile over the ground, where there is one.
    const bool same_height = (a.window.origin_cells.y == b.window.origin_cells.y && a.ambient.ground() == b.ambient.ground()) ||
                             (a.ambient.uniform() && b.ambient.uniform());
    return a.kind == Kind::add_change && b.kind == Kind::add_change && a.kept == b.kept && a.to_air == b.to_air && same_height;
}

// The change may be made before `earlier` too.
bool passes(const CellChange& change, const CellChange& earlier) {
    if (!change.to_air)
        return earlier.kind == Kind::fill;
    return earlier.kind == Kind::shift && earlier.kept == change.kept && earlier.by.y == 0 && earlier.exposed_hold_ambient &&
           earlier.ambient.ground() == change.ambient.ground() && change.ambient.mean() - earlier.ambient.mean() == change.change;
}

} // namespace

// True where the last change now covers this one.
bool WorkQueue::fold(const CellChange& change) {
    if (changes_.empty())
        return false;
    CellChange& last = changes_.back();
    if (last.kind != change.kind || last.kept != change.kept)
        return false;
    switch (change.kind) {
    case Kind::shift: // over level ground: a floor that moves takes the wind with it
        if (last.by.y != 0 || change.by.y != 0 || !same_way(last.by, change.by) ||
            last.exposed_hold_ambient != change.exposed_hold_ambient || last.ambient.mean() != change.ambient.mean())
            return false;
        last.by += change.by;
        last.has_source_flow = last.has_source_flow || change.has_source_flow;
        break;
    case Kind::add_wind: // a ramp of gusts: out with what just came in
        if (last.factor + change.factor != 0.0f || last.window.origin_cells != change.window.origin_cells ||
            !same_wind(last.ambient, change.ambient))
            return false;
        changes_.pop_back();
        return true;
    default:
        return false;
    }
    last.ambient = change.ambient;
    last.window = change.window;
    return true;
}

// A change of the mean wind may move before a shift that exposes the changed wind, and before a fill if it only affects kept
// cells. It moves there and merges with an earlier change: a walk in a turning wind stays one change and one shift.
void WorkQueue::add_change(const CellChange& change) {
    auto at = changes_.end();
    while (at != changes_.begin() && passes(change, *std::prev(at)))
        --at;
    for (auto shift = at; shift != changes_.end(); ++shift)
        if (shift->kind == Kind::shift)
            shift->ambient = change.ambient;
    if (at == changes_.begin() || !same_change(*std::prev(at), change)) {
        changes_.insert(at, change);
        return;
    }
    CellChange& before = *std::prev(at);
    before.change += change.change;
    before.ambient = change.ambient;
    before.window = change.window;
}

void WorkQueue::append(const CellChange& change) {
    if (change.kind == Kind::add_change)
        add_change(change);
    else if (!fold(change))
        changes_.push_back(change);
}

// Keeps only the changes that are still visible after `change`.
void WorkQueue::drop_overwritten(const CellChange& change) {
    const auto of_before_alone = [](const CellChange& w) {
        return w.kind == Kind::fill_before || (w.kind == Kind::add_change && !w.to_air);
    };
    switch (change.kind) {
    case Kind::fill: // all of the air and of the sources' flow
        std::erase_if(changes_, [&](const CellChange& w) { return !change.kept || !changes_before(w); });
        for (CellChange& left : changes_)
            left.to_air = left.has_source_flow = false;
        return;
    case Kind::fill_before: // what is kept; what came before a fill is gone from both then
        while (std::any_of(changes_.begin() + (changes_.empty() ? 0 : 1), changes_.end(),
                           [](const CellChange& w) { return w.kind == Kind::fill; }))
            changes_.erase(changes_.begin());
        std::erase_if(changes_, of_before_alone);
        return;
    case Kind::set: // both, but not what moved or ended the sources' flow: cells that are set keep it
        std::erase_if(changes_,
                      [](const CellChange& w) { return w.kind != Kind::fill && !(w.kind == Kind::shift && w.has_source_flow); });
        for (CellChange& left : changes_) {
            left.ambient = change.ambient;
            left.window = change.window;
        }
        return;
    default:
        return;
    }
}

void WorkQueue::make_room(std::size_t cells) {
    constexpr std::size_t k_max_a_call = 8; // out with the wind, a change, a shift, in with it, what is kept
    const std::size_t most = changes_.size() + k_max_a_call;
    if (changes_.capacity() < most)
        changes_.reserve(2 * most);
    left_.reserve(changes_.capacity());
    cells_.resize(std::max(cells, cells_.size()));
}

void WorkQueue::push(CellChange change) {
    if (change.kind == Kind::set) { // the waiting change is overwritten
        std::transform(change.cells.begin(), change.cells.end(), cells_.begin(),
                       [](glm::vec4 u) { return glm::vec4(u.x, u.y, u.z, 0.0f); });
        change.cells = cells_;
    }
    if (change.kind == Kind::fill || change.kind == Kind::fill_before || change.kind == Kind::set) {
        drop_overwritten(change);
        changes_.swap(left_);
        for (const CellChange& left : left_) // neighbours now, which may merge
            append(left);
        left_.clear();
    }
    append(change);
}

void WorkQueue::record(Air& air, VkCommandBuffer commands) {
    for (const CellChange& change : changes_)
        air.apply(commands, change);
    clear();
}

void WorkQueue::clear() {
    changes_.clear();
    cells_ = {};
}

void WorkQueue::shift_origin(const OriginShift& shift) {
    for (CellChange& change : changes_) {
        shift.move(change.window);
        shift.move(change.ambient);
    }
}

} // namespace windrow::vulkan
