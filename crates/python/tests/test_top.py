"""Tops, their runs, and their errors."""

import copy
import pickle
import subprocess
import sys

import numpy as np
import pytest

import heavytop
from heavytop import Top

START = dict(Pi=[2.0, 3.0, 4.0], Gamma=[0.5, 0.0, 0.75**0.5])


def test_a_run_has_the_shapes_of_scipy():
    run = Top.kovalevskaya().solve(**START, step=0.1, end=10, every=3, attitude=True)
    assert run.t.shape == (35,) and run.y.shape == (6, 35) and run.attitude.shape == (4, 35)
    assert run.success and run.t[0] == 0 and run.t[-1] == 100 * 0.1
    assert run.y[:, 0].tolist() == START["Pi"] + START["Gamma"]
    assert set(run.invariants) == {"h", "f1", "f2", "K"}
    assert run.invariants["K"][0] == pytest.approx(193.0, rel=1e-14)


def test_samples_that_are_not_kept_change_nothing():
    settings = dict(**START, step=0.1, end=10.3, scheme="gauss-8")
    whole, some, last = (Top.kovalevskaya().solve(**settings, every=every) for every in (1, 7, 10**6))
    assert np.array_equal(some.t, whole.t[[*range(0, 103, 7), 103]])
    assert np.array_equal(some.y, whole.y[:, [*range(0, 103, 7), 103]])
    assert np.array_equal(last.y, whole.y[:, [0, 103]])
    assert whole.iterations == some.iterations == last.iterations > 103


@pytest.mark.parametrize("formulation", heavytop.FORMULATIONS)
def test_casimirs_hold_where_the_formulation_promises(formulation):
    # A Gauss method conserves Casimirs that are quadratic even when it is applied directly.
    scheme = {"splitting": "kahan-li-6", "direct": "rk4"}.get(formulation, "gauss-6")
    run = Top.kovalevskaya().solve(**START, step=0.05, end=50, scheme=scheme, formulation=formulation)
    assert (run.deviation("f2") < 1e-12) == (formulation != "direct")
    # 1e-2 is far above the error of any of these schemes with a step of 0.05.
    assert run.deviation("h") < 1e-2


def test_the_attitude_turns_the_vertical_of_the_body_to_that_of_space():
    run = Top.kovalevskaya().solve(**START, step=0.1, end=20, attitude=True)
    w, v = run.attitude[0], run.attitude[1:]
    # R Gamma = Gamma + 2 w v x Gamma + 2 v x (v x Gamma)
    across = np.cross(v, run.Gamma, axis=0)
    turned = run.Gamma + 2 * w * across + 2 * np.cross(v, across, axis=0)
    assert np.abs(turned - np.array([[0], [0], [1]])).max() < 1e-13


def test_dense_output_has_the_casimirs_and_meets_the_samples():
    run = Top.kovalevskaya().solve(**START, step=0.1, end=10, scheme="gauss-12")
    t = np.array([9.87, 0.0, 3.21, run.t[-1]])
    y = run.sol(t)
    assert y.shape == (6, 4) and run.sol(1.0).shape == (6,)
    assert np.abs((y[3:] ** 2).sum(axis=0) - 1).max() < 1e-14
    assert np.abs(run.sol(run.t[:50]) - run.y[:, :50]).max() < 1e-12
    finer = Top.kovalevskaya().solve(**START, step=0.01, end=10, scheme="gauss-12")
    assert np.abs(finer.sol(t) - y).max() < 1e-9
    for outside in (-0.1, 10.1, np.nan):
        with pytest.raises(ValueError, match="from 0 to"):
            run.sol(outside)


def test_a_section_lies_on_its_surface():
    points = Top.kovalevskaya().section(**START, coordinate="Gamma2", direction=1, step=0.05, end=200)
    assert points.t.size > 20 and np.all(np.diff(points.t) > 0)
    assert np.abs(points.y[4]).max() < 1e-13
    few = Top.kovalevskaya().section(**START, coordinate="Gamma2", direction=1, step=0.05, end=200, most=3)
    assert np.array_equal(few.y, points.y[:, :3])


