"""Events: zeros of a function of the state and the time along a run."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Union

import numpy as np

from .arguments import real
from .symbols import Part
from .tracing import TIME, in_time, takes_time, trace

Function = Union[str, Callable[[Any], Any]]
"""A function of the state: a formula, or a Python function of the coordinates that is called once, with symbols. That of an event may
be a function of the coordinates and the time."""

NativeEvent = tuple[Any, int, int]
"""The function, the direction, and the number of the occurrence that ends the run, or 0."""


@dataclass(frozen=True)
class Event:
    """A function of the state and the time whose zeros are found along a run.

    At an event the function goes to zero and changes its sign. A touch, as of "(Gamma3 - 1)^2", is no event, since the sign
    does not change; neither are jumps and poles, where the function does not go to zero. A start where the function is zero
    is no event. An angle, which is "atan2(...)" or a sum of such terms and functions without one, has an event wherever it is
    a multiple of 2 pi, or of the period that a constant factor gives it. Half a turn, as of "arctan(...)", is no angle.

    Attributes:
        function: a formula in the coordinates, the time `t` and the inputs of a system, such as "Gamma3 - 0.5" or "Pi3 - cos(t)",
            or a Python function of the coordinates, such as `lambda x: x.Gamma3 - 0.5`, or of the coordinates and the time, such as
            `lambda x, t: x.Pi3 - cos(t)`, which is called once, with symbols.
        direction: positive for zeros where the function grows along the run, negative where it falls, 0 for both. Along a run backward in
            time a function grows that falls in time, as in SciPy.
        terminal: whether the run ends at the first zero; a whole number ends it at that zero, counted from 1.
    """

    function: Function
    direction: float = 0
    terminal: Union[bool, int] = False


Events = Union[None, Event, Function, Sequence[Union[Event, Function]]]
"""One event or several; a Python function may have the attributes `direction` and `terminal`, as those of SciPy."""


def function_source(
    name: str, function: Function, names: Mapping[str, slice], parameters: Mapping[str, Any]
) -> Union[str, list[Part]]:
    """Returns a formula, or the parts of a Python function."""
    if isinstance(function, str):
        return function
    if callable(function):
        return trace(name, function, names, parameters)
    raise ValueError(f"{name} must be a formula or a function of the coordinates, got {function!r}")


def surface_source(
    coordinate: Function, value: float, names: Mapping[str, slice], parameters: Mapping[str, Any]
) -> Union[str, list[Part]]:
    """Returns the function that is zero where another has a value."""
    if isinstance(coordinate, str):
        return coordinate if value == 0 else f"{coordinate} - {value!r}"
    if not callable(coordinate):
        raise ValueError(f"coordinate must be a coordinate, a formula or a function of them, got {coordinate!r}")
    if takes_time(coordinate):
        function, names = with_time("coordinate", coordinate, names, parameters)
        return trace("coordinate", lambda x: function(x) - value, names, parameters)
    return trace("coordinate", lambda x: coordinate(x) - value, names, parameters)


def with_time(
    name: str, function: Callable[..., Any], names: Mapping[str, slice], parameters: Mapping[str, Any]
) -> tuple[Callable[[Any], Any], Mapping[str, slice]]:
    """Returns a function of the state and the time as one of the state, and the names of the coordinates with the time behind them."""
    if TIME in names or TIME in parameters:
        raise ValueError(f"{name} cannot be a function of the time: {TIME} has another meaning in this system")
    size = max(int(places.stop) for places in names.values())
    return in_time(function), {**names, TIME: slice(size, size + 1)}


def is_list(events: Events) -> bool:
    """Returns whether there are several events, or a list of one."""
    return not isinstance(events, (Event, str)) and not callable(events)


def list_of(events: Events) -> list[Any]:
    """Returns events as a list."""
    return list(events) if is_list(events) else [events]  # type: ignore[arg-type]


def native_events(
    events: Events, names: Mapping[str, slice], parameters: Mapping[str, Any]
) -> list[NativeEvent]:
    """Returns events as the native part takes them."""
    if events is None:
        return []
    every = list_of(events)
    return [native_event(f"events[{i}]", event, names, parameters) for i, event in enumerate(every)]


def native_event(
    name: str, event: Union[Event, Function], names: Mapping[str, slice], parameters: Mapping[str, Any]
) -> NativeEvent:
    """Returns an event as the native part takes it."""
    event, direction, terminal = event_parts(name, event)
    function = event.function
    if callable(function) and takes_time(function):
        function, names = with_time(name, function, names, parameters)
    return function_source(name, function, names, parameters), direction, terminal


def event_parts(name: str, event: Union[Event, Function]) -> tuple[Event, int, int]:
    """Returns an event, its direction, and the number of the occurrence that ends the run, or 0."""
    if not isinstance(event, Event):
        event = Event(event, getattr(event, "direction", 0), getattr(event, "terminal", False))
    terminal = event.terminal
    if not isinstance(terminal, (bool, np.bool_, int, np.integer)) or terminal < 0:
        raise ValueError(f"the terminal of {name} must be True, False or a whole number from 1 on, got {terminal!r}")
    return event, int(np.sign(real(f"the direction of {name}", event.direction))), int(terminal)
