"""A camera that is lost for long begins a new map, which is joined once both maps show the same location."""

import json
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

import pointloom as loom
from pointloom.registration.rigid import invert_pose
from pointloom.rgbd.slam import map_joins, maps
from pointloom.rgbd.slam.map_joins import Proposal, judge_join

from .slam_walks import begun, blank, frame, frames, sequence

ELSEWHERE = range(150, 166)  # the other side of the room
NEAR = 0.03  # [m] voxels are 4 cm


@pytest.fixture(autouse=True)
def _soon(monkeypatch):
    """A loss of four frames begins a new map, and four frames make a map."""
    monkeypatch.setattr(maps, "LOST_FOR_LONG", 4)
    monkeypatch.setattr(maps, "TRIAL_FRAMES", 4)


def away(device: str, **options):
    """Ten frames, then sixteen of the other side of the room."""
    slam = begun(device, **options)
    slam.run(frames(*range(10), *ELSEWHERE))
    return slam


def error(pose, index: int) -> float:
    return float(np.linalg.norm(pose[:3, 3] - frame(index).T_world_camera[:3, 3]))


@pytest.mark.slow
def test_a_camera_lost_for_long_begins_a_map_with_its_own_coordinates(device):
    slam = away(device)
    assert [result.map for result in slam.results] == [0] * 14 + [1] * 12
    assert [result.status for result in slam.results] == ["tracked"] * 10 + ["lost"] * 4 + ["tracked"] * 12
    assert slam.map_sizes == {1: 12, 0: 10}
    assert slam.trajectory.ids[:, 0].tolist() == list(range(14, 26))  # the largest alone
    assert slam.trajectory_of(0).ids[:, 0].tolist() == list(range(10))
    np.testing.assert_array_equal(slam.trajectory.poses[0], np.eye(4))
    steps = invert_pose(slam.trajectory.poses[0]) @ slam.trajectory.poses[-1]
    true = invert_pose(frame(154).T_world_camera) @ frame(165).T_world_camera
    assert np.linalg.norm(steps[:3, 3] - true[:3, 3]) < NEAR and slam.volume is slam.model.volume


@pytest.mark.slow
def test_maps_that_share_nothing_are_not_joined(device):
    slam = away(device)
    assert all(join.refused for join in slam.join_maps()) and len(slam.map_sizes) == 2
    assert slam.join_maps() == []  # nothing new to look at


@pytest.mark.slow
def test_maps_are_joined_when_the_camera_returns_to_the_old_one(device):
    """Lost at 60, the camera returns to its start."""
    slam, indices = begun(device), [*range(0, 14, 2), *range(60, -1, -2)]
    slam.run(frames(*indices))
    (join,) = (join for join in slam.joins if not join.refused)
    assert (join.target, join.source) == (0, 1) and join.views >= 2 and join.score > 0.5
    assert list(slam.map_sizes) == [0]
    ids = slam.trajectory.ids[:, 0].tolist()
    assert len(ids) == len(indices) - 4
    assert max(error(pose, indices[k]) for k, pose in zip(ids, slam.trajectory.poses, strict=True)) < NEAR
    assert slam.model.frame_count == len(ids)


@pytest.mark.slow
def test_maps_are_joined_by_their_submaps_too(device):
    slam = begun(device, submap_frames=8)
    slam.run(frames(*range(0, 24, 2)))
    other = begun(device, submap_frames=8, T_init=None)
    other.run(frames(*range(30, 4, -2)))
    slam._maps.searchable.append(renumbered(other, slam))
    (join,) = slam.join_maps()
    assert not join.refused and len(slam.trajectory) == 25
    errors = [error(r.pose, k) for r, k in zip(slam.results, [*range(0, 24, 2), *range(30, 4, -2)], strict=True)]
    assert max(errors) < NEAR and len(slam.close_loops().T_world_submap) >= 4


def renumbered(other, slam):
    """The only map of another run as the second map of a run."""
    first, second_map = len(slam.results), other._maps.here
    slam.results += [replace(result, index=first + result.index, map=1) for result in other.results]
    second_map.number, second_map.keyframes.numbers = 1, [first + number for number in second_map.keyframes.numbers]
    second_map.recorder.finish()
    submaps = second_map.recorder.submaps
    second_map.recorder.submaps = [replace(submap, frames=submap.frames + first) for submap in submaps]
    return second_map


def test_a_join_must_be_confirmed_by_the_maps(device):
    first, second = begun(device), begun(device)
    first.run(frames(*range(0, 24, 4)))
    second.model.current_frame_pose = frame(8).T_world_camera.copy()
    second.run(frames(*range(8, 32, 4)))
    join = judge_join(first._maps.here, second._maps.here, np.eye(4))
    poses = np.array(second.keyframes.poses)
    assert not join.refused
    assert np.linalg.norm((join.T_target_source @ poses - poses)[:, :3, 3], axis=1).max() < 0.02
    for shift in ((0.2, 0, 0), (0, -0.3, 0.1)):
        assert judge_join(first._maps.here, second._maps.here, moved(*shift)).refused


