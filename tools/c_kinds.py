"""What each number of the C interface is to a host of other axes and another unit: a length, a place, a speed, an axis of rotation.

A field's unit is in its comment in the headers, and its type says whether it is a number, a vector or a turn. The tables below have what
neither tells. `Kinds` gives the kind of each field and of each parameter, or raises Fault: no number is without one. From the kinds,
make_bindings.py makes c_api/source/axes_*.inl, which convert every call (c_api/source/axes.h).

A kind is a class of axes.h, with the power of the length in its unit where it has one: "Vector<1>" of m and m/s, "Number<-1>" of 1/m.
"""
import re
import textwrap

LENGTHS = {"m": 1, "m/s": 1, "m/s^2": 1, "1/m": -1, "m^2": 2, "m^2/s": 2, "m^2/s^2": 2, "m^4/s": 4, "m^5/s^2": 5, "N": 1, "N m": 2, "N m2": 3,
           "N m^2": 3, "Pa": -1, "kg/m3": -3}
WITHOUT = {"s", "ms", "us", "1/s", "rad", "rad/s", "Hz", "cells", "bytes", "texels"}
NUMBERS = {"float", "double"}
VECTORS = {"windrow_vec3", "windrow_dvec3", "windrow_vec4"}
OTHER_VECTORS = {"windrow_vec2", "windrow_dvec2", "windrow_quat", "windrow_dvec4", "windrow_ivec2", "windrow_ivec3"}
ALL = NUMBERS | VECTORS | OTHER_VECTORS

PLAIN = None  # the same for every host
OWN = "own"   # the library's own: its axes and metres, for every host
HAND = "hand"  # c_api/source/axes.cpp

# Structs that go with arrays of cells or are read by shaders.
OWN_STRUCTS = {"windrow_transport", "windrow_scalar_transport", "windrow_vdb_grid", "windrow_vdb_scalar", "windrow_vdb_vector"}
OWN_HEADERS = {"shader_blocks.h"}
PARTS = {"axes_plant_calls.inl": {"plants.h", "motion.h", "vulkan_host.h", "vulkan_wind.h", "vulkan_ground.h"},
         "axes_body_calls.inl": {"motors.h", "obstacles.h", "drag.h", "operators.h"}}  # all others: axes_calls.inl
