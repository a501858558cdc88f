// Parameter blocks of the passes of a tick, from the host and between passes. Include numerics/ambient.glsl before it.
//
// The same source is C++ (fluid/vulkan/blocks.h). Both have the same layout since every row of 16 bytes is full: four scalars, a
// vec3 with the scalar behind it, or a vec4.
#ifndef WINDROW_BLOCKS_GLSL
#define WINDROW_BLOCKS_GLSL

// Halo of a padded field: cells below 0 and above n - 1 that a cubic read at a legal position can touch.
#define WINDROW_HALO_LOW 2
#define WINDROW_HALO 5

// Bits of WindrowStep.flags.
#define WINDROW_FRESH 1            // no history yet: the first sub-step is rehearsed
#define WINDROW_STABLE_FLUIDS 2    // the classic split (and all that does not advect), else second order
#define WINDROW_LINEAR 4           // trilinear, else cubic
#define WINDROW_CUBIC_32 268435456 // cubic on 32 cells
#define WINDROW_ADVECTS 8
#define WINDROW_PROJECTS 16
#define WINDROW_RELAXES 32
#define WINDROW_GUSTS 64               // the ambient wind is prescribed, not solved
#define WINDROW_PROFILE 128            // the mean wind is not the same at all heights
#define WINDROW_HAS_SOURCE_FLOW 256    // u_S is prescribed, not solved
#define WINDROW_RENEWS_SOURCE_FLOW 512 // u_S changes in this tick
#define WINDROW_DIFFUSES 1024          // viscosity may act
#define WINDROW_PUSHES 2048            // a motor of this tick is a force
#define WINDROW_EXPANDS 4096           // a motor of this tick is a volume source
#define WINDROW_KEEPS 8192             // the air before this tick is kept, to blend frames
#define WINDROW_DRIVES 32768           // a motor of this tick is a drive
#define WINDROW_ONE_PASS                                                                                                         \
    16384                    // its explicit pass is all there is: it acts for as long as that may, and leaves the rest for later
#define WINDROW_LIMITS 65536 // limit.comp is recorded: speeds may be cut
#define WINDROW_OBSTACLES 131072       // in the box
#define WINDROW_ROOMS 262144           // some of the air is in closed rooms
#define WINDROW_THIN 524288            // a read may pass through a body
#define WINDROW_BODIES_MOVE 1048576    // some obstacle moves
#define WINDROW_ROUGH 2097152          // the ground is rough
#define WINDROW_DRAG 4194304           // deposits of drag are in the box
#define WINDROW_MAY_REST 8388608       // nothing acts: it is found whether the air is still
#define WINDROW_FIRST_TICK 16777216    // of its recording
#define WINDROW_COUNTED 67108864       // the last pass of the tick before has found what `sources` else does, which is left out
#define WINDROW_OUTER_TURNED 134217728 // the second of the outer wind's two fields is that of the start (outer.glsl)
#define WINDROW_PLANS 33554432         // one sub-step is recorded: the first pass over cells derives the plan, no pass makes it

// Of a tick. An axis is a component of the vec4s of which xyz alone are used.
struct WindrowStep {
    ivec3 cells; // an axis
    int motors;  // how many
    // Fields of cells are stored as a torus; this is the place of cell (0, 0, 0). A shift of the box moves it, not the cells.
    ivec3 torus;
    int recorded_substeps; // at most as many run; the time of the others is carried over to the next tick
    int flags;             // above
    int max_substeps;
    int forced_substeps;                // 0: as many as the speeds ask
    float duration;                     // [s]
    float cell_size;                    // [m]
    float relaxation_time;              // [s] to the ambient wind
    float max_cfl;                      // most cells that air may cross in a sub-step
    float sleep_speed;                  // [m/s] a perturbation that counts as none
    float canopy_drag;                  // [1/m] 0: none
    float canopy_ground;                // [cells above the low side]
    float canopy_top;                   // [cells above the low side]
    float gust_strength;                // [m/s] standard deviation; 0: none
    vec3 ambient;                       // [m/s] mean wind that open boundaries carry
    float viscosity;                    // [m^2/s]
    vec3 gust_speed;                    // [texels/s] at which gusts are carried
    int exposes;                        // bits of WINDROW_PLACE for cells that a shift before the tick exposes; 0: none
    ivec3 shift;                        // [cells] of the box, of these; of adjust.comp: since obstacles were placed
    int exposed_value;                  // WINDROW_PLACE_AMBIENT or _ZERO
    vec4 low, high;                     // positions where a trajectory may end [cells, from the first centre]
    vec4 period;                        // cells of a periodic axis, else 0
    vec4 inverse_period;                // 1 / period, else 0
    ivec4 low_source;                   // cell that a stencil takes beyond the low side
    ivec4 high_source;                  // and beyond the high side
    vec4 velocity_low, velocity_high;   // factor there on the velocity along the axis
    vec4 potential_low, potential_high; // and on the potential
    WindrowAmbient wind;                // at the tick's start; local positions are from the box's low corner
};

