"""Writes what was measured into docs/performance.md, between its markers, and has docs/performance.png drawn.

Two parts of the page are generated: the ratios of computing times at its top, and the tables from which they come.
"""

import platform
import statistics
import subprocess
import tomllib
from fnmatch import fnmatchcase
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import chart

PARTS = ("ratios", "measured")  # what stands between <!-- NAME: begin --> and <!-- NAME: end -->
OURS = "heavytop"  # our names start with it

TITLES = {
    "kovalevskaya": "One Kovalevskaya top to t = 1000",
    "generic": "One generic top to t = 1000",
    "kovalevskaya-ensemble": "10⁴ Kovalevskaya tops to t = 20, one thread",
    "generic-ensemble": "10⁴ generic tops to t = 20, one thread",
}

# What is compared. A contestant is (pattern of the name, setting or None, largest error at 10): the fastest row that
# fits. The ratio is of seconds, ours by theirs.
ANY = float("inf")
KOVALEVSKAYA, GENERIC = "kovalevskaya", "generic"
GAUSS, MIDPOINT = ("heavytop collective Gauss*", None, 2e-14), ("heavytop lift-free midpoint*", "h = 0.01", ANY)
GAUSS_11 = ("heavytop collective Gauss*", None, 1e-11)
ENSEMBLE_13, ENSEMBLE_8 = ("heavytop*", None, 3e-13), ("heavytop*", None, 1e-8)
RK8, RK8_VECTORS = ("C++ RK8", "h = 0.025", ANY), ("C++ RK8, vectors", "h = 0.025", ANY)
SIMD_RK8_13, SIMD_RK8_8 = ("C++ SIMD RK8", None, 3e-13), ("C++ SIMD RK8", None, 1e-8)

# (task, peer, end of the problems' names, tops, ours, theirs)
PEERS = [
    ("one top, error 2e-14", "heyoka, fastest setting", "", (KOVALEVSKAYA, GENERIC), GAUSS, ("heyoka", None, 2e-14)),
    ("one top, error 2e-14", "heyoka, finest tolerance", "", (KOVALEVSKAYA, GENERIC), GAUSS,
     ("heyoka", "tolerance 1e-16", ANY)),
    ("one top, error 2e-14", "heyoka, compiled parameters", "", (KOVALEVSKAYA, GENERIC), GAUSS,
     ("heyoka, compiled parameters", None, 2e-14)),
    ("one top, error 2e-14", "RK8, h = 0.025", "", (KOVALEVSKAYA, GENERIC), GAUSS, RK8),
    ("one top, error 2e-14", "RK8 in vectors, h = 0.025", "", (KOVALEVSKAYA, GENERIC), GAUSS, RK8_VECTORS),
    ("one top, error 2e-14", "IRKGL16", "", (KOVALEVSKAYA, GENERIC), GAUSS, ("C++ IRKGL16*", None, 2e-14)),
    ("one top, error 2e-14", "IRKGL16, both to 5e-14", "", (KOVALEVSKAYA, GENERIC),
     ("heavytop Gauss-16 to 5e-14", None, 2e-14), ("C++ IRKGL16", None, 2e-14)),
    ("one top, RK4", "C++", "", (KOVALEVSKAYA, GENERIC), ("heavytop any system: RK4, direct", "h = 0.01", ANY),
     ("C++ RK4", "h = 0.01", ANY)),
    ("one top, splitting of order 4", "C++", "", (KOVALEVSKAYA,),
     ("heavytop splitting of order 4, one top", "h = 0.2", ANY), ("C++ splitting of order 4", "h = 0.2", ANY)),
    ("one top, error 1e-11", "DOP853 of ode_solvers", "", (KOVALEVSKAYA, GENERIC), GAUSS_11,
     ("ode_solvers DOP853", None, 1e-11)),
    ("one top, error 1e-11", "DOP853 of differential-equations", "", (KOVALEVSKAYA, GENERIC), GAUSS_11,
     ("differential-equations DOP853", None, 1e-11)),
    ("one top, error 1e-11", "Tsit45 of diffsol", "", (KOVALEVSKAYA, GENERIC), GAUSS_11, ("diffsol Tsit45", None, 1e-11)),
    ("one top, midpoint rule", "C++", "", (KOVALEVSKAYA,), MIDPOINT, ("C++ implicit midpoint", None, ANY)),
    ("one top, midpoint rule", "C++ in vectors", "", (KOVALEVSKAYA,), MIDPOINT,
     ("C++ implicit midpoint, vectors", None, ANY)),
    ("one top, midpoint rule", "GSL", "", (KOVALEVSKAYA,), MIDPOINT, ("GSL rk2imp", None, ANY)),
    ("ensemble, midpoint rule", "C++ SIMD", "-ensemble", (GENERIC,), MIDPOINT,
     ("C++ SIMD implicit midpoint", None, ANY)),
    ("ensemble, error 3e-13", "SIMD RK8", "-ensemble", (KOVALEVSKAYA, GENERIC), ENSEMBLE_13, SIMD_RK8_13),
    ("ensemble, error 3e-13", "heyoka", "-ensemble", (KOVALEVSKAYA, GENERIC), ENSEMBLE_13,
     ("heyoka, batch*", None, 3e-13)),
    ("ensemble, error 3e-13", "heyoka, compiled parameters", "-ensemble", (KOVALEVSKAYA, GENERIC), ENSEMBLE_13,
     ("heyoka, compiled parameters*", None, 3e-13)),
    ("ensemble, error 1e-8", "SIMD RK8", "-ensemble", (KOVALEVSKAYA,), ENSEMBLE_8, SIMD_RK8_8),
]

