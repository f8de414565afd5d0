"""Tiles on a device match the CPU, and each process has its own GPU."""

import contextlib
from types import SimpleNamespace

import numpy as np
import pytest

import pointloom as loom
from pointloom.tiling import processes
from pointloom.tiling.processes import reserved_device

from .scenes import STEP, finished, in_memory, plan_of, read_cloud, rows_of, survey
from .test_same_answer import CHAINS

# Of each class of steps; the slow ones are tested on the CPU as "a chain", or by test_same_answer.
SAME = [
    "normals in a radius",
    *(pytest.param(chain, marks=pytest.mark.slow) for chain in ("normals of both", "a box", "a chain")),
]
MAX_MOVED = 2e-6  # [m] between smoothed points of CPU and GPU, which fuses multiplications and additions


def on_device(files, folder, steps, device):
    loom.tiling.plan_tiles(files, steps, folder, size=20.0)
    status = loom.tiling.run_tiles(folder, device=device)
    assert status.is_finished, status
    return finished(folder)


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    return survey(tmp_path_factory.mktemp("survey"), count=2500)


@pytest.mark.parametrize("chain", SAME)
def test_tiles_of_a_device_are_bitwise_identical_to_the_cpu(device, files, tmp_path, chain):
    result = on_device(files, tmp_path / "job", CHAINS[chain], device)
    plan = plan_of(tmp_path / "job")
    expected = in_memory(read_cloud(files, np.array(plan["origin"])), CHAINS[chain], plan["voxel_corner"])
    np.testing.assert_array_equal(rows_of(result), rows_of(expected))


@pytest.mark.parametrize("chain", [pytest.param("smoothing", marks=pytest.mark.slow), "smoothing of the nearest"])
def test_smoothed_tiles_of_a_device_match_the_cpu_within_two_micrometers(device, files, tmp_path, chain):
    result = rows_of(on_device(files, tmp_path / "job", CHAINS[chain], device))
    plan = plan_of(tmp_path / "job")
    cloud = read_cloud(files, np.array(plan["origin"]))
    expected = rows_of(in_memory(cloud, CHAINS[chain], plan["voxel_corner"]))
    by_time = [rows[np.lexsort(rows[:, 3:].T)] for rows in (result, expected)]
    np.testing.assert_array_equal(by_time[0][:, 3:], by_time[1][:, 3:])
    assert np.abs(by_time[0] - by_time[1])[:, :3].max() * STEP <= MAX_MOVED


def test_a_missing_device_is_named(files, tmp_path):
    loom.tiling.plan_tiles(files, CHAINS["voxels"], tmp_path / "job", size=20.0)
    with pytest.raises(loom.DeviceError, match="cuda:7"):
        loom.tiling.run_tiles(tmp_path / "job", device="cuda:7")


@pytest.fixture
def three_gpus(monkeypatch, tmp_path):
    """A machine with three GPUs and its locks in tmp_path."""
    gpus = [SimpleNamespace(is_cuda=True, alias=f"cuda:{k}", uuid=f"GPU-{k}", ordinal=k) for k in range(3)]
    monkeypatch.setattr(processes.tempfile, "gettempdir", lambda: str(tmp_path))
    monkeypatch.setattr("warp.get_cuda_devices", lambda: gpus)
    monkeypatch.setattr(processes, "resolve_device", lambda name: gpus[int(name[5:] or 0)])


@pytest.mark.usefixtures("three_gpus")
def test_each_process_takes_another_gpu():
    """As with processes: each opened lock file is a separate owner of the lock."""
    with reserved_device("cuda") as first, reserved_device("cuda") as second:
        assert (first, second) == ("cuda:0", "cuda:1")
        for taken, message in (("cuda", "all of 3 GPUs are in use"), ("cuda:1", "all of 1 GPUs are in use")):
            error = pytest.raises(loom.DeviceError, match=message)
            with reserved_device("cuda:2"), error, reserved_device(taken):
                pass
    with reserved_device("cuda:1") as third:
        assert third == "cuda:1"


@pytest.mark.usefixtures("three_gpus")
def test_a_worker_keeps_its_gpu(monkeypatch):
    monkeypatch.setattr(processes, "_devices", {})
    with contextlib.ExitStack() as locks:
        monkeypatch.setattr(processes, "_device_locks", locks)
        processes._prepare("cuda")
        assert processes._call(lambda _, device: device, None, "cuda") == "cuda:0"
        with reserved_device("cuda") as other:
            assert other == "cuda:1"


@pytest.mark.usefixtures("three_gpus")
def test_without_locks_processes_share_a_gpu(monkeypatch):
    monkeypatch.setattr(processes, "fcntl", None)
    with reserved_device("cuda") as first, reserved_device("cuda") as second:
        assert (first, second) == ("cuda:0", "cuda:0")
