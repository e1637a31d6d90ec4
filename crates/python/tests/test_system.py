"""Systems by formula: against SciPy, against compiled tops, and their errors."""

import copy
import pickle

import numpy as np
import pytest

import heavytop
from heavytop import System, Top

MOMENTS, MASSES = np.array([2.0, 1.5, 1.0]), np.array([1.0, 2.0, 4.0])
KIRCHHOFF = "0.5*(Pi1^2/I1 + Pi2^2/I2 + Pi3^2/I3) + 0.5*(Gamma1^2/M1 + Gamma2^2/M2 + Gamma3^2/M3)"
BODY = System("se(3)", KIRCHHOFF, parameters={"I": MOMENTS, "M": MASSES})
START = np.array([0.3, -0.7, 1.1, 0.6, 0.2, 0.8])


def kirchhoff(_, y):
    omega, velocity = y[:3] / MOMENTS, y[3:] / MASSES
    return np.concatenate([np.cross(y[:3], omega) + np.cross(y[3:], velocity), np.cross(y[3:], omega)])


def test_a_body_in_a_fluid_is_that_of_scipy():
    integrate = pytest.importorskip("scipy.integrate")
    run = BODY.solve(START, step=0.05, end=20, scheme="gauss-12", events=["Gamma1", "Pi·Gamma×(Pi + Gamma) + Pi2"])
    peer = integrate.solve_ivp(
        kirchhoff, (0, 20), START, "DOP853", rtol=1e-12, atol=1e-12, t_eval=run.t, events=[lambda _, y: y[3], lambda _, y: y[1]]
    )
    # DOP853 at this tolerance is off by 1e-10 at the end.
    assert np.abs(run.y - peer.y).max() < 1e-8
    for ours, theirs in zip(run.t_events, peer.t_events):
        assert ours.size > 1 and ours.shape == theirs.shape and np.abs(ours - theirs).max() < 1e-8
    assert BODY.casimirs == {"c1": "Pi·Gamma", "c2": "|Gamma|^2"} and BODY.missing_casimirs == 0
    assert run.deviation("c1") < 1e-13 and run.deviation("c2") < 1e-13
    # Control: rk4, applied directly, keeps neither.
    rk4 = BODY.solve(START, step=0.05, end=20, scheme="rk4", formulation="direct")
    assert rk4.deviation("c1") > 1e-10 and rk4.deviation("c2") > 1e-10
    assert np.abs(BODY.rate(START) - kirchhoff(0, START)).max() < 1e-15
    assert BODY.rate(run.y).shape == run.y.shape


@pytest.mark.parametrize("formulation", ["collective", "reduced", "direct"])
def test_a_top_by_formula_is_the_compiled_top(formulation):
    top = Top.kovalevskaya()
    system = System("se(3)", "0.5*(Pi1^2/2 + Pi2^2/2 + Pi3^2) + Gamma1")
    start = [2.0, 3.0, 4.0, 0.6, 0.0, 0.8]
    ours = system.solve(start, step=0.1, end=20, scheme="gauss-6", formulation=formulation)
    theirs = top.solve(start[:3], start[3:], step=0.1, end=20, scheme="gauss-6", formulation=formulation)
    # 200 steps, each with a few rounding errors of size 1e-15, which grow with t.
    assert np.abs(ours.y - theirs.y).max() < 1e-10
    assert np.abs(ours.invariants["h"] - theirs.invariants["h"]).max() < 1e-11
    other = System("se(3)", "0.5*(Pi1^2/2 + Pi2^2/2 + Pi3^2) + 1.001*Gamma1").solve(start, step=0.1, end=20)
    assert np.abs(other.y - theirs.y).max() > 1e-4


def test_formula_and_function_are_one_system():
    def energy(x):
        return 0.5 * (x.Pi @ (x.Pi / x.I) + x.Gamma @ (x.Gamma / x.M))

    traced = System("se(3)", energy, parameters={"I": MOMENTS, "M": MASSES})
    ours, theirs = (s.solve(START, step=0.05, end=10) for s in (traced, BODY))
    assert np.abs(ours.y - theirs.y).max() < 1e-12 and np.array_equal(ours.t, theirs.t)
    assert abs(traced.invariant_values(START)["h"] - energy_of(START)) < 1e-15


def energy_of(y):
    return 0.5 * (y[:3] @ (y[:3] / MOMENTS) + y[3:] @ (y[3:] / MASSES))


