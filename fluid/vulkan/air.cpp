#include "fluid/vulkan/air.h"

#include "fluid/core/message.h"
#include "fluid/grid/box_rules.h"
#include "gpu/label.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace windrow::vulkan {
namespace {

constexpr double k_longest_prepared = 1.0; // [s] a step's viscosity

VkAccessFlags reads_of(VkPipelineStageFlags stages) {
    VkAccessFlags access = 0;
    if ((stages & k_compute) != 0)
        access |= VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT;
    if ((stages & k_transfer) != 0)
        access |= VK_ACCESS_TRANSFER_READ_BIT | VK_ACCESS_TRANSFER_WRITE_BIT;
    if ((stages & k_indirect) != 0)
        access |= VK_ACCESS_INDIRECT_COMMAND_READ_BIT;
    if ((stages & VK_PIPELINE_STAGE_HOST_BIT) != 0)
        access |= VK_ACCESS_HOST_READ_BIT;
    return access;
}

VkAccessFlags writes_of(VkPipelineStageFlags stages) {
    return ((stages & k_compute) != 0 ? VK_ACCESS_SHADER_WRITE_BIT : 0) |
           ((stages & k_transfer) != 0 ? VK_ACCESS_TRANSFER_WRITE_BIT : 0);
}

// Diffusion method of one sub-step of the given duration, the longest.
DiffusionMethod method_of(const Config& config, const Box& box, double duration) {
    return config.stages.diffusion ? diffusion_method(config.viscosity, static_cast<float>(duration), box.finest())
                                   : DiffusionMethod::none;
}

} // namespace

Result<std::unique_ptr<Air>> Air::create(const Host& host, const Config& config, const Settings& settings) {
    auto device = Device::create(host);
    if (!device)
        return device.failure();
    return create(*std::move(device), config, settings);
}

Result<std::unique_ptr<Air>> Air::create(std::unique_ptr<Device> device, const Config& config, const Settings& settings) {
    if (auto valid = validate(config); !valid)
        return valid.failure();
    std::unique_ptr<Air> air(new Air(std::move(device), config, settings));
    if (auto made = air->make(); !made)
        return made.failure();
    return air;
}

Result<Memory::Measured> Air::measure(std::unique_ptr<Device> device, const Config& config, const Settings& settings) {
    Air air(std::move(device), config, settings);
    return air.measure();
}

// Makes all that takes memory without memory, so that its blocks have the right size.
Result<Memory::Measured> Air::measure() {
    prepared_ = method_of(config_, box(), k_longest_prepared);
    // Size check before any allocation of that size on host or device: the padded fields, and the tables of the direct solves.
    const glm::dvec3 padded = glm::dvec3(config_.cells + WINDROW_HALO);
    const double floats =
        std::max((settings_.gusts ? 12.0 : 8.0) * padded.x * padded.y * padded.z + (settings_.outer ? 1048576.0 : 0.0),
                 static_cast<double>(SolveTables::max_floats(config_.cells, prepared_ == DiffusionMethod::implicit)));
    if (4.0 * floats > static_cast<double>(device_->limits().maxStorageBufferRange))
        return Error{detail::message("A box of ", config_.cells.x, " x ", config_.cells.y, " x ", config_.cells.z,
                                     " cells takes a buffer of ", 4.0 * floats, " bytes, but the device allows ",
                                     device_->limits().maxStorageBufferRange, ": give fewer cells, or use the CPU.")};
    make_room_for_sides();
    tables_.emplace(tables_of(config_.boundaries));
    device_->memory().measure();
    if (auto made = make_memory(); !made)
        return made.failure();
    fields_ = {};
    piece_ = {};
    return device_->memory().expect_measured();
}

