#include "vegetation/program/scene_renderer.h"

#include "fluid/core/message.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace windrow::vegetation::program {
namespace {

using windrow::Error;
using windrow::Result;

constexpr int k_max_ticks = 1000; // of windrow::Ticks in one frame

} // namespace

SceneRenderer::SceneRenderer(const PictureScene& scene, const SceneRendererSettings& settings)
    : scene_(scene), settings_(settings), frames_per_second_(settings.frames_per_second.value_or(scene.frames_per_second())),
      size_(settings.size.value_or(scene.picture.size)), anchor_(glm::round(camera_at(scene, 0.0).position)),
      scene_air_(windrow::scene::SceneAir::within(scene.air)) {}

Result<std::unique_ptr<SceneRenderer>> SceneRenderer::create(const PictureScene& scene, const SceneRendererSettings& settings) {
    std::unique_ptr<SceneRenderer> made(new SceneRenderer(scene, settings));
    if (auto ready = made->make(); !ready)
        return ready.failure().after(scene.air.file.string() + ": ");
    return made;
}

Result<void> SceneRenderer::make() {
    device_ = settings_.device;
    if (device_ == nullptr) {
        auto device =
            engine::Device::create({.staged = settings_.staged, .get_instance_proc_addr = settings_.get_instance_proc_addr});
        if (!device)
            return device.failure();
        own_device_ = *std::move(device);
        device_ = own_device_.get();
    }
    const Picture& picture = scene_.picture;
    windrow::Config air = scene_.air.air;
    // As `windrow run` ticks; and no frame is so long that the air would fall behind.
    const double due = std::ceil(scene_.air.tick_hz / frames_per_second_) + 1.0;
    if (due > k_max_ticks)
        return Error{detail::message("$.tick_hz is ", scene_.air.tick_hz, " Hz, more than ", k_max_ticks - 1,
                                     " ticks in each of ", frames_per_second_,
                                     " frames a second; give fewer ticks or more frames a second.")};
    air.ticks = {.hz = scene_.air.tick_hz, .max_per_call = settings_.edited ? k_max_ticks : static_cast<int>(due)};
    if (!settings_.wind) {
        air.ambient = glm::vec3(0.0f);
        air.gusts = {};
        air.cells = glm::ivec3(8); // something to sample
        air.rows.reset();
    } else if (picture.sampling.detail > 0.0f && air.gusts.intensity <= 0.0f) {
        air.gusts.tile = windrow::GustTile::standard(); // the pattern of the detail, where no gusts bring one
    }
    if (settings_.wind && !scene_.air.outer.empty()) {
        auto levels = windrow::scene::SceneLevels::create(scene_.air, level_threads());
        if (!levels)
            return levels.failure();
        levels_.emplace(*std::move(levels));
        air.ambient = levels_->inner_config().ambient; // that of the winds around it
        air.profile.reset();
        air.gusts = {.tile = air.gusts.tile};
    }
    auto wind = Air::create(*device_, air, air_settings(), levels_ ? levels_->nearest() : nullptr);
    if (!wind)
        return wind.failure().after("$.air: ");
    air_ = *std::move(wind);
    if (auto begun = scene_air_.begin(air_->control()); !begun)
        return begun;

    if (auto made = make_renderer(); !made)
        return made;

    if (auto remembers = make_ground_memory(); !remembers)
        return remembers;
    const render::DrawTargets targets = renderer_->draw_targets();
    if (auto grown = make_grass(targets); !grown)
        return grown;
    if (auto grown = make_trees(targets); !grown)
        return grown;
    auto furred = FurredBodies::create(*device_, targets, scene_, anchor_);
    if (!furred)
        return furred.failure();
    furred_ = *std::move(furred);
    auto figures = Figures::create(*device_, targets, scene_, anchor_);
    if (!figures)
        return figures.failure();
    figures_ = *std::move(figures);
    auto standing = StandingBodies::create(*device_, targets, scene_, anchor_, settings_.edited);
    if (!standing)
        return standing.failure();
    standing_ = *std::move(standing);
    if (auto seen = make_views(targets); !seen)
        return seen;
    attach();
    auto frames = engine::Frames::create(*device_);
    if (!frames)
        return frames.failure();
    frames_ = *std::move(frames);
    return {};
}

AirSettings SceneRenderer::air_settings() const {
    // Asked by the host for streaks and cloaks, and by who edits.
    const bool asked = settings_.show == Show::streaks || Figures::any(scene_) || settings_.edited;
    constexpr int k_forces = 64; // of bodies in the box
    return {.backend = settings_.backend,
            .pass_times = settings_.pass_times,
            .queries = asked,
            .forces = settings_.edited ? k_forces : 0,
            .gusts = settings_.edited};
}

