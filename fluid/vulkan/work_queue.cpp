#include "fluid/vulkan/work_queue.h"

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
    case Kind::add_change:
        if (last.to_air != work.to_air || last.window.origin_cells != work.window.origin_cells)
            return false;
        last.change += work.change;
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

void WorkQueue::push(Work work) {
    if (fold(work))
        return;
    // Nothing is left of what was asked for before all of the air is set anew.
    if (work.kind == Kind::fill && !work.kept)
        works_.clear();
    else if (work.kind == Kind::fill_before && !works_.empty() && works_.back().kind == Kind::fill)
        works_.erase(works_.begin(), works_.end() - 1);
    else if (work.kind == Kind::set) // what moved or ended the sources' flow stays: cells that are set keep it
        while (!works_.empty() && (works_.back().kind == Kind::set || works_.back().kind == Kind::add_change ||
                                   works_.back().kind == Kind::add_wind))
            works_.pop_back();
    works_.push_back(std::move(work));
}

void WorkQueue::record(Air& air, VkCommandBuffer commands) {
    for (const Work& work : works_)
        work.record(air, commands);
    works_.clear();
}

} // namespace windrow::vulkan
