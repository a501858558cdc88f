// Calls of scene.h.
#include "c_api/scene.h"

#include "c_api/source/tables.h"
#include "fluid/core/message.h"
#include "fluid/files/new_file.h"
#include "fluid/saved_parts.h"
#include "scene/scene_levels.h"
#include "scene/scene_reader.h"
#include "scene/scene_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

using namespace windrow;
using namespace windrow::c_api;

namespace windrow::c_api {

/// A handle of a wind around a scene's, which another takes the place of when the scene goes back.
struct WindAround final : windrow_wind {
    void hold(Wind& wind, std::shared_ptr<const Wind> its_owner) {
        control = cpu = &wind;
        reader = &wind;
        shared = std::move(its_owner);
    }
    long uses = 0; ///< of it, without those of the host
};

} // namespace windrow::c_api

struct windrow_scene {
    std::unique_ptr<const scene::Scene> scene; ///< stays where it is: the air refers to it
    scene::SceneLevels levels;                 ///< around the wind
    scene::SceneAir air;
    WindOf<Wind> wind;
    ParallelFor parallel_for{};
    std::vector<std::unique_ptr<WindAround>> around{}; ///< handles of the levels, from the nearest out
};

namespace {

constexpr const char* k_clock = "scene";
constexpr const char* k_wind = "wind";
constexpr const char* k_levels = "levels"; // none in scenes without

/// The handles name the levels of now.
void name_levels(windrow_scene& scene) {
    const Wind* inner = &scene.wind.air;
    for (std::size_t place = 0; place < scene.around.size(); ++place) {
        WindAround& around = *scene.around[place];
        around.hold(scene.levels.wind(scene.levels.size() - 1 - place), inner->outer());
        around.uses = around.shared.use_count();
        inner = around.cpu;
    }
}

/// Whether a wind of the host is inside one that is gone when the scene goes back.
bool is_around_others(const windrow_scene& scene) {
    return scene.wind.owned.use_count() > 2 || // its own two
           std::any_of(scene.around.begin(), scene.around.end(),
                       [](const auto& one) { return one->shared.use_count() > one->uses; });
}

/// Begins the air of a scene.
windrow_result begin(Result<scene::Scene> read, const windrow_parallel_for* parallel_for, windrow_scene** out) {
    if (!read)
        return done(read);
    for (const std::string& warning : read->warnings)
        warn(warning.c_str());
    auto scene = std::make_unique<const scene::Scene>(*std::move(read));
    const ParallelFor threads = loop_of(parallel_for);
    auto levels = scene::SceneLevels::create(*scene, threads);
    if (!levels)
        return done(levels);
    Config config = levels->inner_config();
    config.parallel_for = threads;
    auto wind = Wind::create(config, levels->nearest());
    if (!wind)
        return done(wind);
    const scene::Scene& there = *scene;
    auto made = std::unique_ptr<windrow_scene>(new windrow_scene{
        std::move(scene), *std::move(levels), scene::SceneAir::within(there), WindOf<Wind>(*std::move(wind)), threads});
    if (const auto begun = made->air.begin(made->wind.air); !begun)
        return done(begun);
    for (std::size_t n = 0; n < made->levels.size(); ++n)
        made->around.push_back(std::make_unique<WindAround>());
    name_levels(*made);
    *out = made.release();
    return WINDROW_OK;
}

/// What is in the air under a name, of the scene's motors or obstacles.
template <class Parts, class Id, class CId>
windrow_result find(const Parts& parts, const char* kind, std::string_view name, Id id, const auto& lives, CId* out) {
    if (lives(id)) {
        *out = {id.slot, id.generation, id.owner};
        return WINDROW_OK;
    }
    if (std::none_of(parts.begin(), parts.end(), [&](const auto& part) { return part.name == name; }))
        return fail(WINDROW_REJECTED, detail::message("the scene has no ", std::string_view(kind), " '", name, "'."));
    return fail(WINDROW_STALE, detail::message("the ", std::string_view(kind), " '", name, "' is not in the air now."));
}

template <class Parts>
const char* name_of_part(const Parts& parts, std::int32_t place) {
    return place >= 0 && static_cast<std::size_t>(place) < parts.size() ? parts[static_cast<std::size_t>(place)].name.c_str()
                                                                        : nullptr;
}

} // namespace

