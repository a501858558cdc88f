// Made by ./dev schema from the headers of c_api, where units, ranges and defaults are. Do not edit.
#![allow(dead_code, unused_imports)]
use super::air::*;
use super::bodies::*;
use super::operators::*;
use std::mem::size_of;
use std::os::raw::{c_char, c_void};

pub type Plant = i32; pub const PLANT_GRASS: Plant = 0; pub const PLANT_WHEAT: Plant = 1;
pub const PLANT_REED: Plant = 2; pub const PLANT_LEAF: Plant = 3; pub const PLANT_TWIG: Plant = 4;
pub const PLANT_BRANCH: Plant = 5; pub const PLANT_SMALL_TRUNK: Plant = 6; pub const PLANT_LARGE_TRUNK: Plant = 7;
pub type SpringPlant = i32; pub const SPRING_GRASS: SpringPlant = 0; pub const SPRING_WHEAT: SpringPlant = 1;
pub const SPRING_ALFALFA: SpringPlant = 2; pub const SPRING_REED: SpringPlant = 3;
pub const SPRING_LEAF: SpringPlant = 4; pub const SPRING_TWIG: SpringPlant = 5;
pub const SPRING_BRANCH: SpringPlant = 6; pub const SPRING_TRUNK: SpringPlant = 7;


