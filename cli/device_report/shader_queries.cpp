// What a shader samples against the CPU's query: the wind in both kinds of texels, and the ground memory.
#include "cli/device_report/report_section.h"
#include "coupling/ground_memory.h"
#include "coupling/vulkan/ground_memory.h"
#include "fluid/vulkan/textures.h"
#include "fluid/vulkan/wind.h"
#include "gpu/device.h"
#include "gpu/pipeline.h"
#include "shader_words/query_ground.h"
#include "shader_words/query_wind.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <utility>

namespace windrow::cli {
namespace {

using namespace vulkan;

constexpr std::size_t k_places = 4096;

std::vector<glm::vec4> places_within(glm::vec3 reach) {
    std::mt19937 random(7);
    std::vector<glm::vec4> places(k_places);
    for (glm::vec4& place : places)
        for (int axis = 0; axis < 3; ++axis) // the same places on each machine: no distribution of the library's
            place[axis] = reach[axis] * (static_cast<float>(random() % 20001) / 10000.0f - 1.0f);
    return places;
}

/// The wind's bindings of shaders/coupling/windrow_wind.glsl, for a host that waits for each frame.
class WindBindings {
  public:
    /// For winds with these boundaries.
    [[nodiscard]] static Result<WindBindings> create(Device& device, const Boundaries& boundaries);
    /// Of the frame last recorded; nothing that uses them is in flight.
    [[nodiscard]] std::vector<Binding> of(const vulkan::Wind& wind, glm::dvec3 anchor);

