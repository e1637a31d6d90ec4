"""Traced functions against the same functions of numbers."""

import math
import operator

import numpy as np
import pytest

from heavytop import System, functions

POINT = np.array([0.7, 0.4, 1.3, 0.6, 0.2, 0.8])


class Numbers:
    """The point with the names of the coordinates."""

    Pi, Gamma = POINT[:3], POINT[3:]
    Pi1, Pi2, Pi3, Gamma1, Gamma2, Gamma3 = (float(x) for x in POINT)
    I = np.array([2.0, 3.0, 4.0])
    m = 1.5

    def __getitem__(self, key):
        return getattr(self, key) if isinstance(key, str) else POINT[key]


def in_place(p, q):
    """Returns what arithmetic in place makes of two vectors, and checks that it is in place."""
    kept = p
    p *= 2
    p += q
    p[1:] -= q[:2] / 4
    p **= 2
    np.sin(p, out=p)
    np.add(p, 1.0, out=p, where=[True, False, True])
    p[0] = q[1]
    assert kept is p
    return p.sum() + np.add.reduce(q * 1, out=np.empty((), dtype=p.dtype))


FUNCTIONS = [
    lambda x: 0.5 * x.Pi1**2 / 2 - x.Pi2 * 3 + 1 / x.Pi3 - (-x.Gamma1) + (+x.Gamma2),
    lambda x: 2 - x.Pi1 + 3 * x.Pi2 / (1 + x.Pi3) + 2**x.Gamma1 + x.Pi1**x.Gamma2 + x.Pi2**-1.5,
    lambda x: x.Pi @ x.Pi + np.dot(x.Pi, x.Gamma) + x.Gamma.dot(x.Pi / x.I) * x.m,
    lambda x: np.cross(x.Pi, x.Gamma) @ np.array([1.0, 2.0, 3.0]) + np.linalg.norm(x.Pi),
    lambda x: (np.diag([1.0, 2.0, 3.0]) @ x.Pi) @ x.Pi + (x.Pi**2).sum() + sum(x.Gamma),
    lambda x: np.sin(x.Pi1) + np.cos(x.Pi2) * np.tan(x.Pi3 / 3) + np.sqrt(x.Gamma1) + np.exp(-x.Pi1) + np.log(x.Pi2),
    lambda x: np.sinh(x.Pi1) + np.cosh(x.Pi2) - np.tanh(x.Pi3) + abs(x.Gamma1 - 1) + np.abs(x.Gamma2 - 1),
    lambda x: np.arctan2(x.Pi1, x.Pi2) + functions.atan2(1.0, x.Pi3) + np.hypot(x.Pi1, x.Pi2) + np.square(x.Pi3),
    lambda x: functions.sin(x.Pi1) * functions.sqrt(x.Pi2) + functions.norm(x.Pi) + functions.dot(x.Pi, x.Gamma),
    lambda x: x["Pi1"] * x["Pi"][2] + x[0] * x[5] + x[1:3].sum() + np.float64(2) * x.Pi1 - np.int64(2) * x.Pi2,
    lambda x: np.exp(np.sin(x.Pi)).prod() + np.outer(x.Pi, x.Gamma).trace(),
    lambda x: np.arctan2(2.0, x.Pi1) + np.hypot(2, x.Pi2) + np.arctan2(x.Pi3, np.float64(3)) + np.power(2.0, x.Pi1),
    lambda x: (np.arctan2(1.5, x.Pi) * np.hypot(np.array([1.0, 2.0, 3.0]), x.Gamma)).sum() + np.add.reduce(x.Pi),
    lambda x: functions.atan2(2.0, x.Pi).sum() + np.arctan2([1.0, 2.0, 3.0], x.Pi1) @ x.Gamma + np.concatenate([x.Pi, x.Gamma]).prod(),
    lambda x: np.arcsin(x.Pi1) + np.arccos(x.Pi2) * np.arctan(x.Pi3) + np.log10(x.Gamma1) - np.cbrt(x.Gamma2 - 1),
    lambda x: np.where(x.Pi1 > 0.5, x.Pi2, 1 / (x.Pi1 - 0.9)) + np.where(x.Pi1 <= 0.5, 2, x.Pi3**2),
    lambda x: np.where(1.0 < x.Pi3, np.where(x.Pi2 >= 2, 1, x.Pi), x.Gamma).sum() + np.where(x.Pi > 0.5, x.Gamma, 0.1).prod(),
    lambda x: functions.where(np.float64(2) > x.Pi1, functions.hypot(x.Pi1, 3), 0) + functions.arcsin(x.Gamma1) + functions.cbrt(8.0),
    lambda x: in_place(x.Pi * 1, x.Gamma),
    lambda x: 3,
]


