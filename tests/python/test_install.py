"""pip builds a wheel from the tree and installs it without a network."""

import json
import os
import pathlib
import re
import subprocess
import sys
import zipfile

import pytest

ROOT = pathlib.Path(__file__).parents[2]
PROGRAM = "import rbpa, sys; print(rbpa.__file__); sys.exit(len(rbpa.Delaunay([[0, 0], [1, 0], [0, 1]]).simplices) - 1)"

NO_NETWORK = {**os.environ, "PIP_NO_INDEX": "1", "PIP_DISABLE_PIP_VERSION_CHECK": "1"}
NO_NETWORK.pop("PYTHONPATH", None)


def installed(folder: pathlib.Path, options: list, **environment: str) -> subprocess.CompletedProcess:
    """Returns the output of pip in a new environment."""
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


OF_EVERY_SYSTEM = re.compile(r"(linux-vdso|ld-linux[^/]*|libc|libm|libstdc\+\+|libgcc_s|libpthread|libdl|librt)\.so")


@pytest.mark.nightly
def test_a_wheel_stands_alone(tmp_path):
    """The wheel needs only libraries of every system, also at run time; the examples of the pages run with it."""
    ran = subprocess.run([sys.executable, "-m", "pip", "wheel", "--no-deps", "-w", tmp_path, ROOT], env=NO_NETWORK, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    (wheel,) = tmp_path.glob("rbpa-*.whl")
    assert re.search(r"-manylinux_2_\d+_", wheel.name) and wheel.stat().st_size <= 8 << 20
    with zipfile.ZipFile(wheel) as files:
        names = files.namelist()
        (bill,) = [json.loads(files.read(name)) for name in names if name.endswith(".cdx.json")]
        brought = [name for name in names if name.startswith("rbpa.libs/")]
        licenses = {name.rsplit("/", 1)[1]: files.read(name).decode() for name in names if "/licenses/" in name}
    assert bill["bomFormat"] == "CycloneDX" and len(bill["components"]) == len(brought) == len(licenses) - 1 > 3
    assert all(len(text) > 500 for text in licenses.values()) and "MIT License" in licenses["LICENSE"]

    environment = tmp_path / "environment"
    subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", environment], check=True)
    python = environment / "bin" / "python3"
    subprocess.run([python, "-m", "pip", "install", "--no-deps", wheel], env=NO_NETWORK, check=True, capture_output=True)
    (module,) = environment.glob("lib/python*/site-packages/rbpa/_core*.so")
    needed = subprocess.run(["ldd", module], check=True, capture_output=True, text=True).stdout
    for line in needed.splitlines():
        name, _, path = line.strip().partition(" => ")
        assert OF_EVERY_SYSTEM.match(pathlib.Path(name.split()[0]).name) or str(environment) in str(pathlib.Path(path.split()[0]).resolve()), line
    program = (
        "import numpy as np; loaded = set(open('/proc/self/maps').read().split()); import rbpa; rbpa.surface(np.random.rand(500, 3));"
        "rbpa.alpha_shape(np.random.rand(5000, 2)); now = set(open('/proc/self/maps').read().split());"
        "print('\\n'.join(sorted(name for name in now - loaded if '.so' in name)))"
    )
    used = subprocess.run([python, "-c", program], env={}, cwd=tmp_path, capture_output=True, text=True)
    assert used.returncode == 0, used.stderr
    for name in used.stdout.split():
        assert OF_EVERY_SYSTEM.match(pathlib.Path(name).name) or name.startswith((str(environment), "/usr/lib/python3")), name
    ran = subprocess.run(
        [python, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-m", "not nightly", ROOT / "tests" / "python" / "test_documentation.py"],
        env={**NO_NETWORK, "MPLBACKEND": "Agg"}, capture_output=True, text=True)  # fmt: skip
    assert ran.returncode == 0, ran.stdout
