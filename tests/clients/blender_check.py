"""Imports a .vdb into Blender as an artist would, and fails unless it holds a velocity that Blender can use.

    blender -b --factory-startup --python tests/clients/blender_check.py -- FILE.vdb [GRID]

GRID is the name of the grid of vectors to look for, "vel" unless given. Tried with Blender 3.4.
"""

import os
import sys
import traceback

import bpy


def check(file, wanted):
    # The operator answers FINISHED for a file that is not there.
    if not os.path.isfile(file):
        return f"{file}: no such file"
    bpy.ops.object.volume_import(filepath=os.path.abspath(file))
    volume_object = bpy.context.object
    if volume_object is None or volume_object.type != "VOLUME":
        return f"{file}: Blender could not import it"
    volume = volume_object.data
    if not volume.grids.load():
        return f"{file}: Blender could not load it: {volume.grids.error_message}"

    print(f"file {file}")
    for grid in volume.grids:
        voxel = [round(grid.matrix_object[axis][axis], 6) for axis in range(3)]
        place = [round(grid.matrix_object[axis][3], 6) for axis in range(3)]
        print(f"grid {grid.name} data_type {grid.data_type} channels {grid.channels} voxel {voxel} centre of voxel 0 {place}")
    # Blender's box reaches from centre to centre of the outermost voxels: one voxel less than the wind's box.
    bpy.context.view_layer.update()
    print(f"dimensions {[round(size, 4) for size in volume_object.dimensions]} m")
    print(f"bound_box low {[round(x, 4) for x in volume_object.bound_box[0]]} high {[round(x, 4) for x in volume_object.bound_box[6]]}")
    # What Blender took for the velocity by itself, and its unit: distance a frame, until someone says "SECOND".
    print(f"velocity_grid {volume.velocity_grid!r} velocity_unit {volume.velocity_unit}")
    volume.velocity_unit = "SECOND"

    vectors = [grid.name for grid in volume.grids if grid.data_type == "VECTOR_FLOAT" and grid.channels == 3]
    if wanted not in vectors:
        return f"{file}: no VECTOR_FLOAT grid named {wanted}; its vector grids are {vectors}"
    return None


def main():
    arguments = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
    if len(arguments) not in (1, 2):
        return "usage: blender -b --factory-startup --python blender_check.py -- FILE.vdb [GRID]"
    return check(arguments[0], arguments[1] if len(arguments) == 2 else "vel")


# Blender in the background ends with 0 after an exception: only sys.exit carries the verdict.
try:
    problem = main()
except Exception:
    problem = traceback.format_exc()
if problem:
    print(f"blender_check: {problem}", file=sys.stderr)
    sys.exit(1)
print("blender_check: well")
