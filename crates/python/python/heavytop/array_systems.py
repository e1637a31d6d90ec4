"""Systems of any size whose states are arrays: lattices of spins, vortices, fluids."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import fields
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _native
from .arguments import array, count
from .events import Events, NativeEvent
from .solution import Floats, Solution
from .system import System
from .system_description import Parameters, State


class ArraySolution(Solution):
    """A run of a system of arrays; `run["S"]` is the array S of all n samples, of shape (n, ...)."""

    def __getitem__(self, name: str) -> Floats:
        """Returns the samples of an array, of shape (n, ...), by name."""
        arrays = self._run.native.arrays  # type: ignore[attr-defined]
        return arrays_of(arrays, self.y.T, name)


class ArraySystem(System):
    """A system of the library whose states are arrays of any size. Its classes are `SpinLattice` and others.

    A state, `y`, has all numbers of the arrays one after the other; `unpack` gives the arrays, and `run["S"]` those of a run.
    `solve` takes a state, the array of a system that has one, or what `start` takes by name. There are no events.

    Args:
        kind: the name of the system, such as "spin-lattice".
        parameters: its parameters by name; those that are missing are named with their meaning.
    """

    def __init__(self, kind: str, parameters: Parameters) -> None:
        self._numbers = numbers_of("parameters", parameters)
        self._kind = self._algebra = str(kind)
        self._arrays = _native.Arrays(self._kind, self._numbers)
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
        """The symbols of what is conserved."""
        return tuple(self._arrays.invariants)

    def start(self, **given: ArrayLike) -> Floats:
        """Returns the state that is given by numbers and arrays by name, of shape (d,)."""
        return self._arrays.start(numbers_of("y0", given))

    def unpack(self, y: ArrayLike) -> dict[str, Floats]:
        """Returns the arrays at states of shape (d,) or (d, n), by name, of their shapes or with an axis of n before them."""
        states = self._states("y", y)
        return {name: arrays_of(self._arrays.arrays, states.T, name) for name in self._names}

    def _watched(self, events: Events) -> list[NativeEvent]:
        if events is not None:
            raise ValueError("a system of arrays has no events: leave events out")
        return []

    def _solved(self, run: Solution) -> ArraySolution:
        return ArraySolution(**{field.name: getattr(run, field.name) for field in fields(Solution)})

    def section(self, *_: Any, **__: Any) -> Any:
        """Raises ValueError: sections are of systems of few coordinates."""
        raise ValueError("a system of arrays has no sections")

    def _state(self, y0: State) -> Floats:
        if isinstance(y0, Mapping):
            return self.start(**y0)
        state = array("y0", y0)
        shapes = list(self.shapes.items())
        # What is given is checked as by its name.
        if len(shapes) == 1 and state.shape in (shapes[0][1], (self.dimension,)):
            return self.start(**{shapes[0][0]: state.reshape(-1)})
        if state.shape != (self.dimension,):
            raise ValueError(f"y0 must have the shape ({self.dimension},) or that of {self.shapes}, got {state.shape}")
        return self.start(**{name: state[places] for name, places in self._names.items()})

    def __repr__(self) -> str:
        shapes = ", ".join(f"{name} {shape}" for name, shape in self.shapes.items())
        return f"<{type(self).__name__}: {shapes}>"


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
    """Classical spins on a periodic lattice of one to three dimensions, with the plus bracket; one array S.

    h = -sum J s_i.s_j over neighbours - K sum (a.s_i)^2 - B.sum s_i, and ds_i/dt = s_i x H_i with H_i = -dh/ds_i. A start is
    an array of the shape of S, or `{"direction": [0, 0, 1], "waves": [1, 0], "cone": 0.1, "tilt": 0.05, "seed": 1}`: spins
    along a direction, on the cone of a wave with so many periods along each axis, and tilted at random.

    Args:
        shape: the number of spins along each axis; S has the shape (*shape, 3).
        exchange: J of neighbours, for all axes or for each; positive for a ferromagnet.
        anisotropy: K; positive for an easy axis.
        axis: a, of which the direction counts.
        field: B.
        bonds: rows (d1, d2, d3, J) of further bonds, each to the spin at that offset.

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
        exchange: ArrayLike = 0.0,
        anisotropy: float = 0.0,
        axis: ArrayLike = (0.0, 0.0, 1.0),
        field: ArrayLike = (0.0, 0.0, 0.0),
        bonds: ArrayLike = (),
    ) -> None:
        numbers = {"shape": np.atleast_1d(shape), "exchange": exchange, "anisotropy": anisotropy, "axis": axis}
        super().__init__("spin-lattice", {**numbers, "field": field, "bonds": np.ravel(bonds)})


