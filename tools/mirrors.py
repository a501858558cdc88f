"""Mirrors of the C interface in Python (ctypes), C# and Rust: choices, callbacks, structs and calls, made from the headers.

Each language has a file a part of the library. In C# the pointers of a call are IntPtr, since a declaration in C does not have which of
them are arrays, and which may be null; text is a string. Its structs have `Default()` where C has an init function.
"""
import ctypes
import re
import textwrap

from c_header import common

PARTS = {"air": ("base.h", "config.h", "ambient.h", "shader_blocks.h", "wind.h", "event_log.h", "tracer.h"),
         "bodies": ("motors.h", "obstacles.h", "drag.h"),
         "operators": ("operators.h", "scene.h"),
         "plants": ("plants.h", "motion.h"),
         "device": ("vdb.h", "vulkan_host.h", "vulkan_wind.h", "vulkan_ground.h")}
PYTHON_FOLDER = "bindings/python/windrow/_c"
MADE = "Made by ./dev schema from the headers of c_api, where units, ranges and defaults are. Do not edit."
PYTHON = {"float": "c.c_float", "double": "c.c_double", "int32_t": "c.c_int32", "uint32_t": "c.c_uint32", "int64_t": "c.c_int64",
          "uint64_t": "c.c_uint64", "uint16_t": "c.c_uint16", "uint8_t": "c.c_uint8", "size_t": "c.c_size_t", "void": "None"}
CSHARP = {"float": "float", "double": "double", "int32_t": "int", "uint32_t": "uint", "int64_t": "long", "uint64_t": "ulong",
          "uint16_t": "ushort", "uint8_t": "byte", "size_t": "UIntPtr"}
CSHARP_NAMES = {"out": "result", "params": "parameters", "object": "thing", "event": "happening", "lock": "held", "base": "origin"}
RUST = {"float": "f32", "double": "f64", "int32_t": "i32", "uint32_t": "u32", "int64_t": "i64", "uint64_t": "u64", "uint16_t": "u16",
        "uint8_t": "u8", "size_t": "usize", "void": "c_void", "char": "c_char"}
RUST_WORDS = {"box", "in", "loop", "match", "mod", "move", "ref", "type", "use", "where"}


def title(name):
    """"WakeMotor" of windrow_wake_motor, "DVec3" of windrow_dvec3."""
    name = re.sub(r"^([diu])(?=vec\d)", r"\1_", name.removeprefix("windrow_"))
    return "".join(word[:1].upper() + word[1:] for word in name.split("_"))


def pointee(kind):
    """What a pointer's type points to, and whether that is constant; None: it is no pointer."""
    found = re.fullmatch(r"(.*)\*(?:const)?", kind)
    if not found:
        return None
    inner = found.group(1)
    if "*" in inner:
        return inner, inner.endswith("*const")
    return inner.removeprefix("const "), inner.startswith("const ")


def packed(parts, indent="", between=", ", first=None, width=120):
    """Parts side by side, on as many lines as they take; a part is not broken."""
    joined = between.join(part.replace(" ", "\0") for part in parts)
    return textwrap.fill(joined, width, initial_indent=indent if first is None else first, subsequent_indent=indent,
                         break_long_words=False, break_on_hyphens=False).replace("\0", " ")


def kinds_of(call):
    """The types of the result and of the parameters."""
    return [call[0], *(kind for kind, _ in call[1])]


