#include "coupling/vulkan/ground_memory.h"

#include "coupling/ground_host.h"
#include "fluid/core/message.h"
#include "gpu/device.h"
#include "shader_words/ground_float.h"
#include "shader_words/ground_half.h"

#include <array>
#include <cstddef>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace windrow::vulkan {
namespace {

constexpr VkPipelineStageFlags k_compute = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT;
constexpr VkPipelineStageFlags k_transfer = VK_PIPELINE_STAGE_TRANSFER_BIT;
constexpr std::uint32_t k_group = 8; // along each axis; ground_pass.glsl

static_assert(sizeof(numerics::WindrowGroundStep) == 9 * 16 && sizeof(numerics::WindrowWalker) == 2 * 16);

VkAccessFlags writes_of(VkPipelineStageFlags stages) {
    return ((stages & k_compute) != 0 ? VK_ACCESS_SHADER_WRITE_BIT : 0) |
           ((stages & k_transfer) != 0 ? VK_ACCESS_TRANSFER_WRITE_BIT : 0);
}

VkAccessFlags uses_of(VkPipelineStageFlags stages) {
    return ((stages & k_compute) != 0 ? VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT : 0) |
           ((stages & k_transfer) != 0 ? VK_ACCESS_TRANSFER_READ_BIT | VK_ACCESS_TRANSFER_WRITE_BIT : 0);
}

// An image that is written whole, from no layout.
VkImageMemoryBarrier begun_anew(const Image3D& image, VkAccessFlags access, VkImageLayout layout) {
    return {.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER,
            .pNext = nullptr,
            .srcAccessMask = 0,
            .dstAccessMask = access,
            .oldLayout = VK_IMAGE_LAYOUT_UNDEFINED,
            .newLayout = layout,
            .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
            .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
            .image = image.handle(),
            .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1}};
}

// And then, to those who sample it.
void to_readers(VkImageMemoryBarrier& image) {
    image.srcAccessMask = image.dstAccessMask;
    image.dstAccessMask = VK_ACCESS_SHADER_READ_BIT;
    image.oldLayout = image.newLayout;
    image.newLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
}

} // namespace

struct WINDROW_HIDDEN GroundMemory::State {
    State(std::unique_ptr<Device> lent, const GroundConfig& config) : device(std::move(lent)), host(config) {}

    [[nodiscard]] Result<void> make(Texel texel);
    [[nodiscard]] Result<void> make_memory(Texel texel);
    [[nodiscard]] std::array<Buffer*, 6> buffers() { return {&step, &walkers, &motion, &memory, &leans_before, &leans}; }
    void barrier(VkCommandBuffer commands, VkPipelineStageFlags from, VkPipelineStageFlags to) const;
    void dispatch(VkCommandBuffer commands, int into) const;
    void copy(VkCommandBuffer commands, const Buffer& from, const Buffer& to, VkDeviceSize read, VkDeviceSize write,
              VkDeviceSize bytes) const;
    [[nodiscard]] Result<void> stage(const windrow::detail::SavedGround& ground, Texel texel);
    void take_staged(VkCommandBuffer commands) const;
    /// What a save copies, one behind another.
    [[nodiscard]] std::array<const Buffer*, 3> kept() const { return {&motion, &memory, &leans_before}; }

    std::unique_ptr<Device> device; // above what is made from it, which goes first
    windrow::detail::GroundHost host;
    Buffer step, walkers, motion, memory, leans_before, leans;
    std::array<Image3D, 2> images;
    std::shared_ptr<const Pipeline> pipeline;
    Sets sets;
    int set = 0;
    bool recorded = false;
    Buffer save;                                          // of the last record_save
    std::optional<windrow::detail::GroundHost> save_host; // as it was then
    Buffer staged;                                        // of `load`: what a save copies, then the texels of a texture
    bool is_staged = false;                               // and no step has taken it
};

GroundMemory::GroundMemory(std::unique_ptr<State> state) : state_(std::move(state)) {}
GroundMemory::GroundMemory(GroundMemory&&) noexcept = default;
GroundMemory& GroundMemory::operator=(GroundMemory&&) noexcept = default;
GroundMemory::~GroundMemory() = default;

Result<GroundMemory> GroundMemory::create(const Host& host, const GroundConfig& config, Texel texel) {
    if (auto valid = validate(config); !valid)
        return valid.failure();
    return windrow::detail::where_memory_lasts([&]() -> Result<GroundMemory> {
        auto device = Device::create(host);
        if (!device)
            return device.failure();
        auto state = std::make_unique<State>(*std::move(device), config);
        if (auto made = state->make(texel); !made)
            return made.failure();
        return GroundMemory(std::move(state));
    });
}

