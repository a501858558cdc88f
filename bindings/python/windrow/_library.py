"""The shared library: where it is, what its errors become, and objects of its own."""
from __future__ import annotations

import ctypes
import os
import pathlib
import sys
import warnings
from typing import Any, Callable, NoReturn

from . import _c
from ._version import __version__

_NAMES = {"win32": ("libwindrow.dll", "windrow.dll"), "darwin": ("libwindrow.dylib",)}.get(sys.platform, ("libwindrow.so",))
_KINDS = {_c.REJECTED: "rejected", _c.STALE: "stale", _c.OUT_OF_MEMORY: "out of memory", _c.CANNOT_WRITE: "cannot write",
          _c.DISK_FULL: "disk full", _c.UNSUPPORTED: "unsupported", _c.NOT_READY: "not ready", _c.DEVICE_LOST: "device lost",
          _c.UNEXPECTED: "unexpected"}


class WindrowError(Exception):
    """A call failed. The text is the library's sentence: what is wrong, its value, the fix.

    `kind` is its class: "rejected", "stale", "out of memory", "cannot write", "disk full", "unsupported" or "unexpected".
    """

    def __init__(self, sentence: str, kind: str = "rejected") -> None:
        super().__init__(sentence)
        self.kind = kind


def _find() -> str:
    """The library of WINDROW_LIBRARY, else the package's own, else the system's."""
    named = os.environ.get("WINDROW_LIBRARY")
    if named:
        return named
    for name in _NAMES:
        beside = pathlib.Path(__file__).with_name(name)
        if beside.exists():
            return str(beside)
    return _NAMES[0] if sys.platform != "linux" else f"libwindrow.so.{__version__.rpartition('.')[0]}"


def _load() -> Any:
    place = _find()
    try:
        loaded = _c.bind(ctypes.CDLL(place))
    except (OSError, AttributeError) as error:
        raise ImportError(f"windrow's library {place} cannot be loaded ({error}): install the wheel, or set WINDROW_LIBRARY") from None
    version = loaded.windrow_version_string().decode()
    if version.rpartition(".")[0] != __version__.rpartition(".")[0]:
        raise ImportError(f"windrow's library {place} is version {version}, the package is {__version__}: install the same of both")
    return loaded


library = _load()


class WindrowWarning(UserWarning):
    """What the library warns of: cells that it repaired, a motor that reaches no air, what a scene lacks."""


def _log(severity: int, sentence: bytes, _user: object) -> None:
    if severity == _c.SEVERITY_WARNING:
        warnings.warn(sentence.decode(errors="replace"), WindrowWarning, stacklevel=3)


_LOGGER = _c.Logger(_log)  # called as long as the process runs
library.windrow_set_logger(_LOGGER, None)


def fail(result: int) -> NoReturn:
    raise WindrowError(library.windrow_last_error().decode(errors="replace"), _KINDS.get(result, "unexpected"))


def check(result: int) -> None:
    if result != 0:
        fail(result)


class Handle:
    """An object of the library, freed with its last user: the class that wraps it, arrays that look into its memory."""

    __slots__ = ("pointer", "log", "_destroy", "_keeps", "__weakref__")

    def __init__(self, create: Callable[[Any], Any], destroy: str, *keeps: object) -> None:
        self._destroy: Any = None  # for __del__, where creating fails
        self._keeps = keeps        # what the object points to
        self.log: object = None    # what it writes to, where it is a wind that is recorded
        pointer = ctypes.c_void_p()
        check(create(ctypes.byref(pointer)))
        self.pointer = pointer
        self._destroy = getattr(library, destroy)

    @classmethod
    def part_of(cls, owner: Handle, pointer: int) -> Handle:
        """An object that belongs to another one."""
        handle = cls.__new__(cls)
        handle._destroy, handle._keeps, handle.log, handle.pointer = None, (owner,), None, ctypes.c_void_p(pointer)
        return handle

    def __reduce__(self) -> NoReturn:
        raise TypeError("an object of the library cannot be copied or pickled: save a wind or a scene, or make the object again")

    def __copy__(self) -> Handle:
        return self

    def __del__(self) -> None:
        if self._destroy is not None:
            self._destroy(self.pointer)


def taken_bytes(create: Callable[[Any], Any]) -> bytes:
    """The bytes that a call makes."""
    handle = Handle(create, "windrow_bytes_destroy")
    return ctypes.string_at(library.windrow_bytes_data(handle.pointer), library.windrow_bytes_size(handle.pointer))
