"""Functions for Hamiltonians and events that are written in Python: of numbers, of symbols, and of NumPy arrays of both."""

from __future__ import annotations

from typing import Any

import numpy as np

__all__ = [
    "arccos",
    "arcsin",
    "arctan",
    "atan2",
    "cbrt",
    "cos",
    "cosh",
    "cross",
    "dot",
    "exp",
    "hypot",
    "log",
    "log10",
    "norm",
    "sin",
    "sinh",
    "sqrt",
    "tan",
    "tanh",
    "where",
]


def sqrt(x: Any) -> Any:
    """Returns the square root of x."""
    return np.sqrt(x)


def exp(x: Any) -> Any:
    """Returns the exponential of x."""
    return np.exp(x)


def log(x: Any) -> Any:
    """Returns the natural logarithm of x."""
    return np.log(x)


def sin(x: Any) -> Any:
    """Returns the sine of x."""
    return np.sin(x)


def cos(x: Any) -> Any:
    """Returns the cosine of x."""
    return np.cos(x)


def tan(x: Any) -> Any:
    """Returns the tangent of x."""
    return np.tan(x)


def sinh(x: Any) -> Any:
    """Returns the hyperbolic sine of x."""
    return np.sinh(x)


def cosh(x: Any) -> Any:
    """Returns the hyperbolic cosine of x."""
    return np.cosh(x)


def tanh(x: Any) -> Any:
    """Returns the hyperbolic tangent of x."""
    return np.tanh(x)


def atan2(y: Any, x: Any) -> Any:
    """Returns the angle of the point (x, y)."""
    return np.arctan2(y, x)


def cbrt(x: Any) -> Any:
    """Returns the cube root of x, with the sign of x."""
    return np.cbrt(x)


def log10(x: Any) -> Any:
    """Returns the decadic logarithm of x."""
    return np.log10(x)


def arcsin(x: Any) -> Any:
    """Returns the angle in [-pi/2, pi/2] whose sine is x."""
    return np.arcsin(x)


def arccos(x: Any) -> Any:
    """Returns the angle in [0, pi] whose cosine is x."""
    return np.arccos(x)


def arctan(x: Any) -> Any:
    """Returns the angle in (-pi/2, pi/2) whose tangent is x."""
    return np.arctan(x)


def hypot(x: Any, y: Any) -> Any:
    """Returns the length of the vector (x, y)."""
    return np.hypot(x, y)


def where(condition: Any, x: Any, y: Any) -> Any:
    """Returns x in states where the condition, such as `state.Pi1 > 0`, holds, and y in others."""
    return np.where(condition, x, y)


def dot(a: Any, b: Any) -> Any:
    """Returns the inner product of two vectors."""
    return np.dot(a, b)


def cross(a: Any, b: Any) -> Any:
    """Returns the cross product of two vectors with three components."""
    return np.cross(a, b)


def norm(a: Any) -> Any:
    """Returns the length of a vector."""
    return np.sqrt(np.dot(a, a))