Result<void> Air::make_memory() {
    auto piece = piece_of(*tables_);
    if (!piece)
        return piece.failure();
    piece_ = *std::move(piece);
    auto fields = Fields::create(*device_, {.cells = config_.cells,
                                            .table_floats = static_cast<std::uint32_t>(
                                                SolveTables::max_floats(config_.cells, prepared_ == DiffusionMethod::implicit)),
                                            .commands = Passes::commands(config_.max_substeps),
                                            .sums = Passes::sums(*device_, config_.cells),
                                            .diffuses = prepared_ != DiffusionMethod::none || rough(),
                                            .rough = rough(),
                                            .rows = rows_table_ != nullptr,
                                            .gusts = settings_.gusts,
                                            .outer = settings_.outer != nullptr,
                                            .slabs = Passes::fits_in_slabs(*device_, config_.cells),
                                            .texel = settings_.texel,
                                            .textures = settings_.textures,
                                            .slots = static_cast<std::uint32_t>(settings_.reads.slots),
                                            .slot_bytes = slot_bytes(settings_.reads),
                                            .points = static_cast<std::uint32_t>(settings_.reads.points),
                                            .exported = settings_.exported});
    if (!fields)
        return fields.failure();
    fields_ = *std::move(fields);
    return {};
}

Result<void> Air::make() {
    if (auto measured = measure(); !measured)
        return measured.failure();
    if (auto made = make_memory(); !made)
        return made;
    if (rough()) {
        layer_.emplace(box(), *config_.roughness);
        layer_wanted_.reserve(fields_.layer.bytes() / sizeof(float));
        layer_written_.reserve(layer_wanted_.capacity());
    }
    if (settings_.outer != nullptr)
        outer_ = outer_air_of(box(), *settings_.outer);
    auto passes = passes_for(settings_.obstacles);
    if (!passes)
        return passes.failure();
    passes_ = *std::move(passes);
    passes_know_obstacles_ = settings_.obstacles;
    const std::vector<WindrowRow> rows = rows_table_ ? rows_in(*rows_table_) : std::vector<WindrowRow>();
    const auto bytes = std::as_bytes(std::span(rows));
    step_block_.resize(sizeof(WindrowStep) + bytes.size());
    std::ranges::copy(bytes, step_block_.begin() + sizeof(WindrowStep));
    return {};
}

Result<Passes> Air::passes_for(bool obstacles) {
    auto passes = Passes::create(*device_, fields_,
                                 {.cells = config_.cells,
                                  .projects = config_.stages.projection,
                                  .texel = settings_.texel,
                                  .textures = settings_.textures,
                                  .read_cells = settings_.reads.cells,
                                  .read_halves = settings_.reads.kind == ReadBack::halves,
                                  .obstacles = obstacles,
                                  .rough = rough(),
                                  .rows = rows_table_ != nullptr,
                                  .outer = outer_ != nullptr,
                                  .samples = obstacles || reading_maker_.law().acts()});
    if (passes)
        passes->set_tables(*tables_);
    return passes;
}

// --- The block of a step -----------------------------------------------------------------------------------------------------

// Diffusion method of a sub-step with the accumulated diffusion time (a ratio below the least that acts), if prepared for.
DiffusionMethod Air::diffusion_of(double duration) const {
    if (prepared_ == DiffusionMethod::none)
        return prepared_;
    const double h = box().finest(), accumulated = static_cast<double>(numerics::windrow_least_diffusion) * h * h /
                                                   static_cast<double>(config_.viscosity);
    const DiffusionMethod most = method_of(config_, box(), duration + accumulated);
    return most == DiffusionMethod::implicit ? prepared_ : DiffusionMethod::one_pass;
}

