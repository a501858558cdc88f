// Motors: weight of a region at a point, and effect of a law on the air there.
//
//   weight of a region   w = (1 - s^2)^2 for s < 1, else 0;  s = distance / radius
//   force                u += dt w f
//   drive                u += (1 - exp(-E)) (U - u),  E = k w dt;  several: E and E U add up before they act
//   wake                 the same with the path integral of w in place of w dt
//   volume source        div u = S,  S = S0 w; the integral of w times S0 is the outflow [m^3/s]
//
// The kernel (1 - s^2)^2 is 1 at the centre, has slope 0 there and at the rim, is a polynomial in the squared distance (no
// root) and so has a path integral in closed form. Volume of a sphere's weight: 32 pi R^3 / 105.
// Based on: the biweight kernel of Tukey (Beaton & Tukey 1974, Technometrics 16).
#ifndef WINDROW_MOTORS_GLSL
#define WINDROW_MOTORS_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

// Regions and laws by number, as a motor's block has them.
const uint windrow_sphere = 0u;
const uint windrow_capsule = 1u;
const uint windrow_box = 2u;
const uint windrow_cone = 3u;
const uint windrow_jet = 4u;
const uint windrow_vortex = 5u;
const uint windrow_path = 6u;
const uint windrow_force = 0u;
const uint windrow_drive = 1u;
const uint windrow_source = 2u;

// (1 - s^2)^2 from the squared relative distance.
WINDROW_FN float windrow_falloff(float squared) {
    float rest = max(1.0f - squared, 0.0f);
    return rest * rest;
}

// Ball of `radius` [m] about the origin; `p` [m] from its centre.
WINDROW_FN float windrow_sphere_weight(vec3 p, float radius) { return windrow_falloff(dot(p, p) / (radius * radius)); }

// Potential of the flow -grad phi of a ball that lets one unit of air out, as its weight is spread, in air without bounds: this
// over 4 pi R, `squared` the relative distance squared. 1 / distance beyond the ball; inside from the flow (35 s^3 - 42 s^5 +
// 15 s^7) / 8 through the sphere at s.
WINDROW_FN float windrow_source_potential(float squared) {
    float inside = 0.125f * (17.5f - squared * (17.5f - squared * (10.5f - 2.5f * squared)));
    return squared < 1.0f ? inside : inversesqrt(squared + (squared < 1.0f ? 1.0f : 0.0f));
}

// All within `radius` of the segment from -half_axis to half_axis.
WINDROW_FN float windrow_capsule_weight(vec3 p, vec3 half_axis, float radius) {
    float length_squared = dot(half_axis, half_axis);
    float along = length_squared > 0.0f ? clamp(dot(p, half_axis) / length_squared, -1.0f, 1.0f) : 0.0f;
    vec3 off = p - along * half_axis;
    return windrow_falloff(dot(off, off) / (radius * radius));
}

// Axis-aligned box with `half_size` [m].
WINDROW_FN float windrow_box_weight(vec3 p, vec3 half_size) {
    vec3 s = p / half_size;
    return windrow_falloff(s.x * s.x) * windrow_falloff(s.y * s.y) * windrow_falloff(s.z * s.z);
}

// Round column about `axis` [m], from the narrow end at 0 to the wide one at `axis`; its radius grows evenly from `start_radius`
// to `end_radius`. 1 halfway on the axis, 0 at both ends and at the mantle. Equal radii: a cylinder. Volume of the weight:
// 8 pi L / 45 * (a^2 + b^2 / 7) with a, b half the sum and half the difference of the radii.
WINDROW_FN float windrow_cone_weight(vec3 p, vec3 axis, float start_radius, float end_radius) {
    float along = dot(p, axis) / dot(axis, axis);
    vec3 off = p - along * axis;
    float radius = mix(start_radius, end_radius, clamp(along, 0.0f, 1.0f));
    float half_lengths = 2.0f * along - 1.0f;
    return windrow_falloff(half_lengths * half_lengths) * windrow_falloff(dot(off, off) / (radius * radius));
}

// What blows out of a nozzle at 0 along `axis`, 1 there: rays from the cone's tip, slower as the section grows so that each
// section passes the same momentum, u^2 r^2, as a free round jet does (Pope 2000, Turbulent Flows, section 5.1).
WINDROW_FN vec3 windrow_jet_velocity(vec3 p, vec3 axis, float start_radius, float end_radius) {
    float axis_length = length(axis);
    vec3 direction = axis / axis_length;
    float along = dot(p, direction);
    vec3 off = p - along * direction;
    float radius = mix(start_radius, end_radius, clamp(along / axis_length, 0.0f, 1.0f));
    vec3 ray = direction + ((end_radius - start_radius) / (axis_length * radius)) * off;
    return (start_radius / radius) * ray;
}

// Weight along an axis alone: 1 in the middle, 0 at both ends.
WINDROW_FN float windrow_axial_weight(vec3 p, vec3 half_axis) {
    float along = dot(p, half_axis) / dot(half_axis, half_axis);
    return windrow_falloff(along * along);
}

