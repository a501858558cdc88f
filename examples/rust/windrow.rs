// Tutorial: the README's ten lines in Rust, with a small wrapper to take along.
//
//     rustc -L FOLDER_OF_THE_LIBRARY -o follow_player windrow.rs
//
// 1. windrow_c, beside this file, has all structs, choices and functions of the C headers; the init functions fill a struct with
//    defaults.
// 2. `check` makes a Result of what a call returns, with the library's sentence.
// 3. `Wind` destroys its wind when it is dropped.
use std::ffi::CStr;
use std::os::raw::c_void;
use std::ptr::null_mut;

mod windrow_c;
use windrow_c::*;

fn place(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3 { x, y, z }
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
        let mut velocity = Vec3 { x: 0.0, y: 0.0, z: 0.0 };
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
    config.ambient.x = 3.0;
    if std::env::args().any(|argument| argument == "wrong") {
        config.cell_size = -1.0; // to see the library's sentence
    }
    let mut wind = Wind::new(&config)?;
    let mut wake = defaults(windrow_wake_motor_init)?;
    wake.position = place(0.0, 0.5, 1.0);
    wake.radius = 0.6;
    let dog = wind.add_wake(&wake)?;
    for frame in 0..60 {
        let frame = f64::from(frame);
        wind.follow(place(frame / 20.0, 1.0, 0.0))?;
        wind.move_motor(dog, place(frame / 8.0, 0.5, 1.0))?;
        wind.advance(1.0 / 60.0)?;
    }
    println!("{:.2} m/s at the leaf", wind.velocity(place(4.0, 0.5, 1.0))?.x);
    Ok(())
}

fn main() {
    if let Err(sentence) = run() {
        eprintln!("{sentence}");
        std::process::exit(2);
    }
}
