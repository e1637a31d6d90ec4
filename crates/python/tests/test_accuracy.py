"""How accurate runs are: the estimate, the check, and one warning for all of them."""

import warnings

import numpy as np
import pytest

import heavytop
from heavytop import System, Top

TOP = Top.kovalevskaya()
START = dict(Pi=[2, 3, 4], Gamma=[0.6, 0, 0.8])
STATE = [2, 3, 4, 0.6, 0, 0.8]
BODY = System("so(3)", "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2")
FAST = [0.3, 0.2, 30]
LONG = "the motion turns by about .* rad in a step"


def test_motions_that_are_wrong_are_warned_of():
    """They conserve the Casimirs, and are wrong in the first digit."""
    for solve, casimir in [
        (lambda: TOP.solve(**START, step=2.5, end=250), "f1"),
        (lambda: TOP.solve(**START, step=0.032, end=20, scheme="implicit-midpoint"), "f1"),
        (lambda: BODY.solve(FAST, step=1, end=30), "c1"),
        (lambda: BODY.solve(FAST, np.linspace(0, 30, 31)), "c1"),
        (lambda: BODY.solve(FAST, step=7.5, end=75), "c1"),
    ]:
        with pytest.warns(RuntimeWarning, match=LONG) as caught:
            run = solve()
        assert caught[0].filename == __file__
        assert run.success and run.deviation(casimir) < 1e-9
        assert run.error_estimate > (0.1 if casimir == "f1" else 0)


def test_the_fastest_of_many_runs_is_measured():
    """It is no member of any regular choice, and slow by |Pi|: the moments and the weight decide."""
    slow, fast = [0.1, 0.2, 0.3], [0.3, 30, 0.2]
    turns = np.array([fast if i == 13 else slow for i in range(20)]).T
    states = np.vstack([0.01 * np.ones((3, 20)), 0.6 * np.ones(20), np.zeros(20), 0.8 * np.ones(20)])
    heavy = Top.kovalevskaya(weight_moment=1e6)
    for call in [
        lambda: heavytop.solve_many(BODY, turns, step=0.1, end=10),
        lambda: heavytop.lyapunov(BODY, turns, step=0.1, end=10),
        lambda: heavytop.solve_many([heavy if i == 13 else TOP for i in range(20)], states, step=0.01, end=0.1),
        lambda: heavytop.lyapunov([heavy if i == 13 else TOP for i in range(20)], states, step=0.01, end=0.1),
    ]:
        with pytest.warns(RuntimeWarning, match=f"^run 13: {LONG}"):
            call()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        # Control: without it there is nothing to warn of. A state that is none is left to the failures.
        turns[:, 13] = np.nan
        assert list(heavytop.solve_many(BODY, turns, step=0.1, end=10).failures) == [13]
        heavytop.solve_many([TOP] * 20, states, step=0.01, end=0.1)


def test_an_estimate_may_be_left_out():
    """The run is the same, and a step that turns the motion too far is still warned of."""
    times = np.linspace(0, 10, 101)
    for solve in [
        lambda **more: TOP.solve(**START, step=0.1, end=20, **more),
        lambda **more: BODY.solve(FAST, step=0.1, end=10, **more),
        lambda **more: BODY.solve(FAST, times, **more),
    ]:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            whole, alone = solve(), solve(estimate=False)
        assert np.array_equal(whole.y, alone.y)
        assert whole.error_estimate is not None and alone.error_estimate is None
        with pytest.raises(ValueError, match="estimate must be True or False"):
            solve(estimate="no")
    with pytest.warns(RuntimeWarning, match=LONG):
        BODY.solve(FAST, step=1, end=30, estimate=False)


def test_right_motions_are_not():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert TOP.solve(**START, step=0.1, end=20).error_estimate < 1e-4
        assert BODY.solve(FAST, step=0.02, end=10).error_estimate < 1e-6
        y = np.array([STATE] * 20).T
        assert heavytop.solve_many(TOP, y, step=0.1, end=10).error_estimate < 1e-4
        heavytop.lyapunov(TOP, STATE, step=0.1, end=10)


