// Frames of a meadow in the wind, by stage, and three pictures: a walker and a fan in gusts, drawn by the renderer of vegetation/.
#include "cli/device_report/png.h"
#include "cli/device_report/report_section.h"
#include "cli/output_file.h"
#include "fluid/core/message.h"
#include "fluid/vulkan/wind.h"
#include "vegetation/render/grass_layer.h"
#include "vegetation/render/renderer.h"
#include "vegetation/render/wind_arrows.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace windrow::cli {
namespace {

using detail::message;
namespace engine = vegetation::engine;
namespace render = vegetation::render;

constexpr glm::ivec2 k_full_hd{1920, 1080};
constexpr int k_blades[] = {250'000, 1'000'000, 4'000'000};
constexpr const char* k_drawn = "frame of 1920 x 1080";
constexpr double k_share = 0.24;                // of the section's time, for each number of blades
constexpr int k_steps = 90, k_quick_steps = 45; // of the wind before it is drawn: three seconds, half of them
constexpr double k_step = 1.0 / 30.0;           // [s]
constexpr double k_field = 100.0;               // [m] a side of the ground
constexpr glm::dvec3 k_walk{4.0, 0.0, 0.0};     // [m/s]
constexpr glm::dvec3 k_chest{0.0, 0.8, 0.0};

render::Scene meadow_scene() {
    render::Scene scene;
    scene.camera.far = 160.0f;
    scene.camera.exposure = 0.8f;
    scene.plants = {.stalk = {}, .width = 0.012f, .view_bend = 0.4f};
    scene.wind.wind = {.cells = {48, 12, 48},
                       .cell_size = 0.5f,
                       .boundaries = Boundaries::open_over_floor(),
                       .centre = {0.0, 3.0, 0.0},
                       .ambient = {-1.0f, 0.0f, 3.2f},
                       .profile = LogProfile{},
                       .gusts = {.intensity = 0.35f, .length = 10.0f}};
    scene.wind.sampling = {.detail = 0.5f, .detail_length = 0.5f};
    return scene;
}

render::Camera eye_at(render::Camera camera, glm::dvec3 position, glm::dvec3 ahead) {
    camera.position = position;
    camera.target = position + ahead;
    return camera;
}

class Meadow {
  public:
    static Result<std::unique_ptr<Meadow>> create(vulkan::OwnDevice& own);

    /// Steps the wind until the walker has come halfway. Ends early where `stopped` returns true.
    Result<void> blow(int steps, const std::function<bool()>& stopped);

    /// Passes for pictures of a size, with as many blades, or with a slice of the wind.
    struct Stage {
        std::unique_ptr<render::Renderer> renderer;
        std::unique_ptr<render::GrassLayer> grass;
        std::unique_ptr<render::WindArrows> slice;
    };
    Result<Stage> stage(glm::ivec2 size, int samples, int blades);
    /// A frame, waited for; its picture is copied where it is wanted.
    Result<void> draw(Stage& stage, const render::Camera& camera, bool copied);

    [[nodiscard]] render::Camera walking() const { return eye_at(scene_.camera, {0.0, 2.2, 8.5}, {0.0, -0.2, -1.0}); }
    [[nodiscard]] render::Camera above() const { return eye_at(scene_.camera, {0.0, 11.0, 5.5}, {0.0, -1.0, -0.62}); }
    [[nodiscard]] render::Camera over_all() const { return eye_at(scene_.camera, {0.0, 25.0, 12.0}, {0.0, -1.0, -0.45}); }

  private:
    Meadow(std::unique_ptr<engine::Device> device, vulkan::Wind wind, std::unique_ptr<engine::Frames> frames)
        : device_(std::move(device)), wind_(std::move(wind)), frames_(std::move(frames)) {}
    Result<void> step(const engine::Frame& frame);

    render::Scene scene_ = meadow_scene();
    std::unique_ptr<engine::Device> device_; // before what is made from it
    vulkan::Wind wind_;
    std::unique_ptr<engine::Frames> frames_;
    MotorId walker_{};
};

Result<std::unique_ptr<Meadow>> Meadow::create(vulkan::OwnDevice& own) {
    auto device = engine::Device::adopt(own.host(), own.queue());
    if (!device)
        return device.failure();
    auto wind = vulkan::Wind::create(own.host(), meadow_scene().wind.wind, {.frames_in_flight = engine::k_frames_in_flight});
    if (!wind)
        return wind.failure();
    auto frames = engine::Frames::create(**device);
    if (!frames)
        return frames.failure();
    const auto fan = wind->motors().add(JetMotor{.position = {6.0, 1.2, -5.0},
                                                 .direction = {-0.98f, -0.10f, 0.17f},
                                                 .length = 7.0f,
                                                 .start_radius = 0.9f,
                                                 .end_radius = 1.6f,
                                                 .law = Drive{.speed = 12.0f, .rate = 8.0f}});
    const auto walker = wind->motors().add(WakeMotor{.position = k_chest, .radius = 0.9f, .law = WakeDrive{.per_metre = 20.0f}});
    if (!fan || !walker)
        return fan ? walker.failure() : fan.failure();
    std::unique_ptr<Meadow> made(new Meadow(*std::move(device), *std::move(wind), *std::move(frames)));
    made->walker_ = *walker;
    return made;
}

Result<void> Meadow::step(const engine::Frame& frame) {
    const auto recorded = wind_.record_step(frame.commands, {.dt = k_step, .slot = frame.slot});
    return recorded ? Result<void>() : recorded.failure();
}

Result<void> Meadow::blow(int steps, const std::function<bool()>& stopped) {
    for (int n = 1; n <= steps && !stopped(); ++n) {
        if (auto moved = wind_.motors().move(walker_, k_step * (n - steps / 2) * k_walk + k_chest); !moved)
            return moved;
        const auto frame = frames_->begin();
        if (!frame)
            return frame.failure();
        if (auto stepped = step(*frame); !stepped)
            return stepped;
        if (auto submitted = frames_->submit(*frame); !submitted)
            return submitted;
    }
    return frames_->wait();
}

Result<Meadow::Stage> Meadow::stage(glm::ivec2 size, int samples, int blades) {
    Stage made;
    auto renderer = render::Renderer::create(*device_, scene_, {.width = size.x, .height = size.y, .samples = samples});
    if (!renderer)
        return renderer.failure();
    made.renderer = *std::move(renderer);
    const render::DrawTargets targets = made.renderer->draw_targets();
    if (blades == 0) {
        auto slice = render::WindArrows::create(
            *device_, targets, {.form = render::WindArrowSettings::Form::slice, .spacing = 0.25f, .count = {96, 1, 96}});
        if (!slice)
            return slice.failure();
        made.slice = *std::move(slice);
        made.slice->place({});
        made.renderer->add(*made.slice);
        return made;
    }
    auto everywhere = vegetation::grass::PlacementMask::create({2, 2}, scene_.ground.heights.extent(), 1.0f);
    if (!everywhere)
        return everywhere.failure();
    const auto density = static_cast<float>(std::sqrt(blades) / k_field);
    auto grass = render::GrassLayer::create(*device_, targets, scene_.ground, *everywhere,
                                            {.field = {.blade = scene_.plants, .density = density, .max_chunks = 512},
                                             .look = scene_.look,
                                             .max_blades = std::min(blades, 1 << 20)});
    if (!grass)
        return grass.failure();
    made.grass = *std::move(grass);
    made.grass->set_time_step(k_step);
    made.renderer->add(*made.grass);
    return made;
}

Result<void> Meadow::draw(Stage& stage, const render::Camera& camera, bool copied) {
    const auto frame = frames_->begin();
    if (!frame)
        return frame.failure();
    if (auto stepped = step(*frame); !stepped)
        return stepped;
    stage.renderer->begin(*frame);
    if (auto recorded = stage.renderer->record(*frame, camera, wind_); !recorded)
        return recorded;
    if (copied)
        stage.renderer->copy(*frame);
    if (auto finished = frames_->finish(*frame); !finished)
        return finished;
    stage.renderer->clock().collect(frame->slot);
    return {};
}

// --- Sections ----------------------------------------------------------------------------------------------------------------

Result<std::unique_ptr<Meadow>> prepare(SectionRun& run) {
    auto meadow = Meadow::create(run.own);
    if (!meadow)
        return meadow;
    const bool few = run.quick && run.own.facts().software;
    if (auto blown = (*meadow)->blow(few ? k_quick_steps : k_steps, [&] { return run.clock.stopped(); }); !blown)
        return blown.failure();
    return meadow;
}

bool cannot_draw(SectionRun& run, const char* what) {
    if (!run.own_draws)
        run.leave_out(message(what, ": the device has no queue that draws."));
    return !run.own_draws;
}

// Frames with so many blades; the seconds that one took, or nothing where it was stopped.
Result<std::optional<double>> measure(SectionRun& run, Meadow& meadow, int blades) {
    auto stage = meadow.stage(k_full_hd, 1, blades);
    if (!stage)
        return stage.failure();
    const render::StageClock& clock = stage->renderer->clock();
    const double begin = run.clock.past();
    const int warm = run.own.facts().software ? 1 : 8; // a device that was idle is slow; the first frame makes the blades
    std::vector<float> frames;
    std::map<std::string, std::vector<float>> stages;
    std::vector<std::string> names; // in their order
    for (int n = 0; n <= warm || run.clock.past() - begin < k_share * run.clock.budget(); ++n) {
        if (run.clock.stopped())
            return std::optional<double>();
        if (auto drawn = meadow.draw(*stage, meadow.walking(), false); !drawn)
            return drawn.failure();
        if (n < warm)
            continue;
        double sum = 0.0;
        for (const render::StageTime& part : clock.times()) {
            sum += part.us;
            if (stages[part.name].empty())
                names.emplace_back(part.name);
            stages[part.name].push_back(static_cast<float>(part.us));
        }
        frames.push_back(static_cast<float>(sum));
    }
    const DeviceSpread us = device_spread(frames);
    run.json["frames"].push_back({{"drawn", k_drawn},
                                  {"blades", blades},
                                  {"us", spread_json(us)},
                                  {"ns_per_blade", four_digits(1e3 * us.median / blades)}});
    for (const std::string& name : names)
        run.json["stages"].push_back({{"blades", blades}, {"stage", name}, {"us", spread_json(device_spread(stages.at(name)))}});
    return std::optional(1e-6 * us.median);
}

Result<void> save(SectionRun& run, Meadow& meadow, Meadow::Stage& stage, const render::Camera& camera, const char* name,
                  const char* text) {
    for (const bool copied : {false, true}) // twice: motion is that since a frame before
        if (auto drawn = meadow.draw(stage, camera, copied); !drawn)
            return drawn;
    const render::Picture8 picture = stage.renderer->images().picture();
    std::vector<std::byte> pixels;
    pixels.reserve(4 * picture.values.size() / 3);
    for (std::size_t n = 0; n < picture.values.size(); n += 3)
        for (std::size_t channel = 0; channel < 4; ++channel)
            pixels.push_back(channel < 3 ? static_cast<std::byte>(picture.values[n + channel]) : std::byte{255});
    OutputFile file(run.folder / name);
    file.write(png_of(picture.width, picture.height, pixels));
    if (const Fault fault = file.publish())
        return Error{fault.sentence};
    run.json["pictures"].push_back({{"file", name}, {"shows", text}});
    return {};
}

} // namespace

Result<void> report_meadow(SectionRun& run) {
    if (cannot_draw(run, "frames"))
        return {};
    auto meadow = prepare(run);
    if (!meadow)
        return meadow.failure();
    double blade_seconds = 0.0; // that a blade took before
    for (const int blades : k_blades) {
        // A frame that warms up, and one that counts. The fewest blades are drawn however little time there is.
        if (blades == k_blades[0] ? run.clock.stopped() : run.clock.over() || 2.0 * blade_seconds * blades > run.clock.left()) {
            run.leave_out(message("a frame of ", blades, " blades: the time is up."));
            run.leave_out_row("frames", {{"drawn", k_drawn}, {"blades", blades}}, "time");
            continue;
        }
        const auto took = measure(run, **meadow, blades);
        if (!took)
            return took.failure();
        if (!*took)
            return {};
        blade_seconds = **took / blades;
    }
    return {};
}

Result<void> report_pictures(SectionRun& run) {
    if (cannot_draw(run, "pictures"))
        return {};
    auto prepared = prepare(run);
    if (!prepared)
        return prepared.failure();
    if (run.clock.stopped())
        return {};
    Meadow& meadow = **prepared;
    const bool few = run.quick && run.own.facts().software;
    const glm::ivec2 size = few ? glm::ivec2(960, 540) : k_full_hd;
    auto grass = meadow.stage(size, 4, few ? 120'000 : 500'000), slice = meadow.stage(size, 4, 0);
    if (!grass || !slice)
        return grass ? slice.failure() : grass.failure();
    if (auto saved =
            save(run, meadow, *grass, meadow.walking(), "meadow.png", "a meadow in gusts, with a walker's wake and a fan");
        !saved)
        return saved;
    if (auto saved = save(run, meadow, *grass, meadow.above(), "meadow_above.png", "the same from above"); !saved)
        return saved;
    return save(run, meadow, *slice, meadow.over_all(), "wind.png", "speed of its wind, one metre over the ground");
}

} // namespace windrow::cli