ROTOR = dict(coordinates=["K", "H", "P"], brackets={("K", "H"): "P", ("K", "P"): "H"})


def test_brackets_and_structure_constants_are_one_algebra():
    c = np.zeros((3, 3, 3))
    c[0, 1, 2] = c[0, 2, 1] = 1.0
    c -= c.swapaxes(0, 1)
    by_brackets = System(**ROTOR, hamiltonian="K^2/2 + 0.75*H^2 + P^2/2")
    by_constants = System(structure_constants=c, coordinates=["K", "H", "P"], hamiltonian=lambda x: x.K**2 / 2 + 0.75 * x.H**2 + x.P**2 / 2)
    unnamed = System(structure_constants=c, hamiltonian="mu1^2/2 + 0.75*mu2^2 + mu3^2/2")
    assert np.array_equal(by_brackets.structure_constants, c) and by_brackets.casimirs == {"c1": "H^2 - P^2"}
    assert unnamed.coordinates == ("mu1", "mu2", "mu3") and by_brackets.coordinates == ("K", "H", "P")
    start = [0.4, 1.5, -0.2]
    runs = [s.solve(start, step=0.05, end=10) for s in (by_brackets, by_constants, unnamed)]
    assert np.array_equal(runs[0].y, runs[2].y) and np.abs(runs[0].y - runs[1].y).max() < 1e-13
    k, h, p = start
    # dmu_j/dt = sum c_ijk xi_i mu_k with xi = (K, 1.5 H, P)
    assert np.allclose(by_brackets.rate(start), [-1.5 * h * p - p * h, k * p, k * h], atol=1e-15)
    assert runs[0].deviation("c1") < 1e-13 and np.array_equal(runs[0]["H"], runs[0].y[1])
    # The Clebsch map is another discretisation of the same motion.
    clebsch = by_brackets.solve(start, step=0.05, end=10, formulation="collective")
    assert 0 < np.abs(clebsch.y - runs[0].y).max() < 1e-9


def test_times_are_those_that_were_asked_for():
    t = np.linspace(0, 5, 51)
    given, run = BODY.solve(START, t), BODY.solve(START, step=0.1, end=5)
    assert np.array_equal(given.t, t) and np.abs(given.y - run.y).max() < 1e-12
    uneven = BODY.solve(START, [0.05, 0.33, 4.9], step=0.1)
    assert np.abs(uneven.y - run.sol([0.05, 0.33, 4.9])).max() < 1e-15
    assert uneven.invariants["h"].shape == (3,) and uneven.success
    for arguments, words in [
        (dict(t=[0, 1, 3]), "not equally spaced"),
        (dict(t=[0, 2, 1], step=0.1), "do not decrease"),
        (dict(t=t, end=5), "go with step"),
        (dict(step=0.1), "write either t, or step and end"),
    ]:
        with pytest.raises(ValueError, match=words):
            BODY.solve(START, **arguments)


def test_states_may_be_given_by_name():
    named = BODY.solve({"Pi": START[:3], "Gamma": START[3:]}, step=0.1, end=1)
    single = BODY.solve({"Pi": START[:3], "Gamma1": 0.6, "Gamma2": 0.2, "Gamma3": 0.8}, step=0.1, end=1)
    plain = BODY.solve(START, step=0.1, end=1)
    assert np.array_equal(named.y, plain.y) and np.array_equal(single.y, plain.y)
    assert np.array_equal(plain.Gamma, plain.y[3:]) and plain["Pi2"].shape == plain.t.shape
    with pytest.raises(ValueError, match="no value for Gamma2, Gamma3"):
        BODY.solve({"Pi": START[:3], "Gamma1": 0.6}, step=0.1, end=1)
    with pytest.raises(ValueError, match="no coordinate 'Omega'"):
        BODY.solve({"Omega": START[:3]}, step=0.1, end=1)
    with pytest.raises(KeyError, match="the coordinates are Pi"):
        plain["Omega"]


