"""Events along runs of tops."""

import pickle

import numpy as np
import pytest

from heavytop import Event, IntegrationError, SpinLattice, System, Top

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
        ("ln(Gamma2 - 1)", ValueError, "event 0.*not a number at t = 0"),
    ],
)
def test_wrong_events_say_why(events, error, words):
    with pytest.raises(error, match=words):
        TOP.solve(**START, step=0.1, end=10, events=events)


def test_an_event_without_a_value_keeps_the_samples_before():
    whole = TOP.solve(**START, step=0.1, end=10, events="Gamma2")
    run = TOP.solve(**START, step=0.1, end=10, events=["Gamma2 + 0*sqrt(0.7 - Gamma1)", "Gamma2"])
    assert run.status == -1 and not run.success and isinstance(run.error, IntegrationError)
    assert run.message.startswith("event 0: the event function is not a number at t = ")
    kept = run.t.size
    assert 1 < kept < 101 and np.array_equal(run.y, whole.y[:, :kept]) and whole.y[3, kept] > 0.7
    assert (run.y[3] <= 0.7).all()
    with pytest.raises(IntegrationError, match="event 0: the event function is not a number at t = "):
        TOP.section(**START, coordinate="Gamma2 + 0*sqrt(0.7 - Gamma1)", step=0.1, end=10)


def test_a_section_by_any_function():
    plane = TOP.section(**START, coordinate="Gamma2", value=0.1, step=0.05, end=100)
    formula = TOP.section(**START, coordinate="2*Gamma2", value=0.2, step=0.05, end=100)
    function = TOP.section(**START, coordinate=lambda x: 2 * x.Gamma2, value=0.2, step=0.05, end=100)
    assert plane.t.size > 10 and np.abs(plane.y[4] - 0.1).max() < 1e-13
    assert np.abs(plane.t - formula.t).max() < 1e-12 and np.array_equal(formula.t, function.t)
    oblique = TOP.section(**START, coordinate="Pi·Gamma×(Pi + Gamma) + Gamma1", direction=0, step=0.05, end=100)
    assert oblique.t.size > 10 and np.abs(oblique.y[3]).max() < 1e-13


LINE = System(coordinates=["X", "Y", "Z"], brackets={("X", "Y"): "Z"}, hamiltonian="X")
"""dY/dt = Z = 1: Y is the time."""


@pytest.mark.parametrize("unit", [1.0, 1e-30, 1e30])
@pytest.mark.parametrize(
    ("function", "zeros"),
    [
        # Two zeros in the first step, beside a zero at a sample, at two samples, at the start, in the last step.
        ("(Y - 0.03)*(Y - 0.05)", [0.03, 0.05]),
        ("(Y - 0.5)*(Y - 0.55)", [0.5, 0.55]),
        ("(Y - 0.375)*(Y - 0.5)", [0.375, 0.5]),
        ("Y*(Y - 0.05)", [0.05]),
        ("Y*(Y - 0.03)*(Y - 0.05)", [0.03, 0.05]),
        ("(Y - 1.9)*(Y - 1.95)", [1.9, 1.95]),
        # Touches.
        ("(Y - 0.5)^2", []),
        ("(Y - 0.53)^2", []),
        ("Y^2", []),
        ("|Y - 0.5|", []),
        ("(Y - 0.5)^2*(Y - 0.55)", [0.55]),
        # Poles and jumps.
        ("1/(Y - 0.53)", []),
        ("1/(Y - 0.53)^2", []),
        ("(Y - 1)/(Y - 0.53)^3", [1.0]),
        ("tan(3*Y)", [np.pi / 3]),
        ("|Y - 0.7|/(Y - 0.7)", []),
        ("|Y - 0.7|/(Y - 0.7) + 0.9", []),
        # Angles, and a formula of an angle that is none.
        ("atan2(sin(9*Y), cos(9*Y)) - 3", [3 / 9, (3 + 2 * np.pi) / 9, (3 + 4 * np.pi) / 9]),
        ("atan2(sin(9*Y), cos(9*Y)) - pi", [np.pi / 9, np.pi / 3, 5 * np.pi / 9]),
        ("(atan2(sin(9*Y), cos(9*Y)) + 3)*180/pi", [(2 * np.pi - 3) / 9, (4 * np.pi - 3) / 9, (6 * np.pi - 3) / 9]),
        ("atan2(sin(9*Y), cos(9*Y)) + Y - 3", [0.3, 0.3 + 0.2 * np.pi, 0.3 + 0.4 * np.pi]),
        ("atan2(sin(9*Y), cos(9*Y))^3", [2 * np.pi / 9, 4 * np.pi / 9]),
        # Half a turn is no angle: 0.1 + 2 pi is none of its values.
        ("arctan(9*(Y - 1)) - 0.1", [1 + np.tan(0.1) / 9]),
        ("arctan(9*(Y - 1)) - 0.1 - 2*pi", []),
        ("arcsin(sin(9*Y)) - 0.1 - 2*pi", []),
        ("arccos(cos(9*Y)) - 3 - 2*pi", []),
    ],
)
def test_events_are_zeros_where_the_sign_changes(function, zeros, unit):
    # A unit of the function; a factor of an angle is a factor of its period.
    events = [f"{unit!r}*({function})", Event(function, direction=1), Event(function, direction=-1)]
    scaled, up, down = LINE.solve([0, 0, 1], step=0.125, end=2, events=events).t_events
    assert scaled.shape == (len(zeros),) and np.abs(scaled - zeros).max(initial=0) < 1e-12, scaled
    assert np.abs(np.sort(np.concatenate([up, down])) - zeros).max(initial=0) < 1e-12


