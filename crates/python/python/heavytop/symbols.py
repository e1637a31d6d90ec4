"""The symbols of functions that are traced: called once, and computed in Rust from then on."""

from __future__ import annotations

import operator
from collections.abc import Sequence
from typing import Any, NoReturn

import numpy as np

Part = tuple[str, float, int, int, int]
"""An operation, a number, and the places of the parts that it combines."""

BRANCH = (
    "{what} of a symbol: the function is called once, with symbols instead of numbers, so that it cannot branch on the "
    "state. Write numpy.where(x.Pi1 > 0, a, b) instead of a branch; max(a, b) is numpy.where(a > b, a, b)"
)

NUMBER = (
    "a symbol is no number: the function is called once, with symbols. Use the functions of numpy or of heavytop.functions "
    "instead of those of math, such as numpy.sin(x.Pi1)"
)

CONDITION = "it is the condition of numpy.where, as in numpy.where(x.Pi1 > 0, a, b)"

FIXED = "an array of numbers cannot become one of symbols: write a = a + x.Pi instead of a += x.Pi"


class Trace:
    """The parts of a function that is being traced, each once."""

    def __init__(self) -> None:
        self.parts: list[Part] = []
        self._places: dict[Part, int] = {}

    def add(self, operation: str, number: float = 0.0, first: int = 0, second: int = 0, third: int = 0) -> Symbol:
        """Returns the symbol of a part, which is added if it is new."""
        part = (operation, number, first, second, third)
        place = self._places.setdefault(part, len(self.parts))
        if place == len(self.parts):
            self.parts.append(part)
        return Symbol(self, place)


class Symbol:
    """A scalar of a function that is being traced: a coordinate, or what the function makes of coordinates.

    It has the operators +, -, *, / and **, abs(), and the functions of NumPy sqrt, cbrt, exp, log, log10, sin, cos, tan,
    arcsin, arccos, arctan, arctan2, hypot, sinh, cosh and tanh. Arrays of symbols are NumPy arrays, with `@`, `numpy.dot`,
    `numpy.cross` and `numpy.linalg.norm`. A symbol has no value: `if` or float() is a TypeError. A comparison with <, <=, >
    or >= is the condition of `numpy.where`, which gives one of two formulas in each state.
    """

    __slots__ = ("_place", "_trace")

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **kwargs: Any) -> Any:
        """Applies a function of NumPy to symbols and to numbers, in any order."""
        return applied(ufunc, method, inputs, kwargs)

    def __init__(self, trace: Trace, place: int) -> None:
        self._trace = trace
        self._place = place

    def _part(self, other: Any) -> Any:
        """Returns a symbol or number as a symbol of this trace, or NotImplemented."""
        if isinstance(other, Symbol):
            if other._trace is not self._trace:
                raise TypeError("symbols of two functions meet: a symbol is valid only while its own function is traced")
            return other
        if isinstance(other, (bool, np.bool_, np.ndarray, str)):
            return NotImplemented
        try:
            return self._trace.add("number", float(other))
        except (TypeError, ValueError):
            return NotImplemented

    def _binary(self, operation: str, other: Any, swapped: bool = False) -> Any:
        other = self._part(other)
        if other is NotImplemented:
            return NotImplemented
        first, second = (other, self) if swapped else (self, other)
        return self._trace.add(operation, 0.0, first._place, second._place)

    def _function(self, name: str) -> Symbol:
        return self._trace.add(name, 0.0, self._place)

    def __add__(self, other: Any) -> Any:
        return self._binary("add", other)

    def __radd__(self, other: Any) -> Any:
        return self._binary("add", other, swapped=True)

    def __sub__(self, other: Any) -> Any:
        return self._binary("subtract", other)

    def __rsub__(self, other: Any) -> Any:
        return self._binary("subtract", other, swapped=True)

    def __mul__(self, other: Any) -> Any:
        return self._binary("multiply", other)

    def __rmul__(self, other: Any) -> Any:
        return self._binary("multiply", other, swapped=True)

    def __truediv__(self, other: Any) -> Any:
        return self._binary("divide", other)

    def __rtruediv__(self, other: Any) -> Any:
        return self._binary("divide", other, swapped=True)

    def __pow__(self, other: Any) -> Any:
        return self._binary("power", other)

    def __rpow__(self, other: Any) -> Any:
        return self._binary("power", other, swapped=True)

    def __neg__(self) -> Symbol:
        return self._function("negate")

    def __pos__(self) -> Symbol:
        return self

    def __abs__(self) -> Symbol:
        return self._function("abs")

    # NumPy calls the method of the name of a function on the objects of an array.

    def sqrt(self) -> Symbol:
        """Returns the square root."""
        return self._function("sqrt")

    def exp(self) -> Symbol:
        """Returns the exponential."""
        return self._function("exp")

    def log(self) -> Symbol:
        """Returns the natural logarithm."""
        return self._function("ln")

    def log10(self) -> Symbol:
        """Returns the decadic logarithm."""
        return self._function("log10")

    def cbrt(self) -> Symbol:
        """Returns the cube root, with the sign of the symbol."""
        return self._function("cbrt")

    def arcsin(self) -> Symbol:
        """Returns the angle in [-pi/2, pi/2] with this sine."""
        return self._function("arcsin")

    def arccos(self) -> Symbol:
        """Returns the angle in [0, pi] with this cosine."""
        return self._function("arccos")

    def arctan(self) -> Symbol:
        """Returns the angle in (-pi/2, pi/2) with this tangent."""
        return self._function("arctan")

    def sin(self) -> Symbol:
        """Returns the sine."""
        return self._function("sin")

    def cos(self) -> Symbol:
        """Returns the cosine."""
        return self._function("cos")

    def tan(self) -> Symbol:
        """Returns the tangent."""
        return self._function("tan")

    def sinh(self) -> Symbol:
        """Returns the hyperbolic sine."""
        return self._function("sinh")

    def cosh(self) -> Symbol:
        """Returns the hyperbolic cosine."""
        return self._function("cosh")

    def tanh(self) -> Symbol:
        """Returns the hyperbolic tangent."""
        return self._function("tanh")

    def arctan2(self, x: Any) -> Any:
        """Returns the angle of the point (x, self)."""
        return self._binary("atan2", x)

    def angle_from(self, y: Any) -> Any:
        """Returns the angle of the point (self, y)."""
        return self._binary("atan2", y, swapped=True)

    def hypot(self, other: Any) -> Any:
        """Returns the length of the vector (self, other)."""
        return (self * self + other * other).sqrt()

    def conjugate(self) -> Symbol:
        """Returns the symbol itself: every symbol is real."""
        return self

    def _refuse_branch(self, what: str) -> NoReturn:
        raise TypeError(BRANCH.format(what=what))

    def __bool__(self) -> NoReturn:
        self._refuse_branch("the truth value")

    def _condition(self, difference: Any, holds: bool) -> Any:
        return NotImplemented if difference is NotImplemented else Condition(difference, holds)

    def __ge__(self, other: Any) -> Any:
        return self._condition(self - other if self._part(other) is not NotImplemented else NotImplemented, True)

    def __le__(self, other: Any) -> Any:
        return self._condition(other - self if self._part(other) is not NotImplemented else NotImplemented, True)

    def __gt__(self, other: Any) -> Any:
        return ~condition if (condition := self.__le__(other)) is not NotImplemented else NotImplemented

    def __lt__(self, other: Any) -> Any:
        return ~condition if (condition := self.__ge__(other)) is not NotImplemented else NotImplemented

    def __eq__(self, other: object) -> NoReturn:
        self._refuse_branch("a test of equality")

    def __ne__(self, other: object) -> NoReturn:
        self._refuse_branch("a test of equality")

    __hash__ = object.__hash__

    def __float__(self) -> NoReturn:
        raise TypeError(NUMBER)

    __int__ = __index__ = __complex__ = __float__

    def __repr__(self) -> str:
        operation = self._trace.parts[self._place][0]
        return f"<Symbol: {operation}, part {self._place} of a traced function>"


