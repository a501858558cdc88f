#include "fluid/vulkan/fields.h"

#include "fluid/core/message.h"
#include "fluid/vulkan/blocks.h"
#include "fluid/vulkan/passes.h"

#include <string>

namespace windrow::vulkan {
namespace {

constexpr VkDeviceSize k_step_blocks = 16;  // of a slot: some ticks, and changes between them
constexpr VkDeviceSize k_motors_area = 128; // of a slot

} // namespace

Result<Fields> Fields::create(Device& device, const Sizes& sizes) {
    Fields fields;
    Result<void> made_all;
    const auto make = [&](Buffer& buffer, const char* name, VkDeviceSize bytes, MemoryUse use = MemoryUse::device) {
        if (!made_all)
            return;
        auto made = Buffer::create(device, bytes, use);
        if (!made) {
            made_all = made.failure().after(detail::message("The field ", name, " of ", sizes.cells.x, " x ", sizes.cells.y,
                                                            " x ", sizes.cells.z, " cells was not made: "));
            return;
        }
        buffer = *std::move(made);
        device.name(VK_OBJECT_TYPE_BUFFER, buffer.handle(), name);
    };
    const auto count = [](glm::ivec3 cells) {
        return static_cast<VkDeviceSize>(cells.x) * static_cast<VkDeviceSize>(cells.y) * static_cast<VkDeviceSize>(cells.z);
    };
    const VkDeviceSize cells = count(sizes.cells), padded = count(sizes.cells + WINDROW_HALO);
    const auto axes = static_cast<VkDeviceSize>(sizes.cells.x + sizes.cells.y + sizes.cells.z + 3 * WINDROW_HALO);

    const auto padded_rows = [](glm::ivec3 size) { return static_cast<VkDeviceSize>(size.y + WINDROW_HALO); };
    const auto make_blocks = [&](HostBlocks& blocks, const char* name, VkDeviceSize area, VkDeviceSize block) {
        if (!made_all)
            return;
        auto made = HostBlocks::create(device, sizes.slots, area, block);
        if (!made) {
            made_all = made.failure().after(detail::message("The blocks of the ", name, " were not made: "));
            return;
        }
        blocks = *std::move(made);
        device.name(VK_OBJECT_TYPE_BUFFER, blocks.buffer().handle(), name);
    };
    const VkDeviceSize step = sizeof(WindrowStep) + (sizes.rows ? padded_rows(sizes.cells) * sizeof(WindrowRow) : 0);
    make_blocks(fields.step, "step", k_step_blocks * step, step);
    make(fields.control, "control", sizeof(WindrowControl));
    make(fields.shapes, "shapes", 4 * (1 + 3 * k_max_stages));
    make(fields.commands, "commands", sizes.commands * sizeof(VkDispatchIndirectCommand));
    make(fields.rules, "rules", 2 * axes * sizeof(WindrowRule)); // boundary rules of viscosity and of transport
    make_blocks(fields.motors, "motors", k_motors_area * sizeof(WindrowMotor), k_max_motors * sizeof(WindrowMotor));
    make(fields.tables, "tables", sizes.table_floats * sizeof(float));
    // Motors' eddies are read from it too.
    make(fields.tile, "tile", (VkDeviceSize{128} * 16 * 128 + (sizes.outer ? 2 * padded : 0)) * sizeof(vec4), MemoryUse::shared);
    // A field above this travels in the command buffer, as one that finds no room does.
    constexpr VkDeviceSize k_most_staged = VkDeviceSize{64} << 20;
    if (const VkDeviceSize field = padded * sizeof(vec4); sizes.outer)
        make_blocks(fields.outer, "outer wind", field <= k_most_staged ? field : 0, sizeof(vec4));
    make(fields.velocity, "velocity", 2 * cells * sizeof(vec4));
    make(fields.history, "history", cells * sizeof(vec4));
    make(fields.force, "force", cells * sizeof(vec4));
    make(fields.drives, "drives", cells * sizeof(vec4));
    make(fields.source_flow, "source_flow", cells * sizeof(vec4));
    make(fields.arrived, "arrived", cells * sizeof(vec4));
    make(fields.diffused, "diffused", sizes.diffuses ? cells * sizeof(vec4) : sizeof(vec4));
    make(fields.before, "before", cells * sizeof(vec4));
    make(fields.padded, "padded", (sizes.gusts ? 3 : 2) * padded * sizeof(vec4));
    make(fields.expansion, "expansion", cells * sizeof(float));
    make(fields.hat, "hat", cells * sizeof(float));
    make(fields.hat_x, "hat_x", sizes.slabs ? cells * sizeof(float) : sizeof(vec4));
    make(fields.potential, "potential", cells * sizeof(float));
    make(fields.sums, "sums", sizes.sums * sizeof(glm::vec2));
    make(fields.solids, "solids", sizeof(WindrowSolids) + sizeof(vec4));
    make(fields.drag, "drag", sizeof(vec4));
    make(fields.reading, "reading", sizeof(WindrowReading));
    make(fields.around, "around", sizeof(WindrowAround) + sizeof(vec4));
    make(fields.correction, "correction", sizeof(vec4));
    make(fields.direction, "direction", sizeof(vec4));
    if (sizes.rough) {
        const glm::ivec3 faces = sizes.cells + glm::ivec3(0, 1, 0);
        make(fields.layer, "layer", (count(faces) + static_cast<VkDeviceSize>(sizes.cells.y + faces.y)) * sizeof(float));
    }
    if (sizes.points > 0)
        make(fields.points, "points", sizes.points * sizeof(WindrowPoint));
    fields.slots.resize(sizes.slots);
    for (Buffer& slot : fields.slots)
        make(slot, "read-back", sizes.slot_bytes, MemoryUse::readback);
    const VkExtent3D extent = {static_cast<std::uint32_t>(sizes.cells.x), static_cast<std::uint32_t>(sizes.cells.y),
                               static_cast<std::uint32_t>(sizes.cells.z)};
    const auto make_image = [&](Image3D& image, VkFormat half, VkFormat single) {
        if (!made_all)
            return;
        auto made = Image3D::create(device, extent, sizes.texel == Texel::half ? half : single, sizes.exported);
        if (!made) {
            made_all = made.failure();
            return;
        }
        image = *std::move(made);
        device.name(VK_OBJECT_TYPE_IMAGE, image.handle(), "texture");
    };
    for (int frame = 0; frame < 2; ++frame) {
        if (has_vectors(sizes.textures))
            make_image(fields.vectors[frame], VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_R32G32B32A32_SFLOAT);
        for (int axis = 0; axis < 3 && has_axes(sizes.textures); ++axis)
            make_image(fields.axes[frame][axis], VK_FORMAT_R16_SFLOAT, VK_FORMAT_R32_SFLOAT);
    }
    if (!made_all)
        return made_all.failure();
    return fields;
}

} // namespace windrow::vulkan
