"""Damaged files are rejected or read correctly: a short run of benchmarks/fuzz, and a test of its oracles."""

import sys
import warnings
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import pytest

FOLDER = Path(__file__).resolve().parents[2] / "benchmarks" / "fuzz"
NAMES = ("run", "cases", "job_cases", "mutations", "oracles", "other_cases", "ply_oracle")
CASES = ("OBJ", "OBJ corners", "OFF", "STL", "PLY mesh, text", "PLY mesh, binary", "PCD")
JOBS = ("area", "steps", "transforms.json", "configuration", "depth bundle", "occupancy grid", "control grid")
GLTF = ("GLB", "glTF")


@pytest.fixture(scope="module")
def fuzz() -> Iterator[ModuleType]:
    """The script, with its folder on the path as when it is run."""
    for name in NAMES:
        sys.modules.pop(name, None)
    sys.path.insert(0, str(FOLDER))
    import run

    yield run
    sys.path.remove(str(FOLDER))
    for name in NAMES:
        sys.modules.pop(name, None)


def case_of(fuzz, name):
    return next(case for case in fuzz.CASES if case.name == name)


@pytest.mark.parametrize("name", [*CASES, *JOBS, *GLTF, pytest.param("plan of a manifest", marks=pytest.mark.slow)])
def test_damaged_files_are_rejected_or_read_correctly(fuzz, name, tmp_path):
    results = fuzz.fuzz(case_of(fuzz, name), range(60), 0, tmp_path)
    assert [entry for entry in results if entry[1] not in ("refused", "read")] == []
    assert {what for _, what, _ in results} == {"refused", "read"}


@pytest.mark.parametrize("name", CASES)
def test_valid_files_are_read_and_the_oracle_detects_missing_data(fuzz, name, tmp_path):
    case = case_of(fuzz, name)
    for k, data in enumerate(case.seeds()):
        path = tmp_path / f"{k}{case.suffix}"
        path.write_bytes(data)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # about ignored data
            read = case.read(path)
        if b"binary_compressed" in data:
            read.points = read.points[:-1]  # the minimal requirement
        else:
            assert case.oracle(path, read) is None
            moved = read.points if name == "PCD" else read.vertices
            moved[-1, 2] += 1
            if name != "PCD":
                read.triangles = read.triangles[:, [0, 2, 1]] if name != "STL" else read.triangles
        assert case.oracle(path, read) is not None
