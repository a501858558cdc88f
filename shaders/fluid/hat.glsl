// Index of a mode of x and z in a plane of constant y: [y][z][x].
int hat_index(ivec3 mode) { return (mode.y * tick.cells.z + mode.z) * tick.cells.x + mode.x; }
