"""Lattices of spins with friction, and at a temperature."""

import pickle

import numpy as np
import pytest

from heavytop import Event, SphereFluid, SpinChain, SpinLattice, System, VibratingLattice, lyapunov, solve_many
from heavytop.array_systems import ArraySystem

UP = {"direction": [0, 0, 1]}


def ring(spins, temperature, **noise):
    return SpinLattice(spins, exchange=1.0, damping=1.0, noise={"temperature": temperature, **noise})


def energy_of_bond(k):
    """Returns that of a long chain, in units of J, with K = J/kT."""
    return 1 / k - 1 / np.tanh(k)


@pytest.mark.parametrize(("damping", "rates"), [(0.3, (1, 0.3)), ({"friction": 0.5, "form": "gilbert"}, (0.8, 0.4))])
def test_damped_spins_have_their_closed_form(damping, rates):
    """In a field B along e3, s3 = tanh(b B t) and the spin turns by a B t, to the order 2 of the method."""
    factor, friction = rates
    lattice = SpinLattice(3, field=[0, 0, 2.0], damping=damping)
    errors = []
    for step in (0.05, 0.025):
        run = lattice.solve({"direction": [1, 0, 0]}, step=step, end=2)
        x, y, z = run["S"][:, 1].T
        turned = -np.unwrap(np.arctan2(y, x))
        errors.append(max(np.abs(z - np.tanh(2 * friction * run.t)).max(), np.abs(turned - 2 * factor * run.t).max()))
        assert run.kept == ("C",) and run.deviation("C") < 1e-13
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.05) and errors[1] < 2e-3
    assert run.check().order == pytest.approx(2, abs=0.1)
    # The rate is that of Landau, Lifshitz and Gilbert, and damping lowers h.
    s = np.array([0.6, 0.0, 0.8])
    expected = np.cross(s, factor * np.array([0, 0, 2]) + friction * np.cross([0, 0, 2], s))
    assert np.allclose(lattice.rate(np.tile(s, 3)).reshape(3, 3), expected, atol=1e-15)
    assert (np.diff(run.invariants["h"]) < 0).all()


def test_paths_are_functions_of_seed_and_number():
    warm = ring(8, 0.5)
    run = warm.solve(UP, step=0.05, end=5, path=3)
    assert np.array_equal(warm.solve(UP, step=0.05, end=5, path=3).y, run.y)
    assert np.array_equal(pickle.loads(pickle.dumps(warm)).solve(UP, step=0.05, end=5, path=3).y, run.y)
    assert np.array_equal(ring(8, 0.5, path=3).solve(UP, step=0.05, end=5).y, run.y)
    ends = solve_many(warm, [UP] * 5, step=0.05, end=5)
    assert np.array_equal(ends.y[:, 3], run.y[:, -1]) and not np.array_equal(ends.y[:, 2], run.y[:, -1])
    assert ends.deviation("C").max() < 1e-12
    for different in ({"seed": 2}, {"bound": 1}, {"interval": 0.1}):
        assert not np.array_equal(ring(8, 0.5, **different).solve(UP, step=0.05, end=5, path=3).y, run.y)
    # With intervals of their own, paths are seen by shorter steps, too.
    fine = ring(8, 0.5, interval=0.05)
    near, nearer = (fine.solve(UP, step=step, end=2).y[:, -1] for step in (0.00625, 0.003125))
    assert np.abs(near - nearer).max() < 0.1
    # States at times are those of the run.
    assert np.array_equal(warm.solve(UP, np.linspace(0, 5, 101), path=3).y, run.y)


def test_events_along_paths_are_of_the_time_alone():
    warm, damped = ring(8, 0.5), SpinLattice(8, exchange=1.0, damping=1.0)
    strobe = warm.solve(UP, step=0.05, end=50, events=Event(lambda _, t: np.sin(2 * t), terminal=3))
    assert strobe.t_events[0] == pytest.approx(np.pi / 2 * np.arange(1, 4), abs=1e-12) and strobe.status == 1
    fluid = SphereFluid(5, damping={"drag": 0.1}, noise={"stirring": {"degrees": [2, 3], "strength": 0.1}})
    for function in (
        lambda x: x["S"][..., 2].mean() - 0.5,
        lambda x, t: x["S"][..., 2].mean() - t,
        lambda x: x["omega"].mean(),
        lambda x: sum(values.sum() for values in x.values()),
        lambda x: len(x) - 1.0,
    ):
        for system, start in ((warm, UP), (fluid, {"degrees": [2, 3]})):
            with pytest.raises(ValueError, match="events\\[0\\]: a path with noise .*depends on the step"):
                system.solve(start, step=0.05, end=1, events=function)
    # Without noise they are functions of the arrays.
    tilted = damped.solve({"direction": [0.6, 0, 0.8]}, step=0.05, end=1, events=lambda x, t: x["S"][0, 2] - t)
    assert tilted.t_events[0] == pytest.approx([0.8], abs=1e-9)


def test_the_energy_of_a_bond_is_that_of_the_temperature():
    spins, paths = 40, 50
    warm = ring(spins, 1.0)
    ends = solve_many(warm, [UP] * paths, step=0.05, end=15)
    energies = warm.invariant_values(ends.y)["h"] / spins
    error = energies.std() / np.sqrt(paths)
    # The error by the step, of weak order 1, is below 0.002, and the standard error is 0.01.
    assert abs(energies.mean() - energy_of_bond(1.0)) < 4 * error < 0.06
    assert abs(energies.mean() - energy_of_bond(1.5)) > 4 * error, "control"
    assert np.abs(np.linalg.norm(ends.y.reshape(spins, 3, paths), axis=1) - 1).max() < 1e-13


