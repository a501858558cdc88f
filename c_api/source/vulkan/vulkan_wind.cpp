// Calls of vulkan_wind.h.
#include "c_api/vulkan_wind.h"

#include "c_api/source/vulkan/vulkan_tables.h"
#include "fluid/core/message.h"

#include <algorithm>
#include <vector>

using namespace windrow;
using namespace windrow::c_api;

struct windrow_vulkan_set_writes {
    windrow_vulkan_set_writes(VkDescriptorSet set, const vulkan::SetContent& content, vulkan::TextureSet textures,
                              std::uint32_t first)
        : writes(set, content, textures, first) {}
    vulkan::SetWrites writes;
};

namespace {

using DeviceWind = WindOf<vulkan::Wind>;

const char* const k_not_device = "is for winds on a device: make the wind with windrow_vulkan_wind_create.";

/// Runs use(air) on a wind of a device.
template <class Handle, class Use>
windrow_result with_air(Handle* wind, std::initializer_list<Argument> others, const Use& use) {
    if (wind == nullptr)
        return fail_null("wind");
    return call(others, [&] {
        auto* const device = dynamic_cast<std::conditional_t<std::is_const_v<Handle>, const DeviceWind, DeviceWind>*>(wind);
        if (device == nullptr)
            return fail(WINDROW_UNSUPPORTED, detail::message("the call ", std::string_view(k_not_device)));
        return done(use(device->air));
    });
}
/// The same for a call that returns a value.
template <class Handle, class Use>
auto value_of_air(Handle* wind, const Use& use) {
    std::invoke_result_t<Use, decltype((static_cast<DeviceWind*>(nullptr)->air))> value{};
    (void)with_air(wind, {}, [&](auto& air) -> windrow_result {
        value = use(air);
        return WINDROW_OK;
    });
    return value;
}

template <class Use>
windrow_result with_settings(const windrow_vulkan_settings* settings, const Use& use) {
    if (settings == nullptr)
        return done(use(vulkan::Settings{}));
    return with(settings, use);
}

windrow_result make_wind(windrow_wind** wind, Result<vulkan::Wind> made) {
    if (!made)
        return done(made);
    *wind = new DeviceWind(*std::move(made));
    return WINDROW_OK;
}

windrow_vulkan_texture texture_of(const vulkan::Texture& texture) {
    return {number_of(texture.image), number_of(texture.view)};
}
windrow_vulkan_textures textures_of(const vulkan::Textures& from) {
    return {texture_of(from.vectors), {texture_of(from.axes[0]), texture_of(from.axes[1]), texture_of(from.axes[2])}};
}
vulkan::Texture texture_of(const windrow_vulkan_texture& texture) {
    return {handle_of<VkImage>(texture.image), handle_of<VkImageView>(texture.view)};
}
vulkan::Textures textures_of(const windrow_vulkan_textures& from) {
    return {texture_of(from.vectors), {texture_of(from.axes[0]), texture_of(from.axes[1]), texture_of(from.axes[2])}};
}

/// Copies a list into the host's room and returns its number.
template <class From, class To, class Convert>
windrow_result give_list(const std::vector<From>& from, To* to, std::uint32_t* count, const Convert& convert) {
    if (to != nullptr)
        for (std::size_t n = 0; n < std::min<std::size_t>(from.size(), *count); ++n)
            to[n] = convert(from[n]);
    *count = static_cast<std::uint32_t>(from.size());
    return WINDROW_OK;
}

windrow_result require(const windrow_vulkan_host* host, const windrow_config* config, const windrow_vulkan_settings* settings,
                       const Wind* outer, std::uint64_t* memory, std::uint64_t* reserved) {
    return with(host, [&](const vulkan::Host& device) {
        return with(config, [&](const Config& wanted) {
            return with_settings(settings, [&](const vulkan::Settings& how) -> windrow_result {
                const auto bytes = vulkan::required_bytes(device, wanted, how, outer);
                if (bytes) {
                    *memory = bytes->memory;
                    *reserved = bytes->reserved;
                }
                return done(bytes);
            });
        });
    });
}

windrow_result not_ready(const char* sentence) {
    return fail(WINDROW_NOT_READY, sentence);
}

} // namespace

