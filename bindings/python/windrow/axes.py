"""Axes and unit of the host: Blender's, Unreal's, Unity's, or metres with y up."""
from __future__ import annotations

import ctypes
import dataclasses
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from . import _c, forms
from ._library import check, library
from ._values import _CLASSES, Settings, _choice, number

Axes = Literal["y_up_right", "y_up_left", "z_up_right", "z_up_left"]
_WORDS = ("y_up_right", "y_up_left", "z_up_right", "z_up_left")
# Defaults that the library has no struct for: the power of the length in their unit.
_FORMS: dict[type, dict[str, int]] = {
    forms.Sphere: {"radius": 1}, forms.Capsule: {"half_axis": 1, "radius": 1}, forms.AlignedBox: {"half_size": 1},
    forms.Cone: {"axis": 1, "start_radius": 1, "end_radius": 1}, forms.Force: {"acceleration": 1}, forms.Drive: {"speed": 1},
    forms.WakeDrive: {"per_metre": -1}, forms.Block: {"half_size": 1}, forms.Cylinder: {"radius": 1, "half_length": 1},
    forms.Plate: {"half_size": 1}, forms.VoxelShape: {"cell_size": 1}}
_METRES = {kind: {field.name: field.default for field in dataclasses.fields(kind)} for kind in _FORMS}


def set_axes(axes: Axes = "y_up_right", unit: float = 1.0) -> None:
    """The host's axes, and its unit of length [m], for all that follows: Blender is ("z_up_right", 1), Unreal ("z_up_left", 0.01).

    Lengths, speeds, places and defaults are in the unit then, along these axes. Settings that were made before keep their numbers. Arrays
    of cells, such as `Wind.field`, stay in the library's own axes, in m/s, indexed by its z, y, x; `matrix` turns them. While no other
    thread uses the library.
    """
    check(library.windrow_set_axes(_choice("axes", axes, _WORDS), number("unit", unit)))
    for kind in set(_CLASSES.values()):
        if kind._init:
            _take_defaults(kind)
    for form, powers in _FORMS.items():
        metres = _METRES[form]
        scaled = {name: _scaled(metres[name], float(unit) ** -power) for name, power in powers.items()}
        fields = [field.name for field in dataclasses.fields(form) if field.default is not dataclasses.MISSING]
        _set_defaults(form, tuple(scaled.get(name, metres[name]) for name in fields))


def matrix() -> npt.NDArray[np.float64]:
    """(4, 4) From a place of the host to the library's own [m]. Its inverse takes the library's own velocities to the host's."""
    numbers = (ctypes.c_double * 16)()
    check(library.windrow_axes_matrix(numbers))
    return np.array(numbers, np.float64).reshape(4, 4).T


def own_order(cells: Any) -> tuple[int, int, int]:
    """Cells along the host's x, y, z as the shape of a field, which is indexed by the library's own z, y, x."""
    turn = np.abs(np.sign(matrix()[:3, :3]))
    x, y, z = (int(count) for count in turn @ np.array([cells[0], cells[1], cells[2]]))
    return (z, y, x)


def _scaled(value: Any, factor: float) -> Any:
    return tuple(part * factor for part in value) if isinstance(value, tuple) else value * factor


def _take_defaults(kind: type[Settings]) -> None:
    """Defaults that are numbers, as the library gives them to this host."""
    struct = kind._struct()
    check(getattr(library, kind._init)(ctypes.byref(struct), ctypes.sizeof(struct)))
    made: Any = kind.__init__
    for name, known in dict(made.__kwdefaults__ or {}).items():
        if isinstance(known, float) or (isinstance(known, tuple) and all(isinstance(part, (int, float)) for part in known)):
            value = getattr(struct, name, None)
            if isinstance(value, ctypes.Structure) and len(value._fields_) == len(known if isinstance(known, tuple) else ()):
                made.__kwdefaults__[name] = tuple(_shown(getattr(value, part), of) for part, of in value._fields_)
            elif isinstance(value, float) and isinstance(known, float):
                made.__kwdefaults__[name] = _shown(value, dict(kind._struct._fields_)[name])


def _shown(value: Any, kind: Any) -> Any:
    """The shortest number of which this is the nearest float."""
    return float(str(np.float32(value))) if kind is ctypes.c_float else value


def _set_defaults(form: Any, values: tuple[Any, ...]) -> None:
    form.__init__.__defaults__ = values
