#include "fluid/vulkan/passes.h"

#include "fluid/vulkan/blocks.h"
#include "shader_words/adjust.h"
#include "shader_words/advect.h"
#include "shader_words/columns.h"
#include "shader_words/diffuse.h"
#include "shader_words/diffuse_back.h"
#include "shader_words/diffuse_columns.h"
#include "shader_words/diffuse_forward.h"
#include "shader_words/gradient.h"
#include "shader_words/limit.h"
#include "shader_words/modes_back.h"
#include "shader_words/modes_between.h"
#include "shader_words/modes_forward.h"
#include "shader_words/output_float.h"
#include "shader_words/output_half.h"
#include "shader_words/pad.h"
#include "shader_words/place.h"
#include "shader_words/plan.h"
#include "shader_words/source_flow.h"
#include "shader_words/sources.h"

#include <algorithm>
#include <bit>
#include <string>

namespace windrow::vulkan {
namespace {

using Groups = Passes::Groups;
constexpr std::uint32_t k_cell_group = 128;  // invocations; every device has as many
constexpr std::uint32_t k_solve_group = 256; // of a plane's transform, where the device has them
constexpr std::uint32_t k_tile_lines = 16;   // of a tile that is not a whole plane

std::uint32_t blocks(std::uint32_t count, std::uint32_t size) {
    return (count + size - 1) / size;
}

// Cells of a group along each axis: as long along x as memory likes, but not longer than the box.
Groups cell_group(glm::ivec3 cells) {
    const auto x = std::min(32u, std::bit_ceil(static_cast<std::uint32_t>(cells.x)));
    const auto y = std::min(k_cell_group / x, std::bit_ceil(static_cast<std::uint32_t>(cells.y)));
    // 64: as long as a group may be along z everywhere.
    return {x, y, std::min(64u, k_cell_group / x / y)};
}

Groups groups_over(glm::ivec3 cells, const Groups& size) {
    return {blocks(static_cast<std::uint32_t>(cells.x), size[0]), blocks(static_cast<std::uint32_t>(cells.y), size[1]),
            blocks(static_cast<std::uint32_t>(cells.z), size[2])};
}

// How planes are cut for the transforms of x and z.
struct Tiles {
    bool whole = true;
    std::uint32_t x = 1, z = 1;  // of a whole plane; else of the pass along x: all of x, some of z
    std::uint32_t between_x = 1; // of the pass along z: some of x, all of z
};

Tiles tiles_of(const Device& device, glm::ivec3 cells) {
    const auto nx = static_cast<std::uint32_t>(cells.x), nz = static_cast<std::uint32_t>(cells.z);
    const std::uint32_t most = device.limits().maxComputeSharedMemorySize / 4;
    Tiles tiles;
    tiles.whole = nx * nz <= most;
    tiles.x = nx;
    tiles.z = tiles.whole ? nz : std::clamp(most / nx, 1u, std::min(k_tile_lines, nz));
    tiles.between_x = std::clamp(most / nz, 1u, std::min(k_tile_lines, nx));
    return tiles;
}

struct Plan {
    Pass pass;
    const char* name;
    std::span<const std::uint32_t> code;
    std::vector<VkBuffer> buffers; ///< bindings 0, 1, 2 ...
    Groups local, groups;
    std::vector<std::uint32_t> constants; ///< behind the three of the local size
};

} // namespace

std::uint32_t Passes::sums(const Device&, glm::ivec3 cells) {
    const Groups groups = groups_over(cells, cell_group(cells));
    return groups[0] * groups[1] * groups[2];
}

Result<Passes> Passes::create(Device& device, const Fields& fields, const Settings& settings) {
    const glm::ivec3 cells = settings.cells;
    const Groups cell = cell_group(cells), over_cells = groups_over(cells, cell);
    const Groups over_padded = groups_over(cells + WINDROW_HALO, cell);
    const Tiles tiles = tiles_of(device, cells);
    const std::uint32_t solve =
        std::min({k_solve_group, device.limits().maxComputeWorkGroupInvocations, device.limits().maxComputeWorkGroupSize[0]});
    const auto nx = static_cast<std::uint32_t>(cells.x), ny = static_cast<std::uint32_t>(cells.y),
               nz = static_cast<std::uint32_t>(cells.z);
    const Groups line{solve, 1, 1};
    const Groups over_tiles{tiles.whole ? 1 : blocks(nz, tiles.z), ny, 1}, over_between{blocks(nx, tiles.between_x), ny, 1};
    const auto yes = [](bool value) { return value ? 1u : 0u; };
    const auto of = [](const auto&... buffer) { return std::vector<VkBuffer>{buffer.handle()...}; };
    const Fields& f = fields;
    namespace words = shader_words;

    const std::vector<std::uint32_t> both_axes = {tiles.x, tiles.z, yes(true), yes(tiles.whole)};
    const std::vector<std::uint32_t> second_axis = {tiles.between_x, nz, yes(false), yes(true)};
    const Groups lines{64, 1, 1}, over_columns{blocks(nx * nz, lines[0]), 1, 1};
    const auto show = settings.half ? std::span<const std::uint32_t>(words::output_half) : words::output_float;
    std::vector<Plan> plans;
    const auto over = [&](const Groups& local, const Groups& groups, const std::vector<std::uint32_t>& constants = {}) {
        return [&plans, local, groups, constants](Pass pass, const char* name, std::span<const std::uint32_t> code,
                                                  std::vector<VkBuffer> buffers) {
            plans.push_back({pass, name, code, std::move(buffers), local, groups, constants});
        };
    };
    const auto a_cell = over(cell, over_cells), a_padded_cell = over(cell, over_padded), a_column = over(lines, over_columns);
    const auto a_plane = over(line, over_tiles, both_axes), a_half_plane = over(line, over_between, second_axis);
    a_cell(Pass::place, "place", words::place, of(f.step, f.control, f.arrived, f.padded, f.tile));
    a_cell(Pass::sources, "sources", words::sources,
           of(f.step, f.control, f.velocity, f.velocity_old, f.history, f.force, f.expansion, f.motors, f.tile));
    a_cell(Pass::source_flow, "source_flow", words::source_flow,
           of(f.step, f.control, f.potential, f.source_flow, f.velocity, f.velocity_old));
    a_cell(Pass::adjust, "adjust", words::adjust, of(f.step, f.control, f.velocity, f.velocity_old, f.before, f.tile));
    over(lines, {1, 1, 1})(Pass::plan, "plan", words::plan, of(f.step, f.control, f.shapes, f.commands));
    a_cell(Pass::limit, "limit", words::limit, of(f.step, f.control, f.velocity, f.source_flow));
    a_cell(Pass::diffuse, "diffuse", words::diffuse,
           of(f.step, f.control, f.velocity, f.force, f.source_flow, f.rules, f.diffused, f.tile));
    a_plane(Pass::diffuse_forward, "diffuse_forward", words::diffuse_forward,
            of(f.step, f.control, f.tables, f.diffused, f.rules, f.hat));
    a_column(Pass::diffuse_columns, "diffuse_columns", words::diffuse_columns,
             of(f.step, f.control, f.tables, f.hat, f.potential, f.arrived));
    a_plane(Pass::diffuse_back, "diffuse_back", words::diffuse_back, of(f.step, f.control, f.tables, f.hat, f.diffused));
    a_padded_cell(Pass::pad, "pad", words::pad,
                  of(f.step, f.control, f.velocity, f.velocity_old, f.history, f.force, f.source_flow, f.diffused, f.rules,
                     f.padded, f.tile));
    a_cell(Pass::advect, "advect", words::advect, of(f.step, f.control, f.velocity, f.padded, f.force, f.arrived));
    a_plane(Pass::modes_forward, "modes_forward", words::modes_forward,
            of(f.step, f.control, f.tables, f.arrived, f.expansion, f.hat));
    a_half_plane(Pass::modes_between, "modes_between", words::modes_between, of(f.step, f.control, f.tables, f.hat));
    a_column(Pass::columns, "columns", words::columns, of(f.step, f.control, f.tables, f.hat));
    a_plane(Pass::modes_back, "modes_back", words::modes_back, of(f.step, f.control, f.tables, f.hat, f.potential));
    a_cell(Pass::gradient, "gradient", words::gradient,
           of(f.step, f.control, f.potential, f.arrived, f.force, f.source_flow, f.velocity, f.velocity_old, f.history, f.tile));
    over(cell, over_cells, {cell[0] * cell[1] * cell[2]})(
        Pass::show, "show", show, of(f.step, f.control, f.velocity, f.before, f.expansion, f.shown, f.sums, f.tile));

    Passes passes;
    passes.functions_ = &device.functions();
    passes.commands_ = fields.commands.handle();
    std::vector<Sets::Content> contents;
    for (const Plan& plan : plans) {
        const auto n = static_cast<std::size_t>(plan.pass);
        if (auto fits = device.check({.groups = plan.groups, .local_size = plan.local, .name = plan.name}); !fits)
            return Error{fits.error()};
        std::vector<VkDescriptorType> kinds(plan.buffers.size(), VK_DESCRIPTOR_TYPE_STORAGE_BUFFER);
        const int images = plan.pass == Pass::show ? 3 : 0;
        kinds.insert(kinds.end(), images, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE);
        std::vector<std::uint32_t> constants(plan.local.begin(), plan.local.end());
        constants.insert(constants.end(), plan.constants.begin(), plan.constants.end());
        auto pipeline = Pipeline::create(
            device,
            {.code = plan.code, .bindings = kinds, .constants = constants, .push_bytes = sizeof(Push), .name = plan.name});
        if (!pipeline)
            return Error{pipeline.error()};
        passes.pipelines_[n] = *std::move(pipeline);
        passes.groups_[n] = plan.groups;
        passes.first_set_[n] = contents.size();
        for (int frame = 0; frame < (images > 0 ? 2 : 1); ++frame) {
            Sets::Content content{.pipeline = &passes.pipelines_[n], .bindings = {}};
            for (const VkBuffer buffer : plan.buffers)
                content.bindings.push_back({.type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, .buffer = buffer});
            for (int axis = 0; axis < images; ++axis)
                content.bindings.push_back({.type = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, .view = fields.axes[frame][axis].view()});
            contents.push_back(std::move(content));
        }
    }
    auto sets = Sets::create(device, contents);
    if (!sets)
        return Error{sets.error()};
    passes.sets_ = *std::move(sets);

    passes.settings_ = settings;
    passes.whole_planes_ = tiles.whole;
    return passes;
}

void Passes::set_tables(const SolveTables& tables) {
    // A direct solve: forward, columns, back, with the second axis between where it has passes of its own.
    const auto solve = [&](std::vector<Stage>& stages, Stage forward, const Stage& columns, Stage back,
                           const SolveTables::Vectors& at) {
        forward.push = {0, at.x_forward, at.z_forward, forward.push.w};
        back.push = {0, at.x_back, at.z_back, back.push.w};
        stages.push_back(forward);
        if (!whole_planes_)
            stages.push_back({Pass::modes_between, {0, 0, at.z_forward, 0}});
        stages.push_back(columns);
        if (!whole_planes_)
            stages.push_back({Pass::modes_between, {0, 0, at.z_back, 0}});
        stages.push_back(back);
    };
    const auto solve_pressure = [&](std::vector<Stage>& stages, std::int32_t of_air) {
        solve(stages, {Pass::modes_forward, {0, 0, 0, of_air}},
              {Pass::columns, {0, tables.pivots, tables.vectors, tables.singular}}, {Pass::modes_back, {}}, tables.pressure);
    };
    source_solve_.clear();
    solve_pressure(source_solve_, 1);
    for (const DiffusionMethod most : {DiffusionMethod::none, DiffusionMethod::one_pass, DiffusionMethod::implicit}) {
        std::vector<Stage>& stages = substeps_[static_cast<std::size_t>(most)];
        stages.clear();
        if (most != DiffusionMethod::none)
            stages.push_back({Pass::diffuse, {}});
        for (std::int32_t n = 0; most == DiffusionMethod::implicit && n < 3; ++n)
            solve(stages, {Pass::diffuse_forward, {0, 0, 0, n}}, {Pass::diffuse_columns, {0, tables.diffusion_columns[n], 0, 0}},
                  {Pass::diffuse_back, {0, 0, 0, n}}, tables.diffusion[n]);
        stages.push_back({Pass::pad, {}});
        stages.push_back({Pass::advect, {}});
        if (settings_.projects)
            solve_pressure(stages, 0);
        stages.push_back({Pass::gradient, {}});
    }
}

std::vector<std::uint32_t> Passes::shapes(DiffusionMethod most) const {
    std::vector<std::uint32_t> shapes = {static_cast<std::uint32_t>(substep(most).size())};
    const auto append = [&](Pass pass) {
        const Groups each = groups(pass);
        shapes.insert(shapes.end(), each.begin(), each.end());
    };
    append(Pass::limit);
    for (const Stage& stage : substep(most))
        append(stage.pass);
    return shapes;
}

void Passes::bind(VkCommandBuffer commands, Pass pass, const Push& push, int show_frame) const {
    const auto n = static_cast<std::size_t>(pass);
    const Pipeline& pipeline = pipelines_[n];
    const VkDescriptorSet set = sets_.at(first_set_[n] + static_cast<std::size_t>(show_frame));
    functions_->vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.handle());
    functions_->vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.layout(), 0, 1, &set, 0, nullptr);
    functions_->vkCmdPushConstants(commands, pipeline.layout(), VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(Push), &push);
}

void Passes::record(VkCommandBuffer commands, Pass pass, const Push& push, int show_frame) const {
    bind(commands, pass, push, show_frame);
    const Groups count = groups(pass);
    functions_->vkCmdDispatch(commands, count[0], count[1], count[2]);
}

void Passes::record_indirect(VkCommandBuffer commands, Pass pass, const Push& push, std::uint32_t n) const {
    bind(commands, pass, push, 0);
    functions_->vkCmdDispatchIndirect(commands, commands_, VkDeviceSize{n} * sizeof(VkDispatchIndirectCommand));
}

} // namespace windrow::vulkan
