"""The parameters of heavy tops."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from . import _native
from .arguments import array, choice, inertia_of_body, not_negative, positive, principal_moments, real, vector
from .solution import Floats

if TYPE_CHECKING:
    from typing_extensions import Self


class TopParameters:
    """The parameters of a heavy top, and its invariants.

    The energy is h = (Pi1^2/I1 + Pi2^2/I2 + Pi3^2/I3)/2 + m g l c.Gamma. Mass, gravity and length enter by their product
    alone, the weight moment m g l.

    Args:
        inertia: the principal moments about the support, the fixed point, kg m^2; or a symmetric matrix, of shape (3, 3), in
            any axes. None may be larger than the sum of the other two. One may be 0: a thin rod, with its centre of mass on it
            and no angular momentum about it. With a matrix all vectors and states, in arguments and results, are in its axes.
        mass: kg.
        gravity: m/s^2; 0 gives a free rigid body.
        length: the distance of the centre of mass from the support, m.
        center_of_mass: the direction c of the centre of mass from the support in the body frame, a unit vector.
        inertia_about: "support", or "center-of-mass" for moments about the centre of mass, to which m l^2 (1 - c c^T) is then
            added.

    Raises:
        ValueError: if a parameter is out of its range. The message names the number and its bound.

    Warns:
        UserWarning: if no body has these moments about the support with this mass at this distance. The motion depends on
            the moments and m g l alone.
    """

    def __init__(
        self,
        inertia: ArrayLike,
        mass: float,
        gravity: float,
        length: float,
        center_of_mass: ArrayLike = (0.0, 0.0, 1.0),
        *,
        inertia_about: str = "support",
    ) -> None:
        center = vector("center_of_mass", center_of_mass)
        moments = inertia_of_body("inertia", inertia)
        numbers = (real("mass", mass), real("gravity", gravity), real("length", length))
        is_central = choice("inertia_about", inertia_about, ("support", "center-of-mass")) != "support"
        self._top = _native.Top(moments, *numbers, center, is_central)
        reason = None if is_central else _native.Top.impossibility(moments, *numbers, center)
        if reason is not None:
            text = f'{reason}; the motion is that of m g l: give moments about the support, or inertia_about="center-of-mass"'
            warnings.warn(text, UserWarning, stacklevel=2)

    @classmethod
    def _of(cls, native: _native.Top) -> Self:
        top = cls.__new__(cls)
        top._top = native
        return top

    @classmethod
    def free_rigid_body(cls, inertia: ArrayLike) -> Self:
        """Returns a rigid body without gravity: Euler's top. Its Gamma is any unit vector that is fixed in space.

        The principal moments are about the support, or about the centre of mass of a body that nothing holds. One may be 0:
        a thin rod, without an angular momentum about it.
        """
        return cls._of(_native.Top.free_rigid_body(principal_moments("inertia", inertia)))

    @classmethod
    def lagrange(cls, transverse: float, axial: float, weight_moment: float = 1.0) -> Self:
        """Returns Lagrange's top: I1 = I2 = transverse, I3 = axial (kg m^2), with the centre of mass on the third axis.

        The weight moment is m g l, N m. A fourth invariant is f3 = Pi3. With axial = 0 it is a thin rod, whose Pi3 is 0.
        """
        moments = (positive("transverse", transverse), not_negative("axial", axial))
        return cls._of(_native.Top.lagrange(*moments, real("weight_moment", weight_moment)))

    @classmethod
    def kovalevskaya(cls, axial: float = 1.0, weight_moment: float = 1.0) -> Self:
        """Returns Kovalevskaya's top: I1 = I2 = 2 I3, I3 = axial (kg m^2), with the centre of mass on the first axis.

        The weight moment is m g l, N m. A fourth invariant is K = |(Pi1 + i Pi2)^2 - 4 m g l I3 (Gamma1 + i Gamma2)|^2.
        """
        return cls._of(_native.Top.kovalevskaya(positive("axial", axial), real("weight_moment", weight_moment)))

    @classmethod
    def goryachev_chaplygin(cls, axial: float = 1.0, weight_moment: float = 1.0) -> Self:
        """Returns the top of Goryachev and Chaplygin: I1 = I2 = 4 I3, with the centre of mass on the first axis.

        The weight moment is m g l, N m. G = Pi3 (Pi1^2 + Pi2^2) - 4 m g l I3 Gamma3 Pi1 is conserved if Pi.Gamma = 0, and
        only then.
        """
        moments = (positive("axial", axial), real("weight_moment", weight_moment))
        return cls._of(_native.Top.goryachev_chaplygin(*moments))

    @property
    def inertia(self) -> Floats:
        """The principal moments of inertia about the support, kg m^2."""
        return np.array(self._top.inertia)

    @property
    def principal_axes(self) -> Floats:
        """The rotation A whose columns are the principal axes: the inertia matrix is A diag(inertia) A^T."""
        return np.array(self._top.principal_axes)

    @property
    def weight_moment(self) -> float:
        """The weight moment m g l, N m."""
        return self._top.weight_moment

    @property
    def center_of_mass(self) -> Floats:
        """The direction of the centre of mass in the body frame."""
        return np.array(self._top.center_of_mass)

    @property
    def invariants(self) -> tuple[str, ...]:
        """The symbols of the invariants.

        Every top has the energy h (J) and the Casimirs f1 = |Gamma|^2 and f2 = Pi.Gamma (kg m^2/s). A free body has
        C = |Pi|^2. Some tops have one more: that of Lagrange f3 = Pi3, that of Kovalevskaya K, and a sphere f3 = Pi.c
        wherever its centre of mass is. The moments and the centre of mass decide which it is, however the top was made. G
        of Goryachev and Chaplygin is conserved only if Pi.Gamma = 0; the runs from such a state have it, and it is not
        listed here. The constructors give the formulas; if the symmetry axis is not the third, the indices are permuted
        cyclically.
        """
        return tuple(self._top.invariants)

    def invariant_values(self, y: ArrayLike) -> dict[str, Floats]:
        """Returns the invariants of states of shape (6,) or (6, n), by symbol; also G if it is conserved from each of them."""
        states = array("y", y)
        if states.ndim not in (1, 2) or states.shape[0] != 6:
            raise ValueError(f"y must have the shape (6,) or (6, n), got {states.shape}")
        rows = states.reshape(6, -1).T
        symbols, values = self._top.invariants_from(rows), self._top.invariant_values(rows)
        return {symbol: values[:, i].reshape(states.shape[1:]) for i, symbol in enumerate(symbols)}

    def _parameters(self) -> tuple[Any, ...]:
        axes = tuple(map(tuple, self._top.principal_axes))
        return tuple(self._top.inertia), axes, self._top.weight_moment, tuple(self._top.center_of_mass)

    def __eq__(self, other: object) -> bool:
        return self._parameters() == other._parameters() if isinstance(other, TopParameters) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._parameters())

    def __repr__(self) -> str:
        inertia, center = (", ".join(f"{x:g}" for x in v) for v in (self.inertia, self.center_of_mass))
        return f"<Top: I = ({inertia}), m g l = {self.weight_moment:g}, c = ({center})>"
