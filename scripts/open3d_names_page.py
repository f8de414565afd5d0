"""Text of docs/open3d-names.md: each name of the installed Open3D in `pointloom.open3d`, and its equivalent in `loom`.

Also of docs/other-libraries.md. `scripts/write_open3d_names.py` writes both pages. Tests compare the stored pages.
Differences in behavior are the rows of scripts/open3d_differences.toml.
"""

from __future__ import annotations

import dataclasses
import importlib
import inspect
import itertools
import re
import tomllib
from collections.abc import Iterable
from pathlib import Path
from types import ModuleType
from typing import Any

from pointloom.core.open3d_names import BRIDGE, COMMON, SHAPES, row_of, sections
from pointloom.core.open3d_names import MODULES as MODULE_SECTIONS

MODULES = (
    "camera", "core", "core.cuda", "core.nns", "data", "geometry", "geometry.keypoint", "io",
    "pipelines.color_map", "pipelines.integration", "pipelines.odometry", "pipelines.registration",
    "t.geometry", "t.io", "t.pipelines.odometry", "t.pipelines.registration",
    "t.pipelines.registration.robust_kernel", "t.pipelines.slac", "t.pipelines.slam",
    "utility", "utility.random", "visualization",
)  # fmt: skip
WITHOUT = {  # modules of Open3D that pointloom.open3d does not have, and the reason
    "ml": "Open3D-ML needs Open3D's own library. pointloom gives arrays to torch without a copy",
    "visualization.gui": "windows with widgets. `o3d.visualization.draw` and `loom.Viewer` open a page in the browser",
    "visualization.rendering": "a rendering engine. `loom.render` draws images without a window",
    "visualization.app": "a program. `pointloom view FILE` opens a page in the browser",
    "visualization.webrtc_server": "every window is a page of the browser already",
    "io.rpc": "connections to Open3D's viewer. `loom.Viewer` takes updates from any thread",
}
ABSTRACT = {"Geometry", "Geometry2D", "Geometry3D", "MeshBase", "KDTreeSearchParam"}  # scripts make no objects of them
ARTIFACTS = {"m", "n", "capsule", "open3d", "name", "value", "o3d", "annotations"}  # of Open3D's bindings
HEAD = """# Every name of Open3D

`.venv/bin/python scripts/write_open3d_names.py` writes this page from Open3D {version} and pointloom.

## In `pointloom.open3d`

A name is *same* if it is available and no difference is known, *differs* if a result or an accepted argument is
different, and *missing* if it raises an error with the alternative. Differences that concern many functions are listed
in [open3d.md](open3d.md).

{counts}

Not here as a whole:

{without}
"""
COMMON_HEAD = """# Names of other libraries

Names that users of PCL, PDAL, CloudCompare, trimesh, PyVista, PyTorch3D, SciPy, evo and torch try, with the equivalents
in pointloom. Accessing such a name, or passing such an argument, raises an error with its row of this table, as
`loom.load` or `mesh.faces`. Names with the same words as a public name are found in all modules: `loom.M3C2` leads to
`loom.m3c2`. The names of Open3D are on a [page of their own](open3d-names.md).
`.venv/bin/python scripts/write_open3d_names.py` writes this page.

| name | pointloom |
|---|---|
"""
EQUIVALENTS = """## In `pointloom`

Names that are the same in the same module are not listed. Accessing another name raises an error with its row of this
table, for example `loom.KDTreeFlann`.

| Open3D | pointloom |
|---|---|
"""


@dataclasses.dataclass
class Table:
    """The names of a module or a class of Open3D in pointloom.open3d."""

    path: str
    same: list[str] = dataclasses.field(default_factory=list)
    differs: dict[str, str] = dataclasses.field(default_factory=dict)
    missing: dict[str, str] = dataclasses.field(default_factory=dict)

    def counts(self) -> list[int]:
        return [len(self.same), len(self.differs), len(self.missing)]

    def text(self, title: str) -> str:
        rows = [f"| {', '.join(f'`{name}`' for name in self.same)} | same |"] if self.same else []
        rows += [f"| `{name}` | differs: {how} |" for name, how in self.differs.items()]
        rows += [f"| `{name}` | missing: {why} |" for name, why in self.missing.items()]
        return f"{title} {self.path}\n\n" + "\n".join(["| names | |", "|---|---|", *map(escaped, rows)]) + "\n"


def differences() -> dict[str, str]:
    """Dotted names or patterns -> how pointloom.open3d differs."""
    return tomllib.loads(Path(__file__).with_name("open3d_differences.toml").read_text("utf-8"))


def matches(name: str, pattern: str) -> bool:
    """True if a dotted name has the pattern, where `*` is any text without dots."""
    return re.fullmatch(re.escape(pattern).replace(r"\*", "[^.]*"), name) is not None


