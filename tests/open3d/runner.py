"""Runs a script that was written for Open3D: as it is, and with its import line changed; both in this process."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

import pointloom.open3d

CHAPTERS = Path(__file__).parent / "chapters"
IMPORT = "import open3d as o3d\n"
LARGE = 600  # numbers of an array


def found_by(chapter: str, package: str, folder: Path) -> dict[str, Any]:
    """What a script leaves in `found`, run in a folder with one of the packages."""
    text = (CHAPTERS / f"{chapter}.py").read_text()
    assert text.count(IMPORT) == 1
    program = compile(text.replace(IMPORT, f"import {package} as o3d\n"), f"{chapter}.py", "exec")
    names: dict[str, Any] = {"__name__": "__main__"}
    with inside(folder):
        exec(program, names)
    return names["found"]


@contextlib.contextmanager
def inside(folder: Path) -> Iterator[None]:
    """Work in a folder."""
    before = Path.cwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)


def draw_nothing(monkeypatch: Any, module: ModuleType) -> list[int]:
    """Windows stay closed: `draw_geometries` counts what it is given."""
    shown: list[int] = []
    monkeypatch.setattr(module.visualization, "draw_geometries", lambda shapes, **_: shown.append(len(shapes)))
    return shown


def assert_found_by_both(
    oracle: Any, script: str, folder: Path, monkeypatch: Any, tolerances: dict[str, float], usual: float
) -> None:
    """A script finds and draws with pointloom.open3d what it does with Open3D: all in live runs, or the stored part."""

    def run(package: ModuleType) -> dict[str, Any]:
        shown = draw_nothing(monkeypatch, package)
        return found_by(script, package.__name__, folder) | {"windows": shown}

    def compare_and_shorten(open3d: ModuleType) -> dict[str, Any]:
        theirs = run(open3d)
        assert differences(theirs, ours, tolerances, usual) == []
        return shortened(theirs)

    ours = run(pointloom.open3d)
    stored = oracle(f"open3d/{Path(script).name}", compare_and_shorten)
    assert differences(stored, shortened(ours), tolerances, usual) == []


def shortened(found: dict[str, Any]) -> dict[str, Any]:
    """What a script found, with large arrays by their shape and some of their rows: an answer that can be stored."""
    short: dict[str, Any] = {}
    for name, value in found.items():
        if isinstance(value, np.ndarray) and value.size > LARGE:
            rows = value.reshape(len(value), -1)[:: value.size // LARGE + 1]
            value = rows.astype(np.float32) if rows.dtype.kind == "f" else rows
            short[f"{name}: shape"] = str(found[name].shape)
        short[name] = value
    return short


def differences(theirs: dict[str, Any], ours: dict[str, Any], tolerances: dict[str, float], usual: float) -> list[str]:
    """What two runs found otherwise: text alike, numbers within a tolerance, claims (of type bool) true in both."""
    said = [f"{name} is missing" for name in theirs.keys() ^ ours.keys()]
    for name in theirs.keys() & ours.keys():
        expected, got = theirs[name], ours[name]
        if isinstance(expected, bool):
            said += [f"{name}: {expected} and {got}"] if not (expected and got) else []
        elif isinstance(expected, str):
            said += [f"{name}: {expected!r} and {got!r}"] if expected != got else []
        else:
            said += _apart(name, np.asarray(expected), np.asarray(got), tolerances.get(name, usual))
    return said


def _apart(name: str, expected: np.ndarray, got: np.ndarray, tolerance: float) -> list[str]:
    if expected.shape != got.shape:
        return [f"{name}: shape {expected.shape} and {got.shape}"]
    if expected.dtype.kind in "iub" and tolerance < 1:
        return [] if np.array_equal(expected, got) else [f"{name}: {(expected != got).sum()} of {expected.size} differ"]
    if expected.size == 0:
        return []
    scale = max(1.0, float(np.abs(expected[np.isfinite(expected)]).max(initial=0)))
    apart = float(np.abs(expected.astype(float) - got).max()) / scale
    return [] if apart <= tolerance else [f"{name}: {apart:.3g} apart"]
