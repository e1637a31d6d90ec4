"""Systems of the library by their classes, and algebras by expression."""

import pickle
import re
import subprocess

import numpy as np
import pytest

import heavytop
from heavytop import System

ARGUMENTS = [
    (heavytop.BodyInFluid, ([2, 2.5, 3], [3, 1.5, 2]), {"Pi": [1, 0.5, 0.2], "P": [0.3, 1, 0]}),
    (heavytop.EllipticalVortex, (1.0, 0.05), {"a": 1.5, "b": 0.5, "angle": 0.3}),
    (heavytop.Gyrostat, ([2, 2, 1], 1.0, [0, 0, 1], [0, 0, 2]), {"Pi": [0.5, 0, 3], "Gamma": [0.6, 0, 0.8]}),
    (heavytop.ReactionWheels, ([3, 2, 1.5], [[0, 1, 0], [3, 0, 4]], 0.1), {"Omega": [0.3, 1, -0.2], "speeds": [3, 1]}),
    (heavytop.RigidBody, (4, [1, 1.5, 2, 2.5]), [1, 0.2, -0.3, 0.5, 0.1, 0.7]),
    (heavytop.Satellite, ([1, 1.2, 0.4], 1.3), {"pitch": 0.3, "roll": 0.1, "relative": [0.2, 0, -0.1]}),
    (heavytop.SpinChain, (3, 1.0, 0.3, [0, 0, 0.2]), [[1, 0, 0], [0, 1, 0], [0, 0.6, 0.8]]),
    (heavytop.TopOnBase, ([2, 2, 1], 0.8, 1.3, 9.8, [0, 0, 0.5]), [0.5, 0, 5, 0.1, 0, 0, 0.6, 0, 0.8]),
    (heavytop.Vortices, ([1, -0.7],), [[1, 0, 0], [0, 0.6, 0.8]]),
]
BODIES = [(system(*given), start) for system, given, start in ARGUMENTS]


@pytest.mark.parametrize(("system", "start"), BODIES, ids=lambda value: type(value).__name__)
def test_a_class_conserves_what_its_system_conserves(system, start):
    run = system.solve(start, step=0.02, end=4, scheme="gauss-12")
    assert np.abs(run.y[:, -1] - run.y[:, 0]).max() > 0.01
    assert system.missing_casimirs == 0
    for name in system.invariants:
        assert run.deviation(name) < 1e-9, name
    # Resampled by a larger stride, the states are the same to the bit.
    coarse = system.solve(start, step=0.02, end=4, scheme="gauss-12", every=50)
    assert np.array_equal(coarse.y[:, -1], run.y[:, -1])
    # Pickle makes the same system.
    other = pickle.loads(pickle.dumps(system))
    assert other.hamiltonian == system.hamiltonian and other.bracket == system.bracket
    assert np.array_equal(other.rate(run.y[:, 3]), system.rate(run.y[:, 3]))


@pytest.mark.parametrize(("system", "given", "start"), ARGUMENTS, ids=lambda value: getattr(value, "__name__", ""))
def test_a_class_takes_forces(system, given, start):
    alone = system(*given).solve(start, step=0.02, end=1)
    unit = [1.0] * len(system(*given).coordinates)
    damped = system(*given, damping={"friction": 0.05, "inner_product": unit}).solve(start, step=0.02, end=1, scheme="gauss-8")
    h = damped.invariants["h"]
    assert (np.diff(h) < 0).all() and np.abs(damped.y[:, -1] - alone.y[:, -1]).max() > 1e-4
    assert all(damped.deviation(name) < 1e-9 for name in damped.kept) and "h" not in damped.kept
    noises = [{"strength": 0.05, "inner_product": unit, "path": path} for path in (0, 0, 1)]
    noisy = [system(*given, noise=noise).solve(start, step=0.02, end=1) for noise in noises]
    assert np.array_equal(noisy[0].y, noisy[1].y) and not np.array_equal(noisy[0].y, noisy[2].y)
    name = system(*given).coordinates[0]
    pushed = system(*given, inputs={"u": ([0, 0.5, 1], [0, 0.1, 0], "linear")}, torque={name: "u"})
    # A torque changes h and the Casimirs of its coordinate, and no other ones.
    run = pushed.solve(start, step=0.02, end=1)
    assert "h" not in pushed.kept and all(run.deviation(kept) < 1e-13 for kept in pushed.kept)
    assert all(run.deviation(other) > 1e-6 for other in set(pushed.invariants) - set(pushed.kept))
    assert np.abs(run.y[:, -1] - alone.y[:, -1]).max() > 1e-3
    with pytest.raises(TypeError, match="friction"):
        system(*given, friction=0.1)
    with pytest.raises(ValueError, match="a kind has its algebra"):
        system(*given, hamiltonian="Pi1")


