"""Lie algebras and parameters as the native part takes them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from .arguments import array, real
from .realisation import real_matrices

Brackets = Mapping[Union[str, tuple[str, str]], str]

Names = Union[str, list[str]]

Matrices = list[list[list[float]]]

AlgebraSource = Union[
    str,
    tuple[str],
    tuple[str, list[str]],
    tuple[str, list[str], list[tuple[str, Matrices]]],
    tuple[list[str], list[tuple[str, str]]],
    tuple[Names, list[tuple[int, int, int, float]], int],
]
"""An expression; or the name of a system, alone in a tuple; or an expression with symbols for its coordinates, and the matrices of representations; or the names of coordinates with their brackets; or names, structure constants and the dimension."""


class Algebra(NamedTuple):
    """What describes an algebra: a name; or coordinates with brackets or structure constants."""

    name: Optional[str]
    coordinates: Union[None, str, Sequence[str]]
    brackets: Optional[Brackets]
    structure_constants: Optional[ArrayLike]
    representations: Optional[Mapping[str, ArrayLike]]


def algebra_source(algebra: Algebra) -> AlgebraSource:
    """Returns an algebra as the native part takes it."""
    given = [name for name, value in zip(("algebra", "brackets", "structure_constants"), algebra_parts(algebra)) if value]
    if len(given) != 1:
        raise ValueError(f"write one of algebra, brackets and structure_constants; got {' and '.join(given) or 'none'}")
    if algebra.name is not None:
        if not isinstance(algebra.name, str):
            raise ValueError(f"algebra must be a name such as 'se(3)', got {algebra.name!r}")
        own = algebra.coordinates
        symbols = [str(symbol) for symbol in ([own] if isinstance(own, str) else own or [])]
        if algebra.representations:
            matrices = [(str(name), real_matrices(f"representations[{name!r}]", rho)) for name, rho in algebra.representations.items()]
            return algebra.name, symbols, matrices
        return (algebra.name, symbols) if own is not None else algebra.name
    if algebra.representations is not None:
        raise ValueError("representations are those that the text of an algebra names")
    if algebra.structure_constants is not None:
        return of_constants(algebra.structure_constants, algebra.coordinates)
    if algebra.coordinates is None or isinstance(algebra.coordinates, str):
        raise ValueError("brackets need coordinates: a list of the names of all coordinates")
    pairs = [(pair(key), str(text)) for key, text in (algebra.brackets or {}).items()]
    return [str(name) for name in algebra.coordinates], pairs


def algebra_parts(algebra: Algebra) -> tuple[bool, bool, bool]:
    """Returns which descriptions of an algebra there are."""
    return algebra.name is not None, algebra.brackets is not None, algebra.structure_constants is not None


def pair(key: Any) -> str:
    """Returns the two coordinates of a bracket as text."""
    if isinstance(key, str):
        return key
    if isinstance(key, tuple) and len(key) == 2 and all(isinstance(name, str) for name in key):
        return f"{key[0]}, {key[1]}"
    raise ValueError(f"the keys of brackets are pairs of coordinates such as ('K', 'H'), got {key!r}")


def of_constants(values: ArrayLike, names: Union[None, str, Sequence[str]]) -> AlgebraSource:
    """Returns the algebra of structure constants c[i, j, k] with [e_i, e_j] = sum_k c[i, j, k] e_k."""
    c = array("structure_constants", values)
    if c.ndim != 3 or len(set(c.shape)) != 1:
        raise ValueError(f"structure_constants must have the shape (d, d, d), got {c.shape}")
    dimension = c.shape[0]
    wrong = np.argwhere(c != -c.swapaxes(0, 1))
    if wrong.size:
        i, j, k = (int(n) for n in wrong[0])
        raise ValueError(f"structure_constants must change sign with i and j: [{i}, {j}, {k}] is {c[i, j, k]}, and [{j}, {i}, {k}] is {c[j, i, k]}")
    entries = [(int(i), int(j), int(k), float(c[i, j, k])) for i, j, k in np.argwhere(c) if i < j]
    named: Names = names if isinstance(names, str) else list(names) if names is not None else "mu"
    if isinstance(named, list) and len(named) != dimension:
        raise ValueError(f"there are {len(named)} coordinates and structure constants of dimension {dimension}")
    return named, entries, dimension


def native_parameters(parameters: Mapping[str, Any]) -> tuple[list[tuple[str, list[float], bool]], dict[str, Any]]:
    """Returns parameters as the native part takes them, and by name as numbers and arrays."""
    natives: list[tuple[str, list[float], bool]] = []
    values: dict[str, Any] = {}
    for name, value in parameters.items():
        numbers = array(f"parameters[{name!r}]", value)
        if numbers.ndim > 2:
            raise ValueError(f"parameters[{name!r}] must be a number, or a list of numbers or of rows, got the shape {numbers.shape}")
        flat = [real(f"parameters[{name!r}]", x) for x in numbers.reshape(-1)]
        natives.append((name, flat, numbers.ndim > 0))
        values[name] = numbers if numbers.ndim > 0 else flat[0]
    return natives, values
