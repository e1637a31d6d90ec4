"""Realisations of one's own: matrices of a representation, or of quadratic momenta."""

from __future__ import annotations

from typing import Any, NamedTuple, Optional

import numpy as np
from numpy.typing import ArrayLike


class Realisation(NamedTuple):
    """What momenta J_a(z) = z.S_a z/2 on R^(2m) obey, with {q, p} = 1.

    Attributes:
        bracket: the bracket for which they are a Poisson map: "plus" if {J_a, J_b} = sum_k c_abk J_k, "minus" for the negative.
        defect: the largest deviation from these relations, relative to the size of the brackets.
        rank: the rank of z -> J(z) at a generic point: the momenta reach an open part of the dual if it is the dimension.
        odd_powers: how far the cubes of the matrices are from the space of these matrices, relative to their size.
        descends: whether steps descend to the dual, so that they are Poisson maps and conserve all Casimirs to round-off. If
            not, Casimirs that are not quadratic are conserved to the order of the scheme alone.
    """

    bracket: str
    defect: float
    rank: int
    odd_powers: float
    descends: bool


def realisation(representation: Optional[ArrayLike], momenta: Optional[ArrayLike]) -> Optional[tuple[Any, bool]]:
    """Returns the matrices as the native part takes them, and whether they are those of a representation."""
    if representation is not None and momenta is not None:
        raise ValueError("write one of representation and momenta")
    name, values = ("representation", representation) if representation is not None else ("momenta", momenta)
    if values is None:
        return None
    if name == "momenta" and np.iscomplexobj(np.asarray(values)):
        raise ValueError("momenta must be real")
    return real_matrices(name, values), name == "representation"


def real_matrices(name: str, values: ArrayLike) -> list[list[list[float]]]:
    """Returns matrices by rows. A complex number x + iy is the block [[x, -y], [y, x]]."""
    matrices = np.asarray(values)
    if matrices.ndim != 3 or matrices.shape[1] != matrices.shape[2]:
        raise ValueError(f"{name} must have the shape (d, n, n), got {matrices.shape}")
    if not np.issubdtype(matrices.dtype, np.number):
        raise TypeError(f"{name} must be numbers, got {matrices.dtype}")
    if np.iscomplexobj(matrices):
        blocks = np.array([[matrices.real, -matrices.imag], [matrices.imag, matrices.real]])
        size = 2 * matrices.shape[1]
        matrices = blocks.transpose(2, 3, 0, 4, 1).reshape(len(matrices), size, size)
    result: list[list[list[float]]] = matrices.astype(float).tolist()
    return result
