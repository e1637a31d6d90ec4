"""Draws docs/performance.png: computing time against error, for one top and for ensembles.

    python chart.py

draws it anew from the tables of docs/performance.md. `page` calls it with what was measured.
"""

import re
from fnmatch import fnmatchcase
from pathlib import Path

# The colours of Okabe & Ito, which colour-blind readers tell apart. Each stands for one method in every panel.
BLUE, SKY, GREEN, VERMILLION, PURPLE, ORANGE = "#0072B2", "#56B4E9", "#009E73", "#D55E00", "#CC79A7", "#E69F00"
BLACK, GREY = "#000000", "#777777"
LEFT, RIGHT = -1, 1

# (label, its side of the line, patterns of the names, colour, marker). Ours have discs, and a general integrator has the
# colour of its kernel and an empty disc.
SERIES = [
    ("Gauss-16", LEFT, ("heavytop collective Gauss-16", "heavytop Gauss-16"), BLUE, "o"),
    ("Gauss-16, any system", RIGHT, ("heavytop any system: Gauss-16",), BLUE, "empty"),
    ("splittings, symmetric tops", RIGHT, ("heavytop splitting of order *",), GREEN, "o"),
    ("midpoint", LEFT, ("heavytop lift-free midpoint",), SKY, "o"),
    ("midpoint, any Hamiltonian", LEFT, ("heavytop any Hamiltonian: midpoint",), SKY, "empty"),
    ("RK4, any system", RIGHT, ("heavytop any system: RK4, direct",), ORANGE, "empty"),
    ("RK4, C++", RIGHT, ("C++ RK4",), ORANGE, "s"),
    ("RK8, C++", RIGHT, ("C++ RK8, vectors", "C++ SIMD RK8"), VERMILLION, "s"),
    ("IRKGL16, C++", RIGHT, ("C++ IRKGL16*",), GREY, "^"),
    ("midpoint, C++", LEFT, ("C++ implicit midpoint, vectors", "C++ SIMD implicit midpoint"), PURPLE, "s"),
    ("heyoka", RIGHT, ("heyoka", "heyoka, batch*"), BLACK, "D"),
]


def chosen(points):
    """The series of one panel, from a dictionary {name: [(error, microseconds)]}: those on the front of each."""
    for label, side, patterns, colour, marker in SERIES:
        own = [point for name, found in points.items() if any(fnmatchcase(name, p) for p in patterns) for point in found]
        front = [a for a in own if not any(b != a and b[0] <= a[0] and b[1] <= a[1] for b in own)]
        if front:
            yield label, side, sorted(front), colour, marker


def draw(path, titles, panels):
    """Draws one panel for each title, from {problem: {name: [(error, microseconds for one time unit)]}}."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(2, 2, figsize=(13, 11), layout="constrained", sharex=True, sharey="row")
    for panel, (problem, title) in zip(axes.flat, titles.items()):
        ensemble = problem.endswith("ensemble")
        ends = []
        for label, side, points, colour, marker in chosen(panels.get(problem, {})):
            empty = marker == "empty"
            panel.loglog(*zip(*points), marker="o" if empty else marker, markersize=7, color=colour,
                         markerfacecolor="white" if empty else colour, linestyle=":" if empty else "-",
                         linewidth=2.5 if marker == "o" else 1.5)
            ends.append((label, side, points[-1 if side == RIGHT else 0]))
        panel.set(title=title, xlim=(1e-17, 1))
        panel.set_xticks([10.0 ** n for n in range(-14, 1, 2)])
        panel.grid(alpha=0.3)
        if problem in list(titles)[2:]:
            panel.set_xlabel("error of (Π, Γ) at t = 10, 2-norm")
        panel.set_ylabel("µs for one time unit" + (" of one top" if ensemble else ""))
        panel.yaxis.set_tick_params(labelleft=True)
        figure.canvas.draw()
        write_labels(panel, ends)
    figure.savefig(path, dpi=100)


def write_labels(panel, ends):
    """Writes each label beside the end of its line, moved up or down where another one is in the way."""
    height, gap, placed = 15, 12, []
    for label, side, point in sorted(ends, key=lambda end: end[2][1]):
        x, y = panel.transData.transform(point)
        width = 7.2 * len(label)
        left = x + gap if side == RIGHT else x - gap - width
        moves = sorted(range(-12, 13), key=abs)
        free = (y + n * height / 2 for n in moves if not any(
            abs(y + n * height / 2 - v) < height and left < u + w and u < left + width for u, v, w in placed))
        level = next(free, y)
        placed.append((left, level, width))
        points = 72 / panel.figure.dpi
        panel.annotate(label, point, xytext=(side * gap * points, (level - y) * points), textcoords="offset points",
                       ha="left" if side == RIGHT else "right", va="center", fontsize=9.5, color="#222222")


def read(page, titles):
    """The panels of `draw`, from the tables of the page."""
    panels = {}
    for problem, title in titles.items():
        section = page.split(f"### {title}\n", 1)[1].split("\n###", 1)[0]
        points = panels.setdefault(problem, {})
        for line in section.splitlines():
            cells = [cell.strip().strip("*") for cell in line.strip("|").split("|")]
            if len(cells) == 7 and re.fullmatch(r"[0-9.]+", cells[2]):
                # milliseconds for 1000 time units, or millions of time units in a second
                time = 1 / float(cells[2]) if problem.endswith("ensemble") else float(cells[2])
                points.setdefault(cells[0], []).append((float(cells[4]), time))
    return panels


if __name__ == "__main__":
    from page import TITLES

    docs = Path(__file__).resolve().parents[2] / "docs"
    draw(docs / "performance.png", TITLES, read((docs / "performance.md").read_text(), TITLES))
