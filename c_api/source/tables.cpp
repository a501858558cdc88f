#include "c_api/source/tables.h"

#include <array>

namespace windrow::c_api {
namespace {

template <std::size_t Kinds>
void add_kind(Reasons& reasons, const Path& path, std::int32_t kind, const std::array<const char*, Kinds>& names) {
    reasons.add(path, ".kind is ", kind, ": give ", detail::Choice{names}, ", as 0 to ", Kinds - 1, ".");
}

constexpr std::array k_stages{&Stages::sources, &Stages::relaxation, &Stages::diffusion, &Stages::advection, &Stages::projection};
static_assert(detail::member_count<Stages>() == k_stages.size() && WINDROW_STAGE_ALL == (1 << k_stages.size()) - 1);

} // namespace

void read_rest(Reasons&, const Path&, const windrow_gust_tile* from, std::shared_ptr<const GustTile>& to) {
    to = from != nullptr ? from->tile : nullptr;
}
void read_rest(Reasons&, const Path&, const windrow_height_map* from, std::shared_ptr<const HeightMap>& to) {
    to = from != nullptr ? from->map : nullptr;
}

void read_rest(Reasons&, const Path&, const windrow_parallel_for& from, ParallelFor& to) {
    to = {from.run, from.context};
}
void write_rest(Writing, const ParallelFor& from, windrow_parallel_for& to) {
    to = {from.run, from.context};
}

void read_rest(Reasons& reasons, const Path& path, const windrow_rows& from, Rows& to) {
    if (from.heights == nullptr && from.height_count > 0)
        reasons.add(path, ".heights is null: give ", from.height_count, " heights, or height_count 0.");
    else if (from.height_count > static_cast<std::uint32_t>(k_max_axis_cells)) // more are not even copied
        reasons.add(path, ".height_count is ", from.height_count, ": give one height a row, at most ", k_max_rows, ".");
    else
        to.heights.assign(from.heights, from.heights + from.height_count);
}
void write_rest(Writing, const Rows& from, windrow_rows& to) {
    to.height_count = static_cast<std::uint32_t>(from.heights.size());
    to.heights = from.heights.data();
}

void read_rest(Reasons& reasons, const Path& path, const windrow_config& from, Config& to) {
    if (from.follow_axes == WINDROW_FOLLOW_DEFAULT)
        to.follow_axes.reset();
    else if (from.follow_axes < 0 || from.follow_axes > (WINDROW_FOLLOW_X | WINDROW_FOLLOW_Y | WINDROW_FOLLOW_Z))
        reasons.add(path, ".follow_axes is ", from.follow_axes, ": give bits of WINDROW_FOLLOW_*, or WINDROW_FOLLOW_DEFAULT.");
    else
        to.follow_axes = glm::bvec3(from.follow_axes & WINDROW_FOLLOW_X, from.follow_axes & WINDROW_FOLLOW_Y,
                                    from.follow_axes & WINDROW_FOLLOW_Z);
    to.relaxation_time.reset();
    if (from.relaxation_time != -1.0f)
        to.relaxation_time = from.relaxation_time;
    if (from.stages > static_cast<std::uint32_t>(WINDROW_STAGE_ALL))
        reasons.add(path, ".stages is ", from.stages, ": give bits of WINDROW_STAGE_*.");
    for (std::size_t n = 0; n < k_stages.size(); ++n)
        to.stages.*k_stages[n] = (from.stages >> n & 1u) != 0;
    to.ticks = {.hz = from.ticks_hz, .max_per_call = from.ticks_max_per_call};
}
void write_rest(Writing, const Config& from, windrow_config& to) {
    to.follow_axes = WINDROW_FOLLOW_DEFAULT;
    if (from.follow_axes)
        to.follow_axes = (from.follow_axes->x ? WINDROW_FOLLOW_X : 0) | (from.follow_axes->y ? WINDROW_FOLLOW_Y : 0) |
                         (from.follow_axes->z ? WINDROW_FOLLOW_Z : 0);
    to.relaxation_time = from.relaxation_time.value_or(-1.0f);
    to.stages = 0;
    for (std::size_t n = 0; n < k_stages.size(); ++n)
        to.stages |= from.stages.*k_stages[n] ? 1u << n : 0u;
    to.ticks_hz = from.ticks.hz;
    to.ticks_max_per_call = from.ticks.max_per_call;
}

void write_rest(Writing, const Box& from, windrow_box& to) {
    to.size = to_c(from.size());
}

// --- Motors ----------------------------------------------------------------------------------------------------------
void read_rest(Reasons& reasons, const Path& path, const windrow_region& from, Region& to) {
    switch (from.kind) {
    case WINDROW_REGION_SPHERE:
        to = Sphere{from.radius};
        return;
    case WINDROW_REGION_CAPSULE:
        to = Capsule{to_cpp(from.half_axis), from.radius};
        return;
    case WINDROW_REGION_BOX:
        to = AlignedBox{to_cpp(from.half_size)};
        return;
    case WINDROW_REGION_CONE:
        to = Cone{to_cpp(from.axis), from.start_radius, from.end_radius};
        return;
    default:
        add_kind(reasons, path, from.kind, k_alternatives<Region>);
    }
}
void write_rest(Writing, const Region& from, windrow_region& to) {
    to = {};
    to.kind = static_cast<std::int32_t>(from.index());
    if (const auto* sphere = std::get_if<Sphere>(&from))
        to.radius = sphere->radius;
    else if (const auto* capsule = std::get_if<Capsule>(&from)) {
        to.half_axis = to_c(capsule->half_axis);
        to.radius = capsule->radius;
    } else if (const auto* box = std::get_if<AlignedBox>(&from))
        to.half_size = to_c(box->half_size);
    else if (const auto* cone = std::get_if<Cone>(&from)) {
        to.axis = to_c(cone->axis);
        to.start_radius = cone->start_radius;
        to.end_radius = cone->end_radius;
    }
}
static_assert(std::variant_size_v<Region> == 4 && std::variant_size_v<Motor> == 6);

void read_rest(Reasons& reasons, const Path& path, const windrow_law& from, std::variant<Force, Drive>& to) {
    if (from.kind == WINDROW_LAW_FORCE)
        to = Force{from.acceleration};
    else if (from.kind == WINDROW_LAW_DRIVE)
        to = Drive{from.speed, from.rate};
    else
        add_kind(reasons, path, from.kind, k_alternatives<std::variant<Force, Drive>>);
}
void write_rest(Writing, const std::variant<Force, Drive>& from, windrow_law& to) {
    if (const auto* force = std::get_if<Force>(&from))
        to = windrow_law_force(force->acceleration);
    else if (const auto* drive = std::get_if<Drive>(&from))
        to = windrow_law_drive(drive->speed, drive->rate);
}

void read_rest(Reasons& reasons, const Path& path, const windrow_wake_law& from, std::variant<WakeForce, WakeDrive>& to) {
    if (from.kind == WINDROW_LAW_FORCE)
        to = WakeForce{from.strength};
    else if (from.kind == WINDROW_LAW_DRIVE)
        to = WakeDrive{from.per_metre, from.entrainment};
    else
        add_kind(reasons, path, from.kind, k_alternatives<std::variant<WakeForce, WakeDrive>>);
}
void write_rest(Writing, const std::variant<WakeForce, WakeDrive>& from, windrow_wake_law& to) {
    if (const auto* force = std::get_if<WakeForce>(&from))
        to = windrow_wake_law_force(force->strength);
    else if (const auto* drive = std::get_if<WakeDrive>(&from))
        to = windrow_wake_law_drive(drive->per_metre, drive->entrainment);
}

// --- Obstacles ---------------------------------------------------------------------------------------------------------
void read_rest(Reasons& reasons, const Path& path, const windrow_shape& from, Shape& to) {
    switch (from.kind) {
    case WINDROW_SHAPE_SPHERE:
        to = Sphere{from.radius};
        return;
    case WINDROW_SHAPE_CAPSULE:
        to = Capsule{to_cpp(from.half_axis), from.radius};
        return;
    case WINDROW_SHAPE_BLOCK:
        to = Block{to_cpp(from.half_size)};
        return;
    case WINDROW_SHAPE_CYLINDER:
        to = Cylinder{from.radius, from.half_length};
        return;
    case WINDROW_SHAPE_PLATE:
        to = Plate{{from.half_size.x, from.half_size.y}};
        return;
    case WINDROW_SHAPE_MESH:
        to = MeshShape{from.mesh != nullptr ? from.mesh->mesh : nullptr, from.scale.x};
        return;
    case WINDROW_SHAPE_VOXELS:
        to = VoxelShape{from.voxels != nullptr ? from.voxels->grid : nullptr, from.cell_size};
        return;
    case WINDROW_SHAPE_GROUND: {
        Ground ground{from.heights != nullptr ? from.heights->map : nullptr, to_cpp(from.scale)};
        if (read_choice(reasons, Path{&path, "beyond"}, from.beyond, ground.beyond))
            to = ground;
        return;
    }
    default:
        add_kind(reasons, path, from.kind, k_alternatives<Shape>);
    }
}
void write_rest(Writing, const Shape& from, windrow_shape& to) {
    to = {};
    if (const auto* sphere = std::get_if<Sphere>(&from))
        to = windrow_shape_sphere(sphere->radius);
    else if (const auto* capsule = std::get_if<Capsule>(&from))
        to = windrow_shape_capsule(to_c(capsule->half_axis), capsule->radius);
    else if (const auto* block = std::get_if<Block>(&from))
        to = windrow_shape_block(to_c(block->half_size));
    else if (const auto* cylinder = std::get_if<Cylinder>(&from))
        to = windrow_shape_cylinder(cylinder->radius, cylinder->half_length);
    else if (const auto* plate = std::get_if<Plate>(&from))
        to = windrow_shape_plate(to_c(plate->half_size));
    else if (const auto* mesh = std::get_if<MeshShape>(&from))
        to = windrow_shape_mesh(nullptr, mesh->scale);
    else if (const auto* voxels = std::get_if<VoxelShape>(&from))
        to = windrow_shape_voxels(nullptr, voxels->cell_size);
    else if (const auto* ground = std::get_if<Ground>(&from)) {
        to = windrow_shape_ground(nullptr, to_c(ground->scale));
        to.beyond = static_cast<windrow_beyond>(ground->beyond);
    }
}
static_assert(std::variant_size_v<Shape> == 8);

} // namespace windrow::c_api
