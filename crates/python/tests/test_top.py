"""Tops, their runs, and their errors."""

import numpy as np
import pytest

import heavytop
from heavytop import Top

START = dict(Pi=[2.0, 3.0, 4.0], Gamma=[0.5, 0.0, 0.75**0.5])


def test_a_run_has_the_shapes_of_scipy():
    run = Top.kovalevskaya().solve(**START, step=0.1, end=10, every=3, attitude=True)
    assert run.t.shape == (35,) and run.y.shape == (6, 35) and run.attitude.shape == (4, 35)
    assert run.success and run.t[0] == 0 and run.t[-1] == 100 * 0.1
    assert run.y[:, 0].tolist() == START["Pi"] + START["Gamma"]
    assert set(run.invariants) == {"h", "f1", "f2", "K"}
    assert run.invariants["K"][0] == pytest.approx(193.0, rel=1e-14)


@pytest.mark.parametrize("formulation", heavytop.FORMULATIONS)
def test_casimirs_hold_where_the_formulation_promises(formulation):
    # A Gauss method conserves Casimirs that are quadratic even when it is applied directly.
    scheme = {"splitting": "kahan-li-6", "direct": "rk4"}.get(formulation, "gauss-6")
    run = Top.kovalevskaya().solve(**START, step=0.05, end=50, scheme=scheme, formulation=formulation)
    assert (run.drift("f2") < 1e-12) == (formulation != "direct")
    # 1e-2 is far above the error of any of these schemes with a step of 0.05.
    assert run.drift("h") < 1e-2


def test_the_attitude_turns_the_vertical_of_the_body_to_that_of_space():
    run = Top.kovalevskaya().solve(**START, step=0.1, end=20, attitude=True)
    w, v = run.attitude[0], run.attitude[1:]
    # R Gamma = Gamma + 2 w v x Gamma + 2 v x (v x Gamma)
    across = np.cross(v, run.Gamma, axis=0)
    turned = run.Gamma + 2 * w * across + 2 * np.cross(v, across, axis=0)
    assert np.abs(turned - np.array([[0], [0], [1]])).max() < 1e-13


def test_dense_output_has_the_casimirs_and_meets_the_samples():
    run = Top.kovalevskaya().solve(**START, step=0.1, end=10, scheme="gauss-12")
    t = np.array([9.87, 0.0, 3.21, run.t[-1]])
    y = run.sol(t)
    assert y.shape == (6, 4) and run.sol(1.0).shape == (6,)
    assert np.abs((y[3:] ** 2).sum(axis=0) - 1).max() < 1e-14
    assert np.abs(run.sol(run.t[:50]) - run.y[:, :50]).max() < 1e-12
    finer = Top.kovalevskaya().solve(**START, step=0.01, end=10, scheme="gauss-12")
    assert np.abs(finer.sol(t) - y).max() < 1e-9
    for outside in (-0.1, 10.1, np.nan):
        with pytest.raises(ValueError, match="between 0 and"):
            run.sol(outside)


def test_a_section_lies_on_its_surface():
    points = Top.kovalevskaya().section(**START, coordinate="Gamma2", direction=1, step=0.05, end=200)
    assert points.t.size > 20 and np.all(np.diff(points.t) > 0)
    assert np.abs(points.y[4]).max() < 1e-13
    few = Top.kovalevskaya().section(**START, coordinate="Gamma2", direction=1, step=0.05, end=200, most=3)
    assert np.array_equal(few.y, points.y[:, :3])


def test_invariants_of_states():
    top = Top.lagrange(2.0, 1.0)
    values = top.invariant_values([1, 2, 3, 0, 0, 1])
    assert values["h"] == pytest.approx(0.5 * (1 / 2 + 4 / 2 + 9) + 1)
    assert values["f3"] == 3


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (dict(step=0.0), "step must be positive"),
        (dict(end=0.15), "nearest ends are 0.1 and 0.2"),
        (dict(scheme="gauss-5"), "unknown scheme `gauss-5`"),
        (dict(scheme="rk4", formulation="reduced"), "reduced has no scheme rk4"),
        (dict(formulation="direct", attitude=True), "no attitude"),
        (dict(Pi=[1, 2]), "Pi must have three components"),
        (dict(Gamma=[0, 0, 0]), "different from 0"),
        (dict(Pi=[np.nan, 0, 0]), "finite"),
        (dict(every=0), "every must be at least 1"),
        (dict(tolerance=-1.0), "tolerance must be"),
    ],
)
def test_wrong_arguments_are_value_errors_that_say_why(change, words):
    arguments = {**START, "step": 0.1, "end": 1.0, **change}
    with pytest.raises(ValueError, match=words):
        Top.kovalevskaya().solve(**arguments)


def test_no_body_has_such_moments():
    with pytest.raises(ValueError, match="triangle"):
        Top(inertia=[1, 1, 3])


def test_a_step_that_fails_ends_the_run_and_keeps_what_was_before():
    run = Top.kovalevskaya().solve(
        Pi=[2e9, 3e9, 4e9], Gamma=[0.6, 0, 0.8], step=1.0, end=100.0, scheme="explicit-midpoint", formulation="direct"
    )
    assert not run.success and "step" in run.message
    assert isinstance(run.error, heavytop.IntegrationError)
    assert 0 < run.t.size < 101 and np.isfinite(run.y).all()


def test_reprs_say_what_they_are():
    top = Top.kovalevskaya()
    assert repr(top) == "<Top: I = (2, 2, 1), m g l = 1, c = (1, 0, 0)>"
    assert "drift" in repr(top.solve(**START, step=0.1, end=1))
