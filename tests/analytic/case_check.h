// A case of `windrow verify` as a test: the same flow, truth and bounds.
#pragma once

#include "cases/verify_case.h"
#include "figures.h"

#include <algorithm>
#include <string>

namespace windrow::figures {

/// Runs a case at `sizes`, coarse to fine, of its own; each error is held against its bound, each order between neighbours against
/// the least. Cases beside a spectral solution are there where FFTW is built in.
inline void expect_case(const std::string& name, const std::vector<int>& sizes) {
    const auto all = cases::verify_cases();
    const auto found = std::find_if(all.begin(), all.end(), [&](const cases::VerifyCase& one) { return one.name == name; });
    if (found == all.end() && cases::spectral_cases().empty())
        GTEST_SKIP() << name << " needs FFTW";
    ASSERT_TRUE(found != all.end()) << "there is no case of the name " << name;
    cases::VerifyCase one = *found;
    one.sizes = sizes;
    cases::VerifiedCase verified{.name = name};
    for (std::size_t level = 0; level < sizes.size(); ++level) {
        ASSERT_EQ(std::count(found->sizes.begin(), found->sizes.end(), sizes[level]), 1) << "its bound is of its own sizes";
        for (const cases::VerifyRow& row : one.run({}, sizes[level]).rows) {
            verified.rows.push_back(cases::judge(one, verified, level, row, {}));
            const cases::VerifiedRow& judged = verified.rows.back();
            const std::string label = name + (row.label.empty() ? "" : "." + row.label) + "." + std::to_string(sizes[level]);
            expect_at_most(label + ".error", row.error, row.bound);
            if (judged.order && one.min_order > 0.0)
                expect_at_least(label + ".order", *judged.order, one.min_order);
            EXPECT_TRUE(judged.pass) << label;
        }
    }
}

} // namespace windrow::figures
