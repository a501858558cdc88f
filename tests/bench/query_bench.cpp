// What a query of the wind costs: one point after another by plain GLM, one by the library, and lists of 10,000 points by the
// library on each SIMD level.
//
//     windrow_query_bench [seconds a case]          default 1
//
// Methods take turns within a case, a list each; times are the least of the turns, and so is `times`, the plain time over that of the
// list on the best level. `apart` is the largest difference between the list and plain GLM over the largest speed; `single = list`
// says whether the library's two calls gave the same bits. "in order" is a list as a meadow has it: neighbours in the list are 0.1 m
// apart, in rows. "shuffled" are the same points in random order.
#include "cases/reference/plain_query.h"
#include "fluid/wind.h"
#include "tests/fields.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <glm/geometric.hpp>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace windrow;

constexpr std::size_t k_points = 10'000;
constexpr Simd k_levels[] = {Simd::baseline, Simd::avx2, Simd::avx512};

using List = std::vector<glm::dvec3>;
using Winds = std::vector<glm::vec3>;

// 100 x 100 points over a rectangle of the ground, in rows, at heights of plants.
List meadow(glm::dvec3 low, double edge) {
    List points;
    test::Random random(5);
    for (int k = 0; k < 100; ++k)
        for (int i = 0; i < 100; ++i)
            points.push_back(low + glm::dvec3(edge * (i + random.real(0.0, 1.0)) / 100.0, random.real(0.1, 1.5),
                                              edge * (k + random.real(0.0, 1.0)) / 100.0));
    return points;
}

List shuffled(List points) {
    std::mt19937 random(7);
    std::shuffle(points.begin(), points.end(), random);
    return points;
}

// Anywhere in a box: no two points share cells.
List scattered(const Wind& wind) {
    List points(k_points);
    test::Random random(9);
    for (glm::dvec3& point : points)
        point = wind.origin() + (0.5 + random.point(0.5)) * glm::dvec3(wind.box().size());
    return points;
}

struct Method {
    std::function<void(Winds&)> run;
    Winds winds = Winds(k_points);
    double seconds = 1e30;
};

double time_of(const std::function<void()>& body) {
    const auto start = std::chrono::steady_clock::now();
    body();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void contest(const std::string& name, double seconds, std::vector<Method>& methods) {
    double spent = 0.0;
    for (int round = 0; round < 5 || spent < seconds; ++round)
        for (Method& method : methods) {
            const double taken = time_of([&] { method.run(method.winds); });
            method.seconds = std::min(method.seconds, taken);
            spent += taken;
        }
    double apart = 0.0, largest = 0.0;
    for (std::size_t n = 0; n < k_points; ++n) {
        apart = std::max(apart, double(glm::length(methods[0].winds[n] - methods.back().winds[n])));
        largest = std::max(largest, double(glm::length(methods[0].winds[n])));
    }
    bool same = true;
    for (std::size_t n = 2; n < methods.size(); ++n)
        same = same && std::memcmp(methods[1].winds.data(), methods[n].winds.data(), k_points * sizeof(glm::vec3)) == 0;
    std::printf("| %-34s |", name.c_str());
    for (const Method& method : methods)
        std::printf(" %6.1f |", 1e9 * method.seconds / k_points);
    std::printf(" %5.1f | %7.1e | %s |\n", methods[0].seconds / methods.back().seconds, largest > 0.0 ? apart / largest : 0.0,
                same ? "yes" : "NO");
}

WindView on_level(const WindView& view, Simd level) {
    return {view.box(), view.window(), view.blend_zone(), view.ambient(), view.field(), level};
}

// Each call makes a view, as Wind::velocity does.
void velocities(const std::string& name, double seconds, const Wind& wind, const List& points) {
    const WindView view = wind.view();
    std::vector<Method> methods;
    methods.push_back({.run = [&](Winds& winds) {
        for (std::size_t n = 0; n < k_points; ++n)
            winds[n] = reference::plain_velocity(wind.view(), points[n]);
    }});
    methods.push_back({.run = [&](Winds& winds) {
        for (std::size_t n = 0; n < k_points; ++n)
            winds[n] = wind.velocity(points[n]);
    }});
    for (const Simd level : k_levels)
        if (runs(level))
            methods.push_back({.run = [&view, &points, level](Winds& winds) { on_level(view, level).velocity(points, winds); }});
    contest(name, seconds, methods);
}

void felt(const std::string& name, double seconds, const Wind& wind, const List& points, const Sampling& sampling) {
    const WindView view = wind.view();
    std::vector<Method> methods;
    methods.push_back({.run = [&](Winds& winds) {
        for (std::size_t n = 0; n < k_points; ++n)
            winds[n] =
                reference::plain_felt(view.ambient(), reference::plain_velocity(wind.view(), points[n]), points[n], sampling);
    }});
    methods.push_back({.run = [&](Winds& winds) {
        for (std::size_t n = 0; n < k_points; ++n)
            winds[n] = wind.felt(points[n], sampling);
    }});
    for (const Simd level : k_levels)
        if (runs(level))
            methods.push_back({.run = [&view, &points, &sampling, level](Winds& winds) {
                on_level(view, level).felt(points, sampling, winds);
            }});
    contest(name, seconds, methods);
}

Wind wind_of(const Config& config) {
    auto wind = Wind::create(config);
    if (!wind) {
        std::fprintf(stderr, "%s\n", wind.error().c_str());
        std::exit(1);
    }
    std::vector<glm::vec4> field(wind->box().cell_count());
    test::Random random(3);
    for (glm::vec4& cell : field)
        cell = glm::vec4(random.vector(5.0f), 0.0f);
    if (!wind->set_velocity(field))
        std::exit(1);
    return *std::move(wind);
}

// A field into halves: one number after another, and by the library.
void halves(double seconds) {
    std::vector<glm::vec4> field(64 * 32 * 64);
    test::Random random(4);
    for (glm::vec4& cell : field)
        cell = glm::vec4(random.vector(20.0f), 0.0f);
    std::vector<std::uint16_t> one(4 * field.size()), all(4 * field.size());
    double by_one = 1e30, by_all = 1e30;
    for (double spent = 0.0; spent < seconds;) {
        const double first = time_of([&] {
            for (std::size_t n = 0; n < field.size(); ++n)
                for (int axis = 0; axis < 4; ++axis)
                    one[4 * n + std::size_t(axis)] = axis < 3 ? to_half(field[n][axis]) : std::uint16_t{0};
        });
        const double second = time_of([&] { pack_vectors(field, all); });
        by_one = std::min(by_one, first);
        by_all = std::min(by_all, second);
        spent += first + second;
    }
    std::printf("\n64 x 32 x 64 cells as halves (%.1f MB): %.2f ms by to_half, %.3f ms by pack_vectors, the same bits: %s\n",
                double(all.size()) * 2e-6, 1e3 * by_one, 1e3 * by_all, one == all ? "yes" : "NO");
}

} // namespace

