"""Settings and reports: a dataclass for each struct of the library, with its defaults.

Made by ./dev schema from the headers of c_api and the tables of settings. Do not edit. Lengths are metres, times
seconds; a range and a unit stand before the meaning. Values are checked where they are used: by the library, in one sentence.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import ClassVar, Literal

from . import _c
from ._library import library
from ._values import IVec3, Quat, Settings, Stage, Vec2, Vec3, metre
from .forms import Block, Drive, GustTile, HeightMap, Law, Region, Shape, Sphere, WakeDrive, WakeLaw

infinity = float("inf")
BoundaryKind = Literal["open", "free_slip", "no_slip", "periodic"]
DiffusionMethod = Literal["none", "one_pass", "implicit"]
Interpolation = Literal["linear", "cubic", "cubic_32"]
Scheme = Literal["second_order", "stable_fluids"]
Simd = Literal["best", "baseline", "avx2", "avx512"]
Surface = Literal["free_slip", "no_slip"]

__all__ = [
    "Sampling", "Boundary", "Boundaries", "LogProfile", "Gusts", "Canopy", "RoughnessMap", "Roughness", "Rows",
    "Config", "PlantDrag", "BeltDrag", "SpringClass", "Envelope", "Turbulence", "DirectionalMotor", "WakeMotor",
    "JetMotor", "VortexMotor", "OmniMotor", "PressureMotor", "Obstacle", "Drag", "BladeSettings", "ShellSettings",
    "StageTimes", "Diagnostics", "Advance", "Box", "ObstacleForce", "DragForce", "BoundaryKind", "DiffusionMethod",
    "Interpolation", "Scheme", "Simd", "Surface",
]


@dataclass(kw_only=True, slots=True)
class Sampling(Settings):
    """Conversion of the wind to the wind that acts on a plant."""

    _struct: ClassVar = _c.Sampling
    _init: ClassVar = "windrow_sampling_init"

    strength: float = 1.0
    """0 to 1000. Factor on the wind; 0: no wind acts."""
    limit: float = 60.0
    """[m/s] 0 to 1e6. Upper bound of the speed, after the strength. 60 is the strongest storm."""
    detail: float = 0.0
    """0 (none) to 1. Small-scale detail over the local speed; a bound, typical detail is a quarter of it. Needs a
    tile (GustTile): without gusts, give Gusts.tile."""
    detail_length: float = 1.0
    """[m] 0.001 to 1e6. Distance from one ripple to the next, rounded so that a whole number of ripples fits a gust
    (at most its length): then one phase moves both. 1 is what cells of 1 m leave out."""


@dataclass(kw_only=True, slots=True)
class Boundary(Settings):
    """Condition at one face of the box."""

    _struct: ClassVar = _c.Boundary
    _words: ClassVar = {
        "kind": ("open", "free_slip", "no_slip", "periodic"),
    }

    kind: BoundaryKind = "open"
    """open: the ambient wind is beyond. free_slip: a wall without friction. no_slip: a wall that drags the air.
    periodic: the opposite face is beyond."""
    wall_velocity: Vec3 = (0.0, 0.0, 0.0)
    """[m/s] Each component -10000 to 10000. Velocity of a no-slip wall, in its own plane; 0 on every other kind.
    May change in every step."""


@dataclass(kw_only=True, slots=True)
class Boundaries(Settings):
    """Conditions at the six faces of the box."""

    _struct: ClassVar = _c.Boundaries

    x_low: Boundary = field(default_factory=Boundary)
    """At the low end of x."""
    x_high: Boundary = field(default_factory=Boundary)
    """At its high end."""
    y_low: Boundary = field(default_factory=Boundary)
    """Below: the floor."""
    y_high: Boundary = field(default_factory=Boundary)
    """Above."""
    z_low: Boundary = field(default_factory=Boundary)
    """At the low end of z."""
    z_high: Boundary = field(default_factory=Boundary)
    """At its high end."""

    @staticmethod
    def all(kind: BoundaryKind) -> Boundaries:
        """All six of one kind."""
        return Boundaries(**{face: Boundary(kind=kind) for face in ("x_low", "x_high", "y_low", "y_high", "z_low", "z_high")})

    @staticmethod
    def open_over_floor() -> Boundaries:
        """Open air over a free-slip floor."""
        return Boundaries._from_c(library.windrow_boundaries_open_over_floor())


@dataclass(kw_only=True, slots=True)
class LogProfile(Settings):
    """Wind over open ground: log((z + z0) / z0)."""

    _struct: ClassVar = _c.LogProfile
    _init: ClassVar = "windrow_log_profile_init"

    roughness_length: float = 0.03
    """[m] 1e-6 to 100. z0: about a tenth of the height of what is on the ground. 0.0002 water, 0.03 short grass, 1
    wood."""
    reference_height: float = 10.0
    """[m] 0.01 to 10000. Height at which the wind is the mean. 10 is where weather services measure."""


@dataclass(kw_only=True, slots=True)
class Gusts(Settings):
    """A pattern that the mean wind carries along."""

    _struct: ClassVar = _c.Gusts
    _init: ClassVar = "windrow_gusts_init"
    _shared: ClassVar = {"tile": GustTile}

    intensity: float = 0.0
    """0 (none) to 1. Standard deviation of each horizontal component over the mean horizontal speed. 0 costs
    nothing, 0.15 is open country, 0.3 a gusty day."""
    length: float = 24.0
    """[m] 0.01 to 1e6. Distance from one gust to the next. A texel is a twelfth of it, the pattern repeats after
    128 texels; 24 makes texels of 2 m, which cells of 1 m resolve, and 256 m until it repeats."""
    seed: int = 1
    """0 to 4294967295. Seed of the pattern."""
    tile: GustTile | None = None
    """The pattern itself, for many winds to use one; None: made from the seed."""


@dataclass(kw_only=True, slots=True)
class Canopy(Settings):
    """Drag of plants on the floor."""

    _struct: ClassVar = _c.Canopy
    _init: ClassVar = "windrow_canopy_init"

    height: float = 0.8
    """[m] 0 (none) to 1000. Height of the plants; 0.8 is ripe wheat. A cell that it fills in part is slowed by that
    fraction."""
    drag: float = 0.6
    """[1/m] 0 (none) to 1000. Drag coefficient, 0.15 to 0.3, times leaf area in a volume of air: wheat 0.6 (0.2
    times leaves of 2.4 times the area of its ground), short grass 2 to 5, a forest 0.03 to 0.1. Based on: Shaw &
    Schumann 1992, Boundary-Layer Meteorology 61 (0.15)."""


@dataclass(kw_only=True, slots=True)
class RoughnessMap(Settings):
    """Roughness lengths by place."""

    _struct: ClassVar = _c.RoughnessMap
    _init: ClassVar = "windrow_roughness_map_init"
    _shared: ClassVar = {"lengths": HeightMap}

    lengths: HeightMap | None = None
    """[m] Where a height map has heights; None is rejected."""
    position: Vec3 = (0.0, 0.0, 0.0)
    """[m] Each component -1e12 to 1e12. World place of its first pixel; y does not count."""
    scale: Vec3 = (1.0, 1.0, 1.0)
    """Each component 1e-6 to 100000. Factor on its size along x and z, the metres of a pixel, and, y, on the
    lengths."""


@dataclass(kw_only=True, slots=True)
class Roughness(Settings):
    """Rough ground."""

    _struct: ClassVar = _c.Roughness
    _init: ClassVar = "windrow_roughness_init"

    length: float = 0.03
    """[m] 1e-6 to 100. Roughness length z0: about a tenth of the height of what is on the ground. 0.0002 water,
    0.03 short grass, 0.1 crops, 0.3 bushes, 1 wood."""
    longest_mixing: float = 0.0
    """[m] 0 (no limit) to 100000. Longest mixing length. Over open ground eddies grow with the height; among
    buildings, which the grid resolves, about a twentieth of their height leaves the wakes unsteady."""
    map: RoughnessMap | None = None
    """Lengths by place, instead of one. Default none."""


@dataclass(kw_only=True, slots=True)
class Rows(Settings):
    """Rows of cells of unequal thickness."""

    _struct: ClassVar = _c.Rows
    _init: ClassVar = "windrow_rows_init"

    first: float = 0.5
    """[m] A number above 0, at most 1e6. Thickness of the lowest rows. The lowest cell's centre is at half of it:
    .3 m resolves a log profile among grass."""
    uniform: int = 4
    """1 to 2048. How many rows are that thick. Over hills as many as reach the highest ground, so that all ground
    is met by cells of one size."""
    ratio: float = 1.1
    """1 to 1.5. Distance between two rows above these over the distance below. Up to 1.15 the error stays that of
    equal rows of the mean thickness."""
    top: float = 0.0
    """[m] 0 (by the ratio) to 1e6. Height of the box. The ratio follows from it. With heights: where the box ends
    above the last one."""
    heights: Sequence[float] = ()
    """[m] A number above 0, at most 1e6. Heights of the rows' centres over the floor of the box, one a row, in
    place of the law. A distance between two is at most twice the distance beside it. Default none."""


@dataclass(kw_only=True, slots=True)
class Config(Settings):
    """Settings of a wind: 32 x 16 x 32 cells of 1 m, open air, no wind."""

    _struct: ClassVar = _c.Config
    _init: ClassVar = "windrow_config_init"
    _not_negative: ClassVar = ("relaxation_time",)
    _letters: ClassVar = {"follow_axes": "xyz"}
    _words: ClassVar = {
        "scheme": ("second_order", "stable_fluids"),
        "interpolation": ("linear", "cubic", "cubic_32"),
        "simd": ("best", "baseline", "avx2", "avx512"),
    }

    cells: IVec3 = (32, 16, 32)
    """[cells] Each component 1 to 2048. Cells along x, y, z; at most 67,108,864 in all. Odd sizes too. The default
    is 32 m around a player at 1 m, half as high."""
    cell_size: float = 1.0
    """[m] 1e-6 to 1e6. Edge of a cell; with rows of their own, along x and z. At 1 m a gust that a person notices
    spans several."""
    boundaries: Boundaries = field(default_factory=Boundaries)
    """Boundary conditions of the six faces. Default: open everywhere; Boundaries.open_over_floor() adds ground.
    Periodic boundaries come in pairs."""
    follow_axes: str | None = None
    """Axes along which the box follows, such as "xz". Default None: those with two open boundaries; others
    cannot."""
    centre: Vec3 = (0.0, 0.0, 0.0)
    """[m] Each component -1e12 to 1e12. Point that the box is centred on at the start, to whole cells; for good on
    axes that do not follow. Its height does not count over a wall at boundaries.y_low: the box stands on floor."""
    ambient: Vec3 = (0.0, 0.0, 0.0)
    """[m/s] Each component -10000 to 10000. Mean wind: of the air at the start, of the inflow through open
    boundaries, of new cells. Its component along an axis that a wall closes is dropped."""
    profile: LogProfile | None = None
    """Wind over open ground: log((z + z0) / z0), 0 at the ground (the box's floor, or height 0 without one), the
    ambient wind at the reference height, more above. Default none: the same wind at all heights; LogProfile() for
    the profile with its own defaults."""
    gusts: Gusts | None = None
    """A frozen pattern that the ambient wind carries along, outside the box and through it. Calm air has none. The
    pattern is not periodic in the box: it jumps at periodic boundaries."""
    canopy: Canopy | None = None
    """Drag of plants of uniform height and density on the floor, or at height 0 without one. The inflow, and the
    wind to which the air relaxes, is still the ambient wind. Default none, which costs nothing: plants then bend in
    the wind and do not slow it; Canopy() for wheat."""
    roughness: Roughness | None = None
    """Rough ground: its drag, and the mixing of the air above it by turbulence. Default none, which costs nothing:
    the ground is smooth, and a profile is worn away by what the air does; Roughness() for short grass."""
    rows: Rows | None = None
    """Rows of cells of unequal thickness, thin near the ground and thick aloft; Rows() for rows of half a metre
    that grow by a tenth from the fifth on. Default none, which costs nothing: all rows are cell_size thick. At most
    128 rows. Such a box keeps its height, which set_floor changes by whole lowest rows, and the air is then
    interpolated; it cannot repeat along y."""
    blend_width: float = 2.0
    """[cells] 0 (none) to 64. Width over which sampled wind fades to ambient at the boundaries along which the box
    follows. It ends one cell before the box does (two with ticks), so that a shift of the box moves nothing. Axes
    of fewer than 8 cells (10 with ticks) have none."""
    viscosity: float = 1.5e-05
    """[m^2/s] 0 to 1e9. Kinematic viscosity. Default: that of air, which at 1 m cells is below what the solver
    resolves and costs nothing."""
    relaxation_time: float | None = None
    """[s] 0 (never) to 1e9. Time constant of the relaxation to the ambient wind. Default 20; 200 while wind meets
    obstacles, whose lees 20 would fill. A collocated solver has no other damping of the checkerboard mode in still
    air. 0 is for analytic cases."""
    sleep_speed: float = 0.001
    """[m/s] 0 (never) to 10000. Air that differs from ambient by less everywhere, with no motor in reach and no
    gusts, sleeps: it becomes ambient, and a step costs microseconds until something acts. It does not sleep without
    a relaxation time or while viscosity acts."""
    scheme: Scheme = "second_order"
    """Time scheme. second_order: semi-implicit semi-Lagrangian. stable_fluids: the classic split, first order."""
    interpolation: Interpolation = "cubic"
    """Interpolation of the advection. linear: never overshoots, smooths. cubic: third order. cubic_32: reads 32 of
    its 64 cells, 1.00 to 1.05 of its error, less time without AVX-512."""
    max_cfl: float = 2.0
    """A number above 0, at most 1e6. Cells that the air may cross in one sub-step. Above 2 the backtrace may miss
    thin motors; large values are for tests of the raw step."""
    max_substeps: int = 8
    """1 to 64. Maximal number of sub-steps in a step. Beyond max_cfl * max_substeps cells a step, speeds are
    limited (and counted). While obstacles move, the number follows from speeds of four steps ago and from what acts
    since."""
    pressure_solves: int = 0
    """0 (two, eight in the first step of a flow) to 64. Direct solves of the pressure around obstacles in a
    sub-step. Each further solve costs about a fifth of a step; without obstacles in the box there is one."""
    stages: Stage = Stage.ALL
    """Stages that run."""
    ticks_hz: float = 30.0
    """1 to 10000. Ticks a second. At 30, blended between ticks, leaves move as smoothly as at 144, at a fifth of
    the cost."""
    ticks_max_per_call: int = 4
    """1 to 1000. Maximal number of ticks in one call. Time beyond them is dropped and reported: a slow machine gets
    a slower wind, not an ever longer frame."""
    simd: Simd = "best"
    """Instructions of the hot loops. Default: the best that this machine runs. Each level gives one result,
    baseline the same on all machines."""
    floor: float = 0.0
    """[m] -1e12 to 1e12. Height of the ground, where boundaries.y_low is a wall: the box's low side, to whole
    cells. Default 0. set_floor changes it."""
    jump_speed: float = 100.0
    """[m/s] 0 (never) to 1e9. An obstacle or a wake that is moved faster has jumped: it is at its new place at
    once, at rest, and pushes no air on the way (Diagnostics.jumps). Default 100: above what moves in a game's air,
    below a respawn over two metres."""


@dataclass(kw_only=True, slots=True)
class PlantDrag(Settings):
    """A plant, or anything porous that a box along the axes surrounds: a bush, a crown, a net."""

    _struct: ClassVar = _c.PlantDrag
    _init: ClassVar = "windrow_plant_drag_init"

    radius: float = 1.0
    """[m] A number above 0, at most 10000. Half of its width along x and z. Below one cell its drag is spread over
    two cells."""
    position: Vec3 = (0.0, 0.0, 0.0)
    """[m] Each component -1e12 to 1e12. Its foot."""
    base: float = 0.0
    """[m] 0 to 10000. Height of its lowest leaves over its foot, below `height`: 0 for a bush, the bare stem of a
    tree."""
    height: float = 2.0
    """[m] A number above 0, at most 10000. Height of its top over its foot."""
    area: float = 2.0
    """[m^2] 0 (none) to 1e6. Drag area: drag coefficient times frontal area, of all leaves and twigs together. The
    default is half of the default's front of 4 m^2."""


@dataclass(kw_only=True, slots=True)
class BeltDrag(Settings):
    """A hedge, a row of trees, a fence, a net: a strip between two places."""

    _struct: ClassVar = _c.BeltDrag
    _init: ClassVar = "windrow_belt_drag_init"

    width: float = 2.0
    """[m] A number above 0, at most 10000. Thickness, across its length. Below two cells its drag is spread over
    two cells."""
    start: Vec3 = (-5.0, 0.0, 0.0)
    """[m] Each component -1e12 to 1e12. Its foot at one end."""
    end: Vec3 = (5.0, 0.0, 0.0)
    """[m] Each component -1e12 to 1e12. Its foot at the other end, 1 mm to 1e4 m away along x and z. Between them
    the foot rises evenly."""
    height: float = 2.0
    """[m] A number above 0, at most 10000. Height over its foot."""
    resistance: float = 2.0
    """0 (none) to 10000. Sum of c across its thickness, half of the pressure loss coefficient of a screen: 2 is a
    fence that is half open (Wilson 1985)."""


@dataclass(kw_only=True, slots=True)
class SpringClass(Settings):
    """Class of plants that swing."""

    _struct: ClassVar = _c.SpringClass

    frequency_hz: float = 2.5
    """[Hz] 1e-4 to 1000. Natural frequency without damping. A lower one follows gusts later."""
    damping: float = 0.12
    """0 to 1000. Damping ratio. 0: undamped; below 1: decaying oscillation; 1: critical; above 1: slow return.
    Crops and trees have 0.12, drag of the leaves included."""


@dataclass(kw_only=True, slots=True)
class Envelope(Settings):
    """[s] Strength over time."""

    _struct: ClassVar = _c.Envelope

    attack: float = 0.0
    """[s] 0 to 1e9. Time in which it rises."""
    hold: float = infinity
    """[s] At least 0. Time at full strength. Default infinity: until the motor is removed."""
    decay: float = 0.0
    """[s] 0 to 1e9. Time in which it falls, after the hold."""
    delay: float = 0.0
    """[s] 0 to 1e9. Time before it begins to rise, in which the motor rests: gusts that are added together come one
    by one."""


@dataclass(kw_only=True, slots=True)
class Turbulence(Settings):
    """Eddies in what a motor blows."""

    _struct: ClassVar = _c.Turbulence

    intensity: float = 0.05
    """0 (none) to 1. Standard deviation over U of a horizontal component of what leaves the region. At 0.05 jets
    spread as measured ones do. 0 costs nothing."""
    length: float = 0.0
    """[m] 0 (two radii) to 1e6. Size of the largest eddies; most are a third of that. 0: two radii of the region
    (of a box, two of its smallest half sizes)."""
    seed: int = 0
    """0 to 4294967295. Selects a part of the pattern: motors of the same kind, age and seed have the same
    eddies."""


@dataclass(kw_only=True, slots=True)
class DirectionalMotor(Settings):
    """A fan, a gust, a draught."""

    _struct: ClassVar = _c.DirectionalMotor
    _init: ClassVar = "windrow_directional_motor_init"

    direction: Vec3 = (1.0, 0.0, 0.0)
    """A finite vector that is not 0. Any length; normalised on creation."""
    position: Vec3 = (0.0, 0.0, 0.0)
    """[m] Each component -1e12 to 1e12. Centre of the region; first end of a cone."""
    region: Region = field(default_factory=Sphere)
    """Region in which it acts: fully in the middle, falling smoothly to 0 at the edge."""
    law: Law = field(default_factory=Drive)
    """Law of its action on the air."""
    envelope: Envelope = field(default_factory=Envelope)
    """Strength over time."""
    turbulence: Turbulence = field(default_factory=Turbulence)
    """Eddies in what it blows."""


@dataclass(kw_only=True, slots=True)
class WakeMotor(Settings):
    """The wake of a moving body."""

    _struct: ClassVar = _c.WakeMotor
    _init: ClassVar = "windrow_wake_motor_init"

    radius: float = 0.5
    """[m] A number above 0, at most 1e6. Radius of the body."""
    position: Vec3 = (0.0, 0.0, 0.0)
    """[m] Each component -1e12 to 1e12. Start of the path."""
    law: WakeLaw = field(default_factory=WakeDrive)
    """Law of its action on the air."""
    envelope: Envelope = field(default_factory=Envelope)
    """Strength over time."""
    turbulence: Turbulence = field(default_factory=lambda: Turbulence(intensity=0.0))
    """Eddies in the wake. Default none: a wake makes its own."""


@dataclass(kw_only=True, slots=True)
class JetMotor(Settings):
    """A nozzle."""

    _struct: ClassVar = _c.JetMotor
    _init: ClassVar = "windrow_jet_motor_init"

    direction: Vec3 = (1.0, 0.0, 0.0)
    """A finite vector that is not 0. Any length; normalised on creation."""
    position: Vec3 = (0.0, 0.0, 0.0)
    """[m] Each component -1e12 to 1e12. The nozzle."""
    length: float = 6.0
    """[m] A number above 0, at most 1e6. Length over which it pushes. The air carries the jet on beyond it."""
    start_radius: float = 0.5
    """[m] A number above 0, at most 1e6. Radius at the nozzle."""
    end_radius: float = 1.5
    """[m] A number above 0, at most 1e6. Radius at the end; equal to start_radius: a cylinder."""
    law: Law = field(default_factory=lambda: Drive(12.0 * metre(), 8.0))
    """Law of its action on the air, at the nozzle."""
    envelope: Envelope = field(default_factory=Envelope)
    """Strength over time."""
    turbulence: Turbulence = field(default_factory=Turbulence)
    """Eddies in the jet: they make it roll up and spread."""


@dataclass(kw_only=True, slots=True)
class VortexMotor(Settings):
    """Turns the air about an axis."""

    _struct: ClassVar = _c.VortexMotor
    _init: ClassVar = "windrow_vortex_motor_init"

    axis: Vec3 = (0.0, 1.0, 0.0)
    """A finite vector that is not 0. Any length; normalised on creation."""
    position: Vec3 = (0.0, 0.0, 0.0)
    """[m] Each component -1e12 to 1e12. The middle."""
    radius: float = 4.0
    """[m] A number above 0, at most 1e6. Distance from the axis beyond which nothing acts."""
    half_length: float = 4.0
    """[m] A number above 0, at most 1e6. Along the axis, from the middle to each end."""
    lift: float = 0.0
    """-10 to 10. Speed along the axis in the middle over the swirl. A dust devil has about 0.5."""
    law: Law = field(default_factory=lambda: Drive(8.0 * metre(), 8.0))
    """Law of its action on the air, where it is fastest."""
    envelope: Envelope = field(default_factory=Envelope)
    """Strength over time."""


@dataclass(kw_only=True, slots=True)
class OmniMotor(Settings):
    """Air that comes out of a ball or vanishes in it."""

    _struct: ClassVar = _c.OmniMotor
    _init: ClassVar = "windrow_omni_motor_init"

    radius: float = 2.0
    """[m] A number above 0, at most 1e6. Radius of the ball."""
    position: Vec3 = (0.0, 0.0, 0.0)
    """[m] Each component -1e12 to 1e12. Centre of the ball."""
    speed: float = 5.0
    """[m/s] -10000 to 10000. Outward speed at the radius; negative draws in."""
    envelope: Envelope = field(default_factory=Envelope)
    """Strength over time."""


@dataclass(kw_only=True, slots=True)
class PressureMotor(Settings):
    """A burst."""

    _struct: ClassVar = _c.PressureMotor
    _init: ClassVar = "windrow_pressure_motor_init"

    radius: float = 2.0
    """[m] A number above 0, at most 1e6. Radius of the ball."""
    position: Vec3 = (0.0, 0.0, 0.0)
    """[m] Each component -1e12 to 1e12. Centre of the ball."""
    speed: float = 20.0
    """[m/s] -10000 to 10000. Outward speed at the radius in the first moment; negative: an implosion."""
    duration: float = 0.2
    """[s] A number above 0, at most 1e9. T: duration of the outflow before the inflow."""


@dataclass(kw_only=True, slots=True)
class Obstacle(Settings):
    """A body that the air flows around."""

    _struct: ClassVar = _c.Obstacle
    _init: ClassVar = "windrow_obstacle_init"
    _words: ClassVar = {
        "surface": ("free_slip", "no_slip"),
    }

    surface: Surface = "free_slip"
    """free_slip: the air slides along it. At 1 m cells the layer that a wall slows is thinner than a cell. no_slip:
    the air sticks to it, through the viscosity."""
    position: Vec3 = (0.0, 0.0, 0.0)
    """[m] Each component -1e12 to 1e12. Centre of the shape; the origin of a mesh."""
    orientation: Quat = (0.0, 0.0, 0.0, 1.0)
    """A finite vector that is not 0. From the shape's own axes to the world's. Default: not turned."""
    shape: Shape = field(default_factory=Block)
    """Its form and size."""


@dataclass(kw_only=True, slots=True)
class Drag(Settings):
    """Mechanical properties of a stalk, uniform along its length."""

    _struct: ClassVar = _c.Drag
    _init: ClassVar = "windrow_drag_init"

    length: float = 0.3
    """[m] 1e-4 to 200. Length of the stalk; 0.3 is meadow grass. In a scene it is that of the class. The bend grows
    with its cube."""
    width: float = 0.004
    """[m] 1e-6 to 100. Width across the wind, leaves included. A blade of grass has 0.004."""
    rigidity: float = 4.2e-05
    """[N m2] 1e-12 to 1e12. E I. 4.2e-5 is a blade creased to a V, folded_rigidity(5e8, 0.004, 2.5e-4, 0.001)."""
    drag_coefficient: float = 1.95
    """0 to 10. A flat plate has 1.95 (Luhar & Nepf 2011), a round stem 1.1, a crown 0.3; 0: no wind bends it."""
    air_density: float = 1.2
    """[kg/m3] 0 to 2000. 1.2 is air at 20 C."""
    vogel_exponent: float = 0.0
    """-2 to 0. Loss of drag as leaves close up: speed to this power above vogel_speed. 0: only the loss by the
    bend, which is -2/3. Crowns have -0.7 (Vogel 1989)."""
    vogel_speed: float = 5.0
    """[m/s] 0.001 to 1000. Speed above which leaves turn and close up."""
    max_bend: float = 1.5707964
    """[rad] 0 to 2.5. Upper bound of the tip's bend. No steady wind exceeds pi/2, a spring that overshoots may;
    shells stay within pi/2."""


@dataclass(kw_only=True, slots=True)
class BladeSettings(Settings):
    """Blades of grass of one class."""

    _struct: ClassVar = _c.BladeSettings
    _init: ClassVar = "windrow_blade_settings_init"

    stalk: Drag | None = None
    """Properties of the stalk that the class does not set. The defaults are those of meadow grass."""
    length_spread: float = 0.3
    """0 to 0.9. Fraction by which lengths vary. A blade bends by its own length: in a light wind as its cube, 0.34
    to 2.2 times as far as the class at 0.3."""
    width: float = 0.006
    """[m] 0 to 10. Width of the drawn strip at its root. 0.006 is a blade of 4 mm, drawn wider since only a few are
    drawn."""
    tip_width: float = 0.1
    """0 to 1. The tip's width over the root's."""
    taper: float = 2.0
    """A number above 0, at most 10. Exponent of the width over height: width (1 - (1 - tip_width) h^taper). 2 is
    wide for long and pointed at the end."""
    along_wind: float = 1.0
    """0 to 1. Fraction of the load that bends the blade along the wind; the rest bends it about its own wide axis
    only. 1 is for stems and twisted blades."""
    stiffness_spread: float = 0.3
    """0 to 0.9. Fraction by which stiffness varies, so that blades move differently."""
    rest_bend: float = 0.5
    """[rad] -3 to 3. Bend of the tip at rest, toward the face. 0 is straight."""
    rest_bend_spread: float = 0.3
    """[rad] 0 to 3. Spread of the rest bend."""
    rest_curve: float = 0.5
    """0 to 1. Shape of the rest bend: 0 a uniform arc, 1 all at the tip."""
    view_bend: float = 0.0
    """[rad] 0 to 3. Added to the own bend when seen from straight above; 0.5 covers ground that would show between
    upright blades."""
    twist: float = 0.3
    """0 to 2. Turn of the tip toward a wind that blows against its corner, over its bend, by wind, walkers or a
    spring. 0: none, as for stems; so a scene has it for classes of stems. A strip has 3/4 of its width over its
    length times the ratio of its stiffnesses, bending over twisting: 0.3 for 4 mm on 0.3 m and a ratio of 30. Stems
    of tulips and daffodils have 8 and 13 (Etnier & Vogel 2000, Am. J. Bot. 87, 29); that of a channelled blade is
    ours."""


@dataclass(kw_only=True, slots=True)
class ShellSettings(Settings):
    """Layers of fur or grass over a skin."""

    _struct: ClassVar = _c.ShellSettings
    _init: ClassVar = "windrow_shell_settings_init"

    shells: int = 32
    """2 to 4096. Number of layers. Of a mesh from a file, the default is that of the material's fur line."""
    reaches_tip: bool = True
    """Whether the outermost layer is at the tip, layer i at i / (N - 1), so that the look does not depend on N;
    else layer i is at i / N."""
    length: float = 0.03
    """[m] 1e-6 to 100. Length of the longest strands; 0.03 is long fur. Of a mesh from a file, the default is that
    of the material's fur line."""
    spacing: float = 1.0
    """A number above 0, at most 10. Heights are (i / d)^spacing: above 1 layers gather at the skin."""
    bias: float = 0.0
    """0 to 1. Fraction of the length by which all layers are lifted: a little lifts shell 0 off a skin that is
    drawn too."""
    push: float = 0.015
    """[m] -100 to 100. Displacement of the tip for a direction of length 1, in the translated form."""
    push_exponent: float = 2.0
    """A number above 0, at most 10. The push grows as height^this: at 2 roots stay upright and tips lean."""
    droop: float = 0.0
    """[m] 0 to 100. Droop of the tip, in the translated form."""
    droop_shape: float = 3.0
    """0.001 to 1000. p of the droop (p^h - 1) / (p - 1): above 1 it bends toward the tip, 1 is linear."""
    sag: float = 0.3
    """[rad] 0 to 1.5707964. Sag of the tip of a horizontal strand, in the bent form. Strands that a map shortens
    sag by its cube."""
    down: Vec3 = (0.0, -1.0, 0.0)
    """A finite vector that is not 0. Direction of gravity, of any length above 0."""
    strand: Drag | None = None
    """Strand of the bent form; its length is that of the layers."""


@dataclass(kw_only=True, slots=True)
class StageTimes(Settings):
    """[ms] Wall-clock time of one step by stage."""

    _struct: ClassVar = _c.StageTimes

    sources: float = 0.0
    """[ms] Motors, NaN guard, speed limit."""
    ambient: float = 0.0
    """[ms] The ambient wind cell by cell; 0 without gusts."""
    diffusion: float = 0.0
    """[ms] Viscosity, and the mixing over rough ground."""
    advection: float = 0.0
    """[ms] Transport of the velocity, gathering the carried field included."""
    projection: float = 0.0
    """[ms] Direct solves of the pressure, further ones around obstacles too."""
    obstacles: float = 0.0
    """[ms] Rasterisation, and all passes over faces and cells at obstacles."""
    report: float = 0.0
    """[ms] Energy, largest speed, divergence."""
    total: float = 0.0
    """[ms] The whole step, with what belongs to no stage: a moved box, for one."""


@dataclass(kw_only=True, slots=True)
class Diagnostics(Settings):
    """Report of a step."""

    _struct: ClassVar = _c.Diagnostics
    _init: ClassVar = "windrow_diagnostics_init"
    _words: ClassVar = {
        "diffusion": ("none", "one_pass", "implicit"),
    }

    stepped: bool = False
    """The step ran. False: dt was 0, negative or not finite, or out_of_memory; nothing was done."""
    out_of_memory: bool = False
    """The system has no memory that the step needs: the wind is unchanged. Free some and call again. On a device
    only its obstacles find none: the step ran without them."""
    regridded: bool = False
    """The box, with rows of its own, was at another height in the last step: air that stayed in it was
    interpolated. After `advance`, in any of its ticks."""
    max_speed: float = 0.0
    """[m/s] Largest component of the velocity after the step."""
    cfl: float = 0.0
    """Largest component * dt / h after the sources, before sub-steps and limit: how many cells the air would cross
    at once."""
    substeps: int = 0
    """Number of sub-steps: ceil(cfl / max_cfl), at most max_substeps; while obstacles move, of a bound of the speed
    that is known before the step."""
    substeps_capped: bool = False
    """More sub-steps were needed than allowed: speeds were limited."""
    carried_time: float = 0.0
    """[s] Time that the next steps make up for, on a device whose speeds rose further than its host could foresee;
    0 on the CPU."""
    motors_in_reach: int = 0
    """Motors that acted in the box; a wake counts once per segment of its path. In free air also a volume source
    outside of the box that makes 1 cm/s in it."""
    limited_cells: int = 0
    """Cells whose speed was scaled down to max_cfl * max_substeps cells a step, before the air moved or, where
    forces and pressure had made them faster, after it."""
    repaired_cells: int = 0
    """Cells that held NaN or infinity and were set to ambient."""
    diffusion: DiffusionMethod = "none"
    """How viscosity acted: not at all, in one explicit pass, or by a direct solve."""
    pressure_residual: float = 0.0
    """What the pressure's solution leaves of the divergence at the surfaces of obstacles, relative to that before
    it. 0 without obstacles in the box."""
    pressure_solves: int = 0
    """Direct solves of the pressure in the last sub-step. 0 without obstacles in the box."""
    sealed_sources: int = 0
    """Volume sources in air that no opening joins to the boundary of the box. What comes out of one there is taken
    out again, evenly, from all air of that room: incompressible air cannot leave it."""
    divergence_rms: float = 0.0
    """[1/s] Root mean square of the central divergence that the collocated projection leaves."""
    energy: float = 0.0
    """[m^5/s^2] Kinetic energy of the box per unit of density: sum of u^2 / 2 h^3."""
    asleep: bool = False
    """The air had relaxed to the ambient wind and no motor acted: the step did nothing. The other figures, those of
    gusts too, stay as in the step that fell asleep. Gusts go on."""
    motors_lost: int = 0
    """Motors that act on no air where they are: under the ground, or farther outside of the box than its size, on
    an axis along which it does not follow. A mistake in most scenes."""
    times_ms: StageTimes = field(default_factory=StageTimes)
    """[ms] Wall-clock time by stage."""
    jumps: int = 0
    """Obstacles and wakes that were moved faster than jump_speed: they were there at once, without a push."""
    fast_turns: int = 0
    """Obstacles that turned by more than a sixth of a turn in the step, or whose outermost place went farther than
    a cell by it: their blades meet the air at few places. The moment on a blade of 4 cells and more is some 10 %
    off then, on a thinner one up to a half. A vortex motor is the wind of a fast rotor."""
    filling_obstacles: int = 0
    """Obstacles, grounds aside, of which each fills more than half of the box, so that little wind is left: a
    mistake of units in most scenes. Lengths are metres."""
    sealed_rooms: int = 0
    """Parts of the air without an opening whose volume moving walls change: a closed room, or all air of a box
    without an open boundary. Incompressible air cannot leave: it takes the change evenly, as if it were pressed
    together, and its pressure is relative to none."""


@dataclass(kw_only=True, slots=True)
class Advance(Settings):
    """Result of Wind.advance."""

    _struct: ClassVar = _c.Advance
    _init: ClassVar = "windrow_advance_init"

    ticks: int = 0
    """that ran"""
    dropped: float = 0.0
    """[s] beyond config.ticks_max_per_call, not simulated"""
    factor: float = 0.0
    """of this frame between the last two ticks, 0 to 1"""


@dataclass(kw_only=True, slots=True)
class Box(Settings):
    """The box of a wind."""

    _struct: ClassVar = _c.Box
    _init: ClassVar = "windrow_box_init"

    cells: IVec3 = (0, 0, 0)
    """Cells along x, y, z."""
    cell_size: float = 0.0
    """[m]"""
    size: Vec3 = (0.0, 0.0, 0.0)
    """[m] from the low corner to the high one"""
    origin: Vec3 = (0.0, 0.0, 0.0)
    """[m] world position of the low corner"""
    boundaries: Boundaries = field(default_factory=Boundaries)
    """Conditions at its six faces."""


@dataclass(kw_only=True, slots=True)
class ObstacleForce(Settings):
    """What the pressure of the air does to an obstacle."""

    _struct: ClassVar = _c.ObstacleForce
    _init: ClassVar = "windrow_obstacle_force_init"

    force: Vec3 = (0.0, 0.0, 0.0)
    """[N]"""
    moment: Vec3 = (0.0, 0.0, 0.0)
    """[N m] about its position"""
    pressure: float = 0.0
    """[Pa]"""
    in_box: int = 0
    """1; 0: no part of it was in the box, and all else is 0."""


@dataclass(kw_only=True, slots=True)
class DragForce(Settings):
    """What the air does to a deposit."""

    _struct: ClassVar = _c.DragForce
    _init: ClassVar = "windrow_drag_force_init"

    force: Vec3 = (0.0, 0.0, 0.0)
    """[N]"""
    in_box: float = 0.0
    """fraction of its drag area that the force is of: the rest is outside of the cells that are read"""
