// A device beside the CPU: the same story on both (parity_story.h), held together to rounding. It is no error against a
// truth, but what makes the errors of the CPU's cases the device's too.
#include "cases/parity_run.h"
#include "cases/verify_case.h"
#include "fluid/core/message.h"

#include <algorithm>

namespace windrow::cases {
namespace {

// A software device takes about 3 us a cell and step: with these a story takes a minute at most.
constexpr double k_software_cell_steps = 1.4e7;

// The stories whose box is `size` cells along x.
VerifyRows parity(const VerifySetting& setting, int size) {
    std::vector<VerifyRow> rows;
    vulkan::OwnDevice& device = *setting.backend.device();
    for (const ParityStory& whole : parity_stories()) {
        if (whole.config.cells.x != size)
            continue;
        const ParityStory story = device.facts().software ? shortened(whole, k_software_cell_steps) : whole;
        const auto result =
            run_parity(device, story, {.simd = setting.simd, .parallel_for = setting.parallel_for, .stopped = setting.stopped});
        if (!result) {
            setting.backend.note_fault(result.error());
            return rows;
        }
        const auto row = [&](double error, double bound, const std::string& when) {
            rows.push_back(VerifyRow{.cells = result->cells, .error = error, .bound = bound, .label = story.name + when});
        };
        row(result->first, result->first_bound, ", 1 step");
        row(result->largest, result->bound, detail::message(", ", result->steps, " steps"));
    }
    return rows;
}

std::vector<int> story_sizes() {
    std::vector<int> sizes;
    for (const ParityStory& story : parity_stories())
        sizes.push_back(story.config.cells.x);
    std::sort(sizes.begin(), sizes.end());
    sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
    return sizes;
}

} // namespace

std::vector<VerifyCase> parity_cases() {
    return {
        {.name = "parity",
         .what = "The device and the CPU with the same calls: motors, shifts, mixed boundaries, gusts, storms; largest "
                 "difference of a "
                 "component over the largest component, after the first step and after all.",
         .source = "the CPU's step, in this very run",
         .reason = "rounding, some 1e-7 a step, which a hundred steps of chaotic flow stretch",
         .runs_on = RunsOn::device,
         .sizes = story_sizes(),
         .run = parity},
    };
}

} // namespace windrow::cases
