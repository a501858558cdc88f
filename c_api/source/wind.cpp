// Calls of wind.h and config.h.
#include "c_api/wind.h"

#include "c_api/source/tables.h"
#include "fluid/core/message.h"
#include "fluid/field_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

using namespace windrow;
using namespace windrow::c_api;

void windrow::c_api::warn_of(windrow_wind& wind, const Diagnostics& report) {
    if (!report.stepped)
        return;
    if (report.repaired_cells > 0) [[unlikely]]
        warn("cells that were not finite were set to the ambient wind: look for a velocity that the host set.");
    if (report.motors_lost > wind.motors_lost) [[unlikely]]
        warn("a motor acts on no air where it is: it is under the ground or far outside of the box; move it or the floor.");
    wind.motors_lost = report.motors_lost;
    if (report.out_of_memory && report.stepped) [[unlikely]]
        warn("out of memory for the obstacles on the device: the step ran without them; free some, and they come back.");
    if (report.filling_obstacles > wind.filling_obstacles) [[unlikely]]
        warn("an obstacle fills more than half of the box, so that little wind is left: are its lengths metres?");
    wind.filling_obstacles = report.filling_obstacles;
}

namespace {

windrow_result lasted(windrow_wind& wind, const Diagnostics& report) {
    if (report.out_of_memory) [[unlikely]]
        return fail(detail::out_of_memory());
    warn_of(wind, report);
    return WINDROW_OK;
}

windrow_result make_cpu_wind(windrow_wind** wind, Result<Wind> made) {
    if (made)
        *wind = new WindOf<Wind>(*std::move(made));
    return done(made);
}

windrow_result lacks(const char* what) {
    return fail(WINDROW_UNSUPPORTED,
                detail::message(std::string_view(what), " is for winds on the CPU: call the windrow_vulkan_wind "
                                                        "function for a wind on a device."));
}

bool is_time(double dt) {
    return std::isfinite(static_cast<float>(dt)) && dt >= 0.0;
}
windrow_result fail_time(double dt) {
    return fail(WINDROW_REJECTED, detail::message("dt is ", dt, " s: give a finite time of 0 or more."));
}
/// Runs use(view) on the view of a frame.
template <class Use>
windrow_result with_view(const windrow_wind* wind, windrow_frame frame, const Use& use) {
    if (frame != WINDROW_FRAME_NOW && frame != WINDROW_FRAME_PREVIOUS)
        return fail(WINDROW_REJECTED, detail::message("frame is ", frame, ": give WINDROW_FRAME_NOW or WINDROW_FRAME_PREVIOUS."));
    const bool before = frame == WINDROW_FRAME_PREVIOUS;
    const Result<WindView> view = before ? wind->reader->previous_view() : wind->reader->view();
    if (!view)
        return fail(before ? WINDROW_UNSUPPORTED : WINDROW_NOT_READY, view.error());
    return done(use(*view));
}

windrow_result fail_texel(windrow_texel texel) {
    return fail(WINDROW_REJECTED, detail::message("texel is ", texel, ": give WINDROW_TEXEL_HALF or WINDROW_TEXEL_FLOAT."));
}

/// write(zero) with a number of the texel's type.
template <class Write>
windrow_result write_texels(windrow_texel texel, const Write& write) {
    if (texel == WINDROW_TEXEL_HALF)
        return done(write(std::uint16_t{}));
    if (texel == WINDROW_TEXEL_FLOAT)
        return done(write(float{}));
    return fail_texel(texel);
}

template <class Number>
glm::dvec3 point_at(const unsigned char* from) {
    std::array<Number, 3> place;
    std::memcpy(place.data(), from, sizeof place);
    return {static_cast<double>(place[0]), static_cast<double>(place[1]), static_cast<double>(place[2])};
}

Result<void> sample(const WindView& view, const windrow_query& query, const Sampling* felt) {
    const bool doubles = query.number == WINDROW_NUMBER_DOUBLE;
    const std::size_t step = query.position_stride != 0 ? query.position_stride
                             : doubles                  ? sizeof(glm::dvec3)
                                                        : sizeof(glm::vec3);
    const std::size_t out_step = query.velocity_stride != 0 ? query.velocity_stride : sizeof(glm::vec3);
    const auto count = static_cast<std::size_t>(query.count);
    const auto* from = static_cast<const unsigned char*>(query.positions);
    auto* to = reinterpret_cast<unsigned char*>(query.velocities);
    const glm::dvec3 anchor = to_cpp(query.anchor);
    const auto fits = [](const void* memory, std::size_t alignment) {
        return reinterpret_cast<std::uintptr_t>(memory) % alignment == 0;
    };
    if (doubles && felt == nullptr && step == sizeof(glm::dvec3) && out_step == sizeof(glm::vec3) && anchor == glm::dvec3(0.0) &&
        fits(from, alignof(glm::dvec3)) && fits(to, alignof(glm::vec3))) {
        view.velocity({reinterpret_cast<const glm::dvec3*>(from), count}, std::span(reinterpret_cast<glm::vec3*>(to), count));
        return {};
    }
    constexpr std::size_t k_block = 256;
    std::array<glm::dvec3, k_block> positions;
    std::array<glm::vec3, k_block> velocities;
    for (std::size_t first = 0; first < count; first += k_block) {
        const std::size_t size = std::min(k_block, count - first);
        for (std::size_t n = 0; n < size; ++n, from += step)
            positions[n] = (doubles ? point_at<double>(from) : point_at<float>(from)) + anchor;
        if (felt == nullptr)
            view.velocity({positions.data(), size}, std::span(velocities.data(), size));
        else
            view.felt({positions.data(), size}, *felt, std::span(velocities.data(), size));
        for (std::size_t n = 0; n < size; ++n, to += out_step)
            std::memcpy(to, &velocities[n], sizeof velocities[n]);
    }
    return {};
}

windrow_result check_query(const windrow_query& query) {
    Reasons reasons;
    const bool doubles = query.number == WINDROW_NUMBER_DOUBLE;
    if (!doubles && query.number != WINDROW_NUMBER_FLOAT)
        reasons.add("query.number is ", query.number, ": give WINDROW_NUMBER_FLOAT or WINDROW_NUMBER_DOUBLE.");
    if (query.count > 0 && (query.positions == nullptr || query.velocities == nullptr))
        reasons.add("query has no positions or no velocities: give an entry for each of the ", query.count, " points.");
    if (query.position_stride != 0 && query.position_stride < 3 * (doubles ? sizeof(double) : sizeof(float)))
        reasons.add("query.position_stride is ", query.position_stride, " bytes: give 0, or at least the size of three numbers.");
    if (query.velocity_stride != 0 && query.velocity_stride < 3 * sizeof(float))
        reasons.add("query.velocity_stride is ", query.velocity_stride, " bytes: give 0, or at least 12.");
    return reasons.empty() ? windrow_result{WINDROW_OK} : fail(WINDROW_REJECTED, reasons.take());
}

/// Once a wind: what acts on plants is no more than the limit, though the mean wind itself is above it.
void warn_of_limit(const windrow_wind& wind, const Sampling& sampling) {
    if (wind.limit || glm::length(wind.control->ambient()) * sampling.strength <= sampling.limit) [[likely]]
        return;
    wind.limit = true;
    warn("sampling.limit is below the mean wind, so that plants feel no more than it: are the wind's lengths metres?");
}

} // namespace

