"""Values on their way into the library's structs and back, and arrays of numpy's over its memory."""
from __future__ import annotations

import ast
import ctypes
import dataclasses
import enum
import inspect
import operator
import os
import sys
from collections.abc import Sequence
from typing import Any, ClassVar, TypeVar

import numpy as np
import numpy.typing as npt

from . import _c
from ._library import Handle, WindrowError, check, library

Vec2 = Sequence[float]
Vec3 = Sequence[float]
IVec3 = Sequence[int]
Quat = Sequence[float]  # x, y, z, w
Floats = npt.NDArray[np.float32]
S = TypeVar("S", bound="Settings")
T = TypeVar("T")


class Stage(enum.IntFlag):
    """Stages of a step."""

    SOURCES = _c.STAGE_SOURCES
    RELAXATION = _c.STAGE_RELAXATION
    DIFFUSION = _c.STAGE_DIFFUSION
    ADVECTION = _c.STAGE_ADVECTION
    PROJECTION = _c.STAGE_PROJECTION
    ALL = _c.STAGE_ALL


class Form:
    """A value with a C struct that is not named by its fields: a shape, a law, what a handle names."""

    def _to_c(self, keep: list[Any]) -> Any:
        """The struct of a region or a law, or a Handle."""
        return None

    def _shape(self, keep: list[Any]) -> Any:
        """The struct of a shape."""
        return None

    def _as_shared(self) -> Handle:
        """Of an object of the library."""
        raise NotImplementedError

    def _as(self, kind: Any, place: str, keep: list[Any]) -> Any:
        try:
            made = self._shape(keep) if kind is _c.Shape else self._to_c(keep)
        except TypeError:
            raise WindrowError(f"{place} is {self!r}: give numbers.") from None
        if not isinstance(made, kind):
            raise WindrowError(f"{place} is {_article(type(self).__name__)}, which is no {kind.__name__}.")
        return made


# --- What a caller gives, or one sentence -----------------------------------------------------------------------------------

def number(name: str, value: Any) -> float:
    try:
        return float(value) if not isinstance(value, (str, bytes)) and value is not None else _no_number(name, value)
    except (TypeError, ValueError, OverflowError):
        return _no_number(name, value)


def _no_number(name: str, value: Any) -> float:
    raise WindrowError(f"{name} is {value!r}: give a number.")


def metre() -> float:
    """In the host's unit of length (set_axes)."""
    numbers = (ctypes.c_double * 16)()
    check(library.windrow_axes_matrix(numbers))
    return 1.0 / float(numbers[0])


def whole(name: str, value: Any, least: int = 0, most: int = 2**31 - 1) -> int:
    try:
        found = operator.index(value)
    except TypeError:
        raise WindrowError(f"{name} is {value!r}: give a whole number.") from None
    if not least <= found <= most:
        raise WindrowError(f"{name} is {found}: give {least} to {most}.")
    return found


def text(name: str, value: Any) -> bytes:
    """UTF-8 of a word or a path."""
    try:
        found = value.encode() if isinstance(value, str) else os.fsencode(value)
    except TypeError:
        raise WindrowError(f"{name} is {value!r}: give text.") from None
    if b"\0" in found:
        raise WindrowError(f"{name} is {value!r}: leave out the character of number 0.")
    return found


def data(name: str, value: Any) -> bytes:
    if not isinstance(value, (bytes, bytearray, memoryview)):
        raise WindrowError(f"{name} is {_article(type(value).__name__)}: give bytes.")
    return bytes(value)


def of_class(name: str, value: Any, kind: type[T]) -> T:
    if not isinstance(value, kind):
        raise WindrowError(f"{name} is {value!r}: give {_article(kind.__name__)}.")
    return value


def _choice(name: str, word: object, words: Sequence[str]) -> int:
    if not isinstance(word, str) or word not in words:
        raise WindrowError(f"{name} is {word!r}: give {', '.join(map(repr, words[:-1]))} or {words[-1]!r}.")
    return words.index(word)


