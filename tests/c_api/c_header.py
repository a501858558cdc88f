"""The C headers as Python has them: functions, structs and types, read from their text, and ctypes made of them."""
import ctypes
import pathlib
import re

SCALARS = {"float": ctypes.c_float, "double": ctypes.c_double, "int32_t": ctypes.c_int32, "uint32_t": ctypes.c_uint32,
           "int64_t": ctypes.c_int64, "uint64_t": ctypes.c_uint64, "uint16_t": ctypes.c_uint16, "uint8_t": ctypes.c_uint8,
           "size_t": ctypes.c_size_t}


class Header:
    """All headers of a folder."""

    def __init__(self, folder):
        text = "\n".join(path.read_text(encoding="utf-8") for path in sorted(pathlib.Path(folder).glob("*.h")))
        text = re.sub(r"/\*.*?\*/", " ", text, flags=re.DOTALL)
        text = re.sub(r"^\s*#.*$", "", text, flags=re.MULTILINE)
        self.types = dict(SCALARS)
        self.structs = {}
        for found in re.finditer(r"typedef\s+(\w+)\s+(windrow_\w+);", text):
            self.types[found.group(2)] = found.group(1)
        for found in re.finditer(r"typedef\s+[\w\s*]+\(\*(windrow_\w+)\)\(", text):
            self.types[found.group(1)] = ctypes.c_void_p
        for found in re.finditer(r"typedef struct (windrow_\w+) \{(.*?)\} \1;", text, flags=re.DOTALL):
            self.structs[found.group(1)] = [field for line in found.group(2).split(";") for field in self._fields(line)]
        self.functions = {}
        for found in re.finditer(r"WINDROW_C_API\s+([\w\s*]*?[\s*])(windrow_\w+)\(([^;]*)\);", text):
            parameters = [] if found.group(3).strip() == "void" else [self._parameter(part) for part in found.group(3).split(",")]
            self.functions[found.group(2)] = (" ".join(found.group(1).split()), parameters)

    @staticmethod
    def _fields(line):
        """(type, name, length) of each field of a declaration; length 0: no array."""
        words = " ".join(line.split())
        if not words:
            return
        found = re.match(r"((?:const )?\w+(?: ?\*(?: ?const)?)*\*?) ?(.*)$", words)
        kind, names = found.group(1).replace(" ", ""), found.group(2)
        for name in names.split(","):
            array = re.match(r"\s*(\**)\s*(?:const\s+)?(\**)\s*(\w+)(?:\[(\d+)\])?", name)
            pointer = "*" if "*" in kind + array.group(1) + array.group(2) else ""
            yield kind.replace("const", "").replace("*", "") + pointer, array.group(3), int(array.group(4) or 0)

    @staticmethod
    def _parameter(part):
        words = " ".join(part.split()).replace("const ", "")
        found = re.match(r"(\w+)( ?\*+)? ?(\w+)$", words)
        return found.group(1) + ("*" if found.group(2) else ""), found.group(3)

    def ctype(self, name):
        """The ctypes type of a type's name; void is None."""
        if name.endswith("*"):
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
            result = result.replace("const ", "")
            function.restype = ctypes.c_char_p if result == "char*" else self.ctype(result.replace(" ", ""))
            function.argtypes = [self.ctype(kind) for kind, _ in parameters]
