#!/usr/bin/env python3
"""make_ground.py [SURVEY.npz [GROUND.pgm]]: the ground of meadow.json from a survey of real terrain.

Reads the digital elevation model of the country around the Jacksboro fault, Tennessee (Debian's python-matplotlib-data:
344 x 403 heights in whole metres, 3 arc seconds apart, from north to south and west to east) and writes a PGM of 16 bits
that a scene's `picture.ground.heights` names. Needs Python alone.

How it is scaled: 1 to 15 in all three directions, so that every slope is the survey's. 30 km x 32 km become 1996 m x
2120 m, 840 m of relief become 56 m. Heights between the survey's are Catmull-Rom's cubic, which passes through each of
them; the grid is 4 m, as fine as the survey's own (5 m x 6.2 m at this scale). East is +x, south is +z; 0 and 65535 are
the lowest and the highest height, told on stdout as the scene file wants them.
"""
import array
import math
import os
import struct
import sys
import zipfile

SURVEY = "/usr/share/matplotlib/mpl-data/sample_data/jacksboro_fault_dem.npz"
SCALE = 15.0  # metres of the country a metre of the scene
SPACING = 4.0  # [m] between samples of the scene
EARTH = 6371008.8  # [m] mean radius


SCENES = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "examples", "scenes")


def give_up(sentence, code):
    print(f"make_ground.py: {sentence}", file=sys.stderr)
    sys.exit(code)


def member(archive, name):
    """Header and bytes of one array of an .npz: the format of NumPy's files, version 1."""
    data = archive.read(f"{name}.npy")
    if data[:7] != b"\x93NUMPY\x01":
        raise ValueError(f"{name}.npy is not an array file of version 1")
    (length,) = struct.unpack_from("<H", data, 8)
    return data[10 : 10 + length].decode("latin-1"), data[10 + length :]


def read_survey(path):
    """Rows of heights [m], and the distance between samples along x and z [m]."""
    with zipfile.ZipFile(path) as archive:
        header, body = member(archive, "elevation")
        if "'<i2'" not in header or "'fortran_order': False" not in header:
            raise ValueError("its heights are not rows of 16-bit integers")
        rows, columns = (int(part) for part in header.split("'shape': (")[1].split(")")[0].split(","))
        number = lambda name: struct.unpack("<d", member(archive, name)[1])[0]
        step_x, step_z = number("dx"), number("dy")
        middle = 0.5 * (number("ymin") + number("ymax"))
    if len(body) != 2 * rows * columns:
        raise ValueError(f"it should hold {2 * rows * columns} bytes of heights and holds {len(body)}")
    heights = struct.unpack(f"<{rows * columns}h", body)
    metres = math.radians(1.0) * EARTH
    spacing = (step_x * metres * math.cos(math.radians(middle)), step_z * metres)
    return [heights[row * columns : (row + 1) * columns] for row in range(rows)], spacing


def resampled(line, ratio, count):
    """`count` values along a line, `ratio` samples apart."""
    last = len(line) - 1
    made = []
    for n in range(count):
        place = n * ratio
        cell = min(int(place), last - 1)
        t = place - cell
        a, b, c, d = (line[min(max(cell + k, 0), last)] for k in (-1, 0, 1, 2))
        made.append(b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a))))
    return made


def main():
    if len(sys.argv) > 3 or (len(sys.argv) > 1 and sys.argv[1].startswith("-")):
        give_up("usage: make_ground.py [SURVEY.npz [GROUND.pgm]]", 2)
    survey = sys.argv[1] if len(sys.argv) > 1 else SURVEY
    ground = sys.argv[2] if len(sys.argv) > 2 else os.path.join(SCENES, "ground.pgm")
    try:
        lines, spacing = read_survey(survey)
    except FileNotFoundError:
        give_up(f"{survey} does not exist; install python-matplotlib-data (./dev setup), or name another survey.", 3)
    except (OSError, ValueError, KeyError, IndexError, struct.error, zipfile.BadZipFile) as error:
        give_up(f"{survey} is no such survey ({error}); give the .npz of Debian's python-matplotlib-data.", 2)

    ratio = [SPACING * SCALE / step for step in spacing]
    columns = int((len(lines[0]) - 1) / ratio[0]) + 1
    rows = int((len(lines) - 1) / ratio[1]) + 1
    across = [resampled(line, ratio[0], columns) for line in lines]
    down = [resampled(column, ratio[1], rows) for column in zip(*across)]
    low, high = min(map(min, down)), max(map(max, down))
    values = array.array("H", (round(65535.0 * (down[x][z] - low) / (high - low)) for z in range(rows) for x in range(columns)))
    if sys.byteorder == "little":
        values.byteswap()  # a PGM has the high byte first

    beside = ground + ".part"
    try:
        with open(beside, "wb") as file:
            file.write(b"P5\n%d %d\n65535\n" % (columns, rows))
            values.tofile(file)
        os.replace(beside, ground)
    except OSError as error:
        if os.path.exists(beside):
            os.remove(beside)
        give_up(f"{ground} cannot be written ({error.strerror}); name a place that you may write to.", 2)
    extent = ((columns - 1) * SPACING, (rows - 1) * SPACING)
    print(f'{ground}: {columns} x {rows} samples, "extent": [{extent[0]:g}, {extent[1]:g}], '
          f'"low": {(low - low) / SCALE:g}, "high": {(high - low) / SCALE:.3f}')


if __name__ == "__main__":
    main()