WindrowStep Air::block_of(const AmbientWind& ambient, const Window& window, const CellStep& step) const {
    const Box air = box();
    WindrowStep block{};
    const auto any = [&](detail::MotorReach::Law law) {
        return std::any_of(step.motors.begin(), step.motors.end(), [&](const auto& motor) { return motor.law == law; });
    };
    const auto bit = [](bool on, int value) { return on ? value : 0; };
    const bool classic = config_.scheme == Scheme::stable_fluids || !config_.stages.advection;
    const DiffusionMethod diffusion = diffusion_of(step.duration);
    block.cells = air.cells;
    block.motors = static_cast<int>(std::min<std::size_t>(step.motors.size(), k_max_motors));
    block.max_substeps = config_.max_substeps;
    block.forced_substeps = forced_substeps_;
    block.torus = torus_;
    block.flags =
        bit(fresh_, WINDROW_FRESH) | bit(classic, WINDROW_STABLE_FLUIDS) |
        bit(config_.interpolation == Interpolation::linear, WINDROW_LINEAR) |
        bit(config_.interpolation == Interpolation::cubic_32, WINDROW_CUBIC_32) | bit(config_.stages.advection, WINDROW_ADVECTS) |
        bit(config_.stages.projection, WINDROW_PROJECTS) | bit(step.relaxation_time > 0.0f, WINDROW_RELAXES) |
        bit(ambient.gusting(), WINDROW_GUSTS) | bit(config_.profile.has_value(), WINDROW_PROFILE) |
        bit(step.has_source_flow, WINDROW_HAS_SOURCE_FLOW) | bit(step.renews_sources, WINDROW_RENEWS_SOURCE_FLOW) |
        bit(diffusion != DiffusionMethod::none, WINDROW_DIFFUSES) | bit(any(detail::MotorReach::Law::force), WINDROW_PUSHES) |
        bit(any(detail::MotorReach::Law::drive), WINDROW_DRIVES) | bit(any(detail::MotorReach::Law::source), WINDROW_EXPANDS) |
        bit(diffusion == DiffusionMethod::one_pass, WINDROW_ONE_PASS) | bit(rough(), WINDROW_ROUGH) |
        bit(step.may_rest, WINDROW_MAY_REST) | bit(outer_turned_, WINDROW_OUTER_TURNED) |
        bit(holds_drag_ && step.drag.any(), WINDROW_DRAG) | obstacle_flags();
    block.shift = unplaced_shift_;
    block.duration = static_cast<float>(step.duration);
    block.cell_size = air.cell_size;
    block.relaxation_time = step.relaxation_time;
    block.max_cfl = config_.max_cfl;
    block.sleep_speed = config_.sleep_speed;
    block.canopy_drag = step.canopy.drag;
    block.canopy_ground = step.canopy.ground;
    block.canopy_top = step.canopy.top;
    block.ambient = ambient.mean();
    block.viscosity = config_.viscosity;
    for (int axis = 0; axis < 3; ++axis) {
        const LegalPlaces legal = legal_places(air, axis);
        block.low[axis] = legal.low;
        block.high[axis] = legal.high;
        block.period[axis] = legal.period;
        block.inverse_period[axis] = legal.inverse_period;
        const NormalGhost u_low = velocity_ghost(air, axis, 0), u_high = velocity_ghost(air, axis, 1);
        const NormalGhost p_low = potential_ghost(air, axis, 0), p_high = potential_ghost(air, axis, 1);
        block.low_source[axis] = u_low.source;
        block.high_source[axis] = u_high.source;
        block.velocity_low[axis] = u_low.scale;
        block.velocity_high[axis] = u_high.scale;
        block.potential_low[axis] = p_low.scale;
        block.potential_high[axis] = p_high.scale;
    }
    const AmbientBlock wind = ambient.block(window.origin());
    static_assert(sizeof(wind) == sizeof(block.wind));
    std::memcpy(&block.wind, &wind, sizeof(wind));
    block.gust_strength = wind.gust_strength;
    block.gust_speed = wind.gust_texels * glm::vec3(wind.mean.x, 0.0f, wind.mean.z); // the level part carries the gusts
    return block;
}

void Air::write(VkCommandBuffer commands, const Buffer& to, std::span<const std::byte> bytes, VkDeviceSize first) {
    wait(commands);
    ++transfers_;
    for (std::size_t at = 0; at < bytes.size(); at += k_max_update)
        device_->functions().vkCmdUpdateBuffer(commands, to.handle(), first + at,
                                               std::min<VkDeviceSize>(k_max_update, bytes.size() - at), bytes.data() + at);
}

// --- Recording ---------------------------------------------------------------------------------------------------------------

void Air::barrier(VkPipelineStageFlags from, VkPipelineStageFlags to) {
    waits_from_ |= from;
    waits_to_ |= to;
}

