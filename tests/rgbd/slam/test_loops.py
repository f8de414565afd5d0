"""Loop closure removes drift, preserves good poses, and rejects similar but different locations."""

import dataclasses
import itertools
from unittest.mock import Mock

import numpy as np
import pytest

from benchmarks.room_loops import LOOPS, room_loop_sequence
from pointloom.datasets.scenes.room import surface_errors
from pointloom.io.frames.rgbd_sources import RGBDSource
from pointloom.registration.pose_graphs.reports import GlobalOptimizationReport
from pointloom.registration.rigid import invert_pose, pose_error, pose_of
from pointloom.rgbd.slam import loops as loops_module
from pointloom.rgbd.slam.loops import close_loops, corrected_trajectory, fuse_submaps
from pointloom.rgbd.slam.submaps import Submap

from .loop_scenes import hall_run, moved, record, room_run, surface_error, trajectory_error


@pytest.fixture(scope="module")
def closed():
    """The drifted run with closed loops: (submaps, tracked, true, LoopClosure)."""
    submaps, tracked, true = room_run()
    return submaps, tracked, true, close_loops(submaps)


def farthest_shift(poses, submaps):
    """Displacements of submaps [m, or rad at an arm of one meter]."""
    return max(sum(pose_error(T, s.T_world_submap)) for T, s in zip(poses, submaps, strict=True))


def bits_of(closure, order):
    """All bits of a closure, submaps in the order of the run; `order` gives their positions in the given list."""
    rank = {given: k for k, given in enumerate(order)}
    pairs = sorted((rank[p.source], rank[p.target], p.T_target_source.tobytes(), p.score) for p in closure.loops)
    return closure.T_world_submap[order].tobytes(), pairs


@pytest.mark.slow
def test_closing_loops_removes_drift_from_the_trajectory(closed):
    submaps, tracked, true, closure = closed
    numbers, poses = corrected_trajectory(submaps, closure.T_world_submap)
    assert (numbers == np.arange(len(true))).all()
    before, after = trajectory_error(tracked, true), trajectory_error(poses, true)
    assert before > 0.015 and after < 0.01 and after < before / 2
    assert len(closure.loops) >= len(submaps) and (closure.groups == 0).all()
    assert closure.reliable and len(closure.reports) == 1


@pytest.mark.slow
def test_fusing_at_corrected_poses_removes_drift_from_the_surface(closed):
    submaps, tracked, true, closure = closed
    _, poses = corrected_trajectory(submaps, closure.T_world_submap)
    before = surface_error(fuse_submaps(submaps), tracked, true)
    after = surface_error(fuse_submaps(submaps, closure.T_world_submap), poses, true)
    assert after < 0.01 and after < 0.6 * before


