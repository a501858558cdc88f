// What the direct solve gives, stored: phi, or a correction around obstacles.
layout(std430, set = 0, binding = 4) writeonly buffer Potential { float potential[]; };
layout(std430, set = 0, binding = 5) buffer Correction { float correction[]; };
layout(std430, set = 0, binding = 6) buffer Direction { float direction[]; };
layout(std430, set = 0, binding = 7) readonly buffer Around { WindrowAround around; };

// A correction is kept beside phi until surface.comp has found how far to go along it.
void store(ivec3 cell, float value) {
    const int at = cell_index(cell);
    if (!k_obstacles || push.solve == 0) {
        potential[at] = value;
        return;
    }
    if (push.solve > 1) {
        const float along = correction[at], next = around.beta == 0.0f ? along : along + around.beta * direction[at];
        const float step = around.alpha == 0.0f ? 0.0f : around.alpha * next;
        const int sum = at + tick.cells.x * tick.cells.y * tick.cells.z;
        correction[sum] = push.solve == 2 ? step : correction[sum] + step;
        direction[at] = next;
    }
    correction[at] = value;
}
