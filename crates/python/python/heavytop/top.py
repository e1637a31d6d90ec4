"""Heavy tops and their runs."""

from __future__ import annotations

from typing import Optional

import numpy as np
from numpy.typing import ArrayLike

from . import _native
from .solution import Crossings, Floats, Solution

FORMULATIONS = ("collective", "reduced", "direct", "splitting")
"""Where a scheme is applied.

* collective: on T*C^2, mapped to se(3)* by a Poisson map. Every Gauss method conserves the Casimirs to round-off.
* reduced: the same maps without a lift, on se(3)* itself. Gauss methods and compositions of the midpoint rule.
* direct: on the six equations of the top, as a comparison.
* splitting: exact flows of parts of the energy, on se(3)*; explicit.
"""

SCHEMES = (
    "implicit-midpoint",
    "gauss-4",
    "gauss-6",
    "gauss-8",
    "gauss-10",
    "gauss-12",
    "gauss-16",
    "explicit-midpoint",
    "rk4",
    "symplectic-euler",
    "stormer-verlet",
    "lobatto-iiia-iiib-4",
    "strang",
    "yoshida-4",
    "suzuki-4",
    "yoshida-6",
    "kahan-li-6",
    "kahan-li-8",
)
"""The one-step methods. The number is the order; the last six are compositions."""

COORDINATES = ("Pi1", "Pi2", "Pi3", "Gamma1", "Gamma2", "Gamma3")


def vector(name: str, values: ArrayLike) -> list[float]:
    """Returns three numbers, or raises ValueError."""
    array = np.asarray(values, dtype=float)
    if array.shape != (3,):
        raise ValueError(f"{name} must have three components, got the shape {array.shape}")
    return [float(x) for x in array]


