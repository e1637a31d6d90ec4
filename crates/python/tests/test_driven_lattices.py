"""Lattices of spins in a field that depends on the time."""

import pickle

import numpy as np
import pytest

from heavytop import SpinLattice, System, solve_many
from heavytop.array_systems import ArraySystem

UP = {"direction": [0, 0, 1]}
TURNING = ["0.3*cos(2*t)", "-0.3*sin(2*t)", 0]
PULSE = {"u": ([0, 0.97, 1.03, 2], [0, np.pi / 2, 0, 0], "linear")}


@pytest.mark.parametrize(
    "field",
    [TURNING, lambda t: [0.3 * np.cos(2 * t), -0.3 * np.sin(2 * t), 0], lambda x, t: 0.3 * np.array([np.cos(2 * t), -np.sin(2 * t), 0])],
)
def test_a_small_field_that_turns_with_the_spins_turns_them_over(field):
    lattice = SpinLattice(4, exchange=1.0, field=[0, 0, 2.0], drive={"field": field})
    run = lattice.solve(UP, step=0.01, end=10)
    # Rabi's resonance; the method has the order 2.
    assert np.abs(run["S"][:, 0, 2] - np.cos(0.3 * run.t)).max() < 1e-3
    assert lattice.formulations == ("direct",) and run.kept == ("C",) and run.deviation("C") < 1e-12
    assert run.check().order == pytest.approx(2, abs=0.1)
    # h has the field of its time.
    assert np.allclose(lattice.invariant_values(run.y, run.t)["h"], run.invariants["h"], atol=1e-13)
    assert lattice.invariant_values(run.y[:, 0], 0.5)["h"] == pytest.approx(-4 - 8, abs=1e-14)
    s, t = np.array([0.6, 0.0, 0.8]), 0.4
    expected = np.cross(s, [0.3 * np.cos(2 * t), -0.3 * np.sin(2 * t), 2.0])
    assert np.allclose(lattice.rate(np.tile(s, 4), t).reshape(4, 3), expected, atol=1e-15)
    assert np.array_equal(pickle.loads(pickle.dumps(lattice)).solve(UP, step=0.01, end=1).y, lattice.solve(UP, step=0.01, end=1).y)


def test_one_spin_is_the_driven_spin_of_a_formula():
    """The field turns once in 0.63, and the step is a tenth of it."""
    field, start = ["1.5*cos(10*t)", "u*sin(10*t)", "0.5"], [0.6, 0.0, 1.6]
    inputs = {"u": ([0, 0.37, 1.3, 2], [1, -2, 0.5, 0], "constant")}
    spin = System("so(3)", f"-({field[0]})*Pi1 - {field[1]}*Pi2 - {field[2]}*Pi3", bracket="plus", inputs=inputs)
    exact = spin.solve(start, step=0.02, end=2, scheme="gauss-12").y[:, -1]
    one = SpinLattice(1, field=[0, 0, 0], drive={"field": field}, inputs=inputs)
    errors = [np.abs(one.solve([start], step=step, end=2).y[:, -1] - exact).max() for step in (0.05, 0.025, 0.0125)]
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.15) and errors[1] / errors[2] == pytest.approx(4, rel=0.1)
    assert errors[2] < 1e-2


def test_a_table_turns_spins_by_its_area():
    lattice = SpinLattice((2, 2), 1.0, drive={"field": lambda x, t: [2 * x.u, 0, 0]}, inputs=PULSE)
    run = lattice.solve(UP, step=0.05, end=2)
    angle = 2 * 0.515 * np.pi / 2
    assert np.allclose(run["S"][-1, 0, 0], [0, np.sin(angle), np.cos(angle)], atol=2e-3)
    ends = solve_many(lattice, [UP] * 3, step=0.05, end=2)
    assert np.array_equal(ends.y[:, 1], run.y[:, -1])
    assert np.array_equal(lattice.solve(UP, np.linspace(0, 2, 41)).y, run.y)
    # With noise, each member has a path of its own.
    warm = SpinLattice(4, 1.0, drive={"field": ["u", 0, 0]}, inputs=PULSE, damping={"friction": 0.5, "form": "gilbert"}, noise={"temperature": 0.3})
    ends = solve_many(warm, [UP] * 3, step=0.05, end=2)
    assert ends.deviation("C").max() < 1e-12 and not np.array_equal(ends.y[:, 0], ends.y[:, 1])
    assert np.array_equal(warm.solve(UP, step=0.05, end=2, path=1).y[:, -1], ends.y[:, 1])


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"drive": {}}, "drive of a lattice has no field"),
        ({"inputs": PULSE}, "drive of a lattice has no field"),
        ({"drive": {"field": [0, 0, "t"]}, "inputs": PULSE}, "no formula names the input u"),
        ({"drive": 3}, "drive must be a mapping"),
        ({"drive": {"S": [0, 0, 1]}}, "drive of a lattice has no 'S'; there are field"),
        ({"drive": {"field": [0, 1]}}, r"drive\['field'\] must have 3 formulas"),
        ({"drive": {"field": "t"}}, r"drive\['field'\] must have 3 formulas"),
        ({"drive": {"field": lambda t: [t, 0]}}, "must return 3 numbers"),
        ({"drive": {"field": ["S1", 0, 0]}}, "there is no `S1`"),
        ({"drive": {"field": [np.nan, 0, 0]}}, "must be finite, got nan"),
        ({"drive": {"field": ["u", 0, 0]}, "inputs": {"u": ([0, 1, 1], [1, 2, 3], "linear")}}, "must increase"),
        ({"drive": {"field": ["u", 0, 0]}, "inputs": {"u": ([0, 1], [1, np.nan], "linear")}}, "value 2 of the table is NaN"),
        ({"drive": {"field": ["t", 0, 0]}, "inputs": {"t": ([0, 1], [1, 2], "linear")}}, "is that of the time"),
    ],
)
def test_what_is_no_drive_is_refused(wrong, message):
    with pytest.raises(ValueError, match=message):
        SpinLattice(4, 1.0, **wrong)


def test_tables_cover_the_run_and_other_arrays_have_no_drive():
    lattice = SpinLattice(4, 1.0, drive={"field": ["u", 0, 0]}, inputs=PULSE)
    for run in (
        lambda: lattice.solve(UP, step=0.05, end=3),
        lambda: solve_many(lattice, [UP] * 2, step=0.05, end=3),
        lambda: lattice.solve(UP, np.linspace(0, 3, 61)),
    ):
        with pytest.raises(ValueError, match="the input u: .*from 0 to 2, and the run from 0 to 3"):
            run()
    for more in ({"drive": {"field": [0, 0, 1]}}, {"inputs": PULSE}):
        with pytest.raises(ValueError, match="sphere-fluid has no .*: of the systems of arrays spin-lattice has drive"):
            ArraySystem("sphere-fluid", {"size": 4}, **more)
