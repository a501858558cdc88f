#include "vegetation/trees/stand_settings.h"

#include "fluid/core/validation.h"
#include "vegetation/trees/chance.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <string>
#include <unordered_map>

namespace windrow::vegetation::trees {
namespace {

using windrow::detail::FieldPath, windrow::detail::Reasons;

constexpr int k_tries = 40; // a tree, before the region counts as full

// Which of the places so far stand near: a grid whose cells are as wide as trees must be apart.
class Neighbours {
  public:
    explicit Neighbours(double apart) : apart_(apart), cell_(std::max(apart, 0.01)) {}

    [[nodiscard]] bool any_near(glm::dvec2 at) const {
        const glm::i64vec2 here = cell(at);
        for (std::int64_t z = -1; z <= 1; ++z)
            for (std::int64_t x = -1; x <= 1; ++x) {
                const auto found = cells_.find(key({here.x + x, here.y + z}));
                if (found != cells_.end() && std::any_of(found->second.begin(), found->second.end(),
                                                         [&](glm::dvec2 p) { return glm::distance(p, at) < apart_; }))
                    return true;
            }
        return false;
    }
    void add(glm::dvec2 at) { cells_[key(cell(at))].push_back(at); }

  private:
    [[nodiscard]] glm::i64vec2 cell(glm::dvec2 at) const { return glm::i64vec2(glm::floor(at / cell_)); }
    [[nodiscard]] static std::int64_t key(glm::i64vec2 cell) { return cell.x * 0x1fffffffffffLL + cell.y; }

    double apart_, cell_; // [m]
    std::unordered_map<std::int64_t, std::vector<glm::dvec2>> cells_{};
};

} // namespace

windrow::Result<void> validate(const TreeScatter& scatter) {
    return windrow::detail::validate_settings(scatter, "scatter");
}

void check_rules(Reasons& reasons, const FieldPath& path, const TreeScatter& scatter) {
    for (int axis = 0; axis < 2; ++axis)
        if (!(scatter.high[axis] > scatter.low[axis]))
            reasons.add(FieldPath{&path, axis == 0 ? "high.x" : "high.z"}, " is ", scatter.high[axis], " m: give more than ",
                        FieldPath{&path, axis == 0 ? "low.x" : "low.z"}, ", which is ", scatter.low[axis], " m.");
}

windrow::Result<void> validate(const TreeStandSettings& stand) {
    Reasons reasons;
    for (const windrow::Result<void>& judged :
         {validate(stand.kind.tree), validate(stand.kind.look), validate(stand.kind.levels)})
        reasons.add_all_of(judged);
    windrow::detail::check_settings(reasons, {nullptr, "stand"}, stand);
    return reasons.outcome();
}

windrow::Result<std::vector<TreePlace>> scatter(const TreeScatter& s, const GroundHeight& ground) {
    if (auto judged = validate(s); !judged)
        return judged.failure();
    Chance chance(s.seed, 6);
    Neighbours neighbours(s.apart);
    std::vector<TreePlace> places;
    const auto wanted = static_cast<std::size_t>(s.count);
    for (std::size_t tries = 0; places.size() < wanted && tries < wanted * k_tries; ++tries) {
        const glm::dvec2 share(static_cast<double>(chance.share()), static_cast<double>(chance.share()));
        const glm::dvec2 at = s.low + share * (s.high - s.low);
        const float grove =
            numerics::windrow_place_noise(glm::vec2((at - s.low) / s.grove_length) + 17.0f * static_cast<float>(s.seed % 64u));
        const float stands = 1.0f - s.groves + s.groves * glm::smoothstep(0.5f, 0.7f, grove);
        const float drawn = chance.share(), size = chance.around(s.size_spread), yaw = chance.share();
        const bool cleared = std::any_of(s.clear.begin(), s.clear.end(), [&](const ClearCircle& circle) {
            return glm::distance(circle.centre, at) < circle.radius;
        });
        if (cleared || drawn >= stands || neighbours.any_near(at))
            continue;
        neighbours.add(at);
        places.push_back({.base = {at.x, ground(at.x, at.y), at.y}, .size = 1.0f + size, .yaw_deg = 360.0f * yaw});
    }
    return places;
}

windrow::Result<std::vector<TreePlace>> places_of(const TreeStandSettings& stand, const GroundHeight& ground) {
    if (auto judged = validate(stand); !judged)
        return judged.failure();
    std::vector<TreePlace> places = stand.places;
    auto scattered = scatter(stand.scatter, ground);
    if (!scattered)
        return scattered.failure();
    places.insert(places.end(), scattered->begin(), scattered->end());
    return places;
}

} // namespace windrow::vegetation::trees
