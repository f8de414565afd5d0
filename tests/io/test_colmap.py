"""COLMAP models are read as by COLMAP, written files are valid in COLMAP, and damage is reported with its location."""

import json
import struct
import subprocess
import sys

import numpy as np
import pytest

import pointloom as loom
from pointloom.io.models import colmap_binary, colmap_text
from pointloom.io.models.colmap import read_colmap_model

from ..cameras.colmap_oracle import query_colmap
from .sfm_models import LENS, assert_same, ring_model

FORMS = ["bin", "txt"]
MODEL = ring_model()


@pytest.fixture(params=FORMS)
def form(request) -> str:
    return request.param


@pytest.fixture
def folder(tmp_path, form):
    loom.write_colmap_model(tmp_path / "model", MODEL, format=form)
    return tmp_path / "model"


@pytest.fixture(scope="module")
def synthetic(tmp_path_factory):
    """A model made by COLMAP in both formats, and its description; with rigs of two cameras."""
    folders = [tmp_path_factory.mktemp("binary"), tmp_path_factory.mktemp("text")]
    options = {"num_rigs": 2, "num_cameras_per_rig": 2, "num_frames_per_rig": 3, "num_points3D": 80}
    question = {"options": options, "binary": [str(folders[0])], "text": [str(folders[1])]}
    return folders, query_colmap("synthesize", question)


@pytest.mark.parametrize("which", [0, 1], ids=FORMS)
def test_models_written_by_colmap_are_read(synthetic, which):
    folders, expected = synthetic
    model = read_colmap_model(folders[which])
    assert {"rigs", "frames"} <= {path.stem for path in folders[which].iterdir()}  # of version 4
    assert sorted(expected["images"]) == list(model.names)
    for i, name in enumerate(model.names):
        (lens, width, height, params), pose, observed = expected["images"][name]
        assert model.cameras[i] == loom.CameraModel(lens, width, height, params)
        assert np.abs(model.T_camera_world[i, :3] - pose).max() < 1e-14
        rows = model.observations[:, 0] == i
        actual = np.hstack([model.pixels[rows] + 0.5, model.points[model.observations[rows, 1]]])
        assert np.array_equal(actual[np.lexsort(actual.T)], np.array(observed)[np.lexsort(np.array(observed).T)])
    rows, points = np.array(expected["points"]), np.column_stack([model.points, model.colors, model.view_counts])
    assert np.array_equal(points[np.lexsort(points.T)], rows[np.lexsort(rows.T)])


def test_colmap_reads_written_models(folder):
    description = query_colmap("describe", str(folder))
    assert sorted(description["images"]) == list(MODEL.names)
    assert description["error"] < 1e-3  # the keypoints have three decimals
    assert len(description["points"]) == len(MODEL.points)
    for i, name in enumerate(MODEL.names):
        _, pose, observed = description["images"][name]
        assert np.abs(MODEL.T_camera_world[i, :3] - pose).max() < 1e-14
        assert len(observed) == (MODEL.observations[:, 0] == i).sum()


@pytest.mark.parametrize(("images", "points"), [(1, 0), (1, 1), (2, 3), (None, None)])
def test_model_round_trip(tmp_path, form, images, points):
    lists = [values[:images] for values in (MODEL.names, MODEL.cameras, MODEL.T_camera_world)]
    model = loom.SfmModel(*lists, MODEL.points[:points]) if images else MODEL
    loom.write_colmap_model(tmp_path / "m", model, format=form)
    assert_same(read_colmap_model(tmp_path / "m"), model, poses=1e-15, pixels=1e-12)


@pytest.mark.parametrize("subfolder", ["sparse/0", "sparse", "0", "."])
def test_model_in_a_subfolder_of_the_project_is_read(tmp_path, form, subfolder):
    loom.write_colmap_model(tmp_path / "project" / subfolder, MODEL, format=form)
    assert len(read_colmap_model(tmp_path / "project")) == len(MODEL)


def test_of_several_models_one_must_be_chosen(tmp_path):
    loom.write_colmap_model(tmp_path / "sparse/0", MODEL.select(MODEL.names[:2]))
    loom.write_colmap_model(tmp_path / "sparse/1", MODEL, format="txt")
    with pytest.raises(loom.FileError, match=r"2.*sparse/0.*2.*sparse/1.*6"):
        read_colmap_model(tmp_path)
    assert len(read_colmap_model(tmp_path / "sparse/1")) == 6


