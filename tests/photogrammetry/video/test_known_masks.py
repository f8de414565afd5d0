"""Masks with known poses: they match the stored pictures, and hidden pixels are not matched."""

import sqlite3
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.photogrammetry.video import known_motion, motion

from ..sfm.conftest import has_pycolmap, left_half, write_pictures
from ..sfm.scene import camera_path, picture
from .test_known_motion import noise, silent, steps, write_metashape

SIZE = (48, 64)


def take(tmp_path, masks, *, names=("a.png", "b.png"), orientation=None, more=""):
    """The report of the stage `frames`, and the folder of its files."""
    source, folder = tmp_path / "in", tmp_path / "frames"
    source.mkdir()
    folder.mkdir()
    exif = Image.Exif()
    if orientation:
        exif[0x0112] = orientation
    for name, pixels in zip(names, noise(len(names)), strict=True):
        Image.fromarray(pixels).save(source / name, exif=exif)
    stems = [name.split(".")[0] for name in names]
    xml = write_metashape(tmp_path / "c.xml", stems, steps(len(names)), size=SIZE[::-1], focal=60, more=more)
    posed = loom.video.Settings(cameras=xml)
    given = {"source": source, "max_frames": 150, "posed": posed, "masks": masks}
    return known_motion.take_pictures(folder, silent, **given), folder


def mask_in(folder, name) -> np.ndarray:
    return np.array(Image.open(folder / motion.MASKS / f"{name}.png"))


@pytest.mark.parametrize("orientation", [1, 6, 8, 3])
def test_masks_keep_the_stored_orientation_of_their_pictures(tmp_path, orientation):
    # A rotation by 180 degrees is ambiguous: the mask is assumed to match the stored picture.
    rotation_count = {1: 0, 6: 3, 8: 1, 3: 0}[orientation]
    upright = np.ascontiguousarray(np.rot90(left_half(SIZE), rotation_count))
    masks = write_pictures(tmp_path / "masks", [left_half(SIZE), upright], ["a.jpg.png", "b.png"])
    report, folder = take(tmp_path, masks, names=("a.jpg", "b.jpg", "c.jpg"), orientation=orientation)
    ending = "jpg" if orientation == 1 else "png"
    for name in ("a", "b"):
        np.testing.assert_array_equal(mask_in(folder, f"{name}.{ending}"), left_half(SIZE))
    assert report["notes"] == ["1 image without a mask, used completely: c.jpg"]


def test_a_mask_function_gets_stored_pictures_and_may_exclude_them(tmp_path):
    def mask_of(pixels, name):
        assert pixels.shape == (*SIZE, 3)
        return None if name == "a.jpg" else left_half(SIZE) if name == "b.jpg" else np.zeros(SIZE, bool)

    report, folder = take(tmp_path, mask_of, names=("a.jpg", "b.jpg", "c.jpg"), orientation=6)
    assert sorted(path.name for path in (folder / "pictures").iterdir()) == ["a.png", "b.png"]
    assert loom.read_colmap_model(folder / "cameras").names == ("a.png", "b.png")
    assert report["kept"] == 2 and "since the mask excludes all pixels: c.jpg" in " ".join(report["notes"])


def test_masks_are_straightened_with_pictures_whose_lens_colmap_does_not_have(tmp_path):
    masks = write_pictures(tmp_path / "masks", [left_half(SIZE)] * 2, ["a.png", "b.png"])
    _, folder = take(tmp_path, masks, more="<k4>2.0</k4>")
    camera = loom.read_colmap_model(folder / "cameras").cameras[0]
    mask = mask_in(folder, "a.png")
    assert mask.shape == (camera.height, camera.width) != SIZE
    border = int(np.floor(camera.intrinsic.cx))
    assert mask[5:-5, 2 : border - 1].min() == 255 and mask[:, border + 2 :].max() == 0


@pytest.mark.skipif(not has_pycolmap(), reason="pycolmap is not installed")
def test_posed_pictures_have_no_feature_in_black_mask_pixels(tmp_path):
    pictures = [picture(T) for T in camera_path(2)]
    write_pictures(tmp_path / "frames" / motion.PICTURES, pictures, ["a.png", "b.png"])
    (tmp_path / "frames" / motion.MASKS).mkdir()
    for name in ("a.png.png", "b.png.png"):
        Image.fromarray(left_half(pictures[0].shape)).save(tmp_path / "frames" / motion.MASKS / name)
    frames = SimpleNamespace(folder=tmp_path / "frames")
    (tmp_path / "out").mkdir()
    known_motion.find_features(tmp_path / "out", silent, frames=frames, max_features=300, seed=0)
    with sqlite3.connect(tmp_path / "out" / motion.DATABASE) as database:
        rows = database.execute("SELECT data, rows, cols FROM keypoints").fetchall()
    for data, count, width in rows:
        columns = np.frombuffer(data, np.float32).reshape(count, width)[:, 0]
        assert 30 < len(columns) <= 700 and columns.max() <= pictures[0].shape[1] / 2 + 1
