"""Runs backward in time: an end before 0, or a negative step, in every function that makes steps."""

import numpy as np
import pytest

import heavytop
from heavytop import Event, System, Top

START = dict(Pi=[2.0, 3.0, 4.0], Gamma=[0.6, 0.0, 0.8])
TOP = Top.kovalevskaya()
BODY = System("so(3)", "(Pi1^2 + Pi2^2/2 + Pi3^2/4)/2")


def test_an_end_before_0_alone_asks_for_it():
    run = TOP.solve(**START, step=0.1, end=-10)
    assert run.success and np.array_equal(run.t, -0.1 * np.arange(101)) and run.y[0, 0] == 2.0
    same = TOP.solve(**START, step=-0.1, end=-10)
    assert np.array_equal(run.y, same.y) and np.array_equal(run.t, same.t)
    # Control: forward is another motion.
    assert np.abs(run.y[:, -1] - TOP.solve(**START, step=0.1, end=10).y[:, -1]).max() > 0.1
    for wrong, words in (
        (dict(step=-0.1, end=1), "end must be before 0 for a run backward in time, with a step of -0.1, got 1.0"),
        (dict(step=0.0, end=-1), "step must be different from 0, got 0.0"),
        (dict(step=0.1, end=0), "end must be different from 0, got 0.0"),
        (dict(step=0.1, end=-1.05), "nearest ends are -1 and -1.1"),
        (dict(step=0.1, end=-np.inf), "end must be finite"),
    ):
        with pytest.raises(ValueError, match=words):
            TOP.solve(**START, **wrong)


@pytest.mark.parametrize("formulation", heavytop.FORMULATIONS)
def test_a_symmetric_method_returns(formulation):
    method = dict(formulation=formulation, scheme="yoshida-4" if formulation == "splitting" else "gauss-8")
    there = TOP.solve(**START, step=0.05, end=10, **method)
    back = TOP.solve(there.Pi[:, -1], there.Gamma[:, -1], step=0.05, end=-10, **method)
    assert np.abs(back.y[:, ::-1] - there.y).max() < 1e-11
    # Control: rk4 returns by its order.
    there = TOP.solve(**START, step=0.05, end=10, scheme="rk4", formulation="direct")
    back = TOP.solve(there.Pi[:, -1], there.Gamma[:, -1], step=0.05, end=-10, scheme="rk4", formulation="direct")
    assert 1e-9 < np.abs(back.y[:, -1] - there.y[:, 0]).max() < 1e-2


def test_the_attitude_returns():
    there = TOP.solve(**START, step=0.05, end=5, attitude=True)
    end = dict(Pi=there.Pi[:, -1], Gamma=there.Gamma[:, -1], attitude0=there.attitude[:, -1])
    back = TOP.solve(**end, step=0.05, end=-5)
    assert np.abs(back.attitude[:, ::-1] - there.attitude).max() < 1e-11


def test_any_times_between_0_and_the_end():
    run = TOP.solve(**START, step=0.1, end=-5, scheme="gauss-12")
    times = np.array([-4.87, 0.0, -0.03, -5.0, -1.0])
    exact = TOP.solve(**START, step=0.01, end=-5, scheme="gauss-12")
    assert np.abs(run.sol(times) - exact.sol(times)).max() < 1e-11
    assert np.array_equal(run.sol(0.0), run.y[:, 0])
    for outside in (0.1, -5.1, np.nan):
        with pytest.raises(ValueError, match=r"t must be from 0 to -5"):
            run.sol(outside)


def test_times_that_decrease():
    times = np.linspace(0, -10, 101)
    run = BODY.solve([1, 2, 0.5], times)
    assert np.array_equal(run.t, times) and run.deviation("c1") < 1e-13
    assert np.array_equal(run.y[:, -1], BODY.solve([1, 2, 0.5], step=0.1, end=-10).y[:, -1])
    some = BODY.solve([1, 2, 0.5], [-0.5, -0.5, -3.21], step=0.1)
    assert np.abs(some.y - run.sol([-0.5, -0.5, -3.21])).max() < 1e-14
    for wrong in ([0, -1, -0.5], [1, 0, -1], [-1, 0, 1]):
        with pytest.raises(ValueError, match="from 0 on that do not decrease, or that do not increase"):
            BODY.solve([1, 2, 0.5], wrong, step=0.1)
    with pytest.raises(ValueError, match="end must be before 0"):
        BODY.solve([1, 2, 0.5], [0, 1], step=-0.1)


