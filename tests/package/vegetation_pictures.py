#!/usr/bin/env python3
"""vegetation_pictures.py GRASS.ppm BARE.ppm: sky above, many different green pixels below, and grass where the other is bare."""
import pathlib
import sys


def pixels(path):
    """Width, height and rows of (red, green, blue)."""
    magic, size, most, body = pathlib.Path(path).read_bytes().split(b"\n", 3)
    width, height = map(int, size.split())
    if (magic, most, len(body)) != (b"P6", b"255", 3 * width * height):
        sys.exit(f"{path} is not a binary PPM of {width} x {height} pixels")
    colours = [tuple(body[n:n + 3]) for n in range(0, len(body), 3)]
    return width, height, [colours[row * width:(row + 1) * width] for row in range(height)]


def mean(rows):
    """Mean red, green and blue."""
    count = sum(len(row) for row in rows)
    return [sum(pixel[channel] for row in rows for pixel in row) / count for channel in range(3)]


def main():
    width, height, grass = pixels(sys.argv[1])
    if (width, height) != (320, 180):
        sys.exit(f"the picture is {width} x {height}, not 320 x 180")
    _, _, bare = pixels(sys.argv[2])
    sky, ground = grass[:height // 5], grass[height // 2:]
    red, green, blue = mean(sky)
    shades = {pixel for row in ground for pixel in row if pixel[1] > pixel[0] and pixel[1] > pixel[2]}
    changed = sum(a != b for rows in zip(ground, bare[height // 2:]) for a, b in zip(*rows)) / (width * len(ground))
    same_sky = sky == bare[:height // 5]
    print(f"sky ({red:.0f}, {green:.0f}, {blue:.0f}); {len(shades)} greens; {changed:.3f} of the ground differs from the bare one")
    faults = [text for fault, text in (
        (blue <= 1.05 * red or blue < 60, "the upper fifth is not a blue sky"),
        (len(shades) < 1000, "fewer than 1000 different greens in the lower half"),
        (changed < 0.5, "less than half of the ground differs from the bare one"),
        (not same_sky, "the sky depends on the grass")) if fault]
    sys.exit("; ".join(faults) or 0)


if __name__ == "__main__":
    main()