@pytest.mark.parametrize("number", range(len(FUNCTIONS)))
def test_a_traced_function_has_the_values_of_the_function(number):
    function = FUNCTIONS[number]
    system = System("se(3)", function, parameters={"I": Numbers.I, "m": Numbers.m})
    expected = function(Numbers())
    # a few rounding errors of terms of size ten
    assert system.invariant_values(POINT)["h"] == pytest.approx(expected, rel=1e-14, abs=1e-14)
    # Control: another point has another value, unless the function is constant.
    assert (system.invariant_values(POINT + 0.01)["h"] == expected) == (number == len(FUNCTIONS) - 1)


def test_the_differential_is_that_of_the_function():
    """The rate of so(3) is Pi x dh, here with dh from central differences, whose error is about 1e-10."""

    def energy(x):
        return np.exp(np.sin(x.Pi1 * x.Pi2)) / (2 + np.cos(x.Pi3)) + np.linalg.norm(x.Pi) ** 3

    system, pi = System("so(3)", energy), POINT[:3]
    basis = 1e-5 * np.eye(3)
    values = [system.invariant_values(pi + s * e)["h"] for e in basis for s in (1, -1)]
    slope = np.subtract(values[::2], values[1::2]) / 2e-5
    assert np.abs(system.rate(pi) - np.cross(pi, slope)).max() < 1e-8
    assert np.abs(system.rate(pi) - np.cross(pi, slope * [1, 1, 1.01])).max() > 1e-4


def test_a_value_that_is_not_chosen_does_not_count():
    system = System("so(3)", lambda x: np.where(x.Pi1 > 0, np.sqrt(x.Pi1), x.Pi2) + 0.5 * x.Pi3**2)
    for pi, slope in [([-1, 2, 3], [0, 1, 3]), ([0, 2, 3], [0, 1, 3]), ([4, 2, 3], [0.25, 0, 3])]:
        assert system.rate(pi) == pytest.approx(np.cross(pi, slope), abs=1e-15)
    # Control: a chosen value without a slope counts.
    system = System("so(3)", lambda x: np.where(x.Pi1 >= 0, np.sqrt(x.Pi1), x.Pi2) + 0.5 * x.Pi3**2)
    assert not np.isfinite(system.rate([0, 2, 3])).all()


@pytest.mark.parametrize("compare", [operator.gt, operator.ge, operator.lt, operator.le])
def test_a_condition_that_is_not_a_number_has_no_value(compare):
    system = System("so(3)", lambda x: np.where(compare(np.log(x.Pi1), 0), 1, x.Pi2))
    with pytest.raises(ValueError, match=r"where ln\(Pi1\) is not a number"):
        system.invariant_values([-1, 2, 3])
    # Control: elsewhere it has one.
    assert system.invariant_values([2, 2, 3])["h"] in (1, 2)


def test_the_function_is_called_once():
    calls = []

    def energy(x):
        calls.append(x)
        return x.Pi @ x.Pi + x.Pi1**4

    system = System("so(3)", energy)
    system.solve(POINT[:3], step=0.1, end=10)
    assert len(calls) == 1


def test_shared_parts_stay_shared():
    def energy(x):
        s = x.Pi1 + x.Pi2
        for _ in range(40):
            s = s * s / 2
        return s + x.Pi3

    # As text this has 2^40 terms.
    system = System("so(3)", energy)
    assert len(system.hamiltonian) < 2000 and "s40" in system.hamiltonian
    assert system.invariant_values([1.5, 0.5, 7.0])["h"] == 9.0
    assert len(repr(system)) < 300