def test_dense_output_sections_and_events():
    run = BODY.solve(START, step=0.1, end=20, events=heavytop.Event("Gamma1", direction=1, terminal=3))
    assert run.status == 1 and run.t_events[0].size == 3 and run.t[-1] == run.t_events[0][-1]
    points = BODY.section(START, "Gamma1", step=0.1, end=float(round(run.t[-1] + 0.1, 1)), most=3)
    assert np.array_equal(points.t, run.t_events[0]) and np.abs(points.y[3]).max() < 1e-13
    halves = BODY.section(START, lambda x: x.I[0] * x.Gamma1, value=0.2, step=0.1, end=20, direction=0)
    assert halves.t.size and np.abs(halves.y[3] - 0.1).max() < 1e-13
    assert np.abs(run.sol(run.t[:5]) - run.y[:, :5]).max() < 1e-13


def test_many_states_are_each_alone():
    y = START[:, None] + 0.1 * np.sin(np.arange(6 * 130)).reshape(6, 130)
    ends = heavytop.solve_many(BODY, y, step=0.1, end=5)
    for i in (0, 63, 64, 129):
        alone = BODY.solve(y[:, i], step=0.1, end=5)
        assert np.array_equal(alone.y[:, -1], ends.y[:, i])
    assert ends.deviation("c2").max() < 1e-13 and ends.success
    y[0, 5] = np.nan
    broken = heavytop.solve_many(BODY, y, step=0.1, end=5)
    assert list(broken.failures) == [5]
    assert np.array_equal(np.delete(broken.y, 5, axis=1), np.delete(ends.y, 5, axis=1))
    rotor = System(**ROTOR, hamiltonian="K^2/2 + 0.75*H^2 + P^2/2")
    for formulation in (None, "collective"):
        ends = heavytop.solve_many(rotor, y[1:4], step=0.05, end=2, formulation=formulation)
        alone = rotor.solve(y[1:4, 7], step=0.05, end=2, formulation=formulation)
        assert ends.success and np.array_equal(ends.y[:, 7], alone.y[:, -1])


def test_lyapunov_exponents_of_a_system_are_those_of_the_top():
    top = Top(inertia=[1.0, 1.7, 2.2], mass=1.0, gravity=9.81, length=0.5, center_of_mass=[0.6, 0.0, 0.8])
    text = "0.5*(Pi1^2 + Pi2^2/1.7 + Pi3^2/2.2) + 4.905*(0.6*Gamma1 + 0.8*Gamma3)"
    system, start = System("se(3)", text), [1.0, 2.0, 1.0, 0.0, 0.6, 0.8]
    for arguments in (dict(), dict(exponents=6), dict(sali=True)):
        ours = heavytop.lyapunov(system, start, step=0.02, end=10, **arguments)
        theirs = heavytop.lyapunov(top, start, step=0.02, end=10, **arguments)
        # rounding errors grow by exp(10 λ), about 1e4
        assert np.abs(ours.exponents - theirs.exponents).max() < 1e-9 and abs(ours.megno - theirs.megno) < 1e-8
    # A space of four dimensions is completed to six: the exponents are four, and add up to 0.
    four = System(coordinates=["a", "b", "c", "d"], brackets={"a, b": "c", "a, c": "-b", "b, c": "a"}, hamiltonian="a^2/2 + b^2/3 + c^2/5 + d*a")
    found = heavytop.lyapunov(four, [1.0, 0.2, 0.5, 0.3], step=0.05, end=100, exponents=4)
    assert found.exponents.shape == (4,) and abs(found.exponents.sum()) < 1e-12
    with pytest.raises(ValueError, match="from 1 to 4"):
        heavytop.lyapunov(four, [1.0, 0.2, 0.5, 0.3], step=0.05, end=1, exponents=5)


def test_systems_and_their_solutions_are_pickled():
    traced = System("se(3)", lambda x: x.Pi @ (x.Pi / x.I) + np.cos(x.Gamma1), parameters={"I": MOMENTS})
    constants = System(structure_constants=BODY.structure_constants, hamiltonian="|mu|^2/2")
    for system, start in ((BODY, START), (traced, START), (constants, START), (System(**ROTOR, hamiltonian="K"), START[:3])):
        for again in (pickle.loads(pickle.dumps(system)), copy.deepcopy(system)):
            assert repr(again) == repr(system) and again.coordinates == system.coordinates
            run, second = system.solve(start, step=0.1, end=1), again.solve(start, step=0.1, end=1)
            assert np.array_equal(run.y, second.y)
        loaded = pickle.loads(pickle.dumps(run))
        assert np.array_equal(loaded.sol(0.55), run.sol(0.55))
    ends = pickle.loads(pickle.dumps(heavytop.solve_many(BODY, START[:, None], step=0.1, end=1)))
    assert ends.deviation("c1")[0] < 1e-14


