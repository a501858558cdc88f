// Made by ./dev schema from the headers of c_api, where units, ranges and defaults are. Do not edit.
#![allow(dead_code, unused_imports)]
use super::air::*;
use super::bodies::*;
use super::operators::*;
use super::plants::*;
use std::mem::size_of;
use std::os::raw::{c_char, c_void};

pub type VdbForm = i32; pub const VDB_ONE_VECTOR: VdbForm = 0; pub const VDB_THREE_SCALARS: VdbForm = 1;
pub type VdbPrecision = i32; pub const VDB_FULL: VdbPrecision = 0; pub const VDB_HALF: VdbPrecision = 1;
pub type VdbUp = i32; pub const VDB_UP_Y: VdbUp = 0; pub const VDB_UP_Z: VdbUp = 1;
pub type VdbFormat = i32; pub const VDB_OPENVDB: VdbFormat = 0; pub const VDB_NANOVDB: VdbFormat = 1;
pub type VulkanTextureSet = i32; pub const VULKAN_VECTORS: VulkanTextureSet = 0;
pub const VULKAN_AXES: VulkanTextureSet = 1; pub const VULKAN_BOTH: VulkanTextureSet = 2;
pub type VulkanReadBack = i32; pub const VULKAN_READ_NONE: VulkanReadBack = 0;
pub const VULKAN_READ_CELLS: VulkanReadBack = 1; pub const VULKAN_READ_HALVES: VulkanReadBack = 2;
pub const VULKAN_READ_BOX: VulkanReadBack = 3; pub const VULKAN_READ_POINTS: VulkanReadBack = 4;
pub const VULKAN_MAX_BINDINGS: i32 = 8;
pub type WindLeans = i32; pub const LEANS_EVERYWHERE: WindLeans = 0; pub const LEANS_EACH_TEXEL: WindLeans = 1;

pub type VulkanFunction = Option<unsafe extern "C" fn()>;
pub type VulkanGetInstanceProcAddr = Option<unsafe extern "C" fn(
        instance: *mut c_void, name: *const c_char
    ) -> VulkanFunction>;
pub type VulkanAllocate = Option<unsafe extern "C" fn(
        size: u64, alignment: u64, memory_type_bits: u32, type_index: u32, memory: *mut VulkanMemory, user: *mut c_void
    ) -> i32>;
pub type VulkanRelease = Option<unsafe extern "C" fn(memory: *const VulkanMemory, user: *mut c_void)>;
pub type VulkanPipelineCreated = Option<unsafe extern "C" fn(name: *const c_char, pipeline: u64, user: *mut c_void)>;
pub type VulkanMessage = Option<unsafe extern "C" fn(text: *const c_char, user: *mut c_void)>;
pub type VulkanRecord = Option<unsafe extern "C" fn(commands: *mut c_void, user: *mut c_void)>;
pub type VulkanRun = Option<unsafe extern "C" fn(
        record: VulkanRecord, argument: *mut c_void, user: *mut c_void
    ) -> ResultCode>;