HAND_STRUCTS = {"windrow_boundaries", "windrow_box"}
FIELDS = {
    "windrow_uniform_gust.direction": "Vector<0>", "windrow_directional_motor.direction": "Vector<0>", "windrow_jet_motor.direction": "Vector<0>",
    "windrow_vortex_motor.axis": "Axial<0>", "windrow_vortex_motor.lift": "Handed", "windrow_obstacle.orientation": "Turn",
    "windrow_pose.rotation": "Turn", "windrow_roughness_map.scale": "Extents<0>", "windrow_roughness_map.position": HAND,
    "windrow_region.half_size": "Extents<1>", "windrow_shape.half_size": "Extents<1>", "windrow_shape.scale": "Extents<0>",
    "windrow_shell_settings.down": "Vector<0>", "windrow_tree_part.axis": "Vector<0>", "windrow_plant_vertex.normal": "Vector<0>",
    "windrow_plant_vertex.tangent": "Vector<0>", "windrow_ground_step.wind_lean": "Level<0>", "windrow_ground_sample.lean": "Level<0>",
    "windrow_config.cells": "Extents<0>", "windrow_config.follow_axes": HAND, "windrow_vulkan_settings.read_cells": "Extents<0>",
    "windrow_vdb_film.low": HAND, "windrow_vdb_film.high": HAND, "windrow_debug_line.end": "Vector<1>", "windrow_vulkan_frame.around": "Vector<1>",
    "windrow_vulkan_frame.points": "Vector<1>", "windrow_skin.positions": "Vector<1>", "windrow_skin.normals": "Vector<0>",
    "windrow_obstacle_force.moment": "Axial<2>",
    "windrow_query.anchor": HAND, "windrow_query.velocities": HAND, "windrow_query.sampling": HAND, "windrow_cascade_batch.value": PLAIN,
}
# Entries of the arrays that fields and parameters point to; others point to one thing. What the library rejects unread is not read.
LENGTHS_OF = {
    "windrow_vulkan_frame.points": "point_count", "windrow_skin.positions": "count", "windrow_skin.normals": "count",
    "windrow_rows.heights": "{0}.height_count <= 2048 ? {0}.height_count : 0", "windrow_ground_step.walkers": "walker_count",
    "windrow_wind_add_plants.plants": "count", "windrow_tree_vertices.parts": "part_count", "windrow_tree_vertices.winds": "part_count",
    "windrow_blades_vertices.positions": "2 * count * rows", "windrow_blades_vertices.normals": "2 * count * rows",
    **{f"windrow_shells_{what}_many.{name}": "count_of(skin)" for name in ("winds", "loads", "directions", "positions")
       for what in ("loads", "bent", "translated")},
}
PARAMETERS = {  # of any call; a call with another kind is in CALLS
    "position": "Vector<1>", "point": "Vector<1>", "offset": "Vector<1>", "anchor": "Vector<1>", "ambient": "Vector<1>", "mean": "Vector<1>",
    "velocity": "Vector<1>", "wind": "Vector<1>", "winds": "Vector<1>", "phase": "Vector<1>", "roots": "Vector<1>", "positions": "Vector<1>",
    "rest_positions": "Vector<1>", "half_axis": "Vector<1>", "axis": "Vector<1>", "impulse": "Vector<4>", "direction": "Vector<0>",
    "directions": "Vector<0>", "view": "Vector<0>", "load": "Vector<0>", "loads": "Vector<0>", "normal": "Vector<0>", "normals": "Vector<0>",
    "rest_normals": "Vector<0>", "spin": "Axial<0>", "orientation": "Turn", "half_size": "Extents<1>", "scale": "Extents<0>",
    **dict.fromkeys(("height", "radius", "start_radius", "end_radius", "half_length", "cell_size", "speed", "acceleration", "width", "thickness",
                     "depth", "diameter", "outer_diameter", "inner_diameter"), "Number<1>"),
    "young": "Number<-1>", "per_metre": "Number<-1>", "viscosity": "Number<2>",
    **dict.fromkeys(("angle", "dt", "duration", "time", "h", "side", "map", "spread", "strength", "entrainment", "rate", "number", "tick_hz",
                     "value", "whole_us", "read_back_us", "slot"), PLAIN),
    **dict.fromkeys(("cells", "field", "gradient", "expansion", "result", "rhs_then_phi", "wind_leans"), OWN),
}
CALLS = {
    "windrow_cascade_at.height": PLAIN, "windrow_cascade_previous_at.height": PLAIN, "windrow_shape_mesh.scale": PLAIN,
    "windrow_blades_vertices.heights": PLAIN, "windrow_wind_field.origin": OWN, "windrow_vulkan_wind_halves.origin": OWN,
    "windrow_vulkan_wind_points.positions": OWN, "windrow_vulkan_wind_points.velocities": OWN, "windrow_project.velocity": OWN,
    "windrow_divergence.velocity": OWN,
}
RESULTS = {
    "windrow_ambient_wind_period": "Number<1>", "windrow_ambient_wind_ground": "Number<1>", "windrow_ambient_wind_profile_at": PLAIN,
    "windrow_ambient_wind_phase": "Vector<1>", "windrow_ambient_wind_mean": "Vector<1>", "windrow_wind_ambient": "Vector<1>",
    "windrow_mesh_distance": "Number<1>", "windrow_height_map_normal": HAND, "windrow_height_map_height": HAND, "windrow_wind_origin": HAND,
    "windrow_rectangle_rigidity": "Number<3>", "windrow_folded_rigidity": "Number<3>", "windrow_rod_rigidity": "Number<3>",
    "windrow_tube_rigidity": "Number<3>", "windrow_plant_yaw": "LevelSign", "windrow_plant_stiffness": PLAIN, "windrow_blades_length": "Number<1>",
    "windrow_shells_height": PLAIN, "windrow_blades_load": "Vector<0>", "windrow_shells_load": "Vector<0>", "windrow_shells_bent": "Vector<1>",
    "windrow_shells_translated": "Vector<1>", "windrow_ground_next_centre": "Level<1>", "windrow_from_half": PLAIN, "windrow_scene_time": PLAIN,
    "windrow_scene_duration": PLAIN, "windrow_scene_frames_per_second": PLAIN, "windrow_vulkan_wind_query_age": PLAIN,
}
HAND_CALLS = {"windrow_wind_origin", "windrow_wind_set_velocity", "windrow_wind_sample", "windrow_wind_debug_lines", "windrow_voxels_create",
              "windrow_mesh_create", "windrow_height_map_create", "windrow_height_map_create_with_holes", "windrow_height_map_height",
              "windrow_height_map_normal", "windrow_wind_add_obstacle", "windrow_wind_set_obstacle", "windrow_wind_get_obstacle",
              "windrow_wind_move_obstacle", "windrow_workspace_set_obstacles", "windrow_shape_plate", "windrow_place_key"}
