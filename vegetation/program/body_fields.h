// Every field of a body, as picture_fields.h lists those of the picture.
#pragma once

#include "vegetation/program/body.h"
#include "vegetation/program/coat_fields.h"

namespace windrow::vegetation::program {

inline constexpr NumberRule k_angle_rule{.least = -360.0, .most = 360.0, .unit = "deg"};

/// But for the name.
template <class Fields>
void list_fields(Fields& fields, MeshSource& mesh) {
    using fur::SizeOf;
    using fur::UpAxis;
    fields.word("up", mesh.load.up, {{"x", UpAxis::x}, {"y", UpAxis::y}, {"z", UpAxis::z}});
    fields.real("size", mesh.load.size, {.least = 1e-3, .most = 1e3, .unit = "m"});
    fields.word("size_of", mesh.load.size_of, {{"longest_edge", SizeOf::longest_edge}, {"height", SizeOf::height}});
    fields.real("yaw_deg", mesh.yaw_deg, k_angle_rule);
    fields.integer("most_triangles", mesh.most_triangles, {.least = 4.0, .most = 4e6});
}

template <class Fields>
void list_fields(Fields& fields, fur::Sheet& sheet) {
    fields.pair("size", sheet.size, {.least = 1e-3, .most = 1e4, .unit = "m"}, "x, z");
    fields.integer("columns", sheet.columns, {.least = 1.0, .most = 1024.0});
    fields.integer("rows", sheet.rows, {.least = 1.0, .most = 1024.0});
    fields.real("wave", sheet.wave, {.least = 0.0, .most = 1e3, .unit = "m"});
}

template <class Fields>
void list_fields(Fields& fields, fur::GlobeSphere& sphere) {
    fields.real("radius", sphere.radius, {.least = 1e-3, .most = 1e3, .unit = "m"});
    fields.integer("sectors", sphere.sectors, {.least = 3.0, .most = 1024.0});
    fields.integer("stacks", sphere.stacks, {.least = 2.0, .most = 1024.0});
}

template <class Fields>
void list_fields(Fields& fields, fur::CubeSphere& sphere) {
    fields.real("radius", sphere.radius, {.least = 1e-3, .most = 1e3, .unit = "m"});
    fields.integer("cells", sphere.cells, {.least = 1.0, .most = 512.0});
}

template <class Fields>
void list_fields(Fields& fields, fur::Wing& wing) {
    fields.real("span", wing.span, {.least = 1e-2, .most = 100.0, .unit = "m"});
    fields.real("chord", wing.chord, {.least = 1e-3, .most = 100.0, .unit = "m"});
    fields.real("thickness", wing.thickness, {.least = 0.005, .most = 0.3});
    fields.real("sweep", wing.sweep, k_share_rule);
    fields.real("droop", wing.droop, {.least = 0.0, .most = 0.5});
    fields.integer("feathers", wing.feathers, {.least = 0.0, .most = 40.0});
    fields.integer("columns", wing.columns, {.least = 4.0, .most = 512.0});
    fields.integer("rows", wing.rows, {.least = 2.0, .most = 256.0});
    fields.flag("left", wing.left);
}

template <class Fields>
void list_fields(Fields& fields, fur::Beast& beast) {
    fields.real("height", beast.height, {.least = 0.1, .most = 20.0, .unit = "m"});
    fields.integer("detail", beast.detail, {.least = 20.0, .most = 120.0});
}

template <class Fields>
void list_fields(Fields& fields, BodyPlace& place) {
    fields.place("position", place.position, k_place_rule);
    fields.real("yaw_deg", place.yaw_deg, k_angle_rule);
    fields.real("pitch_deg", place.pitch_deg, k_angle_rule);
    fields.real("roll_deg", place.roll_deg, k_angle_rule);
    fields.real("scale", place.scale, {.least = 1e-3, .most = 1e3});
    fields.flag("above_ground", place.above_ground);
}

template <class Fields>
void list_fields(Fields& fields, Sway& sway) {
    fields.place("by", sway.by, {.least = -1e3, .most = 1e3, .unit = "m"});
    fields.number("turn_deg", sway.turn_deg, {.least = 0.0, .most = 360.0, .unit = "deg"});
    fields.number("nod_deg", sway.nod_deg, {.least = 0.0, .most = 360.0, .unit = "deg"});
    fields.number("hz", sway.hz, {.least = 0.0, .most = 100.0, .unit = "Hz"});
    fields.number("phase", sway.phase, k_share_rule);
}

template <class Fields>
void list_fields(Fields& fields, Hop& hop) {
    fields.number("height", hop.height, {.least = 0.0, .most = 100.0, .unit = "m"});
    fields.number("hz", hop.hz, {.least = 0.0, .most = 100.0, .above_least = true, .unit = "Hz"});
    fields.number("rest", hop.rest, {.least = 0.0, .most = 0.95});
}

/// But for the path, sway and hop.
template <class Fields>
void list_fields(Fields& fields, BodyMotion& motion) {
    fields.flag("faces", motion.faces);
    fields.number("spin_hz", motion.spin_hz, {.least = -100.0, .most = 100.0, .unit = "Hz"});
}

template <class Fields>
void list_fields(Fields& fields, fur::Swing& swing) {
    constexpr NumberRule k_swing_rule{.least = 0.0, .most = 1.5707964, .unit = "rad"};
    constexpr NumberRule k_phase_rule{.least = -100.0, .most = 100.0, .unit = "rad"};
    fields.direction("axis", swing.axis);
    fields.real("rest", swing.rest, {.least = -3.1415927, .most = 3.1415927, .unit = "rad"});
    fields.real("amplitude", swing.amplitude, k_swing_rule);
    fields.real("hz", swing.hz, {.least = 0.0, .most = 20.0, .unit = "Hz"});
    fields.real("phase", swing.phase, k_phase_rule);
    fields.real("second", swing.second, k_swing_rule);
    fields.real("second_phase", swing.second_phase, k_phase_rule);
}

/// But for the name, the parent and the swings.
template <class Fields>
void list_fields(Fields& fields, fur::Bone& bone) {
    constexpr NumberRule k_bone_rule{.least = -1e4, .most = 1e4, .unit = "m"};
    fields.position("head", bone.head, k_bone_rule);
    fields.position("tail", bone.tail, k_bone_rule);
    fields.real("radius", bone.radius, {.least = 0.0, .most = 100.0, .above_least = true, .unit = "m"});
    fields.position("sway", bone.sway, {.least = -10.0, .most = 10.0, .unit = "m"});
    fields.real("sway_hz", bone.sway_hz, {.least = 0.0, .most = 20.0, .unit = "Hz"});
    fields.real("sway_phase", bone.sway_phase, {.least = -100.0, .most = 100.0, .unit = "rad"});
}

/// But for the bones.
template <class Fields>
void list_fields(Fields& fields, BodySkeleton& skeleton) {
    fields.word("kind", skeleton.kind,
                {{"none", SkeletonKind::none},
                 {"beast", SkeletonKind::beast},
                 {"horse", SkeletonKind::horse},
                 {"own", SkeletonKind::own}});
    fields.number("pace", skeleton.pace, {.least = 0.0, .most = 10.0});
    fields.number("phase", skeleton.phase, {.least = 0.0, .most = 1e3, .unit = "s"});
}

} // namespace windrow::vegetation::program
