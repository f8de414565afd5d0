"""track: the camera trajectory, its errors, reports of lost frames, and invalid calls."""

import json

import numpy as np
import pytest

from pointloom.cameras.trajectory import read_trajectory
from pointloom.cli.jobs.track import track_folder
from pointloom.io.pictures.image_files import read_depth, write_png
from pointloom.rgbd.slam import tracking
from pointloom.rgbd.slam.fixed_parts import FixedParts
from pointloom.rgbd.slam.results import TrackingResult
from pointloom.rgbd.slam.stream_check import StreamCheck

from .commands import answer, names_in, refusal, run, unreliable


class Guided:
    """A tracker that returns the true poses with given statuses; only the command is tested."""

    def __init__(self, fates: dict[int, str] | None = None):
        self.fates, self.seen, self.folded = fates or {}, 0, []
        self.results, self.joins, self.stream, self.fixed_parts = [], [], StreamCheck(), FixedParts()

    def join_maps(self):
        return []

    def step(self, frame):
        self.results.append(self.judge(frame))

    def judge(self, frame):
        number = self.seen
        self.seen += 1
        fate = self.fates.get(number, "tracked")
        if not (np.asarray(frame.depth) > 0).any():
            fate = "lost"
        if fate == "lost":
            return TrackingResult(None, fate, ("no depth in reach",))
        if fate == "tracked":
            self.folded.append(frame.name)
        pose = np.linalg.inv(self.start(frame)) @ frame.T_world_camera
        return TrackingResult(pose, fate, inlier_rmse=0.002, fitness=0.9, iterations=int(number > 0))

    def start(self, frame):
        if not hasattr(self, "first"):
            self.first = frame.T_world_camera
        return self.first


@pytest.fixture
def guided(monkeypatch):
    """Make trackers that return the true poses, with the statuses of some frames."""

    def use(fates=None):
        tracker = Guided(fates)
        monkeypatch.setattr(tracking, "make_slam", lambda *_, **__: tracker)
        return tracker

    use()
    monkeypatch.setattr("pointloom.cli.jobs.track.check_focal", lambda *_, **__: None)  # see tests/rgbd/slam
    return use


def test_track_writes_the_trajectory_and_its_errors(guided, frames, tmp_path):
    tracker = guided()
    report = answer("track", frames, "-o", tmp_path / "poses.log")
    trajectory = read_trajectory(tmp_path / "poses.log")
    truth = np.array([np.loadtxt(path) for path in sorted(frames.glob("*.pose.txt"))])
    np.testing.assert_allclose(trajectory.poses, np.linalg.inv(truth[0]) @ truth, atol=1e-12)
    assert trajectory.ids[:, 0].tolist() == [0, 1, 2, 3, 4, 5]
    assert (report["frames"], report["tracked"], report["lost"], report["uncertain"]) == (6, 6, [], [])
    assert report["errors"]["absolute"]["m"]["rmse"] < 1e-9 and report["files"] == [str(tmp_path / "poses.log")]
    assert tracker.folded == [f"frame-{i:06d}" for i in range(6)]


def test_a_lost_frame_has_no_pose_and_is_reported(guided, frames, tmp_path):
    tracker = guided({2: "lost", 3: "lost", 5: "uncertain"})
    report = unreliable("track", frames, "-o", tmp_path / "poses.log")
    assert [entry["frame"] for entry in report["lost"]] == [2, 3] and report["uncertain"] == [5]
    assert "2 of 6 frames were lost (frame 2-3) and are left out: no depth in reach" in str(report["warnings"])
    trajectory = read_trajectory(tmp_path / "poses.log")
    assert trajectory.ids[:, 0].tolist() == [0, 1, 4, 5] and report["errors"]["compared"] == 4
    assert report["errors"]["absolute"]["m"]["rmse"] < 1e-9  # each pose is compared with its own ground truth
    assert "frame-000002" not in tracker.folded
    guided({2: "lost", 3: "lost", 5: "uncertain"})
    result = run("track", frames, "-o", tmp_path / "again.txt")
    assert result.exit_code == 3
    for part in ("ATE", "RPE", "frames/s", "off the model", "lost       2: frame 2-3", "uncertain  1: frame 5"):
        assert part in result.stdout


def test_broken_and_missing_pictures_are_left_out_and_named(guided, frames, tmp_path):
    path = frames / "frame-000003.depth.png"
    path.write_bytes(path.read_bytes()[:-200])
    report = unreliable("track", frames, "-o", tmp_path / "poses.log")
    assert [entry["frame"] for entry in report["unreadable"]] == [3]
    assert "1 of 6 frames cannot be read and are left out: " in str(report["warnings"])
    assert "frame-000003.depth.png (byte" in str(report["warnings"])
    assert read_trajectory(tmp_path / "poses.log").ids[:, 0].tolist() == [0, 1, 2, 4, 5]
    guided()
    (frames / "frame-000004.color.png").unlink()
    report = unreliable("track", frames, "-o", tmp_path / "poses.txt")
    assert report["frames"] == 5
    assert "1 of 6 frames lack an image and are left out, the first frame-000004.color.png" in str(report["warnings"])


def test_frames_beyond_depth_max_and_without_any_depth_are_unreliable(guided, frames, tmp_path):
    report = unreliable("track", frames, "-o", tmp_path / "poses.txt", "--depth-max", "0.1")
    assert "raise depth_max" in str(report["warnings"])
    for path in frames.glob("*.depth.png"):
        write_png(path, np.zeros_like(read_depth(path)))
    report = unreliable("track", frames, "-o", tmp_path / "other.txt")
    assert (report["tracked"], report["files"], report["errors"]) == (0, [], None)
    assert "other.txt" not in names_in(tmp_path)


def test_track_rejects_invalid_calls_first(guided, frames, tmp_path):
    poses = tmp_path / "poses.txt"
    assert "poses are not written to .ply" in refusal("track", frames, "-o", tmp_path / "a.ply")
    assert "does not exist" in refusal("track", tmp_path / "none", "-o", poses)
    assert "Make the folder first" in refusal("track", frames, "-o", tmp_path / "no" / "a.txt")
    poses.write_text("kept")
    assert "Give another name, or --force" in refusal("track", frames, "-o", poses) and poses.read_text() == "kept"
    assert answer("track", frames, "-o", poses, "--force")["tracked"] == 6
    assert "expected at least two frames, got one" in refusal("track", frames, "-o", poses, "--force", "--every", 10)
    for path in frames.glob("*.png"):
        path.write_bytes(path.read_bytes()[:-200])
    assert "frame-000000.depth.png (byte" in refusal("track", frames, "-o", tmp_path / "b.txt")
    assert names_in(tmp_path) == ["frames", "poses.txt"]


def test_a_camera_of_another_size_is_an_error_that_names_the_option(guided, frames, tmp_path):
    camera = tmp_path / "camera.json"
    content = json.loads((frames / "camera-intrinsics.json").read_text())
    camera.write_text(json.dumps(content | {"width": 640, "height": 480}))
    message = refusal("track", frames, "-o", tmp_path / "a.txt", "--intrinsic", camera)
    assert "is 160 x 120, but the intrinsic given is for 640 x 480" in message
    assert "Give --intrinsic of these images" in message


def test_an_interruption_leaves_nothing(guided, frames, tmp_path):
    def interrupt(stage, done, total):
        if done == 3:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        track_folder(frames, tmp_path / "poses.txt", progress=interrupt)
    assert names_in(tmp_path) == ["frames"]
