"""Realisations of one's own by matrices."""

import pickle

import numpy as np
import pytest

import heavytop
from heavytop import System

BODY = "(mu1^2 + mu2^2/2 + mu3^2/4)/2"
PAULI = np.array([[[0, 1], [1, 0]], [[0, -1j], [1j, 0]], [[1, 0], [0, -1]]])
START = [1.0, 2.0, 0.5]


def test_complex_matrices_are_a_realisation():
    own = System("su(2)", BODY, representation=-0.5j * PAULI)
    verdict = own.realisation
    assert verdict.bracket == "plus" and verdict.rank == 3 and verdict.descends and verdict.defect < 1e-15
    assert own.formulations[0] == "collective"
    library = System("su(2)", BODY)
    assert library.realisation is None
    run, other = (system.solve(START, step=0.05, end=10, scheme="gauss-12") for system in (own, library))
    assert np.abs(run.y - other.y).max() < 1e-12 and np.abs(run.y[:, -1] - START).max() > 0.1
    assert run.deviation("c1") < 1e-13
    # The other sign is the minus bracket, and makes the same motion.
    minus = System("su(2)", BODY, representation=0.5j * PAULI)
    assert minus.realisation.bracket == "minus"
    assert np.abs(minus.solve(START, step=0.05, end=10, scheme="gauss-12").y - other.y).max() < 1e-12
    assert pickle.loads(pickle.dumps(own)).realisation == verdict


def test_quadratic_momenta_are_a_realisation():
    # q^2/2... of sp(2, R): q^2, q p, p^2 by the matrices of z.S z/2.
    forms = [[[2, 0], [0, 0]], [[0, 1], [1, 0]], [[0, 0], [0, 2]]]
    system = System("sp(2,R)", "Q11^2/4 + P11 + R11^2/3", momenta=forms)
    assert system.realisation.rank == 2 and system.realisation.descends
    # One particle has q^2 p^2 = (q p)^2; a start off that cone is not reached.
    run = system.solve([0.36, 0.3, 0.25], step=0.01, end=2)
    assert run.deviation("c1") < 1e-13 and run.deviation("h") < 1e-8
    with pytest.raises(ValueError, match="not in the image"):
        system.solve([1.0, 2.0, 1.0], step=0.01, end=1)
    # Among many, it is the only one that fails.
    ends = heavytop.solve_many(system, np.array([[1.0, 2.0, 1.0], [0.36, 0.3, 0.25]]).T, step=0.01, end=2)
    assert list(ends.failures) == [0] and "not in the image" in ends.failures[0]
    assert np.array_equal(ends.y[:, 1], run.y[:, -1])


def test_starts_without_a_lift_are_followed_among_those_with_one():
    body = System("se(3)", "(Pi1^2/2 + Pi2^2/3 + Pi3^2)/2 + Gamma1")
    starts = np.array([[1.0, 2.0, 3.0, 0.6, 0.0, 0.8], [1.0, 2.0, 3.0, 0.0, 0.0, 0.0], [2.0, 1.0, 0.0, 0.6, 0.0, 0.8]])
    method = dict(step=0.05, end=2, formulation="reduced", scheme="gauss-4")
    for order in ([0, 1, 2], [1, 0, 2]):
        ends = heavytop.solve_many(body, starts[order].T, **method)
        assert ends.success
        for start, end in zip(starts[order], ends.y.T):
            assert np.abs(body.solve(start, **method).y[:, -1] - end).max() < 1e-13


def test_a_class_of_matrices_by_name_has_collective_methods():
    body = System("so(5)", "L12^2/2 + L13^2/3 + L25*L34/7 + L45^2")
    assert body.formulations[0] == "collective" and body.realisation.rank == 10
    start = 0.3 * np.cos(1.9 * np.arange(10))
    run = body.solve(start, step=0.1, end=10, scheme="gauss-4")
    assert all(run.deviation(name) < 1e-13 for name in body.casimirs)
    direct = body.solve(start, step=0.1, end=10, scheme="gauss-4", formulation="direct")
    assert direct.deviation("c2") > 1e-11


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        (dict(representation=-1j * PAULI), ValueError, "2.000000 times what they should be: divide the matrices by 2.000000"),
        (dict(representation=-0.5j * PAULI[:2]), ValueError, "2 matrices for an algebra of dimension 3"),
        (dict(representation=-0.5j * PAULI * [[[1]], [[1]], [[3]]]), ValueError, r"no Poisson map: \{mu"),
        (dict(representation=np.zeros((3, 2, 3))), ValueError, r"shape \(d, n, n\)"),
        (dict(representation=[["a"]]), ValueError, r"shape \(d, n, n\)"),
        (dict(momenta=-0.5j * PAULI), ValueError, "must be real"),
        (dict(momenta=np.zeros((3, 3, 3))), ValueError, "an odd number"),
        (dict(momenta=np.triu(np.ones((3, 2, 2)))), ValueError, "not symmetric"),
        (dict(momenta=np.full((3, 2, 2), np.nan)), ValueError, "NaN"),
        (dict(momenta=np.zeros((3, 2, 2)), representation=np.zeros((3, 2, 2))), ValueError, "write one of"),
    ],
)
def test_what_is_no_realisation_is_taught(arguments, error, message):
    with pytest.raises(error, match=message):
        System("su(2)", BODY, **arguments)