void Air::wait(VkCommandBuffer commands, std::span<const VkImageMemoryBarrier> images) {
    const VkPipelineStageFlags from = std::exchange(waits_from_, 0), to = std::exchange(waits_to_, 0);
    if (from == 0)
        return;
    ordered_ = ordered_ || ((from & k_compute) != 0 && (to & k_compute) != 0);
    const VkMemoryBarrier memory{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                                 .pNext = nullptr,
                                 .srcAccessMask = writes_of(from),
                                 .dstAccessMask = reads_of(to)};
    device_->functions().vkCmdPipelineBarrier(commands, from, to, 0, 1, &memory, 0, nullptr,
                                              static_cast<std::uint32_t>(images.size()), images.data());
    ++barriers_;
}

void Air::copy(VkCommandBuffer commands, const Buffer& from, const Buffer& to, VkDeviceSize at) {
    copy(commands, from, to, VkBufferCopy{.srcOffset = 0, .dstOffset = at, .size = std::min(from.bytes(), to.bytes() - at)});
}

void Air::copy(VkCommandBuffer commands, const Buffer& from, const Buffer& to, const VkBufferCopy& region) {
    wait(commands);
    ++transfers_;
    device_->functions().vkCmdCopyBuffer(commands, from.handle(), to.handle(), 1, &region);
}

void Air::clear(VkCommandBuffer commands, const Buffer& buffer, VkDeviceSize at, VkDeviceSize bytes) {
    wait(commands);
    ++transfers_;
    device_->functions().vkCmdFillBuffer(commands, buffer.handle(), at, bytes, 0);
}

void Air::dispatch(VkCommandBuffer commands, Pass pass, const Push& push, int frame, std::optional<std::uint32_t> command) {
    if (!step_put_)
        put_step(commands);
    wait(commands);
    ordered_ = false;
    passes_.use(blocks_);
    const Label label(*device_, commands, name_of(pass));
    const PassClock::Lap lap(clock_, commands, pass);
    if (command)
        passes_.record_indirect(commands, pass, push, *command);
    else
        passes_.record(commands, pass, push, frame);
    ++dispatches_;
}

void Air::place(VkCommandBuffer commands, const WindrowPlacePush& push) {
    counted_ = false;
    barrier(k_transfer | k_compute, k_compute);
    dispatch(commands, Pass::place, push);
    barrier(k_compute, k_compute | k_transfer);
}

void Air::apply(VkCommandBuffer commands, const CellChange& change) {
    using Kind = CellChange::Kind;
    window_ = change.window;
    if (change.kind == Kind::keep || change.kind == Kind::begin_frames || change.kind == Kind::end_frames) {
        keeps_ = change.kind != Kind::end_frames;
        return;
    }
    place_exposed(commands);
    follow_outer(change);
    if (keeps_ && (change.kind == Kind::fill || !change.to_air)) // the velocity and what is kept part here
        keep(commands);
    keeps_ = keeps_ && change.kind != Kind::fill_before;
    if (change.kind == Kind::shift && rows_table_ && change.by.y != 0)
        return lift(commands, change);
    if (change.kind == Kind::shift) {
        shift_ = change;
        unplaced_shift_ += glm::ivec3(change.by);
        torus_ = ((torus_ + glm::ivec3(change.by)) % config_.cells + config_.cells) % config_.cells;
        return;
    }
    write_step(commands, block_of(change.ambient, change.window), change.ambient);
    switch (change.kind) {
    case Kind::set:
        return upload(commands, change.cells);
    case Kind::add_change:
    case Kind::add_wind:
        return adjust(commands, change);
    case Kind::fill:
        first_sources_ = true;
        begin_anew(commands);
        return place_all(commands, WINDROW_PLACE_AIR | WINDROW_PLACE_SOURCE_FLOW, WINDROW_PLACE_AMBIENT);
    default:
        return place_all(commands, WINDROW_PLACE_BEFORE, WINDROW_PLACE_AMBIENT);
    }
}

void Air::keep(VkCommandBuffer commands) {
    if (std::exchange(keeps_, false))
        place_all(commands, WINDROW_PLACE_BEFORE, WINDROW_PLACE_NOW);
}

void Air::begin_anew(VkCommandBuffer commands) {
    barrier(k_compute | k_transfer, k_transfer);
    // And the time that is behind.
    clear(commands, fields_.control, offsetof(WindrowControl, plan) + offsetof(WindrowPlan, undiffused_time), 2 * sizeof(float));
    clear(commands, fields_.control, offsetof(WindrowControl, last_undiffused), 2 * sizeof(float));
    barrier(k_transfer, k_compute | k_transfer);
    fresh_ = inside_is_air_ = true;
}