def field(_, y):
    omega = y[:3] / TOP.inertia
    torque = TOP.weight_moment * TOP.center_of_mass
    return np.concatenate([np.cross(y[:3], omega) + np.cross(y[3:], torque), np.cross(y[3:], omega)])


@pytest.mark.parametrize("direction", [-1, 0, 1])
def test_events_are_those_of_scipy(direction):
    integrate = pytest.importorskip("scipy.integrate")

    def height(_, y):
        return y[5] - 0.25

    height.direction = direction
    run = TOP.solve(**START, step=0.05, end=-10, scheme="gauss-12", events=Event("Gamma3 - 0.25", direction=direction))
    start = START["Pi"] + START["Gamma"]
    peer = integrate.solve_ivp(field, (0, -10), start, "DOP853", rtol=1e-12, atol=1e-12, events=height)
    assert run.t_events[0].size == peer.t_events[0].size > 2
    # DOP853 at this tolerance is off by 1e-10 at the end.
    assert np.abs(run.t_events[0] - peer.t_events[0]).max() < 1e-8 and np.abs(run.y[:, -1] - peer.y[:, -1]).max() < 1e-8


def test_a_terminal_event_ends_the_run_and_what_lies_beyond_it_is_left_out():
    free = TOP.solve(**START, step=0.1, end=-20, events=["Gamma2", "Pi1"])
    run = TOP.solve(**START, step=0.1, end=-20, events=[Event("Gamma2", terminal=3), "Pi1"])
    end = free.t_events[0][2]
    assert run.status == 1 and run.t[-1] == end and np.all(np.diff(run.t) < 0)
    assert np.array_equal(run.t_events[1], free.t_events[1][free.t_events[1] >= end])
    assert run.t.size == (free.t > end).sum() + 1


def test_a_section_is_the_same_set_of_states():
    start = TOP.section_starts(h=2, f2=0.3, coordinate="Gamma3")[:, 0]
    there = TOP.section(start[:3], start[3:], coordinate="Gamma3", step=0.05, end=50)
    assert there.t.size > 5
    last = there.y[:, -1]
    back = TOP.section(last[:3], last[3:], coordinate="Gamma3", step=0.05, end=-50)
    # The antecedents of the last point are the others, which cross the surface in the same direction of time. The last
    # point itself lies on the surface to rounding, and may count.
    first = int(np.abs(back.y[:, 0] - last).max() < 1e-9)
    count = there.t.size - 1
    assert np.abs(back.y[:, first : first + count] - there.y[:, -2::-1]).max() < 1e-7
    assert (back.t <= 0).all() and (np.diff(back.t) < 0).all()
    points = BODY.section([1, 2, 0.5], "Pi3", step=0.05, end=-20)
    assert points.t.size > 1 and np.abs(points.y[2]).max() < 1e-13
    # Pi3 grows in time at each of them.
    assert (BODY.rate(points.y)[2] > 0).all()


def test_many_at_once():
    y = np.tile(np.array(START["Pi"] + START["Gamma"])[:, None], 20) * np.linspace(0.9, 1.1, 20)
    for call in (lambda y, end: heavytop.solve_many(TOP, y, step=0.05, end=end), lambda y, end: heavytop.solve_many([TOP] * 20, y, step=0.05, end=end)):
        there = call(y, 4)
        assert there.success and np.abs(there.y - y).max() > 0.1
        assert np.abs(call(there.y, -4).y - y).max() < 1e-12
    turns = y[:3]
    there = heavytop.solve_many(BODY, turns, step=0.05, end=4)
    assert np.abs(heavytop.solve_many(BODY, there.y, step=0.05, end=-4).y - turns).max() < 1e-12


def test_chaos_grows_along_the_run():
    top = Top([1.0, 1.7, 2.2], mass=1.0, gravity=9.81, length=0.5, center_of_mass=[0.6, 0.0, 0.8])
    start = [1, 2, 1, 0, 0.6, 0.8]
    found = heavytop.lyapunov(top, start, step=0.05, end=-200, exponents=6, every=1000)
    assert np.array_equal(found.t, [-50.0, -100.0, -150.0, -200.0]) and "t = -200" in repr(found)
    # The exponents of a Hamiltonian motion come in pairs, so that it is as chaotic backward.
    assert (found.exponents[0] > 0.1).all() and (found.megno > 5).all()
    assert np.abs(found.exponents.sum(axis=0)).max() < 1e-11


def test_a_long_step_is_warned_of_whatever_its_sign():
    for end in (10, -10):
        with pytest.warns(RuntimeWarning, match="turns by about .* rad in a step"):
            TOP.solve([0, 0, 4], [0.6, 0, 0.8], step=1, end=end)
