"""Moments about the support and about the centre of mass, matrices, thin rods, and directions by angles."""

import copy
import pickle
import warnings

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

import heavytop
from heavytop import Top, vertical

C = np.array([0.48, 0.6, 0.64])
START = np.array([0.5, 1.2, -0.8, 0.6, 0.0, 0.8])
ROTATIONS = [Rotation.from_euler("xyz", angles).as_matrix() for angles in ((0.4, -1.1, 2.3), (3.0, 0.2, -0.7))]
MOMENTS = ([1.0, 1.7, 2.2], [2.0, 2.0, 1.0], [1.4, 1.4, 1.4])


def by_equations(inertia, weight, start, t):
    """The states, as columns, by SciPy from the equations with the full matrix."""
    inverse = np.linalg.inv(inertia)

    def rates(_, y):
        omega = inverse @ y[:3]
        return np.concatenate([np.cross(y[:3], omega) + weight * np.cross(y[3:], C), np.cross(y[3:], omega)])

    return solve_ivp(rates, (0, t[-1]), start, method="DOP853", rtol=1e-12, atol=1e-12, t_eval=t).y


@pytest.mark.parametrize("rotation", ROTATIONS)
@pytest.mark.parametrize("moments", MOMENTS)
def test_a_matrix_moves_as_the_equations_with_it_say(rotation, moments):
    inertia = rotation @ np.diag(moments) @ rotation.T
    top = Top(inertia, mass=1.0, gravity=2.6, length=0.5, center_of_mass=C)
    assert np.allclose(np.sort(top.inertia), np.sort(moments), atol=1e-14)
    axes = top.principal_axes
    assert np.allclose(axes @ np.diag(top.inertia) @ axes.T, inertia, atol=1e-14)
    assert np.allclose(top.center_of_mass, C, atol=1e-15)

    run = top.solve(START[:3], START[3:], step=0.05, end=4, scheme="gauss-12", attitude=True, events="Gamma2 - 0.1")
    expected = by_equations(inertia, 1.3, START, run.t)
    assert np.array_equal(run.y[:, 0], START)
    assert np.abs(run.y - expected).max() < 1e-9
    # The attitude has the vertical of the same axes, and begins with the shortest rotation, as for principal moments.
    turns = Rotation.from_quat(run.attitude[[1, 2, 3, 0]].T)
    assert np.abs(turns.apply([0, 0, 1], inverse=True).T - run.Gamma).max() < 1e-12
    plain = Top([1, 1, 1], 1, 1, 1, C, inertia_about="center-of-mass")
    first = plain.solve(START[:3], START[3:], step=0.05, end=0.05, attitude=True).attitude[:, 0]
    assert np.abs(run.attitude[:, 0] - first).max() < 1e-14
    # Events, states in between, sections and many tops are in these axes, too.
    assert run.y_events[0].shape[0] > 0 and np.abs(run.y_events[0][:, 4] - 0.1).max() < 1e-12
    assert np.abs(run.sol(run.t) - run.y).max() < 1e-12
    points = top.section(START[:3], START[3:], coordinate="Gamma1", step=0.05, end=20)
    assert points.t.size > 1 and np.abs(points.y[3]).max() < 1e-12
    ends = heavytop.solve_many(top, np.array([START, START]).T, step=0.05, end=4, scheme="gauss-12")
    assert np.abs(ends.y.T - run.y[:, -1]).max() < 1e-12
    ends = heavytop.solve_many([top, top], np.array([START, START]).T, step=0.05, end=4, scheme="gauss-12")
    assert np.abs(ends.y.T - run.y[:, -1]).max() < 1e-12
    grown = heavytop.lyapunov(top, START, step=0.05, end=4, scheme="gauss-12")
    assert np.abs(grown.y - run.y[:, -1]).max() < 1e-12
    values = top.invariant_values(START)
    energy = 0.5 * START[:3] @ np.linalg.solve(inertia, START[:3]) + 1.3 * START[3:] @ C
    assert abs(values["h"] - energy) < 1e-14 and abs(values["f2"] - START[:3] @ START[3:]) < 1e-14
    starts = top.section_starts(h=3.0, f2=0.3, coordinate="Gamma2", value=0.1, count=5)
    assert np.abs(starts[4] - 0.1).max() < 1e-14 and np.abs(top.invariant_values(starts)["h"] - 3).max() < 1e-13


def test_a_matrix_is_kept_by_copies_and_is_part_of_equality():
    inertia = ROTATIONS[0] @ np.diag(MOMENTS[0]) @ ROTATIONS[0].T
    top = Top(inertia, 1.0, 2.6, 0.5, C)
    for again in (copy.deepcopy(top), pickle.loads(pickle.dumps(top))):
        assert again == top and hash(again) == hash(top)
    assert Top(np.diag(MOMENTS[0]), 1.0, 2.6, 0.5, C) == Top(MOMENTS[0], 1.0, 2.6, 0.5, C) != top
    for wrong, text in (
        ([[2, 0.1, 0], [0.2, 2, 0], [0, 0, 1]], "symmetric"),
        ([[2, 0.1, 0], [0.1, np.nan, 0], [0, 0, 1]], r"inertia\[1\]\[1\] must be finite"),
        ([[1, 3, 0], [3, 1, 0], [0, 0, 1]], "inertia"),
        ([1, 2], "three components"),
    ):
        with pytest.raises(ValueError, match=text):
            Top(wrong, 1.0, 2.6, 0.5, C)