ParallelFor SceneRenderer::level_threads() {
    if (!level_threads_)
        level_threads_ = std::make_unique<ThreadPool>();
    return level_threads_->parallel_for();
}

Result<void> SceneRenderer::make_ground_memory() {
    if (!scene_.picture.ground_memory || ground_)
        return {};
    auto memory = windrow::vulkan::GroundMemory::create(device_->host(), *scene_.picture.ground_memory);
    if (!memory)
        return memory.failure().after("$.picture.ground_memory: ");
    ground_ = *std::move(memory);
    for (const auto& layer : grass_)
        layer->set_ground(&*ground_);
    return {};
}

Result<void> SceneRenderer::make_renderer() {
    const Picture& picture = scene_.picture;
    render::Scene scene;
    scene.camera = camera_at(scene_, 0.0);
    scene.sun = picture.sun;
    scene.fog = picture.fog;
    scene.clouds = picture.clouds;
    scene.ground = {.corner = picture.ground.corner, .heights = *picture.ground.heights};
    if (!picture.grass.empty()) {
        scene.look = picture.grass.front().drawn.look;
        scene.plants = picture.grass.front().drawn.field.blade;
        scene.ground.grown = picture.grass.front().mask.mask;
    }
    scene.wind.wind = air_->control().config();
    scene.wind.sampling = picture.sampling;
    render::RenderSettings drawn{.width = size_.x,
                                 .height = size_.y,
                                 .samples = settings_.samples,
                                 .shutter_deg = shutter_deg(),
                                 .quality = picture.quality,
                                 .anchor = anchor_,
                                 .counts = settings_.counts,
                                 .apart = settings_.edited};
    if (settings_.draft) {
        drawn.shadow_texels = 256;
        drawn.draft = true;
    }
    auto renderer = render::Renderer::create(*device_, scene, drawn);
    if (!renderer)
        return renderer.failure().after("$.picture: ");
    renderer_ = *std::move(renderer);
    return {};
}

void SceneRenderer::attach() {
    renderer_->show(view_);
    for (const auto& layer : grass_)
        renderer_->add(*layer);
    for (const auto& stand : trees_)
        renderer_->add(*stand);
    furred_->add_to(*renderer_);
    figures_->add_to(*renderer_);
    standing_->add_to(*renderer_);
    for (render::Drawable* const one : std::initializer_list<render::Drawable*>{arrows_.get(), streaks_.get()})
        if (one != nullptr)
            renderer_->add(*one);
}

Result<void> SceneRenderer::change(const Change& change) {
    if (auto done = frames_->wait(); !done)
        return done;
    if (change.show && *change.show != settings_.show) {
        settings_.show = *change.show;
        arrows_.reset();
        streaks_.reset();
        if (auto seen = make_views(renderer_->draw_targets()); !seen)
            return seen;
    }
    if (change.obstacles)
        if (auto stand = standing_->make_obstacles(renderer_->draw_targets()); !stand)
            return stand;
    if (change.ground_memory)
        if (auto remembers = make_ground_memory(); !remembers)
            return remembers;
    if (!change.size && !change.show && !change.obstacles && !change.look)
        return {};
    size_ = change.size.value_or(size_);
    // Its render passes and layouts are shared: what was made for the old one is drawn by the new one.
    if (auto made = make_renderer(); !made)
        return made;
    attach();
    return {};
}

Result<void> SceneRenderer::make_grass(const render::DrawTargets& targets) {
    const render::Ground ground{.corner = scene_.picture.ground.corner, .heights = *scene_.picture.ground.heights};
    for (const GrassSource& layer : scene_.picture.grass) {
        render::GrassLayerSettings drawn = layer.drawn;
        drawn.max_blades = settings_.max_blades.value_or(drawn.max_blades);
        auto made = render::GrassLayer::create(*device_, targets, ground, *layer.mask.mask, drawn);
        if (!made)
            return made.failure().after("$.picture.grass, " + layer.name + ": ");
        if (ground_)
            (*made)->set_ground(&*ground_);
        grass_.push_back(*std::move(made));
    }
    return {};
}

Result<void> SceneRenderer::repaint(std::size_t layer, const grass::Touched& touched) {
    return grass_.at(layer)->field().repaint(*scene_.picture.grass.at(layer).mask.mask, touched);
}