// A row of a padded field, behind the step, in a box with rows of its own.
struct WindrowRow {
    float height; // [m] of its centre over the low boundary
    float scale;  // cell size over its thickness
    float link;   // cell size over the distance to the row below
    float column; // factor on its unknown in a column's system; of the first: square of the cell size over the least distance
};

// Of a tick (planning.glsl). Speeds that are found are the bits of floats, for atomicMax.
struct WindrowPlan {
    float substep_duration;  // [s]
    float previous_duration; // [s] of the last tick's sub-steps
    float max_speed;         // [m/s] that a component may be
    float cfl;               // Courant number
    // The velocity has two slots, in turns: now and one sub-step ago. Sub-step n begins in slot (first_slot + n) % 2.
    int first_slot;
    int substeps;
    float undiffused_time; // [s] in which viscosity has not acted yet
    float carried_time;    // [s] by which the air is behind the tick's end: later ticks make up for it
    float begin;           // [s] of the first sub-step, from the tick's start: 0, or less where time was carried over
    int capped;            // 1: more sub-steps were wanted than allowed
    // What it was made from.
    uint fastest_component; // [m/s] of the velocity
    uint fastest_in_rows;   // the same with what moves along y in rows; 0 where all are equal
    uint largest_force;     // [m/s^2] component
    uint nonfinite_cells;   // repaired
    uint unused_a, unused_b;
};

// Between the passes of a tick, on the device.
struct WindrowControl {
    // Found by the passes over cells before the plan, as there. `advect` clears them for the next tick.
    uint fastest_component;
    uint largest_force;
    uint nonfinite_cells;
    uint fastest_in_rows;
    // The same, by the last pass of the tick before.
    uint left_fastest, left_in_rows;
    uint reported_groups; // of `show` that are done
    uint unused;
    WindrowPlan plan; // of this tick, or of the last one until there is one
    // Of the last tick's plan, kept by its last pass: invocations make the next one from these while one replaces it.
    float last_duration;
    int next_slot;
    float last_undiffused, behind;
    // Reported.
    uint largest_speed;         // [m/s] bits of the largest component after the tick
    uint farthest_from_ambient; // [m/s] bits of the largest difference in a component
    uint repaired_cells;        // of all ticks of the recording
    uint limited_cells;         // as these
    float diffused_time[64];    // [s] for which each sub-step diffuses; 0: left for later
    uint left_before[4];        // `left_fastest` of the ticks before the last one, the newest first
    uint left_apart; // [m/s] bits of the largest difference from ambient, where nothing acts: by the last pass of a tick
    uint left_still; // a bit a tick before, the newest lowest: nothing acted, and it was less than the sleep speed
    uint unused_a, unused_b;
};

// What the host reads of the last tick of a recording: 64 bytes.
struct WindrowReport {
    float largest_component;  // [m/s] after the tick
    float apart;              // [m/s] largest difference from the ambient wind in a component
    float cfl;                // Courant number
    uint substeps;            // 8 bits; 1 bit: more were wanted than allowed; 23 bits: time carried over [us]
    uint repaired_cells;      // of all ticks of the recording
    uint limited_cells;       // as these
    float squares;            // [m^2/s^2] sum of |u|^2
    float divergence_squares; // [1/s^2] sum of the squared divergence
    float pressure_residual;  // around obstacles: left of the divergence at their surfaces
    uint pressure_solves;     // direct solves of the last sub-step around obstacles
    uint still;               // a bit a tick, the newest lowest: nothing acted, and the air was within the sleep speed of ambient
    uint unused;
    float largest_before[4]; // `largest_component` of the ticks before, the newest first: a recording may have several
};

// --- Obstacles (solids.glsl) -------------------------------------------------------------------------------------------------