def test_a_missing_file_or_model_is_named(folder, form, tmp_path):
    (tmp_path / "file").write_text("x")
    for name, reason in (("", "contains no COLMAP model"), ("none", "does not exist"), ("file", "is a file")):
        with pytest.raises(loom.FileError, match=reason):
            read_colmap_model(tmp_path / name)
    for name in ("cameras", "images", "points3D"):
        (folder / f"{name}.{form}").rename(tmp_path / "part")
        with pytest.raises(loom.FileError, match=f"but not {name}.{form}"):
            read_colmap_model(folder)
        (tmp_path / "part").rename(folder / f"{name}.{form}")


def test_writing_replaces_the_existing_model_in_both_formats(folder, form):
    for name in ("rigs.bin", "frames.txt", "project.ini"):
        (folder / name).write_text("of the old model")
    other = "txt" if form == "bin" else "bin"
    loom.write_colmap_model(folder, MODEL.select(MODEL.names[:3]), format=other)
    names = sorted(path.name for path in folder.iterdir())
    assert names == sorted([*(f"{name}.{other}" for name in ("cameras", "images", "points3D")), "project.ini"])
    assert len(read_colmap_model(folder)) == 3


def test_a_model_that_may_not_be_replaced_stays(folder):
    before = {path.name: path.read_bytes() for path in folder.iterdir()}
    with pytest.raises(loom.FileError, match="already"):
        loom.write_colmap_model(folder, MODEL.select(MODEL.names[:2]), overwrite=False)
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == before


@pytest.mark.parametrize("failing", ["write_cameras", "write_images", "write_points"])
def test_full_disk_preserves_the_existing_files(folder, form, failing, monkeypatch, tmp_path):
    def fail(*_):
        raise OSError(28, "No space left on device")

    before = {path.name: path.read_bytes() for path in folder.iterdir()}
    monkeypatch.setattr(colmap_binary if form == "bin" else colmap_text, failing, fail)
    for target in (folder, tmp_path / "new"):
        with pytest.raises(loom.FileError, match="No space left"):
            loom.write_colmap_model(target, MODEL.scaled(2), format=form)
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == before and not (tmp_path / "new").exists()


def test_models_unsupported_by_colmap_are_rejected(tmp_path):
    lens = loom.CameraModel("METASHAPE", 640, 480, [500, 320, 240, *[0.0] * 7, 1.0])
    for model, message, form in (
        (loom.SfmModel(["a"], [lens], np.eye(4)[None]), "no camera model METASHAPE", "bin"),
        (loom.SfmModel(["a\nb"], [LENS], np.eye(4)[None]), "text cannot store", "txt"),
        (loom.SfmModel(["a b"], [LENS], np.eye(4)[None]), "text cannot store", "txt"),
        (loom.SfmModel(["a\0b"], [LENS], np.eye(4)[None]), "cannot store the image name", "bin"),
        (loom.SfmModel([], [], []), "at least one image", "bin"),
        (MODEL, "format", "ply"),
    ):
        with pytest.raises(ValueError, match=message):
            loom.write_colmap_model(tmp_path / "m", model, format=form)
    with pytest.raises(TypeError, match="model: expected an SfmModel, got CameraModel"):
        loom.write_colmap_model(tmp_path / "m", LENS)
    assert not (tmp_path / "m").exists()
    (tmp_path / "file").touch()
    with pytest.raises(loom.FileError, match=r"/file/m: cannot be created: Not a directory"):
        loom.write_colmap_model(tmp_path / "file" / "m", MODEL)


POSE = 8 + 4  # the quaternion of the first image
NAME = 8 + 4 + 56 + 4
KEYPOINTS = NAME + len(MODEL.names[0]) + 1


