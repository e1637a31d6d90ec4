"""Measures SciPy's DOP853 on one top, with the equations in plain Python.

    scipy_peer.py PROBLEM
"""

import sys

from scipy.integrate import solve_ivp

from contest import Problem, contest


def main():
    problem = Problem(sys.argv[1])
    i1, i2, i3 = (float(x) for x in 1 / problem.inertia)
    c1, c2, c3 = (float(x) for x in problem.gravity)

    def heavy_top(_, y):
        p1, p2, p3, g1, g2, g3 = y.tolist()
        w1, w2, w3 = i1 * p1, i2 * p2, i3 * p3
        return (p2 * w3 - p3 * w2 + g2 * c3 - g3 * c2, p3 * w1 - p1 * w3 + g3 * c1 - g1 * c3,
                p1 * w2 - p2 * w1 + g1 * c2 - g2 * c1, g2 * w3 - g3 * w2, g3 * w1 - g1 * w3, g1 * w2 - g2 * w1)

    def integrate(start, end):
        solution = solve_ivp(heavy_top, (0, end), start[0], method="DOP853", rtol=1e-12, atol=1e-12, t_eval=(end,))
        assert solution.success, solution.message
        return solution.y.T, solution.nfev // 12

    contest("SciPy DOP853", "tolerance 1e-12", problem, integrate)


if __name__ == "__main__":
    main()
