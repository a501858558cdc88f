#!/usr/bin/env python3
"""make_tower.py [FILE]: examples/scenes/tower.vox, a round tower with a door and battlements, as a MagicaVoxel file.

16 by 16 by 24 cells, walls of two cells. Needs Python alone.
"""
import math
import pathlib
import struct
import sys

SIDE, HEIGHT, WALL, FLOOR = 16, 24, 2, 20
STONE = 79  # of the usual palette


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


def main():
    if len(sys.argv) > 2:
        sys.exit(__doc__)
    file = pathlib.Path(sys.argv[1] if len(sys.argv) == 2 else pathlib.Path(__file__).parent.parent / "examples/scenes/tower.vox")
    cells = [(x, y, z) for z in range(HEIGHT) for y in range(SIDE) for x in range(SIDE) if closed(x, y, z)]
    chunks = chunk(b"SIZE", struct.pack("<iii", SIDE, SIDE, HEIGHT))
    chunks += chunk(b"XYZI", struct.pack("<i", len(cells)) + b"".join(struct.pack("BBBB", *cell, STONE) for cell in cells))
    file.write_bytes(b"VOX " + struct.pack("<i", 150) + b"MAIN" + struct.pack("<ii", 0, len(chunks)) + chunks)


if __name__ == "__main__":
    main()