@pytest.mark.parametrize(
    ("name", "at", "new", "message"),
    [
        ("images.bin", 0, struct.pack("<Q", 0), "bytes follow the last record"),
        ("images.bin", KEYPOINTS, struct.pack("<Q", 2**60), "keypoints, but only"),
        ("points3D.bin", 8 + 43, struct.pack("<Q", 2**64 - 1), r"byte \d+.*ends within"),
        ("cameras.bin", 12, struct.pack("<i", 99), r"byte 8.*unknown camera model 99"),
        ("cameras.bin", 12, struct.pack("<i", 17), "EQUIRECTANGULAR is not supported"),
        ("cameras.bin", 16, struct.pack("<Q", 2**63), r"byte 8.*width"),
        ("cameras.bin", 32, struct.pack("<d", np.nan), r"byte 8.*finite"),
        ("cameras.bin", 8, struct.pack("<I", 7), "camera 1, which is missing in cameras.bin"),
        ("images.bin", POSE, struct.pack("<d", np.nan), r"byte 8.*no pose"),
        ("images.bin", NAME, b"\xff\xfe", r"byte \d+.*not UTF-8"),
        ("cameras.bin", 96, struct.pack("<I", 1), r"byte 96.*the camera number 1 is duplicated"),
        ("images.bin", NAME, b"\0", "without an end|expected|no name|name"),
        ("images.bin", KEYPOINTS + 8, struct.pack("<d", np.nan), "keypoint of 'left/00.png' is not finite"),
        ("images.bin", KEYPOINTS + 24, struct.pack("<q", 999), "point 999, which is missing in points3D.bin"),
        ("images.bin", KEYPOINTS + 24, struct.pack("<q", -1), "does not refer to it|keypoints belong"),
        ("points3D.bin", 16, struct.pack("<d", np.nan), r"byte 8.*position is not finite"),
        ("points3D.bin", 8, struct.pack("<Q", 2), r"byte \d+.*number 2 is duplicated"),
    ],
)
def test_damage_is_reported_with_its_location(tmp_path, name, at, new, message):
    loom.write_colmap_model(tmp_path, MODEL)
    data = bytearray((tmp_path / name).read_bytes())
    data[at : at + len(new)] = new
    (tmp_path / name).write_bytes(data)
    with pytest.raises(loom.FileError, match=message):
        read_colmap_model(tmp_path)


@pytest.mark.parametrize("rows", [1, 7, 40])
def test_blocks_of_any_size_give_one_file(tmp_path, monkeypatch, rows):
    loom.write_colmap_model(tmp_path / "a", MODEL)
    monkeypatch.setattr(colmap_binary, "_ROWS_PER_BLOCK", rows)
    loom.write_colmap_model(tmp_path / "b", MODEL)
    for path in (tmp_path / "a").iterdir():
        assert path.read_bytes() == (tmp_path / "b" / path.name).read_bytes()
    assert_same(read_colmap_model(tmp_path / "b"), read_colmap_model(tmp_path / "a"))


def test_an_image_without_a_name_is_rejected(tmp_path):
    loom.write_colmap_model(tmp_path, MODEL)
    data = (tmp_path / "images.bin").read_bytes()
    (tmp_path / "images.bin").write_bytes(data[:NAME] + data[NAME + len(MODEL.names[0]) :])
    with pytest.raises(loom.FileError, match=r"/images\.bin \(byte 8\): an image has no name"):
        read_colmap_model(tmp_path)


@pytest.mark.parametrize("name", ["cameras.bin", "images.bin", "points3D.bin"])
def test_truncated_or_overlong_file_is_rejected(tmp_path, name):
    loom.write_colmap_model(tmp_path, MODEL)
    data = (tmp_path / name).read_bytes()
    rng = np.random.default_rng(3)
    for end in [0, 1, 7, 8, 9, *rng.integers(10, len(data), 40).tolist(), len(data) - 1]:
        (tmp_path / name).write_bytes(data[:end])
        with pytest.raises(loom.FileError, match=r"byte|is empty"):
            read_colmap_model(tmp_path)
    (tmp_path / name).write_bytes(data + b"\0")
    with pytest.raises(loom.FileError, match="1 bytes follow the last record"):
        read_colmap_model(tmp_path)


@pytest.mark.parametrize("name", ["cameras", "images", "points3D"])
def test_random_bytes_never_crash_the_reader(folder, form, name):
    path = folder / f"{name}.{form}"
    data = path.read_bytes()
    rng = np.random.default_rng(5)
    for trial in range(120):
        spoiled = bytearray(data)
        for at in rng.integers(0, len(data), 1 + trial % 6):
            spoiled[at] = rng.integers(0, 256)
        path.write_bytes(spoiled if trial % 4 else rng.bytes(200))
        try:
            model = read_colmap_model(folder)
        except loom.FileError as error:
            assert str(path) in str(error) or "images" in str(error) or "points3D" in str(error)
        else:
            assert len(model) == len(MODEL)


CAMERAS = "# list\n\n1 PINHOLE 640 480 500 500 320 240\n"
IMAGES = "1 1 0 0 0 0 0 0 1 a b.png\n10.5 20.5 3\n2 1 0 0 0 1 0 0 1 c.png\n\n"
POINTS = "3 0 0 2 1 2 3 0.5 1 0\n"


