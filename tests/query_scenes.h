// Winds to ask for points: every boundary kind, blend zones, rows of their own, gusts, a profile, a box far away; and lists of
// points in and around them.
#pragma once

#include "tests/tier.h"
#include "tests/winds.h"

#include <bit>
#include <cstdint>

namespace windrow::test {

struct QueryScene {
    std::string name;
    Config config{};
};

inline constexpr Sampling k_rippled{.strength = 1.25f, .limit = 7.0f, .detail = 0.4f, .detail_length = 0.7f};

/// Cells of half a metre, so that places in cells are exact, except in the last.
inline std::vector<QueryScene> query_scenes() {
    const Config base{.cells = {21, 13, 17}, .cell_size = 0.5f, .centre = {3.0, -2.0, 1.0}, .ambient = {4.0f, -1.0f, 2.0f}};
    const auto boundaries = [&](BoundaryKind kind) {
        return with(base, [&](Config& c) { c.boundaries = Boundaries::all(kind); });
    };
    const auto over_floor = with(base, [](Config& c) { c.boundaries = Boundaries::open_over_floor(); });
    return {{"open", base},
            {"no_blend_zone", with(base, [](Config& c) { c.blend_width = 0.0f; })},
            {"wide_blend_zone", with(base, [](Config& c) { c.blend_width = 5.0f; })},
            {"free_slip", boundaries(BoundaryKind::free_slip)},
            {"no_slip", boundaries(BoundaryKind::no_slip)},
            {"periodic", boundaries(BoundaryKind::periodic)},
            {"mixed", with(base,
                           [](Config& c) {
                               c.boundaries = {.x_low = {BoundaryKind::no_slip}, .y_low = {BoundaryKind::free_slip}};
                               c.boundaries.z_low.kind = c.boundaries.z_high.kind = BoundaryKind::periodic;
                           })},
            {"rows", with(over_floor, [](Config& c) { c.rows.emplace(Rows{.first = 0.2f, .uniform = 2, .ratio = 1.25f}); })},
            {"most_rows", with(over_floor,
                               [](Config& c) {
                                   c.cells = {9, k_max_rows, 7};
                                   c.rows.emplace(Rows{.first = 0.1f, .uniform = 3, .ratio = 1.02f});
                               })},
            {"profile", with(over_floor, [](Config& c) { c.profile.emplace(); })},
            {"gusts", with(over_floor, [](Config& c) { c.gusts = {.intensity = 0.4f, .length = 7.0f}; })},
            {"gusts_profile_rows", with(over_floor,
                                        [](Config& c) {
                                            c.profile.emplace();
                                            c.gusts = {.intensity = 0.4f};
                                            c.rows.emplace();
                                        })},
            {"one_cell", with(base, [](Config& c) { c.cells = glm::ivec3(1, 6, 1); })},
            {"million_metres_away", with(over_floor,
                                         [](Config& c) {
                                             c.centre = glm::dvec3(1e6, 3.0, -1e6);
                                             c.gusts = {.intensity = 0.4f};
                                         })},
            {"cells_of_0.3", with(over_floor, [](Config& c) { c.cell_size = 0.3f; })}};
}

inline Wind noisy(const QueryScene& scene) {
    Wind wind = made(scene.config);
    (void)wind.follow(scene.config.centre + glm::dvec3(1.3, 0.0, -2.4)); // where it follows
    EXPECT_TRUE(wind.set_velocity(white_noise(scene.config.cells, 5.0f, 81)));
    return wind;
}

/// Inside, about the ends of the box, far away, beside and at the centres and faces of cells; some that are not finite.
inline std::vector<glm::dvec3> points_of(const QueryScene& scene, const Wind& wind, int count) {
    Random random(97);
    std::vector<glm::dvec3> points;
    const glm::dvec3 extent(wind.box().size()), origin = wind.origin();
    constexpr double k_none[] = {std::numeric_limits<double>::quiet_NaN(),
                                 std::numeric_limits<double>::infinity(),
                                 -std::numeric_limits<double>::infinity(),
                                 1.7e308,
                                 -1e300,
                                 1e39};
    for (int n = 0; n < count; ++n) {
        const int kind = n / 24 % 8; // groups of one kind, and groups of two
        const double margin = kind < 4 ? -0.3 : kind == 4 ? 0.1 : kind == 5 ? 3.0 : 0.05;
        glm::dvec3 point;
        for (int axis = 0; axis < 3; ++axis)
            point[axis] = origin[axis] + random.real(-margin * extent[axis], (1.0 + margin) * extent[axis]);
        if (kind == 6) // on a face or a centre
            for (int axis = 0; axis < 3; ++axis)
                point[axis] = origin[axis] + 0.5 * double(scene.config.cell_size) * std::round(point[axis] - origin[axis]);
        if (kind == 7 && n % 3 == 0)
            point += random.direction() * random.spread(10.0, 1e9);
        if (n % 97 == 50)
            point[n % 3] = k_none[n / 97 % 6];
        points.push_back(point);
    }
    return points;
}

} // namespace windrow::test
