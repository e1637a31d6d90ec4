"""Directions by angles."""

from __future__ import annotations

import math
from typing import NamedTuple, Union

import numpy as np

from .arguments import real
from .solution import Floats

UNITS = (("degrees", math.pi / 180), ("deg", math.pi / 180), ("\N{DEGREE SIGN}", math.pi / 180), ("rad", 1.0))


class AngleRange(NamedTuple):
    """The range of an angle, in words and in radians; the ends in words, and whether they belong to it."""

    words: str
    least: float
    greatest: float
    ends: tuple[str, str]
    is_closed: bool

    def contains(self, radians: float) -> bool:
        """Returns whether an angle is in the range."""
        if self.is_closed:
            return self.least <= radians <= self.greatest
        return self.least < radians < self.greatest


INCLINATION = AngleRange("from 0 to pi", 0.0, math.pi, ("0", "pi"), True)

AZIMUTH = AngleRange("between -2 pi and 2 pi", -2 * math.pi, 2 * math.pi, ("-2 pi", "2 pi"), False)

LEAST_DEGREES = 4.0
"""A number below it is no angle in degrees, but one in radians on the wrong side, or half a turn with too few digits."""


def angle(name: str, value: Union[float, str], bounds: AngleRange) -> float:
    """Returns an angle in radians, within bounds."""
    if isinstance(value, str):
        number, unit = with_unit(name, value)
        # 180 degrees are pi, to the last bit.
        radians = number / 180 * math.pi if unit != 1.0 else number
        if bounds.contains(radians):
            return radians
        raise ValueError(f"{name} must be {bounds.words}, got {value!r}; write an angle {bounds.words}")
    radians = real(name, value)
    if bounds.contains(radians):
        return radians
    is_degrees = abs(radians) >= LEAST_DEGREES and bounds.contains(radians / 180 * math.pi)
    repair = f'write "{radians:.15g} deg"' if is_degrees else f'write an angle {bounds.words}, such as "30 deg"'
    beyond = bounds.ends[0 if radians < 0 else 1]
    raise ValueError(f"{name} is in radians, {bounds.words}, and {radians:.15g} is beyond {beyond}; {repair}")


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
        ValueError: if an angle is out of its range. If a number beyond it may have been meant in degrees, the message says
            how to write these.

    Example:
        >>> vertical("60 deg", "90 deg").round(12)
        array([0.       , 0.8660254, 0.5      ])
        >>> vertical(60)
        Traceback (most recent call last):
        ...
        ValueError: inclination is in radians, from 0 to pi, and 60 is beyond pi; write "60 deg"
    """
    i = angle("inclination", inclination, INCLINATION)
    a = angle("azimuth", azimuth, AZIMUTH)
    return np.array([math.sin(i) * math.cos(a), math.sin(i) * math.sin(a), math.cos(i)])
