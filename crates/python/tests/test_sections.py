"""Starts of sections, and other invariants."""

import numpy as np
import pytest

from heavytop import Top, solve_many


def test_starts_have_the_energy_and_the_vertical_momentum():
    top = Top(inertia=[1.0, 1.4, 2.1], mass=0.7, gravity=9.81, length=0.2, center_of_mass=[2 / 7, -3 / 7, 6 / 7])
    for coordinate, row, value in [("Gamma3", 5, 0.2), ("Pi1", 0, -0.3)]:
        y = top.section_starts(h=3.0, f2=0.4, coordinate=coordinate, value=value, count=50, seed=3)
        values = top.invariant_values(y)
        assert y.shape == (6, 50) and np.abs(y[row] - value).max() < 1e-13
        for symbol, expected in [("h", 3.0), ("f1", 1.0), ("f2", 0.4)]:
            assert np.abs(values[symbol] - expected).max() < 1e-13
        assert np.array_equal(y[:, :7], top.section_starts(h=3, f2=0.4, coordinate=coordinate, value=value, count=7, seed=3))
        assert not np.array_equal(y, top.section_starts(h=3, f2=0.4, coordinate=coordinate, value=value, count=50))
        # each passes the surface upwards: so its run lies beyond it at once
        after = solve_many(top, y, step=1e-4, end=1e-4).y[row]
        assert (after > value).all()
        # the control is the other direction
        down = top.section_starts(h=3, f2=0.4, coordinate=coordinate, value=value, direction=-1, count=50)
        assert (solve_many(top, down, step=1e-4, end=1e-4).y[row] < value).all()


@pytest.mark.parametrize("coordinate, j, k", [
    ("atan2(Gamma3, Gamma2)", 4, 5),
    ("atan2(Gamma1, Gamma3)", 5, 3),
    ("atan2(Gamma2, Gamma1)", 3, 4),
])
def test_a_surface_may_be_an_angle(coordinate, j, k):
    top = Top(inertia=[1.0, 1.4, 2.1], mass=0.7, gravity=9.81, length=0.2, center_of_mass=[2 / 7, -3 / 7, 6 / 7])
    for value in [0.5, np.pi, -3.1, 7.0]:
        y = top.section_starts(h=3.0, f2=0.4, coordinate=coordinate, value=value, count=20, seed=3)
        assert np.abs(np.sin((np.arctan2(y[k], y[j]) - value) / 2)).max() < 1e-13
        assert np.abs(top.invariant_values(y)["h"] - 3).max() < 1e-13
        rate = lambda y: y[k] * np.cos(value) - y[j] * np.sin(value)
        assert (rate(solve_many(top, y, step=1e-4, end=1e-4).y) > 0).all()
        # The returns are on the surface, too, and the jump of the angle is none.
        found = top.section(y[:3, 0], y[3:, 0], coordinate=coordinate, value=value, step=0.02, end=60)
        assert found.y.shape[1] > 1
        assert np.abs(np.sin((np.arctan2(found.y[k], found.y[j]) - value) / 2)).max() < 1e-12


def test_a_section_without_states_names_the_least_energy():
    with pytest.raises(ValueError, match="the least is -"):
        Top.kovalevskaya().section_starts(h=-5, f2=0.0, coordinate="Gamma3")
    with pytest.raises(ValueError, match="coordinate must be one of Pi1"):
        Top.kovalevskaya().section_starts(h=2, f2=0.0, coordinate="Gamma4")


