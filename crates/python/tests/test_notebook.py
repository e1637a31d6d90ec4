"""The code of the notebook."""

import json
import pathlib

import numpy as np
import pytest

NOTEBOOK = pathlib.Path(__file__).parent.parent / "examples" / "paper.ipynb"


def test_the_notebook_runs_and_shows_what_it_says():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    cells = json.loads(NOTEBOOK.read_text(encoding="utf-8"))["cells"]
    names = {}
    for cell in cells:
        if cell["cell_type"] == "code":
            exec(compile("".join(cell["source"]), str(NOTEBOOK), "exec"), names)
    runs = names["runs"]
    drift = {name: {f: run.deviation(f) for f in run.invariants} for name, run in runs.items()}
    ours, direct = drift["collective, implicit midpoint"], drift["direct, implicit midpoint"]
    # "The collective implicit rule conserves both Casimirs to round-off", and the explicit ones do not
    assert max(ours["f1"], ours["f2"]) < 1e-12
    for name in ("collective, explicit midpoint", "direct, explicit midpoint"):
        assert min(drift[name]["f1"], drift[name]["f2"]) > 1e-3
    # "all quadratic functions", "oscillates four times as much, from peak to peak"
    assert max(direct["h"], direct["f1"], direct["f2"]) < 1e-12
    spans = [float(np.ptp(runs[name].invariants["K"])) for name in list(runs)[3::-3]]
    assert 3.5 < spans[0] / spans[1] < 4.5
    # "conserves everything to round-off"
    assert all(names["best"].deviation(f) < 1e-13 * abs(names["best"].invariants[f][0]) for f in ours)
    # "The returns of Kovalevskaya's top lie on curves", "loses some of them to chaos"
    regular, raised = (names["chaos"][name].megno[:, -1] for name in names["chaos"])
    assert regular.max() < 4 and raised.max() > 10
    assert all(abs(points.y[5]).max() < 1e-12 and points.t.size > 50 for every in names["sections"].values() for points in every)
    # "formula and function", and the Casimir that was found
    same = names["same"].solve(names["swim"].y[:, 0], step=0.1, end=50)
    assert np.abs(same.y - names["swim"].y).max() < 1e-12 and names["swim"].deviation("c1") < 1e-13
    assert names["rotor"].casimirs == {"c1": "H^2 - P^2"}
    assert all(orbit.deviation("c1") < 1e-12 for orbit in names["orbits"])
