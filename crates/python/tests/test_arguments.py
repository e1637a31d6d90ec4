"""Arguments that NumPy would convert to numbers, although they are none, and what a result is measured from."""

from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

import heavytop
from heavytop import System, Top

START = dict(Pi=[2.0, 3.0, 4.0], Gamma=[0.6, 0.0, 0.8])
TOP = Top.kovalevskaya()
BODY = System("so(3)", "(Pi1^2 + Pi2^2/2 + Pi3^2/4)/2")

NO_NUMBERS = [True, "1.5", b"1", None, 1j, np.True_, np.str_("2"), np.array(["1.5"]), np.array([True]), np.ma.masked]


@pytest.mark.parametrize("value", NO_NUMBERS)
def test_what_is_no_number_is_refused(value):
    calls = [
        lambda: System("so(3)", "a*Pi1^2", parameters={"a": value}),
        lambda: System("so(3)", "a*Pi1^2", parameters={"a": [1.0, value]}),
        lambda: TOP.solve([1.0, 2.0, value], [0, 0, 1], step=0.1, end=1),
        lambda: TOP.solve(**START, step=value, end=1),
        lambda: Top.lagrange(2.0, value),
        lambda: Top([1, 1, 1], value, 1, 1),
        lambda: BODY.solve({"Pi": [1.0, value, 2.0]}, step=0.1, end=1),
        lambda: TOP.invariant_values([1, 2, 3, 4, 5, value]),
    ]
    for call in calls:
        with pytest.raises(ValueError, match="must be a|must have no masked entries"):
            call()


def test_numbers_of_any_kind_are_taken():
    values = [2, 2.0, np.float32(2), np.int8(2), Fraction(2), Decimal("2"), np.array(2), np.ma.array(2.0)]
    for value in values:
        system = System("so(3)", "a*Pi1", parameters={"a": value})
        assert system.invariant_values([3.0, 0, 0])["h"] == 6.0
        assert BODY.invariant_values([value, Fraction(0), 0])["c1"] == 4.0
    assert BODY.invariant_values(np.ma.array([1.0, 0.0, 2.0]))["c1"] == 5.0
    # Control: masked arrays without a masked entry, in lists.
    assert BODY.invariant_values([np.ma.array(1.0), 0.0, np.ma.array(2.0, mask=False)])["c1"] == 5.0
    assert BODY.invariant_values(np.array([1, Decimal(0), 2.0], dtype=object))["c1"] == 5.0


def test_a_mask_is_not_lost():
    """A masked entry has a value below its mask, which NumPy would use."""
    mask = lambda values: np.ma.array(values, mask=np.arange(np.size(values)).reshape(np.shape(values)) == 1)
    many = np.tile(np.array(START["Pi"] + START["Gamma"])[:, None], 3)
    masked = np.ma.array(2.0, mask=True)
    calls = [
        # Also within lists, from which NumPy makes an array without a mask.
        lambda: TOP.solve([1.0, masked, 3.0], START["Gamma"], step=0.1, end=1),
        lambda: TOP.solve((1.0, np.ma.masked, 3.0), START["Gamma"], step=0.1, end=1),
        lambda: Top([mask([1.0, 0.0, 0.0]), [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], 1.0, 1.0, 1.0),
        lambda: heavytop.solve_many(TOP, list(mask(many)), step=0.1, end=1),
        lambda: heavytop.lyapunov(BODY, [mask(many[0]), *many[1:3]], step=0.1, end=1),
        lambda: BODY.solve({"Pi": [1.0, 2.0, masked]}, step=0.1, end=1),
        lambda: BODY.rate(np.array([1.0, masked, 2.0], dtype=object)),
        lambda: System("so(3)", "I1*Pi1", parameters={"I": [1.0, masked]}),
        lambda: TOP.solve(mask(START["Pi"]), START["Gamma"], step=0.1, end=1),
        lambda: TOP.solve(**START, step=0.1, end=1).sol(mask([0.1, 0.2])),
        lambda: TOP.solve(**START, step=0.1, end=1, attitude0=mask([1.0, 0, 0, 0])),
        lambda: heavytop.solve_many(TOP, mask(many), step=0.1, end=1),
        lambda: heavytop.solve_many(BODY, mask(many[:3]), step=0.1, end=1),
        lambda: heavytop.lyapunov(TOP, mask(many), step=0.1, end=1),
        lambda: BODY.solve(mask([1.0, 2.0, 3.0]), step=0.1, end=1),
        lambda: BODY.solve([1.0, 2.0, 3.0], mask([0.0, 0.1, 0.2])),
        lambda: BODY.rate(mask([1.0, 2.0, 3.0])),
        lambda: System("so(3)", "I1*Pi1", parameters={"I": mask([1.0, 2.0, 3.0])}),
        lambda: System(structure_constants=mask(np.zeros((2, 2, 2))), hamiltonian="mu1"),
    ]
    for call in calls:
        with pytest.raises(ValueError, match="must have no masked entries: fill them or leave them out"):
            call()


def test_deviations_count_from_the_start():
    """Also where the first sample is a later one."""
    rough = dict(scheme="rk4", formulation="direct")
    whole = BODY.solve([1, 2, 0.5], np.linspace(0, 20, 51), step=0.4, **rough)
    late = BODY.solve([1, 2, 0.5], [19.6, 20.0], step=0.4, **rough)
    exact = whole.invariants["c1"][[-2, -1]] - 5.25
    assert late.deviation("c1") == pytest.approx(np.abs(exact).max(), rel=1e-9) and late.deviation("c1") > 1e-5
    assert late.deviation("c1", relative=True) == pytest.approx(late.deviation("c1") / 5.25)
    # Control: from the first sample it would be much smaller.
    assert np.abs(np.diff(late.invariants["c1"])).max() < 0.5 * late.deviation("c1")
    # Where the start is the first sample, nothing changes.
    run = TOP.solve(**START, step=0.1, end=10)
    for name, values in run.invariants.items():
        assert run.deviation(name) == np.abs(values - values[0]).max()


def test_many_systems_have_the_bits_of_one_and_tops_differ_by_rounding():
    turns = np.array([[1.0, 2.0, 0.5], [0.3, -1.0, 2.0]]).T
    ends = heavytop.solve_many(BODY, turns, step=0.1, end=10)
    for i, start in enumerate(turns.T):
        assert np.array_equal(ends.y[:, i], BODY.solve(start, step=0.1, end=10).y[:, -1])
    y = np.array(START["Pi"] + START["Gamma"])[:, None]
    for scheme in ("implicit-midpoint", "gauss-8"):
        ends = heavytop.solve_many(TOP, y, step=0.1, end=10, scheme=scheme).y[:, 0]
        alone = TOP.solve(**START, step=0.1, end=10, scheme=scheme).y[:, -1]
        # Rounding errors of 100 steps, which the motion magnifies. A method of another order differs by far more.
        assert np.abs(ends - alone).max() < 1e-11
    other = TOP.solve(**START, step=0.1, end=10, scheme="gauss-6").y[:, -1]
    assert np.abs(ends - other).max() > 1e-9