def test_many_starts_and_growth_of_a_class():
    system = heavytop.Vortices([1.0, 1.0, 1.0])
    points = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
    starts = np.stack([points.ravel(), points[::-1].ravel()], axis=1)
    ends = heavytop.solve_many(system, starts, step=0.05, end=2)
    alone = system.solve(points, step=0.05, end=2)
    assert np.array_equal(ends.y[:, 0], alone.y[:, -1])
    growth = heavytop.lyapunov(system, starts[:, 0], step=0.1, end=20)
    assert np.isfinite(growth.exponents).all()


def test_vectors_have_the_shapes_of_the_field():
    chain = heavytop.SpinChain(4, 1.0)
    spins = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1], [0.6, 0.8, 0]])
    run = chain.solve(spins, step=0.1, end=1)
    assert chain.spins(run.y).shape == (11, 4, 3)
    assert np.array_equal(chain.spins(run.y)[0], spins)
    assert np.array_equal(chain.spins(run.y[:, 0]), spins)
    assert np.array_equal(chain.solve(spins.ravel(), step=0.1, end=1).y, run.y)
    vortices = heavytop.Vortices([1.0, 2.0])
    positions = np.array([[1, 0, 0], [0, 1, 0.0]])
    run = vortices.solve(positions, step=0.1, end=1)
    assert np.allclose(vortices.positions(run.y)[0], positions, atol=1e-15)
    assert np.allclose(np.linalg.norm(vortices.positions(run.y), axis=2), 1, atol=1e-13)


def magnon(n, mode, exchange=1.3):
    """Returns the measured angular frequency of a spin wave of a small amplitude."""
    i, k = np.arange(n), 2 * np.pi * mode / n
    wave = np.stack([1e-5 * np.cos(k * i), 1e-5 * np.sin(k * i), np.ones(n)], axis=1)
    chain = heavytop.SpinChain(n, exchange)
    run = chain.solve(wave, step=0.05, end=2, scheme="gauss-12")
    s = chain.spins(run.y)[:, 0]
    angle = np.unwrap(np.arctan2(s[:, 1], s[:, 0]))
    return abs(angle[-1] - angle[0]) / run.t[-1], 2 * exchange * (1 - np.cos(k))


@pytest.mark.parametrize("mode", [1, 3, 8])
def test_a_spin_wave_has_the_frequency_of_linear_theory(mode):
    measured, expected = magnon(16, mode)
    assert abs(measured - expected) < 1e-6 * expected


def test_a_ring_of_vortices_turns_at_its_known_rate():
    # N equal vortices on a parallel at the height z turn at k (N - 1) z/(4 pi (1 - z^2)).
    n, z = 5, 0.5
    angle = 2 * np.pi * np.arange(n) / n
    ring = np.stack([np.sqrt(1 - z * z) * np.cos(angle), np.sqrt(1 - z * z) * np.sin(angle), np.full(n, z)], axis=1)
    vortices = heavytop.Vortices(np.ones(n))
    run = vortices.solve(ring, step=0.1, end=3, scheme="gauss-12")
    last = vortices.positions(run.y)[-1, 0]
    rate = (n - 1) * z / (4 * np.pi * (1 - z * z))
    assert abs(np.arctan2(last[1], last[0]) - 3 * rate) < 1e-9
    assert abs(last[2] - z) < 1e-12


