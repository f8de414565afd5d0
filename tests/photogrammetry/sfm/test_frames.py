"""Frames of videos and folders of photographs, prepared for structure from motion."""

import json
import subprocess
from pathlib import Path

import numpy as np
import pytest
from PIL import Image, ImageOps

import pointloom as loom
from pointloom.photogrammetry.sfm import frame_picker, image_writing, video_files
from pointloom.photogrammetry.sfm.frame_picker import FramePicker, movement
from pointloom.photogrammetry.sfm.frames import VideoSampling
from pointloom.photogrammetry.sfm.video_files import VideoFile, VideoFrames, find_container, open_video

from .conftest import write_images

READERS = pytest.mark.parametrize("reader", ["ffmpeg", pytest.param("opencv", marks=pytest.mark.slow)])


def read(path: Path) -> np.ndarray:
    with Image.open(path) as image:
        return np.array(image.convert("RGB"))


def blurred(frame: np.ndarray) -> np.ndarray:
    """Blurred along the rows, as by camera shake."""
    return np.mean([np.roll(frame, shift, axis=1) for shift in range(-4, 5)], axis=0).astype(np.uint8)


def softened(frame: np.ndarray) -> np.ndarray:
    """Slightly less sharp than its neighbors, not blurred."""
    return (0.85 * frame + 0.15 * blurred(frame)).astype(np.uint8)


def picked(frames, **options) -> FramePicker:
    picker = FramePicker(**options)
    for frame in frames:
        picker.add(frame)
    picker.end()
    return picker


def test_blurred_frames_are_not_chosen(panned):
    for start in range(0, 20, 3):
        spoiled = set(range(start, 40, 5)) | set(range(start + 1, 40, 5))
        picker = picked([blurred(f) if k in spoiled else f for k, f in enumerate(panned)])
        assert not spoiled & set(picker.chosen) and picker.blurred >= 0.8 * len(spoiled) and len(picker.chosen) >= 7


def test_frames_are_spaced_by_the_requested_movement(panned):
    for step, pixels in ((0.04, 6.4), (0.1, 16), (0.2, 32)):
        moved = 3 * np.diff(picked(panned, min_movement=step).chosen)
        assert moved.min() >= pixels - 2 * 3 and moved.max() <= pixels + 5 * 3


def test_frames_before_the_last_chosen_one_are_not_reconsidered(panned):
    near = panned[::2]
    frames = [frame if k % 3 == 2 else softened(frame) for k, frame in enumerate(near)]
    a_frame = movement(*(frame_picker.thumbnail(frame) for frame in near[:2]))
    step = a_frame / 1.2  # each frame is at a new position within the step
    assert picked(frames, min_movement=step).chosen[:6] == [2, 5, 8, 11, 14, 17]


def test_distant_frames_are_all_chosen(panned):
    far = panned[::5]  # 9 % of the width a frame
    chosen = picked(far).chosen
    assert chosen == list(range(chosen[0], len(far))) and chosen[0] <= frame_picker.SEARCHED_FRAMES


def test_a_stationary_camera_gives_one_frame(panned):
    rng = np.random.default_rng(0)
    noisy = [np.clip(panned[0] + rng.normal(0, 4, panned[0].shape), 0, 255).astype(np.uint8) for _ in range(100)]
    for k, frame in enumerate(noisy):
        frame[40:100, k : k + 25] = 128  # somebody walks by
    picker = picked(noisy, max_gap=30)
    assert len(picker.chosen) == 1 and picker.still == 3
    moved = picked([*noisy, *panned], max_gap=30)  # and then goes on
    assert len(moved.chosen) >= 8 and sum(n < 100 for n in moved.chosen) <= 2


def test_a_camera_that_goes_straight_ahead_or_rolls_slowly_is_not_still(panned):
    wide = Image.fromarray(np.concatenate([panned[0], panned[39]], axis=1)).resize((320, 240))
    inner = [wide.crop((k / 3, k / 4, 320 - k / 3, 240 - k / 4)) for k in range(100)]
    rolled = [wide.rotate(0.1 * k, Image.Resampling.BICUBIC).crop((60, 45, 260, 195)) for k in range(100)]
    for frames in (inner, rolled):
        gray = [np.asarray(frame.resize((160, 120), Image.Resampling.BILINEAR)) for frame in frames]
        picker = picked(gray, max_gap=30)
        assert len(picker.chosen) >= 3 and max(np.diff(picker.chosen)) <= 32 and picker.still == 0


