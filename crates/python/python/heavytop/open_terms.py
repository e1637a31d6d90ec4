"""What drives, damps, shakes or forces a system."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from .arguments import array, choice, count, not_negative, real
from .events import Function
from .symbols import Part
from .tracing import TIME, in_time, takes_time, trace, trace_element

Element = Union[Callable[..., Any], Mapping[str, Any], Sequence[Any]]
"""An element of the algebra, or a rate of the coordinates: a function of the state and the time that returns a number for each
coordinate; formulas for them; or formulas and numbers by the names of vectors and scalars of coordinates, where what is left out is 0."""

Inputs = Mapping[str, tuple[ArrayLike, ArrayLike, str]]
"""Inputs by name: times, values, and "constant", "linear" or "cubic" between them."""

Source = Union[str, list[Part]]

PATH = ("seed", "path", "interval", "bound")
"""What every noise has."""

SHELL = "{'degrees': [8, 10], 'strength': 0.1}"

MOST_POWER = 2**32 - 1
"""The largest power of a viscosity that the native part takes, which refuses it."""


class OpenNames:
    """The names of the coordinates of a system, with the time and the inputs behind them."""

    def __init__(self, names: Mapping[str, slice], parameters: Mapping[str, Any], inputs: Sequence[str]) -> None:
        self.size = max((int(places.stop) for places in names.values()), default=0)
        self.groups = names
        self.parameters = parameters
        more = enumerate([TIME, *inputs], self.size)
        self.names = {**names, **{name: slice(i, i + 1) for i, name in more}}

    def scalar(self, name: str, function: Function) -> Source:
        """Returns a formula, or the parts of a function of the state, or of the state and the time."""
        if isinstance(function, str):
            return function
        if callable(function):
            return trace(name, in_time(function), self.names, self.parameters)
        raise ValueError(f"{name} must be a formula or a function of the coordinates, got {function!r}")

    def element(self, name: str, element: Element, size: Optional[int] = None) -> list[Source]:
        """Returns a formula for each coordinate, or so many formulas."""
        size = self.size if size is None else size
        if callable(element):
            return trace_element(name, in_time(element), self.names, self.parameters, size)
        if isinstance(element, Mapping):
            if not element:
                raise ValueError(f"{name} has no formulas")
            every: list[Any] = [0.0] * size
            for key, value in element.items():
                if key not in self.groups:
                    raise ValueError(f"{name} has no coordinate {key!r}; there are {', '.join(self.groups)}")
                places = self.groups[key]
                values = [value] if isinstance(value, str) or np.ndim(value) == 0 else list(value)
                if len(values) != places.stop - places.start:
                    wanted = places.stop - places.start
                    raise ValueError(f"{name}[{key!r}] must have {wanted} formulas, got {len(values)}")
                every[places] = values
            return [self._formula(name, value) for value in every]
        if isinstance(element, str) or np.ndim(element) == 0 or len(element) != size:
            raise ValueError(f"{name} must have {size} formulas, one for each coordinate, got {element!r}")
        return [self._formula(name, value) for value in element]

    def _formula(self, name: str, value: Any) -> Source:
        return value if isinstance(value, str) else [("number", real(name, value), 0, 0, 0)]


def depends_on_time(hamiltonian: Any, parameters: Mapping[str, Any]) -> bool:
    """Returns whether a Hamiltonian is one of the time, too."""
    if isinstance(hamiltonian, str):
        return TIME not in parameters and re.search(rf"(?<![\w]){TIME}(?![\w])", hamiltonian) is not None
    return callable(hamiltonian) and takes_time(hamiltonian)


def native_inputs(inputs: Optional[Inputs]) -> list[tuple[str, list[float], list[float], str]]:
    """Returns inputs as the native part takes them."""
    every = []
    for name, table in (inputs or {}).items():
        if not isinstance(table, (tuple, list)) or len(table) != 3:
            raise ValueError(f"inputs[{name!r}] must be (times, values, interpolation), got {table!r}")
        times, values = (array(f"inputs[{name!r}]", column).reshape(-1).tolist() for column in table[:2])
        between = choice(f"the interpolation of inputs[{name!r}]", table[2], ("constant", "linear", "cubic"))
        every.append((str(name), times, values, between))
    return every


def native_open(
    names: OpenNames,
    inputs: list[tuple[str, list[float], list[float], str]],
    drive: Optional[Element],
    damping: Union[None, float, Mapping[str, Any]],
    noise: Optional[Mapping[str, Any]],
    torque: Optional[Element],
) -> _native.Open:
    """Returns what makes a system an open one as the native part takes it."""
    return (
        inputs,
        None if drive is None else names.element("drive", drive),
        None if damping is None else native_damping(names, damping),
        None if noise is None else native_noise(names, noise),
        None if torque is None else names.element("torque", torque),
    )


def native_damping(names: OpenNames, damping: Union[float, Mapping[str, Any]]) -> _native.Damping:
    """Returns the friction, whether it is Gilbert's damping, if it has a form, and the rows of its inner product."""
    given = damping if isinstance(damping, Mapping) else {"friction": damping}
    only("damping", given, ("friction", "form", "inner_product"))
    if "form" not in given:
        return friction_of(given), None, inner_product(names, given.get("inner_product"))
    only("damping with form", given, ("friction", "form"))
    return friction_of(given), is_gilbert(given), None