def test_invariants_of_states():
    top = Top.lagrange(2.0, 1.0)
    values = top.invariant_values([1, 2, 3, 0, 0, 1])
    assert values["h"] == pytest.approx(0.5 * (1 / 2 + 4 / 2 + 9) + 1)
    assert values["f3"] == 3


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (dict(step=0.0), "step must be different from 0, got 0.0"),
        (dict(end=0.15), "nearest ends are 0.1 and 0.2"),
        (dict(scheme="gauss-5"), "scheme must be one of implicit-midpoint"),
        (dict(scheme="rk4", formulation="reduced"), "reduced has no scheme rk4"),
        (dict(formulation="direct", attitude=True), "no attitude"),
        (dict(Pi=[1, 2]), "Pi must have three components"),
        (dict(Gamma=[0, 0, 0]), "different from 0"),
        (dict(Pi=[np.nan, 0, 0]), "finite"),
        (dict(every=0), "every must be a whole number from 1 on"),
        (dict(tolerance=-1.0), "tolerance must be"),
    ],
)
def test_wrong_arguments_are_value_errors_that_say_why(change, words):
    arguments = {**START, "step": 0.1, "end": 1.0, **change}
    with pytest.raises(ValueError, match=words):
        Top.kovalevskaya().solve(**arguments)


def test_no_body_has_such_moments():
    with pytest.raises(ValueError, match="triangle"):
        Top(inertia=[1, 1, 3], mass=1, gravity=1, length=1)


def test_a_step_that_fails_ends_the_run_and_keeps_what_was_before():
    start = dict(Pi=[20, 30, 40], Gamma=[0.6, 0, 0.8])
    with pytest.warns(RuntimeWarning, match="turns by"):
        run = Top.kovalevskaya().solve(**start, step=1.0, end=100.0, scheme="explicit-midpoint", formulation="direct")
    assert not run.success and "not finite" in run.message
    assert isinstance(run.error, heavytop.IntegrationError)
    assert 0 < run.t.size < 101 and np.isfinite(run.y).all()


def test_reprs_say_what_they_are():
    top = Top.kovalevskaya()
    assert repr(top) == "<Top: I = (2, 2, 1), m g l = 1, c = (1, 0, 0)>"
    assert "deviations" in repr(top.solve(**START, step=0.1, end=1))


def test_tops_and_solutions_are_values():
    top = Top.lagrange(2.0, 1.0)
    assert top == Top.lagrange(2.0, 1.0) != Top.lagrange(2.0, 1.5) and len({top, Top.lagrange(2.0, 1.0)}) == 1
    for copied in (pickle.loads(pickle.dumps(top)), copy.deepcopy(top)):
        assert copied == top and copied.invariants == top.invariants
    free = pickle.loads(pickle.dumps(Top.free_rigid_body([1, 2, 2.5])))
    assert free.weight_moment == 0
    run = top.solve(**START, step=0.1, end=1)
    again = pickle.loads(pickle.dumps(run))
    assert np.array_equal(again.y, run.y) and np.array_equal(again.sol(0.55), run.sol(0.55))
    assert run == run and run != again and isinstance(hash(run), int)


def test_too_many_samples_are_a_memory_error():
    with pytest.raises(MemoryError, match="every"):
        Top.kovalevskaya().solve(**START, step=1e-11, end=1)


def test_steps_that_are_too_long_are_told():
    with pytest.warns(RuntimeWarning, match="the motion turns by about .* rad in a step"):
        run = Top.kovalevskaya().solve(**START, step=5.0, end=10)
    with pytest.warns(RuntimeWarning):
        run = Top.kovalevskaya().solve(**START, step=15, end=300, formulation="direct", scheme="rk4")
    assert not run.success and all(np.isfinite(values).all() for values in run.invariants.values())
    with pytest.raises(ValueError, match="a step of 50 s turns the motion by about .* rad; it must be at most 100"):
        Top.kovalevskaya().solve(**START, step=50, end=500)