Result<void> SceneRenderer::make_trees(const render::DrawTargets& targets) {
    for (const StandSource& stand : scene_.picture.trees) {
        auto kind = trees::preset(stand.kind);
        if (!kind)
            return kind.failure().after("$.picture.trees: ");
        kind->tree.seed = stand.seed;
        trees::TreeStandSettings settings{
            .kind = *std::move(kind), .variants = stand.variants, .springs = stand.springs, .flutter = stand.flutter};
        const auto places = windrow::scene::places_of(stand, scene_.picture.ground);
        if (places.empty())
            continue;
        auto made = trees::TreeStand::create(*device_, targets, settings, places, anchor_);
        if (!made)
            return made.failure().after("$.picture.trees: ");
        trees_.push_back(*std::move(made));
    }
    return {};
}

Result<void> SceneRenderer::make_views(const render::DrawTargets& targets) {
    view_ = {};
    switch (settings_.show) {
    case Show::lean:
        view_ = render::GrassView::lean;
        return {};
    case Show::levels:
        view_ = render::GrassView::levels;
        return {};
    case Show::chunks:
        view_ = render::GrassView::chunks;
        return {};
    case Show::plants:
        return {};
    case Show::streaks:
        return make_streaks(targets);
    case Show::arrows:
    case Show::slice:
        break;
    }
    const windrow::Config& air = air_->control().config();
    render::WindArrowSettings view;
    view.form = settings_.show == Show::slice ? render::WindArrowSettings::Form::slice : render::WindArrowSettings::Form::arrows;
    const bool slice = view.form == render::WindArrowSettings::Form::slice;
    view.spacing = slice ? 0.5f * air.cell_size : air.cell_size;
    view.count = slice ? glm::ivec3(2 * air.cells.x, 1, 2 * air.cells.z) : glm::ivec3(air.cells.x, 3, air.cells.z);
    view.count = glm::clamp(view.count, 1, 512);
    view.scale = scene_.air.pictures.speed_scale;
    auto made = render::WindArrows::create(*device_, targets, view);
    if (!made)
        return made.failure();
    arrows_ = *std::move(made);
    return {};
}

Result<void> SceneRenderer::make_streaks(const render::DrawTargets& targets) {
    const windrow::Box box = air_->control().box();
    const render::StreakBox held{air_->control().origin(), glm::dvec3(box.size())};
    auto made = render::WindStreaks::create(*device_, targets, {}, held);
    if (!made)
        return made.failure();
    streaks_ = *std::move(made);
    return {};
}

void SceneRenderer::move_figures(double time, double seconds) {
    figures_->move(time, seconds,
                   [&](glm::dvec3 place) { return settings_.wind ? air_->reader().velocity(place) : glm::vec3(0.0f); });
}

void SceneRenderer::move_streaks(double time, double seconds) {
    if (!streaks_)
        return;
    const auto standing = scene_air_.standing(time);
    const auto blocked = [&](const glm::dvec3& from, const glm::dvec3& to) {
        return std::any_of(standing.begin(), standing.end(), [&](const auto& body) { return body.blocks(from, to); });
    };
    const auto velocity = [&](std::span<const glm::dvec3> places, std::span<glm::vec3> velocities) {
        air_->reader().velocity(places, velocities);
    };
    streaks_->follow(air_->control().origin());
    streaks_->advance(seconds, velocity, blocked);
}

Result<void> SceneRenderer::walk(const engine::Frame& frame, double start, double end) {
    if (!ground_)
        return {};
    std::vector<windrow::GroundWalker> walkers;
    for (const Walker& walker : scene_.picture.walkers)
        walkers.push_back(walker_at(scene_, walker, start, end));
    if (auto followed = ground_->follow(scene_.air.followed_point(end)); !followed)
        return followed;

    auto recorded = ground_->record(frame.commands, {.duration = end - start, .walkers = walkers});
    walkers_left_out_ = std::max(walkers_left_out_, ground_->walkers_left_out());
    return recorded;
}

Result<void> SceneRenderer::record_air(const engine::Frame& frame, double dt) {
    return air_->record(frame, settings_.wind ? dt : 0.0);
}

Result<void> SceneRenderer::blow(const engine::Frame& frame, double start, double end) {
    if (levels_)
        if (auto around = levels_->advance_to(end); !around)
            return around;
    if (settings_.wind)
        if (auto placed = scene_air_.advance_to(air_->control(), end); !placed)
            return placed;
    if (auto recorded = record_air(frame, end - start); !recorded)
        return recorded;
    return walk(frame, start, end);
}

void SceneRenderer::set_time_step(double seconds) {
    for (const auto& stand : trees_)
        stand->set_time_step(seconds);
    for (const auto& layer : grass_)
        layer->set_time_step(seconds);
}

