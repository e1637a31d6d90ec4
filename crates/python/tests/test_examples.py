"""The programs in `examples`."""

import pathlib
import runpy

import numpy as np
import pytest

EXAMPLES = pathlib.Path(__file__).parent.parent / "examples"


def test_the_constant_of_kovalevskaya_stays_or_drifts_as_the_figure_shows(tmp_path):
    pytest.importorskip("matplotlib")
    pytest.importorskip("scipy")
    names = runpy.run_path(str(EXAMPLES / "kovalevskaya.py"))
    times, values = names["constants"](100.0)
    assert times[0] == 0 and times[-1] == 100 and all(line[0] == pytest.approx(193) for line in values.values())
    ours, runge_kutta, scipy = values.values()
    # Order 8 at a step of a quarter of a radian, against methods that lose parts of a per cent in 100 s.
    assert np.ptp(ours) < 1e-7
    assert min(abs(runge_kutta[-1] - 193), abs(scipy[-1] - 193)) > 0.1
    picture = tmp_path / "picture.png"
    names["draw"](times, values, picture)
    assert picture.stat().st_size > 10_000
