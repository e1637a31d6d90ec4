"""The examples in the documentation, and the README."""

import dataclasses
import doctest
import importlib.util
import pathlib
import pkgutil

import pytest

import heavytop

MODULES = ["heavytop"] + [f"heavytop.{m.name}" for m in pkgutil.iter_modules(heavytop.__path__) if m.name != "_native"]


@pytest.mark.parametrize("name", MODULES)
def test_examples_run(name):
    module = __import__(name, fromlist=["_"])
    assert doctest.testmod(module, optionflags=doctest.ELLIPSIS).failed == 0


PACKAGE = pathlib.Path(__file__).parent.parent
ROOT = PACKAGE.parent.parent
GUIDE = sorted((ROOT / "docs/guide").glob("*.md"))
PAGES = [PACKAGE / "README.md"] + [page for page in GUIDE if ">>> " in page.read_text()]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_pages_run(page):
    found = doctest.testfile(str(page), module_relative=False, optionflags=doctest.ELLIPSIS)
    assert found.failed == 0 and found.attempted > 3


def gallery():
    """The program that draws the pictures of the documentation from its pages."""
    specification = importlib.util.spec_from_file_location("make", ROOT / "docs/gallery/make.py")
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


GALLERY = gallery()
ENTRIES = {page.name: GALLERY.entries(page) for page in (ROOT / "docs/gallery.md", ROOT / "docs/guide/tops-you-know.md")}


@pytest.mark.parametrize(
    "entry", [pytest.param(entry, id=f"{page}-{entry.picture.stem}") for page, found in ENTRIES.items() for entry in found]
)
def test_checks_of_pictures_hold(entry):
    pytest.importorskip("scipy")
    pytest.importorskip("matplotlib")
    GALLERY.check(entry)
    assert entry.picture.exists()


def test_all_pictures_have_entries():
    assert {page: len(found) for page, found in ENTRIES.items()} == {"gallery.md": 20, "tops-you-know.md": 6}
    drawn = {entry.picture for found in ENTRIES.values() for entry in found}
    assert set((ROOT / "docs/gallery").glob("*.png")) <= drawn


def test_a_picture_comes_from_its_page(program, tmp_path):
    entry = next(entry for entry in ENTRIES["gallery.md"] if entry.picture.stem == "toda")
    own = dataclasses.replace(entry, picture=tmp_path / "toda.png")
    GALLERY.draw(own, program)
    assert own.picture.stat().st_size > 10_000
    # Negative controls: a check that fails, and a run in Python that is not the one of the commands.
    own.picture.unlink()
    for wrong in (
        dataclasses.replace(own, python=own.python + "assert run.t[-1] == 0\n"),
        dataclasses.replace(own, toml=own.toml.replace("b1 = 1", "b1 = 1.001")),
    ):
        with pytest.raises(AssertionError):
            GALLERY.draw(wrong, program)
        assert not own.picture.exists()


def test_every_public_name_has_documentation():
    for name in heavytop.__all__:
        item = getattr(heavytop, name)
        if isinstance(item, tuple):
            continue
        assert item.__doc__, name
        for member in vars(item):
            if not member.startswith("_") and callable(getattr(item, member)):
                assert getattr(item, member).__doc__, f"{name}.{member}"
