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
    windrow_wind() = default;
    windrow_wind(const windrow_wind&) = delete;
    windrow_wind& operator=(const windrow_wind&) = delete;
    virtual ~windrow_wind() = default;

    virtual windrow::Motors& motors() = 0;
    virtual const windrow::Motors& motors() const = 0;
    virtual windrow::Obstacles& obstacles() = 0;
    virtual const windrow::Obstacles& obstacles() const = 0;
    virtual windrow::Result<windrow::ObstacleForce> force_on(windrow::ObstacleId id) const = 0;
    virtual windrow::Result<void> set_ambient(glm::vec3 ambient) = 0;
    virtual glm::vec3 ambient() const = 0;
    virtual windrow::Result<void> set_gusts(const windrow::Gusts& gusts) = 0;
    virtual windrow::Result<void> set_boundaries(const windrow::Boundaries& boundaries) = 0;
    virtual windrow::Result<void> follow(glm::dvec3 point) = 0;
    virtual windrow::Result<void> set_floor(double height) = 0;
    virtual glm::dvec3 origin() const = 0;
    virtual windrow::Box box() const = 0;
    virtual const windrow::Config& config() const = 0;
    virtual windrow::Result<void> set_velocity(const std::function<glm::vec3(glm::dvec3)>& velocity_at) = 0;
    virtual windrow::Result<void> set_velocity(std::span<const glm::vec4> field) = 0;
    virtual void reset() = 0;
    virtual void record_to(windrow::EventLog* log) = 0;
    virtual windrow::WindowBlock window_block(glm::dvec3 anchor) const = 0;
    virtual windrow::FrameBlock frame_block(glm::dvec3 anchor, const windrow::Sampling& sampling) const = 0;
    virtual std::uint64_t memory_bytes() const = 0;
    virtual glm::vec3 velocity(glm::dvec3 position) const = 0;
    /// Of WINDROW_FRAME_NOW or WINDROW_FRAME_PREVIOUS; `why` is the class where there is none.
    virtual windrow::Result<windrow::WindView> view(windrow_frame frame, windrow_result& why) const = 0;
    virtual windrow::Result<windrow::AmbientWind> ambient_wind(windrow_frame frame) const = 0;
    /// On the CPU; null on a device.
    virtual windrow::Wind* cpu() { return nullptr; }
    virtual const windrow::Wind* cpu() const { return nullptr; }

    /// What the pointers of windrow_wind_config point to.
    struct ConfigStore {
        windrow_log_profile profile;
        windrow_gusts gusts;
        windrow_canopy canopy;
        windrow_roughness roughness;
        windrow_rows rows;
    };
    std::unique_ptr<ConfigStore> config_store;
};

namespace windrow::c_api {

/// The calls that both backends have.
template <class Air>
class WindOf : public windrow_wind {
  public:
    explicit WindOf(Air its_air) : air(std::move(its_air)) {}

    Motors& motors() override { return air.motors(); }
    const Motors& motors() const override { return air.motors(); }
    Obstacles& obstacles() override { return air.obstacles(); }
    const Obstacles& obstacles() const override { return air.obstacles(); }
    Result<ObstacleForce> force_on(ObstacleId id) const override { return air.force_on(id); }
    Result<void> set_ambient(glm::vec3 ambient) override { return air.set_ambient(ambient); }
    glm::vec3 ambient() const override { return air.ambient(); }
    Result<void> set_gusts(const Gusts& gusts) override { return air.set_gusts(gusts); }
    Result<void> set_boundaries(const Boundaries& boundaries) override { return air.set_boundaries(boundaries); }
    Result<void> follow(glm::dvec3 point) override { return air.follow(point); }
    Result<void> set_floor(double height) override { return air.set_floor(height); }
    glm::dvec3 origin() const override { return air.origin(); }
    Box box() const override { return air.box(); }
    const Config& config() const override { return air.config(); }
    Result<void> set_velocity(std::span<const glm::vec4> field) override { return air.set_velocity(field); }
    void reset() override { air.reset(); }
    void record_to(EventLog* log) override { air.record_to(log); }
    WindowBlock window_block(glm::dvec3 anchor) const override { return air.window_block(anchor); }
    FrameBlock frame_block(glm::dvec3 anchor, const Sampling& sampling) const override {
        return air.frame_block(anchor, sampling);
    }
    std::uint64_t memory_bytes() const override { return air.memory_bytes(); }
    glm::vec3 velocity(glm::dvec3 position) const override { return air.velocity(position); }

    Air air;
};

/// The ids of C are those of C++.
template <class Id, class CId>
[[nodiscard]] Id id_of(CId id) {
    return {.slot = id.slot, .generation = id.generation, .owner = id.owner};
}

} // namespace windrow::c_api
