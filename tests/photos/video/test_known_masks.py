"""Masks with known poses: they follow their pictures as those are stored, and nothing that they hide is matched."""

from __future__ import annotations

import sqlite3
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.core.errors import DatasetError, FileError
from pointloom.photos.video import known_motion, motion

from ...app.commands import answer
from ..sfm.conftest import has_pycolmap, write_pictures
from ..sfm.scene import HEIGHT, WIDTH, picture, walk
from .test_known_motion import noise, silent, steps, write_metashape

SIZE = (48, 64)


def left_half(shape=SIZE) -> np.ndarray:
    mask = np.zeros(shape, np.uint8)
    mask[:, : shape[1] // 2] = 255
    return mask


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
    upright = np.ascontiguousarray(np.rot90(left_half(), turned))
    masks = write_pictures(tmp_path / "masks", [left_half(), upright], ["a.jpg.png", "b.png"])
    told, folder = take(tmp_path, masks, names=("a.jpg", "b.jpg", "c.jpg"), orientation=orientation)
    ending = "jpg" if orientation == 1 else "png"
    for name in ("a", "b"):
        np.testing.assert_array_equal(mask_in(folder, f"{name}.{ending}"), left_half())
    assert told["remarks"] == ["1 picture without a mask, taken whole: c.jpg"]


def test_a_function_sees_pictures_as_they_are_stored_and_may_hide_them(tmp_path):
    def mask_of(pixels, name):
        assert pixels.shape == (*SIZE, 3)
        return None if name == "a.jpg" else left_half() if name == "b.jpg" else np.zeros(SIZE, bool)

    told, folder = take(tmp_path, mask_of, names=("a.jpg", "b.jpg", "c.jpg"), orientation=6)
    assert sorted(path.name for path in (folder / "pictures").iterdir()) == ["a.png", "b.png"]
    assert loom.read_colmap_model(folder / "cameras").names == ("a.png", "b.png")
    assert told["kept"] == 2 and any("whose masks hide all: c.jpg" in remark for remark in told["remarks"])


def test_masks_are_straightened_with_pictures_whose_lens_colmap_does_not_have(tmp_path):
    masks = write_pictures(tmp_path / "masks", [left_half()] * 2, ["a.png", "b.png"])
    _, folder = take(tmp_path, masks, more="<k4>2.0</k4>")
    camera = loom.read_colmap_model(folder / "cameras").cameras[0]
    mask = mask_in(folder, "a.png")
    assert mask.shape == (camera.height, camera.width) != SIZE
    border = int(np.floor(camera.intrinsic.cx))
    assert mask[5:-5, 2 : border - 1].min() == 255 and mask[:, border + 2 :].max() == 0


def test_masks_that_hide_all_or_are_missing_are_named(tmp_path):
    (tmp_path / "none").mkdir()
    with pytest.raises(DatasetError, match=r"there is no mask in .*none, as a.png.png"):
        take(tmp_path, tmp_path / "none")
    black = write_pictures(tmp_path / "black", [np.zeros(SIZE, np.uint8)] * 2, ["a.png", "b.png"])
    (tmp_path / "second").mkdir()
    with pytest.raises(FileError, match="none of 2 pictures is left"):
        take(tmp_path / "second", black)
    wide = write_pictures(tmp_path / "wide", [left_half((48, 80))], ["a.png"])
    (tmp_path / "third").mkdir()
    with pytest.raises(FileError, match=r"a.png: is a mask of 80 x 48, its picture 64 x 48 pixels"):
        take(tmp_path / "third", wide)


@pytest.mark.skipif(not has_pycolmap(), reason="pycolmap is not installed")
@pytest.mark.parametrize("finder", ["colmap", "pointloom"])
def test_no_feature_of_a_posed_picture_lies_where_its_mask_is_black(tmp_path, finder):
    walked = [picture(T) for T in walk(2)]
    write_pictures(tmp_path / "frames" / motion.PICTURES, walked, ["a.png", "b.png"])
    (tmp_path / "frames" / motion.MASKS).mkdir()
    for name in ("a.png.png", "b.png.png"):
        Image.fromarray(left_half(walked[0].shape)).save(tmp_path / "frames" / motion.MASKS / name)
    frames = SimpleNamespace(folder=tmp_path / "frames")
    (tmp_path / "out").mkdir()
    own = {"finder": finder, "seed": 0, "device": "cpu"}
    known_motion.find_features(tmp_path / "out", silent, frames=frames, max_features=300, **own)
    with sqlite3.connect(tmp_path / "out" / motion.DATABASE) as database:
        rows = database.execute("SELECT data, rows, cols FROM keypoints").fetchall()
    for data, count, width in rows:
        columns = np.frombuffer(data, np.float32).reshape(count, width)[:, 0]
        assert 30 < len(columns) <= 700 and columns.max() <= walked[0].shape[1] / 2 + 1


@pytest.mark.slow
@pytest.mark.skipif(not has_pycolmap(), reason="pycolmap is not installed")
def test_nothing_of_what_masks_hide_is_in_the_mesh(tmp_path):
    poses, names = walk(6), [f"view {k}" for k in range(6)]
    source = write_pictures(tmp_path / "in", [picture(T) for T in poses], [f"{name}.png" for name in names])
    xml = write_metashape(tmp_path / "c.xml", names, np.linalg.inv(np.array(poses)))
    camera = loom.CameraModel("PINHOLE", WIDTH, HEIGHT, [300, 300, WIDTH / 2, HEIGHT / 2])
    v, u = np.mgrid[:HEIGHT, :WIDTH].reshape(2, -1)
    rays = camera.unproject(np.column_stack([u, v]).astype(float))
    normal = np.cross((3, 0, 0.8), (0, 2.2, 0.3))
    masks = []
    for T in poses:  # what of the wall lies to the right of a plane in the world
        back = np.linalg.inv(T)
        ways = rays @ back[:3, :3].T
        reach = ((np.array([0, 0, 4]) - back[:3, 3]) @ normal) / (ways @ normal)
        x = (back[:3, 3] + ways * reach[:, None])[:, 0]
        masks.append(np.where(x < 0.2, 255, 0).astype(np.uint8).reshape(HEIGHT, WIDTH))
    folder = write_pictures(tmp_path / "masks", masks, [f"{name}.png.png" for name in names])
    for given, most in (([], 1.0), (["--masks", folder], 0.25)):
        mesh = tmp_path / f"{len(given)}.ply"
        report = answer("video", source, "-o", mesh, "--cameras", xml, "--max-size", 160, *given)
        assert report["files"] == [str(mesh)]
        vertices = loom.read_triangle_mesh(mesh).vertices
        wall = np.abs((vertices - (0, 0, 4)) @ normal) / np.linalg.norm(normal) < 0.05
        assert len(vertices) > 1500
        right = vertices[wall][:, 0].max()
        assert right < most if given else right > 0.6, right
