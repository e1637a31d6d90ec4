"""A rigid body that motors turn by reaction wheels."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from .arguments import numbers
from .motors import Motor, formulas_of_motors
from .solution import Floats
from .system import System


class ReactionWheels(System):
    """A free rigid body with balanced wheels about any axes; coordinates Pi and l.

    Pi is the angular momentum of the body with its wheels, in the frame of the body, and l that of each wheel about its axis,
    against the stars. dPi/dt = Pi x Omega and dl/dt = u, the torques of the motors, with Omega = (Pi - sum l_k a_k)/I. The motors
    are inside, so that |Pi| is conserved, whatever they do. A start is given by Pi and l, or by `{"Omega": [0, 0.1, 0], "speeds":
    [10, 0]}`, the angular velocity of the body and the speeds of the wheels against it, of which each may be left out.

    Args:
        moments: of the body with its wheels, without those of the wheels about their axes, kg m^2.
        axes: of the wheels in the frame of the body, an array of shape (n, 3) of vectors of any length but 0.
        inertias: of the wheels about their axes, kg m^2, a number or n of them.
        motors: n torques on the wheels, N m, each a number, a formula of the coordinates, the time `t` and inputs, or a table
            (times, values, "constant", "linear" or "cubic"). Without them the wheels turn freely.
        forces: inputs, drive, damping, noise and torque, as for `System`; with motors, no torque.

    Example:
        A motor of 0.02 N m takes up the spin of 1 kg m^2/s in 50 s:

        >>> body = ReactionWheels([3, 2, 1.5], [[0, 1, 0]], 0.1, motors=[([0, 50, 60], [0.02, 0, 0], "constant")])
        >>> run = body.solve({"Pi": [0, 1, 0], "l": 0}, step=1, end=60)
        >>> bool(abs(body.angular_velocity(run.y)[1, -1]) < 1e-13), bool(abs(run["Pi2"] - 1).max() < 1e-13)
        (True, True)
    """

    def __init__(
        self, moments: ArrayLike, axes: ArrayLike, inertias: ArrayLike, motors: Optional[Sequence[Motor]] = None, **forces: Any
    ) -> None:
        rows = numbers("axes", np.reshape(axes, -1))
        parameters = {"I": numbers("moments", moments), "axes": rows, "J": inertias}
        if motors is not None:
            if "torque" in forces:
                raise ValueError("torque: write motors, or a torque on l, and not both")
            torques, forces = formulas_of_motors("motors", motors, forces)
            forces["torque"] = {"l": torques}
        super().__init__(kind="reaction-wheels", parameters=parameters, **forces)
        units = rows.reshape(-1, 3)
        self._axes = units / np.linalg.norm(units, axis=1)[:, None]
        self._inertia = numbers("moments", moments)
        self._wheels = np.broadcast_to(np.asarray(inertias, dtype=float), len(units))

    def angular_velocity(self, y: ArrayLike) -> Floats:
        """Returns the angular velocity of the body, rad/s, at states of shape (d,) or (d, n), as an array of shape (3,) or (3, n)."""
        states = self._states("y", y)
        body = states[:3] - np.tensordot(self._axes.T, states[3:], 1)
        return np.asarray(body / self._inertia.reshape(-1, *[1] * (states.ndim - 1)))

    def speeds(self, y: ArrayLike) -> Floats:
        """Returns the speeds of the wheels against the body, rad/s, at states of shape (d,) or (d, n)."""
        states = self._states("y", y)
        own = states[3:] / self._wheels.reshape(-1, *[1] * (states.ndim - 1))
        return np.asarray(own - np.tensordot(self._axes, self.angular_velocity(states), 1))
