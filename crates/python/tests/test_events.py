"""Events along runs of tops."""

import pickle

import numpy as np
import pytest

from heavytop import Event, Top

START = dict(Pi=[2.0, 3.0, 4.0], Gamma=[0.6, 0.0, 0.8])
TOP = Top.kovalevskaya()


def field(_, y):
    omega = y[:3] / TOP.inertia
    torque = TOP.weight_moment * TOP.center_of_mass
    return np.concatenate([np.cross(y[:3], omega) + np.cross(y[3:], torque), np.cross(y[3:], omega)])


def test_events_are_those_of_scipy():
    integrate = pytest.importorskip("scipy.integrate")

    def height(_, y):
        return y[5] - 0.25

    def rate(_, y):
        return y[0] * y[3] - 0.5 * y[1] ** 2 + np.cos(y[2])

    rate.direction = 1
    run = TOP.solve(
        **START,
        step=0.05,
        end=20,
        scheme="gauss-16",
        events=["Gamma3 - 0.25", Event(lambda x: x.Pi1 * x.Gamma1 - 0.5 * x.Pi2**2 + np.cos(x.Pi3), direction=1)],
    )
    start = START["Pi"] + START["Gamma"]
    peer = integrate.solve_ivp(field, (0, 20), start, "DOP853", rtol=1e-12, atol=1e-12, events=[height, rate])
    for ours, theirs, states, peers in zip(run.t_events, peer.t_events, run.y_events, peer.y_events):
        assert ours.shape == theirs.shape and ours.size > 8 and states.shape == peers.shape
        # DOP853 at this tolerance is off by 1e-10 at the end.
        assert np.abs(ours - theirs).max() < 1e-8 and np.abs(states - peers).max() < 1e-8
    assert (run.status, run.success, run.t[-1]) == (0, True, 20.0)
    # Control: the other direction has other zeros, and both directions have all.
    down = TOP.solve(**START, step=0.05, end=20, events=[Event("Gamma3 - 0.25", direction=-1)]).t_events[0]
    up = TOP.solve(**START, step=0.05, end=20, events=[Event("Gamma3 - 0.25", direction=1)]).t_events[0]
    assert np.allclose(np.sort(np.concatenate([down, up])), run.t_events[0], atol=1e-9) and down.size and up.size


@pytest.mark.parametrize(("terminal", "number"), [(True, 1), (1, 1), (4, 4)])
@pytest.mark.parametrize("every", [1, 7])
def test_a_terminal_event_ends_the_run(terminal, number, every):
    free = TOP.solve(**START, step=0.1, end=20, events=["Gamma2", "Pi1"])
    run = TOP.solve(**START, step=0.1, end=20, every=every, events=[Event("Gamma2", terminal=terminal), "Pi1"])
    end = free.t_events[0][number - 1]
    assert run.status == 1 and run.success and "event 0" in run.message
    assert run.t[-1] == end == run.t_events[0][-1] and run.t_events[0].size == number
    assert abs(run.y[4, -1]) < 1e-14 and np.all(np.diff(run.t) > 0)
    assert np.array_equal(run.t_events[1], free.t_events[1][free.t_events[1] <= end])
    assert np.array_equal(run.t[:-1], free.t[free.t < end][::every])
    assert np.abs(run.sol(end) - run.y[:, -1]).max() < 1e-12
    assert all(values.shape == run.t.shape for values in run.invariants.values())


def test_the_attributes_of_scipy_are_read():
    def event(x):
        return x.Gamma2

    event.terminal, event.direction = True, -1.0
    run = TOP.solve(**START, step=0.1, end=20, events=event, attitude=True)
    falling = TOP.solve(**START, step=0.1, end=20, events=Event("Gamma2", direction=-1)).t_events[0]
    assert run.t[-1] == falling[0] and run.attitude.shape == (4, run.t.size)
    again = pickle.loads(pickle.dumps(run))
    assert again.status == 1 and np.array_equal(again.t_events[0], run.t_events[0])


def test_no_events_are_none():
    run = TOP.solve(**START, step=0.1, end=1)
    assert run.t_events is None and run.y_events is None
    assert TOP.solve(**START, step=0.1, end=1, events=[]).t_events == []
    none = TOP.solve(**START, step=0.1, end=1, events="Pi1 - 100")
    assert none.t_events[0].shape == (0,) and none.y_events[0].shape == (0, 6)


def test_formula_and_function_are_one_event_to_the_last_bit():
    text = "|Pi×Gamma|^2 - 3*sin(Pi1) - 9"
    both = TOP.solve(
        **START,
        step=0.1,
        end=50,
        events=[text, lambda x: sum(np.cross(x.Pi, x.Gamma) ** 2) - 3 * np.sin(x.Pi1) - 9],
    ).t_events
    # The sum of the squares may be added in another order: zeros differ by a few rounding errors of g over its slope.
    assert both[0].shape == both[1].shape and both[0].size > 20 and np.abs(both[0] - both[1]).max() < 1e-12


@pytest.mark.parametrize(
    ("events", "error", "words"),
    [
        ("Gamma4", ValueError, "there is no `Gamma4`"),
        ("Gamma2 -", ValueError, r"Gamma2 -\n"),
        ("Pi", ValueError, "vector of dimension 3"),
        (["Pi1", 3], ValueError, r"events\[1\] must be a formula or a function"),
        (lambda x: x.Pi1 if x.Pi1 > 0 else x.Pi2, TypeError, "cannot branch"),
        (lambda x: x.Pi, TypeError, r"must return a scalar .* shape \(3,\)"),
        (Event("Pi1", direction="up"), ValueError, "direction"),
        (Event("Pi1", terminal=-1), ValueError, "terminal"),
        ("sqrt(Gamma2)", ValueError, "event 0.*not a number"),
    ],
)
def test_wrong_events_say_why(events, error, words):
    with pytest.raises(error, match=words):
        TOP.solve(**START, step=0.1, end=10, events=events)


def test_a_section_by_any_function():
    plane = TOP.section(**START, coordinate="Gamma2", value=0.1, step=0.05, end=100)
    formula = TOP.section(**START, coordinate="2*Gamma2", value=0.2, step=0.05, end=100)
    function = TOP.section(**START, coordinate=lambda x: 2 * x.Gamma2, value=0.2, step=0.05, end=100)
    assert plane.t.size > 10 and np.abs(plane.y[4] - 0.1).max() < 1e-13
    assert np.abs(plane.t - formula.t).max() < 1e-12 and np.array_equal(formula.t, function.t)
    oblique = TOP.section(**START, coordinate="Pi·Gamma×(Pi + Gamma) + Gamma1", direction=0, step=0.05, end=100)
    assert oblique.t.size > 10 and np.abs(oblique.y[3]).max() < 1e-13
