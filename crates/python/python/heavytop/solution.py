"""The results of runs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._native import IntegrationError
from .arguments import array

Floats = NDArray[np.float64]


class Run(NamedTuple):
    """What a run is made from: enough to make it again."""

    top: _native.Top
    setting: tuple[list[float], float, tuple[str, str, float]]


@dataclass(frozen=True, eq=False, repr=False)
class Solution:
    """A run of a top, with the names of SciPy's `solve_ivp`.

    Attributes:
        t: the times of the n samples, s, shape (n,).
        y: the states (Pi1, Pi2, Pi3, Gamma1, Gamma2, Gamma3), shape (6, n).
        invariants: the invariants of the top by symbol, each of shape (n,); `Top.invariants` lists them.
        attitude: the unit quaternions (w, x, y, z) of the attitude, shape (4, n), or None if they were not asked for.
            They rotate the body frame to the spatial frame. The run begins with the shortest rotation of Gamma to the
            spatial vertical (0, 0, 1).
        iterations: the number of iterations of the stage equations in all steps.
        success: whether every step was made. If not, the samples until the failure are there.
        message: the reason why a step failed, or a sentence that says that none did.
        error: the exception of the step that failed, or None.
    """

    t: Floats
    y: Floats
    invariants: Mapping[str, Floats]
    attitude: Optional[Floats]
    iterations: int
    error: Optional[IntegrationError]
    _run: Run = field(repr=False)

    @property
    def Pi(self) -> Floats:
        """The angular momentum in the body frame, shape (3, n)."""
        return self.y[:3]

    @property
    def Gamma(self) -> Floats:
        """The vertical in the body frame, shape (3, n)."""
        return self.y[3:]

    @property
    def success(self) -> bool:
        """Whether every step was made."""
        return self.error is None

    @property
    def message(self) -> str:
        """The reason why a step failed, or a sentence that says that none did."""
        return "every step was made" if self.error is None else str(self.error)

    def deviation(self, symbol: str, *, relative: bool = False) -> float:
        """Returns the largest |f(t) - f(0)| of an invariant, over all samples.

        Args:
            symbol: the symbol of the invariant, such as "h".
            relative: whether to divide it by |f(0)|.
        """
        if symbol not in self.invariants:
            raise ValueError(f"the invariants are {', '.join(self.invariants)}, got {symbol!r}")
        values = self.invariants[symbol]
        with np.errstate(all="ignore"):
            largest = float(np.abs(values - values[0]).max())
            return largest / abs(float(values[0])) if relative else largest

    def sol(self, t: ArrayLike) -> Floats:
        """Returns the states at any times from 0 to the end of the run.

        A state is that of a step of partial size from the whole step before it. It has the order of the method, and
        conserves what the method conserves. Each call makes the run again, up to the last of the times: pass all times at
        once.

        Args:
            t: a time, or an array of them in any order.

        Returns:
            The states, of shape (6,) for one time and (6, k) for k times.

        Raises:
            ValueError: if a time is negative, beyond the end, or not a number.
        """
        times = array("t", t)
        end = float(self.t[-1])
        flat = times.reshape(-1)
        # The end that was asked for may differ from a whole number of steps by 1e-9 of itself.
        outside = flat[~((flat >= 0.0) & (flat <= end * (1 + 2e-9)))]
        if outside.size:
            raise ValueError(f"t must be from 0 to {end}, got {outside[0]}")
        flat = np.minimum(flat, end)
        order = np.argsort(flat, kind="stable")
        top, setting = self._run
        states = np.empty((6, flat.size))
        states[:, order] = top.states_at(setting, flat[order].tolist()).T
        return states.reshape((6, *times.shape))

    def __repr__(self) -> str:
        span = f"t = {self.t[0]:g} ... {self.t[-1]:g}, {self.t.size} samples"
        deviations = ", ".join(f"{symbol} {self.deviation(symbol):.1e}" for symbol in self.invariants)
        return f"<Solution: {span}; {self.message}; deviations: {deviations}>"


@dataclass(frozen=True, eq=False, repr=False)
class Crossings:
    """The points where a run crosses a surface.

    Attributes:
        t: the times of the n crossings, s, shape (n,).
        y: the states there, shape (6, n).
    """

    t: Floats
    y: Floats

    def __repr__(self) -> str:
        return f"<Crossings: {self.t.size} points>"
