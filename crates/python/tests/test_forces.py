"""Systems that are driven, damped, noisy, or under a torque, and Hamiltonians with time."""

import pickle

import numpy as np
import pytest

from heavytop import SpinChain, SpinLattice, System, lyapunov, solve_many

SPIN = [1.0, 0.0, 0.0]

INPUTS = {"u": ([0, 2.03, 5], [0, 0.4, -0.2], "linear")}


def test_a_function_of_time_is_the_formula():
    text = System("so(3)", "-2*Pi3 - 0.3*(cos(2*t)*Pi1 - sin(2*t)*Pi2)", bracket="plus")
    traced = System("so(3)", lambda x, t: -2 * x.Pi3 - 0.3 * (np.cos(2 * t) * x.Pi1 - np.sin(2 * t) * x.Pi2), bracket="plus")
    for system in (text, traced):
        run = system.solve([0, 0, 1], step=0.1, end=10)
        # Rabi's resonance: about the field that turns with the spin.
        assert abs(run.y[2, -1] - np.cos(3)) < 1e-10
        assert run.kept == ("c1",) and "changes: h" in repr(run) and "deviations: c1" in repr(run)
    assert np.array_equal(text.solve([0, 0, 1], step=0.1, end=2).y, traced.solve([0, 0, 1], step=0.1, end=2).y)
    # Values of h are those of the times.
    h = text.solve([0, 0, 1], step=0.1, end=10).invariants["h"]
    run = text.solve([0, 0, 1], np.linspace(0, 10, 101))
    assert np.allclose(run.invariants["h"], h, atol=1e-14)
    assert text.invariant_values([1, 0, 0], 0.5)["h"] == pytest.approx(-0.3 * np.cos(1))
    assert np.allclose(text.rate([0, 0, 1], 0.25), [0.3 * np.sin(0.5), 0.3 * np.cos(0.5), 0], atol=1e-15)
    # A parameter of this name is a number.
    assert System("so(3)", "t*Pi3", parameters={"t": 2.0}).kept == ("h", "c1")


@pytest.mark.parametrize("friction", [0.5, {"friction": 0.25, "inner_product": 2}, {"friction": 1, "inner_product": [0.5, 0.5, 0.5]}])
def test_a_damped_spin_has_its_closed_form(friction):
    run = System("so(3)", "-Pi3", damping=friction).solve(SPIN, step=0.1, end=10)
    assert abs(run.y[2, -1] - np.tanh(5)) < 1e-12
    assert (np.diff(run.invariants["h"]) < 0).all() and run.deviation("c1") < 1e-13


@pytest.mark.parametrize(("form", "rates"), [("landau-lifshitz", (1, 0.5)), ("gilbert", (0.8, 0.2))])
def test_a_spin_has_the_closed_form_of_each_damping(form, rates):
    """A spin of length 2 in a field 3 along e3: s3 = 2 tanh(2 b B t), and it turns by a B t."""
    factor, friction = rates
    run = System("so(3)", "-3*Pi3", bracket="plus", damping={"friction": 0.5, "form": form}).solve([2, 0, 0], step=0.05, end=2)
    x, y, z = run.y
    assert np.abs(z - 2 * np.tanh(2 * friction * 3 * run.t)).max() < 1e-9 and run.deviation("c1") < 1e-13
    early = run.t < 1
    assert np.abs(np.unwrap(np.arctan2(y, x))[early] + factor * 3 * run.t[early]).max() < 1e-9


def test_forms_of_damping_are_of_spins():
    spins = np.random.default_rng(1).normal(size=9)
    by_name = SpinChain(3, 1.0, damping={"friction": 0.4, "form": "gilbert"})
    run = by_name.solve(spins, step=0.05, end=5)
    assert np.abs(np.linalg.norm(run.y.reshape(3, 3, -1), axis=1) - np.linalg.norm(spins.reshape(3, 3), axis=1)[:, None]).max() < 1e-13
    assert (np.diff(run.invariants["h"]) < 0).all()
    # Gilbert's equation of each spin, in the plus bracket; the chain and the lattice have one rate.
    free, rate = SpinChain(3, 1.0).rate(spins).reshape(3, 3), by_name.rate(spins).reshape(3, 3)
    lengths = np.linalg.norm(spins.reshape(3, 3), axis=1)[:, None]
    assert np.allclose(rate, free - 0.4 / lengths * np.cross(spins.reshape(3, 3), rate), atol=1e-14)
    lattice = SpinLattice(3, 1.0, damping={"friction": 0.4, "form": "gilbert"})
    assert np.allclose(lattice.rate(spins).reshape(3, 3), rate, atol=1e-14)
    # One friction for all spins needs no inner product.
    one = SpinChain(3, 1.0, damping={"friction": 0.4, "form": "landau-lifshitz"})
    other = SpinChain(3, 1.0, damping={"friction": 0.4, "inner_product": 1})
    assert np.array_equal(one.rate(spins), other.rate(spins))
    assert np.array_equal(pickle.loads(pickle.dumps(one)).rate(spins), one.rate(spins))
    with pytest.raises(ValueError, match="a form of damping is of spins, .*: se\\(3\\) has friction with inner_product"):
        System("se(3)", "Pi3", damping={"friction": 1, "form": "landau-lifshitz"})


