#!/usr/bin/env python3
"""make_hills.py: the ground of far_hills.json, hills.pgm, from a sum of sines.

65 x 65 heights of 16 bits, as smooth as a 4 m grid shows them: two ranges across each other and a shallow bowl.
"""
import array
import math
import pathlib
import sys

SIDE = 65


def share(u, v):
    """Height from 0 to 1 at a place of the unit square."""
    ranges = math.sin(9.0 * u + 2.0 * v + 0.6) * math.cos(7.0 * v - 3.0 * u)
    return 0.5 + 0.32 * ranges + 0.16 * (4.0 * (u - 0.5) ** 2 + 4.0 * (v - 0.5) ** 2 - 1.0)


values = array.array("H", (round(65535 * share(x / (SIDE - 1), z / (SIDE - 1))) for z in range(SIDE) for x in range(SIDE)))
if sys.byteorder == "little":
    values.byteswap()
with open(pathlib.Path(__file__).with_name("hills.pgm"), "wb") as file:
    file.write(b"P5\n%d %d\n65535\n" % (SIDE, SIDE) + values.tobytes())
