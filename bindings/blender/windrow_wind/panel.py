"""Properties and panels, made from the dataclasses of windrow.settings: names, defaults, ranges and meanings are those of the library."""

import ast
import dataclasses
import inspect
import re
import typing

import bpy
import numpy as np
import windrow
from windrow import forms, settings

# Settings of the scene that the add-on fills in, or that have no meaning in Blender.
LEFT_OUT = {"Config": {"boundaries", "follow_axes", "centre", "stages", "floor", "ticks_hz", "ticks_max_per_call"},
            "Gusts": {"tile"}, "Roughness": {"map"}, "Rows": {"heights"}}
PLACED = {"position", "direction", "axis", "region", "orientation", "shape", "half_axis"}
MOTORS = {"DIRECTIONAL": windrow.DirectionalMotor, "WAKE": windrow.WakeMotor, "JET": windrow.JetMotor, "VORTEX": windrow.VortexMotor,
          "OMNI": windrow.OmniMotor, "PRESSURE": windrow.PressureMotor}
LAWS = {"law": (forms.Drive, forms.Force), "wake_law": (forms.WakeDrive, forms.WakeForce)}


def meanings(module) -> dict[tuple[str, str], str]:
    """(class, field): the text below the field."""
    found = {}
    for node in ast.parse(inspect.getsource(module)).body:
        if isinstance(node, ast.ClassDef):
            for field, said in zip(node.body, node.body[1:]):
                if isinstance(field, ast.AnnAssign) and isinstance(said, ast.Expr) and isinstance(said.value, ast.Constant):
                    found[node.name, field.target.id] = " ".join(str(said.value.value).split())
    return found


MEANINGS = meanings(settings)
_NUMBER = r"-?\d*\.?\d+(?:e-?\d+)?"


def property_of(owner: type, field: dataclasses.Field, value):
    """The property of Blender's for a field, or None."""
    said = MEANINGS.get((owner.__name__, field.name), "")
    options = {"name": field.name.replace("_", " ").capitalize(), "description": said.rstrip(".")}
    span = re.search(rf"(?:^|\] |component )({_NUMBER})(?: \([^)]*\))? to ({_NUMBER})", said)
    if span and not isinstance(value, bool):
        options |= {"min": float(span.group(1)), "max": float(span.group(2))}
    kind = field.type
    if kind == "bool":
        return bpy.props.BoolProperty(default=value, **options)
    if kind == "int":
        options |= {name: int(min(max(options[name], -2**31), 2**31 - 1)) for name in ("min", "max") if name in options}
        return bpy.props.IntProperty(default=value, **options)
    if kind == "float" or kind == "float | None":
        return bpy.props.FloatProperty(default=-1.0 if value is None else min(value, 3e38), **(options if value is not None else
                                       {"name": options["name"], "description": options["description"] + "; -1: the default"}))
    if kind == "Vec3":
        return bpy.props.FloatVectorProperty(size=3, default=value, subtype="XYZ", **options)
    if kind == "IVec3":
        x, y, z = value  # z up here
        return bpy.props.IntVectorProperty(size=3, default=(x, z, y), min=1, max=2048, name=options["name"], description=options["description"])
    words = typing.get_args(getattr(settings, str(kind), None))
    if words:
        return bpy.props.EnumProperty(items=[(word, word.replace("_", " ").capitalize(), "") for word in words], default=value,
                                      name=options["name"], description=options["description"])
    return None


GROUPS: dict[type, type] = {}  # dataclass: its property group


def group_of(kind: type) -> type:
    """A property group with a property for each field; a field with settings of its own is a group with a switch."""
    if kind in GROUPS:
        return GROUPS[kind]
    initial = kind()
    annotations = {}
    for field in dataclasses.fields(kind):
        if field.name in LEFT_OUT.get(kind.__name__, ()) or (kind in MOTORS.values() and field.name in PLACED):
            continue
        value = getattr(initial, field.name)
        inner = getattr(settings, str(field.type).removesuffix(" | None"), None)
        if dataclasses.is_dataclass(inner):
            annotations[field.name] = bpy.props.PointerProperty(type=group_of(inner))
            if "None" in str(field.type):
                annotations[f"use_{field.name}"] = bpy.props.BoolProperty(
                    name=field.name.capitalize(), description=MEANINGS.get((kind.__name__, field.name), "").rstrip("."))
        elif str(field.type) in ("Law", "WakeLaw"):
            choices = LAWS["law" if field.type == "Law" else "wake_law"]
            annotations["law_kind"] = bpy.props.EnumProperty(
                items=[(choice.__name__, choice.__name__.removeprefix("Wake"), inspect.getdoc(choice) or "") for choice in choices], name="Law")
            for choice in choices:
                given = value if isinstance(value, choice) else choice()
                for part in dataclasses.fields(choice):
                    annotations[part.name] = bpy.props.FloatProperty(name=part.name.replace("_", " ").capitalize(),
                                                                     default=getattr(given, part.name))
        else:
            made = property_of(kind, field, value)
            if made is not None:
                annotations[field.name] = made
    GROUPS[kind] = type(f"WINDROW_PG_{kind.__name__}", (bpy.types.PropertyGroup,), {"__annotations__": annotations})
    return GROUPS[kind]


def shortest(value: float) -> float:
    """The shortest number of which Blender's is the nearest float."""
    return float(str(np.float32(value)))


