#!/usr/bin/env python3
"""make_meshes.py [--from FOLDER] [--out FOLDER]: the meshes that the scenes of examples/scenes/fur name.

Copies the Stanford bunny (bunny.obj) from Debian's glmark2-data, which a scene may not read where it lies, converts its horse
(horse.3ds to horse.obj), and makes a polar bear (bear.obj, bear.mtl): a body of rounded cones that flow into one another, cut out of a grid by
surface nets. The bear's coat stands in its mtl: `fur 48 0.419 2.753 11`, shells, length, thickness and strands along a unit of
uv. Needs Python alone.

Based on: Gibson 1998, Constrained elastic surface nets, without its relaxation: one vertex a cell, in the mean of where the
surface crosses the cell's edges.
"""
import argparse
import math
import os
import struct
import sys

PACKAGE = "/usr/share/glmark2/models"
TAKEN = ("bunny.obj", "horse.3ds")
CELL = 0.19  # units of the bear's file; the bear is some 10 of them long
TILE = 0.8  # units of the file that one unit of uv covers, so that 11 strands stand on it

# Ends and radii of rounded cones: (x, y, z, r) to (x, y, z, r). z forward, y up, x across; mirrored where x is not 0.
BODY = [
    ((0.0, 3.7, -2.3, 1.45), (0.0, 3.6, 0.0, 1.55)),  # rump to belly
    ((0.0, 3.6, 0.0, 1.55), (0.0, 3.9, 1.7, 1.25)),  # to the shoulders
    ((0.0, 3.9, 1.7, 1.10), (0.0, 4.3, 3.3, 0.72)),  # neck
    ((0.0, 4.35, 3.5, 0.78), (0.0, 4.15, 4.3, 0.55)),  # head
    ((0.0, 4.05, 4.4, 0.42), (0.0, 3.92, 5.05, 0.30)),  # muzzle
    ((0.62, 4.98, 3.25, 0.17), (0.55, 4.8, 3.35, 0.2)),  # ears
    ((0.85, 3.0, 1.7, 0.85), (0.9, 1.3, 1.9, 0.55)),  # fore legs
    ((0.9, 1.3, 1.9, 0.55), (0.9, 0.4, 2.0, 0.48)),
    ((0.9, 0.33, 2.0, 0.40), (0.9, 0.3, 2.55, 0.36)),  # paws
    ((0.85, 2.9, -2.3, 1.0), (0.9, 1.4, -2.5, 0.6)),  # hind legs
    ((0.9, 1.4, -2.5, 0.6), (0.9, 0.4, -2.6, 0.5)),
    ((0.9, 0.33, -2.6, 0.42), (0.9, 0.3, -1.95, 0.38)),
    ((0.0, 4.0, -3.7, 0.2), (0.0, 3.7, -4.0, 0.16)),  # tail
]
BLEND = 0.35  # units over which two cones flow into one another
NOSE = (0.0, 4.02, 5.32, 0.34)  # what lies within has no fur


SCENES = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "examples", "scenes", "fur")


def give_up(sentence, code):
    print(f"make_meshes.py: {sentence}", file=sys.stderr)
    sys.exit(code)


def cones():
    made = []
    for a, b in BODY:
        made.append((a, b))
        if a[0] != 0.0:
            made.append(((-a[0], *a[1:]), (-b[0], *b[1:])))
    return [(a, tuple(b[k] - a[k] for k in range(4)), 1.0 / sum((b[k] - a[k]) ** 2 for k in range(3))) for a, b in made]


CONES = cones()


def distance(x, y, z):
    """Below 0 inside: the smooth least of all cones, of which those far away do not count."""
    total, least = 0.0, 1e9
    ways = []
    for a, d, over in CONES:
        px, py, pz = x - a[0], y - a[1], z - a[2]
        t = (px * d[0] + py * d[1] + pz * d[2]) * over
        t = 0.0 if t < 0.0 else 1.0 if t > 1.0 else t
        way = math.sqrt((px - t * d[0]) ** 2 + (py - t * d[1]) ** 2 + (pz - t * d[2]) ** 2) - a[3] - t * d[3]
        ways.append(way)
        if way < least:
            least = way
    for way in ways:
        if way - least < 4.0 * BLEND:
            total += math.exp((least - way) / (0.35 * BLEND))
    return least - 0.35 * BLEND * math.log(total)


