"""A frame is integrated completely or not at all after any interruption."""

from functools import partial

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.volumes import device_frames, voxel_blocks

from ..interruptions import run_lines
from .tsdf_scenes import fingerprint

FILES = (
    "meshing/volume/tsdf.py", "kernels/volumes/voxel_blocks.py", "kernels/volumes/integrate.py",
    "kernels/volumes/device_frames.py", "kernels/volumes/frame_record.py", "kernels/arrays/hash_table.py",
    "kernels/arrays/atomic_changes.py",
)  # fmt: skip
CAMERA = loom.PinholeCameraIntrinsic(32, 24, 30.0, 30.0, 15.5, 11.5)
HERE, THERE = np.eye(4), np.eye(4)
THERE[0, 3] = 1.5  # with new blocks, for which the table and the voxels grow


def frame(seed):
    depth = (1 + 0.4 * np.random.default_rng(seed).random((24, 32))).astype(np.float32)
    return depth, np.full((24, 32, 3), 40 * seed, np.uint8)


def begun(device):
    volume = loom.TSDFVolume(voxel_size=0.02, device=device)
    add(volume, 1, HERE)
    return volume


def add(volume, seed, pose):
    depth, color = frame(seed)
    return volume.integrate(depth, CAMERA, pose, color)


def without_spare_room(device, monkeypatch):
    """Make GPU volumes grow with the counted blocks as well; by default they allocate a frame's blocks beforehand."""
    if device.startswith("cuda"):
        monkeypatch.setattr(device_frames, "ROOM_SHARE", 0.0)


def interrupt_everywhere(begin, states, blocks, every=1):
    """Interrupt the second frame before each (or some) line: it is either in the volume or not."""
    volume = begin()
    total, stop, outcomes = run_lines(lambda: add(volume, 2, THERE), FILES), 0, set()
    while stop < total:
        stop += every
        volume = begin()
        run_lines(lambda: add(volume, 2, THERE), FILES, stop)  # noqa: B023  runs at once
        added = volume.frame_count - 1
        outcomes.add(added)
        assert (volume.block_count, fingerprint(volume)) == (blocks[added], states[added]), stop
        if not added:
            add(volume, 2, THERE)
        assert (volume.frame_count, fingerprint(volume)) == (2, states[1]), stop
    assert outcomes == {0, 1}


@pytest.mark.slow
def test_a_frame_is_integrated_completely_or_not_at_all_after_any_interruption(device, tmp_path, monkeypatch):
    without_spare_room(device, monkeypatch)
    volume = begun(device)
    states, blocks, room = [fingerprint(volume)], [volume.block_count], volume.memory_bytes
    add(volume, 2, THERE)
    states, blocks = [*states, fingerprint(volume)], [*blocks, volume.block_count]
    assert volume.memory_bytes > room  # both voxels and table grew
    interrupt_everywhere(partial(begun, device), states, blocks)
    if device.startswith("cuda"):  # by launches in a row, then by a recording of them
        monkeypatch.undo()
        interrupt_everywhere(partial(begun, device), states, blocks, every=7)
    volume.save(tmp_path / "volume.npz")
    assert fingerprint(loom.TSDFVolume.load(tmp_path / "volume.npz", device=device)) == states[1]


def test_a_second_interruption_during_cleanup_is_harmless(device):
    volume = begun(device)
    total = run_lines(lambda: add(volume, 2, THERE), FILES)
    state = fingerprint(volume)
    for stop in range(total // 2, total, 7):
        volume = begun(device)
        run_lines(lambda: add(volume, 2, THERE), FILES, stop)  # noqa: B023
        for again in (2, 5, 8, 11):
            run_lines(lambda: volume.frame_count, FILES, again)  # noqa: B023
        if volume.frame_count == 1:
            add(volume, 2, THERE)
        assert (volume.frame_count, fingerprint(volume)) == (2, state)


@pytest.mark.parametrize("stage", ["new arrays", "last launch"])
def test_memory_that_runs_out_leaves_the_volume_as_it_was(device, monkeypatch, stage):
    without_spare_room(device, monkeypatch)
    is_cuda = device.startswith("cuda")
    last = (device_frames, "launch_integration") if is_cuda else (voxel_blocks, "gather_rows")
    volume = begun(device)
    before = fingerprint(volume)

    def fail(*_args, **_options):
        raise MemoryError

    with monkeypatch.context() as patch:
        patch.setattr(*{"new arrays": (voxel_blocks, "zeros"), "last launch": last}[stage], fail)
        with pytest.raises(MemoryError):
            add(volume, 2, THERE)
    assert (volume.frame_count, fingerprint(volume)) == (1, before)
    add(volume, 2, THERE)
    fresh = begun(device)
    add(fresh, 2, THERE)
    assert fingerprint(volume) == fingerprint(fresh)
