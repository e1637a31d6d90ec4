"""Compares systems that a user of Python writes as a formula with heyoka's Taylor integrator, at equal error, and writes the
table at the top of docs/performance.md.

    python -m venv VENV && VENV/bin/pip install -r benches/peers/requirements.txt ./crates/python
    VENV/bin/python benches/peers/formulas.py [--page] [--rounds N]

Both make one run to t = 1000 on one core and return its last state. heyoka compiles the equations with their numbers, which
takes a part of a second and is not counted; `System` compiles nothing. Each has its fastest setting whose error at t = 10 is
below the target; `System` has one that solves its stages to round-off, as it does by itself, and one that stops at a tolerance.
The settings take turns, and a time is the median of the rounds.
"""

import argparse
import statistics
import time
import warnings
from pathlib import Path

import heyoka
import numpy as np

from heavytop import System, Top

END = 1000.0
TARGETS = (2e-14, 1e-9)
STEPS = {
    "gauss-16": (0.2, 2 / 9, 0.25, 5 / 18, 0.3125, 1 / 3, 0.4, 0.5, 1.0, 1.25, 2.0, 2.5, 10 / 3, 5.0),
    "gauss-12": (0.1, 0.125, 0.2, 0.25),
    "gauss-8": (0.02, 0.04, 0.05, 0.0625, 0.1),
}
# `direct` keeps linear and quadratic Casimirs, and its steps are no Poisson maps.
FORMULATIONS = ("collective", "reduced", "direct")
SETTINGS = [(scheme, h) for scheme, steps in STEPS.items() for h in steps]
# Relative changes of the stages at which their iteration stops. 0 is round-off.
STOPS = (1e-14, 1e-13, 1e-12, 1e-11, 1e-10)
TOLERANCES = (1e-16, 3e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10)


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def add(*vectors):
    return [sum(parts[1:], parts[0]) for parts in zip(*vectors)]


def body_in_fields(omega, forces):
    """Π' = Π × Ω + Σ Γ_k × ∂h/∂Γ_k, Γ_k' = Γ_k × Ω."""

    def equations(x):
        vectors = [x[i : i + 3] for i in range(0, len(x), 3)]
        momentum, fields = vectors[0], vectors[1:]
        turn = omega(momentum, *fields)
        pulls = [cross(field, force) for field, force in zip(fields, forces(momentum, *fields))]
        rates = [add(cross(momentum, turn), *pulls), *(cross(field, turn) for field in fields)]
        return [rate for vector in rates for rate in vector]

    return equations


def body_on_so4(x):
    """L' = [ω, L] with ω_ij = L_ij/c_ij."""
    pairs = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)]
    zero = 0.0 * x[0]
    momentum, turn = ([[zero] * 4 for _ in range(4)] for _ in range(2))
    for (i, j), entry, inverse in zip(pairs, x, (1 / 2, 1 / 3, 1 / 4, 1 / 5, 1 / 6, 1 / 7)):
        momentum[i][j], momentum[j][i] = entry, -entry
        turn[i][j], turn[j][i] = entry * inverse, -entry * inverse

    def product(a, b, i, j):
        return sum((a[i][k] * b[k][j] for k in range(4) if k not in (i, j)), zero)

    return [product(turn, momentum, i, j) - product(momentum, turn, i, j) for i, j in pairs]


def number(x):
    return heyoka.expression(x)


HALF = 0.5 * 3**0.5
BODY = "(Pi1^2/2 + Pi2^2/3 + Pi3^2)/2"
TURN = lambda p, *fields: [p[0] * 0.5, p[1] * (1 / 3), p[2]]  # noqa: E731


class TopAsSystem:
    """The first system by its kernel, for comparison."""

    top = Top.kovalevskaya()

    def solve(self, start, **settings):
        return self.top.solve(start[:3], start[3:], **settings)

    def rate(self, state):
        return SYSTEMS["Kovalevskaya's top"][0].rate(state)


KOVALEVSKAYA = body_in_fields(
    lambda p, g: [p[0] * 0.5, p[1] * 0.5, p[2]], lambda p, g: [[number(1.0), number(0.0), number(0.0)]]
)
SYSTEMS = {
    "Kovalevskaya's top, as a `Top`": (TopAsSystem(), [2, 3, 4, 0.5, 0, HALF], KOVALEVSKAYA),
    "Kovalevskaya's top": (
        System("se(3)", "(Pi1^2/2 + Pi2^2/2 + Pi3^2)/2 + Gamma1"),
        [2, 3, 4, 0.5, 0, HALF],
        KOVALEVSKAYA,
    ),
    "Kirchhoff's body in a fluid": (
        System("se(3)", BODY + " + (Gamma1^2 + Gamma2^2/2 + Gamma3^2/3)/2 + Pi1*Gamma2/10"),
        [2, 3, 4, 0.5, 0, HALF],
        body_in_fields(
            lambda p, g: [p[0] * 0.5 + g[1] * 0.1, p[1] * (1 / 3), p[2]],
            lambda p, g: [[g[0], g[1] * 0.5 + p[0] * 0.1, g[2] * (1 / 3)]],
        ),
    ),
    "body in a periodic field": (
        System("se(3)", BODY + " + cos(Gamma1) + sin(Gamma2)*Gamma3"),
        [2, 3, 4, 0.5, 0, HALF],
        body_in_fields(TURN, lambda p, g: [[-heyoka.sin(g[0]), heyoka.cos(g[1]) * g[2], heyoka.sin(g[1])]]),
    ),
    "body on so(4)": (
        System("so(4)", "(L12^2/2 + L13^2/3 + L14^2/4 + L23^2/5 + L24^2/6 + L34^2/7)/2"),
        [1, 0.5, 0.3, 0.2, 0.1, 0.7],
        body_on_so4,
    ),
    "body in two fields": (
        System("so(3) ⋉ (R3 + R3)", BODY + " + Gamma_1_1 + Gamma_2_2/2 + Gamma_1_3*Gamma_2_1/3"),
        [2, 3, 4, 0.5, 0, HALF, 0, 1, 0],
        body_in_fields(
            TURN,
            lambda p, g, d: [[number(1.0), number(0.0), d[0] * (1 / 3)], [g[2] * (1 / 3), number(0.5), number(0.0)]],
        ),
    ),
}


