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

Any other Lie-Poisson system is a `System`: an algebra by an expression or its brackets, and a Hamiltonian as a formula or as a
Python function, which is called once. Vortices, spins, gyrostats and other systems have classes of their own.

The energy is h = (Pi1^2/I1 + Pi2^2/I2 + Pi3^2/I3)/2 + m g l c.Gamma. Signs and frames: dPi/dt = Pi x Omega + m g l Gamma x c and dGamma/dt = Gamma x Omega, where Omega = Pi / I. All numbers are
in SI units, or in any other consistent ones.
"""

from importlib.metadata import version

from . import functions
from ._native import IntegrationError
from .accuracy import Balance, Check
from .array_systems import ArraySystem, ManyVortices, SphereFluid, SpinLattice, VibratingLattice
from .chaos import Chaos, lyapunov
from .directions import vertical
from .ends import Ends
from .ensembles import solve_many
from .events import Event
from .forced_bodies import DrivenTop, StochasticRigidBody
from .kinds import BodyInFluid, EllipticalVortex, Gyrostat, RigidBody, Satellite, SpinChain, TopOnBase, Vortices
from .methods import FORMULATIONS, SCHEMES
from .paths import PathStatistics, Statistics, solve_paths
from .reaction_wheels import ReactionWheels
from .realisation import Realisation
from .solution import Crossings, Solution
from .system import System
from .top import Top
from .top_solution import Report, TopSolution

__version__ = version("heavytop")

__all__ = [
    "ArraySystem",
    "Balance",
    "BodyInFluid",
    "Chaos",
    "Check",
    "Crossings",
    "DrivenTop",
    "EllipticalVortex",
    "Ends",
    "Event",
    "FORMULATIONS",
    "Gyrostat",
    "IntegrationError",
    "ManyVortices",
    "PathStatistics",
    "ReactionWheels",
    "Realisation",
    "Report",
    "RigidBody",
    "Satellite",
    "SCHEMES",
    "Solution",
    "SphereFluid",
    "SpinChain",
    "SpinLattice",
    "Statistics",
    "StochasticRigidBody",
    "System",
    "Top",
    "TopOnBase",
    "TopSolution",
    "VibratingLattice",
    "Vortices",
    "functions",
    "lyapunov",
    "solve_many",
    "solve_paths",
    "vertical",
]
