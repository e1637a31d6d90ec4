"""Systems of arrays: lattices of spins, vortices and fluids of any size."""

import math
import pickle
import subprocess

import numpy as np
import pytest

import heavytop
from heavytop import Event, ManyVortices, SphereFluid, SpinLattice, VibratingLattice, Vortices, lyapunov, solve_many


def spins(shape, seed=0):
    x = np.random.default_rng(seed).normal(size=(*shape, 3))
    return x / np.linalg.norm(x, axis=-1, keepdims=True)


def test_a_lattice_has_the_equations_of_its_energy():
    """The rate is s x H, and the energy the sum, both by NumPy."""
    field, axis, k = np.array([0.1, -0.2, 0.3]), np.array([1.0, 2.0, 2.0]) / 3, 0.4
    lattice = SpinLattice((4, 3, 5), [1.0, -0.5, 0.7], k, field, axis, bonds=[[1, 1, 0, 0.3]])
    s = spins((4, 3, 5))
    neighbours = [((1, 0, 0), 1.0), ((0, 1, 0), -0.5), ((0, 0, 1), 0.7), ((1, 1, 0), 0.3)]
    near = np.zeros_like(s)
    energy = -k * ((s @ axis) ** 2).sum() - (s @ field).sum()
    for offset, j in neighbours:
        # The neighbour of the spin at i is that at i + offset.
        forth = np.roll(s, [-d for d in offset], axis=(0, 1, 2))
        near += j * (forth + np.roll(s, offset, axis=(0, 1, 2)))
        energy -= j * (s * forth).sum()
    expected = np.cross(s, near + 2 * k * (s @ axis)[..., None] * axis + field)
    y = s.reshape(-1)
    assert np.abs(lattice.rate(y).reshape(s.shape) - expected).max() < 1e-13
    assert abs(lattice.invariant_values(y)["h"] - energy) < 1e-12
    assert lattice.invariants == ("h", "C")


def test_runs_have_arrays_of_the_shapes_of_the_field():
    lattice = SpinLattice((4, 3), 1.0)
    run = lattice.solve(spins((4, 3)), step=0.1, end=1, formulation="reduced", scheme="spherical-midpoint")
    assert run["S"].shape == (11, 4, 3, 3) and run.y.shape == (36, 11)
    assert (run["S"][3] == run.y[:, 3].reshape(4, 3, 3)).all()
    assert (lattice.unpack(run.y)["S"] == run["S"]).all()
    assert lattice.unpack(run.y[:, 0])["S"].shape == (4, 3, 3)
    assert np.abs(np.linalg.norm(run["S"], axis=-1) - 1).max() < 1e-14
    assert all(run.deviation(name) < 1e-13 for name in ("M1", "M2", "M3", "C"))
    vibrating = VibratingLattice(5, 1.0, coupling=0.5)
    run = vibrating.solve({"S": spins((5,)), "q": np.zeros(5), "p": [0.1, 0, 0, 0, 0]}, step=0.05, end=2)
    assert run["S"].shape == (41, 5, 3) and run["q"].shape == run["p"].shape == (41, 5)
    assert run.deviation("P") < 1e-14 and run.deviation("h") < 1e-9
    longer = vibrating.solve({"S": spins((5,))}, step=0.25, end=5)
    assert longer.check().order == pytest.approx(8, abs=0.6)


def test_states_between_steps_and_the_same_run_again():
    lattice = SpinLattice(6, 1.0, field=[0, 0, 0.2])
    run = lattice.solve(spins((6,)), np.linspace(0, 1, 11))
    again = lattice.solve({"S": run["S"][0]}, step=0.1, end=1)
    assert (run.y == again.y).all()
    assert np.abs(run.sol([0.3]) - run.y[:, 3:4]).max() < 1e-12
    ends = solve_many(lattice, run.y[:, :2], step=0.1, end=1)
    assert (ends.y[:, 0] == run.y[:, -1]).all()
    assert ends.deviation("C").max() < 1e-13


def test_exponents_of_a_chain_are_those_of_its_formula():
    s = spins((4,), 5)
    chaos = [lyapunov(system, s.reshape(-1), step=0.1, end=20) for system in (SpinLattice(4, 1.0), heavytop.SpinChain(4, 1.0))]
    assert chaos[0].exponents == pytest.approx(chaos[1].exponents, abs=1e-9)
    fluid = SphereFluid(4)
    with pytest.raises(ValueError, match="tangent vectors in the formulation direct alone"):
        lyapunov(fluid, fluid.start(degrees=[1, 3]), step=0.1, end=1, formulation="reduced")


