// What the plants' descriptions ask of their fields, as sentences that name field, value and fix.
#pragma once

#include "fluid/message.h"
#include "fluid/result.h"

#include <cmath>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>

namespace windrow::detail {

class Checks {
  public:
    explicit Checks(std::string_view owner) : owner_(owner) {}

    /// NaN fails every comparison, and is refused too.
    void between(std::string_view field, float value, float least, float most, std::string_view unit) {
        if (!(value >= least && value <= most))
            reasons_.add(owner_, field, " is ", value, gap(unit), unit, ": give ", least, " to ", most, gap(unit), unit, ".");
    }
    /// [least, most] but 0.
    void above_zero(std::string_view field, float value, float most, std::string_view unit) {
        if (!(value > 0.0f && value <= most))
            reasons_.add(owner_, field, " is ", value, gap(unit), unit, ": give a number above 0", ", at most ", most, gap(unit),
                         unit, ".");
    }
    void direction(std::string_view field, const glm::vec3& value) {
        const double square = static_cast<double>(value.x) * value.x + static_cast<double>(value.y) * value.y +
                              static_cast<double>(value.z) * value.z;
        if (!std::isfinite(square) || !(square > 1e-24))
            reasons_.add(owner_, field, " is ", value, ": give a finite vector that is not 0.");
    }
    void at_least(std::string_view field, int value, int least, int most) {
        if (value < least || value > most)
            reasons_.add(owner_, field, " is ", value, ": give ", least, " to ", most, ".");
    }
    /// Spans of one call, each with an entry a plant.
    void same_size(std::string_view field, std::size_t size, std::size_t wanted) {
        if (size != wanted)
            reasons_.add(owner_, field, " has ", size, " entries: give ", wanted, ".");
    }
    void add(const Result<void>& part) {
        if (!part)
            reasons_.add(part.error());
    }
    [[nodiscard]] Result<void> outcome() {
        if (reasons_.empty())
            return {};
        return Error{reasons_.take()};
    }

  private:
    static std::string_view gap(std::string_view unit) { return unit.empty() ? "" : " "; }

    std::string_view owner_;
    Reasons reasons_;
};

} // namespace windrow::detail
