#include "scene/scene_levels.h"

#include "fluid/core/message.h"
#include "fluid/saved_parts.h"

#include <algorithm>
#include <string>
#include <utility>

namespace windrow::scene {
namespace {

using detail::message;

std::string key_of(std::size_t place) {
    std::string key = "$.air";
    for (std::size_t n = 0; n <= place; ++n)
        key += ".outer";
    return key;
}

// What a wind takes from the outermost one.
void leave_out_ambient(Config& config) {
    config.ambient = glm::vec3(0.0f);
    config.profile.reset();
    config.gusts = {};
}

} // namespace

// Of Scene::outer at a place: as the scene's air, in its own box.
Config SceneLevels::config_of(std::size_t place) const {
    const SceneLevel& level = scene_->outer[place];
    Config config = scene_->air;
    config.cells = level.cells;
    config.cell_size = level.cell_size;
    config.rows = level.rows;
    config.blend_width = level.blend_width;
    config.ticks = level.ticks;
    if (place + 1 < scene_->outer.size())
        leave_out_ambient(config);
    return config;
}

Config SceneLevels::inner_config() const {
    Config config = scene_->air;
    if (!levels_.empty())
        leave_out_ambient(config);
    return config;
}

Result<SceneLevels> SceneLevels::create(const Scene& scene, const ParallelFor& threads) {
    SceneLevels made(scene);
    for (std::size_t left = scene.outer.size(); left > 0; --left) {
        const std::size_t place = left - 1;
        Config config = made.config_of(place);
        config.parallel_for = threads;
        auto wind = Wind::create(config, made.nearest());
        if (!wind)
            return wind.failure().after(message(scene.file.string(), ": ", key_of(place), ": "));
        Level level{std::make_shared<Wind>(*std::move(wind)), SceneAir(scene, place)};
        if (auto begun = level.air.begin(*level.wind); !begun)
            return begun.failure();
        made.levels_.push_back(std::move(level));
    }
    return made;
}

namespace {

// A frame may take more ticks than a call does.
void advance(Wind& wind, double dt) {
    const Ticks& ticks = wind.config().ticks;
    const double most = ticks.max_per_call / ticks.hz;
    for (; dt > most; dt -= most)
        (void)wind.advance(most);
    (void)wind.advance(dt);
}

} // namespace

Result<void> SceneLevels::advance_to(double end, double longest) {
    for (Level& level : levels_) {
        const double begin = level.air.time();
        if (auto placed = level.air.advance_to(*level.wind, end); !placed)
            return placed;
        advance(*level.wind, std::min(end - begin, longest));
    }
    return {};
}

Result<void> SceneLevels::pass(double dt) {
    for (Level& level : levels_) {
        if (auto held = level.air.hold(*level.wind); !held)
            return held;
        advance(*level.wind, dt);
    }
    return {};
}

Result<std::vector<std::byte>> SceneLevels::save() const {
    std::vector<std::vector<std::byte>> bytes;
    std::vector<SavedPart> parts;
    for (const Level& level : levels_) {
        auto wind = level.wind->save();
        if (!wind)
            return wind.failure();
        bytes.push_back(*std::move(wind));
        bytes.push_back(level.air.save());
    }
    std::vector<std::string> names;
    for (std::size_t n = 0; n < bytes.size(); ++n)
        names.push_back(message(n % 2 == 0 ? "wind " : "air ", n / 2));
    for (std::size_t n = 0; n < bytes.size(); ++n)
        parts.push_back({names[n], bytes[n]});
    return join_parts(parts);
}

Result<SceneLevels> SceneLevels::load(const Scene& scene, const ParallelFor& threads, std::span<const std::byte> bytes) {
    SceneLevels made(scene);
    if (scene.outer.empty() && bytes.empty()) // saved before there were any
        return made;
    const auto parts = split_parts(bytes);
    if (!parts)
        return parts.failure();
    if (parts->size() != 2 * scene.outer.size())
        return Error{message("the levels that were saved are ", parts->size() / 2, ", and ", scene.file.string(), " has ",
                             scene.outer.size(), ": load them with the scene that they were saved with.")};
    for (std::size_t n = 0; n < scene.outer.size(); ++n) {
        SceneAir air(scene, scene.outer.size() - 1 - n);
        if (auto loaded = air.load((*parts)[2 * n + 1].bytes); !loaded)
            return loaded.failure();
        if (auto added = made.add((*parts)[2 * n].bytes, threads, std::move(air)); !added)
            return added.failure();
    }
    return made;
}

Result<void> SceneLevels::add(std::span<const std::byte> bytes, const ParallelFor& threads, SceneAir air) {
    auto wind = Wind::load(bytes, threads, nearest());
    if (!wind)
        return wind.failure();
    levels_.push_back({std::make_shared<Wind>(*std::move(wind)), std::move(air)});
    return {};
}

Result<std::vector<SceneLevels::Kept>> SceneLevels::keep() const {
    std::vector<Kept> kept;
    for (const Level& level : levels_) {
        auto wind = level.wind->save();
        if (!wind)
            return wind.failure();
        kept.push_back({*std::move(wind), level.air.state()});
    }
    return kept;
}

Result<SceneLevels> SceneLevels::restore(const Scene& scene, const ParallelFor& threads, std::span<const Kept> kept) {
    SceneLevels made(scene);
    for (std::size_t n = 0; n < kept.size(); ++n) {
        SceneAir air(scene, kept.size() - 1 - n);
        air.restore(kept[n].air.unowned());
        if (auto added = made.add(kept[n].wind, threads, std::move(air)); !added)
            return added.failure();
    }
    return made;
}

} // namespace windrow::scene
