// What is behind the opaque handles.
#pragma once

#include "c_api/windrow.h"
#include "fluid/event_log.h"
#include "fluid/gust_tile.h"
#include "fluid/shapes/height_map.h"
#include "fluid/shapes/triangle_mesh.h"
#include "fluid/shapes/voxel_grid.h"
#include "fluid/thread_pool.h"
#include "fluid/wind.h"

#include <concepts>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

struct windrow_thread_pool {
    std::unique_ptr<windrow::ThreadPool> pool;
};
struct windrow_bytes {
    std::vector<std::byte> bytes;
};
struct windrow_gust_tile {
    std::shared_ptr<const windrow::GustTile> tile;
};
struct windrow_height_map {
    std::shared_ptr<const windrow::HeightMap> map;
};
struct windrow_mesh {
    std::shared_ptr<const windrow::TriangleMesh> mesh;
};
struct windrow_voxels {
    std::shared_ptr<const windrow::VoxelGrid> grid;
};
struct windrow_ambient_wind {
    windrow::AmbientWind wind;
};
struct windrow_event_log {
    windrow::EventLog log;
};

/// A wind on either backend. Calls that only one has fail on the other.
struct windrow_wind {
    windrow_wind(const windrow_wind&) = delete;
    windrow_wind& operator=(const windrow_wind&) = delete;
    virtual ~windrow_wind() = default;

    windrow::WindControl* control = nullptr;
    windrow::WindReader* reader = nullptr;
    windrow::Wind* cpu = nullptr; ///< null: on a device
    /// The same, which winds inside this one keep alive.
    std::shared_ptr<const windrow::Wind> shared;
    int motors_lost = 0;        ///< of which the host was warned
    int filling_obstacles = 0;  ///< the same
    mutable bool limit = false; ///< the host was warned that Sampling::limit cuts the wind

    /// What the pointers of windrow_wind_config point to.
    struct ConfigStore {
        windrow_log_profile profile;
        windrow_gusts gusts;
        windrow_canopy canopy;
        windrow_roughness roughness;
        windrow_rows rows;
        std::vector<float> heights;
    };
    std::unique_ptr<ConfigStore> config_store;

  protected:
    windrow_wind() = default;
};

namespace windrow::c_api {

template <class Air>
struct WindOf final : windrow_wind {
    explicit WindOf(Air its_air) : owned(std::make_shared<Air>(std::move(its_air))), air(*owned) {
        control = &air;
        reader = &air;
        if constexpr (std::same_as<Air, Wind>) {
            cpu = &air;
            shared = owned;
        }
    }

    std::shared_ptr<Air> owned;
    Air& air;
};

[[nodiscard]] inline std::span<const std::byte> saved_at(const void* bytes, std::uint64_t size) {
    return {static_cast<const std::byte*>(bytes), static_cast<std::size_t>(size)};
}

/// Runs use(wind around), the wind on the CPU that a new one is inside of.
template <class Use>
[[nodiscard]] windrow_result with_outer(const windrow_wind* outer, const Use& use) {
    if (outer->cpu == nullptr)
        return fail(WINDROW_UNSUPPORTED,
                    "outer is a wind on a device: give one on the CPU, which winds on a device are inside of too.");
    return use(outer->shared);
}

/// Warns the host's logger of what is wrong with a step or a recording, if anything.
void warn_of(windrow_wind& wind, const Diagnostics& report);

/// The ids of C are those of C++.
template <class Id, class CId>
[[nodiscard]] Id id_of(CId id) {
    return {.slot = id.slot, .generation = id.generation, .owner = id.owner};
}

} // namespace windrow::c_api
