"""TSDFVolume.integrate_frames: several frames in one call."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.language import pinned_uploads
from pointloom.kernels.volumes import device_frames

from ..interruptions import run_lines
from .tsdf_scenes import state_of

CAMERA = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
WIDER = loom.PinholeCameraIntrinsic(64, 48, 50.0, 52.0, 31.0, 23.0)
LIMITS = {"depth_scale": 1000.0, "depth_max": 3.0}
FILES = (
    "meshing/volume/tsdf.py", "meshing/volume/stacked_frames.py", "kernels/volumes/voxel_blocks.py",
    "kernels/volumes/integrate.py", "kernels/volumes/device_frames.py", "kernels/volumes/frame_record.py",
    "kernels/arrays/hash_table.py", "kernels/arrays/atomic_changes.py", "kernels/language/pinned_uploads.py",
)  # fmt: skip


@pytest.fixture(autouse=True)
def large(monkeypatch):
    """Small images are uploaded like large ones."""
    monkeypatch.setattr(pinned_uploads, "STAGED_BYTES", 8)


def scene(count):
    """Depth images of a wavy wall, poses beside each other, and colors."""
    v, u = np.mgrid[:48, :64]
    depths = [1000 + 200 * np.sin(u / (9 + k)) + 100 * np.cos(v / 7) for k in range(count)]
    poses = np.stack([np.eye(4)] * count)
    poses[:, 0, 3] = 0.05 * np.arange(count)
    colors = np.random.default_rng(1).integers(0, 256, (count, 48, 64, 3)).astype(np.uint8)
    return np.stack(depths).astype(np.uint16), poses, colors


def volume(device, color=True):
    return loom.TSDFVolume(voxel_size=0.03, color=color, device=device)


def assert_equal(one, other):
    arrays = [each.downloaded() for each in (one, other)]
    assert arrays[0].keys() == arrays[1].keys()
    for name, values in arrays[0].items():
        np.testing.assert_array_equal(values, arrays[1][name], err_msg=name)


@pytest.mark.parametrize("cameras", [[CAMERA], [CAMERA, WIDER]], ids=["one camera", "two cameras"])
@pytest.mark.parametrize("color", [False, True])
@pytest.mark.parametrize("count", [1, 3, 11])  # 11: more than a group
def test_frames_together_give_the_volume_of_single_calls(device, cameras, color, count):
    depths, poses, colors = scene(count)
    each = [cameras[k % len(cameras)] for k in range(count)]
    single, together = volume(device, color), volume(device, color)
    for _ in range(3):  # on a GPU the first, a recorded and a repeated run
        expected = [
            int(single.integrate(depths[k], each[k], poses[k], colors[k] if color else None, **LIMITS))
            for k in range(count)
        ]
        given = each if len(cameras) > 1 else CAMERA
        counts = together.integrate_frames(depths, given, poses, colors if color else None, **LIMITS)
        assert list(map(int, counts)) == expected
    assert together.frame_count == single.frame_count == 3 * count
    assert_equal(single, together)


def test_frames_of_a_wall_give_its_mean_distance_and_color(device, tmp_path):
    """Three frames at 1 m and one at 1.04 m, within the truncation."""
    depths = np.full((4, 48, 64), 1.0)
    depths[3] = 1.04
    colors = np.full((4, 48, 64, 3), 50, np.uint8)
    colors[3] = 210
    with loom.PagedTSDFVolume(tmp_path / "v", voxel_size=0.03, device=device) as paged:
        for each in (volume(device), paged):
            each.integrate_frames(depths, CAMERA, np.tile(np.eye(4), (4, 1, 1)), colors)
            mesh = each.extract_triangle_mesh(0)
            np.testing.assert_allclose(mesh.vertices[:, 2], 1.01, atol=1e-4)
            np.testing.assert_allclose(mesh.vertex_colors, 90 / 255, atol=1 / 255)
    plain = volume(device)
    plain.integrate_frames(depths, CAMERA, np.tile(np.eye(4), (4, 1, 1)))
    assert not plain.has_frame_colors and mesh.has_vertex_colors()


@pytest.mark.parametrize("dtype", [np.uint16, np.float32, np.int64])
def test_depth_types_mean_what_they_mean_for_one_frame(device, dtype):
    depths, poses, _ = scene(2)
    depths = (depths / 1000).astype(dtype) if dtype == np.float32 else depths.astype(dtype)
    single, together = volume(device, False), volume(device, False)
    for depth, pose in zip(depths, poses, strict=True):
        single.integrate(depth, CAMERA, pose)
    together.integrate_frames(list(depths), CAMERA, poses)
    assert_equal(single, together)


def test_frames_without_room_for_all_blocks_are_integrated_one_by_one(device, monkeypatch):
    monkeypatch.setattr(device_frames, "ROOM_FRACTION", 0.0)
    depths, poses, colors = scene(3)
    single, together = volume(device), volume(device)
    for k in range(3):
        single.integrate(depths[k], CAMERA, poses[k], colors[k], **LIMITS)
    together.integrate_frames(depths, CAMERA, poses, colors, **LIMITS)
    assert_equal(single, together)


def test_frames_mix_with_single_ones_and_with_other_numbers_of_frames(device):
    depths, poses, colors = scene(5)
    single, together = volume(device), volume(device)
    for k in range(5):
        single.integrate(depths[k], CAMERA, poses[k], colors[k], **LIMITS)
    first = together.integrate_frames(depths[:2], CAMERA, poses[:2], colors[:2], **LIMITS)
    together.integrate(depths[2], CAMERA, poses[2], colors[2], **LIMITS)
    together.integrate_frames(depths[3:], CAMERA, poses[3:], colors[3:], **LIMITS)
    assert all(int(count) > 0 for count in first)  # read after the next frames
    assert_equal(single, together)


def test_images_may_be_overwritten_after_the_call(device):
    depths, poses, colors = scene(8)
    single, together = volume(device), volume(device)
    for k in range(8):
        single.integrate(depths[k], CAMERA, poses[k], colors[k], **LIMITS)
    depth, color = depths[:2].copy(), colors[:2].copy()
    for k in range(0, 8, 2):
        depth[:], color[:] = depths[k : k + 2], colors[k : k + 2]
        together.integrate_frames(depth, CAMERA, poses[k : k + 2], color, **LIMITS)
    depth[:], color[:] = 0, 0
    assert_equal(single, together)


@pytest.mark.slow
def test_an_interrupted_group_is_integrated_completely_or_not_at_all(device):
    """Before each line: the frames that the volume does not count, integrated then, complete it. On the CPU a group is
    one frame."""
    camera, (depths, poses, colors) = CAMERA.scaled(0.25), scene(3)
    depths, colors = depths[:, ::4, ::4], colors[:, ::4, ::4]
    poses[2, 0, 3] = 1.5  # with new blocks

    def begun():
        target = loom.TSDFVolume(voxel_size=0.1, device=device)
        target.integrate(depths[0], camera, poses[0], colors[0], **LIMITS)
        return target

    def add(target, first, stop=None):
        given = depths[first:], camera, poses[first:], colors[first:]
        return run_lines(lambda: target.integrate_frames(*given, **LIMITS), FILES, stop)

    single, total, outcomes = begun(), add(begun(), 1), set()
    for k in (1, 2):
        single.integrate(depths[k], camera, poses[k], colors[k], **LIMITS)
    complete = state_of(single)
    for stop in range(1, total + 1):
        target = begun()
        add(target, 1, stop)
        outcomes.add(done := target.frame_count)
        if done < 3:
            add(target, done)
        assert (target.frame_count, state_of(target)) == (3, complete), stop
    assert outcomes == ({1, 3} if device.startswith("cuda") else {1, 2, 3})


@pytest.mark.parametrize("far", [10.0, 1e6])
def test_the_first_frame_sets_the_origin(device, far):
    depths, poses, _ = scene(2)
    poses[:, 0, 3] -= far
    single, together = volume(device, False), volume(device, False)
    for depth, pose in zip(depths, poses, strict=True):
        single.integrate(depth, CAMERA, pose, **LIMITS)
    together.integrate_frames(depths, CAMERA, poses, **LIMITS)
    np.testing.assert_array_equal(single.origin, together.origin)
    assert_equal(single, together)


def nan_pose(poses):
    changed = poses.copy()
    changed[1, 0, 3] = np.nan
    return changed


@pytest.mark.parametrize(
    ("change", "error", "name"),
    [
        ({"depth": lambda d: d[0]}, ValueError, "depth"),
        ({"depth": lambda d: d[:0], "extrinsic": lambda p: p[:0], "color": lambda c: c[:0]}, ValueError, "depth"),
        ({"depth": lambda d: d.astype(np.uint8)}, TypeError, "depth"),
        ({"depth": lambda d: [d[0], d[1, :20], d[2]]}, ValueError, "depth"),
        ({"extrinsic": lambda p: p[:2]}, ValueError, "extrinsic"),
        ({"extrinsic": nan_pose}, ValueError, "extrinsic"),
        ({"extrinsic": lambda p: 2 * p}, ValueError, "extrinsic"),
        ({"color": lambda c: c[:2]}, ValueError, "color"),
        ({"color": lambda c: c.astype(float)}, TypeError, "color"),
        ({"color": lambda c: None}, ValueError, "color"),
        ({"intrinsic": lambda c: [c, c]}, ValueError, "intrinsic"),
        ({"intrinsic": lambda c: [c, c, None]}, TypeError, "intrinsic"),
    ],
)
def test_bad_frames_are_errors_and_change_nothing(device, change, error, name):
    depths, poses, colors = scene(3)
    target = volume(device)
    target.integrate(depths[0], CAMERA, poses[0], colors[0], **LIMITS)
    before = target.copy()
    given = {"depth": depths, "intrinsic": CAMERA, "extrinsic": poses, "color": colors}
    given |= {key: edit(given[key]) for key, edit in change.items()}
    with pytest.raises(error, match=name):
        target.integrate_frames(**given, **LIMITS)
    assert target.frame_count == 1
    assert_equal(before, target)