def test_spins_with_gilberts_damping_have_langevins_means():
    pair = System("so(3)^2", "-Pi_1_3 - Pi_2_3", damping={"friction": 1, "form": "gilbert"}, noise={"temperature": 0.5})
    start = np.tile([[1.0], [0], [0], [0], [2], [0]], 1000)
    ends = solve_many(pair, start, step=0.1, end=12, scheme="implicit-midpoint")
    for length, s3 in ((1, ends.y[2]), (2, ends.y[5])):
        error = s3.std() / np.sqrt(s3.size)
        langevin = lambda x: length * (1 / np.tanh(x) - 1 / x)  # noqa: E731
        assert abs(s3.mean() - langevin(2 * length)) < 4 * error < 0.08
        assert abs(s3.mean() - langevin(length)) > 4 * error, "control: twice the temperature"


def test_a_drive_adds_to_the_differential_in_every_form():
    whole = System("so(3)", "Pi1^2/2 + cos(t)*Pi3")
    expected = whole.solve([0.6, 0.5, 0.3], step=0.1, end=5).y
    for drive in (lambda x, t: [0, 0, np.cos(t)], {"Pi": [0, 0, "cos(t)"]}, {"Pi3": "cos(t)"}, ["0", 0.0, "cos(t)"]):
        run = System("so(3)", "Pi1^2/2", drive=drive).solve([0.6, 0.5, 0.3], step=0.1, end=5)
        assert np.abs(run.y - expected).max() < 1e-12


def test_a_torque_changes_the_casimirs():
    body = System("so(3)", "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2", torque=lambda x: -0.1 * x.Pi)
    run = body.solve([1, 2, 3], step=0.1, end=10)
    assert run.kept == () and body.formulations == ("direct",)
    assert np.linalg.norm(run.y[:, -1]) / np.linalg.norm(run.y[:, 0]) == pytest.approx(np.exp(-1), rel=1e-12)
    with pytest.raises(ValueError, match="formulation must be one of direct"):
        body.solve([1, 2, 3], step=0.1, end=10, formulation="collective")


def test_inputs_are_tables_in_formulas_and_functions():
    inputs = {"u": ([0, 1, 2], [1, 0, 2], "linear")}
    text = System("so(3)", "u*Pi3", inputs=inputs)
    traced = System("so(3)", lambda x: x.u * x.Pi3, inputs=inputs)
    for system in (text, traced):
        x, y, _ = system.solve(SPIN, step=0.1, end=2).y[:, -1]
        assert np.arctan2(y, x) == pytest.approx(-1.5, abs=1e-13)
    with pytest.raises(ValueError, match="from 0 to 2, and the run from 0 to 3"):
        text.solve(SPIN, step=0.1, end=3)
    with pytest.raises(ValueError, match="from 0 to 2, and the run from 0 to 3"):
        solve_many(text, np.tile([[1.0], [0], [0]], 3), step=0.1, end=3)


