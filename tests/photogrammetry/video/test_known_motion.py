"""`pointloom video --cameras`: images are matched to cameras by name, and wrong poses give no cloud."""

import inspect
import sqlite3
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.core.errors import DatasetError, FileError
from pointloom.io.models.colmap import read_colmap_model
from pointloom.photogrammetry.sfm.pose_check import PoseCheck
from pointloom.photogrammetry.video import chain, known_motion, motion
from pointloom.photogrammetry.video.units import OF_POSES, fit_as_given, fit_units

from ...cli.commands import answer, refusal, unreliable
from ..sfm.conftest import has_pycolmap, left_half, silent, write_images
from ..sfm.scene import FOCAL, HEIGHT, WIDTH, camera_path, image
from .conftest import set_stage

COUNT = 6
METASHAPE = (
    "<document version='1.5.0'><chunk><sensors><sensor id='0' type='frame'><calibration type='frame' class='adjusted'>"
    "<resolution width='{width}' height='{height}'/><f>{focal}</f>{more}</calibration></sensor></sensors>"
    "<cameras>{cameras}</cameras></chunk></document>"
)


def write_metashape(path, names, poses, *, more="", size=(WIDTH, HEIGHT), focal=FOCAL):
    cameras = "".join(
        f"<camera id='{k}' sensor_id='0' label='{name}'><transform>{' '.join(map(repr, T.ravel().tolist()))}"
        "</transform></camera>"
        for k, (name, T) in enumerate(zip(names, poses, strict=True))
    )
    path.write_text(METASHAPE.format(cameras=cameras, width=size[0], height=size[1], focal=focal, more=more))
    return path


def noise(count, size=(48, 64)):
    return list(np.random.default_rng(0).integers(0, 256, (count, *size), dtype=np.uint8))


def take(tmp_path, source, cameras, masks=None, **options):
    folder = tmp_path / "frames"
    folder.mkdir()
    given = {"max_frames": 150, "posed": loom.photogrammetry.VideoSettings(cameras=cameras, **options), "masks": masks}
    report = known_motion.take_images(folder, silent, source=source, **given)
    return report, read_colmap_model(folder / "cameras"), folder / "images"


def steps(count):
    poses = np.tile(np.eye(4), (count, 1, 1))
    poses[:, 0, 3] = np.arange(count)
    return poses


def test_images_are_matched_to_cameras_by_name_and_the_rest_is_reported(tmp_path):
    source = write_images(tmp_path / "in", noise(4), ["b.png", "a.png", "c.png", "extra.png"])
    xml = write_metashape(tmp_path / "c.xml", ["c", "a", "b", "gone"], steps(4), size=(64, 48), focal=60)
    report, model, images = take(tmp_path, source, xml)
    assert dict(zip(model.names, model.centers[:, 0], strict=True)) == {"a.png": 1.0, "b.png": 2.0, "c.png": 0.0}
    assert (report["kept"], report["missing"]) == (3, 1)
    assert report["notes"] == ["1 images have no pose: extra.png", "1 poses have no image: gone"]
    assert (images / "a.png").read_bytes() == (source / "a.png").read_bytes()


def test_images_keep_their_stored_orientation(tmp_path):
    source = tmp_path / "in"
    source.mkdir()
    exif = Image.Exif()
    exif[0x0112] = 6
    for name, pixels in zip(("a.jpg", "b.jpg"), noise(2), strict=True):
        Image.fromarray(pixels).save(source / name, exif=exif)
    xml = write_metashape(tmp_path / "c.xml", ["a", "b"], steps(2), size=(64, 48), focal=60)
    _, model, images = take(tmp_path, source, xml)
    assert model.names == ("a.png", "b.png")
    stored = np.asarray(Image.open(source / "a.jpg").convert("RGB"))
    with Image.open(images / "a.png") as written:
        assert written.getexif().get(0x0112, 1) == 1
        np.testing.assert_array_equal(np.asarray(written.convert("RGB")), stored)


def test_a_lens_that_colmap_does_not_have_is_straightened_first(tmp_path):
    source = write_images(tmp_path / "in", noise(2), ["a.png", "b.png"])
    xml = write_metashape(tmp_path / "c.xml", ["a", "b"], steps(2), size=(64, 48), focal=60, more="<k4>0.1</k4>")
    assert loom.read_cameras(xml).cameras[0].model == "METASHAPE"
    _, model, images = take(tmp_path, source, xml)
    assert model.cameras[0].is_pinhole
    assert loom.read_color(images / "a.png").shape[:2] == (model.cameras[0].height, model.cameras[0].width)