WINDROW_C_INIT(windrow_vulkan_settings)
WINDROW_C_INIT(windrow_vulkan_frame)

// --- Life --------------------------------------------------------------------------------------------------------------
WINDROW_EXPORT windrow_result windrow_vulkan_wind_required_bytes(const windrow_vulkan_host* host, const windrow_config* config,
                                                                 const windrow_vulkan_settings* settings, uint64_t* memory,
                                                                 uint64_t* reserved) {
    return call({{host, "host"}, {config, "config"}, {memory, "memory"}, {reserved, "reserved"}},
                [&] { return require(host, config, settings, nullptr, memory, reserved); });
}
WINDROW_EXPORT windrow_result windrow_vulkan_wind_required_bytes_inside(const windrow_vulkan_host* host,
                                                                        const windrow_config* config,
                                                                        const windrow_vulkan_settings* settings,
                                                                        const windrow_wind* outer, uint64_t* memory,
                                                                        uint64_t* reserved) {
    return call({{host, "host"}, {config, "config"}, {outer, "outer"}, {memory, "memory"}, {reserved, "reserved"}}, [&] {
        return with_outer(outer, [&](const std::shared_ptr<const Wind>& around) {
            return require(host, config, settings, around.get(), memory, reserved);
        });
    });
}
WINDROW_EXPORT windrow_result windrow_vulkan_wind_create(const windrow_vulkan_host* host, const windrow_config* config,
                                                         const windrow_vulkan_settings* settings, windrow_wind** wind) {
    if (wind != nullptr)
        *wind = nullptr;
    return call({{host, "host"}, {config, "config"}, {wind, "wind"}}, [&] {
        return with(host, [&](const vulkan::Host& device) {
            return with(config, [&](const Config& wanted) {
                return with_settings(settings, [&](const vulkan::Settings& how) {
                    return make_wind(wind, vulkan::Wind::create(device, wanted, how));
                });
            });
        });
    });
}
WINDROW_EXPORT windrow_result windrow_vulkan_wind_create_inside(const windrow_vulkan_host* host, const windrow_config* config,
                                                                const windrow_vulkan_settings* settings,
                                                                const windrow_wind* outer, windrow_wind** wind) {
    if (wind != nullptr)
        *wind = nullptr;
    return call({{host, "host"}, {config, "config"}, {outer, "outer"}, {wind, "wind"}}, [&] {
        return with_outer(outer, [&](const std::shared_ptr<const Wind>& around) {
            return with(host, [&](const vulkan::Host& device) {
                return with(config, [&](const Config& wanted) {
                    return with_settings(settings, [&](const vulkan::Settings& how) {
                        return make_wind(wind, vulkan::Wind::create(device, wanted, how, around));
                    });
                });
            });
        });
    });
}
WINDROW_EXPORT windrow_result windrow_vulkan_wind_load(const windrow_vulkan_host* host, const void* bytes, uint64_t size,
                                                       const windrow_vulkan_settings* settings, windrow_wind** wind) {
    if (wind != nullptr)
        *wind = nullptr;
    return call({{host, "host"}, {bytes, "bytes"}, {wind, "wind"}}, [&] {
        return with(host, [&](const vulkan::Host& device) {
            return with_settings(settings, [&](const vulkan::Settings& how) {
                return make_wind(wind, vulkan::Wind::load(device, saved_at(bytes, size), how));
            });
        });
    });
}
WINDROW_EXPORT windrow_result windrow_vulkan_wind_load_inside(const windrow_vulkan_host* host, const void* bytes, uint64_t size,
                                                              const windrow_vulkan_settings* settings, const windrow_wind* outer,
                                                              windrow_wind** wind) {
    if (wind != nullptr)
        *wind = nullptr;
    return call({{host, "host"}, {bytes, "bytes"}, {outer, "outer"}, {wind, "wind"}}, [&] {
        return with_outer(outer, [&](const std::shared_ptr<const Wind>& around) {
            return with(host, [&](const vulkan::Host& device) {
                return with_settings(settings, [&](const vulkan::Settings& how) {
                    return make_wind(wind, vulkan::Wind::load(device, saved_at(bytes, size), how, around));
                });
            });
        });
    });
}
WINDROW_EXPORT windrow_result windrow_vulkan_wind_saved(windrow_wind* wind, windrow_bytes** bytes) {
    if (bytes != nullptr)
        *bytes = nullptr;
    return with_air(wind, {{bytes, "bytes"}}, [&](vulkan::Wind& air) -> windrow_result {
        auto saved = air.saved();
        if (!saved)
            return not_ready(saved.error().c_str());
        *bytes = new windrow_bytes{*std::move(saved)};
        return WINDROW_OK;
    });
}

