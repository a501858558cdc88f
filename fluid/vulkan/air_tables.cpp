// Tables of the box on the device: the direct solves, and the rules that give values to cells beyond the boundaries. Uploaded
// once, and again when the boundary conditions change.
//
// Tables of 10^4 floats and more go through a range of host memory, which a copy in the command buffer reads. A range is written
// before it is recorded and never again: new tables get a new range, and the old one is kept until its slot is reused.
#include "fluid/grid/box_rules.h"
#include "fluid/vulkan/air.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace windrow::vulkan {

namespace {

std::vector<WindrowRule> rules_in(const Box& box) {
    std::vector<WindrowRule> rules;
    for (const auto rules_of : {halo_rules, carried_rules})
        for (int axis = 0; axis < 3; ++axis)
            for (const HaloRule& from : rules_of(box, axis)) {
                WindrowRule rule{};
                rule.source = from.source;
                rule.beyond_open_side = from.ambient ? 1 : 0;
                rule.identity = from.identity ? 1 : 0;
                for (int n = 0; n < 3; ++n) {
                    rule.scale[n] = from.scale[n];
                    rule.offset[n] = from.offset[n];
                    rule.history_scale[n] = from.history_scale[n];
                }
                rules.push_back(rule);
            }
    return rules;
}

} // namespace

// Of a padded field, as pass.glsl reads them.
std::vector<WindrowRow> Air::rows_in(const RowTable& rows) const {
    const ColumnRows columns(rows, static_cast<double>(config_.cell_size));
    std::vector<WindrowRow> found;
    for (int j = -WINDROW_HALO_LOW; j < rows.count() + WINDROW_HALO - WINDROW_HALO_LOW; ++j) {
        const int within = std::clamp(j, 0, rows.count() - 1);
        const double apart = rows.height(j) - rows.height(j - 1);
        found.push_back({.height = static_cast<float>(rows.height(j)),
                         .scale = rows.scales()[static_cast<std::size_t>(within)],
                         .link = static_cast<float>(static_cast<double>(config_.cell_size) / apart),
                         .column = static_cast<float>(columns.scales[static_cast<std::size_t>(within)])});
    }
    const float finest = box().finest() / config_.cell_size;
    found.front().column = 1.0f / (finest * finest);
    return found;
}

void Air::lift(VkCommandBuffer commands, const CellChange& change) {
    CellChange along_ground = change;
    along_ground.by.y = 0;
    if (along_ground.by != CellIndex(0)) {
        apply(commands, along_ground);
        place_exposed(commands);
    }
    uncover(commands, -1);
    counted_ = false;
    write_step(commands, block_of(change.ambient, change.window), change.ambient);
    barrier(k_transfer | k_compute, k_compute);
    const auto field = [&](int which, bool ambient) {
        for (const int back : {0, 1}) {
            dispatch(commands, Pass::lift,
                     WindrowLiftPush{.rise = static_cast<float>(static_cast<double>(change.by.y) * rows_table_->step()),
                                     .field = which,
                                     .value = ambient && change.exposed_hold_ambient ? WINDROW_PLACE_AMBIENT : WINDROW_PLACE_ZERO,
                                     .back = back});
            barrier(k_compute, k_compute | k_transfer);
        }
    };
    field(WINDROW_LIFT_NOW, true);
    if (!fresh_) {
        field(WINDROW_LIFT_AGO, true);
        field(WINDROW_LIFT_HISTORY, false);
    }
    if (change.has_source_flow)
        field(WINDROW_LIFT_SOURCE_FLOW, false);
    if (change.kept && !keeps_)
        field(WINDROW_LIFT_BEFORE, true);
    if (solids_) // no list of theirs holds in other rows
        lift_obstacles(commands, change.by);
}

SolveTables Air::tables_of(const Boundaries& boundaries) const {
    const ColumnRows rows = rows_table_ ? ColumnRows(*rows_table_, static_cast<double>(config_.cell_size)) : ColumnRows();
    SolveTables tables(config_.cells, pressure_ends(boundaries), rows, Passes::fits_in_slabs(*device_, config_.cells));
    if (prepared_ == DiffusionMethod::implicit)
        tables.add_diffusion(config_.cells,
                             {velocity_ends(boundaries, 0), velocity_ends(boundaries, 1), velocity_ends(boundaries, 2)});
    return tables;
}

// Empty where the tables travel inside the command buffer.
Result<Buffer> Air::piece_of(const SolveTables& tables) {
    const auto bytes = std::as_bytes(std::span(tables.values));
    if (bytes.size() <= k_max_update)
        return Buffer{};
    auto piece = Buffer::create(*device_, bytes.size(), MemoryUse::upload);
    if (!piece)
        return piece.failure();
    if (!device_->memory().measuring())
        std::memcpy(piece->mapped(), bytes.data(), bytes.size());
    return piece;
}

void Air::make_room_for_sides() {
    constexpr std::size_t k_max_slots = 16; // of frames in flight, twice over
    rules_ = rules_in(box());
    retired_.reserve(k_max_slots);
}

