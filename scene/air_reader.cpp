#include "scene/air_reader.h"

#include "fluid/message.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

namespace windrow::scene {
namespace {

using detail::message;
using nlohmann::json;

Side read_side(JsonObject& sides, const char* key) {
    const Side fallback;
    const std::initializer_list<Word<SideKind>> k_kinds = {{"open", SideKind::open},
                                                           {"free_slip", SideKind::free_slip},
                                                           {"no_slip", SideKind::no_slip},
                                                           {"periodic", SideKind::periodic}};
    const json* const value = sides.value().contains(key) ? &sides.value()[key] : nullptr;
    // A bare word is the common case; the object is for a wall that moves.
    if (value != nullptr && value->is_object()) {
        JsonObject side = sides.object(key);
        Side read;
        read.kind = side.word("kind", fallback.kind, k_kinds);
        read.wall_velocity = glm::vec3(side.vector("wall_velocity", glm::dvec3(fallback.wall_velocity), k_velocity_rule));
        side.finish();
        return read;
    }
    return {.kind = sides.word(key, fallback.kind, k_kinds)};
}

Sides read_sides(JsonObject sides) {
    Sides read;
    read.x_low = read_side(sides, "x_low");
    read.x_high = read_side(sides, "x_high");
    read.y_low = read_side(sides, "y_low");
    read.y_high = read_side(sides, "y_high");
    read.z_low = read_side(sides, "z_low");
    read.z_high = read_side(sides, "z_high");
    sides.finish();
    return read;
}

std::optional<LogProfile> read_profile(JsonObject profile, bool given) {
    LogProfile read;
    read.roughness_length = profile.real("roughness_length", read.roughness_length, {.least = 1e-6, .most = 100.0, .unit = "m"});
    read.reference_height = profile.real("reference_height", read.reference_height, {.least = 0.01, .most = 1e4, .unit = "m"});
    profile.finish();
    return given ? std::optional(read) : std::nullopt;
}

std::optional<Canopy> read_canopy(JsonObject canopy, bool given) {
    Canopy read;
    read.height = canopy.real("height", read.height, {.least = 0.0, .most = 1000.0, .unit = "m"});
    read.drag = canopy.real("drag", read.drag, {.least = 0.0, .most = 1000.0, .unit = "1/m"});
    canopy.finish();
    return given ? std::optional(read) : std::nullopt;
}

Gusts read_gusts(JsonObject gusts) {
    Gusts read;
    read.intensity = gusts.real("intensity", read.intensity, {.least = 0.0, .most = 1.0});
    read.length = gusts.real("length", read.length, {.least = 0.01, .most = 1e6, .unit = "m"});
    read.seed = static_cast<std::uint32_t>(
        gusts.integer("seed", static_cast<int>(read.seed), {.least = 0.0, .most = std::numeric_limits<int>::max()}));
    gusts.finish();
    return read;
}

} // namespace

ReadAir read_air(JsonObject& air) {
    const std::size_t faults_before = air.log().faults();
    ReadAir read;
    Config& config = read.config;
    config.cells = air.integers("cells", config.cells, {.least = 1, .most = k_max_axis_cells});
    config.cell_size = air.real("cell_size", config.cell_size, {.least = 1e-6, .most = 1e6, .unit = "m"});
    config.sides = read_sides(air.object("sides"));
    if (const auto centre = air.optional_vector("centre", k_place_rule)) {
        config.centre = *centre;
        read.has_centre = true;
    }
    config.follow_axes = air.optional_flags("follow_axes");
    config.ambient = glm::vec3(air.vector("ambient", glm::dvec3(config.ambient), k_velocity_rule));
    config.profile = read_profile(air.object("profile"), air.value().contains("profile"));
    config.gusts = read_gusts(air.object("gusts"));
    config.canopy = read_canopy(air.object("canopy"), air.value().contains("canopy"));
    config.rim = air.real("rim", config.rim, {.least = 0.0, .most = 64.0});
    config.viscosity = air.real("viscosity", config.viscosity, {.least = 0.0, .most = 1e9, .unit = "m^2/s"});
    config.settling_time = air.real("settling_time", config.settling_time, {.least = 0.0, .most = 1e9, .unit = "s"});
    config.sleep_speed = air.real("sleep_speed", config.sleep_speed, {.least = 0.0, .most = 1e4, .unit = "m/s"});
    config.scheme =
        air.word("scheme", config.scheme, {{"second_order", Scheme::second_order}, {"stable_fluids", Scheme::stable_fluids}});
    config.interpolation =
        air.word("interpolation", config.interpolation, {{"cubic", Interpolation::cubic}, {"linear", Interpolation::linear}});
    config.max_cfl = air.real("max_cfl", config.max_cfl, {.least = 0.0, .most = 1e6, .above_least = true});
    config.max_substeps = air.integer("max_substeps", config.max_substeps, {.least = 1, .most = 64});
    air.finish();
    if (air.log().faults() == faults_before)
        check_air(config, air.path(), air.log());
    return read;
}

void check_air(const Config& config, const std::string& path, ReadLog& log) {
    const auto valid = validate(config);
    if (valid)
        return;
    // The library's lines begin with the name of a field of Config, and the scene's keys bear the same names.
    std::string_view lines = valid.error();
    while (!lines.empty()) {
        const std::size_t end = lines.find('\n');
        log.refuse_as_is(message(log.file(), ": ", path, ".", lines.substr(0, end)));
        lines.remove_prefix(end == lines.npos ? lines.size() : end + 1);
    }
}

} // namespace windrow::scene
