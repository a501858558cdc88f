// What the host reads of a frame: the report, and the cells or the wind at points that it asked for. Shaders write them into the
// mapped memory of a slot; nothing is copied.
#include "fluid/vulkan/air.h"

#include <cstring>
#include <utility>

namespace windrow::vulkan {

namespace {

// At the end of a slot.
VkDeviceSize forces_bytes(const Reads& reads) {
    return static_cast<VkDeviceSize>(reads.forces) * WINDROW_PUSHED * sizeof(float);
}

} // namespace

VkDeviceSize Air::slot_bytes(const Reads& reads) {
    const glm::u64vec3 cells(reads.cells);
    const VkDeviceSize count =
        reads.kind == ReadBack::points ? static_cast<VkDeviceSize>(reads.points) : cells.x * cells.y * cells.z;
    const VkDeviceSize each = reads.kind == ReadBack::halves ? sizeof(glm::u16vec4) : sizeof(glm::vec4);
    return sizeof(WindrowReport) + (reads.kind == ReadBack::none ? 0 : count * each) + forces_bytes(reads);
}

int Air::forces_at(const Reads& reads) {
    return static_cast<int>((slot_bytes(reads) - forces_bytes(reads) - sizeof(WindrowReport)) / sizeof(float));
}

void Air::read_back(VkCommandBuffer commands, const ReadRequest& request) {
    const ReadBack kind = settings_.reads.kind;
    order_passes();
    if (std::exchange(reported_slot_, -1) != request.slot) {
        const auto sums = static_cast<int>(fields_.sums.bytes() / sizeof(glm::vec2));
        dispatch(commands, Pass::report,
                 WindrowReportPush{.sums = sums, .forces = settings_.reads.forces, .forces_at = forces_at(settings_.reads)},
                 request.slot);
    }
    if (kind == ReadBack::points) {
        if (!request.points.empty()) {
            barrier(k_compute, k_compute | k_transfer);
            write(commands, fields_.points, std::as_bytes(request.points));
            barrier(k_transfer, k_compute);
            const WallLaw law = reading_ ? reading_->law() : WallLaw{};
            dispatch(commands, Pass::read_points,
                     WindrowPointsPush{.shift = sampled_part().low,
                                       .points = static_cast<int>(request.points.size()),
                                       .factor = shown_factor_,
                                       .wall_per_length = law.per_length,
                                       .wall_per_log = law.per_log,
                                       .wall_lowest = law.lowest,
                                       .wall_fall = law.fall},
                     request.slot);
        }
    } else if (kind != ReadBack::none) {
        order_passes(); // they write one buffer
        dispatch(commands, Pass::read_cells,
                 WindrowReadPush{.low = request.low, .factor = shown_factor_, .size = settings_.reads.cells, .unused = 0},
                 request.slot);
    }
    if (!ordered_) // something was written behind `show`
        barrier(k_compute, VK_PIPELINE_STAGE_HOST_BIT | k_compute | k_transfer);
}

AirReport Air::report(int slot) const {
    WindrowReport read{};
    std::memcpy(&read, this->slot(slot).mapped(), sizeof(read));
    return {.largest_component = read.largest_component,
            .cfl = read.cfl,
            .substeps = static_cast<int>(read.substeps & 0xffu),
            .substeps_capped = (read.substeps >> 8 & 1u) != 0,
            .carried_time = 1e-6f * static_cast<float>(read.substeps >> 9),
            .repaired_cells = static_cast<int>(read.repaired_cells),
            .limited_cells = static_cast<int>(read.limited_cells),
            .apart = read.apart,
            .pressure_residual = read.pressure_residual,
            .pressure_solves = static_cast<int>(read.pressure_solves),
            .still = read.still,
            .largest_before = {read.largest_before[0], read.largest_before[1], read.largest_before[2], read.largest_before[3]},
            .squares = static_cast<double>(read.squares),
            .divergence_squares = static_cast<double>(read.divergence_squares)};
}

std::span<const std::byte> Air::read(int slot) const {
    const Buffer& buffer = this->slot(slot);
    return {buffer.mapped() + sizeof(WindrowReport),
            static_cast<std::size_t>(slot_bytes(settings_.reads) - forces_bytes(settings_.reads)) - sizeof(WindrowReport)};
}

PressurePush Air::push_on(int slot, int body) const {
    std::array<float, WINDROW_PUSHED> read{};
    const std::size_t first = slot_bytes(settings_.reads) - forces_bytes(settings_.reads);
    std::memcpy(read.data(), this->slot(slot).mapped() + first + static_cast<std::size_t>(body) * sizeof(read), sizeof(read));
    return {.impulse = {read[0], read[1], read[2]},
            .twist = {read[3], read[4], read[5]},
            .potential = static_cast<double>(read[6]),
            .wetted = static_cast<double>(read[7])};
}

std::span<const detail::PlacedObstacle> Air::bodies() const {
    return solids_ && solids_->any() ? solids_->solids().bodies() : std::span<const detail::PlacedObstacle>();
}

} // namespace windrow::vulkan
