"""Frames on a GPU give bitwise identical volumes to those of the CPU, and are integrated completely or not."""

import pickle
from functools import partial

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.lang import cpu_compiler
from pointloom.kernels.linear_algebra import inv
from pointloom.kernels.memory import download
from pointloom.kernels.volumes import device_frames, voxel_blocks
from pointloom.meshing.volume.block_count import BlockCount

from ..interruptions import run_lines
from . import tsdf_scenes
from .tsdf_scenes import CAMERA, SMALL, TRUNCATION, VOXEL, fingerprint, look_at, plane_depth, rays_of, small_frames

WIDE = loom.PinholeCameraIntrinsic(61, 33, 40.0, 41.0, 30.2, 16.4)


def frames(count, seed=3):
    """As small_frames; every third frame has another camera, and one has no depth."""
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
    keys = volume.blocks.keys.numpy()[: volume.block_count]
    return touched, keys.tobytes(), fingerprint(volume), volume.frame_count


@pytest.fixture(scope="module")
def on_cpu():
    """The volume of the frames on one CPU core, with and without color."""
    with cpu_compiler("warp"):
        return {color: fused("cpu", color=color) for color in (True, False)}


@pytest.mark.parametrize("color", [True, False])
def test_every_device_has_bitwise_identical_blocks_in_the_same_order(device, on_cpu, color):
    assert fused(device, color=color) == on_cpu[color]


@pytest.mark.parametrize(
    ("name", "value"), [("ROOM_FRACTION", 0.0), ("MAX_GRID", 0), ("MAX_GRID", 3000)], ids=["counted", "listed", "some"]
)
def test_counted_capacity_and_boxes_beyond_the_grid_change_nothing(device, on_cpu, monkeypatch, name, value):
    monkeypatch.setattr(device_frames, name, value)
    assert fused(device) == on_cpu[True]


def test_growth_between_recorded_frames_loses_nothing(device, on_cpu, monkeypatch):
    """Memory for one frame at a time: most frames move the voxels and drop launches recorded for the old ones."""
    monkeypatch.setattr(device_frames, "RESERVED_RATIO", 0)
    assert fused(device) == on_cpu[True]


def test_exchanged_voxels_are_updated_by_frames(device):
    a, b = (loom.TSDFVolume(voxel_size=0.03, device=device) for _ in range(2))
    for depth, camera, T, color in list(frames(2)) * 2:
        for volume in (a, b):
            volume.integrate(depth, camera, T, color)
        b = b.copy()
    assert fingerprint(a) == fingerprint(b)


def test_a_gpu_frame_does_not_synchronize(device, monkeypatch):
    """After frames of its shape, neither the blocks nor their count are read from the device."""
    volume = loom.TSDFVolume(voxel_size=0.03, device=device)
    depth, camera, T, color = next(frames(1))
    for _ in range(2):
        volume.integrate(depth, camera, T, color)
    monkeypatch.setattr(device_frames, "download", None)
    monkeypatch.setattr(device_frames, "launch", None)  # recorded launches run again
    touched = volume.integrate(depth, camera, T, color)
    if device.startswith("cuda"):
        assert isinstance(touched, BlockCount) and touched._counts._counts is None
    assert touched == volume.block_count > 0


def test_a_pending_count_behaves_like_an_integer(device):
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


WALL = np.array([0.0, 0.0, -1.0])
GRAY = np.array([0.2990, 0.5870, 0.1140])


def painted_wall(device, *, color=True, origin=(0.0, 0.0, 0.0)):
    """A wall with a color ramp along x, seen from three positions, and the brightness at world positions."""

    def shade(points):
        x = (points[..., 0] - origin[0])[..., None]
        return np.clip(0.5 + x * [1.0, 0.5, -0.4], 0, 1)

    volume = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, color=color, device=device)
    for eye in ((0, 0, -1.2), (0.1, 0.1, -1.1), (-0.1, 0.05, -1.15)):
        T = look_at(np.add(eye, origin), origin)
        depth = plane_depth(CAMERA, T, WALL, -origin[2])
        points = rays_of(CAMERA, T) * depth[..., None] + T[:3, 3]
        paint = np.round(255 * shade(points)).astype(np.uint8) if color else None
        volume.integrate(depth, CAMERA, np.linalg.inv(T), paint)
    return volume, lambda points: shade(points) @ GRAY


