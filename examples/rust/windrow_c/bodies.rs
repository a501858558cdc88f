// Made by ./dev schema from the headers of c_api, where units, ranges and defaults are. Do not edit.
#![allow(dead_code, unused_imports)]
use super::air::*;
use std::mem::size_of;
use std::os::raw::{c_char, c_void};

pub type RegionKind = i32; pub const REGION_SPHERE: RegionKind = 0; pub const REGION_CAPSULE: RegionKind = 1;
pub const REGION_BOX: RegionKind = 2; pub const REGION_CONE: RegionKind = 3;
pub type LawKind = i32; pub const LAW_FORCE: LawKind = 0; pub const LAW_DRIVE: LawKind = 1;
pub type MotorKind = i32; pub const MOTOR_DIRECTIONAL: MotorKind = 0; pub const MOTOR_WAKE: MotorKind = 1;
pub const MOTOR_JET: MotorKind = 2; pub const MOTOR_VORTEX: MotorKind = 3; pub const MOTOR_OMNI: MotorKind = 4;
pub const MOTOR_PRESSURE: MotorKind = 5;
pub type ShapeKind = i32; pub const SHAPE_SPHERE: ShapeKind = 0; pub const SHAPE_CAPSULE: ShapeKind = 1;
pub const SHAPE_BLOCK: ShapeKind = 2; pub const SHAPE_CYLINDER: ShapeKind = 3; pub const SHAPE_PLATE: ShapeKind = 4;
pub const SHAPE_MESH: ShapeKind = 5; pub const SHAPE_VOXELS: ShapeKind = 6; pub const SHAPE_GROUND: ShapeKind = 7;
pub type Beyond = i32; pub const BEYOND_EDGE: Beyond = 0; pub const BEYOND_NOTHING: Beyond = 1;
pub type Surface = i32; pub const SURFACE_FREE_SLIP: Surface = 0; pub const SURFACE_NO_SLIP: Surface = 1;
pub type DragKind = i32; pub const DRAG_PLANT: DragKind = 0; pub const DRAG_BELT: DragKind = 1;


