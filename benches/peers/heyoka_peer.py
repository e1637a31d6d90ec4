"""Measures heyoka's adaptive Taylor integrator, compiled at run time, with the top's parameters given at run time.

    heyoka_peer.py PROBLEM          one top on one core, or an ensemble in batches, as the file has it
"""

import sys

import heyoka
import numpy as np

from contest import Problem, contest

# heyoka recommends 4 where AVX-512 is there too, and 8 is faster: with AVX2 it then takes two registers.
BATCH = 8


def heavy_top():
    """Π' = Π×Ω + Γ×γ, Γ' = Γ×Ω with par[0..3] = 1/I and par[3..6] = γ."""
    momentum = heyoka.make_vars("p0", "p1", "p2")
    vertical = heyoka.make_vars("g0", "g1", "g2")
    velocity = [momentum[i] * heyoka.par[i] for i in range(3)]
    gravity = [heyoka.par[3 + i] for i in range(3)]

    def cross(a, b, i):
        j, k = (i + 1) % 3, (i + 2) % 3
        return a[j] * b[k] - a[k] * b[j]

    return ([(momentum[i], cross(momentum, velocity, i) + cross(vertical, gravity, i)) for i in range(3)]
            + [(vertical[i], cross(vertical, velocity, i)) for i in range(3)])


def one_top(problem, parameters, tolerance):
    integrator = heyoka.taylor_adaptive(heavy_top(), problem.start[0], tol=tolerance, pars=parameters)

    def integrate(start, end):
        integrator.time = 0.0
        integrator.state[:] = start[0]
        outcome, _, _, steps, *_ = integrator.propagate_until(end)
        assert outcome == heyoka.taylor_outcome.time_limit, outcome
        return integrator.state[np.newaxis].copy(), steps

    contest("heyoka", f"tolerance {tolerance:g}", problem, integrate)


def ensemble(problem, parameters, tolerance, batch):
    tops = len(problem.start)
    assert tops % batch == 0
    integrator = heyoka.taylor_adaptive_batch(heavy_top(), problem.start[:batch].T.copy(), tol=tolerance,
                                              pars=np.repeat(parameters[:, np.newaxis], batch, axis=1))

    def integrate(start, end):
        states, steps = np.empty_like(start), 0
        for first in range(0, tops, batch):
            integrator.set_time(0.0)
            integrator.state[:] = start[first:first + batch].T
            integrator.propagate_until(end)
            assert all(result[0] == heyoka.taylor_outcome.time_limit for result in integrator.propagate_res)
            states[first:first + batch] = integrator.state.T
            steps += sum(result[3] for result in integrator.propagate_res)
        return states, round(steps / tops)

    contest(f"heyoka, batch {batch}", f"tolerance {tolerance:g}", problem, integrate)


def main():
    problem = Problem(sys.argv[1])
    parameters = np.concatenate([1 / problem.inertia, problem.gravity])
    if len(problem.start) == 1:
        for tolerance in (1e-9, 1e-13, 1e-15, 1e-16):
            one_top(problem, parameters, tolerance)
    else:
        for tolerance in (1e-10, 1e-11, 1e-12, 1e-13, 1e-16):
            ensemble(problem, parameters, tolerance, BATCH)


if __name__ == "__main__":
    main()
