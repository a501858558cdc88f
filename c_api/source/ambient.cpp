// Calls of ambient.h.
#include "c_api/ambient.h"

#include "c_api/source/tables.h"
#include "fluid/core/archive.h"
#include "fluid/core/message.h"

#include <cmath>
#include <span>
#include <utility>
#include <vector>

using namespace windrow;
using namespace windrow::c_api;

namespace {

constexpr detail::Format k_tile_format{"WINDTILE", 1, "gust tile", "windrow_gust_tile_save"};

std::uint64_t checksum_of(const GustTile& tile) {
    return detail::checksum(std::as_bytes(tile.texels()));
}

} // namespace

WINDROW_C_INIT(windrow_sampling)
WINDROW_EXPORT windrow_result windrow_sampling_validate(const windrow_sampling* sampling) {
    return call({{sampling, "sampling"}},
                [&] { return with(sampling, [](const Sampling& wanted) { return validate(wanted); }); });
}
WINDROW_C_INIT(windrow_ambient_settings)
WINDROW_C_INIT(windrow_uniform_gust)

WINDROW_EXPORT windrow_result windrow_gust_tile_bake(uint32_t seed, windrow_gust_tile** tile) {
    return create(tile, [&]() -> Result<std::shared_ptr<const GustTile>> {
        auto baked = GustTile::bake(seed);
        if (!baked)
            return detail::out_of_memory();
        return baked;
    });
}
WINDROW_EXPORT void windrow_gust_tile_destroy(windrow_gust_tile* tile) {
    delete tile;
}
WINDROW_EXPORT windrow_result windrow_gust_tile_save(const windrow_gust_tile* tile, windrow_bytes** bytes) {
    if (tile == nullptr)
        return fail_null("tile");
    return create(bytes, [&]() -> Result<std::vector<std::byte>> {
        detail::Writer writer(2 * sizeof(std::uint64_t));
        writer(tile->tile->seed(), checksum_of(*tile->tile));
        return std::move(writer).finish(k_tile_format);
    });
}
WINDROW_EXPORT windrow_result windrow_gust_tile_load(const void* bytes, uint64_t size, windrow_gust_tile** tile) {
    if (tile != nullptr)
        *tile = nullptr;
    return call({{bytes, "bytes"}}, [&] {
        return create(tile, [&]() -> Result<std::shared_ptr<const GustTile>> {
            std::uint32_t seed = 0;
            std::uint64_t sum = 0;
            if (const auto read = detail::read_sealed({static_cast<const std::byte*>(bytes), static_cast<std::size_t>(size)},
                                                      k_tile_format, [&](detail::Reader& reader) { reader(seed, sum); });
                !read)
                return read.failure();
            auto baked = GustTile::bake(seed);
            if (!baked)
                return detail::out_of_memory();
            if (checksum_of(*baked) != sum)
                return Error{"gust tile is of a library whose pattern is another one: bake it again."};
            return baked;
        });
    });
}
WINDROW_EXPORT const windrow_vec4* windrow_gust_tile_texels(const windrow_gust_tile* tile, uint64_t* count) {
    return value_of(tile, "tile", [&] {
        const auto texels = tile->tile->texels();
        if (count != nullptr)
            *count = texels.size();
        return same_layout<const windrow_vec4>(texels.data());
    });
}

