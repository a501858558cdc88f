#!/usr/bin/env python3
"""unusual_files_test.py WINDROW: sixteen damaged or unusual files of each kind that a scene names. Each is read as the plain file that it
stands for, so that the air is the same to the byte, or ends the command with 2 and one sentence that names the file.

A kind is a function that yields (name, bytes, expected): None for the plain file's air, "other" for an air of its own, else words of
the sentence.
"""
import json
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import zlib

FRAMES = 2

# --- Meshes --------------------------------------------------------------------------------------------------------------------

CORNERS = [(-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)]
FACES = [(1, 4, 3, 2), (5, 6, 7, 8), (1, 2, 6, 5), (4, 8, 7, 3), (1, 5, 8, 4), (2, 3, 7, 6)]


def obj(vertex="v {} {} {}", face=lambda face: "f " + " ".join(map(str, face)), end="\n", faces=FACES):
    lines = [vertex.format(*corner) for corner in CORNERS] + [face(one) for one in faces]
    return (end.join(lines) + end).encode()


def meshes():
    yield "plain", obj(), None
    yield "carriage_returns", obj(end="\r\n"), None
    yield "byte_order_mark", b"\xef\xbb\xbf" + obj(), None
    yield "counted_from_the_end", obj(face=lambda face: "f " + " ".join(str(n - 9) for n in face)), None
    yield "with_texture_and_normal", b"vt 0 0\nvn 0 1 0\n" + obj(face=lambda face: "f " + " ".join(f"{n}/1/1" for n in face)), None
    yield "with_normal_alone", b"vn 0 1 0\n" + obj(face=lambda face: "f " + " ".join(f"{n}//1" for n in face)), None
    yield "coloured_vertices", obj(vertex="v {} {} {} 0.5 0.25 1"), None
    yield "no_last_line_end", obj().rstrip(b"\n"), None
    yield "comments_groups_materials", b"# Blender\nmtllib no.mtl\no Cube\ng a b\ns off\nusemtl stone\n" + obj() + b"# end\n", None
    yield "tabs", obj().replace(b" ", b"\t"), None
    yield "exponents", obj(vertex="v {}e0 {}E+0 {}.0"), None
    yield "index_beyond", obj(face=lambda face: "f " + " ".join(str(n + 1) for n in face)), "9"
    yield "index_zero", obj(face=lambda face: "f " + " ".join(str(n - 1) for n in face)), "0"
    yield "open", obj(faces=FACES[:5]), "open"
    yield "no_number", obj().replace(b"v 1 -1 -1", b"v 1 -1 nan"), "nan"
    yield "two_numbers", obj().replace(b"v 1 -1 -1\n", b"v 1 -1\n"), "2"
    yield "empty", b"", "no "
    yield "binary", bytes(range(256)) * 4, ""


# --- Voxels --------------------------------------------------------------------------------------------------------------------


def chunk(name, content=b"", children=b""):
    return name + struct.pack("<II", len(content), len(children)) + content + children


def size_and_voxels(size=(2, 2, 2), voxels=None):
    if voxels is None:
        voxels = [(x, y, z) for x in range(size[0]) for y in range(size[1]) for z in range(size[2])]
    return chunk(b"SIZE", struct.pack("<III", *size)) + chunk(
        b"XYZI", struct.pack("<I", len(voxels)) + b"".join(struct.pack("<BBBB", *voxel, 1) for voxel in voxels))


def vox(children=None, version=150):
    return b"VOX " + struct.pack("<I", version) + chunk(b"MAIN", b"", size_and_voxels() if children is None else children)


def voxels():
    yield "plain", vox(), None
    yield "version_200", vox(version=200), None
    yield "with_palette", vox(size_and_voxels() + chunk(b"RGBA", bytes(1024))), None
    yield "unknown_chunk", vox(chunk(b"ABCD", b"xyz") + size_and_voxels()), None
    yield "unknown_chunk_behind", vox(size_and_voxels() + chunk(b"NOTE", b"xyz")), None
    yield "pack_of_one", vox(chunk(b"PACK", struct.pack("<I", 1)) + size_and_voxels()), None
    yield "voxel_twice", vox(size_and_voxels(voxels=[(x, y, z) for x in range(2) for y in range(2) for z in range(2)] * 2)), None
    yield "bytes_behind", vox() + b"junk", "beyond"
    yield "one_voxel", vox(size_and_voxels(voxels=[(1, 1, 1)])), "other"
    yield "two_models", vox(size_and_voxels() * 2), "model"
    yield "no_voxel", vox(size_and_voxels(voxels=[])), "voxel"
    yield "voxel_outside", vox(size_and_voxels(voxels=[(5, 0, 0)])), "5"
    yield "no_model", vox(b""), ""
    yield "size_zero", vox(size_and_voxels(size=(0, 2, 2), voxels=[])), ""
    yield "size_huge", vox(size_and_voxels(size=(2 ** 31, 2 ** 31, 2 ** 31), voxels=[(0, 0, 0)])), ""
    yield "cut", vox()[:40], ""
    yield "another_file", b"RIFF" + vox(), ""
    yield "empty", b"", ""


