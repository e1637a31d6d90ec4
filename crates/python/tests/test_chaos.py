"""Lyapunov exponents, MEGNO and SALI."""

import numpy as np
import pytest

from heavytop import IntegrationError, System, Top, Vortices, lyapunov

CHAOTIC = Top(inertia=[1.0, 1.7, 2.2], mass=1.0, gravity=9.81, length=0.5, center_of_mass=[0.6, 0.0, 0.8])
WILD = [1.0, 2.0, 1.0, 0.0, 0.6, 0.8]
REGULAR = Top.kovalevskaya()
TAME = [2.0, 3.0, 4.0, 0.6, 0.0, 0.8]


def test_chaos_and_order_differ_in_every_indicator():
    wild = lyapunov(CHAOTIC, WILD, step=0.05, end=500, sali=True)
    tame = lyapunov(REGULAR, TAME, step=0.05, end=500, sali=True)
    assert wild.exponents[0] > 0.1 and tame.exponents[0] < 0.03
    assert wild.megno > 10 and 1 < tame.megno < 3
    assert wild.sali < 1e-12 and tame.sali > 1e-4
    assert wild.exponents.shape == (1,) and wild.y.shape == (6,) and float(wild.t) == 500


def test_the_spectrum_is_that_of_a_poisson_map():
    found = lyapunov(CHAOTIC, WILD, step=0.05, end=500, exponents=6, scheme="gauss-6").exponents
    # The determinant of a Poisson map of se(3)* that conserves the Casimirs is 1: ln 1 = 0, with 1e4 steps of rounding.
    assert found.shape == (6,) and abs(found.sum()) < 1e-11
    # pairs of opposite signs, up to the convergence of (ln t)/t
    assert np.abs(found + found[::-1]).max() < 0.05 and found[0] > 0.1 and np.abs(found[2:4]).max() < 0.05
    # Control: a map that is not a Poisson map changes the volume.
    other = lyapunov(CHAOTIC, WILD, step=0.05, end=50, exponents=6, scheme="rk4", formulation="direct").exponents
    assert abs(other.sum()) > 1e-7


def test_the_exponent_is_the_growth_of_nearby_runs():
    """The growth of the distance of two runs of `solve`, which starts at 1e-7, over twelve seconds."""
    found = lyapunov(CHAOTIC, WILD, step=0.01, end=12, every=1200)
    direction = np.array([0.3, -0.2, 0.5, 0.1, 0.4, -0.3])
    ends = [
        CHAOTIC.solve(*np.split(np.array(WILD) + s * direction, 2), step=0.01, end=12).y[:, -1] for s in (0, 1e-7)
    ]
    growth = np.log(np.linalg.norm(ends[1] - ends[0]) / (1e-7 * np.linalg.norm(direction))) / 12
    # Two directions grow alike up to a factor e, which is 1/12 here.
    assert found.exponents.shape == (1, 1) and abs(found.exponents[0, 0] - growth) < 0.2 and growth > 0.1


def test_many_runs_and_histories_have_axes():
    y = np.array([WILD, TAME, WILD]).T
    y[0, 2] += 0.5
    many = lyapunov(CHAOTIC, y, step=0.05, end=20, every=100, exponents=2)
    assert many.t.tolist() == [5.0, 10.0, 15.0, 20.0]
    assert many.exponents.shape == (2, 3, 4) and many.megno.shape == (3, 4) and many.y.shape == (6, 3)
    for i in range(3):
        one = lyapunov(CHAOTIC, y[:, i], step=0.05, end=20, every=100, exponents=2)
        assert np.array_equal(one.exponents, many.exponents[:, i]) and np.array_equal(one.megno, many.megno[i])
        assert np.array_equal(one.y, many.y[:, i])
        last = lyapunov(CHAOTIC, y[:, i], step=0.05, end=20, exponents=2)
        assert np.array_equal(last.exponents, one.exponents[:, -1])
    assert not np.array_equal(many.exponents[:, 0], many.exponents[:, 1])
    tops = lyapunov([CHAOTIC, REGULAR, CHAOTIC], y, step=0.05, end=20)
    assert tops.exponents.shape == (1, 3)
    assert tops.exponents[0, 1] == lyapunov(REGULAR, TAME, step=0.05, end=20).exponents[0]