def _numbers(name: str, value: Any, kind: Any) -> Any:
    """A vector of the library's."""
    count = len(kind._fields_)
    is_whole = "int" in kind._fields_[0][1].__name__
    try:
        parts = list(value) if not isinstance(value, (str, bytes, dict)) else []
    except TypeError:
        parts = []
    if len(parts) != count or isinstance(parts[0], (str, bytes)):
        raise WindrowError(f"{name} is {value!r}: give {count} {'whole ' if is_whole else ''}numbers.")
    try:
        return kind(*(whole(name, part, -2**31) if is_whole else part for part in parts))
    except (TypeError, OverflowError):
        raise WindrowError(f"{name} is {value!r}: give {count} {'whole ' if is_whole else ''}numbers.") from None
    except WindrowError:
        raise WindrowError(f"{name} is {value!r}: give {count} whole numbers.") from None


def _article(name: str) -> str:
    return f"{'an' if name[0] in 'AEIOUaeiou' else 'a'} {name}"


def _shortest(value: float) -> float:
    """The shortest number of which this is the nearest float: .3 of .30000001192092896."""
    return float(str(np.float32(value)))


class Settings:
    """Base of the dataclasses of settings.py."""

    __slots__ = ()
    _struct: ClassVar[Any]
    _init: ClassVar[str] = ""
    _words: ClassVar[dict[str, tuple[str, ...]]] = {}
    _letters: ClassVar[dict[str, str]] = {}
    _shared: ClassVar[dict[str, type[Form]]] = {}  # fields that name an object of the library
    _not_negative: ClassVar[tuple[str, ...]] = ()  # below 0 is the default, which is None here

    @classmethod
    def describe(cls) -> str:
        """Each field with its default, unit, range and meaning: what an editor shows beside it."""
        said = [inspect.getdoc(cls) or cls.__name__, ""]
        fields = {field.name: field for field in dataclasses.fields(cls)}
        module = ast.parse(inspect.getsource(sys.modules[cls.__module__]))
        body = next(node.body for node in module.body if isinstance(node, ast.ClassDef) and node.name == cls.__name__)
        for field, below in zip(body, body[1:]):
            if isinstance(field, ast.AnnAssign) and isinstance(below, ast.Expr) and isinstance(below.value, ast.Constant):
                name = ast.unparse(field.target)
                if name in fields:
                    said.append(f"{name} = {ast.unparse(field.value) if field.value else ''}\n    {' '.join(str(below.value.value).split())}")
        return "\n".join(said)

    def _to_c(self, keep: list[Any]) -> Any:
        """The C struct; `keep` holds what it points to."""
        struct = self._struct()
        if self._init:
            check(getattr(library, self._init)(ctypes.byref(struct), ctypes.sizeof(struct)))
        for name, kind in self._struct._fields_:
            if name in self.__dataclass_fields__:  # type: ignore[attr-defined]
                self._put(struct, name, kind, getattr(self, name), keep)
        return struct

    def _put(self, struct: Any, name: str, kind: Any, value: Any, keep: list[Any]) -> None:
        place = f"{type(self).__name__}.{name}"
        if value is None:
            return  # the default
        if name in self._words:
            value = _choice(place, value, self._words[name])
        elif name in self._letters:
            letters = of_class(place, value, str)
            value = sum(1 << _choice(place, letter, self._letters[name]) for letter in dict.fromkeys(letters))
        elif name in self._shared:
            if not isinstance(value, self._shared[name]):
                raise WindrowError(f"{place} is {value!r}: give {_article(self._shared[name].__name__)}, or None.")
            keep.append(value)
            value = value._as_shared().pointer
        elif kind in _CLASSES:
            if type(value) is not _CLASSES[kind]:
                raise WindrowError(f"{place} is {value!r}: give {_article(kind.__name__)}.")
            value = value._to_c(keep)
        elif issubclass(kind, ctypes.Structure):
            if kind in _FORMS:
                if not isinstance(value, Form):
                    raise WindrowError(f"{place} is {value!r}: give {_FORMS[kind]}.")
                value = value._as(kind, place, keep)
            else:
                value = _numbers(place, value, kind)
        elif hasattr(kind, "contents"):
            of = kind._type_
            if of in _CLASSES:
                if type(value) is not _CLASSES[of]:
                    raise WindrowError(f"{place} is {value!r}: give {_article(of.__name__)}, or None.")
                inner = value._to_c(keep)
                keep.append(inner)
                value = ctypes.pointer(inner)
            else:
                try:
                    array = (of * len(value))(*value)
                except TypeError:
                    raise WindrowError(f"{place} is {value!r}: give a list of numbers.") from None
                if len(value) == 0:
                    return
                keep.append(array)
                setattr(struct, name.removesuffix("s") + "_count", len(value))
                value = array
        elif kind in _WHOLE:
            value = whole(place, value, *_WHOLE[kind])
        else:
            value = number(place, value)
            if name in self._not_negative and value < 0.0:
                raise WindrowError(f"{place} is {value}: give 0 or more, or None.")
        setattr(struct, name, value)

    @classmethod
    def _from_c(cls: type[S], struct: Any) -> S:
        """Of numbers, words and settings within it; what is behind pointers stays with the library."""
        found = {}
        for name, kind in cls._struct._fields_:
            field = cls.__dataclass_fields__.get(name)  # type: ignore[attr-defined]
            if field is None:
                continue
            value = getattr(struct, name)
            if name in cls._words:
                value = cls._words[name][value]
            elif isinstance(value, ctypes.Structure):
                inner = _CLASSES.get(type(value))
                value = inner._from_c(value) if inner else tuple(
                    _shortest(getattr(value, part)) if of is ctypes.c_float else getattr(value, part) for part, of in value._fields_)
            elif field.type == "bool":
                value = bool(value)
            elif kind is ctypes.c_float:
                value = _shortest(value)
            found[name] = value
        return cls(**found)

    def __init_subclass__(cls) -> None:
        _CLASSES[cls._struct] = cls


