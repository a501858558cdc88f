#include "fluid/vulkan/passes.h"

#include "fluid/vulkan/blocks.h"
#include "fluid/vulkan/host.h"
#include "fluid/vulkan/work_groups.h"
#include "gpu/pipeline.h"
#include "shader_words/adjust.h"
#include "shader_words/advect.h"
#include "shader_words/columns.h"
#include "shader_words/diffuse.h"
#include "shader_words/diffuse_back.h"
#include "shader_words/diffuse_columns.h"
#include "shader_words/diffuse_forward.h"
#include "shader_words/gradient.h"
#include "shader_words/level.h"
#include "shader_words/lift.h"
#include "shader_words/limit.h"
#include "shader_words/lines_back.h"
#include "shader_words/lines_forward.h"
#include "shader_words/loads.h"
#include "shader_words/modes_back.h"
#include "shader_words/modes_between.h"
#include "shader_words/modes_forward.h"
#include "shader_words/output_float.h"
#include "shader_words/output_float_axes.h"
#include "shader_words/output_float_both.h"
#include "shader_words/output_half.h"
#include "shader_words/output_half_axes.h"
#include "shader_words/output_half_both.h"
#include "shader_words/pad.h"
#include "shader_words/place.h"
#include "shader_words/plan.h"
#include "shader_words/read_floats.h"
#include "shader_words/read_halves.h"
#include "shader_words/read_points.h"
#include "shader_words/report.h"
#include "shader_words/rooms.h"
#include "shader_words/slabs.h"
#include "shader_words/source_flow.h"
#include "shader_words/sources.h"
#include "shader_words/stress.h"
#include "shader_words/surface.h"
#include "shader_words/terms.h"
#include "shader_words/uncover.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <string>
#include <utility>