Result<Air::NewBoundaries> Air::prepare(const Boundaries& boundaries, bool kinds) {
    Box changed = box();
    changed.boundaries = boundaries;
    NewBoundaries prepared{.boundaries = boundaries, .tables = {}, .piece = {}, .rules = rules_in(changed)};
    if (!kinds)
        return prepared;
    prepared.tables.emplace(tables_of(boundaries));
    auto piece = piece_of(*prepared.tables);
    if (!piece)
        return piece.failure();
    prepared.piece = *std::move(piece);
    return prepared;
}

void Air::set_boundaries(VkCommandBuffer commands, NewBoundaries&& boundaries) {
    config_.boundaries = boundaries.boundaries;
    rules_ = std::move(boundaries.rules);
    rules_written_ = false;
    if (!boundaries.tables)
        return;
    tables_ = std::move(boundaries.tables);
    passes_.set_tables(*tables_);
    if (piece_slot_ >= 0 && piece_slot_ != slot_)
        retired_.push_back({std::move(piece_), piece_slot_});
    piece_ = std::move(boundaries.piece);
    piece_slot_ = -1;
    tables_written_ = false;
    fresh_ = inside_is_air_ = reading_stale_ = true;
    place_within_boundaries(commands);
}

void Air::begin(int slot) {
    slot_before_ = std::exchange(slot_, slot);
    fields_.step.begin(slot);
    fields_.motors.begin(slot);
    fields_.outer.begin(slot);
    step_put_ = false;
    reported_slot_ = -1;
    stepped_ = false;
    std::erase_if(retired_, [&](const Retired& retired) { return retired.slot == slot; });
    std::erase_if(retired_passes_, [&](const RetiredPasses& retired) { return retired.slot == slot; });
}

void Air::forget() {
    // What the recording that was thrown away has replaced, those before it may still use.
    for (Retired& retired : retired_)
        retired.slot = retired.slot == slot_ ? slot_before_ : retired.slot;
    for (RetiredPasses& retired : retired_passes_)
        retired.slot = retired.slot == slot_ ? slot_before_ : retired.slot;
    slot_ = slot_before_;
    tables_written_ = rules_written_ = cleared_ = false;
    outer_stale_ = true;
    tile_.reset();
    layer_written_.clear();
    solids_.reset();
    place_again_ = reading_stale_ = drag_stale_ = true;
    shapes_.reset();
    shift_.reset();
    fresh_ = first_sources_ = true;
    keeps_ = ordered_ = counted_ = reading_known_ = false;
}

// Data that is constant from tick to tick, written once.
void Air::write_tables(VkCommandBuffer commands) {
    if (tables_written_ && rules_written_)
        return;
    barrier(k_compute | k_transfer, k_transfer);
    if (!std::exchange(rules_written_, true))
        write(commands, fields_.rules, std::as_bytes(std::span(rules_)));
    if (!std::exchange(tables_written_, true)) {
        if (piece_.bytes() > 0) {
            copy(commands, piece_, fields_.tables);
            piece_slot_ = slot_;
        } else {
            write(commands, fields_.tables, std::as_bytes(std::span(tables_->values)));
        }
        shapes_.reset();
    }
    // These are read before the first write, times 0: they must hold finite numbers.
    if (!std::exchange(cleared_, true))
        for (const Buffer* field : {&fields_.velocity, &fields_.history, &fields_.force, &fields_.source_flow, &fields_.expansion,
                                    &fields_.potential, &fields_.control})
            clear(commands, *field);
    barrier(k_transfer, k_compute | k_transfer);
}

// --- The blocks of a tick, which the host writes where the passes read them ---------------------------------------------------

void Air::write_step(VkCommandBuffer commands, const WindrowStep& block, const AmbientWind& ambient,
                     std::shared_ptr<const GustTile> tile) {
    if (!tile)
        tile = settings_.gusts ? ambient.tile() : tile_;
    write_tables(commands);
    upload_outer(commands);
    if (tile && tile != tile_) {
        tile_ = std::move(tile);
        // The host's shaders read it too: those of earlier frames finish before it changes.
        barrier(device_->reader_stages() | k_compute | k_transfer, k_transfer);
        write(commands, fields_.tile, std::as_bytes(tile_->texels()));
        barrier(k_transfer, k_compute | k_transfer);
    }
    std::memcpy(step_block_.data(), &block, sizeof(block));
    put_step(commands);
}

std::uint32_t Air::put(VkCommandBuffer commands, HostBlocks& blocks, std::span<const std::byte> bytes) {
    if (const auto at = blocks.put(bytes))
        return *at;
    barrier(k_compute | k_transfer, k_transfer);
    write(commands, blocks.buffer(), bytes, blocks.last());
    barrier(k_transfer, k_compute | k_transfer);
    return blocks.last();
}

void Air::put_step(VkCommandBuffer commands) {
    step_put_ = true;
    blocks_.step = put(commands, fields_.step, step_block_);
}

} // namespace windrow::vulkan
