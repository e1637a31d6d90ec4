"""Statistics of many paths, which are those of the paths one by one, and of the program."""

import csv
import json
import os
import subprocess
import sys

import numpy as np
import pytest

from heavytop import IntegrationError, SphereFluid, SpinLattice, System, solve_paths

WARM = System("so(3)", "-Pi3", damping=1, noise={"temperature": 0.5, "path": 3})
RING = SpinLattice(6, exchange=1.0, damping=1.0, noise={"temperature": 0.5})
UP = {"direction": [0, 0, 1]}


def assert_same(found, values, tolerance):
    """Checks mean, error and deviation of values with one path along the first axis."""
    count = len(values)
    deviation = values.std(axis=0, ddof=1)
    assert np.abs(found.mean - values.mean(axis=0)).max() < tolerance
    assert np.abs(found.deviation - deviation).max() < tolerance
    assert np.abs(found.error - deviation / np.sqrt(count)).max() < tolerance


@pytest.mark.parametrize(("system", "start", "step"), [(WARM, [1, 0, 0], 0.1), (RING, UP, 0.05)])
def test_statistics_are_those_of_the_paths_one_by_one(system, start, step):
    asked = {"step": step, "end": 20 * step, "every": 5}
    found = solve_paths(system, start, paths=12, quantiles=[0.5], **asked)
    first = 3 if system is WARM else 0
    runs = [system.solve(start, path=first + i, estimate=False, **asked) for i in range(12)]
    assert np.array_equal(found.t, runs[0].t) and found.paths == 12
    # Sums of twelve numbers of size 1, and of h of size 6.
    assert_same(found.y, np.array([run.y for run in runs]), 1e-14)
    assert set(found.invariants) == set(system.invariants)
    for symbol, statistics in found.invariants.items():
        assert_same(statistics, np.array([run.invariants[symbol] for run in runs]), 1e-13)
    # The P2 algorithm estimates a median of twelve, which lies among those near it.
    ordered = np.sort([run.y for run in runs], axis=0)
    median = found.y.quantiles[0.5]
    assert (ordered[1] - 1e-13 <= median).all() and (median <= ordered[10] + 1e-13).all()
    # Control: other paths have another mean.
    other = np.array([system.solve(start, path=50 + i, estimate=False, **asked).y[:, -1] for i in range(12)])
    assert np.abs(found.y.mean[:, -1] - other.mean(axis=0)).max() > 1e-3


def test_a_tolerance_costs_no_casimir_without_a_lift():
    asked = {"paths": 12, "step": 0.1, "end": 2, "scheme": "implicit-midpoint"}
    exact = solve_paths(WARM, [1, 0, 0], formulation="reduced", **asked)
    quick = solve_paths(WARM, [1, 0, 0], formulation="reduced", tolerance=1e-4, **asked)
    lifted = solve_paths(WARM, [1, 0, 0], formulation="collective", tolerance=1e-4, **asked)
    apart = np.abs(exact.y.mean - quick.y.mean).max()
    assert 0 < apart < 1e-2
    # Twenty steps, each with some roundings.
    assert np.abs(quick.invariants["c1"].mean - 1).max() < 1e-13 < 1e-9 < np.abs(lifted.invariants["c1"].mean - 1).max()
    with pytest.raises(ValueError, match="tolerance"):
        solve_paths(WARM, [1, 0, 0], formulation="reduced", tolerance=-1, **asked)
    with pytest.raises(ValueError, match="reduced with implicit-midpoint"):
        solve_paths(WARM, [1, 0, 0], formulation="reduced", **{**asked, "scheme": "gauss-4"})


def test_names_give_the_rows_of_runs():
    found = solve_paths(WARM, [1, 0, 0], paths=4, step=0.1, end=0.5, quantiles=[0.1, 0.9])
    assert np.array_equal(found["Pi3"].mean, found.y.mean[2]) and found["Pi"].error.shape == (3, 6)
    assert np.array_equal(found["Pi2"].quantiles[0.9], found.y.quantiles[0.9][1])
    assert list(found.y.quantiles) == [0.1, 0.9] and "4 paths" in repr(found)
    arrays = solve_paths(RING, UP, paths=4, step=0.05, end=0.5)
    assert arrays["S"].deviation.shape == (11, 6, 3)
    assert np.array_equal(arrays["S"].mean.reshape(11, 18), arrays.y.mean.T) and arrays.y.quantiles == {}
    with pytest.raises(KeyError, match="the coordinates are Pi"):
        found["Gamma"]


THREADS = """
import heavytop, sys
warm = heavytop.System("so(3)", "-Pi3", damping=1, noise={"temperature": 0.5})
found = heavytop.solve_paths(warm, [1, 0, 0], paths=600, step=0.1, end=1, every=10, quantiles=[0.9])
sys.stdout.write(" ".join(x.hex() for x in [*found.y.mean.flat, *found.y.error.flat, *found.y.quantiles[0.9].flat]))
"""