def test_exponents_of_a_fluid_are_those_of_its_neighbours():
    """The growth of a tangent vector against that of the distance of a near state, and none for a zonal flow."""
    fluid = SphereFluid(8)
    y, step, end = fluid.start(degrees=[2, 6], seed=3), 0.05, 8.0
    growth = lyapunov(fluid, y, step=step, end=end, scheme="gauss-4")
    rng = np.random.default_rng(0)
    near = y + 1e-8 * rng.normal(size=y.shape) * (y != 0)
    runs = [fluid.solve(one, step=step, end=end, scheme="gauss-4", formulation="direct") for one in (y, near)]
    apart = np.linalg.norm(runs[1].y - runs[0].y, axis=0)
    # Generic directions have the growth of the largest exponent up to factors of order 1.
    assert growth.exponents[0] == pytest.approx(math.log(apart[-1] / apart[0]) / end, abs=0.3)
    assert growth.exponents[0] > 0.05
    zonal = lyapunov(fluid, {"coefficients": [[1, 0, 2, 0]]}, step=0.05, end=8, scheme="gauss-4")
    assert abs(zonal.exponents[0]) < 1e-6


def test_a_wave_on_the_rotating_sphere():
    c, rotation, l, m = 1.0, 0.5, 4, 3
    fluid = SphereFluid(12, rotation=rotation)
    rows = [[1, 0, (c + 2 * rotation) * math.sqrt(4 * math.pi / 3), 0], [l, m, 0.3, 0.1]]
    run = fluid.solve({"coefficients": rows}, step=0.05, end=2)
    sigma = (c + 2 * rotation) / (l * (l + 1)) - c / 2
    wave = fluid.harmonics(run.y)[:, l, m]
    assert np.abs(wave - (0.3 + 0.1j) * np.exp(1j * m * sigma * run.t)).max() < 1e-9
    assert run["omega"].shape == (41, 12, 12) and fluid.invariants == ("h", "Z", "M3")
    # What is read is what was given.
    assert np.abs(fluid.solve(run["omega"][7], step=0.1, end=0.1)["omega"][0] - run["omega"][7]).max() < 1e-14
    energy = fluid.invariant_values(run.y[:, 0])
    # Z is the sum of |omega_lm|^2, in which each m above 0 counts twice.
    assert energy["Z"] == pytest.approx(rows[0][2] ** 2 + 2 * 0.1, abs=1e-12)


def test_many_vortices_are_those_of_the_formula():
    k = np.linspace(0.5, 1.5, 7)
    few, many = Vortices(k), ManyVortices(k)
    x = many.positions(many.start(seed=4))
    runs = [system.solve(start, step=0.01, end=0.5) for system, start in ((few, x), (many, {"positions": x}))]
    assert np.abs(runs[0].y - runs[1].y).max() < 1e-12
    assert np.abs(np.linalg.norm(many.positions(runs[1].y), axis=-1) - 1).max() < 1e-13
    assert many.positions(runs[1].y).shape == (51, 7, 3)


def test_events_are_functions_of_the_arrays():
    """The spins of a field turn at |B|: their mean first component vanishes at known times."""
    lattice = SpinLattice((2, 3), 1.0, field=[0, 0, 0.5])
    start = {"direction": [1, 0, 1]}

    def across(x):
        assert x["S"].shape == (2, 3, 3)
        return x["S"][..., 0].mean()

    run = lattice.solve(start, step=0.1, end=15, events=[across, Event(across, direction=1, terminal=True)])
    times = [math.pi * (k + 0.5) / 0.5 for k in range(2)]
    assert run.t_events[0] == pytest.approx(times, abs=1e-8)
    assert run.t_events[1] == pytest.approx(times[1:], abs=1e-8) and run.t[-1] == run.t_events[1][0]
    assert np.abs(lattice.unpack(run.y_events[0].T)["S"][..., 0]).max() < 1e-8
    # What the function sees and returns is in the arrays of the user, also for a fluid.
    fluid = SphereFluid(5)
    wave = fluid.solve({"coefficients": [[1, 0, 3, 0], [3, 2, 0.2, 0]]}, step=0.05, end=6, events=lambda x: x["omega"][3, 2])
    assert len(wave.t_events[0]) > 0
    assert np.abs(fluid.unpack(wave.y_events[0].T)["omega"][:, 3, 2]).max() < 1e-9

    def failing(x):
        if x["S"][0, 0, 0] < 0:
            raise RuntimeError("the user's own")
        return 1.0

    # Without a value later, the run ends there.
    ended = lattice.solve(start, step=0.1, end=5, events=lambda x: 1.0 if x["S"][0, 0, 0] > 0 else float("nan"))
    assert not ended.success and ended.t[-1] == pytest.approx(math.pi, abs=0.11) and "not a number" in ended.message

    with pytest.raises(RuntimeError, match="the user's own"):
        lattice.solve(start, step=0.1, end=15, events=failing)


