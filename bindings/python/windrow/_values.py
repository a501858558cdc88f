"""Values on their way into the library's structs and back, and arrays of numpy's over its memory."""
from __future__ import annotations

import ctypes
import enum
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

    def _as(self, kind: Any, place: str, keep: list[Any]) -> Any:
        made = self._shape(keep) if kind is _c.Shape else self._to_c(keep)
        if made is None or isinstance(made, ctypes.Structure) and not isinstance(made, kind):
            raise WindrowError(f"{place} is {_article(type(self).__name__)}, which is no {kind.__name__}.")
        return made


def _choice(name: str, word: object, words: Sequence[str]) -> int:
    if word not in words:
        raise WindrowError(f"{name} is {word!r}: give {', '.join(map(repr, words[:-1]))} or {words[-1]!r}.")
    return words.index(str(word))


def _numbers(name: str, value: Any, kind: Any) -> Any:
    """A vector of the library's."""
    count = len(kind._fields_)
    try:
        if len(value) == count:
            return kind(*value)
    except TypeError:
        pass
    whole = "whole " if "int" in kind._fields_[0][1].__name__ else ""
    raise WindrowError(f"{name} is {value!r}: give {count} {whole}numbers.")


def _article(name: str) -> str:
    return f"{'an' if name[0] in 'AEIOU' else 'a'} {name}"


def _shortest(value: float) -> float:
    """The shortest number of which this is the nearest float: .3 of .30000001192092896."""
    return float(str(np.float32(value)))


class Settings:
    """Base of the dataclasses of settings.py."""

    _struct: ClassVar[Any]
    _init: ClassVar[str] = ""
    _words: ClassVar[dict[str, tuple[str, ...]]] = {}
    _letters: ClassVar[dict[str, str]] = {}

    def _to_c(self, keep: list[Any]) -> Any:
        """The C struct; `keep` holds what it points to."""
        struct = self._struct()
        if self._init:
            check(getattr(library, self._init)(ctypes.byref(struct), ctypes.sizeof(struct)))
        for name, kind in self._struct._fields_:
            if name in self.__dataclass_fields__:  # type: ignore[attr-defined]
                self._put(struct, name, kind, getattr(self, name), keep)
        return struct

    def _as(self, kind: Any, place: str, keep: list[Any]) -> Any:
        expected = kind if issubclass(kind, ctypes.Structure) else kind._type_
        if self._struct is not expected:
            raise WindrowError(f"{place} is {_article(type(self).__name__)}, which is no {expected.__name__}.")
        return self._to_c(keep)

    def _put(self, struct: Any, name: str, kind: Any, value: Any, keep: list[Any]) -> None:
        place = f"{type(self).__name__}.{name}"
        if value is None:
            return  # the default
        if name in self._words:
            value = _choice(place, value, self._words[name])
        elif name in self._letters:
            value = sum(1 << _choice(place, letter, self._letters[name]) for letter in value)
        elif isinstance(value, (Settings, Form)):
            value = value._as(kind, place, keep)
            if isinstance(value, Handle):
                keep.append(value)
                value = value.pointer
            elif not issubclass(kind, ctypes.Structure):
                keep.append(value)
                value = ctypes.pointer(value)
        elif kind in _CLASSES:
            raise WindrowError(f"{place} is {value!r}: give {_article(kind.__name__)}.")
        elif issubclass(kind, ctypes.Structure):
            value = _numbers(place, value, kind)
        elif hasattr(kind, "contents"):
            if kind._type_ in _CLASSES:
                raise WindrowError(f"{place} is {value!r}: give {_article(kind._type_.__name__)}, or None.")
            try:
                array = (kind._type_ * len(value))(*value)
            except TypeError:
                raise WindrowError(f"{place} is {value!r}: give a list of numbers.") from None
            if len(value) == 0:
                return
            keep.append(array)
            setattr(struct, name.removesuffix("s") + "_count", len(value))
            value = array
        try:
            setattr(struct, name, value)
        except TypeError:
            raise WindrowError(f"{place} is {value!r}: give {'a whole number' if 'int' in kind.__name__ else 'a number'}.") from None

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
    given = np.asarray(values)
    if given.shape[:-1] != grid or given.shape[-1] not in (3, 4):
        raise WindrowError(f"{name} has shape {given.shape}: give {(*grid, 3)} or {(*grid, 4)}, indexed [z, y, x, component].")
    if given.shape[-1] == 4 and given.dtype == np.float32 and given.flags.c_contiguous and given.ctypes.data % 16 == 0:
        return given, False
    room = aligned((*grid, 4))
    room[..., 3] = 0.0
    room[..., :given.shape[-1]] = given
    return room, given.shape[-1] == 3


def scalars(name: str, values: npt.ArrayLike, grid: tuple[int, int, int]) -> Floats:
    given = np.ascontiguousarray(values, np.float32)
    if given.shape != grid:
        raise WindrowError(f"{name} has shape {given.shape}: give {grid}, indexed [z, y, x].")
    return given