// --- Frames --------------------------------------------------------------------------------------------------------------
WINDROW_EXPORT windrow_result windrow_vulkan_wind_record(windrow_wind* wind, void* commands, const windrow_vulkan_frame* frame,
                                                         windrow_advance* advance, windrow_diagnostics* last) {
    return with_air(wind, {{commands, "commands"}, {frame, "frame"}}, [&](vulkan::Wind& air) -> windrow_result {
        for (const windrow_result outcome : {check_output(advance), check_output(last)})
            if (outcome != WINDROW_OK)
                return outcome;
        return with(frame, [&](const vulkan::Frame& wanted) -> windrow_result {
            const auto recorded = air.record(commands_of(commands), wanted);
            if (!recorded)
                return done(recorded);
            give_cpp(*recorded, advance);
            give_cpp(recorded->last, last);
            warn_of(*wind, recorded->last);
            return WINDROW_OK;
        });
    });
}
WINDROW_EXPORT windrow_result windrow_vulkan_wind_record_step(windrow_wind* wind, void* commands,
                                                              const windrow_vulkan_frame* frame,
                                                              windrow_diagnostics* diagnostics) {
    return with_air(wind, {{commands, "commands"}, {frame, "frame"}}, [&](vulkan::Wind& air) -> windrow_result {
        if (const windrow_result outcome = check_output(diagnostics); outcome != WINDROW_OK)
            return outcome;
        return with(frame, [&](const vulkan::Frame& wanted) -> windrow_result {
            const auto recorded = air.record_step(commands_of(commands), wanted);
            if (!recorded)
                return done(recorded);
            give_cpp(*recorded, diagnostics);
            warn_of(*wind, *recorded);
            return WINDROW_OK;
        });
    });
}
WINDROW_EXPORT int32_t windrow_vulkan_wind_collect(windrow_wind* wind, int32_t slot) {
    return value_of_air(wind, [&](auto& air) { return air.collect(slot) ? 1 : 0; });
}
WINDROW_EXPORT windrow_result windrow_vulkan_wind_forget(windrow_wind* wind) {
    return with_air(wind, {}, [](vulkan::Wind& air) -> windrow_result {
        air.forget();
        return WINDROW_OK;
    });
}
WINDROW_EXPORT windrow_result windrow_vulkan_wind_replay(const windrow_event_log* log, windrow_wind* wind, windrow_vulkan_run run,
                                                         void* user) {
    return with_air(wind, {{log, "log"}, {reinterpret_cast<const void*>(run), "run"}}, [&](vulkan::Wind& air) {
        return vulkan::replay(log->log, air, [&](const std::function<void(VkCommandBuffer)>& record) -> Result<void> {
            const auto call_record = [](void* commands, void* argument) {
                (*static_cast<const std::function<void(VkCommandBuffer)>*>(argument))(commands_of(commands));
            };
            void* const argument = const_cast<std::function<void(VkCommandBuffer)>*>(&record);
            if (run(call_record, argument, user) != WINDROW_OK)
                return Error{"the host's run did not record, submit and wait: see its own error."};
            return {};
        });
    });
}

