"""The runs against SciPy, and many tops against one."""

import numpy as np
import pytest

from heavytop import Top, solve_many

SCHEMES = ["implicit-midpoint", "gauss-4", "gauss-8", "gauss-16"]


def field(top):
    inertia, torque = top.inertia, top.weight_moment * top.center_of_mass

    def rate(_, y):
        omega = y[:3] / inertia
        return np.concatenate([np.cross(y[:3], omega) + np.cross(y[3:], torque), np.cross(y[3:], omega)])

    return rate


def test_the_solution_is_that_of_scipy():
    integrate = pytest.importorskip("scipy.integrate")
    top = Top(inertia=[1.0, 1.4, 2.1], mass=0.7, gravity=9.81, length=0.2, center_of_mass=[2 / 7, -3 / 7, 6 / 7])
    start = [1.2, -0.7, 2.3, 2 / 7, 6 / 7, -3 / 7]
    run = top.solve(start[:3], start[3:], step=0.05, end=20, scheme="gauss-16")
    peer = integrate.solve_ivp(field(top), (0, 20), start, method="DOP853", rtol=1e-12, atol=1e-12, t_eval=run.t)
    # DOP853 at this tolerance is off by 1e-10 at the end.
    assert np.abs(run.y - peer.y).max() < 1e-8


def states(count):
    angle = np.linspace(0, 1, count)
    return np.array([2 + angle, 3 - angle, 4 * np.cos(angle), 0.6 + 0 * angle, 0 * angle, 0.8 + 0 * angle])


@pytest.mark.parametrize("scheme", SCHEMES)
def test_each_of_many_states_ends_where_it_ends_alone(scheme):
    top, y = Top.kovalevskaya(), states(37)
    together = solve_many(top, y, step=0.1, end=5, scheme=scheme)
    assert together.success
    for i in (0, 17, 36):
        alone = top.solve(y[:3, i], y[3:, i], step=0.1, end=5, scheme=scheme)
        # 50 steps, each with a few rounding errors of size 1e-15, which grow with t.
        assert np.abs(alone.y[:, -1] - together.y[:, i]).max() < 1e-11
        # the member by itself has the same bits as among others
        single = solve_many(top, y[:, i : i + 1], step=0.1, end=5, scheme=scheme)
        assert np.array_equal(single.y[:, 0], together.y[:, i])


@pytest.mark.parametrize("scheme", SCHEMES)
def test_each_of_many_tops_has_its_own_parameters(scheme):
    tops = [Top.lagrange(2.0, 1.0 + 0.01 * i) for i in range(20)]
    ends = solve_many(tops, states(20), step=0.1, end=5, scheme=scheme)
    energies = [top.invariant_values(y)["f2"] for top, y in zip(tops, ends.y.T)]
    starts = [top.invariant_values(y)["f2"] for top, y in zip(tops, states(20).T)]
    assert np.abs(np.subtract(energies, starts)).max() < 1e-12
    assert np.abs(ends.y[:, 0] - ends.y[:, -1]).max() > 1e-2


def test_a_member_that_fails_is_reported_and_harms_no_other():
    y = states(9)
    y[0, 4] = np.nan
    ends = solve_many(Top.kovalevskaya(), y, step=0.1, end=5)
    assert list(ends.failures) == [4] and not ends.success
    good = np.delete(np.arange(9), 4)
    assert np.array_equal(ends.y[:, good], solve_many(Top.kovalevskaya(), y[:, good], step=0.1, end=5).y)


@pytest.mark.parametrize(
    ("tops", "shape", "words"),
    [
        (Top.kovalevskaya(), (6,), "shape"),
        (Top.kovalevskaya(), (5, 3), "shape"),
        ([Top.kovalevskaya()] * 2, (6, 3), "2 tops and 3 states"),
    ],
)
def test_wrong_shapes_are_value_errors(tops, shape, words):
    with pytest.raises(ValueError, match=words):
        solve_many(tops, np.ones(shape), step=0.1, end=1)
    with pytest.raises(ValueError, match="scheme must be one of"):
        solve_many(Top.kovalevskaya(), np.ones((6, 3)), step=0.1, end=1, scheme="rk4")
