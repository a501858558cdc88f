"""The operators of a step on arrays of one's own: advection, diffusion, divergence, projection."""
from __future__ import annotations

import ctypes
from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _c
from ._library import Handle, WindrowError, check, library
from .axes import own_order
from ._values import Floats, Vec3, _choice, _numbers, aligned, field, number, of_class, scalars, whole
from .settings import Boundaries, Config, DiffusionMethod, Interpolation, Obstacle
from .wind import ThreadPool

_INTERPOLATIONS = ("linear", "cubic", "cubic_32")
_METHODS: tuple[DiffusionMethod, ...] = ("none", "one_pass", "implicit")
_VECTORS = ctypes.POINTER(_c.Vec4)
_FLOATS = ctypes.POINTER(ctypes.c_float)


class Workspace:
    """Tables and scratch for one box: the cells, cell_size, rows, boundaries, ambient wind and simd of a config.

        box = windrow.Config(cells=(64, 64, 1), cell_size=0.1, boundaries=windrow.Boundaries.all("periodic"))
        work = windrow.Workspace(box)
        free = work.project(velocity)

    A velocity is an array [z, y, x, component] in m/s of three components, or of x, y, z, 0, which is read without a copy where it is
    float32 and contiguous. Results have the components of what was given; a call changes none of its arguments. One thread at a time may
    use a workspace.
    """

    def __init__(self, config: Config | None = None, *, pool: ThreadPool | None = None) -> None:
        config = Config() if config is None else of_class("config", config, Config)
        keep: list[Any] = []
        struct = config._to_c(keep)
        if pool is not None:
            struct.parallel_for = of_class("pool", pool, ThreadPool)._loop
        self._handle = Handle(lambda out: library.windrow_workspace_create(ctypes.byref(struct), out), "windrow_workspace_destroy",
                              *([pool._handle] if pool else []))
        self._work = self._handle.pointer
        self._grid = own_order(config.cells)
        self._count = int(np.prod(self._grid))

    def set_boundaries(self, boundaries: Boundaries) -> None:
        """Other conditions at the faces of the box."""
        check(library.windrow_workspace_set_boundaries(self._work, ctypes.byref(of_class("boundaries", boundaries, Boundaries)._to_c([]))))

    def set_ambient(self, ambient: Vec3) -> None:
        """[m/s] The wind beyond open boundaries."""
        check(library.windrow_workspace_set_ambient(self._work, _numbers("ambient", ambient, _c.Vec3)))

    def set_obstacles(self, obstacles: Sequence[Obstacle], velocities: Sequence[Vec3] | None = None,
                      spins: Sequence[Vec3] | None = None) -> None:
        """Replaces the obstacles that every operator sees. Positions are relative to the box's corner that is low
        in the library's own axes.

        `velocities` [m/s] and `spins` [rad/s], one for each; None: at rest.
        """
        obstacles = [of_class("obstacle", obstacle, Obstacle) for obstacle in list(obstacles)]
        count = len(obstacles)
        keep: list[Any] = []
        moves = []
        for name, given in (("velocities", velocities), ("spins", spins)):
            if given is not None and len(given) != count:
                raise WindrowError(f"{name} has {len(given)} entries: give {count}, one for each obstacle.")
            moves.append(None if given is None else (_c.Vec3 * count)(*[_numbers(name, value, _c.Vec3) for value in given]))
        structs = (_c.Obstacle * count)(*[obstacle._to_c(keep) for obstacle in obstacles])
        check(library.windrow_workspace_set_obstacles(self._work, structs, *moves, count))

    def impulse_on(self, obstacle: int) -> tuple[float, float, float]:
        """[m^4/s] The momentum that the last projection took from the air and gave to an obstacle, by its place in the list."""
        impulse = _c.Vec3()
        check(library.windrow_workspace_impulse_on(self._work, whole("obstacle", obstacle), ctypes.byref(impulse)))
        return (impulse.x, impulse.y, impulse.z)

    def advect(self, carried: npt.ArrayLike, velocity: npt.ArrayLike, dt: float, *, velocity_old: npt.ArrayLike | None = None,
               extrapolation: float = 1.0, relaxation: float = 1.0, interpolation: Interpolation = "cubic") -> Floats:
        """What `carried` is after a step of dt [s] on the wind `velocity`.

        result(x) = carried at where the air of x was dt ago, by the second-order trajectory (Hortal 2002, SETTLS). `velocity_old` is the
        wind one step earlier, None: steady; `extrapolation` is dt over the step before.
        """
        what, three = field("carried", carried, self._grid)
        wind, _ = field("velocity", velocity, self._grid)
        transport = _c.Transport()
        check(library.windrow_transport_init(ctypes.byref(transport), ctypes.sizeof(transport)))
        transport.dt = number("dt", dt)
        transport.carried = what.ctypes.data_as(_VECTORS)
        transport.velocity = wind.ctypes.data_as(_VECTORS)
        if velocity_old is not None:
            old, _ = field("velocity_old", velocity_old, self._grid)
            transport.velocity_old = old.ctypes.data_as(_VECTORS)
        transport.extrapolation = number("extrapolation", extrapolation)
        transport.relaxation = number("relaxation", relaxation)
        transport.interpolation = _choice("interpolation", interpolation, _INTERPOLATIONS)
        result = self._room()
        check(library.windrow_advect(self._work, ctypes.byref(transport), result.ctypes.data_as(_VECTORS), self._count))
        return _as_given(result, three)

    def advect_scalar(self, carried: npt.ArrayLike, velocity: npt.ArrayLike, dt: float, *, outside: float = 0.0, clamped: bool = False,
                      interpolation: Interpolation = "cubic") -> Floats:
        """A scalar [z, y, x] on the same wind: smoke, seeds, a dye. `outside` is its value beyond open boundaries.

        `clamped`: no result leaves the range of the eight values around its departure point; of order 2.6 in place of 3.
        """
        what = scalars("carried", carried, self._grid)
        wind, _ = field("velocity", velocity, self._grid)
        transport = _c.ScalarTransport()
        check(library.windrow_scalar_transport_init(ctypes.byref(transport), ctypes.sizeof(transport)))
        transport.dt = number("dt", dt)
        transport.carried = what.ctypes.data_as(_FLOATS)
        transport.velocity = wind.ctypes.data_as(_VECTORS)
        transport.outside = number("outside", outside)
        transport.clamped = bool(clamped)
        transport.interpolation = _choice("interpolation", interpolation, _INTERPOLATIONS)
        result = np.empty(self._grid, np.float32)
        check(library.windrow_advect_scalar(self._work, ctypes.byref(transport), result.ctypes.data_as(_FLOATS), self._count))
        return result

    def diffuse(self, velocity: npt.ArrayLike, viscosity: float, dt: float) -> Floats:
        """A field after dt [s] of diffusion with a viscosity [m^2/s]: first order in time, second in space, stable for any step."""
        return self.diffuse_and_method(velocity, viscosity, dt)[0]

    def diffuse_and_method(self, velocity: npt.ArrayLike, viscosity: float, dt: float) -> tuple[Floats, DiffusionMethod]:
        """The same, and what it took by viscosity * dt / cell_size^2: "none" below 1e-4, "one_pass" up to 1/12, "implicit" above."""
        what, three = field("velocity", velocity, self._grid)
        result = self._room()
        method = ctypes.c_int32()
        check(library.windrow_diffuse(self._work, what.ctypes.data_as(_VECTORS), number("viscosity", viscosity), number("dt", dt), result.ctypes.data_as(_VECTORS),
                                      ctypes.byref(method), self._count))
        return _as_given(result, three), _METHODS[method.value]

    def divergence(self, velocity: npt.ArrayLike) -> Floats:
        """[1/s] Central divergence at the cells' centres, as the projection sees it."""
        what, _ = field("velocity", velocity, self._grid)
        result = np.empty(self._grid, np.float32)
        check(library.windrow_divergence(self._work, what.ctypes.data_as(_VECTORS), result.ctypes.data_as(_FLOATS), self._count))
        return result

    def solve_poisson(self, rhs: npt.ArrayLike) -> Floats:
        """phi with L phi = rhs, L the 7-point Laplacian [1/m^2], by a direct solve.

        phi is 0 at the ghosts' centres beyond open boundaries and level across walls. In a box without an open boundary the mean of rhs
        is dropped and phi has mean 0.
        """
        phi = scalars("rhs", rhs, self._grid).copy()
        check(library.windrow_solve_poisson(self._work, phi.ctypes.data_as(_FLOATS), self._count))
        return phi

    def project(self, velocity: npt.ArrayLike, expansion: npt.ArrayLike | None = None) -> Floats:
        """A field without its divergence: velocity - grad phi with L phi = div velocity - expansion.

        What remains falls as h^2 in a periodic box, and between walls through which no wind blows. Wind through a wall, and through an open
        face, leaves some in the cells beside it. A box of two dimensions has one cell along z and is periodic there.

        `expansion` [1/s] is the divergence that sources of volume want. Cells inside obstacles take their velocity.
        """
        what, three = field("velocity", velocity, self._grid)
        result = self._room()
        result[...] = what
        sources = None if expansion is None else scalars("expansion", expansion, self._grid).ctypes.data_as(_FLOATS)
        check(library.windrow_project(self._work, result.ctypes.data_as(_VECTORS), None, sources, self._count))
        return _as_given(result, three)

    @property
    def memory_bytes(self) -> int:
        """That it has allocated."""
        return int(library.windrow_workspace_memory_bytes(self._work))

    def _room(self) -> Floats:
        return aligned((*self._grid, 4))


def _as_given(result: Floats, three: bool) -> Floats:
    return np.ascontiguousarray(result[..., :3]) if three else result