def write_text(folder, cameras=CAMERAS, images=IMAGES, points=POINTS, encoding="utf-8"):
    for name, text in (("cameras", cameras), ("images", images), ("points3D", points)):
        (folder / f"{name}.txt").write_bytes(text.encode(encoding))
    return folder


@pytest.mark.parametrize("change", [str, lambda s: s.replace("\n", "\r\n"), lambda s: "\ufeff" + s, str.rstrip])
def test_text_is_read_with_any_line_ends(tmp_path, change):
    images = change(IMAGES) if change is not str.rstrip else IMAGES
    model = read_colmap_model(write_text(tmp_path, change(CAMERAS), images, change(POINTS)))
    assert model.names == ("a b.png", "c.png") and model.pixels.tolist() == [[10, 20]]
    assert model.colors.tolist() == [[1, 2, 3]] and model.errors.tolist() == [0.5]


@pytest.mark.parametrize(
    ("file", "text", "message"),
    [
        ("cameras", "1 PINHOLE 640\n", "line 1.*got 3 columns"),
        ("cameras", "1 METASHAPE 640 480 1 1 1 1\n", "line 1.*unknown camera model"),
        ("cameras", "1 PINHOLE 640 480 1 1 1 1 1\n", r"/cameras\.txt \(line 1\):.*takes fx, fy, cx, cy; got 5"),
        ("cameras", "1 PINHOLE 640 480 1 1 1 x\n", "line 1.*not a number: 'x'"),
        ("cameras", CAMERAS + CAMERAS[8:], "line 4.*number 1 is duplicated"),
        ("cameras", "# nothing\n", "camera 1, which is missing in cameras.txt"),
        ("images", "1 1 0 0 0 0 0 0 1\n\n", "line 1.*got 9 columns"),
        ("images", "1 1 0 0 0 0 0 0 1 a", "line 1.*line of keypoints is missing"),
        ("images", "1 1 0 0 0 0 0 0 1 a\n1 2\n", "line 2.*3 numbers per keypoint"),
        ("images", "1 1 0 0 0 0 0 0 1 a\n1 nan 3\n", "not finite"),
        ("images", "1 1 0 0 0 0 0 0 1 a\n1 2 3\n1 1 0 0 0 0 0 0 1 b\n\n", "line 3.*number 1 is duplicated"),
        ("images", "1 1 0 0 0 0 0 0 1 a\n1 2 3\n2 1 0 0 0 0 0 0 1 a\n\n", "line 3.*'a' is duplicated"),
        ("images", "1 0.5 0.5 0.5 0.6 0 0 0 1 a\n1 2 3\n", "line 1.*no pose"),
        ("images", "# nothing\n", "contains no image"),
        ("points3D", "\n# c\n3 0 0 2 1 2 3 0.5 1\n", "line 3.*expected 8 numbers"),
        ("points3D", "3 0 0 2 1 2 256 0.5 1 0\n", "line 1.*colors of 0..255"),
        ("points3D", "3 0 0 2 1 2 2.5 0.5 1 0\n", "line 1.*a color: expected a whole number"),
        ("points3D", "3 0 0 nan 1 2 3 0.5 1 0\n", "line 1.*not finite"),
        ("points3D", "", "observes point 3, which is missing in points3D.txt"),
        ("points3D", "3 0 0 2 1 2 3 0.5\n", "1 keypoints belong to points, but the tracks have 0"),
        ("points3D", POINTS + POINTS, "line 2.*number 3 is duplicated"),
    ],
)
def test_invalid_text_is_reported_with_its_line(tmp_path, file, text, message):
    write_text(tmp_path, **{{"points3D": "points"}.get(file, file): text})
    with pytest.raises(loom.FileError, match=message):
        read_colmap_model(tmp_path)


def test_text_in_another_encoding_is_reported_and_a_point_without_an_error_or_a_track_is_read(tmp_path):
    model = read_colmap_model(write_text(tmp_path, points=POINTS + "9 1 1 1 0 0 0 -1\n"))
    assert np.isnan(model.errors[1]) and model.view_counts.tolist() == [1, 0]
    write_text(tmp_path, images=IMAGES.replace("a b", "größe"), encoding="latin-1")
    with pytest.raises(loom.FileError, match=r"/images\.txt \(byte 20\):"):
        read_colmap_model(tmp_path)