@pytest.mark.slow
def test_every_accepted_loop_is_correct(closed):
    submaps, _, true, closure = closed
    middles = [len(s.frames) // 2 for s in submaps]
    truth = [true[s.frames[k]] @ invert_pose(s.T_submap_camera[k]) for s, k in zip(submaps, middles, strict=True)]
    for loop in closure.loops:
        angle, shift = pose_error(loop.T_target_source, invert_pose(truth[loop.target]) @ truth[loop.source])
        assert angle < np.radians(1.5) and shift < 0.08  # the drift within the two


@pytest.mark.slow
def test_the_order_of_submaps_does_not_matter(closed):
    submaps, _, _, closure = closed
    order = list(np.random.default_rng(0).permutation(len(submaps)))
    again = close_loops([submaps[i] for i in order])
    assert bits_of(again, np.argsort(order)) == bits_of(closure, np.arange(len(submaps)))


@pytest.mark.slow
def test_correct_poses_are_unchanged():
    submaps, _, true = room_run(drift=0.0)
    closure = close_loops(submaps)
    _, poses = corrected_trajectory(submaps, closure.T_world_submap)
    assert closure.loops and trajectory_error(poses, true) < 0.004


@pytest.mark.slow
def test_a_similar_room_is_not_joined():
    """The same room again, 7 m away: no accepted pair may connect the two."""
    submaps, _, _ = room_run(drift=0.0)
    shift = pose_of(np.array([0, 0, 0, 7.0, 0, 0]))
    pair = [submaps[0], submaps[5]]
    twins = [*pair, *(moved(s, shift, frames=s.frames + 1000, follows=True) for s in pair)]
    closure = close_loops(twins)
    assert all(loop.target // 2 == loop.source // 2 for loop in closure.loops)
    assert farthest_shift(closure.T_world_submap, twins) < 0.02


def test_the_seed_is_that_of_the_registration(monkeypatch):
    search = Mock(wraps=loops_module.verify_far)
    monkeypatch.setattr(loops_module, "verify_far", search)
    parts = [hall_run("cpu", 4, (0.0, 1.2)), hall_run("cpu", 4, (np.pi, np.pi + 1.2), first=10)]
    close_loops(parts, voxel_size=0.1, drift=2.0, seed=7)
    assert search.call_args.args[2] == 7


def test_a_symmetric_hall_is_not_rotated(device):
    """Its two ends fit each other as well as themselves, and any three planes match."""
    parts = [hall_run(device, 4, (0.0, 1.2)), hall_run(device, 4, (np.pi, np.pi + 1.2), first=10)]
    closure = close_loops(parts, voxel_size=0.1, drift=2.0)
    assert closure.loops == [] and farthest_shift(closure.T_world_submap, parts) == 0.0


@pytest.mark.slow
def test_a_loop_that_contradicts_the_others_is_dropped(closed, monkeypatch):
    submaps, _, true, closure = closed
    true_loops = {(p.source, p.target) for p in closure.loops}
    wrong = max((p for p in closure.loops), key=lambda p: p.source - p.target)
    error_pose = pose_of(np.array([0.1, 0.0, 0.1, 0.3, -0.2, 0.1]))
    verify, replace = loops_module.verify_near, dataclasses.replace

    def joins(p):
        return (p.source, p.target) == (wrong.source, wrong.target)

    def deceived(surfaces, candidates):
        loops = verify(surfaces, candidates)
        return [replace(p, T_target_source=error_pose @ p.T_target_source) if joins(p) else p for p in loops]

    monkeypatch.setattr(loops_module, "verify_near", deceived)

    def unrefined(surfaces, loops):
        return [replace(p, residual=0.01) for p in loops]

    monkeypatch.setattr(loops_module, "refine", unrefined)
    misled = close_loops(submaps)
    _, poses = corrected_trajectory(submaps, misled.T_world_submap)
    assert (wrong.source, wrong.target) in true_loops - {(p.source, p.target) for p in misled.loops}
    assert "contradicts" in {(p.source, p.target): p.refused for p in misled.refused}[wrong.source, wrong.target]
    assert trajectory_error(poses, true) < 0.012


@pytest.mark.slow
def test_submaps_after_a_tracking_loss_are_relocalized():
    """Two submaps that tracking placed meters away and rotated after a tracking loss."""
    submaps, _, _ = room_run(drift=0.0)
    wrong_pose = pose_of(np.array([0.0, 0.0, 2.5, 9.0, 4.0, 1.0]))
    closure = close_loops([*submaps[:2], moved(submaps[5], wrong_pose, follows=False), moved(submaps[6], wrong_pose)])
    assert (closure.groups == 0).all()
    for T, k in zip(closure.T_world_submap[2:], (5, 6), strict=True):
        angle, shift = pose_error(T, submaps[k].T_world_submap)
        assert angle < np.radians(1) and shift < 0.03


def test_unconnected_submaps_form_their_own_group(device):
    parts = [hall_run(device, 4, (0.0, 1.2)), hall_run(device, 4, (2.0, 3.2), first=10)]
    far = moved(parts[1], pose_of(np.array([0, 0, 0, 50.0, 0, 0])), follows=False)
    closure = close_loops([far, parts[0]], voxel_size=0.1)
    assert closure.groups.tolist() == [0, 1] and closure.loops == []
    assert (closure.T_world_submap == [far.T_world_submap, parts[0].T_world_submap]).all()
    assert "the submaps form 2 groups (1, 1) that neither tracking nor a loop connects" in str(closure.warnings)
    assert closure.to_dict()["reliable"] is False
    report = GlobalOptimizationReport(9, 1.0, 0.9, 1.0, False, "", np.zeros(0, np.int64), np.zeros(0, np.int64))
    unfinished = dataclasses.replace(closure, groups=np.zeros(2, np.int64), reports=(report, report))
    assert "did not converge within 9 iterations" in str(unfinished.warnings) and len(unfinished.warnings) == 1


def test_frames_move_with_their_submaps():
    steps = np.cumsum(np.random.default_rng(0).normal(0, 0.02, (25, 6)), axis=0)
    tracked = np.array([pose_of(step) for step in steps])
    submaps = record(tracked, frames=10).finish()
    stayed = np.array([s.T_world_submap for s in submaps])
    _, poses = corrected_trajectory(submaps, stayed)
    assert np.abs(poses - tracked).max() < 1e-9
    T = pose_of(np.array([0.3, 0.1, -0.2, 1.0, 2.0, 3.0]))
    _, poses = corrected_trajectory(submaps[::-1], (T @ stayed)[::-1])
    assert np.abs(poses - T @ tracked).max() < 1e-9
    stayed[-1, :3, 3] += 0.1  # frames of the first submap stay, those of the last move, others are interpolated
    _, poses = corrected_trajectory(submaps, stayed)
    shifts = np.linalg.norm((poses - tracked)[:, :3, 3], axis=1)
    assert shifts[0] < 1e-9 and np.isclose(shifts[-1], 0.1 * 3**0.5) and (np.diff(shifts) > -1e-9).all()


def test_the_order_of_submaps_does_not_matter_to_the_volume(device):
    parts = [hall_run(device, 3, (a, a + 0.8), first=int(10 * a)) for a in (0.0, 1.0, 2.0)]
    digests = set()
    for order in itertools.permutations(range(3)):
        mesh = fuse_submaps([parts[i] for i in order]).extract_triangle_mesh(0)
        digests.add(mesh.vertices.tobytes() + mesh.triangles.tobytes())
    assert len(digests) == 1


def test_progress_is_reported(device):
    reported = []
    close_loops([hall_run(device, 3, (0.0, 0.8))], progress=lambda *step: reported.append(step))
    assert reported[0] == ("surfaces", 0, 1) and reported[-1][0] == "loops" and reported[-1][1] == reported[-1][2]


def test_bad_input_is_refused(device):
    part = hall_run(device, 2, (0.0, 0.4))
    for arguments, error, message in (
        (([],), ValueError, "submaps: expected at least one"),
        (([part, part],), ValueError, "expected different first frames"),
        (([part, None],), TypeError, r"submaps\[1\]: expected a Submap"),
    ):
        with pytest.raises(error, match=message):
            close_loops(*arguments)
    for options, message in (({"voxel_size": 0}, "voxel_size"), ({"drift": -1}, "drift")):
        with pytest.raises(ValueError, match=message):
            close_loops([part], **options)
    with pytest.raises(ValueError, match="T_world_submap:"):
        corrected_trajectory([part], np.eye(4))
    with pytest.raises(ValueError, match=r"T_world_submap\[0\]"):
        fuse_submaps([part], [2 * np.eye(4)])
    with pytest.raises(ValueError, match="frames:"):
        Submap(part.volume, np.eye(4), np.array([3, 2]), part.T_submap_camera)
    with pytest.raises(TypeError, match="volume:"):
        Submap(None, np.eye(4), np.array([3, 4]), part.T_submap_camera)


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
    assert steps.min() > 0.003 and steps.max() < 0.02 and angles.max() < 1.5 and angles.sum() > 360
    assert surface_errors(poses[:, :3, 3]).min() > 0.4


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
            assert len(np.unique((along / extent * 4).clip(0, 3).astype(int), axis=0)) >= 14


def test_a_covered_lens_sees_nothing_and_the_pose_stays_true():
    plain, covered = room_loop_sequence(9, **SMALL), room_loop_sequence(9, **SMALL, covered=(2, 4))
    for i in range(9):
        frame, expected = covered.read(i), plain.read(i)
        assert np.array_equal(frame.T_world_camera, expected.T_world_camera)
        dark = 2 <= i < 4
        assert np.array_equal(frame.depth, np.zeros_like(expected.depth) if dark else expected.depth)
        assert np.array_equal(frame.color, np.zeros_like(expected.color) if dark else expected.color)


def test_blur_takes_detail_from_color_and_leaves_depth(device):
    sharp, blurred = (room_loop_sequence(300, **SMALL, blur=blur, device=device).read(10) for blur in (0.0, 2.0))
    assert np.array_equal(sharp.depth, blurred.depth)
    detail = [np.abs(np.diff(frame.color.astype(float), axis=1)).mean() for frame in (sharp, blurred)]
    assert detail[1] < 0.9 * detail[0] and abs(sharp.color.mean() - blurred.color.mean()) < 2


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
    fractions = []
    for i in range(0, 60, 4):
        still, moved = plain.read(i).depth, crossed.read(i).depth
        assert (moved <= still).all()
        fractions.append((moved < still).mean())
    assert max(fractions) > 0.1 and min(fractions) < 0.02


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
