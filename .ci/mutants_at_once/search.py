"""Finds the changes that no fast test sees, from what compile.py left in FOLDER."""

import collections
import concurrent.futures
import json
import os
import pathlib
import random
import subprocess
import sys
import time

folder, sample, seed = pathlib.Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
LIMIT = float(os.environ.get("LIMIT", "4"))
# A change that passes tests for so many seconds counts as missed.
PATIENCE = 5 * LIMIT
# As few random cases as find what is wrong in general.
CASES = {"PROPTEST_CASES": "8", "RUST_BACKTRACE": "0"}


def run(test, limit, **variables):
    """Runs one test, and returns whether it passes and its time, or None if it takes longer than the limit."""
    program, directory, name = test
    start = time.monotonic()
    try:
        ended = subprocess.run(
            [program, "--exact", name, "--test-threads=1"], cwd=directory, env={**os.environ, **CASES, **variables},
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=limit,
        )
    except subprocess.TimeoutExpired:
        return None
    return ended.returncode == 0, time.monotonic() - start


def listed(program, directory):
    """Returns the tests of a program."""
    names = subprocess.run([program, "--list", "--format", "terse"], cwd=directory, capture_output=True, text=True)
    return [(program, directory, line[:-6]) for line in names.stdout.splitlines() if line.endswith(": test")]


def reach(test):
    """Returns the changes that a test reaches and its time; nothing if it is slow, or fails with notes."""
    notes = folder / "notes" / str(abs(hash(test)))
    notes.unlink(missing_ok=True)
    result = run(test, LIMIT, CHANGE="note", CHANGES_REACHED=str(notes))
    if result is None or not result[0] or not notes.exists():
        return test, 0.0, []
    return test, result[1], [int(line) for line in notes.read_text().split()]


def judge(number, tests):
    """Returns the number of a change with what becomes of it."""
    spent = 0.0
    for seconds, test in tests:
        if spent > PATIENCE:
            break
        result = run(test, 5 + 8 * seconds, CHANGE=str(number))
        if result is None:
            return number, "time limit"
        if not result[0]:
            return number, "caught"
        spent += result[1]
    return number, "missed"


def keys(names):
    """Returns the name of each change without its place, with a number if a function has several like it."""
    seen, result = collections.Counter(), []
    for name in names:
        path, _, _, change = name.split(":", 3)
        key = f"{path}:{change}"
        seen[key] += 1
        result.append(key if seen[key] == 1 else f"{key} #{seen[key]}")
    return result


def listed_equivalents():
    """Returns the keys of the changes that are known to change nothing that can be tested."""
    lines = (pathlib.Path(__file__).parent / "equivalent.txt").read_text().splitlines()
    return {line for line in lines if line and not line.startswith("#")}


def main():
    (folder / "notes").mkdir(exist_ok=True)
    changes = json.loads((folder / "changes.json").read_text())
    names = changes["names"]
    keyed, equivalent = keys(names), listed_equivalents()
    if unknown := sorted(equivalent - set(keyed)):
        print("equivalent.txt names changes that are not there:", *unknown, sep="\n", flush=True)
    tests = [test for program in changes["programs"] for test in listed(*program)]
    reached = collections.defaultdict(list)
    drawn = random.Random(seed).sample(range(len(names)), min(sample, len(names)))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for test, seconds, numbers in pool.map(reach, tests):
            for number in numbers:
                reached[number].append((seconds, test))
        print(f"{len(tests)} tests, {len(reached)} of {len(names)} changes are reached", flush=True)
        verdicts = list(pool.map(lambda number: judge(number, sorted(reached[number])), drawn))
    verdicts = [(n, "equivalent" if verdict == "missed" and keyed[n] in equivalent else verdict) for n, verdict in verdicts]
    survivors = sorted(f"{names[n].split(':', 3)[1]}: {keyed[n]}" for n, verdict in verdicts if verdict == "missed")
    (folder / "survivors.txt").write_text("".join(f"{name}\n" for name in survivors))
    counts = collections.defaultdict(collections.Counter)
    for number, verdict in verdicts:
        for crate in (names[number].split("/")[1], "all"):
            counts[crate][verdict] += 1
    print("| crate | tried | caught | time limit | change nothing | missed | caught of the others |\n|---|---|---|---|---|---|---|")
    for crate, count in sorted(counts.items(), key=lambda item: (item[0] == "all", item[0])):
        tried, seen, same = count.total(), count["caught"] + count["time limit"], count["equivalent"]
        share = f"{100 * seen / (tried - same):.0f} %" if tried > same else ""
        print(f"| `{crate}` | {tried} | {count['caught']} | {count['time limit']} | {same} | {count['missed']} | {share} |")


main()