@pytest.mark.parametrize(
    ("given", "refused"),
    [
        ({}, ""),
        ({"views": 1}, "1 views confirm it"),
        ({"apart": 0.0}, "1 views confirm it"),  # the same view twice
        ({"against": 1}, "1 views contradict it"),
        ({"score": 0.4}, "their surfaces do not confirm it: score 0.40"),
    ],
)
def test_each_kind_of_evidence_is_required(monkeypatch, given, refused):
    views, gap = given.get("views", 2), given.get("apart", 1.0)
    poses = [moved(gap * k) for k in range(views)]
    answers = iter([(poses, [np.eye(4)] * views, given.get("against", 0)), ([], [], 0)])
    monkeypatch.setattr(map_joins, "_views", lambda *_: next(answers))
    monkeypatch.setattr(map_joins, "_rate", lambda *_: given.get("score", 0.9))
    target, source = SimpleNamespace(number=0), SimpleNamespace(number=1)
    assert judge_join(target, source, np.eye(4)).refused.startswith(refused) and bool(refused) is bool(given)


def test_a_proposal_needs_confirming_frames_and_is_dropped_by_a_few_contradicting_ones():
    off, shift = [0.0], np.eye(4)
    tracker = SimpleNamespace(try_pose=lambda _, pose: SimpleNamespace(status="tracked", pose=pose @ moved(off[0])))
    proposal = Proposal(SimpleNamespace(tracker=tracker), None, shift, np.eye(4))
    assert not any(proposal.check(None, moved(0.001 * k)) for k in range(20))  # hardly moved
    assert proposal.check(None, moved(0.2))
    off[0] = 0.1
    fresh = Proposal(SimpleNamespace(tracker=tracker), None, shift, np.eye(4))
    assert not any(fresh.check(None, moved(0.1 * k)) for k in range(3)) and fresh.is_refuted


def moved(*shift: float):
    T = np.eye(4)
    T[: len(shift), 3] = shift
    return T


@pytest.mark.slow
def test_a_map_that_is_lost_immediately_is_discarded(device, monkeypatch):
    monkeypatch.setattr(maps, "LOST_FOR_LONG", 1)
    slam = begun(device)
    slam.run(frames(*range(4), *ELSEWHERE[:3], 100))  # two frames of a new map, and then elsewhere
    assert slam.status_counts == {"tracked": 4, "uncertain": 0, "lost": 4}
    assert "discarded after 2 frames" in slam.results[5].warnings[0]
    assert slam.map_sizes == {0: 4} and slam.model.frame_count == 4
    result = slam.step(frame(3))
    assert result.is_tracked and result.map == 0  # the relocalized camera is in its old map


def test_covered_frames_begin_no_map(device):
    slam = begun(device)
    slam.run([*frames(*range(4)), *[blank(frame(4))] * 12])
    assert slam.map_sizes == {0: 4} and slam._maps.begun == 1


@pytest.mark.slow
def test_few_models_are_stored(device, monkeypatch):
    monkeypatch.setattr(maps, "MAX_MAPS", 2)
    slam = away(device)
    slam.run(frames(*range(75, 85)))
    assert slam._maps.begun == 3 and len(slam._maps.searchable) == 2
    assert set(slam.map_sizes) == {0, 1, 2}  # its frames still refer to their map


class Away:
    """Four frames, then nine of the other side of the room, for `loom.rgbd.track`."""

    seen = (*range(4), *ELSEWHERE[:9])
    intrinsic, depth_scale = property(lambda _: sequence().intrinsic), 1000.0

    def __len__(self) -> int:
        return len(self.seen)

    def read(self, index: int):
        return frame(self.seen[index])


@pytest.mark.slow
def test_a_path_reports_poses_in_a_separate_map():
    path = loom.rgbd.track(Away(), voxel_size=0.04)
    assert path.trajectory.ids[:, 0].tolist() == list(range(8, 13))
    assert len(path.true_poses) == 5 and path.error.absolute_translation.rmse < NEAR
    (other,) = path.other_maps
    assert other.ids[:, 0].tolist() == list(range(4)) and sorted(path.lost) == [4, 5, 6, 7]
    assert "2 maps without known relative poses: frame 0-3 are in a separate map" in str(path.warnings)
    report = json.loads(json.dumps(path.to_dict()))
    assert report["other_maps"] == [{"first": 0, "last": 3, "tracked": 4}] and report["tracked"] == 5
    assert "other maps" in str(path)


@pytest.mark.slow
def test_a_model_is_of_one_map():
    result = loom.rgbd.reconstruct(Away(), voxel_size=0.04)
    assert len(result.trajectory) == 5 and "2 maps" in str(result.warnings)
    lowest, highest = result.mesh.vertices.min(axis=0), result.mesh.vertices.max(axis=0)
    images = [(f.color, f.depth) for f in frames(*range(154, 159))]
    alone = loom.rgbd.reconstruct(loom.frames_from(images, sequence().intrinsic), voxel_size=0.04)
    np.testing.assert_allclose(lowest, alone.mesh.vertices.min(axis=0), atol=0.05)
    np.testing.assert_allclose(highest, alone.mesh.vertices.max(axis=0), atol=0.05)
