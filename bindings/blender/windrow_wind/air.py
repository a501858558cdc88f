"""The wind of a Blender scene, with its motors and obstacles at each frame. Blender is z up, the library y up: (x, y, z) is (x, z, -y)."""
from __future__ import annotations

import dataclasses
import hashlib

import bpy
import numpy as np
import windrow
from mathutils import Quaternion, Vector

from . import panel


def to_wind(vectors) -> np.ndarray:
    """Of Blender's axes, (..., 3)."""
    given = np.asarray(vectors, np.float64)
    return np.stack([given[..., 0], given[..., 2], -given[..., 1]], axis=-1)


def to_blender(vectors) -> np.ndarray:
    given = np.asarray(vectors)
    return np.stack([given[..., 0], -given[..., 2], given[..., 1]], axis=-1)


def config_of(scene) -> windrow.Config:
    """The settings of the panel; vectors are in Blender's axes there."""
    wind = scene.windrow
    given = panel.values_of(windrow.Config, wind.config)
    x, y, z = given["cells"]
    return windrow.Config(**{**given, "cells": (x, z, y), "ambient": tuple(to_wind(given["ambient"])), "centre": tuple(to_wind(wind.centre)),
                             "boundaries": panel.boundaries(wind), "floor": wind.ground_height})


# --- Motors ------------------------------------------------------------------------------------------------------------------

def motor_of(thing) -> windrow.wind.Motor:
    """The motor of an object: it stands at its origin and blows along its own z axis; its size is that of an empty."""
    kind = panel.MOTORS[thing.windrow.motor]
    given = panel.values_of(kind, getattr(thing.windrow, thing.windrow.motor.lower()))
    given["position"] = tuple(to_wind(thing.matrix_world.translation))
    along = tuple(to_wind(thing.matrix_world.to_quaternion() @ Vector((0.0, 0.0, 1.0))))
    names = {field.name for field in dataclasses.fields(kind)}
    if "direction" in names:
        given["direction"] = along
    if "axis" in names:
        given["axis"] = along
    if kind is windrow.DirectionalMotor:
        given["region"] = windrow.Sphere(max(1e-3, thing.empty_display_size * max(map(abs, thing.matrix_world.to_scale())))
                                         if thing.type == "EMPTY" else 2.0)
    return kind(**given)


# --- Obstacles ---------------------------------------------------------------------------------------------------------------

def mesh_of(thing, graph) -> tuple[np.ndarray, np.ndarray]:
    """Vertices and triangles in the object's own axes, with its scale, as the library has them; what is mirrored is turned outside out."""
    evaluated = thing.evaluated_get(graph)
    mesh = evaluated.to_mesh()
    mesh.calc_loop_triangles()
    vertices = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", vertices)
    triangles = np.empty(3 * len(mesh.loop_triangles), np.int32)
    mesh.loop_triangles.foreach_get("vertices", triangles)
    evaluated.to_mesh_clear()
    # What is left of the object's matrix without its turn: scale, mirror, shear.
    rest = np.array(thing.matrix_world.to_quaternion().to_matrix().transposed() @ thing.matrix_world.to_3x3())
    triangles = triangles.reshape(-1, 3)
    if thing.matrix_world.determinant() < 0.0:
        triangles = triangles[:, ::-1]
    return to_wind(vertices.reshape(-1, 3) @ rest.T), triangles


