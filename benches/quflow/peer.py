"""Runs quflow's integrators from the start that `zeitlin_costs` has written; prints the same columns.

    peer.py QUFLOW SIZE END FOLDER

Settings are quflow's own: the isospectral midpoint rule by fixed-point iteration with its default tolerance, and its
explicit method of order 4.
"""

import sys
import time

import numpy

quflow_folder, size, end, folder = sys.argv[1], int(sys.argv[2]), float(sys.argv[3]), sys.argv[4]
sys.path.insert(0, quflow_folder)
import quflow  # noqa: E402


def load(name):
    """Reads a matrix, written column by column."""
    return numpy.fromfile(f"{folder}/{name}").view(complex).reshape(size, size).T.copy()


start, reference = load("start.bin"), load("end.bin")


def largest(matrix):
    return max(numpy.abs(matrix.real).max(), numpy.abs(matrix.imag).max())


def run(name, method, rate):
    steps, best, begin = max(1, round(rate * end)), float("inf"), time.perf_counter()
    while True:
        w, now = start.copy(), time.perf_counter()
        method(w, end / steps, steps=steps)
        best = min(best, time.perf_counter() - now)
        if time.perf_counter() - begin > 2:
            break
    error = largest(w - reference) / largest(reference)
    print(f"{name}\t{steps}\t{best:.6f}\t{error:.3e}", flush=True)


# The first call compiles.
for method in (quflow.isomp_fixedpoint, quflow.rk4):
    method(start.copy(), 1e-3, steps=1)
for rate in (32, 64, 192, 512) if size <= 128 else (96, 192, 400):
    run("quflow isomp_fixedpoint", quflow.isomp_fixedpoint, rate)
for rate in (4, 6, 8, 48, 72, 104):
    run("quflow rk4", quflow.rk4, rate)
