"""Many tops at once, on all threads and in the SIMD lanes of the processor."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Union

import numpy as np
from numpy.typing import ArrayLike

from . import _native
from .solution import Floats
from .top import Top


@dataclass(frozen=True)
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


def solve_many(
    tops: Union[Top, Sequence[Top]],
    y: ArrayLike,
    *,
    step: float,
    end: float,
    scheme: str = "gauss-8",
) -> Ends:
    """Follows many tops from t = 0 to the end, and returns their last states.

    A member that fails is reported by its index and harms no other. The result of a member depends neither on the others
    nor on the number of threads, which RAYON_NUM_THREADS sets.

    Args:
        tops: one top for all states, or a sequence of n tops.
        y: the initial states (Pi1, Pi2, Pi3, Gamma1, Gamma2, Gamma3), shape (6, n).
        step: the time step, s.
        end: the end, s: a whole number of steps.
        scheme: "implicit-midpoint", "gauss-4", ..., "gauss-12" or "gauss-16"; all are collective.

    Raises:
        ValueError: if an argument is out of its range, or the numbers of tops and states differ.

    Example:
        >>> import numpy as np
        >>> top = Top.kovalevskaya()
        >>> y = np.tile([[2.0], [3.0], [4.0], [0.6], [0.0], [0.8]], 100)
        >>> ends = solve_many(top, y, step=0.1, end=10, scheme="gauss-8")
        >>> ends.y.shape, ends.success
        ((6, 100), True)
    """
    states = np.asarray(y, dtype=float)
    if states.ndim != 2 or states.shape[0] != 6:
        raise ValueError(f"y must have the shape (6, n), got {states.shape}")
    rows, step, end = states.T, float(step), float(end)
    if isinstance(tops, Top):
        last, failures = _native.advance_states(tops._top, rows, step, end, scheme)
    else:
        last, failures = _native.advance_tops([top._top for top in tops], rows, step, end, scheme)
    return Ends(last.T, dict(failures))