def sampled():
    low = (-2.6, -0.4, -4.8)
    size = tuple(int(math.ceil(way / CELL)) + 1 for way in (5.2, 6.2, 10.6))
    place = lambda i, j, k: (low[0] + CELL * i, low[1] + CELL * j, low[2] + CELL * k)
    field = {}
    for k in range(size[2]):
        for j in range(size[1]):
            i = 0
            while i < size[0]:
                value = distance(*place(i, j, k))
                # As far from the surface as that, the next samples lie on the same side.
                skip = max(1, int((abs(value) - 0.5 * BLEND) / CELL))
                for n in range(i, min(size[0], i + skip)):
                    field[(n, j, k)] = value
                i += skip
    return field, size, place


def surface_nets():
    """Vertices, and quads of vertex numbers, counter-clockwise seen from outside."""
    field, size, place = sampled()
    corners = [(a, b, c) for a in (0, 1) for b in (0, 1) for c in (0, 1)]
    edges = [(p, q) for p in corners for q in corners if p < q and sum(abs(p[n] - q[n]) for n in range(3)) == 1]
    numbers, vertices = {}, []
    for cell in ((i, j, k) for k in range(size[2] - 1) for j in range(size[1] - 1) for i in range(size[0] - 1)):
        values = {p: field[tuple(cell[n] + p[n] for n in range(3))] for p in corners}
        if all(v > 0.0 for v in values.values()) or all(v <= 0.0 for v in values.values()):
            continue
        crossings = []
        for p, q in edges:
            if (values[p] > 0.0) != (values[q] > 0.0):
                t = values[p] / (values[p] - values[q])
                crossings.append([p[n] + t * (q[n] - p[n]) for n in range(3)])
        middle = [sum(c[n] for c in crossings) / len(crossings) for n in range(3)]
        numbers[cell] = len(vertices)
        vertices.append(place(*(cell[n] + middle[n] for n in range(3))))
    quads = []
    for (i, j, k), value in field.items():
        for axis in range(3):
            step = [0, 0, 0]
            step[axis] = 1
            other = field.get((i + step[0], j + step[1], k + step[2]))
            if other is None or (value > 0.0) == (other > 0.0):
                continue
            u, v = [n for n in range(3) if n != axis]
            if axis == 1:
                u, v = v, u
            ring = []
            for du, dv in ((-1, -1), (0, -1), (0, 0), (-1, 0)):
                cell = [i, j, k]
                cell[u] += du
                cell[v] += dv
                ring.append(numbers.get(tuple(cell)))
            if None not in ring:
                quads.append(ring if value <= 0.0 else ring[::-1])
    return vertices, quads


def bear():
    vertices, quads = surface_nets()
    uvs, uv_numbers, faces = [], {}, {"coat": [], "nose": []}

    def uv_of(vertex, u, v):
        key = (vertex, u, v)
        if key not in uv_numbers:
            uvs.append((vertices[vertex][u] / TILE, vertices[vertex][v] / TILE))
            uv_numbers[key] = len(uvs)
        return uv_numbers[key]

    for quad in quads:
        a, b, c = (vertices[quad[n]] for n in (0, 1, 2))
        p, q = [b[n] - a[n] for n in range(3)], [c[n] - a[n] for n in range(3)]
        normal = [abs(p[1] * q[2] - p[2] * q[1]), abs(p[2] * q[0] - p[0] * q[2]), abs(p[0] * q[1] - p[1] * q[0])]
        u, v = ((2, 1), (0, 2), (0, 1))[normal.index(max(normal))]  # a box projection
        middle = [sum(vertices[n][m] for n in quad) / 4 for m in range(3)]
        bare = sum((middle[m] - NOSE[m]) ** 2 for m in range(3)) < NOSE[3] ** 2
        faces["nose" if bare else "coat"].append([(n + 1, uv_of(n, u, v)) for n in quad])
    lines = ["# A polar bear; z is forward. Made by make_meshes.py.", "mtllib bear.mtl"]
    lines += ["v %.4f %.4f %.4f" % v for v in vertices]
    lines += ["vt %.4f %.4f" % v for v in uvs]
    for name, some in faces.items():
        lines.append(f"usemtl {name}")
        lines += ["f " + " ".join(f"{n}/{t}" for n, t in face) for face in some]
    return "\n".join(lines) + "\n", len(vertices)