def test_what_a_lattice_tells():
    warm = ring(4, 1.0)
    assert warm.invariants == ("h", "M1", "M2", "M3", "C") and warm.kept == ("C",)
    assert warm.formulations == ("direct",)
    run = warm.solve(UP, step=0.05, end=1)
    assert "deviations: C" in repr(run) and "changes: h" in repr(run)
    assert np.allclose(run.invariants["M3"], run["S"][..., 2].sum(axis=1))
    # Without friction and noise the default is what it was.
    free = SpinLattice(4, exchange=1.0)
    start = {"waves": [1], "cone": 0.3}
    usual = free.solve(start, step=0.05, end=1)
    assert np.array_equal(usual.y, free.solve(start, step=0.05, end=1, scheme="gauss-8", formulation="collective").y)
    assert free.kept == free.invariants
    with pytest.raises(ValueError, match="no way back in time"):
        warm.solve(UP, step=0.05, end=-1)


def test_a_chain_by_formula_has_the_forces_of_systems():
    parameters = {"spins": 3, "exchange": 1.0}
    chain = System(kind="spin-chain", parameters=parameters, damping={"friction": 1.0, "inner_product": 1}, noise={"temperature": 1.0})
    start = np.tile([0.0, 0.0, 1.0], 3)
    run = chain.solve(start, step=0.02, end=1, scheme="implicit-midpoint")
    assert run.deviation("c1") < 1e-12 and "h" not in run.kept
    assert SpinChain(3, 1.0).kept[0] == "h"


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"damping": -1}, "friction must be 0 or a positive number, it is -1"),
        ({"damping": {"theta": 1}}, "damping of a lattice has no 'theta'; there are friction, form"),
        ({"damping": {"form": "gilbert"}}, "damping has no friction"),
        ({"damping": {"friction": 1, "form": "bloch"}}, "form must be one of landau-lifshitz, gilbert"),
        ({"damping": {"friction": 1, "inner_product": 1}}, "has no 'inner_product'"),
        ({"damping": np.nan}, "friction must be 0 or a positive number, it is nan"),
        ({"damping": {"friction": np.inf, "form": "gilbert"}}, "friction must be 0 or a positive number, it is inf"),
        ({"damping": 1, "noise": {"temperature": np.nan}}, "temperature must be 0 or a positive number, it is nan"),
        ({"damping": 0, "noise": {"temperature": 0.5}}, "beside temperature = 0.5 the friction must be a positive number, it is friction = 0"),
        ({"noise": {"temperature": 1}}, "a temperature needs a friction"),
        ({"damping": 1, "noise": {"temperature": -1}}, "it is -1"),
        ({"damping": 1, "noise": {"strength": 1}}, "noise of a lattice has no 'strength'; there are temperature, seed"),
        ({"damping": 1, "noise": {"temperature": 1, "rule": "together"}}, "has no 'rule'"),
        ({"damping": 1, "noise": {}}, "noise of a lattice has no temperature"),
        ({"damping": 1, "noise": 3}, "must be a mapping"),
        ({"damping": 1, "noise": {"temperature": 1, "seed": -1}}, "seed must be a whole number"),
        ({"damping": 1, "noise": {"temperature": 1, "bound": 0.5}}, "1 standard deviation or more, it is 0.5"),
        ({"damping": 1, "noise": {"temperature": 1, "interval": 0}}, "positive number, it is 0"),
        ({"damping": 1, "noise": {"temperature": 1, "path": 2**53}}, "must be below 9007199254740992"),
    ],
)
def test_what_does_not_fit_is_refused(wrong, message):
    with pytest.raises(ValueError, match=message):
        SpinLattice(4, exchange=1.0, **wrong)


def test_what_there_is_not_is_refused_with_a_reason():
    damped, warm = SpinLattice(4, exchange=1.0, damping=1.0), ring(4, 1.0)
    with pytest.raises(ValueError, match="path is of systems with noise"):
        damped.solve(UP, step=0.05, end=1, path=1)
    with pytest.raises(ValueError, match="has no direct gauss-8; direct has implicit-midpoint"):
        warm.solve(UP, step=0.05, end=1, scheme="gauss-8")
    with pytest.raises(ValueError, match="formulation must be one of direct"):
        warm.solve(UP, step=0.05, end=1, formulation="reduced")
    with pytest.raises(ValueError, match="with friction, forces or noise has no tangent vectors"):
        lyapunov(damped, UP, step=0.05, end=1)
    with pytest.raises(ValueError, match="must be at least 0.000005"):
        ring(4, 1.0, interval=1e-9).solve(UP, step=0.05, end=1)
    with pytest.raises(ValueError, match="below 9007199254740992"):
        solve_many(ring(4, 1.0, path=2**53 - 2), [UP] * 3, step=0.05, end=1)
    with pytest.warns(RuntimeWarning, match="the noise turns the state by about 4.0e-1"):
        ring(4, 1.6).solve(UP, step=0.05, end=1)
    with pytest.raises(ValueError, match="spin-lattice has friction, a temperature and a field in time"):
        ArraySystem("vibrating-lattice", {"atoms": 4, "exchange": 1.0}, damping=1.0)
    with pytest.raises(TypeError):
        VibratingLattice(4, 1.0, damping=1.0)


def test_a_temperature_has_no_way_back():
    start = np.tile([1.0, 0.0, 0.0], (4, 1))
    warm = SpinLattice(4, exchange=1.0, damping=1, noise={"temperature": 1})
    with pytest.raises(ValueError, match="no way back in time, where its friction = 1 .* the step is -0.1"):
        warm.solve(start, step=-0.1, end=-1)
    assert SpinLattice(4, exchange=1.0, damping=1).solve(start, step=-0.1, end=-1).t[-1] == -1, "control"