// --- For shaders -----------------------------------------------------------------------------------------------------------
WINDROW_EXPORT windrow_result windrow_vulkan_wind_textures(const windrow_wind* wind, windrow_frame frame,
                                                           windrow_vulkan_textures* textures) {
    return with_air(wind, {{textures, "textures"}}, [&](const vulkan::Wind& air) -> windrow_result {
        *textures = textures_of(frame == WINDROW_FRAME_PREVIOUS ? air.previous_textures() : air.textures());
        return WINDROW_OK;
    });
}
WINDROW_EXPORT uint64_t windrow_vulkan_wind_gust_buffer(const windrow_wind* wind) {
    return value_of_air(wind, [](const auto& air) { return number_of(air.gust_buffer()); });
}
WINDROW_EXPORT windrow_result windrow_vulkan_wind_exported_images(const windrow_wind* wind, windrow_vulkan_exported_image* images,
                                                                  uint32_t* count) {
    return with_air(wind, {{count, "count"}}, [&](const vulkan::Wind& air) {
        return give_list(air.exported_images(), images, count, [](const vulkan::ExportedImage& from) {
            return windrow_vulkan_exported_image{.image = number_of(from.image),
                                                 .memory = number_of(from.memory),
                                                 .offset = from.offset,
                                                 .size = from.size,
                                                 .handle_type = static_cast<std::uint32_t>(from.handle_type),
                                                 .format = static_cast<std::int32_t>(from.format),
                                                 .width = from.extent.width,
                                                 .height = from.extent.height,
                                                 .depth = from.extent.depth,
                                                 .reserved = 0};
        });
    });
}
WINDROW_EXPORT windrow_result windrow_vulkan_sampler_info(const windrow_boundaries* boundaries, void* sampler_info) {
    return call({{boundaries, "boundaries"}, {sampler_info, "sampler_info"}}, [&]() -> windrow_result {
        Reasons reasons;
        Boundaries wanted;
        read_fields(reasons, Path{nullptr, "boundaries"}, *boundaries, wanted);
        if (!reasons.empty())
            return fail(WINDROW_REJECTED, reasons.take());
        *static_cast<VkSamplerCreateInfo*>(sampler_info) = vulkan::sampler_info(wanted);
        return WINDROW_OK;
    });
}
WINDROW_EXPORT uint32_t windrow_vulkan_set_bindings(windrow_vulkan_texture_set textures, uint32_t stages, uint32_t first,
                                                    void* bindings) {
    return value_of(bindings, "bindings", [&] {
        Reasons reasons;
        vulkan::TextureSet wanted{};
        if (!read_choice(reasons, Path{nullptr, "textures"}, textures, wanted)) {
            (void)fail(WINDROW_REJECTED, reasons.take());
            return std::uint32_t{0};
        }
        const vulkan::SetBindings made = vulkan::set_bindings(wanted, stages, first);
        std::copy(made.begin(), made.end(), static_cast<VkDescriptorSetLayoutBinding*>(bindings));
        return made.size();
    });
}
WINDROW_EXPORT windrow_result windrow_vulkan_set_writes_create(uint64_t set, const windrow_vulkan_set_content* content,
                                                               windrow_vulkan_texture_set textures, uint32_t first,
                                                               windrow_vulkan_set_writes** writes) {
    return call({{content, "content"}, {writes, "writes"}}, [&]() -> windrow_result {
        *writes = nullptr;
        Reasons reasons;
        vulkan::TextureSet wanted{};
        if (!read_choice(reasons, Path{nullptr, "textures"}, textures, wanted))
            return fail(WINDROW_REJECTED, reasons.take());
        *writes = new windrow_vulkan_set_writes(
            handle_of<VkDescriptorSet>(set),
            {.now = textures_of(content->now),
             .before = textures_of(content->before),
             .sampler = handle_of<VkSampler>(content->sampler),
             .block = {handle_of<VkBuffer>(content->block), content->block_offset, sizeof(FrameBlock)},
             .tile = handle_of<VkBuffer>(content->tile)},
            wanted, first);
        return WINDROW_OK;
    });
}
WINDROW_EXPORT void windrow_vulkan_set_writes_destroy(windrow_vulkan_set_writes* writes) {
    delete writes;
}
WINDROW_EXPORT const void* windrow_vulkan_set_writes_data(const windrow_vulkan_set_writes* writes) {
    return value_of(writes, "writes", [&]() -> const void* { return writes->writes.data(); });
}
WINDROW_EXPORT uint32_t windrow_vulkan_set_writes_count(const windrow_vulkan_set_writes* writes) {
    return value_of(writes, "writes", [&] { return writes->writes.size(); });
}

