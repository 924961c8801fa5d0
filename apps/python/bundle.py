"""Copies the shared libraries that an extension module needs into its wheel, as auditwheel does: with unique names, in
a folder next to the package, in which the module searches first. Needs patchelf and ldd.
"""

from __future__ import annotations

import hashlib
import json
import os
import pathlib
import platform
import re
import shutil
import subprocess
import uuid

# Libraries that every Linux system has, by PEP 600.
OF_THE_SYSTEM = re.compile(r"(libc|libm|libdl|librt|libpthread|libstdc\+\+|libgcc_s|ld-linux.*|linux-vdso)\.so")


def can_bundle() -> bool:
    return platform.libc_ver()[0] == "glibc" and all(shutil.which(tool) for tool in ("patchelf", "ldd"))


def platform_tag() -> str:
    """Returns the tag of a self-contained wheel, which needs the C library and libstdc++ of this system, or newer."""
    major, minor = platform.libc_ver()[1].split(".")[:2]
    return f"manylinux_{major}_{minor}_{platform.machine()}"


def output_of(*command: object) -> str:
    return subprocess.run([str(part) for part in command], check=True, capture_output=True, text=True).stdout


def libraries_of(module: pathlib.Path) -> dict[str, pathlib.Path]:
    """Returns, by name, the files of the libraries that a module needs, directly or not, except libraries that every
    Linux system has."""
    found = {}
    for line in output_of("ldd", module).splitlines():
        match = re.match(r"\s*(\S+) => (.*?)(?: \(0x[0-9a-f]+\))?$", line)
        if not match or OF_THE_SYSTEM.match(match[1]):
            continue
        if match[2] == "not found":
            raise SystemExit(f"rbpa: {module.name} needs {match[1]}, which is not found")
        found[match[1]] = pathlib.Path(match[2]).resolve()
    return found


def debian_package(library: pathlib.Path) -> tuple[str, str]:
    """Returns name and version of the package that contains a library; if dpkg does not know, the library's name and
    ""."""
    try:
        name = output_of("dpkg", "-S", f"*/{library.name}").split(":")[0]
        return name, output_of("dpkg-query", "-W", "-f=${Version}", name)
    except (OSError, subprocess.CalledProcessError):
        return re.split(r"[-.]", library.name)[0], ""


def look_in(folder: str, names: dict[str, str], file: pathlib.Path) -> None:
    """Sets the new names of the libraries that a file needs, and the folder in which the file searches. Sets one name
    at a time, as patchelf 0.14 confuses several."""
    needed = output_of("patchelf", "--print-needed", file).split()
    for old, new in names.items():
        if old in needed:
            output_of("patchelf", "--replace-needed", old, new, file)
    output_of("patchelf", "--set-rpath", folder, file)


def bundle(module: pathlib.Path, folder: pathlib.Path) -> list[dict[str, str]]:
    """Copies the libraries into the folder, and changes the module so that it finds them in ../<folder's name>.

    Returns for each library its "file" in the folder, the "package" and "version" it comes from, and the text of its
    "license".
    """
    folder.mkdir()
    names, parts = {}, []
    for needed, library in sorted(libraries_of(module).items()):
        digest = hashlib.sha256(library.read_bytes()).hexdigest()[:8]
        stem, ending = needed.split(".so", 1)
        names[needed] = f"{stem}-{digest}.so{ending}"
        shutil.copy(library, folder / names[needed])
        (folder / names[needed]).chmod(0o755)
        package, version = debian_package(library)
        text = pathlib.Path("/usr/share/doc", package, "copyright")
        parts.append({"file": names[needed], "package": package, "version": version,
                      "license": text.read_text(errors="replace") if text.exists() else ""})  # fmt: skip
    for name in names.values():
        output_of("patchelf", "--set-soname", name, folder / name)
        look_in("$ORIGIN", names, folder / name)
    look_in(f"$ORIGIN/{os.path.relpath(folder, module.parent)}", names, module)
    left = [path for path in libraries_of(module).values() if folder.resolve() not in path.parents]
    if left:
        raise SystemExit(f"rbpa: {module.name} still needs {', '.join(map(str, left))}")
    return parts


def bill_of_materials(name: str, version: str, parts: list[dict[str, str]]) -> str:
    """Returns the contents of a wheel as CycloneDX 1.5 (PEP 770)."""
    components = [
        {
            "type": "library",
            "bom-ref": part["file"],
            "name": part["package"],
            **({"version": part["version"]} if part["version"] else {}),
            **({"purl": f"pkg:deb/debian/{part['package']}@{part['version']}"} if part["version"] else {}),
        }
        for part in parts
    ]
    seed = json.dumps([name, version, components])
    return json.dumps(
        {
            "bomFormat": "CycloneDX",
            "specVersion": "1.5",
            "serialNumber": f"urn:uuid:{uuid.uuid5(uuid.NAMESPACE_URL, seed)}",
            "version": 1,
            "metadata": {
                "component": {
                    "type": "library",
                    "bom-ref": name,
                    "name": name,
                    "version": version,
                    "licenses": [{"license": {"id": "MIT"}}],
                    "purl": f"pkg:pypi/{name}@{version}",
                }
            },
            "components": components,
            "dependencies": [{"ref": name, "dependsOn": [part["file"] for part in parts]}],
        },
        indent=2,
    )