Result<GroundMemory> GroundMemory::load(const Host& host, std::span<const std::byte> bytes, Texel texel) {
    auto saved = windrow::detail::ground_of(bytes);
    if (!saved)
        return saved.failure();
    auto made = create(host, saved->host.config(), texel);
    if (!made)
        return made;
    State& state = *made->state_;
    if (saved->stepped)
        if (auto staged = state.stage(*saved, texel); !staged)
            return staged.failure();
    state.recorded = saved->stepped;
    state.host = std::move(saved->host);
    return made;
}

// In the order of `buffers`.
Result<void> GroundMemory::State::make_memory(Texel texel) {
    const GroundConfig& config = host.config();
    const auto n = static_cast<std::uint32_t>(config.texels);
    const VkDeviceSize texels = host.texel_count();
    const std::array<VkDeviceSize, 6> bytes = {
        sizeof(numerics::WindrowGroundStep), sizeof(numerics::WindrowWalker) * static_cast<VkDeviceSize>(config.max_walkers),
        texels * sizeof(glm::vec4),          texels * sizeof(glm::vec4),
        texels * sizeof(glm::vec2),          texels * sizeof(glm::vec2)};
    for (std::size_t each = 0; each < bytes.size(); ++each) {
        auto made = Buffer::create(*device, bytes[each], MemoryUse::device);
        if (!made)
            return made.failure();
        *buffers()[each] = *std::move(made);
        device->name(VK_OBJECT_TYPE_BUFFER, buffers()[each]->handle(), "ground");
    }
    const VkFormat format = texel == Texel::half ? VK_FORMAT_R16G16B16A16_SFLOAT : VK_FORMAT_R32G32B32A32_SFLOAT;
    for (Image3D& image : images) {
        auto made = Image3D::create(*device, {n, n, 1}, format);
        if (!made)
            return made.failure();
        image = *std::move(made);
        device->name(VK_OBJECT_TYPE_IMAGE, image.handle(), "ground texture");
    }
    return {};
}

Result<void> GroundMemory::State::make(Texel texel) {
    device->memory().measure(); // once without memory, so that its blocks have the right size
    auto made = make_memory(texel);
    (void)device->memory().expect_measured();
    if (made)
        made = make_memory(texel);
    if (!made)
        return made;
    const auto n = static_cast<std::uint32_t>(host.config().texels);
    std::vector<Binding> bindings;
    for (const Buffer* buffer : buffers())
        bindings.push_back({.type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, .buffer = buffer->handle()});
    const std::uint32_t groups = (n + k_group - 1) / k_group;
    if (auto fits = device->check({.groups = {groups, groups, 1}, .local_size = {k_group, k_group, 1}, .name = "ground"}); !fits)
        return fits;
    std::vector<VkDescriptorType> kinds(bindings.size(), VK_DESCRIPTOR_TYPE_STORAGE_BUFFER);
    kinds.push_back(VK_DESCRIPTOR_TYPE_STORAGE_IMAGE);
    const auto code =
        texel == Texel::half ? std::span<const std::uint32_t>(shader_words::ground_half) : shader_words::ground_float;
    auto compute = device->pipeline({.code = code, .bindings = kinds, .constants = {}, .push_bytes = 0, .name = "ground"});
    if (!compute)
        return compute.failure();
    pipeline = *std::move(compute);
    std::vector<Sets::Content> contents;
    for (const Image3D& image : images) {
        contents.push_back({pipeline.get(), bindings});
        contents.back().bindings.push_back({.type = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, .view = image.view()});
    }
    auto bound = Sets::create(*device, contents);
    if (!bound)
        return bound.failure();
    sets = *std::move(bound);
    return {};
}

void GroundMemory::State::barrier(VkCommandBuffer commands, VkPipelineStageFlags from, VkPipelineStageFlags to) const {
    const VkMemoryBarrier all{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                              .pNext = nullptr,
                              .srcAccessMask = writes_of(from),
                              .dstAccessMask = uses_of(to)};
    device->functions().vkCmdPipelineBarrier(commands, from, to, 0, 1, &all, 0, nullptr, 0, nullptr);
}

// Writes an image whole, from no layout to the one that shaders read.
void GroundMemory::State::dispatch(VkCommandBuffer commands, int into) const {
    const Functions& call = device->functions();
    VkImageMemoryBarrier image =
        begun_anew(images[static_cast<std::size_t>(into)], VK_ACCESS_SHADER_WRITE_BIT, VK_IMAGE_LAYOUT_GENERAL);
    // Whoever sampled it two frames ago is done first.
    call.vkCmdPipelineBarrier(commands, device->reader_stages() | k_compute, k_compute, 0, 0, nullptr, 0, nullptr, 1, &image);
    pipeline->bind(call, commands, sets.at(static_cast<std::size_t>(into)));
    const std::uint32_t groups = (static_cast<std::uint32_t>(host.config().texels) + k_group - 1) / k_group;
    call.vkCmdDispatch(commands, groups, groups, 1);
    to_readers(image);
    call.vkCmdPipelineBarrier(commands, k_compute, device->reader_stages(), 0, 0, nullptr, 0, nullptr, 1, &image);
}