#[repr(C)]
#[derive(Clone, Copy)]
pub struct VdbOptions {
    pub struct_size: u32, pub form: VdbForm, pub name: *const c_char, pub precision: VdbPrecision, pub up: VdbUp,
    pub time: f64, pub frame: i32, pub format: VdbFormat,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct VdbScalar {
    pub name: *const c_char, pub units: *const c_char, pub values: *const f32, pub outside: f32, pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct VdbVector {
    pub name: *const c_char, pub units: *const c_char, pub values: *const Vec4,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct VdbGrid {
    pub struct_size: u32, pub cells: IVec3, pub origin: DVec3, pub outside: Vec3, pub cell_size: f32, pub count: u64,
    pub field: *const Vec4, pub obstacle: *const f32, pub cell_height: f32, pub scalar_count: u32,
    pub vector_count: u32, pub reserved: u32, pub scalars: *const VdbScalar, pub vectors: *const VdbVector,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct VdbFilm {
    pub struct_size: u32, pub has_region: i32, pub low: DVec3, pub high: DVec3, pub margin: f64, pub voxel_size: f32,
    pub speed: i32, pub vorticity: i32, pub scalar_count: u32, pub scalars: *const VdbScalar,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct VulkanMemory {
    pub memory: u64, pub offset: u64, pub mapped: *mut c_void, pub user: u64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct VulkanHost {
    pub struct_size: u32, pub queue_family: u32, pub instance: *mut c_void, pub physical_device: *mut c_void,
    pub device: *mut c_void, pub get_instance_proc_addr: VulkanGetInstanceProcAddr,
    pub allocation_callbacks: *const c_void, pub pipeline_cache: u64, pub pipeline_store: *const c_void,
    pub reader_queue_families: *const u32, pub reader_queue_family_count: u32, pub reader_stages: u32,
    pub shared_bytes: u32, pub pipeline_flags: u32, pub allocate: VulkanAllocate, pub release: VulkanRelease,
    pub memory_user: *mut c_void, pub pipeline_created: VulkanPipelineCreated, pub pipeline_user: *mut c_void,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct VulkanRequirements {
    pub struct_size: u32, pub api_version: u32, pub shared_bytes: u32, pub invocations: u32, pub storage_buffers: u32,
    pub storage_images: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct VulkanDeviceFacts {
    pub struct_size: u32, pub software: i32, pub name: *const c_char, pub driver: *const c_char,
    pub api_version: *const c_char, pub trouble: *const c_char,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct VulkanDeviceSettings {
    pub struct_size: u32, pub device: i32, pub validation: i32, pub gpu_validation: i32, pub queue: u32,
    pub queue_without: u32, pub compute_queue: i32, pub extension_count: u32, pub extensions: *const *const c_char,
    pub wished: *const c_void, pub next: *const c_void, pub get_instance_proc_addr: VulkanGetInstanceProcAddr,
    pub on_message: VulkanMessage, pub message_user: *mut c_void, pub instance_extensions: *const *const c_char,
    pub instance_extension_count: u32, pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct VulkanSettings {
    pub struct_size: u32, pub texel: Texel, pub textures: VulkanTextureSet, pub frames_in_flight: i32, pub gusts: i32,
    pub timestamps: i32, pub queries: VulkanReadBack, pub read_cells: IVec3, pub read_points: i32, pub forces: i32,
    pub export_textures: u32, pub obstacles: i32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct VulkanFrame {
    pub struct_size: u32, pub slot: i32, pub dt: f64, pub around: *const DVec3, pub point_count: u64,
    pub points: *const DVec3, pub save: i32, pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct VulkanTexture {
    pub image: u64, pub view: u64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct VulkanTextures {
    pub vectors: VulkanTexture, pub axes: [VulkanTexture; 3],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct VulkanExportedImage {
    pub image: u64, pub memory: u64, pub offset: u64, pub size: u64, pub handle_type: u32, pub format: i32,
    pub width: u32, pub height: u32, pub depth: u32, pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct VulkanSetContent {
    pub now: VulkanTextures, pub before: VulkanTextures, pub sampler: u64, pub block: u64, pub block_offset: u64,
    pub tile: u64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct VulkanPass {
    pub name: *const c_char, pub dispatches: i32, pub reserved: u32, pub us: f64,
}

#[cfg(target_pointer_width = "64")]
const _: () = {
    assert!(size_of::<VdbOptions>() == 40); assert!(size_of::<VdbScalar>() == 32);
    assert!(size_of::<VdbVector>() == 24); assert!(size_of::<VdbGrid>() == 112); assert!(size_of::<VdbFilm>() == 88);
    assert!(size_of::<VulkanMemory>() == 32); assert!(size_of::<VulkanHost>() == 128);
    assert!(size_of::<VulkanRequirements>() == 24); assert!(size_of::<VulkanDeviceFacts>() == 40);
    assert!(size_of::<VulkanDeviceSettings>() == 96); assert!(size_of::<VulkanSettings>() == 56);
    assert!(size_of::<VulkanFrame>() == 48); assert!(size_of::<VulkanTexture>() == 16);
    assert!(size_of::<VulkanTextures>() == 64); assert!(size_of::<VulkanExportedImage>() == 56);
    assert!(size_of::<VulkanSetContent>() == 160); assert!(size_of::<VulkanPass>() == 24);
};

#[link(name = "windrow")]
extern "C" {
    pub fn windrow_vdb_has_nanovdb() -> i32;
    pub fn windrow_vdb_options_init(options: *mut VdbOptions, struct_size: u32) -> ResultCode;
    pub fn windrow_vdb_write(wind: *const c_void, path: *const c_char, options: *const VdbOptions) -> ResultCode;
    pub fn windrow_vdb_write_frame(
        wind: *const c_void, folder: *const c_char, prefix: *const c_char, digits: i32, frame: i32, time: f64,
        options: *const VdbOptions
    ) -> ResultCode;
    pub fn windrow_vdb_grid_init(grid: *mut VdbGrid, struct_size: u32) -> ResultCode;
    pub fn windrow_vdb_write_grid(grid: *const VdbGrid, path: *const c_char, options: *const VdbOptions) -> ResultCode;
    pub fn windrow_vdb_film_init(film: *mut VdbFilm, struct_size: u32) -> ResultCode;
    pub fn windrow_vdb_write_film(
        wind: *const c_void, film: *const VdbFilm, path: *const c_char, options: *const VdbOptions
    ) -> ResultCode;
    pub fn windrow_vulkan_host_init(host: *mut VulkanHost, struct_size: u32) -> ResultCode;
    pub fn windrow_vulkan_requirements_init(requirements: *mut VulkanRequirements, struct_size: u32) -> ResultCode;
    pub fn windrow_vulkan_require_features(features: *mut c_void) -> ResultCode;
    pub fn windrow_vulkan_check(
        instance: *mut c_void, physical_device: *mut c_void, get_instance_proc_addr: VulkanGetInstanceProcAddr
    ) -> ResultCode;
    pub fn windrow_vulkan_result_name(result: i32) -> *const c_char;
    pub fn windrow_vulkan_pipeline_store_create(host: *const VulkanHost, store: *mut *mut c_void) -> ResultCode;
    pub fn windrow_vulkan_pipeline_store_destroy(store: *mut c_void);
    pub fn windrow_vulkan_pipeline_store_count(store: *const c_void) -> u64;
    pub fn windrow_vulkan_device_facts_init(facts: *mut VulkanDeviceFacts, struct_size: u32) -> ResultCode;
    pub fn windrow_vulkan_device_list_create(list: *mut *mut c_void) -> ResultCode;
    pub fn windrow_vulkan_device_list_destroy(list: *mut c_void);
    pub fn windrow_vulkan_device_list_count(list: *const c_void) -> i32;
    pub fn windrow_vulkan_device_list_get(list: *const c_void, index: i32, facts: *mut VulkanDeviceFacts) -> ResultCode;
    pub fn windrow_vulkan_has_validation_layer() -> i32;
    pub fn windrow_vulkan_device_settings_init(settings: *mut VulkanDeviceSettings, struct_size: u32) -> ResultCode;
    pub fn windrow_vulkan_device_create(settings: *const VulkanDeviceSettings, device: *mut *mut c_void) -> ResultCode;
    pub fn windrow_vulkan_device_destroy(device: *mut c_void);
    pub fn windrow_vulkan_device_host(device: *const c_void, compute: i32, host: *mut VulkanHost) -> ResultCode;
    pub fn windrow_vulkan_device_queue(device: *const c_void, compute: i32) -> *mut c_void;
    pub fn windrow_vulkan_device_get_facts(device: *const c_void, facts: *mut VulkanDeviceFacts) -> ResultCode;
    pub fn windrow_vulkan_device_features(device: *const c_void) -> *const c_void;
    pub fn windrow_vulkan_device_messages(device: *const c_void) -> i32;
    pub fn windrow_vulkan_device_run(device: *mut c_void, record: VulkanRecord, user: *mut c_void) -> ResultCode;
    pub fn windrow_vulkan_device_submit(
        device: *mut c_void, slot: i32, record: VulkanRecord, user: *mut c_void
    ) -> ResultCode;
    pub fn windrow_vulkan_device_wait(device: *mut c_void) -> ResultCode;
    pub fn windrow_vulkan_settings_init(settings: *mut VulkanSettings, struct_size: u32) -> ResultCode;
    pub fn windrow_vulkan_frame_init(frame: *mut VulkanFrame, struct_size: u32) -> ResultCode;
    pub fn windrow_vulkan_wind_required_bytes(
        host: *const VulkanHost, config: *const Config, settings: *const VulkanSettings, memory: *mut u64,
        reserved: *mut u64
    ) -> ResultCode;
    pub fn windrow_vulkan_wind_required_bytes_inside(
        host: *const VulkanHost, config: *const Config, settings: *const VulkanSettings, outer: *const c_void,
        memory: *mut u64, reserved: *mut u64
    ) -> ResultCode;
    pub fn windrow_vulkan_wind_create(
        host: *const VulkanHost, config: *const Config, settings: *const VulkanSettings, wind: *mut *mut c_void
    ) -> ResultCode;
    pub fn windrow_vulkan_wind_create_inside(
        host: *const VulkanHost, config: *const Config, settings: *const VulkanSettings, outer: *const c_void,
        wind: *mut *mut c_void
    ) -> ResultCode;
    pub fn windrow_vulkan_wind_load(
        host: *const VulkanHost, bytes: *const c_void, size: u64, settings: *const VulkanSettings,
        wind: *mut *mut c_void
    ) -> ResultCode;
    pub fn windrow_vulkan_wind_load_inside(
        host: *const VulkanHost, bytes: *const c_void, size: u64, settings: *const VulkanSettings, outer: *const c_void,
        wind: *mut *mut c_void
    ) -> ResultCode;
    pub fn windrow_vulkan_wind_saved(wind: *mut c_void, bytes: *mut *mut c_void) -> ResultCode;
    pub fn windrow_vulkan_wind_record(
        wind: *mut c_void, commands: *mut c_void, frame: *const VulkanFrame, advance: *mut Advance,
        last: *mut Diagnostics
    ) -> ResultCode;
    pub fn windrow_vulkan_wind_record_step(
        wind: *mut c_void, commands: *mut c_void, frame: *const VulkanFrame, diagnostics: *mut Diagnostics
    ) -> ResultCode;
    pub fn windrow_vulkan_wind_collect(wind: *mut c_void, slot: i32) -> i32;
    pub fn windrow_vulkan_wind_forget(wind: *mut c_void) -> ResultCode;
    pub fn windrow_vulkan_wind_replay(
        log: *const c_void, wind: *mut c_void, run: VulkanRun, user: *mut c_void
    ) -> ResultCode;
    pub fn windrow_vulkan_wind_textures(wind: *const c_void, frame: Frame, textures: *mut VulkanTextures) -> ResultCode;
    pub fn windrow_vulkan_wind_gust_buffer(wind: *const c_void) -> u64;
    pub fn windrow_vulkan_wind_exported_images(
        wind: *const c_void, images: *mut VulkanExportedImage, count: *mut u32
    ) -> ResultCode;
    pub fn windrow_vulkan_sampler_info(boundaries: *const Boundaries, sampler_info: *mut c_void) -> ResultCode;
    pub fn windrow_vulkan_set_bindings(
        textures: VulkanTextureSet, stages: u32, first: u32, bindings: *mut c_void
    ) -> u32;
    pub fn windrow_vulkan_set_writes_create(
        set: u64, content: *const VulkanSetContent, textures: VulkanTextureSet, first: u32, writes: *mut *mut c_void
    ) -> ResultCode;
    pub fn windrow_vulkan_set_writes_destroy(writes: *mut c_void);
    pub fn windrow_vulkan_set_writes_data(writes: *const c_void) -> *const c_void;
    pub fn windrow_vulkan_set_writes_count(writes: *const c_void) -> u32;
    pub fn windrow_vulkan_wind_halves(
        wind: *const c_void, cells: *mut *const u16, count: *mut u64, origin: *mut DVec3
    ) -> ResultCode;
    pub fn windrow_vulkan_wind_points(
        wind: *const c_void, positions: *mut *const DVec3, velocities: *mut *const Vec4, count: *mut u64
    ) -> ResultCode;
    pub fn windrow_vulkan_wind_query_age(wind: *const c_void) -> f64;
    pub fn windrow_vulkan_wind_reported(wind: *mut c_void, diagnostics: *mut Diagnostics) -> ResultCode;
    pub fn windrow_vulkan_wind_dispatches(wind: *const c_void) -> i32;
    pub fn windrow_vulkan_wind_barriers(wind: *const c_void) -> i32;
    pub fn windrow_vulkan_wind_reserved_bytes(wind: *const c_void) -> u64;
    pub fn windrow_vulkan_wind_pass_times(
        wind: *const c_void, whole_us: *mut f64, read_back_us: *mut f64, untimed: *mut i32, passes: *mut VulkanPass,
        count: *mut u32
    ) -> ResultCode;
    pub fn windrow_vulkan_ground_create(
        host: *const VulkanHost, config: *const GroundConfig, texel: Texel, ground: *mut *mut c_void
    ) -> ResultCode;
    pub fn windrow_vulkan_ground_destroy(ground: *mut c_void);
    pub fn windrow_vulkan_ground_follow(ground: *mut c_void, point: DVec3) -> ResultCode;
    pub fn windrow_vulkan_ground_shift_origin(ground: *mut c_void, offset: DVec3) -> ResultCode;
    pub fn windrow_vulkan_ground_record(
        ground: *mut c_void, commands: *mut c_void, step: *const GroundStep, leans: WindLeans
    ) -> ResultCode;
    pub fn windrow_vulkan_ground_record_save(ground: *mut c_void, commands: *mut c_void) -> ResultCode;
    pub fn windrow_vulkan_ground_saved(ground: *mut c_void, bytes: *mut *mut c_void) -> ResultCode;
    pub fn windrow_vulkan_ground_load(
        host: *const VulkanHost, bytes: *const c_void, size: u64, texel: Texel, ground: *mut *mut c_void
    ) -> ResultCode;
    pub fn windrow_vulkan_ground_lean_buffer(ground: *const c_void) -> u64;
    pub fn windrow_vulkan_ground_walkers_left_out(ground: *const c_void) -> i32;
    pub fn windrow_vulkan_ground_next_place(
        ground: *const c_void, anchor: DVec3, place: *mut GroundPlaceBlock
    ) -> ResultCode;
    pub fn windrow_vulkan_ground_texture(ground: *const c_void, frame: Frame, texture: *mut VulkanTexture) -> ResultCode;
    pub fn windrow_vulkan_ground_block(ground: *const c_void, anchor: DVec3, block: *mut GroundBlock) -> ResultCode;
    pub fn windrow_vulkan_ground_memory_bytes(ground: *const c_void) -> u64;
    pub fn windrow_vulkan_ground_reserved_bytes(ground: *const c_void) -> u64;
}