// --- config.h ----------------------------------------------------------------------------------------------------------
WINDROW_EXPORT windrow_boundaries windrow_boundaries_all(windrow_boundary_kind kind) {
    const windrow_boundary each{kind, {}};
    return {each, each, each, each, each, each};
}
WINDROW_EXPORT windrow_boundaries windrow_boundaries_open_over_floor(void) {
    windrow_boundaries boundaries;
    write_fields(Boundaries::open_over_floor(), boundaries);
    return boundaries;
}
WINDROW_EXPORT int32_t windrow_simd_runs(windrow_simd level) {
    return level >= 0 && level < k_values<Simd> && runs(static_cast<Simd>(level));
}
WINDROW_EXPORT const char* windrow_simd_name(windrow_simd level) {
    return level >= 0 && level < k_values<Simd> ? name_of(static_cast<Simd>(level)) : "";
}
WINDROW_EXPORT windrow_result windrow_config_validate(const windrow_config* config) {
    return call({{config, "config"}}, [&] { return with(config, [](const Config& wanted) { return validate(wanted); }); });
}

WINDROW_C_INIT(windrow_log_profile)
WINDROW_C_INIT(windrow_gusts)
WINDROW_C_INIT(windrow_canopy)
WINDROW_C_INIT(windrow_roughness_map)
WINDROW_C_INIT(windrow_roughness)
WINDROW_C_INIT(windrow_rows)
WINDROW_C_INIT(windrow_config)
WINDROW_C_INIT(windrow_diagnostics)
WINDROW_C_INIT(windrow_advance)
WINDROW_C_INIT(windrow_box)
WINDROW_C_INIT(windrow_query)

