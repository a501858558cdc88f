#!/usr/bin/env python3
"""make_shapes.py [FOLDER]: the shapes of example scenes, by default in examples/scenes. Needs Python alone.

tower.vox   a round tower with a door and battlements, as a MagicaVoxel file: 16 by 16 by 24 cells, walls of two cells
ridge.pgm   a ridge with a pass, steeper on its lee, as heights of 16 bits: 193 by 97 pixels, white is the highest summit
"""
import math
import pathlib
import struct
import sys

SIDE, HEIGHT, WALL, FLOOR = 16, 24, 2, 20
STONE = 79  # of the usual palette
ACROSS, ALONG = 193, 97


def closed(x, y, z):
    away = math.hypot(x + 0.5 - SIDE / 2, y + 0.5 - SIDE / 2)
    if away > SIDE / 2:
        return False
    if away < SIDE / 2 - WALL:
        return z == FLOOR
    if z < 5 and y < SIDE / 2 and abs(x + 0.5 - SIDE / 2) < 2:
        return False  # the door
    return z < HEIGHT - 2 or int(8 * (math.atan2(y - 7.5, x - 7.5) / math.pi + 1)) % 2 == 0


def chunk(name, content):
    return name + struct.pack("<ii", len(content), 0) + content


def tower():
    cells = [(x, y, z) for z in range(HEIGHT) for y in range(SIDE) for x in range(SIDE) if closed(x, y, z)]
    chunks = chunk(b"SIZE", struct.pack("<iii", SIDE, SIDE, HEIGHT))
    chunks += chunk(b"XYZI", struct.pack("<i", len(cells)) + b"".join(struct.pack("BBBB", *cell, STONE) for cell in cells))
    return b"VOX " + struct.pack("<i", 150) + b"MAIN" + struct.pack("<ii", 0, len(chunks)) + chunks


def ridge_height(x, z):
    """0 to 1, a pixel a metre."""
    away = x - (90 + 6 * math.sin(z / 17))
    crest = 1 - 0.45 * math.exp(-(((z - 60) / 11) ** 2))  # the pass
    return crest * math.exp(-0.5 * (away / (17 if away < 0 else 10)) ** 2)


def ridge():
    levels = [round(65535 * ridge_height(x, z)) for z in range(ALONG) for x in range(ACROSS)]
    return b"P5\n%d %d\n65535\n" % (ACROSS, ALONG) + struct.pack(">%dH" % len(levels), *levels)


def main():
    if len(sys.argv) > 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) == 2 else pathlib.Path(__file__).parent.parent / "examples/scenes")
    (folder / "tower.vox").write_bytes(tower())
    (folder / "ridge.pgm").write_bytes(ridge())


if __name__ == "__main__":
    main()
