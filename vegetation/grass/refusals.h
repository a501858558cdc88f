// What is wrong with an input, as sentences that name field, value and fix.
#pragma once

#include "fluid/result.h"

#include <cstdio>
#include <string>

namespace windrow::vegetation::grass {

/// A number as a sentence has it.
inline std::string text(double value) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.9g", value);
    return digits;
}

class Refusals {
  public:
    void add(const std::string& sentence) { sentences_ += (sentences_.empty() ? "" : "\n") + sentence; }
    /// NaN fails every comparison, and is refused too.
    void between(const char* field, double value, double least, double most, const char* unit) {
        if (!(value >= least && value <= most))
            add(std::string(field) + " is " + text(value) + unit + ": give " + text(least) + " to " + text(most) + unit + ".");
    }
    [[nodiscard]] windrow::Result<void> outcome() const {
        if (sentences_.empty())
            return {};
        return windrow::Error{sentences_};
    }

  private:
    std::string sentences_;
};

} // namespace windrow::vegetation::grass
