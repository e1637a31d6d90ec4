"""The ends of many runs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Optional

import numpy as np

from .solution import Floats


@dataclass(frozen=True, eq=False, repr=False)
class Ends:
    """The ends of many runs.

    Attributes:
        y: the states at the end, shape (d, n). A member whose step failed keeps the state before it.
        failures: the reason by the index of each member that failed; also where an invariant of a system has no value at
            the end.
        error_estimate: the largest estimated error of the fastest run and of some others spread evenly, as for
            `Solution.error_estimate`; None if there is none.
        invariants: the invariants at the end by symbol, each of shape (n,): those that every member conserves from its
            start. NaN where an invariant of a system has no value.
    """

    y: Floats
    failures: Mapping[int, str]
    error_estimate: Optional[float]
    _starts: Floats = field(repr=False)
    _values: Callable[[Floats, float], dict[str, Floats]] = field(repr=False)
    _end: float = field(repr=False)

    @cached_property
    def invariants(self) -> dict[str, Floats]:
        """The invariants at the end by symbol, each of shape (n,)."""
        return self._values(self.y, self._end)

    def deviation(self, symbol: str) -> Floats:
        """Returns |f(end) - f(0)| of an invariant for each member, shape (n,)."""
        if symbol not in self.invariants:
            raise ValueError(f"the invariants are {', '.join(self.invariants)}, got {symbol!r}")
        return np.abs(self.invariants[symbol] - self._values(self._starts, 0.0)[symbol])

    @property
    def success(self) -> bool:
        """Whether no member failed."""
        return not self.failures

    def __repr__(self) -> str:
        return f"<Ends: {self.y.shape[1]} states, {len(self.failures)} failures>"