@pytest.mark.parametrize("scale", [1.0, 1e-30, 1e30])
def test_impossible_moments_are_told(scale):
    gyroscope = dict(mass=0.5 * scale, gravity=9.81, length=0.04)
    inertia = np.array([2e-4, 2e-4, 3e-4]) * scale
    with pytest.warns(UserWarning, match="no body has these moments about the support"):
        Top(inertia, **gyroscope)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        central = Top(inertia, **gyroscope, inertia_about="center-of-mass")
        assert np.allclose(central.inertia / scale, [1e-3, 1e-3, 3e-4], rtol=1e-14)
        # About an axis on which the centre of mass is not, the principal axes turn.
        aside = Top(np.array([1.0, 1.2, 1.5]) * scale, 2 * scale, 3, 0.5, C, inertia_about="center-of-mass")
        expected = np.diag([1.0, 1.2, 1.5]) + 0.5 * (np.eye(3) - np.outer(C, C))
        found = aside.principal_axes @ np.diag(aside.inertia / scale) @ aside.principal_axes.T
        assert np.allclose(found, expected, atol=1e-14)
        Top.kovalevskaya()
        Top(inertia, 0.5 * scale, 0.0, 0.04)
    with pytest.raises(ValueError, match="no body has these moments"):
        Top([scale, scale, 3 * scale], scale, 1, 1, inertia_about="center-of-mass")
    with pytest.raises(ValueError, match="inertia_about must be one of support, center-of-mass"):
        Top(inertia, **gyroscope, inertia_about="centre")


def test_a_thin_rod_is_a_pendulum_without_spin():
    rod = Top([0.12, 0.12, 0.0], mass=1.0, gravity=9.81, length=0.3)
    start = dict(Pi=[0.1, 0.2, 0.0], Gamma=[0.6, 0.0, -0.8], step=0.01, end=5)
    run = rod.solve(**start)
    other = Top([0.12, 0.12, 0.05], mass=1.0, gravity=9.81, length=0.3).solve(**start)
    assert np.abs(run.y - other.y).max() < 1e-11
    assert run.deviation("h") < 1e-9 and np.abs(run.Pi[2]).max() < 1e-14
    many = np.array([[0.1, 0.2, 0.3, 0.6, 0.0, -0.8]]).T
    for spinning in (
        lambda: rod.solve([0.1, 0.2, 0.3], [0.6, 0, -0.8], step=0.01, end=1),
        lambda: heavytop.solve_many(rod, many, step=0.01, end=1),
        lambda: heavytop.solve_many([rod], many, step=0.01, end=1),
        lambda: heavytop.lyapunov(rod, many[:, 0], step=0.01, end=1),
    ):
        with pytest.raises(ValueError, match="no angular momentum about itself"):
            spinning()
    # By the other constructors, too, along any axis where there is no weight.
    assert Top.lagrange(0.12, 0, 9.81 * 0.3) == rod
    free = Top([0.12, 0.12, 0.0], 1.0, 0.0, 0.3)
    assert Top.free_rigid_body([0.12, 0.12, 0]) == free
    straight = Top.free_rigid_body([0.12, 0.0, 0.12]).solve([0.1, 0.0, 0.2], [0.6, 0.0, 0.8], step=0.1, end=1)
    assert np.abs(straight.Pi - [[0.1], [0.0], [0.2]]).max() < 1e-15
    for impossible in (lambda: Top.free_rigid_body([1, 0, 0]), lambda: Top.lagrange(0, 1), lambda: Top.lagrange(1, -1)):
        with pytest.raises(ValueError, match="positive|negative"):
            impossible()
    with pytest.raises(ValueError, match="thin rod"):
        Top([0.12, 0.12, 0.0], 1.0, 9.81, 0.3, [0.6, 0, 0.8])


def test_a_sphere_conserves_the_momentum_about_its_centre_of_mass():
    sphere = Top([1.4, 1.4, 1.4], mass=1.0, gravity=2.0, length=0.5, center_of_mass=C)
    assert sphere.invariants == ("h", "f1", "f2", "f3")
    run = sphere.solve(START[:3], START[3:], step=0.05, end=20, scheme="gauss-12")
    assert np.allclose(run.invariants["f3"], C @ run.Pi, atol=1e-14) and run.deviation("f3") < 1e-11


def test_directions_by_angles():
    assert np.allclose(vertical("30 deg", "60 deg"), vertical(np.pi / 6, np.pi / 3), atol=1e-15)
    assert np.array_equal(vertical(0), [0, 0, 1]) and vertical("180 deg")[2] == -1
    assert np.allclose(vertical("1 rad", "-90\N{DEGREE SIGN}"), [0, -np.sin(1), np.cos(1)], atol=1e-15)
    for angles, text in (
        ((30,), 'is in radians, from 0 to pi, and 30 is beyond pi; write "30 deg"$'),
        ((30.123456789,), 'write "30.123456789 deg"$'),
        # Half a turn with too few digits, and angles that are out of range in degrees, too.
        ((3.15,), 'and 3.15 is beyond pi; write an angle from 0 to pi, such as "30 deg"$'),
        ((-0.5,), 'and -0.5 is beyond 0; write an angle from 0 to pi, such as "30 deg"$'),
        ((-30,), "and -30 is beyond 0; write an angle from 0 to pi"),
        ((400,), "and 400 is beyond pi; write an angle from 0 to pi"),
        ((1, -400), "and -400 is beyond -2 pi; write an angle between -2 pi and 2 pi"),
        (("200 deg",), "inclination must be from 0 to pi, got '200 deg'"),
        (("30",), "needs a number and deg or rad"),
        (("x deg",), "needs a number and deg or rad"),
        ((1, 90), 'azimuth is in radians, between -2 pi and 2 pi, and 90 is beyond 2 pi; write "90 deg"$'),
        ((1, -90), 'and -90 is beyond -2 pi; write "-90 deg"$'),
        ((np.nan,), "finite"),
    ):
        with pytest.raises(ValueError, match=text):
            vertical(*angles)
