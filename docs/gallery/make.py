"""Draws the pictures of docs/gallery.md and docs/guide/tops-you-know.md from the blocks of code on these pages.

    python docs/gallery/make.py                  # all pictures
    python docs/gallery/make.py dzhanibekov toda # those with these names

An entry is a section of a page with a picture and a `python` block. Its `toml` block is saved as run.toml in a new folder, its
`python` block is run there after that of the head of the page, and then its `sh` block. The one PNG that they leave is the
picture; a section whose picture is that of another one leaves none. If a check of
the `python` block fails, or its run is not the one of the commands, no picture is written.

Needs the package heavytop, NumPy, SciPy and Matplotlib, and the program heavytop: that of the environment variable
HEAVYTOP_PROGRAM, or target/release/heavytop.
"""

import contextlib
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = [ROOT / "docs/gallery.md", ROOT / "docs/guide/tops-you-know.md"]

SAME_MOTION = 1e-8
"""How far states of the program and of Python may differ: the same steps, with the rounding of two programs."""


@dataclass(frozen=True)
class Entry:
    """A section of a page with a picture.

    Attributes:
        picture: the path of the picture.
        toml: the configuration, or "".
        sh: the commands, or "".
        python: the first `python` block of the page, and that of the section.
    """

    picture: pathlib.Path
    toml: str
    sh: str
    python: str


def entries(page: pathlib.Path) -> list[Entry]:
    """Returns the entries of a page in their order."""
    start, *sections = re.split(r"^## ", page.read_text("utf-8"), flags=re.MULTILINE)
    found = []
    for section in sections:
        pictures = re.findall(r"!\[[^]]*\]\(([^)]*\.png)\)", section)
        if pictures and blocks(section, "python"):
            python = blocks(start, "python") + blocks(section, "python")
            found.append(Entry((page.parent / pictures[0]).resolve(), blocks(section, "toml"), blocks(section, "sh"), python))
    return found


def blocks(text: str, language: str) -> str:
    """Returns the blocks of code in a language, one after the other."""
    return "".join(re.findall(rf"^```{language}\n(.*?)^```$", text, flags=re.MULTILINE | re.DOTALL))


def check(entry: Entry) -> dict[str, Any]:
    """Runs the Python of an entry in a folder of its own, and returns what it has defined. Warnings are errors."""
    with new_folder():
        return run_python(entry)


def draw(entry: Entry, program: str) -> None:
    """Runs the Python and the commands of an entry, and writes its picture.

    Raises:
        AssertionError: if a check fails, or the motions differ.
        subprocess.CalledProcessError: if a command fails.
    """
    with new_folder() as folder:
        (folder / "run.toml").write_text(entry.toml, "utf-8")
        defined = run_python(entry)
        with tempfile.TemporaryDirectory() as bin_folder:
            (pathlib.Path(bin_folder) / "heavytop").symlink_to(program)
            path = os.pathsep.join([bin_folder, os.environ.get("PATH", "")])
            subprocess.run(["sh", "-e", "-c", entry.sh], check=True, env={**os.environ, "PATH": path})
        compare(defined.get("run"), folder / "run.npz")
        pictures = list(folder.rglob("*.png"))
        assert len(pictures) == 1 or not (pictures or entry.sh), f"one picture is needed, and there are {pictures}"
        for picture in pictures:
            entry.picture.write_bytes(picture.read_bytes())


def run_python(entry: Entry) -> dict[str, Any]:
    """Runs the Python of an entry in the current folder."""
    os.environ.setdefault("MPLBACKEND", "Agg")
    defined: dict[str, Any] = {}
    with warnings.catch_warnings():
        warnings.simplefilter("error", RuntimeWarning)
        exec(compile(entry.python, str(entry.picture.name), "exec"), defined)
    return defined


def compare(run: Any, archive: pathlib.Path) -> None:
    """Checks that a run in Python has the samples of that of the program."""
    if run is None or not archive.exists():
        return
    import numpy as np

    compared = 0
    with np.load(archive) as arrays:
        for name in arrays.files:
            try:
                own = run[name]
            except (KeyError, ValueError):
                continue  # The run in Python does not have it.
            others = arrays[name]
            difference = np.abs((own if own.shape == others.shape else own.T) - others).max()
            assert difference < SAME_MOTION, f"{name} of the program and of Python differ by {difference}"
            compared += 1
    assert compared > 0, "the runs of the program and of Python have no array in common"


@contextlib.contextmanager
def new_folder() -> Iterator[pathlib.Path]:
    """Makes a temporary folder the current one."""
    before = os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            yield pathlib.Path(folder)
        finally:
            os.chdir(before)


def main(names: list[str]) -> None:
    """Draws the pictures with these names, or all."""
    program = os.environ.get("HEAVYTOP_PROGRAM", str(ROOT / "target/release/heavytop"))
    every = [entry for page in PAGES for entry in entries(page)]
    unknown = set(names) - {entry.picture.stem for entry in every}
    if unknown:
        sys.exit(f"there is no picture {', '.join(sorted(unknown))}")
    for entry in every:
        if not names or entry.picture.stem in names:
            print(entry.picture.relative_to(ROOT), flush=True)
            draw(entry, program)


if __name__ == "__main__":
    main(sys.argv[1:])
