"""Writes the table of docs/matrix_hydrodynamics.md between its marks.

    page.py PAGE ROWS...

Each file of rows is named SIZE.ROUND.tsv and has the columns name, steps, seconds, error.
"""

import pathlib
import re
import statistics
import sys

page, files = pathlib.Path(sys.argv[1]), [pathlib.Path(name) for name in sys.argv[2:]]
POISSON = ("exponential midpoint",)
ISOSPECTRAL = ("exponential midpoint", "Gauss–Magnus of order 4", "Gauss–Magnus of order 6")
OURS = ("exponential midpoint", "Gauss–Magnus of order 4", "Gauss–Magnus of order 6", "RK4, direct")
FIXED, EXPLICIT = "quflow isomp_fixedpoint", "quflow rk4"


def rows(path):
    lines = [line.split("\t") for line in path.read_text().splitlines()]
    return [(name, int(steps), float(seconds), float(error)) for name, steps, seconds, error in lines if seconds != "-"]


def best(table, names, target):
    """The least time of a run whose error is at most the target, and how it was reached."""
    reached = [(seconds, name, steps) for name, steps, seconds, error in table if name in names and error <= target]
    if reached:
        seconds, name, steps = min(reached)
        return seconds, f"{name}, {steps} steps"
    if names != (FIXED,):
        raise SystemExit(f"no run of {', '.join(names)} reaches the error {target}")
    # A method of order 2 needs a number of steps in proportion to error^(−1/2). Time per step is that of the last run.
    steps, seconds, error = max((s, t, e) for name, s, t, e in table if name in names)
    factor = (error / target) ** 0.5
    return seconds * factor, f"{names[0]}, {round(steps * factor)} steps, extrapolated"


def main():
    sizes = sorted({int(path.name.split(".")[0]) for path in files})
    out = ["| N | task | ours | quflow | ratio |", "|--:|---|---|---|--:|"]
    for size in sizes:
        rounds = [rows(path) for path in files if path.name.startswith(f"{size}.")]
        for target, ours, peer, task in (
            (1e-3, OURS, FIXED, "error 1e-3, against `isomp_fixedpoint`"),
            (1e-3, ISOSPECTRAL, FIXED, "error 1e-3 with the spectrum, against `isomp_fixedpoint`"),
            (1e-3, POISSON, FIXED, "error 1e-3 by a Poisson map, against `isomp_fixedpoint`"),
            (1e-8, OURS, FIXED, "error 1e-8, against `isomp_fixedpoint`"),
            (1e-3, OURS, EXPLICIT, "error 1e-3, against `rk4`"),
            (1e-8, OURS, EXPLICIT, "error 1e-8, against `rk4`"),
        ):
            pairs = [(best(table, ours, target), best(table, (peer,), target)) for table in rounds]
            ratio = statistics.median(mine[0] / theirs[0] for mine, theirs in pairs)
            (mine, how), (theirs, their_way) = pairs[0]
            their_way = their_way.removeprefix("quflow ")
            out.append(f"| {size} | {task} | {mine:.3g} s ({how}) | {theirs:.3g} s ({their_way}) | {ratio:.2g} |")
    with open("/proc/cpuinfo") as info:
        names = [line.split(":")[1].strip() for line in info if line.startswith("model name")]
    out += ["", f"Measured on one core of {names[0] if names else 'an unknown processor'}, in {len(rounds)} round(s)."]
    text = page.read_text()
    table = "<!-- table: begin -->\n\n" + "\n".join(out) + "\n<!-- table: end -->"
    page.write_text(re.sub(r"<!-- table: begin -->.*<!-- table: end -->", lambda _: table, text, flags=re.S))


main()
