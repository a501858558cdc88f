// Obstacles on the device: the host rasterises them where they or the box have moved, and uploads the tables with the step.
#include "fluid/core/message.h"
#include "fluid/core/numerics.h"
#include "fluid/core/obstacle_record.h"
#include "fluid/vulkan/air.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/vector_relational.hpp>
#include <utility>

namespace windrow::vulkan {
namespace {

std::uint32_t with_room(std::size_t count) {
    return static_cast<std::uint32_t>(count + count / 2 + 64);
}

} // namespace

void Air::place_obstacles(VkCommandBuffer commands, std::span<const detail::PlacedObstacle> obstacles, double early) {
    if (!solids_ && obstacles.empty()) {
        unplaced_shift_ = glm::ivec3(0);
        place_again_ = false;
        return;
    }
    bool written = false;
    const bool placed = detail::memory_lasts([&] {
        if (!solids_)
            solids_ = std::make_unique<SolidTables>(box(), config_.max_cfl, finds_forces());
        placed_.assign(obstacles.begin(), obstacles.end());
        detail::move_back(placed_, early);
        solids_->place(placed_, unplaced_shift_);
        written = write_obstacles(commands);
    });
    unplaced_shift_ = glm::ivec3(0);
    reading_stale_ = true;
    place_again_ = !(placed && written);
    if (place_again_) // the air does without them in this step
        solids_.reset();
}

// Other boundaries make other images, neighbours and rooms. Faces keep their names.
void Air::place_within_boundaries(VkCommandBuffer commands) {
    if (solids_ && !put_obstacles(commands, true))
        place_again_ = true;
}

// As Cells::lift_obstacles of the CPU.
void Air::lift_obstacles(VkCommandBuffer commands, CellIndex by) {
    const glm::vec3 along(glm::vec3(unplaced_shift_) * config_.cell_size);
    const auto rise = static_cast<float>(static_cast<double>(by.y) * rows_table_->step());
    windrow::detail::follow_box(placed_, {along.x, rise, along.z}, box());
    (void)put_obstacles(commands, false);
    unplaced_shift_ = glm::ivec3(0);
    inside_is_air_ = place_again_ = reading_stale_ = true;
}

// Those of the last placement anew, in the cells of now. Without memory the air does without them.
bool Air::put_obstacles(VkCommandBuffer commands, bool keeps_faces) {
    bool written = false;
    const bool placed = detail::memory_lasts([&] {
        solids_->begin_anew(box(), keeps_faces);
        solids_->place(placed_, glm::ivec3(0));
        written = write_obstacles(commands);
    });
    if (!placed || !written)
        solids_.reset();
    return placed && written;
}

// As Cells::uncover of the CPU.
void Air::uncover(VkCommandBuffer commands, int substep) {
    if (!solids_ || !solids_->any() || inside_is_air_)
        return;
    place_exposed(commands);
    keep(commands); // as it was shown
    counted_ = false;
    barrier(k_transfer | k_compute, k_compute);
    dispatch(commands, Pass::uncover, WindrowUncoverPush{.shift = unplaced_shift_, .substep = substep, .past = fresh_ ? 0 : 1});
    barrier(k_compute, k_compute | k_transfer);
}

bool Air::write_obstacles(VkCommandBuffer commands) {
    if (!solids_->any()) {
        restored_terms_.clear();
        return true;
    }
    barrier(k_compute | k_transfer, k_transfer);
    if (!make_room_for_obstacles(commands))
        return false;
    clear(commands, fields_.around, offsetof(WindrowAround, groups_done), sizeof(WindrowAround::groups_done));
    const auto words = static_cast<int>(WINDROW_SURFACE_WORDS * surface_room_), faces = static_cast<int>(face_room_);
    WindrowSolids& head = solids_->head();
    head.history_before = words + history_slot_ * faces;
    history_slot_ ^= 1;
    head.history = words + history_slot_ * faces;
    const auto loads = static_cast<int>(WINDROW_LOAD * body_room_);
    head.loads_before = words + 2 * faces + (1 - history_slot_) * loads;
    head.loads = words + 2 * faces + history_slot_ * loads;
    write(commands, fields_.solids, solids_->bytes());
    barrier(k_transfer, k_compute);
    dispatch(commands, Pass::terms);
    barrier(k_compute, k_compute | k_transfer);
    return true;
}

VkDeviceSize Air::history_at(int slot) const {
    return sizeof(WindrowAround) +
           sizeof(float) * (VkDeviceSize{WINDROW_SURFACE_WORDS} * surface_room_ + static_cast<VkDeviceSize>(slot) * face_room_);
}

VkDeviceSize Air::loads_at(int slot) const {
    return history_at(2) + sizeof(float) * VkDeviceSize{WINDROW_LOAD} * static_cast<VkDeviceSize>(slot) * body_room_;
}

DeviceSurface Air::surface() const {
    if (!solids_ || !solids_->any() || glm::any(glm::greaterThanEqual(glm::abs(unplaced_shift_), config_.cells)))
        return {};
    const auto keys = solids_->keys();
    return {.placed = placed_,
            .inside_is_air = inside_is_air_,
            .keys = {keys.begin(), keys.end()},
            .shift = unplaced_shift_,
            .load_duration = finds_forces() ? static_cast<float>(step_duration_) : 0.0f};
}

// The obstacles of the last step.
void Air::restore_obstacles(VkCommandBuffer commands, DeviceSurface&& surface, std::vector<float>&& terms,
                            std::span<const BodyLoad> loads) {
    const bool placed = detail::memory_lasts([&] {
        solids_ = std::make_unique<SolidTables>(box(), config_.max_cfl, finds_forces());
        solids_->set_keys(std::move(surface.keys));
        restored_terms_ = std::move(terms);
        placed_ = std::move(surface.placed);
        solids_->place(placed_, glm::ivec3(0));
    });
    place_again_ = !(placed && write_obstacles(commands));
    if (place_again_)
        solids_.reset();
    else if (finds_forces())
        restore_loads(commands, loads);
    inside_is_air_ = surface.inside_is_air;
    unplaced_shift_ = surface.shift;
    step_duration_ = static_cast<double>(surface.load_duration);
}

// What the pressure's history does to each body: the next step's forces need it.
void Air::restore_loads(VkCommandBuffer commands, std::span<const BodyLoad> loads) {
    const auto bodies = solids_->any() ? solids_->solids().bodies() : std::span<const detail::PlacedObstacle>();
    barrier(k_compute | k_transfer, k_transfer);
    for (std::size_t n = 0; n < bodies.size(); ++n) {
        const auto of = std::find_if(loads.begin(), loads.end(), [&](const BodyLoad& load) {
            return load.slot == bodies[n].slot && load.generation == bodies[n].generation;
        });
        if (of == loads.end())
            continue;
        std::array<float, WINDROW_LOAD> words{};
        auto to = words.begin();
        for (const PressurePush& push : {of->history, of->sources, of->sum, of->blast}) {
            for (const glm::dvec3& vector : {push.impulse, push.twist})
                for (int axis = 0; axis < 3; ++axis)
                    *to++ = static_cast<float>(vector[axis]);
            *to++ = static_cast<float>(push.potential);
            *to++ = static_cast<float>(push.wetted);
        }
        write(commands, fields_.around, std::as_bytes(std::span(words)), loads_at(history_slot_) + n * sizeof(words));
    }
    barrier(k_transfer, k_compute | k_transfer);
}

// The old buffer is kept until its slot is reused.
Result<void> Air::replace(Buffer& buffer, VkDeviceSize bytes) {
    auto made = Buffer::create(*device_, bytes, MemoryUse::device);
    if (!made)
        return made.failure();
    retired_.push_back({std::exchange(buffer, *std::move(made)), slot_});
    return {};
}

// The buffers grow with what is rasterised; the pressure's history moves with them.
Result<void> Air::make_room_for_obstacles(VkCommandBuffer commands) {
    const std::size_t faces = solids_->solids().faces().size(), surface = solids_->solids().surface().size();
    bool grown = !passes_know_obstacles_;
    const auto grow = [&](Buffer& buffer, VkDeviceSize bytes) {
        grown = true;
        return replace(buffer, bytes);
    };
    const VkDeviceSize cells = static_cast<VkDeviceSize>(box().cell_count()) * sizeof(float);
    for (const auto& [field, bytes] : {std::pair{&fields_.correction, 2 * cells}, std::pair{&fields_.direction, cells}})
        if (field->bytes() < bytes)
            if (auto made = grow(*field, bytes); !made)
                return made;
    if (fields_.solids.bytes() < solids_->bytes().size())
        if (auto made = grow(fields_.solids, with_room(solids_->bytes().size() / 4) * VkDeviceSize{4}); !made)
            return made;
    const std::size_t bodies = finds_forces() ? solids_->solids().bodies().size() : 0;
    if (surface > surface_room_ || faces + restored_terms_.size() > face_room_ || bodies > body_room_) {
        const std::uint32_t surface_room = std::max(surface_room_, with_room(surface)),
                            face_room = std::max(face_room_, with_room(faces + restored_terms_.size())),
                            body_room = bodies > body_room_ ? with_room(bodies) : body_room_;
        const VkDeviceSize words = VkDeviceSize{WINDROW_SURFACE_WORDS} * surface_room + VkDeviceSize{2} * face_room +
                                   VkDeviceSize{2 * WINDROW_LOAD} * body_room;
        if (auto made = grow(fields_.around, sizeof(WindrowAround) + sizeof(float) * words); !made)
            return made;
        clear(commands, fields_.around);
        barrier(k_transfer, k_transfer);
        const VkDeviceSize from = history_at(history_slot_), count = std::min(face_room_, face_room);
        const VkDeviceSize loads_from = loads_at(history_slot_), loads = sizeof(float) * VkDeviceSize{WINDROW_LOAD} * body_room_;
        const bool had = face_room_ > 0;
        surface_room_ = surface_room;
        face_room_ = face_room;
        body_room_ = body_room;
        if (had) {
            wait(commands);
            const VkBufferCopy regions[] = {
                {.srcOffset = from, .dstOffset = history_at(history_slot_), .size = sizeof(float) * count},
                {.srcOffset = loads_from, .dstOffset = loads_at(history_slot_), .size = loads}};
            device_->functions().vkCmdCopyBuffer(commands, retired_.back().piece.handle(), fields_.around.handle(),
                                                 loads > 0 ? 2 : 1, regions);
        }
    }
    if (!restored_terms_.empty()) {
        barrier(k_transfer, k_transfer);
        write(commands, fields_.around, std::as_bytes(std::span(restored_terms_)), history_at(history_slot_));
        restored_terms_.clear();
    }
    if (!grown)
        return {};
    if (auto bound = bind_anew(!passes_know_obstacles_); !bound)
        return bound;
    barrier(k_transfer, k_transfer);
    return {};
}

// The passes with the buffers of now; recordings in flight use the old ones. `for_obstacles`: they are made anew, to know them.
Result<void> Air::bind_anew(bool for_obstacles) {
    RetiredPasses old{.passes = {}, .sets = {}, .slot = slot_};
    if (for_obstacles) {
        auto passes = passes_for(true);
        if (!passes)
            return passes.failure();
        old.passes = std::exchange(passes_, *std::move(passes));
        passes_know_obstacles_ = true;
        shapes_.reset();
    } else {
        auto sets = passes_.rebind(*device_, fields_);
        if (!sets)
            return sets.failure();
        old.sets = *std::move(sets);
    }
    retired_passes_.push_back(std::move(old));
    return {};
}

// Uploads the pieces of the tables that are others now.
void Air::renew_layer(VkCommandBuffer commands, const CellStep& step, bool placed) {
    if (!layer_)
        return;
    const std::uint64_t before = layer_->version();
    layer_->renew(*step.ambient, *step.window, config_.boundaries, solids_ && solids_->any() ? &solids_->solids() : nullptr,
                  placed, config_.parallel_for);
    if (layer_->version() == before && !layer_written_.empty())
        return;
    const auto faces = layer_->faces();
    layer_wanted_.assign(faces.begin(), faces.end());
    layer_wanted_.resize(fields_.layer.bytes() / sizeof(float));
    std::ranges::copy(layer_->wind_mixing(), layer_wanted_.begin() + static_cast<std::ptrdiff_t>(faces.size()));
    std::ranges::copy(layer_->wind_drag(), layer_wanted_.end() - config_.cells.y);
    const bool all = layer_written_.size() != layer_wanted_.size();
    layer_written_.resize(layer_wanted_.size());
    barrier(k_compute | k_transfer, k_transfer);
    constexpr std::size_t k_piece = k_max_update / sizeof(float);
    for (std::size_t first = 0; first < layer_wanted_.size(); first += k_piece) {
        const auto wanted = std::span(layer_wanted_).subspan(first, std::min(k_piece, layer_wanted_.size() - first));
        const auto written = std::span(layer_written_).subspan(first, wanted.size());
        if (!all && std::ranges::equal(wanted, written))
            continue;
        std::ranges::copy(wanted, written.begin());
        write(commands, fields_.layer, std::as_bytes(wanted), first * sizeof(float));
    }
    barrier(k_transfer, k_compute);
}

Passes::Around Air::around_obstacles(bool has_past) const {
    if (!solids_ || !solids_->any())
        return {};
    return {.solves = pressure_solves(config_, has_past),
            .one_sided = solids_->one_sided(),
            .rooms = !solids_->solids().rooms().empty(),
            .sealed = !solids_->solids().sealed_parts().empty(),
            .loads = finds_forces()};
}

// From no guess: the flow of a burst is another in each step.
Passes::Around Air::around_sources() const {
    if (!solids_ || !solids_->any())
        return {};
    return {.solves = k_first_solves,
            .one_sided = false,
            .rooms = false,
            .sealed = !solids_->solids().sealed_parts().empty(),
            .loads = finds_forces(),
            .first_sources = first_sources_};
}

void Air::work_on_rooms(VkCommandBuffer commands, int work) {
    dispatch(commands, Pass::rooms, WindrowRoomsPush{.substep = 0, .work = work});
    barrier(k_compute, k_compute);
}

// As Cells::open_parts and Cells::seal_sources of the CPU.
std::span<const detail::MotorReach> Air::uncovered(std::span<const detail::MotorReach> motors) {
    using Law = detail::MotorReach::Law;
    motors = motors.first(std::min<std::size_t>(motors.size(), k_max_motors));
    sealed_sources_ = 0;
    if (!solids_ || !solids_->any() ||
        std::none_of(motors.begin(), motors.end(), [](const auto& motor) { return motor.law == Law::source; }))
        return motors;
    const Solids& solids = solids_->solids();
    const Boundaries& boundaries = config_.boundaries;
    const bool closed = !boundaries.has_open(0) && !boundaries.has_open(1) && !boundaries.has_open(2);
    uncovered_.assign(motors.begin(), motors.end());
    for (detail::MotorReach& motor : uncovered_) {
        if (motor.law != Law::source)
            continue;
        float whole = 0.0f, open = 0.0f;
        bool in_room = closed;
        for (int k = motor.low.z; k < motor.high.z; ++k)
            for (int j = motor.low.y; j < motor.high.y; ++j)
                for (int i = motor.low.x; i < motor.high.x; ++i) {
                    const glm::vec3 off = box().centre(i, j, k) - motor.centre;
                    const float weight = box().volume(j) * numerics::windrow_sphere_weight(off, motor.radius);
                    const auto cell = static_cast<std::uint32_t>(box().index(i, j, k));
                    whole += weight;
                    in_room = in_room || solids.in_room(cell);
                    open += solids.inside(cell) || solids.in_room(cell) ? 0.0f : weight;
                }
        motor.push.x *= whole > 0.0f ? open / whole : 1.0f;
        sealed_sources_ += in_room ? 1 : 0;
    }
    return uncovered_;
}

} // namespace windrow::vulkan
