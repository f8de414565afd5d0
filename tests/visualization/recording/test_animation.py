"""Animations and videos have one frame per step, the given frame rate, and the drawn colors."""

import io
import json
import shutil
import subprocess

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.visualization.recording.film import Film, view_frames
from pointloom.visualization.recording.timeline import Frame, Placement, Shape, Timeline
from pointloom.visualization.recording.writers import changed_box, make_palette, write_gif

WHITE = (255, 255, 255)
ORANGE, BLUE = (255, 180, 0), (0, 166, 237)
has_ffmpeg = pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="needs the program ffmpeg")


def pictures(count: int = 12, height: int = 41, width: int = 61) -> list[np.ndarray]:
    """A square that moves to the right and stops at the eighth image."""
    made = []
    for k in range(count):
        picture = np.full((height, width, 3), 255, np.uint8)
        left = 3 * min(k, 8)
        picture[10:20, left : left + 12] = 200, 30 * min(k, 8), 40
        made.append(picture)
    return made


def read_back(data: bytes) -> tuple[list[np.ndarray], list[int]]:
    """The frames of an animation as an image reader decodes them, and their durations [ms]."""
    image = Image.open(io.BytesIO(data))
    frames, durations = [], []
    for k in range(getattr(image, "n_frames", 1)):
        image.seek(k)
        image.load()
        frames.append(np.array(image.convert("RGB")))
        durations.append(image.info["duration"])
    return frames, durations


def two_cloud_timeline(frames: int = 4) -> Timeline:
    """A blue cloud, and an orange one with a value that moves onto it."""
    square = np.random.default_rng(0).uniform(-1, 1, (400, 3)).astype(np.float32)
    shapes = [Shape("points", square, size=5.0, plain=color) for color in (BLUE, ORANGE)]
    timeline = Timeline(np.array([5e5, 5e6, 0.0]), shapes, fps=10.0)
    for k in range(frames):
        pose = np.eye(4)
        pose[0, 3] = 4.0 - k
        shown = {"target": Placement((0,)), "source": Placement((1,), pose)}
        timeline.frames.append(Frame(shown, f"step {k}", {"rmse": 1.0 / (k + 1)}))
    return timeline


def film_of(timeline: Timeline, size: tuple[int, int] = (160, 120), device: str = "cpu") -> Film:
    return Film(timeline, view_frames(timeline, None, *size), *size, (1.0, 1.0, 1.0), device)


def near(picture: np.ndarray, color: tuple[int, int, int]) -> np.ndarray:
    return (np.abs(picture.astype(int) - color) < 40).all(axis=2)


@pytest.mark.parametrize(("fps", "total"), [(30, 400), (7, 1714)])
def test_a_gif_has_all_frames_and_the_right_duration(fps, total):
    drawn, file = pictures(), io.BytesIO()
    palette = make_palette(drawn, WHITE)
    assert write_gif(file, drawn, palette, fps) == 12
    assert file.getvalue()[13 : 13 + 768] == palette.tobytes() and tuple(palette[0]) == WHITE  # one for all frames
    frames, durations = read_back(file.getvalue())
    assert len(frames) == 12
    assert abs(sum(durations) - total) <= 5
    for frame, picture in zip(frames, drawn, strict=True):
        assert np.abs(frame.astype(int) - picture).max() < 8
        assert (frame == 255).all(axis=2).sum() == (picture == 255).all(axis=2).sum()


def test_the_changed_box_is_exact_to_the_pixel():
    before = np.zeros((20, 30, 3), np.uint8)
    after = before.copy()
    after[4:9, 7:11, 1] = 1
    assert changed_box(after, before) == (7, 4, 11, 9)
    assert changed_box(before, before) == (0, 0, 1, 1)
    assert changed_box(before, None) == (0, 0, 30, 20)