class Part:
    """A part of the library. `order`: its structs and callbacks, each after those that it has."""

    def __init__(self, header, name):
        self.header, self.name, self.files = header, name, PARTS[name]
        self.earlier = list(PARTS)[:list(PARTS).index(name)]
        self.functions = {name: header.functions[name] for name in self._own(header.functions)}
        self.callbacks = {name: header.callbacks[name] for name in self._own(header.callbacks)}
        self.choices = [(name if name.startswith("windrow_") else None,
                         [(value.removeprefix("WINDROW_"), number) for value, number in header.choices[name]])
                        for name in self._own(header.choices)]
        self.order = []
        for name in [*self._own(header.structs), *self.callbacks]:
            self._put(name)
        self.structs = [name for name in self.order if name in header.structs]

    def _own(self, names):
        return sorted((name for name in names if self.header.file_of[name] in self.files),
                      key=lambda name: self.files.index(self.header.file_of[name]))

    def _put(self, name):
        if name in self.order or self.header.file_of.get(name) not in self.files:
            return
        struct = self.header.structs.get(name)
        for kind in [kind for kind, _, _ in struct] if struct else kinds_of(self.callbacks[name]):
            inner = re.sub(r"const |\*(?:const)?", "", kind)
            if inner != name and (inner in self.header.structs or inner in self.header.callbacks):
                self._put(inner)
        self.order.append(name)

    def plain(self, kind):
        """A type without the names that the C headers give to others: a struct, a callback or a number."""
        named = self.header.types.get(kind)
        return self.plain(named) if isinstance(named, str) else kind

    def known(self, inner, scalars):
        """Whether a pointer to this is typed: an opaque handle is not."""
        return "*" in inner or self.plain(inner) in {**scalars, **self.header.structs}

    # --- Python --------------------------------------------------------------------------------------------------------------
    def _python_type(self, kind):
        inner = pointee(kind)
        if inner is None:
            kind = self.plain(kind)
            return PYTHON.get(kind) or title(kind)
        if inner[0] == "char":
            return "c.c_char_p"
        if inner[0] == "void" or not self.known(inner[0], PYTHON):
            return "c.c_void_p"
        return f"P({self._python_type(inner[0])})"

    def _python_fields(self, name):
        for kind, field, length in self.header.structs[name]:
            yield f'("{field}", {self._python_type(kind)}{f" * {length}" if length else ""})'

    def python(self):
        text = f'"""{MADE}"""\nimport ctypes as c\n' + ("\n" if self.earlier else "")
        text += "".join(f"from .{part} import *\n" for part in self.earlier) + "\nP = c.POINTER\n"
        for _, values in self.choices:
            text += packed([f"{name} = {value}" for name, value in values], between="; ") + "\n"
        for name in self.order:
            if name in self.callbacks:
                text += f"\n{title(name)} = c.CFUNCTYPE({', '.join(map(self._python_type, kinds_of(self.callbacks[name])))})\n"
            else:
                fields = packed(self._python_fields(name), " " * 16, first="    _fields_ = [")
                text += f"\n\nclass {title(name)}(c.Structure):\n{fields}]\n"
        text += f"\n\n# Each function with the types of its result and of its arguments.\n{self.name.upper()} = [\n"
        for name, call in self.functions.items():
            text += packed([f'"{name}"', *map(self._python_type, kinds_of(call))], " " * 5, first="    (") + "),\n"
        return text + "]\n"

    # --- C# ------------------------------------------------------------------------------------------------------------------
    def _csharp_type(self, kind):
        if kind in self.header.choices:
            return title(kind)
        kind = self.plain(kind)
        return "IntPtr" if pointee(kind) or kind in self.header.callbacks else CSHARP.get(kind) or title(kind)

    def csharp(self):
        text = f"// {MADE}\nusing System;\nusing System.Runtime.InteropServices;\n\nnamespace Windrow\n{{\n"
        loose = []
        for name, values in self.choices:
            before = common([value for value, _ in values]) if name else ""
            members = [f"{title(value.removeprefix(before).lower())} = {number}" for value, number in values]
            if name:
                text += packed(members, " " * 8, first=f"    public enum {title(name)} {{ ") + " }\n"
            else:
                loose += members
        if loose:
            text += f"    public static partial class Constants\n    {{\n{packed(loose, ' ' * 12, first='        public const int ')};\n    }}\n"
        for name in self.structs:
            text += f"\n    [StructLayout(LayoutKind.Sequential)]\n    public partial struct {title(name)}\n    {{\n"
            rows = []
            for kind, field, length in self.header.structs[name]:
                of = f"public {self._csharp_type(kind)}"
                if length:
                    rows.append((f"[MarshalAs(UnmanagedType.ByValArray, SizeConst = {length})] {of}[]", [title(field)]))
                elif rows and rows[-1][0] == of:
                    rows[-1][1].append(title(field))
                else:
                    rows.append((of, [title(field)]))
            text += "".join(packed(fields, " " * 12, first=f"        {of} ") + ";\n" for of, fields in rows)
            if f"{name}_init" in self.header.functions:
                text += (f"        public static {title(name)} Default() {{ return Native.Filled<{title(name)}>({name}_init); }}\n"
                         f"        [DllImport(Native.Library)] private static extern int {name}_init(out {title(name)} it, uint size);\n")
            text += "    }\n"
        text += "\n    public static partial class Calls\n    {\n"
        for name, call in self.functions.items():
            parameters = [f"{self._csharp_parameter(kind)} {CSHARP_NAMES.get(parameter, parameter)}" for kind, parameter in call[1]]
            result = "void" if call[0] == "void" else self._csharp_type(call[0])
            begin = f"        public static extern {result} {name}("
            text += f"        [DllImport(Native.Library)]\n{packed(parameters, ' ' * 12, first=begin) or begin});\n"
        return text + "    }\n}\n"

    def _csharp_parameter(self, kind):
        inner = pointee(kind)
        return "[MarshalAs(UnmanagedType.LPUTF8Str)] string" if inner and inner[0] == "char" and inner[1] else self._csharp_type(kind)

    # --- Rust ----------------------------------------------------------------------------------------------------------------
    @staticmethod
    def _rust_name(name):
        return "ResultCode" if name == "windrow_result" else title(name)  # Result is Rust's own

    def _rust_type(self, kind):
        inner = pointee(kind)
        if inner is not None:
            return f"*{'const' if inner[1] else 'mut'} {self._rust_type(inner[0]) if self.known(inner[0], RUST) else 'c_void'}"
        if kind in self.header.choices or kind in self.header.callbacks:
            return self._rust_name(kind)
        kind = self.plain(kind)
        return RUST.get(kind) or title(kind)

    def _rust_field(self, kind, name, length=0):
        kind = self._rust_type(kind)
        return f"{'r#' if name in RUST_WORDS else ''}{name}: " + (f"[{kind}; {length}]" if length else kind)

    def _rust_call(self, call, begin):
        parameters = [self._rust_field(*parameter) for parameter in call[1]]
        end = "" if call[0] == "void" else f" -> {self._rust_type(call[0])}"
        line = f"{begin}({', '.join(parameters)}){end}"
        return line if len(line) <= 120 else f"{begin}(\n{packed(parameters, ' ' * 8)}\n    ){end}"

    def rust(self):
        text = f"// {MADE}\n#![allow(dead_code, unused_imports)]\n" + "".join(f"use super::{part}::*;\n" for part in self.earlier)
        text += "use std::mem::size_of;\nuse std::os::raw::{c_char, c_void};\n\n"
        for name, values in self.choices:
            kind = self._rust_name(name) if name else "i32"
            constants = [f"pub const {value}: {kind} = {number};" for value, number in values]
            text += packed(([f"pub type {kind} = i32;"] if name else []) + constants, between=" ") + "\n"
        text += "\n"
        for name, call in self.callbacks.items():
            text += self._rust_call(call, f'pub type {title(name)} = Option<unsafe extern "C" fn') + ">;\n"
        for name in self.structs:
            fields = ["pub " + self._rust_field(*field) for field in self.header.structs[name]]
            text += f"\n#[repr(C)]\n#[derive(Clone, Copy)]\npub struct {title(name)} {{\n{packed(fields, '    ')},\n}}\n"
        sizes = [f"assert!(size_of::<{title(name)}>() == {ctypes.sizeof(self.header.ctype(name))});" for name in self.structs]
        text += f'\n#[cfg(target_pointer_width = "64")]\nconst _: () = {{\n{packed(sizes, "    ", " ")}\n}};\n'
        text += '\n#[link(name = "windrow")]\nextern "C" {\n'
        return text + "".join(self._rust_call(call, f"    pub fn {name}") + ";\n" for name, call in self.functions.items()) + "}\n"


def mirrors(header):
    """{path from the root: text}."""
    whole = f"The whole C interface. {MADE}"
    files = {
        f"{PYTHON_FOLDER}/__init__.py": f'''"""{whole}"""
from typing import Any

{"".join(f"from .{name} import *{chr(10)}" for name in PARTS)}

def bind(library: Any) -> Any:
    """Sets the types of each function of a loaded library."""
    for name, result, *arguments in {" + ".join(name.upper() for name in PARTS)}:
        function = getattr(library, name)
        function.restype, function.argtypes = result, arguments
    return library
''',
        "examples/rust/windrow_c/mod.rs": f"""// {whole}
{"".join(f"pub mod {name};{chr(10)}" for name in PARTS)}#[allow(unused_imports)]
pub use self::{{{", ".join(f"{name}::*" for name in PARTS)}}};
""",
    }
    for name in PARTS:
        part = Part(header, name)
        files |= {f"{PYTHON_FOLDER}/{name}.py": part.python(), f"examples/csharp/windrow_c/{title(name)}.cs": part.csharp(),
                  f"examples/rust/windrow_c/{name}.rs": part.rust()}
    return files
