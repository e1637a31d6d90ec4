"""Bodies with forces of their own, by name."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Union

from numpy.typing import ArrayLike

from . import _native
from .arguments import not_negative, positive, real, vector
from .kinds import RigidBody
from .motors import Motor, formulas_of_motors
from .system import System


class StochasticRigidBody(RigidBody):
    """A free rigid body at a temperature: friction and noise that keep |Pi|; coordinates as of `RigidBody`.

    dPi = Pi x (Omega + theta Pi x Omega) dt + sigma Pi x o dW (Stratonovich) with sigma^2 = 2 theta kT. In the end the states on the
    sphere have the weight exp(-h/kT). This is `RigidBody` with `damping` and `noise`.

    Args:
        moments: the second moments of the mass along each axis, kg m^2.
        friction: theta, s/(kg m^2).
        temperature: kT, J.
        noise: seed, path, rule, interval and bound, as for `System`.
        forces: inputs, drive and torque, as for `System`.

    Example:
        >>> body = StochasticRigidBody([2.5, 1.5, 0.5], friction=2, temperature=0.2)
        >>> run = body.solve([2, 0, 0], step=0.05, end=10, scheme="implicit-midpoint", path=3)
        >>> run.kept, bool(run.deviation("c1") < 1e-13)
        (('c1',), True)
    """

    def __init__(
        self, moments: ArrayLike, friction: float, temperature: float, noise: Union[None, Mapping[str, Any]] = None, **forces: Any
    ) -> None:
        theta, heat = real("friction", friction), real("temperature", temperature)
        super().__init__(moments, damping=theta, noise={**(noise or {}), "temperature": heat}, **forces)


class DrivenTop(System):
    """A heavy top that a motor drives and friction brakes; coordinates Pi and Gamma.

    dPi/dt = Pi x Omega + w Gamma x c + M - k Omega, so that dh/dt = M.Omega - k |Omega|^2: what the motor does, less what
    the friction takes. Only |Gamma| is kept.

    Args:
        inertia: the three principal moments about the support, kg m^2, all of them positive, and none larger than the sum of the
            other two.
        weight_moment: w = m g l, N m, not negative.
        center_of_mass: the direction from the support, a unit vector.
        friction: k, N m s.
        motor: M, N m, in the frame of the body: three numbers, formulas of the coordinates, the time `t`, inputs and I1, I2, I3, or
            tables (times, values, "constant", "linear" or "cubic").
        forces: inputs, drive, damping and noise, as for `System`.

    Example:
        Along the axis of a symmetric top, the spin tends to M/k:

        >>> import math
        >>> top = DrivenTop([0.3, 0.3, 0.2], 1.0, [0, 0, 1], friction=0.05, motor=[0, 0, 1])
        >>> run = top.solve({"Pi": [0, 0, 1], "Gamma": [0.6, 0, 0.8]}, step=0.01, end=10)
        >>> bool(abs(run["Pi3"][-1] - 4 + 3 * math.exp(-2.5)) < 1e-12)
        True
    """

    def __init__(
        self,
        inertia: ArrayLike,
        weight_moment: float,
        center_of_mass: ArrayLike,
        friction: float,
        motor: Sequence[Motor] = (0.0, 0.0, 0.0),
        **forces: Any,
    ) -> None:
        if callable(motor):
            raise ValueError(f"motor must be three numbers, formulas or tables, got {motor!r}; write a function as torque of System")
        if len(motor) != 3:
            raise ValueError(f"motor must have 3 numbers or formulas, got {len(motor)}")
        moments = [positive(f"inertia[{i}]", moment) for i, moment in enumerate(vector("inertia", inertia))]
        weight, center = not_negative("weight_moment", weight_moment), vector("center_of_mass", center_of_mass)
        # The top checks the moments and the direction.
        _native.Top(moments, 1.0, weight, 1.0, center, False)
        parameters: dict[str, ArrayLike] = {
            "I": moments,
            "weight_moment": weight,
            "center_of_mass": center,
            "friction": not_negative("friction", friction),
        }
        torques, forces = formulas_of_motors("motor", motor, forces)
        torque = [f"({force}) - friction*Pi{i}/I{i}" for i, force in enumerate(torques, 1)]
        h = "sum(Pi[i]^2/I[i])/2 + weight_moment*(center_of_mass·Gamma)"
        super().__init__("se(3)", h, parameters=parameters, torque={"Pi": torque}, **forces)
