"""Sets a sequence of VDB files of `windrow run` up in Blender 3.4: a scene that shows the wind, ready to render.

    windrow run examples/scenes/film.json --vdb --out out/film
    blender -b --python tools/blender_sequence.py -- out/film --save out/film.blend --render out/film.png

It loads the sequence with its frame numbers and frames a second, sets the velocity's unit to metres a second, turns files whose y
axis is up, and makes a material whose colour is the speed. How much of the air is seen follows the grid `density` (smoke), else
`vorticity`, else `speed` itself. Obstacles become a mesh. Sun, ground and a camera on the whole are added.

Options after `--`:
    FOLDER              holds the files, or name the first file
    --save FILE         writes a .blend
    --render FILE       renders one picture, .png or .jpg
    --frame N           its frame; default the last one
    --size WxH          its size; default 960x540
    --samples N         a pixel; default 48
    --fastest S         speed at the end of the colours [m/s]; default 10
"""

import argparse
import math
import os
import re
import struct
import sys
import traceback

import bpy
from mathutils import Vector

# Speed as colour, slow to fast: violet, blue, green, orange, red.
RAMP = (
    (0.0, (0.10, 0.03, 0.35)),
    (0.25, (0.03, 0.25, 0.90)),
    (0.5, (0.05, 0.70, 0.35)),
    (0.75, (0.95, 0.55, 0.03)),
    (1.0, (0.80, 0.03, 0.01)),
)
FASTEST = 10.0  # [m/s] a fresh breeze reaches it


class Wrong(Exception):
    """A sentence for the user."""


def read_metadata(data, key, kind):
    """The first value of a key in the bytes of a .vdb, whose metadata is not compressed: name, type and size before each."""
    name = struct.pack("<I", len(key)) + key.encode() + struct.pack("<I", len(kind)) + kind.encode()
    place = data.find(name)
    if place < 0:
        return None
    size = struct.unpack_from("<I", data, place + len(name))[0]
    value = data[place + len(name) + 4 : place + len(name) + 4 + size]
    return value.decode() if kind == "string" else struct.unpack({"double": "<d", "int32": "<i"}[kind], value)[0]


def find_sequence(place):
    """(folder, names in order, number of the first)."""
    folder = place if os.path.isdir(place) else os.path.dirname(place) or "."
    if not os.path.isdir(folder):
        raise Wrong(f"{place}: no such folder")
    start = "" if os.path.isdir(place) else re.sub(r"\d+\.vdb$", "", os.path.basename(place))
    found = {}
    for name in os.listdir(folder):
        match = re.fullmatch(r"(.*?)(\d+)\.vdb", name)
        if match and match[1].startswith(start):
            found.setdefault(match[1], {})[int(match[2])] = name
    if not found:
        raise Wrong(f"{place}: holds no files NAME_0000.vdb; write them with windrow run --vdb")
    if len(found) > 1:
        raise Wrong(f"{place}: holds several sequences, {', '.join(sorted(found))}: name the first file of one")
    numbered = next(iter(found.values()))
    first, last = min(numbered), max(numbered)
    missing = [number for number in range(first, last + 1) if number not in numbered]
    if missing:
        raise Wrong(f"{place}: frame {missing[0]} is missing between {first} and {last}")
    return os.path.abspath(folder), [numbered[number] for number in range(first, last + 1)], first


def facts_of(folder, names):
    """Frames a second and the axis that points up, as the files have them."""
    heads = []
    for name in names[:2]:
        with open(os.path.join(folder, name), "rb") as file:
            heads.append(file.read())
    time = [read_metadata(head, "windrow_time", "double") for head in heads]
    if time[0] is None:
        raise Wrong(f"{names[0]}: has no windrow_time: it is not a file of windrow")
    rate = 1.0 / (time[1] - time[0]) if len(time) > 1 and time[1] > time[0] else 24.0
    return rate, read_metadata(heads[0], "windrow_up_axis", "string") or "y"


def load(folder, names, first, up):
    bpy.ops.object.volume_import(filepath=os.path.join(folder, names[0]), directory=folder, files=[{"name": name} for name in names])
    wind = bpy.context.object
    volume = wind.data
    volume.is_sequence = len(names) > 1
    volume.frame_start = first
    volume.frame_duration = len(names)
    volume.frame_offset = first - 1  # file = frame - frame_start + 1 + frame_offset
    volume.velocity_unit = "SECOND"
    wind.name = "wind"
    if up == "y":
        wind.rotation_euler = (math.pi / 2, 0.0, 0.0)
    return wind


