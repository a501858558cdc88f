// Made by ./dev schema from the headers of c_api, where units, ranges and defaults are. Do not edit.
#![allow(dead_code, unused_imports)]
use super::air::*;
use super::bodies::*;
use std::mem::size_of;
use std::os::raw::{c_char, c_void};



#[repr(C)]
#[derive(Clone, Copy)]
pub struct Transport {
    pub struct_size: u32, pub dt: f32, pub carried: *const Vec4, pub velocity: *const Vec4,
    pub velocity_old: *const Vec4, pub history: *const Vec4, pub history_scale: f32, pub extrapolation: f32,
    pub relaxation: f32, pub interpolation: Interpolation,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct ScalarTransport {
    pub struct_size: u32, pub dt: f32, pub carried: *const f32, pub velocity: *const Vec4, pub outside: f32,
    pub clamped: i32, pub interpolation: Interpolation, pub reserved: u32,
}

#[cfg(target_pointer_width = "64")]
const _: () = {
    assert!(size_of::<Transport>() == 56); assert!(size_of::<ScalarTransport>() == 40);
};

#[link(name = "windrow")]
extern "C" {
    pub fn windrow_workspace_create(config: *const Config, work: *mut *mut c_void) -> ResultCode;
    pub fn windrow_workspace_destroy(work: *mut c_void);
    pub fn windrow_workspace_cell_count(work: *const c_void) -> u64;
    pub fn windrow_workspace_memory_bytes(work: *const c_void) -> u64;
    pub fn windrow_workspace_set_boundaries(work: *mut c_void, boundaries: *const Boundaries) -> ResultCode;
    pub fn windrow_workspace_set_ambient(work: *mut c_void, ambient: Vec3) -> ResultCode;
    pub fn windrow_workspace_set_obstacles(
        work: *mut c_void, obstacles: *const Obstacle, velocities: *const Vec3, spins: *const Vec3, count: u64
    ) -> ResultCode;
    pub fn windrow_workspace_impulse_on(work: *const c_void, obstacle: u64, impulse: *mut Vec3) -> ResultCode;
    pub fn windrow_transport_init(transport: *mut Transport, struct_size: u32) -> ResultCode;
    pub fn windrow_advect(work: *mut c_void, transport: *const Transport, result: *mut Vec4, count: u64) -> ResultCode;
    pub fn windrow_scalar_transport_init(transport: *mut ScalarTransport, struct_size: u32) -> ResultCode;
    pub fn windrow_advect_scalar(
        work: *mut c_void, transport: *const ScalarTransport, result: *mut f32, count: u64
    ) -> ResultCode;
    pub fn windrow_diffuse(
        work: *mut c_void, field: *const Vec4, viscosity: f32, dt: f32, result: *mut Vec4, method: *mut DiffusionMethod,
        count: u64
    ) -> ResultCode;
    pub fn windrow_workspace_reserve_diffusion(work: *mut c_void) -> ResultCode;
    pub fn windrow_divergence(work: *mut c_void, velocity: *const Vec4, result: *mut f32, count: u64) -> ResultCode;
    pub fn windrow_solve_poisson(work: *mut c_void, rhs_then_phi: *mut f32, count: u64) -> ResultCode;
    pub fn windrow_project(
        work: *mut c_void, velocity: *mut Vec4, gradient: *mut Vec4, expansion: *const f32, count: u64
    ) -> ResultCode;
    pub fn windrow_scene_load(
        path: *const c_char, parallel_for: *const ParallelFor, scene: *mut *mut c_void
    ) -> ResultCode;
    pub fn windrow_scene_parse(
        text: *const c_char, size: u64, path: *const c_char, parallel_for: *const ParallelFor, scene: *mut *mut c_void
    ) -> ResultCode;
    pub fn windrow_scene_destroy(scene: *mut c_void);
    pub fn windrow_scene_wind(scene: *mut c_void) -> *mut c_void;
    pub fn windrow_scene_outer_count(scene: *const c_void) -> i32;
    pub fn windrow_scene_outer_wind(scene: *mut c_void, place: i32) -> *mut c_void;
    pub fn windrow_wind_write_scene(wind: *const c_void, path: *const c_char, duration: f64, tick_hz: f64) -> ResultCode;
    pub fn windrow_scene_step(scene: *mut c_void, diagnostics: *mut Diagnostics) -> ResultCode;
    pub fn windrow_scene_advance(scene: *mut c_void, dt: f64, advance: *mut Advance) -> ResultCode;
    pub fn windrow_scene_time(scene: *const c_void) -> f64;
    pub fn windrow_scene_duration(scene: *const c_void) -> f64;
    pub fn windrow_scene_frames_per_second(scene: *const c_void) -> f64;
    pub fn windrow_scene_motor_count(scene: *const c_void) -> i32;
    pub fn windrow_scene_motor_name(scene: *const c_void, place: i32) -> *const c_char;
    pub fn windrow_scene_obstacle_count(scene: *const c_void) -> i32;
    pub fn windrow_scene_obstacle_name(scene: *const c_void, place: i32) -> *const c_char;
    pub fn windrow_scene_motor(scene: *const c_void, name: *const c_char, id: *mut MotorId) -> ResultCode;
    pub fn windrow_scene_obstacle(scene: *const c_void, name: *const c_char, id: *mut ObstacleId) -> ResultCode;
    pub fn windrow_scene_save(scene: *const c_void, bytes: *mut *mut c_void) -> ResultCode;
    pub fn windrow_scene_restore(scene: *mut c_void, bytes: *const c_void, size: u64) -> ResultCode;
}
