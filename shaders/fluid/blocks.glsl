// What the host tells the passes of a tick, and what they tell each other. The same text is C++ (fluid/vulkan/blocks.h): only
// vec4s, ivec4s and uvec4s, so that both lay it out alike. numerics/ambient.glsl comes before it.
#ifndef WINDROW_BLOCKS_GLSL
#define WINDROW_BLOCKS_GLSL

// Halo of a padded field: cells below 0 and above n - 1 that a cubic read at a legal position can touch.
#define WINDROW_HALO_LOW 2
#define WINDROW_HALO 5

// Bits of WindrowStep.shape.z.
#define WINDROW_FRESH 1         // there is no past: the first sub-step is rehearsed
#define WINDROW_STABLE_FLUIDS 2 // the classic split (and all that does not advect), else second order
#define WINDROW_LINEAR 4        // trilinear, else cubic
#define WINDROW_ADVECTS 8
#define WINDROW_PROJECTS 16
#define WINDROW_SETTLES 32
#define WINDROW_GUSTS 64          // the ambient wind is given, not solved
#define WINDROW_PROFILE 128       // the mean wind is not the same at all heights
#define WINDROW_LETS_AIR_IN 256   // u_S is given, not solved
#define WINDROW_RENEWS_AIR 512    // u_S changes in this tick
#define WINDROW_DIFFUSES 1024     // viscosity may act
#define WINDROW_PUSHES 2048       // a motor of this tick is a force
#define WINDROW_EXPANDS 4096      // a motor of this tick is a source of air
#define WINDROW_OWES_NOTHING 8192 // viscosity has acted for all time so far
#define WINDROW_DRIVES 32768      // a motor of this tick is a drive
#define WINDROW_ONE_PASS 16384    // its explicit pass is all there is: it acts for as long as that may, and owes the rest

// Of a tick.
struct WindrowStep {
    ivec4 cells;    // xyz cells an axis, w all of them
    ivec4 shape;    // x motors, y most sub-steps, z bits (above), w sub-steps forced, 0: as many as the speeds ask
    vec4 time;      // x [s] duration, y [m] edge of a cell, z [s] settling time, w most cells that air may cross in a sub-step
    vec4 ambient;   // xyz [m/s] mean wind that open sides carry, w [m^2/s] viscosity
    vec4 low, high; // xyz positions where a trajectory may end [cells, from the first centre]
    vec4 period;    // xyz cells of a periodic axis, else 0
    vec4 inverse_period;                // xyz 1 / period, else 0
    ivec4 low_source;                   // xyz cell that a stencil takes beyond the low side
    ivec4 high_source;                  // and beyond the high side
    vec4 velocity_low, velocity_high;   // xyz factor there on the velocity along the axis
    vec4 potential_low, potential_high; // and on the potential
    vec4 canopy;                        // x [1/m] drag, 0: none; y ground, z top [cells above the low side]
    vec4 carried;        // xyz [texels/s] speed at which gusts are carried, w [m/s] a perturbation that counts as none
    WindrowAmbient wind; // at the tick's start; local positions are from the box's low corner
};

// Between the passes of a tick. Lives on the device; `dt` is kept from tick to tick.
struct WindrowControl {
    // x bits of the largest speed component, y bits of the largest force component, z broken cells, w cells whose speed was cut
    uvec4 found;
    // x [s] duration of a sub-step, y [s] of the last tick's, z [m/s] most that a component may be, w Courant number
    vec4 substep;
    // x sub-steps, y 1 where more were wanted than allowed, z bits of the time [s] in which viscosity has not acted yet
    ivec4 plan;
    vec4 diffused[16]; // [s] for which each sub-step diffuses, four a vector; 0: it owes
    // x bits of the largest speed component, y bits of the largest difference from ambient; found.zw of all ticks of the
    // recording
    uvec4 measured;
};

// Where a padded index takes its value from: value = scale * source + offset, or the ambient wind.
struct WindrowRule {
    ivec4 source; // x cell along the axis, y 1 beyond an open side, z 1 where the value is taken as it is
    vec4 scale;
    vec4 offset;
    vec4 history_scale;
};

// One motor; fluid/motor_reach.h.
struct WindrowMotor {
    uint shape, law;
    float centre[3], extent[3];
    float radius, end_radius, lift;
    float push[3];
    float amount, eddies, texels;
    float tile_place[3];
    int low[3], high[3];
};

#endif
