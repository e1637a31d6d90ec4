"""Functions of the state that are traced: called once with symbols, and computed in Rust from then on."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from typing import Any, Union

import numpy as np
from numpy.typing import NDArray

from .symbols import Part, Symbol, SymbolArray, Trace

BINARY = ("add", "subtract", "multiply", "divide", "power", "atan2")
"""The operations that combine two parts."""

TIME = "t"
"""The name of the time."""


class StateSymbols:
    """The state of a function that is being traced: its coordinates by name, as `x.Pi1`, `x.Pi` or `x["Pi"]`.

    A vector of coordinates is a NumPy array of symbols. The parameters of the system are there, too, as numbers and
    arrays. `x[0]` is the first coordinate.
    """

    def __init__(self, trace: Trace, names: Mapping[str, slice], parameters: Mapping[str, Any]) -> None:
        count = max(places.stop for places in names.values())
        self._all = [trace.add("coordinate", 0.0, i) for i in range(count)]
        self._names = names
        self._parameters = parameters

    def __getitem__(self, key: Union[str, int, slice]) -> Any:
        if not isinstance(key, str):
            symbols = self._all[key]
            return as_array(symbols) if isinstance(symbols, list) else symbols
        if key in self._parameters:
            return self._parameters[key]
        if key not in self._names:
            known = ", ".join([*self._names, *self._parameters])
            raise KeyError(f"there is no coordinate or parameter {key!r}; there are {known}")
        places = self._names[key]
        return self._all[places.start] if is_scalar(key, places, self._names) else as_array(self._all[places])

    def __getattr__(self, name: str) -> Any:
        try:
            return self[name]
        except KeyError as error:
            raise AttributeError(*error.args) from None

    def __len__(self) -> int:
        return len(self._all)

    def __dir__(self) -> list[str]:
        return [*self._names, *self._parameters]


def is_scalar(name: str, places: slice, names: Mapping[str, slice]) -> bool:
    """Returns whether a name is that of one coordinate, and not of a vector with one component."""
    return places.stop - places.start == 1 and f"{name}1" not in names


def as_array(symbols: list[Symbol]) -> NDArray[np.object_]:
    """Returns an array of symbols."""
    array = np.empty(len(symbols), dtype=object)
    array[:] = symbols
    return array.view(SymbolArray)


def trace(
    name: str,
    function: Callable[[Any], Any],
    names: Mapping[str, slice],
    parameters: Mapping[str, Any],
) -> list[Part]:
    """Returns the parts of a function of the state, which is called once; the last part is its value.

    Args:
        name: what the function is, in messages.
        function: the function of the state.
        names: the places of each coordinate and each vector of coordinates.
        parameters: numbers and arrays by name.
    """
    traced = Trace()
    return parts_of(name, function(StateSymbols(traced, names, parameters)), traced)


def trace_element(
    name: str,
    function: Callable[[Any], Any],
    names: Mapping[str, slice],
    parameters: Mapping[str, Any],
    size: int,
) -> list[Union[str, list[Part]]]:
    """Returns the parts of each component of a function with so many, as `trace` does; it is called once."""
    traced = Trace()
    values = function(StateSymbols(traced, names, parameters))
    values = [values] if isinstance(values, Symbol) or np.ndim(values) == 0 else np.concatenate([np.atleast_1d(v) for v in values])
    if len(values) != size:
        raise ValueError(f"{name} must return {size} numbers, one for each coordinate, got {len(values)}")
    return [parts_of(f"{name}, component {i}", value, traced) for i, value in enumerate(values, 1)]


def parts_of(name: str, value: Any, traced: Trace) -> list[Part]:
    """Returns the parts of a value that a traced function has returned."""
    if isinstance(value, np.ndarray) and value.shape == ():
        value = value[()]
    if isinstance(value, Symbol) and value._trace is traced:
        return only_needed(traced.parts, value._place)
    if isinstance(value, (int, float, np.integer, np.floating)) and not isinstance(value, bool):
        return [("number", float(value), 0, 0, 0)]
    what = f"an array of shape {value.shape}" if isinstance(value, np.ndarray) else repr(value)
    raise TypeError(f"{name} must return a scalar made of the coordinates, got {what}")


def only_needed(parts: list[Part], last: int) -> list[Part]:
    """Returns the parts up to `last` that it needs."""
    needed = [False] * (last + 1)
    needed[last] = True
    for place in range(last, -1, -1):
        if needed[place]:
            for part in operands(parts[place]):
                needed[part] = True
    places: dict[int, int] = {}
    kept: list[Part] = []
    for place in range(last + 1):
        if needed[place]:
            places[place] = len(kept)
            operation, number, first, second, third = parts[place]
            count = len(operands(parts[place]))
            first = places[first] if count > 0 else first
            second = places[second] if count > 1 else second
            third = places[third] if count > 2 else third
            kept.append((operation, number, first, second, third))
    return kept


def operands(part: Part) -> tuple[int, ...]:
    """Returns the places of the parts that a part combines."""
    operation, _, first, second, third = part
    if operation in ("number", "coordinate"):
        return ()
    if operation == "where":
        return (first, second, third)
    return (first, second) if operation in BINARY else (first,)


def in_time(function: Callable[..., Any]) -> Callable[[Any], Any]:
    """Returns a function of the state, whose time a function of the state and the time gets, too."""
    return (lambda x: function(x, x[TIME])) if takes_time(function) else function


def takes_time(function: Callable[..., Any]) -> bool:
    """Returns whether a function has two arguments without which it cannot be called."""
    try:
        parameters = inspect.signature(function).parameters.values()
    except (TypeError, ValueError):
        return False
    needed = [p for p in parameters if p.kind in (p.POSITIONAL_ONLY, p.POSITIONAL_OR_KEYWORD) and p.default is p.empty]
    return len(needed) > 1