MTL = """# The coat of the polar bear: shells, length, thickness, strands along a unit of uv.
newmtl coat
Kd 0.9 0.9 0.85
fur 48 0.419 2.753 11

newmtl nose
Kd 0.03 0.03 0.03
"""


def chunks(data, begin, end, path=()):
    """Each chunk of a 3DS file: the kinds that it lies in and its own, its bytes. A kind is 2 bytes, then 4 of its length."""
    while end - begin >= 6:
        kind, length = struct.unpack_from("<HI", data, begin)
        if not 6 <= length <= end - begin:
            raise ValueError(f"the chunk at byte {begin} is longer than what it lies in")
        inner = begin + 6
        yield (*path, kind), data[inner:begin + length]
        if kind == 0x4000:  # an object: its name, then chunks
            inner = data.index(b"\0", inner) + 1
        elif kind == 0x4120:  # faces: a list, then chunks
            inner += 2 + 8 * struct.unpack_from("<H", data, inner)[0]
        if kind in (0x4D4D, 0x3D3D, 0x4000, 0x4100, 0x4120):
            yield from chunks(data, inner, begin + length, (*path, kind))
        begin += length


def obj_of_3ds(data):
    """An OBJ of the vertices, uv, faces and materials; exact, without normals. Pitts 1994, The 3D Studio file format."""
    meshes = []
    for path, body in chunks(data, 0, len(data)):
        if path[-1] == 0x4100:
            meshes.append({"v": [], "vt": [], "faces": [], "materials": []})
        elif path[-1] in (0x4110, 0x4140):  # vertices, uv: as many
            key, size = ("v", 3) if path[-1] == 0x4110 else ("vt", 2)
            meshes[-1][key] = struct.iter_unpack(f"<{size}f", body[2:2 + 4 * size * struct.unpack_from("<H", body)[0]])
        elif path[-1] == 0x4120:
            meshes[-1]["faces"] = [face[:3] for face in struct.iter_unpack("<4H", body[2:2 + 8 * struct.unpack_from("<H", body)[0]])]
        elif path[-1] == 0x4130:  # which of these faces have a material
            name, _, numbers = body.partition(b"\0")
            meshes[-1]["materials"].append((name.decode("ascii"), [number for number, in struct.iter_unpack("<H", numbers[2:])]))
    lines, first = ["# Made by make_meshes.py from a 3DS file."], 1
    for mesh in meshes:
        rows = {key: [" ".join([key, *("%.9g" % value for value in row)]) for row in mesh[key]] for key in ("v", "vt")}
        lines += rows["v"] + rows["vt"]
        for name, numbers in mesh["materials"]:
            lines.append(f"usemtl {name}")
            for face in (mesh["faces"][number] for number in numbers):
                lines.append("f " + " ".join(f"{first + n}/{first + n}" if rows["vt"] else str(first + n) for n in face))
        first += len(rows["v"])
    return "\n".join(lines) + "\n"


def write(path, text):
    with open(path + ".part", "w", encoding="ascii") as file:
        file.write(text)
    os.replace(path + ".part", path)


def main():
    parser = argparse.ArgumentParser(description="The meshes that the scenes of examples/scenes/fur name.")
    parser.add_argument("--from", dest="source", default=PACKAGE, help=f"folder with {' and '.join(TAKEN)}; default: {PACKAGE}")
    parser.add_argument("--out", default=SCENES, help="where they go; default: beside the scenes")
    options = parser.parse_args()
    missing = [name for name in TAKEN if not os.path.isfile(os.path.join(options.source, name))]
    made = ["bear.mtl"]
    try:
        for name in TAKEN:
            if name in missing:
                continue
            with open(os.path.join(options.source, name), "rb") as file:
                data = file.read()
            text = data.decode("ascii") if name.endswith(".obj") else obj_of_3ds(data)
            made.append(name.replace(".3ds", ".obj"))
            write(os.path.join(options.out, made[-1]), text)
        text, count = bear()
        write(os.path.join(options.out, "bear.mtl"), MTL)
        write(os.path.join(options.out, "bear.obj"), text)
    except OSError as error:
        give_up(f"{options.out} cannot be written into ({error.strerror}); name a folder that you may write to.", 2)
    print(f"{options.out}: bear.obj of {count} vertices, {', '.join(made)}")
    if missing:
        give_up(f"{options.source} has no {' and no '.join(missing)}; install glmark2-data (./dev setup), or name another "
                "folder with --from.", 3)


if __name__ == "__main__":
    main()
