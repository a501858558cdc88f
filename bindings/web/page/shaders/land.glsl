// The land around the meadow: hills that begin beyond its edge.
float hill_height(vec2 place) {
    vec2 off = place - far.xy;
    float rise = smoothstep(far.z, 6.0 * far.z, length(off));
    return far.w * rise * (0.75 * windrow_place_noise(place / 90.0 + 40.0) + 0.25 * windrow_place_noise(place / 37.0 + 11.0));
}