BRANCHES = [
    lambda x: x.Pi1 if x.Pi1 > 0 else x.Pi2,
    lambda x: x.Pi1 if x.Pi1 else x.Pi2,
    lambda x: max(x.Pi1, x.Pi2),
    lambda x: x.Pi1 if x.Pi1 == x.Pi2 else x.Pi2,
    lambda x: x.Pi[x.Pi > 0].sum(),
    lambda x: x.Pi[x.Pi1 > 0],
    lambda x: x.Pi[x.Pi1],
    lambda x: x.Pi.__setitem__(x.Pi > 0, 0),
    lambda x: np.add(x.Pi, 1, where=x.Pi > 0).sum(),
    lambda x: np.where(x.Pi1 == 0, 1, x.Pi1),
    lambda x: np.maximum(x.Pi1, 0),
]


@pytest.mark.parametrize("function", BRANCHES)
def test_a_branch_is_a_type_error_that_says_what_to_do(function):
    with pytest.raises(TypeError, match=r"called once.*cannot branch.*numpy\.where"):
        System("so(3)", function)


@pytest.mark.parametrize(
    ("function", "error", "words"),
    [
        (lambda x: math.sin(x.Pi1), TypeError, "functions of numpy or of heavytop.functions"),
        (lambda x: float(x.Pi1), TypeError, "a symbol is no number"),
        (lambda x: np.array(x.Pi, dtype=float).sum(), TypeError, "a symbol is no number"),
        (lambda x: x.Pi, TypeError, r"hamiltonian must return a scalar .* an array of shape \(3,\)"),
        (lambda x: None, TypeError, "must return a scalar .* got None"),
        (lambda x: x.Omega, AttributeError, "no coordinate or parameter 'Omega'; there are Pi, Pi1"),
        (lambda x: np.arcsinh(x.Pi1), TypeError, "arcsinh"),
        (lambda x: np.where((x.Pi1 > 0) & (x.Pi2 > 0), 1, 0), TypeError, "conditions cannot be combined"),
        (lambda x: np.where((x.Pi1 > 0) ^ (x.Pi2 > 0), 1, 0), TypeError, "conditions cannot be combined"),
        (lambda x: np.sum(x.Pi1 > 0), TypeError, "condition of numpy.where"),
        (lambda x: np.where((x.Pi1 > 0) == True, x.Pi2, 1), TypeError, "test of equality of a comparison: .*numpy.where"),
        (lambda x: np.where((x.Pi1 > 0) != False, x.Pi2, 1), TypeError, "test of equality of a comparison"),
        (lambda x: np.where((x.Pi > 0) == True, x.Pi, 1).sum(), TypeError, "test of equality of a comparison"),
        (lambda x: np.where(x.Pi1 > 0), TypeError, r"without values to choose from: .*numpy.where\(x.Pi1 > 0, a, b\)"),
        (lambda x: np.where(x.Pi > 0), TypeError, "without values to choose from"),
        (lambda x: (x.Pi1 > 0) * x.Pi2, TypeError, "a comparison of symbols is no number: .*numpy.where"),
        (lambda x: [x.Pi1, x.Pi2][x.Pi1 > 0], TypeError, "a comparison of symbols is no number"),
        (lambda x: np.add(x.Pi, 1, out=np.zeros(3)).sum(), TypeError, r"a = a \+ x.Pi"),
        (lambda x: x.Pi1 / 0, ValueError, "the divisor is 0"),
        (lambda x: x.Pi1 * np.inf, ValueError, "not a finite number"),
        (lambda: 1, TypeError, "argument"),
    ],
)
def test_wrong_functions_say_why(function, error, words):
    with pytest.raises(error, match=words):
        System("so(3)", function)


def test_a_symbol_belongs_to_its_function():
    kept = []
    System("so(3)", lambda x: kept.append(x.Pi1) or x.Pi1)
    with pytest.raises(TypeError, match="symbols of two functions"):
        System("so(3)", lambda x: x.Pi1 + kept[0])
    with pytest.raises(TypeError, match="must return a scalar"):
        System("so(3)", lambda x: kept[0])
