"""How accurate runs are, and the warning about steps that are too long: one rule for all of them."""

from __future__ import annotations

import contextlib
import warnings
from collections.abc import Sequence
from typing import Any, NamedTuple, Optional, Protocol

import numpy as np
from numpy.typing import NDArray

from . import _native

SPREAD = 8
"""The number of many runs whose accuracy is measured, besides that of the fastest."""


MOST_TURN = 100.0
"""The largest angle by which a motion may turn in one step, rad: sixteen turns, as in the program."""


class Check(NamedTuple):
    """The error at the end of a run, relative to the state, and the order with which it converges.

    The order is None if the differences between the runs are round-off.
    """

    error: float
    order: Optional[float]


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
        text = warned[3] if count == 1 else f"of the run number {warned[0]}: {warned[3]}"
        warnings.warn(text, RuntimeWarning, stacklevel=stacklevel)
    return worst[2]


def members_of_tops(
    tops: Sequence[_native.Top], states: NDArray[np.float64], step: float, names: tuple[str, str, float]
) -> list[tuple[int, Measured, Any]]:
    """Returns the fastest of many runs of tops, and some others. States have the shape (6, n)."""
    count = states.shape[1]
    if len(tops) not in (1, count) or count == 0:
        return []
    momenta = states[:3].T
    parts = [momenta] if len(tops) == 1 else np.split(momenta, len(tops))
    turns = np.concatenate([top.angular_speeds(part) for top, part in zip(tops, parts)])
    finite = np.where(np.isfinite(turns), turns, -1.0)
    numbers = sorted({int(np.argmax(finite)), *spread(count)})
    return [(i, tops[min(i, len(tops) - 1)], (states[:, i].tolist(), step, names)) for i in numbers]


def members_of_system(
    system: _native.System, states: NDArray[np.float64], step: float, names: Any
) -> list[tuple[int, Measured, Any]]:
    """Returns some of many runs of a system. States have the shape (d, n)."""
    return [(i, system, (states[:, i].tolist(), step, names)) for i in spread(states.shape[1])]


def spread(count: int) -> list[int]:
    """Returns some of so many numbers, the first and the last among them."""
    return sorted({round(i) for i in np.linspace(0, count - 1, min(count, SPREAD))}) if count else []
