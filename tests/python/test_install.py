"""pip makes a wheel of the tree and installs it, without a network."""

import os
import pathlib
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).parents[2]
PROGRAM = "import rbpa, sys; print(rbpa.__file__); sys.exit(len(rbpa.Delaunay([[0, 0], [1, 0], [0, 1]]).simplices) - 1)"


@pytest.mark.nightly
@pytest.mark.parametrize("kind", ["tree", "sdist"])
def test_pip_installs_the_package(tmp_path, kind):
    environment = tmp_path / "environment"
    subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", environment], check=True)
    python = environment / "bin" / "python3"
    source = ROOT
    if kind == "sdist":
        sys.path.insert(0, str(ROOT / "apps" / "python"))
        import build_backend

        source = tmp_path / build_backend.build_sdist(str(tmp_path))
    no_network = {**os.environ, "PIP_NO_INDEX": "1", "PIP_DISABLE_PIP_VERSION_CHECK": "1"}
    del no_network["PYTHONPATH"]
    ran = subprocess.run([python, "-m", "pip", "install", source], env=no_network, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    used = subprocess.run([python, "-c", PROGRAM], env={}, cwd=tmp_path, capture_output=True, text=True)
    assert used.returncode == 0, used.stderr
    assert used.stdout.startswith(str(environment))
    listed = subprocess.run([python, "-m", "pip", "show", "-f", "rbpa"], capture_output=True, text=True, check=True).stdout
    assert "rbpa/py.typed" in listed and "rbpa/_core.pyi" in listed
