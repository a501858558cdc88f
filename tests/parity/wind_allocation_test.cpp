// Lives of a wind on a device in which an allocation of the library fails, at many places: no exception leaves a call, creation and changes
// return an error, the recordings that follow are valid, and nothing leaks. Allocations of the driver are left alone.
#include "fluid/vulkan/wind.h"
#include "tests/figure.h"
#include "tests/parity/gpu.h"
#include "tests/tier.h"
#include "tests/unit/counted_new.h"

namespace windrow::vulkan {
namespace {

using windrow::test::Failing;
using windrow::test::FailingMemory;
using windrow::test::Whose;

class WindAllocations : public Gpu {
  protected:
    static constexpr glm::ivec3 k_cells{8, 6, 8};

    std::optional<Wind> wind;
    int rejected = 0; ///< calls that returned an error

    template <class Done>
    void note(const Done& done) {
        rejected += done ? 0 : 1;
    }

    // Each call may fail; what was recorded before and after must run.
    void live() {
        auto made = Wind::create(own->host(), {.cells = k_cells, .ambient = {2.0f, 0.0f, 0.0f}, .viscosity = 1.0f},
                                 {.gusts = true, .queries = ReadBack::points});
        note(made);
        if (!made)
            return;
        wind.emplace(*std::move(made));
        note(wind->motors().add(OmniMotor{.position = {1.0, 0.0, 1.0}}));
        note(wind->set_velocity(start_));
        for (int frame = 0; frame < 3; ++frame) {
            note(wind->follow({2.7 * frame, 0.0, 0.0}));
            note(wind->set_ambient({2.0f, 0.0f, 1.0f * static_cast<float>(frame)}));
            if (frame == 1) {
                note(wind->set_boundaries(Boundaries::open_over_floor()));
                note(wind->set_gusts({.intensity = 0.2f, .tile = GustTile::standard()}));
            }
            if (frame == 2)
                wind->reset();
            frame_ = frame;
            own->run(record_).has_value() ? void() : void(++rejected);
        }
        (void)wind->collect(0);
        note(wind->saved());
        (void)wind->queried_points();
    }

  private:
    int frame_ = 0;
    const std::array<glm::dvec3, 2> points_{};
    const std::vector<glm::vec4> start_ =
        std::vector<glm::vec4>(static_cast<std::size_t>(k_cells.x * k_cells.y * k_cells.z), glm::vec4(1.0f));
    // Made once: a function that is made again would be one more allocation, of the test's.
    const std::function<void(VkCommandBuffer)> record_ = [this](VkCommandBuffer commands) {
        note(wind->record(commands, {.dt = 1.0 / 30.0, .slot = frame_ % 2, .points = points_, .save = frame_ == 2}));
    };
};

TEST_F(WindAllocations, EachThatFailsLeavesTheWindUsable) {
    const auto tile = GustTile::standard();
    live();
    ASSERT_EQ(rejected, 0);
    wind.reset();
    const int stride = test::whole_sweeps() ? 37 : 997; // of some 4,300 allocations; a life takes 0.2 s and more
    int failures = 0, seen = 0;
    for (const Failing failing : {Failing::once, Failing::from_then_on})
        for (int after = failing == Failing::once ? 0 : stride / 2, failed = 1; failed != 0; after += stride) {
            rejected = 0;
            bool threw = false;
            {
                const FailingMemory memory(after, failing, Whose::of_the_program);
                try {
                    live();
                } catch (...) {
                    threw = true;
                }
                failed = memory.failed() ? 1 : 0;
            }
            ASSERT_FALSE(threw) << "an exception left a call after " << after << " allocations";
            failures += failed;
            seen += rejected > 0 ? 1 : 0;
            if (wind) { // it goes on
                run([&](VkCommandBuffer commands) { held(wind->record(commands, {.dt = 1.0 / 30.0})); });
                EXPECT_TRUE(wind->set_ambient({1.0f, 0.0f, 0.0f}));
            }
            wind.reset();
        }
    test::figure("failed_allocations", failures);
    test::figure("of which a call reported", seen);
}

} // namespace
} // namespace windrow::vulkan