# --- Heights -------------------------------------------------------------------------------------------------------------------

WIDE, HIGH = 24, 20
LEVELS = [[(40 + 3 * x + 2 * y + 8 * (x * y % 5)) for x in range(WIDE)] for y in range(HIGH)]  # of 255
FLAT = [level for row in LEVELS for level in row]


def pgm(head=f"P5\n{WIDE} {HIGH}\n255\n", content=bytes(FLAT)):
    return head.encode() + content


def words(order, factor=257):
    return b"".join(struct.pack(order + "H", factor * level) for level in FLAT)


def pgms():
    yield "plain", pgm(), None
    yield "16_bits", pgm(f"P5\n{WIDE} {HIGH}\n65535\n", words(">")), None
    yield "text", (f"P2\n{WIDE} {HIGH}\n255\n" + " ".join(map(str, FLAT))).encode(), None
    yield "text_in_lines", (f"P2\n{WIDE} {HIGH}\n255\n" + "\n".join(map(str, FLAT)) + "\n").encode(), None
    yield "comment", pgm(f"P5\n# made by hand\n{WIDE} {HIGH}\n255\n"), None
    yield "comment_in_a_line", pgm(f"P5 {WIDE} # wide\n{HIGH} 255\n"), None
    yield "one_line_head", pgm(f"P5 {WIDE} {HIGH} 255 "), None
    yield "carriage_returns", pgm(f"P5\r\n{WIDE} {HIGH}\r\n255\n"), None
    yield "bytes_behind", pgm() + b"\n\n", None
    yield "cut", pgm()[:-7], ""
    yield "no_pixels", pgm(content=b""), ""
    yield "colour", pgm(f"P6\n{WIDE} {HIGH}\n255\n", bytes(v for level in FLAT for v in (level, level, 255 - level))), ""
    yield "bits", f"P1\n{WIDE} {HIGH}\n".encode() + b"0 " * (WIDE * HIGH), ""
    yield "size_zero", pgm(f"P5\n0 {HIGH}\n255\n"), ""
    yield "size_negative", pgm(f"P5\n-{WIDE} {HIGH}\n255\n"), ""
    yield "size_huge", pgm("P5\n99999999 99999999\n255\n"), ""
    yield "most_zero", pgm(f"P5\n{WIDE} {HIGH}\n0\n"), ""
    yield "most_100000", pgm(f"P5\n{WIDE} {HIGH}\n100000\n"), ""
    yield "empty", b"", ""


def png(kind=0, bits=8, rows=None, wide=WIDE, high=HIGH, before=lambda part: b"", damage=None, junk=b""):
    if rows is None:
        rows = [bytes(row) for row in LEVELS]
    def part(name, content):
        return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))
    head = part(b"IHDR", struct.pack(">IIBBBBB", wide, high, bits, kind, 0, 0, 0))
    image = part(b"IDAT", zlib.compress(b"".join(b"\0" + row for row in rows)))
    if damage == "checksum":
        image = image[:-1] + bytes([image[-1] ^ 1])
    if damage == "stream":
        image = part(b"IDAT", b"\x78\x9c" + bytes(50))
    return b"\x89PNG\r\n\x1a\n" + head + before(part) + image + part(b"IEND", b"") + junk


