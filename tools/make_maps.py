#!/usr/bin/env python3
"""make_maps.py [--out FOLDER]: the maps that the scenes of examples/scenes/fur name, painted with strokes and formulas.

  horse_length.pgm    how long the horse's hair is, seen from the front: mane and tail long, legs short, hooves bald
  bunny_length.pgm    how long the bunny's fur is, seen from the front: short on the face and feet, hardly any in the ears
  bunny_colour.ppm    its colour: white on chest, muzzle and tail
  bands.ppm           the paper of the pinata, in bands

PGM and PPM of 8 bits. A stroke is a line with a radius, soft at its rim, in shares of the picture from its upper left corner.
Needs Python alone.
"""
import argparse
import os
import sys

SIDE = 256  # [px]


def smooth(t):
    t = min(max(t, 0.0), 1.0)
    return t * t * (3.0 - 2.0 * t)


class Picture:
    """Values 0 to 1, of one or three channels."""

    def __init__(self, ground, width=SIDE, height=SIDE):
        self.width, self.height = width, height
        self.values = [ground] * (width * height)

    def stroke(self, value, a, b, radius, soft, end_radius=None):
        end_radius = radius if end_radius is None else end_radius
        way = (b[0] - a[0], b[1] - a[1])
        over = way[0] ** 2 + way[1] ** 2
        for row in range(self.height):
            y = (row + 0.5) / self.height
            for column in range(self.width):
                x = (column + 0.5) / self.width
                t = 0.0 if over == 0.0 else min(max(((x - a[0]) * way[0] + (y - a[1]) * way[1]) / over, 0.0), 1.0)
                far = ((x - a[0] - t * way[0]) ** 2 + (y - a[1] - t * way[1]) ** 2) ** 0.5 - radius - t * (end_radius - radius)
                share = 1.0 - smooth(far / soft + 0.5)
                if share > 0.0:
                    n = row * self.width + column
                    self.values[n] = tuple(o + share * (v - o) for o, v in zip(self.values[n], value))

    def write(self, path):
        kind = b"P5" if len(self.values[0]) == 1 else b"P6"
        data = bytes(round(255.0 * min(max(channel, 0.0), 1.0)) for value in self.values for channel in value)
        with open(path + ".part", "wb") as file:
            file.write(b"%s\n%d %d\n255\n" % (kind, self.width, self.height) + data)
        os.replace(path + ".part", path)


def horse_length():
    made = Picture((0.28,))
    for a, b in (((0.28, 0.7), (0.3, 0.97)), ((0.42, 0.78), (0.6, 0.97)), ((0.7, 0.22), (1.0, 0.28)), ((0.8, 0.18), (0.92, 0.16))):
        made.stroke((0.1,), a, b, 0.09, 0.08)  # legs
    made.stroke((0.12,), (0.25, 0.18), (0.36, 0.06), 0.08, 0.06)  # face
    for a, b in (((0.4, 0.03), (0.62, 0.1)), ((0.42, 0.06), (0.55, 0.26))):
        made.stroke((1.0,), a, b, 0.05, 0.05)  # mane
    made.stroke((1.0,), (0.2, 0.6), (0.06, 0.95), 0.05, 0.06, 0.12)  # tail
    made.stroke((0.0,), (0.27, 0.985), (0.8, 0.985), 0.03, 0.012)  # hooves
    made.stroke((0.0,), (1.0, 0.25), (1.0, 0.3), 0.03, 0.012)
    return made


def bunny_length():
    made = Picture((1.0,))
    made.stroke((0.3,), (0.06, 0.36), (0.2, 0.3), 0.13, 0.12)  # face
    made.stroke((0.45,), (0.2, 0.95), (0.5, 0.97), 0.07, 0.06)  # feet
    for a, b, radius in (((0.36, 0.16), (0.6, 0.04), 0.07), ((0.16, 0.16), (0.09, 0.04), 0.07)):
        made.stroke((0.4,), a, b, radius, 0.06)  # ears
    made.stroke((0.0,), (0.41, 0.145), (0.56, 0.065), 0.022, 0.02)  # and their insides
    return made


def bunny_colour():
    made = Picture((0.62, 0.48, 0.37))
    made.stroke((1.0, 1.0, 1.0), (0.1, 0.48), (0.22, 0.72), 0.07, 0.14)  # chest
    made.stroke((1.0, 1.0, 1.0), (0.95, 0.77), (0.98, 0.77), 0.08, 0.05)  # tail
    made.stroke((1.0, 0.97, 0.93), (0.03, 0.42), (0.1, 0.43), 0.05, 0.05)  # muzzle
    made.stroke((0.35, 0.25, 0.2), (0.61, 0.02), (0.65, 0.03), 0.03, 0.06)  # ear's tip
    return made


def bands():
    colours = [(0.95, 0.12, 0.25), (1.0, 0.62, 0.05), (1.0, 0.9, 0.15), (0.2, 0.75, 0.25), (0.1, 0.5, 0.95), (0.65, 0.2, 0.8)]
    made = Picture((0.0, 0.0, 0.0), 4, 240)
    made.values = [colours[row // 20 % len(colours)] for row in range(made.height) for _ in range(made.width)]
    return made


SCENES = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "examples", "scenes", "fur")


def main():
    parser = argparse.ArgumentParser(description="The maps that the scenes of examples/scenes/fur name.")
    parser.add_argument("--out", default=SCENES, help="where they go; default: beside the scenes")
    folder = parser.parse_args().out
    maps = {"horse_length.pgm": horse_length, "bunny_length.pgm": bunny_length, "bunny_colour.ppm": bunny_colour, "bands.ppm": bands}
    try:
        for name, make in maps.items():
            make().write(os.path.join(folder, name))
    except OSError as error:
        print(f"make_maps.py: {folder} cannot be written into ({error.strerror}); name a folder that you may write to.", file=sys.stderr)
        sys.exit(2)
    print(f"{folder}: {', '.join(maps)}")


if __name__ == "__main__":
    main()
