#!/usr/bin/env python3
"""make_calls.py HEADERS FILE: C++ that fills each struct and calls each function of the C interface with what a World hands out.

random_calls.cpp includes the file. Functions that need a device, or that set hooks before the first object, are left out.
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent.parent / "tools"))
from c_header import Header

BY_HAND = {"windrow_set_allocator", "windrow_set_logger", "windrow_thread_pool_destroy", "windrow_scene_parse"}
FILLED_BY_HAND = {"windrow_parallel_for", "windrow_spring_batch", "windrow_cascade_batch", "windrow_skin", "windrow_ground_step",
                  "windrow_query", "windrow_vdb_grid", "windrow_vdb_film", "windrow_vdb_scalar", "windrow_vdb_vector", "windrow_rows", "windrow_motor_id", "windrow_obstacle_id", "windrow_drag_id",
                  "windrow_saved_part", "windrow_transport", "windrow_scalar_transport"}
# Entries of the arrays whose number no parameter `count` tells.
LENGTHS = {
    "windrow_blades_vertices": {"heights": "rows", "positions": "2 * count * rows", "normals": "2 * count * rows"},
    "windrow_tree_vertices": {"parts": "part_count", "winds": "part_count"},
    "windrow_wind_add_plants": {"plants": "count"},
    "windrow_mesh_create": {"vertices": "vertex_count", "indices": "3 * triangle_count"},
    "windrow_height_map_create_with_holes": {"heights": "count", "open": "cell_count"},
    "windrow_workspace_set_obstacles": {"obstacles": "count", "velocities": "count", "spins": "count"},
    "windrow_axes_matrix": {"matrix": "16"},
    "windrow_spring_bands": {"bands": "4"},
    "windrow_swing_steps_make": {"blocks": "4"},
    **{f"windrow_shells_{what}_many": {name: "entries_of(skin)" for name in ("winds", "loads", "directions", "positions")}
       for what in ("loads", "bent", "translated")},
}
# What a count should be for the call to be right.
RIGHT_COUNTS = {
    "windrow_wind_write_vectors": "4 * cells_of(wind)", "windrow_wind_write_axes": "cells_of(wind)",
    "windrow_wind_write_obstacles": "cells_of(wind)", "windrow_wind_write_pressure": "cells_of(wind)",
    "windrow_wind_set_field": "cells_of(wind)", "windrow_ground_advance": "texels_of(ground)",
    "windrow_voxels_create": "product(cells)", "windrow_height_map_create": "product(corners)",
    "windrow_height_map_create_with_holes": "product(corners)", "windrow_height_map_create_with_holes.cell_count": "product(cells)",
    **{f"windrow_{operator}": "cells_in(work)" for operator in ("advect", "advect_scalar", "diffuse", "divergence", "solve_poisson",
                                                               "project")},
}
COUNTS = {"count", "cell_count", "rows", "part_count", "vertex_count", "triangle_count"}


class Maker:
    def __init__(self, header):
        self.header = header
        self.handles = {kind.removesuffix("**") for _, parameters in header.functions.values() for kind, _ in parameters
                        if kind.endswith("**") and not kind.startswith("const")}

    def initial(self, struct):
        return struct.startswith("windrow_") and f"{struct}_init" in self.header.functions

    def put(self, kind, place, name):
        """A statement that gives a field or a parameter a value."""
        if kind in self.header.choices:
            values = ", ".join(str(value) for _, value in self.header.choices[kind])
            return f"world.choose({place}, {{{values}}});"
        if self.header.types.get(kind, kind) in self.header.structs:
            return f"fill(world, {place});"
        if kind.endswith("*"):
            what = kind.removesuffix("*").removeprefix("const ")
            if what in self.handles:
                return f"{place} = world.handle<{what}>();"
            if what == "char":
                return f"{place} = world.text();"
            return f"{place} = world.maybe<{what}>();"
        return f'world.number({place}, "{name}");'

    def filler(self, struct):
        lines = [f"void fill(World& world, {struct}& value) {{"]
        fields = [field for field in self.header.structs[struct] if field[1] != "struct_size"]
        if self.initial(struct):
            lines.append(f"    (void){struct}_init(&value, sizeof value);")
            lines.append("    value.struct_size = world.size_of(sizeof value);")
        for kind, name, length in fields:
            for at in range(length) if length else [None]:
                place = f"value.{name}" + ("" if at is None else f"[{at}]")
                guard = "if (world.changes()) " if self.initial(struct) else ""
                lines.append(f"    {guard}{self.put(kind, place, name)}")
        lines.append(f"    world.tame(value);\n}}")
        return "\n".join(lines)

    def call(self, name):
        result, parameters = self.header.functions[name]
        lines, arguments, after = [], [], []
        if name.endswith("_destroy"):
            handle = parameters[0][0].removesuffix("*")
            return f'    {{"{name}", []([[maybe_unused]] World& world) {{ {name}(world.take<{handle}>()); }}}},'
        lengths = LENGTHS.get(name, {})
        counted = any(kind == "uint64_t" and parameter in COUNTS for kind, parameter in parameters)
        # Counts come first: arrays are made to their measure. What a count is measured by comes before it.
        order = sorted(parameters, key=lambda p: 0 if p[1] in ("wind", "work", "ground", "cells", "corners", "skin") and "*" not in p[0].removesuffix("*")
                       and not (p[1] == "cells" and "*" in p[0]) else 1 if p[1] in COUNTS else 2)
        written = {}
        for kind, parameter in order:
            what = kind.removeprefix("const ").rstrip("*")
            stars = kind.count("*")
            if parameter == "struct_size":
                lines.append(f"const std::uint32_t struct_size = world.size_of(sizeof({parameters[0][0].removesuffix('*')}));")
            elif kind == "uint64_t" and parameter in COUNTS:
                lines.append(f"const std::uint64_t {parameter} = world.count({RIGHT_COUNTS.get(f'{name}.{parameter}', RIGHT_COUNTS.get(name, '0'))});")
            elif kind == "windrow_velocity_at":
                lines.append(f"const auto {parameter} = world.velocity_at();")
            elif kind == "windrow_debug_draw":
                lines.append(f"const auto {parameter} = world.debug_draw();")
            elif parameter == "bytes" and what == "void":
                lines.append("std::uint64_t size = 0; const void* const bytes = world.bytes(size);")
            elif parameter == "size" and ("const void*", "bytes") in parameters:
                pass
            elif parameter in ("user", "context"):
                lines.append(f"void* const {parameter} = &world;")
            elif stars == 0:
                lines.append(f"{kind} {parameter}{{}}; {self.put(kind, parameter, parameter)}")
            elif stars == 2:
                const = "const " if kind.startswith("const") else ""
                lines.append(f"{const}{what}* made_{parameter} = nullptr; {const}{what}** const {parameter} = world.rarely_null(made_{parameter});")
                if not const:
                    after.append(f"world.keep(made_{parameter});")
            elif what in self.handles:
                lines.append(f"{what}* const {parameter} = world.handle<{what}>();")
            elif what == "char":
                lines.append(f"const char* const {parameter} = world.text();")
            elif parameter in lengths or (counted and what != "windrow_parallel_for" and not self.initial(what) and not
                                          (name.startswith("windrow_shells") and what == "windrow_skin") and parameter != "origin"):
                of = "float" if what == "void" else what
                lines.append(f"{of}* const {parameter} = world.array<{of}>({lengths.get(parameter, 'count')});")
            elif kind.startswith("const"):
                lines.append(f"{what}* const {parameter} = world.maybe<{what}>();")
            elif name.endswith("_init"):
                lines.append(f"{what} {parameter}_room; {what}* const {parameter} = world.rarely_null({parameter}_room);")
            else:
                lines.append(f"{what}* const {parameter} = world.room<{what}>();")
                after.append(f"world.got({parameter});")
        arguments = ", ".join(parameter for _, parameter in parameters)
        if result == "windrow_result":
            wind = None if name == "windrow_event_log_replay" else next((p for kind, p in parameters if kind.rstrip("*").removeprefix("const ") == "windrow_wind"
                         and kind.count("*") == 1), None)
            lines.append(f'world.judge({wind or "nullptr"}, [&] {{ return {name}({arguments}); }});')
            after = [f"if (world.worked()) {line}" for line in after]
        elif result == "void":
            lines.append(f"{name}({arguments});")
        else:
            lines.append(f"[[maybe_unused]] const auto result = {name}({arguments});")
            if result.endswith("*") and any(p == "count" for _, p in parameters):
                lines.append("world.read(result, count);")
        body = "\n         ".join(lines + after)
        return f'    {{"{name}", []([[maybe_unused]] World& world) {{\n         {body}\n     }}}},'

    def text(self):
        functions = [name for name in self.header.functions
                     if not self.header.file_of[name].startswith("vulkan") and name not in BY_HAND]
        structs = [name for name, fields in self.header.structs.items() if not self.header.file_of[name].startswith("vulkan")]
        parts = [f"[[maybe_unused]] void fill(World& world, {name}& value);" for name in structs]
        parts += [self.filler(name) for name in structs if name not in FILLED_BY_HAND]
        parts += ["const Call k_calls[] = {", *(self.call(name) for name in functions), "};"]
        return "// Made by make_calls.py.\n" + "\n".join(parts) + "\n"


if __name__ == "__main__":
    pathlib.Path(sys.argv[2]).write_text(Maker(Header(sys.argv[1])).text(), encoding="utf-8")