// --- Life --------------------------------------------------------------------------------------------------------------
WINDROW_EXPORT windrow_result windrow_wind_create(const windrow_config* config, windrow_wind** wind) {
    if (wind != nullptr)
        *wind = nullptr;
    return call({{config, "config"}, {wind, "wind"}},
                [&] { return with(config, [&](const Config& wanted) { return make_cpu_wind(wind, Wind::create(wanted)); }); });
}
WINDROW_EXPORT windrow_result windrow_wind_create_inside(const windrow_config* config, const windrow_wind* outer,
                                                         windrow_wind** wind) {
    if (wind != nullptr)
        *wind = nullptr;
    return call({{config, "config"}, {outer, "outer"}, {wind, "wind"}}, [&] {
        return with_outer(outer, [&](const std::shared_ptr<const Wind>& around) {
            return with(config, [&](const Config& wanted) { return make_cpu_wind(wind, Wind::create(wanted, around)); });
        });
    });
}
WINDROW_EXPORT void windrow_wind_destroy(windrow_wind* wind) {
    delete wind;
}
WINDROW_EXPORT windrow_result windrow_wind_save(const windrow_wind* wind, windrow_bytes** bytes) {
    if (wind == nullptr)
        return fail_null("wind");
    if (wind->cpu == nullptr)
        return lacks("windrow_wind_save");
    return create(bytes, [&] { return wind->cpu->save(); });
}
WINDROW_EXPORT windrow_result windrow_wind_load(const void* bytes, uint64_t size, const windrow_parallel_for* parallel_for,
                                                windrow_wind** wind) {
    if (wind != nullptr)
        *wind = nullptr;
    return call({{bytes, "bytes"}, {wind, "wind"}},
                [&] { return make_cpu_wind(wind, Wind::load(saved_at(bytes, size), loop_of(parallel_for))); });
}
WINDROW_EXPORT windrow_result windrow_wind_load_inside(const void* bytes, uint64_t size, const windrow_parallel_for* parallel_for,
                                                       const windrow_wind* outer, windrow_wind** wind) {
    if (wind != nullptr)
        *wind = nullptr;
    return call({{bytes, "bytes"}, {outer, "outer"}, {wind, "wind"}}, [&] {
        return with_outer(outer, [&](const std::shared_ptr<const Wind>& around) {
            return make_cpu_wind(wind, Wind::load(saved_at(bytes, size), loop_of(parallel_for), around));
        });
    });
}
WINDROW_EXPORT windrow_result windrow_wind_record_to(windrow_wind* wind, windrow_event_log* log) {
    return call({{wind, "wind"}}, [&]() -> Result<void> {
        wind->control->record_to(log != nullptr ? &log->log : nullptr);
        return {};
    });
}
WINDROW_EXPORT windrow_result windrow_wind_config(windrow_wind* wind, windrow_config* config) {
    return call({{wind, "wind"}, {config, "config"}}, [&]() -> windrow_result {
        if (const windrow_result outcome = check_output(config); outcome != WINDROW_OK)
            return outcome;
        if (!wind->config_store)
            wind->config_store = std::make_unique<windrow_wind::ConfigStore>();
        const Config& from = wind->control->config();
        auto& store = *wind->config_store;
        windrow_config all{};
        write_fields(from, all);
        const auto keep = [](const auto& value, auto& place, auto*& pointer) {
            place = {};
            place.struct_size = sizeof place;
            write_fields(value, place);
            pointer = &place;
        };
        keep(from.gusts, store.gusts, all.gusts);
        if (from.profile)
            keep(*from.profile, store.profile, all.profile);
        if (from.canopy)
            keep(*from.canopy, store.canopy, all.canopy);
        if (from.roughness)
            keep(*from.roughness, store.roughness, all.roughness);
        if (from.rows) {
            keep(*from.rows, store.rows, all.rows);
            store.heights = from.rows->heights; // a copy, which the host may get in its unit
            store.rows.heights = store.heights.data();
        }
        give(all, config);
        return WINDROW_OK;
    });
}
WINDROW_EXPORT uint64_t windrow_wind_memory_bytes(const windrow_wind* wind) {
    return value_of(wind, "wind", [&] { return wind->reader->memory_bytes(); });
}