def test_paths_are_functions_of_seed_and_number():
    warm = System("so(3)", "-Pi3", damping=1, noise={"temperature": 0.5})
    run = warm.solve(SPIN, step=0.1, end=20, path=3)
    assert np.array_equal(warm.solve(SPIN, step=0.1, end=20, path=3).y, run.y)
    assert np.array_equal(pickle.loads(pickle.dumps(warm)).solve(SPIN, step=0.1, end=20, path=3).y, run.y)
    ends = solve_many(warm, np.tile([[1.0], [0], [0]], 5), step=0.1, end=20)
    assert np.array_equal(ends.y[:, 3], run.y[:, -1]) and ends.deviation("c1").max() < 1e-13
    other = System("so(3)", "-Pi3", damping=1, noise={"temperature": 0.5, "path": 3})
    assert np.array_equal(other.solve(SPIN, step=0.1, end=20).y, run.y)
    for different in ({"seed": 2}, {"rule": "alternating"}, {"bound": 1}):
        system = System("so(3)", "-Pi3", damping=1, noise={"temperature": 0.5, **different})
        assert not np.array_equal(system.solve(SPIN, step=0.1, end=20, path=3).y, run.y)
    # With intervals of their own, paths are seen by shorter steps, too.
    fine = System("so(3)", "-Pi3", damping=1, noise={"temperature": 0.5, "interval": 0.1})
    near, nearer = (fine.solve(SPIN, step=step, end=20, path=3).y[:, -1] for step in (0.0125, 0.00625))
    assert np.abs(near - nearer).max() < 0.1


def test_an_ensemble_has_langevins_mean():
    warm = System("so(3)", "-Pi3", damping=1, noise={"temperature": 0.5})
    s3 = solve_many(warm, np.tile([[1.0], [0], [0]], 2000), step=0.1, end=10, scheme="implicit-midpoint").y[2]
    error = s3.std() / np.sqrt(s3.size)
    assert abs(s3.mean() - (1 / np.tanh(2) - 1 / 2)) < 4 * error < 0.05
    # Control: the mean of half the temperature.
    assert abs(s3.mean() - (1 / np.tanh(4) - 1 / 4)) > 4 * error


def test_noise_by_fields_and_by_a_strength():
    still = System("so(3)", "0*Pi3", noise={"fields": [{"Pi": [0, 0, 0.5]}]})
    x, y, z = still.solve(SPIN, step=0.1, end=5).y
    assert np.abs(z).max() < 1e-14 and np.abs(y).max() > 1e-3
    one = System("so(3)", "0*Pi3", noise={"strength": 0.5})
    other = System("so(3)", "0*Pi3", noise={"strength": 0.25, "inner_product": 4})
    assert np.abs(one.solve(SPIN, step=0.1, end=5).y - other.solve(SPIN, step=0.1, end=5).y).max() < 1e-12


def test_exponents_of_a_damped_spin_are_those_of_the_friction():
    """At the pole small vectors across shrink at theta B |Pi|, and those along Pi stay, since |Pi|^2 is a Casimir."""
    spin = System("so(3)", "-1.5*Pi3", damping=0.3)
    found = lyapunov(spin, [0, 0, 2], step=0.1, end=100, exponents=3)
    assert found.exponents.sum() == pytest.approx(-2 * 0.3 * 1.5 * 2, abs=1e-12)
    # Finding the direction that stays costs a stretch of about 1.
    assert np.abs(found.exponents - [0, -0.9, -0.9]).max() < 0.03
    assert np.abs(found.exponents + 0.9).max() > 0.5, "control"
    # A torque -k Pi shrinks every vector.
    slowed = System("so(3)", "cos(t)*Pi1", torque=lambda x: -0.2 * x.Pi)
    found = lyapunov(slowed, SPIN, step=0.1, end=20, exponents=3, every=50)
    assert np.abs(found.exponents + 0.2).max() < 1e-12 and found.exponents.shape == (3, 4)


def test_tangent_vectors_of_a_driven_body_are_differences_of_runs():
    body = System("so(3)", "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2 + 0.5*cos(1.3*t)*Pi1", damping={"friction": 0.02}, inputs=INPUTS, drive=["0", "u", "0"])
    start, step, end = np.array([0.1, 1.0, 0.2]), 0.1, 5
    found = lyapunov(body, start, step=step, end=end, exponents=3)
    ends = [body.solve(start + small * e, step=step, end=end, formulation="direct").y[:, -1] for e in np.eye(3) for small in (1e-5, -1e-5)]
    derivative = np.array([(after - before) / 2e-5 for after, before in zip(ends[::2], ends[1::2])]).T
    # The volume of the parallelepiped of all tangent vectors is the determinant of the derivative. Central differences are right to 1e-9.
    assert found.exponents.sum() * end == pytest.approx(np.log(np.linalg.det(derivative)), abs=1e-8)
    assert np.array_equal(found.y, body.solve(start, step=step, end=end, formulation="direct").y[:, -1])
    # Control: without the friction the volume stays.
    free = System("so(3)", "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2 + 0.5*cos(1.3*t)*Pi1", inputs=INPUTS, drive=["0", "u", "0"])
    assert abs(lyapunov(free, start, step=step, end=end, exponents=3).exponents.sum()) < 1e-12 < abs(found.exponents.sum())