// Cells that the last shift exposed.
WindrowPlacePush Air::exposed() const {
    return {.shift = glm::ivec3(shift_->by),
            .fields = WINDROW_PLACE_AIR | (fresh_ ? 0 : WINDROW_PLACE_PAST) |
                      (shift_->kept && !keeps_ ? WINDROW_PLACE_BEFORE : 0) |
                      (shift_->has_source_flow ? WINDROW_PLACE_SOURCE_FLOW : 0),
            .value = shift_->exposed_hold_ambient ? WINDROW_PLACE_AMBIENT : WINDROW_PLACE_ZERO};
}

void Air::place_exposed(VkCommandBuffer commands) {
    if (!shift_)
        return;
    write_step(commands, block_of(shift_->ambient, shift_->window), shift_->ambient);
    place(commands, exposed());
    shift_.reset();
}

void Air::adjust(VkCommandBuffer commands, const CellChange& change) {
    const bool of_mean = change.kind == CellChange::Kind::add_change;
    counted_ = false;
    barrier(k_transfer | k_compute, k_compute);
    dispatch(commands, Pass::adjust,
             WindrowAdjustPush{.change = change.change,
                               .factor = of_mean ? 1.0f : change.factor,
                               .of_mean = of_mean ? 1 : 0,
                               .to_air = change.to_air ? 1 : 0,
                               .to_before = change.kept && !keeps_ ? 1 : 0,
                               .unused = 0});
    barrier(k_compute, k_compute | k_transfer);
}

void Air::upload(VkCommandBuffer commands, std::span<const glm::vec4> cells) {
    begin_anew(commands);
    write(commands, fields_.arrived, std::as_bytes(cells));
    place_all(commands, WINDROW_PLACE_AIR, WINDROW_PLACE_GIVEN);
    keeps_ = true;
}

