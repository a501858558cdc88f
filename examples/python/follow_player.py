#!/usr/bin/env python3
"""Tutorial: the README's ten lines in Python. A dog runs beside a player through a breeze, and a leaf feels its wake.

    follow_player.py          prints the wind at a leaf after a second

1. Get the package: `pip install` of the wheel that ./dev wheel makes, or PYTHONPATH=bindings/python with the library of a build in
   WINDROW_LIBRARY.
2. Every setting is a field of a dataclass with its default, so only what differs is given.
3. What cannot be done is a WindrowError with the library's sentence.
"""
import sys

import windrow


def main() -> None:
    config = windrow.Config(boundaries=windrow.Boundaries.open_over_floor(), ambient=(3.0, 0.0, 0.0))
    if "wrong" in sys.argv:  # to see the library's sentence
        config.cell_size = -1.0
    wind = windrow.Wind(config)
    dog = wind.motors.add(windrow.WakeMotor(position=(0.0, 0.5, 1.0), radius=0.6))
    for frame in range(60):
        wind.follow((frame / 20, 1.0, 0.0))
        wind.motors.move(dog, (frame / 8, 0.5, 1.0))
        wind.advance(1 / 60)
    print(f"{wind.velocity((4.0, 0.5, 1.0))[0]:.2f} m/s at the leaf")


if __name__ == "__main__":
    try:
        main()
    except windrow.WindrowError as error:
        print(error, file=sys.stderr)
        sys.exit(2)
