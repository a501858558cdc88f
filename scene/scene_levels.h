// The winds around the box of a scene (Scene::outer), played with it: each in its own cells and ticks, all by one clock.
//
//     auto levels = scene::SceneLevels::create(scene, threads);
//     auto wind = Wind::create(levels->inner_config(), levels->nearest());
//     auto air = scene::SceneAir::within(scene);
//     (void)air.begin(*wind);
//     for (int tick = 1; tick <= ticks; ++tick) {
//         (void)levels->advance_to(tick / scene.tick_hz);          // from the outermost in
//         (void)air.advance_to(*wind, tick / scene.tick_hz);
//         wind->step(1.0 / scene.tick_hz);
//     }
#pragma once

#include "fluid/wind.h"
#include "scene/scene_air.h"

#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace windrow::scene {

class SceneLevels {
  public:
    /// At the scene's begin; none where Scene::outer is empty. The scene must outlive it.
    [[nodiscard]] static Result<SceneLevels> create(const Scene& scene, const ParallelFor& threads);
    /// Goes on where `save` was called. Rejects other numbers of levels and what Wind::load and SceneAir::load reject.
    [[nodiscard]] static Result<SceneLevels> load(const Scene& scene, const ParallelFor& threads,
                                                  std::span<const std::byte> bytes);

    /// All that the scene has in the air is placed in each level, and each advances to `end` [s], by at most `longest` [s]: a wind
    /// inside that drops more drops it of all. To be called before the same of the inner air.
    Result<void> advance_to(double end, double longest = std::numeric_limits<double>::infinity());
    /// Air before the first frame: `dt` [s] with what acts then, and nothing moves. To be called before each step of
    /// SceneAir::warm_up.
    Result<void> pass(double dt);

    /// The wind around the scene's own; null: none.
    [[nodiscard]] std::shared_ptr<const Wind> nearest() const { return levels_.empty() ? nullptr : levels_.back().wind; }
    /// Scene::air as Wind::create takes it beside nearest().
    [[nodiscard]] Config inner_config() const;
    [[nodiscard]] std::size_t size() const { return levels_.size(); }
    /// From the outermost in.
    [[nodiscard]] const Wind& wind(std::size_t level) const { return *levels_.at(level).wind; }
    [[nodiscard]] Wind& wind(std::size_t level) { return *levels_.at(level).wind; }
    /// Clock and handles in that wind.
    [[nodiscard]] SceneAir& air(std::size_t level) { return levels_.at(level).air; }

    [[nodiscard]] Result<std::vector<std::byte>> save() const;

    /// The same in memory, of a host that goes back in time (SceneAir::state).
    struct Kept {
        std::vector<std::byte> wind{}; ///< Wind::save
        SceneAir::State air{};
    };
    /// From the outermost in.
    [[nodiscard]] Result<std::vector<Kept>> keep() const;
    /// Goes on where `keep` was called. Takes what was appended to the scene since then, as SceneAir::restore does.
    [[nodiscard]] static Result<SceneLevels> restore(const Scene& scene, const ParallelFor& threads, std::span<const Kept> kept);

  private:
    struct Level {
        std::shared_ptr<Wind> wind;
        SceneAir air;
    };
    explicit SceneLevels(const Scene& scene) : scene_(&scene) {}
    [[nodiscard]] Config config_of(std::size_t place) const;
    /// The next one in, from what Wind::save returned.
    Result<void> add(std::span<const std::byte> wind, const ParallelFor& threads, SceneAir air);

    const Scene* scene_;
    std::vector<Level> levels_; ///< from the outermost in
};

} // namespace windrow::scene
