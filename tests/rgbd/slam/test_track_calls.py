"""`loom.track` and `loom.check_focal` as Python calls them: any frames, what the command gives, wrong arguments."""

from __future__ import annotations

import json

import numpy as np
import pytest
from click.testing import CliRunner

import pointloom as loom
from pointloom.app.shell.cli import cli
from pointloom.core.errors import FileError
from pointloom.core.timing import Clock

from ..sequences import CAMERA, turning_path, waves


class Damaged:
    """Frames that can be read by their place, but for some."""

    intrinsic, depth_scale = CAMERA, 1000.0

    def __init__(self, *damaged: int):
        self.damaged = damaged

    def __len__(self) -> int:
        return 6

    def read(self, index: int):
        if index in self.damaged:
            raise FileError(f"frame-{index}.png", "damaged")
        return waves()[index]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    path = tmp_path_factory.mktemp("frames") / "waves"
    loom.record_frames(loom.frames_from(waves(), CAMERA), path)
    return path


def test_a_list_a_generator_and_a_folder_give_the_same_path(folder):
    listed, streamed = loom.frames_from(waves(), CAMERA), loom.frames_from(iter(waves()), CAMERA)
    first, *others = (loom.track(frames, voxel_size=0.02) for frames in (listed, streamed, loom.open_frames(folder)))
    assert len(first.trajectory) == first.frame_count == 6
    for other in others:
        np.testing.assert_array_equal(other.trajectory.poses, first.trajectory.poses)
        assert other.to_json() == first.to_json()


def test_the_error_is_told_where_frames_came_with_their_poses():
    path = loom.track(loom.frames_from(waves(), CAMERA), voxel_size=0.02)
    assert path.error is not None and path.error.absolute_translation.rmse < 0.01
    untold = loom.track(loom.frames_from([(f.color, f.depth, f.timestamp) for f in waves()], CAMERA), voxel_size=0.02)
    assert untold.error is None
    np.testing.assert_array_equal(untold.trajectory.poses, path.trajectory.poses)


@pytest.mark.parametrize("frames", [[], iter([])], ids=["a list", "a generator"])
def test_no_frame_at_all_is_refused(frames):
    with pytest.raises(ValueError, match="frames: expected at least one frame"):
        loom.track(loom.frames_from(frames, CAMERA))


def test_one_frame_is_where_the_world_begins():
    path = loom.track(loom.frames_from(waves()[:1], CAMERA))
    np.testing.assert_array_equal(path.trajectory.poses, np.eye(4)[None])
    assert (path.residuals, path.poor, path.error) == ((), None, None)


def test_what_cannot_be_read_is_named_and_left_out():
    path = loom.track(Damaged(2), voxel_size=0.02)
    assert path.unreadable == {2: "frame-2.png: damaged"}
    assert path.trajectory.ids[:, 0].tolist() == [0, 1, 3, 4, 5]
    assert "1 of 6 frames cannot be read and are left out: frame-2.png: damaged" in str(path.poor)
    with pytest.raises(FileError, match=r"frame-0\.png: damaged"):
        loom.track(Damaged(*range(6)))


def test_a_clock_counts_the_stages():
    clock = Clock()
    loom.track(loom.frames_from(waves()[:2], CAMERA), clock=clock)
    assert list(clock.seconds) == ["read", "track"]


def test_the_command_gives_the_same_poses_figures_and_lines(folder, tmp_path):
    words = ["track", str(folder), "-o", str(tmp_path / "poses.log"), "--device", "cpu"]
    shown = CliRunner().invoke(cli, words)
    printed = CliRunner().invoke(cli, [*words, "--force", "--json"])
    assert (shown.exit_code, printed.exit_code) == (0, 0)
    path = loom.track(loom.open_frames(folder))
    loom.write_trajectory(tmp_path / "own.log", path.trajectory)
    assert (tmp_path / "own.log").read_bytes() == (tmp_path / "poses.log").read_bytes()
    report = json.loads(printed.stdout)
    assert report.items() >= json.loads(json.dumps(path.to_json())).items()
    told = dict(line.split(maxsplit=1) for line in shown.stdout.splitlines()[1:] if not line.startswith("   "))
    for label, value in (line.split(maxsplit=1) for line in str(path).splitlines()):
        assert told[label].split("; ")[-1] == value.split("; ")[-1]


def test_without_a_trajectory_the_frames_are_tracked_first():
    """They hardly turn: nothing is told, and nothing is made up."""
    assert loom.check_focal(loom.frames_from(waves(), CAMERA)) is None


def test_frames_of_a_list_are_checked_as_those_that_can_be_read():
    class Readable(Damaged):
        def read(self, index: int):
            return waves()[0]

    listed = loom.frames_from([waves()[0]] * 6, CAMERA)
    assert loom.check_focal(listed, turning_path()) == loom.check_focal(Readable(), turning_path())


def test_a_number_of_no_frame_is_refused():
    poses = turning_path().poses
    strange = loom.Trajectory(poses, ids=np.array([[0, 0, 1], [90, 90, 91], [91, 91, 92], [92, 92, 93]]))
    for frames in (Damaged(), loom.frames_from(waves(), CAMERA)):
        with pytest.raises(ValueError, match=r"trajectory: names frame 9[0-2], and frames has no such frame"):
            loom.check_focal(frames, strange)
