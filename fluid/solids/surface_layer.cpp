#include "fluid/solids/surface_layer.h"

#include "fluid/portable_math.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace windrow {
namespace {

constexpr float k_karman = 0.4f;
// Least height [cells] of a cell's centre over a surface that cuts it: nearer, the air is at rest anyway.
constexpr float k_lowest = 0.01f;

float drag(float height, float roughness) {
    const float stress = k_karman / numerics::log1p(height / roughness);
    return stress * stress;
}

} // namespace

float roughness_at(const Roughness& roughness, glm::dvec3 place) {
    if (!roughness.map)
        return roughness.length;
    const RoughnessMap& map = *roughness.map;
    const glm::vec2 on_map(place.x - map.position.x, place.z - map.position.z);
    return std::max(map.scale.y * map.lengths->height(on_map / glm::vec2(map.scale.x, map.scale.z)), k_smoothest);
}

SurfaceLayer::SurfaceLayer(const Box& box, const Roughness& roughness)
    : box_(box), roughness_(roughness), faces_(static_cast<std::size_t>(box.cells.x) * static_cast<std::size_t>(box.cells.y + 1) *
                                               static_cast<std::size_t>(box.cells.z)),
      wind_drag_(static_cast<std::size_t>(box.cells.y)) {
    wind_mixing_.reserve(wind_drag_.size() + 1);
}

// [m] From the centre of a row to that of the next one.
float SurfaceLayer::distance_above(int row) const {
    return box_.rows ? static_cast<float>(box_.rows->height(row + 1) - box_.rows->height(row)) : box_.cell_size;
}

// Of the face above a cell of a row at a height [m]. From 8 cells on a series of the logarithm, whose rest is below a float's rounding.
float SurfaceLayer::mixing(int row, float height, float roughness) const {
    const float distance = distance_above(row), t = (height + roughness) / distance;
    const float length =
        k_karman * (t > 8.0f ? t + 0.5f - (1.0f / 12 - (1.0f / 24 - 19.0f / 720 / t) / t) / t : 1.0f / numerics::log1p(1.0f / t));
    const float most = roughness_.longest_mixing > 0.0f ? roughness_.longest_mixing / distance : length;
    return std::min(length, most) * std::min(length, most);
}

// [m] Of a row of cells over a surface that is `height` below the row `first`.
float SurfaceLayer::height_of(int row, int first, float height) const {
    if (box_.rows)
        return height + static_cast<float>(box_.rows->height(row) - box_.rows->height(first));
    return height + static_cast<float>(row - first) * box_.cell_size;
}

void SurfaceLayer::renew(const AmbientWind& around, const Window& window, const Boundaries& boundaries, const Solids* solids,
                         bool placed, const ParallelFor& parallel_for) {
    Place place{window.origin_cells, around.ground(), boundaries.y_low.kind, boundaries.y_high.kind};
    if (!roughness_.map) // and obstacles that move with the box are placed anew
        place.origin_cells.x = place.origin_cells.z = 0;
    if (place == place_ && !placed)
        return;
    place_ = place;
    ++version_;
    box_.boundaries = boundaries;
    renew_wind(around, window);
    parallel_for(box_.cells.z, [&](int plane) { renew_plane(window, solids, plane); });
}

void SurfaceLayer::renew_wind(const AmbientWind& around, const Window& window) {
    wind_height_ = static_cast<float>(window.centre(0, 0, 0).y - around.ground());
    wind_mixing_.clear();
    std::fill(wind_drag_.begin(), wind_drag_.end(), 0.0f);
    const auto& profile = around.settings().profile;
    if (!profile)
        return;
    for (int j = 0; j <= box_.cells.y; ++j) {
        const float below = height_of(j - 1, 0, wind_height_), height = height_of(j, 0, wind_height_);
        wind_mixing_.push_back(below > 0.0f ? mixing(j - 1, below, profile->roughness_length) : 0.0f);
        if (j < box_.cells.y && height > 0.0f)
            wind_drag_[j] = drag(height, profile->roughness_length);
    }
}

