// Figures of the analytic tests: each one is printed, kept in the XML report and held against its bound.
//
//     [figure] name value <= bound
//
// A claim that is only measured has no bound and says "reported".
#pragma once

#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <initializer_list>
#include <string>

namespace windrow::figures {

inline void record(const std::string& name, double value, const char* relation, const std::string& bound) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    ::testing::Test::RecordProperty(name, std::string(text) + " " + relation + (bound.empty() ? "" : " ") + bound);
    std::printf("[figure] %-58s %12s  %s %s\n", name.c_str(), text, relation, bound.c_str());
}

inline std::string number_text(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.8g", value);
    return text;
}

inline void report(const std::string& name, double value) {
    record(name, value, "reported", "");
}

// NaN fails both.
inline void expect_at_most(const std::string& name, double value, double bound) {
    record(name, value, "<=", number_text(bound));
    EXPECT_LE(value, bound) << name;
}

inline void expect_at_least(const std::string& name, double value, double bound) {
    record(name, value, ">=", number_text(bound));
    EXPECT_GE(value, bound) << name;
}

/// Observed order between two errors whose grids differ by a factor 2.
inline double order(double coarse, double fine) {
    return std::log2(coarse / fine);
}

/// Errors error(n) over sizes n, each twice the one before, reported; the order between neighbours is held against `least`. Returns
/// the last error.
template <class Error>
double expect_orders(const std::string& name, std::initializer_list<int> sizes, double least, const Error& error) {
    int coarse = 0;
    double last = 0.0;
    for (const int size : sizes) {
        const double now = error(size);
        report(name + ".error_" + std::to_string(size), now);
        if (coarse > 0)
            expect_at_least(name + ".order_" + std::to_string(coarse) + "_" + std::to_string(size), order(last, now), least);
        coarse = size;
        last = now;
    }
    return last;
}

} // namespace windrow::figures