def test_a_trajectory_takes_the_lens_that_is_given(tmp_path):
    source = write_images(tmp_path / "in", noise(3), ["1.0.png", "2.0.png", "3.0.png"])
    loom.write_trajectory(tmp_path / "p.tum", loom.Trajectory(steps(3), timestamps=[1.0, 2.0, 3.0]))
    lens = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
    _, model, _ = take(tmp_path, source, tmp_path / "p.tum", intrinsic=lens)
    assert model.centers[:, 0].tolist() == [0, 1, 2] and model.cameras[0].intrinsic == lens


def test_cameras_that_do_not_match_the_source_are_rejected(tmp_path):
    (tmp_path / "walk.mp4").write_bytes(b"a film")
    xml = write_metashape(tmp_path / "c.xml", ["a", "b"], steps(2), size=(64, 48))
    with pytest.raises(DatasetError, match=r"/walk\.mp4:"):
        take(tmp_path, tmp_path / "walk.mp4", xml)
    source = write_images(tmp_path / "in", noise(2), ["a.png", "b.png"])
    (tmp_path / "frames").rmdir()
    lens = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
    with pytest.raises(FileError, match=r"c\.xml"):
        take(tmp_path, source, xml, intrinsic=lens)


def test_the_unit_is_that_of_the_poses_unless_more_is_known():
    camera = loom.CameraModel("PINHOLE", 64, 48, [60, 60, 32, 24])
    model = loom.SfmModel(["1.png", "2.png"], [camera] * 2, steps(2))
    assert fit_as_given(fit_units(loom.photogrammetry.VideoUnits(), model)).units == OF_POSES
    assert fit_as_given(fit_units(loom.photogrammetry.VideoUnits(scale=2.0), model)).units == "meters"


def test_poses_that_do_not_fit_end_with_exit_code_3_and_no_file(tmp_path, monkeypatch):
    source = write_images(tmp_path / "in", noise(3), ["a.png", "b.png", "c.png"])
    xml = write_metashape(tmp_path / "c.xml", ["a", "b", "c"], steps(3), size=(64, 48), focal=60)
    check = PoseCheck(500, 0.03, 1.0, "each pose is inverted", 0.9)
    nothing = SimpleNamespace(pairs=np.zeros((0, 2), int), firsts=np.zeros(1, int), matches=np.zeros((0, 2), int))
    monkeypatch.setattr(known_motion, "match_posed", lambda *_, **__: (nothing, check))
    set_stage(monkeypatch, "features", lambda folder, report_progress, *, frames, seed: {}, chain.KNOWN_STAGES)
    report = unreliable("video", source, "-o", tmp_path / "mesh.ply", "--cloud", tmp_path / "c.ply", "--cameras", xml)
    assert "only 3% of the matches" in str(report["warnings"]) and "each pose is inverted" in str(report["warnings"])
    assert "move instead of only rotating" not in str(report["warnings"])
    assert report["files"] == [] and not (tmp_path / "mesh.ply").exists() and not (tmp_path / "c.ply").exists()


def test_a_trajectory_without_a_lens_is_refused(tmp_path):
    source = write_images(tmp_path / "in", noise(2), ["1.0.png", "2.0.png"])
    loom.write_trajectory(tmp_path / "p.tum", loom.Trajectory(steps(2), timestamps=[1.0, 2.0]))
    assert "--intrinsic" in refusal("video", source, "-o", tmp_path / "m.ply", "--cameras", tmp_path / "p.tum")


@pytest.mark.slow
@pytest.mark.skipif(not has_pycolmap(), reason="pycolmap is not installed")
def test_images_and_metashapes_cameras_become_points_on_the_true_surface(tmp_path):
    poses = camera_path(COUNT)
    names = [f"view {k}" for k in range(COUNT)]
    source = write_images(tmp_path / "in", [image(T) for T in poses], [f"{name}.png" for name in names])
    xml = write_metashape(tmp_path / "c.xml", names, np.linalg.inv(np.array(poses)))
    cloud = tmp_path / "points.pcd"
    report = answer("video", source, "-o", cloud, "--cameras", xml, "--max-size", 160)
    assert report["units"] == OF_POSES and report["files"] == [str(cloud)]
    points = loom.read_point_cloud(cloud).points
    assert len(points) > 3000
    normal = np.cross((3, 0, 0.8), (0, 2.2, 0.3))  # of the wall, which fills most of the images
    off = np.abs((points - (0, 0, 4)) @ normal) / np.linalg.norm(normal)
    assert np.median(off) < 0.01 and 2.0 < points[:, 2].min() < points[:, 2].max() < 5.5


SIZE = (48, 64)


