"""The warning about steps that are too long for every method."""

from __future__ import annotations

import warnings
from collections.abc import Sequence

import numpy as np

from . import _native
from .solution import Floats

LONG_STEP = 2.0


def warn_of_long_step(tops: Sequence[_native.Top], momenta: Floats, step: float, stacklevel: int) -> None:
    """Warns if a body turns by more than two radians in the first step.

    The momenta Pi have the shape (n, 3), with one top for all of them or for each.
    """
    if len(tops) not in (1, momenta.shape[0]) or not momenta.size:
        return
    parts = [momenta] if len(tops) == 1 else np.split(momenta, len(tops))
    turns = abs(step) * np.concatenate([top.angular_speeds(part) for top, part in zip(tops, parts)])
    most = int(np.argmax(turns))
    turn = float(turns[most])
    if turn > LONG_STEP:
        which = "the body" if len(turns) == 1 else f"the body number {most}"
        text = f"{which} turns by {turn:.3g} rad in the first step: a step of {abs(step) / turn:.3g} turns it by 1 rad"
        warnings.warn(text, RuntimeWarning, stacklevel=stacklevel)