// --- What was read back ----------------------------------------------------------------------------------------------------
WINDROW_EXPORT windrow_result windrow_vulkan_wind_halves(const windrow_wind* wind, const uint16_t** cells, uint64_t* count,
                                                         windrow_dvec3* origin) {
    return with_air(wind, {{cells, "cells"}, {count, "count"}}, [&](const vulkan::Wind& air) -> windrow_result {
        const auto view = air.queried_halves();
        if (!view)
            return not_ready(
                "no halves have come back yet: create the wind with settings.queries of halves, record and submit frames.");
        *cells = view->field().empty() ? nullptr : &view->field().data()->x;
        *count = view->field().size();
        if (origin != nullptr)
            *origin = to_c(view->origin());
        return WINDROW_OK;
    });
}
WINDROW_EXPORT windrow_result windrow_vulkan_wind_points(const windrow_wind* wind, const windrow_dvec3** positions,
                                                         const windrow_vec4** velocities, uint64_t* count) {
    return with_air(wind, {{positions, "positions"}, {velocities, "velocities"}, {count, "count"}},
                    [&](const vulkan::Wind& air) -> windrow_result {
                        const auto points = air.queried_points();
                        if (!points)
                            return not_ready(
                                "no points have come back yet: create the wind with settings.queries of points, give a frame "
                                "points, record and submit it.");
                        *positions = same_layout<const windrow_dvec3>(points->positions.data());
                        *velocities = same_layout<const windrow_vec4>(points->velocities.data());
                        *count = points->positions.size();
                        return WINDROW_OK;
                    });
}
WINDROW_EXPORT double windrow_vulkan_wind_query_age(const windrow_wind* wind) {
    return value_of_air(wind, [](const auto& air) { return air.query_age(); });
}
WINDROW_EXPORT windrow_result windrow_vulkan_wind_reported(windrow_wind* wind, windrow_diagnostics* diagnostics) {
    return with_air(wind, {{diagnostics, "diagnostics"}}, [&](vulkan::Wind& air) -> windrow_result {
        if (const windrow_result outcome = check_output(diagnostics); outcome != WINDROW_OK)
            return outcome;
        give_cpp(air.reported(), diagnostics);
        return WINDROW_OK;
    });
}
WINDROW_EXPORT int32_t windrow_vulkan_wind_dispatches(const windrow_wind* wind) {
    return value_of_air(wind, [](const auto& air) { return air.dispatches(); });
}
WINDROW_EXPORT int32_t windrow_vulkan_wind_barriers(const windrow_wind* wind) {
    return value_of_air(wind, [](const auto& air) { return air.barriers(); });
}
WINDROW_EXPORT uint64_t windrow_vulkan_wind_reserved_bytes(const windrow_wind* wind) {
    return value_of_air(wind, [](const auto& air) { return air.reserved_bytes(); });
}
WINDROW_EXPORT windrow_result windrow_vulkan_wind_pass_times(const windrow_wind* wind, double* whole_us, double* read_back_us,
                                                             int32_t* untimed, windrow_vulkan_pass* passes, uint32_t* count) {
    return with_air(wind, {{count, "count"}}, [&](const vulkan::Wind& air) -> windrow_result {
        const auto times = air.pass_times();
        if (!times)
            return not_ready("no times have come back yet: create the wind with settings.timestamps, record and submit frames.");
        if (whole_us != nullptr)
            *whole_us = times->whole_us;
        if (read_back_us != nullptr)
            *read_back_us = times->read_back_us;
        if (untimed != nullptr)
            *untimed = times->untimed;
        return give_list(times->passes, passes, count, [](const vulkan::PassTimes::Pass& from) {
            return windrow_vulkan_pass{from.name, from.dispatches, 0, from.us};
        });
    });
}