void Air::step(VkCommandBuffer commands, const CellStep& step, const Recorded& recorded) {
    const Label tick(*device_, commands, "windrow tick");
    step_duration_ = step.duration;
    window_ = *step.window;
    const int wanted = recorded.substeps > 0 ? std::min(recorded.substeps, config_.max_substeps) : config_.max_substeps;
    const int substeps = forced_substeps_ > 0 ? forced_substeps_ : config_.stages.advection ? wanted : 1;
    const bool limits = recorded.limits && forced_substeps_ == 0 && substeps == config_.max_substeps && config_.stages.advection;
    if (shift_ && !same_wind(shift_->ambient, *step.ambient)) // exposed cells hold the wind of then
        place_exposed(commands);
    begin_outer(commands, step);
    const bool bodies_move =
        std::any_of(step.obstacles.begin(), step.obstacles.end(), [](const auto& body) { return body.moves(); });
    const bool places = step.obstacles_changed || place_again_ || (bodies_move && substeps > 1);
    const auto early = [&](int part) { return bodies_move ? step.duration * (substeps - part - 1) / substeps : 0.0; };
    const bool others = places && (step.obstacles_moved || place_again_);
    if (others || (places && bodies_move))
        uncover(commands, -1);
    if (places)
        place_obstacles(commands, step.obstacles, early(0));
    inside_is_air_ = false;
    renew_layer(commands, step, places);
    renew_drag(commands, step);
    WindrowStep block = block_of(*step.ambient, *step.window, step);
    block.recorded_substeps = substeps;
    block.shift = glm::ivec3(0);
    if (bodies_move) // each sub-step has its own place of them
        block.forced_substeps = substeps;
    if (shift_) {
        const WindrowPlacePush push = exposed();
        block.exposes = push.fields;
        block.shift = push.shift;
        block.exposed_value = push.value;
        shift_.reset();
    }
    const bool renews_sources = step.renews_sources || (others && step.has_source_flow);
    block.flags |= (renews_sources ? WINDROW_RENEWS_SOURCE_FLOW : 0);
    const DiffusionMethod diffusion = diffusion_of(step.duration);
    const bool chosen = substeps > 1 && block.forced_substeps == 0; // by the device
    const bool rehearses = fresh_ && (block.flags & WINDROW_STABLE_FLUIDS) == 0;
    const bool plans = substeps > 1 || limits || rehearses || diffusion != DiffusionMethod::none; // with a pass of its own
    block.flags |= (limits ? WINDROW_LIMITS : 0) | (std::exchange(keeps_, false) ? WINDROW_KEEPS : 0) |
                   (std::exchange(stepped_, true) ? 0 : WINDROW_FIRST_TICK) | (plans ? 0 : WINDROW_PLANS);
    const bool classic = (block.flags & WINDROW_STABLE_FLUIDS) != 0;
    const bool counted =
        counted_ && step.motors.empty() && block.exposes == 0 && !places && !renews_sources && !limits && !classic;
    block.flags |= counted ? WINDROW_COUNTED : 0;
    order_passes();
    write_step(commands, block, *step.ambient, step.tile);
    Passes::Around around = around_obstacles(true);
    const Shapes shapes{diffusion, around};
    if (chosen && std::exchange(shapes_, shapes) != shapes) {
        barrier(k_compute | k_transfer, k_transfer);
        write(commands, fields_.shapes, std::as_bytes(passes_.shapes(passes_.substep(diffusion, around))));
        barrier(k_transfer, k_compute);
    }
    if (const auto motors = uncovered(step.motors); !motors.empty())
        blocks_.motors = put(commands, fields_.motors, std::as_bytes(motors));
    if (!counted) {
        dispatch(commands, Pass::sources);
        barrier(k_compute, k_compute);
    }
    if (around.rooms && places)
        work_on_rooms(commands, WINDROW_STILL_NEW_ROOMS);
    if (around.rooms && (block.flags & WINDROW_EXPANDS) != 0)
        work_on_rooms(commands, WINDROW_SEAL_SOURCES);
    if (renews_sources) {
        for (const Passes::Stage& stage : passes_.source_solve(around_sources())) {
            dispatch(commands, stage.pass, stage.push);
            barrier(k_compute, k_compute);
        }
        dispatch(commands, Pass::source_flow);
        barrier(k_compute, k_compute);
        first_sources_ = false;
    }
    if (plans) {
        dispatch(commands, Pass::plan);
        barrier(k_compute, chosen ? k_compute | k_indirect : k_compute);
    }
    if (limits) {
        dispatch(commands, Pass::limit);
        barrier(k_compute, k_compute);
    }
    if (rehearses)
        substep(commands, passes_.substep(diffusion, around_obstacles(false)), -1, std::nullopt);
    sealed_rooms_ = 0;
    for (int n = 0; n < substeps; ++n) {
        if (bodies_move && n > 0) {
            uncover(commands, n);
            place_obstacles(commands, step.obstacles, early(n));
            renew_layer(commands, step, true);
            around = around_obstacles(true); // rooms may have come or gone, and bodies met their first cell
            if (const int flags = (block.flags & ~SolidTables::k_flags) | obstacle_flags(); flags != block.flags) {
                block.flags = flags;
                write_step(commands, block, *step.ambient, step.tile);
            }
        }
        sealed_rooms_ = std::max(sealed_rooms_, solids_ ? solids_->solids().squeezed() : 0);
        const auto stages = passes_.substep(diffusion, rehearses && n == 0 ? around_obstacles(false) : around);
        const auto passes = static_cast<std::uint32_t>(stages.size());
        substep(commands, stages, n,
                chosen && n > 0 ? std::optional((static_cast<std::uint32_t>(n) - 1) * passes) : std::nullopt);
        fresh_ = (block.flags & WINDROW_STABLE_FLUIDS) != 0; // the next sub-step has a past
    }
    counted_ = !around.rooms; // whose air may be slowed
    end_outer();
}

void Air::substep(VkCommandBuffer commands, std::span<const Passes::Stage> stages, int number,
                  std::optional<std::uint32_t> command) {
    for (const Passes::Stage& stage : stages) {
        dispatch(commands, stage.pass, stage.push.in_substep(number), 0, command);
        if (command)
            ++*command;
        barrier(k_compute, k_compute);
    }
}

} // namespace windrow::vulkan
