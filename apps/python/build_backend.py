"""Builds a wheel from the source tree for pip (PEP 517): CMake builds the package, and the wheel is a zip of the
package.

Downloads nothing: the build requirements of the library and pybind11 must be installed (docs/reference/python.md). If
patchelf is installed, the wheel contains the shared libraries that the package needs.
"""

from __future__ import annotations

import base64
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile

import bundle

ROOT = pathlib.Path(__file__).resolve().parents[2]


def version() -> str:
    found = re.search(r"^project\(rbpa VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE)
    if not found:
        raise SystemExit("CMakeLists.txt: found no project(rbpa VERSION ...), expected one")
    return found[1]


def metadata() -> str:
    return (
        "Metadata-Version: 2.1\nName: rbpa\n"
        f"Version: {version()}\n"
        "Summary: Alpha shapes, concave hulls and Delaunay triangulations in the plane, surfaces in space, exact and fast\n"
        "License: MIT\nRequires-Python: >=3.9\nRequires-Dist: numpy\n"
        "Description-Content-Type: text/markdown\n\n" + (ROOT / "docs" / "reference" / "python.md").read_text()
    )


def say(sentence: str) -> None:
    """Prints a line that `pip install -v` shows immediately, and `pip install` only if the build fails."""
    print(f"rbpa: {sentence}", file=sys.stderr, flush=True)


def answers(*command: str) -> bool:
    try:
        return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode == 0
    except OSError:
        return False


def missing() -> list[str]:
    """Returns the missing build tools, each with its Debian package. CMake checks the libraries."""
    found = []
    if not answers(os.environ.get("CXX", "c++"), "--version"):
        found.append("C++ compiler (Debian: g++)")
    if not answers("cmake", "--version"):
        found.append("CMake (Debian: cmake)")
    elif not shutil.which("make") and "CMAKE_GENERATOR" not in os.environ:
        found.append("make (Debian: make)")
    if not pathlib.Path(sysconfig.get_path("include"), "Python.h").exists():
        found.append("Python.h (Debian: python3-dev)")
    return found


def configure(folder: pathlib.Path) -> None:
    """Checks the requirements and configures the build, in seconds; the build takes minutes."""
    found = missing()
    if found:
        raise SystemExit("rbpa: cannot be built: there is no " + ", no ".join(found))
    say("checking the build requirements")
    run("see above for what is missing", "-S", str(ROOT), "-B", str(folder), "-DCMAKE_BUILD_TYPE=Release", "-DRBPA_BUILD_PYTHON=ON",
        "-DRBPA_COMPILE_TOGETHER=ON", "-DRBPA_BUILD_APPS=OFF", "-DRBPA_BUILD_TESTS=OFF", f"-DPython_EXECUTABLE={sys.executable}")  # fmt: skip


def run(advice: str, *arguments: str) -> None:
    if subprocess.run(["cmake", *arguments], stdout=sys.stderr).returncode:
        raise SystemExit(f"rbpa: cmake {arguments[0]} failed: {advice}")


def build_package(folder: pathlib.Path) -> pathlib.Path:
    """Builds the package for the running Python. Returns the folder of the package."""
    configure(folder)
    jobs = str(os.cpu_count() or 1)
    say(f"compiling with {jobs} processes, which takes minutes")
    run("see above for what did not compile", "--build", str(folder), "--parallel", jobs, "--target", "rbpa_python_package")
    return folder / "python" / "rbpa"


def prepare_metadata_for_build_wheel(metadata_directory: str, config_settings=None) -> str:
    """Writes the metadata, so that pip finds or downloads NumPy, or fails, before the package is compiled."""
    with tempfile.TemporaryDirectory() as folder:
        configure(pathlib.Path(folder))
    info = pathlib.Path(metadata_directory, f"rbpa-{version()}.dist-info")
    info.mkdir()
    (info / "METADATA").write_text(metadata())
    return info.name


def strip(module: pathlib.Path) -> None:
    """Removes symbols that only debuggers need from a module, if the program strip is installed."""
    if shutil.which("strip"):
        subprocess.run(["strip", "--strip-unneeded", str(module)], check=True)


def build_wheel(wheel_directory: str, config_settings=None, metadata_directory=None) -> str:
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    info = f"rbpa-{version()}.dist-info"
    record: list[str] = []

    with tempfile.TemporaryDirectory() as folder:
        package = build_package(pathlib.Path(folder))
        (module,) = package.glob("_core*.so")
        strip(module)
        libraries = package.with_name("rbpa.libs")
        parts: list[dict[str, str]] = []
        system = re.sub(r"[-.]", "_", sysconfig.get_platform())
        if bundle.can_bundle():
            parts = bundle.bundle(module, libraries)
            system = bundle.platform_tag()
            say(f"{len(parts)} shared libraries are included: the wheel is self-contained")
        else:
            say("patchelf is missing (Debian: patchelf): the wheel needs the libraries of this machine")
        tag = f"{python}-{python}-{system}"
        name = f"rbpa-{version()}-{tag}.whl"
        with zipfile.ZipFile(pathlib.Path(wheel_directory, name), "w", zipfile.ZIP_DEFLATED) as wheel:

            def add(path: str, content: bytes) -> None:
                digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
                record.append(f"{path},sha256={digest},{len(content)}")
                wheel.writestr(path, content)

            for file in sorted(package.iterdir()):
                if file.is_file():
                    add(f"rbpa/{file.name}", file.read_bytes())
            for part in parts:
                add(f"rbpa.libs/{part['file']}", (libraries / part["file"]).read_bytes())
                add(f"{info}/licenses/{part['package']}", part["license"].encode())
            if parts:
                add(f"{info}/sboms/rbpa.cdx.json", bundle.bill_of_materials("rbpa", version(), parts).encode())
            add(f"{info}/licenses/LICENSE", (ROOT / "LICENSE").read_bytes())
            add(f"{info}/METADATA", metadata().encode())
            add(f"{info}/WHEEL", f"Wheel-Version: 1.0\nGenerator: rbpa\nRoot-Is-Purelib: false\nTag: {tag}\n".encode())
            wheel.writestr(f"{info}/RECORD", "\n".join([*record, f"{info}/RECORD,,", ""]))
    return name


def build_sdist(sdist_directory: str, config_settings=None) -> str:
    top = f"rbpa-{version()}"
    kept = ["CMakeLists.txt", "CMakePresets.json", "LICENSE", "README.md", "CHANGELOG.md", "pyproject.toml",
            "libmeshops", "librbpa", "apps", "docs/reference/python.md"]  # fmt: skip

    def source(member: tarfile.TarInfo) -> tarfile.TarInfo | None:
        return None if "__pycache__" in member.name else member

    with tarfile.open(pathlib.Path(sdist_directory, f"{top}.tar.gz"), "w:gz", format=tarfile.PAX_FORMAT) as archive:
        for path in kept:
            archive.add(ROOT / path, f"{top}/{path}", filter=source)
        with tempfile.TemporaryDirectory() as folder:
            info = pathlib.Path(folder, "PKG-INFO")
            info.write_text(metadata())
            archive.add(info, f"{top}/PKG-INFO")
    return f"{top}.tar.gz"
