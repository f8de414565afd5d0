"""Run a script written for Open3D in this process, with Open3D or with pointloom.open3d."""

import contextlib
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

import pointloom.open3d

CHAPTERS = Path(__file__).parent / "chapters"
IMPORT = "import open3d as o3d\n"
LARGE = 600  # numbers of an array


def results_of(chapter: str, package: str, folder: Path) -> dict[str, Any]:
    """Run a script in a folder with one of the packages and return its `results`."""
    text = (CHAPTERS / f"{chapter}.py").read_text()
    assert text.count(IMPORT) == 1
    program = compile(text.replace(IMPORT, f"import {package} as o3d\n"), f"{chapter}.py", "exec")
    names: dict[str, Any] = {"__name__": "__main__"}
    with contextlib.chdir(folder):
        exec(program, names)
    return names["results"]


def draw_nothing(monkeypatch: Any, module: ModuleType) -> list[int]:
    """Replace `draw_geometries` by a function that counts its geometries and opens no window."""
    drawn: list[int] = []
    monkeypatch.setattr(module.visualization, "draw_geometries", lambda shapes, **_: drawn.append(len(shapes)))
    return drawn


def assert_same_results(
    oracle: Any, script: str, folder: Path, monkeypatch: Any, tolerances: dict[str, float], default_tolerance: float
) -> None:
    """Check that a script gives the same results with pointloom.open3d as with Open3D (live runs) or as stored."""

    def run(package: ModuleType) -> dict[str, Any]:
        drawn = draw_nothing(monkeypatch, package)
        return results_of(script, package.__name__, folder) | {"windows": drawn}

    def compare_and_shorten(open3d: ModuleType) -> dict[str, Any]:
        expected = run(open3d)
        assert differences(expected, actual, tolerances, default_tolerance) == []
        return shortened(expected)

    actual = run(pointloom.open3d)
    stored = oracle(f"open3d/{Path(script).name}", compare_and_shorten)
    assert differences(stored, shortened(actual), tolerances, default_tolerance) == []


def shortened(results: dict[str, Any]) -> dict[str, Any]:
    """Replace large arrays by their shape and some rows, so that results can be stored."""
    short: dict[str, Any] = {}
    for name, value in results.items():
        if isinstance(value, np.ndarray) and value.size > LARGE:
            rows = value.reshape(len(value), -1)[:: value.size // LARGE + 1]
            value = rows.astype(np.float32) if rows.dtype.kind == "f" else rows
            short[f"{name}: shape"] = str(results[name].shape)
        short[name] = value
    return short


def differences(
    theirs: dict[str, Any], actual: dict[str, Any], tolerances: dict[str, float], default_tolerance: float
) -> list[str]:
    """Differences of two results: text must be equal, numbers within a tolerance, booleans true in both."""
    messages = [f"{name} is missing" for name in theirs.keys() ^ actual.keys()]
    for name in theirs.keys() & actual.keys():
        expected, got = theirs[name], actual[name]
        if isinstance(expected, bool):
            messages += [f"{name}: {expected} and {got}"] if not (expected and got) else []
        elif isinstance(expected, str):
            messages += [f"{name}: {expected!r} and {got!r}"] if expected != got else []
        else:
            messages += _apart(name, np.asarray(expected), np.asarray(got), tolerances.get(name, default_tolerance))
    return messages


def _apart(name: str, expected: np.ndarray, got: np.ndarray, tolerance: float) -> list[str]:
    if expected.shape != got.shape:
        return [f"{name}: shape {expected.shape} and {got.shape}"]
    if expected.dtype.kind in "iub" and tolerance < 1:
        return [] if np.array_equal(expected, got) else [f"{name}: {(expected != got).sum()} of {expected.size} differ"]
    if expected.size == 0:
        return []
    scale = max(1.0, float(np.abs(expected[np.isfinite(expected)]).max(initial=0)))
    difference = float(np.abs(expected.astype(float) - got).max()) / scale
    return [] if difference <= tolerance else [f"{name}: {difference:.3g} apart"]