_CLASSES: dict[Any, type[Settings]] = {}
_FORMS = {_c.Shape: "a shape, such as Block()", _c.Region: "a region, such as Sphere()", _c.Law: "Drive() or Force()",
          _c.WakeLaw: "WakeDrive() or WakeForce()"}
_WHOLE = {ctypes.c_int32: (-2**31, 2**31 - 1), ctypes.c_uint32: (0, 2**32 - 1), ctypes.c_int64: (-2**63, 2**63 - 1)}


# --- Arrays ----------------------------------------------------------------------------------------------------------------

def view(address: int, shape: tuple[int, ...], kind: Any, owner: object, writable: bool = False) -> npt.NDArray[Any]:
    """An array over memory of the library's, which `owner` holds."""
    size = 1
    for length in shape:
        size *= length
    memory = (kind * size).from_address(address)
    memory._owner = owner
    array = np.frombuffer(memory, dtype=kind).reshape(shape)
    array.flags.writeable = writable
    return array


def as_array(name: str, values: npt.ArrayLike) -> npt.NDArray[Any]:
    """Numbers, in the byte order of this machine."""
    try:
        given = np.asarray(values)
    except ValueError:
        raise WindrowError(f"{name} is no array: its rows have different lengths.") from None
    if given.dtype.kind not in "fiub":
        raise WindrowError(f"{name} is an array of {given.dtype}: give numbers.")
    return given if given.dtype.isnative else given.astype(given.dtype.newbyteorder("="))


def pointer(array: npt.NDArray[Any]) -> Any:
    return ctypes.c_void_p(array.ctypes.data)


def aligned(shape: tuple[int, ...]) -> Floats:
    """Floats at a multiple of 16 bytes."""
    count = int(np.prod(shape))
    room = np.empty(count + 4, np.float32)
    first = (-room.ctypes.data % 16) // 4
    return room[first:first + count].reshape(shape)


def grid_of(cells: Any) -> tuple[int, int, int]:
    """Shape of a field, z slowest: [k, j, i]."""
    return (cells.z, cells.y, cells.x)


def field(name: str, values: npt.ArrayLike, grid: tuple[int, int, int]) -> tuple[Floats, bool]:
    """Velocities as the library reads them, x, y, z, 0 a cell, and whether the caller gave three numbers a cell."""
    given = as_array(name, values)
    if given.shape[:-1] != grid or given.shape[-1] not in (3, 4):
        raise WindrowError(f"{name} has shape {given.shape}: give {(*grid, 3)} or {(*grid, 4)}, indexed [z, y, x, component].")
    if given.shape[-1] == 4 and given.dtype == np.float32 and given.flags.c_contiguous and given.ctypes.data % 16 == 0:
        return given, False
    room = aligned((*grid, 4))
    room[..., 3] = 0.0
    room[..., :given.shape[-1]] = given
    return room, given.shape[-1] == 3


def scalars(name: str, values: npt.ArrayLike, grid: tuple[int, int, int]) -> Floats:
    given = np.ascontiguousarray(as_array(name, values), np.float32)
    if given.shape != grid:
        raise WindrowError(f"{name} has shape {given.shape}: give {grid}, indexed [z, y, x].")
    return given