def public(owner: Any) -> list[str]:
    """The public names of a module or class, without submodules."""
    inherited = dir(int) if isinstance(owner, type) and issubclass(owner, int) else ()
    names = [name for name in dir(owner) if not name.startswith("_") and name not in {*ARTIFACTS, *inherited}]
    return [name for name in names if not isinstance(getattr(owner, name), ModuleType)]


def of_path(root: Any, path: str) -> Any:
    """The attribute at a dotted path, or None if it does not exist."""
    for part in path.split("."):
        try:
            root = getattr(root, part)
        except (AttributeError, ImportError):
            return None
    return root


def members(kind: Any) -> set[str]:
    """The members of a class of pointloom.open3d, including fields and parameters of its constructor."""
    if not isinstance(kind, type):
        return set(dir(kind))
    fields = {name for base in kind.__mro__ for name in getattr(base, "__annotations__", {})}
    return {*dir(kind), *fields, *inspect.signature(kind).parameters}


def table_of(open3d: Any, ours: Any, path: str, known: dict[str, str]) -> Table:
    """Compare the names at a path. Members of a class that is missing as a whole are not listed."""
    table, theirs, mine = Table(path), of_path(open3d, path), of_path(ours, path)
    available = members(mine) if isinstance(theirs, type) else set()
    for name in public(theirs):
        dotted = f"{path}.{name}"
        if name not in available and of_path(ours, dotted) is None:
            table.missing[name] = reason(theirs, path, name)
        elif how := next((how for pattern, how in known.items() if matches(dotted, pattern)), None):
            table.differs[name] = how
        else:
            table.same.append(name)
    return table


def reason(owner: Any, path: str, name: str) -> str:
    """The alternative to a missing name."""
    if isinstance(owner, type):
        bases = [base.__name__ for base in owner.__mro__]
        row = row_of(name, [*(f"{BRIDGE}.{base}" for base in bases), *bases, SHAPES])
    else:
        row = row_of(name, [BRIDGE, *MODULE_SECTIONS])
    if row is None:
        raise LookupError(f"open3d.{path}.{name}: expected a row in src/pointloom/core/open3d_names.toml, found none")
    return row.removeprefix("not here").lstrip(":; ") or "no counterpart"


def tables(open3d: Any, ours: Any) -> dict[str, list[Table]]:
    """For each module its own table and those of its classes."""
    known, made = differences(), {}
    for module in MODULES:
        table = table_of(open3d, ours, module, known)
        paths = [f"{module}.{name}" for name in (*table.same, *table.differs) if name not in ABSTRACT]
        inner = [table_of(open3d, ours, path, known) for path in paths if isinstance(of_path(open3d, path), type)]
        made[module] = [table, *(one for one in inner if sum(one.counts()))]
    return made


def page() -> str:
    """The text of the page.

    Raises:
        ModuleNotFoundError: Open3D is not installed.
        LookupError: A missing name has no alternative in the table of names.
    """
    open3d, ours = importlib.import_module("open3d"), importlib.import_module("pointloom.open3d")
    made = tables(open3d, ours)
    rows = ["| module | names and members | same | differs | missing |", "|---|---|---|---|---|"]
    totals = {module: [sum(column) for column in zip(*(one.counts() for one in found), strict=True)]
              for module, found in made.items()}  # fmt: skip
    totals["all"] = [sum(column) for column in zip(*totals.values(), strict=True)]
    rows += [f"| {module} | {sum(counts)} | {' | '.join(map(str, counts))} |" for module, counts in totals.items()]
    without = "\n".join(f"- `{module}`: {why}." for module, why in WITHOUT.items())
    parts = [HEAD.format(version=open3d.__version__, counts="\n".join(rows), without=without)]
    for module, found in made.items():
        parts += [one.text("####" if one.path != module else "###") for one in found]
    return "\n".join(parts) + "\n" + equivalents()


def equivalents() -> str:
    names = (name for name in sections() if name.partition(".")[0] not in (BRIDGE, COMMON))
    return EQUIVALENTS + table_of_sections(names)


def common_page() -> str:
    """The text of docs/other-libraries.md."""
    return COMMON_HEAD + table_of_sections(name for name in sections() if name.partition(".")[0] == COMMON)


def table_of_sections(chosen: Iterable[str]) -> str:
    rows = []
    for section in chosen:
        names = sections()[section].items()
        rows += [f"| **{section.removeprefix(f'{COMMON}.')}** | |", *(f"| `{name}` | {row} |" for name, row in names)]
    return "\n".join(map(escaped, rows)) + "\n"


def escaped(row: str) -> str:
    """A row of a table, with its asterisks outside of code and bold titles escaped."""
    return (
        row
        if row.startswith("| **")
        else "`".join(
            part if inside else part.replace("*", "\\*")
            for inside, part in zip(itertools.cycle((False, True)), row.split("`"))
        )
    )
