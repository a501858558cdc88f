#include "vegetation/bench/fur_stage.h"

#include "fluid/vulkan/own_device.h"
#include "pictures/picture_files.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vulkan/vulkan.h>

namespace windrow::vegetation::bench {
namespace {

constexpr double k_frame = 1.0 / 30.0;          // [s]
constexpr glm::dvec3 k_anchor{0.0, 100.0, 0.0}; // [m] all coats are near it, far above the ground: behind them is the sky alone

// Ends the program with a sentence.
void held(const Result<void>& result) {
    if (!result) {
        std::fprintf(stderr, "windrow_shells_bench: %s\n", result.error().c_str());
        std::exit(3);
    }
}
template <class T>
T held(Result<T> result) {
    if (!result)
        held(result.failure());
    return *std::move(result);
}

windrow::vulkan::Wind wind_of(const engine::Device& device, const FurCase& wanted) {
    windrow::Config air;
    air.cells = wanted.wind ? wanted.cells : glm::ivec3(8); // something to sample
    air.centre = k_anchor;
    if (wanted.wind) {
        air.ambient = wanted.ambient;
        air.gusts = {.intensity = wanted.gusts, .length = wanted.gust_length};
    }
    return held(windrow::vulkan::Wind::create(device.host(), air, {.frames_in_flight = engine::k_frames_in_flight}));
}

} // namespace

FurStage::FurStage(FurCase wanted) : wanted_(std::move(wanted)) {
    device_ = held(engine::Device::create());
    frames_ = held(engine::Frames::create(*device_));
    wind_.emplace(wind_of(*device_, wanted_));
    render::Scene scene;
    scene.fog.density = 0.0f;
    scene.sun = {.elevation_deg = 35.0f, .azimuth_deg = 40.0f};
    scene.wind.wind = wind_->config();
    renderer_ = held(render::Renderer::create(*device_, scene,
                                              {.width = wanted_.size.x,
                                               .height = wanted_.size.y,
                                               .samples = wanted_.samples,
                                               .shadow_texels = 512,
                                               .near_shadow = 12.0f,
                                               .anchor = k_anchor}));
    auto counted = engine::guarded([&] { return std::make_unique<CountedCoats>(*device_); });
    coats_ = held(std::move(counted));
    for (Worn& worn : wanted_.coats) {
        if (worn.bones)
            held(bind(worn.mesh, *worn.bones));
        coats_->coats.push_back(held(fur::Coat::create(*device_, renderer_->draw_targets(), worn.mesh, {}, worn.settings, {},
                                                       {.position = k_anchor + worn.place}, k_anchor)));
        held(coats_->coats.back()->set_lamps([&] {
            std::vector<fur::Lamp> lamps = wanted_.lamps;
            for (fur::Lamp& lamp : lamps)
                lamp.position += k_anchor;
            return lamps;
        }()));
    }
    renderer_->add(*coats_);
}

int FurStage::record(bool copies) {
    for (std::size_t n = 0; n < coats_->coats.size(); ++n) {
        const Worn& worn = wanted_.coats[n];
        const auto bones = worn.bones ? pose(*worn.bones, time_) : std::vector<glm::mat4>{};
        held(coats_->coats[n]->move(k_frame, {.position = k_anchor + worn.place}, bones));
    }
    render::Camera camera;
    camera.position = k_anchor + wanted_.from;
    camera.target = k_anchor + wanted_.to;
    camera.view_deg = wanted_.view_deg;
    const engine::Frame frame = held(frames_->begin());
    renderer_->begin(frame);
    held(wind_->record(frame.commands, {.dt = wanted_.wind ? k_frame : 0.0, .slot = frame.slot}));
    held(renderer_->record(frame, camera, *wind_));
    if (copies)
        renderer_->copy(frame);
    held(frames_->finish(frame));
    renderer_->clock().collect(frame.slot);
    time_ += k_frame;
    return frame.slot;
}

void FurStage::draw(bool timed) {
    (void)record(false);
    if (!timed)
        return;
    double sum = 0.0;
    for (const render::StageTime& stage : renderer_->clock().times()) {
        times_[stage.name].push_back(1e-3 * stage.us);
        sum += 1e-3 * stage.us;
    }
    times_["frame"].push_back(sum);
}

CoatCosts FurStage::count(const std::filesystem::path& folder) {
    coats_->counting = true;
    const int slot = record(true);
    coats_->counting = false;
    CoatCosts costs = coats_->collect(slot);
    const render::PictureF with = renderer_->images().light_picture();
    if (!folder.empty())
        write(folder);
    coats_->hidden = true;
    const render::PictureF without = light();
    coats_->hidden = false;
    for (std::size_t n = 0; n + 2 < with.values.size(); n += 3)
        costs.pixels += std::equal(&with.values[n], &with.values[n] + 3, &without.values[n]) ? 0u : 1u;
    return costs;
}

render::PictureF FurStage::light() {
    (void)record(true);
    return renderer_->images().light_picture();
}

void FurStage::write(const std::filesystem::path& folder) const {
    std::string name;
    for (const char letter : wanted_.name)
        name += std::isalnum(static_cast<unsigned char>(letter)) != 0 ? letter : '_';
    held(pictures::write_png(renderer_->images().picture(), folder / (name + ".png")));
}

const std::vector<double>& FurStage::times(const std::string& stage) const {
    static const std::vector<double> none;
    const auto found = times_.find(stage);
    return found == times_.end() ? none : found->second;
}

double FurStage::median(const std::string& stage) const {
    return median_of(times(stage));
}

double FurStage::least(const std::string& stage) const {
    const auto& all = times(stage);
    return all.empty() ? 0.0 : *std::min_element(all.begin(), all.end());
}

std::uint64_t FurStage::vertices() const {
    std::uint64_t sum = 0;
    for (const Worn& worn : wanted_.coats)
        sum += worn.mesh.vertices.size();
    return sum;
}

double median_of(std::vector<double> values) {
    if (values.empty())
        return 0.0;
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

double ratio(const FurStage& of, const FurStage& over, const std::string& stage) {
    const auto &a = of.times(stage), &b = over.times(stage);
    std::vector<double> ratios;
    for (std::size_t n = 0; n < std::min(a.size(), b.size()); ++n)
        if (b[n] > 0.0)
            ratios.push_back(a[n] / b[n]);
    return median_of(std::move(ratios));
}

void draw_in_turn(std::span<const std::unique_ptr<FurStage>> stages, int warm, int frames) {
    for (int n = 0; n < warm + frames; ++n)
        for (const auto& stage : stages)
            stage->draw(n >= warm);
}

} // namespace windrow::vegetation::bench
