// A wind on the CPU and one on the device that are told the same, and what is read back of the device against the CPU's cells,
// frame by frame.
#pragma once

#include "fluid/vulkan/wind.h"
#include "tests/figure.h"
#include "tests/parity/gpu.h"
#include "tests/parity/submitter.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>
#include <string>

namespace windrow::vulkan {

/// Largest difference of a component, over the largest component of `b`; not a number where `a` holds one that is none.
[[nodiscard]] inline double apart(std::span<const glm::vec4> a, std::span<const glm::vec4> b, double least = 1e-30) {
    EXPECT_EQ(a.size(), b.size());
    double worst = 0.0, largest = least;
    for (std::size_t n = 0; n < std::min(a.size(), b.size()); ++n)
        for (int axis = 0; axis < 3; ++axis) {
            const double x = a[n][axis], y = b[n][axis];
            if (!std::isfinite(x) && !std::isfinite(y)) // set so, and no step since
                continue;
            if (!std::isfinite(x))
                return std::nan("");
            worst = std::max(worst, std::abs(x - y));
            largest = std::max(largest, std::abs(y));
        }
    return worst / largest;
}

class WindParity : public Gpu {
  protected:
    struct TwoWinds {
        windrow::Wind cpu;
        Wind device;
        int in_flight = 1;
        std::unique_ptr<Submitter> submitter{};         ///< null: each frame is waited for
        std::deque<std::vector<glm::vec4>> expected{};  ///< the CPU's frames that are not read back yet, oldest first
        double largest = 0.0;                           ///< difference so far, over the largest component of its frame
        double last = 0.0;                              ///< of the last frame
        int compared = 0;                               ///< frames
        bool cpu_sleeps = false, device_sleeps = false; ///< as of the last tick
        double min = 1e-30;                             ///< [m/s] that a frame's largest component counts as, at least

        /// Calls the same on both, which must take it.
        template <class Call>
        void both(const Call& call) {
            const auto on_cpu = call(cpu), on_device = call(device);
            ASSERT_TRUE(on_cpu) << on_cpu.error();
            ASSERT_TRUE(on_device) << on_device.error();
        }
        using Ids = std::pair<MotorId, MotorId>;
        Ids add(const Motor& motor) {
            const auto on_cpu = cpu.motors().add(motor), on_device = device.motors().add(motor);
            EXPECT_TRUE(on_cpu && on_device);
            return on_cpu && on_device ? Ids{*on_cpu, *on_device} : Ids{};
        }
        void move(const Ids& ids, glm::dvec3 to) {
            EXPECT_TRUE(cpu.motors().move(ids.first, to) && device.motors().move(ids.second, to));
        }
        void follow(glm::dvec3 point) {
            both([&](auto& wind) { return wind.follow(point); });
        }
        void set_ambient(glm::vec3 mean) {
            both([&](auto& wind) { return wind.set_ambient(mean); });
        }
        void set_gusts(const Gusts& gusts) {
            both([&](auto& wind) { return wind.set_gusts(gusts); });
        }
        void set_boundaries(const Boundaries& boundaries) {
            both([&](auto& wind) { return wind.set_boundaries(boundaries); });
        }
        void set_floor(double height) {
            both([&](auto& wind) { return wind.set_floor(height); });
        }
        void set_velocity(std::span<const glm::vec4> field) {
            both([&](auto& wind) { return wind.set_velocity(field); });
        }
        void reset() {
            cpu.reset();
            device.reset();
        }
    };

    /// One frame in flight that is waited for, or `in_flight` that are not.
    TwoWinds make(const Config& config, int in_flight = 0, Settings settings = {.texel = Texel::single},
                  const std::shared_ptr<const windrow::Wind>& outer = {}) {
        auto cpu = windrow::Wind::create(config, outer);
        settings.frames_in_flight = std::max(in_flight, 1);
        if (settings.queries == ReadBack::none)
            settings.queries = ReadBack::cells;
        auto gpu = Wind::create(sharing_host(), config, settings, outer);
        EXPECT_TRUE(cpu) << cpu.error();
        EXPECT_TRUE(gpu) << gpu.error();
        auto submitter = in_flight > 0 ? std::make_unique<Submitter>(own->host(), in_flight) : nullptr;
        return {*std::move(cpu), *std::move(gpu), std::max(in_flight, 1), std::move(submitter)};
    }

    /// Records with `recorded(commands, slot)`, reads what came back, and lets the CPU do the same.
    template <class Recorded, class Done>
    void frame_of(TwoWinds& pair, const Recorded& recorded, const Done& done) {
        if (pair.submitter)
            pair.submitter->frame(recorded);
        else
            run([&](VkCommandBuffer commands) { recorded(commands, 0); });
        compare(pair);
        done();
        const auto now = pair.cpu.view().field();
        pair.expected.emplace_back(now.begin(), now.end());
    }

    void frame(TwoWinds& pair, double dt) {
        Advance recorded, cpu;
        frame_of(
            pair,
            [&](VkCommandBuffer commands, int slot) { recorded = held(pair.device.record(commands, {.dt = dt, .slot = slot})); },
            [&] { cpu = pair.cpu.advance(dt); });
        if (cpu.ticks > 0) {
            EXPECT_EQ(recorded.last.carried_time, 0.0f) << "the host foresaw too few sub-steps";
            pair.cpu_sleeps = cpu.last.asleep;
            pair.device_sleeps = recorded.last.asleep;
        }
        EXPECT_EQ(cpu.ticks, recorded.ticks);
        EXPECT_EQ(cpu.factor, recorded.factor);
    }

    /// The same by one step of dt.
    void step(TwoWinds& pair, double dt) {
        frame_of(
            pair,
            [&](VkCommandBuffer commands, int slot) {
                const Diagnostics recorded = held(pair.device.record_step(commands, {.dt = dt, .slot = slot}));
                EXPECT_EQ(recorded.carried_time, 0.0f) << "the host foresaw too few sub-steps";
                pair.device_sleeps = recorded.asleep;
            },
            [&] { pair.cpu_sleeps = pair.cpu.step(dt).asleep; });
    }

    /// What was read back of the oldest frame in flight against the CPU's.
    static void compare(TwoWinds& pair) {
        if (pair.expected.size() < static_cast<std::size_t>(pair.in_flight))
            return;
        const std::vector<glm::vec4> expected = std::move(pair.expected.front());
        pair.expected.pop_front();
        if (expected.empty())
            return;
        const auto view = pair.device.queried();
        ASSERT_TRUE(view);
        pair.last = apart(view->field(), expected, pair.min);
        pair.largest = std::isnan(pair.last) ? pair.last : std::max(pair.largest, pair.last);
        ++pair.compared;
    }

    /// What was recorded and not compared yet is not looked at: the two fall asleep, and wake, some frames apart.
    static void forget_frames(TwoWinds& pair) { pair.expected.assign(pair.expected.size(), {}); }

    static void report(const std::string& name, const TwoWinds& pair, double bound) {
        WINDROW_EXPECT_FIGURE("wind_parity." + name, pair.largest, bound);
        EXPECT_GT(pair.largest, 0.0) << name << ": nothing was compared";
    }
};

} // namespace windrow::vulkan
