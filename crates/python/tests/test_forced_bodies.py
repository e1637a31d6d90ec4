"""Bodies with forces of their own: means of Gibbs, and the balance of energy."""

import pickle

import numpy as np
import pytest

from heavytop import DrivenTop, RigidBody, StochasticRigidBody, System, solve_many


def gibbs_mean(beta):
    """Returns the mean of h over |Pi| = 2 for the moments (2, 3, 4), by Gauss's and the trapezoidal rule."""
    z, weights = np.polynomial.legendre.leggauss(60)
    angle = np.arange(128) * 2 * np.pi / 128
    across = 4 * (1 - z * z)[:, None]
    h = (across * (np.cos(angle) ** 2 / 2 + np.sin(angle) ** 2 / 3) + z[:, None] ** 2) / 2
    boltzmann = weights[:, None] * np.exp(-beta * h)
    return (h * boltzmann).sum() / boltzmann.sum()


def test_a_stochastic_rigid_body_has_the_energy_of_gibbs():
    body = StochasticRigidBody([2.5, 1.5, 0.5], friction=2, temperature=0.2, noise={"seed": 5})
    ends = solve_many(body, np.tile([[2.0], [0], [0]], 2000), step=0.05, end=4, scheme="implicit-midpoint")
    h = body.invariant_values(ends.y)["h"]
    error = h.std() / np.sqrt(2000)
    assert abs(h.mean() - gibbs_mean(5)) < 4 * error
    # Controls: the mean of other temperatures.
    assert all(abs(h.mean() - gibbs_mean(beta)) > 8 * error for beta in (0, 2.5, 10))
    assert ends.deviation("c1").max() < 1e-12
    # It is the body with its damping and noise, to the bit.
    same = RigidBody([2.5, 1.5, 0.5], damping=2, noise={"seed": 5, "temperature": 0.2})
    setting = {"step": 0.05, "end": 1, "scheme": "implicit-midpoint", "path": 7}
    assert np.array_equal(body.solve([2, 0, 0], **setting).y, same.solve([2, 0, 0], **setting).y)
    assert np.array_equal(pickle.loads(pickle.dumps(body)).solve([2, 0, 0], **setting).y, same.solve([2, 0, 0], **setting).y)


def test_a_driven_top_is_the_system_with_its_torque_and_balances_its_energy():
    inertia, friction = [0.3, 0.25, 0.2], 0.05
    top = DrivenTop(inertia, 2, [0, 0, 1], friction, motor=[0.1, "0.2*cos(t)", "u*I3"], inputs={"u": ([0, 2, 4], [1, 0, 3], "linear")})
    start = {"Pi": [0.1, 0.2, 1], "Gamma": [0.6, 0, 0.8]}
    run = top.solve(start, step=0.01, end=4)
    omega = run.y[:3] / np.array(inertia)[:, None]
    motor = [np.full(run.t.shape, 0.1), 0.2 * np.cos(run.t), 0.2 * np.interp(run.t, [0, 2, 4], [1, 0, 3])]

    def work(k):
        power = (motor * omega).sum(axis=0) - k * (omega**2).sum(axis=0)
        return 0.01 / 3 * (power[:-2:2] + 4 * power[1:-1:2] + power[2::2]).sum()

    h = run.invariants["h"]
    # Simpson's rule, with steps of a tenth of a radian at most.
    assert abs(work(friction) - (h[-1] - h[0])) < 1e-6 * np.ptp(h)
    assert abs(work(1.01 * friction) - (h[-1] - h[0])) > 1e-4 * np.ptp(h)
    assert run.kept == ("c2",) and run.deviation("c2") < 1e-12 and run.deviation("c1") > 0.1
    # Without a motor and friction it is a top.
    free = DrivenTop(inertia, 2, [0, 0, 1], 0).solve(start, step=0.01, end=1)
    closed = System("se(3)", "Pi1^2/0.6 + Pi2^2/0.5 + Pi3^2/0.4 + 2*Gamma3").solve(start, step=0.01, end=1)
    assert np.abs(free.y - closed.y).max() < 1e-12


def test_wrong_bodies_are_refused():
    with pytest.raises(ValueError, match="friction must be 0 or a positive number, it is -0.1"):
        DrivenTop([1, 1, 1], 1, [0, 0, 1], -0.1)
    with pytest.raises(ValueError, match="motor must have 3 numbers or formulas, got 2"):
        DrivenTop([1, 1, 1], 1, [0, 0, 1], 0.1, motor=[0, 0])
    with pytest.raises(ValueError, match="there is no `nothing`"):
        DrivenTop([1, 1, 1], 1, [0, 0, 1], 0.1, motor=[0, 0, "nothing"])
    with pytest.raises(ValueError, match="temperature must be finite, got nan"):
        StochasticRigidBody([1, 1, 1], 1, np.nan)
    with pytest.raises(ValueError, match="friction"):
        StochasticRigidBody([1, 1, 1], -1, 1)


def test_a_driven_top_takes_tables_as_motors():
    table = ([0, 2, 4], [1, 0, 3], "linear")
    setting = {"step": 0.01, "end": 4}
    start = {"Pi": [0.1, 0.2, 1], "Gamma": [0.6, 0, 0.8]}
    by_table = DrivenTop([0.3, 0.25, 0.2], 2, [0, 0, 1], 0.05, motor=[0, "0.2*cos(t)", table]).solve(start, **setting)
    by_input = DrivenTop([0.3, 0.25, 0.2], 2, [0, 0, 1], 0.05, motor=[0, "0.2*cos(t)", "u"], inputs={"u": table}).solve(start, **setting)
    assert np.array_equal(by_table.y, by_input.y)
    # Control: another table.
    other = DrivenTop([0.3, 0.25, 0.2], 2, [0, 0, 1], 0.05, motor=[0, "0.2*cos(t)", (*table[:2], "constant")]).solve(start, **setting)
    assert np.abs(other.y - by_input.y).max() > 0.1


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (([1, 1, 1], 1, [0, 0, 2], 0), "center_of_mass must be a unit vector to within 1e-9, its length is 2.0"),
        (([1, 1, 1], 1, [0, 1], 0), "center_of_mass must have three components"),
        (([1, -1, 1], 1, [0, 0, 1], 0), r"inertia\[1\] must be positive, got -1.0"),
        (([1, 1, 0], 1, [0, 0, 1], 0), r"inertia\[2\] must be positive, got 0.0"),
        (([1, 1, 3], 1, [0, 0, 1], 0), "3"),
        (([1, 1, 1], -1, [0, 0, 1], 0), "weight_moment must be 0 or a positive number, it is -1"),
        (([1, 1, 1], 1, [0, 0, 1], 0, [0, 0, lambda x: x.Pi1]), r"motor\[2\] must be a number, a formula or a table, got <function"),
        (([1, 1, 1], 1, [0, 0, 1], 0, lambda x: x.Pi), "motor must be three numbers, formulas or tables, got <function"),
        (([1, 1, 1], 1, [0, 0, 1], 0, [0, 0, ([0, 1], [1], "linear")]), "motor_3"),
    ],
)
def test_bodies_and_motors_that_are_none_are_refused(arguments, message):
    with pytest.raises(ValueError, match=message):
        DrivenTop(*arguments)


def test_an_input_does_not_hide_behind_the_table_of_a_motor():
    table = ([0, 1], [1, 1], "linear")
    with pytest.raises(ValueError, match="inputs\\['motor_1'\\] has the name of the table of a motor"):
        DrivenTop([1, 1, 1], 1, [0, 0, 1], 0, motor=[table, 0, 0], inputs={"motor_1": table})