WINDROW_EXPORT windrow_result windrow_ambient_wind_create(const windrow_ambient_settings* settings,
                                                          windrow_ambient_wind** ambient) {
    return create_from(settings, ambient, [](const AmbientWind::Settings& wanted) { return AmbientWind::create(wanted); });
}
WINDROW_EXPORT windrow_result windrow_ambient_wind_of(const windrow_wind* wind, int32_t frame, windrow_ambient_wind** ambient) {
    if (ambient != nullptr)
        *ambient = nullptr;
    return call({{wind, "wind"}}, [&] {
        return create(ambient, [&]() -> Result<AmbientWind> {
            const auto before = wind->reader->previous_view();
            return frame == WINDROW_FRAME_PREVIOUS && before ? before->ambient() : wind->reader->ambient_wind();
        });
    });
}
WINDROW_EXPORT void windrow_ambient_wind_destroy(windrow_ambient_wind* ambient) {
    delete ambient;
}
WINDROW_EXPORT windrow_result windrow_ambient_wind_advance(windrow_ambient_wind* ambient, double dt) {
    return call({{ambient, "ambient"}}, [&]() -> windrow_result {
        if (!std::isfinite(dt))
            return fail(WINDROW_REJECTED, detail::message("dt is ", dt, " s: give a finite time."));
        ambient->wind.advance(dt);
        return WINDROW_OK;
    });
}
WINDROW_EXPORT windrow_result windrow_ambient_wind_set_mean(windrow_ambient_wind* ambient, windrow_vec3 mean) {
    return call({{ambient, "ambient"}}, [&] { return ambient->wind.set_mean(to_cpp(mean)); });
}
WINDROW_EXPORT windrow_result windrow_ambient_wind_set_ground(windrow_ambient_wind* ambient, double height) {
    return call({{ambient, "ambient"}}, [&] { return ambient->wind.set_ground(height); });
}
WINDROW_EXPORT windrow_result windrow_ambient_wind_set_phase(windrow_ambient_wind* ambient, windrow_dvec3 phase) {
    return call({{ambient, "ambient"}}, [&]() -> Result<void> {
        ambient->wind.set_phase(to_cpp(phase));
        return {};
    });
}
WINDROW_EXPORT windrow_dvec3 windrow_ambient_wind_phase(const windrow_ambient_wind* ambient) {
    return value_of(ambient, "ambient", [&] { return to_c(ambient->wind.phase()); });
}
WINDROW_EXPORT double windrow_ambient_wind_period(const windrow_ambient_wind* ambient) {
    return value_of(ambient, "ambient", [&] { return ambient->wind.period(); });
}
WINDROW_EXPORT windrow_vec3 windrow_ambient_wind_mean(const windrow_ambient_wind* ambient) {
    return value_of(ambient, "ambient", [&] { return to_c(ambient->wind.mean()); });
}
WINDROW_EXPORT double windrow_ambient_wind_ground(const windrow_ambient_wind* ambient) {
    return value_of(ambient, "ambient", [&] { return ambient->wind.ground(); });
}
WINDROW_EXPORT float windrow_ambient_wind_profile_at(const windrow_ambient_wind* ambient, double height) {
    return value_of(ambient, "ambient", [&] { return ambient->wind.profile_at(height); });
}
WINDROW_EXPORT windrow_result windrow_ambient_wind_velocity(const windrow_ambient_wind* ambient, windrow_dvec3 position,
                                                            windrow_vec3* velocity) {
    return call({{ambient, "ambient"}, {velocity, "velocity"}}, [&]() -> Result<void> {
        *velocity = to_c(ambient->wind.velocity(to_cpp(position)));
        return {};
    });
}
WINDROW_EXPORT windrow_result windrow_ambient_wind_felt(const windrow_ambient_wind* ambient, windrow_dvec3 position,
                                                        const windrow_sampling* sampling, windrow_vec3* velocity) {
    return call({{ambient, "ambient"}, {velocity, "velocity"}}, [&] {
        return with_sampling(sampling, [&](const Sampling& wanted) -> Result<void> {
            *velocity = to_c(ambient->wind.felt(to_cpp(*velocity), to_cpp(position), wanted));
            return {};
        });
    });
}
WINDROW_EXPORT windrow_result windrow_ambient_wind_block(const windrow_ambient_wind* ambient, windrow_dvec3 anchor,
                                                         const windrow_sampling* sampling, windrow_ambient_block* block) {
    return call({{ambient, "ambient"}, {block, "block"}}, [&] {
        return with_sampling(sampling, [&](const Sampling& wanted) -> Result<void> {
            copy_block(ambient->wind.block(to_cpp(anchor), wanted), block);
            return {};
        });
    });
}
WINDROW_EXPORT windrow_result windrow_ambient_wind_tile(const windrow_ambient_wind* ambient, windrow_gust_tile** tile) {
    if (tile != nullptr)
        *tile = nullptr;
    return call({{ambient, "ambient"}, {tile, "tile"}}, [&]() -> windrow_result {
        if (const auto& of_wind = ambient->wind.tile())
            *tile = new windrow_gust_tile{of_wind};
        return WINDROW_OK;
    });
}
WINDROW_EXPORT windrow_result windrow_uniform_gust_velocity(const windrow_uniform_gust* gust, double time,
                                                            windrow_vec3* velocity) {
    return call({{gust, "gust"}, {velocity, "velocity"}}, [&] {
        return with(gust, [&](const UniformGust& wanted) -> Result<void> {
            *velocity = to_c(wanted.velocity(time));
            return {};
        });
    });
}