def set_times(scene, rate, first, count):
    scene.render.fps = max(1, round(rate))
    scene.render.fps_base = scene.render.fps / rate  # 23.976 is 24 over 1.001
    scene.frame_start, scene.frame_end = first, first + count - 1


def attribute(nodes, name):
    node = nodes.new("ShaderNodeAttribute")
    node.attribute_name = name
    return node


def math_node(tree, operation, value, factor):
    node = tree.nodes.new("ShaderNodeMath")
    node.operation = operation
    tree.links.new(value, node.inputs[0])
    node.inputs[1].default_value = factor
    return node.outputs[0]


def make_material(grids, fastest, size):
    """Colour by speed, opacity by what is to be seen."""
    material = bpy.data.materials.new("speed of the wind")
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    ramp = tree.nodes.new("ShaderNodeValToRGB")
    while len(ramp.color_ramp.elements) < len(RAMP):
        ramp.color_ramp.elements.new(0.5)
    for element, (place, colour) in zip(ramp.color_ramp.elements, RAMP):
        element.position = place
        element.color = (*colour, 1.0)
    speed = attribute(tree.nodes, "speed").outputs["Fac"]
    tree.links.new(math_node(tree, "DIVIDE", speed, fastest), ramp.inputs["Fac"])

    if "density" in grids:
        seen, thickness = attribute(tree.nodes, "density").outputs["Fac"], 60.0 / size
    elif "vorticity" in grids:
        length = tree.nodes.new("ShaderNodeVectorMath")
        length.operation = "LENGTH"
        tree.links.new(attribute(tree.nodes, "vorticity").outputs["Vector"], length.inputs[0])
        # Squared: the faint vorticity of a log profile and of gusts is not to hide that of wakes and jets.
        seen, thickness = math_node(tree, "POWER", length.outputs["Value"], 2.0), 4.0 / size * (size / fastest / 8.0) ** 2
    else:
        seen, thickness = math_node(tree, "POWER", math_node(tree, "DIVIDE", speed, fastest), 3.0), 8.0 / size
    opacity = math_node(tree, "MULTIPLY", seen, thickness)
    shader = tree.nodes.new("ShaderNodeVolumePrincipled")
    shader.inputs["Density Attribute"].default_value = ""
    tree.links.new(ramp.outputs["Color"], shader.inputs["Color"])
    tree.links.new(ramp.outputs["Color"], shader.inputs["Emission Color"])
    tree.links.new(opacity, shader.inputs["Density"])
    tree.links.new(math_node(tree, "MULTIPLY", opacity, 0.2), shader.inputs["Emission Strength"])
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(shader.outputs["Volume"], output.inputs["Volume"])
    return material


