// The parity stories over both kinds of texels, both divisions of planes, one to three frames in flight, and each kind of queue.
#include "cases/parity_run.h"
#include "cli/device_report/report_section.h"
#include "cli/table.h"
#include "fluid/core/message.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

namespace windrow::cli {
namespace {

using namespace cases;
using detail::message;

// Updates of a cell in a story. A GPU takes the first round of stories whole.
constexpr double k_cell_steps = 2e7, k_software_cell_steps = 2.5e6, k_quick_cell_steps = 1e5;

// Stories that run however little time there is: with them each texel, division of planes and number of frames has run.
constexpr int k_least_stories = 4;

struct Path {
    vulkan::Texel texel = vulkan::Texel::single;
    bool split = false;
    int frames = 1;
    std::size_t queue = 0;
};

struct ParityQueue {
    const char* name;
    vulkan::OwnDevice* device;
};

// Texels change with each path, planes with each second one, frames in a rhythm of three: any four paths in a row have both texels and
// planes, any three each number of frames, and twelve all combinations.
std::vector<Path> all_paths(std::size_t queues) {
    std::vector<Path> paths;
    for (std::size_t n = 0; n < 12 * queues; ++n)
        paths.push_back({.texel = n % 2 == 0 ? vulkan::Texel::single : vulkan::Texel::half,
                         .split = (n / 2) % 2 != 0,
                         .frames = static_cast<int>(1 + n % 3),
                         .queue = n / 12});
    return paths;
}

class Matrix {
  public:
    Matrix(SectionRun& run, std::vector<ParityQueue> queues) : run_(run), queues_(std::move(queues)) {}

    /// Each story on its path in turns for `quick`, else on each path: the first path with all steps on a GPU, the others shorter.
    void measure() {
        const bool software = run_.own.facts().software;
        const std::vector<Path> paths = all_paths(queues_.size());
        std::vector<ParityStory> stories = parity_stories();
        const double most = run_.quick ? k_quick_cell_steps : software ? k_software_cell_steps : k_cell_steps;
        // The cheap ones first, so that the time lasts for each path.
        std::stable_sort(stories.begin(), stories.end(), [&](const ParityStory& a, const ParityStory& b) {
            return cell_steps(shortened(a, most)) < cell_steps(shortened(b, most));
        });
        if (run_.quick) {
            // A story that is left out leaves its path to the next one.
            std::size_t next = 0;
            for (std::size_t n = 0; goes_on() && (n < stories.size() || next < paths.size()); ++n)
                next += tell(shortened(stories[n % stories.size()], most), paths[next % paths.size()]) ? 1 : 0;
        } else {
            for (std::size_t path = 0; path < paths.size(); ++path)
                for (const ParityStory& story : stories)
                    tell(path == 0 && !software ? story : shortened(story, most), paths[path]);
        }
        for (const ParityStory& story : stories)
            if (!names_.contains(story.name))
                run_.leave_out(message(story.name, ": the time did not last for it."));
        if (paths_.size() < paths.size())
            run_.leave_out(
                message(paths.size() - paths_.size(), " of ", paths.size(), " paths: the time did not last for them."));
        run_.json["ran"] = ran_;
        run_.json["passed"] = passed_;
        run_.json["pass"] = ran_ == passed_;
    }

  private:
    /// False where the time does not allow it.
    bool tell(const ParityStory& story, const Path& path) {
        const ParityQueue& queue = queues_[path.queue];
        const double size = cell_steps(story);
        const bool whatever_the_time = ran_ < k_least_stories;
        if (!whatever_the_time && (run_.clock.over() || size * cost_ > run_.clock.left()))
            return false;
        const double before = run_.clock.past();
        bool cut = false;
        const auto result =
            run_parity(*queue.device, story,
                       {.texel = path.texel,
                        .frames_in_flight = path.frames,
                        .split_planes = path.split,
                        .parallel_for = run_.parallel_for,
                        .stopped = [&] {
                            cut = run_.clock.stopped() || (!whatever_the_time && run_.clock.left() < -0.2 * run_.clock.budget());
                            return cut;
                        }});
        if (cut)
            return false;
        ++ran_;
        names_.insert(story.name);
        paths_.insert({path.texel == vulkan::Texel::half, path.split, path.frames, path.queue});
        ReportJson row = {{"story", story.name},
                          {"texel", path.texel == vulkan::Texel::half ? "half" : "single"},
                          {"planes", path.split ? "split" : "as chosen"},
                          {"frames_in_flight", path.frames},
                          {"queue", queue.name}};
        if (!result) {
            run_.json["broken"].push_back(message(row.dump(), ": ", result.error()));
            return true;
        }
        // Compiling takes most of a small story, so that only large ones show what a cell costs.
        if (size > 1e5)
            cost_ = std::max(cost_, (run_.clock.past() - before) / size);
        passed_ += result->pass() ? 1 : 0;
        row["steps"] = result->steps;
        row["first"] = four_digits(result->first); // what is not finite becomes null
        row["largest"] = four_digits(result->largest);
        row["bound"] = result->bound;
        row["pass"] = result->pass();
        run_.json["stories"].push_back(std::move(row));
        return true;
    }

    [[nodiscard]] bool goes_on() const { return !run_.clock.stopped() && (ran_ < k_least_stories || !run_.clock.over()); }
    static double cell_steps(const ParityStory& story) {
        const glm::dvec3 cells(story.config.cells);
        return cells.x * cells.y * cells.z * story.steps;
    }

    SectionRun& run_;
    std::vector<ParityQueue> queues_;
    double cost_ = 0.0; ///< [s] of a cell's update
    int ran_ = 0, passed_ = 0;
    std::set<std::string> names_;
    std::set<std::tuple<bool, bool, int, std::size_t>> paths_;
};

} // namespace

Result<void> report_parity(SectionRun& run) {
    const bool draws = run.own_draws;
    std::vector<ParityQueue> queues = {{draws ? "graphics" : "compute", &run.own}};
    auto compute = vulkan::OwnDevice::create({.device = run.device, .queue_without = VK_QUEUE_GRAPHICS_BIT});
    if (draws && compute)
        queues.push_back({"compute alone", compute->get()});
    else
        run.leave_out(draws ? "a queue that computes alone: " + compute.error() : "a queue that draws: the device has none.");
    Matrix(run, std::move(queues)).measure();
    return {};
}

} // namespace windrow::cli
