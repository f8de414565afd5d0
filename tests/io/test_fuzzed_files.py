"""Damaged files are rejected or read correctly: a short run of tests/fuzz, its list of readers, its oracles."""

import importlib.util
import shutil
import sys
import warnings
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import pytest

import pointloom as loom
import pointloom.open3d as o3d

FOLDER = Path(__file__).resolve().parents[2] / "tests" / "fuzz"
NAMES = ("run", "cases", "folder_cases", "job_cases", "mutations", "open3d_cases", "oracles", "other_cases")
NAMES += ("ply_oracle", "media_cases", "public_cases", "stage_cases", "targets")
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


# One input of each open3d case and of some others takes a second. The nightly run has thousands of all cases.
GROUPS = {"pointloom.open3d": "open3d ", "clouds": "cloud ", "meshes": "mesh "}


@pytest.mark.parametrize("begin", GROUPS.values(), ids=GROUPS)
def test_public_readers_reject_or_read_damaged_files(fuzz, begin, tmp_path):
    cases = [case for case in fuzz.CASES if case.name.startswith(begin)]
    numbers = range(1, 8, 2)  # damaged, not only truncated
    wrong = [(case.name, *entry) for case in cases for entry in fuzz.fuzz(case, numbers, 3, tmp_path)]
    assert cases and [entry for entry in wrong if entry[2] not in ("refused", "read")] == []


# Begins of the names of cases whose complete files are made by another package or program.
NEEDED = {"network": "onnxruntime", "photo .dng": "rawpy", "photo .heic": "pi_heif", "features,": "pycolmap",
          "matches,": "pycolmap", "video,": "pycolmap", "video .": "ffmpeg"}  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("begin", NEEDED)
def test_files_for_other_packages_are_rejected_or_read(fuzz, begin, tmp_path):
    if importlib.util.find_spec(NEEDED[begin]) is None and shutil.which(NEEDED[begin]) is None:
        pytest.skip(f"{NEEDED[begin]} is not installed")
    cases = [case for case in fuzz.CASES if case.name.startswith(begin)]
    wrong = [(case.name, *entry) for case in cases for entry in fuzz.fuzz(case, range(1, 8, 2), 3, tmp_path)]
    assert cases and [entry for entry in wrong if entry[2] not in ("refused", "read")] == []


@pytest.mark.slow
def test_all_other_readers_reject_or_read_damaged_files(fuzz, tmp_path):
    others = ("job of", *GROUPS.values(), *CASES, *JOBS, *NEEDED)
    rest = [case for case in fuzz.CASES if not case.name.startswith(others)]
    wrong = [(case.name, *entry) for case in rest for entry in fuzz.fuzz(case, range(1, 8, 2), 3, tmp_path)]
    assert [entry for entry in wrong if entry[2] not in ("refused", "read")] == []


def test_every_function_that_reads_has_a_case_or_a_reason(fuzz):
    import targets

    cases = {case.name for case in fuzz.CASES}
    assert targets.uncovered(FOLDER.parents[1], loom, o3d, cases) == []


def test_a_reader_without_a_case_is_reported(fuzz, monkeypatch):
    import targets

    cases = {case.name for case in fuzz.CASES}
    monkeypatch.delitem(targets.PUBLIC, "o3d.io.read_feature")
    monkeypatch.delitem(targets.MODULES, "open3d/io/ply_elements.py")
    monkeypatch.setitem(targets.PUBLIC, "loom.read_view", ())
    lines = targets.uncovered(FOLDER.parents[1], loom, o3d, cases)
    assert {line.split(":")[0] for line in lines} == {
        "o3d.io.read_feature",
        "open3d/io/ply_elements.py",
        "loom.read_view",
    }


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


POINTER = b"version https://git-lfs.github.com/spec/v1\noid sha256:" + 64 * b"0" + b"\nsize 123456\n"
ONE_FILE = ("cloud ", "mesh ", "splats ", "trajectory ", "recording ", "color ", "depth .", "photo .tif", "photo .webp",
            "raster ", "chunks ", "COPC", "stations ", "volume", "occupancy grid", "distance field", "control grid",
            "camera .json", "cameras of frames", "Metashape", "pose graph", "given positions", "targets ",
            "control of", "view", "polygon volume", "detail tree", "depth bundle", "open3d ", "PCD", "OBJ", "STL",
            "OFF", "PLY", "GLB", "glTF", "configuration", "steps", "area", "VPC")  # fmt: skip


def test_every_reader_names_a_pointer_of_git_lfs(fuzz, tmp_path):
    cases = [case for case in fuzz.CASES if case.name.startswith(ONE_FILE)]
    wrong = []
    for case in cases:
        path = tmp_path / f"a{case.suffix}"
        path.write_bytes(POINTER)
        try:
            case.read(path)
            wrong.append((case.name, "no error"))
        except loom.FileError as error:
            wrong += [] if "is a pointer of Git LFS" in str(error) else [(case.name, str(error))]
        path.unlink()
    assert len(cases) > 60 and wrong == []