def pngs():
    yield "plain", png(), None
    yield "16_bits", png(bits=16, rows=[b"".join(struct.pack(">H", 257 * v) for v in row) for row in LEVELS]), None
    yield "grey_with_alpha", png(kind=4, rows=[b"".join(bytes([v, 255]) for v in row) for row in LEVELS]), None
    yield "grey_as_colour", png(kind=2, rows=[b"".join(bytes([v, v, v]) for v in row) for row in LEVELS]), None
    yield "grey_as_colour_with_alpha", png(kind=6, rows=[b"".join(bytes([v, v, v, 255]) for v in row) for row in LEVELS]), None
    yield "text_beside", png(before=lambda part: part(b"tEXt", b"Author\0me")), None
    yield "resolution_beside", png(before=lambda part: part(b"pHYs", struct.pack(">IIB", 2835, 2835, 1))), None
    yield "gamma_beside", png(before=lambda part: part(b"gAMA", struct.pack(">I", 45455))), None
    yield "bytes_behind", png(junk=b"junk"), None
    yield "colours", png(kind=2, rows=[b"".join(bytes([v, 255 - v, 7]) for v in row) for row in LEVELS]), ""
    yield "a_bit", png(bits=1, rows=[bytes(WIDE // 8) for _ in LEVELS]), "other"
    yield "cut", png()[:90], ""
    yield "checksum", png(damage="checksum"), ""
    yield "stream", png(damage="stream"), ""
    yield "size_zero", png(wide=0), ""
    yield "size_huge", png(wide=2 ** 30, high=2 ** 30), ""
    yield "head_alone", png()[:33], ""
    yield "empty", b"", ""


def tiff(order="<", kind=3, bits=32, content=None, tags=(), samples=1, big=False, wide=WIDE, high=HIGH):
    """kind: 1 whole numbers, 2 with a sign, 3 floats. Heights are metres."""
    if content is None:
        letter = {(1, 8): "B", (1, 16): "H", (2, 16): "h", (3, 32): "f", (3, 64): "d", (1, 32): "I", (2, 32): "i"}[kind, bits]
        content = b"".join(struct.pack(order + letter, level) * samples for level in FLAT)
    entries = [(256, 4, wide), (257, 4, high), (258, 3, bits), (259, 3, 1), (262, 3, 1), (273, 4, 8), (277, 3, samples),
               (278, 4, high), (279, 4, len(content)), (339, 3, kind)]
    if samples > 1:
        entries[2] = (258, 3, [bits] * samples)
        entries[9] = (339, 3, [kind] * samples)
        entries[4] = (262, 3, 2)
    entries += list(tags)
    beside, table = b"", b""
    begin = 8 + len(content)
    beside_at = begin + 2 + 12 * len(entries) + 4
    for tag, of, value in sorted(entries, key=lambda entry: entry[0]):
        if of == 2:
            data, count = value, len(value)
        else:
            values = value if isinstance(value, list) else [value]
            data, count = b"".join(struct.pack(order + {3: "H", 4: "I", 12: "d"}[of], one) for one in values), len(values)
        if len(data) > 4:
            field = struct.pack(order + "I", beside_at + len(beside))
            beside += data
        else:
            field = data.ljust(4, b"\0")
        table += struct.pack(order + "HHI", tag, of, count) + field
    return (b"II" if order == "<" else b"MM") + struct.pack(order + "HI", 42, begin) + content + \
        struct.pack(order + "H", len(entries)) + table + struct.pack(order + "I", 0) + beside


def tiffs():
    with_hole = b"".join(struct.pack("<f", -9999 if n == 200 else level) for n, level in enumerate(FLAT))
    nan = b"".join(struct.pack("<f", float("nan") if n == 200 else level) for n, level in enumerate(FLAT))
    yield "plain", tiff(), None
    yield "high_byte_first", tiff(">"), None
    yield "doubles", tiff(kind=3, bits=64), None
    yield "with_a_sign", tiff(kind=2, bits=16), None
    yield "with_a_sign_high_byte_first", tiff(">", kind=2, bits=16), None
    yield "author_beside", tiff(tags=[(315, 2, b"me and my camera\0")]), None
    yield "no_data_unused", tiff(tags=[(42113, 2, b"-9999\0")]), None
    yield "bytes_behind", tiff() + b"junk", None
    yield "no_data_filled", tiff(content=with_hole, tags=[(42113, 2, b"-9999\0")]), "other"
    yield "pixels_of_2_m", tiff(tags=[(33550, 12, [2.0, 2.0, 0.0])]), None  # the scene gives a scale
    yield "whole_numbers", tiff(kind=1, bits=16), "other"  # parts of white, as PGM
    yield "void_without_a_tag", tiff(content=with_hole), "other"
    yield "no_numbers", tiff(content=nan), "other"
    yield "colours", tiff(kind=1, bits=8, samples=3, content=bytes(v for n in FLAT for v in (n, 255 - n, 3))), ""
    yield "cut", tiff()[:900], ""
    yield "size_zero", tiff(wide=0), ""
    yield "size_huge", tiff(wide=2 ** 30, high=2 ** 30), ""
    yield "empty", b"", ""


def grids():
    head = f"ncols {WIDE}\nnrows {HIGH}\nxllcorner 0\nyllcorner 0\ncellsize 1\n"
    lines = "\n".join(" ".join(map(str, row)) for row in LEVELS) + "\n"
    yield "plain", (head + lines).encode(), None
    yield "capitals", (head.upper() + lines).encode(), None
    yield "carriage_returns", (head + lines).replace("\n", "\r\n").encode(), None
    yield "centres", (head.replace("corner", "center") + lines).encode(), None
    yield "no_data_unused", (head + "NODATA_value -9999\n" + lines).encode(), None
    yield "in_one_line", (head + lines.replace("\n", " ")).encode(), None
    yield "points", (head + lines.replace(" ", ".0 ").replace("\n", "e0\n")).encode(), None
    yield "byte_order_mark", b"\xef\xbb\xbf" + (head + lines).encode(), None
    yield "no_data_filled", (head + "NODATA_value -9999\n" + lines.replace("40", "-9999", 1)).encode(), "other"
    yield "cells_of_2_m", (head.replace("cellsize 1", "cellsize 2") + lines).encode(), None
    yield "a_number_less", (head + lines.rsplit(" ", 1)[0]).encode(), ""
    yield "a_number_more", (head + lines + "7\n").encode(), ""
    yield "a_word", (head + lines.replace("40", "forty", 1)).encode(), "forty"
    yield "a_decimal_comma", (head + lines.replace("40", "40,5", 1)).encode(), ""
    yield "no_columns", (head.split("\n", 1)[1] + lines).encode(), ""
    yield "size_huge", (head.replace(str(WIDE), "99999999", 1) + lines).encode(), ""
    yield "infinite", (head + lines.replace("40", "inf", 1)).encode(), "other"
    yield "empty", b"", ""


# --- Tables and scenes ------------------------------------------------------------------------------------------------------------

TABLE = "t,x,y,z\n0,-3,0,0\n0.5,0,1,0\n1,3,0,1\n"


def tables():
    yield "plain", TABLE.encode(), None
    yield "no_names", TABLE.split("\n", 1)[1].encode(), None
    yield "carriage_returns", TABLE.replace("\n", "\r\n").encode(), None
    yield "byte_order_mark", b"\xef\xbb\xbf" + TABLE.encode(), None
    yield "comments", ("# a walk\n\n" + TABLE + "\n# end\n").encode(), None
    yield "blanks", TABLE.replace(",", " , ").encode(), None
    yield "no_last_line_end", TABLE.rstrip("\n").encode(), None
    yield "exponents", TABLE.replace("-3,", "-3.0e0,").encode(), None
    yield "quoted", TABLE.replace("t,x,y,z", '"t","x","y","z"').encode(), "order"
    yield "semicolons", TABLE.replace(",", ";").encode(), ""
    yield "decimal_commas", TABLE.replace("0.5,", "0,5,").encode(), ""
    yield "a_column_less", TABLE.replace(",0\n", "\n", 1).encode(), ""
    yield "times_fall", TABLE.replace("0.5,", "-1,").encode(), ""
    yield "no_number", TABLE.replace("0.5,0", "0.5,nan").encode(), "nan"
    yield "infinite", TABLE.replace("0.5,0", "0.5,inf").encode(), "inf"
    yield "names_alone", b"t,x,y,z\n", ""
    yield "wide_letters", TABLE.encode("utf-16"), ""
    yield "empty", b"", ""


def scenes():
    plain = json.dumps(scene_of({}))
    yield "plain", plain.encode(), None
    yield "byte_order_mark", b"\xef\xbb\xbf" + plain.encode(), None
    yield "spread", json.dumps(scene_of({}), indent=4).replace("\n", "\r\n").encode(), None
    yield "escapes", plain.replace('"air"', '"\\u0061ir"').encode(), None
    yield "numbers_with_points", plain.replace("[4, 0, 1]", "[4.0, 0e0, 1.00]").encode(), None
    yield "key_twice", plain.replace('{"air"', '{"duration": 3, "duration": 3, "air"').encode(), "duration"
    yield "comment", ("// mine\n" + plain).encode(), "1:1"
    yield "last_comma", (plain[:-1] + ",}").encode(), ""
    yield "cut", plain[:-9].encode(), ""
    yield "behind", (plain + "x").encode(), ""
    yield "array", b"[]", ""
    yield "not_a_number", plain.replace("[4, 0, 1]", "[NaN, 0, 1]").encode(), "NaN"
    yield "too_large", plain.replace("[4, 0, 1]", "[1e999, 0, 1]").encode(), "1e999"
    yield "wrong_kind", plain.replace("[4, 0, 1]", '"4"').encode(), "ambient"
    yield "unknown_key", plain.replace('"ambient"', '"ambiant"').encode(), "ambient"
    yield "wide_letters", plain.encode("utf-16"), ""
    yield "deep", b"[" * 100000, ""
    yield "empty", b"", ""


def scene_of(more):
    return {"air": {"cells": [24, 8, 20], "ambient": [4, 0, 1], "boundaries": {"y_low": "free_slip"}}, "tick_hz": 30} | more


def body(shape):
    return scene_of({"obstacles": [{"position": [0, 2, 0], "shape": shape}]})


def ground(name, scale):
    return scene_of({"obstacles": [{"position": [-12, 0, -10], "shape": {"ground": {"file": name, "scale": scale}}}]})


KINDS = {
    "obj": (meshes, lambda name: body({"mesh": {"file": name}})),
    "vox": (voxels, lambda name: body({"voxels": {"file": name, "cell_size": 1.5}})),
    "pgm": (pgms, lambda name: ground(name, [1, 6, 1])),
    "png": (pngs, lambda name: ground(name, [1, 6, 1])),
    "tif": (tiffs, lambda name: ground(name, [1, 0.02, 1])),
    "asc": (grids, lambda name: ground(name, [1, 0.02, 1])),
    "csv": (tables, lambda name: scene_of({"paths": {"way": {"file": name}}, "motors": [
        {"kind": "wake", "path": "way", "radius": 0.6}]})),
    "json": (scenes, None),
}


def air_of(windrow, folder, scene):
    """(exit code, what it says, the bytes of its last frame)"""
    for old in folder.glob("out/*"):
        old.unlink()
    done = subprocess.run([windrow, "run", scene, "--frames", str(FRAMES), "--vdb", "--threads", "1", "--out", folder / "out"],
                          capture_output=True, cwd=folder, timeout=60, check=False)
    written = sorted(folder.glob("out/*.vdb"))
    air = written[-1].read_bytes() if written else b""
    said = re.sub("^libpng error: .*\n", "", done.stderr.decode("utf-8", "replace"), flags=re.M)  # the library's own
    return done.returncode, said, re.sub(rb"[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}", b"", air)


def main(windrow):
    windrow = str(pathlib.Path(windrow).resolve())
    faults = []
    for kind, (cases, scene) in KINDS.items():
        count, plain = 0, None
        for name, content, expected in cases():
            count += 1
            with tempfile.TemporaryDirectory() as made:
                folder = pathlib.Path(made)
                file = folder / f"it.{kind}"
                file.write_bytes(content)
                if scene is not None:
                    (folder / "scene.json").write_text(json.dumps(scene(file.name)))
                code, said, air = air_of(windrow, folder, "scene.json" if scene is not None else file.name)
            wrong = None
            if plain is None:
                plain = air
            if expected in (None, "other"):
                if code != 0:
                    wrong = f"ends with {code}: {said}"
                elif (air == plain) != (expected is None):
                    wrong = "has the plain file's air" if expected else "has another air than the plain file"
            elif code != 2 or file.name not in said or expected not in said or "\n" in said.strip():
                wrong = f"ends with {code} and not with one sentence with {file.name} and {expected!r}: {said}"
            if "--show" in sys.argv:
                print(f"{kind} {name}: {code} {said.strip() if code else ''}")
            if wrong:
                faults.append(f"{kind} {name} {wrong}")
        print(f"{kind}: {count} files")
        if count < 16:
            faults.append(f"{kind} has {count} files")
    print("\n".join(faults) or "no fault")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
