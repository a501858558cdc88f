// What a frame shows of the air on the device: textures, filled beside surfaces (fluid/solids/reading.h). The host makes the tables of
// that, where obstacles were placed, and uploads them before the textures are written.
#include "fluid/core/message.h"
#include "fluid/vulkan/air.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <utility>

namespace windrow::vulkan {
namespace {

// The tables as shaders/fluid/reading.glsl reads them.
void write_words(const SurfaceReading* reading, glm::ivec3 box, std::vector<std::int32_t>& words) {
    constexpr std::size_t k_head = sizeof(WindrowReading) / sizeof(std::int32_t);
    words.assign(k_head, 0);
    if (reading == nullptr)
        return;
    WindrowReading head{};
    const auto here = [&] { return static_cast<int>(words.size() - k_head); };
    const auto put = [&](const auto&... values) { (words.push_back(std::bit_cast<std::int32_t>(values)), ...); };
    const auto cells = reading->cells();
    head.on = 1;
    head.rows = here();
    std::size_t next = 0;
    for (std::uint32_t row = 0; row <= static_cast<std::uint32_t>(box.y * box.z); ++row) {
        while (next < cells.size() && cells[next].cell < row * static_cast<std::uint32_t>(box.x))
            ++next;
        words.push_back(static_cast<std::int32_t>(next));
    }
    head.columns = here();
    for (const auto& cell : cells)
        put(cell.cell % static_cast<std::uint32_t>(box.x));
    head.entries = here();
    for (const auto& cell : cells)
        put(cell.first, cell.count, cell.wall, cell.height, cell.raise);
    head.terms = here();
    for (const auto& term : reading->terms())
        put(term.cell, term.weight, term.raised);
    head.walls = here();
    for (const auto& wall : reading->walls())
        put(wall.normal.x, wall.normal.y, wall.normal.z, wall.across, wall.own.x, wall.own.y, wall.own.z, wall.keep);
    head.laws = reading->rows().empty() ? -1 : here();
    for (const auto& row : reading->rows())
        put(row.height, row.raise);
    std::memcpy(words.data(), &head, sizeof(head));
}

} // namespace

// Of the air now.
SurfaceReading::Part Air::sampled_part() const {
    return {.cells = config_.cells, .low = reading_ ? glm::ivec3(window_.origin_cells - reading_origin_) : glm::ivec3(0)};
}

// Of the obstacles as they were placed last.
void Air::renew_reading(VkCommandBuffer commands) {
    const bool bodies = solids_ && solids_->any();
    Window window = window_;
    if (bodies)
        window.origin_cells -= CellIndex(unplaced_shift_);
    else if (drag_.any())
        window.origin_cells = drag_origin_;
    if (!reading_stale_ && (reading_origin_ == window.origin_cells || !reading_maker_.depends_on_place()))
        return;
    reading_stale_ = false;
    reading_origin_ = window.origin_cells;
    const bool was = reading_ != nullptr;
    reading_.reset();
    const bool made = windrow::detail::memory_lasts([&] {
        if (bodies || wall_law(config_, box()).acts())
            reading_ = reading_maker_.make(bodies ? &solids_->solids() : nullptr, config_.boundaries, window, drag_);
        if ((reading_ || was || (passes_.sample() && !reading_known_)) && !write_reading(commands))
            throw std::bad_alloc();
    });
    if (made)
        return;
    reading_.reset(); // cells as they are
    reading_stale_ = true;
    constexpr WindrowReading k_none{};
    barrier(k_compute | k_transfer, k_transfer);
    write(commands, fields_.reading, std::as_bytes(std::span(&k_none, 1)));
    barrier(k_transfer, k_compute);
    reading_known_ = true;
}

Result<void> Air::write_reading(VkCommandBuffer commands) {
    write_words(reading_.get(), config_.cells, reading_words_);
    const std::span<const std::byte> bytes = std::as_bytes(std::span(reading_words_));
    const bool grown = fields_.reading.bytes() < bytes.size();
    if (grown)
        if (auto made = replace(fields_.reading, bytes.size() + bytes.size() / 2); !made)
            return made;
    if (const bool anew = reading_ && !passes_.sample(); grown || anew)
        if (auto bound = bind_anew(anew); !bound)
            return bound;
    barrier(k_compute | k_transfer, k_transfer);
    write(commands, fields_.reading, bytes);
    barrier(k_transfer, k_compute);
    reading_known_ = true;
    return {};
}

void Air::show(VkCommandBuffer commands, float factor, int frame, bool reports, std::optional<int> slot) {
    place_exposed(commands);
    renew_reading(commands);
    std::array<VkImageMemoryBarrier, 4> all{};
    std::size_t count = 0;
    fields_.each_image(frame, [&](const Image3D& image) {
        all[count++] = {.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER,
                        .pNext = nullptr,
                        .srcAccessMask = 0,
                        .dstAccessMask = VK_ACCESS_SHADER_WRITE_BIT,
                        .oldLayout = VK_IMAGE_LAYOUT_UNDEFINED, // written whole
                        .newLayout = VK_IMAGE_LAYOUT_GENERAL,
                        .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                        .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                        .image = image.handle(),
                        .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1}};
    });
    const std::span images(all.data(), count);
    // Readers of two frames ago finish first.
    barrier(device_->reader_stages() | k_compute | k_transfer, k_compute);
    wait(commands, images);
    shown_factor_ = keeps_ ? 1.0f : factor;
    dispatch(commands, Pass::show,
             WindrowShowPush{.shift = sampled_part().low,
                             .factor = shown_factor_,
                             .reports = !reports ? WINDROW_REPORTS_NOTHING
                                        : slot   ? WINDROW_REPORTS_TO_HOST
                                                 : WINDROW_REPORTS_SUMS,
                             .forces = settings_.reads.forces,
                             .forces_at = forces_at(settings_.reads)},
             frame * settings_.reads.slots + slot.value_or(0));
    if (reports)
        reported_slot_ = slot.value_or(-1);
    for (VkImageMemoryBarrier& image : images) {
        image.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
        image.dstAccessMask = VK_ACCESS_SHADER_READ_BIT;
        image.oldLayout = VK_IMAGE_LAYOUT_GENERAL;
        image.newLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    }
    // The gust tile is made visible with the images: the host's shaders read it too.
    const VkMemoryBarrier tile{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                               .pNext = nullptr,
                               .srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT,
                               .dstAccessMask = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_HOST_READ_BIT};
    device_->functions().vkCmdPipelineBarrier(commands, k_compute | k_transfer,
                                              device_->reader_stages() | k_compute | VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &tile, 0,
                                              nullptr, static_cast<std::uint32_t>(images.size()), images.data());
    ++barriers_;
    ordered_ = true; // the host and the passes to come find the report and the sums too
}

} // namespace windrow::vulkan