WINDROW_EXPORT windrow_result windrow_scene_load(const char* path, const windrow_parallel_for* parallel_for,
                                                 windrow_scene** scene) {
    if (scene != nullptr)
        *scene = nullptr;
    return call({{path, "path"}, {scene, "the place of the new handle"}},
                [&] { return begin(scene::read_scene(path_of(path)), parallel_for, scene); });
}
WINDROW_EXPORT windrow_result windrow_wind_write_scene(const windrow_wind* wind, const char* path, double duration,
                                                       double tick_hz) {
    return call({{wind, "wind"}, {path, "path"}}, [&]() -> windrow_result {
        const auto text = scene::write_scene(*wind->control, {.duration = duration, .tick_hz = tick_hz}, path_of(path));
        if (!text)
            return done(text);
        return done(detail::write_file("scene", path_of(path), *text));
    });
}
WINDROW_EXPORT windrow_result windrow_scene_parse(const char* text, uint64_t size, const char* path,
                                                  const windrow_parallel_for* parallel_for, windrow_scene** scene) {
    if (scene != nullptr)
        *scene = nullptr;
    return call({{text, "text"}, {path, "path"}, {scene, "the place of the new handle"}}, [&]() -> windrow_result {
        if (size > scene::k_max_scene_bytes)
            return fail(WINDROW_REJECTED,
                        detail::message("size is ", size, ": give at most ", scene::k_max_scene_bytes, " bytes."));
        return begin(scene::read_scene_text({text, static_cast<std::size_t>(size)}, path_of(path)), parallel_for, scene);
    });
}
WINDROW_EXPORT void windrow_scene_destroy(windrow_scene* scene) {
    delete scene;
}
WINDROW_EXPORT windrow_wind* windrow_scene_wind(windrow_scene* scene) {
    return value_of(scene, "scene", [&]() -> windrow_wind* { return &scene->wind; });
}
WINDROW_EXPORT int32_t windrow_scene_outer_count(const windrow_scene* scene) {
    return value_of(scene, "scene", [&] { return static_cast<std::int32_t>(scene->around.size()); });
}
WINDROW_EXPORT windrow_wind* windrow_scene_outer_wind(windrow_scene* scene, int32_t place) {
    return value_of(scene, "scene", [&]() -> windrow_wind* {
        const auto at = static_cast<std::size_t>(place);
        return place >= 0 && at < scene->around.size() ? scene->around[at].get() : nullptr;
    });
}

WINDROW_EXPORT windrow_result windrow_scene_step(windrow_scene* scene, windrow_diagnostics* diagnostics) {
    return call({{scene, "scene"}}, [&]() -> windrow_result {
        if (const windrow_result outcome = check_output(diagnostics); outcome != WINDROW_OK)
            return outcome;
        const scene::FrameTimes times = scene->scene->frame_times();
        const std::int64_t next = scene->air.steps() + 1;
        if (const auto around = scene->levels.advance_to(times.time_of_step(next)); !around)
            return done(around);
        if (const auto placed = scene->air.advance_to(scene->wind.air, times.time_of_step(next)); !placed)
            return done(placed);
        return windrow_wind_step(&scene->wind, times.length_of_step(next), diagnostics);
    });
}
WINDROW_EXPORT windrow_result windrow_scene_advance(windrow_scene* scene, double dt, windrow_advance* advance) {
    return call({{scene, "scene"}}, [&]() -> windrow_result {
        if (!(std::isfinite(static_cast<float>(dt)) && dt >= 0.0))
            return fail(WINDROW_REJECTED, detail::message("dt is ", dt, " s: give a finite time of 0 or more."));
        if (const windrow_result outcome = check_output(advance); outcome != WINDROW_OK)
            return outcome;
        const Ticks& ticks = scene->wind.air.config().ticks;
        if (const auto around = scene->levels.advance_to(scene->air.time() + dt, ticks.max_per_call / ticks.hz); !around)
            return done(around);
        if (const auto placed = scene->air.advance_to(scene->wind.air, scene->air.time() + dt); !placed)
            return done(placed);
        return windrow_wind_advance(&scene->wind, dt, advance, nullptr);
    });
}
WINDROW_EXPORT double windrow_scene_time(const windrow_scene* scene) {
    return value_of(scene, "scene", [&] { return scene->air.time(); });
}
WINDROW_EXPORT double windrow_scene_duration(const windrow_scene* scene) {
    return value_of(scene, "scene", [&] { return scene->scene->duration; });
}
WINDROW_EXPORT double windrow_scene_frames_per_second(const windrow_scene* scene) {
    return value_of(scene, "scene", [&] { return scene->scene->frames_per_second; });
}

