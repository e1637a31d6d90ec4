"""Finds the changes that no test sees, from what compile.py left in FOLDER."""

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
LIMIT = float(os.environ.get("LIMIT", "3"))
# What fast tests do not see is looked for by those that take less than so many seconds.
SLOW = float(os.environ.get("SLOW", "20"))
# A change that passes tests for so many of their limits counts as missed by them.
PATIENCE = 4
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


def reach(test, limit):
    """Returns the changes that a test reaches and its time; `None` if it is slow, and nothing if it fails with notes."""
    notes = folder / "notes" / str(abs(hash(test)))
    notes.unlink(missing_ok=True)
    result = run(test, limit, CHANGE="note", CHANGES_REACHED=str(notes))
    if result is None:
        return None
    passed, seconds = result
    reached = notes.read_text().split() if passed and notes.exists() else []
    return seconds, [int(line) for line in reached]


def judge(number, tests, patience):
    """Returns what becomes of a change, and the tests for which there was no time."""
    spent = 0.0
    for place, (seconds, test) in enumerate(tests):
        if spent > patience:
            return "missed", tests[place:]
        result = run(test, 5 + 8 * seconds, CHANGE=str(number))
        if result is None:
            return "time limit", []
        if not result[0]:
            return "caught", []
        spent += result[1]
    return "missed", []


def judge_all(pool, left, tests, limit):
    """Judges changes by the tests that are left for them, and by those of the others that are fast enough.

    Returns the verdicts, and the tests that are not.
    """
    reached, slow = collections.defaultdict(list, left), []
    for test, result in zip(tests, pool.map(lambda test: reach(test, limit), tests)):
        if result is None:
            slow.append(test)
            continue
        for number in result[1]:
            reached[number].append((result[0], test))
    print(f"{len(tests) - len(slow)} tests of less than {limit:g} s, which reach {len(reached)} changes", flush=True)
    verdicts = pool.map(lambda number: judge(number, sorted(reached[number]), PATIENCE * limit), left)
    return dict(zip(left, verdicts)), slow


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
    drawn = random.Random(seed).sample(range(len(names)), min(sample, len(names)))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        verdicts, slow = judge_all(pool, {n: [] for n in drawn}, tests, LIMIT)
        left = {n: left for n, (verdict, left) in verdicts.items() if verdict == "missed" and keyed[n] not in equivalent}
        print(f"{len(left)} changes are left", flush=True)
        verdicts |= judge_all(pool, left, slow, SLOW)[0]
    same = lambda n, verdict: verdict == "missed" and keyed[n] in equivalent
    verdicts = [(n, "equivalent" if same(n, verdict) else verdict) for n, (verdict, _) in verdicts.items()]
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