class Condition:
    """A comparison of symbols, which holds in some states: the first argument of `numpy.where`.

    Where a side of the comparison is not a number, neither is the result.
    """

    def __init__(self, difference: Symbol, holds: bool) -> None:
        self._difference = difference
        self._holds = holds

    def choose(self, holds: Any, fails: Any) -> Any:
        """Returns the first value in states where the condition holds, and the second one in others."""
        first, second = (holds, fails) if self._holds else (fails, holds)
        first, second = self._difference._part(first), self._difference._part(second)
        if first is NotImplemented or second is NotImplemented:
            raise TypeError(f"numpy.where chooses between numbers and symbols, got {holds!r} and {fails!r}")
        return self._difference._trace.add("where", 0.0, self._difference._place, first._place, second._place)

    def __invert__(self) -> Condition:
        return Condition(self._difference, not self._holds)

    def __bool__(self) -> NoReturn:
        raise TypeError(BRANCH.format(what="the truth value of a comparison"))

    def __and__(self, other: object) -> NoReturn:
        raise TypeError("conditions cannot be combined: write numpy.where(a, numpy.where(b, x, y), y) for a & b")

    __or__ = __xor__ = __rand__ = __ror__ = __rxor__ = __and__

    def __eq__(self, other: object) -> NoReturn:
        raise TypeError(f"a test of equality of a comparison: {CONDITION}; write ~(x.Pi1 > 0) for the opposite")

    __ne__ = __eq__

    __hash__ = object.__hash__

    def __float__(self, *_: object) -> NoReturn:
        raise TypeError(f"a comparison of symbols is no number: {CONDITION}")

    __int__ = __index__ = __complex__ = __neg__ = __abs__ = __float__
    __add__ = __radd__ = __sub__ = __rsub__ = __mul__ = __rmul__ = __float__
    __truediv__ = __rtruediv__ = __pow__ = __rpow__ = __float__

    def __array_function__(self, function: Any, types: Any, arguments: Any, settings: Any) -> Any:
        """Chooses between symbols where a function of NumPy is `numpy.where`."""
        if function is np.where:
            return chosen(*arguments)
        raise TypeError(f"a comparison of symbols has no numpy.{function.__name__}: {CONDITION}")


