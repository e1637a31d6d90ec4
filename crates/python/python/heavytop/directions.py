"""Directions by angles."""

from __future__ import annotations

import math
from typing import Union

import numpy as np

from .arguments import real
from .solution import Floats

UNITS = (("degrees", math.pi / 180), ("deg", math.pi / 180), ("\N{DEGREE SIGN}", math.pi / 180), ("rad", 1.0))


def angle(name: str, value: Union[float, str], bounds: tuple[str, float, float, bool]) -> float:
    """Returns an angle in radians, within bounds: their words, the least and the greatest, and whether these belong to it."""
    words, least, greatest, is_closed = bounds
    if isinstance(value, str):
        number, unit = with_unit(name, value)
    else:
        number, unit = real(name, value), 1.0
    radians = number / 180 * math.pi if unit != 1.0 else number
    is_within = least <= radians <= greatest if is_closed else least < radians < greatest
    if is_within:
        return radians
    if isinstance(value, str):
        raise ValueError(f"{name} must be {words}, got {value!r}")
    raise ValueError(f'{name} is in radians, {words}, and {number:g} is beyond it; write "{number:g} deg"')


def with_unit(name: str, text: str) -> tuple[float, float]:
    """Returns the number and the unit of a text."""
    for unit, size in UNITS:
        if text.strip().endswith(unit):
            try:
                number = float(text.strip()[: -len(unit)])
            except ValueError:
                break
            if math.isfinite(number):
                return number, size
    raise ValueError(f'{name} needs a number and deg or rad, as in "30 deg", got {text!r}')


def vertical(inclination: Union[float, str], azimuth: Union[float, str] = 0.0) -> Floats:
    """Returns the vertical Gamma = (sin i cos a, sin i sin a, cos i), a unit vector in the body frame.

    Args:
        inclination: the angle i from the third axis to Gamma: a number of radians from 0 to pi, or a text such as "30 deg".
        azimuth: the angle a of Gamma about the third axis, from the first towards the second: a number of radians between
            -2 pi and 2 pi, or a text.

    Raises:
        ValueError: if an angle is out of its range. A number beyond it was meant in degrees, which need their unit.

    Example:
        >>> vertical("60 deg", "90 deg").round(12)
        array([0.       , 0.8660254, 0.5      ])
        >>> vertical(60)
        Traceback (most recent call last):
        ...
        ValueError: inclination is in radians, from 0 to pi, and 60 is beyond it; write "60 deg"
    """
    i = angle("inclination", inclination, ("from 0 to pi", 0.0, math.pi, True))
    a = angle("azimuth", azimuth, ("between -2 pi and 2 pi", -2 * math.pi, 2 * math.pi, False))
    return np.array([math.sin(i) * math.cos(a), math.sin(i) * math.sin(a), math.cos(i)])