// --- Time --------------------------------------------------------------------------------------------------------------
WINDROW_EXPORT windrow_result windrow_wind_step(windrow_wind* wind, double dt, windrow_diagnostics* diagnostics) {
    return call({{wind, "wind"}}, [&]() -> windrow_result {
        if (wind->cpu == nullptr)
            return lacks("windrow_wind_step");
        if (!is_time(dt))
            return fail_time(dt);
        if (const windrow_result outcome = check_output(diagnostics); outcome != WINDROW_OK)
            return outcome;
        const Diagnostics report = wind->cpu->step(dt);
        give_cpp(report, diagnostics);
        return lasted(*wind, report);
    });
}
WINDROW_EXPORT windrow_result windrow_wind_advance(windrow_wind* wind, double dt, windrow_advance* advance,
                                                   windrow_diagnostics* last) {
    return call({{wind, "wind"}}, [&]() -> windrow_result {
        if (wind->cpu == nullptr)
            return lacks("windrow_wind_advance");
        if (!is_time(dt))
            return fail_time(dt);
        for (const windrow_result outcome : {check_output(advance), check_output(last)})
            if (outcome != WINDROW_OK)
                return outcome;
        const Advance report = wind->cpu->advance(dt);
        give_cpp(report, advance);
        give_cpp(report.last, last);
        return lasted(*wind, report.last);
    });
}

// --- Place and ambient wind ----------------------------------------------------------------------------------------------
WINDROW_EXPORT windrow_result windrow_wind_follow(windrow_wind* wind, windrow_dvec3 point) {
    return call({{wind, "wind"}}, [&] { return wind->control->follow(to_cpp(point)); });
}
WINDROW_EXPORT windrow_result windrow_wind_set_floor(windrow_wind* wind, double height) {
    return call({{wind, "wind"}}, [&] { return wind->control->set_floor(height); });
}
WINDROW_EXPORT windrow_result windrow_wind_shift_origin(windrow_wind* wind, windrow_dvec3 offset) {
    return call({{wind, "wind"}}, [&] { return wind->control->shift_origin(to_cpp(offset)); });
}
WINDROW_EXPORT windrow_result windrow_wind_box(const windrow_wind* wind, windrow_box* box) {
    return call({{wind, "wind"}, {box, "box"}}, [&]() -> windrow_result {
        if (const windrow_result outcome = check_output(box); outcome != WINDROW_OK)
            return outcome;
        windrow_box all{};
        write_fields(wind->control->box(), all);
        all.origin = to_c(wind->control->origin());
        give(all, box);
        return WINDROW_OK;
    });
}
WINDROW_EXPORT windrow_dvec3 windrow_wind_origin(const windrow_wind* wind) {
    return value_of(wind, "wind", [&] { return to_c(wind->control->origin()); });
}
WINDROW_EXPORT uint64_t windrow_wind_cell_count(const windrow_wind* wind) {
    return value_of(wind, "wind", [&] { return static_cast<uint64_t>(wind->control->box().cell_count()); });
}
WINDROW_EXPORT windrow_result windrow_wind_set_ambient(windrow_wind* wind, windrow_vec3 ambient) {
    return call({{wind, "wind"}}, [&] { return wind->control->set_ambient(to_cpp(ambient)); });
}
WINDROW_EXPORT windrow_vec3 windrow_wind_ambient(const windrow_wind* wind) {
    return value_of(wind, "wind", [&] { return to_c(wind->control->ambient()); });
}
WINDROW_EXPORT windrow_result windrow_wind_set_gusts(windrow_wind* wind, const windrow_gusts* gusts) {
    return call({{wind, "wind"}, {gusts, "gusts"}},
                [&] { return with(gusts, [&](const Gusts& wanted) { return wind->control->set_gusts(wanted); }); });
}
WINDROW_EXPORT windrow_result windrow_wind_set_boundaries(windrow_wind* wind, const windrow_boundaries* boundaries) {
    return call({{wind, "wind"}, {boundaries, "boundaries"}}, [&]() -> windrow_result {
        Reasons reasons;
        Boundaries wanted;
        read_fields(reasons, Path{nullptr, "boundaries"}, *boundaries, wanted);
        if (!reasons.empty())
            return fail(WINDROW_REJECTED, reasons.take());
        return done(wind->control->set_boundaries(wanted));
    });
}

