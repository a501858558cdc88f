#!/usr/bin/env python3
"""make_village.py > village.json: houses along a lane, a church, gardens. The same text on every machine.

A house is a block, a second block for its gable, rolled by 45 degrees about the ridge, and two thin ones for the roof.
"""
import json
import math

EAVES_OUT, ROOF_HALF = 0.45, 0.13  # [m] of a roof beyond the wall; half its thickness

# x, z of the middle; length along the ridge, width, height of the eaves [m]; yaw of the ridge [deg], 0 along x, front to +z
HOUSES = [
    # north of the lane, their fronts to it
    (-33.0, -10.5, 10.0, 7.5, 3.2, 0), (-19.0, -11.5, 9.0, 8.0, 5.4, 4), (-5.5, -10.5, 8.5, 7.0, 3.0, 90), (7.0, -11.0, 11.0, 8.0, 5.4, -3),
    (22.5, -10.5, 9.5, 7.5, 3.2, 0), (36.0, -12.0, 9.0, 7.0, 5.2, 8),
    # south of it
    (-27.0, 11.0, 10.5, 8.0, 3.2, 180), (-12.5, 10.5, 8.0, 7.0, 5.2, 176), (0.5, 11.5, 9.5, 7.5, 3.2, 180), (14.5, 10.5, 8.0, 7.5, 3.2, 270),
    (28.5, 11.5, 10.5, 8.0, 5.4, 184),
    # behind
    (-24.0, -28.0, 12.0, 8.0, 3.4, 15), (31.0, -28.0, 10.0, 7.5, 3.2, -20), (-21.0, 28.0, 10.0, 7.5, 3.2, 170), (20.0, 28.5, 12.0, 8.0, 3.4, 195),
]
CHURCH = (5.0, -29.0, 15.0, 8.5, 6.5, 0)
TOWER = (-5.2, -29.0, 5.0, 5.0, 14.0, 90)


def lane(x):
    """z of its middle."""
    return 0.4 + 0.9 * math.sin(0.055 * x)


def turned(x, z, yaw):
    a = math.radians(yaw)
    return x * math.cos(a) + z * math.sin(a), z * math.cos(a) - x * math.sin(a)


def rounded(*numbers):
    return [round(number, 3) + 0.0 for number in numbers]


def block(name, middle, half, turn):
    obstacle = {"name": name, "position": rounded(*middle)}
    if any(turn):
        obstacle["turn_deg"] = rounded(*turn)
    return {**obstacle, "shape": {"block": {"half_size": rounded(*half)}}}


def house(x, z, length, width, eaves, yaw, walls="house"):
    half = width / 2
    side = half / math.sqrt(2)  # of the gable's square
    slope = (half + EAVES_OUT) * math.sqrt(2)  # of the roof, from the ridge down
    parts = [block(walls, (x, eaves / 2, z), (length / 2, eaves / 2, half), (yaw, 0, 0)),
             block("gable", (x, eaves, z), (length / 2 - 0.01, side, side), (yaw, 45, 0))]
    for way in (1, -1):
        along, up = (slope - ROOF_HALF) / 2, ROOF_HALF  # of its middle from the ridge: down the slope, and off it
        out, y = (along + up) / math.sqrt(2), eaves + half + (up - along) / math.sqrt(2)
        dx, dz = turned(0, way * out, yaw)
        parts.append(block("roof", (x + dx, y, z + dz), (length / 2 + 0.35, ROOF_HALF, (slope + ROOF_HALF) / 2),
                           (yaw if way > 0 else yaw + 180, 45, 0)))
    return parts


def chimney(x, z, length, width, eaves, yaw):
    dx, dz = turned(0.25 * length, 0.9, yaw)
    return block("chimney", (x + dx, eaves + width / 2 - 0.1, z + dz), (0.32, 0.9, 0.32), (yaw, 0, 0))


obstacles = []
for each in HOUSES:
    obstacles += house(*each)
    obstacles.append(chimney(*each))
obstacles += house(*CHURCH, walls="church") + house(*TOWER, walls="tower")

erased = []
x = -120.0
while x <= 120.0:
    erased.append({"erase": {"centre": rounded(x + 120.0, lane(x) + 100.0), "radius": 2.3, "hardness": 0.7}})
    x += 1.5
for (x, z, length, width, _, yaw) in HOUSES[:11]:  # from each door to the lane
    front = 1 if z < 0 else -1
    z += front * ((length if abs(yaw) % 180 == 90 else width) / 2)
    while front * (lane(x) - z) > 0:
        erased.append({"erase": {"centre": rounded(x + 120.0, z + 100.0), "radius": 0.75, "hardness": 0.6}})
        z += 0.6 * front