#[repr(C)]
#[derive(Clone, Copy)]
pub struct MotorId {
    pub slot: u32, pub generation: u32, pub owner: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Region {
    pub kind: RegionKind, pub radius: f32, pub half_axis: Vec3, pub half_size: Vec3, pub axis: Vec3,
    pub start_radius: f32, pub end_radius: f32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Law {
    pub kind: LawKind, pub acceleration: f32, pub speed: f32, pub rate: f32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct WakeLaw {
    pub kind: LawKind, pub strength: f32, pub per_metre: f32, pub entrainment: f32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Envelope {
    pub attack: f32, pub hold: f32, pub decay: f32, pub delay: f32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Turbulence {
    pub intensity: f32, pub length: f32, pub seed: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct DirectionalMotor {
    pub struct_size: u32, pub direction: Vec3, pub position: DVec3, pub region: Region, pub law: Law,
    pub envelope: Envelope, pub turbulence: Turbulence,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct WakeMotor {
    pub struct_size: u32, pub radius: f32, pub position: DVec3, pub law: WakeLaw, pub envelope: Envelope,
    pub turbulence: Turbulence, pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct JetMotor {
    pub struct_size: u32, pub direction: Vec3, pub position: DVec3, pub length: f32, pub start_radius: f32,
    pub end_radius: f32, pub law: Law, pub envelope: Envelope, pub turbulence: Turbulence,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct VortexMotor {
    pub struct_size: u32, pub axis: Vec3, pub position: DVec3, pub radius: f32, pub half_length: f32, pub lift: f32,
    pub law: Law, pub envelope: Envelope, pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct OmniMotor {
    pub struct_size: u32, pub radius: f32, pub position: DVec3, pub speed: f32, pub envelope: Envelope,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct PressureMotor {
    pub struct_size: u32, pub radius: f32, pub position: DVec3, pub speed: f32, pub duration: f32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Shape {
    pub kind: ShapeKind, pub radius: f32, pub half_length: f32, pub cell_size: f32, pub half_size: Vec3,
    pub half_axis: Vec3, pub scale: Vec3, pub beyond: Beyond, pub mesh: *const c_void, pub voxels: *const c_void,
    pub heights: *const c_void,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Obstacle {
    pub struct_size: u32, pub surface: Surface, pub position: DVec3, pub orientation: Quat, pub shape: Shape,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct ObstacleId {
    pub slot: u32, pub generation: u32, pub owner: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct ObstacleForce {
    pub struct_size: u32, pub force: Vec3, pub moment: Vec3, pub pressure: f32, pub in_box: i32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct DragId {
    pub slot: u32, pub generation: u32, pub owner: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct PlantDrag {
    pub struct_size: u32, pub radius: f32, pub position: DVec3, pub base: f32, pub height: f32, pub area: f32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct BeltDrag {
    pub struct_size: u32, pub width: f32, pub start: DVec3, pub end: DVec3, pub height: f32, pub resistance: f32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct DragForce {
    pub struct_size: u32, pub force: Vec3, pub in_box: f32,
}

#[cfg(target_pointer_width = "64")]
const _: () = {
    assert!(size_of::<MotorId>() == 12); assert!(size_of::<Region>() == 52); assert!(size_of::<Law>() == 16);
    assert!(size_of::<WakeLaw>() == 16); assert!(size_of::<Envelope>() == 16); assert!(size_of::<Turbulence>() == 12);
    assert!(size_of::<DirectionalMotor>() == 136); assert!(size_of::<WakeMotor>() == 80);
    assert!(size_of::<JetMotor>() == 96); assert!(size_of::<VortexMotor>() == 88);
    assert!(size_of::<OmniMotor>() == 56); assert!(size_of::<PressureMotor>() == 40); assert!(size_of::<Shape>() == 80);
    assert!(size_of::<Obstacle>() == 128); assert!(size_of::<ObstacleId>() == 12);
    assert!(size_of::<ObstacleForce>() == 36); assert!(size_of::<DragId>() == 12);
    assert!(size_of::<PlantDrag>() == 48); assert!(size_of::<BeltDrag>() == 64); assert!(size_of::<DragForce>() == 20);
};

#[link(name = "windrow")]
extern "C" {
    pub fn windrow_region_sphere(radius: f32) -> Region;
    pub fn windrow_region_capsule(half_axis: Vec3, radius: f32) -> Region;
    pub fn windrow_region_box(half_size: Vec3) -> Region;
    pub fn windrow_region_cone(axis: Vec3, start_radius: f32, end_radius: f32) -> Region;
    pub fn windrow_law_force(acceleration: f32) -> Law;
    pub fn windrow_law_drive(speed: f32, rate: f32) -> Law;
    pub fn windrow_wake_law_force(strength: f32) -> WakeLaw;
    pub fn windrow_wake_law_drive(per_metre: f32, entrainment: f32) -> WakeLaw;
    pub fn windrow_directional_motor_init(motor: *mut DirectionalMotor, struct_size: u32) -> ResultCode;
    pub fn windrow_wake_motor_init(motor: *mut WakeMotor, struct_size: u32) -> ResultCode;
    pub fn windrow_jet_motor_init(motor: *mut JetMotor, struct_size: u32) -> ResultCode;
    pub fn windrow_vortex_motor_init(motor: *mut VortexMotor, struct_size: u32) -> ResultCode;
    pub fn windrow_omni_motor_init(motor: *mut OmniMotor, struct_size: u32) -> ResultCode;
    pub fn windrow_pressure_motor_init(motor: *mut PressureMotor, struct_size: u32) -> ResultCode;
    pub fn windrow_wind_add_directional(
        wind: *mut c_void, motor: *const DirectionalMotor, id: *mut MotorId
    ) -> ResultCode;
    pub fn windrow_wind_add_wake(wind: *mut c_void, motor: *const WakeMotor, id: *mut MotorId) -> ResultCode;
    pub fn windrow_wind_add_jet(wind: *mut c_void, motor: *const JetMotor, id: *mut MotorId) -> ResultCode;
    pub fn windrow_wind_add_vortex(wind: *mut c_void, motor: *const VortexMotor, id: *mut MotorId) -> ResultCode;
    pub fn windrow_wind_add_omni(wind: *mut c_void, motor: *const OmniMotor, id: *mut MotorId) -> ResultCode;
    pub fn windrow_wind_add_pressure(wind: *mut c_void, motor: *const PressureMotor, id: *mut MotorId) -> ResultCode;
    pub fn windrow_wind_set_directional(wind: *mut c_void, id: MotorId, motor: *const DirectionalMotor) -> ResultCode;
    pub fn windrow_wind_set_wake(wind: *mut c_void, id: MotorId, motor: *const WakeMotor) -> ResultCode;
    pub fn windrow_wind_set_jet(wind: *mut c_void, id: MotorId, motor: *const JetMotor) -> ResultCode;
    pub fn windrow_wind_set_vortex(wind: *mut c_void, id: MotorId, motor: *const VortexMotor) -> ResultCode;
    pub fn windrow_wind_set_omni(wind: *mut c_void, id: MotorId, motor: *const OmniMotor) -> ResultCode;
    pub fn windrow_wind_set_pressure(wind: *mut c_void, id: MotorId, motor: *const PressureMotor) -> ResultCode;
    pub fn windrow_wind_get_directional(wind: *const c_void, id: MotorId, motor: *mut DirectionalMotor) -> ResultCode;
    pub fn windrow_wind_get_wake(wind: *const c_void, id: MotorId, motor: *mut WakeMotor) -> ResultCode;
    pub fn windrow_wind_get_jet(wind: *const c_void, id: MotorId, motor: *mut JetMotor) -> ResultCode;
    pub fn windrow_wind_get_vortex(wind: *const c_void, id: MotorId, motor: *mut VortexMotor) -> ResultCode;
    pub fn windrow_wind_get_omni(wind: *const c_void, id: MotorId, motor: *mut OmniMotor) -> ResultCode;
    pub fn windrow_wind_get_pressure(wind: *const c_void, id: MotorId, motor: *mut PressureMotor) -> ResultCode;
    pub fn windrow_wind_motor_kind(wind: *const c_void, id: MotorId, kind: *mut MotorKind) -> ResultCode;
    pub fn windrow_wind_move_motor(wind: *mut c_void, id: MotorId, position: DVec3) -> ResultCode;
    pub fn windrow_wind_remove_motor(wind: *mut c_void, id: MotorId) -> ResultCode;
    pub fn windrow_wind_motor_count(wind: *const c_void) -> i32;
    pub fn windrow_mesh_create(
        vertices: *const Vec3, vertex_count: u64, indices: *const u32, triangle_count: u64, mesh: *mut *mut c_void
    ) -> ResultCode;
    pub fn windrow_mesh_destroy(mesh: *mut c_void);
    pub fn windrow_mesh_save(mesh: *const c_void, bytes: *mut *mut c_void) -> ResultCode;
    pub fn windrow_mesh_load(bytes: *const c_void, size: u64, mesh: *mut *mut c_void) -> ResultCode;
    pub fn windrow_mesh_distance(mesh: *const c_void, point: Vec3) -> f32;
    pub fn windrow_voxels_create(cells: IVec3, closed: *const u8, count: u64, voxels: *mut *mut c_void) -> ResultCode;
    pub fn windrow_voxels_destroy(voxels: *mut c_void);
    pub fn windrow_height_map_create(
        corners: IVec2, spacing: f32, heights: *const f32, count: u64, map: *mut *mut c_void
    ) -> ResultCode;
    pub fn windrow_height_map_create_with_holes(
        corners: IVec2, spacing: f32, heights: *const f32, count: u64, cells: IVec2, open: *const u8, cell_count: u64,
        map: *mut *mut c_void
    ) -> ResultCode;
    pub fn windrow_height_map_destroy(map: *mut c_void);
    pub fn windrow_height_map_height(map: *const c_void, place: Vec2) -> f32;
    pub fn windrow_height_map_normal(map: *const c_void, place: Vec2) -> Vec3;
    pub fn windrow_shape_sphere(radius: f32) -> Shape;
    pub fn windrow_shape_capsule(half_axis: Vec3, radius: f32) -> Shape;
    pub fn windrow_shape_block(half_size: Vec3) -> Shape;
    pub fn windrow_shape_cylinder(radius: f32, half_length: f32) -> Shape;
    pub fn windrow_shape_plate(half_size: Vec2) -> Shape;
    pub fn windrow_shape_mesh(mesh: *const c_void, scale: f32) -> Shape;
    pub fn windrow_shape_voxels(voxels: *const c_void, cell_size: f32) -> Shape;
    pub fn windrow_shape_ground(heights: *const c_void, scale: Vec3) -> Shape;
    pub fn windrow_obstacle_init(obstacle: *mut Obstacle, struct_size: u32) -> ResultCode;
    pub fn windrow_wind_add_obstacle(wind: *mut c_void, obstacle: *const Obstacle, id: *mut ObstacleId) -> ResultCode;
    pub fn windrow_wind_set_obstacle(wind: *mut c_void, id: ObstacleId, obstacle: *const Obstacle) -> ResultCode;
    pub fn windrow_wind_get_obstacle(wind: *const c_void, id: ObstacleId, obstacle: *mut Obstacle) -> ResultCode;
    pub fn windrow_wind_move_obstacle(
        wind: *mut c_void, id: ObstacleId, position: DVec3, orientation: *const Quat, spin: *const Vec3
    ) -> ResultCode;
    pub fn windrow_wind_remove_obstacle(wind: *mut c_void, id: ObstacleId) -> ResultCode;
    pub fn windrow_wind_obstacle_count(wind: *const c_void) -> i32;
    pub fn windrow_obstacle_force_init(force: *mut ObstacleForce, struct_size: u32) -> ResultCode;
    pub fn windrow_wind_force_on(wind: *const c_void, id: ObstacleId, force: *mut ObstacleForce) -> ResultCode;
    pub fn windrow_plant_drag_init(plant: *mut PlantDrag, struct_size: u32) -> ResultCode;
    pub fn windrow_belt_drag_init(belt: *mut BeltDrag, struct_size: u32) -> ResultCode;
    pub fn windrow_wind_add_plant_drag(wind: *mut c_void, plant: *const PlantDrag, id: *mut DragId) -> ResultCode;
    pub fn windrow_wind_add_belt_drag(wind: *mut c_void, belt: *const BeltDrag, id: *mut DragId) -> ResultCode;
    pub fn windrow_wind_add_plants(
        wind: *mut c_void, plants: *const PlantDrag, count: u64, ids: *mut DragId
    ) -> ResultCode;
    pub fn windrow_wind_set_plant_drag(wind: *mut c_void, id: DragId, plant: *const PlantDrag) -> ResultCode;
    pub fn windrow_wind_set_belt_drag(wind: *mut c_void, id: DragId, belt: *const BeltDrag) -> ResultCode;
    pub fn windrow_wind_get_plant_drag(wind: *const c_void, id: DragId, plant: *mut PlantDrag) -> ResultCode;
    pub fn windrow_wind_get_belt_drag(wind: *const c_void, id: DragId, belt: *mut BeltDrag) -> ResultCode;
    pub fn windrow_wind_drag_kind(wind: *const c_void, id: DragId, kind: *mut DragKind) -> ResultCode;
    pub fn windrow_wind_remove_drag(wind: *mut c_void, id: DragId) -> ResultCode;
    pub fn windrow_wind_drag_count(wind: *const c_void) -> i32;
    pub fn windrow_drag_force_init(force: *mut DragForce, struct_size: u32) -> ResultCode;
    pub fn windrow_wind_drag_force_on(wind: *const c_void, id: DragId, force: *mut DragForce) -> ResultCode;
}