def test_an_open_chain_is_that_of_its_formula():
    s = spins((5,), 7)
    few = heavytop.SpinChain(5, 1.0, periodic=False)
    assert np.abs(SpinLattice(5, 1.0, periodic=False).rate(s.reshape(-1)) - few.rate(s.reshape(-1))).max() < 1e-14
    assert np.abs(SpinLattice(5, 1.0).rate(s.reshape(-1)) - few.rate(s.reshape(-1))).max() > 0.1
    with pytest.raises(ValueError, match="whole numbers along periodic axes, got 0.5"):
        SpinLattice(5, 1.0).start(waves=[0.5], cone=0.2)
    assert SpinLattice(5, 1.0, periodic=False).start(waves=[0.5], cone=0.2).shape == (15,)


def test_a_fluid_starts_from_its_grid():
    """Legendre's P2 and a wave with the phase of Condon and Shortley, on the colatitudes and longitudes of the grid."""
    fluid = SphereFluid(8)
    theta = math.pi * (np.arange(15) + 0.5) / 15
    phi = math.pi * np.arange(30) / 15
    p2 = (3 * np.cos(theta) ** 2 - 1) / 2
    # Y_11 is -sqrt(3/(8 pi)) sin(theta) exp(i phi), and its real part counts twice.
    wave = -2 * math.sqrt(3 / (8 * math.pi)) * np.outer(np.sin(theta), np.cos(phi))
    state = fluid.start(vorticity=p2[:, None] + wave)
    omega = fluid.harmonics(state)
    assert omega[2, 0] == pytest.approx(math.sqrt(4 * math.pi / 5), abs=1e-13)
    assert omega[1, 1] == pytest.approx(1, abs=1e-13)
    omega[2, 0] = omega[1, 1] = 0
    assert np.abs(omega).max() < 1e-13
    assert np.abs(fluid.vorticity(state) - p2[:, None] - wave).max() < 1e-13
    run = fluid.solve({"degrees": [1, 7], "seed": 2}, step=0.05, end=0.2)
    grid = fluid.vorticity(run.y)
    assert grid.shape == (5, 15, 30) and fluid.vorticity(run.y[:, 0], rows=4).shape == (4, 8)
    assert np.abs(fluid.start(vorticity=grid[3]) - run.y[:, 3]).max() < 1e-13


def test_starts_by_name_of_many_and_of_exponents():
    lattice = SpinLattice((2, 2), 1.0)
    named = [{"tilt": 0.5, "seed": i} for i in range(3)]
    flat = np.stack([lattice.start(**one) for one in named], axis=1)
    assert (solve_many(lattice, named, step=0.1, end=1).y == solve_many(lattice, flat, step=0.1, end=1).y).all()
    one, other = (lyapunov(lattice, start, step=0.1, end=2).exponents for start in (named[0], flat[:, 0]))
    assert one == other
    pair, x = Vortices([1.0, 2.0]), np.array([[1, 0, 0], [0, 1, 0.0]])
    found = [lyapunov(pair, start, step=0.1, end=2).exponents for start in (x, {"positions": x}, [1, 0, 0, 0, 2, 0])]
    assert found[0] == found[1] == found[2]


