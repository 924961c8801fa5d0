"""docs/drawings/draw.py draws figures of the pages."""

import pathlib
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).parents[2]


@pytest.mark.nightly
def test_all_figures_that_are_drawn_are_committed(tmp_path):
    pytest.importorskip("matplotlib")
    subprocess.run([sys.executable, ROOT / "docs" / "drawings" / "draw.py", "--to", tmp_path], check=True)
    drawn = {figure.name for figure in tmp_path.iterdir()}
    assert len(drawn) >= 10
    assert drawn <= {figure.name for figure in (ROOT / "docs" / "figures").iterdir()}
