"""Arguments as numbers, or an error that names the argument, its value and its bound."""

from __future__ import annotations

import difflib
import math
from collections.abc import Sequence
from typing import Any, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray


def scalar(name: str, value: Any) -> float:
    """Returns a number, which may be NaN or infinite."""
    try:
        return float(array(name, value)[()])
    except (TypeError, ValueError):
        raise ValueError(f"{name} must be a number, got {value!r}") from None


def real(name: str, value: Any) -> float:
    """Returns a finite number."""
    number = scalar(name, value)
    if not math.isfinite(number):
        raise ValueError(f"{name} must be finite, got {number}")
    return number


def not_negative(name: str, value: Any) -> float:
    """Returns a finite number of at least 0, such as a friction, or a moment of inertia, which is 0 for a thin rod."""
    number = scalar(name, value)
    if not 0 <= number < math.inf:
        raise ValueError(f"{name} must be 0 or a positive number, it is {number:g}")
    return number


def positive(name: str, value: Any) -> float:
    """Returns a positive number."""
    number = real(name, value)
    if number <= 0:
        raise ValueError(f"{name} must be positive, got {number}")
    return number


def course(step: Any, end: Any) -> tuple[float, float]:
    """Returns the step and the end of a run. Before 0 the end alone asks for a run backward in time."""
    step, end = real("step", step), real("end", end)
    for name, value in (("step", step), ("end", end)):
        if value == 0:
            raise ValueError(f"{name} must be different from 0, got {value}")
    if step < 0 < end:
        raise ValueError(f"end must be before 0 for a run backward in time, with a step of {step}, got {end}")
    return math.copysign(step, end), end


def count(name: str, value: Any, least: int) -> int:
    """Returns a whole number that is not below `least`."""
    number = real(name, value)
    if number != math.floor(number) or not least <= number < 2**63:
        raise ValueError(f"{name} must be a whole number from {least} on, got {value!r}")
    return int(number)


def flag(name: str, value: Any) -> bool:
    """Returns True or False."""
    if not isinstance(value, (bool, np.bool_)):
        raise ValueError(f"{name} must be True or False, got {value!r}")
    return bool(value)


def choice(name: str, value: Any, choices: Sequence[Any]) -> Any:
    """Returns one of the choices."""
    if isinstance(value, (str, int, float)) and value in choices:
        return value
    near = difflib.get_close_matches(str(value).lower(), list(map(str, choices)), n=1)
    hint = f"; did you mean {near[0]!r}?" if near else ""
    raise ValueError(f"{name} must be one of {', '.join(map(str, choices))}, got {value!r}{hint}")


NO_NUMBERS = (bool, np.bool_, str, bytes, type(None), type(np.ma.masked))
"""What NumPy would convert to a number, although it is none."""


def holds_numbers(values: Any) -> bool:
    """Returns whether all entries of an array, of nested lists or of a mixture of both are real numbers."""
    kind = values.dtype.kind if isinstance(values, (np.ndarray, np.generic)) else "O"
    if kind != "O":
        return kind in "iuf"
    # A list may hold what an array of its entries would convert.
    entries = np.asarray(values, dtype=object).flat
    return not any(isinstance(x, NO_NUMBERS) or isinstance(x, np.ndarray) and not holds_numbers(x) for x in entries)


def is_masked(values: Any) -> bool:
    """Returns whether there is a masked entry in an array, in nested sequences or in a mixture of both."""
    if isinstance(values, np.ndarray):
        return bool(np.ma.is_masked(values)) or values.dtype == object and any(map(is_masked, values.flat))
    is_sequence = isinstance(values, Sequence) and not isinstance(values, (str, bytes))
    return is_sequence and any(map(is_masked, values))


def array(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """Returns an array of real numbers."""
    if is_masked(values):
        raise ValueError(f"{name} must have no masked entries: fill them or leave them out")
    try:
        if not holds_numbers(values) or np.iscomplexobj(values):
            raise TypeError
        return np.asarray(values, dtype=float)
    except (TypeError, ValueError, OverflowError):
        raise ValueError(f"{name} must be an array of real numbers, got {values!r}") from None


def numbers(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """Returns a list of numbers, of any length."""
    found = array(name, values)
    if found.ndim != 1:
        raise ValueError(f"{name} must be one-dimensional, got the shape {found.shape}")
    return found


def vector(name: str, values: ArrayLike) -> list[float]:
    """Returns three finite numbers."""
    numbers = array(name, values)
    if numbers.shape != (3,):
        raise ValueError(f"{name} must have three components, got the shape {numbers.shape}")
    return [real(f"{name}[{i}]", x) for i, x in enumerate(numbers)]


def inertia_of_body(name: str, values: ArrayLike) -> Union[list[float], list[list[float]]]:
    """Returns three principal moments that are not negative, or the rows of a matrix of finite numbers."""
    numbers = array(name, values)
    if numbers.shape == (3, 3):
        return [[real(f"{name}[{i}][{j}]", x) for j, x in enumerate(row)] for i, row in enumerate(numbers)]
    return principal_moments(name, numbers)


def principal_moments(name: str, values: ArrayLike) -> list[float]:
    """Returns three moments that are not negative."""
    return [not_negative(f"{name}[{i}]", x) for i, x in enumerate(vector(name, values))]


def quaternion(values: ArrayLike, vertical: Sequence[float]) -> list[float]:
    """Returns a unit quaternion that rotates the direction of Gamma to (0, 0, 1)."""
    numbers = array("attitude0", values)
    if numbers.shape != (4,) or not np.isfinite(numbers).all():
        raise ValueError(f"attitude0 must be four finite numbers (w, x, y, z), got {values!r}")
    length = float(np.linalg.norm(numbers))
    if abs(length - 1) > 1e-9:
        raise ValueError(f"attitude0 must be a unit quaternion, to within 1e-9, got the length {length}")
    numbers = numbers / length
    gamma = np.array(vertical) / max(math.hypot(*vertical), np.finfo(float).tiny)
    axis = numbers[1:]
    across = np.cross(axis, gamma)
    turned = gamma + 2 * numbers[0] * across + 2 * np.cross(axis, across)
    if math.dist(turned, (0, 0, 1)) > 1e-9:
        raise ValueError(
            "attitude0 must rotate Gamma to the vertical (0, 0, 1), to within 1e-9, but rotates it to "
            f"({', '.join(f'{x:.6g}' for x in turned)})"
        )
    return [float(x) for x in numbers]


def states(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """Returns states of shape (6, n)."""
    numbers = array(name, values)
    if numbers.ndim != 2 or numbers.shape[0] != 6:
        raise ValueError(f"{name} must have the shape (6, n), got {numbers.shape}")
    return numbers
