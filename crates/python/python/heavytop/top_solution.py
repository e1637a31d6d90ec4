"""Runs of tops, and reports on them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Optional

import numpy as np

from ._native import Top
from .solution import Floats, Solution

QUANTITIES = ("Omega", "euler_angles", "kinetic", "potential", "spatial_momentum")
"""What a run of a top tells besides its state."""

ANGLES_OF_EULER = ("phi", "theta", "psi")


class TopSolution(Solution):
    """A run of a top, which tells more by name than its coordinates.

    `run["Omega"]` is the angular velocity in the body frame (rad/s), of shape (3, n); `run["kinetic"]` and `run["potential"]`
    are the energies (J), of shape (n,). With the attitude there are `run["spatial_momentum"]`, the angular momentum in
    the spatial frame, and `run["euler_angles"]`, of shape (3, n), which are `run["phi"]`, `run["theta"]` and `run["psi"]` (rad):
    the rotation to the spatial frame is R3(phi) R1(theta) R3(psi).
    """

    def __getitem__(self, name: str) -> Floats:
        """Returns the rows of a coordinate, a vector or a quantity of the top, by name."""
        if name in ANGLES_OF_EULER:
            angles: Floats = self["euler_angles"][ANGLES_OF_EULER.index(name)]
            return angles
        if name not in QUANTITIES:
            if name not in self._run.names:
                names = ", ".join([*self._run.names, *QUANTITIES, *ANGLES_OF_EULER])
                raise KeyError(f"there are {names}, got {name!r}")
            return super().__getitem__(name)
        native = self._run.native
        assert isinstance(native, Top)
        attitude = np.full((4, self.t.size), np.nan) if self.attitude is None else self.attitude
        if self.attitude is None and name in ("euler_angles", "spatial_momentum"):
            raise ValueError(f"{name} needs the attitude: write attitude=True in solve")
        values = native.quantity(name.replace("_", "-"), np.ascontiguousarray(self.y.T), np.ascontiguousarray(attitude.T)).T
        return values if len(values) > 1 else values[0]


@dataclass(frozen=True)
class Measured:
    """A number of a report.

    Attributes:
        value: the measured number, or None if the run does not show it.
        unit: its unit.
        formulas: what textbooks say, by formula.
    """

    value: Optional[float]
    unit: str
    formulas: Mapping[str, float]


@dataclass(frozen=True)
class SteadyRotation:
    """A steady rotation of a top about the vertical.

    Attributes:
        vertical: the vertical in the body; of a body without weight the direction of its angular momentum.
        rate: the angular velocity about it, rad/s.
        energy: h, J.
        growth: the rate at which small disturbances grow, 1/s; 0 if they do not.
        is_circle: whether it is one of a circle about an axis of symmetry.
        nearest: the least angle between the vertical of the run and that of the rotation, rad.
    """

    vertical: Floats
    rate: float
    energy: float
    growth: float
    is_circle: bool
    nearest: float


@dataclass(frozen=True)
class Report:
    """The rates and turning points of a top, beside the formulas of textbooks. `print(report)` is a table.

    Attributes:
        kind: what kind of top it is, and about which line its angles are.
        numbers: the numbers by name, such as "precession, mean dφ/dt".
        steady: the steady rotations with the same vertical angular momentum; none of Lagrange's top.
    """

    kind: str
    numbers: Mapping[str, Measured]
    steady: tuple[SteadyRotation, ...]
    _text: str = field(repr=False)

    def __str__(self) -> str:
        return self._text