INTERRUPTED = """
import dataclasses, heavytop, signal, sys, threading, numpy as np
# A job in the background of a shell begins with the signal ignored.
signal.signal(signal.SIGINT, signal.default_int_handler)
top = heavytop.Top.kovalevskaya()
system = heavytop.System("se(3)", "0.5*(Pi1^2/2 + Pi2^2/2 + Pi3^2) + Gamma1")
start = dict(Pi=[2, 3, 4], Gamma=[0.6, 0, 0.8])
y = np.tile([[2.0], [3.0], [4.0], [0.6], [0.0], [0.8]], 50)
# the record of a run that would take hours
long = dataclasses.replace(top.solve(**start, step=1e-4, end=1e-3), t=np.array([0.0, 1e6]))
calls = {
    "solve": lambda: top.solve(**start, step=1e-4, end=1e6, every=10**6),
    "section": lambda: top.section(**start, coordinate="Pi3", value=1e3, step=1e-4, end=1e6),
    "solve_many": lambda: heavytop.solve_many(top, y, step=1e-4, end=1e6),
    "sol": lambda: long.sol(1e6),
    "check": lambda: long.check(),
    "events": lambda: top.solve(**start, step=1e-4, end=1e6, every=10**6, events="Pi3 - 1e3"),
    "lyapunov": lambda: heavytop.lyapunov(top, y[:, :5], step=1e-4, end=1e6),
    "system": lambda: system.solve(y[:, 0], step=1e-4, end=1e6, every=10**6),
    "system section": lambda: system.section(y[:, 0], "Pi3", value=1e3, step=1e-4, end=1e6),
    "many systems": lambda: heavytop.solve_many(system, y, step=1e-4, end=1e6),
    "system lyapunov": lambda: heavytop.lyapunov(system, y[:, :5], step=1e-4, end=1e6),
}
threading.Timer(0.3, lambda: signal.raise_signal(signal.SIGINT)).start()
try:
    calls[sys.argv[1]]()
except KeyboardInterrupt:
    print("interrupted")
"""


CALLS = ["solve", "section", "solve_many", "sol", "check", "events", "lyapunov"]
CALLS += ["system", "system section", "many systems", "system lyapunov"]


@pytest.mark.parametrize("call", CALLS)
def test_control_c_ends_every_loop(call):
    # A minute is far above the second that it takes, and far below the hours of the run.
    done = subprocess.run([sys.executable, "-c", INTERRUPTED, call], capture_output=True, text=True, timeout=60)
    assert done.stdout == "interrupted\n", done.stderr


ESTIMATES = """
import heavytop, signal, sys, threading, time
signal.signal(signal.SIGINT, signal.default_int_handler)
top, system = heavytop.Top.kovalevskaya(), heavytop.System("se(3)", "0.5*(Pi1^2/2 + Pi2^2/2 + Pi3^2) + Gamma1")
native, method = (top._top, "collective") if sys.argv[1] == "top" else (system._system, "direct")
setting = ([2.0, 3.0, 4.0, 0.6, 0.0, 0.8], 1e-3, (method, "gauss-16", 0.0))
began = time.perf_counter()
native.accuracy(setting, 5000)
# Of 20 * 2**18 steps 2**18 are repeated.
whole = 2**18 / 5000 * (time.perf_counter() - began)
threading.Timer(0.05 * whole, lambda: signal.raise_signal(signal.SIGINT)).start()
began = time.perf_counter()
try:
    native.accuracy(setting, 20 * 2**18)
except KeyboardInterrupt:
    pass
took = time.perf_counter() - began
# A signal is noticed within 50 ms.
print("interrupted" if took < 0.5 * whole + 0.05 else f"{took} of {whole}")
"""


