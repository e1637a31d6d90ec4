"""Draws Kovalevskaya's constant K of the paper's top over a long run, by three methods.

K is constant along the exact motion. Usage: ``python kovalevskaya.py PICTURE [END]``. It needs SciPy and Matplotlib.
"""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from scipy.integrate import solve_ivp

import heavytop

STEP = 0.1  # s: a quarter of a radian of the turning body
EVERY = 10  # steps from one sample to the next
START = np.array([2, 3, 4, 0.5, 0, 0.75**0.5])  # Π in kg m²/s, and Γ
TOP = heavytop.Top.kovalevskaya()  # I = (2, 2, 1) kg m², m g l = 1 N m, centre of mass on the first axis


def euler_poisson(_, y):
    """Returns the right-hand sides dΠ/dt = Π × Ω + m g l Γ × c and dΓ/dt = Γ × Ω."""
    momentum, vertical = y[:3], y[3:]
    velocity = momentum / [2, 2, 1]
    return np.r_[np.cross(momentum, velocity) + np.cross(vertical, [1, 0, 0]), np.cross(vertical, velocity)]


def kovalevskaya_constant(y):
    """Returns K = |(Π₁ + iΠ₂)² − 4 (Γ₁ + iΓ₂)|² of this top, in (kg m²/s)⁴."""
    return abs((y[0] + 1j * y[1]) ** 2 - 4 * (y[3] + 1j * y[4])) ** 2


def constants(end):
    """Returns the times of the samples and, by method, K at these times."""

    def run(formulation, scheme):
        return TOP.solve(
            START[:3], START[3:], step=STEP, end=end, every=EVERY, formulation=formulation, scheme=scheme
        )

    ours = run("collective", "gauss-8")
    conventional = solve_ivp(euler_poisson, (0, end), START, t_eval=ours.t)
    return ours.t, {
        "heavytop, Gauss's method of order 8": ours.invariants["K"],
        "RK4 with the same step": run("direct", "rk4").invariants["K"],
        "SciPy's solve_ivp with its default settings": kovalevskaya_constant(conventional.y),
    }


def draw(times, values, path):
    """Draws K against time."""
    figure, axes = plt.subplots(figsize=(8, 4), layout="constrained")
    for (name, line), colour, width in zip(values.items(), ["#d55e00", "#0072b2", "#666666"], [2.5, 1, 1]):
        axes.plot(times, line, color=colour, lw=width, label=name)
    axes.set(xlabel="time (s)", ylabel="Kovalevskaya's constant K", xlim=(0, times[-1]))
    axes.set_title(f"A top turns for {times[-1]:g} s. The exact motion keeps K = 193.", loc="left")
    axes.legend(frameon=False, loc="lower left")
    axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(path, dpi=160)


if __name__ == "__main__":
    times, values = constants(float(sys.argv[2]) if len(sys.argv) > 2 else 1000.0)
    for name, line in values.items():
        print(f"{name}: K changes by {abs(line - line[0]).max():.2g}")
    draw(times, values, sys.argv[1])
