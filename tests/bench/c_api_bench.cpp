// Cost of a call of the C interface over the same call of the C++ one.
//
//     windrow_c_api_bench         prints nanoseconds a call of both, and what C adds
//
// Both are in one program; each call is timed in rounds that take turns, and the shortest round counts: what else runs on the machine
// only adds. The wind is the default one with a fan; both winds are in the same state.
#include "fluid/wind.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <limits>
#include <memory>
#include <vector>
#include <windrow/windrow.h>

namespace {

constexpr int k_rounds = 60;

struct Contest {
    const char* name;
    int calls; ///< of a round
    std::function<void()> cpp, c;
};

double round_ns(const Contest& contest, const std::function<void()>& call) {
    const auto start = std::chrono::steady_clock::now();
    for (int n = 0; n < contest.calls; ++n)
        call();
    return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count() / contest.calls;
}

void run(const Contest& contest) {
    double cpp = std::numeric_limits<double>::infinity(), c = cpp;
    for (int round = 0; round < k_rounds; ++round) {
        cpp = std::min(cpp, round_ns(contest, contest.cpp));
        c = std::min(c, round_ns(contest, contest.c));
    }
    std::printf("| %-34s | %12.1f | %12.1f | %+8.1f | %+6.1f %% |\n", contest.name, cpp, c, c - cpp, 100.0 * (c / cpp - 1.0));
}

} // namespace

int main() {
    auto cpp = windrow::Wind::create({.ambient = {3.0f, 0.0f, 0.0f}});
    windrow_config config;
    windrow_wind* c = nullptr;
    if (!cpp || windrow_config_init(&config, sizeof config) != WINDROW_OK)
        return 1;
    config.ambient.x = 3.0f;
    if (windrow_wind_create(&config, &c) != WINDROW_OK)
        return std::puts(windrow_last_error()), 1;
    const std::unique_ptr<windrow_wind, void (*)(windrow_wind*)> owned(c, windrow_wind_destroy);

    windrow_wake_motor wake;
    windrow_motor_id id;
    (void)windrow_wake_motor_init(&wake, sizeof wake);
    const auto cpp_id = cpp->motors().add(windrow::WakeMotor{});
    if (!cpp_id || windrow_wind_add_wake(c, &wake, &id) != WINDROW_OK)
        return 1;
    (void)cpp->motors().add(windrow::DirectionalMotor{});
    windrow_directional_motor fan;
    (void)windrow_directional_motor_init(&fan, sizeof fan);
    (void)windrow_wind_add_directional(c, &fan, nullptr);

    std::vector<glm::dvec3> points(10'000);
    std::vector<glm::vec3> winds(points.size());
    for (std::size_t n = 0; n < points.size(); ++n)
        points[n] = {0.003 * static_cast<double>(n) - 15.0, 0.0007 * static_cast<double>(n % 1000),
                     0.01 * static_cast<double>(n % 97)};
    windrow_query query;
    (void)windrow_query_init(&query, sizeof query);
    query.count = points.size();
    query.positions = points.data();
    query.velocities = &winds[0].x;
    std::vector<float> float_points;
    for (const glm::dvec3& point : points)
        float_points.insert(float_points.end(),
                            {static_cast<float>(point.x), static_cast<float>(point.y), static_cast<float>(point.z)});
    windrow_query float_query = query;
    float_query.number = WINDROW_NUMBER_FLOAT;
    float_query.positions = float_points.data();
    float sum = 0.0f;
    double x = 0.0;

    std::printf("| %-34s | %12s | %12s | %8s | %8s |\n|---|---|---|---|---|\n", "call", "C++ [ns]", "C [ns]", "C adds", "");
    run({"velocity of one point", 20'000,
         [&] {
             sum += cpp->velocity({1.0, 2.0, 3.0}).x;
         },
         [&] {
             windrow_vec3 velocity;
             (void)windrow_wind_velocity(c, {1.0, 2.0, 3.0}, &velocity);
             sum += velocity.x;
         }});
    run({"velocities of 10,000 points", 4, [&] { cpp->velocity(points, winds); }, [&] { (void)windrow_wind_sample(c, &query); }});
    run({"the same, C from floats", 4, [&] { cpp->velocity(points, winds); },
         [&] { (void)windrow_wind_sample(c, &float_query); }});
    run({"follow", 20'000, [&] { (void)cpp->follow({0.0, 0.0, 0.0}); }, [&] { (void)windrow_wind_follow(c, {0.0, 0.0, 0.0}); }});
    run({"move of a motor", 100,
         [&] {
             (void)cpp->motors().move(*cpp_id, {x += 1e-6, 0.0, 0.0});
         },
         [&] {
             (void)windrow_wind_move_motor(c, id, {x += 1e-6, 0.0, 0.0});
         }});
    run({"add and remove of a fan", 200,
         [&] {
             if (const auto made = cpp->motors().add(windrow::DirectionalMotor{}))
                 (void)cpp->motors().remove(*made);
         },
         [&] {
             windrow_motor_id made;
             (void)windrow_wind_add_directional(c, &fan, &made);
             (void)windrow_wind_remove_motor(c, made);
         }});
    run({"a step of 32 x 16 x 32 cells", 10, [&] { (void)cpp->step(1.0 / 60.0); },
         [&] { (void)windrow_wind_step(c, 1.0 / 60.0, nullptr); }});
    return sum == 0.123f; // it is used
}
