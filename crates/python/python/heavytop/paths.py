"""Means, errors, deviations and quantiles over many paths of a motion with noise."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple, Optional

import numpy as np
from numpy.typing import ArrayLike

from . import _native
from .accuracy import warn_of_accuracy
from .arguments import count, course, numbers
from .solution import Floats
from .system import System
from .system_description import State


class Statistics(NamedTuple):
    """The statistics of a quantity over paths, each of its shape.

    Attributes:
        mean: the mean.
        error: the standard error of the mean.
        deviation: the standard deviation of the quantity.
        quantiles: the estimated quantiles by their probabilities.
    """

    mean: Floats
    error: Floats
    deviation: Floats
    quantiles: Mapping[float, Floats]

    def _each(self, part: Callable[[Floats], Floats]) -> Statistics:
        quantiles = {p: part(values) for p, values in self.quantiles.items()}
        return Statistics(part(self.mean), part(self.error), part(self.deviation), quantiles)


@dataclass(frozen=True, eq=False, repr=False)
class PathStatistics:
    """The statistics of many paths of a motion with noise, at the times that are kept.

    Attributes:
        t: the times, shape (m,).
        paths: the number of paths.
        y: the statistics of the coordinates, each of shape (d, m). `found["Pi3"]` are those of one row, and `found["Pi"]` of those
            of a vector; of a system of arrays `found["S"]` are those of an array, of shape (m, ...), as of a run.
        invariants: the statistics of h and the Casimirs by symbol, each of shape (m,).
    """

    t: Floats
    paths: int
    y: Statistics
    invariants: Mapping[str, Statistics]
    _system: System = field(repr=False)

    def __getitem__(self, name: str) -> Statistics:
        """Returns the statistics of a coordinate, of a vector of them, or of an array, by name."""
        return self.y._each(lambda states: self._system._named(states, name))

    def __repr__(self) -> str:
        return f"<PathStatistics: {self.paths} paths, t = {self.t[0]:g} ... {self.t[-1]:g}, {self.t.size} times>"


def solve_paths(
    system: System,
    y0: Optional[State] = None,
    *,
    paths: int,
    step: float,
    end: float,
    every: int = 1,
    quantiles: ArrayLike = (),
    scheme: Optional[str] = None,
    formulation: Optional[str] = None,
    tolerance: float = 0.0,
) -> PathStatistics:
    """Follows many paths of a system with noise from one state, on all threads, and returns their statistics at each time.

    Path i has the number of the path that `noise` has, plus i; each is the run of `System.solve` on it. No path is kept: means and
    deviations are updated by Welford's method, and quantiles by the P2 algorithm, which estimates them. So the memory depends neither on
    the number of paths nor, but for the result, on the number of times. The results do not depend on the number of threads, and are those
    of the program's `heavytop ensemble`. Ctrl-C ends the call after the paths that are followed together, 256 at most.

    Args:
        system: a system with noise.
        y0: the state at t = 0, as for `System.solve`.
        paths: the number of paths, at least 2.
        step: the time step.
        end: the end: a multiple of the step, to within 1e-9 of itself.
        every: keep the statistics after each n-th step; those of the start and the end are always kept.
        quantiles: the probabilities of the quantiles, between 0 and 1.
        scheme: as for `System.solve`.
        formulation: as for it.
        tolerance: as for it. By "reduced" it is an error of the paths alone, and none of their Casimirs: 1e-6 is far below the error
            of means, and makes steps faster.

    Raises:
        ValueError: if an argument is out of its range, the system has no noise, or the numbers that are kept, times times quantities,
            are more than two millions.
        IntegrationError: if a step fails; the message names the path.

    Warns:
        RuntimeWarning: if the noise turns the state, or the motion itself turns, too far in a step.

    Example:
        A spin at a temperature. In the limit of long times the mean of Pi3 is coth x - 1/x with x = 1/kT:

        >>> warm = System("so(3)", "-Pi3", damping=1, noise={"temperature": 0.5})
        >>> found = solve_paths(warm, [1, 0, 0], paths=1000, step=0.1, end=6, every=10, quantiles=[0.05, 0.95])
        >>> found
        <PathStatistics: 1000 paths, t = 0 ... 6, 7 times>
        >>> pi3 = found["Pi3"]
        >>> bool(abs(pi3.mean[-1] - (1 / np.tanh(2) - 1 / 2)) < 4 * pi3.error[-1] < 0.1)
        True
        >>> bool(pi3.quantiles[0.05][-1] < pi3.mean[-1] < pi3.quantiles[0.95][-1])
        True
    """
    if not isinstance(system, System):
        raise ValueError(f"paths are of a system with noise, got {system!r}")
    step, end = course(step, end)
    asked = numbers("quantiles", quantiles).tolist()
    extent = (end, count("every", every, 1), count("paths", paths, 2))
    run = system._run(y0, step, (formulation, scheme, tolerance))
    warn_of_accuracy(system._system, run.setting, 0, 3)
    times, values = _native.statistics_of_paths(system._system, run.setting, extent, asked)
    every_kind = np.moveaxis(values.reshape(len(times), -1, 3 + len(asked)), 0, -1)

    def of(columns: Any) -> Statistics:
        mean, error, deviation, *others = np.moveaxis(every_kind[columns], -2, 0)
        return Statistics(mean, error, deviation, dict(zip(asked, others)))

    invariants = {symbol: of(system.dimension + i) for i, symbol in enumerate(system.invariants)}
    return PathStatistics(np.array(times), extent[2], of(slice(system.dimension)), invariants, system)