def taylor(equations, start, tolerance, **kind):
    x = heyoka.make_vars(*(f"x{i}" for i in range(len(start))))
    return heyoka.taylor_adaptive(list(zip(x, equations(x))), start, tol=tolerance, **kind)


def same_equations(system, equations, start):
    """Whether heyoka integrates the equations of the system, to round-off."""
    x = heyoka.make_vars(*(f"x{i}" for i in range(len(start))))
    values = heyoka.cfunc(equations(x), x)(np.array(start, dtype=float))
    return np.allclose(values, system.rate(start), rtol=1e-14, atol=1e-14)


def ours(system, start, formulation, scheme, step, stop=0):
    def run(end):
        count, method = round(end / step), {"formulation": formulation, "scheme": scheme, "tolerance": stop}
        return system.solve(start, step=step, end=count * step, every=count, estimate=False, **method).y[:, -1]

    return run


def theirs(equations, start, tolerance):
    integrator = taylor(equations, start, tolerance)

    def run(end):
        integrator.time = 0.0
        integrator.state[:] = start
        integrator.propagate_until(end)
        return integrator.state.copy()

    return run


def error(run, reference):
    """The error of a setting at t = 10; infinite if its steps fail."""
    try:
        return np.linalg.norm(run(10.0) - reference)
    except ValueError:
        return np.inf


def measure(rounds):
    """Yields the rows (system, target, our setting to round-off, ms, our setting with a tolerance, ms, heyoka's tolerance, ms)."""
    for name, (system, start, equations) in SYSTEMS.items():
        assert same_equations(system, equations, start), name
        exact = taylor(equations, np.array(start, dtype=np.longdouble), np.longdouble(1e-19), fp_type=np.longdouble)
        exact.propagate_until(np.longdouble(10))
        reference = exact.state.astype(float)
        # What is nearly as slow for each step is not tried in all formulations: the first that there is, and `direct`.
        known = [name for name in FORMULATIONS if error(ours(system, start, name, "gauss-16", 0.1), reference) < 1e-9]
        formulations = dict.fromkeys([known[0], known[-1]])
        whole = {
            f"{formulation} {scheme}, h = {step:.4g}": ours(system, start, formulation, scheme, step)
            for formulation in formulations
            for scheme, step in SETTINGS
        }
        early = {
            f"{formulation} {scheme}, h = {step:.4g}, {stop:g}": ours(system, start, formulation, scheme, step, stop)
            for formulation in formulations
            for scheme, step in SETTINGS
            if scheme == "gauss-16"
            for stop in STOPS
        }
        groups = [whole, early, {f"{tolerance:g}": theirs(equations, start, tolerance) for tolerance in TOLERANCES}]
        errors = [{key: error(run, reference) for key, run in runs.items()} for runs in groups]
        clock = {key: [] for runs in groups for key in runs}
        for _ in range(rounds):
            for runs, of in zip(groups, errors):
                for key in (key for key in runs if of[key] <= max(TARGETS)):
                    begin = time.perf_counter()
                    runs[key](END)
                    clock[key].append(time.perf_counter() - begin)
        for target in TARGETS:
            row = [name, target]
            for runs, of in zip(groups, errors):
                good = [(1e3 * statistics.median(clock[key]), key) for key in runs if of[key] <= target]
                row += min(good)[::-1] if good else ("none", float("nan"))
            yield row


def table(rounds):
    lines = [
        "| formula | error at t = 10 | to round-off | ms | with a tolerance | ms | heyoka's tolerance | ms | ratios |",
        "|---|--:|---|--:|---|--:|--:|--:|--:|",
    ]
    for name, target, setting, ms, stopped, less, tolerance, other in measure(rounds):
        lines.append(
            f"| {name} | {target:g} | {setting} | {ms:.2f} | {stopped} | {less:.2f} | {tolerance} | {other:.2f} "
            f"| {ms / other:.2f}, {less / other:.2f} |"
        )
        print(lines[-1], flush=True)
    return lines


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--page", action="store_true", help="write the table into docs/performance.md")
    arguments.add_argument("--rounds", type=int, default=7)
    given = arguments.parse_args()
    warnings.simplefilter("ignore", RuntimeWarning)  # of steps that are long on purpose
    lines = table(given.rounds)
    if given.page:
        page = Path(__file__).parents[2] / "docs" / "performance.md"
        before, rest = page.read_text(encoding="utf-8").split("<!-- formulas: begin -->")
        _, after = rest.split("<!-- formulas: end -->")
        text = "\n".join(["<!-- formulas: begin -->", "", *lines, "", "<!-- formulas: end -->"])
        page.write_text(before + text + after, encoding="utf-8")


if __name__ == "__main__":
    main()
