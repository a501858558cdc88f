// Where a label goes beside its point: of some places around it the one that covers least of what is drawn already.
#pragma once

#include "cli/pareto/plot.h"

#include <span>
#include <vector>

namespace windrow::cli {

class LabelPlaces {
  public:
    /// Labels stay within `room`.
    explicit LabelPlaces(const Rect& room) : room_(room) {}

    /// Something that a label should not cover; the more it matters, the larger its weight.
    void avoid(const Rect& thing, double weight) { things_.push_back({thing, weight}); }

    struct Place {
        glm::dvec2 at{0.0}; ///< base line
        Align align = Align::left;
        bool far = false;     ///< so far from its point that a line should lead there
        glm::dvec2 near{0.0}; ///< where that line ends
    };
    /// The place of a text beside a point; it is avoided from then on.
    [[nodiscard]] Place find(std::string_view text, double size, glm::dvec2 point);

  private:
    struct Thing {
        Rect rect;
        double weight;
    };
    Rect room_;
    std::vector<Thing> things_;
};

} // namespace windrow::cli