@pytest.mark.parametrize(
    ("arguments", "error", "words"),
    [
        (dict(algebra="se4", hamiltonian="Pi1"), ValueError, r"there is no algebra se4; there are so\(n\)"),
        (dict(algebra="so(3)"), ValueError, "hamiltonian is missing"),
        (dict(algebra="so(3)", hamiltonian="Pj1"), ValueError, r"(?s)Pj1.*\^\^\^ there is no `Pj1`"),
        (dict(algebra="so(3)", hamiltonian=3), ValueError, "hamiltonian must be a formula or a function"),
        (dict(hamiltonian="Pi1"), ValueError, "write one of algebra, brackets and structure_constants; got none"),
        (dict(algebra="so(3)", brackets={}, hamiltonian="Pi1"), ValueError, "got algebra and brackets"),
        (dict(algebra="so(3)", coordinates=["a", "b"], hamiltonian="a1"), ValueError, "2 symbols; the algebra has 1: Pi"),
        (dict(brackets={"a, b": "c"}, hamiltonian="a"), ValueError, "brackets need coordinates"),
        (dict(coordinates=["a", "b"], brackets={"a, c": "b"}, hamiltonian="a"), ValueError, "no.*pair of coordinates"),
        (dict(coordinates=["a", "b", "c"], brackets={"a, b": "c", "a, c": "b", "b, c": "b"}, hamiltonian="a"), ValueError, "Jacobi"),
        (dict(coordinates=["a", "b"], brackets={3: "b"}, hamiltonian="a"), ValueError, "keys of brackets are pairs"),
        (dict(structure_constants=np.ones((2, 2, 2)), hamiltonian="mu1"), ValueError, "change sign with i and j"),
        (dict(structure_constants=np.ones((2, 2)), hamiltonian="mu1"), ValueError, r"shape \(d, d, d\)"),
        (dict(structure_constants=np.zeros((2, 2, 2)), coordinates=["a"], hamiltonian="a"), ValueError, "1 coordinates"),
        (dict(coordinates=[f"x{i}" for i in range(257)], brackets={}, hamiltonian="x0"), ValueError, "257 coordinates"),
        (dict(algebra="so(3)", hamiltonian="Pi1", parameters={"Pi1": 2.0}), ValueError, "parameters.*Pi1"),
        (dict(algebra="so(3)", hamiltonian="Pi1", parameters={"a": [[[1.0]]]}), ValueError, "a number, or a list"),
        (dict(algebra="so(3)", hamiltonian="Pi1", parameters={"a": np.nan}), ValueError, "must be finite"),
    ],
)
def test_wrong_systems_say_why(arguments, error, words):
    with pytest.raises(error, match=words):
        System(**arguments)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (dict(y0=[1.0]), "shape"),
        (dict(y0=[np.nan] * 6), "must be finite"),
        (dict(scheme="stormer-verlet"), "se.3. has no"),
        (dict(formulation="splitting"), "formulation must be one of collective, reduced, direct"),
        (dict(step=0.0), "step must be different from 0, got 0.0"),
        (dict(end=0.25), "nearest ends"),
        (dict(tolerance=1.0), "tolerance must be"),
    ],
)
def test_wrong_runs_say_why(change, words):
    arguments = {"y0": START, "step": 0.1, "end": 1.0, **change}
    with pytest.raises(ValueError, match=words):
        BODY.solve(**arguments)


def test_a_step_that_fails_ends_the_run():
    growing = System("so(3)", "exp(Pi1)*Pi2*Pi3")
    run = growing.solve([3.0, 3.0, 3.0], step=0.4, end=20.0, scheme="rk4", formulation="direct")
    assert run.status == -1 and not run.success and np.isfinite(run.y).all() and 0 < run.t.size < 51
    with pytest.raises(heavytop.IntegrationError):
        growing.solve([3.0, 3.0, 3.0], np.linspace(0, 20, 51), scheme="rk4", formulation="direct")