def test_exponents_of_noisy_motions_are_those_of_their_paths():
    warm = System("so(3)", "-Pi3", damping=1, noise={"temperature": 0.1})
    many = lyapunov(warm, np.tile([[1.0], [0], [0]], 3), step=0.1, end=10, exponents=2)
    for path in range(3):
        one = lyapunov(System("so(3)", "-Pi3", damping=1, noise={"temperature": 0.1, "path": path}), SPIN, step=0.1, end=10, exponents=2)
        assert np.array_equal(one.exponents, many.exponents[:, path])
        assert np.array_equal(one.y, warm.solve(SPIN, step=0.1, end=10, path=path, formulation="direct").y[:, -1])
    assert len(np.unique(many.exponents[1])) == 3 and (many.exponents[1] < -0.3).all()
    last = System("so(3)", "-Pi3", noise={"strength": 0.1, "path": 2**53 - 1})
    assert set(lyapunov(last, np.tile([[1.0], [0], [0]], 2), step=0.1, end=1).failures) == {1}


def test_sections_once_a_period_and_of_the_state():
    """In the frame of a field that turns the spin turns about (b, 0, B - w)."""
    h = "-2*Pi3 - 0.3*(cos(1.6*t)*Pi1 - sin(1.6*t)*Pi2)"
    spin, start = System("so(3)", h, bracket="plus"), [0, 0.6, 0.8]
    for surface in ("sin(1.6*t)", lambda x, t: np.sin(1.6 * t)):
        points = spin.section(start, surface, step=0.1, end=40)
        assert np.abs(points.t - 2 * np.pi / 1.6 * np.arange(1, 11)).max() < 1e-12
        assert np.abs(0.3 * points.y[0] + 0.4 * points.y[2] - 0.4 * 0.8).max() < 1e-9
    later = spin.section(start, "sin(1.6*t)", value=0.5, step=0.1, end=40)
    assert np.ptp(0.3 * later.y[0] + 0.4 * later.y[2]) > 1e-2, "control"
    damped = System("so(3)", "-2*Pi3", damping=0.1)
    (time,) = damped.section(SPIN, "Pi3", value=0.5, step=0.1, end=10).t
    assert time == pytest.approx(np.arctanh(0.5) / 0.2, abs=1e-10)


def test_a_noise_has_sections_at_times_alone():
    warm = System("so(3)", "-Pi3", damping=1, noise={"temperature": 0.1})
    points = warm.section(SPIN, "sin(2*acos(-1)*(t - 0.5))", step=0.1, end=4, path=2)
    run = warm.solve(SPIN, step=0.1, end=4, path=2)
    assert np.abs(points.t - [0.5, 1.5, 2.5, 3.5]).max() < 1e-12
    # The times are right to rounding, and noise moves the state by the root of that.
    assert np.abs(points.y - run.y[:, [5, 15, 25, 35]]).max() < 1e-5
    for surface in ("Pi3 - 0.5", lambda x: x.Pi3, lambda x, t: x.Pi1 - t, "t*Pi2"):
        with pytest.raises(ValueError, match="depends on the step"):
            warm.section(SPIN, surface, step=0.1, end=4)
    assert warm.section(SPIN, lambda x, t: t - 1, step=0.1, end=4).t.size == 1
    for event in ("Pi3 - 0.5", lambda x, t: x.Pi1 - t, ["t - 1", "t*Pi2"]):
        with pytest.raises(ValueError, match="depends on the step"):
            warm.solve(SPIN, step=0.1, end=4, events=event)
    (times,) = warm.solve(SPIN, step=0.1, end=4, events="t - 1").t_events
    assert times == pytest.approx([1], abs=1e-12)