def winding_number(points: np.ndarray, vertices: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Of a surface about points: 1 inside, 0 outside; a hole makes it go smoothly between. Based on: van Oosterom & Strackee 1983."""
    found = np.empty(len(points))
    corners = vertices[triangles]
    block = max(1, 4_000_000 // max(len(triangles), 1))
    for begin in range(0, len(points), block):
        a, b, c = (corners[None, :, n] - points[begin:begin + block, None] for n in range(3))
        la, lb, lc = (np.linalg.norm(side, axis=-1) for side in (a, b, c))
        volume = np.einsum("pti,pti->pt", a, np.cross(b, c))
        below = la * lb * lc + (a * b).sum(-1) * lc + (b * c).sum(-1) * la + (c * a).sum(-1) * lb
        found[begin:begin + block] = np.arctan2(volume, below).sum(axis=1) / (2.0 * np.pi)
    return found


def thickened(vertices: np.ndarray, triangles: np.ndarray, thickness: float) -> windrow.TriangleMesh:
    """A sheet as a thin closed body."""
    normals = np.zeros_like(vertices)
    faces = np.cross(vertices[triangles[:, 1]] - vertices[triangles[:, 0]], vertices[triangles[:, 2]] - vertices[triangles[:, 0]])
    for corner in range(3):
        np.add.at(normals, triangles[:, corner], faces)
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    there = {tuple(edge) for edge in edges}
    border = np.array([edge for edge in edges if (edge[1], edge[0]) not in there])
    below = border + len(vertices)
    walls = np.concatenate([np.stack([border[:, 1], border[:, 0], below[:, 0]], 1), np.stack([border[:, 1], below[:, 0], below[:, 1]], 1)]
                           if len(border) else [np.empty((0, 3), int)])
    return windrow.TriangleMesh(np.concatenate([vertices + 0.5 * thickness * normals, vertices - 0.5 * thickness * normals]),
                                np.concatenate([triangles, triangles[:, ::-1] + len(vertices), walls]))


def is_open(triangles: np.ndarray) -> bool:
    """Whether an edge has no other side, or more than one."""
    edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    return bool((np.unique(edges, axis=0, return_counts=True)[1] != 2).any())


class Shape:
    """The form of a mesh, and where its middle is in the object's own axes."""

    def __init__(self, name: str, vertices: np.ndarray, triangles: np.ndarray, cell_size: float) -> None:
        self.middle, self.note = np.zeros(3), ""
        try:
            self.shape = windrow.MeshShape(windrow.TriangleMesh(vertices, triangles))
            return
        except windrow.WindrowError as error:
            if not is_open(triangles):
                raise windrow.WindrowError(f"{name}: {error}") from None
        low, high = vertices.min(axis=0), vertices.max(axis=0)
        extent = float((high - low).max())
        step = max(min(0.5 * cell_size, extent / 24), extent / 60)
        if step > 0.0:
            counts = np.minimum(np.ceil((high - low) / step).astype(int) + 2, 64)
            axes = [low[n] + (np.arange(counts[n]) - 0.5) * step for n in range(3)]
            z, y, x = np.meshgrid(axes[2], axes[1], axes[0], indexing="ij")
            number = winding_number(np.stack([x, y, z], -1).reshape(-1, 3), vertices, triangles).reshape(x.shape)
            inside = number > 0.5
            if np.count_nonzero(number > 0.8) > max(4, 0.5 * np.count_nonzero(inside)):  # a sheet has about a half at its surface
                self.middle = low + (counts / 2 - 1.0) * step
                self.shape = windrow.VoxelShape(windrow.VoxelGrid(inside), step)
                self.note = f"{name} is open: its inside was found by the winding number, on cells of {step:.3g} m."
                return
        thickness = 0.1 * cell_size
        self.shape = windrow.MeshShape(thickened(vertices, triangles, thickness))
        self.note = f"{name} is a sheet: it is {thickness:.3g} m thick in the wind."


class Body:
    """An obstacle of the scene."""

    def __init__(self, thing, graph, cell_size: float) -> None:
        self.thing, self.cell_size = thing, cell_size
        self.vertices, self.triangles = mesh_of(thing, graph)
        self.form = Shape(thing.name, self.vertices, self.triangles, cell_size)
        self.id: windrow.ObstacleId | None = None

    def pose(self):
        turned = self.thing.matrix_world.to_quaternion()
        # The same turn in the library's axes: its axis is a vector.
        x, y, z = to_wind((turned.x, turned.y, turned.z))
        place = np.array(to_wind(self.thing.matrix_world.translation))
        if self.form.middle.any():
            place = place + np.array(Quaternion((turned.w, x, y, z)) @ Vector(self.form.middle))
        return tuple(place), (x, y, z, turned.w)

    def place(self, wind: windrow.Wind, graph) -> None:
        vertices, triangles = mesh_of(self.thing, graph)
        size = float(np.ptp(vertices, axis=0).max()) if len(vertices) else 0.0
        changed = vertices.shape != self.vertices.shape or not np.allclose(vertices, self.vertices, rtol=0.0, atol=1e-5 * max(1.0, size))
        if changed:  # a cloth, a pose
            self.vertices, self.triangles = vertices, triangles
            self.form = Shape(self.thing.name, vertices, triangles, self.cell_size)
        position, orientation = self.pose()
        obstacle = windrow.Obstacle(position=position, orientation=orientation, shape=self.form.shape)
        if self.id is None:
            self.id = wind.obstacles.add(obstacle)
        elif changed:
            wind.obstacles.set(self.id, obstacle)
        else:
            wind.obstacles.move(self.id, position, orientation)


class Air:
    """The wind and what the scene has put into it. `saved` goes on from an earlier one."""

    def __init__(self, scene, saved: dict | None = None) -> None:
        self.scene = scene
        self.config = config_of(scene)
        self.dt = scene.render.fps_base / scene.render.fps
        graph = bpy.context.evaluated_depsgraph_get()
        by_name = sorted(scene.objects, key=lambda thing: thing.name)
        self.motors = {thing.name: None for thing in by_name if thing.windrow.role == "MOTOR"}
        self.given: dict[str, object] = {}
        self.bodies = [Body(thing, graph, self.config.cell_size) for thing in by_name
                       if thing.windrow.role == "OBSTACLE" and thing.type == "MESH"]
        self.notes = [body.form.note for body in self.bodies if body.form.note]
        if saved is None:
            self.wind = windrow.Wind(self.config)
        else:
            self.wind = windrow.Wind.load(saved["wind"])
            for name, number in saved["motors"].items():
                self.motors[name] = windrow.MotorId.from_numbers(number)
            for body, number in zip(self.bodies, saved["obstacles"]):
                body.id = windrow.ObstacleId.from_numbers(number)
            self.given = {name: motor_of(scene.objects[name]) for name in self.motors}

    def place(self) -> None:
        """Puts everything where it is at the scene's frame."""
        graph = bpy.context.evaluated_depsgraph_get()
        followed = self.scene.windrow.follow
        if followed:
            self.wind.follow(tuple(to_wind(followed.matrix_world.translation)))
        for name in self.motors:
            motor = motor_of(self.scene.objects[name])
            known = self.motors[name]
            if known is None:
                self.motors[name] = self.wind.motors.add(motor)
            elif known in self.wind.motors:
                before = self.given[name]
                if dataclasses.replace(before, position=motor.position) == motor:
                    self.wind.motors.move(known, motor.position)
                else:
                    self.wind.motors.set(known, motor)
            self.given[name] = motor
        for body in self.bodies:
            body.place(self.wind, graph)

    def step(self) -> windrow.Diagnostics:
        self.place()
        return self.wind.step(self.dt)

    def save(self) -> dict:
        return {"wind": self.wind.save(), "motors": {name: known.numbers for name, known in self.motors.items()},
                "obstacles": [body.id.numbers for body in self.bodies]}

    def parts(self) -> list[object]:
        """What a bake depends on besides the animation."""
        return [self.config, self.dt, [motor_of(self.scene.objects[name]) for name in self.motors],
                [(body.thing.name, hashlib.sha256(body.vertices.tobytes() + body.triangles.tobytes()).hexdigest()) for body in self.bodies],
                self.scene.windrow.follow and self.scene.windrow.follow.name, self.scene.windrow.warm_up]
