"""Systems of any size whose states are arrays: lattices of spins, vortices, fluids."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _native
from .arguments import array, count, numbers
from .events import Events, NativeEvent, event_parts, list_of
from .open_terms import Inputs, native_arrays
from .solution import Floats, Solution
from .system import System
from .system_description import Parameters, State
from .tracing import takes_time


MOST_ROWS = 8192
"""The largest number of circles of a grid, a gibibyte of numbers."""


class ArraySolution(Solution):
    """A run of a system of arrays; `run["S"]` is the array S of all n samples, of shape (n, ...)."""

    def __getitem__(self, name: str) -> Floats:
        """Returns the samples of an array, of shape (n, ...), by name."""
        arrays = self._run.native.arrays  # type: ignore[attr-defined]
        return arrays_of(arrays, self.y.T, name)


class ArraySystem(System):
    """A system of the library whose states are arrays of any size. Its classes are `SpinLattice` and others.

    A state, `y`, has all numbers of the arrays one after the other; `unpack` gives the arrays, and `run["S"]` those of a run.
    `solve` takes a state, the array of a system that has one, or what `start` takes by name. Its events are Python functions of
    the arrays by name, such as `lambda x: x["S"][..., 2].mean()`, or of them and the time, `lambda x, t: ...`, which are called after
    each step. With noise they are of the time alone, `lambda _, t: ...`, as for `System.solve`. There are no sections.

    Args:
        kind: the name of the system, such as "spin-lattice".
        parameters: its parameters by name; those that are missing are named with their meaning.
        damping: of a lattice of spins, as for `SpinLattice`, or of a fluid, as for `SphereFluid`.
        noise: of a lattice of spins or a fluid, the same.
        torque: of a fluid, as for `SphereFluid`.
        drive: of a lattice of spins, as for `SpinLattice`.
        inputs: of a lattice of spins, the same.
    """

    def __init__(
        self,
        kind: str,
        parameters: Parameters,
        damping: Union[None, float, Mapping[str, Any]] = None,
        noise: Optional[Mapping[str, Any]] = None,
        torque: Optional[Mapping[str, Any]] = None,
        drive: Optional[Mapping[str, Any]] = None,
        inputs: Optional[Inputs] = None,
    ) -> None:
        self._numbers = numbers_of("parameters", parameters)
        self._kind = self._algebra = str(kind)
        terms = native_arrays(self._kind, damping, noise, torque, drive, inputs)
        self._arrays = _native.Arrays(self._kind, self._numbers, terms)
        # The methods of `System` need no more of it than it has.
        self._system: Any = self._arrays
        self._names = {}
        start = 0
        for name, shape in self._arrays.arrays:
            self._names[name] = slice(start, start + math.prod(shape))
            start += math.prod(shape)

    @property
    def shapes(self) -> dict[str, tuple[int, ...]]:
        """The shape of each array of a state, by name."""
        return {name: tuple(shape) for name, shape in self._arrays.arrays}

    @property
    def coordinates(self) -> tuple[str, ...]:
        """The names of the arrays."""
        return tuple(self.shapes)

    @property
    def casimirs(self) -> dict[str, str]:
        """Nothing: the invariants have names."""
        return {}

    @property
    def invariants(self) -> tuple[str, ...]:
        """The symbols of what is conserved, or would be without friction, forces and noise."""
        return tuple(self._arrays.invariants)

    @property
    def structure_constants(self) -> Any:
        """Raises ValueError: a table of structure constants is of systems of few coordinates."""
        raise ValueError("a system of arrays has no table of structure constants")

    def start(self, **given: ArrayLike) -> Floats:
        """Returns the state that is given by numbers and arrays by name, of shape (d,)."""
        shapes = {**self.shapes, **self._shapes_of_start()}
        for name, values in given.items():
            shape, found = shapes.get(name), np.shape(values)
            if shape is not None and found not in (shape, (math.prod(shape),)):
                raise ValueError(f"y0[{name!r}] must have the shape {shape}, got {found}")
        return self._arrays.start(numbers_of("y0", given))

    def _shapes_of_start(self) -> dict[str, tuple[int, ...]]:
        """The shapes of arrays that a start may be given by, besides those of the state."""
        return {}

    def unpack(self, y: ArrayLike) -> dict[str, Floats]:
        """Returns the arrays at states of shape (d,) or (d, n), by name, of their shapes or with an axis of n before them."""
        states = self._states("y", y)
        return {name: arrays_of(self._arrays.arrays, states.T, name) for name in self._names}

    def _usual_scheme(self) -> str:
        return "implicit-midpoint" if self._arrays.is_open else super()._usual_scheme()

    def _warn_of_end(self, states: Floats, stacklevel: int) -> None:
        """Nothing: sums over arrays are no small differences."""

    def _watched(self, events: Events) -> list[NativeEvent]:
        if events is None:
            return []

        def watched(name: str, event: Any) -> NativeEvent:
            event, direction, terminal = event_parts(name, event)
            if not callable(event.function):
                raise ValueError(f"{name} must be a function of the arrays by name, or of them and the time, got {event.function!r}")
            function = event.function if takes_time(event.function) else lambda arrays, _: event.function(arrays)
            if self._arrays.has_noise:
                return (lambda _, t: number(name, function(NoArrays(name), t))), direction, terminal
            return (lambda y, t: number(name, function(self.unpack(y), t))), direction, terminal

        return [watched(f"events[{i}]", event) for i, event in enumerate(list_of(events))]

    def _solved(self, run: Solution) -> ArraySolution:
        return ArraySolution(**{field.name: getattr(run, field.name) for field in fields(Solution)})

    def _named(self, states: Floats, name: str) -> Floats:
        """Returns the samples of an array, of shape (n, ...), by name, from states in columns."""
        return arrays_of(self._arrays.arrays, states.T, name)

    def section(self, *_: Any, **__: Any) -> Any:
        """Raises ValueError: sections are of systems of few coordinates."""
        raise ValueError("a system of arrays has no sections")

    def _state(self, y0: State) -> Floats:
        if isinstance(y0, Mapping):
            return self.start(**y0)
        state = array("y0", y0)
        if state.shape in self._shapes_of_state():
            name = next(iter(self.shapes))
            return self.start(**{name: state})
        if state.shape != (self.dimension,):
            arrays = ", ".join(f"{name} {shape}" for name, shape in self.shapes.items())
            raise ValueError(f"y0 must have the shape ({self.dimension},), or be given by name, {arrays}; got {state.shape}")
        return self.start(**{name: state[places] for name, places in self._names.items()})

    def _shapes_of_state(self) -> list[tuple[int, ...]]:
        shapes = list(self.shapes.values())
        return shapes if len(shapes) == 1 else []

    def __repr__(self) -> str:
        shapes = ", ".join(f"{name} {shape}" for name, shape in self.shapes.items())
        return f"<{type(self).__name__}: {shapes}>"


class NoArrays(Mapping[str, Floats]):
    """The arrays of a path with noise, which no event may read."""

    def __init__(self, name: str) -> None:
        self._name = name

    def __getitem__(self, _: str) -> Floats:
        raise ValueError(
            f"{self._name}: a path with noise passes a value of a function of the arrays again and again in any time, however short, and "
            "where depends on the step: write a function of the time alone, such as lambda _, t: np.sin(2*t)"
        )

    def __iter__(self) -> Iterator[str]:
        self[""]
        return iter(())

    def __len__(self) -> int:
        self[""]
        return 0


def number(name: str, value: Any) -> float:
    """Returns the value of an event, which may be no finite number: the run then ends there."""
    found = array(name, value)
    if found.ndim:
        raise ValueError(f"{name} must be a number, got the shape {found.shape}")
    return float(found)


def numbers_of(name: str, given: Mapping[str, Any]) -> list[tuple[str, list[float], bool]]:
    """Returns numbers and arrays by name as the native part takes them."""
    arrays = {own: array(f"{name}[{own!r}]", value) for own, value in given.items()}
    return [(own, values.reshape(-1).tolist(), values.ndim > 0) for own, values in arrays.items()]


def arrays_of(arrays: list[tuple[str, list[int]]], states: Floats, name: str) -> Floats:
    """Returns an array of states, which are along the last axis."""
    start = 0
    for own, shape in arrays:
        size = math.prod(shape)
        if own == name:
            return states[..., start : start + size].reshape(*states.shape[:-1], *shape)
        start += size
    raise KeyError(f"the arrays are {', '.join(own for own, _ in arrays)}, got {name!r}")


class SpinLattice(ArraySystem):
    """Classical spins on a lattice of one to three dimensions, with the plus bracket; one array S.

    h = -sum J s_i.s_j over neighbours - K sum (a.s_i)^2 - B.sum s_i, and ds_i/dt = s_i x H_i with H_i = -dh/ds_i. A start is
    an array of the shape of S, or `{"direction": [0, 0, 1], "waves": [1, 0], "cone": 0.1, "tilt": 0.05, "seed": 1}`: spins
    along a direction, on the cone of a wave with so many periods along each axis, and tilted at random. Conserved are h, the
    total spin (M1, M2, M3), or its part M along an axis or a field, and C = sum |s_i|^2. The scheme "spherical-midpoint" under
    "reduced" is the fastest for periodic lattices.

    Args:
        shape: the number of spins along each axis; S has the shape (*shape, 3).
        exchange: J of neighbours, for all axes or for each; positive for a ferromagnet.
        anisotropy: K; positive for an easy axis.
        field: B.
        axis: a, of which the direction counts.
        bonds: rows (d1, d2, d3, J) of further bonds, each to the spin at that offset.
        periodic: whether the axes are rings or have open ends, for all axes or for each.
        damping: the friction theta of Landau and Lifshitz, ds/dt = s x H - theta s x (s x H); or {"friction": alpha, "form":
            "gilbert"}, ds/dt = s x H - (alpha/|s|) s x ds/dt. It lowers h and keeps every |s|.
        noise: {"temperature": kT}, which goes with a damping: after a while states have the weight exp(-h/kT). Besides "seed" (1), "path"
            (0), "interval" and "bound" as for `System`. With damping, noise or a drive the method is "direct", "implicit-midpoint",
            without tangent vectors; the energy h, the total spin (M1, M2, M3) and C have values, of which C is kept.
        drive: {"field": B(t)}, a uniform field that is added to `field` and depends on the time: three formulas in t and the
            inputs, or a function of t, or of x and t with the inputs as `x.u`. h has the field of its time, so that dh/dt =
            -dB/dt.sum s_i without friction and noise.
        inputs: numbers u(t) by tables, by name, as for `System`. Steps are divided at their times.

    Example:
        A spin wave on a cone about z turns at 2 J cos(cone) (1 - cos k):

        >>> lattice = SpinLattice((16, 4), exchange=1.0)
        >>> run = lattice.solve({"waves": [1, 0], "cone": 0.5}, step=0.1, end=10)
        >>> run["S"].shape
        (101, 16, 4, 3)
        >>> first = run["S"][:, 0, 0]
        >>> turned = np.unwrap(np.arctan2(first[:, 1], first[:, 0]))[-1]
        >>> bool(abs(abs(turned) - 10 * 2 * np.cos(0.5) * (1 - np.cos(2 * np.pi / 16))) < 1e-8)
        True
    """

    def __init__(
        self,
        shape: ArrayLike,
        exchange: Optional[ArrayLike] = None,
        anisotropy: Optional[float] = None,
        field: Optional[ArrayLike] = None,
        axis: ArrayLike = (0.0, 0.0, 1.0),
        bonds: Optional[ArrayLike] = None,
        periodic: Union[bool, Sequence[bool]] = True,
        damping: Union[None, float, Mapping[str, Any]] = None,
        noise: Optional[Mapping[str, Any]] = None,
        drive: Optional[Mapping[str, Any]] = None,
        inputs: Optional[Inputs] = None,
    ) -> None:
        given: dict[str, Any] = {"exchange": exchange, "anisotropy": anisotropy, "field": field}
        if bonds is not None:
            rows = array("bonds", bonds)
            if rows.shape != (len(rows), 4):
                raise ValueError(f"bonds must have the shape (n, 4), got {rows.shape}")
            given["bonds"] = rows.ravel()
        rings = np.asarray(periodic)
        if rings.dtype != bool:
            raise ValueError(f"periodic must be True or False, for all axes or for each, got {periodic!r}")
        given = {name: value for name, value in given.items() if value is not None}
        shaped = {"shape": np.atleast_1d(shape), "axis": axis, "periodic": rings.astype(float)}
        super().__init__("spin-lattice", {**shaped, **given}, damping, noise, drive=drive, inputs=inputs)


class VibratingLattice(ArraySystem):
    """Classical spins on a chain of atoms in motion; arrays S (N, 3), q (N,) and p (N,).

    h = sum p_i^2/2m + kappa (q_(i+1) - q_i)^2/2 - (J - a (q_(i+1) - q_i)) s_i.s_(i+1), periodic. A start is given by name: S,
    or what gives the spins of a `SpinLattice`, and q and p, which are 0 unless given. Conserved are h, the total spin (M1, M2,
    M3), the total momentum P, and C = sum |s_i|^2.

    Args:
        atoms: how many there are, at least 3.
        exchange: J.
        mass: m.
        stiffness: kappa.
        coupling: a, by which J falls with the distance of the atoms.
    """

    def __init__(
        self, atoms: int, exchange: float, mass: float = 1.0, stiffness: float = 1.0, coupling: float = 0.0
    ) -> None:
        given = {"atoms": count("atoms", atoms, 3), "exchange": exchange, "mass": mass}
        super().__init__("vibrating-lattice", {**given, "stiffness": stiffness, "coupling": coupling})


class SphereFluid(ArraySystem):
    """A fluid on the sphere, by Zeitlin's model, ideal unless it has damping, a torque or noise; one array omega of shape (N, N).

    omega holds the coefficients of the absolute vorticity in orthonormal spherical harmonics with the phase of Condon and
    Shortley: Re omega_lm at [l, m], and Im omega_lm at [m - 1, l]; `harmonics` gives them as complex numbers, and `vorticity`
    the values on a grid. A start is such an array, or `{"degrees": [2, 10], "rms": 1, "seed": 0}` at random, or
    `{"coefficients": [[l, m, re, im], ...]}`, without rows at rest, or `{"vorticity": array}` of shape (r, 2 r) with r >= 2 N - 1, as `vorticity`
    returns. On a sphere that rotates at Omega the absolute vorticity of a fluid at rest there is 2 Omega cos(theta), the
    coefficient omega_10 = 2 Omega sqrt(4 pi/3): add it to a start relative to the sphere. Conserved are h, the kinetic energy;
    the enstrophy Z, the integral of omega^2; and the angular momentum (M1, M2, M3), or M3 alone on a sphere that rotates. Tangent
    vectors, for exponents, are those of the formulation "direct", which is much slower for large N.

    Args:
        size: N; harmonics of degree below N are kept.
        vorticity: a start as values on a grid, for runs that are given none.
        coefficients: a start as rows (l, m, re, im), instead.
        rotation: the angular velocity of the sphere.
        damping: {"viscosity": nu, "power": p, "drag": alpha}: the coefficients of degree l, relative to the rotation of the sphere, decay
            at the rate alpha + nu (l (l + 1))^p. p is 1 unless given; above 1 it is a hyperviscosity.
        torque: {"coefficients": rows (l, m, re, im)}: a constant force, as the rate of the vorticity.
        noise: {"transport": {"degrees": [l1, l2], "strength": s}}, random stream functions that carry the fluid along and keep its
            Casimirs, s in 1/sqrt(t); or "stirring", random vorticities that are added to it, s in 1/(t sqrt(t)); or both; each a shell or a
            list of shells. Besides "seed" (1), "path" (0), "interval" and "bound" as for `System`. With damping, a torque or noise the
            method is "reduced", "implicit-midpoint", of order 2 without noise, and viscosity runs forward in time alone; h, Z and the
            angular momentum have values, of which Z is kept under transport noise alone.

    Example:
        A Rossby-Haurwitz wave on a sphere at rest keeps the size of its coefficients:

        >>> fluid = SphereFluid(12, coefficients=[[1, 0, 1, 0], [4, 3, 0.2, 0]])
        >>> run = fluid.solve(step=0.05, end=1)
        >>> wave = fluid.harmonics(run.y)[:, 4, 3]
        >>> bool(abs(abs(wave) - 0.2).max() < 1e-9), run.deviation("Z") < 1e-12
        (True, True)
    """

    def __init__(
        self,
        size: int,
        vorticity: Optional[ArrayLike] = None,
        coefficients: Optional[ArrayLike] = None,
        rotation: float = 0.0,
        damping: Optional[Mapping[str, Any]] = None,
        torque: Optional[Mapping[str, Any]] = None,
        noise: Optional[Mapping[str, Any]] = None,
    ) -> None:
        given = {"size": count("size", size, 2), "rotation": rotation}
        super().__init__("sphere-fluid", given, damping, noise, torque)
        starts = {"vorticity": vorticity, "coefficients": coefficients}
        start = {name: values for name, values in starts.items() if values is not None}
        self._first = self.start(**start) if start else None

    def _formulation_of_tangents(self) -> str:
        return "direct"

    def vorticity(self, y: ArrayLike, rows: Optional[int] = None) -> Floats:
        """Returns the vorticity at states of shape (d,) or (d, n), as an array of shape (r, 2 r) or (n, r, 2 r).

        The rows are at the colatitudes pi (i + 1/2)/r, from the north, and the columns at the longitudes pi j/r.

        Args:
            rows: r, by default 2 N - 1, from which a start has the same coefficients.
        """
        states = self._states("y", y)
        r = 2 * self.shapes["omega"][0] - 1 if rows is None else count("rows", rows, 1)
        if r > MOST_ROWS:
            raise ValueError(f"rows must be at most {MOST_ROWS}, got {r}")
        values = self._arrays.on_grid(np.atleast_2d(states.T), r)
        return values.reshape(*states.shape[1:], r, 2 * r)

    def start(self, **given: ArrayLike) -> Floats:
        """Returns the state that is given by numbers and arrays by name, of shape (d,)."""
        grid = np.shape(given.get("vorticity", np.zeros((1, 2))))
        if len(grid) != 2 or grid[1] != 2 * grid[0]:
            raise ValueError(f"y0['vorticity'] must have the shape (r, 2 r), got {grid}")
        rows = np.shape(given.get("coefficients", np.zeros((1, 4))))
        # No rows are a fluid at rest.
        if rows != (0,) and (len(rows) != 2 or rows[1] != 4):
            raise ValueError(f"y0['coefficients'] must have the shape (n, 4), got {rows}")
        return super().start(**given)

    def harmonics(self, y: ArrayLike) -> "np.ndarray[Any, np.dtype[np.complex128]]":
        """Returns omega_lm at [..., l, m], 0 <= m <= l < N, of states of shape (d,) or (d, n)."""
        omega = self.unpack(y)["omega"]
        imaginary = np.zeros_like(omega)
        imaginary[..., :, 1:] = np.swapaxes(omega, -1, -2)[..., :, :-1]
        return np.tril(omega) + 1j * np.tril(imaginary)


class ManyVortices(ArraySystem):
    """Point vortices on the unit sphere, as many as there are strengths; one array m (N, 3), the positions times the strengths.

    A start is given by the positions, here or as `{"positions": array of shape (N, 3)}`, by m, or by `{"seed": 1}` at random.
    `Vortices` has up to 48 by a formula, with sections. Conserved are h, the moment of vorticity (M1, M2, M3), and C = sum |x_i|^2.

    Args:
        strengths: the circulation of each vortex, m^2/s.
        positions: on the unit sphere, of shape (N, 3), for runs that are given no start.
    """

    def __init__(self, strengths: ArrayLike, positions: Optional[ArrayLike] = None) -> None:
        self._strengths = numbers("strengths", strengths)
        super().__init__("vortices", {"strengths": self._strengths})
        self._first = None if positions is None else self.start(positions=positions)

    def _shapes_of_start(self) -> dict[str, tuple[int, ...]]:
        return {"positions": self.shapes["m"]}

    def positions(self, y: ArrayLike) -> Floats:
        """Returns the positions at states of shape (d,) or (d, n), as an array of shape (N, 3) or (n, N, 3)."""
        return self.unpack(y)["m"] / self._strengths[:, None]
