#include "cases/parity_run.h"

#include "fluid/core/message.h"
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

/// Both winds with the same calls. A recording takes the read-back of the frame that had its slot before.
class Twins {
  public:
    Twins(vulkan::OwnDevice& device, const ParityStory& story, int frames_in_flight, windrow::Wind cpu, vulkan::Wind gpu)
        : device_(device), story_(story), cpu_(std::move(cpu)), gpu_(std::move(gpu)), follows_(story.walk != glm::dvec3(0.0)),
          cells_(static_cast<std::size_t>(frames_in_flight)) {}

    Result<void> start() {
        if (story_.stirred) {
            const std::vector<glm::vec4> field = stirred(story_.config);
            if (auto done = both([&](auto& wind) { return wind.set_velocity(field); }); !done)
                return done;
        }
        for (const StoryMotor& one : story_.motors) {
            const auto cpu = cpu_.motors().add(one.motor);
            const auto gpu = gpu_.motors().add(one.motor);
            if (!cpu || !gpu)
                return cpu ? gpu.failure() : cpu.failure();
            ids_.push_back({*cpu, *gpu});
        }
        return {};
    }

    /// Step n of both; the one that had its slot before is compared on the way, since its read-back is in.
    Result<void> step(int n, ParityResult& result) {
        if (auto done = change(n); !done)
            return done;
        if (auto done = build(n); !done)
            return done;
        move(story_.dt * (n + 1));
        if (follows_) {
            const glm::dvec3 point = story_.config.centre + jumped_ + story_.dt * (n + 1) * story_.walk;
            if (auto done = both([&](auto& wind) { return wind.follow(point); }); !done)
                return done;
        }
        if (auto ran = record({.dt = story_.dt, .slot = slot_of(n)}); !ran)
            return ran;
        result.dispatches = std::max(result.dispatches, gpu_.dispatches());
        result.barriers = std::max(result.barriers, gpu_.barriers());
        compare(n, result);
        const Diagnostics done = story_.frames ? cpu_.advance(story_.dt).last : cpu_.step(story_.dt);
        result.max_substeps = std::max(result.max_substeps, done.substeps);
        result.max_limited_cells = std::max(result.max_limited_cells, done.limited_cells);
        const auto cells = story_.frames ? cpu_.view().field() : cpu_.field();
        cells_of(n).assign(cells.begin(), cells.end());
        return {};
    }

    /// Compares the steps that are still in flight, the first of which would be taken by step n.
    Result<void> end(int n, ParityResult& result) {
        auto done = device_.wait();
        for (int last = n + static_cast<int>(cells_.size()); done && n < last; ++n) {
            (void)gpu_.collect(slot_of(n)); // none where the air slept
            compare(n, result);
        }
        return done;
    }

  private:
    [[nodiscard]] int slot_of(int n) const { return n % static_cast<int>(cells_.size()); }
    [[nodiscard]] std::vector<glm::vec4>& cells_of(int n) { return cells_[static_cast<std::size_t>(slot_of(n))]; }

    // One frame in flight is waited for; more are not.
    Result<void> record(const vulkan::Frame& frame) {
        Result<void> recorded;
        const auto keep = [&](const auto& done) {
            if (!done)
                recorded = done.failure();
        };
        auto ran = device_.submit(frame.slot, [&](VkCommandBuffer commands) {
            story_.frames ? keep(gpu_.record(commands, frame)) : keep(gpu_.record_step(commands, frame));
        });
        if (ran && cells_.size() == 1)
            ran = device_.wait();
        return recorded ? ran : recorded;
    }

    template <class Call>
    Result<void> both(const Call& call) {
        if (auto done = call(cpu_); !done)
            return done;
        return call(gpu_);
    }

    Result<void> change(int n) {
        for (const StoryChange& change : story_.changes) {
            if (change.step != n)
                continue;
            const auto done = std::visit(
                [&](const auto& what) -> Result<void> {
                    using What = std::decay_t<decltype(what)>;
                    if constexpr (std::is_same_v<What, StoryChange::FollowJump>) {
                        jumped_ += what.by;
                        return {};
                    } else if constexpr (std::is_same_v<What, StoryChange::Ambient>) {
                        return both([&](auto& wind) { return wind.set_ambient(what.mean); });
                    } else if constexpr (std::is_same_v<What, Boundaries>) {
                        return both([&](auto& wind) { return wind.set_boundaries(what); });
                    } else if constexpr (std::is_same_v<What, StoryChange::Floor>) {
                        return both([&](auto& wind) { return wind.set_floor(what.height); });
                    } else {
                        return both([&](auto& wind) { return wind.set_gusts(what); });
                    }
                },
                change.what);
            if (!done)
                return done;
        }
        return {};
    }

    Result<void> build(int n) {
        for (const StoryObstacle& one : story_.obstacles) {
            if (one.step != n)
                continue;
            const auto cpu = cpu_.obstacles().add(one.obstacle);
            const auto gpu = gpu_.obstacles().add(one.obstacle);
            if (!cpu || !gpu)
                return cpu ? gpu.failure() : cpu.failure();
            bodies_.push_back({&one, *cpu, *gpu});
        }
        return {};
    }

    void move(double time) {
        for (const Body& body : bodies_) {
            if (body.one->velocity == glm::dvec3(0.0))
                continue;
            const glm::dvec3 to = body.one->obstacle.position + (time - story_.dt * body.one->step) * body.one->velocity;
            (void)cpu_.obstacles().move(body.cpu, to);
            (void)gpu_.obstacles().move(body.gpu, to);
        }
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

    // The CPU's cells of the step that had the slot of step n before.
    void compare(int n, ParityResult& result) {
        const std::vector<glm::vec4>& cells = cells_of(n);
        const auto view = gpu_.queried();
        if (!view || cells.empty())
            return;
        const auto device = view->field();
        double worst = 0.0, largest = 1e-30;
        for (std::size_t at = 0; at < cells.size(); ++at)
            for (int axis = 0; axis < 3; ++axis) {
                const double cpu = cells[at][axis], apart = std::abs(static_cast<double>(device[at][axis]) - cpu);
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

    struct Body {
        const StoryObstacle* one;
        ObstacleId cpu, gpu;
    };
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
    std::vector<Body> bodies_;
    std::vector<std::vector<glm::vec4>> cells_; ///< of the CPU's last steps, by slot
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
    vulkan::Host host = device.host();
    if (settings.split_planes) // 4 bytes for each of half of the cells
        host.shared_bytes = static_cast<std::uint32_t>(2 * config.cells.x * config.cells.z);
    auto gpu = vulkan::Wind::create(host, config,
                                    {.texel = settings.texel,
                                     .frames_in_flight = settings.frames_in_flight,
                                     .gusts = gusts,
                                     .queries = vulkan::ReadBack::cells});
    if (!gpu)
        return failed(gpu.error());
    ParityResult result{.name = story.name, .cells = config.cells, .first_bound = story.first_bound, .bound = story.bound};
    {
        Twins twins(device, story, settings.frames_in_flight, *std::move(cpu), *std::move(gpu));
        if (auto done = twins.start(); !done)
            return failed(done.error());
        for (int n = 0; n < story.steps; ++n) {
            if (settings.stopped && settings.stopped())
                return failed("stopped");
            if (auto stepped = twins.step(n, result); !stepped)
                return failed(stepped.error());
        }
        if (auto ended = twins.end(story.steps, result); !ended)
            return failed(ended.error());
    } // the layer tells what was left behind
    result.messages = device.messages() - messages;
    return result;
}

} // namespace windrow::cases