// Head of the tables: where each begins, in words behind the head.
struct WindrowSolids {
    int rows;    // first record of each row of x, and the end of the last
    int columns; // x of each record
    int records; // WINDROW_RECORD words each: flags and body, six faces, first air term and their number, surface cell, change
    int faces;   // WINDROW_FACE words each
    int terms;   // WINDROW_TERM words each: air that a cell inside takes its value from
    int bodies;  // WINDROW_BODY words each: velocity, spin, position
    int surface; // record and cell of each surface cell
    int bytes;   // four cells a word
    int rooms;   // end of each room's cells, and bits of WINDROW_ROOM
    int room_cells;
    int parts; // of sealed air: of each, the end of its cells and of its surface cells
    int part_cells, part_surface;
    int part_count;
    float other_change; // [m/s] of the divergence of cells without a record, times h: as Solids::other_change
    int face_count, surface_count, room_count;
    int before;         // for each face, which one it was at the last placement; -1: new
    float thinnest;     // [cells] thickness of the thinnest body
    int farthest;       // [cells] largest reach that the bytes know
    int history;        // where the slopes of the last steps' phi over closed faces are in the work words
    int history_before; // the same of the last placement
    // Where forces are asked for; body_count is 0 elsewhere.
    int body_count;
    int body_faces; // of each body, its first face in the list, and the end
    int body_list;  // faces, one body after another
    int body_open;  // of each body, its first side in the next list, and the end
    int open_list; // WINDROW_OPEN_SIDE words each: sides of cells inside that are open, low and high cell, the one inside, axis, weight
    int bodies_before; // for each body, which one it was at the last placement; -1: new
    int loads;         // WINDROW_LOAD words each in the work words
    int loads_before;  // the same of the last placement
};
#define WINDROW_RECORD 11
#define WINDROW_FACE 10
#define WINDROW_TERM 6
#define WINDROW_BODY 9
#define WINDROW_OPEN_SIDE 5
#define WINDROW_PUSHED 8                  // impulse, moment, potential and closed faces of a body
#define WINDROW_LOAD (4 * WINDROW_PUSHED) // as cpu::BodyLoads::Load: history, sources, sum, blast
// Flags of a record.
#define WINDROW_INSIDE 1
#define WINDROW_SHUT 2
#define WINDROW_SHELTERED 4
#define WINDROW_ROOM 8
#define WINDROW_BODY_SHIFT 5
// Of a room.
#define WINDROW_ROOM_CAME_IN 1 // into the box, with this placement
#define WINDROW_ROOM_WALLS_MOVE 2
// Of a face, behind its axis.
#define WINDROW_LOW_SHELTERED 4
#define WINDROW_FACE_NO_SLIP 16
#define WINDROW_LOW_SHUT 32
// A cell's byte: three blocked faces, then
#define WINDROW_BYTE_INSIDE 8
#define WINDROW_BYTE_ROOM 16
#define WINDROW_BYTE_REACH_SHIFT 5 // reach from which its reads stop at closed faces; 0: none up to WindrowSolids.farthest
#define WINDROW_FARTHEST_REACH 6   // most that it may be

// --- Cells as they are shown (reading.glsl) ------------------------------------------------------------------------------------

// Head of the tables: where each begins, in words behind the head.
struct WindrowReading {
    int on;      // 0: every cell is shown as it is
    int rows;    // first entry of each row of x, and the end of the last
    int columns; // x of each entry
    int entries; // WINDROW_READING_ENTRY words each: first term, their number, wall, height, raise
    int terms;   // WINDROW_READING_TERM words each: cell, weight, weight over the law's share
    int walls;   // WINDROW_READING_WALL words each: normal, its velocity along it, its velocity, what is kept beside it
    int laws;    // height and raise of each row; -1: no law
    int unused;
};
#define WINDROW_READING_ENTRY 5
#define WINDROW_READING_TERM 3
#define WINDROW_READING_WALL 8

#define WINDROW_RESIDUAL_GROUPS 64 // at most as many as invocations

// Around obstacles: where the conjugate gradients are, then words of each surface cell and face.
struct WindrowAround {
    float alpha, beta; // phi = potential + earlier steps + alpha (correction + beta direction)
    float squares;     // of the last residual in the norm of the preconditioner
    float wanted;      // norm of the divergence at the surface before the solves
    float left;        // norm of the residual
    int solved;
    int stopped;     // 1: solved to rounding
    int corrections; // solves after the first
    // Of the groups that find the residual of the first solve: their sums, and how many are done.
    float wanted_parts[WINDROW_RESIDUAL_GROUPS], left_parts[WINDROW_RESIDUAL_GROUPS];
    uint groups_done;
};
#define WINDROW_SURFACE_WORDS 4 // residual, L d, d, scratch

// A point whose wind the host asked for: u = ambient + fraction (trilinear - ambient).
struct WindrowPoint {
    ivec3 low;      // cells around it
    float fraction; // weight of the box's wind
    ivec3 high;
    int unused_a;
    vec3 between;     // of the way from the low to the high cell, on each axis
    float over_floor; // [m] over the box's low boundary
    vec3 ambient;     // [m/s]
    float unused_c;
};

// Where a padded index takes its value from: value = scale * source + offset, or the ambient wind.
struct WindrowRule {
    int source;           // cell along the axis
    int beyond_open_side; // 1: the ambient wind
    int identity;         // 1: the value is taken as it is
    int unused;
    vec4 scale;
    vec4 offset;
    vec4 history_scale;
};

// --- Push constants of a dispatch: pass.glsl takes WindrowStagePush, or what WINDROW_PUSH names ---------------------------