scene = {
    "$schema": "scene.schema.json",
    "name": "village",
    "description": "A village in a fresh wind along its lane: the lane is fast, gardens behind the houses are calm. Written by tools/make_village.py.",
    "duration": 12,
    "tick_hz": 20,
    "frames_per_second": 2,
    "air": {
        "cells": [104, 28, 84],
        "boundaries": {"y_low": "free_slip"},
        "centre": [0, 14, 0],
        "ambient": [7, 0, 0.8],
        "profile": {"roughness_length": 0.05, "reference_height": 10},
        "gusts": {"intensity": 0.12, "length": 25},
        "relaxation_time": 60,
    },
    "floor": 0,
    "obstacles": obstacles,
    "pictures": {"slice_height": 1.5, "slice_z": 10.5, "speed_scale": 9, "flow": "streamlines", "width": 1800},
    "picture": {
        "size": [960, 540],
        "frames_per_second": 10,
        "warm_up": 12,
        "camera": {"position": [-60, 17, 6], "target": [0, 0, 0], "view_deg": 42, "exposure": 0.8, "far": 3000},
        "sun": {"elevation_deg": 38, "azimuth_deg": 118},
        "fog": {"density": 0.0008, "fall": 0.01},
        "clouds": {"cover": 0.35, "drift": [10, 1]},
        "ground": {"corner": [-120, 0, -100], "extent": [240, 200], "hills": {"height": 0, "length": 80}},
        "grass": [
            {"name": "gardens", "class": "grass", "length": 0.55, "length_spread": 0.3, "width": 0.011, "tip_width": 0.06, "taper": 2.6, "along_wind": 0.9, "rest_bend": 0.35,
             "rest_bend_spread": 0.35, "density": 16, "chunk_cells": 80, "split_distance": 9, "cut_distance": 110, "fade_from": 0.6, "shadow_distance": 13, "min_width": 0,
             "thin_from": 3, "thin_power": 1.4, "clump_size": 0.6, "clump_height": 0.3, "clump_lean": 0.3, "clump_fan": 0.3, "patch_height": 0.3, "max_chunks": 1200,
             "look": {"root": [0.018, 0.038, 0.008], "tip": [0.135, 0.190, 0.040], "second": [0.085, 0.155, 0.040], "variation": 0.24, "root_light": 0.26, "even_from": 60, "self_shade": 1.4,
                      "soil": [0.155, 0.125, 0.085]},
             "mask": {"corners": [481, 401], "strokes": erased}},
        ],
        "trees": [
            {"kind": "oak", "places": [{"at": [-40, 27], "size": 0.8, "yaw_deg": 30}, {"at": [14, -22], "size": 0.9, "yaw_deg": 80}, {"at": [44, 24], "size": 1.0}, {"at": [-46, -20], "size": 1.0, "yaw_deg": 200}]},
            {"kind": "birch", "places": [{"at": [-6, 24], "size": 0.8}, {"at": [-3.4, 26], "size": 0.7, "yaw_deg": 90}, {"at": [43, -4.5], "size": 0.8, "yaw_deg": 150}]},
            {"kind": "bush", "places": [{"at": [-20, 18.5], "size": 0.7}, {"at": [-5.5, 17.5], "size": 0.8, "yaw_deg": 40}, {"at": [-34, 16.5], "size": 0.6, "yaw_deg": 140}, {"at": [7, 19], "size": 0.8, "yaw_deg": 200},
                                       {"at": [-26.2, -5.2], "size": 0.45}, {"at": [-12, -6], "size": 0.4, "yaw_deg": 70}]},
            {"kind": "oak", "scatter": {"count": 60, "low": [-110, -95], "high": [115, -50], "groves": 0.5, "grove_length": 40, "apart": 8, "seed": 5}},
            {"kind": "spruce", "scatter": {"count": 50, "low": [60, -60], "high": [118, 60], "groves": 0.6, "grove_length": 30, "apart": 5, "seed": 3}},
        ],
        "obstacles": [
            {"name": "house", "colour": [0.60, 0.55, 0.45], "windows": {"door": True, "glass": [0.035, 0.040, 0.050]}},
            {"name": "gable", "colour": [0.60, 0.55, 0.45]},
            {"name": "roof", "colour": [0.255, 0.085, 0.045]},
            {"name": "chimney", "colour": [0.20, 0.09, 0.06]},
            {"name": "church", "colour": [0.62, 0.59, 0.52], "windows": {"width": 0.9, "height": 2.8, "spacing": 3.0, "storey": 6.2, "sill": 2.2}},
            {"name": "tower", "colour": [0.62, 0.59, 0.52], "windows": {"width": 0.7, "height": 1.3, "spacing": 4.0, "storey": 4.4, "sill": 2.6}},
        ],
        "sampling": {"detail": 0.5, "detail_length": 0.5},
    },
}


def text(value, depth, whole):
    """Objects over lines as far as `whole`, then each on one."""
    space = "    " * (depth + 1)
    if depth < whole and isinstance(value, dict) and value:
        return "{\n" + ",\n".join(f"{space}{json.dumps(key)}: {text(item, depth + 1, whole)}" for key, item in value.items()) + "\n" + "    " * depth + "}"
    if depth < whole and isinstance(value, list) and value and isinstance(value[0], dict):
        return "[\n" + ",\n".join(space + text(item, depth + 1, 0) for item in value) + "\n" + "    " * depth + "]"
    return json.dumps(value)


print(text(scene, 0, 3))