def inner_product(names: OpenNames, given: Optional[ArrayLike]) -> Optional[list[float]]:
    """Returns the rows of an inner product: of a multiple of the unit matrix, a diagonal, or a matrix."""
    if given is None:
        return None
    matrix: NDArray[np.float64] = array("inner_product", given)
    if matrix.ndim == 0:
        matrix = np.eye(names.size) * matrix
    elif matrix.ndim == 1:
        matrix = np.diag(matrix)
    if matrix.ndim != 2:
        raise ValueError(f"inner_product must be a number, a diagonal or a matrix, got the shape {matrix.shape}")
    return [float(x) for x in matrix.reshape(-1)]


def native_noise(names: OpenNames, noise: Mapping[str, Any]) -> _native.Noise:
    """Returns the noise as the native part takes it."""
    mapping("noise", noise, "{'temperature': 0.5}")
    kinds = ("temperature", "strength", "fields")
    only("noise", noise, (*kinds, "inner_product", "rule", *PATH))
    given = [kind for kind in kinds if kind in noise]
    if len(given) != 1 or ("inner_product" in noise and given != ["strength"]):
        raise ValueError("noise has one of temperature, which goes with damping, strength, with or without inner_product, and fields")
    if given == ["temperature"]:
        source: Any = (not_negative("temperature", noise["temperature"]),)
    elif given == ["strength"]:
        source = (not_negative("strength", noise["strength"]), inner_product(names, noise.get("inner_product")))
    else:
        fields = noise["fields"]
        if isinstance(fields, (str, Mapping)) or callable(fields):
            raise ValueError(f"fields must be a list of fields, got {fields!r}")
        source = [names.element(f"fields[{k}]", field) for k, field in enumerate(fields)]
    numbers = native_path(noise)
    rule = choice("rule", noise.get("rule", "together"), ("together", "alternating"))
    return source, numbers, rule == "alternating"


def native_path(noise: Mapping[str, Any]) -> _native.Path:
    """Returns the seed, the path, the interval and the bound of a noise."""
    interval = None if noise.get("interval") is None else real("interval", noise["interval"])
    bound = None if noise.get("bound") in (None, math.inf) else real("bound", noise["bound"])
    # None is the bound of the library.
    bound = math.inf if noise.get("bound") == math.inf else bound
    return count("seed", noise.get("seed", 1), 0), count("path", noise.get("path", 0), 0), interval, bound


def native_arrays(
    kind: str,
    damping: Union[None, float, Mapping[str, Any]],
    noise: Optional[Mapping[str, Any]],
    torque: Optional[Mapping[str, Any]],
    drive: Optional[Mapping[str, Any]],
    inputs: Optional[Inputs],
) -> Union[None, _native.Lattice, _native.Fluid]:
    """Returns the forces on a system of arrays as the native part takes them; None if there are none."""
    if all(given is None for given in (damping, noise, torque, drive, inputs)):
        return None
    if (drive is not None or inputs is not None) and kind != "spin-lattice":
        name = "inputs" if drive is None else "drive"
        raise ValueError(f"{kind} has no {name}: of the systems of arrays spin-lattice has drive, with inputs")
    if kind == "sphere-fluid":
        return fluid_damping(damping), fluid_force(torque), None if noise is None else fluid_noise(noise)
    if torque is not None:
        raise ValueError(f"{kind} has no torque: of the systems of arrays sphere-fluid has one")
    friction = None if damping is None else lattice_damping(damping)
    return friction, None if noise is None else lattice_noise(noise), lattice_field(drive, inputs)


def lattice_damping(damping: Union[float, Mapping[str, Any]]) -> tuple[float, bool]:
    """Returns the friction of spins on a lattice, and whether it is Gilbert's damping."""
    given = damping if isinstance(damping, Mapping) else {"friction": damping}
    only("damping of a lattice", given, ("friction", "form"))
    return friction_of(given), is_gilbert(given)


def is_gilbert(damping: Mapping[str, Any]) -> bool:
    """Returns whether a damping of spins is Gilbert's."""
    form: str = choice("form", damping.get("form", "landau-lifshitz"), ("landau-lifshitz", "gilbert"))
    return form == "gilbert"


