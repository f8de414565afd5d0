"""The room on film: frames in their order, the truth somewhere else, whole files or none."""

import shutil
import subprocess

import numpy as np
import pytest
from PIL import Image

from pointloom.cameras.camera import read_pinhole_camera_intrinsic
from pointloom.cameras.trajectory import read_trajectory
from pointloom.core.errors import FileError
from pointloom.data.scenes import room_video
from pointloom.data.scenes.room import surface_errors
from pointloom.data.scenes.room_video import room_video_frames, room_video_poses, write_room_video
from pointloom.drawing.recording import video

from ..app.commands import names_in

SMALL = {"width": 64, "height": 48}
needs_ffmpeg = pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="ffmpeg is not on the path")


@pytest.fixture(scope="module")
def frames():
    return room_video_frames(4, **SMALL)


def decoded(path):
    """The frames of a video."""
    line = ["ffmpeg", "-v", "error", "-i", path, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"]
    said = subprocess.run(line, capture_output=True, check=True).stdout
    return np.frombuffer(said, np.uint8).reshape(-1, 48, 64, 3)


@needs_ffmpeg
def test_a_video_shows_the_frames_in_their_order(frames, tmp_path):
    write_room_video(tmp_path / "room.mp4", frames)
    seen = decoded(tmp_path / "room.mp4").astype(float)
    true = np.array([frame.color for frame in frames], float)
    assert seen.shape == true.shape
    apart = np.abs(seen[:, None] - true).mean(axis=(2, 3, 4))
    assert (apart.argmin(axis=1) == range(4)).all()
    assert np.diag(apart).max() < 0.3 * apart[~np.eye(4, dtype=bool)].min()
    assert names_in(tmp_path) == ["room.mp4"]


def test_a_folder_holds_the_frames_as_jpegs(frames, tmp_path):
    write_room_video(tmp_path / "pictures", frames)
    assert names_in(tmp_path / "pictures") == [f"frame-00000{k}.jpg" for k in range(4)]
    for k, frame in enumerate(frames):
        with Image.open(tmp_path / "pictures" / f"frame-00000{k}.jpg") as picture:
            assert not picture.getexif()
            assert np.abs(np.asarray(picture, float) - frame.color).mean() < 4


def test_truth_lies_apart_and_is_exact(frames, tmp_path):
    said = []
    told = {"truth": tmp_path / "truth", "depth": True, "progress": lambda *step: said.append(step)}
    write_room_video(tmp_path / "pictures", frames, fps=4.0, **told)
    truth = tmp_path / "truth"
    assert names_in(truth) == ["camera-intrinsics.json", "depth", "poses.log", "poses.tum"]
    timed, numbered = read_trajectory(truth / "poses.tum"), read_trajectory(truth / "poses.log")
    np.testing.assert_allclose(timed.poses, room_video_poses(4), atol=1e-12)
    np.testing.assert_array_equal(numbered.poses, room_video_poses(4))
    assert timed.timestamps.tolist() == [0, 0.25, 0.5, 0.75]
    assert numbered.ids[:, 0].tolist() == [0, 1, 2, 3]
    assert read_pinhole_camera_intrinsic(truth / "camera-intrinsics.json") == frames.intrinsic
    for frame in frames:
        depth = np.load(truth / "depth" / f"{frame.name}.npy")
        assert depth.dtype == np.float32 and np.array_equal(depth, frame.depth)
    assert said == [("video", k, 4) for k in range(5)]


def test_pictures_have_the_same_bits_each_time(device):
    first, again = (room_video_frames(3, **SMALL, seed=2, device=device).read(1) for _ in range(2))
    other = room_video_frames(3, **SMALL, seed=3, device=device).read(1)
    assert first.color.tobytes() == again.color.tobytes() != other.color.tobytes()
    assert first.depth.tobytes() == other.depth.tobytes()


def test_the_way_is_one_round_as_smooth_as_a_hand():
    poses = room_video_poses(240)
    forward, eyes = poses[:, :3, 2], poses[:, :3, 3]
    turn = np.degrees(np.arccos((forward[1:] * forward[:-1]).sum(axis=1)))
    assert turn.min() > 0.8 and turn.max() < 2.2
    assert 0.02 < np.linalg.norm(np.diff(eyes, axis=0), axis=1).max() < 0.06
    assert surface_errors(eyes).min() > 0.35
    yaw = np.unwrap(np.arctan2(forward[:, 1], forward[:, 0]))
    assert np.degrees(yaw[-1] - yaw[0]) == pytest.approx(358.5, abs=0.5)


def test_what_exists_is_left_alone(frames, tmp_path):
    (tmp_path / "there").mkdir()
    (tmp_path / "there.mp4").write_bytes(b"kept")
    for path, more in [("there", {}), ("there.mp4", {}), ("new", {"truth": tmp_path / "there"}), ("no/new", {})]:
        with pytest.raises(FileError, match=r"exists already|does not exist"):
            write_room_video(tmp_path / path, frames, **more)
    assert (tmp_path / "there.mp4").read_bytes() == b"kept"
    assert names_in(tmp_path) == ["there", "there.mp4"]


def test_a_walk_that_is_interrupted_leaves_nothing(frames, tmp_path):
    def interrupt(stage, done, total):
        if done == 2:
            raise KeyboardInterrupt

    for name in ("pictures", "room.mp4"):
        if name == "room.mp4" and shutil.which("ffmpeg") is None:
            continue
        with pytest.raises(KeyboardInterrupt):
            write_room_video(tmp_path / name, frames, truth=tmp_path / "truth", depth=True, progress=interrupt)
        assert names_in(tmp_path) == []


def test_a_full_disk_is_told_and_leaves_nothing(frames, tmp_path, monkeypatch):
    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(room_video, "_write_jpeg", full)
    with pytest.raises(FileError, match="No space left"):
        write_room_video(tmp_path / "pictures", frames, truth=tmp_path / "truth")
    assert names_in(tmp_path) == []


def test_a_video_wants_ffmpeg_and_even_sides(frames, tmp_path, monkeypatch):
    with pytest.raises(ValueError, match="even sides, got 63 x 48"):
        write_room_video(tmp_path / "room.mp4", room_video_frames(2, width=63, height=48))
    with pytest.raises(ValueError, match="truth="):
        write_room_video(tmp_path / "pictures", frames, depth=True)
    with pytest.raises(ValueError, match="frame_count"):
        room_video_frames(0)
    with pytest.raises(ValueError, match="fps"):
        write_room_video(tmp_path / "pictures", frames, fps=0)
    monkeypatch.setattr(video.shutil, "which", lambda _: None)
    with pytest.raises(FileError, match="ffmpeg"):
        write_room_video(tmp_path / "room.mp4", frames)
    assert names_in(tmp_path) == []
