#!/usr/bin/env python3
"""make_storm.py > storm.json: 300 motors of all kinds along a runner's way. The same text on every machine."""
import json
import math
import random

DURATION = 8.0  # [s]
RUNNER_SPEED = 9.0  # [m/s]
COUNTS = {"directional": 90, "jet": 60, "vortex": 50, "omni": 40, "wake": 36, "pressure": 24}
FAST_WAKES = 8  # of the wakes: arrows at 50 m/s

chance = random.Random(300).random  # its sequence is the same in every version of Python


def between(low, high):
    return low + (high - low) * chance()


def rounded(*numbers):
    return [round(number, 2) for number in numbers]


def place(lowest=0.5, highest=12.0):
    """Along the runner's way, thicker near the ground."""
    return rounded(between(-50, 50), lowest + (highest - lowest) * chance() ** 2, between(-18, 18))


def heading(level=1.0):
    turn = between(0, 2 * math.pi)
    return rounded(math.cos(turn), between(-0.3, 0.3) * level, math.sin(turn))


def gust():
    """Two of three come and go, the third stays."""
    if chance() < 1 / 3:
        return {}
    start = round(between(0, 0.8 * DURATION), 2)
    return {"from": start, "envelope": {"attack": round(between(0.1, 0.5), 2), "hold": round(between(0.3, 2), 2), "decay": round(between(0.2, 1), 2)}}


def law(low, high):
    if chance() < 0.25:
        return {"force": {"acceleration": round(between(2 * low, 2 * high), 1)}}
    return {"drive": {"speed": round(between(low, high), 1), "rate": round(between(2, 8), 1)}}


def region():
    size = round(between(0.8, 3), 2)
    kind = int(4 * chance())
    if kind == 0:
        return {"sphere": {"radius": size}}
    if kind == 1:
        return {"capsule": {"half_axis": rounded(between(-3, 3), between(-1, 1), between(-3, 3)), "radius": size}}
    if kind == 2:
        return {"box": {"half_size": rounded(size, between(0.8, 2), between(0.8, 3))}}
    return {"cone": {"axis": rounded(between(2, 6), between(-1, 1), between(-3, 3)), "start_radius": 0.8, "end_radius": size}}


def motor(kind, index, paths):
    made = {"kind": kind, "name": f"{kind} {index + 1}"}
    if kind == "wake":
        fast = index < FAST_WAKES
        speed = 50.0 if fast else between(4, 12)
        start = between(0.5, DURATION - 1.5) if fast else between(0, DURATION - 3)
        length = 90.0 if fast else speed * 3.0
        runner = -36 + RUNNER_SPEED * (start + 0.5 * length / speed)  # it crosses where the runner then is
        way = heading(0.0)
        middle = (runner + between(-8, 8), between(0.7, 3), between(-8, 8))
        ends = [[m + side * 0.5 * length * w for m, w in zip(middle, way)] for side in (-1, 1)]
        name = f"way {index + 1}"
        paths[name] = {"points": [rounded(start, *ends[0]), rounded(start + length / speed, *ends[1])]}
        made |= {"path": name, "from": round(start, 2), "until": round(start + length / speed, 2), "radius": round(between(0.4, 1), 2)}
        made["law"] = {"drive": {"per_metre": round(between(0.5, 4), 2), "entrainment": round(between(0.4, 1), 2)}}
        return made
    made["position"] = place()
    if kind == "directional":
        made |= {"direction": heading(), "region": region(), "law": law(4, 12)} | gust()
    elif kind == "jet":
        made |= {"direction": heading(), "length": round(between(3, 8), 1), "start_radius": round(between(0.5, 1), 2),
                 "end_radius": round(between(0.5, 2), 2), "law": law(6, 16)} | gust()
    elif kind == "vortex":
        made |= {"axis": rounded(between(-0.3, 0.3), 1, between(-0.3, 0.3)), "radius": round(between(2, 5), 1),
                 "half_length": round(between(2, 5), 1), "lift": round(between(0, 0.6), 2), "law": law(3, 9)} | gust()
    elif kind == "omni":
        made |= {"radius": round(between(1, 2), 2), "speed": round(between(1, 4) * (1 if chance() < 0.5 else -1), 1)} | gust()
    else:
        made |= {"from": round(between(0, DURATION - 0.5), 2), "radius": round(between(1, 2), 2),
                 "speed": round(between(8, 25), 1), "duration": round(between(0.1, 0.4), 2)}
    return made


def line(value):
    return json.dumps(value, separators=(", ", ": "))


def main():
    paths = {"runner": {"points": [rounded(t / 4, -36 + RUNNER_SPEED * t / 4, 0, 2 * math.sin(0.35 * t)) for t in range(33)]}}
    motors = [motor(kind, index, paths) for kind, count in COUNTS.items() for index in range(count)]
    print("{")
    print('    "$schema": "scene.schema.json",')
    print('    "name": "storm",')
    print(f'    "description": "A storm made of {len(motors)} motors of all kinds, arrows at 50 m/s among them. Made by make_storm.py.",')
    print(f'    "duration": {DURATION:g},')
    print('    "frames_per_second": 10,')
    print('    "air": {"boundaries": {"y_low": "free_slip"}, "ambient": [7, 0, 3], "profile": {}, "gusts": {"intensity": 0.25}, "blend_width": 4},')
    print('    "paths": {')
    print(",\n".join(f"        {line(name)}: {line(path)}" for name, path in paths.items()))
    print("    },")
    print('    "follow": "runner",')
    print('    "motors": [')
    print(",\n".join(f"        {line(made)}" for made in motors))
    print("    ],")
    print('    "pictures": {"slice_height": 1, "speed_scale": 16}')
    print("}")


main()
