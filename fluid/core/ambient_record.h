// Snapshot record of an ambient wind: settings, phase, and the tile by its seed.
#pragma once

#include "fluid/ambient.h"
#include "fluid/core/archive.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <utility>
#include <vector>

namespace windrow::detail {

/// All of an AmbientWind but the profile, which never changes, and the texels, which follow from the seed.
struct AmbientRecord {
    glm::vec3 mean{0.0f};
    double ground = 0.0;
    glm::vec3 gust_axes{1.0f};
    glm::dvec3 phase{0.0};
    float intensity = 0.0f;
    float length = 0.0f;
    bool has_tile = false; ///< detail needs one without gusts
    std::uint32_t seed = 0;
};

[[nodiscard]] inline AmbientRecord record_of(const AmbientWind& wind) {
    const auto& [mean, profile, gusts, ground] = wind.settings();
    const auto& [intensity, length, seed, tile] = gusts;
    return {mean, ground, wind.gust_axes(), wind.phase(), intensity, length, tile != nullptr, tile ? tile->seed() : seed};
}

/// Makes each tile once.
class Tiles {
  public:
    void add(std::shared_ptr<const GustTile> tile) {
        if (tile)
            tiles_.push_back(std::move(tile));
    }
    [[nodiscard]] std::shared_ptr<const GustTile> of_seed(std::uint32_t seed) {
        const auto found = std::find_if(tiles_.begin(), tiles_.end(), [&](const auto& tile) { return tile->seed() == seed; });
        if (found != tiles_.end())
            return *found;
        auto tile = GustTile::bake(seed);
        if (!tile)
            throw std::bad_alloc(); // caught by whoever reads the bytes
        return tiles_.emplace_back(std::move(tile));
    }

  private:
    std::vector<std::shared_ptr<const GustTile>> tiles_;
};

// A phase can be the period itself, where a value just below 0 was wrapped and rounded; it comes out so again.
[[nodiscard]] inline glm::dvec3 unwrapped(glm::dvec3 phase, double period) {
    for (int axis = 0; axis < 3; ++axis)
        if (phase[axis] == period)
            phase[axis] = -std::numeric_limits<double>::min();
    return phase;
}

/// Rejects, through the reader, what AmbientWind does.
inline void restore(AmbientWind& wind, const AmbientRecord& record, const std::optional<LogProfile>& profile, Tiles& tiles,
                    Reader& reader) {
    Gusts gusts{.intensity = record.intensity, .length = record.length, .seed = record.seed};
    if (auto valid = validate(gusts); valid && !reader.rejected() && record.has_tile)
        gusts.tile = tiles.of_seed(record.seed);
    auto made = AmbientWind::create({.mean = record.mean, .profile = profile, .gusts = gusts, .ground = record.ground});
    if (!made)
        return reader.reject("its ambient wind cannot be used: ", made.error());
    made->set_gust_axes(record.gust_axes);
    made->set_phase(unwrapped(record.phase, made->period()));
    wind = *std::move(made);
}

void fields(auto& archive, Like<AmbientRecord> auto& record) {
    auto& [mean, ground, gust_axes, phase, intensity, length, has_tile, seed] = record;
    archive(mean, ground, gust_axes, phase, intensity, length, has_tile, seed);
}

} // namespace windrow::detail
