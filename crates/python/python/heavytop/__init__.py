"""Heavy tops by collective Lie-Poisson integrators.

A heavy top is a rigid body that turns about a fixed point under gravity. Its state is (Pi, Gamma): the angular momentum
and the upward vertical, both in the body frame. The default method, and every other that `Top.solve` says so of, conserves the
Casimirs |Gamma|^2 and Pi.Gamma to round-off and the energy without drift, in runs of any length.

    >>> import heavytop
    >>> top = heavytop.Top.kovalevskaya()
    >>> run = top.solve(Pi=[2, 3, 4], Gamma=[0.6, 0, 0.8], step=0.1, end=100, scheme="gauss-12")
    >>> run.y.shape
    (6, 1001)
    >>> bool(abs(run.invariants["f1"] - 1).max() < 1e-13)
    True

The energy is h = (Pi1^2/I1 + Pi2^2/I2 + Pi3^2/I3)/2 + m g l c.Gamma. Signs and frames: dPi/dt = Pi x Omega + m g l Gamma x c and dGamma/dt = Gamma x Omega, where Omega = Pi / I. All numbers are
in SI units, or in any other consistent ones.
"""

from importlib.metadata import version

from ._native import IntegrationError
from .ensembles import Ends, solve_many
from .solution import Crossings, Solution
from .top import FORMULATIONS, SCHEMES, Top

__version__ = version("heavytop")

__all__ = [
    "Crossings",
    "Ends",
    "FORMULATIONS",
    "IntegrationError",
    "SCHEMES",
    "Solution",
    "Top",
    "solve_many",
]