def test_a_balance_tells_what_forces_supply():
    torque = ["sin(t)", "-0.2*Pi2", "0"]
    body = System("so(3)", "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2", torque=torque)
    defects = []
    for step in (0.2, 0.1):
        run = body.solve([0.6, -0.5, 1.2], step=step, end=2, scheme="gauss-4")
        found = run.balance()
        assert set(found) == {"h", "c1"}
        for symbol, balance in found.items():
            values = run.invariants[symbol]
            assert balance.change == pytest.approx(values[-1] - values[0], abs=1e-14)
            assert abs(balance.change - balance.supplied) <= balance.defect < 1e-4 < abs(balance.change)
        defects.append(found["h"].defect)
    assert defects[0] / defects[1] == pytest.approx(16, rel=0.3), "order 4"
    # By another quadrature of the power, over a fine run.
    fine = body.solve([0.6, -0.5, 1.2], step=0.005, end=2)
    power = np.sin(fine.t) * fine.y[0] - 0.2 * fine.y[1] ** 2 / 2
    weights = np.ones(fine.t.size)
    weights[1:-1:2], weights[2:-1:2] = 4, 2
    assert (weights * power).sum() * 0.005 / 3 == pytest.approx(fine.balance()["h"].supplied, abs=1e-9)
    assert abs((weights * -power).sum() * 0.005 / 3 - fine.balance()["h"].supplied) > 0.1, "control: the other sign"
    # Friction takes h and no Casimir.
    damped = System("so(3)", "-2*Pi3", damping=0.1).solve(SPIN, step=0.1, end=5).balance()
    assert damped["h"].supplied == pytest.approx(-2 * np.tanh(1), abs=1e-12) and damped["c1"].defect < 1e-13
    for system, step in ((System("so(3)", "-Pi3"), 0.1), (System("so(3)", "-Pi3", noise={"strength": 0.1}), 0.1)):
        with pytest.raises(ValueError, match="a balance is of"):
            system.solve(SPIN, step=step, end=1).balance()


def test_a_kind_may_have_forces():
    gyrostat = {"kind": "body-with-rotors", "parameters": {"I": [1, 2, 3], "J": [0.1, 0.2]}}
    start = {"Pi": [0.3, 1, 0.2], "l": [0.2, 0.1]}
    slowed = System(**gyrostat, torque={"Pi": ["-0.1*Pi1", "-0.1*Pi2", "-0.1*Pi3"]}).solve(start, step=0.1, end=10)
    free = System(**gyrostat).solve(start, step=0.1, end=10)
    assert slowed.invariants["c3"][-1] == pytest.approx(np.exp(-2) * free.invariants["c3"][-1])


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"damping": -1}, "friction must be 0 or a positive number, it is -1"),
        ({"damping": {"theta": 1}}, "damping has no 'theta'"),
        ({"damping": np.nan}, "friction must be 0 or a positive number, it is nan"),
        ({"damping": 1, "noise": {"temperature": np.inf}}, "temperature must be 0 or a positive number, it is inf"),
        ({"damping": 0, "noise": {"temperature": 0.5}}, "beside temperature = 0.5 the friction must be a positive number, it is friction = 0"),
        ({"damping": {"friction": 0, "form": "gilbert"}, "noise": {"temperature": 2}}, "it is friction = 0"),
        ({"damping": {"form": "gilbert"}}, "damping has no friction"),
        ({"damping": {"friction": 1, "form": "bloch"}}, "form must be one of landau-lifshitz, gilbert"),
        ({"damping": {"friction": 1, "form": "gilbert", "inner_product": 1}}, "damping with form has no 'inner_product'"),
        ({"damping": {}}, "no friction"),
        ({"damping": {"friction": 1, "inner_product": [1, 2]}}, "2 rows, and the algebra 3"),
        ({"noise": {"temperature": 1}}, "a temperature needs a friction"),
        ({"damping": 1, "noise": {"temperature": -1}}, "it is -1"),
        ({"noise": {"strength": -1}}, "it is -1"),
        ({"noise": 3}, "must be a mapping"),
        ({"noise": {}}, "one of temperature"),
        ({"noise": {"strength": 1, "temperature": 1}}, "one of temperature"),
        ({"noise": {"strength": 1, "seed": -1}}, "seed must be a whole number"),
        ({"noise": {"strength": 1, "rule": "both"}}, "rule must be one of"),
        ({"noise": {"strength": 1, "bound": 0.5}}, "1 standard deviation or more, it is 0.5"),
        ({"noise": {"strength": 1, "interval": 0}}, "positive number, it is 0"),
        ({"noise": {"strength": 1, "path": 2**53}}, "must be below 9007199254740992, it is 9007199254740992"),
        ({"torque": {}}, "torque has no formulas"),
        ({"drive": {"Pi3": "1"}, "parameters": {"t": 1.0}}, "is that of the time"),
        ({"noise": {"fields": "Pi1"}}, "must be a list of fields"),
        ({"torque": lambda x: x.Pi[:2]}, "must return 3 numbers"),
        ({"torque": "Pi1"}, "must have 3 formulas"),
        ({"torque": {"P": "1"}}, "no coordinate 'P'"),
        ({"drive": {"Pi": ["1", "2"]}}, "must have 3 formulas, got 2"),
        ({"drive": {"Pi": ["1", "2", "Pj"]}}, "there is no `Pj`"),
        ({"inputs": {"u": ([0, 1], [1, 2])}}, r"must be \(times, values, interpolation\)"),
        ({"inputs": {"u": ([0, 1], [1], "linear")}}, "got 2 times and 1 values"),
        ({"inputs": {"u": ([0, 0], [1, 2], "linear")}}, "must increase"),
        ({"inputs": {"Pi1": ([0, 1], [1, 2], "linear")}}, "the input Pi1"),
    ],
)
def test_what_does_not_fit_is_refused(wrong, message):
    with pytest.raises(ValueError, match=message):
        System("so(3)", "Pi3", **wrong)


