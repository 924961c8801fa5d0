"""Examples of Python in pages and docstrings give the documented results."""

import ast
import doctest
import functools
import pathlib
import pydoc
import re

import numpy as np
import pytest
import rbpa
import rbpa.meshops

ROOT = pathlib.Path(__file__).parents[2]
PUBLIC = [name for name in rbpa.__all__ if not name.startswith("__")]


def blocks(page: pathlib.Path) -> list:
    return re.findall(r"^```python\n(.*?)^```", page.read_text(), re.DOTALL | re.MULTILINE)


PAGES = [str(page.relative_to(ROOT)) for page in (ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))) if blocks(page)]


def test_pages_are_found():
    assert len(PAGES) >= 7


@pytest.mark.parametrize("page", PAGES)
def test_lines_of_pages_run(page, tmp_path, monkeypatch):
    found = blocks(ROOT / page)
    if any("rbpa.dask" in block for block in found):
        pytest.importorskip("dask")
    (tmp_path / "tests").symlink_to(ROOT / "tests")
    monkeypatch.chdir(tmp_path)
    pytest.importorskip("matplotlib")
    names: dict = {}
    for block in found:
        for statement in ast.parse(block).body:
            text = ast.unparse(statement)
            said = block.splitlines()[statement.end_lineno - 1].partition("# -> ")[2]
            if said:  # the documented value of the expression before it
                assert repr(eval(text, names)) == said, text
            else:
                exec(text, names)


def test_examples_in_docstrings_are_right():
    count = 0
    finder = doctest.DocTestFinder(recurse=True)
    runner = doctest.DocTestRunner()
    for thing in (rbpa, rbpa.meshops, rbpa.molecules, *(getattr(rbpa, name) for name in PUBLIC)):
        # Methods are in private modules: without this, their examples would be left out.
        for test in finder.find(thing, module=False if isinstance(thing, type) else None, globs={"rbpa": rbpa, "np": np}):
            count += len(test.examples)
            assert runner.run(test).failed == 0, test.name
    assert count >= 16


@pytest.mark.parametrize("name", PUBLIC)
def test_everything_public_has_a_docstring(name):
    thing = getattr(rbpa, name)
    assert thing.__doc__ and thing.__module__ == "rbpa"
    if isinstance(thing, type):
        for member, value in vars(thing).items():
            if not member.startswith("_") and (callable(value) or isinstance(value, (property, functools.cached_property))):
                assert value.__doc__, f"{name}.{member}"


def test_help_of_the_package_names_all_that_is_there():
    text = pydoc.plain(pydoc.render_doc(rbpa))
    for name in PUBLIC:
        assert name in text


def test_the_page_of_reference_names_all_that_is_there():
    page = (ROOT / "docs/reference/python.md").read_text()
    assert [name for name in PUBLIC if name not in page] == []


def test_the_side_of_estimated_normals_is_called_a_guess():
    said = " ".join(rbpa.estimate_normals.__doc__.split())
    assert "The sign is a guess" in said and "have them outward" not in said


def test_named_tuples_hide_no_method_of_tuples_and_print_no_arrays():
    kinds = [thing for thing in map(rbpa.__dict__.get, PUBLIC) if hasattr(thing, "_fields")] + [rbpa.meshops.Repair]
    assert len(kinds) >= 9
    for kind in kinds:
        assert not {"count", "index"} & set(kind._fields), kind
        row = kind(*[np.arange(3000)] * len(kind._fields))
        assert "3000" in repr(row) or kind in (rbpa.Plateau, rbpa.SolidPlateau, rbpa.BallUnion, rbpa.VoidEvent), kind
        assert len(repr(row)) < 600 or "3000" not in repr(row), kind
    for name in rbpa.VoidTree._fields:
        assert f"{name} : " in rbpa.VoidTree.__doc__


def test_messages_print_no_arrays():
    large = np.linspace(0, 1, 4000).reshape(1000, 4)
    points = np.random.default_rng(0).random((20, 2))
    in_space = np.random.default_rng(0).random((20, 3))
    for call in (
        lambda: rbpa.alpha_shape(points, large),
        lambda: rbpa.alpha_shape(points, cover=large),
        lambda: rbpa.alpha_shape(points, large, cover=0.5),
        lambda: rbpa.alpha_shape(points, components=large),
        lambda: rbpa.alpha_shape(points, threads=large.tolist()),
        lambda: rbpa.alpha_shapes(points, large, 1),
        lambda: rbpa.alpha_shapes(points, np.arange(20), list("ab") * 500),
        lambda: rbpa.Delaunay(points).interpolate(np.arange(20), points, method=large.tolist()),
        lambda: rbpa.filtration(points).persistence(large.tolist()),
        lambda: rbpa.filtration(points).representatives(levels=large),
        lambda: rbpa.surface(in_space, radius=list("ab") * 500),
        lambda: rbpa.surface(in_space, radius=large[None]),
        lambda: rbpa.periodic_solid(in_space, large),
        lambda: rbpa.solid(in_space, large),
        lambda: rbpa.solid(in_space, "a" * 4000),
    ):
        with pytest.raises(rbpa.InvalidInput) as error:
            call()
        assert len(str(error.value)) < 250, str(error.value)