// --- Saving ------------------------------------------------------------------------------------------------------------------

void GroundMemory::State::copy(VkCommandBuffer commands, const Buffer& from, const Buffer& to, VkDeviceSize read,
                               VkDeviceSize write, VkDeviceSize bytes) const {
    const VkBufferCopy region{.srcOffset = read, .dstOffset = write, .size = bytes};
    device->functions().vkCmdCopyBuffer(commands, from.handle(), to.handle(), 1, &region);
}

Result<void> GroundMemory::record_save(VkCommandBuffer commands) {
    State& state = *state_;
    if (commands == VK_NULL_HANDLE)
        return Error{"GroundMemory::record_save got no command buffer: give one that is being recorded."};
    if (!state.recorded || state.is_staged)
        return Error{"GroundMemory::record_save is called before the first step: record one, then save."};
    if (state.save.handle() == VK_NULL_HANDLE) {
        VkDeviceSize bytes = 0;
        for (const Buffer* const buffer : state.kept())
            bytes += buffer->bytes();
        auto made = Buffer::create(*state.device, bytes, MemoryUse::readback);
        if (!made)
            return made.failure();
        state.save = *std::move(made);
        state.device->name(VK_OBJECT_TYPE_BUFFER, state.save.handle(), "saved ground");
    }
    state.barrier(commands, k_compute | k_transfer, k_transfer);
    VkDeviceSize at = 0;
    for (const Buffer* const buffer : state.kept()) {
        state.copy(commands, *buffer, state.save, 0, at, buffer->bytes());
        at += buffer->bytes();
    }
    const VkMemoryBarrier all{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                              .pNext = nullptr,
                              .srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT,
                              .dstAccessMask = VK_ACCESS_HOST_READ_BIT};
    state.device->functions().vkCmdPipelineBarrier(commands, k_transfer, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &all, 0, nullptr, 0,
                                                   nullptr);
    state.save_host = state.host;
    return {};
}

Result<std::vector<std::byte>> GroundMemory::saved() {
    State& state = *state_;
    if (!state.save_host)
        return Error{
            "GroundMemory::saved has nothing: record a step and record_save, wait for their commands, and call it once."};
    return windrow::detail::where_memory_lasts([&]() -> Result<std::vector<std::byte>> {
        if (const VkResult result = state.save.invalidate(); result != VK_SUCCESS)
            return call_error("vkInvalidateMappedMemoryRanges", "a saved ground", result);
        windrow::detail::SavedGround ground(state.host.config());
        ground.host = *state.save_host;
        ground.stepped = true;
        const std::byte* const motion = state.save.mapped();
        const std::byte* const memory = motion + state.motion.bytes();
        for (std::size_t n = 0; n < ground.texels.size(); ++n) {
            glm::vec4 moves, keeps;
            std::memcpy(&moves, motion + n * sizeof moves, sizeof moves);
            std::memcpy(&keeps, memory + n * sizeof keeps, sizeof keeps);
            ground.texels[n] = {
                .lean = {moves.x, moves.y}, .velocity = {moves.z, moves.w}, .trail = {keeps.x, keeps.y}, .trample = keeps.z};
            ground.shown_before[n] = numerics::windrow_ground_shown(ground.texels[n]);
        }
        std::memcpy(ground.leans_before.data(), memory + state.memory.bytes(), state.leans_before.bytes());
        auto bytes = to_bytes(ground);
        if (bytes)
            state.save_host.reset();
        return bytes;
    });
}

// For the next step to take.
Result<void> GroundMemory::State::stage(const windrow::detail::SavedGround& ground, Texel texel) {
    const VkDeviceSize shown_bytes = texel == Texel::half ? sizeof(std::uint64_t) : sizeof(glm::vec4);
    VkDeviceSize bytes = shown_bytes * host.texel_count();
    for (const Buffer* const buffer : kept())
        bytes += buffer->bytes();
    auto made = Buffer::create(*device, bytes, MemoryUse::upload);
    if (!made)
        return made.failure();
    staged = *std::move(made);
    device->name(VK_OBJECT_TYPE_BUFFER, staged.handle(), "loaded ground");
    std::byte* const to_motion = staged.mapped();
    std::byte* const to_memory = to_motion + motion.bytes();
    std::byte* const to_leans = to_memory + memory.bytes();
    std::byte* const to_shown = to_leans + leans_before.bytes();
    for (std::size_t n = 0; n < ground.texels.size(); ++n) {
        const numerics::WindrowGround& one = ground.texels[n];
        const glm::vec4 moves(one.lean, one.velocity), keeps(one.trail, one.trample, 0.0f),
            shown = numerics::windrow_ground_shown(one);
        std::memcpy(to_motion + n * sizeof moves, &moves, sizeof moves);
        std::memcpy(to_memory + n * sizeof keeps, &keeps, sizeof keeps);
        const std::uint64_t halves = glm::packHalf4x16(shown);
        std::memcpy(to_shown + n * shown_bytes, texel == Texel::half ? static_cast<const void*>(&halves) : &shown, shown_bytes);
    }
    std::memcpy(to_leans, ground.leans_before.data(), leans_before.bytes());
    if (const VkResult result = staged.flush(); result != VK_SUCCESS)
        return call_error("vkFlushMappedMemoryRanges", "a loaded ground", result);
    is_staged = true;
    return {};
}