WINDROW_EXPORT int32_t windrow_scene_motor_count(const windrow_scene* scene) {
    return value_of(scene, "scene", [&] { return static_cast<std::int32_t>(scene->scene->motors.size()); });
}
WINDROW_EXPORT const char* windrow_scene_motor_name(const windrow_scene* scene, int32_t place) {
    return value_of(scene, "scene", [&] { return name_of_part(scene->scene->motors, place); });
}
WINDROW_EXPORT int32_t windrow_scene_obstacle_count(const windrow_scene* scene) {
    return value_of(scene, "scene", [&] { return static_cast<std::int32_t>(scene->scene->obstacles.size()); });
}
WINDROW_EXPORT const char* windrow_scene_obstacle_name(const windrow_scene* scene, int32_t place) {
    return value_of(scene, "scene", [&] { return name_of_part(scene->scene->obstacles, place); });
}
WINDROW_EXPORT windrow_result windrow_scene_motor(const windrow_scene* scene, const char* name, windrow_motor_id* id) {
    return call({{scene, "scene"}, {name, "name"}, {id, "id"}}, [&] {
        return find(
            scene->scene->motors, "motor", name, scene->air.motor(name, scene->wind.air.motors()),
            [&](MotorId found) { return scene->wind.air.motors().find(found) != nullptr; }, id);
    });
}
WINDROW_EXPORT windrow_result windrow_scene_obstacle(const windrow_scene* scene, const char* name, windrow_obstacle_id* id) {
    return call({{scene, "scene"}, {name, "name"}, {id, "id"}}, [&] {
        return find(
            scene->scene->obstacles, "obstacle", name, scene->air.obstacle(name, scene->wind.air.obstacles()),
            [&](ObstacleId found) { return scene->wind.air.obstacles().find(found) != nullptr; }, id);
    });
}

WINDROW_EXPORT windrow_result windrow_scene_save(const windrow_scene* scene, windrow_bytes** bytes) {
    if (scene == nullptr)
        return fail_null("scene");
    return create(bytes, [&]() -> Result<std::vector<std::byte>> {
        const auto wind = scene->wind.air.save();
        if (!wind)
            return wind.failure();
        const std::vector<std::byte> clock = scene->air.save();
        const auto levels = scene->levels.save();
        if (!levels)
            return levels.failure();
        const std::array parts{SavedPart{k_clock, clock}, SavedPart{k_wind, *wind}, SavedPart{k_levels, *levels}};
        return join_parts(std::span(parts).first(scene->levels.size() > 0 ? 3 : 2));
    });
}
WINDROW_EXPORT windrow_result windrow_scene_restore(windrow_scene* scene, const void* bytes, uint64_t size) {
    return call({{scene, "scene"}, {bytes, "bytes"}}, [&]() -> windrow_result {
        if (is_around_others(*scene))
            return fail(WINDROW_REJECTED,
                        "a wind of the host is inside the scene's wind: destroy it before the scene goes back.");
        const auto parts = split_parts({static_cast<const std::byte*>(bytes), static_cast<std::size_t>(size)});
        if (!parts)
            return done(parts);
        const auto clock = find_part(*parts, k_clock), air = find_part(*parts, k_wind);
        if (!clock || !air)
            return done(clock ? air : clock);
        const bool has_levels = std::any_of(parts->begin(), parts->end(), [](const auto& part) { return part.name == k_levels; });
        const auto around =
            has_levels ? find_part(*parts, k_levels) : Result<std::span<const std::byte>>(std::span<const std::byte>{});
        auto levels = scene::SceneLevels::load(*scene->scene, scene->parallel_for, *around);
        if (!levels)
            return done(levels);
        auto wind = Wind::load(*air, scene->parallel_for, levels->nearest());
        if (!wind)
            return done(wind);
        if (const auto placed = scene->air.load(*clock); !placed)
            return done(placed);
        scene->wind.air = *std::move(wind);
        scene->levels = *std::move(levels);
        name_levels(*scene);
        return WINDROW_OK;
    });
}
