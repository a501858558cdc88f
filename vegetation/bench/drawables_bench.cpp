// What each drawable of a meadow costs in the colour pass, and what each choice of quality saves.
//
//     windrow_drawables_bench [--metres M] [--size 1920x1080] [--frames N] [--only drawables|choices]
//
// It links the renderer alone, no library that reads pictures or meshes: it starts on a machine that has a driver of Vulkan and
// nothing else. A level field of 36 blade places a square metre under clouds with a gusty wind; the eye is 1.7 m high. On a GPU
// 500 m and 1920 x 1080, 200 frames after 100; on a software device 640 x 360, 8 after 2. Cases of one table take turns, frame by
// frame. Times are of the device's clock, and of the CPU in all threads, which on a software device is the drawing's own: the least
// of the frames, since other work on a machine only adds.
#include "fluid/vulkan/own_device.h"
#include "fluid/vulkan/wind.h"
#include "vegetation/render/grass_layer.h"
#include "vegetation/render/renderer.h"
#include "vegetation/vulkan/failure.h"
#include "vegetation/vulkan/frames.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

using namespace windrow::vegetation;

namespace {

struct Run {
    double metres = 500.0;
    glm::ivec2 size{1920, 1080};
    int warm = 100, frames = 200;
    std::string device{}, only{};
};

[[noreturn]] void end(const std::string& sentence) {
    std::fprintf(stderr, "windrow_drawables_bench: %s\n", sentence.c_str());
    std::exit(3);
}

template <class Value>
Value expect(windrow::Result<Value> result) {
    if (!result)
        end(result.error());
    if constexpr (!std::is_void_v<Value>)
        return *std::move(result);
}

Run run_of(int count, char** arguments) {
    Run run;
    const auto devices = windrow::vulkan::list_devices();
    if (!devices)
        end(devices.error());
    // As the engine chooses: a GPU before software.
    const windrow::vulkan::DeviceFacts* chosen = &devices->front();
    for (const auto& device : *devices)
        if (chosen->software && !device.software)
            chosen = &device;
    run.device = chosen->name + ", " + chosen->driver;
    if (chosen->software) {
        run.size = {640, 360};
        run.warm = 2;
        run.frames = 8;
    }
    for (int n = 1; n < count; ++n) {
        const bool more = n + 1 < count;
        if (std::strcmp(arguments[n], "--frames") == 0 && more)
            run.frames = std::atoi(arguments[++n]);
        else if (std::strcmp(arguments[n], "--metres") == 0 && more)
            run.metres = std::atof(arguments[++n]);
        else if (std::strcmp(arguments[n], "--size") == 0 && more &&
                 std::sscanf(arguments[n + 1], "%dx%d", &run.size.x, &run.size.y) == 2)
            ++n;
        else if (std::strcmp(arguments[n], "--only") == 0 && more)
            run.only = arguments[++n];
        else {
            std::fprintf(stderr, "windrow_drawables_bench [--metres M] [--size WxH] [--frames N] [--only drawables|choices]\n");
            std::exit(2);
        }
    }
    if (!(run.metres >= 16.0 && run.metres <= 500.0) || run.frames < 1) {
        std::fprintf(stderr, "windrow_drawables_bench: give --metres 16 to 500, and --frames 1 or more.\n");
        std::exit(2);
    }
    return run;
}

struct Choice {
    const char* name = "";
    render::Quality quality{};
    int far_vertices = grass::GrassSettings{}.far_vertices;
    int samples = 4;
    bool apart = false;
};

render::Scene meadow(double metres) {
    render::Scene scene;
    const auto side = static_cast<float>(metres);
    scene.ground = {.corner = glm::dvec3(0.0),
                    .heights = expect(windrow::HeightMap::create({501, 501}, side / 500.0f, [](glm::vec2) { return 0.0f; }))};
    scene.clouds = {.cover = 0.4f};
    scene.wind.wind.cells = {32, 16, 32};
    scene.wind.wind.cell_size = 0.5f;
    scene.wind.wind.centre = {0.5 * metres, 4.0, 0.5 * metres};
    scene.wind.wind.ambient = {3.4f, 0.0f, 1.3f};
    scene.wind.wind.gusts = {.intensity = 0.35f, .length = 14.0f};
    return scene;
}

/// A meadow that is drawn with one choice.
class Field {
  public:
    Field(const Run& run, const Choice& choice) : scene_(meadow(run.metres)), device_(expect(engine::Device::create({}))) {
        wind_.emplace(expect(
            windrow::vulkan::Wind::create(device_->host(), scene_.wind.wind, {.frames_in_flight = engine::k_frames_in_flight})));
        renderer_ = expect(render::Renderer::create(*device_, scene_,
                                                    {.width = run.size.x,
                                                     .height = run.size.y,
                                                     .samples = choice.samples,
                                                     .quality = choice.quality,
                                                     .anchor = scene_.wind.wind.centre,
                                                     .counts = true,
                                                     .apart = choice.apart}));
        const auto mask = expect(grass::PlacementMask::create({2, 2}, scene_.ground.heights.extent(), 1.0f));
        grass_ = expect(render::GrassLayer::create(*device_, renderer_->draw_targets(), scene_.ground, mask,
                                                   {.field = {.far_vertices = choice.far_vertices}}));
        renderer_->add(*grass_, "grass");
        frames_ = expect(engine::Frames::create(*device_));
        camera_.position = {0.5 * run.metres, 1.7, 0.5 * run.metres};
        camera_.target = {0.5 * run.metres, 0.8, 0.5 * run.metres - 10.0};
        camera_.view_deg = 50.0f;
    }