Result<void> SceneRenderer::swing(const engine::Frame& frame, double time, double seconds) {
    move_streaks(time, seconds);
    move_figures(time, seconds);
    if (trees_.empty() && grass_.empty() && furred_->empty())
        return {};
    set_time_step(seconds);
    if (auto moved = furred_->move(time, seconds); !moved)
        return moved;
    std::vector<render::Drawable*> swinging;
    furred_->append_to(swinging);
    for (const auto& stand : trees_)
        swinging.push_back(stand.get());
    for (const auto& layer : grass_)
        swinging.push_back(layer.get());
    return renderer_->keep_up(frame, camera_at(scene_, time), air_->sampled(), swinging);
}

Result<void> SceneRenderer::warm_up() {
    const auto step = [&](double dt, std::int64_t left) -> Result<void> {
        const auto frame = frames_->begin();
        if (!frame)
            return frame.failure();
        if (levels_)
            if (auto around = levels_->pass(dt); !around)
                return around;
        auto walked = record_air(*frame, dt);
        if (walked)
            walked = walk(*frame, 0.0, 0.0);
        if (walked)
            walked = swing(*frame, dt * static_cast<double>(-left), dt); // bodies come along to where they begin
        const auto submitted = frames_->submit(*frame);
        return walked ? submitted : walked;
    };
    if (auto warmed =
            scene_air_.warm_up(air_->control(), settings_.warm_up.value_or(scene_.picture.warm_up), frames_per_second_, step);
        !warmed)
        return warmed;
    return frames_->wait();
}

Result<void> SceneRenderer::skip() {
    const auto frame = frames_->begin();
    if (!frame)
        return frame.failure();
    auto blown = blow(*frame, start_of(frame_), end_of(frame_));
    if (blown)
        blown = swing(*frame, end_of(frame_), end_of(frame_) - start_of(frame_));
    const auto submitted = frames_->submit(*frame);
    ++frame_;
    return blown ? submitted : blown;
}

Result<void> SceneRenderer::place(double start, double end) {
    renderer_->set_time(end);
    move_figures(end, end - start);
    figures_->place();
    standing_->place(end, scene_air_);
    move_streaks(end, end - start);
    set_time_step(end - start);
    if (arrows_)
        arrows_->place(glm::vec3(scene_.air.followed_point(end) - anchor_));
    return furred_->move(end, end - start);
}

Result<void> SceneRenderer::record(const engine::Frame& frame, const Moment& moment) {
    renderer_->begin(frame);
    if (auto blown = moment.stepped ? air_->show(frame) : blow(frame, moment.start, moment.end); !blown)
        return blown;
    if (moment.stepped)
        if (auto walked = walk(frame, moment.start, moment.end); !walked)
            return walked;
    if (auto placed = place(moment.start, moment.end); !placed)
        return placed;
    const render::Camera camera = moment.camera.value_or(camera_at(scene_, moment.end));
    if (auto recorded = renderer_->record(frame, camera, air_->sampled()); !recorded)
        return recorded;
    if (moment.copied)
        renderer_->copy(frame);
    return {};
}

Result<void> SceneRenderer::draw(bool copied) {
    const auto frame = frames_->begin();
    if (!frame)
        return frame.failure();
    auto done = record(*frame, {.start = start_of(frame_), .end = end_of(frame_), .copied = copied});
    if (const auto finished = frames_->finish(*frame); done)
        done = finished;
    collect(*frame);
    ++frame_;
    return done;
}

void SceneRenderer::collect(const engine::Frame& frame) {
    renderer_->clock().collect(frame.slot);
    if (renderer_->counter())
        counts_ = sum_of(renderer_->counter()->collect(frame.slot));
}

std::vector<render::StageTime> SceneRenderer::times() const {
    std::vector<render::StageTime> times = renderer_->clock().times();
    if (!times.empty())
        times.front().us += air_->cpu_us(); // "wind"
    return times;
}

SceneRendererMemory SceneRenderer::memory() const {
    SceneRendererMemory sum{.targets = device_->memory_bytes(), .wind = air_->memory_bytes()};
    sum.room = air_->reserved_bytes() - sum.wind + device_->reserved_bytes() - sum.targets;
    if (air_->backend() == Backend::cpu) // its textures are the device's own
        sum.targets -= sum.wind;
    for (const auto& layer : grass_)
        sum.grass += layer->memory_bytes();
    sum.targets -= sum.grass;
    if (ground_) {
        sum.ground_memory = ground_->memory_bytes();
        sum.room += ground_->reserved_bytes() - sum.ground_memory;
    }
    return sum;
}

} // namespace windrow::vegetation::program