def rendered(volume, T, **options):
    maps = volume.render_maps(CAMERA, T, weight_threshold=0, **options)
    shape = (CAMERA.height, CAMERA.width)
    intensity = None if maps.intensity is None else download(maps.intensity).reshape(shape)
    return download(maps.depth).reshape(shape), download(maps.normals).reshape(*shape, 3), intensity


@pytest.mark.parametrize("origin", [(0.0, 0.0, 0.0), (4e5, 5e6, 200.0)])
def test_rendered_maps_match_the_ray_cast_in_the_camera_frame(device, origin):
    volume, _ = painted_wall(device, origin=origin)
    T = look_at(np.add((0.05, -0.1, -1.0), origin), np.add((0.3, 0.1, 0.0), origin))
    extrinsic = np.linalg.inv(T)
    depth, normals, _ = rendered(volume, inv(extrinsic))  # with the inverse used by `ray_cast`
    view = volume.ray_cast(CAMERA, extrinsic, weight_threshold=0)
    assert np.array_equal(depth, view.depth)
    both = np.isfinite(normals).all(-1) & np.isfinite(view.normals).all(-1)
    assert both.sum() > 10_000 and np.abs(normals - view.normals @ T[:3, :3])[both].max() < 1e-3
    assert (normals[both][:, 2] < 0).all(), "they point to the camera's side"
    assert np.isnan(normals[depth == 0]).all()
    assert rendered(painted_wall(device, color=False, origin=origin)[0], T)[2] is None
    depth, normals, _ = rendered(volume, T, depth_max=0.2)
    assert not depth.any() and np.isnan(normals).all()


def test_rendered_brightness_is_smooth_and_matches_the_surface(device):
    """Within half a gray level of 8-bit colors and a tenth of a voxel; the nearest voxel would be off by half."""
    volume, brightness = painted_wall(device)
    T = look_at((0.05, -0.1, -0.9))
    depth, normals, intensity = rendered(volume, T)
    truth = brightness(rays_of(CAMERA, T) * depth[..., None] + T[:3, 3])
    inner = np.isfinite(normals).all(-1)
    for shift in (-3, 3):
        inner &= np.roll(inner, shift, 0) & np.roll(inner, shift, 1)
    assert inner.sum() > 8000
    error = np.abs(intensity - truth)[inner]
    slope = 0.55  # of brightness per meter
    assert np.quantile(error, 0.99) < 0.3 * VOXEL * slope + 0.5 / 255 and not intensity[depth == 0].any()


FILES = (
    "meshing/volume/tsdf.py", "kernels/volumes/voxel_blocks.py", "kernels/volumes/integrate.py",
    "kernels/volumes/device_frames.py", "kernels/volumes/frame_record.py", "kernels/arrays/hash_table.py",
    "kernels/arrays/atomic_changes.py",
)  # fmt: skip
LENS = loom.PinholeCameraIntrinsic(32, 24, 30.0, 30.0, 15.5, 11.5)
HERE, THERE = np.eye(4), np.eye(4)
THERE[0, 3] = 1.5  # with new blocks, for which the table and the voxels grow


def seeded_frame(seed):
    depth = (1 + 0.4 * np.random.default_rng(seed).random((24, 32))).astype(np.float32)
    return depth, np.full((24, 32, 3), 40 * seed, np.uint8)


def begun(device):
    volume = loom.TSDFVolume(voxel_size=0.02, device=device)
    add(volume, 1, HERE)
    return volume


def add(volume, seed, pose):
    depth, color = seeded_frame(seed)
    return volume.integrate(depth, LENS, pose, color)


def without_spare_room(device, monkeypatch):
    """Make GPU volumes grow with the counted blocks as well; by default they allocate a frame's blocks beforehand."""
    if device.startswith("cuda"):
        monkeypatch.setattr(device_frames, "ROOM_FRACTION", 0.0)


@pytest.mark.slow
def test_a_frame_is_integrated_completely_or_not_at_all_after_any_interruption(device, tmp_path, monkeypatch):
    without_spare_room(device, monkeypatch)
    given = partial(begun, device), lambda volume: add(volume, 2, THERE), FILES
    room = begun(device).memory_bytes
    states, volume = tsdf_scenes.assert_complete_or_absent(*given)
    assert volume.memory_bytes > room  # both voxels and table grew
    if device.startswith("cuda"):  # by launches in a row, then by a recording of them
        monkeypatch.undo()
        assert tsdf_scenes.assert_complete_or_absent(*given, every=7)[0] == states
    volume.save(tmp_path / "volume.npz")
    assert fingerprint(loom.TSDFVolume.load(tmp_path / "volume.npz", device=device)) == states[1][1]


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
