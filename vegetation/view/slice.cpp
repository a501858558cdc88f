#include "vegetation/view/slice.h"

#include "fluid/core/message.h"
#include "fluid/obstacle_force.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>
#include <string>

namespace windrow::vegetation::view {
namespace {

using detail::message;

/// Blue below 0, red above; nothing at 0. `value` -1 to 1.
ImU32 colour_of(float value) {
    const float amount = std::clamp(std::abs(value), 0.0f, 1.0f);
    const int alpha = static_cast<int>(200.0f * std::sqrt(amount));
    return value < 0.0f ? IM_COL32(40, 110, 255, alpha) : IM_COL32(255, 70, 40, alpha);
}

/// 1, 2 or 5 times a power of ten, at least `most`: a scale that does not flicker.
float round_up(float most) {
    if (!(most > 1e-6f))
        return 1e-6f;
    const float power = std::pow(10.0f, std::floor(std::log10(most)));
    for (const float step : {1.0f, 2.0f, 5.0f})
        if (most <= step * power)
            return step * power;
    return 10.0f * power;
}

} // namespace

Result<void> Slice::find(std::vector<float>& cells, const WindControl& control, WindReader& reader) {
    if (what_ == SliceOf::pressure) {
        if (auto found = reader.write_pressure(cells); !found)
            return found;
        for (float& cell : cells)
            cell *= k_air_density;
        return {};
    }
    const auto air = reader.view();
    if (!air)
        return air.failure();
    if (!work_ || work_->box().cells != air->box().cells) {
        auto made = Workspace::create({.box = air->box(), .ambient = air->ambient().mean(), .parallel_for = {}});
        if (!made)
            return made.failure();
        work_ = *std::move(made);
    }
    if (auto placed = work_->set_obstacles(control.obstacles().in_reach()); !placed)
        return placed;
    divergence(*work_, air->field(), cells);
    return {};
}

Result<void> Slice::look(SliceOf what, double height, double step, const WindControl& control, WindReader& reader) {
    if (what == SliceOf::nothing) {
        what_ = what;
        work_.reset();
        return {};
    }
    if (what == what_ && height == height_ && step == step_)
        return {};
    what_ = what;
    height_ = height;
    step_ = step;
    values_.clear();
    const Box& box = control.box();
    std::vector<float> cells(box.cell_count());
    if (auto found = find(cells, control, reader); !found)
        return found;
    const glm::ivec3 count = box.cells;
    const auto off = [&](int row) { return std::abs(static_cast<double>(box.centre(0, row, 0).y) - height); };
    int row = 0; // whose middle is nearest
    while (row + 1 < count.y && off(row + 1) < off(row))
        ++row;
    cells_ = {count.x, count.z};
    cell_ = static_cast<double>(box.cell_size);
    corner_ = control.origin() + glm::dvec3(0.0, static_cast<double>(box.centre(0, row, 0).y), 0.0);
    most_ = 0.0f;
    for (int z = 0; z < count.z; ++z)
        for (int x = 0; x < count.x; ++x) {
            values_.push_back(cells[box.index(x, row, z)]);
            most_ = std::max(most_, std::abs(values_.back()));
        }
    return {};
}

void Slice::draw(const Projection& projection, glm::vec2 legend) const {
    if (what_ == SliceOf::nothing || values_.empty())
        return;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const float scale = round_up(most_);
    std::vector<std::optional<glm::vec2>> corners;
    for (int z = 0; z <= cells_.y; ++z)
        for (int x = 0; x <= cells_.x; ++x)
            corners.push_back(projection.pixel(corner_ + cell_ * glm::dvec3(x, 0.0, z)));
    const auto corner = [&](int x, int z) {
        return corners[static_cast<std::size_t>(z) * static_cast<std::size_t>(cells_.x + 1) + static_cast<std::size_t>(x)];
    };
    for (int z = 0; z < cells_.y; ++z)
        for (int x = 0; x < cells_.x; ++x) {
            const ImU32 colour = colour_of(values_[static_cast<std::size_t>(z * cells_.x + x)] / scale);
            const auto a = corner(x, z), b = corner(x + 1, z), c = corner(x + 1, z + 1), d = corner(x, z + 1);
            if ((colour >> 24) < 4 || !a || !b || !c || !d)
                continue;
            list.AddQuadFilled({a->x, a->y}, {b->x, b->y}, {c->x, c->y}, {d->x, d->y}, colour);
        }
    constexpr float k_width = 200.0f, k_height = 12.0f;
    constexpr int k_parts = 40;
    list.AddRectFilled({legend.x - 8.0f, legend.y - 22.0f}, {legend.x + k_width + 8.0f, legend.y + k_height + 22.0f},
                       IM_COL32(0, 0, 0, 170), 4.0f);
    const std::string title = message(what_ == SliceOf::pressure ? "pressure, " : "divergence, ", unit(), ", at ",
                                      std::round(10.0 * height_) / 10.0, " m");
    list.AddText({legend.x, legend.y - 18.0f}, IM_COL32_WHITE, title.c_str());
    for (int n = 0; n < k_parts; ++n) {
        const float from = legend.x + k_width * static_cast<float>(n) / k_parts;
        list.AddRectFilled({from, legend.y}, {from + k_width / k_parts, legend.y + k_height},
                           colour_of(2.0f * (static_cast<float>(n) + 0.5f) / k_parts - 1.0f));
    }
    const std::string low = message(-scale), high = message(scale);
    list.AddText({legend.x, legend.y + k_height + 2.0f}, IM_COL32_WHITE, low.c_str());
    list.AddText({legend.x + 0.5f * k_width - 3.0f, legend.y + k_height + 2.0f}, IM_COL32_WHITE, "0");
    list.AddText({legend.x + k_width - ImGui::CalcTextSize(high.c_str()).x, legend.y + k_height + 2.0f}, IM_COL32_WHITE,
                 high.c_str());
}

} // namespace windrow::vegetation::view
