"""Systems of the library by their own names.

Each takes `inputs`, `drive`, `damping`, `noise` and `torque` by name, as `System` does.
"""

from __future__ import annotations

from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from .arguments import array, count, numbers
from .solution import Floats
from .system import System
from .system_description import State


class BodyInFluid(System):
    """Kirchhoff's rigid body in an ideal fluid; coordinates Pi, the impulsive couple, and P, the impulse.

    The energy at the velocities Omega and v is Omega.I Omega/2 + Omega.D v + v.M v/2.

    Args:
        inertia: I of body and fluid, kg m^2: its three moments, or an array of shape (3, 3).
        masses: M of body and fluid, kg: three masses along the axes, or an array of shape (3, 3).
        coupling: D, kg m, an array of shape (3, 3); 0 for a body with three planes of symmetry.
        forces: inputs, drive, damping, noise and torque, as for `System`.

    Example:
        >>> BodyInFluid([1, 2, 3], [1, 2, 4]).casimirs
        {'c1': 'Pi·P', 'c2': '|P|^2'}
    """

    def __init__(self, inertia: ArrayLike, masses: ArrayLike, coupling: Optional[ArrayLike] = None, **forces: Any) -> None:
        parameters = {"inertia": inertia, "masses": masses, **({} if coupling is None else {"coupling": coupling})}
        super().__init__(kind="body-in-fluid", parameters=parameters, **forces)


class EllipticalVortex(System):
    """Kida's elliptical patch of vorticity in a plane strain; coordinates mu.

    mu = ((a^2 - b^2) cos(2 phi)/2, (a^2 - b^2) sin(2 phi)/2, (a^2 + b^2)/2) with the semi-axes a and b, the first at the angle
    phi to the x-axis, along which the strain stretches: its velocity is e (x, -y). The Casimir is a^2 b^2. A start is given by
    mu, or by the semi-axes and the angle: `{"a": 1.5, "b": 0.5, "angle": 0.3}`. `ellipse` gives them of states.

    Args:
        strength: the vorticity times the product of the semi-axes, m^2/s.
        strain: the rate of strain of the flow around the vortex, 1/s.
        rotation: the angular velocity of that flow, 1/s.
        forces: inputs, drive, damping, noise and torque, as for `System`.

    Example:
        Without strain, an ellipse turns at Kirchhoff's rate w ab/(a + b)^2:

        >>> vortex = EllipticalVortex(0.75)
        >>> run = vortex.solve({"a": 1.5, "b": 0.5}, step=0.01, end=1)
        >>> a, b, angle = vortex.ellipse(run.y)
        >>> round(float(angle[-1]), 9), round(float(a[-1]), 9), round(float(b[-1]), 9)
        (0.1875, 1.5, 0.5)
    """

    def __init__(self, strength: float, strain: float = 0.0, rotation: float = 0.0, **forces: Any) -> None:
        parameters = {"strength": strength, "strain": strain, "rotation": rotation}
        super().__init__(kind="elliptical-vortex", parameters=parameters, **forces)

    def ellipse(self, y: ArrayLike) -> tuple[Floats, Floats, Floats]:
        """Returns the semi-axes a and b, and the angle of the first, from -pi/2 to pi/2, at states of shape (3,) or (3, n)."""
        mu1, mu2, mu3 = self._states("y", y)
        across = np.hypot(mu1, mu2)
        return np.sqrt(mu3 + across), np.sqrt(np.maximum(mu3 - across, 0)), np.arctan2(mu2, mu1) / 2


