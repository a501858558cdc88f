// A vertex on a layer, for the colour and the shadow pass. After windrow_plants.glsl (or shell.glsl without wind) and coat.glsl.
#ifndef WINDROW_SHELLS_SHELL_VERTEX_GLSL
#define WINDROW_SHELLS_SHELL_VERTEX_GLSL

struct ShellPlace {
    vec3 position;
    vec3 normal; // of the side that the layer lies on
    vec3 along;  // [m] by which position moves with the height, from 0 to 1
};

// Height of layer i from -1 to 1: below 0 on the other side of a mirrored coat. The outermost is held at the tip while their
// number, which goes by the distance, lies between two whole ones.
float layer_height(int layer, float divisor) {
    float share = min(float(layer) / divisor, 1.0);
    if (coat.layers.z == 1) {
        float side = 2.0 * share - 1.0;
        return sign(side) * windrow_mask_power(abs(side), coat.shells.form.y);
    }
    return windrow_mask_power(share, coat.shells.form.y);
}

// `wind_load` [rad] or [m/s] in the translate form; what `skin` holds unless the layer has its own.
ShellPlace shell_place(CoatSkin skin, float height, vec3 wind_load) {
    float h = abs(height);
    ShellPlace place;
    place.normal = height < 0.0 ? -skin.normal.xyz : skin.normal.xyz;
    vec3 lag = h * (skin.lag.xyz + h * skin.lag_more.xyz);
    if (coat.form.x == 1) {
        float step = 0.02;
        vec3 p = windrow_shell_translated(coat.shells, skin.position.xyz, place.normal, h, 1.0, wind_load);
        vec3 below = windrow_shell_translated(coat.shells, skin.position.xyz, place.normal, h - min(step, h), 1.0, wind_load);
        vec3 above = windrow_shell_translated(coat.shells, skin.position.xyz, place.normal, h + step, 1.0, wind_load);
        place.position = p + lag;
        place.along = (above - below) / (step + min(step, h)) + skin.lag.xyz + 2.0 * h * skin.lag_more.xyz;
        return place;
    }
    WindrowCoatStrand own = windrow_coat_strand(coat.shells, place.normal, skin.position.w, skin.load.xyz, skin.own.xyz,
                                                skin.lag.xyz, skin.lag_more.xyz);
    vec3 shift = windrow_coat_shift(own, h);
    vec3 tangent = windrow_coat_tangent(own, h);
    if (coat.form.y == k_wind_at_shell) {
        // Aside by the layer's own wind, out by the strand's: layers keep their order whatever the wind does between them.
        WindrowCoatStrand other = windrow_coat_strand(coat.shells, place.normal, skin.position.w, wind_load, skin.own.xyz,
                                                      skin.lag.xyz, skin.lag_more.xyz);
        shift = dot(shift, place.normal) * place.normal + windrow_across(windrow_coat_shift(other, h), place.normal);
        tangent = dot(tangent, place.normal) * place.normal + windrow_across(windrow_coat_tangent(other, h), place.normal);
    }
    float kept = 1.0 - skin.load.w; // as a whole, so that layers keep their order
    place.position =
        skin.position.xyz + kept * (own.stem.reach * h + coat.shells.form.x * coat.shells.form.z) * place.normal + kept * shift;
    place.along = kept * (own.stem.reach * (place.normal + tangent));
    return place;
}

#endif