#[repr(C)]
#[derive(Clone, Copy)]
pub struct Drag {
    pub struct_size: u32, pub length: f32, pub width: f32, pub rigidity: f32, pub drag_coefficient: f32,
    pub air_density: f32, pub vogel_exponent: f32, pub vogel_speed: f32, pub max_bend: f32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct PlantVertex {
    pub position: Vec3, pub normal: Vec3, pub tangent: Vec3,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct BladeSettings {
    pub struct_size: u32, pub reserved: u32, pub stalk: *const Drag, pub length_spread: f32, pub width: f32,
    pub tip_width: f32, pub taper: f32, pub along_wind: f32, pub stiffness_spread: f32, pub rest_bend: f32,
    pub rest_bend_spread: f32, pub rest_curve: f32, pub view_bend: f32, pub twist: f32, pub reserved_2: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct ShellSettings {
    pub struct_size: u32, pub shells: i32, pub reaches_tip: i32, pub length: f32, pub spacing: f32, pub bias: f32,
    pub push: f32, pub push_exponent: f32, pub droop: f32, pub droop_shape: f32, pub sag: f32, pub down: Vec3,
    pub strand: *const Drag,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Skin {
    pub count: u64, pub positions: *const Vec4, pub normals: *const Vec4,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct TreeClasses {
    pub struct_size: u32, pub reserved: u32, pub trunk: *const Drag, pub branch: *const Drag, pub leaf: *const Drag,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct TreePart {
    pub root: Vec3, pub axis: Vec3, pub length: f32, pub stiffness: f32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct TreeBearers {
    pub trunk: u32, pub branch: u32, pub leaf: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct SpringClass {
    pub frequency_hz: f64, pub damping: f64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct SpringStep {
    pub place_place: f64, pub place_velocity: f64, pub place_target: f64, pub velocity_place: f64,
    pub velocity_velocity: f64, pub velocity_target: f64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct FlutterClass {
    pub frequency_hz: f64, pub most: f32, pub onset: f32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct SpringBatch {
    pub count: u64, pub place: *mut c_void, pub velocity: *mut c_void, pub target_before: *const c_void,
    pub target_now: *const c_void, pub place_remainder: *mut c_void, pub velocity_remainder: *mut c_void,
    pub place_previous: *mut c_void,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct CascadeBatch {
    pub rows: u64, pub value: *mut c_void, pub body_before: *const c_void, pub body_now: *const c_void,
    pub remainder: *mut c_void,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Pose {
    pub position: DVec3, pub rotation: DVec4, pub scale: f64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct CascadeConfig {
    pub struct_size: u32, pub stages: i32, pub lag: f64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct GroundConfig {
    pub struct_size: u32, pub texels: i32, pub spring: SpringClass, pub texel_size: f32, pub push: f32,
    pub trail_fraction: f32, pub trail_time: f32, pub trample_time: f32, pub clearance: f32, pub blend_width: f32,
    pub jump_speed: f32, pub max_walkers: i32, pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct GroundWalker {
    pub position: DVec3, pub previous: DVec3, pub foot_height: f32, pub previous_foot_height: f32, pub radius: f32,
    pub weight: f32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct GroundStep {
    pub struct_size: u32, pub wind_lean: Vec2, pub reserved: u32, pub duration: f64, pub walker_count: u64,
    pub walkers: *const GroundWalker,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct GroundSample {
    pub lean: Vec2, pub trample: f32, pub trail: f32,
}

#[cfg(target_pointer_width = "64")]
const _: () = {
    assert!(size_of::<Drag>() == 36); assert!(size_of::<PlantVertex>() == 36);
    assert!(size_of::<BladeSettings>() == 64); assert!(size_of::<ShellSettings>() == 64);
    assert!(size_of::<Skin>() == 24); assert!(size_of::<TreeClasses>() == 32); assert!(size_of::<TreePart>() == 32);
    assert!(size_of::<TreeBearers>() == 12); assert!(size_of::<SpringClass>() == 16);
    assert!(size_of::<SpringStep>() == 48); assert!(size_of::<FlutterClass>() == 16);
    assert!(size_of::<SpringBatch>() == 64); assert!(size_of::<CascadeBatch>() == 40); assert!(size_of::<Pose>() == 64);
    assert!(size_of::<CascadeConfig>() == 16); assert!(size_of::<GroundConfig>() == 64);
    assert!(size_of::<GroundWalker>() == 64); assert!(size_of::<GroundStep>() == 40);
    assert!(size_of::<GroundSample>() == 16);
};

#[link(name = "windrow")]
extern "C" {
    pub fn windrow_drag_init(drag: *mut Drag, struct_size: u32) -> ResultCode;
    pub fn windrow_drag_of(plant: Plant, drag: *mut Drag) -> ResultCode;
    pub fn windrow_drag_validate(drag: *const Drag) -> ResultCode;
    pub fn windrow_drag_block_of(drag: *const Drag, block: *mut DragBlock) -> ResultCode;
    pub fn windrow_cauchy_number(drag: *const Drag, speed: f64, number: *mut f64) -> ResultCode;
    pub fn windrow_bend_angle(drag: *const Drag, speed: f32, angle: *mut f32) -> ResultCode;
    pub fn windrow_rectangle_rigidity(young: f32, width: f32, thickness: f32) -> f32;
    pub fn windrow_folded_rigidity(young: f32, width: f32, thickness: f32, depth: f32) -> f32;
    pub fn windrow_rod_rigidity(young: f32, diameter: f32) -> f32;
    pub fn windrow_tube_rigidity(young: f32, outer_diameter: f32, inner_diameter: f32) -> f32;
    pub fn windrow_place_key(x: f32, z: f32) -> UVec2;
    pub fn windrow_plant_yaw(key: UVec2) -> f32;
    pub fn windrow_plant_stiffness(key: UVec2, spread: f32) -> f32;
    pub fn windrow_blade_settings_init(settings: *mut BladeSettings, struct_size: u32) -> ResultCode;
    pub fn windrow_blades_create(settings: *const BladeSettings, blades: *mut *mut c_void) -> ResultCode;
    pub fn windrow_blades_destroy(blades: *mut c_void);
    pub fn windrow_blades_block(blades: *const c_void, block: *mut BladeBlock) -> ResultCode;
    pub fn windrow_blades_length(blades: *const c_void, key: UVec2) -> f32;
    pub fn windrow_blades_load(blades: *const c_void, key: UVec2, wind: Vec3) -> Vec3;
    pub fn windrow_blades_vertex(
        blades: *const c_void, key: UVec2, load: Vec3, h: f32, side: f32, view: Vec3, vertex: *mut PlantVertex
    ) -> ResultCode;
    pub fn windrow_blades_loads(
        blades: *const c_void, count: u64, keys: *const UVec2, winds: *const Vec4, loads: *mut Vec4,
        parallel_for: *const ParallelFor
    ) -> ResultCode;
    pub fn windrow_blades_vertices(
        blades: *const c_void, count: u64, keys: *const UVec2, roots: *const Vec4, loads: *const Vec4, rows: u64,
        heights: *const f32, view: Vec3, positions: *mut Vec4, normals: *mut Vec4, parallel_for: *const ParallelFor
    ) -> ResultCode;
    pub fn windrow_shell_settings_init(settings: *mut ShellSettings, struct_size: u32) -> ResultCode;
    pub fn windrow_shells_create(settings: *const ShellSettings, shells: *mut *mut c_void) -> ResultCode;
    pub fn windrow_shells_destroy(shells: *mut c_void);
    pub fn windrow_shells_block(shells: *const c_void, block: *mut ShellBlock) -> ResultCode;
    pub fn windrow_shells_height(shells: *const c_void, shell: i32) -> f32;
    pub fn windrow_shells_load(shells: *const c_void, normal: Vec3, map: f32, wind: Vec3) -> Vec3;
    pub fn windrow_shells_bent(
        shells: *const c_void, position: Vec3, normal: Vec3, h: f32, map: f32, load: Vec3
    ) -> Vec3;
    pub fn windrow_shells_translated(
        shells: *const c_void, position: Vec3, normal: Vec3, h: f32, map: f32, direction: Vec3
    ) -> Vec3;
    pub fn windrow_shells_loads_many(
        shells: *const c_void, skin: *const Skin, winds: *const Vec4, loads: *mut Vec4, parallel_for: *const ParallelFor
    ) -> ResultCode;
    pub fn windrow_shells_bent_many(
        shells: *const c_void, skin: *const Skin, h: f32, loads: *const Vec4, positions: *mut Vec4,
        parallel_for: *const ParallelFor
    ) -> ResultCode;
    pub fn windrow_shells_translated_many(
        shells: *const c_void, skin: *const Skin, h: f32, directions: *const Vec4, positions: *mut Vec4,
        parallel_for: *const ParallelFor
    ) -> ResultCode;
    pub fn windrow_tree_classes_init(classes: *mut TreeClasses, struct_size: u32) -> ResultCode;
    pub fn windrow_tree_create(classes: *const TreeClasses, tree: *mut *mut c_void) -> ResultCode;
    pub fn windrow_tree_destroy(tree: *mut c_void);
    pub fn windrow_tree_block_of(tree: *const c_void, block: *mut TreeBlock) -> ResultCode;
    pub fn windrow_tree_vertex(
        tree: *const c_void, trunk: *const TreePart, branch: *const TreePart, leaf: *const TreePart, wind: Vec3,
        rest: *const PlantVertex, bent: *mut PlantVertex
    ) -> ResultCode;
    pub fn windrow_tree_vertices(
        tree: *const c_void, part_count: u64, parts: *const TreePart, winds: *const Vec4, count: u64,
        rest_positions: *const Vec4, rest_normals: *const Vec4, bearers: *const TreeBearers, positions: *mut Vec4,
        normals: *mut Vec4, parallel_for: *const ParallelFor
    ) -> ResultCode;
    pub fn windrow_spring_class_of(plant: SpringPlant, spring: *mut SpringClass) -> ResultCode;
    pub fn windrow_spring_step_make(spring: *const SpringClass, duration: f64, step: *mut SpringStep) -> ResultCode;
    pub fn windrow_spring_step_block(step: *const SpringStep, block: *mut SpringBlock) -> ResultCode;
    pub fn windrow_swing_step_make(spring: *const SpringClass, duration: f64, block: *mut SwingBlock) -> ResultCode;
    pub fn windrow_spring_bands(spring: *const SpringClass, bands: *mut SpringClass) -> ResultCode;
    pub fn windrow_swing_steps_make(spring: *const SpringClass, duration: f64, blocks: *mut SwingBlock) -> ResultCode;
    pub fn windrow_flutter_step_make(
        flutter: *const FlutterClass, time: f64, duration: f64, block: *mut FlutterBlock
    ) -> ResultCode;
    pub fn windrow_springs_advance_float(
        step: *const SpringStep, batch: *const SpringBatch, parallel_for: *const ParallelFor
    ) -> ResultCode;
    pub fn windrow_springs_advance_double(
        step: *const SpringStep, batch: *const SpringBatch, parallel_for: *const ParallelFor
    ) -> ResultCode;
    pub fn windrow_cascade_step_create(stages: i32, step: *mut *mut c_void) -> ResultCode;
    pub fn windrow_cascade_step_destroy(step: *mut c_void);
    pub fn windrow_cascade_step_set(step: *mut c_void, rate: f64, duration: f64) -> ResultCode;
    pub fn windrow_cascades_advance_float(
        step: *const c_void, batch: *const CascadeBatch, parallel_for: *const ParallelFor
    ) -> ResultCode;
    pub fn windrow_cascades_advance_double(
        step: *const c_void, batch: *const CascadeBatch, parallel_for: *const ParallelFor
    ) -> ResultCode;
    pub fn windrow_cascade_config_init(config: *mut CascadeConfig, struct_size: u32) -> ResultCode;
    pub fn windrow_cascade_create(
        config: *const CascadeConfig, body: *const Pose, cascade: *mut *mut c_void
    ) -> ResultCode;
    pub fn windrow_cascade_destroy(cascade: *mut c_void);
    pub fn windrow_cascade_save(cascade: *const c_void, bytes: *mut *mut c_void) -> ResultCode;
    pub fn windrow_cascade_load(bytes: *const c_void, size: u64, cascade: *mut *mut c_void) -> ResultCode;
    pub fn windrow_cascade_advance(cascade: *mut c_void, duration: f64, body: *const Pose) -> ResultCode;
    pub fn windrow_cascade_reset(cascade: *mut c_void, body: *const Pose) -> ResultCode;
    pub fn windrow_cascade_move(cascade: *mut c_void, offset: DVec3) -> ResultCode;
    pub fn windrow_cascade_at(cascade: *const c_void, height: f64, pose: *mut Pose) -> ResultCode;
    pub fn windrow_cascade_previous_at(cascade: *const c_void, height: f64, pose: *mut Pose) -> ResultCode;
    pub fn windrow_cascade_shader_poses(
        cascade: *mut c_void, anchor: DVec3, poses: *mut *const PoseBlock, count: *mut u64
    ) -> ResultCode;
    pub fn windrow_cascade_previous_shader_poses(
        cascade: *mut c_void, anchor: DVec3, poses: *mut *const PoseBlock, count: *mut u64
    ) -> ResultCode;
    pub fn windrow_ground_config_init(config: *mut GroundConfig, struct_size: u32) -> ResultCode;
    pub fn windrow_ground_step_init(step: *mut GroundStep, struct_size: u32) -> ResultCode;
    pub fn windrow_ground_create(
        config: *const GroundConfig, parallel_for: *const ParallelFor, ground: *mut *mut c_void
    ) -> ResultCode;
    pub fn windrow_ground_destroy(ground: *mut c_void);
    pub fn windrow_ground_save(ground: *const c_void, bytes: *mut *mut c_void) -> ResultCode;
    pub fn windrow_ground_load(
        bytes: *const c_void, size: u64, parallel_for: *const ParallelFor, ground: *mut *mut c_void
    ) -> ResultCode;
    pub fn windrow_ground_follow(ground: *mut c_void, point: DVec3) -> ResultCode;
    pub fn windrow_ground_shift_origin(ground: *mut c_void, offset: DVec3) -> ResultCode;
    pub fn windrow_ground_advance(
        ground: *mut c_void, step: *const GroundStep, wind_leans: *const Vec2, count: u64
    ) -> ResultCode;
    pub fn windrow_ground_walkers_left_out(ground: *const c_void) -> i32;
    pub fn windrow_ground_next_centre(ground: *const c_void, slot: IVec2) -> DVec2;
    pub fn windrow_ground_at(ground: *const c_void, position: DVec3, sample: *mut GroundSample) -> ResultCode;
    pub fn windrow_ground_previous_at(ground: *const c_void, position: DVec3, sample: *mut GroundSample) -> ResultCode;
    pub fn windrow_ground_texels(ground: *const c_void, count: *mut u64) -> *const Vec4;
    pub fn windrow_ground_previous_texels(ground: *const c_void, count: *mut u64) -> *const Vec4;
    pub fn windrow_ground_block_of(ground: *const c_void, anchor: DVec3, block: *mut GroundBlock) -> ResultCode;
}
