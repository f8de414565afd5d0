"""Kernels compiled ahead are used without compilation, however the archive is located.

The archive of these tests contains PTX, which the emulated device runs, of the modules that one program needs.
`EMULATED_CUDA_COMPILER=0` makes a compilation a fault, for whole folders of tests too.
"""

import json
import shutil
import subprocess
import sys
import zipfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
import warp as wp

from pointloom.kernels import cuda_cache

from . import processes

SELECT = "pointloom.kernels.arrays.select"
PROGRAM = """
import warnings
import warp._src.context as context

with warnings.catch_warnings(record=True) as said:
    warnings.simplefilter("always")
    points = np.random.default_rng(0).random((600, 3)).astype(np.float32)
    cloud = loom.PointCloud(points, device="cuda:0").voxel_down_sample(0.1)
    cloud = cloud.estimate_normals(max_nn=8)
    moved = loom.PointCloud(points + np.float32(0.01), device="cuda:0")
    icp = loom.registration.registration_icp(
        moved, cloud, 0.2, estimation_method=loom.registration.TransformationEstimationPointToPlane())
    chosen = loom.PointCloud(points, device="cuda:0").select_by_index(np.arange(0, 600, 7))

found = {
    "loaded": sorted(m.name for m in context.user_modules.values() if any(place for place, _ in m.execs)),
    "compiled": installed().findings.counts["modules compiled"],
    "results": [cloud.points.tolist(), cloud.normals.tolist(), icp.transformation.tolist(), chosen.points.tolist()],
    "said": [str(each.message) for each in said],
}
print(json.dumps(found))
"""
SMALL = """
from pointloom.kernels.arrays.select import positions_of
from pointloom.kernels.lang import uint8
from pointloom.kernels.memory import upload
from pointloom.core.devices import resolve_device

mask = upload(np.array([0, 1, 1, 0], np.uint8), uint8, resolve_device("cuda:0"))
found = positions_of(mask).numpy().tolist()
print(json.dumps({"compiled": installed().findings.counts["modules compiled"], "results": found}))
"""


def run(cache: Path, archive=None, *, compiler: bool = True, path: Path | None = None, program: str = PROGRAM) -> dict:
    """What a program found, in a process of its own with Warp's cache in a folder."""
    settings = {"WARP_CACHE_PATH": str(cache), "EMULATED_CUDA_COMPILER": str(int(compiler))}
    if archive is not None:
        settings["POINTLOOM_CUDA_KERNELS"] = str(archive)
    if path is not None:
        settings["PYTHONPATH"] = str(path)
    unset = ("POINTLOOM_CUDA_KERNELS", "EMULATED_CUDA_REPORT")
    return processes.run("-c", processes.START + program, unset=unset, **settings)


def file_of(module: str) -> str:
    """The file of kernels that a module of Warp's comes from."""
    return "pointloom.kernels.language.casts" if module.startswith("cast_") else module.removesuffix(".cuda")


@pytest.fixture(scope="module")
def compiled_here(emulated):
    """The program's results with kernels compiled here or cached by the user."""
    return run(Path(wp.config.kernel_cache_dir).parent)


@pytest.fixture(scope="module")
def files(compiled_here):
    return sorted({file_of(name) for name in compiled_here["loaded"]})


@pytest.fixture(scope="module")
def built(emulated, files, tmp_path_factory):
    """The archive and the wheel; modules in the user's cache are taken from there."""
    return cuda_cache.build(files, [(90, True)], Path(wp.config.kernel_cache_dir), tmp_path_factory.mktemp("built"))


def with_manifest(archive: Path, to: Path, change) -> Path:
    """An archive with another manifest."""
    with zipfile.ZipFile(archive) as old, zipfile.ZipFile(to, "w") as new:
        for name in old.namelist():
            content = old.read(name)
            if name == "manifest.json":
                manifest = json.loads(content)
                change(manifest)
                content = json.dumps(manifest).encode()
            new.writestr(name, content)
    return to


