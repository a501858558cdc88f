// Calls of vulkan_ground.h.
#include "c_api/vulkan_ground.h"

#include "c_api/source/plant_tables.h"
#include "c_api/source/vulkan/vulkan_tables.h"
#include "coupling/vulkan/ground_memory.h"

namespace windrow::c_api {
template <>
inline constexpr int k_values<WindLeans> = 2;
} // namespace windrow::c_api

using namespace windrow;
using namespace windrow::c_api;

struct windrow_vulkan_ground {
    vulkan::GroundMemory ground;
};

WINDROW_EXPORT windrow_result windrow_vulkan_ground_create(const windrow_vulkan_host* host, const windrow_ground_config* config,
                                                           windrow_texel texel, windrow_vulkan_ground** ground) {
    if (ground != nullptr)
        *ground = nullptr;
    return with_host(host, [&](const vulkan::Host& device) -> windrow_result {
        Reasons reasons;
        vulkan::Texel wanted_texel{};
        if (!read_choice(reasons, Path{nullptr, "texel"}, texel, wanted_texel))
            return fail(WINDROW_REJECTED, reasons.take());
        return create_from(config, ground, [&](const GroundConfig& wanted) {
            return vulkan::GroundMemory::create(device, wanted, wanted_texel);
        });
    });
}
WINDROW_EXPORT void windrow_vulkan_ground_destroy(windrow_vulkan_ground* ground) {
    delete ground;
}
WINDROW_EXPORT windrow_result windrow_vulkan_ground_follow(windrow_vulkan_ground* ground, windrow_dvec3 point) {
    return call({{ground, "ground"}}, [&] { return ground->ground.follow(to_cpp(point)); });
}
WINDROW_EXPORT windrow_result windrow_vulkan_ground_shift_origin(windrow_vulkan_ground* ground, windrow_dvec3 offset) {
    return call({{ground, "ground"}}, [&] { return ground->ground.shift_origin(to_cpp(offset)); });
}
WINDROW_EXPORT windrow_result windrow_vulkan_ground_record(windrow_vulkan_ground* ground, void* commands,
                                                           const windrow_ground_step* step, windrow_wind_leans leans) {
    return call({{ground, "ground"}, {commands, "commands"}, {step, "step"}}, [&] {
        return with_ground_step(step, [&](const GroundStep& wanted) -> windrow_result {
            Reasons reasons;
            WindLeans from{};
            if (!read_choice(reasons, Path{nullptr, "leans"}, leans, from))
                return fail(WINDROW_REJECTED, reasons.take());
            return done(ground->ground.record(commands_of(commands), wanted, from));
        });
    });
}
WINDROW_EXPORT windrow_result windrow_vulkan_ground_record_save(windrow_vulkan_ground* ground, void* commands) {
    return call({{ground, "ground"}, {commands, "commands"}}, [&] { return ground->ground.record_save(commands_of(commands)); });
}
WINDROW_EXPORT windrow_result windrow_vulkan_ground_saved(windrow_vulkan_ground* ground, windrow_bytes** bytes) {
    if (bytes != nullptr)
        *bytes = nullptr;
    return call({{ground, "ground"}, {bytes, "bytes"}}, [&]() -> windrow_result {
        auto saved = ground->ground.saved();
        if (!saved)
            return fail(saved.failure());
        *bytes = new windrow_bytes{*std::move(saved)};
        return WINDROW_OK;
    });
}
WINDROW_EXPORT windrow_result windrow_vulkan_ground_load(const windrow_vulkan_host* host, const void* bytes, uint64_t size,
                                                         windrow_texel texel, windrow_vulkan_ground** ground) {
    if (ground != nullptr)
        *ground = nullptr;
    return call({{bytes, "bytes"}}, [&] {
        return with_host(host, [&](const vulkan::Host& device) -> windrow_result {
            Reasons reasons;
            vulkan::Texel wanted{};
            if (!read_choice(reasons, Path{nullptr, "texel"}, texel, wanted))
                return fail(WINDROW_REJECTED, reasons.take());
            const std::span saved(static_cast<const std::byte*>(bytes), static_cast<std::size_t>(size));
            return create(ground, [&] { return vulkan::GroundMemory::load(device, saved, wanted); });
        });
    });
}
WINDROW_EXPORT uint64_t windrow_vulkan_ground_lean_buffer(const windrow_vulkan_ground* ground) {
    return value_of(ground, "ground", [&] { return number_of(ground->ground.lean_buffer()); });
}
WINDROW_EXPORT int32_t windrow_vulkan_ground_walkers_left_out(const windrow_vulkan_ground* ground) {
    return value_of(ground, "ground", [&] { return ground->ground.walkers_left_out(); });
}
WINDROW_EXPORT windrow_result windrow_vulkan_ground_next_place(const windrow_vulkan_ground* ground, windrow_dvec3 anchor,
                                                               windrow_ground_place_block* place) {
    return call({{ground, "ground"}, {place, "place"}}, [&]() -> windrow_result {
        copy_block(ground->ground.next_place(to_cpp(anchor)), place);
        return WINDROW_OK;
    });
}
WINDROW_EXPORT windrow_result windrow_vulkan_ground_texture(const windrow_vulkan_ground* ground, windrow_frame frame,
                                                            windrow_vulkan_texture* texture) {
    return call({{ground, "ground"}, {texture, "texture"}}, [&]() -> windrow_result {
        const vulkan::GroundTexture of_step =
            frame == WINDROW_FRAME_PREVIOUS ? ground->ground.previous_texture() : ground->ground.texture();
        *texture = {number_of(of_step.image), number_of(of_step.view)};
        return WINDROW_OK;
    });
}
WINDROW_EXPORT windrow_result windrow_vulkan_ground_block(const windrow_vulkan_ground* ground, windrow_dvec3 anchor,
                                                          windrow_ground_block* block) {
    return call({{ground, "ground"}, {block, "block"}}, [&]() -> windrow_result {
        copy_block(ground->ground.block(to_cpp(anchor)), block);
        return WINDROW_OK;
    });
}
WINDROW_EXPORT uint64_t windrow_vulkan_ground_memory_bytes(const windrow_vulkan_ground* ground) {
    return value_of(ground, "ground", [&] { return ground->ground.memory_bytes(); });
}
WINDROW_EXPORT uint64_t windrow_vulkan_ground_reserved_bytes(const windrow_vulkan_ground* ground) {
    return value_of(ground, "ground", [&] { return ground->ground.reserved_bytes(); });
}