// Into the buffers, and into the texture of the frame before the next step.
void GroundMemory::State::take_staged(VkCommandBuffer commands) const {
    const Functions& call = device->functions();
    barrier(commands, k_compute | k_transfer, k_transfer);
    VkDeviceSize at = 0;
    for (const Buffer* const buffer : kept()) {
        copy(commands, staged, *buffer, at, 0, buffer->bytes());
        at += buffer->bytes();
    }
    VkImageMemoryBarrier image =
        begun_anew(images[static_cast<std::size_t>(set)], VK_ACCESS_TRANSFER_WRITE_BIT, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    call.vkCmdPipelineBarrier(commands, k_transfer, k_transfer, 0, 0, nullptr, 0, nullptr, 1, &image);
    const auto n = static_cast<std::uint32_t>(host.config().texels);
    const VkBufferImageCopy region{.bufferOffset = at,
                                   .bufferRowLength = 0,
                                   .bufferImageHeight = 0,
                                   .imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
                                   .imageOffset = {0, 0, 0},
                                   .imageExtent = {n, n, 1}};
    call.vkCmdCopyBufferToImage(commands, staged.handle(), image.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    to_readers(image);
    call.vkCmdPipelineBarrier(commands, k_transfer, device->reader_stages(), 0, 0, nullptr, 0, nullptr, 1, &image);
}

Result<void> GroundMemory::follow(glm::dvec3 point) {
    return state_->host.follow(point);
}
Result<void> GroundMemory::shift_origin(glm::dvec3 offset) {
    return state_->host.shift_origin(offset);
}

Result<void> GroundMemory::record(VkCommandBuffer commands, const GroundStep& step, WindLeans leans) {
    State& state = *state_;
    if (commands == VK_NULL_HANDLE)
        return Error{"GroundMemory::record got no command buffer: give one that is being recorded."};
    const auto begun = state.host.begin(step, leans);
    if (!begun)
        return begun.failure();
    const Functions& call = state.device->functions();
    const bool first = !std::exchange(state.recorded, true);
    if (std::exchange(state.is_staged, false))
        state.take_staged(commands);
    state.barrier(commands, k_compute | k_transfer, k_compute | k_transfer);
    call.vkCmdUpdateBuffer(commands, state.step.handle(), 0, sizeof(*begun), &*begun);
    if (const auto walkers = state.host.walkers(); !walkers.empty())
        call.vkCmdUpdateBuffer(commands, state.walkers.handle(), 0, walkers.size_bytes(), walkers.data());
    state.barrier(commands, k_transfer, k_compute);
    state.set ^= 1;
    state.dispatch(commands, state.set);
    if (first) { // the frame before the first is the first: every texel is new, so the same step again gives the same texels
        state.barrier(commands, k_compute, k_compute);
        state.dispatch(commands, state.set ^ 1);
    }
    return {};
}

int GroundMemory::walkers_left_out() const {
    return state_->host.left_out();
}
VkBuffer GroundMemory::lean_buffer() const {
    return state_->leans.handle();
}
GroundPlaceBlock GroundMemory::next_place(glm::dvec3 anchor) const {
    return state_->host.next_place(anchor);
}

namespace {

GroundTexture texture_of(const Image3D& image) {
    return {.image = image.handle(), .view = image.view()};
}

} // namespace

GroundTexture GroundMemory::texture() const {
    return texture_of(state_->images[static_cast<std::size_t>(state_->set)]);
}
GroundTexture GroundMemory::previous_texture() const {
    return texture_of(state_->images[static_cast<std::size_t>(state_->set ^ 1)]);
}
GroundBlock GroundMemory::block(glm::dvec3 anchor) const {
    return state_->host.block(anchor);
}
const GroundConfig& GroundMemory::config() const {
    return state_->host.config();
}
std::uint64_t GroundMemory::memory_bytes() const {
    return state_->device->memory().given();
}
std::uint64_t GroundMemory::reserved_bytes() const {
    return state_->device->memory().taken();
}

} // namespace windrow::vulkan