namespace windrow::vulkan {
namespace {

constexpr std::size_t k_obstacles_constant = 7; // of pass.glsl, then those of rows, reading.glsl and outer.glsl
constexpr std::uint32_t k_load_groups = 64;     // that take bodies or closed faces in turns
constexpr std::uint32_t k_surface_group = 1024; // of the passes of one group over what is at obstacles, where the device has them
constexpr int k_of_sources = 1;                 // WindrowStagePush::part of the volume sources' flow

struct Plan {
    Pass pass;
    std::span<const std::uint32_t> code;
    std::vector<const Buffer*> buffers; ///< bindings 0, 1, 2 ...
    Groups local, groups;
    std::vector<std::uint32_t> constants; ///< behind the three of the local size
    std::uint32_t shared_bytes = 0;
    bool to_host = false; ///< the last buffer is one of Fields::slots
};

// Fields of cells alone; see Passes::bytes.
std::uint64_t bytes_of(const Plan& plan, const Fields& f, std::uint64_t image_bytes) {
    const std::initializer_list<const Buffer*> in_caches = {
        &f.step.buffer(), &f.motors.buffer(), &f.control, &f.shapes,     &f.commands,  &f.rules, &f.tables,
        &f.tile,          &f.solids,          &f.around,  &f.correction, &f.direction, &f.drag};
    const std::vector<Access> access = access_of(plan.code, plan.buffers.size());
    std::uint64_t bytes = image_bytes;
    for (std::size_t n = 0; n < plan.buffers.size(); ++n)
        if (std::find(in_caches.begin(), in_caches.end(), plan.buffers[n]) == in_caches.end() &&
            !(plan.pass == Pass::show && plan.buffers[n] == &f.slots[0])) { // which takes a report
            // One slot of the velocity; pad reads both.
            const std::uint64_t slots = plan.buffers[n] == &f.velocity && plan.pass != Pass::pad ? 2 : 1;
            bytes += plan.buffers[n]->bytes() / slots * (std::uint64_t{access[n].reads} + std::uint64_t{access[n].writes});
        }
    return bytes;
}

// Of the textures of a frame.
std::uint64_t texel_bytes(const Passes::Settings& settings) {
    const glm::u64vec3 cells(settings.cells);
    const std::uint64_t components = (has_vectors(settings.textures) ? 4 : 0) + (has_axes(settings.textures) ? 3 : 0);
    return components * (settings.texel == Texel::half ? 2 : 4) * cells.x * cells.y * cells.z;
}

std::span<const std::uint32_t> show_code(const Passes::Settings& settings) {
    namespace words = shader_words;
    const bool half = settings.texel == Texel::half;
    const auto of = [half](std::span<const std::uint32_t> with_half, std::span<const std::uint32_t> with_float) {
        return half ? with_half : with_float;
    };
    switch (settings.textures) {
    case TextureSet::axes:
        return of(words::output_half_axes, words::output_float_axes);
    case TextureSet::both:
        return of(words::output_half_both, words::output_float_both);
    default:
        return of(words::output_half, words::output_float);
    }
}

} // namespace

const char* name_of(Pass pass) {
    constexpr std::array<const char*, k_passes> names = {"place",
                                                         "sources",
                                                         "source_flow",
                                                         "adjust",
                                                         "plan",
                                                         "limit",
                                                         "diffuse",
                                                         "diffuse_forward",
                                                         "diffuse_columns",
                                                         "diffuse_back",
                                                         "stress",
                                                         "pad",
                                                         "advect",
                                                         "advect_one_sided",
                                                         "modes_forward",
                                                         "modes_between",
                                                         "columns",
                                                         "modes_back",
                                                         "lines_forward",
                                                         "slabs",
                                                         "lines_back",
                                                         "residual",
                                                         "surface",
                                                         "level",
                                                         "gradient",
                                                         "rooms",
                                                         "uncover",
                                                         "terms",
                                                         "loads",
                                                         "lift",
                                                         "show",
                                                         "report",
                                                         "read_cells",
                                                         "read_points"};
    return names[static_cast<std::size_t>(pass)];
}

std::uint32_t Passes::sums(const Device&, glm::ivec3 cells) {
    const Groups groups = groups_over(cells, cell_group(cells));
    return groups[0] * groups[1] * groups[2];
}

Result<Passes> Passes::create(Device& device, const Fields& fields, const Settings& settings) {
    const glm::ivec3 cells = settings.cells;
    const Groups cell = cell_group(cells), over_cells = groups_over(cells, cell);
    const Groups over_padded = groups_over(cells + WINDROW_HALO, cell);
    const std::uint32_t solve = solve_group(device);
    const PlaneTiles tiles = tiles_of(device, solve, cells);
    const auto nx = static_cast<std::uint32_t>(cells.x), ny = static_cast<std::uint32_t>(cells.y),
               nz = static_cast<std::uint32_t>(cells.z);
    const Groups line{solve, 1, 1};
    const Groups over_tiles{tiles.whole ? 1 : blocks(nz, tiles.z), ny, 1}, over_between{blocks(nx, tiles.between_x), ny, 1};
    const auto yes = [](bool value) { return value ? 1u : 0u; };
    const auto of = [](const auto&... buffer) { return std::vector<const Buffer*>{&buffer...}; };
    const Fields& f = fields;
    namespace words = shader_words;

    const Buffer &step = f.step.buffer(), &motors = f.motors.buffer();

    const std::vector<std::uint32_t> both_axes = {tiles.x, tiles.z, yes(true), yes(tiles.whole)};
    const std::vector<std::uint32_t> second_axis = {tiles.between_x, nz, yes(false), yes(true)};
    const Groups lines{64, 1, 1}, over_columns{blocks(nx * nz, lines[0]), 1, 1};
    std::vector<Plan> plans;
    const auto over = [&](const Groups& local, const Groups& groups, const std::vector<std::uint32_t>& constants = {},
                          std::uint32_t shared = 0) {
        return [&plans, local, groups, constants, shared](Pass pass, std::span<const std::uint32_t> code,
                                                          std::vector<const Buffer*> buffers) {
            plans.push_back({pass, code, std::move(buffers), local, groups, constants, shared});
        };
    };
    const auto a_cell = over(cell, over_cells), a_padded_cell = over(cell, over_padded), a_column = over(lines, over_columns);
    const auto a_plane = over(line, over_tiles, both_axes, 4 * tiles.x * tiles.z),
               a_half_plane = over(line, over_between, second_axis, 4 * tiles.between_x * nz);
    a_cell(Pass::place, words::place, of(step, f.control, f.arrived, f.velocity, f.history, f.source_flow, f.before, f.tile));
    a_cell(Pass::sources, words::sources,
           of(step, f.control, f.velocity, f.before, f.history, f.source_flow, f.force, f.drives, f.expansion, motors, f.tile,
              f.solids, f.drag));
    a_cell(Pass::source_flow, words::source_flow,
           of(step, f.control, f.potential, f.source_flow, f.velocity, f.history, f.tile, motors, f.correction, f.direction,
              f.solids, f.around));
    a_cell(Pass::adjust, words::adjust, of(step, f.control, f.velocity, f.before, f.tile, f.solids));
    over(lines, {1, 1, 1})(Pass::plan, words::plan, of(step, f.control, f.shapes, f.commands));
    a_cell(Pass::limit, words::limit, of(step, f.control, f.velocity, f.source_flow, f.drives));
    a_cell(Pass::diffuse, words::diffuse,
           of(step, f.control, f.velocity, f.force, f.source_flow, f.rules, f.diffused, f.tile, f.solids));
    a_plane(Pass::diffuse_forward, words::diffuse_forward, of(step, f.control, f.tables, f.diffused, f.rules, f.hat));
    a_column(Pass::diffuse_columns, words::diffuse_columns, of(step, f.control, f.tables, f.hat, f.potential, f.arrived));
    a_plane(Pass::diffuse_back, words::diffuse_back, of(step, f.control, f.tables, f.hat, f.diffused));
    if (settings.rough)
        a_column(Pass::stress, words::stress,
                 of(step, f.control, f.velocity, f.force, f.source_flow, f.layer, f.diffused, f.tile, f.solids));
    a_padded_cell(Pass::pad, words::pad,
                  of(step, f.control, f.velocity, f.history, f.force, f.drives, f.source_flow, f.diffused, f.rules, f.padded,
                     f.tile, f.solids, f.drag));
    for (const bool one_sided : settings.obstacles ? std::vector{false, true} : std::vector{false})
        over(cell, over_cells, {yes(one_sided)})(one_sided ? Pass::advect_one_sided : Pass::advect, words::advect,
                                                 of(step, f.control, f.velocity, f.padded, f.force, f.drives, f.history,
                                                    f.source_flow, f.arrived, f.tile, f.solids, f.drag));
    a_plane(Pass::modes_forward, words::modes_forward,
            of(step, f.control, f.tables, f.arrived, f.expansion, f.hat, motors, f.solids, f.around, f.tile));
    a_half_plane(Pass::modes_between, words::modes_between, of(step, f.control, f.tables, f.hat));
    a_column(Pass::columns, words::columns, of(step, f.control, f.tables, f.hat));
    a_plane(Pass::modes_back, words::modes_back,
            of(step, f.control, f.tables, f.hat, f.potential, f.correction, f.direction, f.around));
    if (fits_in_slabs(device, cells)) {
        const SlabGroups slab = slab_groups(cells);
        const auto over_lines = [&](std::uint32_t count, std::uint32_t each) {
            return over({slab.of_lines, 1, 1}, {blocks(count, each), ny, 1},
                        {nx, slab.lines, slab.lines_each, slab.lines * nx / 4}, 4 * slab.lines * nx);
        };
        over_lines(nz, slab.lines)(
            Pass::lines_forward, words::lines_forward,
            of(step, f.control, f.tables, f.arrived, f.expansion, f.hat_x, motors, f.solids, f.around, f.tile));
        over({slab.of_slab, 1, 1}, {nx, 2, 1}, {nz / 2, ny, slab.slab_each, ny * nz / 8},
             2 * ny * nz)(Pass::slabs, words::slabs, of(step, f.control, f.tables, f.hat_x, f.hat));
        over_lines(nz / 2,
                   slab.lines / 2)(Pass::lines_back, words::lines_back,
                                   of(step, f.control, f.tables, f.hat, f.potential, f.correction, f.direction, f.around));
    }
    if (settings.obstacles) {
        const std::uint32_t most = std::bit_floor(std::min(
            {k_surface_group, device.limits().maxComputeWorkGroupInvocations, device.limits().maxComputeWorkGroupSize[0]}));
        const auto at_surface = of(step, f.control, f.solids, f.arrived, f.expansion, f.potential, f.correction, f.direction,
                                   f.around, motors, f.tile);
        over(line, {WINDROW_RESIDUAL_GROUPS, 1, 1}, {solve})(Pass::residual, words::surface, at_surface);
        over({most, 1, 1}, {1, 1, 1}, {most})(Pass::surface, words::surface, at_surface);
        over(line, {1, 1, 1}, {solve})(Pass::level, words::level,
                                       of(step, f.control, f.solids, f.potential, f.correction, f.direction, f.around));
        over(line, {1, 1, 1},
             {solve})(Pass::rooms, words::rooms,
                      of(step, f.control, f.tile, f.solids, f.velocity, f.history, f.force, f.drives, f.expansion));
        a_cell(Pass::uncover, words::uncover, of(step, f.control, f.solids, f.velocity, f.history));
        over(lines, {k_load_groups, 1, 1})(Pass::terms, words::terms, of(step, f.control, f.solids, f.around));
        over(lines, {k_load_groups, 1, 1}, {lines[0]})(
            Pass::loads, words::loads, of(step, f.control, f.solids, f.potential, f.correction, f.direction, f.around));
    }
    if (settings.rows)
        a_cell(Pass::lift, words::lift, of(step, f.control, f.velocity, f.history, f.source_flow, f.before, f.arrived, f.tile));
    a_cell(Pass::gradient, words::gradient,
           of(step, f.control, f.potential, f.arrived, f.source_flow, f.velocity, f.history, f.tile, f.correction, f.direction,
              f.solids, f.around, f.before));
    const auto to_host = [&] { plans.back().to_host = true; };
    over(cell, over_cells, {cell[0] * cell[1] * cell[2]})(
        Pass::show, show_code(settings),
        of(step, f.control, f.velocity, f.before, f.expansion, f.sums, f.tile, f.solids, f.reading, f.around, f.slots[0]));
    to_host();
    over(line, {1, 1, 1}, {solve})(Pass::report, words::report, of(step, f.control, f.sums, f.around, f.solids, f.slots[0]));
    to_host();
    if (settings.read_cells.x > 0) {
        const Groups part = cell_group(settings.read_cells);
        const auto read = settings.read_halves ? std::span<const std::uint32_t>(words::read_halves) : words::read_floats;
        over(part, groups_over(settings.read_cells, part))(Pass::read_cells, read,
                                                           of(step, f.control, f.velocity, f.before, f.slots[0]));
        to_host();
    }
    if (f.points.bytes() > 0) {
        const auto points = static_cast<std::uint32_t>(f.points.bytes() / sizeof(WindrowPoint));
        over(lines, {blocks(points, lines[0]), 1, 1})(Pass::read_points, words::read_points,
                                                      of(step, f.control, f.velocity, f.before, f.points, f.reading, f.slots[0]));
        to_host();
    }

    Passes passes;
    passes.functions_ = &device.functions();
    passes.commands_ = fields.commands.handle();
    for (const Plan& plan : plans) {
        const auto n = static_cast<std::size_t>(plan.pass);
        if (auto fits = device.check(
                {.groups = plan.groups, .local_size = plan.local, .shared_bytes = plan.shared_bytes, .name = name_of(plan.pass)});
            !fits)
            return fits.failure();
        assert(plan.buffers.size() <= requirements().storage_buffers);
        std::vector<VkDescriptorType> kinds;
        for (const Buffer* buffer : plan.buffers)
            kinds.push_back(fields.blocks_of(buffer) != nullptr ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER_DYNAMIC
                                                                : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER);
        const bool shows = plan.pass == Pass::show;
        if (shows)
            fields.each_image(0, [&](const Image3D&) { kinds.push_back(VK_DESCRIPTOR_TYPE_STORAGE_IMAGE); });
        std::vector<std::uint32_t> constants(plan.local.begin(), plan.local.end());
        constants.insert(constants.end(), plan.constants.begin(), plan.constants.end());
        constants.resize(k_obstacles_constant, 0);
        constants.push_back(yes(settings.obstacles));
        constants.push_back(yes(settings.rows));
        constants.push_back(yes(settings.samples));
        constants.push_back(yes(settings.outer));
        auto pipeline = device.pipeline({.code = plan.code,
                                         .bindings = kinds,
                                         .constants = constants,
                                         .push_bytes = sizeof(Push),
                                         .name = name_of(plan.pass)});
        if (!pipeline)
            return pipeline.failure();
        passes.pipelines_[n] = *std::move(pipeline);
        passes.groups_[n] = plan.groups;
        passes.bytes_[n] = bytes_of(plan, fields, shows ? texel_bytes(settings) : 0);
        passes.binds_motors_[n] = std::ranges::count(plan.buffers, &motors) > 0;
        passes.bound_.push_back({plan.pass, plan.buffers, plan.to_host});
    }
    auto sets = passes.sets_of(device, fields);
    if (!sets)
        return sets.failure();
    passes.sets_ = *std::move(sets);

    passes.settings_ = settings;
    passes.whole_planes_ = tiles.whole;
    return passes;
}

Result<Sets> Passes::sets_of(Device& device, const Fields& fields) {
    std::vector<Sets::Content> contents;
    for (const Bound& bound : bound_) {
        const auto n = static_cast<std::size_t>(bound.pass);
        const bool shows = bound.pass == Pass::show;
        first_set_[n] = contents.size();
        const std::size_t slots = bound.to_host ? fields.slots.size() : 1;
        for (std::size_t one = 0; one < slots * (shows ? 2 : 1); ++one) {
            Sets::Content content{.layout = pipelines_[n].get(), .bindings = {}};
            for (const Buffer* buffer : bound.buffers) {
                content.bindings.push_back({.type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, .buffer = buffer->handle()});
                if (const HostBlocks* const blocks = fields.blocks_of(buffer)) {
                    content.bindings.back().type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER_DYNAMIC;
                    content.bindings.back().bytes = blocks->block();
                }
            }
            if (bound.to_host)
                content.bindings.back().buffer = fields.slots[one % slots].handle();
            if (shows)
                fields.each_image(static_cast<int>(one / slots), [&](const Image3D& image) {
                    content.bindings.push_back({.type = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, .view = image.view()});
                });
            contents.push_back(std::move(content));
        }
    }
    return Sets::create(device, contents);
}

Result<Sets> Passes::rebind(Device& device, const Fields& fields) {
    auto sets = sets_of(device, fields);
    if (!sets)
        return sets;
    return std::exchange(sets_, *std::move(sets));
}

void Passes::set_tables(const SolveTables& tables) {
    pressure_ = tables.pressure;
    pressure_columns_ =
        WindrowColumnsPush{.substep = 0, .pivots = tables.pivots, .vectors = tables.vectors, .singular = tables.singular};
    in_slabs_ = tables.slabs;
    pressure_slabs_ = WindrowSlabsPush{
        .substep = 0, .forward = tables.pressure.z_forward, .back = tables.pressure.z_back, .pivots = tables.pivots};
    for (std::size_t n = 0; n < 3; ++n) {
        diffusion_[n] = tables.diffusion[n];
        diffusion_columns_[n] = WindrowDiffusePush{.substep = 0, .eigenvalues = tables.diffusion_columns[n]};
    }
    source_solve_.clear();
    add_pressure(source_solve_, k_of_sources, {});
    for (const DiffusionMethod most : {DiffusionMethod::none, DiffusionMethod::one_pass, DiffusionMethod::implicit}) {
        std::vector<Stage>& stages = substeps_[static_cast<std::size_t>(most)];
        stages.clear();
        add_substep(stages, most, {});
    }
    around_.reserve(k_max_stages);
    shapes_.reserve(1 + 3 * k_max_stages);
}

void Passes::add_solve(std::vector<Stage>& stages, const Solve& solve, const SolveTables::Vectors& at) const {
    const auto plane = [&](Pass pass, bool forward) {
        stages.push_back({pass, WindrowStagePush{.substep = 0,
                                                 .x_vectors = forward ? at.x_forward : at.x_back,
                                                 .z_vectors = forward ? at.z_forward : at.z_back,
                                                 .part = solve.part,
                                                 .x_even = at.x_even,
                                                 .z_even = at.z_even,
                                                 .forward = forward ? 1 : 0,
                                                 .solve = solve.number}});
    };
    if (in_slabs_ && solve.forward == Pass::modes_forward) {
        plane(Pass::lines_forward, true);
        stages.push_back({Pass::slabs, pressure_slabs_});
        return plane(Pass::lines_back, false);
    }
    plane(solve.forward, true);
    if (!whole_planes_)
        plane(Pass::modes_between, true);
    stages.push_back({solve.columns, solve.columns_push});
    if (!whole_planes_)
        plane(Pass::modes_between, false);
    plane(solve.back, false);
}

void Passes::add_pressure(std::vector<Stage>& stages, int part, const Around& around) const {
    for (int n = 0; n < std::max(around.solves, 1); ++n) {
        add_solve(stages, {Pass::modes_forward, Pass::columns, Pass::modes_back, pressure_columns_, part, n}, pressure_);
        if (around.solves > 0)
            stages.push_back({n == 0 ? Pass::residual : Pass::surface,
                              WindrowSurfacePush{.substep = 0, .part = part, .solve = n, .unused = 0}});
    }
    if (around.sealed)
        stages.push_back({Pass::level, WindrowLoadsPush{.substep = 0, .of_sources = part}});
}

void Passes::add_substep(std::vector<Stage>& stages, DiffusionMethod most, const Around& around) const {
    if (most != DiffusionMethod::none)
        stages.push_back({Pass::diffuse, {}});
    for (int n = 0; most == DiffusionMethod::implicit && n < 3; ++n)
        add_solve(stages, {Pass::diffuse_forward, Pass::diffuse_columns, Pass::diffuse_back, diffusion_columns_[n], n},
                  diffusion_[n]);
    if (settings_.rough)
        stages.push_back({Pass::stress, {}});
    stages.push_back({Pass::pad, {}});
    stages.push_back({around.one_sided ? Pass::advect_one_sided : Pass::advect, {}});
    if (settings_.projects)
        add_pressure(stages, 0, around);
    if (settings_.projects && around.loads)
        stages.push_back({Pass::loads, WindrowLoadsPush{.substep = 0, .of_sources = 0}});
    stages.push_back({Pass::gradient, {}});
    if (around.rooms)
        stages.push_back({Pass::rooms, WindrowRoomsPush{.substep = 0, .work = WINDROW_BOUND_ROOMS}});
}

std::span<const Passes::Stage> Passes::substep(DiffusionMethod most, const Around& around) {
    if (around.solves == 0)
        return std::as_const(*this).substep(most);
    around_.clear();
    add_substep(around_, most, around);
    return around_;
}

std::span<const Passes::Stage> Passes::source_solve(const Around& around) {
    if (around.solves == 0)
        return std::as_const(*this).source_solve();
    around_.clear();
    add_pressure(around_, k_of_sources, around);
    if (around.loads)
        around_.push_back(
            {Pass::loads,
             WindrowLoadsPush{.substep = 0, .of_sources = around.first_sources ? WINDROW_FIRST_SOURCES : WINDROW_OTHER_SOURCES}});
    return around_;
}

std::span<const std::uint32_t> Passes::shapes(std::span<const Stage> substep) {
    shapes_.assign(1, static_cast<std::uint32_t>(substep.size())); // set_tables made room
    for (const Stage& stage : substep) {
        const Groups each = groups(stage.pass);
        shapes_.insert(shapes_.end(), each.begin(), each.end());
    }
    return shapes_;
}

void Passes::bind(VkCommandBuffer commands, Pass pass, const Push& push, int set_number) const {
    const auto n = static_cast<std::size_t>(pass);
    const Pipeline& pipeline = *pipelines_[n];
    const std::array<std::uint32_t, 2> offsets{blocks_.step, blocks_.motors};
    pipeline.bind(*functions_, commands, sets_.at(first_set_[n] + static_cast<std::size_t>(set_number)),
                  std::span(offsets).first(binds_motors_[n] ? 2 : 1));
    functions_->vkCmdPushConstants(commands, pipeline.layout(), VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(Push), &push);
}

void Passes::record(VkCommandBuffer commands, Pass pass, const Push& push, int set) const {
    bind(commands, pass, push, set);
    const Groups count = groups(pass);
    functions_->vkCmdDispatch(commands, count[0], count[1], count[2]);
}

void Passes::record_indirect(VkCommandBuffer commands, Pass pass, const Push& push, std::uint32_t n) const {
    bind(commands, pass, push, 0);
    functions_->vkCmdDispatchIndirect(commands, commands_, VkDeviceSize{n} * sizeof(VkDispatchIndirectCommand));
}

} // namespace windrow::vulkan
