"""Fluids on the sphere with viscosity, drag, a force, stirring and transport noise."""

import pickle

import numpy as np
import pytest

from heavytop import SphereFluid, SpinLattice, lyapunov, solve_many
from heavytop.array_systems import ArraySystem

REST = {"coefficients": []}
EDDIES = {"degrees": [2, 4]}
STIRRING = {"stirring": {"degrees": [3, 3], "strength": 0.1}}
TRANSPORT = {"transport": {"degrees": [2, 4], "strength": 0.03}}


def test_a_forced_and_damped_harmonic_has_its_closed_form():
    """One degree is no flow for itself: omega = F/lambda (1 - exp(-lambda t)), whatever the step is."""
    damping = {"viscosity": 0.01, "power": 2, "drag": 0.1}
    fluid = SphereFluid(8, damping=damping, torque={"coefficients": [[3, 2, 0.2, -0.1]]})
    run = fluid.solve(REST, step=0.5, end=4)
    rate = 0.1 + 0.01 * 12**2
    exact = (0.2 - 0.1j) / rate * -np.expm1(-rate * run.t)
    assert np.abs(fluid.harmonics(run.y)[:, 3, 2] - exact).max() < 1e-13
    assert run.kept == () and fluid.formulations == ("reduced",)
    # At the start the rate is the force alone.
    assert np.allclose(fluid.harmonics(fluid.rate(fluid.start(**REST)))[3, 2], 0.2 - 0.1j, atol=1e-14)
    flow = SphereFluid(8, damping={"drag": 0.1}).solve(EDDIES, step=0.05, end=1)
    assert flow.check().order == pytest.approx(2, abs=0.1)
    # On a sphere that rotates the drag leaves the vorticity of the rotation as it is.
    rotating = SphereFluid(8, rotation=0.5, damping={"drag": 1.0})
    at_rest = np.sqrt(4 * np.pi / 3)
    run = rotating.solve({"coefficients": [[1, 0, at_rest, 0]]}, step=0.1, end=1)
    assert rotating.harmonics(run.y)[-1, 1, 0].real == pytest.approx(at_rest, abs=1e-13)


def test_the_enstrophy_of_a_stirred_shell_is_exact():
    """Z = (2l + 1) sigma^2/2 lambda in the limit of long times; at lambda t = 8 an e^-16 of it is missing."""
    paths, stirred = 500, SphereFluid(5, damping={"viscosity": 0.05, "drag": 0.2}, noise=STIRRING)
    ends = solve_many(stirred, [REST] * paths, step=2, end=10)
    z = stirred.invariant_values(ends.y)["Z"]
    error = z.std() / np.sqrt(paths)
    assert abs(z.mean() - 7 * 0.01 / 1.6) < 4 * error < 0.006
    assert abs(z.mean() - 7 * 0.01 / 2.2) > 6 * error, "control: another viscosity"


def test_paths_are_functions_of_seed_and_number():
    noisy = SphereFluid(6, damping={"drag": 0.1}, noise={**STIRRING, **TRANSPORT})
    run = noisy.solve(EDDIES, step=0.05, end=1, path=3)
    same = pickle.loads(pickle.dumps(noisy))
    assert np.array_equal(same.solve(EDDIES, step=0.05, end=1, path=3).y, run.y)
    ends = solve_many(noisy, [EDDIES] * 5, step=0.05, end=1)
    assert np.array_equal(ends.y[:, 3], run.y[:, -1]) and not np.array_equal(ends.y[:, 2], run.y[:, -1])
    for more in ({"seed": 2}, {"path": 4}, {"bound": 1}, {"interval": 0.1}):
        other = SphereFluid(6, damping={"drag": 0.1}, noise={**STIRRING, **TRANSPORT, **more})
        path = {} if "path" in more else {"path": 3}
        assert not np.array_equal(other.solve(EDDIES, step=0.05, end=1, **path).y, run.y)
    several = SphereFluid(6, damping={"drag": 0.1}, noise={"stirring": [STIRRING["stirring"]], **TRANSPORT})
    assert np.array_equal(several.solve(EDDIES, step=0.05, end=1, path=3).y, run.y)
    assert np.array_equal(noisy.solve(EDDIES, np.linspace(0, 1, 21), path=3).y, run.y)