@pytest.mark.parametrize("what", ["top", "system"])
def test_control_c_ends_an_estimate(what):
    done = subprocess.run([sys.executable, "-c", ESTIMATES, what], capture_output=True, text=True, timeout=60)
    assert done.stdout == "interrupted\n", done.stderr


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (dict(step=None), "step must be a number, got None"),
        (dict(step="0.1"), "step must be a number, got '0.1'"),
        (dict(end=10**400), "end must be a number"),
        (dict(every=-1), "every must be a whole number from 1 on, got -1"),
        (dict(every=2.5), "every must be a whole number from 1 on, got 2.5"),
        (dict(attitude=1), "attitude must be True or False, got 1"),
        (dict(scheme=8), "scheme must be one of implicit-midpoint"),
        (dict(tolerance=1.0), "tolerance must be from 0 to 0.001, got 1.0"),
        (dict(Pi="abc"), "Pi must be an array of real numbers"),
        (dict(Pi=[1, 2, 3j]), "Pi must be an array of real numbers"),
        (dict(Gamma=[0, np.nan, 1]), r"Gamma\[1\] must be finite, got nan"),
    ],
)
def test_wrong_types_are_value_errors_that_name_the_argument(change, words):
    arguments = {**START, "step": 0.1, "end": 1.0, **change}
    with pytest.raises(ValueError, match=words):
        Top.kovalevskaya().solve(**arguments)


def test_wrong_tops_name_the_argument():
    for call, words in [
        (lambda: Top([1, 1, 1], mass="2", gravity=1, length=1), "mass must be a number, got '2'"),
        (lambda: Top([1, 0, 0], mass=2, gravity=1, length=1), r"inertia\[1\] must be positive, got 0.0"),
        (lambda: Top.kovalevskaya(axial=-1), "axial must be positive, got -1.0"),
        (lambda: Top.kovalevskaya().section(**START, coordinate="Pi1", direction="up", step=0.1, end=1), "direction must"),
        (lambda: Top.kovalevskaya().solve(**START, step=0.1, end=1).deviation("E"), "the invariants are h, f1, f2, K"),
        (lambda: heavytop.solve_many([Top.kovalevskaya(), 1], np.ones((6, 2)), step=0.1, end=1), "got 1 at 1"),
        (lambda: heavytop.solve_many(5, np.ones((6, 2)), step=0.1, end=1), "got 5 at 0"),
    ]:
        with pytest.raises(ValueError, match=words):
            call()


def test_g_is_conserved_if_the_vertical_momentum_is_zero():
    top = Top.goryachev_chaplygin()
    level = top.solve(Pi=[2, 3, -1.5], Gamma=[0.6, 0, 0.8], step=0.05, end=20, scheme="gauss-12")
    assert level.invariants["f2"][0] == pytest.approx(0.0, abs=1e-15) and level.deviation("G") < 1e-11
    other = top.solve(Pi=[2, 3, 4], Gamma=[0.6, 0, 0.8], step=0.05, end=20, scheme="gauss-12")
    assert "G" not in other.invariants and "G" not in top.invariants
    # G, as it stands in the documentation, is not conserved there.
    Pi, Gamma = other.Pi, other.Gamma
    G = Pi[2] * (Pi[0] ** 2 + Pi[1] ** 2) - 4 * Gamma[2] * Pi[0]
    assert np.abs(G - G[0]).max() > 1
    assert "G" in top.invariant_values(level.y) and "G" not in top.invariant_values(other.y)
    # Many runs have it if each of them starts so, of one top and of several.
    starts = np.column_stack([level.y[:, 0], level.y[:, 0], other.y[:, 0]])
    for tops in (top, [top, top]):
        ends = heavytop.solve_many(tops, starts[:, :2], step=0.05, end=20, scheme="gauss-12")
        assert ends.deviation("G").max() < 1e-11
        mixed = heavytop.solve_many(tops, starts[:, 1:], step=0.05, end=20, scheme="gauss-12")
        assert "G" not in mixed.invariants and set(mixed.invariants) == {"h", "f1", "f2"}
    assert "G" not in heavytop.solve_many([top, Top.kovalevskaya()], starts[:, :2], step=0.05, end=1).invariants


