"""Volumes whose frames a GPU folds in by itself hold what those on the CPU hold, bit for bit."""

import pickle

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.lang import cpu_compiler
from pointloom.kernels.volumes import device_frames
from pointloom.meshing.volume.block_count import BlockCount

from .tsdf_scenes import SMALL, fingerprint, small_frames

WIDE = loom.PinholeCameraIntrinsic(61, 33, 40.0, 41.0, 30.2, 16.4)


def frames(count, seed=3):
    """As small_frames; every third one of another camera, and one without any depth."""
    rng = np.random.default_rng(seed)
    for k, (depth, T, color) in enumerate(small_frames(rng, count)):
        camera = SMALL
        if k % 3 == 2:
            camera = WIDE
            depth = np.full((WIDE.height, WIDE.width), 1.1) + 0.2 * rng.random((WIDE.height, WIDE.width))
            color = rng.integers(0, 256, (*depth.shape, 3), dtype=np.uint8)
        yield (0 * depth if k == 4 else depth), camera, np.linalg.inv(T), color


def fused(device, *, count=8, color=True, depth_max=3.0):
    volume = loom.TSDFVolume(voxel_size=0.03, color=color, device=device)
    touched = [
        int(volume.integrate(depth, camera, T, paint if color else None, depth_max=depth_max))
        for depth, camera, T, paint in frames(count)
    ]
    keys = volume._blocks.keys.numpy()[: volume.block_count]
    return touched, keys.tobytes(), fingerprint(volume), volume.frame_count


@pytest.fixture(scope="module")
def on_cpu():
    """What one core of the CPU makes of the frames, with colour and without."""
    with cpu_compiler("warp"):
        return {color: fused("cpu", color=color) for color in (True, False)}


@pytest.mark.parametrize("color", [True, False])
def test_every_device_has_the_same_blocks_in_the_same_order_with_the_same_bits(device, on_cpu, color):
    assert fused(device, color=color) == on_cpu[color]


@pytest.mark.parametrize(
    ("name", "value"), [("ROOM_SHARE", 0.0), ("MAX_GRID", 0), ("MAX_GRID", 3000)], ids=["counted", "listed", "some"]
)
def test_room_that_is_counted_and_boxes_beyond_the_grid_change_nothing(device, on_cpu, monkeypatch, name, value):
    monkeypatch.setattr(device_frames, name, value)
    assert fused(device) == on_cpu[True]


def test_growth_amid_recorded_frames_keeps_all(device, on_cpu, monkeypatch):
    """Room for one frame at a time: most frames move the voxels, and what was recorded for the old ones is dropped."""
    monkeypatch.setattr(device_frames, "FURTHER", 0)
    assert fused(device) == on_cpu[True]


def test_voxels_that_are_exchanged_are_those_that_frames_change(device):
    a, b = (loom.TSDFVolume(voxel_size=0.03, device=device) for _ in range(2))
    for depth, camera, T, color in list(frames(2)) * 2:
        for volume in (a, b):
            volume.integrate(depth, camera, T, color)
        b = b.copy()
    assert fingerprint(a) == fingerprint(b)


def test_a_frame_on_a_gpu_waits_for_nothing(device, monkeypatch):
    """Once frames of its shape were there, neither the blocks nor their number are read from the device."""
    volume = loom.TSDFVolume(voxel_size=0.03, device=device)
    depth, camera, T, color = next(frames(1))
    for _ in range(2):
        volume.integrate(depth, camera, T, color)
    monkeypatch.setattr(device_frames, "download", None)
    monkeypatch.setattr(device_frames, "launch", None)  # what was recorded runs again
    touched = volume.integrate(depth, camera, T, color)
    if device.startswith("cuda"):
        assert isinstance(touched, BlockCount) and touched._counts._found is None
    assert touched == volume.block_count > 0


def test_a_number_that_is_still_counted_behaves_as_one(device):
    volume = loom.TSDFVolume(voxel_size=0.03, device=device)
    depth, camera, T, color = next(frames(1))
    touched = volume.integrate(depth, camera, T, color)
    n = volume.block_count
    assert touched == n and touched >= n and not touched < n and touched + 1 == 1 + touched == n + 1
    assert (2 * touched, touched - 1, 1 - touched) == (2 * n, n - 1, 1 - n)
    assert (touched / 2, 2 / touched, float(touched)) == (n / 2, 2 / n, float(n))
    assert f"{touched:,} {touched}" == f"{n:,} {n}" and repr(touched) == repr(n)
    assert list(range(touched)) == list(range(n)) and hash(touched) == hash(n) and bool(touched)
    assert pickle.loads(pickle.dumps(touched)) == n and np.array([touched], np.int64)[0] == n
    volume.integrate(depth, camera, T, color)
    assert touched == n
