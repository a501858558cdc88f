#include "fluid/vulkan/work_queue.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace windrow::vulkan {
namespace {

using Kind = Work::Kind;

bool same_wind(const AmbientWind& a, const AmbientWind& b) {
    return a.mean() == b.mean() && a.phase() == b.phase() && a.ground() == b.ground() && a.gust_axes() == b.gust_axes() &&
           a.settings().gusts.intensity == b.settings().gusts.intensity && a.period() == b.period() && a.tile() == b.tile();
}

// Both leave what lies between them in the box: a shift there and back loses what left it.
bool same_way(CellIndex a, CellIndex b) {
    for (int axis = 0; axis < 3; ++axis)
        if ((a[axis] < 0 && b[axis] > 0) || (a[axis] > 0 && b[axis] < 0))
            return false;
    return true;
}

// What the host keeps of the air is not the same after it.
bool changes_before(const Work& work) {
    return work.kind == Kind::fill_before || work.kind == Kind::set || (work.kind != Kind::fill && work.kept);
}

bool same_change(const Work& a, const Work& b) {
    // The change goes by its profile over the ground, where there is one.
    const bool same_height = (a.window.origin_cells.y == b.window.origin_cells.y && a.ambient.ground() == b.ambient.ground()) ||
                             (a.ambient.uniform() && b.ambient.uniform());
    return a.kind == Kind::add_change && b.kind == Kind::add_change && a.kept == b.kept && a.to_air == b.to_air && same_height;
}

// The change may be made before `earlier` too.
bool passes(const Work& change, const Work& earlier) {
    if (!change.to_air)
        return earlier.kind == Kind::fill;
    return earlier.kind == Kind::shift && earlier.kept == change.kept && earlier.move.by.y == 0 &&
           earlier.move.exposed_hold_ambient && earlier.ambient.ground() == change.ambient.ground() &&
           change.ambient.mean() - earlier.ambient.mean() == change.change;
}

} // namespace

void Work::record(Air& air, VkCommandBuffer commands) const {
    switch (kind) {
    case Kind::fill:
        return air.fill(commands, ambient, window);
    case Kind::fill_before:
        return air.fill_before(commands, ambient, window);
    case Kind::shift:
        return air.shift(commands, move, ambient, window);
    case Kind::add_change:
        return air.add_change(commands, change, to_air, kept, ambient, window);
    case Kind::add_wind:
        return air.add_wind(commands, factor, kept, ambient, window);
    case Kind::set:
        return air.upload(commands, cells);
    }
}

// True where the last work now does what this one asks too.
bool WorkQueue::fold(const Work& work) {
    if (works_.empty())
        return false;
    Work& last = works_.back();
    if (last.kind != work.kind || last.kept != work.kept)
        return false;
    switch (work.kind) {
    case Kind::shift: // over level ground: a floor that moves takes the wind with it
        if (last.move.by.y != 0 || work.move.by.y != 0 || !same_way(last.move.by, work.move.by) ||
            last.move.exposed_hold_ambient != work.move.exposed_hold_ambient || last.ambient.mean() != work.ambient.mean())
            return false;
        last.move.by += work.move.by;
        last.move.lets_air_in = last.move.lets_air_in || work.move.lets_air_in;
        break;
    case Kind::add_wind: // a ramp of gusts: out with what just came in
        if (last.factor + work.factor != 0.0f || last.window.origin_cells != work.window.origin_cells ||
            !same_wind(last.ambient, work.ambient))
            return false;
        works_.pop_back();
        return true;
    default:
        return false;
    }
    last.ambient = work.ambient;
    last.window = work.window;
    return true;
}

// A change of the mean wind acts as well before a shift that exposes the changed wind, and before a fill where it is only of what
// is kept. So it goes there, and into the change that it meets: a walk in a wind that turns stays one change and one shift.
void WorkQueue::add_change(Work change) {
    auto at = works_.end();
    while (at != works_.begin() && passes(change, *std::prev(at)))
        --at;
    for (auto shift = at; shift != works_.end(); ++shift)
        if (shift->kind == Kind::shift)
            shift->ambient = change.ambient;
    if (at == works_.begin() || !same_change(*std::prev(at), change)) {
        works_.insert(at, std::move(change));
        return;
    }
    Work& before = *std::prev(at);
    before.change += change.change;
    before.ambient = change.ambient;
    before.window = change.window;
}

void WorkQueue::append(Work work) {
    if (work.kind == Kind::add_change)
        add_change(std::move(work));
    else if (!fold(work))
        works_.push_back(std::move(work));
}

// Leaves of the works what can still be seen after `work`.
void WorkQueue::drop_overwritten(const Work& work) {
    const auto of_before_alone = [](const Work& w) {
        return w.kind == Kind::fill_before || (w.kind == Kind::add_change && !w.to_air);
    };
    switch (work.kind) {
    case Kind::fill: // all of the air and of the sources' flow
        std::erase_if(works_, [&](const Work& w) { return !work.kept || !changes_before(w); });
        for (Work& left : works_)
            left.to_air = left.move.lets_air_in = false;
        return;
    case Kind::fill_before: // what is kept; what came before a fill is gone from both then
        while (std::any_of(works_.begin() + (works_.empty() ? 0 : 1), works_.end(),
                           [](const Work& w) { return w.kind == Kind::fill; }))
            works_.erase(works_.begin());
        std::erase_if(works_, of_before_alone);
        return;
    case Kind::set: // both, but not what moved or ended the sources' flow: cells that are set keep it
        std::erase_if(works_,
                      [](const Work& w) { return w.kind != Kind::fill && !(w.kind == Kind::shift && w.move.lets_air_in); });
        for (Work& left : works_) {
            left.ambient = work.ambient;
            left.window = work.window;
        }
        return;
    default:
        return;
    }
}

void WorkQueue::make_room() {
    constexpr std::size_t k_most_a_call = 8; // out with the wind, a change, a shift, in with it, what is kept
    const std::size_t most = works_.size() + k_most_a_call;
    if (works_.capacity() < most)
        works_.reserve(2 * most);
    left_.reserve(works_.capacity());
}

void WorkQueue::push(Work work) {
    if (work.kind == Kind::fill || work.kind == Kind::fill_before || work.kind == Kind::set) {
        drop_overwritten(work);
        works_.swap(left_);
        for (Work& left : left_) // neighbours now, that may fold
            append(std::move(left));
        left_.clear();
    }
    append(std::move(work));
}

void WorkQueue::record(Air& air, VkCommandBuffer commands) {
    for (const Work& work : works_)
        work.record(air, commands);
    works_.clear();
}

} // namespace windrow::vulkan
