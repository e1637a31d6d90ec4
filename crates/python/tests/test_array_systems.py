"""Systems of arrays: lattices of spins, vortices and fluids of any size."""

import math
import pickle
import subprocess

import numpy as np
import pytest

import heavytop
from heavytop import ManyVortices, SphereFluid, SpinLattice, VibratingLattice, Vortices, lyapunov, solve_many


def spins(shape, seed=0):
    x = np.random.default_rng(seed).normal(size=(*shape, 3))
    return x / np.linalg.norm(x, axis=-1, keepdims=True)


def test_a_lattice_has_the_equations_of_its_energy():
    """The rate is s x H, and the energy the sum, both by NumPy."""
    field, axis, k = np.array([0.1, -0.2, 0.3]), np.array([1.0, 2.0, 2.0]) / 3, 0.4
    lattice = SpinLattice((4, 3, 5), [1.0, -0.5, 0.7], k, axis, field, bonds=[[1, 1, 0, 0.3]])
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
    with pytest.raises(heavytop.IntegrationError, match="have no tangent vectors"):
        lyapunov(fluid, fluid.start(degrees=[1, 3]), step=0.1, end=1)


def test_a_wave_on_the_rotating_sphere():
    c, rotation, l, m = 1.0, 0.5, 4, 3
    fluid = SphereFluid(12, rotation)
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
    start = system.start(**({"degrees": [1, 3]} if isinstance(system, SphereFluid) else {"seed": 1}))
    assert copy.shapes == system.shapes and repr(copy) == repr(system)
    assert (copy.solve(start, step=0.1, end=0.2).y == system.solve(start, step=0.1, end=0.2).y).all()


def test_the_program_computes_the_same_bytes(program, tmp_path):
    """The same spins, vortices and fluid by the program, to the last bit."""
    cases = [
        ("spin-lattice", SpinLattice((3, 4), 1.0, field=[0, 0, 0.2]), {"tilt": 1.0, "seed": 2}, "shape = [3, 4], exchange = 1, field = [0, 0, 0.2]"),
        ("vibrating-lattice", VibratingLattice(4, 1.0, coupling=0.5), {"waves": [1], "cone": 0.4}, "atoms = 4, exchange = 1, coupling = 0.5"),
        ("sphere-fluid", SphereFluid(6, 0.2), {"degrees": [1, 4]}, "size = 6, rotation = 0.2"),
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


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        (lambda: SpinLattice((0, 4)), "shape must be one to three whole numbers"),
        (lambda: SpinLattice((2, 2), [1, 2, 3]), "one for each of 2 axes, got 3"),
        (lambda: SpinLattice((2, 2), axis=[0, 0, 0], anisotropy=1.0), "axis must not be zero"),
        (lambda: VibratingLattice(2, 1.0), "atoms must be a whole number from 3 on, got 2"),
        (lambda: SphereFluid(1), "size must be a whole number from 2 on, got 1"),
        (lambda: SphereFluid(1e9), "from 2 to 2048"),
        (lambda: ManyVortices([1.0, 0.0]), "strength"),
        (lambda: heavytop.ArraySystem("spins", {}), "there is no system of arrays spins; there are sphere-fluid"),
        (lambda: SpinLattice(4, 1.0).solve(np.ones((5, 3)), step=0.1, end=1), r"y0 must have the shape \(12,\) or that of"),
        (lambda: SpinLattice(4, 1.0).solve(np.zeros((4, 3)), step=0.1, end=1), "number 1 is 0"),
        (lambda: SpinLattice(4, 1.0).solve({"S": np.ones((4, 3)), "tip": 1}, step=0.1, end=1), "tip is wrong, missing"),
        (lambda: SpinLattice(4, 1.0).solve({"tilt": 1}, step=0.1, end=1, events=["S"]), "has no events"),
        (lambda: SpinLattice(4, 1.0).section({"tilt": 1}, "S", step=0.1, end=1), "has no sections"),
        (lambda: SpinLattice(4, 1.0).solve({"tilt": 1}, step=0.1, end=1, scheme="spherical-midpoint"), "no collective spherical-midpoint"),
        (lambda: SphereFluid(4).solve({}, step=0.1, end=1), "coefficients must be rows of four numbers"),
        (lambda: SpinLattice(4, 1.0).solve({"tilt": 1}, step=0.1, end=1)["q"], "the arrays are S, got 'q'"),
    ],
)
def test_what_does_not_fit_is_refused(wrong, said):
    with pytest.raises((ValueError, KeyError), match=said):
        wrong()