# (general integrator, kernel for tops, end of the problems' names, setting)
THIRD = "h = 0.3333333333333333"
GENERAL = [
    ("any system: Gauss-16", "collective Gauss-16", "", "h = 0.25"),
    ("any system: lift-free midpoint", "lift-free midpoint", "", "h = 0.01"),
    ("any Hamiltonian: midpoint", "lift-free midpoint", "", "h = 0.01"),
    ("any system: Gauss-16", "Gauss-16", "-ensemble", THIRD),
    ("any system: lift-free midpoint", "lift-free midpoint", "-ensemble", "h = 0.01"),
    ("any Hamiltonian: midpoint", "lift-free midpoint", "-ensemble", "h = 0.01"),
]


# The bodies of `downstream_bodies`, and its two methods.
BODIES = ("rigid body on so(4)", "body in two fields", "body on su(3)")
GAUSS_4, RK4_BY_HAND = "heavytop any system: Gauss-4", "RK4 by hand"


def final_error(row):
    return next(value for key, value in row.items() if key.startswith("error_") and key != "error_10")


def table(problem, rows):
    ensemble = problem.endswith("ensemble")
    rows = [row for row in rows if row["problem"] == problem]
    head = ("| who | setting | million time units/s | ns per top and step | error at 10 | at 20 | spread |" if ensemble
            else "| who | setting | ms | ns per step | error at 10 | at 1000 | spread |")
    lines = [f"### {TITLES[problem]}", "", head, "|---|---|--:|--:|--:|--:|--:|"]
    for row in rows:
        seconds, steps, tops = row["seconds"], row["steps"], 10**4 if ensemble else 1
        main = f"{tops * 20 / seconds * 1e-6:.2f}" if ensemble else f"{seconds * 1e3:.2f}"
        name = f"**{row['name']}**" if row["name"].startswith(OURS) else row["name"]
        spread = max(row["rounds"].values()) / min(row["rounds"].values()) - 1
        lines.append(f"| {name} | {row['setting']} | {main} | {seconds / steps / tops * 1e9:.1f} | "
                     f"{row['error_10']:.1e} | {final_error(row):.1e} | {spread:.0%} |")
    return lines + [""]


def fastest(rows, problem, wanted):
    name, setting, error = wanted
    fitting = [row for row in rows if row["problem"] == problem and fnmatchcase(row["name"], name)
               and setting in (None, row["setting"]) and row["error_10"] <= error]
    return min(fitting, key=lambda row: row["seconds"], default=None)


def pair(rows, problem, ours, theirs):
    """The two rows compared, and the median over the rounds of the ratio within a round; None where a row lacks."""
    a, b = fastest(rows, problem, ours), fastest(rows, problem, theirs)
    if a is None or b is None:
        return None
    return a, b, statistics.median(a["rounds"][n] / b["rounds"][n] for n in a["rounds"] if n in b["rounds"])


def ratios(rows):
    lines = ["| task | peer | Kovalevskaya's top | generic top |", "|---|---|--:|--:|"]
    for task, peer, ensemble, tops, ours, theirs in PEERS:
        pairs = [pair(rows, top + ensemble, ours, theirs) if top in tops else None for top in (KOVALEVSKAYA, GENERIC)]
        if any(pairs):
            cells = (f"{found[2]:.3f}" if found else "—" for found in pairs)
            lines.append(f"| {task} | {peer} | {' | '.join(cells)} |")
    return lines + [""]


