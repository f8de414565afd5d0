"""Loops through the furnished room are closed, slow and exact, and their images have the given effects."""

import numpy as np
import pytest

from pointloom.datasets.scenes.room import LOOPS, room_loop_sequence, surface_errors
from pointloom.io.frames.rgbd_sources import RGBDSource

SMALL = {"width": 80, "height": 60}


def back_project(frame):
    """World points [n, 3] of the pixels with exact depth [m]."""
    v, u = np.nonzero(frame.depth)
    z = frame.depth[v, u].astype(np.float64)
    camera = frame.intrinsic
    points = np.column_stack([(u - camera.cx) / camera.fx * z, (v - camera.cy) / camera.fy * z, z])
    return points @ frame.T_world_camera[:3, :3].T + frame.T_world_camera[:3, 3]


@pytest.mark.parametrize("path", LOOPS)
def test_a_loop_of_600_frames_is_closed_and_as_slow_as_a_hand(path):
    poses = room_loop_sequence(600, path).poses
    assert poses.shape == (600, 4, 4)
    around = np.concatenate([poses, poses[:1]])
    steps = np.linalg.norm(np.diff(around[:, :3, 3], axis=0), axis=1)
    rotations = np.einsum("nji,njk->nik", around[:-1, :3, :3], around[1:, :3, :3])
    angles = np.degrees(np.arccos(np.clip((np.trace(rotations, axis1=1, axis2=2) - 1) / 2, -1, 1)))
    assert steps.min() > 0.003 and steps.max() < 0.02
    assert angles.max() < 1.5 and angles.sum() > 360
    assert surface_errors(poses[:, :3, 3]).min() > 0.4


def test_the_two_loops_are_not_the_same_way():
    first, second = (room_loop_sequence(60, path).poses[:, :3, 3] for path in ("round", "eight"))
    gaps = np.linalg.norm(first[:, None] - second, axis=2).min(axis=1)
    assert np.median(gaps) > 0.15


@pytest.mark.parametrize("path", LOOPS)
def test_depth_of_a_loop_is_on_the_true_surface(path, device):
    sequence = room_loop_sequence(6, path, **SMALL, noise=False, device=device)
    for frame in sequence:
        assert surface_errors(back_project(frame), device=device).max() < 2e-6
    assert isinstance(sequence, RGBDSource)


@pytest.mark.parametrize("path", LOOPS)
def test_a_loop_sees_all_sides_of_the_room(path):
    """Nearly all sixteenths of each wall, of the floor and of the ceiling."""
    points = np.concatenate([back_project(f) for f in room_loop_sequence(40, path, **SMALL, noise=False)])
    sizes = (5.0, 4.0, 2.6)
    for axis, size in enumerate(sizes):
        for wall in (points[:, axis] < 0.1, points[:, axis] > size - 0.1):
            along = np.delete(points[wall], axis, axis=1)
            extent = np.delete(sizes, axis)
            cells = np.unique((along / extent * 4).clip(0, 3).astype(int), axis=0)
            assert len(cells) >= 14


def test_times_are_those_of_30_frames_a_second():
    sequence = room_loop_sequence(600, **SMALL)
    assert [sequence.read(i).timestamp for i in (0, 30)] == [0.0, 1.0]


def test_a_covered_lens_sees_nothing_and_the_pose_stays_true():
    plain, covered = room_loop_sequence(9, **SMALL), room_loop_sequence(9, **SMALL, covered=(2, 4))
    for i in range(9):
        frame, expected = covered.read(i), plain.read(i)
        assert np.array_equal(frame.T_world_camera, expected.T_world_camera)
        dark = 2 <= i < 4
        assert np.array_equal(frame.depth, np.zeros_like(expected.depth) if dark else expected.depth)
        assert np.array_equal(frame.color, np.zeros_like(expected.color) if dark else expected.color)


def test_frames_may_lack_color():
    frame = room_loop_sequence(9, **SMALL, color=False, blur=0.5).read(3)
    assert frame.color is None and frame.depth.any()


def test_blur_takes_detail_from_color_and_leaves_depth(device):
    sharp, blurred = (room_loop_sequence(300, **SMALL, blur=blur, device=device).read(10) for blur in (0.0, 2.0))
    assert np.array_equal(sharp.depth, blurred.depth)
    detail = [np.abs(np.diff(frame.color.astype(float), axis=1)).mean() for frame in (sharp, blurred)]
    assert detail[1] < 0.9 * detail[0]
    assert abs(sharp.color.mean() - blurred.color.mean()) < 2


def test_exposure_changes_brightness_within_its_bounds_and_along_the_rows():
    plain, wild = room_loop_sequence(60, **SMALL), room_loop_sequence(60, **SMALL, exposure=0.5)
    ratios = []
    for i in range(0, 60, 6):
        expected, frame = plain.read(i).color.astype(float), wild.read(i).color.astype(float)
        seen = [(v, expected[v] < 160) for v in (0, 59) if (expected[v] < 160).any()]
        ratios.append([frame[v][dark].sum() / expected[v][dark].sum() for v, dark in seen])
    everything = np.concatenate(ratios)
    assert 1 / 1.52 < everything.min() < 0.85 and 1.15 < everything.max() < 1.52
    assert max(abs(rows[0] - rows[-1]) for rows in ratios) > 0.02


def test_a_person_crosses_the_view():
    plain, crossed = (room_loop_sequence(60, **SMALL, noise=False, person=person) for person in (False, True))
    shares = []
    for i in range(0, 60, 4):
        still, moved = plain.read(i).depth, crossed.read(i).depth
        assert (moved <= still).all()
        shares.append((moved < still).mean())
    assert max(shares) > 0.1 and min(shares) < 0.02


@pytest.mark.parametrize(
    ("options", "error"),
    [
        ({"path": "square"}, ValueError),
        ({"path": 3}, TypeError),
        ({"blur": -0.1}, ValueError),
        ({"exposure": "bright"}, TypeError),
        ({"covered": (3, 3)}, ValueError),
        ({"covered": (3, 700)}, ValueError),
        ({"covered": 3}, TypeError),
        ({"frame_count": 0}, ValueError),
        ({"width": 0}, ValueError),
    ],
)
def test_options_out_of_range_are_refused_by_name(options, error):
    with pytest.raises(error, match=next(iter(options))):
        room_loop_sequence(**options)