def test_black_and_blank_frames_are_left_out(panned):
    black, gray = np.zeros_like(panned[0]), np.full_like(panned[0], 120)
    frames = [black, black, *panned[:10], gray, *panned[10:20], black]
    picker = picked(frames)
    assert picker.blank == [0, 1, 12, 23] and not set(picker.blank) & set(picker.chosen)
    assert len(picker.chosen) >= 4 and picker.chosen[0] < 5
    assert picked([black] * 30).chosen == [] and picked([]).chosen == []
    for shape in ((1, 1), (2, 2), (1, 500), (500, 1), (3, 3)):
        assert picked(np.random.default_rng(0).integers(0, 256, (5, *shape)).astype(np.uint8)).chosen is not None
    night = [frame // 18 for frame in panned]  # something is seen in it, by a few steps of brightness
    assert picked(night).chosen == [] and picked([frame // 9 for frame in panned]).chosen != []


@pytest.mark.slow
@READERS
def test_frames_of_a_video_are_those_of_the_numbers_in_their_names(make_video, panned, tmp_path, reader):
    video, steps = make_video("Küche 1.mp4", panned), []
    how = {"kind": "png", "sampling": VideoSampling(reader=reader), "progress": lambda *step: steps.append(step)}
    choice = loom.photogrammetry.choose_frames(video, tmp_path / "out here", **how)
    assert (choice.kind, choice.reader, choice.frame_count, choice.frames_promised) == ("video", reader, 40, 40)
    assert len(choice.names) >= 8 and choice.sizes == {(160, 120): len(choice.names)} and choice.notes == ()
    assert choice.reliable
    assert sorted(path.name for path in (tmp_path / "out here").iterdir()) == list(choice.names)
    for name, number in zip(choice.names, choice.numbers, strict=True):
        assert name == f"frame_{number:06d}.png"
        written = read(tmp_path / "out here" / name)[..., 1].astype(int)
        errors = [np.abs(written - frame).mean() for frame in panned]
        assert int(np.argmin(errors)) == number and min(errors) < 12
    assert steps[-1] == ("write", len(choice.names), len(choice.names)) and ("look", 40, 40) in steps
    (size,) = json.loads(json.dumps(choice.to_dict()))["sizes"]
    assert size == {"width": 160, "height": 120, "count": len(choice.names)}


@pytest.mark.parametrize(
    ("reader", "kind"),
    [("ffmpeg", "mp4"), *(pytest.param("opencv", k, marks=pytest.mark.slow) for k in ("mp4", "mkv"))],
)
def test_a_truncated_video_reports_the_missing_frames(make_video, panned, tmp_path, reader, kind):
    complete = make_video(f"whole.{kind}", panned * 3, *(["-movflags", "+faststart"] if kind == "mp4" else []))
    cut = tmp_path / f"cut.{kind}"
    cut.write_bytes(complete.read_bytes()[: complete.stat().st_size // 2])
    choice = loom.photogrammetry.choose_frames(cut, tmp_path / "out", sampling=VideoSampling(reader=reader))
    assert 30 < choice.frame_count < 90 and choice.frames_promised == 120
    assert f"the video is damaged or truncated: {choice.frame_count} of 120 frames were decoded" in choice.warnings[0]
    assert choice.to_dict()["reliable"] is False and choice.notes == ()


@READERS
def test_a_video_without_its_index_is_an_error(make_video, panned, tmp_path, reader):
    complete, cut = make_video("whole.mp4", panned), tmp_path / "cut.mp4"
    cut.write_bytes(complete.read_bytes()[:-2000])
    with pytest.raises(loom.FileError, match=r"cut\.mp4:"):
        loom.photogrammetry.choose_frames(cut, tmp_path / "out", sampling=VideoSampling(reader=reader))
    assert not (tmp_path / "out").exists()


@READERS
@pytest.mark.parametrize("content", [b"", bytes(range(256)) * 200])
def test_files_that_are_no_videos_are_rejected(tmp_path, reader, content):
    (tmp_path / "junk.mp4").write_bytes(content)
    with pytest.raises(loom.FileError, match=r"junk\.mp4:"):
        loom.photogrammetry.choose_frames(
            tmp_path / "junk.mp4", tmp_path / "out", sampling=VideoSampling(reader=reader)
        )


HLS = "#EXTM3U\n#EXT-X-TARGETDURATION:2\n#EXTINF:1,\n{}\n#EXT-X-ENDLIST\n"
DASH = (
    '<?xml version="1.0"?><MPD xmlns="urn:mpeg:dash:schema:mpd:2011" type="static" '
    'profiles="urn:mpeg:dash:profile:isoff-on-demand:2011"><Period><AdaptationSet mimeType="video/mp4">'
    '<Representation id="1" bandwidth="1"><BaseURL>{}</BaseURL></Representation></AdaptationSet></Period></MPD>'
)
CONCAT = "ffconcat version 1.0\nfile {}\n"


@READERS
@pytest.mark.parametrize("text", [HLS, DASH, CONCAT], ids=["HLS", "DASH", "concat"])
def test_a_playlist_is_no_video_and_is_not_followed(make_video, panned, tmp_path, reader, text):
    other, given = make_video("other.mp4", panned[:3]), tmp_path / "given.mp4"
    given.write_text(text.format(other))
    with pytest.raises(loom.FileError, match=r"given\.mp4"):
        open_video(given, reader=reader)
    for container in ("mov", "matroska", "mpegts"):  # the decoders do not guess either
        video = VideoFile(given, reader, container, None, False, 0.0)
        with pytest.raises(loom.FileError, match=r"given\.mp4"), VideoFrames(video, max_size=64) as frames:
            next(iter(frames))


@pytest.mark.parametrize(
    ("head", "container"),
    [
        (b"\0\0\0\x20ftypisom", "mov"),
        (b"\0\0\0\x08wide", "mov"),
        (b"\x1a\x45\xdf\xa3", "matroska"),
        (b"RIFF\0\0\0\0AVI LIST", "avi"),
        (b"cut" + (b"\x47" + bytes(187)) * 6, "mpegts"),
        ((bytes(4) + b"\x47" + bytes(187)) * 6, "mpegts"),
        (b"\0\0\0\x01\x67\x42", "h264"),
        (b"\0\0\0\x01\x40\x01", "hevc"),
        (b"RIFF\0\0\0\0WAVE", ""),
        (b"#EXTM3U\n", ""),
    ],
)
def test_containers_are_detected_by_their_first_bytes(tmp_path, head, container):
    path = tmp_path / "a.mp4"
    path.write_bytes(head)
    assert find_container(path) == container


def rotated(video: Path) -> Path:
    """The same video with a matrix that rotates it by 90 degrees."""
    path = video.with_name("turned.mp4")
    command = ["ffmpeg", "-v", "error", "-i", str(video), "-c", "copy", "-metadata:s:v", "rotate=90", str(path)]
    subprocess.run(command, check=True, timeout=60)
    return path


@READERS
def test_a_portrait_video_of_a_telephone_is_rotated(make_video, panned, tmp_path, reader):
    video = rotated(make_video("flat.mp4", panned))
    choice = loom.photogrammetry.choose_frames(
        video, tmp_path / "out", sampling=VideoSampling(reader=reader), kind="png"
    )
    assert set(choice.sizes) == {(120, 160)}
    written = read(tmp_path / "out" / choice.names[0])[..., 0].astype(int)
    errors = {k: np.abs(np.rot90(written, k) - panned[choice.numbers[0]]).mean() for k in (1, -1)}
    assert min(errors.values()) < 12


@READERS
@pytest.mark.parametrize("upright", [pytest.param(False, marks=pytest.mark.slow), True])
def test_anamorphic_pixels_are_made_square(make_video, panned, tmp_path, reader, upright):
    video = make_video("wide.mp4", [np.ascontiguousarray(frame[:, ::2]) for frame in panned[:12]], "-vf", "setsar=2/1")
    choice = loom.photogrammetry.choose_frames(
        rotated(video) if upright else video, tmp_path / "out", sampling=VideoSampling(reader=reader)
    )
    assert set(choice.sizes) == {(120, 160) if upright else (160, 120)}


def test_variable_frame_rates_neither_duplicate_nor_drop_frames(make_video, panned, tmp_path):
    """Uneven frame times, as telephones write them in the dark."""
    expression = "setpts='if(lt(N,20),N,20+(N-20)*5)/10/TB'"
    video = make_video("uneven.mkv", panned, "-vf", expression, "-fps_mode", "vfr")
    with video_files.VideoFrames(video_files.open_video(video), max_size=None, gray=True) as frames:
        errors = [np.abs(frame.astype(int) - panned[k]).mean() for k, frame in enumerate(frames)]
    assert len(errors) == 40 and max(errors) < 12


@pytest.mark.slow
@READERS
def test_large_frames_are_scaled_while_they_are_decoded(make_video, panned, tmp_path, reader):
    video = make_video("large.mp4", [np.kron(frame, np.ones((4, 4), np.uint8)) for frame in panned[:12]])
    choice = loom.photogrammetry.choose_frames(
        video, tmp_path / "out", max_size=160, sampling=VideoSampling(reader=reader), kind="png"
    )
    assert set(choice.sizes) == {(160, 120)}
    written = read(tmp_path / "out" / choice.names[0])[..., 0].astype(int)
    assert np.abs(written - panned[choice.numbers[0]]).mean() < 12


@pytest.mark.slow
def test_without_ffmpeg_opencv_reads_videos(make_video, panned, tmp_path, monkeypatch):
    video = make_video("v.mp4", panned)
    monkeypatch.setattr(video_files, "_ffmpeg", lambda: False)
    assert loom.photogrammetry.choose_frames(video, tmp_path / "out").reader == "opencv"
    with pytest.raises(loom.FileError, match=r"/v\.mp4:"):
        loom.photogrammetry.choose_frames(video, tmp_path / "other", sampling=VideoSampling(reader="ffmpeg"))


def test_a_black_video_is_refused(make_video, tmp_path):
    video = make_video("night.mp4", [np.zeros((48, 64), np.uint8)] * 12)
    with pytest.raises(loom.FileError, match=r"/night\.mp4:.*12.*12"):
        loom.photogrammetry.choose_frames(video, tmp_path / "out")


def test_black_frames_and_too_many_frames_are_reported(make_video, panned, tmp_path):
    video = make_video("v.mp4", [np.zeros_like(panned[0])] * 3 + panned)
    choice = loom.photogrammetry.choose_frames(video, tmp_path / "out", max_frames=4)
    assert len(choice.names) == 4 and set(choice.left_out) == {"0", "1", "2"}
    assert choice.numbers[0] < 8 and choice.numbers[-1] > 35 and np.ptp(np.diff(choice.numbers)) <= 8
    assert choice.notes[0] == "3 frames black or blank and left out: 0, 1, 2" and "max_frames" in choice.notes[1]


def test_a_video_that_takes_too_long_is_given_up(make_video, panned, tmp_path):
    video = make_video("v.mp4", panned * 5)
    with pytest.raises(loom.FileError, match=r"/v\.mp4:.*0\.001.*max_seconds"):
        loom.photogrammetry.choose_frames(video, tmp_path / "out", sampling=VideoSampling(max_seconds=1e-3))
    assert not (tmp_path / "out").exists()


def test_photographs_keep_their_order_and_their_names(panned, tmp_path):
    names = ["IMG 2.png", "IMG 10.png", "IMG 1.png"]
    source = write_images(tmp_path / "in", panned[:3], names)
    choice = loom.photogrammetry.choose_frames(source, tmp_path / "out")
    assert choice.names == ("0000_IMG 1.png", "0001_IMG 2.png", "0002_IMG 10.png") and choice.numbers == (0, 1, 2)
    assert (tmp_path / "out" / "0001_IMG 2.png").read_bytes() == (source / "IMG 2.png").read_bytes()
    plain = write_images(tmp_path / "plain", panned[:2], ["größe 1.png", "größe 2.png"])
    assert loom.photogrammetry.choose_frames(plain, tmp_path / "as they are").names == ("größe 1.png", "größe 2.png")


@pytest.mark.parametrize("orientation", [2, 5, 6, 8])
def test_photographs_are_rotated_by_exif_orientation(panned, tmp_path, orientation):
    image = Image.fromarray(panned[0])
    exif = image.getexif()
    exif[0x0112] = orientation
    exif.get_ifd(0x8769)[0xA405] = 28  # the focal length for 35 mm film
    (tmp_path / "in").mkdir()
    image.save(tmp_path / "in" / "a.jpg", exif=exif, quality=95)
    choice = loom.photogrammetry.choose_frames(tmp_path / "in", tmp_path / "out")
    with Image.open(tmp_path / "in" / "a.jpg") as before, Image.open(tmp_path / "out" / choice.names[0]) as after:
        wanted = np.array(ImageOps.exif_transpose(before)).astype(int)
        assert np.abs(np.array(after.convert("L")) - wanted).mean() < 1
        assert after.getexif().get(0x0112, 1) == 1
        assert after.getexif().get_ifd(0x8769)[0xA405] == 28


def test_gray_and_16_bit_photographs_become_8_bit(panned, tmp_path):
    (tmp_path / "in").mkdir()
    for bits in (12, 16):
        for k in range(2):
            Image.fromarray(panned[k].astype(np.uint16) << (bits - 8)).save(tmp_path / "in" / f"{k}.png")
        choice = loom.photogrammetry.choose_frames(tmp_path / "in", tmp_path / f"out {bits}", kind="png")
        written = read(tmp_path / f"out {bits}" / choice.names[0])
        assert np.abs(written.astype(int) - panned[0][..., None]).max() <= 1


def test_photographs_that_cannot_be_used_are_named(panned, tmp_path):
    source = write_images(tmp_path / "in", panned[:4])
    content = (source / "view 1.png").read_bytes()
    (source / "view 1.png").write_bytes(content[: len(content) // 2])
    (source / "view 2.png").write_bytes(b"")
    (source / "wall.nef").write_bytes(b"nef")
    write_images(source, [np.zeros((48, 64), np.uint8)], ["lens cap.png"])
    choice = loom.photogrammetry.choose_frames(source, tmp_path / "out")
    assert choice.names == ("view 0.png", "view 3.png")
    assert set(choice.left_out) == {"view 1.png", "view 2.png", "lens cap.png"}
    assert "1 image black, or of one brightness, and left out: lens cap.png" in choice.notes[0]
    assert "wall.nef" in choice.notes[1] and not choice.reliable
    assert choice.warnings[0].startswith("2 of 5 images cannot be read and are left out: view 2.png (")


def test_photographs_of_several_sizes_are_reported(panned, tmp_path):
    source = write_images(tmp_path / "in", [panned[0], panned[1][:, :100], panned[2]])
    choice = loom.photogrammetry.choose_frames(source, tmp_path / "out", max_size=80)
    assert choice.sizes == {(80, 60): 2, (67, 80): 1}
    assert "images of 2 sizes, each treated as a separate camera: 2 of 80 x 60, 1 of 67 x 80" in choice.notes


def test_a_folder_without_an_image_that_can_be_used_is_refused(panned, tmp_path):
    (tmp_path / "in").mkdir()
    with pytest.raises(loom.FileError, match="/in:"):
        loom.photogrammetry.choose_frames(tmp_path / "in", tmp_path / "out")
    (tmp_path / "in" / "a.nef").write_bytes(b"")
    with pytest.raises(loom.FileError, match=r"/in:.*1"):
        loom.photogrammetry.choose_frames(tmp_path / "in", tmp_path / "out")
    (tmp_path / "in" / "a.png").write_bytes(b"png")
    with pytest.raises(loom.FileError, match=r"/in:.*1.*a\.png"):
        loom.photogrammetry.choose_frames(tmp_path / "in", tmp_path / "out")


def test_a_folder_with_contents_is_not_written_to(panned, tmp_path):
    source = write_images(tmp_path / "in", panned[:2])
    with pytest.raises(loom.FileError, match="in:"):
        loom.photogrammetry.choose_frames(source, source)
    assert len(list(source.iterdir())) == 2
    (tmp_path / "file").write_text("x")
    with pytest.raises(loom.FileError, match="file:"):
        loom.photogrammetry.choose_frames(source, tmp_path / "file")


@pytest.mark.parametrize(("kind", "stage"), [("video", "look"), ("folder", "write")])
def test_an_interrupt_leaves_nothing_behind(make_video, panned, tmp_path, kind, stage):
    def interrupt(now: str, done: int, total: int) -> None:
        if now == stage and done == 3:
            raise KeyboardInterrupt

    source = make_video("v.mp4", panned) if kind == "video" else write_images(tmp_path / "in", panned)
    with pytest.raises(KeyboardInterrupt):
        loom.photogrammetry.choose_frames(source, tmp_path / "out", progress=interrupt)
    assert not (tmp_path / "out").exists()


def test_a_full_disk_leaves_nothing_behind(panned, tmp_path, monkeypatch):
    source, written = write_images(tmp_path / "in", panned[:4]), []
    real = image_writing.atomic_write

    def full(path, **options):
        written.append(path)
        if len(written) == 3:
            raise loom.FileError(path, "cannot be written: No space left on device")
        return real(path, **options)

    monkeypatch.setattr(image_writing, "atomic_write", full)
    with pytest.raises(loom.FileError, match="No space left"):
        loom.photogrammetry.choose_frames(source, tmp_path / "out")
    assert not (tmp_path / "out").exists() and len(written) == 3
