// Metres a second that mean something: how plants stand in the winds of Beaufort's scale.
#include "coupling/drag.h"
#include "coupling/plant_classes.h"
#include "fluid/ambient.h"
#include "tests/figure.h"

#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <string>

namespace windrow {
namespace {

constexpr double k_beaufort_degrees = 180.0 / 3.14159265358979323846;

struct Plant {
    const char* name;
    Drag drag;
    double height; // [m] where it meets the wind
};

// The scale's winds are those at 10 m over open ground; a plant meets less, by the profile of short grass.
double at_height(double wind, double height) {
    const auto air = AmbientWind::create({.mean = {static_cast<float>(wind), 0.0f, 0.0f}, .profile = LogProfile{}});
    return static_cast<double>(air->velocity({0.0, height, 0.0}).x);
}

double lean(const Plant& plant, double wind) {
    return static_cast<double>(bend_angle(plant.drag, static_cast<float>(at_height(wind, plant.height)))) * k_beaufort_degrees;
}

// [m] How far the tip moves from calm: L Ca / 8 for small bends, by 0.75 of the tip's angle; the arc's chord for large ones.
double tip_way(const Plant& plant, double wind) {
    return 0.75 * static_cast<double>(plant.drag.length) * lean(plant, wind) / k_beaufort_degrees;
}

const Plant k_plants[] = {{"grass", grass(), 0.2},
                          {"wheat", wheat(), 0.6},
                          {"reed", reed(), 1.5},
                          {"leaf", leaf(), 5.0},
                          {"twig", twig(), 5.0},
                          {"branch", branch(), 6.0},
                          {"small_trunk", small_trunk(), 6.0},
                          {"large_trunk", large_trunk(), 14.0}};
// Middles of the scale's classes 1 to 10. [m/s]
constexpr double k_winds[] = {0.9, 2.4, 4.4, 6.7, 9.3, 12.3, 15.5, 18.9, 22.6, 26.4};

TEST(Beaufort, TheTableOfBends) {
    std::printf("%-12s", "degrees");
    for (int force = 1; force <= 10; ++force)
        std::printf(" %6d", force);
    std::printf("\n");
    for (const Plant& plant : k_plants) {
        std::printf("%-12s", plant.name);
        double before = 0.0;
        for (int force = 1; force <= 10; ++force) {
            const double angle = lean(plant, k_winds[force - 1]);
            std::printf(" %6.1f", angle);
            EXPECT_GT(angle, before);
            EXPECT_LT(angle, 90.0);
            before = angle;
        }
        std::printf("\n");
        for (const int force : {2, 5, 8})
            test::figure(std::string("plants/beaufort/") + plant.name + "/force_" + std::to_string(force) + "_degrees",
                         lean(plant, k_winds[force - 1]));
    }
}

// The scale's words: 2 leaves rustle; 3 leaves and small twigs in constant motion; 4 small branches move; 5 small trees in leaf
// begin to sway; 7 whole trees in motion. An eye sees a tip move by about 1 % of what it looks at (a third of a degree from ten
// lengths away is more than ten times what it resolves): the first force at which steady wind moves the tip by that may not lie
// beyond the scale's, nor, since gusts swing plants by about as much again, may the tip move by more than a tenth of its length
// two forces below.
TEST(Beaufort, PlantsMoveWhereTheScaleSaysThatTheyDo) {
    struct Word {
        Plant plant;
        int force;
    };
    const Word words[] = {{k_plants[3], 2}, {k_plants[4], 3}, {k_plants[5], 4}, {k_plants[6], 5}, {k_plants[7], 7}};
    for (const Word& word : words) {
        const double length = static_cast<double>(word.plant.drag.length);
        const double there = tip_way(word.plant, k_winds[word.force - 1]) / length;
        const std::string name = std::string("plants/beaufort/") + word.plant.name;
        test::figure(name + "/way_of_the_tip_over_length_where_the_scale_sees_it", there);
        EXPECT_GE(there, 0.01) << word.plant.name;
        const double below = word.force > 2 ? tip_way(word.plant, k_winds[word.force - 3]) / length : 0.0;
        WINDROW_EXPECT_FIGURE(name + "/way_two_forces_below", below, 0.1);
    }
}

TEST(Beaufort, TheClassesKeepTheirOrder) {
    // What bends first in a breeze: grass before wheat, twigs before branches, trunks last.
    const double breeze = 4.4;
    EXPECT_GT(lean(k_plants[0], breeze), lean(k_plants[1], breeze));
    EXPECT_GT(lean(k_plants[4], breeze), lean(k_plants[5], breeze));
    EXPECT_GT(lean(k_plants[5], breeze), lean(k_plants[6], breeze));
    EXPECT_GT(lean(k_plants[6], breeze), lean(k_plants[7], breeze));
}

} // namespace
} // namespace windrow