def test_an_ellipse_turns_at_kirchhoffs_rate():
    for a, b, vorticity in [(1.5, 0.5, 1.0), (3.0, 2.9, 0.2)]:
        vortex = heavytop.EllipticalVortex(vorticity * a * b)
        run = vortex.solve({"a": a, "b": b}, step=0.05, end=1, scheme="gauss-12")
        turned = np.arctan2(run["mu2"], run["mu1"])[-1] / 2
        assert abs(turned - vorticity * a * b / (a + b) ** 2) < 1e-11


def test_a_body_in_three_dimensions_is_eulers():
    second = np.array([1.0, 1.5, 2.0])
    moments = second.sum() - second
    body, euler = heavytop.RigidBody(second), System("so(3)", "sum(Pi[i]^2/I[i])/2", parameters={"I": moments})
    runs = [system.solve([1, 2, 0.5], step=0.1, end=10) for system in (body, euler)]
    assert np.abs(runs[0].y - runs[1].y).max() < 1e-13


def test_the_plus_bracket_is_the_motion_backward():
    text = "Pi1^2/2 + Pi2^2/3 + Pi3"
    minus, plus = System("so(3)", text), System("so(3)", text, bracket="plus")
    assert (minus.bracket, plus.bracket) == ("minus", "plus")
    y = [0.3, -0.8, 1.1]
    assert np.array_equal(plus.rate(y), -minus.rate(y)) and np.abs(minus.rate(y)).max() > 0.1
    there = plus.solve(y, step=0.05, end=3, scheme="gauss-12").y[:, -1]
    assert np.abs(minus.solve(there, step=0.05, end=3, scheme="gauss-12").y[:, -1] - y).max() < 1e-12


def test_algebras_by_expression():
    compass = System("so(3) |x (R3 + R3)", "|Pi|^2/2 + Gamma_1[1] + Gamma2[2]")
    assert set(compass.casimirs.values()) == {"|Gamma_1|^2", "Gamma_1·Gamma_2", "|Gamma_2|^2"}
    assert System("su(3)", "mu1^2 + mu8").dimension == 8
    spins = System("so(3)^2", lambda s: s.S_1 @ s.S_2, coordinates="S")
    assert spins.coordinates == ("S_1_1", "S_1_2", "S_1_3", "S_2_1", "S_2_2", "S_2_3")
    assert spins.formulations[0] == "collective"


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: System("so(3) |x R4", "1"), r"column 10: the algebra before it acts on R3, and not on R4"),
        (lambda: System("so(3", "1"), r"column 5: `\)` must stand where the text ends"),
        (lambda: System("soo(3)", "1"), r"there is no algebra soo\(3\); there are so\(n\)"),
        (lambda: System("so(3)^2", "1", coordinates=["S", "T"]), r"2 symbols; the algebra has 1: Pi"),
        (lambda: System("so(3)", "1", bracket="up"), "bracket"),
        (lambda: System("so(3)^2", "sum(Pi[i]·Pi[j])"), "needs the indices"),
        (lambda: heavytop.Vortices([1.0, 0.0]), "other than 0"),
        (lambda: heavytop.SpinChain(1, 1.0), "a whole number from 2 to 85"),
        (lambda: heavytop.Gyrostat([1, 1, 3], 1, [0, 0, 1], [0, 0, 0]), "none above the sum of the others"),
        (lambda: heavytop.Vortices([1, 1]).solve([[1, 0, 0], [0, 2, 0]], step=0.1, end=1), "the length of number 2 is 2"),
        (lambda: heavytop.Vortices([1, 1]).solve([[1, 0, 0]], step=0.1, end=1), r"shape \(2, 3\) or \(6,\), got \(1, 3\)"),
        (lambda: heavytop.Vortices([1, 2]).solve([1, 0, 0, 0, 1, 0], step=0.1, end=1), "m_2 must have the length of strength 2"),
        (lambda: heavytop.Vortices([[1, 2], [3, 4]]), "strengths must be one-dimensional"),
        (lambda: heavytop.Vortices([1, 1]).solve({"seed": 1}, step=0.1, end=1), "there is no seed. It takes positions"),
        (lambda: heavytop.RigidBody(np.eye(4)), "moments must be one-dimensional"),
        (lambda: heavytop.RigidBody(4, [1, 2, 3]), r"moments must have the shape \(4,\), one for each of 4 axes, got \(3,\)"),
        (lambda: heavytop.RigidBody(), "moments are missing"),
        (lambda: heavytop.Vortices([1, 1], [[1, 0, 0]]), r"positions must have the shape \(2, 3\), got \(1, 3\)"),
        (lambda: heavytop.Vortices([1, 1]).solve(step=0.1, end=1), "y0 is missing: this system was made without a start"),
        (lambda: heavytop.lyapunov(heavytop.Top.kovalevskaya(), step=0.1, end=1), "y0 is missing: a top is made without a start"),
        (lambda: heavytop.SpinChain(3, 1).solve(np.ones((2, 3)), step=0.1, end=1), r"shape \(3, 3\) or \(9,\), got \(2, 3\)"),
        (lambda: heavytop.EllipticalVortex(1).solve({"a": 1.0}, step=0.1, end=1), "b is missing"),
    ],
)
def test_what_is_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()