ROTATION = System("so(3)", "Pi3")
"""A rotation about the third axis: Pi1 = cos(t0 - t)."""

FORMULATIONS = ["collective", "reduced", "direct"]


def turned(t0):
    return [np.cos(t0), np.sin(t0), 0.5]


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_two_zeros_in_the_first_and_in_the_terminal_step(formulation):
    how = dict(step=0.5, scheme="gauss-16", formulation=formulation)
    exact = np.array([-np.arccos(0.99), np.arccos(0.99)])
    run = ROTATION.solve(turned(0.25), end=3, events="Pi1 - 0.99", **how)
    assert np.abs(run.t_events[0] - (0.25 + exact)).max() < 1e-13
    start, end = turned(2.35), 2.495
    last = Event(f"Pi2 + {float(np.sin(end - 2.35))!r}", direction=-1, terminal=True)
    run = ROTATION.solve(start, end=5, events=["Pi1 - 0.99", last], **how)
    assert np.abs(run.t_events[0] - (2.35 + exact)).max() < 1e-13 and abs(run.t[-1] - end) < 1e-13
    # Of two terminal events the earlier one ends the run, though it is one of two in this step.
    run = ROTATION.solve(start, end=5, events=[last, Event("Pi1 - 0.99", terminal=True)], **how)
    assert abs(run.t[-1] - (2.35 + exact[0])) < 1e-13 and "event 1" in run.message and run.t_events[0].size == 0
    # The last step of a run.
    run = ROTATION.solve(turned(0.25), end=0.5, events="Pi1 - 0.99", **how)
    assert run.t_events[0].size == 2


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_the_start_is_as_it_was_given(formulation):
    rng = np.random.default_rng(1)
    for Pi, Gamma in zip(rng.normal(size=(20, 3)), rng.normal(size=(20, 3))):
        Pi, Gamma = Pi.tolist(), (Gamma / np.linalg.norm(Gamma)).tolist()
        surfaces = [f"Gamma3 - {Gamma[2]!r}", f"Pi1 - {Pi[0]!r}", f"3*Pi2 - {3 * Pi[1]!r}"]
        events = [Event(surface, terminal=True) for surface in surfaces]
        run = TOP.solve(Pi, Gamma, step=0.1, end=0.5, formulation=formulation, events=events)
        assert np.array_equal(run.y[:, 0], [*Pi, *Gamma]) and run.t[-1] > 1e-6, run.message
        assert np.array_equal(run.sol(0.0), run.y[:, 0])
    # Below the surface by more than rounding, the run comes to it at once.
    (Pi, Gamma) = (START["Pi"], START["Gamma"])
    near = "Gamma3 - 0.8 - 1e-9*(Pi1*Gamma2 - Pi2*Gamma1)/|Pi|"
    ways = [TOP.solve(Pi, Gamma, step=0.1, end=1, formulation=formulation, events=near.replace("- 1e", s)) for s in ("- 1e", "+ 1e")]
    assert sorted(way.t_events[0].size and way.t_events[0][0] < 1e-6 for way in ways) == [False, True]


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_starts_of_sections_do_not_count_themselves(formulation):
    for coordinate, value in [("Gamma3", 0.1), ("Pi1", 0.3), ("Gamma1", -0.2)]:
        y = TOP.section_starts(h=2.0, f2=0.3, coordinate=coordinate, value=value, count=15)
        for state in y.T:
            for surface, level in [(coordinate, value), (f"3*{coordinate}", 3 * value)]:
                points = TOP.section(
                    state[:3], state[3:], coordinate=surface, value=level, step=0.1, end=1, formulation=formulation
                )
                assert points.t.size == 0 or points.t[0] > 1e-3


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_a_surface_may_be_an_angle(formulation):
    top = Top.lagrange(1.0, 0.6, 1.0)
    how = dict(step=0.05, end=40, formulation=formulation)
    start = ([0.3, 0, 2.0], [0.6, 0, 0.8])
    run = top.solve(*start, step=0.01, end=40, formulation=formulation)
    angle = np.unwrap(np.arctan2(run.y[4], run.y[3]))
    for value in [0.0, 1.0, np.pi, -3.0, 7.0]:
        for surface in ["atan2(Gamma2, Gamma1)", lambda x: np.arctan2(x.Gamma2, x.Gamma1)]:
            for direction in [1, -1]:
                points = top.section(*start, coordinate=surface, value=value, direction=direction, **how)
                turns = np.floor((angle - value) / (2 * np.pi))
                expected = np.count_nonzero(np.diff(turns) == direction)
                # The start lies on the surface of the angle 0.
                expected -= int(value == 0.0 and np.diff(turns)[0] == direction)
                assert points.t.size == expected
                difference = np.arctan2(points.y[4], points.y[3]) - value
                assert np.abs(np.sin(difference / 2)).max(initial=0) < 1e-13
    assert np.ptp(angle) > 4 * np.pi


