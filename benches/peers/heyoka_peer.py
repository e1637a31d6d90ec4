"""Measures heyoka's adaptive Taylor integrator, compiled at run time, with the top's parameters given at run time, and
with the parameters compiled in as numbers.

    heyoka_peer.py PROBLEM          one top on one core, or an ensemble in batches, as the file has it
"""

import sys

import heyoka
import numpy as np

from contest import Problem, contest

# heyoka recommends 4 where AVX-512 is there too, and 8 is faster: with AVX2 it then takes two registers.
BATCH = 8


def heavy_top(parameters):
    """Π' = Π×Ω + Γ×γ, Γ' = Γ×Ω for the parameters (1/I, γ)."""
    momentum = heyoka.make_vars("p0", "p1", "p2")
    vertical = heyoka.make_vars("g0", "g1", "g2")
    velocity = [momentum[i] * parameters[i] for i in range(3)]
    gravity = parameters[3:]

    def cross(a, b, i):
        j, k = (i + 1) % 3, (i + 2) % 3
        return a[j] * b[k] - a[k] * b[j]

    return ([(momentum[i], cross(momentum, velocity, i) + cross(vertical, gravity, i)) for i in range(3)]
            + [(vertical[i], cross(vertical, velocity, i)) for i in range(3)])


def compiled_in(parameters):
    """The parameters as numbers in the equations, and those that are left for the run: none."""
    return [heyoka.expression(float(x)) for x in parameters], np.empty(0)


def at_run_time(parameters):
    """The parameters as par[0], …, par[5] in the equations, and their values for the run."""
    return [heyoka.par[i] for i in range(len(parameters))], parameters


KINDS = {"heyoka": at_run_time, "heyoka, compiled parameters": compiled_in}


def one_top(name, problem, parameters, tolerance):
    equations, left = KINDS[name](parameters)
    integrator = heyoka.taylor_adaptive(heavy_top(equations), problem.start[0], tol=tolerance, pars=left)

    def integrate(start, end):
        integrator.time = 0.0
        integrator.state[:] = start[0]
        outcome, _, _, steps, *_ = integrator.propagate_until(end)
        assert outcome == heyoka.taylor_outcome.time_limit, outcome
        return integrator.state[np.newaxis].copy(), steps

    contest(name, f"tolerance {tolerance:g}", problem, integrate)


def ensemble(name, problem, parameters, tolerance, batch):
    tops = len(problem.start)
    assert tops % batch == 0
    equations, left = KINDS[name](parameters)
    integrator = heyoka.taylor_adaptive_batch(heavy_top(equations), problem.start[:batch].T.copy(), tol=tolerance,
                                              pars=np.repeat(left[:, np.newaxis], batch, axis=1))

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

    contest(f"{name}, batch {batch}", f"tolerance {tolerance:g}", problem, integrate)


def main():
    problem = Problem(sys.argv[1])
    parameters = np.concatenate([1 / problem.inertia, problem.gravity])
    for name in KINDS:
        if len(problem.start) == 1:
            for tolerance in (1e-9, 1e-13, 1e-15, 1e-16):
                one_top(name, problem, parameters, tolerance)
        else:
            for tolerance in (1e-10, 1e-11, 1e-12, 1e-13, 1e-16):
                ensemble(name, problem, parameters, tolerance, BATCH)


if __name__ == "__main__":
    main()
