"""The commands of the guide: they run, from the configurations of the pages, and print what the pages say."""

import os
import pathlib
import re
import subprocess

import pytest

GUIDE = pathlib.Path(__file__).parents[3] / "docs/guide"
# The pictures of the tops that you know are made from that page, which checks them.
PAGES = sorted(page for page in GUIDE.glob("*.md") if page.name != "tops-you-know.md")
BLOCK = re.compile(r"^```(\w+)[^\n]*\n(.*?)^```$", re.MULTILINE | re.DOTALL)
INSTALLATION = ("cargo", "pip", "python3")


def rounded(number):
    """Returns a number without the digits that rounding changes from processor to processor."""
    value = float(number[0])
    return f"{value:.9g}" if abs(value) >= 1e-9 else "0"


def words(text):
    """Returns the text without breaks of lines, without the time that a command took, and with numbers rounded."""
    without_time = re.sub(r";? \d+\.\d\d s$", "", text, flags=re.MULTILINE)
    return " ".join(re.sub(r"-?\d+\.\d+(e-?\d+)?", rounded, without_time).split())


def run(commands, folder, program):
    """Runs the lines of a block that are no installation, and returns what they print."""
    lines = [line for line in commands.splitlines() if not line.startswith(INSTALLATION)]
    path = f"{folder / 'bin'}{os.pathsep}{os.environ['PATH']}"
    (folder / "bin").mkdir(exist_ok=True)
    (folder / "bin/heavytop").unlink(missing_ok=True)
    (folder / "bin/heavytop").symlink_to(program)
    done = subprocess.run(
        ["bash", "-e", "-c", "\n".join(lines)], cwd=folder, env={**os.environ, "PATH": path}, capture_output=True, text=True
    )
    return done.returncode, done.stdout + "\n" + done.stderr


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_commands_print_what_the_page_says(page, tmp_path, program):
    status, printed = 0, ""
    for language, text in BLOCK.findall(page.read_text()):
        name = re.match(r"# (\S+\.toml)\n", text)
        if language == "toml" and name:
            (tmp_path / name[1]).write_text(text)
        elif language == "sh":
            status, printed = run(text, tmp_path, program)
            assert status in (0, 2), printed
        elif language == "text":
            for part in text.split("…"):
                assert words(part) in words(printed), f"{part}\nis not printed:\n{printed}"


def test_another_output_is_seen():
    """Control: the time that a command takes and round-off do not matter, any other number does."""
    assert words("done: 2 rows; to 2 s; 0.01 s\n") == words("done: 2 rows; to\n2 s; 1.25 s")
    assert words("f1 6.7e-16, 35.0382011625246 s apart") == words("f1 0.0e0, 35.0382011625249 s apart")
    assert words("precession 2.00162 rad/s") != words("precession 2.00161 rad/s")
