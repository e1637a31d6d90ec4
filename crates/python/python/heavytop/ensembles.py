"""Many tops at once, on all threads and in the SIMD lanes of the processor."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Union

from numpy.typing import ArrayLike

from . import _native
from .arguments import choice, positive, states
from .solution import Floats
from .top import Top

SCHEMES_OF_MANY = ("implicit-midpoint", "gauss-4", "gauss-6", "gauss-8", "gauss-10", "gauss-12", "gauss-16")


@dataclass(frozen=True, eq=False, repr=False)
class Ends:
    """The ends of many runs.

    Attributes:
        y: the states at the end, shape (6, n). A member that failed keeps the state before the failed step.
        failures: the reason by the index of each member that failed.
    """

    y: Floats
    failures: Mapping[int, str]

    @property
    def success(self) -> bool:
        """Whether no member failed."""
        return not self.failures

    def __repr__(self) -> str:
        return f"<Ends: {self.y.shape[1]} states, {len(self.failures)} failures>"


def natives(tops: Any) -> list[_native.Top]:
    """Returns the native parts of a sequence of tops."""
    try:
        every = list(tops)
    except TypeError:
        every = [tops]
    for i, top in enumerate(every):
        if not isinstance(top, Top):
            raise ValueError(f"tops must be a Top or a sequence of them, got {top!r} at {i}")
    return [top._top for top in every]


def solve_many(
    tops: Union[Top, Sequence[Top]],
    y: ArrayLike,
    *,
    step: float,
    end: float,
    scheme: str = "gauss-8",
) -> Ends:
    """Follows many tops from t = 0 to the end, and returns their last states alone.

    A member that fails is reported by its index and harms no other. The result of a member depends neither on the others
    nor on the number of threads, which the environment variable RAYON_NUM_THREADS sets before the first call. Ctrl-C ends
    the call after 1024 steps at most.

    Args:
        tops: one top for all states, or a sequence of n tops.
        y: the initial states (Pi1, Pi2, Pi3, Gamma1, Gamma2, Gamma3), shape (6, n).
        step: the time step, s.
        end: the end, s: a multiple of the step, to within 1e-9 of itself.
        scheme: "implicit-midpoint", "gauss-4", "gauss-6", "gauss-8", "gauss-10", "gauss-12" or "gauss-16"; all are
            collective, and conserve the Casimirs to round-off.

    Raises:
        ValueError: if an argument is out of its range, or the numbers of tops and states differ.

    Example:
        >>> import numpy as np
        >>> top = Top.kovalevskaya()
        >>> y = np.tile([[2.0], [3.0], [4.0], [0.6], [0.0], [0.8]], 100)
        >>> ends = solve_many(top, y, step=0.1, end=10, scheme="gauss-8")
        >>> ends
        <Ends: 100 states, 0 failures>
    """
    rows, step, end = states("y", y).T, positive("step", step), positive("end", end)
    scheme = choice("scheme", scheme, SCHEMES_OF_MANY)
    if isinstance(tops, Top):
        last, failures = _native.advance_states(tops._top, rows, step, end, scheme)
    else:
        last, failures = _native.advance_tops(natives(tops), rows, step, end, scheme)
    return Ends(last.T, dict(failures))