@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize(("symbol", "ratio", "height"), [("f3", 1.5, 1.0), ("K", 2.0, 0.0), ("G", 4.0, 0.0)])
def test_the_symmetry_axis_may_be_any(axis, symbol, ratio, height):
    inertia = np.roll([ratio, ratio, 1.0], axis + 1)
    center = np.roll([np.sqrt(1 - height**2), 0.0, height], axis + 1)
    # m g l = 1, of a body that is small enough for its moments.
    top = Top(inertia, mass=1.0, gravity=10.0, length=0.1, center_of_mass=center)
    # G depends on the start.
    assert top.invariants == ("h", "f1", "f2", *([] if symbol == "G" else [symbol]))
    start = [np.roll(v, axis + 1) for v in ([2.0, 3.0, -1.5], [0.6, 0.0, 0.8])]
    run = top.solve(*start, step=0.05, end=20, scheme="gauss-12")
    assert list(run.invariants) == ["h", "f1", "f2", symbol] and run.deviation(symbol) < 1e-10
    # Control: with another moment there is no such invariant.
    inertia[(axis + 1) % 3] *= 1.01
    other = Top(inertia, mass=1.0, gravity=10.0, length=0.1, center_of_mass=center)
    assert list(other.solve(*start, step=0.05, end=0.05).invariants) == ["h", "f1", "f2"]


def test_a_free_body_conserves_the_size_of_its_momentum():
    free = Top.free_rigid_body([1.0, 1.4, 2.1])
    assert free.invariants == ("h", "f1", "f2", "C")
    run = free.solve([1.0, 2.0, 3.0], [0.6, 0.0, 0.8], step=0.05, end=50)
    assert run.invariants["C"][0] == 14.0 and run.deviation("C") < 1e-11
    assert Top.free_rigid_body([1.5, 1.5, 2.1]).invariants == ("h", "f1", "f2", "C", "f3")


def test_ends_have_the_invariants_that_all_have():
    y = np.tile([[2.0], [3.0], [4.0], [0.6], [0.0], [0.8]], 5)
    ends = solve_many(Top.kovalevskaya(), y, step=0.1, end=10)
    assert list(ends.invariants) == ["h", "f1", "f2", "K"] and ends.invariants["K"].shape == (5,)
    assert ends.deviation("f2").max() < 1e-13 < ends.deviation("h").max() < 1e-9
    mixed = solve_many([Top.kovalevskaya(), Top.lagrange(2.0, 1.0)], y[:, :2], step=0.1, end=10)
    assert list(mixed.invariants) == ["h", "f1", "f2"] and mixed.deviation("f2").max() < 1e-13
    assert mixed.invariants["h"][1] == Top.lagrange(2.0, 1.0).invariant_values(mixed.y[:, 1])["h"]
    with pytest.raises(ValueError, match="the invariants are h, f1, f2"):
        mixed.deviation("K")


def rotated(q, v):
    across = np.cross(q[1:], v)
    return v + 2 * q[0] * across + 2 * np.cross(q[1:], across)


def test_the_attitude_begins_where_it_is_asked_to():
    top, start = Top.kovalevskaya(), dict(Pi=[2.0, 3.0, 4.0], Gamma=[0.6, 0.0, 0.8])
    shortest = top.solve(**start, step=0.1, end=5, attitude=True).attitude
    # turned about the vertical by 1.2 rad: (cos, 0, 0, sin) times the shortest
    c, s = np.cos(0.6), np.sin(0.6)

    def turned(q):
        w, x, y, z = q
        return np.array([c * w - s * z, c * x - s * y, c * y + s * x, c * z + s * w])

    run = top.solve(**start, step=0.1, end=5, attitude0=turned(shortest[:, 0]))
    # The rotation about the vertical is a symmetry: it stays in front of every attitude, with 50 steps of rounding.
    assert np.abs(run.attitude - turned(shortest)).max() < 1e-13
    assert np.abs(run.attitude - shortest).max() > 0.1
    assert np.abs(rotated(run.attitude[:, -1], run.Gamma[:, -1]) - [0, 0, 1]).max() < 1e-13
    for wrong, words in [
        ([1, 0, 0, 0], r"rotates it to \(0.6, 0, 0.8\)"),
        ([2, 0, 0, 0], "unit quaternion"),
        ([1, 0, 0], "four finite numbers"),
    ]:
        with pytest.raises(ValueError, match=words):
            top.solve(**start, step=0.1, end=1, attitude0=wrong)
    with pytest.raises(ValueError, match="no attitude"):
        top.solve(**start, step=0.1, end=1, formulation="direct", attitude0=shortest[:, 0])