class SymbolArray(np.ndarray):
    """An array of symbols, on which the functions of NumPy act as on a symbol."""

    def __getitem__(self, key: Any) -> Any:
        """Returns a part of the array. Which part may not depend on the state."""
        return super().__getitem__(fixed(key))

    def __setitem__(self, key: Any, value: Any) -> None:
        """Replaces a part of the array. Which part may not depend on the state."""
        super().__setitem__(fixed(key), value)

    def __array_function__(self, function: Any, types: Any, arguments: Any, settings: Any) -> Any:
        """Chooses between symbols where a function of NumPy is `numpy.where`."""
        if function is np.where:
            return chosen(*arguments)
        return super().__array_function__(function, types, arguments, settings)

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **kwargs: Any) -> Any:
        """Applies a function of NumPy to arrays of symbols and to numbers, in any order."""
        return applied(ufunc, method, inputs, kwargs)


def fixed(selection: Any) -> Any:
    """Returns a selection of entries that does not depend on the state.

    Raises:
        TypeError: if there is a symbol or a comparison of symbols in it.
    """
    for part in selection if isinstance(selection, tuple) else (selection,):
        for entry in part.flat if isinstance(part, np.ndarray) else part if isinstance(part, list) else (part,):
            if isinstance(entry, (Symbol, Condition)):
                by = "a comparison" if isinstance(entry, Condition) else "the value"
                raise TypeError(BRANCH.format(what=f"a choice of entries by {by}"))
    return selection


def angle(y: Any, x: Any) -> Any:
    """Returns the angle of the point (x, y)."""
    if isinstance(y, Symbol):
        return y.arctan2(x)
    return x.angle_from(y) if isinstance(x, Symbol) else np.arctan2(y, x)


def length(x: Any, y: Any) -> Any:
    """Returns the length of the vector (x, y)."""
    if isinstance(x, Symbol):
        return x.hypot(y)
    return y.hypot(x) if isinstance(y, Symbol) else np.hypot(x, y)


def choice(condition: Any, holds: Any, fails: Any) -> Any:
    """Returns one of two values, by a condition on the state or by a truth value."""
    if isinstance(condition, Condition):
        return condition.choose(holds, fails)
    return holds if condition else fails


CHOICES = np.frompyfunc(choice, 3, 1)


def chosen(condition: Any, *values: Any) -> Any:
    """Returns what `numpy.where` makes of conditions and symbols."""
    if len(values) != 2:
        raise TypeError(f"numpy.where without values to choose from: {CONDITION}")
    result = CHOICES(*(plain(x) for x in (condition, *values)))
    return result.view(SymbolArray) if isinstance(result, np.ndarray) else result


OF_TWO = {
    "arctan2": np.frompyfunc(angle, 2, 1),
    "hypot": np.frompyfunc(length, 2, 1),
    "greater": np.frompyfunc(operator.gt, 2, 1),
    "greater_equal": np.frompyfunc(operator.ge, 2, 1),
    "less": np.frompyfunc(operator.lt, 2, 1),
    "less_equal": np.frompyfunc(operator.le, 2, 1),
}
"""The functions that NumPy looks for in their first argument alone, which may be a number, or whose result is no number."""


def applied(function: np.ufunc, method: str, inputs: Sequence[Any], settings: dict[str, Any]) -> Any:
    """Returns what a function of NumPy, or one of its methods such as `reduce`, makes of symbols and numbers."""
    function = OF_TWO.get(function.__name__, function)
    outputs = settings.pop("out", ())
    if outputs:
        if any(isinstance(x, np.ndarray) and x.dtype != object for x in outputs):
            raise TypeError(FIXED)
        settings["out"] = tuple(plain(x) for x in outputs)
    if "where" in settings:
        settings["where"] = fixed(settings["where"])
    result = getattr(function, method)(*(plain(x) for x in inputs), **settings)
    if len(outputs) == 1:
        return outputs[0]
    return result.view(SymbolArray) if isinstance(result, np.ndarray) and result.dtype == object else result


def plain(x: Any) -> Any:
    """Returns an array of symbols, or a symbol as an array, without functions of its own."""
    if isinstance(x, (Symbol, Condition)):
        array = np.empty((), dtype=object)
        array[()] = x
        return array
    return x.view(np.ndarray) if isinstance(x, SymbolArray) else x