class Gyrostat(System):
    """A heavy body with a fixed point and a spinning rotor; coordinates Pi and Gamma.

    Args:
        inertia: the three moments of body and rotor about the support, kg m^2.
        weight: m g, N.
        center_of_mass: from the support, m.
        rotor: the angular momentum of the rotor in the body, kg m^2/s.
        forces: inputs, drive, damping, noise and torque, as for `System`.

    Example:
        >>> Gyrostat([2, 2, 1], 1.0, [0, 0, 1], [0, 0, 5]).rate([0, 0, 5, 1, 0, 0])
        array([ 0., -1.,  0.,  0.,  0.,  0.])
    """

    def __init__(self, inertia: ArrayLike, weight: float, center_of_mass: ArrayLike, rotor: ArrayLike, **forces: Any) -> None:
        parameters = {"inertia": inertia, "weight": weight, "center_of_mass": center_of_mass, "rotor": rotor}
        super().__init__(kind="gyrostat", parameters=parameters, **forces)


class RigidBody(System):
    """A free rigid body in n dimensions; coordinates L12, L13, ..., or Pi in three dimensions.

    h = sum L_ij^2/(2 (J_i + J_j)) in the frame of the body, with the second moments J. L is the skew matrix of the angular
    momentum with L_ij in row j and column i, Omega_ij = L_ij/(J_i + J_j), and dL/dt = [L, Omega]. In three dimensions Pi = (L23, -L13,
    L12), with the moments of inertia J_2 + J_3 and so on.

    Args:
        dimension: n, which may be left out, as in `RigidBody(moments)`.
        moments: the n second moments of the mass along each axis, kg m^2.
        forces: inputs, drive, damping, noise and torque, as for `System`.

    Example:
        >>> RigidBody(4, [1, 1.5, 2, 2.5]).coordinates
        ('L12', 'L13', 'L14', 'L23', 'L24', 'L34')
    """

    def __init__(self, dimension: Union[int, ArrayLike, None] = None, moments: Optional[ArrayLike] = None, **forces: Any) -> None:
        if moments is None:
            dimension, moments = None, dimension
        if moments is None:
            raise ValueError("moments are missing: the second moments of the mass along each axis")
        given = numbers("moments", moments)
        if dimension is not None and count("dimension", dimension, 2) != len(given):
            raise ValueError(f"moments must have the shape ({dimension},), one for each of {dimension} axes, got {given.shape}")
        super().__init__(kind="rigid-body", parameters={"moments": given}, **forces)


class Satellite(System):
    """A rigid satellite on a circle or an ellipse, turned by the gradient of gravity; coordinates Pi, Gamma_1 and Gamma_2.

    In the frame of the body, Pi is the angular momentum against the stars, Gamma_1 the direction from the centre of attraction to
    the satellite, and Gamma_2 the normal of the orbit. h is Jacobi's integral on a circle. On an ellipse it depends on the time.
    Formulas may name the rate and the tide of the orbit, orbit_rate (rad/s) and orbit_tide = GM/r^3 (1/s^2), which are n and n^2 on a
    circle. A torque acts on Pi, and on l of wheels. A start is given by
    the coordinates, or by angles in radians and the angular velocity against the orbit: `{"roll": 0.1, "pitch": 0.2, "yaw": 0,
    "relative": [0, 0, 0]}`, of which each may be left out. Without turns, the axes of the body are along the velocity, the normal and the radius.

    Args:
        moments: the three principal moments, kg m^2.
        rate: the angular velocity of the orbit, rad/s; its mean on an ellipse.
        eccentricity: of the orbit, below 1.
        mean_anomaly: at the time 0, rad; 0, at the pericentre, unless it is given.
        true_anomaly: at the time 0, rad, instead of the mean anomaly.
        axes: of reaction wheels in the frame of the body, an array of shape (n, 3). Their angular momenta are coordinates l, their
            motors a torque on l, and a start by angles may have `speeds` of the wheels against the body, rad/s: `ReactionWheels`.
        inertias: of the wheels about their axes, kg m^2, a number or n of them; the moments are without these.
        forces: inputs, drive, damping, noise and torque, as for `System`.

    Example:
        A boom along the radius swings in the plane of the orbit with the frequency n sqrt(3 (I1 - I3)/I2) of small angles:

        >>> boom = Satellite([1, 1.2, 0.4], 1e-3)
        >>> run = boom.solve({"pitch": 1e-3}, step=60, end=6000, events="Gamma_1[1]")
        >>> half = float(np.diff(run.t_events[0])[0])
        >>> round(np.pi / half / 1e-3, 6), round((3 * 0.6 / 1.2) ** 0.5, 6)
        (1.224745, 1.224745)
    """

    def __init__(
        self,
        moments: ArrayLike,
        rate: float,
        eccentricity: float = 0.0,
        mean_anomaly: Optional[float] = None,
        true_anomaly: Optional[float] = None,
        axes: Optional[ArrayLike] = None,
        inertias: Optional[ArrayLike] = None,
        **forces: Any,
    ) -> None:
        anomalies = {"mean_anomaly": mean_anomaly, "true_anomaly": true_anomaly}
        orbit = {"eccentricity": eccentricity, **{name: angle for name, angle in anomalies.items() if angle is not None}}
        wheels = {**({} if axes is None else {"axes": axes}), **({} if inertias is None else {"J": inertias})}
        super().__init__(kind="satellite", parameters={"I": moments, "n": rate, **orbit, **wheels}, **forces)

    def angles(self, y: ArrayLike) -> tuple[Floats, Floats, Floats]:
        """Returns roll, pitch and yaw, in radians, at states of shape (d,) or (d, n); the pitch is from -pi/2 to pi/2."""
        r1, r2, r3, n1, n2, n3 = self._states("y", y)[3:9]
        roll = np.arctan2(r2, r3)
        pitch = -np.arctan2(r1, np.hypot(r2, r3))
        # The axes e1 and e2 of the body turned back by the roll; the first component of the normal is sin(yaw) cos(pitch).
        across = n2 * np.cos(roll) - n3 * np.sin(roll)
        along = n1 * np.cos(pitch) + (n2 * np.sin(roll) + n3 * np.cos(roll)) * np.sin(pitch)
        return roll, pitch, np.arctan2(along, across)