def test_a_frame_shows_the_shapes_at_their_current_poses(device):
    film = film_of(two_cloud_timeline(), (320, 240), device)
    columns = []
    for k in range(4):
        picture = film.draw(k)
        assert picture.shape == (240, 320, 3)
        orange, blue = near(picture, ORANGE), near(picture[:187], BLUE)
        assert blue.sum() > 100
        columns.append(np.flatnonzero(orange.any(axis=0)).mean())
        assert orange.sum() > 100
        assert (np.concatenate([picture[186], picture[:187, 0], picture[:187, -1]]) == 255).all()  # no change beyond
    assert np.diff(columns).max() < -10 or np.diff(columns).min() > 10  # it moves in one direction


def test_values_are_plotted_beneath_up_to_the_frame():
    film = film_of(two_cloud_timeline(), (320, 240))
    strips = [film.draw(k)[190:].astype(int) for k in range(4)]
    past = [int(((strip[..., 2] - strip[..., 0]) > 100).sum()) for strip in strips]
    assert past == sorted(past)
    assert past[0] < past[3]
    timeline = two_cloud_timeline()
    timeline.frames = [Frame(frame.shown, frame.label) for frame in timeline.frames]
    assert (film_of(timeline, (320, 240))._picture_height, film._picture_height) == (240, 188)


def test_frames_without_anything_and_values_that_are_not_finite_are_drawn():
    frames = [Frame({}, "", {"a": float("nan")}), Frame({}, "x", {"a": float("inf"), "b": 2})]
    for size in ((320, 240), (160, 120), (16, 16)):
        film = film_of(Timeline(np.zeros(3), [], frames), size)
        assert [film.draw(k).shape for k in range(2)] == [(size[1], size[0], 3)] * 2


def test_a_recording_has_as_many_frames_as_steps(tmp_path):
    path = tmp_path / "walk.gif"
    reported: list[tuple[str, int, int]] = []
    with loom.record(path, size=(160, 120), fps=20, progress=lambda *step: reported.append(step)) as r:
        r.add("cloud", np.random.default_rng(0).random((100, 3)))
        for k in range(6):
            r.plot("k", k)
            r.step("the same label")
    frames, durations = read_back(path.read_bytes())
    assert (len(frames), sum(durations)) == (6, 300)
    assert frames[0].shape == (120, 160, 3)
    assert reported[-1] == ("drawing", 6, 6)


@has_ffmpeg
def test_a_video_has_as_many_frames_as_steps_and_even_sides(tmp_path):
    path = tmp_path / "walk.mp4"
    with loom.record(path, size=(161, 121), fps=25) as r:
        r.add("cloud", np.random.default_rng(0).random((100, 3)))
        for k in range(6):
            r.step(str(k))
    entries = "stream=width,height,nb_read_frames,r_frame_rate,pix_fmt"
    line = ["ffprobe", "-v", "error", "-count_frames", "-show_entries", entries, "-of", "json", str(path)]
    stream = json.loads(subprocess.run(line, capture_output=True, check=True).stdout)["streams"][0]
    assert (stream["width"], stream["height"], stream["nb_read_frames"]) == (162, 122, "6")
    assert (stream["r_frame_rate"], stream["pix_fmt"]) == ("25/1", "yuv420p")
    assert [entry.name for entry in tmp_path.iterdir()] == ["walk.mp4"]


def test_an_ffmpeg_that_fails_is_quoted_and_leaves_nothing(tmp_path, monkeypatch):
    folder = tmp_path / "bin"
    folder.mkdir()
    program = folder / "ffmpeg"
    program.write_text("#!/bin/sh\necho 'no such codec' >&2\nexit 1\n")
    program.chmod(0o755)
    monkeypatch.setenv("PATH", str(folder))
    with pytest.raises(FileError, match=r"/a\.mp4:"), loom.record(tmp_path / "a.mp4", size=(64, 48)) as r:
        r.add("cloud", np.zeros((1, 3)))
    assert [entry.name for entry in tmp_path.iterdir()] == ["bin"]


def test_a_gif_faster_than_viewers_play_is_refused(tmp_path):
    with pytest.raises(ValueError, match=r"fps.*50"):
        loom.record(tmp_path / "a.gif", fps=60)
