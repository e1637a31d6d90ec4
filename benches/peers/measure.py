"""Runs every contestant, interleaved, and writes the page and the chart. Called by `run`.

A contestant is a command that prints one line of JSON for each setting,

    {"name", "setting", "seconds", "steps", "error_10", "error_1000"}

with seconds for the whole problem (for all tops of an ensemble), steps of one top, and the 2-norm of the error of the
state (Π, Γ), its arithmetic mean over an ensemble, at t = 10 and at the end (an ensemble ends at t = 20: "error_20").
The names of ours begin with "heavytop"; `page.PEERS` asks for "heavytop collective Gauss" and "heavytop lift-free
midpoint". The bodies of a downstream crate are their own peers: their lines have no error. In each round every
contestant runs once, on each problem; the next round starts with another one.
"""

import argparse
import json
import statistics
import subprocess
import sys
from pathlib import Path

import page

# (name, arguments of `reference`): I1 I2 I3 mgl c1 c2 c3, end, number of tops.
PROBLEMS = {
    "kovalevskaya": "2 2 1 1 1 0 0 1000 1",
    "generic": "2.9 2.1 1.3 1 0.48 0.6 0.64 1000 1",
    "kovalevskaya-ensemble": "2 2 1 1 1 0 0 20 10000",
    "generic-ensemble": "2.9 2.1 1.3 1 0.48 0.6 0.64 20 10000",
}

# What runs. {built}, {folder}, {peers}, {python} and {problem} are filled in.
OURS = ["{built}/heavytop bench --json --problem {problem}"]
ONE_TOP = ["{folder}/single {problem}", "{folder}/splitting {problem}", "{folder}/rust-peers {problem}",
           "{folder}/gsl {problem}", "{folder}/odeint {problem}",
           "{python} -B {peers}/heyoka_peer.py {problem}", "{python} -B {peers}/scipy_peer.py {problem}"]
ENSEMBLE = ["{folder}/ensemble {problem}", "{python} -B {peers}/heyoka_peer.py {problem}"]
PEAK = "{folder}/peak"
BODIES = "{built}/downstream_bodies times"


def ours(text):
    """The lines of a contestant from the summary of `heavytop bench --json`; nothing where it failed. Ensembles of
    less than the 10⁴ tops of the others are scaled up to them."""
    return [{key: run[key] for key in ("name", "setting", "steps", "error_10")}
            | {f"error_{run['end']:.0f}": run["error_end"],
               "seconds": run["seconds"] * (10**4 / run["tops"] if run["tops"] > 1 else 1)}
            for run in json.loads(text or '{"runs": []}')["runs"]]


class Results:
    """The lines of all contestants, by (problem, name, setting), with the seconds of each round; and who is missing."""

    def __init__(self):
        self.rows = {}
        self.missing = {}

    def add(self, problem, round_number, line):
        row = self.rows.setdefault((problem, line["name"], line["setting"]), {**line, "rounds": {}})
        row["rounds"][round_number] = line["seconds"]
        row["seconds"] = statistics.median(row["rounds"].values())
        if "gflops" in line:
            row["gflops"] = max(row["gflops"], line["gflops"])

    def run(self, words, problem, round_number):
        command = " ".join(Path(word).name for word in words)
        try:
            done = subprocess.run(words, capture_output=True, text=True, timeout=600)
            lines = ours(done.stdout) if words[1:2] == ["bench"] else [json.loads(line) for line in done.stdout.splitlines()]
            error = done.stderr.strip().splitlines()[-1:] if done.returncode else []
            if done.returncode:
                self.missing[command] = " ".join([f"exit status {done.returncode}", *error])
        except FileNotFoundError:
            lines, self.missing[command] = [], "not built"
        except (OSError, ValueError, subprocess.TimeoutExpired) as failure:
            lines, self.missing[command] = [], str(failure)
        for line in lines:
            self.add(problem, round_number, line)


def write_problems(folder):
    """Reference solutions: a few minutes, the first time."""
    for name, arguments in PROBLEMS.items():
        path = folder / f"{name}.txt"
        stamp = folder / f"{name}.arguments"
        if path.exists() and stamp.exists() and stamp.read_text() == arguments:
            continue
        print(f"   {name}", flush=True)
        with path.open("w") as file:
            if subprocess.run([folder / "reference", *arguments.split()], stdout=file).returncode != 0:
                sys.exit(f"no reference solution for {name}")
        stamp.write_text(arguments)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name in ("--folder", "--root", "--built"):
        parser.add_argument(name, type=Path, required=True)
    parser.add_argument("--rounds", type=int, default=5)
    options = parser.parse_args()

    print("== reference solutions", flush=True)
    write_problems(options.folder)

    def contestants(problem):
        commands = OURS + (ENSEMBLE if problem.endswith("ensemble") else ONE_TOP)
        return [(command, problem) for command in commands]

    schedule = [(PEAK, "peak"), (BODIES, "bodies")] + [pair for problem in PROBLEMS for pair in contestants(problem)]
    results = Results()
    for round_number in range(options.rounds):
        print(f"== round {round_number + 1} of {options.rounds}", flush=True)
        first = round_number * len(schedule) // options.rounds
        for command, problem in schedule[first:] + schedule[:first]:
            words = [word.format(built=options.built, folder=options.folder, python=sys.executable,
                                 peers=Path(__file__).parent, problem=options.folder / f"{problem}.txt")
                     for word in command.split()]
            results.run(words, problem, round_number)

    rows = [{"problem": problem, **row} for (problem, _, _), row in results.rows.items()]
    (options.folder / "results.json").write_text(json.dumps({"rows": rows, "missing": results.missing}, indent=1))
    page.write(options.root / "docs", rows, results.missing, options.rounds)


if __name__ == "__main__":
    main()