def test_transport_noise_keeps_the_enstrophy():
    carried = SphereFluid(6, noise=TRANSPORT)
    for end in (2, -2):
        run = carried.solve(EDDIES, step=0.05, end=end)
        assert run.kept == ("Z",) and run.deviation("Z") < 1e-12 and run.deviation("h") > 1e-4
    # Without terms nothing has changed.
    free = SphereFluid(6)
    assert free.kept == free.invariants == ("h", "Z", "M3", "M1", "M2") == carried.invariants
    usual = free.solve(EDDIES, step=0.05, end=1)
    assert np.array_equal(usual.y, free.solve(EDDIES, step=0.05, end=1, scheme="gauss-8", formulation="reduced").y)


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"damping": 1.0}, "damping must be a mapping such as"),
        ({"damping": {}}, "has no viscosity"),
        ({"damping": {"power": 2, "drag": 1}}, "has no viscosity"),
        ({"damping": {"friction": 1}}, "damping of a fluid has no 'friction'; there are viscosity, power, drag"),
        ({"damping": {"viscosity": -1}}, "viscosity must be 0 or a positive number, it is -1"),
        ({"damping": {"viscosity": np.nan}}, "viscosity must be 0 or a positive number, it is nan"),
        ({"damping": {"viscosity": 1, "power": 0}}, "power must be a whole number from 1 to 32, got 0"),
        ({"damping": {"viscosity": 1, "power": 10**12}}, "power must be a whole number from 1 to 32"),
        ({"damping": {"viscosity": 1, "power": 1.5}}, "power must be a whole number"),
        ({"torque": [[3, 0, 1, 0]]}, "torque must be a mapping such as"),
        ({"torque": {}}, r"must have the shape \(n, 4\)"),
        ({"torque": {"coefficients": [[3, 0, 1]]}}, r"must have the shape \(n, 4\)"),
        ({"torque": {"coefficients": [[4, 0, 1, 0]]}}, "torque must be degrees l from 1 to 3"),
        ({"torque": {"omega": 1}}, "torque of a fluid has no 'omega'"),
        ({"noise": 1}, "noise must be a mapping such as"),
        ({"noise": {}}, "has no transport and no stirring"),
        ({"noise": {"temperature": 1}}, "noise of a fluid has no 'temperature'"),
        ({"noise": {"stirring": 0.1}}, "stirring must be a shell such as"),
        ({"noise": {"stirring": {"degrees": [1, 2]}}}, "stirring must be a shell such as"),
        ({"noise": {"stirring": {"degrees": 2, "strength": 1}}}, "stirring must be a shell such as"),
        ({"noise": {"stirring": {"degrees": [2, 4], "strength": 1}}}, r"degrees from 1 to 3, the least first, got \[2, 4\]"),
        ({"noise": {"transport": {"degrees": [1, 2], "strength": -1}}}, "the strength of transport must be 0 or a positive number, it is -1"),
        ({"noise": {"transport": [{"degrees": [1, 2], "strength": 1, "l": 1}]}}, "transport has no 'l'"),
        ({"noise": {**STIRRING, "bound": 0.5}}, "1 standard deviation or more, it is 0.5"),
        ({"noise": {**STIRRING, "path": 2**53}}, "must be below 9007199254740992"),
    ],
)
def test_what_does_not_fit_is_refused(wrong, message):
    with pytest.raises(ValueError, match=message):
        SphereFluid(4, **wrong)


def test_what_there_is_not_is_refused_with_a_reason():
    viscous, carried = SphereFluid(5, damping={"viscosity": 0.1}), SphereFluid(5, noise=TRANSPORT)
    for end in (-1, 1):
        if end > 0:
            assert viscous.solve(EDDIES, step=0.1, end=end).deviation("Z") > 0.1
            continue
        with pytest.raises(ValueError, match="0 backward in time, where it feeds small eddies, got 0.1"):
            viscous.solve(EDDIES, step=0.1, end=end)
        with pytest.raises(ValueError, match="0 backward in time"):
            solve_many(viscous, [EDDIES] * 2, step=0.1, end=end)
    with pytest.raises(ValueError, match="path is of systems with noise"):
        viscous.solve(EDDIES, step=0.1, end=1, path=1)
    with pytest.raises(ValueError, match="has no reduced gauss-8; reduced has implicit-midpoint"):
        carried.solve(EDDIES, step=0.1, end=1, scheme="gauss-8")
    with pytest.raises(ValueError, match="formulation must be one of reduced"):
        carried.solve(EDDIES, step=0.1, end=1, formulation="direct")
    with pytest.raises(ValueError, match="with friction, forces or noise has no tangent vectors"):
        lyapunov(carried, EDDIES, step=0.1, end=1)
    with pytest.raises(ValueError, match="of the systems of arrays sphere-fluid has one"):
        ArraySystem("spin-lattice", {"shape": [4], "exchange": 1.0}, torque={"coefficients": [[1, 0, 1, 0]]})
    with pytest.raises(TypeError):
        SpinLattice(4, 1.0, torque={"coefficients": [[1, 0, 1, 0]]})
