#include "vegetation/fur/coat_settings.h"

#include "vegetation/render/refusals.h"

#include <algorithm>
#include <cmath>

namespace windrow::vegetation::fur {
namespace {

using render::Refusals;
using windrow::Result;

void between(Refusals& refusals, const std::string& field, float value, float least, float most) {
    refusals.range(field.c_str(), static_cast<double>(value), static_cast<double>(least), static_cast<double>(most));
}

void above_zero(Refusals& refusals, const std::string& field, float value, float most) {
    if (value > 0.0f && value <= most)
        return;
    char text[160];
    std::snprintf(text, sizeof text, "%s is %g; give it a value above 0, at most %g.", field.c_str(), static_cast<double>(value),
                  static_cast<double>(most));
    refusals.add(text);
}

void colour(Refusals& refusals, const std::string& field, glm::vec3 value) {
    for (int channel = 0; channel < 3; ++channel)
        between(refusals, field + "." + "rgb"[channel], value[channel], 0.0f, 1.0f);
}

void place(Refusals& refusals, const std::string& field, glm::vec3 value, float most) {
    for (int axis = 0; axis < 3; ++axis)
        between(refusals, field + "." + "xyz"[axis], value[axis], -most, most);
}

void direction(Refusals& refusals, const std::string& field, glm::vec3 value) {
    const glm::dvec3 wide(value);
    const double square = wide.x * wide.x + wide.y * wide.y + wide.z * wide.z;
    if (!std::isfinite(square) || !(square > 1e-24))
        refusals.add(field + " has no length; give a finite vector that is not 0.");
}

/// What a part says of itself, under the name that it has here: its lines begin with `owner`.
void part(Refusals& refusals, const Result<void>& judged, const std::string& owner, const std::string& name) {
    if (judged)
        return;
    const std::string& text = judged.error();
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string line = text.substr(begin, end - begin);
        refusals.add(line.starts_with(owner) ? name + line.substr(owner.size()) : name + ": " + line);
        begin = end + 1;
    }
}

void judge(Refusals& refusals, const Comb& comb) {
    direction(refusals, "coat.comb.along", comb.along);
    between(refusals, "coat.comb.bend", comb.bend, 0.0f, 1.5f);
    between(refusals, "coat.comb.tousle", comb.tousle, 0.0f, 3.0f);
    above_zero(refusals, "coat.comb.tousle_size", comb.tousle_size, 100.0f);
}

void judge(Refusals& refusals, const Spot& spot, const std::string& name) {
    place(refusals, name + ".from", spot.from, 1e4f);
    place(refusals, name + ".to", spot.to, 1e4f);
    above_zero(refusals, name + ".radius", spot.radius, 1000.0f);
    between(refusals, name + ".soft", spot.soft, 0.0f, 1000.0f);
    between(refusals, name + ".length", spot.length, 0.0f, 1.0f);
    colour(refusals, name + ".colour", spot.colour);
    between(refusals, name + ".tint", spot.tint, 0.0f, 1.0f);
    between(refusals, name + ".glow", spot.glow, 0.0f, 100.0f);
}

void judge(Refusals& refusals, const CoatMaps& maps) {
    between(refusals, "coat.maps.influence_a", maps.influence_a, 0.0f, 1.0f);
    between(refusals, "coat.maps.influence_b", maps.influence_b, 0.0f, 1.0f);
    above_zero(refusals, "coat.maps.noise_tiles", maps.noise_tiles, 1000.0f);
    between(refusals, "coat.maps.bald_below", maps.bald_below, 0.0f, 1.0f);
    if (maps.noise_a.empty() != maps.noise_b.empty())
        refusals.add(std::string("coat.maps.") + (maps.noise_a.empty() ? "noise_a" : "noise_b") +
                     " is empty beside the other; give both, or none.");
}

void judge(Refusals& refusals, const CoatLook& look) {
    colour(refusals, "coat.look.root", look.root);
    colour(refusals, "coat.look.tip", look.tip);
    colour(refusals, "coat.look.second", look.second);
    colour(refusals, "coat.look.skin", look.skin);
    above_zero(refusals, "coat.look.second_size", look.second_size, 1e4f);
    above_zero(refusals, "coat.look.tip_power", look.tip_power, 10.0f);
    between(refusals, "coat.look.variation", look.variation, 0.0f, 0.9f);
    between(refusals, "coat.look.occlusion", look.occlusion, 0.0f, 5.0f);
    between(refusals, "coat.look.occlusion_bias", look.occlusion_bias, 0.0f, 1.0f);
    between(refusals, "coat.look.wrap", look.wrap, 0.0f, 1.0f);
    between(refusals, "coat.look.gloss", look.gloss, 0.0f, 10.0f);
    between(refusals, "coat.look.gloss_power", look.gloss_power, 1.0f, 1000.0f);
    between(refusals, "coat.look.sheen", look.sheen, 0.0f, 10.0f);
    between(refusals, "coat.look.sheen_power", look.sheen_power, 1.0f, 1000.0f);
    between(refusals, "coat.look.through", look.through, 0.0f, 1.0f);
    between(refusals, "coat.look.strand_normals", look.strand_normals, 0.0f, 1.0f);
    between(refusals, "coat.look.square_normals", look.square_normals, 0.0f, 1.0f);
    refusals.range("coat.look.cel_steps", look.cel_steps, 0, 8);
}

void judge(Refusals& refusals, const CoatLevels& levels) {
    // More than the coat has is no fault: a default would be one for a coat of few shells.
    refusals.range("coat.levels.least_shells", levels.least_shells, 2, 4096);
    above_zero(refusals, "coat.levels.full_until", levels.full_until, 1e6f);
    refusals.range("coat.levels.march", levels.march, 0, 16);
    refusals.range("coat.levels.shadow_shells", levels.shadow_shells, 0, 4096);
}

} // namespace

Result<void> validate(const CoatSettings& settings) {
    Refusals refusals;
    part(refusals, windrow::validate(settings.layers), "shells", "coat.layers");
    between(refusals, "coat.wriggle_hz", settings.wriggle_hz, -100.0f, 100.0f);
    between(refusals, "coat.wind_share", settings.wind_share, 0.0f, 100.0f);
    between(refusals, "coat.foot_push", settings.foot_push, 0.0f, 1.5707964f);
    part(refusals, validate(settings.strands), "strands", "coat.strands");
    judge(refusals, settings.comb);
    if (settings.spots.size() > k_most_spots)
        refusals.add("coat.spots are " + std::to_string(settings.spots.size()) + "; give at most " +
                     std::to_string(k_most_spots) + ".");
    else
        for (std::size_t n = 0; n < settings.spots.size(); ++n)
            judge(refusals, settings.spots[n], "coat.spots[" + std::to_string(n) + "]");
    judge(refusals, settings.maps);
    judge(refusals, settings.look);
    judge(refusals, settings.levels);
    if (settings.inertia)
        part(refusals, windrow::validate(*settings.inertia), "CascadeConfig::", "coat.inertia.");
    if (settings.cloud)
        part(refusals, validate(*settings.cloud), "clouds.", "coat.cloud.");
    return refusals.result();
}

} // namespace windrow::vegetation::fur
