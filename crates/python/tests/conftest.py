"""What several tests need."""

import os
import pathlib

import pytest


@pytest.fixture
def program():
    """The program `heavytop`: that of HEAVYTOP_PROGRAM, or a release of this checkout."""
    release = pathlib.Path(__file__).parents[3] / "target/release/heavytop"
    found = os.environ.get("HEAVYTOP_PROGRAM", str(release))
    if not pathlib.Path(found).exists():
        pytest.skip("there is no program heavytop; cargo build --release makes one")
    return found
