// Every field of a body, as picture_fields.h lists those of the picture.
#pragma once

#include "vegetation/program/body.h"
#include "vegetation/program/coat_fields.h"

namespace windrow::vegetation::program {

inline constexpr Range k_angle_rule{.least = -360.0, .most = 360.0, .unit = "deg"};

/// But for the name.
template <class Fields>
void list_fields(Fields& fields, MeshSource& mesh) {
    using fur::SizeOf;
    using fur::UpAxis;
    fields.word({"up", "Which axis of the file points up."}, mesh.load.up,
                {{"x", UpAxis::x}, {"y", UpAxis::y}, {"z", UpAxis::z}});
    fields.real({"size", "What the mesh is scaled to."}, mesh.load.size, {.least = 1e-3, .most = 1e3, .unit = "m"});
    fields.word({"size_of", "What size is the length of."}, mesh.load.size_of,
                {{"longest_edge", SizeOf::longest_edge}, {"height", SizeOf::height}});
    fields.real({"yaw_deg", "Turn about the vertical, seen from above counter-clockwise."}, mesh.yaw_deg, k_angle_rule);
    fields.integer({"most_triangles", "Files with more are simplified."}, mesh.most_triangles, {.least = 4.0, .most = 4e6});
}

template <class Fields>
void list_fields(Fields& fields, fur::Sheet& sheet) {
    fields.pair({"size", "Along x and z."}, sheet.size, {.least = 1e-3, .most = 1e4, .unit = "m"}, "x, z");
    fields.integer({"columns", "Cells along x; 1 x 1 has four vertices."}, sheet.columns, {.least = 1.0, .most = 1024.0});
    fields.integer({"rows", "Cells along z."}, sheet.rows, {.least = 1.0, .most = 1024.0});
    fields.real({"wave", "Amplitude of a gently hanging cloth, at most a tenth of the shorter side."}, sheet.wave,
                {.least = 0.0, .most = 1e3, .unit = "m"});
}

template <class Fields>
void list_fields(Fields& fields, fur::GlobeSphere& sphere) {
    fields.real({"radius", "[m]"}, sphere.radius, {.least = 1e-3, .most = 1e3, .unit = "m"});
    fields.integer({"sectors", "Around; 26 with 20 stacks has 515 vertices."}, sphere.sectors, {.least = 3.0, .most = 1024.0});
    fields.integer({"stacks", "From pole to pole."}, sphere.stacks, {.least = 2.0, .most = 1024.0});
}

template <class Fields>
void list_fields(Fields& fields, fur::CubeSphere& sphere) {
    fields.real({"radius", "[m]"}, sphere.radius, {.least = 1e-3, .most = 1e3, .unit = "m"});
    fields.integer({"cells", "Along an edge of the cube that it is blown up from."}, sphere.cells, {.least = 1.0, .most = 512.0});
}

template <class Fields>
void list_fields(Fields& fields, fur::Wing& wing) {
    fields.real({"span", "From root to tip."}, wing.span, {.least = 1e-2, .most = 100.0, .unit = "m"});
    fields.real({"chord", "At the root, at most the span."}, wing.chord, {.least = 1e-3, .most = 100.0, .unit = "m"});
    fields.real({"thickness", "Share of the chord."}, wing.thickness, {.least = 0.005, .most = 0.3});
    fields.real({"sweep", "Share of the span by which the tip lies behind the root."}, wing.sweep, k_share_rule);
    fields.real({"droop", "Share of the span by which the tip hangs down."}, wing.droop, {.least = 0.0, .most = 0.5});
    fields.integer({"feathers", "Notches of the trailing edge."}, wing.feathers, {.least = 0.0, .most = 40.0});
    fields.integer({"columns", "Cells along the span."}, wing.columns, {.least = 4.0, .most = 512.0});
    fields.integer({"rows", "Cells along the chord."}, wing.rows, {.least = 2.0, .most = 256.0});
    fields.flag({"left", "Spread along -x instead, as in a mirror."}, wing.left);
}

template <class Fields>
void list_fields(Fields& fields, fur::Beast& beast) {
    fields.real({"height", "At the withers."}, beast.height, {.least = 0.1, .most = 20.0, .unit = "m"});
    fields.integer({"detail", "Cells of the skin along that height."}, beast.detail, {.least = 20.0, .most = 120.0});
}

template <class Fields>
void list_fields(Fields& fields, BodyPlace& place) {
    fields.place({"position", "Of the mesh's origin."}, place.position, k_place_rule);
    fields.real({"yaw_deg", "Turn about the vertical."}, place.yaw_deg, k_angle_rule);
    fields.real({"pitch_deg", "Turn about its own x, after the yaw."}, place.pitch_deg, k_angle_rule);
    fields.real({"roll_deg", "Turn about its own z, after both."}, place.roll_deg, k_angle_rule);
    fields.real({"scale", "Factor on mesh and coat."}, place.scale, {.least = 1e-3, .most = 1e3});
    fields.flag({"above_ground", "Whether its height counts from the ground below."}, place.above_ground);
}

template <class Fields>
void list_fields(Fields& fields, Sway& sway) {
    fields.place({"by", "Farthest from the middle."}, sway.by, {.least = -1e3, .most = 1e3, .unit = "m"});
    fields.number({"turn_deg", "Farthest turn about the vertical."}, sway.turn_deg, {.least = 0.0, .most = 360.0, .unit = "deg"});
    fields.number({"nod_deg", "Farthest turn about its own x."}, sway.nod_deg, {.least = 0.0, .most = 360.0, .unit = "deg"});
    fields.number({"hz", "[Hz]"}, sway.hz, {.least = 0.0, .most = 100.0, .unit = "Hz"});
    fields.number({"phase", "Share of a turn by which it is ahead."}, sway.phase, k_share_rule);
}

template <class Fields>
void list_fields(Fields& fields, Hop& hop) {
    fields.number({"height", "0: it stays on the ground."}, hop.height, {.least = 0.0, .most = 100.0, .unit = "m"});
    fields.number({"hz", "Jumps a second."}, hop.hz, {.least = 0.0, .most = 100.0, .unit = "Hz", .above_least = true});
    fields.number({"rest", "Share of the time on the ground."}, hop.rest, {.least = 0.0, .most = 0.95});
}

/// But for the path, sway and hop.
template <class Fields>
void list_fields(Fields& fields, BodyMotion& motion) {
    fields.flag({"faces", "Whether its +z looks along the path."}, motion.faces);
    fields.number({"spin_hz", "Turns about the vertical a second."}, motion.spin_hz,
                  {.least = -100.0, .most = 100.0, .unit = "Hz"});
}

template <class Fields>
void list_fields(Fields& fields, fur::Swing& swing) {
    constexpr Range k_swing_rule{.least = 0.0, .most = 1.5707964, .unit = "rad"};
    constexpr Range k_phase_rule{.least = -100.0, .most = 100.0, .unit = "rad"};
    fields.direction({"axis", "Of the mesh at rest; any length but 0."}, swing.axis);
    fields.real({"rest", "Held always."}, swing.rest, {.least = -3.1415927, .most = 3.1415927, .unit = "rad"});
    fields.real({"amplitude", "[rad]"}, swing.amplitude, k_swing_rule);
    fields.real({"hz", "[Hz]"}, swing.hz, {.least = 0.0, .most = 20.0, .unit = "Hz"});
    fields.real({"phase", "[rad]"}, swing.phase, k_phase_rule);
    fields.real({"second", "Amplitude at the double frequency."}, swing.second, k_swing_rule);
    fields.real({"second_phase", "[rad]"}, swing.second_phase, k_phase_rule);
}

/// But for the name, the parent and the swings.
template <class Fields>
void list_fields(Fields& fields, fur::Bone& bone) {
    constexpr Range k_bone_rule{.least = -1e4, .most = 1e4, .unit = "m"};
    fields.position({"head", "In the mesh at rest: what it turns about."}, bone.head, k_bone_rule);
    fields.position({"tail", "Its other end."}, bone.tail, k_bone_rule);
    fields.real({"radius", "Of the flesh around it."}, bone.radius,
                {.least = 0.0, .most = 100.0, .unit = "m", .above_least = true});
    fields.position({"sway", "It moves to and fro by so much."}, bone.sway, {.least = -10.0, .most = 10.0, .unit = "m"});
    fields.real({"sway_hz", "[Hz]"}, bone.sway_hz, {.least = 0.0, .most = 20.0, .unit = "Hz"});
    fields.real({"sway_phase", "[rad]"}, bone.sway_phase, {.least = -100.0, .most = 100.0, .unit = "rad"});
}

/// But for the bones.
template <class Fields>
void list_fields(Fields& fields, BodySkeleton& skeleton) {
    fields.word({"kind", "Whose: none, those of the beast or of the horse, or the scene's own."}, skeleton.kind,
                {{"none", SkeletonKind::none},
                 {"beast", SkeletonKind::beast},
                 {"horse", SkeletonKind::horse},
                 {"own", SkeletonKind::own}});
    fields.number({"pace", "How fast they move: 1 as they are made, 0 stands in the first pose."}, skeleton.pace,
                  {.least = 0.0, .most = 10.0});
    fields.number({"phase", "By which the motion is ahead."}, skeleton.phase, {.least = 0.0, .most = 1e3, .unit = "s"});
}

} // namespace windrow::vegetation::program