@pytest.mark.parametrize(
    "make",
    [
        lambda: SpinLattice((3, 2), 1.0, bonds=[[1, 1, 0, 0.5]]),
        lambda: VibratingLattice(3, 1.0),
        lambda: SphereFluid(4),
        lambda: ManyVortices([1.0, 2.0]),
    ],
)
def test_systems_can_be_copied(make):
    system = make()
    copy = pickle.loads(pickle.dumps(system))
    given = {"SphereFluid": {"degrees": [1, 3]}, "ManyVortices": {"seed": 1}}
    start = system.start(**given.get(type(system).__name__, {"tilt": 0.5, "seed": 1}))
    assert copy.shapes == system.shapes and repr(copy) == repr(system)
    assert (copy.solve(start, step=0.1, end=0.2).y == system.solve(start, step=0.1, end=0.2).y).all()


def test_the_program_computes_the_same_bytes(program, tmp_path):
    """The same spins, vortices and fluid by the program, to the last bit."""
    cases = [
        ("spin-lattice", SpinLattice((3, 4), 1.0, field=[0, 0, 0.2]), {"tilt": 1.0, "seed": 2}, "shape = [3, 4], exchange = 1, field = [0, 0, 0.2]"),
        ("vibrating-lattice", VibratingLattice(4, 1.0, coupling=0.5), {"waves": [1], "cone": 0.4}, "atoms = 4, exchange = 1, coupling = 0.5"),
        ("sphere-fluid", SphereFluid(6, rotation=0.2), {"degrees": [1, 4]}, "size = 6, rotation = 0.2"),
        ("vortices", ManyVortices(np.full(50, 0.02)), {"seed": 3}, f"strengths = {[0.02] * 50}"),
    ]
    for kind, system, start, parameters in cases:
        initial = ", ".join(f"{name} = {value}" for name, value in start.items())
        text = f"[system]\nkind = '{kind}'\nparameters = {{ {parameters} }}\ninitial = {{ {initial} }}\n[integrator]\nstep = 0.1\nend = 2\n"
        (tmp_path / "a.toml").write_text(text)
        out = tmp_path / f"{kind}.npz"
        subprocess.run([program, "simulate", tmp_path / "a.toml", "--out", out, "--quiet"], check=True)
        run = system.solve(start, step=0.1, end=2)
        with np.load(out) as archive:
            assert (archive["t"] == run.t).all()
            for name in system.shapes:
                assert (archive[name] == run[name]).all(), kind
            for name in system.invariants:
                assert (archive[name] == run.invariants[name]).all(), (kind, name)