TWO = CAMERAS + "2 PINHOLE 640 480 510 510 320 240\n"
STALE = "1 1 0 0 0 0 0 0 1 a\n\n2 0 1 0 0 4 1 2 2 b\n\n3 nan 0 0 0 0 0 5 1 c\n\n4 1 0 0 0 -3 0 5 2 d\n\n"
RIGS = "# list\n7 3 CAMERA 1 CAMERA 2 1 0 1 0 0 -0.1 0 2 IMU 2 0\n"
FRAMES = "1 7 1 0 0 0 0 0 0 3 CAMERA 1 1 CAMERA 2 2 IMU 2 2\n2 7 0 0 1 0 0 0 5 3 CAMERA 2 4 CAMERA 1 3 CAMERA 1 99\n"
SENSORS = {"CAMERA": 0, "IMU": 1}


def pack_rigs(folder):
    """RIGS and FRAMES in COLMAP's binary form."""
    rig, frames = struct.pack("<QII", 1, 7, 3), struct.pack("<Q", 2)
    rig += struct.pack("<iIiIB7d", 0, 1, 0, 2, 1, *map(float, RIGS.split()[9:16])) + struct.pack("<iIB", 1, 2, 0)
    for words in map(str.split, FRAMES.splitlines()):
        frames += struct.pack("<II7dI", *map(int, words[:2]), *map(float, words[2:9]), int(words[9]))
        for kind, sensor, number in zip(words[10::3], words[11::3], words[12::3], strict=True):
            frames += struct.pack("<iIQ", SENSORS[kind], int(sensor), int(number))
    (folder / "rigs.bin").write_bytes(rig)
    (folder / "frames.bin").write_bytes(frames)


def write_rigs(folder, form, rigs=RIGS, frames=FRAMES):
    write_text(folder, TWO, STALE.replace("nan", "1"), "")
    if form == "bin":
        model = read_colmap_model(folder)
        loom.write_colmap_model(folder, model, format="bin")
        pack_rigs(folder)
        return folder
    (folder / "images.txt").write_text(STALE)
    for name, text in (("rigs", rigs), ("frames", frames)):
        if text is not None:
            (folder / f"{name}.txt").write_text(text)
    return folder


def test_poses_of_frames_and_rigs_replace_outdated_copies(tmp_path, form):
    model = read_colmap_model(write_rigs(tmp_path, form))
    second, later = np.diag([1.0, -1, -1, 1]), np.diag([-1.0, 1, -1, 1])
    second[:3, 3], later[2, 3] = (-0.1, 0, 2), 5
    assert np.array_equal(model.T_camera_world, [np.eye(4), second, later, second @ later])
    loom.write_colmap_model(tmp_path, model, format=form)
    assert not [*tmp_path.glob("frames*"), *tmp_path.glob("rigs*")]
    assert_same(read_colmap_model(tmp_path), model, poses=1e-15)


@pytest.mark.parametrize(
    ("rigs", "frames", "message"),
    [
        (None, FRAMES, "rigs.txt: does not exist"),
        (RIGS, None, "frames.txt: does not exist"),
        (RIGS + RIGS[7:], FRAMES, r"rigs.txt \(line 3\): the rig number 7 is duplicated"),
        (RIGS, FRAMES + FRAMES, r"frames.txt \(line 3\): the frame number 1 is duplicated"),
        (RIGS, "", "image 1 .'a'. belongs to no frame"),
        (RIGS, FRAMES + "3 7 1 0 0 0 0 0 0 1 CAMERA 1 3\n", r"line 3\): image 3 belongs to the frames 2 and 3"),
        (RIGS, FRAMES.replace("1 7", "1 8"), r"frames.txt \(line 1\): frame 1 refers to rig 8"),
        (RIGS, FRAMES.replace("CAMERA 2 2", "CAMERA 3 2"), "frame 1 has data of camera 3, which rig 7"),
        (RIGS, FRAMES.replace("CAMERA 1 1 CAMERA 2 2", "CAMERA 1 2 CAMERA 2 1"), "of camera 2, and of camera 1 in"),
        (RIGS, FRAMES.replace("0 0 1", "0 0 2"), r"frames.txt \(line 2\): frame 2 has no pose"),
        (RIGS, FRAMES.replace("1 0 0 0", "nan 0 0 0", 1), r"frames.txt \(line 1\): frame 1 has no pose"),
        (RIGS.replace("1 0 1 0 0 -0.1 0 2", "0"), FRAMES, r"rigs.txt \(line 2\): camera 2 of rig 7 .* no pose"),
        (RIGS.replace("0 1 0 0", "1 1 0 0"), FRAMES, r"rigs.txt \(line 2\): camera 2 of rig 7 has no pose"),
        (RIGS.replace("CAMERA 2", "CAMERA 1"), FRAMES, "sensor camera 1 of rig 7 is duplicated"),
        (RIGS.replace("IMU", "RADAR"), FRAMES, r"rigs.txt \(line 2\): expected a sensor type"),
        (RIGS.replace("7 3", "7 4"), FRAMES, r"rigs.txt \(line 2\): expected more than"),
        (RIGS.replace("7 3", "7 2"), FRAMES, r"rigs.txt \(line 2\): expected 14 words, got 17"),
        (RIGS, FRAMES.replace("2 7", "-2 7"), r"frames.txt \(line 2\): expected a whole number"),
    ],
)
def test_contradictory_rigs_and_frames_are_rejected(tmp_path, rigs, frames, message):
    with pytest.raises(loom.FileError, match=message):
        read_colmap_model(write_rigs(tmp_path, "txt", rigs, frames))


