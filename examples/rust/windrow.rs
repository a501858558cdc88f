// Tutorial: the README's ten lines in Rust, with a small wrapper to take along.
//
//     rustc -L FOLDER_OF_THE_LIBRARY -o follow_player windrow.rs
//
// 1. Mirror the structs that you use, with all fields in their order (c_api/config.h, c_api/motors.h); the init functions fill them
//    with defaults.
// 2. `check` makes a Result of what a call returns, with the library's sentence.
// 3. `Wind` destroys its wind when it is dropped.
use std::ffi::CStr;
use std::os::raw::{c_char, c_void};
use std::ptr::null_mut;

#[repr(C)]
#[derive(Clone, Copy)]
struct Vec3(f32, f32, f32);
#[repr(C)]
#[derive(Clone, Copy)]
struct DVec3(f64, f64, f64);

#[repr(C)]
#[derive(Clone, Copy)]
struct Boundary {
    kind: i32,
    wall_velocity: Vec3,
}

#[repr(C)]
#[derive(Clone, Copy)]
struct Boundaries {
    faces: [Boundary; 6],
}

#[repr(C)]
struct Config {
    struct_size: u32,
    cells: [i32; 3],
    cell_size: f32,
    boundaries: Boundaries,
    follow_axes: i32,
    centre: DVec3,
    ambient: Vec3,
    reserved: u32,
    profile: *const c_void,
    gusts: *const c_void,
    canopy: *const c_void,
    roughness: *const c_void,
    rows: *const c_void,
    blend_width: f32,
    viscosity: f32,
    relaxation_time: f32,
    sleep_speed: f32,
    scheme: i32,
    interpolation: i32,
    max_cfl: f32,
    max_substeps: i32,
    pressure_solves: i32,
    stages: u32,
    ticks_hz: f64,
    ticks_max_per_call: i32,
    simd: i32,
    run: *const c_void,
    context: *mut c_void,
}

#[repr(C)]
struct WakeMotor {
    struct_size: u32,
    radius: f32,
    position: DVec3,
    law_kind: i32,
    law: [f32; 3],
    envelope: [f32; 4],
    turbulence: [f32; 2],
    turbulence_seed: u32,
    reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
struct MotorId {
    slot: u32,
    generation: u32,
    owner: u32,
}

#[link(name = "windrow")]
extern "C" {
    fn windrow_last_error() -> *const c_char;
    fn windrow_boundaries_open_over_floor() -> Boundaries;
    fn windrow_config_init(config: *mut Config, size: u32) -> i32;
    fn windrow_wake_motor_init(motor: *mut WakeMotor, size: u32) -> i32;
    fn windrow_wind_create(config: *const Config, wind: *mut *mut c_void) -> i32;
    fn windrow_wind_destroy(wind: *mut c_void);
    fn windrow_wind_follow(wind: *mut c_void, point: DVec3) -> i32;
    fn windrow_wind_add_wake(wind: *mut c_void, motor: *const WakeMotor, id: *mut MotorId) -> i32;
    fn windrow_wind_move_motor(wind: *mut c_void, id: MotorId, position: DVec3) -> i32;
    fn windrow_wind_advance(wind: *mut c_void, dt: f64, advance: *mut c_void, last: *mut c_void) -> i32;
    fn windrow_wind_velocity(wind: *const c_void, position: DVec3, velocity: *mut Vec3) -> i32;
}

fn check(result: i32) -> Result<(), String> {
    if result == 0 {
        return Ok(());
    }
    Err(unsafe { CStr::from_ptr(windrow_last_error()) }.to_string_lossy().into_owned())
}

/// A struct with the library's defaults.
fn defaults<T>(init: unsafe extern "C" fn(*mut T, u32) -> i32) -> Result<T, String> {
    let mut value = std::mem::MaybeUninit::<T>::uninit();
    check(unsafe { init(value.as_mut_ptr(), std::mem::size_of::<T>() as u32) })?;
    Ok(unsafe { value.assume_init() })
}

/// The wind in a box that follows a player.
struct Wind(*mut c_void);

impl Wind {
    fn new(config: &Config) -> Result<Wind, String> {
        let mut wind = null_mut();
        check(unsafe { windrow_wind_create(config, &mut wind) })?;
        Ok(Wind(wind))
    }
    fn add_wake(&mut self, motor: &WakeMotor) -> Result<MotorId, String> {
        let mut id = MotorId { slot: 0, generation: 0, owner: 0 };
        check(unsafe { windrow_wind_add_wake(self.0, motor, &mut id) })?;
        Ok(id)
    }
    fn follow(&mut self, point: DVec3) -> Result<(), String> {
        check(unsafe { windrow_wind_follow(self.0, point) })
    }
    fn move_motor(&mut self, id: MotorId, position: DVec3) -> Result<(), String> {
        check(unsafe { windrow_wind_move_motor(self.0, id, position) })
    }
    fn advance(&mut self, seconds: f64) -> Result<(), String> {
        check(unsafe { windrow_wind_advance(self.0, seconds, null_mut(), null_mut()) })
    }
    fn velocity(&self, position: DVec3) -> Result<Vec3, String> {
        let mut velocity = Vec3(0.0, 0.0, 0.0);
        check(unsafe { windrow_wind_velocity(self.0, position, &mut velocity) })?;
        Ok(velocity)
    }
}

impl Drop for Wind {
    fn drop(&mut self) {
        unsafe { windrow_wind_destroy(self.0) }
    }
}

fn run() -> Result<(), String> {
    let mut config = defaults(windrow_config_init)?;
    config.boundaries = unsafe { windrow_boundaries_open_over_floor() };
    config.ambient = Vec3(3.0, 0.0, 0.0);
    if std::env::args().any(|argument| argument == "wrong") {
        config.cell_size = -1.0; // to see the library's sentence
    }
    let mut wind = Wind::new(&config)?;
    let mut wake = defaults(windrow_wake_motor_init)?;
    wake.position = DVec3(0.0, 0.5, 1.0);
    wake.radius = 0.6;
    let dog = wind.add_wake(&wake)?;
    for frame in 0..60 {
        let frame = f64::from(frame);
        wind.follow(DVec3(frame / 20.0, 1.0, 0.0))?;
        wind.move_motor(dog, DVec3(frame / 8.0, 0.5, 1.0))?;
        wind.advance(1.0 / 60.0)?;
    }
    println!("{:.2} m/s at the leaf", wind.velocity(DVec3(4.0, 0.5, 1.0))?.0);
    Ok(())
}

fn main() {
    if let Err(sentence) = run() {
        eprintln!("{sentence}");
        std::process::exit(2);
    }
}