// A pass of a sub-step. -1 as its number: the rehearsal of the first.
struct WindrowStagePush {
    int substep;
    int x_vectors; // where the eigenvectors of x begin in the tables
    int z_vectors; // and those of z
    int part;      // of diffusion: the component; of modes_forward: 1 for the flow of volume sources
    int x_even;    // even vectors of x, which come first; all where its ends differ
    int z_even;
    int forward; // 1: cells to modes
    int solve;   // around obstacles: 0 the first, then corrections
};

// surface.comp: after each direct solve around obstacles.
struct WindrowSurfacePush {
    int substep;
    int part; // as WindrowStagePush, of modes_forward
    int solve;
    int unused;
};

// loads.comp: what the pressure of a sub-step, or that of the sources, does to bodies.
#define WINDROW_OTHER_SOURCES 1
#define WINDROW_FIRST_SOURCES 2 // of air that was filled anew
struct WindrowLoadsPush {
    int substep;
    int of_sources; // 0: of a sub-step
};

// rooms.comp.
#define WINDROW_STILL_NEW_ROOMS 0
#define WINDROW_SEAL_SOURCES 1
#define WINDROW_BOUND_ROOMS 2
struct WindrowRoomsPush {
    int substep;
    int work; // one of these
};

// A tile of a transform: most floats, and most products of an invocation (modes.glsl).
#define WINDROW_TILE_FLOATS 4096
#define WINDROW_TILE_HELD 32

// Columns along y of the direct solve of the pressure.
struct WindrowColumnsPush {
    int substep;
    int pivots;   // where they begin in the tables
    int vectors;  // where those of periodic columns begin, then their factors; -1: none
    int singular; // the column without an inverse; -1: none
};

// A direct solve in slabs: where the eigenvectors of z begin in the tables, and the pivots.
struct WindrowSlabsPush {
    int substep;
    int forward;
    int back;
    int pivots; // [mode of x][y][mode of z]
};

// The same as WindrowColumnsPush of diffusion.
struct WindrowDiffusePush {
    int substep;
    int eigenvalues; // of x, then of z, then what the low and the high end of y add to the diagonal, then 1 where y is periodic
};

// Fields that place.comp writes.
#define WINDROW_PLACE_AIR 1
#define WINDROW_PLACE_PAST 2 // velocity a sub-step ago, history
#define WINDROW_PLACE_SOURCE_FLOW 4
#define WINDROW_PLACE_BEFORE 8
// What they take. The past's history and the sources' flow become 0.
#define WINDROW_PLACE_ZERO 0
#define WINDROW_PLACE_AMBIENT 1
#define WINDROW_PLACE_GIVEN 2 // the host's cells
#define WINDROW_PLACE_NOW 3   // the air

struct WindrowPlacePush {
    ivec3 shift; // [cells] of the box: cells that it exposes are written
    int fields;
    int value;
};

struct WindrowUncoverPush {
    ivec3 shift; // [cells] of the box since the tables were made
    int substep; // that is to come; -1: the first one of a tick
    int past;    // 0: the air has none
};

struct WindrowAdjustPush {
    vec3 change; // [m/s] of the mean wind
    float factor;
    int of_mean; // 1: by the change of the mean; 0: by the ambient wind as it blows
    int to_air;
    int to_before;
    int unused;
};

struct WindrowShowPush {
    ivec3 shift;  // [cells] of the box, since the tables of what is shown were made
    float factor; // of the way from the tick before to now
    int reports;  // what is to be reported of a tick: one of these
    int forces;   // as WindrowReportPush
    int forces_at;
};
#define WINDROW_REPORTS_NOTHING 0
#define WINDROW_REPORTS_SUMS 1 // for a later pass
#define WINDROW_REPORTS_TO_HOST 2

struct WindrowReportPush {
    int sums;      // entries to reduce
    int forces;    // bodies that there is room for
    int forces_at; // words behind the report
};

struct WindrowReadPush {
    ivec3 low;    // first cell that is read
    float factor; // as WindrowShowPush
    ivec3 size;   // cells along each axis
    int unused;
};

struct WindrowPointsPush {
    ivec3 shift; // as WindrowShowPush
    int points;
    float factor;                                                // as WindrowShowPush
    float wall_per_length, wall_per_log, wall_lowest, wall_fall; // numerics/wall_law.glsl
};

// lift.comp: what a field holds once the box has risen.
#define WINDROW_LIFT_NOW 0
#define WINDROW_LIFT_AGO 1
#define WINDROW_LIFT_HISTORY 2
#define WINDROW_LIFT_SOURCE_FLOW 3
#define WINDROW_LIFT_BEFORE 4
struct WindrowLiftPush {
    float rise; // [m]
    int field;
    int value; // WINDROW_PLACE_AMBIENT or _ZERO, for rows from outside
    int back;  // 0: into `arrived`; 1: from there into the field
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