def test_a_hamiltonian_without_a_value_keeps_the_samples_before():
    """dPi1/dt = a Pi2, dPi2/dt = -a Pi1 with the a of ln(Pi3), which is constant, until h has no value."""
    where = "Pi3 + 0*sqrt(0.9 - Pi1)"
    start, whole = [0.6, -0.8, 2.0], System("so(3)", "Pi3")
    system = System("so(3)", where)
    exact = whole.solve(start, step=0.1, end=10, scheme="rk4", formulation="direct")
    run = system.solve(start, step=0.1, end=10, scheme="rk4", formulation="direct")
    kept = run.t.size
    assert run.status == -1 and not run.success and isinstance(run.error, heavytop.IntegrationError)
    assert 1 < kept < 101 and np.abs(run.y - exact.y[:, :kept]).max() < 1e-14 and exact.y[0, kept] > 0.9
    assert all(np.isfinite(values).all() and values.size == kept for values in run.invariants.values())
    with pytest.raises(heavytop.IntegrationError):
        system.solve(start, np.linspace(0, 10, 101), scheme="rk4", formulation="direct")
    # At the start it is an error of the argument, which names the formula, its part and the state.
    words = r"ln\(Pi1 - 5\) has no value at Pi1 = 1, Pi2 = 2, Pi3 = 0.5, where ln\(Pi1 - 5\) is not a number"
    for arguments in (dict(step=0.1, end=1), dict(t=[0.0, 0.1])):
        with pytest.raises(ValueError, match=words):
            System("so(3)", "Pi3^2 + ln(Pi1 - 5)").solve([1, 2, 0.5], **arguments)


def test_a_value_that_is_too_large_keeps_the_samples_before():
    """RK4 is unstable at this step: the state grows by 1.5 a step, and h overflows where it is still finite."""
    oscillator = System(coordinates=["q", "p", "z"], brackets={"q, p": "z"}, hamiltonian="(p^2 + q^2)/2")
    start, arguments = [1e150, 0.0, 1.0], dict(step=3.0, end=150.0, scheme="rk4", formulation="direct")
    run = oscillator.solve(start, **arguments)
    assert run.status == -1 and 0 < run.t.size < 51
    assert np.abs(run.y).max() > 1e153
    assert all(np.isfinite(values).all() for values in run.invariants.values())


def test_a_member_without_a_value_harms_no_other():
    system = System("so(3)", "Pi3 + 0*sqrt(0.9 - Pi1)")
    starts = np.array([[0.6, -0.8, 2.0], [0.1, 0.1, 2.0], [0.6, -0.8, 1.0]]).T
    ends = heavytop.solve_many(system, starts, step=0.1, end=10, scheme="rk4", formulation="direct")
    assert list(ends.failures) == [0, 2] and np.isfinite(ends.invariants["h"][1])
    assert ends.deviation("c1")[1] < 1e-6
    starts[0, 2] = 5.0
    ends = heavytop.solve_many(system, starts, step=0.1, end=10, scheme="rk4", formulation="direct")
    assert list(ends.failures) == [0, 2] and list(np.isnan(ends.invariants["h"])) == [False, False, True]


def test_a_system_by_name_is_that_of_its_formulas():
    parameters = {"I": [1.0, 2.0, 3.0], "J": [0.1, 0.2]}
    body = System(kind="body-with-rotors", parameters=parameters)
    assert body.coordinates == ("Pi1", "Pi2", "Pi3", "l1", "l2")
    assert set(body.casimirs.values()) == {"l1", "l2", "|Pi|^2"}
    brackets = {"x, y": "z", "y, z": "x", "z, x": "y"}
    text = body.hamiltonian.replace("Pi1", "x").replace("Pi2", "y").replace("Pi3", "z")
    same = System(coordinates=["x", "y", "z", "l1", "l2"], brackets=brackets, hamiltonian=text, parameters=parameters)
    start = [0.3, 1.0, 0.2, 0.2, 0.1]
    run, other = (system.solve(start, step=0.05, end=10) for system in (body, same))
    assert np.abs(run.y - other.y).max() < 1e-13 and np.abs(run.y[:3, -1] - start[:3]).max() > 0.1
    assert all(run.deviation(name) < 1e-13 for name in body.casimirs)
    assert pickle.loads(pickle.dumps(body)).casimirs == body.casimirs
    with pytest.raises(ValueError, match=r"J is missing\. It takes I of 3 numbers .*kg m²"):
        System(kind="body-with-rotors", parameters={"I": [1, 2, 3]})
    with pytest.raises(ValueError, match="there is no system top; there are body-in-fluid"):
        System(kind="top")
    with pytest.raises(ValueError, match="write neither"):
        System("so(3)", kind="body-with-rotors", parameters=parameters)