def take_masked(tmp_path, masks, *, names=("a.png", "b.png"), orientation=None, more=""):
    """The report of the stage `frames`, and the folder of its files."""
    source, exif = tmp_path / "in", Image.Exif()
    source.mkdir()
    if orientation:
        exif[0x0112] = orientation
    for name, pixels in zip(names, noise(len(names)), strict=True):
        Image.fromarray(pixels).save(source / name, exif=exif)
    stems = [name.split(".")[0] for name in names]
    xml = write_metashape(tmp_path / "c.xml", stems, steps(len(names)), size=SIZE[::-1], focal=60, more=more)
    return take(tmp_path, source, xml, masks)[0], tmp_path / "frames"


def mask_in(folder, name) -> np.ndarray:
    return np.array(Image.open(folder / motion.MASKS / f"{name}.png"))


@pytest.mark.parametrize("orientation", [1, 6, 8, 3])
def test_masks_keep_the_stored_orientation_of_their_images(tmp_path, orientation):
    # A rotation by 180 degrees is ambiguous: the mask is assumed to match the stored image.
    rotation_count = {1: 0, 6: 3, 8: 1, 3: 0}[orientation]
    upright = np.ascontiguousarray(np.rot90(left_half(SIZE), rotation_count))
    masks = write_images(tmp_path / "masks", [left_half(SIZE), upright], ["a.jpg.png", "b.png"])
    report, folder = take_masked(tmp_path, masks, names=("a.jpg", "b.jpg", "c.jpg"), orientation=orientation)
    ending = "jpg" if orientation == 1 else "png"
    for name in ("a", "b"):
        np.testing.assert_array_equal(mask_in(folder, f"{name}.{ending}"), left_half(SIZE))
    assert report["notes"] == ["1 image without a mask, used completely: c.jpg"]


def test_a_mask_function_gets_stored_images_and_may_exclude_them(tmp_path):
    def mask_of(pixels, name):
        assert pixels.shape == (*SIZE, 3)
        return None if name == "a.jpg" else left_half(SIZE) if name == "b.jpg" else np.zeros(SIZE, bool)

    report, folder = take_masked(tmp_path, mask_of, names=("a.jpg", "b.jpg", "c.jpg"), orientation=6)
    assert sorted(path.name for path in (folder / "images").iterdir()) == ["a.png", "b.png"]
    assert loom.read_cameras(folder / "cameras").names == ("a.png", "b.png")
    assert report["kept"] == 2 and "since the mask excludes all pixels: c.jpg" in " ".join(report["notes"])


def test_masks_are_straightened_with_images_whose_lens_colmap_does_not_have(tmp_path):
    masks = write_images(tmp_path / "masks", [left_half(SIZE)] * 2, ["a.png", "b.png"])
    _, folder = take_masked(tmp_path, masks, more="<k4>2.0</k4>")
    camera = loom.read_cameras(folder / "cameras").cameras[0]
    mask = mask_in(folder, "a.png")
    assert mask.shape == (camera.height, camera.width) != SIZE
    border = int(np.floor(camera.intrinsic.cx))
    assert mask[5:-5, 2 : border - 1].min() == 255 and mask[:, border + 2 :].max() == 0


@pytest.mark.slow
@pytest.mark.skipif(not has_pycolmap(), reason="pycolmap is not installed")
def test_posed_images_have_no_feature_in_black_mask_pixels(tmp_path):
    images = [image(T) for T in camera_path(2)]
    write_images(tmp_path / "frames" / motion.IMAGES, images, ["a.png", "b.png"])
    (tmp_path / "frames" / motion.MASKS).mkdir()
    for name in ("a.png.png", "b.png.png"):
        Image.fromarray(left_half(images[0].shape)).save(tmp_path / "frames" / motion.MASKS / name)
    frames = SimpleNamespace(folder=tmp_path / "frames")
    (tmp_path / "out").mkdir()
    known_motion.find_features(tmp_path / "out", silent, frames=frames, max_features=300, seed=0)
    with sqlite3.connect(tmp_path / "out" / motion.DATABASE) as database:
        rows = database.execute("SELECT data, rows, cols FROM keypoints").fetchall()
    for data, count, width in rows:
        columns = np.frombuffer(data, np.float32).reshape(count, width)[:, 0]
        assert 30 < len(columns) <= 700 and columns.max() <= images[0].shape[1] / 2 + 1


@pytest.mark.parametrize("stages", [chain.STAGES, chain.KNOWN_STAGES])
def test_declared_inputs_are_the_parameters_of_a_stage(stages):
    for stage in stages.values():
        _folder, _report, *inputs = inspect.signature(stage.make).parameters
        assert inputs == ["checkpoints"] * stage.resumes + [*stage.inputs]


def test_inputs_are_settings_or_earlier_stages():
    stage = chain.DeclaredStage("frames", motion.take_frames, ("source", "matches"))
    with pytest.raises(ValueError, match="frames: expected settings or earlier stages as inputs, got matches"):
        chain.in_order(stage)