@pytest.mark.parametrize("damping", [0.5, {"friction": 0.5, "form": "gilbert"}])
def test_a_temperature_has_no_way_back(damping):
    warm = System("so(3)", "-Pi3", damping=damping, noise={"temperature": 0.5})
    for go in (warm.solve, lambda y0, **run: warm.section(y0, "sin(t)", **run)):
        with pytest.raises(ValueError, match="no way back in time, where its friction = 0.5 .* the step is -0.1"):
            go(SPIN, step=-0.1, end=-4)
    damped = System("so(3)", "-Pi3", damping=damping)
    assert damped.solve(SPIN, step=-0.1, end=-4).y[2, -1] < -0.5, "control: damping alone has one"


def test_what_there_is_not_is_refused_with_a_reason():
    damped = System("so(3)", "Pi3", damping=1)
    with pytest.raises(ValueError, match="path is of systems with noise"):
        damped.solve(SPIN, step=0.1, end=1, path=1)
    warm = System("so(3)", "Pi3", noise={"strength": 1, "path": 2**53 - 2, "bound": np.inf})
    with pytest.raises(ValueError, match="below 9007199254740992"):
        solve_many(warm, np.tile([[1.0], [0], [0]], 3), step=0.1, end=1)
    with pytest.raises(ValueError, match="must be at least 0.00001"):
        System("so(3)", "Pi3", noise={"strength": 1, "interval": 1e-6}).solve(SPIN, step=0.1, end=1)
    with pytest.warns(RuntimeWarning, match="the noise turns the state by about .* rad in a step, where at most 1/3 rad is safe"):
        System("so(3)", "Pi3", noise={"strength": 2.0}).solve(SPIN, step=0.1, end=1)
    with pytest.raises(ValueError, match="6 rows"):
        System("se(3)", "|Pi|^2 + Gamma3", damping=1)
    with pytest.raises(TypeError):
        System("so(3)", lambda x, t: "Pi3")


def test_an_input_that_no_formula_names_is_refused():
    table = {"u": ([0, 20], [0, 1], "linear")}
    idle = System("so(3)", "-Pi1", inputs=table)
    run = {"step": 0.1, "end": 1}
    for follow in (
        lambda: idle.solve(SPIN, **run),
        lambda: idle.solve(SPIN, np.linspace(0, 1, 11)),
        lambda: idle.solve(SPIN, events=["Pi3", lambda x, t: x.Pi3 - t], **run),
        lambda: idle.section(SPIN, "Pi3", **run),
        lambda: solve_many(idle, [[1, 0], [0, 1], [0, 0]], **run),
        lambda: System("so(3)", lambda x: x.Pi1, inputs={**table, "v": table["u"]}, torque=["v", 0, 0]).solve(SPIN, **run),
    ):
        with pytest.raises(ValueError, match="no formula names the input u$"):
            follow()
    # Any formula names it, those of events and a factor 0, too.
    assert idle.solve(SPIN, events="Pi3 - u", **run).success and idle.solve(SPIN, events="Pi3 - 0*u", **run).success
    # The states between the samples of such a run are there, too.
    watched = idle.solve(SPIN, events="Pi3 - u", **run)
    assert np.array_equal(watched.sol(watched.t), watched.y)
    assert idle.section(SPIN, "u", value=0.025, **run).t == pytest.approx([0.5])
    for forces in ({"torque": ["0*u", 0, 0]}, {"drive": lambda x, t: [x.u, 0, 0]}, {"noise": {"fields": [["u", 0, 0]]}}):
        assert System("so(3)", "-Pi1", inputs=table, **forces).solve(SPIN, **run).success