def test_models_without_frames_have_the_poses_of_images(tmp_path):
    write_rigs(tmp_path, "txt", "# Number of rigs: 0\n", "")
    (tmp_path / "images.txt").write_text(STALE.replace("nan", "1"))
    assert read_colmap_model(tmp_path).T_camera_world[3, :3, 3].tolist() == [-3, 0, 5]


@pytest.mark.parametrize("name", ["rigs.bin", "frames.bin"])
def test_damaged_rigs_and_frames_raise_errors_of_files(tmp_path, name):
    data = (write_rigs(tmp_path, "bin") / name).read_bytes()
    for spoiled in [*(data[:end] for end in range(0, len(data), 3)), data + b"\0", data[:16] + b"\xff" * 8 + data[24:]]:
        (tmp_path / name).write_bytes(spoiled)
        with pytest.raises(loom.FileError, match=name):
            read_colmap_model(tmp_path)


KILLED = """
import os, sys
from pathlib import Path
import numpy as np
import pointloom as loom

def write(folder, name, form):
    camera = loom.CameraModel("PINHOLE", 640, 480, [500, 500, 320, 240])
    loom.write_colmap_model(folder, loom.SfmModel([name], [camera], np.eye(4)[None]), format=form)

def counted(function):
    def call(*args, **kwargs):
        left[0] -= 1
        if not left[0]:
            os._exit(9)
        return function(*args, **kwargs)
    return call

step, status = 0, 9
while status:
    step += 1
    folder = Path(sys.argv[1], str(step))
    write(folder, "old.png", sys.argv[2])
    (folder / "rigs.bin").write_bytes(bytes(8))  # no rig, of the old model
    (folder / "notes.txt").write_text("another file")
    if not (child := os.fork()):
        left = [step]
        os.rename, os.replace, os.unlink, os.rmdir = map(counted, (os.rename, os.replace, os.unlink, os.rmdir))
        write(folder, "new.png", "bin")
        os._exit(0)
    status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
"""


@pytest.mark.slow
@pytest.mark.parametrize("form", ["bin", "txt"])
def test_a_model_survives_a_kill_at_each_step_of_its_replacement(tmp_path, form):
    subprocess.run([sys.executable, "-c", KILLED, tmp_path, form], check=True)
    ends = []
    for folder in sorted(tmp_path.iterdir(), key=lambda path: int(path.name)):
        ends += [*read_colmap_model(folder).names]
        assert (folder / "rigs.bin").exists() == (ends[-1] == "old.png") and (folder / "notes.txt").exists()
    assert ends == sorted(ends, reverse=True) and {*ends} == {"old.png", "new.png"} and len(ends) > 8


def test_a_folder_that_claims_to_be_half_replaced_removes_no_other_file(tmp_path):
    folder, other = tmp_path / "sparse", tmp_path / "other.txt"
    other.write_text("kept")
    camera = loom.CameraModel("PINHOLE", 640, 480, [500, 500, 320, 240])
    loom.write_colmap_model(folder, loom.SfmModel(["a.png"], [camera], np.eye(4)[None]))
    (folder / ".files.new").mkdir()
    (folder / ".files.new" / ".list.json").write_text(json.dumps(["../other.txt", "../../other.txt", "notes.txt"]))
    (folder / "notes.txt").write_text("kept")
    assert read_colmap_model(folder).names[0] == "a.png" and other.exists() and (folder / "notes.txt").exists()