bool SurfaceLayer::leaves_free(const Solids& solids, int i, int k) const {
    bool free = solids.rooms().empty();
    for (int j = 0; j < box_.cells.y && free; ++j)
        free = solids.untouched(static_cast<std::uint32_t>(box_.index(i, j, k)));
    return free;
}

// [cells] Of a cell of air whose lower part a ground fills, that no cell below is inside of.
float SurfaceLayer::over_grounds(const Solids& solids, glm::ivec3 cell) const {
    float height = std::numeric_limits<float>::max();
    if (solids.untouched(static_cast<std::uint32_t>(box_.index(cell.x, cell.y, cell.z))))
        return height;
    for (std::size_t n = 0; n < solids.bodies().size(); ++n)
        if (std::holds_alternative<Ground>(solids.bodies()[n].shape))
            height = std::min(height, solids.height_over(n, cell));
    return height;
}

void SurfaceLayer::renew_plane(const Window& window, const Solids* solids, int plane) {
    const glm::ivec3 cells = box_.cells;
    const float h = box_.cell_size;
    const bool floor = box_.boundaries.y_low.solid(), slips = box_.boundaries.y_low.kind == BoundaryKind::free_slip,
               open_below = box_.boundaries.y_low.kind == BoundaryKind::open,
               open_above = box_.boundaries.y_high.kind == BoundaryKind::open;
    const auto lowest = [this](int row) {
        return box_.rows ? k_lowest / box_.rows->scales()[static_cast<std::size_t>(row)] : k_lowest;
    };
    float* const faces = faces_.data() + static_cast<std::size_t>(plane) * static_cast<std::size_t>(cells.y + 1) * cells.x;
    const auto face = [&](int i, int j) -> float& { return faces[static_cast<std::size_t>(j) * cells.x + i]; };
    int free = -1; // a column without obstacles, as are all others without, where no map is
    for (int i = 0; i < cells.x; ++i) {
        const bool is_free = !roughness_.map && (solids == nullptr || leaves_free(*solids, i, plane));
        if (is_free && free >= 0) {
            for (int j = 0; j <= cells.y; ++j)
                face(i, j) = face(free, j);
            continue;
        }
        if (is_free)
            free = i;
        const float length = roughness_at(roughness_, window.centre(i, 0, plane));
        int first = 0; // row over the last surface, and its height
        float first_height = floor ? box_.centre(0, 0, 0).y : wind_height_;
        bool air_below = false;
        for (int j = 0; j <= cells.y; ++j) {
            const auto above = static_cast<std::uint32_t>(box_.index(i, std::min(j, cells.y - 1), plane)),
                       below = static_cast<std::uint32_t>(box_.index(i, std::max(j - 1, 0), plane));
            const bool air = j < cells.y && !(solids != nullptr && (solids->inside(above) || solids->in_room(above)));
            const ClosedFace* const closed = j > 0 && j < cells.y && solids != nullptr ? solids->face(below, 1) : nullptr;
            const bool from_body = j > 0 && j < cells.y && solids != nullptr && solids->inside(below);
            float passes = 0.0f;
            if (air && (from_body || (closed != nullptr && closed->closed >= 0.5f))) {
                const std::size_t body = from_body ? solids->body_in(below) : closed->body;
                first = j;
                first_height = std::max(solids->height_over(body, {i, j, plane}), lowest(j)) * h;
                if (solids->bodies()[body].surface == Surface::free_slip && !solids->bodies()[body].moves())
                    passes = -drag(first_height, length);
            } else if (j == 0 && floor) {
                if (solids != nullptr)
                    first_height = std::min(first_height, h * std::max(over_grounds(*solids, {i, 0, plane}), lowest(0)));
                passes = air && slips ? -drag(first_height, length) : 0.0f;
            } else if ((air || (j == cells.y && open_above)) && (air_below || (j == 0 && open_below))) {
                const float height = height_of(j - 1, first, first_height);
                if (height > 0.0f)
                    passes = mixing(j - 1, height, length);
            }
            face(i, j) = passes;
            air_below = air;
        }
    }
}

std::size_t SurfaceLayer::memory_bytes() const {
    return (faces_.capacity() + wind_mixing_.capacity() + wind_drag_.capacity()) * sizeof(float);
}

} // namespace windrow
