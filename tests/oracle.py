"""Open3D's answers to fixed inputs: stored in tests/oracle_answers, one file each.

`make test` reads the stored answers and does not import Open3D. `make test-all` computes them with Open3D, compares
them with the stored ones and uses the computed ones. `make oracle` writes them again; the files name the version of
Open3D that made them.

A test takes the fixture `oracle` and names its answer:

    expected = oracle("pcd/normals/cube", open3d_normals, points, radius)

where `open3d_normals(o3d, points, radius)` gets the module Open3D first. An answer is an array, a number, a string or
None, or a tuple, a list or a dictionary of such. A test that cannot store its answer, because it is large or differs
from run to run, takes the fixture `o3d` and runs in `make test-all` only.
"""

from __future__ import annotations

import importlib
import importlib.util
import io
import json
import os
import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

OPTION = "--oracle"
MODES = ("stored", "live", "write")
FOLDER = Path(__file__).parent / "oracle_answers"
MAX_BYTES = 100_000  # of one answer's file: larger ones belong to tests that take `o3d`
RTOL = 1e-5  # relative to the largest value: Open3D adds in the order of its threads, and its LAPACK by the processor
HAS_OPEN3D = importlib.util.find_spec("open3d") is not None


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        OPTION, choices=MODES, help="Open3D's answers: the stored files, Open3D, or Open3D and write files"
    )


def mode_of(config: pytest.Config) -> str:
    """The requested mode; the stored answers with `--quick` and without Open3D."""
    return config.getoption(OPTION) or ("live" if HAS_OPEN3D and not config.getoption("--quick") else "stored")


def is_selected(mode: str, fixtures: Any) -> bool:
    """True if a test with these fixtures runs in this mode."""
    return "oracle" in fixtures if mode == "write" else mode == "live" or "o3d" not in fixtures


def import_open3d() -> ModuleType:
    """Open3D with one thread in each of its pools, which are sized at the import: its sums then have one order."""
    if "open3d" in sys.modules or not hasattr(os, "sched_setaffinity"):
        return importlib.import_module("open3d")
    cores = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {min(cores)})
    try:
        return importlib.import_module("open3d")
    finally:
        os.sched_setaffinity(0, cores)


@pytest.fixture(scope="session")
def o3d() -> ModuleType:
    """Open3D; tests that take it run in `make test-all` only."""
    return import_open3d()


@pytest.fixture(scope="session")
def oracle(request: pytest.FixtureRequest) -> Callable[..., Any]:
    """A function (name, compute, *arguments) -> Open3D's answer `compute(open3d, *arguments)`."""
    mode = mode_of(request.config)

    def answer(name: str, compute: Callable[..., Any], *arguments: Any, **options: Any) -> Any:
        path = FOLDER / f"{name}.npz"
        if mode == "stored":
            return read_answer(path)
        open3d = import_open3d()
        computed = compute(open3d, *arguments, **options)
        if mode == "write":
            write_answer(path, computed, open3d.__version__)
        compare_answers(read_answer(path), computed, name)
        return computed

    return answer


def write_answer(path: Path, answer: Any, version: str) -> None:
    """Write an answer; the file is not changed if it contains the same one within rounding."""
    arrays: list[np.ndarray] = []
    tree = json.dumps({"open3d": version, "answer": pack(answer, arrays)})
    content = io.BytesIO()
    np.savez_compressed(content, np.array(tree), *arrays)
    if content.tell() > MAX_BYTES:
        raise ValueError(f"{path}: expected at most {MAX_BYTES:,} bytes, got {content.tell():,}; take a smaller scene")
    path.parent.mkdir(parents=True, exist_ok=True)
    try:
        compare_answers(read_answer(path), answer, path.name)
    except (AssertionError, FileNotFoundError):
        path.write_bytes(content.getvalue())


def read_answer(path: Path) -> Any:
    """The answer that a file stores."""
    if not path.is_file():
        raise FileNotFoundError(f"{path}: no stored answer of Open3D; write it with `make oracle`")
    with np.load(path) as stored:
        tree, *arrays = (stored[name] for name in stored.files)
    return unpack(json.loads(str(tree))["answer"], arrays)


def pack(value: Any, arrays: list[np.ndarray]) -> Any:
    """A JSON value that names the arrays by their number and keeps tuples apart from lists."""
    if isinstance(value, np.ndarray):
        arrays.append(np.array(value))
        return {"array": len(arrays) - 1}
    if isinstance(value, (float, np.floating)):
        arrays.append(np.array(float(value)))
        return {"float": len(arrays) - 1}
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, (tuple, list)):
        return {type(value).__name__: [pack(item, arrays) for item in value]}
    if isinstance(value, dict):
        return {"dict": [[key, pack(item, arrays)] for key, item in value.items()]}
    if value is None or isinstance(value, (bool, int, str)):
        return value
    raise TypeError(f"expected arrays, numbers, strings, None, tuples, lists, dictionaries, got {type(value).__name__}")


def unpack(value: Any, arrays: list[np.ndarray]) -> Any:
    """The value that `pack` was given."""
    if not isinstance(value, dict):
        return value
    ((kind, content),) = value.items()
    if kind in ("array", "float"):
        return arrays[content] if kind == "array" else float(arrays[content])
    if kind == "dict":
        return {key: unpack(item, arrays) for key, item in content}
    return {"tuple": tuple, "list": list}[kind](unpack(item, arrays) for item in content)


def compare_answers(stored: Any, computed: Any, name: str) -> None:
    """Raise AssertionError if Open3D computes another answer than the stored one, beyond rounding."""
    before: list[np.ndarray] = []
    now: list[np.ndarray] = []
    message = f"{name}: Open3D computes another answer than the stored one; write it with `make oracle`"
    assert json.dumps(pack(stored, before)) == json.dumps(pack(computed, now)), message
    for one, other in zip(before, now, strict=True):
        if one.dtype.kind == "f":
            size = np.abs(other[np.isfinite(other)]).max(initial=0.0)
            np.testing.assert_allclose(one, other, rtol=RTOL, atol=RTOL * size, err_msg=message)
        else:
            np.testing.assert_array_equal(one, other, err_msg=message)
