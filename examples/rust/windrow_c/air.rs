// Made by ./dev schema from the headers of c_api, where units, ranges and defaults are. Do not edit.
#![allow(dead_code, unused_imports)]
use std::mem::size_of;
use std::os::raw::{c_char, c_void};

pub type Part = i32; pub const PART_COUPLING: Part = 0; pub const PART_VDB: Part = 1; pub const PART_VULKAN: Part = 2;
pub const PART_SCENE: Part = 3;
pub type ResultCode = i32; pub const OK: ResultCode = 0; pub const REJECTED: ResultCode = -1;
pub const STALE: ResultCode = -2; pub const OUT_OF_MEMORY: ResultCode = -3; pub const CANNOT_WRITE: ResultCode = -4;
pub const DISK_FULL: ResultCode = -5; pub const UNSUPPORTED: ResultCode = -6; pub const NOT_READY: ResultCode = -7;
pub const DEVICE_LOST: ResultCode = -9; pub const UNEXPECTED: ResultCode = -8;
pub type Severity = i32; pub const SEVERITY_WARNING: Severity = 0; pub const SEVERITY_ERROR: Severity = 1;
pub type Axes = i32; pub const AXES_Y_UP_RIGHT: Axes = 0; pub const AXES_Y_UP_LEFT: Axes = 1;
pub const AXES_Z_UP_RIGHT: Axes = 2; pub const AXES_Z_UP_LEFT: Axes = 3;
pub type BoundaryKind = i32; pub const BOUNDARY_OPEN: BoundaryKind = 0; pub const BOUNDARY_FREE_SLIP: BoundaryKind = 1;
pub const BOUNDARY_NO_SLIP: BoundaryKind = 2; pub const BOUNDARY_PERIODIC: BoundaryKind = 3;
pub type Scheme = i32; pub const SCHEME_SECOND_ORDER: Scheme = 0; pub const SCHEME_STABLE_FLUIDS: Scheme = 1;
pub type Interpolation = i32; pub const INTERPOLATION_LINEAR: Interpolation = 0;
pub const INTERPOLATION_CUBIC: Interpolation = 1; pub const INTERPOLATION_CUBIC_32: Interpolation = 2;
pub type Simd = i32; pub const SIMD_BEST: Simd = 0; pub const SIMD_BASELINE: Simd = 1; pub const SIMD_AVX2: Simd = 2;
pub const SIMD_AVX512: Simd = 3;
pub const FOLLOW_DEFAULT: i32 = -1; pub const FOLLOW_X: i32 = 1; pub const FOLLOW_Y: i32 = 2;
pub const FOLLOW_Z: i32 = 4;
pub const STAGE_SOURCES: i32 = 1; pub const STAGE_RELAXATION: i32 = 2; pub const STAGE_DIFFUSION: i32 = 4;
pub const STAGE_ADVECTION: i32 = 8; pub const STAGE_PROJECTION: i32 = 16; pub const STAGE_ALL: i32 = 31;
pub const MAX_ROWS: i32 = 128;
pub type DiffusionMethod = i32; pub const DIFFUSION_NONE: DiffusionMethod = 0;
pub const DIFFUSION_ONE_PASS: DiffusionMethod = 1; pub const DIFFUSION_IMPLICIT: DiffusionMethod = 2;
pub type Frame = i32; pub const FRAME_NOW: Frame = 0; pub const FRAME_PREVIOUS: Frame = 1;
pub type Number = i32; pub const NUMBER_FLOAT: Number = 0; pub const NUMBER_DOUBLE: Number = 1;
pub type Texel = i32; pub const TEXEL_HALF: Texel = 0; pub const TEXEL_FLOAT: Texel = 1;
pub type FieldFormat = i32; pub const FIELD_FGA: FieldFormat = 0; pub const FIELD_VF: FieldFormat = 1;
pub const FIELD_RAW: FieldFormat = 2; pub const FIELD_NPZ: FieldFormat = 3; pub const FIELD_VTI: FieldFormat = 4;
pub type DebugKind = i32; pub const DEBUG_BOX: DebugKind = 0; pub const DEBUG_MOTOR: DebugKind = 1;
pub const DEBUG_OBSTACLE: DebugKind = 2; pub const DEBUG_ARROW: DebugKind = 3;

