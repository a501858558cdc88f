#!/usr/bin/env python3
"""webp_film.py FILE PICTURE... [flags]: an animated WebP of pictures, for a page; --check compares one with its pictures.

Every frame is a key frame: the encoder's other frames leave out blocks that change little, and a slow dissolve changes every block
little, so that what came before stays on the screen. The quality is the highest, of 95 at most, at which the file keeps within --most
bytes. What was written is decoded, as a browser does, and compared: a frame may differ by MAX_MEAN in the mean and by MAX_BLOCK in
the mean of a block of 16 x 16 pixels.

Needs Pillow (Debian: python3-pil).
"""
import argparse
import os
import pathlib
import signal
import sys

MOST = 4_000_000  # [bytes] what a page can bear
MAX_MEAN, MAX_BLOCK = 4.0, 12.0  # of 255


class Fault(Exception):
    """One sentence, exit code 2."""


def pillow():
    try:
        from PIL import Image, ImageChops, ImageStat
    except ImportError as error:
        raise Fault("Pillow is not installed; install Debian's package python3-pil and use /usr/bin/python3.") from error
    return Image, ImageChops, ImageStat


def differences(frame, picture):
    """Mean over all values, and the largest over blocks and channels of a block's mean."""
    image, chops, stat = pillow()
    # Signed: levels above and below within a block cancel, as they do for the eye.
    above, below = chops.subtract(frame, picture), chops.subtract(picture, frame)
    mean = sum(stat.Stat(above).mean + stat.Stat(below).mean) / 3
    blocks = frame.width // 16, frame.height // 16
    whole = (0, 0, 16 * blocks[0], 16 * blocks[1])
    parts = [side.crop(whole).resize(blocks, image.Resampling.BOX) for side in (above, below)]
    apart = max(high for sides in ((0, 1), (1, 0)) for _, high in chops.subtract(parts[sides[0]], parts[sides[1]]).getextrema())
    return mean, apart


def begin_ms(number, fps):
    return round(1000 * number / fps)


def shown(film, count, fps):
    """What a browser shows at the time of each picture: pictures that are equal share a frame."""
    film.seek(0)
    film.load()
    for number in range(count):
        while film.tell() + 1 < getattr(film, "n_frames", 1) and begin_ms(number, fps) >= film.info["timestamp"] + film.info["duration"]:
            film.seek(film.tell() + 1)
            film.load()
        yield film.convert("RGB")


def check(file, pictures, fps):
    """Worst mean and worst block of all pictures; a Fault where one is too far from its frame."""
    image, _, _ = pillow()
    worst = [0.0, 0.0]
    with image.open(file) as film:
        for name, frame in zip(pictures, shown(film, len(pictures), fps)):
            with image.open(name) as picture:
                if picture.size != frame.size:
                    raise Fault(f"{name} has {picture.size} pixels, {file} {frame.size}; name the pictures that it was made of.")
                found = differences(frame, picture.convert("RGB"))
            if found[0] > MAX_MEAN or found[1] > MAX_BLOCK:
                raise Fault(f"{file} differs from {name} by {found[0]:.1f} levels in the mean and {found[1]} in a block, above {MAX_MEAN:g} "
                            f"and {MAX_BLOCK:g}; give it more bytes, or fewer pictures.")
            worst = [max(pair) for pair in zip(worst, found)]
        film.seek(getattr(film, "n_frames", 1) - 1)
        film.load()
        end = film.info["timestamp"] + film.info["duration"]
    if end != begin_ms(len(pictures), fps):
        raise Fault(f"{file} ends at {end} ms, its pictures at {begin_ms(len(pictures), fps)}; name the pictures that it was made of.")
    return worst


def write(pictures, file, fps, most=MOST, best=95, farthest_key=1):
    """Writes the film whole or not at all. Returns quality, worst mean, worst block. `farthest_key`: frames between key frames; for
    the test."""
    image, _, _ = pillow()
    frames = []
    for name in pictures:
        with image.open(name) as picture:
            frames.append(picture.convert("RGB"))
        if frames[-1].size != frames[0].size:
            raise Fault(f"{name} has {frames[-1].size} pixels, {pictures[0]} {frames[0].size}; give pictures of one size.")
    if all(frame.tobytes() == frames[0].tobytes() for frame in frames):
        raise Fault(f"{pictures[0]} and what follows are one picture; give two that differ.")
    part = file.with_name("part_" + file.name)
    durations = [begin_ms(n + 1, fps) - begin_ms(n, fps) for n in range(len(frames))]
    try:
        def size_at(quality):
            frames[0].save(part, format="WEBP", save_all=True, append_images=frames[1:], duration=durations, loop=0, quality=quality,
                           method=6, kmin=0 if farthest_key == 1 else farthest_key - 1, kmax=farthest_key)
            return part.stat().st_size
        fits, above = (best, best + 1) if size_at(best) <= most else (0, best)
        while above - fits > 1:
            between = (fits + above) // 2
            fits, above = (between, above) if size_at(between) <= most else (fits, between)
        if fits == 0:
            raise Fault(f"{file} is above {most} bytes at the least quality; give fewer or smaller pictures.")
        size_at(fits)
        found = check(part, pictures, fps)
        os.replace(part, file)
        return fits, *found
    finally:
        part.unlink(missing_ok=True)


def main():
    parser = argparse.ArgumentParser(prog="webp_film.py", description="An animated WebP of pictures, or a check of one.")
    parser.add_argument("file", type=pathlib.Path)
    parser.add_argument("pictures", type=pathlib.Path, nargs="+")
    parser.add_argument("--fps", type=float, default=12.0, help="default 12")
    parser.add_argument("--most", type=int, default=MOST, help=f"bytes; default {MOST}")
    parser.add_argument("--check", action="store_true", help="compare FILE with the pictures, write nothing")
    options = parser.parse_args()
    if not 0.1 <= options.fps <= 240:
        raise Fault(f"--fps is {options.fps:g}; give 0.1 to 240.")
    missing = [name for name in ([options.file] if options.check else []) + options.pictures if not name.is_file()]
    if missing:
        raise Fault(f"{missing[0]} is no file; name one that is there.")
    if options.check:
        mean, block = check(options.file, options.pictures, options.fps)
    else:
        quality, mean, block = write(options.pictures, options.file, options.fps, options.most)
        print(f"{options.file}: quality {quality}, {options.file.stat().st_size / 1e6:.2f} MB")
    print(f"{options.file}: at most {mean:.1f} levels from its pictures in the mean, {block:.0f} in a block of 16 x 16")


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # what is half written goes
    try:
        main()
    except (Fault, OSError) as fault:
        print(f"webp_film.py: {fault}", file=sys.stderr)
        sys.exit(2)
    except KeyboardInterrupt:
        sys.exit(1)
