"""Writes a stub with the types of the compiled module for type checkers and editors, from the signatures in pybind11's
docstrings:

    python3 make_stub.py _core.cpython-311-x86_64-linux-gnu.so _core.pyi

Needs only Python, as the module is imported without NumPy, so that it works in every build by pip.
"""

from __future__ import annotations

import importlib.util
import inspect
import re
import sys
from typing import Any, Iterator

HEAD = '''"""The compiled part of rbpa. Written by make_stub.py."""

from collections.abc import Callable, Sequence
from typing import Any, Optional, overload

import numpy as np
import numpy.typing as npt

from rbpa._input import Indices, Progress
'''

# Types as pybind11 writes them, each with Python's type; replaced in this order.
TYPES = [
    (r"numpy\.ndarray\[(?:bool|numpy\.bool_?)\]", "npt.NDArray[np.bool_]"),
    (r"numpy\.ndarray\[numpy\.(\w+)\]", r"npt.NDArray[np.\1]"),
    (r"\bList\[", "list["),
    (r"\bDict\[", "dict["),
    (r"\bTuple\[", "tuple["),
    (r"\bdict\b(?!\[)", "dict[str, Any]"),
    (r"\blist\b(?!\[)", "list[Any]"),
    # Arguments whose types in the stub are more precise than those in C++.
    (r"\bprogress: object", "progress: Progress"),
    (r"\bweight: (function|Callable)", "weight: Callable[[int, int, int], float]"),
    (r"\bpoint_of_vertex: Optional\[list\[int\]\]", "point_of_vertex: Optional[Sequence[int] | Indices]"),
]
SPECIAL = ("__init__", "__neg__", "__add__")  # special methods to list; every object has the others


def typed(signature: str, classes: dict[str, type]) -> str:
    for pattern, wanted in TYPES:
        signature = re.sub(pattern, wanted, signature)
    signature = re.sub(r"\b[\w.]+\.(\w+)", lambda name: name[1] if name[1] in classes else name[0], signature)
    if re.search(r"::|\bnumpy\.|\btuple\b(?!\[)", signature):
        raise SystemExit(f"make_stub.py: found {signature!r}, expected types of Python, and what arrays and tuples consist of")
    return signature


def body(text: str, indent: str) -> str:
    """Returns the text behind a signature: the documentation, or an ellipsis."""
    text = text.strip().replace("\\", "\\\\")
    return f'\n{indent}    """{text}"""' if text else " ..."


def functions(name: str, function: Any, classes: dict[str, type], indent: str) -> Iterator[str]:
    parts = re.split(rf"^(?:\d+\. )?{name}(?=\(.*\) -> )", function.__doc__, flags=re.MULTILINE)[1:]
    for part in parts:
        signature, _, text = part.partition("\n")
        if len(parts) > 1:
            yield f"{indent}@overload"
        signature = re.sub(r"\(self: [\w.:]+", "(self", typed(signature, classes))
        yield f"{indent}def {name}{signature}:{body(text, indent)}"


def members(of: type, classes: dict[str, type]) -> Iterator[str]:
    for name, value in vars(of).items():
        if isinstance(value, property):
            kind = typed(value.fget.__doc__.splitlines()[0].rpartition(" -> ")[2], classes)
            yield f"    @property\n    def {name}(self) -> {kind}:{body(value.__doc__ or '', '    ')}"
        elif callable(value) and (name in SPECIAL or not name.startswith("__")):
            yield from functions(name, value, classes, "    ")


def stub(module: Any) -> str:
    classes = dict(inspect.getmembers(module, inspect.isclass))
    lines = [HEAD]
    for name, value in vars(module).items():
        if name in classes:
            bases = [base.__name__ for base in value.__bases__ if base.__name__ != "pybind11_object"]
            inside = list(members(value, classes))
            text = value.__doc__ or ""
            head = f"class {name}({', '.join(bases)}):" if bases else f"class {name}:"
            lines.append(head + (body(text, "") if text or not inside else ""))
            lines.extend(inside)
        elif isinstance(value, str) and not name.startswith("__"):
            lines.append(f"{name}: str")
        elif callable(value) and not name.startswith("__"):
            lines.extend(functions(name, value, classes, ""))
    return "\n".join(lines) + "\n"


def main(library: str, output: str) -> None:
    spec = importlib.util.spec_from_file_location("_core", library)
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    text = stub(module)
    compile(text, output, "exec")
    with open(output, "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    main(*sys.argv[1:])
