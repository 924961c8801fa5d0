"""pip makes a wheel of the tree and installs it, without a network."""

import os
import pathlib
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).parents[2]
PROGRAM = "import rbpa, sys; print(rbpa.__file__); sys.exit(len(rbpa.Delaunay([[0, 0], [1, 0], [0, 1]]).simplices) - 1)"

NO_NETWORK = {**os.environ, "PIP_NO_INDEX": "1", "PIP_DISABLE_PIP_VERSION_CHECK": "1"}
NO_NETWORK.pop("PYTHONPATH", None)


def installed(folder: pathlib.Path, options: list, **environment: str) -> subprocess.CompletedProcess:
    """What pip says in a new environment."""
    subprocess.run([sys.executable, "-m", "venv", *options, folder / "new"], check=True)
    command = [folder / "new" / "bin" / "python3", "-m", "pip", "install", ROOT]
    return subprocess.run(command, env={**NO_NETWORK, **environment}, capture_output=True, text=True)


def test_without_numpy_pip_fails_before_anything_is_compiled(tmp_path):
    compiled, launcher = tmp_path / "compiled", tmp_path / "launcher"
    launcher.write_text(f'#!/bin/sh\ncase "$*" in */librbpa/*) echo "$*" >>{compiled}; exit 1;; esac\nexec "$@"\n')
    launcher.chmod(0o755)
    ran = installed(tmp_path, [], CMAKE_CXX_COMPILER_LAUNCHER=str(launcher))
    assert ran.returncode != 0 and "No matching distribution found for numpy" in ran.stderr
    assert not compiled.exists()


@pytest.mark.nightly
def test_without_tools_pip_says_all_that_is_missing_at_once(tmp_path):
    (tmp_path / "bin").mkdir()
    ran = installed(tmp_path, ["--system-site-packages"], PATH=str(tmp_path / "bin"))
    said = ran.stdout + ran.stderr
    assert ran.returncode != 0 and "Building wheel" not in said
    assert "rbpa: cannot be built: there is no C++ compiler (Debian: g++), no CMake (Debian: cmake)" in said


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
    ran = subprocess.run([python, "-m", "pip", "install", source], env=NO_NETWORK, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    used = subprocess.run([python, "-c", PROGRAM], env={}, cwd=tmp_path, capture_output=True, text=True)
    assert used.returncode == 0, used.stderr
    assert used.stdout.startswith(str(environment))
    listed = subprocess.run([python, "-m", "pip", "show", "-f", "rbpa"], capture_output=True, text=True, check=True).stdout
    assert "rbpa/py.typed" in listed and "rbpa/_core.pyi" in listed
