"""What the contestants in Python share: the problem file (see problem.hpp), the clock and the line of JSON."""

import json
import time

import numpy as np


class Problem:
    """A top with run-time parameters, and states (Π, Γ) in rows at times 0, 10 and `end`."""

    def __init__(self, path):
        with open(path) as file:
            numbers = [float(x) for x in file.readline().split()]
            rows = np.array([[float(x) for x in line.split()] for line in file])
        self.inertia = np.array(numbers[:3])
        self.gravity = numbers[3] * np.array(numbers[4:7])
        self.end = numbers[7]
        self.start, self.at_10, self.at_end = rows[:, :6], rows[:, 6:12], rows[:, 12:]


def mean_error(states, reference):
    """The arithmetic mean over the tops of the 2-norm of the state's error."""
    return float(np.mean(np.linalg.norm(states - reference, axis=1)))


def contest(name, setting, problem, integrate):
    """Runs `integrate(start, end) -> states, steps` and prints the result; the best time of at least three runs."""
    at_10, _ = integrate(problem.start, 10.0)
    best, total, repeats = float("inf"), 0.0, 0
    while repeats < 3 or total < 0.5:
        begin = time.perf_counter()
        at_end, steps = integrate(problem.start, problem.end)
        seconds = time.perf_counter() - begin
        best, total, repeats = min(best, seconds), total + seconds, repeats + 1
    result = {"name": name, "setting": setting, "seconds": best, "steps": steps,
              "error_10": mean_error(at_10, problem.at_10),
              f"error_{problem.end:g}": mean_error(at_end, problem.at_end)}
    print(json.dumps(result, ensure_ascii=False), flush=True)
