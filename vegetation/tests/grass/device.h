// A field on a device under the validation layer, which must stay silent.
#pragma once

#include "tests/parity/gpu.h"
#include "vegetation/grass/grass_field.h"
#include "vegetation/tests/grass/fields.h"

#include <memory>
#include <vector>

namespace windrow::vegetation::grass::test {

class GrassOnTheDevice : public windrow::vulkan::Gpu {
  protected:
    /// The hills and glades of fields.h.
    void make_field(const GrassSettings& settings = small_field()) {
        if (!renders)
            renders = engine::must(engine::Device::adopt(own->host(), own->queue()));
        auto made = GrassField::create(*renders, heights, mask, settings);
        ASSERT_TRUE(made) << made.error();
        field = std::make_unique<GrassField>(*std::move(made));
    }
    void TearDown() override {
        field.reset();
        renders.reset();
        Gpu::TearDown();
    }

    /// Records the cull of a frame whose anchor is the field's corner, and waits.
    GrassReport cull(const GrassCamera& camera) {
        GrassReport report;
        run([&](VkCommandBuffer commands) {
            auto done = field->record_cull(commands, camera);
            EXPECT_TRUE(done) << done.error();
            if (done)
                report = *done;
        });
        return report;
    }

    /// A whole buffer of the field's, as values.
    template <class Value>
    std::vector<Value> values_of(VkBuffer from, std::size_t count) {
        return engine::must(renders->read<Value>(from, 0, count));
    }
    [[nodiscard]] std::size_t places() const {
        return static_cast<std::size_t>(field->settings().chunk_cells) * static_cast<std::size_t>(field->settings().chunk_cells);
    }
    [[nodiscard]] std::size_t slots() const { return static_cast<std::size_t>(field->settings().max_chunks); }
    std::vector<VkDrawIndirectCommand> draws() { return values_of<VkDrawIndirectCommand>(field->draw_buffer(), 4 * slots()); }

    HeightMap heights = hills();
    PlacementMask mask = glades(heights);
    std::unique_ptr<engine::Device> renders; ///< the fixture's device, lent to the renderer
    std::unique_ptr<GrassField> field;
};

} // namespace windrow::vegetation::grass::test
