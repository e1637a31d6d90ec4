"""Processes that are forked: every function that uses threads, whether the parent used them before or not."""

import os
import subprocess
import sys

import pytest

PROGRAM = """
import multiprocessing
import sys
import numpy as np
import heavytop

top = heavytop.Top.kovalevskaya()
body = heavytop.System("so(3)", "(Pi1^2 + Pi2^2/2 + Pi3^2/4)/2")
# More members than one thread takes at a time.
many = np.tile([[2.0], [3.0], [4.0], [0.6], [0.0], [0.8]], 300)
turns = np.tile([[1.0], [2.0], [0.5]], 300)
few = many[:, :4]
calls = {
    "states of a top": lambda: heavytop.solve_many(top, many, step=0.1, end=0.3, scheme="implicit-midpoint").y,
    "states by Gauss": lambda: heavytop.solve_many(top, many, step=0.1, end=0.3, scheme="gauss-8").y,
    "tops": lambda: heavytop.solve_many([top] * 300, many, step=0.1, end=0.3, scheme="implicit-midpoint").y,
    "states of a system": lambda: heavytop.solve_many(body, turns, step=0.1, end=0.3).y,
    "chaos of tops": lambda: heavytop.lyapunov(top, few, step=0.1, end=0.3).exponents,
    "check of a top": lambda: np.array(top.solve([2, 3, 4], [0.6, 0, 0.8], step=0.1, end=1).check()),
    "check of a system": lambda: np.array(body.solve([1, 2, 0.5], step=0.1, end=1).check()),
    "chaos of a system": lambda: heavytop.lyapunov(body, turns[:, :4], step=0.1, end=0.3).exponents,
}
parent_is_first = sys.argv[2] == "parent"


def call(_=0):
    return calls[sys.argv[1]]()


def pooled():
    with multiprocessing.get_context("fork").Pool(2) as pool:
        return pool.map_async(call, range(4)).get(timeout=60)


if __name__ == "__main__":
    own = call() if parent_is_first else None
    children = pooled()
    again = pooled()
    after = call()
    results = [*children, *again, after] + ([own] if parent_is_first else [])
    assert all(np.array_equal(result, after) for result in results)
    print("done", len(results))
"""

CALLS = (
    "states of a top",
    "states by Gauss",
    "tops",
    "states of a system",
    "chaos of tops",
    "chaos of a system",
    "check of a top",
    "check of a system",
)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system does not fork")
@pytest.mark.parametrize("first", ["parent", "child"])
@pytest.mark.parametrize("name", CALLS)
def test_a_forked_process_has_threads_of_its_own(name, first):
    # With more threads than one every call would wait for threads that the child does not have.
    settings = {**os.environ, "RAYON_NUM_THREADS": "2"}
    # Without them the children never return, and the process is ended.
    done = subprocess.run(
        [sys.executable, "-W", "ignore::DeprecationWarning", "-c", PROGRAM, name, first],
        env=settings,
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout == f"done {10 if first == 'parent' else 9}\n"