class Top:
    """A heavy top: a rigid body that turns about a fixed point, under gravity.

    Args:
        inertia: the principal moments about the fixed point, kg m^2.
        mass: kg.
        gravity: m/s^2; 0 gives a free rigid body.
        length: the distance of the centre of mass from the fixed point, m.
        center_of_mass: the direction of the centre of mass in the body frame, a unit vector.

    Raises:
        ValueError: if no rigid body has these parameters. The message names the number and its bound.

    Example:
        >>> top = Top(inertia=[1.0, 1.5, 2.0], mass=1.0, gravity=9.81, length=0.1, center_of_mass=[0, 0, 1])
        >>> top.invariants
        ('h', 'f1', 'f2')
    """

    def __init__(
        self,
        inertia: ArrayLike,
        mass: float = 1.0,
        gravity: float = 9.81,
        length: float = 1.0,
        center_of_mass: ArrayLike = (0.0, 0.0, 1.0),
    ) -> None:
        center = vector("center_of_mass", center_of_mass)
        self._top = _native.Top(vector("inertia", inertia), mass, gravity, length, center)

    @classmethod
    def _of(cls, native: _native.Top) -> Top:
        top = cls.__new__(cls)
        top._top = native
        return top

    @classmethod
    def free_rigid_body(cls, inertia: ArrayLike) -> Top:
        """Returns a rigid body without gravity: Euler's top."""
        return cls._of(_native.Top.free_rigid_body(vector("inertia", inertia)))

    @classmethod
    def lagrange(cls, transverse: float, axial: float, weight_moment: float = 1.0) -> Top:
        """Returns Lagrange's top: I1 = I2 = transverse, I3 = axial, with the centre of mass on the third axis.

        The weight moment is m g l.
        """
        return cls._of(_native.Top.lagrange(transverse, axial, weight_moment))

    @classmethod
    def kovalevskaya(cls, axial: float = 1.0, weight_moment: float = 1.0) -> Top:
        """Returns Kovalevskaya's top: I1 = I2 = 2 I3, with the centre of mass on the first axis."""
        return cls._of(_native.Top.kovalevskaya(axial, weight_moment))

    @classmethod
    def goryachev_chaplygin(cls, axial: float = 1.0, weight_moment: float = 1.0) -> Top:
        """Returns the top of Goryachev and Chaplygin: I1 = I2 = 4 I3, with the centre of mass on the first axis."""
        return cls._of(_native.Top.goryachev_chaplygin(axial, weight_moment))

    @property
    def inertia(self) -> Floats:
        """The principal moments of inertia, kg m^2."""
        return np.array(self._top.inertia)

    @property
    def weight_moment(self) -> float:
        """The weight moment m g l, N m."""
        return self._top.weight_moment

    @property
    def center_of_mass(self) -> Floats:
        """The direction of the centre of mass in the body frame."""
        return np.array(self._top.center_of_mass)

    @property
    def invariants(self) -> tuple[str, ...]:
        """The symbols of the conserved quantities: h, f1 and f2, and f3, K or G of an integrable top."""
        return tuple(self._top.invariants)

    def invariant_values(self, y: ArrayLike) -> dict[str, Floats]:
        """Returns the conserved quantities of states of shape (6,) or (6, n), by symbol."""
        states = np.asarray(y, dtype=float)
        if states.ndim not in (1, 2) or states.shape[0] != 6:
            raise ValueError(f"y must have the shape (6,) or (6, n), got {states.shape}")
        values = self._top.invariant_values(states.reshape(6, -1).T)
        return {name: values[:, i].reshape(states.shape[1:]) for i, name in enumerate(self.invariants)}

    def solve(
        self,
        Pi: ArrayLike,
        Gamma: ArrayLike,
        *,
        step: float,
        end: float,
        scheme: str = "gauss-8",
        formulation: str = "collective",
        tolerance: float = 0.0,
        every: int = 1,
        attitude: bool = False,
    ) -> Solution:
        """Follows the top from t = 0 to the end, in equal steps.

        Args:
            Pi: the initial angular momentum in the body frame, kg m^2/s.
            Gamma: the initial vertical in the body frame. A unit vector, if m g l is that of the body.
            step: the time step, s.
            end: the end, s: a whole number of steps to within 1e-9 of itself.
            scheme: one of `SCHEMES`.
            formulation: one of `FORMULATIONS`.
            tolerance: of the stage equations of implicit schemes; 0 iterates to the round-off floor.
            every: keep each n-th sample; the last one is always kept.
            attitude: whether to follow the attitude of the body, too.

        Returns:
            The samples. If a step fails, those until then, with `success` false.

        Raises:
            ValueError: if an argument is out of its range, or the pair of formulation and scheme makes no sense.

        Example:
            The collective midpoint rule conserves the Casimirs; the explicit one does not.

            >>> top = Top.kovalevskaya()
            >>> start = dict(Pi=[2, 3, 4], Gamma=[0.6, 0, 0.8])
            >>> run = top.solve(**start, step=0.02, end=100, scheme="implicit-midpoint")
            >>> run.drift("f2") < 1e-12
            True
            >>> run = top.solve(**start, step=0.02, end=100, scheme="explicit-midpoint", formulation="direct")
            >>> run.drift("f2") > 1e-3
            True
        """
        start = vector("Pi", Pi) + vector("Gamma", Gamma)
        method = (formulation, scheme, float(tolerance))
        t, y, quaternions, iterations, error = self._top.follow(
            start, float(step), float(end), *method, every, attitude
        )
        values = self._top.invariant_values(y)
        return Solution(
            t=t,
            y=y.T,
            invariants={name: values[:, i] for i, name in enumerate(self.invariants)},
            attitude=quaternions.T if attitude else None,
            iterations=iterations,
            error=error,
            _states_at=lambda times: self._top.states_at(start, float(step), times.tolist(), *method),
        )

    def section(
        self,
        Pi: ArrayLike,
        Gamma: ArrayLike,
        *,
        coordinate: str,
        value: float = 0.0,
        direction: int = 1,
        step: float,
        end: float,
        most: Optional[int] = None,
        scheme: str = "gauss-8",
        formulation: str = "collective",
    ) -> Crossings:
        """Returns the points at which a coordinate passes a value: a Poincare section.

        They lie on the surface to round-off, and are as accurate as the run.

        Args:
            coordinate: "Pi1", "Pi2", "Pi3", "Gamma1", "Gamma2" or "Gamma3".
            value: the value of the coordinate on the surface.
            direction: 1 for crossings upwards, -1 for crossings downwards, 0 for both.
            most: the number of crossings after which the run ends; None for no bound.

        The other arguments are those of `solve`.

        Raises:
            ValueError: if an argument is out of its range.
            IntegrationError: if a step fails.
        """
        if coordinate not in COORDINATES:
            raise ValueError(f"coordinate must be one of {', '.join(COORDINATES)}, got {coordinate!r}")
        if most is not None and most < 1:
            raise ValueError(f"most must be at least 1, got {most}")
        normal = [float(name == coordinate) for name in COORDINATES]
        start = vector("Pi", Pi) + vector("Gamma", Gamma)
        bound = 2**63 - 1 if most is None else most
        t, y = self._top.crossings(
            start, float(step), float(end), formulation, scheme, 0.0, normal, float(value), direction, bound
        )
        return Crossings(t, y.T)

    def __repr__(self) -> str:
        inertia, center = (", ".join(f"{x:g}" for x in v) for v in (self.inertia, self.center_of_mass))
        return f"<Top: I = ({inertia}), m g l = {self.weight_moment:g}, c = ({center})>"
