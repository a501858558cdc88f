// Descriptions that cannot be used: one sentence for each field, with its value and what to give.
#include "coupling/blade.h"
#include "coupling/shell.h"
#include "coupling/tree.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <string>

namespace windrow {
namespace {

constexpr float k_infinite = std::numeric_limits<float>::infinity();
const float k_nan = std::nanf("");

template <class Settings, class Member>
void rejects(const char* field, Member member, std::initializer_list<float> values) {
    for (const float value : values) {
        Settings settings{};
        member(settings) = value;
        const auto result = validate(settings);
        ASSERT_FALSE(result) << field << " " << value;
        EXPECT_NE(result.error().find(field), std::string::npos) << result.error();
        EXPECT_NE(result.error().find(": give "), std::string::npos) << result.error();
        EXPECT_EQ(result.error().find('\n'), std::string::npos) << result.error(); // one fault, one sentence
    }
}

#define FIELD(Settings, name) #name, [](Settings & settings) -> float& { return settings.name; }

TEST(PlantRejection, Drag) {
    rejects<Drag>(FIELD(Drag, length), {0.0f, -1.0f, 1e9f, k_nan, k_infinite});
    rejects<Drag>(FIELD(Drag, width), {0.0f, -1.0f, k_nan, k_infinite});
    rejects<Drag>(FIELD(Drag, rigidity), {0.0f, -1.0f, k_nan, k_infinite});
    rejects<Drag>(FIELD(Drag, drag_coefficient), {-0.1f, 11.0f, k_nan});
    rejects<Drag>(FIELD(Drag, air_density), {-0.1f, k_nan, k_infinite});
    rejects<Drag>(FIELD(Drag, vogel_exponent), {0.1f, -3.0f, k_nan});
    rejects<Drag>(FIELD(Drag, vogel_speed), {0.0f, -3.0f, k_nan});
    rejects<Drag>(FIELD(Drag, max_bend), {-0.1f, 2.6f, k_nan});
    EXPECT_TRUE(validate(Drag{.drag_coefficient = 0.0f}));
}

TEST(PlantRejection, Blades) {
    rejects<BladeSettings>(FIELD(BladeSettings, stalk.length), {0.0f, k_nan});
    rejects<BladeSettings>(FIELD(BladeSettings, length_spread), {-0.1f, 1.0f, k_nan});
    rejects<BladeSettings>(FIELD(BladeSettings, width), {-0.1f, 1e9f, k_nan});
    rejects<BladeSettings>(FIELD(BladeSettings, tip_width), {-0.1f, 1.1f, k_nan});
    rejects<BladeSettings>(FIELD(BladeSettings, taper), {0.0f, -1.0f, 11.0f, k_nan});
    rejects<BladeSettings>(FIELD(BladeSettings, along_wind), {-0.1f, 1.1f, k_nan});
    rejects<BladeSettings>(FIELD(BladeSettings, stiffness_spread), {-0.1f, 1.0f, k_nan});
    rejects<BladeSettings>(FIELD(BladeSettings, rest_bend), {-3.1f, 3.1f, k_nan});
    rejects<BladeSettings>(FIELD(BladeSettings, rest_bend_spread), {-0.1f, 3.1f, k_nan});
    rejects<BladeSettings>(FIELD(BladeSettings, rest_curve), {-0.1f, 1.1f, k_nan});
    rejects<BladeSettings>(FIELD(BladeSettings, view_bend), {-0.1f, 3.1f, k_nan});
    EXPECT_FALSE(Blades::create({.width = k_nan}));
}

TEST(PlantRejection, Shells) {
    rejects<ShellSettings>(FIELD(ShellSettings, length), {0.0f, -1.0f, 1e9f, k_nan});
    rejects<ShellSettings>(FIELD(ShellSettings, spacing), {0.0f, -1.0f, k_nan});
    rejects<ShellSettings>(FIELD(ShellSettings, bias), {-0.1f, 1.1f, k_nan});
    rejects<ShellSettings>(FIELD(ShellSettings, push), {-1e9f, k_infinite, k_nan});
    rejects<ShellSettings>(FIELD(ShellSettings, push_exponent), {0.0f, -1.0f, k_nan});
    rejects<ShellSettings>(FIELD(ShellSettings, droop), {-0.1f, k_infinite, k_nan});
    rejects<ShellSettings>(FIELD(ShellSettings, droop_shape), {0.0f, -1.0f, 1e4f, k_nan});
    rejects<ShellSettings>(FIELD(ShellSettings, sag), {-0.1f, 1.6f, k_nan});
    rejects<ShellSettings>(FIELD(ShellSettings, strand.rigidity), {0.0f, k_nan});
    for (const int count : {-1, 0, 1, 5000})
        EXPECT_FALSE(validate(ShellSettings{.shells = count}));
    for (const glm::vec3 down : {glm::vec3(0.0f), glm::vec3(k_nan), glm::vec3(k_infinite, 0.0f, 0.0f)})
        EXPECT_FALSE(validate(ShellSettings{.down = down}));
    EXPECT_TRUE(validate(ShellSettings{.strand = {.length = k_nan}})); // replaced by the shells' own
}

TEST(PlantRejection, Trees) {
    rejects<TreeClasses>(FIELD(TreeClasses, trunk.length), {0.0f, k_nan});
    rejects<TreeClasses>(FIELD(TreeClasses, branch.width), {0.0f, k_nan});
    rejects<TreeClasses>(FIELD(TreeClasses, leaf.rigidity), {0.0f, k_nan});
    EXPECT_TRUE(validate(TreePart{}));
    EXPECT_TRUE(validate(TreePart{.stiffness = 1.0f}));
    EXPECT_FALSE(validate(TreePart{.root = glm::vec3(k_nan), .stiffness = 1.0f}));
    EXPECT_FALSE(validate(TreePart{.axis = {0.0f, 2.0f, 0.0f}, .stiffness = 1.0f}));
    EXPECT_FALSE(validate(TreePart{.length = 0.0f, .stiffness = 1.0f}));
    EXPECT_FALSE(validate(TreePart{.stiffness = -1.0f}));
    EXPECT_FALSE(validate(TreePart{.stiffness = k_nan}));
}

TEST(PlantRejection, TellsEveryReason) {
    const auto made = Blades::create({.stalk = {.length = -1.0f, .rigidity = 0.0f}, .taper = 0.0f});
    ASSERT_FALSE(made);
    for (const char* field : {"blades.stalk.length", "blades.stalk.rigidity", "blades.taper"})
        EXPECT_NE(made.error().find(field), std::string::npos) << made.error();
}

} // namespace
} // namespace windrow