def values_of(kind: type, group) -> dict[str, object]:
    """The settings of a group, as arguments of its dataclass."""
    found = {}
    for field in dataclasses.fields(kind):
        name = field.name
        if str(field.type) in ("Law", "WakeLaw"):
            law = getattr(forms, group.law_kind)
            found[name] = law(*(shortest(getattr(group, part.name)) for part in dataclasses.fields(law)))
        elif hasattr(group, name):
            value = getattr(group, name)
            inner = getattr(settings, str(field.type).removesuffix(" | None"), None)
            if dataclasses.is_dataclass(inner):
                if getattr(group, f"use_{name}", True):
                    found[name] = inner(**values_of(inner, value))
            elif field.type == "float | None":
                found[name] = None if value == -1.0 else shortest(value)
            elif isinstance(getattr(kind(), name), tuple):
                found[name] = tuple(shortest(part) if isinstance(part, float) else part for part in value)
            elif not isinstance(value, float):
                found[name] = value
            elif value < 3e38:  # else infinity, the default
                found[name] = shortest(value)
    return found


def draw(layout, kind: type, group) -> None:
    for name in group.__annotations__:
        if f"use_{name}" in group.__annotations__:
            box = layout.box()
            box.prop(group, f"use_{name}")
            if getattr(group, f"use_{name}"):
                draw(box, type(None), getattr(group, name))
        elif isinstance(getattr(group, name), bpy.types.PropertyGroup):
            box = layout.box()
            box.label(text=name.capitalize())
            draw(box, type(None), getattr(group, name))
        elif not name.startswith("use_"):
            layout.prop(group, name)


class SceneWind(bpy.types.PropertyGroup):
    """Settings of the scene's wind."""

    centre: bpy.props.FloatVectorProperty(name="Centre", size=3, subtype="XYZ", default=(0.0, 0.0, 8.0),
                                          description="Middle of the box of air; its height does not count over a ground")
    ground: bpy.props.BoolProperty(name="Ground", default=True, description="A ground without friction at a height; else air on all faces")
    ground_height: bpy.props.FloatProperty(name="Ground height", default=0.0)
    follow: bpy.props.PointerProperty(name="Follow", type=bpy.types.Object, description="What the box follows; nothing: it stays")
    folder: bpy.props.StringProperty(name="Cache folder", default="//windrow_cache", subtype="DIR_PATH")
    vdb: bpy.props.BoolProperty(name="VDB files", default=False, description="Writes the cells of each frame as an OpenVDB file, and shows "
                                "them as the volume Wind; the library must have been built with OpenVDB")
    warm_up: bpy.props.IntProperty(name="Warm up", default=0, min=0, max=10000, description="Frames of air before the first")


class ObjectWind(bpy.types.PropertyGroup):
    """What an object is to the wind."""

    role: bpy.props.EnumProperty(name="Role", items=[
        ("NONE", "Nothing", "The wind does not meet it"), ("MOTOR", "Motor", "It blows: along its own z axis, or where it moves"),
        ("OBSTACLE", "Obstacle", "The air flows around it"), ("BLADES", "Blades", "Blades of grass that were made on a surface"),
        ("POINTS", "Points", "The wind at its vertices is baked")])
    motor: bpy.props.EnumProperty(name="Motor", items=[(name, name.capitalize(), inspect.getdoc(kind) or "") for name, kind in MOTORS.items()])


def boundaries(wind) -> windrow.Boundaries:
    return windrow.Boundaries.open_over_floor() if wind.ground else windrow.Boundaries()


class WINDROW_PT_scene(bpy.types.Panel):
    bl_label = "Wind"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "scene"

    def draw(self, context) -> None:
        layout = self.layout
        layout.use_property_split = True
        wind = context.scene.windrow
        for name in ("centre", "ground", "ground_height", "follow"):
            layout.prop(wind, name)
        draw(layout, windrow.Config, wind.config)
        for name in ("folder", "warm_up", "vdb"):
            layout.prop(wind, name)
        layout.operator("windrow.bake").restart = False
        layout.operator("windrow.bake", text="Bake anew").restart = True


class WINDROW_PT_object(bpy.types.Panel):
    bl_label = "Wind"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "object"

    def draw(self, context) -> None:
        layout = self.layout
        layout.use_property_split = True
        wind = context.object.windrow
        layout.prop(wind, "role")
        if wind.role == "MOTOR":
            layout.prop(wind, "motor")
            draw(layout, MOTORS[wind.motor], getattr(wind, wind.motor.lower()))
        elif wind.role == "BLADES":
            draw(layout, windrow.BladeSettings, wind.blades)
            layout.prop(wind, "plant")
        elif context.object.type == "MESH":
            layout.operator("windrow.add_blades")


CLASSES = (WINDROW_PT_scene, WINDROW_PT_object)


def register() -> None:
    SceneWind.__annotations__["config"] = bpy.props.PointerProperty(type=group_of(windrow.Config))
    for name, kind in MOTORS.items():
        ObjectWind.__annotations__[name.lower()] = bpy.props.PointerProperty(type=group_of(kind))
    ObjectWind.__annotations__["blades"] = bpy.props.PointerProperty(type=group_of(windrow.BladeSettings))
    ObjectWind.__annotations__["plant"] = bpy.props.EnumProperty(
        name="Springs", items=[(name, name.capitalize(), "") for name in ("grass", "wheat", "alfalfa", "reed")])
    for kind in [*GROUPS.values(), SceneWind, ObjectWind, *CLASSES]:
        bpy.utils.register_class(kind)
    bpy.types.Scene.windrow = bpy.props.PointerProperty(type=SceneWind)
    bpy.types.Object.windrow = bpy.props.PointerProperty(type=ObjectWind)


def unregister() -> None:
    del bpy.types.Scene.windrow, bpy.types.Object.windrow
    for kind in reversed([*GROUPS.values(), SceneWind, ObjectWind, *CLASSES]):
        bpy.utils.unregister_class(kind)