def lattice_field(drive: Optional[Mapping[str, Any]], inputs: Optional[Inputs]) -> Optional[_native.Field]:
    """Returns the inputs and the formulas of a field of spins on a lattice that depends on the time."""
    if drive is None and inputs is None:
        return None
    given = mapping("drive", {} if drive is None else drive, "{'field': [0, 0, 'cos(t)']}")
    only("drive of a lattice", given, ("field",))
    if "field" not in given:
        raise ValueError("drive of a lattice has no field")
    tables, field = native_inputs(inputs), given["field"]
    names = OpenNames({}, {}, [name for name, *_ in tables])
    of_time = callable(field) and not takes_time(field)
    return tables, names.element("drive['field']", (lambda x: field(x[TIME])) if of_time else field, 3)


def lattice_noise(noise: Mapping[str, Any]) -> tuple[float, _native.Path]:
    """Returns the temperature of spins on a lattice, and the path."""
    only("noise of a lattice", mapping("noise", noise, "{'temperature': 0.5}"), ("temperature", *PATH))
    if "temperature" not in noise:
        raise ValueError("noise of a lattice has no temperature")
    return not_negative("temperature", noise["temperature"]), native_path(noise)


def fluid_damping(damping: Any) -> tuple[float, int, float]:
    """Returns the viscosity of a fluid, its power, and the drag."""
    if damping is None:
        return 0.0, 1, 0.0
    given = mapping("damping", damping, "{'viscosity': 1e-3, 'drag': 0.1}")
    only("damping of a fluid", given, ("viscosity", "power", "drag"))
    if not given or ("power" in given and "viscosity" not in given):
        raise ValueError("damping of a fluid has no viscosity")
    viscosity, drag = (not_negative(key, given.get(key, 0.0)) for key in ("viscosity", "drag"))
    return viscosity, min(count("power", given.get("power", 1), 0), MOST_POWER), drag


def fluid_force(torque: Optional[Mapping[str, Any]]) -> list[list[float]]:
    """Returns the rows l, m, re, im of the force on a fluid."""
    if torque is None:
        return []
    given = mapping("torque", torque, "{'coefficients': [[3, 0, 0.1, 0]]}")
    only("torque of a fluid", given, ("coefficients",))
    rows = array("torque['coefficients']", given.get("coefficients", ()))
    if rows.ndim != 2 or rows.shape[1] != 4 or not rows.size:
        raise ValueError(f"torque['coefficients'] must have the shape (n, 4), got {rows.shape}")
    return [[float(x) for x in row] for row in rows]


def fluid_noise(noise: Mapping[str, Any]) -> tuple[_native.Shells, _native.Shells, _native.Path]:
    """Returns the transport noise and the stirring of a fluid, and the path."""
    given = mapping("noise", noise, "{'stirring': {'degrees': [8, 10], 'strength': 0.1}}")
    only("noise of a fluid", given, ("transport", "stirring", *PATH))
    if not {"transport", "stirring"} & set(given):
        raise ValueError("noise of a fluid has no transport and no stirring")
    return shells("transport", given), shells("stirring", given), native_path(given)


def shells(name: str, noise: Mapping[str, Any]) -> _native.Shells:
    """Returns the shells of harmonics of a noise: of one mapping, or of several."""
    given = noise.get(name, ())
    if isinstance(given, str) or not isinstance(given, (Mapping, Sequence)):
        raise ValueError(f"{name} must be a shell such as {SHELL}, or a list of shells, got {given!r}")
    every: _native.Shells = []
    for shell in [given] if isinstance(given, Mapping) else given:
        only(name, mapping(name, shell, SHELL), ("degrees", "strength"))
        if len(shell) != 2 or np.shape(shell["degrees"]) != (2,):
            raise ValueError(f"{name} must be a shell such as {SHELL}, got {shell!r}")
        least, most = (count(f"the degrees of {name}", degree, 0) for degree in shell["degrees"])
        every.append(((least, most), not_negative(f"the strength of {name}", shell["strength"])))
    return every


def mapping(name: str, given: Any, example: str) -> Mapping[str, Any]:
    """Checks that something is a mapping, and returns it."""
    if not isinstance(given, Mapping):
        raise ValueError(f"{name} must be a mapping such as {example}, got {given!r}")
    return given


def friction_of(given: Mapping[str, Any]) -> float:
    """Returns the friction of a damping."""
    if "friction" not in given:
        raise ValueError("damping has no friction")
    return not_negative("friction", given["friction"])


def only(name: str, given: Mapping[str, Any], keys: Sequence[str]) -> None:
    """Checks that a mapping has no other keys."""
    for key in given:
        if key not in keys:
            raise ValueError(f"{name} has no {key!r}; there are {', '.join(keys)}")
