// Free-space potential of the volume sources in ghost cells, phi / h [m/s], as cpu::FreeAir; 0 without free air (boundaries.h).
// Before this text: WINDROW_MOTORS, the binding of the motors.
#include "numerics/motors.glsl"

layout(std430, set = 0, binding = WINDROW_MOTORS) readonly buffer Motors { WindrowMotor motors[]; };

// The potential in the ghost cell one step from `cell` along an axis; 0 if that is no ghost cell of an open boundary.
float beyond(ivec3 cell, int axis, int step) {
    ivec3 ghost = cell;
    ghost[axis] += step;
    const bool low = ghost[axis] < 0;
    if (!low && ghost[axis] < tick.cells[axis] || (low ? tick.velocity_low : tick.velocity_high)[axis] < 0.0f)
        return 0.0f;
    vec3 wall = vec3(0.0f), walled = vec3(0.0f);
    for (int each = 0; each < 3; ++each) {
        const bool above = tick.velocity_high[each] < 0.0f;
        walled[each] = above || tick.velocity_low[each] < 0.0f ? 1.0f : 0.0f;
        wall[each] = above ? box_size()[each] : 0.0f;
    }
    const vec3 p = centre_of(ghost);
    float potential = 0.0f;
    for (int n = 0; n < tick.motors; ++n) {
        if (motors[n].law != windrow_source || motors[n].push[0] == 0.0f)
            continue;
        const vec3 centre = vec3(motors[n].extent[0], motors[n].extent[1], motors[n].extent[2]);
        float images = 0.0f;
        for (int image = 0; image < 8; ++image) {
            const vec3 turned = vec3(image & 1, (image >> 1) & 1, image >> 2);
            const vec3 from = (p - mix(centre, 2.0f * wall - centre, turned)) / motors[n].radius;
            if (dot(turned, 1.0f - walled) == 0.0f)
                images += windrow_source_potential(dot(from, from));
        }
        potential += motors[n].push[0] / motors[n].radius * images;
    }
    return potential / (12.5663706f * tick.cell_size);
}

// The same as L takes it from a cell's row, both ends of all axes.
float all_beyond(ivec3 cell) {
    float sum = 0.0f;
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end)
            sum += exchange(cell, axis, end) * beyond(cell, axis, 2 * end - 1);
    return sum;
}
