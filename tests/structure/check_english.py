"""Counts odd English in comments, help texts, messages and pages, and comments beyond the last column; fails above a bound.

usage: check_english.py ROOT [--list]     --list prints every place
A place is something to read aloud, not a verdict: docs/contributing/style.md has the rules.
"""

import pathlib
import re
import sys

BOUND = 20  # places in the whole tree
COLUMNS = 120

# A comment does not begin with a word that leans on the code below it.
OPENING = re.compile(
    r"(?:///?<?|//!|\*)\s*"
    r"(?:Of|Those|That|What|Where|The same|As|So|Whose|Which|Who|How|Not|Nothing|None|No one|Neither)\b(?!:)"
)
PHRASES = re.compile(
    r"\b(?:foretold|hangs? together|comes? apart|goes on|go on|as many as there|so many (?:of|as)|no more (?:than|what)"
    r"|what (?:is|are) (?:told|said)|(?:is|are) (?:told|had|asked)|told|parted|at hand|nobody else"
    r"|says? (?:of|what|so|which)|said of|takes? along|lets? in|has of|of which the|which are what|what it is about)\b",
    re.IGNORECASE,
)
CODE = {".h", ".cpp", ".js", ".mjs"}
TEXT = {".py", ".md", ".cmake", ".sh"}
SKIPPED = ("vendor/", "corpus", "tests/data", "build/", ".git/", "rbpa-demo/", "node_modules/", "tests/structure/check_english.py")


def places(path: pathlib.Path):
    """Yields (line number, text) of each odd place, and of each comment beyond the last column."""
    follows_comment = False
    for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1):
        text = line
        if path.suffix in CODE:
            comment = re.search(r"//.*|^\s*\*.*", line)
            quoted = [] if "#include" in line else re.findall(r'"(?:[^"\\]|\\.)*"', line)
            text = " ".join([comment.group(0) if comment else "", *quoted])
            if comment and not follows_comment and OPENING.match(comment.group(0).strip()):
                yield number, comment.group(0).strip()
            follows_comment = line.strip().startswith(("//", "*"))
            if comment and path.suffix in {".h", ".cpp"} and len(line) > COLUMNS:
                yield number, f"{len(line)} columns"
        for match in PHRASES.finditer(text):
            yield number, match.group(0)


def main() -> int:
    root = pathlib.Path(sys.argv[1])
    total, files = 0, 0
    for path in sorted(root.rglob("*")):
        name = path.relative_to(root).as_posix()
        is_text = path.suffix in CODE | TEXT or path.name == "CMakeLists.txt"
        if not is_text or path.name == "CHANGELOG.md" or any(part in name for part in SKIPPED) or not path.is_file():
            continue
        files += 1
        for number, text in places(path):
            total += 1
            if "--list" in sys.argv:
                print(f"{name}:{number}: {text}")
    print(f"{total} places in {files} files, at most {BOUND} are expected")
    if files < 500:
        print("too few files: the check looks in the wrong place")
        return 1
    return int(total > BOUND)


if __name__ == "__main__":
    sys.exit(main())
