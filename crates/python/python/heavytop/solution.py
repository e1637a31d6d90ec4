"""The results of a run."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._native import IntegrationError

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Solution:
    """A run of a top, with the names of SciPy's `solve_ivp`.

    Attributes:
        t: the times of the n samples, shape (n,).
        y: the states (Pi1, Pi2, Pi3, Gamma1, Gamma2, Gamma3), shape (6, n).
        invariants: the conserved quantities of the top by symbol, each of shape (n,): the energy "h", the Casimirs
            "f1" = |Gamma|^2 and "f2" = Pi.Gamma, and "f3", "K" or "G" of an integrable top.
        attitude: the unit quaternions (w, x, y, z) of the attitude, shape (4, n), or None if they were not asked for.
            They rotate the body frame to the spatial frame.
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
    _states_at: Callable[[Floats], Floats]

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

    def drift(self, name: str) -> float:
        """Returns the largest |f(t) - f(0)| of the invariant with this symbol."""
        values = self.invariants[name]
        return float(np.abs(values - values[0]).max())

    def sol(self, t: ArrayLike) -> Floats:
        """Returns the states at any times between 0 and the end of the run.

        A state is that of a step of partial size from the last whole step before it. It is as accurate as the run, and
        has its conserved quantities. The run is made again up to the last of the times.

        Args:
            t: a time, or an array of them in any order.

        Returns:
            The states, of shape (6,) for one time and (6, k) for k times.

        Raises:
            ValueError: if a time is negative, beyond the end, or not a number.
        """
        times = np.asarray(t, dtype=float)
        end = float(self.t[-1])
        flat = times.reshape(-1)
        outside = flat[~((flat >= 0.0) & (flat <= end))]
        if outside.size:
            raise ValueError(f"t must be between 0 and {end}, got {outside[0]}")
        order = np.argsort(flat, kind="stable")
        states = np.empty((6, flat.size))
        states[:, order] = self._states_at(flat[order]).T
        return states.reshape((6, *times.shape))

    def __repr__(self) -> str:
        span = f"t = {self.t[0]:g} ... {self.t[-1]:g}, {self.t.size} samples"
        drifts = ", ".join(f"{name} {self.drift(name):.1e}" for name in self.invariants)
        return f"<Solution: {span}; {self.message}; drift: {drifts}>"


@dataclass(frozen=True)
class Crossings:
    """The points where a run crosses a plane.

    Attributes:
        t: the times of the n crossings, shape (n,).
        y: the states there, shape (6, n).
    """

    t: Floats
    y: Floats
