// The whole C interface. Made by ./dev schema from the headers of c_api, where units, ranges and defaults are. Do not edit.
pub mod air;
pub mod bodies;
pub mod operators;
pub mod plants;
pub mod device;
#[allow(unused_imports)]
pub use self::{air::*, bodies::*, operators::*, plants::*, device::*};