def test_the_threads_do_not_matter():
    def on(threads):
        environment = {**os.environ, "RAYON_NUM_THREADS": threads, "PYTHONPATH": os.pathsep.join(sys.path)}
        return subprocess.run([sys.executable, "-c", THREADS], env=environment, capture_output=True, text=True, check=True).stdout

    assert on("1") == on("3") != ""


CONFIGURATION = """
[system]
algebra = "so(3)"
hamiltonian = "-Pi3"
initial.Pi = [1, 0, 0]
[damping]
friction = 1
[noise]
temperature = 0.5
path = 3
[integrator]
step = 0.1
end = 2
[output]
every = 7
"""


def test_the_numbers_are_those_of_the_program(program, tmp_path):
    (tmp_path / "warm.toml").write_text(CONFIGURATION)
    command = [program, "ensemble", "warm.toml", "--paths", "300", "--quantiles", "0.25,0.75", "--out", "means.csv", "--json"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
    with (tmp_path / "means.csv").open() as file:
        rows = list(csv.DictReader(file))
    found = solve_paths(WARM, [1, 0, 0], paths=300, step=0.1, end=2, every=7, quantiles=[0.25, 0.75])
    assert [float(row["t"]) for row in rows] == found.t.tolist()
    for name in ("Pi1", "Pi2", "Pi3", "h", "c1"):
        of = found.invariants[name] if name in found.invariants else found[name]
        parts = {"mean": of.mean, "error": of.error, "deviation": of.deviation, "q0.25": of.quantiles[0.25]}
        for part, values in parts.items():
            # To the bit: the text of a number is read back as the number.
            assert [float(row[f"{name}_{part}"]) for row in rows] == values.tolist(), (name, part)
    assert json.loads(done.stdout)["last"]["Pi3"]["mean"] == found["Pi3"].mean[-1]


def test_what_has_no_statistics_is_refused():
    asked = {"paths": 3, "step": 0.1, "end": 1}
    for wrong, message in [
        ({"paths": 1}, "paths must be a whole number from 2 on"),
        ({"quantiles": [1.5]}, "between 0 and 1, got 1.5"),
        ({"quantiles": [float("nan")]}, "between 0 and 1, got NaN"),
        ({"quantiles": 0.5}, "one-dimensional"),
        ({"every": 0}, "every must be a whole number"),
        ({"end": 1.05}, "not a whole number of steps"),
        ({"paths": 2**53}, "must be below 9007199254740992"),
        ({"step": 1e-7}, "statistics of .* numbers"),
    ]:
        with pytest.raises(ValueError, match=message):
            solve_paths(WARM, [1, 0, 0], **{**asked, **wrong})
    with pytest.raises(ValueError, match="a motion without noise has one path"):
        solve_paths(System("so(3)", "-Pi3", damping=1), [1, 0, 0], **asked)
    with pytest.raises(ValueError, match="a motion without noise has one path"):
        solve_paths(System("so(3)", "-Pi3"), [1, 0, 0], **asked)
    with pytest.raises(ValueError, match="a motion without noise has one path"):
        solve_paths(SphereFluid(4), {"degrees": [1, 2]}, **asked)
    with pytest.raises(ValueError, match="paths are of a system with noise"):
        solve_paths([WARM], [1, 0, 0], **asked)
    with pytest.raises(ValueError, match="y0 is missing"):
        solve_paths(WARM, **asked)


def test_a_path_that_fails_is_named():
    # The field has no value below a height that paths reach one after the other.
    system = System("so(3)", "log(Pi3 - 0.2)", noise={"strength": 0.8, "seed": 2})
    with pytest.raises(IntegrationError, match=r"path \d+: .*step"):
        solve_paths(system, [0.1, 0, 1], paths=200, step=0.05, end=5)
    # The number is that of a run of its own, wherever the ensemble begins.
    later = System("so(3)", "log(Pi3 - 0.2)", noise={"strength": 0.8, "seed": 2, "path": 100})
    with pytest.raises(IntegrationError, match=r"path 1\d\d: .*step") as failed:
        solve_paths(later, [0.1, 0, 1], paths=200, step=0.05, end=5)
    number, reason = str(failed.value).removeprefix("path ").split(": ", 1)
    alone = system.solve([0.1, 0, 1], step=0.05, end=5, path=int(number), estimate=False)
    assert not alone.success and reason.endswith(alone.message)
    with pytest.warns(RuntimeWarning, match="the noise turns the state by about"):
        solve_paths(System("so(3)", "-Pi3", noise={"strength": 2.0}), [1, 0, 0], paths=2, step=0.1, end=1)
