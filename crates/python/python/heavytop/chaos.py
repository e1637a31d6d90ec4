"""Lyapunov exponents, MEGNO and SALI."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Optional, Union

import numpy as np

from . import _native
from ._native import IntegrationError
from .accuracy import members_of_system, members_of_tops, warn_of_many
from .arguments import array, count, course, flag
from .ensembles import natives
from .methods import method
from .solution import Floats
from .system import System
from .top import Top


@dataclass(frozen=True, eq=False, repr=False)
class Chaos:
    """Indicators of chaos of one run or of many.

    The shapes are those for one run. For n runs there is an axis of n after that of the exponents; with `every` the last
    axis is that of the m times.

    Attributes:
        t: the end, or the times of shape (m,) with `every`.
        exponents: the Lyapunov exponents up to t per unit of time along the run, the largest first in the limit of long runs, shape (k,).
        megno: the mean exponential growth factor of nearby orbits: about 2 for regular motion, and half of the largest
            exponent times t for chaotic motion.
        sali: the smaller alignment index of two tangent vectors, or None: round-off for chaotic motion.
        y: the states at the end, shape (d,) or (d, n).
        failures: the reason by the index of each of many runs that failed; its numbers are NaN.
    """

    t: Floats
    exponents: Floats
    megno: Floats
    sali: Optional[Floats]
    y: Floats
    failures: Mapping[int, str]

    def __repr__(self) -> str:
        if self.y.ndim == 1:
            exponent, megno = np.atleast_2d(self.exponents.T)[-1, 0], np.atleast_1d(self.megno)[-1]
            found = f"the largest exponent is {exponent:.3g}, MEGNO {megno:.3g}"
        else:
            found = f"{self.y.shape[1]} runs, {len(self.failures)} failures"
        return f"<Chaos: up to t = {np.atleast_1d(self.t)[-1]:g}, {found}>"


def lyapunov(
    system: Union[Top, Sequence[Top], System],
    y0: Any = None,
    *,
    step: float,
    end: float,
    exponents: int = 1,
    sali: bool = False,
    every: Optional[int] = None,
    scheme: str = "gauss-8",
    formulation: Optional[str] = None,
) -> Chaos:
    """Returns Lyapunov exponents and other indicators of chaos of one run, or of many on all threads.

    The tangent vectors are advanced by the exact derivative of each step of the method, so that they are those of the
    discrete map. Their lengths are measured in units of the motion, Pi by |Pi| and Gamma by |Gamma|, so that no indicator
    depends on the units of mass, length and time. The exponents converge slowly: for regular motion they vanish as (ln t)/t. MEGNO separates order from
    chaos sooner. A step costs about three plain steps for each tangent vector.

    Something may drive, damp, shake or force the system: nearby motions are then compared at the same time and on the same path of the
    noise. Of many runs with noise each has the path of its number, counted from that which the noise has, as in `solve_many`.

    Args:
        system: a top or a system; or a sequence of n tops, one for each state.
        y0: the initial state, shape (d,), for a top (Pi1, Pi2, Pi3, Gamma1, Gamma2, Gamma3); or n states, shape (d, n). A
            state of a system may be given, or left out, as for its `solve`, and several as a list of states by name.
        step: the time step.
        end: the end: a multiple of the step, to within 1e-9 of itself. Before 0 the indicators are those of the motion
            backward in time.
        exponents: the number of exponents, from 1 to d. All six of a top add up to 0, and come in pairs of opposite signs,
            with two zeros for the Casimirs.
        sali: whether to compute SALI, for which there must be one exponent.
        every: keep the indicators after each n-th step, too; without it those of the end alone.
        scheme: as for `Top.solve` and `System.solve`.
        formulation: as for them, but not "collective", whose tangent vectors belong to another space; "reduced" makes the
            same steps. The default is "reduced" where there is one, and "direct" elsewhere and for systems with the time, a drive,
            damping, noise or a torque.

    Raises:
        ValueError: if an argument is out of its range, or friction, a force or noise acts on a system of arrays.
        IntegrationError: if a step of the only run fails.

    Warns:
        RuntimeWarning: if a step turns the motion by more than 1 rad in the fastest run or some others.

    Example:
        A top near the unstable upright spin, and one that is integrable:

        >>> import numpy as np
        >>> top = Top(inertia=[1.0, 1.7, 2.2], mass=1.0, gravity=9.81, length=0.5, center_of_mass=[0.6, 0.0, 0.8])
        >>> chaotic = lyapunov(top, [1, 2, 1, 0, 0.6, 0.8], step=0.05, end=200)
        >>> regular = lyapunov(Top.kovalevskaya(), [2, 3, 4, 0.6, 0, 0.8], step=0.05, end=200)
        >>> bool(chaotic.exponents[0] > 0.1), bool(regular.exponents[0] < 0.05)
        (True, True)
        >>> bool(chaotic.megno > 5), bool(regular.megno < 3)
        (True, True)
    """
    tops = [] if isinstance(system, System) else natives(system)
    if isinstance(system, System) and isinstance(system._system, _native.Arrays) and system._system.is_open:
        raise ValueError("a system of arrays with friction, forces or noise has no tangent vectors: its own steps carry none")
    dimension = system.dimension if isinstance(system, System) else 6
    if y0 is None and not isinstance(system, System):
        raise ValueError("y0 is missing: a top is made without a start")
    states = system._many_states("y0", y0) if isinstance(system, System) else array("y0", y0)
    if states.ndim not in (1, 2) or states.shape[0] != dimension:
        raise ValueError(f"y0 must have the shape ({dimension},) or ({dimension}, n), got {states.shape}")
    number = count("exponents", exponents, 1)
    if number > dimension:
        raise ValueError(f"exponents must be from 1 to {dimension}, got {number}")
    if formulation == "collective":
        raise ValueError("formulation must not be collective: its tangent vectors belong to another space; leave it out")
    times = (*course(step, end), 0 if every is None else count("every", every, 1))
    rows, followed = states.reshape(dimension, -1).T, followed_exponents(number, flag("sali", sali))
    if isinstance(system, System):
        names = system._method(formulation or system._formulation_of_tangents(), scheme, 0.0)
        members = members_of_system(system._system, rows.T, times[0], names)
        warn_of_many(members, 0, len(rows), 3)
        found = _native.growth_of_system(system._system, rows, times, names, followed)
    else:
        names_of_top = method(formulation or "reduced", scheme, 0.0)
        warn_of_many(members_of_tops(tops, rows.T, times[0], names_of_top), 0, len(rows), 3)
        found = _native.growth_of_tops(tops, rows, times, names_of_top, followed)
    return chaos(found, states, number, times[1], every is not None)


def followed_exponents(exponents: int, sali: bool) -> Optional[int]:
    """Returns the number of exponents whose tangent vectors are followed, or None for the two of SALI."""
    if sali and exponents > 1:
        raise ValueError(f"exponents must be 1 if sali is True, got {exponents}")
    return None if sali else exponents


def chaos(found: _native.Indicators, states: Floats, exponents: int, end: float, history: bool) -> Chaos:
    """Returns the indicators of runs from states of shape (d,) or (d, n) as arrays."""
    if states.ndim == 1 and found.failures:
        raise IntegrationError(found.failures[0][1])
    members, times = states.shape[1:], np.array(found.times or [end])

    def columns(values: Sequence[Sequence[float]], count: int) -> Floats:
        """Returns the first columns of each run, of shape (count, n, m), in the axes that there are."""
        runs = [np.reshape(v, (times.size, -1))[:, :count] if len(v) else np.full((times.size, count), np.nan) for v in values]
        every = np.moveaxis(np.array(runs).reshape(-1, times.size, count), 2, 0).reshape(count, *members, times.size)
        return every if history else every[..., -1]

    ends = [end if len(end) else np.full(states.shape[0], np.nan) for end in found.ends]
    return Chaos(
        t=times if history else times[-1],
        exponents=columns(found.exponents, exponents),
        megno=columns(found.megno, 1)[0],
        sali=columns(found.sali, 1)[0] if any(len(values) for values in found.sali) else None,
        y=np.array(ends).T.reshape(states.shape),
        failures=dict(found.failures),
    )