// Weight of a whirl's drive: as along the axis, and (1 - s^4)^2 across it, 0.92 where the swirl is fastest, so that the core is
// driven nearly as hard as the middle.
WINDROW_FN float windrow_whirl_weight(vec3 p, vec3 half_axis, float radius) {
    float along = dot(p, half_axis) / dot(half_axis, half_axis);
    vec3 off = p - along * half_axis;
    float s2 = dot(off, off) / (radius * radius);
    return windrow_falloff(along * along) * windrow_falloff(s2 * s2);
}

// Swirl about `half_axis`, right-handed: 25 sqrt(5)/16 s (1 - s^2)^2, which is 1 where it is largest, at s = 1/sqrt(5) = 0.447 of
// the radius, turns like a rigid body in the middle and is 0 with slope 0 at the rim; and `lift` (1 - s^2)^2 along the axis. Free
// of divergence without lift.
WINDROW_FN vec3 windrow_swirl_velocity(vec3 p, vec3 half_axis, float radius, float lift) {
    vec3 direction = half_axis / length(half_axis);
    vec3 off = p - dot(p, direction) * direction;
    float falloff = windrow_falloff(dot(off, off) / (radius * radius));
    return falloff * ((3.4938562f / radius) * cross(direction, off) + lift * direction);
}

// Integral of (a - t^2)^2 from 0 to t.
WINDROW_FN float windrow_falloff_primitive(float a, float t) {
    float t2 = t * t;
    return t * (a * a - t2 * (2.0f * a / 3.0f - t2 / 5.0f));
}

// Path integral [m] of a ball's weight at `p` while its centre moves straight from `start` to `end`: additive over pieces
// of the path, 0 for a path of length 0, so it depends neither on the frame rate nor on the speed.
WINDROW_FN float windrow_wake_path(vec3 p, vec3 start, vec3 end, float radius) {
    vec3 path = end - start;
    float length_squared = dot(path, path);
    if (!(length_squared > 0.0f))
        return 0.0f;
    float path_length = sqrt(length_squared);
    vec3 direction = path / path_length;
    vec3 from_start = p - start;
    float along = dot(from_start, direction);
    vec3 off = from_start - along * direction;
    float a = 1.0f - dot(off, off) / (radius * radius);
    float reach = sqrt(abs(a)); // a compiler takes the root in all lanes before it chooses
    float first = clamp(-along / radius, -reach, reach);
    float last = clamp((path_length - along) / radius, -reach, reach);
    float path_within = radius * (windrow_falloff_primitive(a, last) - windrow_falloff_primitive(a, first));
    return a > 0.0f ? path_within : 0.0f;
}

// Weight of a motor at a place, and its push there; fluid/motor_reach.h has what it is made of.
WINDROW_FN float windrow_motor_weight(uint shape, uint law, vec3 p, vec3 centre, vec3 extent, float radius, float end_radius) {
    if (shape == windrow_sphere)
        return windrow_sphere_weight(p - centre, radius);
    if (shape == windrow_capsule)
        return windrow_capsule_weight(p - centre, extent, radius);
    if (shape == windrow_box)
        return windrow_box_weight(p - centre, extent);
    if (shape == windrow_cone || shape == windrow_jet)
        return windrow_cone_weight(p - centre, extent, radius, end_radius);
    if (shape == windrow_path)
        return windrow_wake_path(p, centre, extent, radius);
    // The swirl has its own falloff across the axis; a drive's rate needs one as well.
    return law == windrow_force ? windrow_axial_weight(p - centre, extent) : windrow_whirl_weight(p - centre, extent, radius);
}

// `off`: from the centre; `given`: the push, of jets and vortices its size in x.
WINDROW_FN vec3 windrow_motor_push(uint shape, vec3 off, vec3 given, vec3 extent, float radius, float end_radius, float lift) {
    if (shape == windrow_jet)
        return given.x * windrow_jet_velocity(off, extent, radius, end_radius);
    return shape == windrow_vortex ? given.x * windrow_swirl_velocity(off, extent, radius, lift) : given;
}

// Factor on the gust tile, which is added to the push.
WINDROW_FN float windrow_motor_eddies(uint shape, float weight, float eddies) {
    return (shape == windrow_path ? 1.0f : weight) * eddies;
}

// Velocity after `exponent` of drives toward their mean, `drives` = (sum E U, E).
WINDROW_FN vec3 windrow_driven(vec3 u, vec4 drives, float exponent) {
    return drives.w > 0.0f ? u + (1.0f - exp(-exponent)) * (vec3(drives) / drives.w - u) : u;
}

// A row of cells that is thicker than the others takes the mean of a motor over its thickness, at so many heights, a quarter of the
// motor's radius apart.
WINDROW_FN int windrow_motor_heights(uint shape, vec3 extent, float radius, float end_radius, float thickness, float cell_size) {
    if (!(thickness > cell_size))
        return 1;
    float smallest = shape == windrow_box ? extent.y : radius;
    if (shape == windrow_cone || shape == windrow_jet)
        smallest = min(radius, end_radius);
    else if (shape == windrow_vortex)
        smallest = min(radius, length(extent));
    return int(clamp(ceil(4.0f * thickness / smallest), 1.0f, 64.0f));
}

// How thin a region may be: in cells, as a radius. Below it, cells could fall between.
WINDROW_FN float windrow_widened(float radius, float cell_size) { return max(radius, 1.5f * cell_size); }

#endif
