// The story of story_test.py in Rust.
use std::ffi::CStr;
use std::ptr::null_mut;

#[path = "../../../examples/rust/windrow_c/mod.rs"]
#[allow(dead_code)]
mod windrow_c;
use windrow_c::*;

fn check(result: i32) {
    if result != 0 {
        eprintln!("{}", unsafe { CStr::from_ptr(windrow_last_error()) }.to_string_lossy());
        std::process::exit(2);
    }
}

fn defaults<T>(init: unsafe extern "C" fn(*mut T, u32) -> i32) -> T {
    let mut value = std::mem::MaybeUninit::<T>::uninit();
    check(unsafe { init(value.as_mut_ptr(), std::mem::size_of::<T>() as u32) });
    unsafe { value.assume_init() }
}

fn place(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3 { x, y, z }
}

fn main() {
    let mut gusts = defaults(windrow_gusts_init);
    gusts.intensity = 0.2;
    let mut config = defaults(windrow_config_init);
    config.cells = IVec3 { x: 24, y: 12, z: 20 };
    config.cell_size = 0.75;
    config.boundaries = unsafe { windrow_boundaries_open_over_floor() };
    config.ambient = Vec3 { x: 3.0, y: 0.0, z: 1.0 };
    config.gusts = &gusts;
    config.simd = SIMD_BASELINE;
    let mut block = defaults(windrow_obstacle_init);
    block.position = place(2.0, 1.0, 0.5);
    block.shape = unsafe { windrow_shape_block(Vec3 { x: 0.5, y: 1.0, z: 0.8 }) };
    let mut jet = defaults(windrow_jet_motor_init);
    jet.position = place(-3.0, 1.5, 0.0);
    let (mut wind, mut bytes) = (null_mut(), null_mut());
    let mut block_id = ObstacleId { slot: 0, generation: 0, owner: 0 };
    let mut jet_id = MotorId { slot: 0, generation: 0, owner: 0 };
    unsafe {
        check(windrow_wind_create(&config, &mut wind));
        check(windrow_wind_add_obstacle(wind, &block, &mut block_id));
        check(windrow_wind_add_jet(wind, &jet, &mut jet_id));
        for frame in 0..60 {
            let time = f64::from(frame);
            check(windrow_wind_follow(wind, place(time / 20.0, 1.0, 0.0)));
            check(windrow_wind_move_motor(wind, jet_id, place(time / 16.0 - 3.0, 1.5, 0.0)));
            check(windrow_wind_advance(wind, 1.0 / 60.0, null_mut(), null_mut()));
        }
        check(windrow_wind_save(wind, &mut bytes));
        let saved = std::slice::from_raw_parts(windrow_bytes_data(bytes), windrow_bytes_size(bytes) as usize);
        let hash = saved.iter().fold(0xcbf29ce484222325u64, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x100000001b3));
        println!("{hash:016x}");
        windrow_bytes_destroy(bytes);
        windrow_wind_destroy(wind);
    }
}
