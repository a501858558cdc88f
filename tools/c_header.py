"""The C headers as Python has them: choices, callbacks, structs, functions, read from their text; and ctypes made of them.

A type is written as "const windrow_vec4**": its words, then a star a pointer, "*const" where the pointer itself is constant.
"""
import ctypes
import pathlib
import re

SCALARS = {"float": ctypes.c_float, "double": ctypes.c_double, "int32_t": ctypes.c_int32, "uint32_t": ctypes.c_uint32,
           "int64_t": ctypes.c_int64, "uint64_t": ctypes.c_uint64, "uint16_t": ctypes.c_uint16, "uint8_t": ctypes.c_uint8,
           "size_t": ctypes.c_size_t}


class Header:
    """All headers of a folder, or their texts by name."""

    def __init__(self, source):
        if not isinstance(source, dict):
            source = {path.name: path.read_text(encoding="utf-8") for path in sorted(pathlib.Path(source).glob("*.h"))}
        self.types = dict(SCALARS)  # name: what it stands for
        self.structs = {}           # name: [(type, field, length)], length 0: no array
        self.functions = {}         # name: (type of the result, [(type, parameter)])
        self.callbacks = {}         # likewise
        self.choices = {}           # name of the typedef before it, or of its first value: [(value's name, value)]
        self.file_of = {}           # name of any of these: name of the header
        for file, text in source.items():
            there = set(self._names())
            text = re.sub(r"/\*.*?\*/", " ", text, flags=re.DOTALL)
            self._read(re.sub(r"^\s*#.*$", "", text, flags=re.MULTILINE))
            self.file_of.update((name, file) for name in self._names() if name not in there)

    def _names(self):
        return [*self.structs, *self.functions, *self.callbacks, *self.choices]

    def _read(self, text):
        for found in re.finditer(r"typedef\s+(\w+)\s+(windrow_\w+);", text):
            self.types[found.group(2)] = found.group(1)
        for found in re.finditer(r"typedef\s+([\w\s*]+)\(\*(windrow_\w+)\)\(([^;]*)\);", text):
            self.types[found.group(2)] = ctypes.c_void_p
            self.callbacks[found.group(2)] = self._call(found.group(1), found.group(3))
        for found in re.finditer(r"typedef struct (windrow_\w+) \{(.*?)\} \1;", text, flags=re.DOTALL):
            self.structs[found.group(1)] = [field for line in found.group(2).split(";") for field in fields_of(line)]
        for found in re.finditer(r"WINDROW_C_API\s+([\w\s*]*?[\s*])(windrow_\w+)\(([^;]*)\);", text):
            self.functions[found.group(2)] = self._call(found.group(1), found.group(3))
        for found in re.finditer(r"(?:typedef int32_t (windrow_\w+);\s*)?enum \{(.*?)\};", text, flags=re.DOTALL):
            values = [(name, int(value)) for name, value in re.findall(r"(\w+)\s*=\s*(-?\d+)", found.group(2))]
            self.choices[found.group(1) or values[0][0]] = values

    @staticmethod
    def _call(result, parameters):
        parts = [] if parameters.strip() == "void" else [next(iter(fields_of(part))) for part in parameters.split(",")]
        return type_of(result), [(kind, name) for kind, name, _ in parts]

    def ctype(self, name):
        """The ctypes type of a type; of void None, of each pointer c_void_p."""
        name = name.removeprefix("const ")
        if "*" in name:
            return ctypes.c_void_p
        if name == "void":
            return None
        kind = self.types.get(name)
        if kind is None:
            fields = [(field, self.ctype(of) * length if length else self.ctype(of)) for of, field, length in self.structs[name]]
            kind = self.types[name] = type(name, (ctypes.Structure,), {"_fields_": fields})
        return self.ctype(kind) if isinstance(kind, str) else kind

    def bind(self, library):
        """Sets the types of each function of a loaded library."""
        for name, (result, parameters) in self.functions.items():
            function = getattr(library, name)
            function.restype = ctypes.c_char_p if result == "const char*" else self.ctype(result)
            function.argtypes = [self.ctype(kind) for kind, _ in parameters]


def type_of(words):
    return re.sub(r" ?(\*)(?: ?(const)\b)?", r"\1\2", " ".join(words.split()))


def fields_of(line):
    """(type, name, length) of each name of a declaration."""
    found = re.match(r"((?:const )?\w+(?: ?\*(?: ?const\b)?)*) ?(.+)$", " ".join(line.split()))
    for name in found.group(2).split(",") if found else ():
        array = re.match(r"\s*(\w+)(?:\[(\d+)\])?", name)
        yield type_of(found.group(1)), array.group(1), int(array.group(2) or 0)


def common(names):
    """What all names begin with, up to a "_"; of one nothing."""
    before = names[0] if len(names) > 1 else ""
    while before and not (before.endswith("_") and all(name.startswith(before) for name in names)):
        before = before[:-1]
    return before
