"""Files that pages, docstrings, comments and messages name exist.

A path is relative to the root, to src/pointloom, or to a folder above the file that names it. A name without a folder
may be that of any file of the repository. Not checked:

- files of other projects, which follow the possessive of their owner: Open3D's `initialize_config.py`;
- in code (fenced blocks, and spans with a space): paths that do not begin with a folder of the repository;
- strings outside src, which are data.

A word in capitals stands for any text: `constraints/NAME.txt`.
"""

import re
from collections.abc import Iterator
from fnmatch import fnmatchcase
from functools import cache
from pathlib import Path

import pytest

from .programs import ROOT, script

FOLDERS = (
    ".ci",
    ".github",
    "benchmarks",
    "changes",
    "constraints",
    "docs",
    "recipe",
    "scripts",
    "src",
    "tests",
    "typings",
)
GENERATED = {f"docs/{name}" for name in script("check_prose").GENERATED}
TOKEN = script("check_prose").TOKEN
EVERYWHERE = {"py", "pyi", "h", "md"}  # files with other suffixes are checked if their path begins with one of FOLDERS
SUFFIX = re.compile(r"\.(pyi?|h|md|sh|toml|txt|json|js|css|rst|ya?ml|npz|png|jpg)\b(?![\w*/{<(-]|\.\w)")
START = re.compile(r"(?<![\w./<>{}*$%~\\-])(?:\.{1,2}/)*((?:[\w-][\w.-]*/|\.(?:ci|github)/)*[\w-][\w.-]*)$")
CODE = re.compile(r"^[ \t]*```.*?^[ \t]*```|`[^`]+`", re.M | re.S)
OWNER = re.compile(r"['’]s[\s#]+`?$")


@cache
def tree() -> tuple[frozenset[str], frozenset[str]]:
    """The files of the repository by path, and their names."""
    paths = [path for folder in FOLDERS for path in (ROOT / folder).rglob("*")]
    paths += [path for path in ROOT.iterdir() if path.is_file()]
    names = {path.relative_to(ROOT).as_posix() for path in paths}
    files = {name for name in names if "/".join(name.split("/")[:2]) not in GENERATED}
    return frozenset(files), frozenset(name.rpartition("/")[2] for name in files)


def exists(path: str, source: str) -> bool:
    """True if a file that a text in `source` names exists."""
    files, names = tree()
    folders = ("", "src/pointloom/", *(f"{folder.as_posix()}/" for folder in Path(source).parents))
    if any(folder + path in files for folder in folders):
        return True
    if "/" not in path:
        return path in names or path[0].lower() + path[1:] in names  # the first word of a sentence
    pattern = re.sub(r"[A-Z]{3,}", "*", path)
    return pattern != path and any(fnmatchcase(name, pattern) for name in files)


def named_files(text: str) -> Iterator[tuple[int, str]]:
    """Position and path of each file of this repository that a text names."""
    code = [match.span() for match in CODE.finditer(text) if re.search(r"\s", match[0])]
    for match in SUFFIX.finditer(text):
        start = START.search(text, max(0, match.start() - 120), match.start())
        if not start or OWNER.search(text, 0, start.start()):
            continue
        path = f"{start[1]}.{match[1]}"
        is_here = path.partition("/")[0] in FOLDERS and "/" in path
        is_code = any(begin <= start.start() < end for begin, end in code)
        if is_here or (match[1] in EVERYWHERE and not is_code):
            yield start.start(), path


def missing(text: str, source: str) -> Iterator[str]:
    """A message for each file that a text names and that does not exist."""
    wrong = [(position, path) for position, path in named_files(text) if not exists(path, source)]
    if wrong and source.endswith(".py"):
        groups = {"docstrings", "comments"} | ({"messages"} if source.startswith("src/") else set())
        parts = [match.span() for match in TOKEN.finditer(text) if match.lastgroup in groups]
        wrong = [each for each in wrong if any(begin <= each[0] < end for begin, end in parts)]
    for position, path in wrong:
        yield f"{source}:{text.count(chr(10), 0, position) + 1}: {path}"


def test_every_named_file_exists():
    sources = [name for name in sorted(tree()[0]) if name.endswith((".py", ".md")) or name in ("Makefile", ".ci/run")]
    texts = {name: (ROOT / name).read_text() for name in sources}
    texts["CHANGELOG.md"] = "\n## ".join(texts["CHANGELOG.md"].split("\n## ")[:2])  # old sections name old files
    assert [message for name, text in texts.items() for message in missing(text, name)] == []


@pytest.mark.parametrize(
    ("text", "source"),
    [
        ("See `kernels/search/lanes.py`.", "docs/a.md"),
        ("# as in no_such_file.py", "tests/a.py"),
        ('"""Points (search/point_tree.py)."""', "src/pointloom/pcd/a.py"),
        ('f"run {python} benchmarks/no_such_file.py"', "src/pointloom/pcd/a.py"),
        ("```\npython benchmarks/no_such_file.py\n```", "docs/a.md"),
        ("The record docs/names-VERSION.txt.", "docs/a.md"),
        ("The oracle's results are in tests/answers.json.", "docs/a.md"),
    ],
)
def test_missing_files_are_found(text, source):
    assert len([*missing(text, source)]) == 1


@pytest.mark.parametrize(
    ("text", "source"),
    [
        ("`kernels/search/point_tree.py`, point_tree.py, `../CHANGELOG.md`, docs/api.txt. Lang.py.", "docs/a.md"),
        ('"""Points (search/point_tree.py)."""', "src/pointloom/kernels/pcd/a.py"),
        ("As in Open3D's `reconstruction/no_such_file.py`, with `python no_such_file.py`.", "docs/a.md"),
        ("```\npython no_such_file.py\n```\n", "docs/a.md"),
        ("tests/test_*.py, src/<name>.py, poses.txt, constraints/NAME.txt", "docs/a.md"),
        ('write("tests/no_such_file.py")', "tests/a.py"),
    ],
)
def test_existing_files_and_those_of_others_are_accepted(text, source):
    assert [*missing(text, source)] == []
