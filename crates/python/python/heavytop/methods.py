"""The formulations and schemes of runs."""

from __future__ import annotations

from typing import Any

from .arguments import choice, real

FORMULATIONS = ("collective", "reduced", "direct", "splitting")
"""Where a scheme is applied; `Top.solve` describes them."""

SCHEMES = (
    "implicit-midpoint",
    "spherical-midpoint",
    "gauss-4",
    "gauss-6",
    "gauss-8",
    "gauss-10",
    "gauss-12",
    "gauss-16",
    "explicit-midpoint",
    "rk4",
    "symplectic-euler",
    "stormer-verlet",
    "lobatto-iiia-iiib-4",
    "strang",
    "yoshida-4",
    "suzuki-4",
    "yoshida-6",
    "kahan-li-6",
    "kahan-li-8",
)
"""The one-step methods; `Top.solve` describes them."""

MOST_TOLERANCE = 1e-3


def method(formulation: Any, scheme: Any, tolerance: Any) -> tuple[str, str, float]:
    """Returns the names of a method, and the tolerance of its stage equations."""
    return choice("formulation", formulation, FORMULATIONS), choice("scheme", scheme, SCHEMES), tolerance_of(tolerance)


def tolerance_of(value: Any) -> float:
    """Returns a tolerance of stage equations."""
    tolerance = real("tolerance", value)
    if not 0 <= tolerance <= MOST_TOLERANCE:
        raise ValueError(f"tolerance must be from 0 to {MOST_TOLERANCE}, got {tolerance}")
    return tolerance