def plain_material(name, colour):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    shader = tree.nodes.new("ShaderNodeBsdfPrincipled")
    tree.links.new(shader.outputs["BSDF"], tree.nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    shader.inputs["Base Color"].default_value = (*colour, 1.0)
    shader.inputs["Roughness"].default_value = 0.9
    return material


def add_obstacles(wind):
    """The cells inside obstacles as a mesh that follows the frames."""
    mesh = bpy.data.meshes.new("obstacles")
    bodies = bpy.data.objects.new("obstacles", mesh)
    bpy.context.collection.objects.link(bodies)
    bodies.parent = wind
    modifier = bodies.modifiers.new("from the wind", "VOLUME_TO_MESH")
    modifier.object = wind
    modifier.grid_name = "obstacle"
    modifier.threshold = 0.5
    paint = bodies.modifiers.new("colour", "NODES")
    group = bpy.data.node_groups.new("colour", "GeometryNodeTree")
    group.inputs.new("NodeSocketGeometry", "Geometry")
    group.outputs.new("NodeSocketGeometry", "Geometry")
    set_material = group.nodes.new("GeometryNodeSetMaterial")
    set_material.inputs["Material"].default_value = plain_material("obstacle", (0.80, 0.76, 0.70))
    group.links.new(group.nodes.new("NodeGroupInput").outputs[0], set_material.inputs["Geometry"])
    group.links.new(set_material.outputs["Geometry"], group.nodes.new("NodeGroupOutput").inputs[0])
    paint.node_group = group


def corners_of(wind):
    bpy.context.view_layer.update()
    points = [wind.matrix_world @ Vector(corner) for corner in wind.bound_box]
    low = Vector([min(point[axis] for point in points) for axis in range(3)])
    high = Vector([max(point[axis] for point in points) for axis in range(3)])
    return low, high


def add_surroundings(scene, low, high):
    middle, size = (low + high) / 2, (high - low).length
    bpy.ops.mesh.primitive_plane_add(size=20 * size, location=(middle.x, middle.y, low.z))
    bpy.context.object.data.materials.append(plain_material("ground", (0.17, 0.18, 0.17)))
    bpy.ops.object.light_add(type="SUN", rotation=(math.radians(40), math.radians(15), math.radians(-30)))
    bpy.context.object.data.energy = 3.0
    world = scene.world or bpy.data.worlds.new("World")
    scene.world = world
    world.use_nodes = True
    tree = world.node_tree
    tree.nodes.clear()
    sky = tree.nodes.new("ShaderNodeBackground")
    sky.inputs["Color"].default_value = (0.40, 0.48, 0.60, 1.0)
    sky.inputs["Strength"].default_value = 0.7
    tree.links.new(sky.outputs["Background"], tree.nodes.new("ShaderNodeOutputWorld").inputs["Surface"])

    # From the side and above, across the longest axis.
    along_x = high.x - low.x >= high.y - low.y
    turn = math.radians(-68 if along_x else -22)
    way = Vector((math.cos(turn) * math.cos(math.radians(19)), math.sin(turn) * math.cos(math.radians(19)), math.sin(math.radians(19))))
    bpy.ops.object.camera_add(location=middle + way * size)
    camera = bpy.context.object
    camera.rotation_euler = (-way).to_track_quat("-Z", "Y").to_euler()
    camera.data.lens = 40
    camera.data.clip_end = 100 * size
    scene.camera = camera
    bpy.context.view_layer.update()
    # As near as the inner part allows: the outer one is there for what is around it.
    inner = (high - low) / 2
    near, far = middle - 0.6 * inner, middle + 0.6 * inner
    near.z = low.z
    corners = [value for x in (near.x, far.x) for y in (near.y, far.y) for z in (near.z, far.z) for value in (x, y, z)]
    place, _ = camera.camera_fit_coords(bpy.context.evaluated_depsgraph_get(), corners)
    camera.location = place


def set_up(arguments):
    folder, names, first = find_sequence(arguments.folder)
    rate, up = facts_of(folder, names)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    size = re.fullmatch(r"(\d{2,5})x(\d{2,5})", arguments.size)
    if not size:
        raise Wrong(f"--size is {arguments.size}: give pixels such as 960x540")
    width, height = int(size[1]), int(size[2])
    scene.render.resolution_x, scene.render.resolution_y = width, height
    set_times(scene, rate, first, len(names))
    wind = load(folder, names, first, up)
    frame = arguments.frame if arguments.frame is not None else first + len(names) - 1
    if not first <= frame < first + len(names):
        raise Wrong(f"--frame is {frame}: give {first} to {first + len(names) - 1}")
    scene.frame_set(frame)
    volume = wind.data
    if not volume.grids.load():
        raise Wrong(f"{volume.filepath}: Blender could not load it: {volume.grids.error_message}")
    grids = [grid.name for grid in volume.grids]
    if "speed" not in grids:
        raise Wrong(f"{names[0]}: has no grid speed: write it with windrow run --vdb --grids speed,density")
    low, high = corners_of(wind)
    volume.materials.append(make_material(grids, arguments.fastest, (high - low).length))
    if "obstacle" in grids:
        add_obstacles(wind)
    add_surroundings(scene, low, high)
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = arguments.samples
    scene.cycles.use_denoising = False  # Debian's Blender has no denoiser
    scene.view_settings.view_transform = "Standard"
    print(f"blender_sequence: frames {scene.frame_start} to {scene.frame_end} at {rate:.6g} a second, {up} up in the files, "
          f"grids {', '.join(sorted(grids))}, velocity unit {volume.velocity_unit}, file {volume.grids.frame} at frame {frame}")
    return scene


def main():
    parser = argparse.ArgumentParser(prog="blender_sequence", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("--save")
    parser.add_argument("--render")
    parser.add_argument("--frame", type=int)
    parser.add_argument("--size", default="960x540")
    parser.add_argument("--samples", type=int, default=48)
    parser.add_argument("--fastest", type=float, default=FASTEST)
    arguments = parser.parse_args(sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else [])
    scene = set_up(arguments)
    if arguments.save:
        bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath(arguments.save))
    if arguments.render:
        scene.render.filepath = os.path.abspath(arguments.render)
        scene.render.image_settings.file_format = "JPEG" if arguments.render.endswith((".jpg", ".jpeg")) else "PNG"
        bpy.ops.render.render(write_still=True)


# Blender in the background ends with 0 after an exception: only sys.exit carries the verdict.
try:
    main()
except Wrong as wrong:
    print(f"blender_sequence: {wrong}.", file=sys.stderr)
    sys.exit(2)
except Exception:
    traceback.print_exc()
    sys.exit(1)
