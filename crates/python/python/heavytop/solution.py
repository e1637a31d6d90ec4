"""The results of runs."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple, Optional, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._native import IntegrationError
from .accuracy import Balance, Check
from .arguments import array

Floats = NDArray[np.float64]

NEVER = 2**63 - 1
"""The number of steps after which a run keeps a sample if only its events are asked for."""


class Native(Protocol):
    """The native part of a top or a system."""

    def states_at(self, setting: Any, times: list[float]) -> Floats: ...
    def invariant_values(self, states: Floats) -> Floats: ...

    def check(self, setting: Any, steps: int) -> tuple[float, Optional[float]]: ...


class Run(NamedTuple):
    """What a run is made from: enough to make it again. The setting is the start, the step and the method."""

    native: Native
    setting: Any
    names: Mapping[str, slice]

    def steps(self, times: Floats) -> int:
        """Returns the number of steps up to the last of the times; a step of partial size counts as one."""
        return math.ceil(self._length(times)) if len(times) else 0

    def whole_steps(self, times: Floats) -> int:
        """Returns the number of whole steps up to the last of the times."""
        return math.floor(self._length(times)) if len(times) else 0

    def _length(self, times: Floats) -> float:
        """Returns the last of the times in steps: a whole number if it is one up to 1e-9 of itself, as ends may be."""
        length = float(times[-1]) / float(self.setting[1])
        return round(length) if abs(length - round(length)) <= 1e-9 * length else length


@dataclass(frozen=True, eq=False, repr=False)
class Solution:
    """A run, with the names of SciPy's `solve_ivp`.

    Attributes:
        t: the times of the n samples, shape (n,).
        y: the states, shape (d, n): for a top (Pi1, Pi2, Pi3, Gamma1, Gamma2, Gamma3). `run["Gamma"]` are the rows of a
            vector, and `run["Gamma3"]` is one row.
        invariants: the invariants by symbol, each of shape (n,): those that are conserved from the start; for a system h and the
            Casimirs, by their formulas.
        attitude: the unit quaternions (w, x, y, z) of the attitude of a top, shape (4, n), or None if they were not asked
            for. They rotate the body frame to the spatial frame.
        t_events: for each event the times of its zeros, or None if there are no events.
        y_events: for each event the states at its zeros, shape (k, d), or None.
        iterations: the number of iterations of the stage equations in all steps; 0 if the times were given.
        status: 0 if the run reached its end, 1 if an event ended it, -1 if it failed: a step had no result, or an invariant
            or an event had no finite value.
        success: whether the run did not fail. If it did, the samples before are there.
        message: the reason for the status, in words.
        error: the exception of the step that failed, or None.
        error_estimate: the estimated error of the states, to two digits: the largest over the run, of each vector or scalar
            of the coordinates relative to its size. 1 means that nothing is right. It is found by a repetition of the
            beginning of the run with half the step; None if that failed, or was not asked for. A step of partial size, as one that ends at an
            event, is repeated as a whole one. With noise it is that of the path.
        kept: the symbols of the invariants that the motion keeps: all, unless something drives, damps, shakes or forces the system.
    """

    t: Floats
    y: Floats
    invariants: Mapping[str, Floats]
    attitude: Optional[Floats]
    t_events: Optional[list[Floats]]
    y_events: Optional[list[Floats]]
    iterations: int
    error: Optional[IntegrationError]
    error_estimate: Optional[float]
    kept: tuple[str, ...]
    _ended_by: Optional[int] = field(repr=False)
    _run: Run = field(repr=False)

    def __getitem__(self, name: str) -> Floats:
        """Returns the rows of a coordinate or of a vector of coordinates, by name."""
        return rows_of(self._run.names, self.y, name)

    @property
    def Pi(self) -> Floats:
        """The angular momentum in the body frame, shape (3, n)."""
        return self["Pi"]

    @property
    def Gamma(self) -> Floats:
        """The vertical in the body frame, shape (3, n)."""
        return self["Gamma"]

    @property
    def success(self) -> bool:
        """Whether the run did not fail."""
        return self.error is None

    @property
    def status(self) -> int:
        """0 if the run reached its end, 1 if an event ended it, -1 if it failed."""
        if self.error is not None:
            return -1
        return 0 if self._ended_by is None else 1

    @property
    def message(self) -> str:
        """The reason for the status, in words."""
        if self.error is not None:
            return str(self.error)
        return "every step was made" if self._ended_by is None else f"event {self._ended_by} ended the run"

    def deviation(self, symbol: str, *, relative: bool = False) -> float:
        """Returns the largest |f(t) - f(0)| of an invariant, over all samples.

        f(0) is the value at the start of the run, whether there is a sample of it or not.

        Args:
            symbol: the symbol of the invariant, such as "h".
            relative: whether to divide it by |f(0)|.
        """
        if symbol not in self.invariants:
            raise ValueError(f"the invariants are {', '.join(self.invariants)}, got {symbol!r}")
        start = np.array([self._run.setting[0]])
        first = float(self._run.native.invariant_values(start)[0, list(self.invariants).index(symbol)])
        with np.errstate(all="ignore"):
            largest = float(np.abs(self.invariants[symbol] - first).max())
            return largest / np.float64(abs(first)) if relative else largest

    def check(self) -> Check:
        """Makes the whole run again with half the step and with twice the step, and returns its error and its order.

        The error is that at the end, relative to the state, as for `error_estimate`. A run that ends between two steps, as at
        an event, is checked up to the last whole step; `t` of the result is its time. If the order is near that of the method
        the steps are short enough; if it is far below, they are not, or the motion is chaotic and the run too long. The check
        takes three and a half times as long as the run.

        Raises:
            ValueError: if the run ends within its first step.
            IntegrationError: if a step fails.
            ArithmeticError: if the derivative of the Hamiltonian has no value during the run.

        Example:
            >>> from heavytop import Top
            >>> run = Top.kovalevskaya().solve([2, 3, 4], [0.6, 0, 0.8], step=0.1, end=10)
            >>> check = run.check()
            >>> check.error < 1e-6, abs(check.order - 8) < 0.3
            (True, True)
        """
        steps, step = self._run.whole_steps(self.t), float(self._run.setting[1])
        if steps == 0:
            raise ValueError(f"a run must have a whole step to be checked, and it ends at {self.t[-1]}, with a step of {step}")
        return Check(*self._run.native.check(self._run.setting, steps), steps * step)

    def balance(self) -> dict[str, Balance]:
        """Makes the run again, and returns how the forces changed h and each Casimir, by symbol.

        A torque F changes a Casimir C at the rate dC.F, and a drive, damping, a torque and the time change h at the rate
        dh.dmu/dt + dh/dt. `supplied` is the integral of this rate by quadrature along the run, `change` is the change, and `defect` the
        largest difference of both: the error of the method, which vanishes with its order. It takes nine times as long as the run. A run
        that ends between two steps, as at an event, is measured up to the last whole step.

        Raises:
            ValueError: if there are no such forces, there is noise, the run is one of arrays, or ends within its first step.
            IntegrationError: if a step fails, or a rate has no value.

        Example:
            A ball in a viscous fluid, whose energy decays as exp(-2 k t):

            >>> from heavytop import System
            >>> ball = System("so(3)", "|Pi|^2/4", torque=lambda x: -0.1 * x.Pi)
            >>> h = ball.solve([0.6, 0, 0.8], step=0.1, end=5).balance()["h"]
            >>> bool(abs(h.supplied - 0.25 * np.expm1(-1)) < 1e-12), h.defect < 1e-12
            (True, True)
        """
        steps, native = self._run.whole_steps(self.t), self._run.native
        if steps == 0:
            raise ValueError(f"a run must have a whole step for a balance, and it ends at {self.t[-1]}")
        if not isinstance(native, _native.System):
            raise ValueError("a balance is of a run of a system by formula with forces, and without noise")
        found = native.balances(self._run.setting, steps)
        return {symbol: Balance(*numbers) for symbol, numbers in zip(self.invariants, found)}

    def sol(self, t: ArrayLike) -> Floats:
        """Returns the states at any times from 0 to the end of the run, which is before 0 if the run was backward.

        A state is that of a step of partial size from the whole step before it. It has the order of the method, and
        conserves what the method conserves. Each call makes the run again, up to the last of the times: pass all times at
        once.

        Args:
            t: a time, or an array of them in any order.

        Returns:
            The states, of shape (d,) for one time and (d, k) for k times.

        Raises:
            ValueError: if a time is not between 0 and the end, or not a number.
        """
        times = array("t", t)
        end = float(self.t[-1])
        flat = times.reshape(-1)
        # How far the times lie along the run, which may be backward.
        along = np.copysign(1.0, end) * flat
        # The end that was asked for may differ from a whole number of steps by 1e-9 of itself.
        outside = flat[~((along >= 0.0) & (along <= abs(end) * (1 + 2e-9)))]
        if outside.size:
            raise ValueError(f"t must be from 0 to {end}, got {outside[0]}")
        flat = np.where(along > abs(end), end, flat)
        order = np.argsort(np.abs(flat), kind="stable")
        states = np.empty((self.y.shape[0], flat.size))
        states[:, order] = self._run.native.states_at(self._run.setting, flat[order].tolist()).T
        return states.reshape((self.y.shape[0], *times.shape))

    def __repr__(self) -> str:
        span = f"t = {self.t[0]:g} ... {self.t[-1]:g}, {self.t.size} samples"
        deviations = ", ".join(f"{symbol} {self.deviation(symbol):.1e}" for symbol in self.kept)
        changed = [symbol for symbol in self.invariants if symbol not in self.kept]
        changes = ", ".join(f"{symbol} {self.deviation(symbol):.1e}" for symbol in changed)
        texts = [f"deviations: {deviations}"] if self.kept else []
        texts += [f"changes: {changes}"] if changed else []
        return f"<Solution: {span}; {self.message}; {'; '.join(texts)}>"


def solution(
    columns: _native.Recorded,
    symbols: tuple[Sequence[str], Sequence[str]],
    run: Run,
    error_estimate: Optional[float],
    *,
    has_events: bool,
) -> Solution:
    """Returns the solution of the columns of a run, with the symbols of its invariants, and of those that it keeps."""
    values, attitudes = columns.values, columns.attitudes
    return Solution(
        t=columns.times,
        y=columns.states.T,
        invariants={symbol: values[:, i] for i, symbol in enumerate(symbols[0])},
        attitude=attitudes.T if len(attitudes) else None,
        t_events=[times for times, _ in columns.events] if has_events else None,
        y_events=[states for _, states in columns.events] if has_events else None,
        iterations=columns.iterations,
        error=columns.failure,
        error_estimate=error_estimate,
        kept=tuple(symbols[1]),
        _ended_by=columns.ended_by,
        _run=run,
    )


def crossings(columns: _native.Recorded) -> Crossings:
    """Returns the points of the only event of a run.

    Raises:
        IntegrationError: if a step failed.
    """
    if columns.failure is not None:
        raise columns.failure
    (t, y) = columns.events[0]
    return Crossings(t, y.T)


def solution_at(
    times: Floats,
    states: Floats,
    invariants: Mapping[str, Floats],
    kept: Sequence[str],
    run: Run,
    error_estimate: Optional[float],
) -> Solution:
    """Returns the solution of states, as rows, at times."""
    return Solution(
        t=times,
        y=states.T,
        invariants=invariants,
        attitude=None,
        t_events=None,
        y_events=None,
        iterations=0,
        error=None,
        error_estimate=error_estimate,
        kept=tuple(kept),
        _ended_by=None,
        _run=run,
    )


def names_of_groups(groups: Iterable[tuple[str, int]]) -> dict[str, slice]:
    """Returns the places of coordinates, of vectors of them and of their components, from the dimensions of the vectors.

    The dimension 0 is that of a scalar.
    """
    names: dict[str, slice] = {}
    start = 0
    for name, dimension in groups:
        width = max(dimension, 1)
        names[name] = slice(start, start + width)
        separator = "_" if name[-1].isdigit() else ""
        for i in range(dimension):
            names[f"{name}{separator}{i + 1}"] = slice(start + i, start + i + 1)
        start += width
    return names


def rows_of(names: Mapping[str, slice], states: Floats, name: str) -> Floats:
    """Returns the rows of a coordinate or of a vector of coordinates, by name, from states in columns."""
    if name not in names:
        raise KeyError(f"the coordinates are {', '.join(names)}, got {name!r}")
    places = names[name]
    return states[places] if places.stop - places.start > 1 else states[places.start]


@dataclass(frozen=True, eq=False, repr=False)
class Crossings:
    """The points where a run crosses a surface.

    Attributes:
        t: the times of the n crossings, shape (n,).
        y: the states there, shape (d, n).
    """

    t: Floats
    y: Floats

    def __repr__(self) -> str:
        return f"<Crossings: {self.t.size} points>"
