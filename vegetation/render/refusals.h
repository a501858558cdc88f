// Reasons why settings are refused, gathered: one sentence a line, each with field, value and fix.
#pragma once

#include "fluid/result.h"

#include <cmath>
#include <cstdio>
#include <string>

namespace windrow::vegetation::render {

class Refusals {
  public:
    /// Refuses a value that is not finite or outside [low, high].
    void range(const char* field, double value, double low, double high) {
        if (std::isfinite(value) && value >= low && value <= high)
            return;
        char text[200];
        std::snprintf(text, sizeof text, "%s is %g; give it a value from %g to %g.", field, value, low, high);
        add(text);
    }
    void add(const std::string& sentence) { text_ += (text_.empty() ? "" : "\n") + sentence; }
    void add(const windrow::Result<void>& judged) {
        if (!judged)
            add(judged.error());
    }

    [[nodiscard]] windrow::Result<void> result() const {
        if (text_.empty())
            return {};
        return windrow::Error{text_};
    }

  private:
    std::string text_;
};

} // namespace windrow::vegetation::render