pub type Logger = Option<unsafe extern "C" fn(severity: Severity, sentence: *const c_char, user: *mut c_void)>;
pub type Allocate = Option<unsafe extern "C" fn(bytes: usize, alignment: usize, user: *mut c_void) -> *mut c_void>;
pub type Release = Option<unsafe extern "C" fn(memory: *mut c_void, bytes: usize, alignment: usize, user: *mut c_void)>;
pub type Task = Option<unsafe extern "C" fn(argument: *mut c_void, index: i32)>;
pub type Run = Option<unsafe extern "C" fn(context: *mut c_void, count: i32, task: Task, argument: *mut c_void)>;
pub type VelocityAt = Option<unsafe extern "C" fn(user: *mut c_void, centre: *const DVec3, velocity: *mut Vec3)>;
pub type DebugDraw = Option<unsafe extern "C" fn(user: *mut c_void, line: *const DebugLine)>;

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Vec2 {
    pub x: f32, pub y: f32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Vec3 {
    pub x: f32, pub y: f32, pub z: f32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Vec4 {
    pub x: f32, pub y: f32, pub z: f32, pub w: f32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Quat {
    pub x: f32, pub y: f32, pub z: f32, pub w: f32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct DVec2 {
    pub x: f64, pub y: f64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct DVec3 {
    pub x: f64, pub y: f64, pub z: f64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct DVec4 {
    pub x: f64, pub y: f64, pub z: f64, pub w: f64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct IVec2 {
    pub x: i32, pub y: i32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct IVec3 {
    pub x: i32, pub y: i32, pub z: i32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct UVec2 {
    pub x: u32, pub y: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct ParallelFor {
    pub run: Run, pub context: *mut c_void,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct SavedPart {
    pub name: *const c_char, pub bytes: *const c_void, pub size: u64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Boundary {
    pub kind: BoundaryKind, pub wall_velocity: Vec3,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Boundaries {
    pub x_low: Boundary, pub x_high: Boundary, pub y_low: Boundary, pub y_high: Boundary, pub z_low: Boundary,
    pub z_high: Boundary,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct LogProfile {
    pub struct_size: u32, pub roughness_length: f32, pub reference_height: f32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gusts {
    pub struct_size: u32, pub intensity: f32, pub length: f32, pub seed: u32, pub tile: *const c_void,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Canopy {
    pub struct_size: u32, pub height: f32, pub drag: f32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct RoughnessMap {
    pub struct_size: u32, pub reserved: u32, pub lengths: *const c_void, pub position: DVec3, pub scale: Vec3,
    pub reserved_2: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Roughness {
    pub struct_size: u32, pub length: f32, pub longest_mixing: f32, pub reserved: u32, pub map: *const RoughnessMap,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Rows {
    pub struct_size: u32, pub first: f32, pub uniform: i32, pub ratio: f32, pub top: f32, pub height_count: u32,
    pub heights: *const f32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Config {
    pub struct_size: u32, pub cells: IVec3, pub cell_size: f32, pub boundaries: Boundaries, pub follow_axes: i32,
    pub centre: DVec3, pub ambient: Vec3, pub reserved: u32, pub profile: *const LogProfile, pub gusts: *const Gusts,
    pub canopy: *const Canopy, pub roughness: *const Roughness, pub rows: *const Rows, pub blend_width: f32,
    pub viscosity: f32, pub relaxation_time: f32, pub sleep_speed: f32, pub scheme: Scheme,
    pub interpolation: Interpolation, pub max_cfl: f32, pub max_substeps: i32, pub pressure_solves: i32,
    pub stages: u32, pub ticks_hz: f64, pub ticks_max_per_call: i32, pub simd: Simd, pub parallel_for: ParallelFor,
    pub floor: f64, pub jump_speed: f32, pub reserved_2: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Sampling {
    pub struct_size: u32, pub strength: f32, pub limit: f32, pub detail: f32, pub detail_length: f32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct AmbientSettings {
    pub struct_size: u32, pub mean: Vec3, pub profile: *const LogProfile, pub gusts: *const Gusts, pub ground: f64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct UniformGust {
    pub struct_size: u32, pub mean: f32, pub amplitude: f32, pub period: f32, pub direction: Vec3, pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct WindowBlock {
    pub origin: Vec3, pub cell_size: f32, pub cells: Vec3, pub factor: f32, pub previous_origin: Vec3, pub rows: f32,
    pub ambient: Vec3, pub height: f32, pub low_boundaries: Vec3, pub wall_per_length: f32, pub high_boundaries: Vec3,
    pub wall_per_log: f32, pub blend_centre: Vec3, pub blend_width: f32, pub blend_reach: Vec3, pub wall_lowest: f32,
    pub previous_blend_centre: Vec3, pub wall_fall: f32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct AxisBlock {
    pub texture_scale: f32, pub texture_offset: f32, pub inner_scale: f32, pub inner_offset: f32, pub edge_scale: f32,
    pub low_edge: f32, pub high_edge: f32, pub smoothness: f32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct PlaceBlock {
    pub x: AxisBlock, pub y: AxisBlock, pub z: AxisBlock,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct AmbientBlock {
    pub mean: Vec3, pub gust_strength: f32, pub roughness_length: f32, pub reference_height: f32,
    pub anchor_height: f32, pub felt_strength: f32, pub gust_texel: Vec3, pub gust_texels: f32, pub gust_fraction: Vec3,
    pub longest_gust: f32, pub gust_axes: Vec3, pub felt_limit: f32, pub detail_texel: Vec3, pub detail_texels: f32,
    pub detail_fraction: Vec3, pub detail_amount: f32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct FrameBlock {
    pub window: WindowBlock, pub place: PlaceBlock, pub previous_place: PlaceBlock, pub ambient: AmbientBlock,
    pub previous_ambient: AmbientBlock, pub heights: [f32; 128],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct DragBlock {
    pub load: Vec4,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct BladeBlock {
    pub size: Vec4, pub form: Vec4, pub own: Vec4, pub drag: DragBlock,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct ShellBlock {
    pub form: Vec4, pub push: Vec4, pub sag: Vec4, pub drag: DragBlock,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct TreeBlock {
    pub trunk: DragBlock, pub branch: DragBlock, pub leaf: DragBlock,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct SpringBlock {
    pub place: Vec4, pub velocity: Vec4,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct SwingBlock {
    pub spring: SpringBlock, pub smoothing: SpringBlock, pub parts: Vec4,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct FlutterBlock {
    pub motion: Vec4, pub now: Vec4, pub before: Vec4,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct PoseBlock {
    pub place: Vec4, pub rotation: Vec4,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct GroundPlaceBlock {
    pub corner: Vec4, pub blend_zone: Vec4, pub slot: Vec4,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct GroundBlock {
    pub now: GroundPlaceBlock, pub before: GroundPlaceBlock,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct StageTimes {
    pub sources: f64, pub ambient: f64, pub diffusion: f64, pub advection: f64, pub projection: f64, pub obstacles: f64,
    pub report: f64, pub total: f64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Diagnostics {
    pub struct_size: u32, pub stepped: i32, pub out_of_memory: i32, pub regridded: i32, pub max_speed: f32,
    pub cfl: f32, pub substeps: i32, pub substeps_capped: i32, pub carried_time: f32, pub motors_in_reach: i32,
    pub limited_cells: i64, pub repaired_cells: i64, pub diffusion: DiffusionMethod, pub pressure_residual: f32,
    pub pressure_solves: i32, pub sealed_sources: i32, pub divergence_rms: f64, pub energy: f64, pub asleep: i32,
    pub motors_lost: i32, pub times_ms: StageTimes, pub jumps: i32, pub reserved: u32, pub fast_turns: i32,
    pub reserved_2: u32, pub filling_obstacles: i32, pub reserved_3: u32, pub sealed_rooms: i32, pub reserved_4: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Advance {
    pub struct_size: u32, pub ticks: i32, pub dropped: f64, pub factor: f32, pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Box {
    pub struct_size: u32, pub cells: IVec3, pub cell_size: f32, pub size: Vec3, pub origin: DVec3,
    pub boundaries: Boundaries,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Query {
    pub struct_size: u32, pub frame: Frame, pub count: u64, pub positions: *const c_void, pub number: Number,
    pub position_stride: u32, pub anchor: DVec3, pub velocities: *mut f32, pub velocity_stride: u32, pub reserved: u32,
    pub sampling: *const Sampling,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct DebugLine {
    pub begin: DVec3, pub end: DVec3, pub kind: DebugKind, pub speed: f32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct DebugView {
    pub struct_size: u32, pub r#box: i32, pub motors: i32, pub obstacles: i32, pub arrows: i32, pub seconds: f32,
    pub height: f64,
}

#[cfg(target_pointer_width = "64")]
const _: () = {
    assert!(size_of::<Vec2>() == 8); assert!(size_of::<Vec3>() == 12); assert!(size_of::<Vec4>() == 16);
    assert!(size_of::<Quat>() == 16); assert!(size_of::<DVec2>() == 16); assert!(size_of::<DVec3>() == 24);
    assert!(size_of::<DVec4>() == 32); assert!(size_of::<IVec2>() == 8); assert!(size_of::<IVec3>() == 12);
    assert!(size_of::<UVec2>() == 8); assert!(size_of::<ParallelFor>() == 16); assert!(size_of::<SavedPart>() == 24);
    assert!(size_of::<Boundary>() == 16); assert!(size_of::<Boundaries>() == 96);
    assert!(size_of::<LogProfile>() == 12); assert!(size_of::<Gusts>() == 24); assert!(size_of::<Canopy>() == 12);
    assert!(size_of::<RoughnessMap>() == 56); assert!(size_of::<Roughness>() == 24); assert!(size_of::<Rows>() == 32);
    assert!(size_of::<Config>() == 288); assert!(size_of::<Sampling>() == 20);
    assert!(size_of::<AmbientSettings>() == 40); assert!(size_of::<UniformGust>() == 32);
    assert!(size_of::<WindowBlock>() == 144); assert!(size_of::<AxisBlock>() == 32);
    assert!(size_of::<PlaceBlock>() == 96); assert!(size_of::<AmbientBlock>() == 112);
    assert!(size_of::<FrameBlock>() == 1072); assert!(size_of::<DragBlock>() == 16);
    assert!(size_of::<BladeBlock>() == 64); assert!(size_of::<ShellBlock>() == 64);
    assert!(size_of::<TreeBlock>() == 48); assert!(size_of::<SpringBlock>() == 32);
    assert!(size_of::<SwingBlock>() == 80); assert!(size_of::<FlutterBlock>() == 48);
    assert!(size_of::<PoseBlock>() == 32); assert!(size_of::<GroundPlaceBlock>() == 48);
    assert!(size_of::<GroundBlock>() == 96); assert!(size_of::<StageTimes>() == 64);
    assert!(size_of::<Diagnostics>() == 192); assert!(size_of::<Advance>() == 24); assert!(size_of::<Box>() == 152);
    assert!(size_of::<Query>() == 80); assert!(size_of::<DebugLine>() == 56); assert!(size_of::<DebugView>() == 32);
};

#[link(name = "windrow")]
extern "C" {
    pub fn windrow_version() -> u32;
    pub fn windrow_version_string() -> *const c_char;
    pub fn windrow_has_part(part: Part) -> i32;
    pub fn windrow_last_error() -> *const c_char;
    pub fn windrow_set_logger(logger: Logger, user: *mut c_void);
    pub fn windrow_set_allocator(allocate: Allocate, release: Release, user: *mut c_void) -> ResultCode;
    pub fn windrow_allocated_bytes() -> u64;
    pub fn windrow_set_axes(axes: Axes, unit: f64) -> ResultCode;
    pub fn windrow_axes_matrix(matrix: *mut f64) -> ResultCode;
    pub fn windrow_thread_pool_create(threads: i32, pool: *mut *mut c_void) -> ResultCode;
    pub fn windrow_thread_pool_destroy(pool: *mut c_void);
    pub fn windrow_thread_pool_size(pool: *const c_void) -> i32;
    pub fn windrow_thread_pool_parallel_for(pool: *mut c_void) -> ParallelFor;
    pub fn windrow_bytes_data(bytes: *const c_void) -> *const u8;
    pub fn windrow_bytes_size(bytes: *const c_void) -> u64;
    pub fn windrow_bytes_destroy(bytes: *mut c_void);
    pub fn windrow_parts_join(parts: *const SavedPart, count: u64, file: *mut *mut c_void) -> ResultCode;
    pub fn windrow_parts_find(
        bytes: *const c_void, size: u64, name: *const c_char, part: *mut *const c_void, part_size: *mut u64
    ) -> ResultCode;
    pub fn windrow_boundaries_all(kind: BoundaryKind) -> Boundaries;
    pub fn windrow_boundaries_open_over_floor() -> Boundaries;
    pub fn windrow_log_profile_init(profile: *mut LogProfile, struct_size: u32) -> ResultCode;
    pub fn windrow_gusts_init(gusts: *mut Gusts, struct_size: u32) -> ResultCode;
    pub fn windrow_canopy_init(canopy: *mut Canopy, struct_size: u32) -> ResultCode;
    pub fn windrow_roughness_map_init(map: *mut RoughnessMap, struct_size: u32) -> ResultCode;
    pub fn windrow_roughness_init(roughness: *mut Roughness, struct_size: u32) -> ResultCode;
    pub fn windrow_rows_init(rows: *mut Rows, struct_size: u32) -> ResultCode;
    pub fn windrow_simd_runs(level: Simd) -> i32;
    pub fn windrow_simd_name(level: Simd) -> *const c_char;
    pub fn windrow_config_init(config: *mut Config, struct_size: u32) -> ResultCode;
    pub fn windrow_config_validate(config: *const Config) -> ResultCode;
    pub fn windrow_sampling_init(sampling: *mut Sampling, struct_size: u32) -> ResultCode;
    pub fn windrow_sampling_validate(sampling: *const Sampling) -> ResultCode;
    pub fn windrow_gust_tile_bake(seed: u32, tile: *mut *mut c_void) -> ResultCode;
    pub fn windrow_gust_tile_destroy(tile: *mut c_void);
    pub fn windrow_gust_tile_save(tile: *const c_void, bytes: *mut *mut c_void) -> ResultCode;
    pub fn windrow_gust_tile_load(bytes: *const c_void, size: u64, tile: *mut *mut c_void) -> ResultCode;
    pub fn windrow_gust_tile_texels(tile: *const c_void, count: *mut u64) -> *const Vec4;
    pub fn windrow_ambient_settings_init(settings: *mut AmbientSettings, struct_size: u32) -> ResultCode;
    pub fn windrow_ambient_wind_create(settings: *const AmbientSettings, ambient: *mut *mut c_void) -> ResultCode;
    pub fn windrow_ambient_wind_of(wind: *const c_void, frame: i32, ambient: *mut *mut c_void) -> ResultCode;
    pub fn windrow_ambient_wind_destroy(ambient: *mut c_void);
    pub fn windrow_ambient_wind_advance(ambient: *mut c_void, dt: f64) -> ResultCode;
    pub fn windrow_ambient_wind_set_mean(ambient: *mut c_void, mean: Vec3) -> ResultCode;
    pub fn windrow_ambient_wind_set_ground(ambient: *mut c_void, height: f64) -> ResultCode;
    pub fn windrow_ambient_wind_set_phase(ambient: *mut c_void, phase: DVec3) -> ResultCode;
    pub fn windrow_ambient_wind_phase(ambient: *const c_void) -> DVec3;
    pub fn windrow_ambient_wind_period(ambient: *const c_void) -> f64;
    pub fn windrow_ambient_wind_mean(ambient: *const c_void) -> Vec3;
    pub fn windrow_ambient_wind_ground(ambient: *const c_void) -> f64;
    pub fn windrow_ambient_wind_profile_at(ambient: *const c_void, height: f64) -> f32;
    pub fn windrow_ambient_wind_velocity(ambient: *const c_void, position: DVec3, velocity: *mut Vec3) -> ResultCode;
    pub fn windrow_ambient_wind_felt(
        ambient: *const c_void, position: DVec3, sampling: *const Sampling, velocity: *mut Vec3
    ) -> ResultCode;
    pub fn windrow_ambient_wind_block(
        ambient: *const c_void, anchor: DVec3, sampling: *const Sampling, block: *mut AmbientBlock
    ) -> ResultCode;
    pub fn windrow_ambient_wind_tile(ambient: *const c_void, tile: *mut *mut c_void) -> ResultCode;
    pub fn windrow_uniform_gust_init(gust: *mut UniformGust, struct_size: u32) -> ResultCode;
    pub fn windrow_uniform_gust_velocity(gust: *const UniformGust, time: f64, velocity: *mut Vec3) -> ResultCode;
    pub fn windrow_diagnostics_init(diagnostics: *mut Diagnostics, struct_size: u32) -> ResultCode;
    pub fn windrow_advance_init(advance: *mut Advance, struct_size: u32) -> ResultCode;
    pub fn windrow_box_init(r#box: *mut Box, struct_size: u32) -> ResultCode;
    pub fn windrow_wind_create(config: *const Config, wind: *mut *mut c_void) -> ResultCode;
    pub fn windrow_wind_create_inside(config: *const Config, outer: *const c_void, wind: *mut *mut c_void) -> ResultCode;
    pub fn windrow_wind_destroy(wind: *mut c_void);
    pub fn windrow_wind_save(wind: *const c_void, bytes: *mut *mut c_void) -> ResultCode;
    pub fn windrow_wind_load(
        bytes: *const c_void, size: u64, parallel_for: *const ParallelFor, wind: *mut *mut c_void
    ) -> ResultCode;
    pub fn windrow_wind_load_inside(
        bytes: *const c_void, size: u64, parallel_for: *const ParallelFor, outer: *const c_void, wind: *mut *mut c_void
    ) -> ResultCode;
    pub fn windrow_wind_record_to(wind: *mut c_void, log: *mut c_void) -> ResultCode;
    pub fn windrow_wind_config(wind: *mut c_void, config: *mut Config) -> ResultCode;
    pub fn windrow_wind_memory_bytes(wind: *const c_void) -> u64;
    pub fn windrow_wind_step(wind: *mut c_void, dt: f64, diagnostics: *mut Diagnostics) -> ResultCode;
    pub fn windrow_wind_advance(wind: *mut c_void, dt: f64, advance: *mut Advance, last: *mut Diagnostics) -> ResultCode;
    pub fn windrow_wind_follow(wind: *mut c_void, point: DVec3) -> ResultCode;
    pub fn windrow_wind_set_floor(wind: *mut c_void, height: f64) -> ResultCode;
    pub fn windrow_wind_shift_origin(wind: *mut c_void, offset: DVec3) -> ResultCode;
    pub fn windrow_wind_box(wind: *const c_void, r#box: *mut Box) -> ResultCode;
    pub fn windrow_wind_origin(wind: *const c_void) -> DVec3;
    pub fn windrow_wind_cell_count(wind: *const c_void) -> u64;
    pub fn windrow_wind_set_ambient(wind: *mut c_void, ambient: Vec3) -> ResultCode;
    pub fn windrow_wind_ambient(wind: *const c_void) -> Vec3;
    pub fn windrow_wind_set_gusts(wind: *mut c_void, gusts: *const Gusts) -> ResultCode;
    pub fn windrow_wind_set_boundaries(wind: *mut c_void, boundaries: *const Boundaries) -> ResultCode;
    pub fn windrow_wind_set_velocity(wind: *mut c_void, velocity_at: VelocityAt, user: *mut c_void) -> ResultCode;
    pub fn windrow_wind_set_field(wind: *mut c_void, cells: *const Vec4, count: u64) -> ResultCode;
    pub fn windrow_wind_reset(wind: *mut c_void) -> ResultCode;
    pub fn windrow_wind_velocity(wind: *const c_void, position: DVec3, velocity: *mut Vec3) -> ResultCode;
    pub fn windrow_wind_felt(
        wind: *const c_void, position: DVec3, sampling: *const Sampling, velocity: *mut Vec3
    ) -> ResultCode;
    pub fn windrow_query_init(query: *mut Query, struct_size: u32) -> ResultCode;
    pub fn windrow_wind_sample(wind: *const c_void, query: *const Query) -> ResultCode;
    pub fn windrow_wind_write_vectors(
        wind: *const c_void, frame: Frame, texel: Texel, texels: *mut c_void, count: u64
    ) -> ResultCode;
    pub fn windrow_wind_write_axes(
        wind: *const c_void, frame: Frame, texel: Texel, x: *mut c_void, y: *mut c_void, z: *mut c_void, count: u64
    ) -> ResultCode;
    pub fn windrow_wind_write_obstacles(wind: *const c_void, cells: *mut f32, count: u64) -> ResultCode;
    pub fn windrow_wind_write_pressure(wind: *mut c_void, cells: *mut f32, count: u64) -> ResultCode;
    pub fn windrow_wind_field(
        wind: *const c_void, frame: Frame, cells: *mut *const Vec4, count: *mut u64, origin: *mut DVec3
    ) -> ResultCode;
    pub fn windrow_wind_write_field(
        wind: *const c_void, path: *const c_char, format: FieldFormat, time: f64
    ) -> ResultCode;
    pub fn windrow_to_half(value: f32) -> u16;
    pub fn windrow_from_half(half: u16) -> f32;
    pub fn windrow_debug_view_init(view: *mut DebugView, struct_size: u32) -> ResultCode;
    pub fn windrow_wind_debug_lines(
        wind: *const c_void, view: *const DebugView, draw: DebugDraw, user: *mut c_void
    ) -> ResultCode;
    pub fn windrow_wind_window_block(wind: *const c_void, anchor: DVec3, block: *mut WindowBlock) -> ResultCode;
    pub fn windrow_wind_frame_block(
        wind: *const c_void, anchor: DVec3, sampling: *const Sampling, block: *mut FrameBlock
    ) -> ResultCode;
    pub fn windrow_event_log_create(log: *mut *mut c_void) -> ResultCode;
    pub fn windrow_event_log_destroy(log: *mut c_void);
    pub fn windrow_event_log_count(log: *const c_void) -> u64;
    pub fn windrow_event_log_complete(log: *const c_void) -> i32;
    pub fn windrow_event_log_clear(log: *mut c_void) -> ResultCode;
    pub fn windrow_event_log_to_bytes(log: *const c_void, bytes: *mut *mut c_void) -> ResultCode;
    pub fn windrow_event_log_from_bytes(bytes: *const c_void, size: u64, log: *mut *mut c_void) -> ResultCode;
    pub fn windrow_event_log_replay(log: *const c_void, wind: *mut c_void) -> ResultCode;
    pub fn windrow_tracer_create(
        wind: *const c_void, parallel_for: *const ParallelFor, tracer: *mut *mut c_void
    ) -> ResultCode;
    pub fn windrow_tracer_destroy(tracer: *mut c_void);
    pub fn windrow_tracer_save(tracer: *const c_void, bytes: *mut *mut c_void) -> ResultCode;
    pub fn windrow_tracer_load(
        bytes: *const c_void, size: u64, wind: *const c_void, parallel_for: *const ParallelFor, tracer: *mut *mut c_void
    ) -> ResultCode;
    pub fn windrow_tracer_step(tracer: *mut c_void, wind: *const c_void, dt: f64) -> ResultCode;
    pub fn windrow_tracer_blow(tracer: *mut c_void, point: DVec3, radius: f32) -> ResultCode;
    pub fn windrow_tracer_cells(tracer: *const c_void, count: *mut u64) -> *const f32;
}
