"""How accurate runs are, and the warning about steps that are too long: one rule for all of them."""

from __future__ import annotations

import contextlib
import warnings
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple, Optional, Protocol

import numpy as np
from numpy.typing import NDArray

from . import _native

SPREAD = 8
"""The number of many runs whose accuracy is measured, besides that of the fastest."""

Rates = Callable[[], Sequence[float]]
"""The fastest rates of the motion through many states."""


MOST_TURN = 100.0
"""The largest angle by which a motion may turn in one step, rad: sixteen turns, as in the program."""


class Check(NamedTuple):
    """The error at the end of a run, relative to the state, the order with which it converges, and the time of the error.

    The order is None if there is none to see: the run has a single step, the differences between the runs are round-off,
    or the run with twice the step fails.
    """

    error: float
    order: Optional[float]
    t: float


class Balance(NamedTuple):
    """How a quantity changed along a run, what the forces supplied of it, and the largest difference of both, which the method added."""

    change: float
    supplied: float
    defect: float


class Measured(Protocol):
    """The native part of a top or a system."""

    def accuracy(self, setting: Any, steps: int) -> tuple[float, Optional[float], Optional[str]]: ...


def warn_of_accuracy(native: Measured, setting: Any, steps: int, stacklevel: int) -> Optional[float]:
    """Returns the estimated error of a run, and warns if a step is too long or the error too large.

    Without steps there is no estimate, and the angle of a step alone decides.

    Raises:
        ValueError: if the motion turns by more than 100 rad in a step from its start.
    """
    # A run without steps has the angle at its start.
    angle, step = native.accuracy(setting, 0)[0], abs(setting[1])
    if angle > MOST_TURN:
        raise ValueError(f"a step of {step:g} s turns the motion by about {angle:.3e} rad; it must be at most {MOST_TURN:g}")
    _, error, warning = native.accuracy(setting, steps)
    if warning is not None:
        warnings.warn(warning, RuntimeWarning, stacklevel=stacklevel)
    return error


def warn_of_many(
    members: Sequence[tuple[int, Measured, Any]], steps: int, count: int, stacklevel: int
) -> Optional[float]:
    """Returns the largest estimated error of some of many runs, and warns of the worst of them.

    A member is the number of a run, the native part and the setting.
    """
    measured = []
    for number, native, setting in members:
        # A state from which there is no run is reported with the failures.
        with contextlib.suppress(ValueError):
            measured.append((number, *native.accuracy(setting, steps)))
    if not measured:
        return None
    worst = max(measured, key=lambda member: (member[2] or 0.0, member[1]))
    warned = worst if worst[3] is not None else next((m for m in measured if m[3] is not None), worst)
    if warned[3] is not None:
        text = warned[3] if count == 1 else f"run {warned[0]}: {warned[3]}"
        warnings.warn(text, RuntimeWarning, stacklevel=stacklevel)
    return worst[2]


def members_of_tops(
    tops: Sequence[_native.Top], states: NDArray[np.float64], step: float, names: tuple[str, str, float]
) -> list[tuple[int, Measured, Any]]:
    """Returns the fastest of many runs of tops, and some others. States have the shape (6, n)."""
    count = states.shape[1]
    if len(tops) not in (1, count) or count == 0:
        return []
    parts = [states.T] if len(tops) == 1 else np.split(states.T, count)

    def rates() -> list[float]:
        return [rate for top, part in zip(tops, parts) for rate in top.fastest_rates(part)]

    return [(i, tops[min(i, len(tops) - 1)], (states[:, i].tolist(), step, names)) for i in to_measure(count, rates)]


def members_of_system(
    system: _native.System, states: NDArray[np.float64], step: float, names: Any
) -> list[tuple[int, Measured, Any]]:
    """Returns the fastest of many runs of a system, and some others. States have the shape (d, n)."""
    numbers = to_measure(states.shape[1], lambda: system.fastest_rates(states.T))
    return [(i, system, (states[:, i].tolist(), step, names)) for i in numbers]


def to_measure(count: int, rates: Rates) -> list[int]:
    """Returns the number of the fastest of so many runs, and some others, the first and the last among them."""
    if count <= SPREAD:
        return list(range(count))
    # A state without a rate is no start of a run.
    known = np.nan_to_num(rates(), nan=-1.0, posinf=-1.0)
    return sorted({int(np.argmax(known)), *(round(i) for i in np.linspace(0, count - 1, SPREAD))})