def test_many_runs_sections_and_exponents_have_the_same_warning():
    y = np.array([STATE] * 20).T
    y[2, 13] = 40.0
    bodies = np.array([FAST] * 3).T
    for call in [
        lambda: heavytop.solve_many(TOP, y, step=0.1, end=10),
        lambda: heavytop.solve_many([TOP] * 20, y, step=0.1, end=10),
        lambda: heavytop.solve_many(BODY, bodies, step=1, end=10),
        lambda: heavytop.lyapunov(TOP, y, step=0.1, end=1),
        lambda: heavytop.lyapunov(BODY, FAST, step=1, end=10),
        lambda: TOP.section(**START, coordinate="Gamma3", step=1, end=10),
        lambda: BODY.section(FAST, "Pi2", step=1, end=10),
    ]:
        with pytest.warns(RuntimeWarning, match=LONG) as caught:
            call()
        assert caught[0].filename == __file__


def test_the_estimate_is_close_to_the_error():
    for scheme, step in [("implicit-midpoint", 0.01), ("gauss-4", 0.05), ("gauss-8", 0.15), ("rk4", 0.02)]:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            run = TOP.solve(**START, step=step, end=30, scheme=scheme)
        exact = TOP.solve(**START, step=step / 4, end=30, scheme="gauss-12", every=4)
        error = max(
            (np.linalg.norm(run[name] - exact[name], axis=0) / np.linalg.norm(exact[name], axis=0).max()).max()
            for name in ["Pi", "Gamma"]
        )
        assert error / 2 < run.error_estimate < 2 * error, (scheme, error, run.error_estimate)


def test_a_check_says_the_error_and_the_order():
    check = TOP.solve(**START, step=0.2, end=4).check()
    assert 0 < check.error < 1e-3 and abs(check.order - 8) < 0.5
    check = BODY.solve(FAST, step=0.05, end=1, scheme="gauss-4").check()
    assert abs(check.order - 4) < 0.3
    fine = TOP.solve(**START, step=0.01, end=1).check()
    assert fine.error < 1e-12 and fine.order is None and fine.t == 1


def test_absurd_steps_are_refused():
    body = System("so(3)", "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2")
    top = Top(inertia=[2.0, 2.0, 3.0], mass=1.0, gravity=0.0, length=0.1)
    # Both turn by 10 rad/s.
    for solve in [
        lambda step, **how: body.solve([0.0, 0.0, 30.0], step=step, **how),
        lambda step, **how: body.section([0.0, 0.0, 30.0], surface="Pi1", step=step, **how),
        lambda step, **how: top.solve(Pi=[0.0, 0.0, 30.0], Gamma=[0.0, 0.0, 1.0], step=step, **how),
        lambda step, **how: top.section([0.0, 0.0, 30.0], [0.0, 0.0, 1.0], coordinate="Pi1", step=step, **how),
    ]:
        with pytest.raises(ValueError, match="a step of 11 s turns the motion by about .* it must be at most 100"):
            solve(11.0, end=11.0)
        # Control: a step of 10 rad is warned of.
        with pytest.warns(RuntimeWarning, match=LONG):
            solve(1.0, end=1.0)



def test_a_run_that_ends_between_steps_is_checked_at_the_last_whole_step():
    for sign in (1, -1):
        run = TOP.solve(**START, step=0.1, end=sign * 4, events=heavytop.Event("Gamma2", terminal=2))
        steps = int(abs(run.t[-1]) // 0.1)
        assert run.status == 1 and steps > 1 and 0.005 < abs(run.t[-1]) - 0.1 * steps < 0.095
        check = run.check()
        assert check.t == pytest.approx(0.1 * steps * sign)
        assert check == TOP.solve(**START, step=0.1, end=check.t).check()
        assert check.error != TOP.solve(**START, step=0.1, end=check.t + sign * 0.1).check().error
    run = TOP.solve(**START, step=0.1, end=1, events=heavytop.Event("Gamma2 + 0.01", terminal=True))
    if run.status == 0:
        run = TOP.solve(**START, step=0.1, end=1, events=heavytop.Event("Gamma2 - 0.01", terminal=True))
    assert run.status == 1 and run.t[-1] < 0.05
    with pytest.raises(ValueError, match=r"a run must have a whole step to be checked, and it ends at 0\.0\d+, with a step of 0.1"):
        run.check()
    # Its estimate is that of the whole step.
    assert run.error_estimate is not None
    assert run.error_estimate == TOP.solve(**START, step=0.1, end=0.1).error_estimate
