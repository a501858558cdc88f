#include "cli/drawing/names.h"

#include "cli/drawing/palette.h"
#include "cli/drawing/text.h"

#include <algorithm>
#include <limits>

namespace windrow::cli {
namespace {

constexpr double k_size = 13.0;
constexpr double k_height = 21.0;
constexpr double k_stripe = 4.0;
constexpr double k_pad = 7.0;
constexpr double k_widest = 190.0;
constexpr double k_distance = 7.0; // between a thing and its name
constexpr std::size_t k_most = 40; // more names than this are a texture, not information

/// Places for a plate, the best first.
std::vector<Rect> candidates(const Rect& around, double width) {
    const glm::dvec2 m = around.middle();
    const double left = around.x - k_distance - width, right = around.right() + k_distance;
    const double above = around.y - k_distance - k_height, below = around.bottom() + k_distance;
    const double level = m.y - 0.5 * k_height, centred = m.x - 0.5 * width;
    std::vector<Rect> places;
    for (const glm::dvec2 corner :
         {glm::dvec2(right, level), glm::dvec2(centred, above), glm::dvec2(centred, below), glm::dvec2(left, level),
          glm::dvec2(right, above), glm::dvec2(right, below), glm::dvec2(left, above), glm::dvec2(left, below),
          // Within it: top, bottom and its four corners.
          glm::dvec2(centred, around.y + k_distance), glm::dvec2(centred, around.bottom() - k_distance - k_height),
          glm::dvec2(around.x + k_distance, around.y + k_distance),
          glm::dvec2(around.right() - k_distance - width, around.y + k_distance),
          glm::dvec2(around.x + k_distance, around.bottom() - k_distance - k_height),
          glm::dvec2(around.right() - k_distance - width, around.bottom() - k_distance - k_height),
          // Farther off.
          glm::dvec2(right + 16.0, above - 16.0), glm::dvec2(right + 16.0, below + 16.0), glm::dvec2(left - 16.0, above - 16.0),
          glm::dvec2(left - 16.0, below + 16.0)})
        places.push_back({corner.x, corner.y, width, k_height});
    return places;
}

} // namespace

void draw_names(Canvas& canvas, const std::vector<Name>& names, const std::vector<Rect>& kept_free, const Rect& room) {
    std::vector<Rect> taken;
    for (const Name& name : names) {
        if (taken.size() >= k_most)
            break;
        const double widest = std::min(k_widest, room.width - 2.0 * k_pad - k_stripe);
        if (widest < 20.0)
            return;
        const std::string text = canvas.fitted(name.text.empty() ? "unnamed" : name.text, k_size, widest, true);
        const double text_width = canvas.width_of(text, k_size, true);
        std::string detail = name.detail.empty() ? std::string() : "  " + name.detail;
        double detail_width = canvas.width_of(detail, k_size - 1.0);
        if (text_width + detail_width > widest) {
            detail.clear();
            detail_width = 0.0;
        }
        const double width = text_width + detail_width + 2.0 * k_pad + k_stripe;

        Rect best;
        double best_cost = std::numeric_limits<double>::infinity();
        double order = 0.0;
        for (Rect place : candidates(name.around, width)) {
            const glm::dvec2 wanted(place.x, place.y);
            place.x = std::clamp(place.x, room.x, std::max(room.x, room.right() - place.width));
            place.y = std::clamp(place.y, room.y, std::max(room.y, room.bottom() - place.height));
            // A place costs its rank, being pushed back into the room, and whatever it covers.
            double cost = order + 2.0 * (std::abs(place.x - wanted.x) + std::abs(place.y - wanted.y));
            order += 3.0;
            for (const Rect& other : taken)
                cost += 100.0 * shared_area(place.grown(2.0), other);
            for (const Rect& free : kept_free)
                cost += 1.0 * shared_area(place, free);
            cost += 0.4 * shared_area(place, name.around);
            if (cost < best_cost) {
                best_cost = cost;
                best = place;
            }
        }
        const bool covers =
            std::any_of(taken.begin(), taken.end(), [&](const Rect& other) { return shared_area(best, other) > 0.0; });
        if (covers && !taken.empty())
            continue;
        taken.push_back(best);

        canvas.fill(best, k_plate, 3.0);
        canvas.fill(Rect{best.x, best.y, k_stripe, best.height}, name.colour);
        const double base = best.y + 0.5 * k_height + 0.36 * k_size;
        canvas.words(text, {best.x + k_stripe + k_pad, base}, {.size = k_size, .colour = hex(0xFFFFFF), .bold = true});
        canvas.words(detail, {best.x + k_stripe + k_pad + text_width, base}, {.size = k_size - 1.0, .colour = hex(0xC9D0DA)});
    }
}

} // namespace windrow::cli