int main(int count, char** arguments) {
    const double seconds = count > 1 ? std::atof(arguments[1]) : 1.0;
    std::printf("ns a point, 10,000 points, box of 32 x 16 x 32 cells of 1 m unless it is named\n\n| %-34s | plain  | single |",
                "case");
    std::string rule = "|---|---|---|";
    for (const Simd level : k_levels)
        if (runs(level)) {
            std::printf(" %s |", name_of(level));
            rule += "---|";
        }
    std::printf(" times | apart | single = list |\n%s---|---|---|\n", rule.c_str());

    const Config open{.boundaries = Boundaries::open_over_floor(), .ambient = {4.0f, 0.0f, 1.0f}};
    Config gusty = open, profiled = open, rows = open, ring = open, large = open;
    profiled.profile = LogProfile{};
    gusty.profile = LogProfile{};
    gusty.gusts = {.intensity = 0.3f};
    rows.rows.emplace();
    ring.boundaries = Boundaries::all(BoundaryKind::periodic);
    large.cells = {128, 64, 128};
    const Wind wide = wind_of(large);
    const Wind wind = wind_of(open), calm = wind_of(profiled), windy = wind_of(gusty), thin = wind_of(rows),
               round = wind_of(ring);
    const glm::dvec3 floor(0.0, wind.origin().y, 0.0), corner = floor + glm::dvec3(-5.0, 0.0, -5.0),
                                                       outside = floor + glm::dvec3(100.0, 0.0, 40.0),
                                                       low = floor + glm::dvec3(-16.0, 0.0, -16.0);
    const List near = meadow(corner, 10.0), whole = meadow(low, 32.0), far = meadow(outside, 10.0);
    velocities("inside, in order", seconds, wind, near);
    velocities("inside, shuffled", seconds, wind, shuffled(near));
    velocities("whole box, in order", seconds, wind, whole);
    velocities("whole box, shuffled", seconds, wind, shuffled(whole));
    velocities("whole box, gusts, profile", seconds, windy, whole);
    const List all = meadow({-64.0, wide.origin().y, -64.0}, 128.0);
    velocities("128 x 64 x 128, in order", seconds, wide, all);
    velocities("128 x 64 x 128, anywhere", seconds, wide, scattered(wide));
    velocities("rows of their own", seconds, thin, near);
    velocities("periodic", seconds, round, near);
    velocities("outside", seconds, wind, far);
    velocities("outside, profile", seconds, calm, far);
    velocities("outside, gusts, profile", seconds, windy, far);
    velocities("outside, gusts, profile, shuffled", seconds, windy, shuffled(far));
    felt("felt, inside", seconds, windy, near, {});
    felt("felt with detail, inside", seconds, windy, near, {.detail = 0.3f});
    halves(seconds);
    return 0;
}