@pytest.mark.filterwarnings("error")
def test_many_steps_that_are_too_long_are_told():
    top, fast = Top.kovalevskaya(), np.array([[0.2, 0.3, 40.0, 0.6, 0, 0.8]]).T
    slow = fast * np.array([[1], [1], [0.01], [1], [1], [1]])
    both = np.hstack([slow, fast])
    for one_or_many in (top, [top, top]):
        with pytest.raises(RuntimeWarning, match="^run 1: the motion turns by about 4.1 rad"):
            heavytop.solve_many(one_or_many, both, step=0.1, end=1)
        with pytest.raises(RuntimeWarning, match="^run 1: the motion turns by about 4.1 rad"):
            heavytop.lyapunov(one_or_many, both, step=0.1, end=1)
        heavytop.solve_many(one_or_many, np.hstack([slow, slow]), step=0.1, end=1)


def test_a_name_that_is_nearly_right_is_offered():
    with pytest.raises(ValueError, match="got 'Gauss8'; did you mean 'gauss-8'"):
        Top.kovalevskaya().solve(**START, step=0.1, end=1, scheme="Gauss8")


def test_quantities_of_a_run_by_name():
    inertia = np.array([[2.0, 0.3, 0.1], [0.3, 1.5, -0.2], [0.1, -0.2, 1.2]])
    top = Top(inertia, mass=2.0, gravity=9.81, length=0.1, center_of_mass=[0.6, 0.0, 0.8])
    run = top.solve([1, -0.5, 2], [0.6, 0, 0.8], step=0.01, end=1, every=20, attitude=True)
    assert np.abs(inertia @ run["Omega"] - run["Pi"]).max() < 1e-13
    height = 0.1 * np.array([0.6, 0, 0.8]) @ run["Gamma"]
    assert np.abs(run["potential"] - 2.0 * 9.81 * height).max() < 1e-13
    assert np.abs(run["kinetic"] + run["potential"] - run.invariants["h"]).max() < 1e-13
    w, x, y, z = run.attitude
    rotation = np.array(
        [
            [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
        ]
    )
    spatial = np.einsum("ijn,jn->in", rotation, run["Pi"])
    assert np.abs(spatial - run["spatial_momentum"]).max() < 1e-13
    # The vertical part is conserved, and the others are not.
    assert np.ptp(spatial[2]) < 1e-13 < 1e-2 < np.ptp(spatial[0])
    theta, psi = run["theta"], run["psi"]
    gamma = np.array([np.sin(theta) * np.sin(psi), np.sin(theta) * np.cos(psi), np.cos(theta)])
    assert np.abs(gamma - run["Gamma"]).max() < 1e-13 and (run["euler_angles"][0] == run["phi"]).all()
    without = top.solve([1, -0.5, 2], [0.6, 0, 0.8], step=0.01, end=0.1)
    assert without["Omega"].shape == (3, 11)
    with pytest.raises(ValueError, match="write attitude=True"):
        without["phi"]
    with pytest.raises(KeyError, match="there are Pi, .*, got 'omega'"):
        without["omega"]


def test_a_report_has_the_formulas_of_the_textbook():
    top = Top.lagrange(transverse=2.0, axial=1.0)
    report = top.report([0, 0, 20], [0.6, 0, 0.8], step=0.02, end=20)
    nutation = report.numbers["nutation, 2π/period"]
    exact = nutation.formulas["closed form, by an elliptic integral"]
    # The method and the step have an error of 1e-9 there; the formula of a fast top is off by far more.
    assert abs(nutation.value / exact - 1) < 1e-8 < abs(nutation.value / nutation.formulas["I₃ω₃/I₁, of a fast top"] - 1)
    assert "precession" in str(report) and report.steady == ()
    euler = Top.free_rigid_body([1, 2, 3]).report([1e-3, 2, 0], [0, 0, 1], step=0.02, end=100)
    assert len(euler.steady) == 6
    growth = [one.growth for one in euler.steady if abs(one.vertical[1]) > 0.9]
    assert np.allclose(growth, np.sqrt(1 / 3), rtol=1e-6) and "flip to flip" in str(euler)
    with pytest.raises(ValueError, match="no attitude"):
        top.report([0, 0, 20], [0.6, 0, 0.8], step=0.02, end=20, formulation="direct")
