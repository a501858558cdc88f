#include "cases/parity_run.h"

#include "fluid/message.h"
#include "fluid/vulkan/wind.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace windrow::cases {
namespace {

using detail::message;

/// Sines of one to two waves a box: no symmetry that would hide a swapped axis.
std::vector<glm::vec4> stirred(const Config& config) {
    const Box box{config.cells, config.cell_size, config.boundaries};
    std::vector<glm::vec4> field(box.cell_count());
    for (int k = 0; k < config.cells.z; ++k)
        for (int j = 0; j < config.cells.y; ++j)
            for (int i = 0; i < config.cells.x; ++i) {
                const glm::vec3 p = 6.2831853f * (glm::vec3(i, j, k) + 0.5f) / glm::vec3(config.cells);
                const glm::vec3 u(std::sin(p.y + 1.0f) * std::cos(p.z), 0.7f * std::sin(p.z - p.x),
                                  0.8f * std::cos(p.x + 0.5f) * std::sin(2.0f * p.y));
                field[box.index(i, j, k)] = glm::vec4(config.ambient + u, 0.0f);
            }
    return field;
}

/// Both winds, told the same: one frame in flight, so that what a recording leaves is read by the next.
class Twins {
  public:
    Twins(vulkan::OwnDevice& device, const ParityStory& story, windrow::Wind cpu, vulkan::Wind gpu)
        : device_(device), story_(story), cpu_(std::move(cpu)), gpu_(std::move(gpu)), follows_(story.walk != glm::dvec3(0.0)) {}

    Result<void> start() {
        if (story_.stirred) {
            const std::vector<glm::vec4> field = stirred(story_.config);
            if (auto told = both([&](auto& wind) { return wind.set_velocity(field); }); !told)
                return told;
        }
        for (const StoryMotor& one : story_.motors) {
            const auto cpu = cpu_.motors().add(one.motor);
            const auto gpu = gpu_.motors().add(one.motor);
            if (!cpu || !gpu)
                return Error{cpu ? gpu.error() : cpu.error()};
            ids_.push_back({*cpu, *gpu});
        }
        return {};
    }

    /// Step n of both; the one before is compared on the way, since its read-back is in.
    Result<void> step(int n, ParityResult& result) {
        if (auto told = change(n); !told)
            return told;
        move(story_.dt * (n + 1));
        if (follows_) {
            const glm::dvec3 point = story_.config.centre + jumped_ + story_.dt * (n + 1) * story_.walk;
            if (auto told = both([&](auto& wind) { return wind.follow(point); }); !told)
                return told;
        }
        const vulkan::Frame frame{.dt = story_.dt};
        if (auto ran = run(frame, story_.frames); !ran)
            return ran;
        result.dispatches = std::max(result.dispatches, gpu_.dispatches());
        result.barriers = std::max(result.barriers, gpu_.barriers());
        compare(result);
        const Diagnostics done = story_.frames ? cpu_.advance(story_.dt).last : cpu_.step(story_.dt);
        result.max_substeps = std::max(result.max_substeps, done.substeps);
        result.max_limited_cells = std::max(result.max_limited_cells, done.limited_cells);
        const auto cells = story_.frames ? cpu_.view().field() : cpu_.field();
        cells_.assign(cells.begin(), cells.end());
        return {};
    }

    /// Compares the last step, which a recording without time reads back.
    Result<void> end(ParityResult& result) {
        const auto ran = run({.dt = 0.0}, true);
        if (ran)
            compare(result);
        return ran;
    }

  private:
    Result<void> run(const vulkan::Frame& frame, bool ticks) {
        Result<void> recorded;
        const auto keep = [&](const auto& done) {
            if (!done)
                recorded = Error{done.error()};
        };
        auto ran = device_.run([&](VkCommandBuffer commands) {
            ticks ? keep(gpu_.record(commands, frame)) : keep(gpu_.record_step(commands, frame));
        });
        return recorded ? ran : recorded;
    }

    template <class Call>
    Result<void> both(const Call& call) {
        if (auto told = call(cpu_); !told)
            return told;
        return call(gpu_);
    }

