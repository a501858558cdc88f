// How grass leans as a whole, where single blades are not seen: what the wind without its detail holds of a plant of the class.
// After shaders/coupling/windrow_plants.glsl.
#ifndef WINDROW_RENDER_CANOPY_LEAN_GLSL
#define WINDROW_RENDER_CANOPY_LEAN_GLSL

// [rad] x and z, over the ground at p [m from the anchor]. `sharp` 1: gusts are seen; 0: a point of the picture holds many of them,
// and has the lean of the mean wind.
vec2 canopy_lean(WindrowBlade blade, vec3 p, float sharp) {
    const vec3 up = vec3(0.0, 1.0, 0.0);
    WindrowAmbient ambient = windrow_frame.ambient;
    vec3 u = vec3(0.0);
    vec3 middle = p + 0.5 * blade.size.x * up;
    if (sharp > 0.0)
        u = sharp * windrow_velocity(middle);
    if (sharp < 1.0) {
        float share = ambient.roughness_length > 0.0
                          ? windrow_profile(0.5 * blade.size.x, ambient.roughness_length, ambient.reference_height)
                          : 1.0;
        u += (1.0 - sharp) * share * ambient.mean;
    }
    return windrow_drag_bend(blade.drag, up, windrow_limited(u, ambient.felt_strength, ambient.felt_limit), 1.0).xz;
}

#endif