def test_functions_of_the_time_and_of_inputs():
    inputs = {"u": ([0, 10], [-1, 1], "linear")}
    odd = np.pi / 2 * np.array([1, 3, 5])
    closed, driven = System("so(3)", "Pi3"), System("so(3)", "Pi3", inputs=inputs, drive={"Pi": [0, 0, "u"]})
    for system in (closed, driven):
        run = system.solve([1, 0, 2], step=0.1, end=10, events=["cos(t)", lambda x, t: np.cos(t)])
        for times in run.t_events:
            assert times.shape == (3,) and np.abs(times - odd).max() < 1e-14
    top = TOP.solve(**START, step=0.05, end=10, events="cos(t)")
    assert np.abs(top.t_events[0] - odd).max() < 1e-14
    assert np.abs(driven.solve([1, 0, 2], step=0.1, end=10, events="u - 0.25").t_events[0] - 6.25).max() < 1e-13
    # Control: of the state alone, and of a name that is none.
    assert np.abs(closed.solve([1, 0, 2], step=0.1, end=10, events=lambda x: x[-3]).t_events[0] - odd).max() < 1e-10
    with pytest.raises(ValueError, match="u"):
        closed.solve([1, 0, 2], step=0.1, end=10, events="u")
    own = System("so(3)", "t*Pi3", parameters={"t": 1.0})
    assert np.abs(own.solve([1, 0, 2], step=0.1, end=2, events="Pi1 - t/2").t_events[0] - np.pi / 3).max() < 1e-10
    with pytest.raises(ValueError, match="another meaning"):
        own.solve([1, 0, 2], step=0.1, end=2, events=lambda x, t: x.Pi1 - t)


def test_functions_of_arrays_and_of_the_time():
    spins = SpinLattice(4, exchange=1.0)
    run = spins.solve({"direction": [0, 0, 1]}, step=0.1, end=2, events=[lambda x, t: np.cos(t), lambda x: x["S"][0, 2] - 2])
    assert abs(run.t_events[0][0] - np.pi / 2) < 1e-14 and [times.size for times in run.t_events] == [1, 0]