def test_a_start_may_be_given_with_the_system():
    positions = np.array([[1, 0, 0], [0, 0.6, 0.8], [0, 0, -1]])
    waves = {"coefficients": [[2, 1, 0.3, 0.1], [3, 0, 0.2, 0]]}
    grid = SphereFluid(4).vorticity(SphereFluid(4).start(**waves))
    for system, start in [
        (heavytop.Vortices([1.0, 2.0, -1.0], positions), positions),
        (heavytop.ManyVortices([1.0, 2.0, -1.0], positions), {"positions": positions}),
        (SphereFluid(4, **waves), waves),
        (SphereFluid(4, grid), {"vorticity": grid}),
    ]:
        own, given = system.solve(step=0.1, end=1), system.solve(start, step=0.1, end=1)
        assert (own.y == given.y).all() and np.abs(own.y[:, -1] - own.y[:, 0]).max() > 1e-3
        chaos = [lyapunov(system, *y0, step=0.1, end=1) for y0 in ([], [start])]
        assert chaos[0].megno == chaos[1].megno
        # Another start is another motion, and the own one stays.
        other = system.solve(own.y[:, -1], step=0.1, end=1)
        # A fluid keeps its coefficients as a matrix, so that they are rounded once.
        assert np.abs(other.y[:, 0] - own.y[:, -1]).max() < 1e-15 and (system.solve(step=0.1, end=1).y == own.y).all()


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        (lambda: SpinLattice((0, 4), 1.0), "shape must be one to three whole numbers"),
        (lambda: SpinLattice((2, 2), [1, 2, 3]), "one for each of 2 axes, got 3"),
        (lambda: SpinLattice((2, 2), axis=[0, 0, 0], anisotropy=1.0), "axis must be different from 0"),
        (lambda: VibratingLattice(2, 1.0), "atoms must be a whole number from 3 on, got 2"),
        (lambda: SphereFluid(1), "size must be a whole number from 2 on, got 1"),
        (lambda: SphereFluid(1e9), "from 2 to 2048"),
        (lambda: ManyVortices([1.0, 0.0]), "strength"),
        (lambda: heavytop.ArraySystem("spins", {}), "there is no system of arrays spins; there are sphere-fluid"),
        (lambda: SpinLattice(4, 1.0).solve(np.ones((5, 3)), step=0.1, end=1), r"y0 must have the shape \(12,\), or be given by name, S \(4, 3\); got"),
        (lambda: SpinLattice(4, 1.0).solve(np.zeros((4, 3)), step=0.1, end=1), "number 1 is 0"),
        (lambda: SpinLattice(4, 1.0).solve({"S": np.ones((4, 3)), "tip": 1}, step=0.1, end=1), "there is no tip"),
        (lambda: SpinLattice(4, 1.0).solve({"tilt": 1}, step=0.1, end=1, events=["S"]), r"events\[0\] must be a function of the arrays"),
        (lambda: SpinLattice(4, 1.0).solve({"tilt": 1}, step=0.1, end=1, events=lambda x: x["T"]), "T"),
        (lambda: SpinLattice(4, 1.0).solve({"tilt": 1}, step=0.1, end=1, events=lambda x: x["S"]), r"events\[0\] must be a number, got the shape"),
        (lambda: SpinLattice((4, 4), 1.0).start(S=np.ones((3, 4, 4))), r"y0\['S'\] must have the shape \(4, 4, 3\), got \(3, 4, 4\)"),
        (lambda: SpinLattice(4, 1.0, periodic=2), "periodic must be True or False"),
        (lambda: SpinLattice(4, bonds=[1, 0, 0, 1]), r"bonds must have the shape \(n, 4\), got \(4,\)"),
        (lambda: SpinLattice(4), "without them nothing moves"),
        (lambda: SpinLattice(4, 1.0).structure_constants, "no table of structure constants"),
        (lambda: SphereFluid(4).vorticity(np.zeros(16), 10**7), "rows must be at most 8192"),
        (lambda: lyapunov(SpinLattice((4, 3), 1.0), {"tilt": 1}, step=0.1, end=1, exponents=37), "exponents must be from 1 to 36, got 37"),
        (lambda: SphereFluid(4).start(omega=np.ones((2, 8))), r"must have the shape \(4, 4\), got \(2, 8\)"),
        (lambda: SphereFluid(4).start(vorticity=np.ones((14, 7))), r"must have the shape \(r, 2 r\), got \(14, 7\)"),
        (lambda: SphereFluid(4).start(vorticity=np.ones((6, 12))), "r at least 7, got 72"),
        (lambda: SphereFluid(4).start(vorticity=np.ones((7, 14))), "without a mean"),
        (lambda: SphereFluid(4).start(coefficients=[2, 0, 1, 0]), r"must have the shape \(n, 4\), got \(4,\)"),
        (lambda: ManyVortices([[1.0, 2.0], [3.0, 4.0]]), r"strengths must be one-dimensional, got the shape \(2, 2\)"),
        (lambda: ManyVortices([1.0, 2.0]).start(positions=np.ones((3, 2))), r"must have the shape \(2, 3\), got \(3, 2\)"),
        (lambda: VibratingLattice(4, 1.0).solve(np.ones((4, 3)), step=0.1, end=1), r"S \(4, 3\), q \(4,\), p \(4,\); got"),
        (lambda: SpinLattice(4, 1.0).section({"tilt": 1}, "S", step=0.1, end=1), "has no sections"),
        (lambda: SpinLattice(4, 1.0).solve({"tilt": 1}, step=0.1, end=1, scheme="spherical-midpoint"), "no collective spherical-midpoint"),
        (lambda: SphereFluid(4).solve(step=0.1, end=1), "y0 is missing: this system was made without a start"),
        (lambda: lyapunov(SpinLattice(4, 1.0), step=0.1, end=1), "y0 is missing: this system was made without a start"),
        (lambda: SphereFluid(4, np.ones((7, 14))), "without a mean"),
        (lambda: ManyVortices([1.0, 2.0], [[1, 0, 0]]), r"must have the shape \(2, 3\), got \(1, 3\)"),
        (lambda: SphereFluid(4).solve({}, step=0.1, end=1), "coefficients must be given, or vorticity"),
        (lambda: SpinLattice(4, 1.0).solve({"tilt": 1}, step=0.1, end=1)["q"], "the arrays are S, got 'q'"),
    ],
)
def test_what_does_not_fit_is_refused(wrong, said):
    with pytest.raises((ValueError, KeyError), match=said):
        wrong()
