"""Many runs at once, on all threads; those of tops in the SIMD lanes of the processor, too."""

from __future__ import annotations

import contextlib
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Optional, Union

import numpy as np

from . import _native
from .accuracy import members_of_system, members_of_tops, warn_of_many
from .arguments import choice, course, states
from .ends import Ends
from .solution import Floats
from .system import System
from .top import Top

SCHEMES_OF_MANY = ("implicit-midpoint", "gauss-4", "gauss-6", "gauss-8", "gauss-10", "gauss-12", "gauss-16")


@dataclass(frozen=True, eq=False)
class InvariantsOfTops:
    """The invariants that all runs of tops conserve from their starts, as a function of a state of each run and the time."""

    tops: tuple[_native.Top, ...]
    starts: Floats

    def __call__(self, y: Floats, _: float) -> dict[str, Floats]:
        symbols, values = _native.invariants_of_tops(self.tops, self.starts.T, y.T)
        return {symbol: values[:, i] for i, symbol in enumerate(symbols)}


@dataclass(frozen=True)
class InvariantsOfSystem:
    """The invariants of a system, as a function of states and the time; NaN for those at which one of them has no value."""

    system: System

    def __call__(self, y: Floats, t: float) -> dict[str, Floats]:
        with contextlib.suppress(ValueError):
            return self.system.invariant_values(y, t)
        values = {symbol: np.full(y.shape[1], np.nan) for symbol in self.system.invariants}
        for i, state in enumerate(y.T):
            with contextlib.suppress(ValueError):
                for symbol, value in self.system.invariant_values(state, t).items():
                    values[symbol][i] = value
        return values


def natives(tops: Any) -> list[_native.Top]:
    """Returns the native parts of a sequence of tops."""
    try:
        every = list(tops)
    except TypeError:
        every = [tops]
    for i, top in enumerate(every):
        if not isinstance(top, Top):
            raise ValueError(f"a sequence must be one of tops, and a system stands alone: got {top!r} at {i}")
    return [top._top for top in every]


def of_system(system: System, y: Floats, times: tuple[float, float], names: tuple[Any, Any]) -> Ends:
    """Follows many states of a system."""
    if y.ndim != 2 or y.shape[0] != system.dimension:
        raise ValueError(f"y must have the shape ({system.dimension}, n), got {y.shape}")
    method = system._method(*names, 0.0)
    last, failures = _native.advance_system(system._system, y.T, *times, method)
    members = members_of_system(system._system, y, times[0], method)
    estimate = warn_of_many(members, steps_of(times), y.shape[1], 4)
    return Ends(last.T, dict(failures), estimate, y, InvariantsOfSystem(system), times[1])


def steps_of(times: tuple[float, float]) -> int:
    """Returns the number of steps to the end."""
    return round(times[1] / times[0])


def solve_many(
    tops: Union[Top, Sequence[Top], System],
    y: Any,
    *,
    step: float,
    end: float,
    scheme: Optional[str] = None,
    formulation: Optional[str] = None,
) -> Ends:
    """Follows many tops, or many states of a system, from t = 0 to the end, and returns their last states alone.

    A member that fails is reported by its index and harms no other. The result of a member depends neither on the others
    nor on the number of threads, which the environment variable RAYON_NUM_THREADS sets before the first call of a process.
    A process that was forked, as those of `multiprocessing` may be, starts threads of its own. Ctrl-C ends the call after
    1024 steps at most.

    Of a system with noise, member i has the path of that number, counted from the path that its `noise` has: many equal states are an
    ensemble, whose means and quantiles are those of `Ends.y`. `solve_paths` has them at other times, too, and keeps no path.

    The last states of a system have the bits of those of `System.solve`. Tops are followed in the SIMD lanes of the
    processor by other arithmetic than that of `Top.solve`: the same method, from which they differ by rounding errors.

    Args:
        tops: one top for all states, or a sequence of n tops; or a system for all states.
        y: the initial states, shape (d, n): for tops (Pi1, Pi2, Pi3, Gamma1, Gamma2, Gamma3); of a system also a list of
            states by name.
        step: the time step, s.
        end: the end, s: a multiple of the step, to within 1e-9 of itself. An end before 0 is reached backward in time.
        scheme: for tops "implicit-midpoint", "gauss-4", "gauss-6", "gauss-8", "gauss-10", "gauss-12" or "gauss-16", which
            are collective and conserve the Casimirs to round-off; for a system any that `System.solve` has. Without it "gauss-8",
            or what `System.solve` has then.
        formulation: of a system, as for `System.solve`; tops have none but "collective".

    Raises:
        ValueError: if an argument is out of its range, or the numbers of tops and states differ.

    Warns:
        RuntimeWarning: if, in the fastest run or some others, a step turns the motion by more than 1 rad, or the estimated
            error is above 1e-3.

    Example:
        >>> import numpy as np
        >>> top = Top.kovalevskaya()
        >>> y = np.tile([[2.0], [3.0], [4.0], [0.6], [0.0], [0.8]], 100)
        >>> ends = solve_many(top, y, step=0.1, end=10, scheme="gauss-8")
        >>> ends
        <Ends: 100 states, 0 failures>
        >>> bool(ends.deviation("f2").max() < 1e-12)
        True
    """
    step, end = course(step, end)
    if isinstance(tops, System):
        return of_system(tops, tops._many_states("y", y), (step, end), (formulation, scheme))
    if formulation not in (None, "collective"):
        raise ValueError(f"formulation must be collective for tops, got {formulation!r}")
    starts = states("y", y)
    scheme = choice("scheme", "gauss-8" if scheme is None else scheme, SCHEMES_OF_MANY)
    every = [tops._top] if isinstance(tops, Top) else natives(tops)
    if isinstance(tops, Top):
        last, failures = _native.advance_states(tops._top, starts.T, step, end, scheme)
    else:
        last, failures = _native.advance_tops(every, starts.T, step, end, scheme)
    members = members_of_tops(every, starts, step, ("collective", scheme, 0.0))
    estimate = warn_of_many(members, steps_of((step, end)), starts.shape[1], 3)
    return Ends(last.T, dict(failures), estimate, starts, InvariantsOfTops(tuple(every), starts), end)
