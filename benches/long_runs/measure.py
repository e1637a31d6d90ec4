"""Fits how the invariants of long runs change, for docs/testing.md and docs/long-runs.png. See the script run."""

import argparse
import pathlib
import re

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

# M. Okabe & K. Ito, Color universal design (2008).
COLOURS = ["#0072B2", "#D55E00"]
TOPS = {"lagrange": ("Lagrange", "Pi3", "Π₃"), "kovalevskaya": ("Kovalevskaya", "K", "K")}
METHODS = {
    "gauss-16": ("collective Gauss-16", "1/4"),
    "implicit-midpoint": ("reduced midpoint", "1/50"),
}
# Larger deviations are truncation errors, not round-off.
LARGEST_DRAWN = 1e-6
# What the rounding of a step changes, about.
ROUND_OFF = 1e-16
# Of all lags up to this part of the run there are at least four intervals.
LONGEST_LAG = 0.25


def deviations(path, invariant):
    """Returns the deviations from the initial values, divided by those, by name."""
    table = np.genfromtxt(path, delimiter=",", names=True)
    columns = {"f₁": "f1", "f₂": "f2", invariant[1]: invariant[0], "h": "h"}
    return {name: table[column] / table[column][0] - 1 for name, column in columns.items()}


def changes(deviation):
    """Returns lags in samples, and the root mean square of the change over each of them."""
    most = int(LONGEST_LAG * len(deviation))
    lags = np.unique(np.geomspace(1, most, 30).astype(int))
    return lags, np.array([np.sqrt(np.mean((deviation[n:] - deviation[:-n]) ** 2)) for n in lags])


def fit(deviation, steps):
    """Returns the largest deviation, the change per step with its standard error, and the exponent of the changes."""
    lags, rms = changes(deviation)
    exponent = np.polyfit(np.log(lags), np.log(rms), 1)[0] if np.all(rms > 0) else 0.0
    error = np.std(np.diff(deviation)) * np.sqrt(len(deviation) - 1) / steps
    return np.max(np.abs(deviation)), deviation[-1] / steps, error, exponent


def number(x):
    """Returns a number with two digits and a minus sign."""
    return f"{x:.1e}".replace("e-0", "e-").replace("-", "−")


def rows(runs, steps):
    """Returns the rows of the table."""
    for (top, method), run in runs.items():
        name, step = METHODS[method]
        for quantity, deviation in run.items():
            most, drift, error, exponent = fit(deviation, steps)
            yield (
                f"| {TOPS[top][0]} | {name} | {step} | {quantity} | {number(most)} "
                f"| {number(drift)} ± {number(error)} | {exponent:.2f} |"
            )


def envelope(deviations):
    """Returns the largest size so far of the deviations of some quantities."""
    return np.maximum.accumulate(np.max(np.abs(list(deviations)), axis=0))


def draw(runs, steps, path):
    """Draws, for each top, the largest deviations so far against the number of steps, on logarithmic scales."""
    figure, panels = plt.subplots(1, 2, figsize=(11, 4.6), sharey=True, layout="constrained")
    for panel, top in zip(panels, TOPS):
        labels = []
        for colour, (method, (name, step)) in zip(COLOURS, METHODS.items()):
            run = runs[top, method]
            count = np.linspace(0, steps, len(run["h"]))[1:]
            exact = {q: d for q, d in run.items() if np.max(np.abs(d)) < LARGEST_DRAWN}
            line = envelope(exact.values())[1:]
            panel.plot(count, line, color=colour, linewidth=2)
            labels.append((line[-1], colour, f"{name}, {step} s:\n" + ", ".join(exact)))
            if "h" not in exact:
                # The midpoint rule changes h with its own error, which does not grow.
                line = envelope([run["h"]])[1:]
                panel.plot(count, line, color=colour, linewidth=2, linestyle="--")
                labels.append((line[-1], colour, f"{name}: h"))
        walk = ROUND_OFF * np.sqrt(count)
        panel.plot(count, walk, color="#969696", linewidth=1, linestyle=":")
        panel.annotate(
            "random walk, $10^{-16}\\sqrt{n}$", (count[len(count) // 30], walk[len(walk) // 30]), (6, -14),
            textcoords="offset points", color="#696969", fontsize=9,
        )
        panel.loglog()
        panel.set_title(f"{TOPS[top][0]}'s top", fontsize=11)
        panel.set_xlabel("steps n")
        panel.set_xlim(count[0], count[-1])
        # Names are below one another; those of curves that end at nearly the same height are moved apart.
        height = None
        for value, colour, name in sorted(labels, key=lambda label: -label[0]):
            height = value if height is None else min(value, height / 40)
            panel.annotate(
                name, (1, height), (6, 0), xycoords=("axes fraction", "data"),
                textcoords="offset points", color=colour, va="center", fontsize=9,
            )
    panels[0].set_ylabel("largest relative deviation so far")
    figure.savefig(path, dpi=110)


def main():
    parser = argparse.ArgumentParser()
    for option in ["folder", "root"]:
        parser.add_argument(f"--{option}", type=pathlib.Path, required=True)
    parser.add_argument("--steps", type=int, required=True)
    options = parser.parse_args()
    runs = {
        (top, method): deviations(
            options.folder / f"{top}-{method}-{options.steps}.csv", TOPS[top][1:]
        )
        for top in TOPS
        for method in METHODS
    }
    docs = options.root / "docs"
    draw(runs, options.steps, docs / "long-runs.png")
    table = "\n".join(
        [
            "| top | method | step, s | quantity | largest relative deviation | change per step | exponent |",
            "|---|---|---|---|---|---|---|",
            *rows(runs, options.steps),
        ]
    )
    page = docs / "testing.md"
    text = page.read_text()
    text, found = re.subn(
        r"(<!-- long-runs: begin -->\n).*?(<!-- long-runs: end -->)", rf"\g<1>{table}\n\g<2>", text, flags=re.S
    )
    if found != 1:
        raise SystemExit(f"{page}: the place of the table is not marked")
    page.write_text(text)
    print(table)


main()