@pytest.mark.parametrize(
    ("kind", "parameters", "initial"),
    [
        ("body-in-fluid", {"inertia": [2, 2.5, 3], "masses": [3, 1.5, 2]}, {"Pi": [1, 0.5, 0.2], "P": [0.3, 1, 0]}),
        ("body-with-rotors", {"I": [1, 2, 3], "J": [0.1, 0.2]}, {"Pi": [0.3, 1, 0.2], "l": [0.2, 0.1]}),
        ("elliptical-vortex", {"strength": 1, "strain": 0.05}, {"a": 1.5, "b": 0.5, "angle": 0.3}),
        (
            "gyrostat",
            {"inertia": [2, 2, 1], "weight": 1, "center_of_mass": [0, 0, 1], "rotor": [0, 0, 2]},
            {"Pi": [0.5, 0, 3], "Gamma": [0.6, 0, 0.8]},
        ),
        ("rigid-body", {"moments": [1, 1.5, 2]}, {"Pi": [1, 0.2, -0.3]}),
        ("satellite", {"I": [1, 1.2, 0.4], "n": 1.3}, {"roll": 0.3, "yaw": -0.2, "relative": [0.1, 0, 0.2]}),
        ("spin-chain", {"spins": 2, "exchange": 1}, {"S_1": [1, 0, 0], "S_2": [0, 0.6, 0.8]}),
        (
            "top-on-base",
            {"inertia": [2, 2, 1], "mass": 0.8, "base_mass": 1.3, "gravity": 9.8, "center_of_mass": [0, 0, 0.5]},
            {"Pi": [0.5, 0, 5], "P": [0.1, 0, 0], "Gamma": [0.6, 0, 0.8]},
        ),
        ("vortices", {"strengths": [1, -0.7]}, {"positions": [[1, 0, 0], [0, 0.6, 0.8]]}),
    ],
)
def test_the_program_computes_the_same_bytes(program, tmp_path, kind, parameters, initial):
    def table(values):
        return "{ " + ", ".join(f"{name} = {value}" for name, value in values.items()) + " }"

    text = f"[system]\nkind = '{kind}'\nparameters = {table(parameters)}\ninitial = {table(initial)}\n"
    (tmp_path / "a.toml").write_text(text + "[integrator]\nstep = 0.05\nend = 2\n")
    arguments = [program, "simulate", tmp_path / "a.toml", "--out", tmp_path / "a.csv", "--quiet"]
    subprocess.run(arguments, check=True)
    table_of_program = np.loadtxt(tmp_path / "a.csv", delimiter=",", skiprows=1)
    run = System(kind=kind, parameters=parameters).solve(initial, step=0.05, end=2)
    assert (table_of_program[:, 0] == run.t).all()
    d = run.y.shape[0]
    assert (table_of_program[:, 1 : d + 1] == run.y.T).all()
    assert (table_of_program[:, d + 1 :] == np.stack(list(run.invariants.values()), axis=1)).all()


