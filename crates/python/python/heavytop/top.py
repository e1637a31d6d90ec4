"""Heavy tops and their runs."""

from __future__ import annotations

import math
from dataclasses import fields
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from . import _native
from .accuracy import warn_of_accuracy
from .arguments import choice, course, flag, quaternion, real, vector
from .arguments import count as whole
from .events import Events, Function, native_events, surface_source
from .methods import method
from .solution import NEVER, Crossings, Floats, Run, Solution, crossings, names_of_groups, solution
from .top_parameters import TopParameters
from .top_solution import Measured, Report, SteadyRotation, TopSolution

COORDINATES = ("Pi1", "Pi2", "Pi3", "Gamma1", "Gamma2", "Gamma3")

ANGLES = ("atan2(Gamma3, Gamma2)", "atan2(Gamma1, Gamma3)", "atan2(Gamma2, Gamma1)")
"""The angles of Gamma about the three axes."""

NAMES = names_of_groups([("Pi", 3), ("Gamma", 3)])


class Top(TopParameters):
    """A heavy top: a rigid body that turns about a fixed point, under gravity.

    The energy is h = (Pi1^2/I1 + Pi2^2/I2 + Pi3^2/I3)/2 + m g l c.Gamma. Mass, gravity and length enter by their product
    alone, the weight moment m g l.

    Args:
        inertia: the principal moments about the support, the fixed point, kg m^2; or a symmetric matrix, of shape (3, 3), in
            any axes. None may be larger than the sum of the other two. One may be 0: a thin rod, with its centre of mass on it
            and no angular momentum about it. With a matrix all vectors and states, in arguments and results, are in its axes.
        mass: kg.
        gravity: m/s^2; 0 gives a free rigid body.
        length: the distance of the centre of mass from the support, m.
        center_of_mass: the direction c of the centre of mass from the support in the body frame, a unit vector.
        inertia_about: "support", or "center-of-mass" for moments about the centre of mass, to which m l^2 (1 - c c^T) is then
            added.

    Raises:
        ValueError: if a parameter is out of its range. The message names the number and its bound.

    Warns:
        UserWarning: if no body has these moments about the support with this mass at this distance. The motion depends on
            the moments and m g l alone.

    Example:
        >>> top = Top(inertia=[1.0, 1.5, 2.0], mass=1.0, gravity=9.81, length=0.1, center_of_mass=[0, 0, 1])
        >>> top.invariants
        ('h', 'f1', 'f2')
    """

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
        attitude0: Optional[ArrayLike] = None,
        events: Events = None,
        estimate: bool = True,
    ) -> TopSolution:
        """Follows the top from t = 0 to the end, in equal steps. An end before 0 is reached backward in time.

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
            end: the end, s: a multiple of the step, to within 1e-9 of itself. If it is negative, so is the step, which may be
                written with its sign or without. From there "implicit-midpoint", "gauss-..." and the compositions, which
                are symmetric in time, return to where they came from, to round-off.
            scheme: the one-step method.
            formulation: where it is applied.
            tolerance: of the stage equations of implicit schemes, relative to the state, at most 1e-3; 0 iterates to
                round-off.
            every: keep each n-th sample; the last one is always kept. A sample takes 56 bytes, 8 for each invariant, and 32
                for the attitude.
            attitude: whether to follow the attitude of the body, too.
            attitude0: the attitude at the start, a unit quaternion (w, x, y, z) that rotates Gamma to the spatial vertical
                (0, 0, 1). Without it the run begins with the shortest such rotation.
            events: functions of the state whose zeros are found: formulas such as "Gamma3 - 0.5", Python functions of the
                coordinates such as `lambda x: x.Pi @ x.Gamma - 1`, or `Event`s, which have a direction and may end the run.
                A function is called once, with symbols. At an event the function goes to zero and changes its sign; see
                `Event`. Two zeros within one step are found unless they are very close.
            estimate: whether to estimate the error of the run. The estimate repeats the run, or the beginning of a long one,
                with half the step, which takes three times as long as a short run itself. Without it the angle of a step at
                the start is judged alone.

        Returns:
            The samples. If a step fails, or an invariant or an event has no finite value at a later state than the start,
            those until then, with `success` false. If an event ends the run, the last sample is the state there.

        Raises:
            ValueError: if an argument is out of its range, or the formulation does not offer the scheme.
            TypeError: if the function of an event branches on the state or returns no scalar.
            MemoryError: if there is no room for the samples.

        Warns:
            RuntimeWarning: if a step turns the motion by more than 1 rad, or the estimated error is above 1e-3.

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
        step, end = course(step, end)
        run, every = self._run(Pi, Gamma, step, formulation, scheme, tolerance), whole("every", every, 1)
        initial = None if attitude0 is None else quaternion(attitude0, run.setting[0][3:])
        followed = (flag("attitude", attitude) or initial is not None, initial)
        watched = native_events(events, NAMES, {})
        columns = self._top.follow(run.setting, end, every, followed, watched)
        symbols = self._top.invariants_from(np.array([run.setting[0]]))
        repeated = run.steps(columns.times) if flag("estimate", estimate) else 0
        error = warn_of_accuracy(self._top, run.setting, repeated, 3)
        found = solution(columns, (symbols, symbols), run, error, has_events=events is not None)
        return TopSolution(**{field.name: getattr(found, field.name) for field in fields(Solution)})

    def report(
        self,
        Pi: ArrayLike,
        Gamma: ArrayLike,
        *,
        step: float,
        end: float,
        scheme: str = "gauss-8",
        formulation: str = "collective",
    ) -> Report:
        """Follows the top, and tells its precession, nutation and spin, its turning points, and the steady rotations near it.

        The angles are those of the line from the support to the centre of mass: theta is its inclination from the vertical, phi
        its precession and psi the spin about it. Of a body without weight they are those of a principal axis about the
        angular momentum L. Means are taken from the first highest point of the line to the last one; where there are no two,
        or theta is constant, over the whole run. Beside the numbers stand the formulas of textbooks. The arguments are those
        of `solve`; "direct" has no attitude, and no report.

        Raises:
            ValueError: if an argument is out of its range.
            IntegrationError: if a step fails.

        Warns:
            RuntimeWarning: as `solve`.

        Example:
            >>> top = Top.lagrange(transverse=2.0, axial=1.0)
            >>> report = top.report([0, 0, 20], [0.6, 0, 0.8], step=0.02, end=20)
            >>> precession = report.numbers["precession, mean dφ/dt"]
            >>> round(precession.value, 4), round(precession.formulas["m g l/(I₃ω₃), of a fast top"], 4)
            (0.0502, 0.05)
        """
        step, end = course(step, end)
        run = self._run(Pi, Gamma, step, formulation, scheme, 0.0)
        warn_of_accuracy(self._top, run.setting, round(end / step), 3)
        kind, numbers, steady, text = self._top.report(run.setting, end)
        measured = {name: Measured(value, unit, dict(formulas)) for name, value, unit, formulas in numbers}
        rotations = tuple(SteadyRotation(np.array(one[0]), one[1], one[2], one[3], one[4], one[5]) for one in steady)
        return Report(kind, measured, rotations, text)

    def _run(self, Pi: ArrayLike, Gamma: ArrayLike, step: float, formulation: Any, scheme: Any, tolerance: Any) -> Run:
        angular_momentum = vector("Pi", Pi)
        names = method(formulation, scheme, tolerance)
        return Run(self._top, (angular_momentum + vector("Gamma", Gamma), step, names), NAMES)

    def section(
        self,
        Pi: ArrayLike,
        Gamma: ArrayLike,
        *,
        coordinate: Function,
        value: float = 0.0,
        direction: int = 1,
        step: float,
        end: float,
        most: Optional[int] = None,
        scheme: str = "gauss-8",
        formulation: str = "collective",
    ) -> Crossings:
        """Returns the points at which a function of the state passes a value: a Poincare section.

        They lie on the surface to round-off, and have the order of the method. The start is no crossing, even if it lies on
        the surface. Two crossings within one step are found unless they are very close together; more than two are not:
        choose a step that resolves the motion.

        Args:
            coordinate: "Pi1", "Pi2", "Pi3", "Gamma1", "Gamma2" or "Gamma3"; or any formula or Python function of them. An
                angle, such as "atan2(Gamma2, Gamma1)", passes its value once per turn.
            value: its value on the surface.
            direction: 1 for crossings upwards in time, -1 for crossings downwards, 0 for both. A run backward in time finds
                the points of the same section.
            most: the number of crossings after which the run ends; None for no bound.

        The other arguments are those of `solve`.

        Raises:
            ValueError: if an argument is out of its range, or the function has no value at the start.
            IntegrationError: if a step fails, or the function has no value later.
        """
        step, end = course(step, end)
        run = self._run(Pi, Gamma, step, formulation, scheme, 0.0)
        # Events have the direction along the run.
        way = int(choice("direction", direction, (1, -1, 0)) * math.copysign(1, step))
        bound = 0 if most is None else whole("most", most, 1)
        surface = (surface_source(coordinate, real("value", value), NAMES, {}), way, bound)
        warn_of_accuracy(self._top, run.setting, 0, 3)
        return crossings(self._top.follow(run.setting, end, NEVER, (False, None), [surface]))

    def section_starts(
        self,
        *,
        h: float,
        f2: float,
        coordinate: str,
        value: float = 0.0,
        direction: int = 1,
        count: int = 1,
        seed: int = 0,
    ) -> Floats:
        """Returns states on a Poincare section with an energy and a vertical momentum, to begin runs of `section` at.

        They are spread evenly over the accessible part of the plane of the section, and have |Gamma| = 1. More states of
        the same seed begin with the same ones.

        Args:
            h: the energy, J.
            f2: the vertical momentum Pi.Gamma, kg m^2/s.
            coordinate: "Pi1", "Pi2", "Pi3", "Gamma1", "Gamma2" or "Gamma3", or the angle of Gamma about an axis:
                "atan2(Gamma3, Gamma2)", "atan2(Gamma1, Gamma3)" or "atan2(Gamma2, Gamma1)".
            value: the value of the coordinate on the surface; of an angle in radians, up to turns of 2 pi.
            direction: 1 for states that cross it upwards, -1 for downwards, 0 for both.
            count: the number of states.
            seed: chooses the states.

        Returns:
            The states, shape (6, count).

        Raises:
            ValueError: if no state of the section has the energy, with the least energy, or an argument is out of its range.

        Example:
            >>> top = Top.kovalevskaya()
            >>> y = top.section_starts(h=2, f2=0.3, coordinate="Gamma3", count=5)
            >>> bool(abs(top.invariant_values(y)["h"] - 2).max() < 1e-14)
            True
            >>> points = [top.section(s[:3], s[3:], coordinate="Gamma3", step=0.1, end=50) for s in y.T]
        """
        level = (real("h", h), real("f2", f2))
        way = int(choice("direction", direction, (1, -1, 0)))
        surface = (choice("coordinate", coordinate, COORDINATES + ANGLES), real("value", value), way)
        number, seed = whole("count", count, 1), whole("seed", seed, 0)
        return _native.section_starts(self._top, level, surface, number, seed).T