    Result<void> change(int n) {
        for (const StoryChange& change : story_.changes) {
            if (change.step != n)
                continue;
            const auto told = std::visit(
                [&](const auto& what) -> Result<void> {
                    using What = std::decay_t<decltype(what)>;
                    if constexpr (std::is_same_v<What, StoryChange::FollowJump>) {
                        jumped_ += what.by;
                        return {};
                    } else if constexpr (std::is_same_v<What, StoryChange::Ambient>) {
                        return both([&](auto& wind) { return wind.set_ambient(what.mean); });
                    } else if constexpr (std::is_same_v<What, Boundaries>) {
                        return both([&](auto& wind) { return wind.set_boundaries(what); });
                    } else {
                        return both([&](auto& wind) { return wind.set_gusts(what); });
                    }
                },
                change.what);
            if (!told)
                return told;
        }
        return {};
    }

    void move(double time) {
        for (std::size_t n = 0; n < ids_.size(); ++n) {
            const StoryMotor& one = story_.motors[n];
            if (one.velocity == glm::dvec3(0.0))
                continue;
            const auto from = std::visit([](const auto& motor) { return motor.position; }, one.motor);
            // A motor that has ended is no fault of the story.
            (void)cpu_.motors().move(ids_[n].cpu, from + time * one.velocity);
            (void)gpu_.motors().move(ids_[n].gpu, from + time * one.velocity);
        }
    }

    void compare(ParityResult& result) const {
        const auto view = gpu_.queried();
        if (!view || cells_.empty())
            return;
        const auto device = view->field();
        double worst = 0.0, largest = 1e-30;
        for (std::size_t n = 0; n < cells_.size(); ++n)
            for (int axis = 0; axis < 3; ++axis) {
                const double cpu = cells_[n][axis], apart = std::abs(static_cast<double>(device[n][axis]) - cpu);
                // A NaN stays: max() keeps its first where nothing compares.
                worst = std::isfinite(apart) ? std::max(worst, apart) : std::numeric_limits<double>::quiet_NaN();
                largest = std::max(largest, std::abs(cpu));
            }
        result.last = worst / largest;
        if (result.steps++ == 0)
            result.first = result.last;
        // A NaN stays one.
        if (!(result.largest >= result.last))
            result.largest = std::isnan(result.largest) ? result.largest : result.last;
        result.largest_component = std::max(result.largest_component, largest);
    }

    struct Ids {
        MotorId cpu, gpu;
    };

    vulkan::OwnDevice& device_;
    const ParityStory& story_;
    windrow::Wind cpu_;
    vulkan::Wind gpu_;
    bool follows_;
    glm::dvec3 jumped_{0.0};
    std::vector<Ids> ids_;
    std::vector<glm::vec4> cells_; ///< of the CPU's last step
};

} // namespace

bool ParityResult::pass() const {
    // A NaN is below no bound.
    return steps > 0 && first <= first_bound && largest <= bound && messages == 0;
}

Result<ParityResult> run_parity(vulkan::OwnDevice& device, const ParityStory& story, const ParitySettings& settings) {
    const auto failed = [&](const std::string& why) { return Error{message("The story ", story.name, ": ", why)}; };
    Config config = story.config;
    config.simd = settings.simd;
    config.parallel_for = settings.parallel_for;
    auto cpu = windrow::Wind::create(config);
    if (!cpu)
        return failed(cpu.error());
    const int messages = device.messages();
    const bool gusts = std::any_of(story.changes.begin(), story.changes.end(),
                                   [](const StoryChange& change) { return std::holds_alternative<Gusts>(change.what); });
    auto gpu =
        vulkan::Wind::create(device.host(), config, {.texel = vulkan::Texel::single, .frames_in_flight = 1, .gusts = gusts});
    if (!gpu)
        return failed(gpu.error());
    ParityResult result{.name = story.name, .cells = config.cells, .first_bound = story.first_bound, .bound = story.bound};
    {
        Twins twins(device, story, *std::move(cpu), *std::move(gpu));
        if (auto told = twins.start(); !told)
            return failed(told.error());
        for (int n = 0; n < story.steps; ++n) {
            if (settings.stopped && settings.stopped())
                return failed("stopped");
            if (auto stepped = twins.step(n, result); !stepped)
                return failed(stepped.error());
        }
        if (auto ended = twins.end(result); !ended)
            return failed(ended.error());
    } // the layer tells what was left behind
    result.messages = device.messages() - messages;
    return result;
}

} // namespace windrow::cases