    void draw(bool timed) {
        const std::clock_t start = std::clock(); // of all threads: on a software device the drawing's own
        const engine::Frame frame = expect(frames_->begin());
        renderer_->begin(frame);
        expect(wind_->record(frame.commands, {.dt = 1.0 / 60.0, .slot = frame.slot}));
        expect(renderer_->record(frame, camera_, *wind_));
        expect(frames_->finish(frame));
        renderer_->clock().collect(frame.slot);
        counts_ = renderer_->counter()->collect(frame.slot);
        if (!timed)
            return;
        double whole = 0.0;
        for (const render::StageTime& stage : renderer_->clock().times()) {
            whole += stage.us;
            add(stage.name, stage.us);
        }
        add("frame", whole);
        add("CPU", 1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    /// [ms] Least of the timed frames.
    [[nodiscard]] double least(const std::string& stage) const {
        const auto found = least_.find(stage);
        return found == least_.end() ? 0.0 : found->second;
    }
    [[nodiscard]] const std::vector<render::DrawnCounts>& counts() const { return counts_; }

  private:
    void add(const std::string& name, double us) {
        const auto [place, made] = least_.try_emplace(name, 1e-3 * us);
        if (!made)
            place->second = std::min(place->second, 1e-3 * us);
    }

    render::Scene scene_;
    std::unique_ptr<engine::Device> device_;
    std::optional<windrow::vulkan::Wind> wind_{};
    std::unique_ptr<render::Renderer> renderer_{};
    std::unique_ptr<render::GrassLayer> grass_{};
    std::unique_ptr<engine::Frames> frames_{};
    render::Camera camera_{};
    std::map<std::string, double> least_{};
    std::vector<render::DrawnCounts> counts_{};
};

void head(const Run& run, const char* title) {
    std::printf("\n## %s\n%s; %d x %d px, field of %g m; least of %d frames after %d\n", title, run.device.c_str(), run.size.x,
                run.size.y, run.metres, run.frames, run.warm);
}

void by_drawable(const Run& run) {
    head(run, "Colour pass by drawable");
    Field field(run, {.apart = true});
    for (int n = 0; n < run.warm + run.frames; ++n)
        field.draw(n >= run.warm);
    std::printf("| drawable | vertices drawn | vertex stage ran | fragments | ms |\n|---|---|---|---|---|\n");
    for (const render::DrawnCounts& each : field.counts())
        std::printf("| %s | %llu | %llu | %llu | %.3f |\n", each.name, static_cast<unsigned long long>(each.counts.vertices),
                    static_cast<unsigned long long>(each.counts.invocations),
                    static_cast<unsigned long long>(each.counts.fragments), field.least(each.name));
    for (const char* const stage : {"colour", "shadow", "prepare", "tone", "frame"})
        std::printf("| %s | | | | %.3f |\n", std::strcmp(stage, "colour") == 0 ? "resolve of samples" : stage,
                    field.least(stage));
}

void by_choice(const Run& run) {
    head(run, "Choices of quality");
    constexpr render::Quality none{.sky_pixels = 0, .cloud_texels = 0, .cloud_noise_texels = 0, .ground_texels = 0};
    const std::vector<Choice> choices{
        {.name = "default"},
        {.name = "sky by pixel", .quality = {.sky_pixels = 0}},
        {.name = "clouds by pixel", .quality = {.cloud_noise_texels = 0}},
        {.name = "clouds' shadow by point", .quality = {.cloud_texels = 0}},
        {.name = "ground's colour by pixel", .quality = {.ground_texels = 0}},
        {.name = "no map", .quality = none},
        {.name = "far blades of 5 vertices", .far_vertices = 5},
        {.name = "light in 4 bytes", .quality = {.light_bytes = 4}},
        {.name = "1 sample", .samples = 1},
    };
    std::vector<std::unique_ptr<Field>> fields;
    for (const Choice& choice : choices)
        fields.push_back(std::make_unique<Field>(run, choice));
    for (int n = 0; n < run.warm + run.frames; ++n)
        for (const auto& field : fields)
            field->draw(n >= run.warm);
    std::printf("| choice | colour, ms | frame, ms | CPU, ms | colour / default | frame / default | CPU / default "
                "|\n|---|---|---|---|---|---|---|\n");
    const Field& base = *fields.front();
    for (std::size_t n = 0; n < choices.size(); ++n) {
        const Field& field = *fields[n];
        std::printf("| %s | %.3f | %.3f | %.3f | %.3f | %.3f | %.3f |\n", choices[n].name, field.least("colour"),
                    field.least("frame"), field.least("CPU"), field.least("colour") / base.least("colour"),
                    field.least("frame") / base.least("frame"), field.least("CPU") / base.least("CPU"));
    }
}

} // namespace

int main(int count, char** arguments) {
    const Run run = run_of(count, arguments);
    if (run.only.empty() || run.only == "drawables")
        by_drawable(run);
    if (run.only.empty() || run.only == "choices")
        by_choice(run);
    return 0;
}