def general(rows):
    lines = ["### General integrators and kernels", "",
             "The time of a general integrator divided by that of the kernel for tops.", "",
             "| general integrator | setting | problem | Kovalevskaya's top | generic top |", "|---|---|---|--:|--:|"]
    for method, kernel, ensemble, setting in GENERAL:
        pairs = [pair(rows, top + ensemble, (f"heavytop {method}", setting, ANY), (f"heavytop {kernel}", setting, ANY))
                 for top in (KOVALEVSKAYA, GENERIC)]
        if any(pairs):
            cells = (f"{found[2]:.1f}" if found else "—" for found in pairs)
            lines.append(f"| {method} | {setting} | {'ensemble' if ensemble else 'one top'} | {' | '.join(cells)} |")
    return lines + [""] if len(lines) > 6 else []


def bodies(rows):
    found = {row["name"]: row for row in rows if row["problem"] == "bodies"}
    lines = ["### Bodies of a downstream crate", "",
             "The time of Gauss-4 of any system, with maps written by hand, divided by that of RK4 by hand; h = 0.01.", "",
             "| body | Gauss-4, ns per step | RK4 by hand, ns per step | ratio |", "|---|--:|--:|--:|"]
    for body in BODIES:
        ours, theirs = found.get(f"{GAUSS_4}, {body}"), found.get(f"{RK4_BY_HAND}, {body}")
        if ours and theirs:
            a, b = (row["seconds"] / row["steps"] * 1e9 for row in (ours, theirs))
            a_rounds, b_rounds = ours["rounds"], theirs["rounds"]
            ratio = statistics.median(a_rounds[n] / b_rounds[n] for n in a_rounds if n in b_rounds)
            lines.append(f"| {body} | {a:.1f} | {b:.1f} | {ratio:.1f} |")
    return lines + [""] if len(lines) > 6 else []


def machine():
    def first_line(*command):
        try:
            return subprocess.run(command, capture_output=True, text=True).stdout.splitlines()[0]
        except (OSError, IndexError):
            return f"no {command[0]}"

    names = [line.split(":")[1].strip() for line in Path("/proc/cpuinfo").read_text().splitlines()
             if line.startswith("model name")] if Path("/proc/cpuinfo").exists() else []
    packages = []
    for package in ("heyoka", "scipy", "numpy"):
        try:
            packages.append(f"{package} {version(package)}")
        except PackageNotFoundError:
            pass
    manifest = tomllib.loads((Path(__file__).parent / "rust/Cargo.toml").read_text())
    for crate, wanted in manifest["dependencies"].items():
        packages.append(f"{crate} {(wanted if isinstance(wanted, str) else wanted['version']).lstrip('=')}")
    return [f"{names[0] if names else platform.machine()}, {len(names)} cores; {first_line('g++', '--version')}; "
            f"{first_line('rustc', '--version')}; Python {platform.python_version()}, {', '.join(packages)}.", ""]


def peak(rows):
    found = [f"{row['gflops']:.0f} with {row['setting']}" for row in rows if row["problem"] == "peak"]
    return [f"One core's peak in fused multiply-adds, GFLOP/s: {', '.join(found)}.", ""] if found else []


def generated(rows, missing, rounds):
    lines = [*machine(), *peak(rows)]
    lines += [f"Rounds: {rounds}; spread: how much the slowest was above the fastest.", ""]
    if missing:
        lines += ["Did not run here:", ""] + [f"* `{name}`: {why}" for name, why in missing.items()] + [""]
    for problem in TITLES:
        lines += table(problem, rows)
    return lines + general(rows) + bodies(rows)


def panels(rows):
    found = {}
    for row in rows:
        if row["problem"] in TITLES:
            units = 20e4 if row["problem"].endswith("ensemble") else 1000
            points = found.setdefault(row["problem"], {}).setdefault(row["name"], [])
            points.append((row["error_10"], row["seconds"] / units * 1e6))
    return found


def write(docs, rows, missing, rounds):
    page = docs / "performance.md"
    text = page.read_text()
    for name, lines in zip(PARTS, (ratios(rows), generated(rows, missing, rounds))):
        begin, end = f"<!-- {name}: begin -->", f"<!-- {name}: end -->"
        before, rest = text.split(begin)
        text = before + "\n".join([begin, "", *lines]) + end + rest.split(end)[1]
    page.write_text(text)
    try:
        chart.draw(docs / "performance.png", TITLES, panels(rows))
    except ImportError:
        print("no Matplotlib: no chart")
    print(f"wrote {page}")