// --- Setting the air ---------------------------------------------------------------------------------------------------
WINDROW_EXPORT windrow_result windrow_wind_set_velocity(windrow_wind* wind, windrow_velocity_at velocity_at, void* user) {
    return call({{wind, "wind"}, {reinterpret_cast<const void*>(velocity_at), "velocity_at"}}, [&] {
        return wind->control->set_velocity([&](glm::dvec3 centre) {
            const windrow_dvec3 place = to_c(centre);
            windrow_vec3 velocity{};
            velocity_at(user, &place, &velocity);
            return to_cpp(velocity);
        });
    });
}
WINDROW_EXPORT windrow_result windrow_wind_set_field(windrow_wind* wind, const windrow_vec4* cells, uint64_t count) {
    return call({{wind, "wind"}, {cells, "cells"}}, [&] {
        return wind->control->set_velocity({same_layout<const glm::vec4>(cells), static_cast<std::size_t>(count)});
    });
}
WINDROW_EXPORT windrow_result windrow_wind_reset(windrow_wind* wind) {
    return call({{wind, "wind"}}, [&]() -> Result<void> {
        wind->control->reset();
        return {};
    });
}

// --- Reading the air -----------------------------------------------------------------------------------------------------
WINDROW_EXPORT windrow_result windrow_wind_velocity(const windrow_wind* wind, windrow_dvec3 position, windrow_vec3* velocity) {
    return call({{wind, "wind"}, {velocity, "velocity"}}, [&]() -> windrow_result {
        *velocity = to_c(wind->reader->velocity(to_cpp(position)));
        return WINDROW_OK;
    });
}
WINDROW_EXPORT windrow_result windrow_wind_felt(const windrow_wind* wind, windrow_dvec3 position,
                                                const windrow_sampling* sampling, windrow_vec3* velocity) {
    return call({{wind, "wind"}, {velocity, "velocity"}}, [&] {
        return with_sampling(sampling, [&](const Sampling& wanted) {
            warn_of_limit(*wind, wanted);
            return with_view(wind, WINDROW_FRAME_NOW, [&](const WindView& view) -> Result<void> {
                *velocity = to_c(view.felt(to_cpp(position), wanted));
                return {};
            });
        });
    });
}
WINDROW_EXPORT windrow_result windrow_wind_sample(const windrow_wind* wind, const windrow_query* query) {
    return call({{wind, "wind"}, {query, "query"}}, [&]() -> windrow_result {
        Reasons reasons;
        windrow_query asked;
        if (!take(reasons, Path{nullptr, "query"}, query, asked))
            return fail(WINDROW_REJECTED, reasons.take());
        if (const windrow_result outcome = check_query(asked); outcome != WINDROW_OK)
            return outcome;
        return with_view(wind, asked.frame, [&](const WindView& view) -> windrow_result {
            if (asked.sampling == nullptr)
                return done(sample(view, asked, nullptr));
            return with(asked.sampling, [&](const Sampling& felt) {
                warn_of_limit(*wind, felt);
                return sample(view, asked, &felt);
            });
        });
    });
}
WINDROW_EXPORT windrow_result windrow_wind_write_vectors(const windrow_wind* wind, windrow_frame frame, windrow_texel texel,
                                                         void* texels, uint64_t count) {
    return call({{wind, "wind"}, {texels, "texels"}}, [&] {
        return with_view(wind, frame, [&](const WindView& view) {
            return write_texels(texel, [&](auto zero) { return view.write_vectors(numbers<decltype(zero)>(texels, count)); });
        });
    });
}
WINDROW_EXPORT windrow_result windrow_wind_write_axes(const windrow_wind* wind, windrow_frame frame, windrow_texel texel, void* x,
                                                      void* y, void* z, uint64_t count) {
    return call({{wind, "wind"}, {x, "x"}, {y, "y"}, {z, "z"}}, [&] {
        return with_view(wind, frame, [&](const WindView& view) {
            return write_texels(texel, [&](auto zero) {
                using Number = decltype(zero);
                return view.write_axes(numbers<Number>(x, count), numbers<Number>(y, count), numbers<Number>(z, count));
            });
        });
    });
}
WINDROW_EXPORT windrow_result windrow_wind_write_obstacles(const windrow_wind* wind, float* cells, uint64_t count) {
    return call({{wind, "wind"}, {cells, "cells"}},
                [&]() -> windrow_result { return done(wind->reader->write_obstacles(numbers<float>(cells, count))); });
}
WINDROW_EXPORT windrow_result windrow_wind_write_pressure(windrow_wind* wind, float* cells, uint64_t count) {
    return call({{wind, "wind"}, {cells, "cells"}}, [&]() -> windrow_result {
        if (wind->cpu == nullptr)
            return lacks("windrow_wind_write_pressure");
        return done(wind->reader->write_pressure(numbers<float>(cells, count)));
    });
}
WINDROW_EXPORT windrow_result windrow_wind_field(const windrow_wind* wind, windrow_frame frame, const windrow_vec4** cells,
                                                 uint64_t* count, windrow_dvec3* origin) {
    return call({{wind, "wind"}, {cells, "cells"}, {count, "count"}}, [&] {
        return with_view(wind, frame, [&](const WindView& view) -> Result<void> {
            *cells = same_layout<const windrow_vec4>(view.field().data());
            *count = view.field().size();
            if (origin != nullptr)
                *origin = to_c(view.origin());
            return {};
        });
    });
}
WINDROW_EXPORT windrow_result windrow_wind_write_field(const windrow_wind* wind, const char* path, windrow_field_format format,
                                                       double time) {
    return call({{wind, "wind"}, {path, "path"}}, [&]() -> windrow_result {
        Reasons reasons;
        FieldFormat wanted{};
        if (!read_choice(reasons, Path{nullptr, "format"}, format, wanted))
            return fail(WINDROW_REJECTED, reasons.take());
        if (!std::isfinite(time))
            return fail(WINDROW_REJECTED, detail::message("time is ", time, " s: give a finite number."));
        return with_view(wind, WINDROW_FRAME_NOW, [&](const WindView& view) -> windrow_result {
            std::vector<float> inside(view.field().size());
            if (const auto written = wind->reader->write_obstacles(inside); !written)
                return done(written);
            FieldGrid grid = field_grid(view, inside);
            grid.time = time;
            const auto written = write_field(path_of(path), wanted, grid);
            if (!written && written.failure().fault == Fault::out_of_memory)
                return done(written);
            if (!written)
                return fail(written.failure().fault == Fault::system_lacks ? WINDROW_DISK_FULL : WINDROW_CANNOT_WRITE,
                            written.error());
            return WINDROW_OK;
        });
    });
}
WINDROW_EXPORT uint16_t windrow_to_half(float value) {
    return to_half(value);
}
WINDROW_EXPORT float windrow_from_half(uint16_t half) {
    return from_half(half);
}
WINDROW_EXPORT windrow_result windrow_wind_window_block(const windrow_wind* wind, windrow_dvec3 anchor,
                                                        windrow_window_block* block) {
    return call({{wind, "wind"}, {block, "block"}}, [&]() -> Result<void> {
        copy_block(wind->reader->window_block(to_cpp(anchor)), block);
        return {};
    });
}
WINDROW_EXPORT windrow_result windrow_wind_frame_block(const windrow_wind* wind, windrow_dvec3 anchor,
                                                       const windrow_sampling* sampling, windrow_frame_block* block) {
    return call({{wind, "wind"}, {block, "block"}}, [&] {
        return with_sampling(sampling, [&](const Sampling& wanted) -> Result<void> {
            warn_of_limit(*wind, wanted);
            copy_block(wind->reader->frame_block(to_cpp(anchor), wanted), block);
            return {};
        });
    });
}