# They put numbers of the host into a struct of the host.
PLAIN_CALLS = re.compile("windrow_(region|law|wake_law|shape)_(?!plate)|windrow_boundaries_all|windrow_axes_matrix|windrow_set_axes")
BOTH_WAYS = {"windrow_ambient_wind_felt.velocity"}  # the wind there, and what acts
COMMENT = "Made by ./dev schema from the headers and tools/c_kinds.py. Do not edit.\n// clang-format off"


class Fault(Exception):
    """A number whose kind nothing tells."""


def base(kind):
    return kind.replace("const", "").replace("*", "").strip()


class Kinds:
    """The kinds of the headers. `comments`: {struct.field: comment}."""

    def __init__(self, header, comments):
        self.header, self.comments = header, comments
        self.fields = {struct: {name: self._field(struct, kind, name) for kind, name, _ in fields} for struct, fields in header.structs.items()
                       if not self.own(struct)}
        self.turned = set(HAND_STRUCTS)
        while True:  # a struct turns if something in it does
            more = {struct for struct, fields in self.fields.items() if any(
                kind not in (PLAIN, OWN, "struct") or (kind == "struct" and self._inner(struct, name) in self.turned) for name, kind in fields.items())}
            if more <= self.turned:
                break
            self.turned |= more
        self.known = {key.split(".")[0] for key in (*FIELDS, *LENGTHS_OF, *CALLS, *BOTH_WAYS)} | HAND_CALLS | set(RESULTS) | OWN_STRUCTS | HAND_STRUCTS
        gone = self.known - set(header.structs) - set(header.functions)
        if gone:
            raise Fault(f"tools/c_kinds.py names {', '.join(sorted(gone))}, which no header has")

    def own(self, struct):
        return struct in OWN_STRUCTS or self.header.file_of[struct] in OWN_HEADERS or struct in ALL

    def _inner(self, struct, name):
        return base(next(kind for kind, field, _ in self.header.structs[struct] if field == name))

    def _field(self, struct, kind, name):
        key, of = f"{struct}.{name}", base(kind)
        if struct in HAND_STRUCTS:
            return HAND
        if key in FIELDS:
            return FIELDS[key]
        if of in self.header.structs and of not in ALL:
            return "struct"
        if of not in ALL:
            return PLAIN
        unit = re.match(r"\[([^\]]+)\]", self.comments.get(key, ""))
        unit = unit.group(1) if unit else None
        if unit not in LENGTHS and unit not in WITHOUT and unit is not None:
            raise Fault(f"{key} has the unit {unit}: add it to LENGTHS or WITHOUT of tools/c_kinds.py")
        if of in NUMBERS:
            return f"Number<{LENGTHS[unit]}>" if unit in LENGTHS else PLAIN
        if of in VECTORS and unit in LENGTHS:
            return f"Vector<{LENGTHS[unit]}>"
        raise Fault(f"{key} is a {of}: add its kind to FIELDS of tools/c_kinds.py")

    def parameter(self, call, kind, name):
        key, of = f"{call}.{name}", base(kind)
        if key in CALLS:
            return CALLS[key]
        if of not in ALL:
            return "struct" if of in self.turned else PLAIN
        if name not in PARAMETERS:
            raise Fault(f"{key} is a {of}: add its kind to PARAMETERS or CALLS of tools/c_kinds.py")
        return PARAMETERS[name]

    def result(self, call, kind):
        of = base(kind)
        if "*" in kind or (of not in ALL and of not in self.header.structs):
            return PLAIN
        if of in self.header.structs and of not in ALL:
            return "struct" if of in self.turned else PLAIN
        if call not in RESULTS:
            raise Fault(f"{call} returns a {of}: add its kind to RESULTS of tools/c_kinds.py")
        return RESULTS[call]

    # --- C++ -------------------------------------------------------------------------------------------------------------
    def calls(self):
        """{call: kinds of its parameters, kind of its result} of those that convert something."""
        found = {}
        for call, (result, parameters) in self.header.functions.items():
            if call in HAND_CALLS or PLAIN_CALLS.match(call):
                continue
            kinds = [self.parameter(call, kind, name) for kind, name in parameters]
            answer = self.result(call, result)
            if any(kind not in (PLAIN, OWN) for kind in (*kinds, answer)):
                found[call] = kinds, answer
        return found

    def names(self):
        text = f"// {COMMENT}\n// Calls that convert are functions of their own, own_windrow_..., which axes.cpp calls.\n#ifndef WINDROW_C_AXES\n"
        text += "".join(f"#define {call} own_{call}\n" for call in sorted([*self.calls(), *HAND_CALLS]))
        return text + "#endif\n"

    def declarations(self):
        text = f"// {COMMENT}\nextern \"C\" {{\n"
        for call in sorted([*self.calls(), *HAND_CALLS]):
            result, parameters = self.header.functions[call]
            text += textwrap.fill(f"{self._type(result)} own_{call}({', '.join(f'{self._type(kind)} {name}' for kind, name in parameters) or 'void'});", 130,
                                  subsequent_indent="    ", break_long_words=False) + "\n"
        return text + "}\n"

    @staticmethod
    def _type(kind):
        return re.sub(r"\*(?=\w)", "* ", kind)

    def structs(self):
        text = (f"// {COMMENT}\n// Each struct on its way in or out, field by field.\n"
                "namespace windrow::c_api {\n\n")
        order = [struct for struct in self._order() if struct in self.turned]
        text += "".join(f"void turn(Keep& keep, Way way, {struct}& value);\n" for struct in order) + "\n"
        for struct in order:
            if struct in HAND_STRUCTS:
                continue
            text += f"inline void turn([[maybe_unused]] Keep& keep, Way way, {struct}& value) {{\n"
            hand = False
            for kind, name, _ in self.header.structs[struct]:
                of_kind = self.fields[struct][name]
                length = LENGTHS_OF.get(f"{struct}.{name}")
                if of_kind == HAND:
                    hand = True
                elif of_kind in (PLAIN, OWN) or (of_kind == "struct" and base(kind) not in self.turned):
                    continue
                elif "*" in kind:
                    of_kind = "Whole" if of_kind == "struct" else of_kind
                    text += f"    turn_behind<{of_kind}>(keep, way, value.{name}, {(length.format('value') if '{' in length else f'value.{length}') if length else '1'});\n"
                elif of_kind == "struct":
                    text += f"    turn(keep, way, value.{name});\n"
                else:
                    text += f"    {of_kind}::turn(way, value.{name});\n"
            text += ("    turn_by_hand(keep, way, value);\n" if hand else "") + "}\n"
        return text + "\n} // namespace windrow::c_api\n"

    def hand_parts(self):
        return sorted(struct for struct, fields in self.fields.items() if HAND in fields.values() and struct not in HAND_STRUCTS)

    def _order(self):
        return sorted(self.header.structs, key=lambda struct: (self.header.file_of[struct], list(self.header.structs).index(struct)))

    def source(self, file):
        text = (f"// {COMMENT}\n// Each call that converts: what goes in, the call itself, what comes out.\n\n")
        for call, (kinds, answer) in self.calls().items():
            if file != next((part for part, headers in PARTS.items() if self.header.file_of[call] in headers), "axes_calls.inl"):
                continue
            result, parameters = self.header.functions[call]
            arguments = [self._argument(call, kind, name, of_kind) for (kind, name), of_kind in zip(parameters, kinds)]
            kind = "Whole" if answer == "struct" else answer or "Same"
            signature = f"WINDROW_EXPORT {self._type(result)} {call}({', '.join(f'{self._type(kind)} {name}' for kind, name in parameters) or 'void'}) {{"
            text += textwrap.fill(signature, 130, subsequent_indent="    ", break_long_words=False) + "\n"
            text += f"    if (!host_axes.turned) [[likely]]\n        return own_{call}({', '.join(name for _, name in parameters)});\n"
            text += textwrap.fill(f"    return turned<{kind}>({', '.join([f'own_{call}', *arguments])});", 130, subsequent_indent="        ",
                                  break_long_words=False) + "\n}\n"
        return text

    def _argument(self, call, kind, name, of_kind):
        if of_kind in (PLAIN, OWN):
            return f"same({name})"
        word = "Whole" if of_kind == "struct" else of_kind
        key = f"{call}.{name}"
        if "*" not in kind:
            return f"in<{word}>({name})"
        parameters = dict((parameter, of) for of, parameter in self.header.functions[call][1])
        counted = "count" in parameters and base(kind) in ALL
        length = LENGTHS_OF.get(key, "count" if counted else "1")
        if key in BOTH_WAYS:
            return f"both<{word}>({name}, {length})"
        return f"{'in_array' if kind.startswith('const') else 'out_array'}<{word}>({name}, {length})"


def made(header, comments):
    """{path under c_api/source: text}."""
    kinds = Kinds(header, comments)
    return {"axes_names.inl": kinds.names(), "axes_own.inl": kinds.declarations(), "axes_structs.inl": kinds.structs(),
            **{file: kinds.source(file) for file in ("axes_calls.inl", *PARTS)}}