def test_a_semidirect_product_with_a_representation_of_ones_own():
    """Vectors of R^3 by their matrices are R3; the spinors of su(2) are C2, whose numbers x + iy are pairs."""
    hats = np.zeros((3, 3, 3))
    for i in range(3):
        hats[i][(i + 2) % 3, (i + 1) % 3], hats[i][(i + 1) % 3, (i + 2) % 3] = 1, -1
    text = "|Pi|^2/2 + Pi1^2 + {0}1 + 0.3*{0}2^2"
    own = System("so(3) |x V", text.format("V"), representations={"V": hats})
    named = System("so(3) |x R3", text.format("Gamma"))
    start = [0.3, -0.2, 1, 0.6, 0, 0.8]
    assert own.coordinates[3:] == ("V1", "V2", "V3")
    assert np.abs(own.rate(start) - named.rate(start)).max() < 1e-15
    many = System("so(3) |x (V^2 + W)", "Pi1*W2 + V_2_3", representations={"V": hats, "W": hats})
    three = System("so(3) |x R3^3", "Pi1*Gamma_3_2 + Gamma_2_3")
    y = np.random.default_rng(3).normal(size=12)
    assert np.abs(many.rate(y) - three.rate(y)).max() < 1e-15 and np.abs(many.rate(y)).max() > 0.1
    pauli = np.array([[[0, 1], [1, 0]], [[0, -1j], [1j, 0]], [[1, 0], [0, -1]]])
    spinors = System("su(2) |x Z", "mu1 + Z1^2", representations={"Z": -0.5j * pauli})
    assert spinors.dimension == 7 and "|Z|^2" in spinors.casimirs.values()
    assert pickle.loads(pickle.dumps(own)).coordinates == own.coordinates
    with pytest.raises(ValueError, match="V is no representation: the commutator of the matrices of Pi1 and Pi2 differs"):
        System("so(3) |x V", "V1", representations={"V": 2 * hats})
    with pytest.raises(ValueError, match="V is no representation: it has 2 matrices, and the algebra before it 3"):
        System("so(3) |x V", "V1", representations={"V": hats[:2]})
    with pytest.raises(ValueError, match=r"representations\['V'\] must have the shape"):
        System("so(3) |x V", "V1", representations={"V": np.ones((3, 2, 3))})
    with pytest.raises(ValueError, match="V is no representation: the expression of the algebra does not name it"):
        System("so(3) |x W", "V1", representations={"V": hats})
    with pytest.raises(ValueError, match="a representation that is given must stand here"):
        System("so(3) |x (V + W)", "V1", representations={"V": hats})


def test_a_run_that_has_used_up_its_digits_says_so():
    vortex = heavytop.EllipticalVortex(2.0, 0.4, 0.05)
    start = {"a": 2, "b": 1, "angle": 0.3}
    with pytest.warns(RuntimeWarning, match="c1, of size 4.0e0, is at the end a difference"):
        vortex.solve(start, step=0.05, end=19)
    run = vortex.solve(start, step=0.05, end=5)
    a, b, angle = vortex.ellipse(run.y)
    assert np.abs(a * b - 2).max() < 1e-9 and a[0] == pytest.approx(2) and angle[0] == pytest.approx(0.3)
    with pytest.raises(ValueError, match="strength must be other than 0"):
        heavytop.EllipticalVortex(0)


def test_an_ellipse_drives_the_pitch_of_a_satellite():
    # Linear theory: 2 e/(k - 1) sin nu with k = 3 (I1 - I3)/I2, here 4 e sin nu; what is left is of the order of e^2.
    def error(e, response=4):
        boom = heavytop.Satellite([1, 1.2, 0.4], 1.3, eccentricity=e, mean_anomaly=np.pi)
        run = boom.solve({"relative": [0, -1.3 * 4 * e, 0]}, step=0.1, end=9)
        assert run.kept == ("c1", "c2", "c3") and run.deviation("c1") < 1e-12
        return abs(boom.angles(run.y)[1] - response * e * np.sin(1.3 * run.t + np.pi)).max()

    assert error(1e-3) < 4e-5 and abs(error(2e-3) / error(1e-3) - 4) < 0.1
    assert error(1e-3, 3.8) > 1e-4


