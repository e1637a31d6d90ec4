"""Heavy tops and their runs."""

from __future__ import annotations

import warnings
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from . import _native
from ._native import IntegrationError
from .arguments import array, choice, count, flag, positive, real, vector
from .solution import Crossings, Floats, Run, Solution

FORMULATIONS = ("collective", "reduced", "direct", "splitting")
"""Where a scheme is applied; `Top.solve` describes them."""

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
"""The one-step methods; `Top.solve` describes them."""

COORDINATES = ("Pi1", "Pi2", "Pi3", "Gamma1", "Gamma2", "Gamma3")

MOST_TOLERANCE = 1e-3

LONG_STEP = 2.0


class Top:
    """A heavy top: a rigid body that turns about a fixed point, under gravity.

    The energy is h = (Pi1^2/I1 + Pi2^2/I2 + Pi3^2/I3)/2 + m g l c.Gamma. Mass, gravity and length enter by their product
    alone, the weight moment m g l.

    Args:
        inertia: the principal moments about the fixed point, kg m^2. They must be positive, and none may be larger than the
            sum of the other two. Whether they leave room for a body with this mass at this distance, I >= m l^2 about the
            axes at right angles to c, is not checked.
        mass: kg.
        gravity: m/s^2; 0 gives a free rigid body.
        length: the distance of the centre of mass from the fixed point, m.
        center_of_mass: the direction c of the centre of mass in the body frame, a unit vector.

    Raises:
        ValueError: if a parameter is out of its range. The message names the number and its bound.

    Example:
        >>> top = Top(inertia=[1.0, 1.5, 2.0], mass=1.0, gravity=9.81, length=0.1, center_of_mass=[0, 0, 1])
        >>> top.invariants
        ('h', 'f1', 'f2')
    """

    def __init__(
        self,
        inertia: ArrayLike,
        mass: float,
        gravity: float,
        length: float,
        center_of_mass: ArrayLike = (0.0, 0.0, 1.0),
    ) -> None:
        center = vector("center_of_mass", center_of_mass)
        moments = [positive(f"inertia[{i}]", x) for i, x in enumerate(vector("inertia", inertia))]
        numbers = (real("mass", mass), real("gravity", gravity), real("length", length))
        self._top = _native.Top(moments, *numbers, center)

    @classmethod
    def _of(cls, native: _native.Top) -> Top:
        top = cls.__new__(cls)
        top._top = native
        return top

    @classmethod
    def free_rigid_body(cls, inertia: ArrayLike) -> Top:
        """Returns a rigid body without gravity: Euler's top. Its Gamma is any unit vector that is fixed in space."""
        moments = [positive(f"inertia[{i}]", x) for i, x in enumerate(vector("inertia", inertia))]
        return cls._of(_native.Top.free_rigid_body(moments))

    @classmethod
    def lagrange(cls, transverse: float, axial: float, weight_moment: float = 1.0) -> Top:
        """Returns Lagrange's top: I1 = I2 = transverse, I3 = axial (kg m^2), with the centre of mass on the third axis.

        The weight moment is m g l, N m. A fourth invariant is f3 = Pi3.
        """
        moments = (positive("transverse", transverse), positive("axial", axial))
        return cls._of(_native.Top.lagrange(*moments, real("weight_moment", weight_moment)))

    @classmethod
    def kovalevskaya(cls, axial: float = 1.0, weight_moment: float = 1.0) -> Top:
        """Returns Kovalevskaya's top: I1 = I2 = 2 I3, I3 = axial (kg m^2), with the centre of mass on the first axis.

        The weight moment is m g l, N m. A fourth invariant is K = |(Pi1 + i Pi2)^2 - 4 m g l I3 (Gamma1 + i Gamma2)|^2.
        """
        return cls._of(_native.Top.kovalevskaya(positive("axial", axial), real("weight_moment", weight_moment)))

    @classmethod
    def goryachev_chaplygin(cls, axial: float = 1.0, weight_moment: float = 1.0) -> Top:
        """Returns the top of Goryachev and Chaplygin: I1 = I2 = 4 I3, with the centre of mass on the first axis.

        The weight moment is m g l, N m. G = Pi3 (Pi1^2 + Pi2^2) - 4 m g l I3 Gamma3 Pi1 is conserved if Pi.Gamma = 0, and
        only then.
        """
        moments = (positive("axial", axial), real("weight_moment", weight_moment))
        return cls._of(_native.Top.goryachev_chaplygin(*moments))

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
        """The symbols of the invariants.

        Every top has the energy h (J) and the Casimirs f1 = |Gamma|^2 and f2 = Pi.Gamma (kg m^2/s). A top with the moments
        and the axis of one of these, with the symmetry axis third, has a fourth: Lagrange's f3 = Pi3, Kovalevskaya's K, and
        G of Goryachev and Chaplygin, which is conserved only if Pi.Gamma = 0. The constructors give their formulas.
        """
        return tuple(self._top.invariants)

    def invariant_values(self, y: ArrayLike) -> dict[str, Floats]:
        """Returns the invariants of states of shape (6,) or (6, n), by symbol."""
        states = array("y", y)
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

        Formulations, with the schemes that each offers:

        * "collective": on T*C^2, mapped to se(3)* by a Poisson map. All schemes.
        * "reduced": the same maps without a lift, on se(3)* itself. "implicit-midpoint", "gauss-...", and compositions.
        * "direct": on the six equations of the top, for comparison. All but "symplectic-euler", "stormer-verlet" and
          "lobatto-iiia-iiib-4".
        * "splitting": exact flows of parts of the energy, on se(3)*; explicit. "strang", "yoshida-4", "suzuki-4",
          "yoshida-6", "kahan-li-6" and "kahan-li-8", whose numbers are their orders.

        Collective and reduced, the schemes "implicit-midpoint", "gauss-4" ... "gauss-16" and the compositions conserve the
        Casimirs to round-off and the energy without drift, and so does every splitting. "explicit-midpoint", "rk4" and the
        three partitioned schemes conserve neither; nor does any scheme applied directly conserve the Poisson structure.
        A step with h |Omega| of about 0.5 suits "gauss-8"; higher orders allow longer steps.

        Args:
            Pi: the initial angular momentum in the body frame, kg m^2/s.
            Gamma: the initial vertical in the body frame, normally a unit vector; |Gamma| scales m g l.
            step: the time step h, s.
            end: the end, s: a multiple of the step, to within 1e-9 of itself.
            scheme: the one-step method.
            formulation: where it is applied.
            tolerance: of the stage equations of implicit schemes, relative to the state, at most 1e-3; 0 iterates to
                round-off.
            every: keep each n-th sample; the last one is always kept. A sample takes 56 bytes, 8 for each invariant, and 32
                for the attitude.
            attitude: whether to follow the attitude of the body, too.

        Returns:
            The samples. If a step fails, or an invariant is no longer finite, those until then, with `success` false.

        Raises:
            ValueError: if an argument is out of its range, or the formulation does not offer the scheme.
            MemoryError: if there is no room for the samples.

        Warns:
            RuntimeWarning: if the body turns by more than two radians in the first step, where no method is accurate.

        Example:
            The collective midpoint rule conserves the Casimirs; the explicit one does not.

            >>> top = Top.kovalevskaya()
            >>> start = dict(Pi=[2, 3, 4], Gamma=[0.6, 0, 0.8])
            >>> run = top.solve(**start, step=0.02, end=100, scheme="implicit-midpoint")
            >>> run.deviation("f2") < 1e-12
            True
            >>> run = top.solve(**start, step=0.02, end=100, scheme="explicit-midpoint", formulation="direct")
            >>> run.deviation("f2") > 1e-3
            True
        """
        run = self._run(Pi, Gamma, step, formulation, scheme, tolerance)
        end, attitude, every = positive("end", end), flag("attitude", attitude), count("every", every, 1)
        t, y, values, quaternions, iterations, error = self._top.follow(run.setting, end, every, attitude)
        finite = np.isfinite(values).all(axis=1)
        if not finite.all():
            kept = max(int(finite.argmin()), 1)
            error = IntegrationError(f"an invariant is not finite after t = {t[kept - 1]}")
            t, y, values, quaternions = t[:kept], y[:kept], values[:kept], quaternions[:kept]
        return Solution(
            t=t,
            y=y.T,
            invariants={symbol: values[:, i] for i, symbol in enumerate(self.invariants)},
            attitude=quaternions.T if attitude else None,
            iterations=iterations,
            error=error,
            _run=run,
        )

    def _run(self, Pi: ArrayLike, Gamma: ArrayLike, step: Any, formulation: Any, scheme: Any, tolerance: Any) -> Run:
        angular_momentum, step = vector("Pi", Pi), positive("step", step)
        tolerance = real("tolerance", tolerance)
        if not 0 <= tolerance <= MOST_TOLERANCE:
            raise ValueError(f"tolerance must be from 0 to {MOST_TOLERANCE}, got {tolerance}")
        turn = step * float(np.linalg.norm(np.divide(angular_momentum, self._top.inertia)))
        if turn > LONG_STEP:
            text = f"the body turns by {turn:.3g} rad in the first step: a step of {step / turn:.3g} turns it by 1 rad"
            warnings.warn(text, RuntimeWarning, stacklevel=3)
        method = (choice("formulation", formulation, FORMULATIONS), choice("scheme", scheme, SCHEMES), tolerance)
        return Run(self._top, (angular_momentum + vector("Gamma", Gamma), step, method))

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

        They lie on the surface to round-off, and have the order of the method. The start is no crossing. Two crossings
        within one step are found unless they are very close together; more than two are not: choose a step that resolves
        the motion.

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
        run = self._run(Pi, Gamma, step, formulation, scheme, 0.0)
        coordinate = choice("coordinate", coordinate, COORDINATES)
        normal = [float(name == coordinate) for name in COORDINATES]
        way = int(choice("direction", direction, (1, -1, 0)))
        bound = 2**63 - 1 if most is None else count("most", most, 1)
        surface = (normal, real("value", value), way)
        t, y = self._top.crossings(run.setting, positive("end", end), surface, bound)
        return Crossings(t, y.T)

    def _parameters(self) -> tuple[tuple[float, ...], float, tuple[float, ...]]:
        return tuple(self._top.inertia), self._top.weight_moment, tuple(self._top.center_of_mass)

    def __eq__(self, other: object) -> bool:
        return self._parameters() == other._parameters() if isinstance(other, Top) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._parameters())

    def __repr__(self) -> str:
        inertia, center = (", ".join(f"{x:g}" for x in v) for v in (self.inertia, self.center_of_mass))
        return f"<Top: I = ({inertia}), m g l = {self.weight_moment:g}, c = ({center})>"
