"""Masks with known poses: they follow their pictures as those are stored, and nothing that they hide is matched."""

from __future__ import annotations

import sqlite3
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.photogrammetry.video import known_motion, motion

from ..sfm.conftest import has_pycolmap, left_half, write_pictures
from ..sfm.scene import picture, walk
from .test_known_motion import noise, silent, steps, write_metashape

SIZE = (48, 64)


def take(tmp_path, masks, *, names=("a.png", "b.png"), orientation=None, more=""):
    """What the stage `frames` tells, and the folder of its files."""
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
def test_masks_stay_as_their_pictures_are_stored(tmp_path, orientation):
    turned = {1: 0, 6: 3, 8: 1, 3: 0}[orientation]  # of half a turn nobody knows: it counts as drawn on what is stored
    upright = np.ascontiguousarray(np.rot90(left_half(SIZE), turned))
    masks = write_pictures(tmp_path / "masks", [left_half(SIZE), upright], ["a.jpg.png", "b.png"])
    told, folder = take(tmp_path, masks, names=("a.jpg", "b.jpg", "c.jpg"), orientation=orientation)
    ending = "jpg" if orientation == 1 else "png"
    for name in ("a", "b"):
        np.testing.assert_array_equal(mask_in(folder, f"{name}.{ending}"), left_half(SIZE))
    assert told["notes"] == ["1 image without a mask, used completely: c.jpg"]


def test_a_function_sees_pictures_as_they_are_stored_and_may_hide_them(tmp_path):
    def mask_of(pixels, name):
        assert pixels.shape == (*SIZE, 3)
        return None if name == "a.jpg" else left_half(SIZE) if name == "b.jpg" else np.zeros(SIZE, bool)

    told, folder = take(tmp_path, mask_of, names=("a.jpg", "b.jpg", "c.jpg"), orientation=6)
    assert sorted(path.name for path in (folder / "pictures").iterdir()) == ["a.png", "b.png"]
    assert loom.read_colmap_model(folder / "cameras").names == ("a.png", "b.png")
    assert told["kept"] == 2 and any("since the mask excludes all pixels: c.jpg" in remark for remark in told["notes"])


def test_masks_are_straightened_with_pictures_whose_lens_colmap_does_not_have(tmp_path):
    masks = write_pictures(tmp_path / "masks", [left_half(SIZE)] * 2, ["a.png", "b.png"])
    _, folder = take(tmp_path, masks, more="<k4>2.0</k4>")
    camera = loom.read_colmap_model(folder / "cameras").cameras[0]
    mask = mask_in(folder, "a.png")
    assert mask.shape == (camera.height, camera.width) != SIZE
    border = int(np.floor(camera.intrinsic.cx))
    assert mask[5:-5, 2 : border - 1].min() == 255 and mask[:, border + 2 :].max() == 0


@pytest.mark.skipif(not has_pycolmap(), reason="pycolmap is not installed")
def test_no_feature_of_a_posed_picture_lies_where_its_mask_is_black(tmp_path):
    walked = [picture(T) for T in walk(2)]
    write_pictures(tmp_path / "frames" / motion.PICTURES, walked, ["a.png", "b.png"])
    (tmp_path / "frames" / motion.MASKS).mkdir()
    for name in ("a.png.png", "b.png.png"):
        Image.fromarray(left_half(walked[0].shape)).save(tmp_path / "frames" / motion.MASKS / name)
    frames = SimpleNamespace(folder=tmp_path / "frames")
    (tmp_path / "out").mkdir()
    known_motion.find_features(tmp_path / "out", silent, frames=frames, max_features=300, seed=0)
    with sqlite3.connect(tmp_path / "out" / motion.DATABASE) as database:
        rows = database.execute("SELECT data, rows, cols FROM keypoints").fetchall()
    for data, count, width in rows:
        columns = np.frombuffer(data, np.float32).reshape(count, width)[:, 0]
        assert 30 < len(columns) <= 700 and columns.max() <= walked[0].shape[1] / 2 + 1
