// A figure that a test measured, beside its bound: printed, and kept in the report of the run.
#pragma once

#include <cstdio>
#include <gtest/gtest.h>
#include <string>

namespace windrow::test {

/// Records `value` under `name`; the test itself compares it with the bound.
inline double figure(const std::string& name, double value, double bound) {
    std::printf("[figure] %s %.6g %.6g\n", name.c_str(), value, bound);
    char text[64];
    std::snprintf(text, sizeof text, "%.9g", value);
    testing::Test::RecordProperty(name, text);
    return value;
}

/// A figure that nothing bounds: stated, so that a change of it is seen.
inline double figure(const std::string& name, double value) {
    std::printf("[figure] %s %.6g -\n", name.c_str(), value);
    char text[64];
    std::snprintf(text, sizeof text, "%.9g", value);
    testing::Test::RecordProperty(name, text);
    return value;
}

/// The same, asked to stay at or below its bound.
#define WINDROW_EXPECT_FIGURE(name, value, bound) EXPECT_LE(windrow::test::figure(name, value, bound), bound) << (name)

} // namespace windrow::test