class VibratingLattice(ArraySystem):
    """Classical spins on a chain of atoms in motion; arrays S (N, 3), q (N,) and p (N,).

    h = sum p_i^2/2m + kappa (q_(i+1) - q_i)^2/2 - (J - a (q_(i+1) - q_i)) s_i.s_(i+1), periodic. A start is given by S, or as
    for `SpinLattice`, and by q and p, which are 0 unless given.

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
        numbers = {"atoms": count("atoms", atoms, 3), "exchange": exchange, "mass": mass}
        super().__init__("vibrating-lattice", {**numbers, "stiffness": stiffness, "coupling": coupling})


class SphereFluid(ArraySystem):
    """An ideal fluid on the sphere, by Zeitlin's model; one array omega of shape (N, N).

    omega holds the coefficients of the absolute vorticity in orthonormal spherical harmonics: Re omega_lm at [l, m], and
    Im omega_lm at [m - 1, l]; `harmonics` gives them as complex numbers. A start is such an array, or
    `{"degrees": [2, 10], "rms": 1, "seed": 0}` at random, or `{"coefficients": [[l, m, re, im], ...]}`.

    Args:
        size: N; harmonics of degree below N are kept.
        rotation: the angular velocity of the sphere.

    Example:
        A Rossby-Haurwitz wave on a sphere at rest keeps the size of its coefficients:

        >>> fluid = SphereFluid(12)
        >>> run = fluid.solve({"coefficients": [[1, 0, 1, 0], [4, 3, 0.2, 0]]}, step=0.05, end=1)
        >>> wave = fluid.harmonics(run.y)[:, 4, 3]
        >>> bool(abs(abs(wave) - 0.2).max() < 1e-9), run.deviation("Z") < 1e-12
        (True, True)
    """

    def __init__(self, size: int, rotation: float = 0.0) -> None:
        super().__init__("sphere-fluid", {"size": count("size", size, 2), "rotation": rotation})

    def harmonics(self, y: ArrayLike) -> "np.ndarray[Any, np.dtype[np.complex128]]":
        """Returns omega_lm at [..., l, m], 0 <= m <= l < N, of states of shape (d,) or (d, n)."""
        omega = self.unpack(y)["omega"]
        imaginary = np.zeros_like(omega)
        imaginary[..., :, 1:] = np.swapaxes(omega, -1, -2)[..., :, :-1]
        return np.tril(omega) + 1j * np.tril(imaginary)


class ManyVortices(ArraySystem):
    """Point vortices on the unit sphere, as many as there are strengths; one array m (N, 3), the positions times the strengths.

    A start is given by `{"positions": array of shape (N, 3)}`, by m, or by `{"seed": 1}` at random. The formula of `Vortices`
    has up to 48, and events, too.

    Args:
        strengths: the circulation of each vortex, m^2/s.
    """

    def __init__(self, strengths: ArrayLike) -> None:
        self._strengths = array("strengths", strengths).reshape(-1)
        super().__init__("vortices", {"strengths": self._strengths})

    def positions(self, y: ArrayLike) -> Floats:
        """Returns the positions at states of shape (d,) or (d, n), as an array of shape (N, 3) or (n, N, 3)."""
        return self.unpack(y)["m"] / self._strengths[:, None]