class TopOnBase(System):
    """A heavy top on a base that moves freely; coordinates Pi, P and Gamma.

    Args:
        inertia: the three moments of the top about the support, kg m^2.
        mass: of the top, kg.
        base_mass: of the base, kg.
        gravity: m/s^2.
        center_of_mass: of the top from the support, m.
        forces: inputs, drive, damping, noise and torque, as for `System`.
    """

    def __init__(
        self, inertia: ArrayLike, mass: float, base_mass: float, gravity: float, center_of_mass: ArrayLike, **forces: Any
    ) -> None:
        masses = {"mass": mass, "base_mass": base_mass, "gravity": gravity}
        super().__init__(kind="top-on-base", parameters={"inertia": inertia, "center_of_mass": center_of_mass, **masses}, **forces)


ON_SPHERE = 1e-5
"""The largest distance of a vortex from the unit sphere, that of positions with six digits."""


class _Vectors(System):
    """A system of N vectors, whose states may be arrays of shape (N, 3)."""

    def _state(self, y0: State) -> Floats:
        if not hasattr(y0, "keys") and np.shape(y0) in self._shapes_of_state():
            y0 = array("y0", y0).reshape(-1)
        return super()._state(y0)

    def _shape_of_state(self) -> str:
        return f"({self.dimension // 3}, 3) or ({self.dimension},)"

    def _shapes_of_state(self) -> list[tuple[int, ...]]:
        return [(self.dimension // 3, 3)]

    def _vectors(self, y: ArrayLike) -> Floats:
        states = self._states("y", y)
        return np.moveaxis(states.reshape(-1, 3, *states.shape[1:]), (0, 1), (-2, -1))


class SpinChain(_Vectors):
    """Classical spins in a row, with the plus bracket; coordinates S_1, S_2, ...

    h = -J sum s_i.s_(i+1) - K sum s_i3^2 - B.sum s_i. A start is an array of shape (N, 3), or as for `System.solve`.

    Args:
        spins: how many there are, 2 to 85. `SpinLattice` has more.
        exchange: J; positive for a ferromagnet.
        anisotropy: K; positive for an easy axis.
        field: B.
        periodic: whether the last spin has a bond with the first.
        forces: inputs, drive, damping, noise and torque, as for `System`.

    Example:
        A spin wave of a small amplitude turns at 2 J (1 - cos k):

        >>> i = np.arange(8)
        >>> k = 2 * np.pi / 8
        >>> wave = np.stack([1e-4 * np.cos(k * i), 1e-4 * np.sin(k * i), np.ones(8)], axis=1)
        >>> chain = SpinChain(8, 1.0)
        >>> run = chain.solve(wave, step=0.1, end=1)
        >>> s = chain.spins(run.y)
        >>> s.shape
        (11, 8, 3)
        >>> turned = np.arctan2(s[-1, 0, 1], s[-1, 0, 0])
        >>> bool(abs(abs(turned) - 2 * (1 - np.cos(k))) < 1e-6)
        True
    """

    def __init__(
        self,
        spins: int,
        exchange: float,
        anisotropy: float = 0.0,
        field: Optional[ArrayLike] = None,
        periodic: bool = True,
        **forces: Any,
    ) -> None:
        parameters = {
            "spins": spins,
            "exchange": exchange,
            "anisotropy": anisotropy,
            "field": [0.0, 0.0, 0.0] if field is None else field,
            "periodic": float(periodic),
        }
        super().__init__(kind="spin-chain", parameters=parameters, **forces)

    def spins(self, y: ArrayLike) -> Floats:
        """Returns the spins at states of shape (d,) or (d, n), as an array of shape (N, 3) or (n, N, 3)."""
        return self._vectors(y)


class Vortices(_Vectors):
    """Point vortices on the unit sphere; coordinates m_1, m_2, ..., the positions times the strengths.

    A start is given by the positions, an array of shape (N, 3), here or to `solve`.

    Args:
        strengths: the circulation of each vortex, m^2/s; up to 48. `ManyVortices` has more.
        positions: on the unit sphere, of shape (N, 3), for runs that are given no start.
        forces: inputs, drive, damping, noise and torque, as for `System`.

    Example:
        Two equal vortices turn about the point between them, at the rate k/(4 pi) for a right angle:

        >>> pair = Vortices([1.0, 1.0], [[1, 0, 0], [0, 1, 0]])
        >>> run = pair.solve(step=0.1, end=10)
        >>> pair.positions(run.y).shape
        (101, 2, 3)
        >>> bool(abs(pair.positions(run.y)[-1].sum(axis=0) - [1, 1, 0]).max() < 1e-13)
        True
    """

    def __init__(self, strengths: ArrayLike, positions: Optional[ArrayLike] = None, **forces: Any) -> None:
        self._strengths = numbers("strengths", strengths)
        super().__init__(kind="vortices", parameters={"strengths": self._strengths}, **forces)
        if positions is not None:
            if np.shape(positions) not in self._shapes_of_state():
                raise ValueError(f"positions must have the shape {self._shapes_of_state()[0]}, got {np.shape(positions)}")
            self._first = self._state(positions)

    def _state(self, y0: State) -> Floats:
        if not hasattr(y0, "keys") and np.shape(y0) in self._shapes_of_state():
            y0 = {"positions": array("y0", y0)}
        state = super()._state(y0)
        lengths = np.linalg.norm(self.positions(state), axis=1)
        away = np.flatnonzero(abs(lengths - 1) > ON_SPHERE)
        if away.size:
            i = int(away[0])
            raise ValueError(
                f"m_{i + 1} must have the length of strength {self._strengths[i]}, got {lengths[i] * abs(self._strengths[i])}: "
                f"a flat state has the positions times the strengths, and an array of shape {np.shape(self.positions(state))} "
                "has the positions"
            )
        return state

    def positions(self, y: ArrayLike) -> Floats:
        """Returns the positions at states of shape (d,) or (d, n), as an array of shape (N, 3) or (n, N, 3)."""
        return self._vectors(y) / self._strengths[:, None]