def test_formulas_name_the_rate_and_the_tide_of_an_orbit():
    moments, n, start = [1, 1.2, 0.4], 1.3, {"pitch": 0.3}
    surface, torque = "Pi2 - 1.2*orbit_rate", {"Pi": [0, "0.1*orbit_tide + 0.2*orbit_rate", 0]}
    run = {"step": 0.05, "end": 6}
    circle = heavytop.Satellite(moments, n)
    times = circle.solve(start, events=surface, **run).t_events[0]
    assert times.size > 1 and np.array_equal(times, circle.section(start, surface, direction=0, **run).t)
    assert times == pytest.approx(circle.solve(start, events="Pi2 - 1.2*n", **run).t_events[0], abs=1e-12)
    by_tide = circle.section(start, "Pi2 - 1.2*orbit_tide", direction=0, **run).t
    assert by_tide == pytest.approx(circle.section(start, "Pi2 - 1.2*n^2", direction=0, **run).t, abs=1e-12)
    assert by_tide.size > 1 and by_tide[0] != pytest.approx(times[0], abs=0.1), "control"
    pushed = heavytop.Satellite(moments, n, torque=torque).solve(start, **run)
    same = heavytop.Satellite(moments, n, torque={"Pi": [0, "0.1*n^2 + 0.2*n", 0]}).solve(start, **run)
    assert np.array_equal(pushed.y, same.y)
    # On an ellipse that is almost a circle they are almost the same, and of the time.
    ellipse = heavytop.Satellite(moments, n, eccentricity=1e-6)
    assert ellipse.section(start, surface, direction=0, **run).t == pytest.approx(times, abs=1e-4)


@pytest.mark.parametrize(
    ("system", "given", "name", "others"),
    [
        (heavytop.Satellite, ([1, 1.2, 0.4], 1.3), "Gamma_1", "Pi"),
        (heavytop.Satellite, ([1, 1.2, 0.4], 1.3, 0.1), "Gamma_2", "Pi"),
        (heavytop.Gyrostat, ([2, 2, 1], 1.0, [0, 0, 1], [0, 0, 5]), "Gamma", "Pi"),
        (heavytop.TopOnBase, ([1, 1.2, 0.5], 1.0, 2.0, 9.81, [0, 0, 0.3]), "Gamma", "Pi and P"),
    ],
)
def test_no_torque_acts_on_a_direction(system, given, name, others):
    words = f"a torque has formulas for {others} alone: {name} is a direction in space"
    for formulas in ([0, 0.1, 0], [0, 0, "t"], [f"{name}[1]", 0, 0]):
        with pytest.raises(ValueError, match=re.escape(words)):
            system(*given, torque={name: formulas})
    assert system(*given, torque={"Pi": [0, 0.1, 0], name: [0, 0, 0]}).formulations == ("direct",)


def test_a_satellite_without_eccentricity_is_that_on_a_circle():
    start = {"pitch": 0.3, "roll": 0.1}
    circle = heavytop.Satellite([1, 1.2, 0.4], 1.3).solve(start, step=0.1, end=3)
    given = heavytop.Satellite([1, 1.2, 0.4], 1.3, eccentricity=0, true_anomaly=1).solve(start, step=0.1, end=3)
    assert np.array_equal(circle.y, given.y) and given.kept == ("h", "c1", "c2", "c3")
    ellipse = heavytop.Satellite([1, 1.2, 0.4], 1.3, eccentricity=0.3, true_anomaly=1)
    run = ellipse.solve(start, step=0.1, end=3, events="orbit_tide - 1.69")
    assert len(run.t_events[0]) == 1 and not np.allclose(run.y[:, -1], circle.y[:, -1], atol=0.1)
    other = pickle.loads(pickle.dumps(ellipse))
    assert np.array_equal(other.solve(start, step=0.1, end=3).y, run.y)
    ends = heavytop.solve_many(ellipse, [start] * 2, step=0.1, end=3)
    assert np.array_equal(ends.y[:, 1], run.y[:, -1])


@pytest.mark.parametrize(
    ("orbit", "message"),
    [
        ({"eccentricity": -0.1}, "eccentricity must be at least 0 and below 1, got -0.1"),
        ({"eccentricity": 1}, "eccentricity must be at least 0 and below 1, got 1"),
        ({"eccentricity": np.nan}, "eccentricity"),
        ({"eccentricity": 0.1, "mean_anomaly": 1, "true_anomaly": 1}, "true_anomaly must be left out"),
    ],
)
def test_impossible_orbits_are_refused(orbit, message):
    with pytest.raises(ValueError, match=message):
        heavytop.Satellite([1, 1.2, 0.4], 1.3, **orbit)


