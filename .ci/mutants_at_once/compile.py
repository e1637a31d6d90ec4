"""Rewrites the library crates in FOLDER/tree, drops the changes that do not compile, and builds the tests."""

import json
import os
import pathlib
import re
import subprocess
import sys

from switches import SWITCH, Changes, Source

folder = pathlib.Path(sys.argv[1])
tree = folder / "tree"
CRATES = ["scalars", "lie-poisson", "momentum-map", "integrators", "isospectral", "systems", "heavytop", "formulas",
          "formula-systems"]
# They depend on the program, or are no mathematics.
EXCLUDED = ["heavytop-cli", "measurements", "heavytop-page", "heavytop-python", "fuzz-targets"]
ENVIRONMENT = {**os.environ, "RUSTFLAGS": "--cap-lints=allow", "CARGO_INCREMENTAL": "0",
               "CARGO_TARGET_DIR": str(folder / "target")}
# After so many attempts all changes of a line that does not compile are dropped.
PATIENCE = 6


def write(path, text):
    """Writes a file if it changes, so that cargo compiles nothing twice."""
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def rewrite(dropped):
    """Rewrites the sources, and returns the names of the changes."""
    changes = Changes(dropped)
    switch = (pathlib.Path(__file__).parent / "change_switch.rs").read_text()
    for crate in CRATES:
        source = tree / "crates" / crate / "src"
        for path in sorted(source.rglob("*.rs")):
            name = path.relative_to(tree)
            if path.name in ("change_switch.rs", "tests.rs") or "tests" in name.parts:
                continue
            committed = subprocess.run(["git", "show", f"HEAD:{name}"], cwd=tree, capture_output=True, check=True, text=True)
            text = Source(name, committed.stdout, changes).rewritten()
            if path == source / "lib.rs":
                text += "\n#[doc(hidden)]\npub mod change_switch;\n"
            write(path, text)
        write(source / "change_switch.rs", switch)
    return changes.names


def cargo(*words):
    """Runs cargo, and returns its exit status and the messages."""
    excluded = [word for package in EXCLUDED for word in ("--exclude", package)]
    command = ["cargo", *words, "--workspace", *excluded, "--message-format=json"]
    result = subprocess.run(command, cwd=tree, env=ENVIRONMENT, stdout=subprocess.PIPE, text=True)
    messages = [json.loads(line) for line in result.stdout.splitlines() if line.startswith("{")]
    return result.returncode, messages


def culprits(messages, seen):
    """Returns the numbers of the changes at which the compiler complains."""
    numbers = set()
    for message in messages:
        if message["reason"] != "compiler-message" or message["message"]["level"] != "error":
            continue
        for span in message["message"]["spans"]:
            path = tree / span["file_name"]
            if not span["is_primary"] or not path.exists():
                continue
            lines, first = path.read_text().split("\n"), span["line_start"] - 1
            place = (span["file_name"], first)
            seen[place] = seen.get(place, 0) + 1
            within = lines[first][span["column_start"] - 1 : span["column_end"] - 1]
            before = "\n".join([*lines[:first], lines[first][: span["column_end"] - 1]])
            found = re.findall(re.escape(SWITCH) + r"\((\d+)\)", within)[:2]
            if seen[place] > PATIENCE:
                found = re.findall(re.escape(SWITCH) + r"\((\d+)\)", "\n".join(lines[first : span["line_end"]]))
            numbers.update(map(int, found or re.findall(re.escape(SWITCH) + r"\((\d+)\)", before)[-1:]))
    return numbers


def settle(dropped, *targets):
    """Drops changes until the targets compile, and returns the names of the others."""
    seen = {}
    while True:
        names = rewrite(dropped)
        status, messages = cargo("check", "--keep-going", *targets)
        print(f"{len(names)} changes, {len(dropped)} dropped", flush=True)
        if status == 0:
            return names
        new = {names[number] for number in culprits(messages, seen)}
        if not new:
            raise SystemExit("the changed sources do not compile, and no change is the reason")
        dropped |= new
        (folder / "dropped.json").write_text(json.dumps(sorted(dropped), indent=0))


def main():
    kept = folder / "dropped.json"
    dropped = set(json.loads(kept.read_text())) if kept.exists() else set()
    settle(dropped, "--lib")
    # The unit tests see private items, and the tests use the features of all crates.
    names = settle(dropped, "--lib", "--tests")
    status, messages = cargo("test", "--no-run", "--tests", "--lib")
    if status != 0:
        raise SystemExit("the tests do not compile")
    programs = [
        [message["executable"], os.path.dirname(message["manifest_path"])]
        for message in messages
        if message["reason"] == "compiler-artifact" and message["executable"] and message["profile"]["test"]
    ]
    (folder / "changes.json").write_text(json.dumps({"names": names, "programs": programs}, indent=0))


main()