def test_an_archive_replaces_compilation_with_the_same_results_for_the_next_process_too(built, compiled_here, tmp_path):
    report = run(tmp_path, built[0], compiler=False)
    assert report["compiled"] == 0 and report["said"] == []
    assert report["results"] == compiled_here["results"]
    assert report["loaded"] == compiled_here["loaded"]
    files = {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*.ptx")}
    assert files
    run(tmp_path, built[0], compiler=False)
    assert {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*.ptx")} == files


def test_an_installed_wheel_is_detected(built, compiled_here, tmp_path):
    site = tmp_path / "site"
    install = [sys.executable, "-m", "pip", "--no-input", "--disable-pip-version-check", "install", "--quiet"]
    subprocess.run([*install, "--no-index", "--no-deps", "--target", site, built[1]], check=True, timeout=120)
    report = run(tmp_path / "cache", compiler=False, path=site)
    assert (report["compiled"], report["said"], report["results"]) == (0, [], compiled_here["results"])


def test_without_an_archive_the_program_has_to_compile(compiled_here, tmp_path):
    """The run without a compiler is no proof otherwise."""
    with pytest.raises(AssertionError, match="CUDA kernel build failed"):
        run(tmp_path, "", compiler=False)


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        (lambda m: m["made from"].update(Warp="1.18.0"), "made from Warp 1.18.0 instead of 1.19"),
        (lambda m: m["made from"].update(CUDA="12.8"), "made from CUDA 12.8 instead of"),
        (lambda m: m["made from"].update({"sources of kernels": "0" * 64}), "made from other sources of kernels"),
        (lambda m: m["made from"].update(format=2), "made from format 2 instead of 1"),
    ],
)
def test_a_mismatched_archive_is_ignored_with_one_warning(built, compiled_here, tmp_path, change, reason):
    archive = with_manifest(built[0], tmp_path / "other.zip", change)
    report = run(Path(wp.config.kernel_cache_dir).parent, archive)
    (warning,) = report["said"]
    assert f"{archive}: {reason}" in warning and "set POINTLOOM_CUDA_KERNELS to nothing" in warning
    assert report["results"] == compiled_here["results"]


def test_a_module_that_is_not_in_the_archive_is_compiled_and_the_others_are_not(built, compiled_here, tmp_path):
    def drop_select(manifest):
        for key, module in list(manifest["modules"].items()):
            if module["name"] == SELECT:
                del manifest["modules"][key]

    report = run(tmp_path, with_manifest(built[0], tmp_path / "less.zip", drop_select))
    assert (report["compiled"], report["said"], report["results"]) == (1, [], compiled_here["results"])


@pytest.fixture
def cache_but_for_select(compiled_here, tmp_path):
    """Warp's cache with all that the program needs but kernels/arrays/select.py."""
    names = {name for name in compiled_here["loaded"] if name != SELECT}
    for folder in Path(wp.config.kernel_cache_dir).iterdir():
        if folder.name.removeprefix("wp_").rpartition("_")[0] in names:
            shutil.copytree(folder, tmp_path / "cache" / wp.__version__ / folder.name)
    return tmp_path / "cache"


@pytest.mark.parametrize("damage", ["missing", "cut", "no archive", "broken code"])
def test_a_damaged_archive_costs_a_warning_and_time(built, compiled_here, cache_but_for_select, tmp_path, damage):
    archive, content = tmp_path / "damaged.zip", built[0].read_bytes()
    if damage == "cut":
        archive.write_bytes(content[: len(content) // 2])
    elif damage == "no archive":
        archive.write_text("nothing of this kind")
    elif damage == "broken code":
        with zipfile.ZipFile(built[0]) as file:
            modules = json.loads(file.read("manifest.json"))["modules"]
        (key,) = [key for key, module in modules.items() if module["name"] == SELECT]
        middle = content.index(f"{key}/sm90.ptx.xz".encode()) + 400
        archive.write_bytes(content[:middle] + b"damage" + content[middle + 6 :])
    report = run(cache_but_for_select, archive)
    (warning,) = report["said"]
    assert str(archive) in warning and "cannot be read" in warning
    assert (report["compiled"], report["results"]) == (1, compiled_here["results"])


def test_code_that_the_device_does_not_take_is_compiled_here(compiled_here, cache_but_for_select, tmp_path):
    """The emulated device takes no machine code, as a GPU takes none of another generation."""
    archive, _ = cuda_cache.build([SELECT], [(90, False)], tmp_path / "work", tmp_path)
    report = run(cache_but_for_select, archive)
    (warning,) = report["said"]
    assert f"cuda:0 does not take wp_{SELECT}" in warning
    assert (report["compiled"], report["results"]) == (1, compiled_here["results"])
    assert not list(cache_but_for_select.rglob("*.cubin")), "Warp would take it for its own"


def test_four_processes_at_once_compile_each_module_once_between_them(emulated, tmp_path):
    with ThreadPoolExecutor(4) as pool:
        reports = list(pool.map(lambda _: run(tmp_path, "", program=SMALL), range(4)))
    assert [each["results"] for each in reports] == [[1, 2]] * 4
    assert sum(each["compiled"] for each in reports) == len(list(tmp_path.rglob("*.ptx"))) > 0