WHEELS = ([3, 2, 1.5], [[0, 1, 0], [3, 0, 4]], [0.1, 0.05])


def test_motors_move_momentum_between_body_and_wheels():
    motors = [([0, 3.33, 8], [0.2, 0, 0], "constant"), "0.1*sin(t)"]
    body = heavytop.ReactionWheels(*WHEELS, motors=motors)
    start = {"Omega": [0.3, 0.5, -0.2], "speeds": [0, 20]}
    run = body.solve(start, step=0.1, end=8)
    assert body.kept == ("c3",) and body.casimirs["c3"] == "|Pi|^2"
    assert np.allclose(body.angular_velocity(run.y)[:, 0], start["Omega"], atol=1e-15)
    assert np.allclose(body.speeds(run.y[:, 0]), start["speeds"], atol=1e-13)
    gained = run.y[3:, -1] - run.y[3:, 0]
    assert np.allclose(gained, [0.2 * 3.33, 0.1 * (1 - np.cos(8))], atol=1e-13)
    # The angular momentum of the whole turns in the body, and keeps its length.
    assert abs(np.linalg.norm(run.y[:3], axis=0) / np.linalg.norm(run.y[:3, 0]) - 1).max() < 1e-13
    assert np.ptp(run.y[1]) > 0.1
    # A torque on l is the same, and a motor that does nothing is a wheel that turns freely.
    same = heavytop.ReactionWheels(*WHEELS, inputs={"m": motors[0]}, torque={"l": ["m", "0.1*sin(t)"]})
    assert np.abs(same.solve(start, step=0.1, end=8).y - run.y).max() < 1e-13
    assert np.array_equal(pickle.loads(pickle.dumps(body)).solve(start, step=0.1, end=8).y, run.y)
    free = heavytop.ReactionWheels(*WHEELS).solve(start, step=0.1, end=8)
    idle = heavytop.ReactionWheels(*WHEELS, motors=[0, 0.0]).solve(start, step=0.1, end=8)
    assert np.abs(idle.y - free.y).max() < 1e-10 and free.kept == ("h", "c1", "c2", "c3")


def test_a_wheel_stops_the_swing_of_a_satellite():
    def end(spring, brake):
        law = {"l": [f"-{spring}*Gamma_1[1] + {brake}*((Pi2 - l1)/120 - 0.001)"]}
        boom = heavytop.Satellite([100, 120, 40], 1e-3, axes=[0, 1, 0], inertias=0.05, torque=law)
        return boom.angles(boom.solve({"pitch": 0.1, "speeds": [30]}, step=20, end=4000).y)[1][-1]

    assert abs(end(9e-4, 0.6)) < 1e-4 and abs(end(0, 0)) > 1e-3


def test_wrong_wheels_are_refused():
    for change, message in [
        ({"axes": [[0, 1, 0], [0, 0, 0]]}, "axes must be of a length that is not 0"),
        ({"inertias": [0.1, 0.1, 0.1]}, "J must be a number for each of 2 axes, got 3"),
        ({"motors": ["1"]}, "torque\\['l'\\] must have 2 formulas, got 1"),
        ({"motors": [([0, 1], [1], "linear"), 0]}, "motor_1"),
        ({"motors": [0, 0], "torque": {"l": [0, 0]}}, "write motors, or a torque on l"),
    ]:
        given = {"moments": WHEELS[0], "axes": WHEELS[1], "inertias": WHEELS[2], **change}
        with pytest.raises(ValueError, match=message):
            heavytop.ReactionWheels(**given)
    short = heavytop.ReactionWheels(*WHEELS, motors=[([0, 1], [1, 1], "linear"), 0])
    with pytest.raises(ValueError, match="from 0 to 1, and the run from 0 to 2"):
        short.solve({"Omega": [0, 0, 1]}, step=0.1, end=2)
