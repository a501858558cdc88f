#include "cli/drawing/world_map.h"

#include "cli/drawing/axes.h"
#include "cli/drawing/motor_style.h"
#include "cli/drawing/outline.h"
#include "cli/drawing/palette.h"
#include "cli/drawing/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

namespace windrow::cli {

void draw_world_map(Canvas& canvas, const Rect& place, const Air& air, std::span<const Trail> trails,
                    std::span<const NamedMotor> motors) {
    const glm::dvec2 corner(air.origin.x, air.origin.z), extent(air.extent().x, air.extent().z);
    glm::dvec2 low = corner, high = corner + extent;
    for (const Trail& trail : trails) {
        // Half a box, and a cell for the rounding to whole cells.
        const glm::dvec2 around = trail.followed ? 0.5 * extent + static_cast<double>(air.box.cell_size) : glm::dvec2(0.0);
        for (const glm::dvec3& point : trail.points) {
            const glm::dvec2 at(point.x, point.z);
            if (!std::isfinite(at.x) || !std::isfinite(at.y))
                continue;
            low = glm::min(low, at - around);
            high = glm::max(high, at + around);
        }
    }
    const glm::dvec2 middle = 0.5 * (low + high), size = high - low;
    const double scale = std::min(place.width / size.x, place.height / size.y);
    const glm::dvec2 centre(place.x + 0.5 * size.x * scale, place.y + 0.5 * size.y * scale);
    const auto to_page = [&](glm::dvec2 world) { return centre + (world - middle) * scale; };

    const Rect land{centre.x - 0.5 * size.x * scale, centre.y - 0.5 * size.y * scale, size.x * scale, size.y * scale};
    canvas.fill(land, hex(0xEFEEE8));
    canvas.clip(land);
    for (const Trail& trail : trails) {
        std::vector<glm::dvec2> points;
        for (const glm::dvec3& point : trail.points) {
            const glm::dvec2 at = to_page({point.x, point.z});
            if (points.empty() || !(std::abs(at.x - points.back().x) + std::abs(at.y - points.back().y) < 0.5))
                points.push_back(at);
        }
        for (const auto& run : cut(points, land))
            canvas.stroke(run, {.colour = trail.followed ? k_ink : k_body, .width = trail.followed ? 1.4 : 1.1});
    }
    const glm::dvec2 from = to_page(corner), to = to_page(corner + extent);
    canvas.unclip();
    const Rect box{from.x, from.y, to.x - from.x, to.y - from.y};
    canvas.fill(box, hex(0x2B5C9E, 0.16));
    canvas.stroke(box, {.colour = hex(0x2B5C9E), .width = 1.6});
    const double dot = motors.size() > 40 ? 1.6 : 2.6;
    for (const NamedMotor& motor : motors) {
        const glm::dvec3 position = position_of(motor.motor);
        const glm::dvec2 at = to_page({position.x, position.z});
        if (land.contains(at))
            canvas.fill_circle(at, dot, style_of(motor.motor).colour);
    }
    for (const Trail& trail : trails) {
        const glm::dvec2 at = to_page({trail.now.x, trail.now.z});
        if (!land.contains(at))
            continue;
        canvas.fill_circle(at, 3.6, k_paper);
        canvas.fill_circle(at, 2.6, trail.followed ? k_ink : k_body);
    }
    canvas.stroke(land, {.colour = k_hairline, .width = 1.0});
}

} // namespace windrow::cli
