"""The examples in the documentation, and the README."""

import doctest
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
GUIDE = sorted((PACKAGE.parent.parent / "docs/guide").glob("*.md"))
PAGES = [PACKAGE / "README.md"] + [page for page in GUIDE if ">>> " in page.read_text()]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_pages_run(page):
    found = doctest.testfile(str(page), module_relative=False, optionflags=doctest.ELLIPSIS)
    assert found.failed == 0 and found.attempted > 3


def test_every_public_name_has_documentation():
    for name in heavytop.__all__:
        item = getattr(heavytop, name)
        if isinstance(item, tuple):
            continue
        assert item.__doc__, name
        for member in vars(item):
            if not member.startswith("_") and callable(getattr(item, member)):
                assert getattr(item, member).__doc__, f"{name}.{member}"
