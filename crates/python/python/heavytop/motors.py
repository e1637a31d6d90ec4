"""The torques of motors."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Union

from numpy.typing import ArrayLike

Motor = Union[float, str, tuple[ArrayLike, ArrayLike, str]]
"""The torque of a motor, N m: a number, a formula, or a table: times, values, and the interpolation between them."""


def formulas_of_motors(name: str, motors: Sequence[Motor], forces: Mapping[str, Any]) -> tuple[list[Union[float, str]], dict[str, Any]]:
    """Returns a number or a formula for each motor, and the forces with the tables among their inputs, as `motor_1` and so on.

    Args:
        name: what the motors are, in messages.
        motors: the torques.
        forces: the arguments of `System`.
    """
    tables: dict[str, Motor] = {}
    formulas: list[Union[float, str]] = []
    for k, motor in enumerate(motors, 1):
        if callable(motor):
            raise ValueError(f"{name}[{k - 1}] must be a number, a formula or a table, got {motor!r}; write a function as torque of System")
        if isinstance(motor, (tuple, list)):
            tables[f"motor_{k}"] = motor
            formulas.append(f"motor_{k}")
        else:
            formulas.append(motor)
    given = forces.get("inputs") or {}
    for table in tables:
        if table in given:
            raise ValueError(f"inputs[{table!r}] has the name of the table of a motor: choose another name")
    return formulas, {**forces, "inputs": {**given, **tables}}