def test_a_run_that_fails_is_reported_and_harms_no_other():
    y = np.array([WILD, TAME]).T
    y[2, 1] = np.nan
    found = lyapunov(CHAOTIC, y, step=0.05, end=5)
    assert list(found.failures) == [1] and np.isnan(found.exponents[0, 1])
    assert found.exponents[0, 0] == lyapunov(CHAOTIC, WILD, step=0.05, end=5).exponents[0]
    with pytest.raises(IntegrationError):
        lyapunov(CHAOTIC, y[:, 1], step=0.05, end=5)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (dict(exponents=7), "from 1 to 6"),
        (dict(exponents=0), "exponents must be a whole number from 1"),
        (dict(exponents=2, sali=True), "exponents must be 1 if sali"),
        (dict(formulation="collective"), "leave it out"),
        (dict(y0=[1, 2]), "shape"),
        (dict(end=0.07), "nearest ends"),
        (dict(scheme="euler"), "scheme must be one of"),
        (dict(every=0), "every"),
    ],
)
def test_wrong_arguments_are_value_errors(change, words):
    arguments = {"y0": TAME, "step": 0.05, "end": 1.0, **change}
    with pytest.raises(ValueError, match=words):
        lyapunov(REGULAR, **arguments)


def test_a_result_shows_its_indicators():
    assert repr(lyapunov(REGULAR, TAME, step=0.1, end=10)).startswith("<Chaos: up to t = 10, the largest exponent is ")
    many = lyapunov(REGULAR, np.array([TAME, TAME]).T, step=0.1, end=10)
    assert repr(many) == "<Chaos: up to t = 10, 2 runs, 0 failures>"


def test_systems_do_not_come_in_a_sequence():
    system = System("so(3)", "Pi·Pi/2")
    with pytest.raises(ValueError, match="a sequence must be one of tops, .* at 1"):
        lyapunov([REGULAR, system], np.array([TAME, TAME]).T, step=0.1, end=1)


@pytest.mark.parametrize("unit", [1e-30, 1e-9, 1e9, 1e30])
@pytest.mark.parametrize("spin", [1.0, 0.0])
def test_indicators_do_not_depend_on_the_unit_of_mass(unit, spin):
    def measured(s):
        top = Top([1.0 * s, 1.7 * s, 2.2 * s], mass=s, gravity=9.81, length=0.5, center_of_mass=[0.6, 0, 0.8])
        y = [spin * s, 2 * spin * s, spin * s, 0, 0.6, 0.8]
        one = lyapunov(top, y, step=0.05, end=10, sali=True)
        return [*lyapunov(top, y, step=0.05, end=10, exponents=6).exponents, *one.exponents, one.megno, one.sali]

    # Round-off of the parameters in other units, which chaos enlarges.
    assert measured(unit) == pytest.approx(measured(1.0), rel=1e-8, abs=1e-8)


def test_all_exponents_of_a_system_of_eight_and_of_eighteen_dimensions():
    rotor = System("su(3)", "mu1^2 + mu4^2/2 + mu7^2/3 + mu1*mu2/2 + mu3*mu8/3")
    start = 0.1 * np.arange(1, 9)
    found = lyapunov(rotor, start, step=0.05, end=20, exponents=8).exponents
    # The volume of momenta is kept, up to the order of the method.
    assert found.shape == (8,) and abs(found.sum()) < 1e-6
    few = lyapunov(rotor, start, step=0.05, end=20, exponents=2).exponents
    assert np.array_equal(few, found[:2])
    vortices = Vortices([1.0, -0.6, 0.8, 1.3, -0.9, 0.7])
    places = [[np.sin(1.7 * t), np.cos(2.9 * t), np.sin(0.8 * t * t)] for t in range(1, 7)]
    places = [np.array(place) / np.linalg.norm(place) for place in places]
    # In such steps the equations of the tangent vectors need Newton's iteration.
    all_of_them = lyapunov(vortices, {"positions": places}, step=0.4, end=3.2, exponents=18, scheme="gauss-4").exponents
    assert abs(all_of_them.sum()) < 1e-9
