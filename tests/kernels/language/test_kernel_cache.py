"""A process launches what an earlier one prepared without reading it, and goes the long way where anything is amiss."""

import json
import os
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest
import warp as wp

from pointloom.kernels import lang  # noqa: F401  starts Warp
from pointloom.kernels.language import kernel_cache

WORK = """
import numpy as np
import pointloom as loom
from pointloom.kernels import lang
points = np.random.default_rng(0).random((2000, 3))
cloud = loom.PointCloud(points).estimate_normals(max_nn=10)
read = sum("source" in vars(what) for kinds in lang.LAUNCHED.values() for what in kinds.values())
known = sum("cached" in vars(what) for kinds in lang.LAUNCHED.values() for what in kinds.values())
print(read, known, cloud.normals.tobytes().hex()[:64])
"""


@pytest.fixture
def cache(tmp_path) -> Path:
    folder = tmp_path / "cache"
    version = folder / wp.config.version
    version.mkdir(parents=True)
    for path in Path(wp.config.kernel_cache_dir).glob("wp_pointloom*"):
        (version / path.name).symlink_to(path)
    return folder


def run(cache: Path, program: str = WORK) -> str:
    inherited = {name: value for name, value in os.environ.items() if not name.startswith("POINTLOOM_CPU")}
    done = subprocess.run(
        [sys.executable, "-c", textwrap.dedent(program)],
        env=inherited | {"WARP_CACHE_PATH": str(cache)}, capture_output=True, text=True, timeout=200,
    )  # fmt: skip
    assert (done.returncode, done.stderr) == (0, "")
    return done.stdout


@pytest.mark.slow
def test_the_second_process_compiles_nothing_and_is_bitwise_identical(cache):
    first, second = run(cache).split(), run(cache).split()
    assert int(first[0]) >= int(first[1]) > 2 and (int(second[0]), second[1:]) == (0, first[1:])


HARMS = {
    "machine code is gone": lambda entries: {name: [*e[:-1], f"{e[-1]}.gone"] for name, e in entries.items()},
    "broken": None,
    "of other making": lambda entries: {name: [1, "a"] for name in entries},
    "other places": lambda entries: [1, 2],
}


@pytest.mark.slow
@pytest.mark.parametrize("harm", HARMS)
def test_damaged_entries_are_not_used(cache, harm):
    before = run(cache).split()
    for path in cache.glob(f"*/{kernel_cache.FOLDER}/*/*.json"):
        text = path.read_text()
        path.write_text(json.dumps(HARMS[harm](json.loads(text))) if HARMS[harm] else text[:-9])
    assert run(cache).split() == before
    assert run(cache).split()[0] == "0"  # and kept again


STORED = kernel_cache.CachedKernel([], "a", "=Q", "symbol", "code.o")
MODULE = f"{kernel_cache.PACKAGE}.room.file"


def forget() -> None:
    kernel_cache._folder.cache_clear()
    kernel_cache._read.cache_clear()


@pytest.fixture
def folder(monkeypatch, tmp_path):
    monkeypatch.setattr(kernel_cache.wp.config, "kernel_cache_dir", str(tmp_path))
    forget()
    yield tmp_path
    monkeypatch.undo()
    forget()


def test_other_sources_keep_apart(monkeypatch, folder):
    for number in range(kernel_cache.MAX_FOLDERS + 3):
        monkeypatch.setattr(kernel_cache, "digest_of_sources", lambda number=number: f"sources {number}")
        forget()
        assert kernel_cache.find(MODULE, "k") is None
        kernel_cache.store(MODULE, "k", STORED)
        assert kernel_cache.find(MODULE, "k") == STORED
    assert len(list((folder / kernel_cache.FOLDER).iterdir())) == kernel_cache.MAX_FOLDERS
    kernel_cache.store("elsewhere.kernels", "k", STORED)
    assert kernel_cache.find("elsewhere.kernels", "k") is None


def test_a_folder_that_cannot_be_written_to_keeps_nothing(folder):
    (folder / kernel_cache.FOLDER).touch()
    kernel_cache.store(MODULE, "k", STORED)
    assert kernel_cache.find(MODULE, "k") is None


WRONG = """
import numpy as np, warp as wp
from pointloom.kernels import lang
from pointloom.kernels.surface.normals import orient_normals_kernel as kernel
points, normals = wp.zeros(3, dtype=wp.vec3, device="cpu"), wp.ones(3, dtype=wp.vec3, device="cpu")
lang.launch(kernel, 3, [points, normals, 0, [0.0, 0.0, 1.0], wp.zeros(3, dtype=wp.vec3, device="cpu")])
up = [0.0, 0.0, 1.0]
for wrong in ([points, normals, 0, up[:2], points], [points, normals, 0], [points, normals, 2**40, up, points]):
    try:
        lang.launch(kernel, 3, wrong)
    except ValueError as error:
        print(error)
"""


@pytest.mark.slow
def test_errors_name_parameters_in_either_process(cache):
    first, second = run(cache, WRONG), run(cache, WRONG)
    assert first == second and "reference: expected shape [3], got [2]" in first and "takes 5 arguments, got 3" in first
    assert "to_point: 1099511627776 does not fit into int32" in first