  private:
    Buffer block_;
    vulkan::Handle<VkSampler, &Functions::vkDestroySampler> sampler_;
};

Result<WindBindings> WindBindings::create(Device& device, const Boundaries& boundaries) {
    WindBindings made;
    auto block = Buffer::create(device, sizeof(FrameBlock), MemoryUse::upload, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    if (!block)
        return block.failure();
    made.block_ = *std::move(block);
    const VkSamplerCreateInfo info = sampler_info(boundaries);
    if (const VkResult result = make(device.functions(), device.host(), device.functions().vkCreateSampler, info, made.sampler_);
        result != VK_SUCCESS)
        return call_error("vkCreateSampler", "the wind's textures", result);
    return made;
}

std::vector<Binding> WindBindings::of(const vulkan::Wind& wind, glm::dvec3 anchor) {
    const FrameBlock content = wind.frame_block(anchor);
    std::memcpy(block_.mapped(), &content, sizeof content);
    (void)block_.flush(); // memory for uploads is coherent
    const auto texture = [&](const Textures& frame) {
        return Binding{.type = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, .view = frame.vectors.view, .sampler = sampler_.get()};
    };
    return {{.type = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, .buffer = block_.handle()},
            texture(wind.textures()),
            texture(wind.previous_textures()),
            {.type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, .buffer = wind.gust_buffer()}};
}

/// Answers of a compute shader with places at binding 0, answers at 1, and these bindings behind.
Result<std::vector<glm::vec4>> answers_of(OwnDevice& own, Device& device, std::span<const std::uint32_t> code,
                                          const std::vector<glm::vec4>& places, const std::vector<Binding>& more) {
    const std::uint64_t bytes = places.size() * sizeof(glm::vec4);
    auto in = Buffer::create(device, bytes, MemoryUse::upload), out = Buffer::create(device, bytes, MemoryUse::readback);
    if (!in || !out)
        return in ? out.failure() : in.failure();
    std::memcpy(in->mapped(), places.data(), bytes);
    (void)in->flush(); // memory for uploads is coherent
    std::vector<Binding> bindings = {{.type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, .buffer = in->handle()},
                                     {.type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, .buffer = out->handle()}};
    bindings.insert(bindings.end(), more.begin(), more.end());
    std::vector<VkDescriptorType> kinds;
    for (const Binding& binding : bindings)
        kinds.push_back(binding.type);
    auto pipeline = Pipeline::create(device, {.code = code, .bindings = kinds, .constants = {}, .name = "query"});
    if (!pipeline)
        return pipeline.failure();
    const Sets::Content content{&*pipeline, bindings};
    auto sets = Sets::create(device, {&content, 1});
    if (!sets)
        return sets.failure();
    auto ran = own.run([&](VkCommandBuffer commands) {
        const Functions& call = device.functions();
        pipeline->bind(call, commands, sets->at(0));
        call.vkCmdDispatch(commands, static_cast<std::uint32_t>(places.size() + 63) / 64, 1, 1);
        const VkMemoryBarrier read{VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, VK_ACCESS_SHADER_WRITE_BIT,
                                   VK_ACCESS_HOST_READ_BIT};
        call.vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &read, 0,
                                  nullptr, 0, nullptr);
    });
    if (!ran)
        return ran.failure();
    if (const VkResult result = out->invalidate(); result != VK_SUCCESS)
        return call_error("vkInvalidateMappedMemoryRanges", "answers", result);
    std::vector<glm::vec4> answers(places.size());
    std::memcpy(answers.data(), out->mapped(), bytes);
    return answers;
}

void add_row(SectionRun& run, const char* what, const char* texel, double worst, double bound, double largest) {
    const bool pass = worst <= bound; // a NaN is below no bound
    run.json["queries"].push_back({{"query", what},
                                   {"texel", texel},
                                   {"places", k_places},
                                   {"largest_difference", four_digits(worst)},
                                   {"bound", four_digits(bound)},
                                   {"largest", four_digits(largest)},
                                   {"pass", pass}});
    run.json["pass"] = run.json.value("pass", true) && pass;
}

double worse(double worst, double apart) {
    return std::isfinite(apart) ? std::max(worst, apart) : apart;
}

Result<void> query_wind(SectionRun& run, Device& device, Texel texel) {
    const Config config{.cells = {20, 12, 16},
                        .boundaries = Boundaries::open_over_floor(),
                        .centre = {1e6, 6.0, -1e6},
                        .ambient = {3.0f, 0.0f, 1.0f},
                        .profile = LogProfile{},
                        .gusts = {.intensity = 0.25f}};
    auto wind = vulkan::Wind::create(run.own.host(), config, {.texel = texel, .frames_in_flight = 1, .queries = ReadBack::cells});
    if (!wind)
        return wind.failure();
    if (const auto id = wind->motors().add(VortexMotor{.position = config.centre, .radius = 3.0f}); !id)
        return id.failure();
    constexpr int k_steps = 20;
    for (int n = 0; n <= k_steps; ++n) {
        (void)wind->follow(config.centre + glm::dvec3(0.3 * n, 0.0, 0.1 * n));
        Result<void> recorded;
        // The last takes the read-back of the one before, and shows the same.
        auto ran = run.own.run([&](VkCommandBuffer commands) {
            if (const auto step = wind->record_step(commands, {.dt = n < k_steps ? 0.02 : 0.0}); !step)
                recorded = step.failure();
        });
        if (!ran || !recorded)
            return ran ? recorded : ran;
    }
    (void)wind->collect(0);
    const glm::dvec3 anchor = config.centre + glm::dvec3(12.3, -4.5, 6.7);
    auto bindings = WindBindings::create(device, config.boundaries);
    if (!bindings)
        return bindings.failure();
    std::vector<glm::vec4> places = places_within(0.9f * glm::vec3(config.cells));
    for (glm::vec4& place : places)
        place += glm::vec4(glm::vec3(config.centre - anchor), 0.0f);
    const auto answers = answers_of(run.own, device, shader_words::query_wind, places, bindings->of(*wind, anchor));
    const auto view = wind->queried();
    if (!answers || !view)
        return Error{answers ? "nothing was read back from the device." : answers.error()};
    double worst = 0.0, largest = 0.0;
    for (std::size_t n = 0; n < places.size(); ++n) {
        const glm::vec3 wanted = view->velocity(anchor + glm::dvec3(places[n]));
        for (int axis = 0; axis < 3; ++axis) {
            worst = worse(worst, std::abs(static_cast<double>((*answers)[n][axis]) - static_cast<double>(wanted[axis])));
            largest = std::max(largest, std::abs(static_cast<double>(wanted[axis])));
        }
    }
    // Places are rounded to 1e-6 m, and half texels to 11 bits.
    const bool half = texel == Texel::half;
    add_row(run, "windrow_velocity, m/s", half ? "half" : "single", worst, 1e-5 + (half ? largest / 2048.0 : 0.0), largest);
    return {};
}

Result<void> query_ground(SectionRun& run, Device& device, Texel texel) {
    const GroundConfig config{.texels = 96};
    auto cpu = windrow::GroundMemory::create(config);
    auto gpu = vulkan::GroundMemory::create(run.own.host(), config, texel);
    if (!cpu || !gpu)
        return cpu ? gpu.failure() : cpu.failure();
    std::vector<GroundWalker> walkers(3);
    for (int frame = 0; frame < 60; ++frame) {
        for (std::size_t n = 0; n < walkers.size(); ++n) {
            walkers[n].previous = walkers[n].position;
            const double turn = 0.05 * frame * static_cast<double>(n + 1);
            walkers[n].position = glm::dvec3(0.08 * frame, 0.0, 0.0) + 3.0 * glm::dvec3(std::cos(turn), 0.0, std::sin(turn));
            if (frame == 0)
                walkers[n].previous = walkers[n].position;
        }
        const GroundStep step{.duration = 1.0 / 60.0, .walkers = walkers, .wind_lean = {0.2 * std::sin(0.1 * frame), 0.1}};
        for (Result<void> done : {cpu->follow(walkers[0].position), gpu->follow(walkers[0].position), cpu->advance(step)})
            if (!done)
                return done;
        Result<void> recorded;
        auto ran = run.own.run([&](VkCommandBuffer commands) { recorded = gpu->record(commands, step); });
        if (!ran || !recorded)
            return ran ? recorded : ran;
    }
    auto block = Buffer::create(device, sizeof(GroundBlock), MemoryUse::upload, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    if (!block)
        return block.failure();
    const glm::dvec3 anchor = walkers[0].position;
    const GroundBlock content = gpu->block(anchor);
    std::memcpy(block->mapped(), &content, sizeof content);
    (void)block->flush(); // memory for uploads is coherent
    vulkan::Handle<VkSampler, &Functions::vkDestroySampler> sampler;
    VkSamplerCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    if (const VkResult result = make(device.functions(), device.host(), device.functions().vkCreateSampler, info, sampler);
        result != VK_SUCCESS)
        return call_error("vkCreateSampler", "the ground's textures", result);
    constexpr VkDescriptorType texture = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    const std::vector<glm::vec4> places = places_within({14.0f, 0.0f, 14.0f});
    const auto answers = answers_of(run.own, device, shader_words::query_ground, places,
                                    {{.type = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, .buffer = block->handle()},
                                     {.type = texture, .view = gpu->texture().view, .sampler = sampler.get()},
                                     {.type = texture, .view = gpu->previous_texture().view, .sampler = sampler.get()}});
    if (!answers)
        return answers.failure();
    double worst = 0.0, largest = 0.0;
    for (std::size_t n = 0; n < places.size(); ++n) {
        const GroundSample wanted = cpu->at(anchor + glm::dvec3(places[n]));
        const glm::vec4 values(wanted.lean.x, wanted.lean.y, wanted.trample, wanted.trail);
        for (int c = 0; c < 4; ++c) {
            worst = worse(worst, std::abs(static_cast<double>((*answers)[n][c]) - static_cast<double>(values[c])));
            largest = std::max(largest, std::abs(static_cast<double>(values[c])));
        }
    }
    // A half has 11 bits: 2^-11 of values up to 2.
    const bool half = texel == Texel::half;
    add_row(run, "windrow_ground, rad", half ? "half" : "single", worst, largest * 1e-4 + (half ? 0x1p-10 : 0.0), largest);
    return {};
}

} // namespace

Result<void> report_queries(SectionRun& run) {
    auto device = Device::create(run.own.host());
    if (!device)
        return device.failure();
    for (const auto query : {query_wind, query_ground})
        for (const Texel texel : {Texel::single, Texel::half}) {
            if (run.clock.stopped())
                return {};
            if (auto done = query(run, **device, texel); !done)
                return done;
        }
    return {};
}

} // namespace windrow::cli
