// A wind on a device inside another wind: the cells of the CPU's, with what stands in the outer box and reaches the inner one; saved
// and loaded; read beyond the box.
#include "tests/parity/wind_parity.h"

#include <array>
#include <glm/geometric.hpp>
#include <memory>
#include <vector>

namespace windrow::vulkan {
namespace {

enum class Stands : std::uint8_t { nothing, bush, block };
constexpr const char* k_names[] = {"nothing", "bush", "block"};

class WindLevels : public WindParity {
  protected:
    static constexpr double k_frame = 1.0 / 30.0;

    static std::shared_ptr<windrow::Wind> around(bool gusts) {
        auto made = windrow::Wind::create({.cells = {20, 8, 20},
                                           .cell_size = 2.0f,
                                           .boundaries = Boundaries::open_over_floor(),
                                           .ambient = {6.0f, 0.0f, 1.0f},
                                           .profile = LogProfile{},
                                           .gusts = {.intensity = gusts ? 0.2f : 0.0f},
                                           .ticks = {.hz = 10.0}});
        EXPECT_TRUE(made) << made.error();
        return std::make_shared<windrow::Wind>(*std::move(made));
    }
    static Config inside() { return {.cells = {16, 8, 14}, .boundaries = Boundaries::open_over_floor()}; }

    /// Before the inner box and across its boundary, so that most of what it does comes in. In both levels, as a scene has it.
    template <class AnyWind>
    static void put(AnyWind& wind, Stands what) {
        if (what == Stands::bush) {
            EXPECT_TRUE(wind.drag().add(
                PlantDrag{.position = {-9.0, 0.0, 0.0}, .radius = 3.0f, .height = 4.0f, .area = 40.0f}));
        } else if (what == Stands::block) {
            EXPECT_TRUE(wind.obstacles().add({.position = {-8.0, 2.0, 1.0}, .shape = Block{glm::vec3(2.0f)}}));
        }
    }
    static void add_fan(windrow::Wind& outer) {
        EXPECT_TRUE(outer.motors().add(
            DirectionalMotor{.position = {-13.0, 3.0, 2.0}, .region = Sphere{5.0f}, .law = Drive{.speed = 9.0f}}));
    }
};

// Twelve frames of 1/30 s, of which each third has a tick of the outer wind; half a second of it came before.
TEST_F(WindLevels, HaveTheCellsOfTheCpu) {
    for (const Stands what : {Stands::nothing, Stands::bush, Stands::block})
        for (const bool gusts : {false, true})
            for (const bool shifts : {false, true}) {
                const auto outer = around(gusts);
                put(*outer, what);
                add_fan(*outer);
                for (int n = 0; n < 15; ++n)
                    (void)outer->advance(k_frame);
                TwoWinds pair = make(inside(), 0, {.texel = Texel::single}, outer);
                put(pair.cpu, what);
                put(pair.device, what);
                windrow::Wind alone = *windrow::Wind::create(
                    [&] {
                        Config config = inside();
                        config.ambient = outer->config().ambient;
                        config.profile = outer->config().profile;
                        config.gusts = outer->config().gusts;
                        return config;
                    }());
                put(alone, what);
                for (int n = 0; n < 12; ++n) {
                    (void)outer->advance(k_frame);
                    if (shifts) {
                        pair.follow({0.3 * n, 0.0, -0.2 * n});
                        EXPECT_TRUE(alone.follow({0.3 * n, 0.0, -0.2 * n}));
                    }
                    frame(pair, k_frame);
                    (void)alone.advance(k_frame);
                }
                step(pair, k_frame); // compares the last frame
                EXPECT_EQ(pair.compared, 12);
                report(std::string("levels.") + k_names[static_cast<int>(what)] + (gusts ? ".gusts" : "") +
                           (shifts ? ".shifts" : ""),
                       pair, 1e-5);
                const auto view = pair.cpu.view();
                EXPECT_GT(apart(alone.field(), view.field()), 0.1) << "the outer wind does nothing";
            }
}

} // namespace
} // namespace windrow::vulkan
