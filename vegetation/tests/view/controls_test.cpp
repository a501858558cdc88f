// Each control of the window has the bounds and the words of its row, and each row has a control.
#include "fluid/config.h"
#include "fluid/debug_draw.h"
#include "vegetation/view/controls.h"

#include <gtest/gtest.h>
#include <imgui.h>

namespace windrow::vegetation::view {
namespace {

/// Draws the controls of a value in a window of no display.
template <class Value>
std::vector<ControlRecord> controls_of(Value value) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {400.0f, 400.0f};
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    ImGui::NewFrame();
    std::vector<ControlRecord> records;
    control_records = &records;
    EXPECT_FALSE(edit(value)); // nobody touched anything
    control_records = nullptr;
    ImGui::Render();
    ImGui::DestroyContext();
    return records;
}

/// What the table says, in the order of the controls: its own walk over the rows, which knows numbers alone.
struct Expected {
    std::string name, meaning;
    double min, max;
};
template <class Value>
void expect_rows(const Value& value, std::vector<Expected>& rows);

template <class Member>
void expect_member(const char* name, const Member& member, const Range& range, const char* meaning, std::vector<Expected>& rows) {
    using windrow::detail::k_is_optional, windrow::detail::k_is_variant;
    if constexpr (k_is_optional<Member>) {
        if (member)
            expect_member(name, *member, range, meaning, rows);
    } else if constexpr (k_is_variant<Member>) {
        std::visit([&](const auto& kind) { expect_rows(kind, rows); }, member);
    } else if constexpr (HasSettings<Member>) {
        expect_rows(member, rows);
    } else if constexpr (std::is_same_v<Member, float> || std::is_same_v<Member, double> || std::is_same_v<Member, int> ||
                         std::is_same_v<Member, std::uint32_t>) {
        rows.push_back({name, meaning, range.min, range.max});
    }
}

template <class Value>
void expect_rows(const Value& value, std::vector<Expected>& rows) {
    for_each_setting(value, [&]<class Row>(const Row& row, const auto& member) {
        if constexpr (Row::k_stored == Stored::everywhere)
            expect_member(row.name, member, row.range, row.meaning, rows);
    });
}

template <class Value>
void expect_controls(const Value& value) {
    std::vector<Expected> rows;
    expect_rows(value, rows);
    const auto records = controls_of(value);
    std::size_t at = 0;
    for (const Expected& row : rows) {
        while (at < records.size() && records[at].name != row.name)
            ++at;
        ASSERT_LT(at, records.size()) << "no control for " << row.name;
        const ControlRecord& record = records[at++];
        EXPECT_NE(record.text.find(row.meaning), std::string::npos) << row.name;
        EXPECT_TRUE(record.bounded) << row.name;
        // A bound beyond what the type holds is that of the type.
        const auto near = [](double bound, double given) {
            return std::abs(given) > 1e8 || std::abs(bound - given) <= 1e-6 * std::abs(given);
        };
        EXPECT_TRUE(near(record.min, row.min)) << row.name << " from " << record.min << ", the table has " << row.min;
        EXPECT_TRUE(near(record.max, row.max)) << row.name << " to " << record.max << ", the table has " << row.max;
    }
    EXPECT_GT(rows.size(), 0u);
}

TEST(Controls, OfEachKindOfMotorHaveTheRangesOfTheTable) {
    expect_controls(DirectionalMotor{.region = Cone{}, .law = Force{}});
    expect_controls(DirectionalMotor{.region = Capsule{}, .law = Drive{}});
    expect_controls(WakeMotor{});
    expect_controls(JetMotor{});
    expect_controls(VortexMotor{});
    expect_controls(OmniMotor{});
    expect_controls(PressureMotor{});
}

TEST(Controls, OfTheAirAndItsBodiesHaveTheRangesOfTheTable) {
    Config air;
    air.profile.emplace();
    air.canopy.emplace();
    expect_controls(air);
    expect_controls(Obstacle{.shape = Cylinder{}});
    expect_controls(DebugDraw{});
}

TEST(Controls, SayRangeUnitAndWhatZeroMeans) {
    EXPECT_EQ(range_text({0.0, 1.0, "m"}), "0 to 1 m");
    EXPECT_EQ(range_text(Range::above(0.0, 1e6, "m")), "above 0 to 1e+06 m");
    EXPECT_EQ(range_text({.min = 0.0, .max = 1.0, .zero = "none"}), "0 to 1; 0: none");
    EXPECT_EQ(range_text({}), "any number");
}

} // namespace
} // namespace windrow::vegetation::view
