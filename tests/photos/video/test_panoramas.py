"""A folder of pictures of all directions becomes one of a cube's faces, with masks, and a lens that is known."""

from __future__ import annotations

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.photos.video import motion


def quiet(*_):
    pass


def test_pictures_of_all_directions_become_faces_with_their_masks(tmp_path):
    source = tmp_path / "in"
    source.mkdir()
    (tmp_path / "out").mkdir()
    rng = np.random.default_rng(0)
    for k in range(2):
        Image.fromarray(rng.integers(0, 256, (64, 128, 3), dtype=np.uint8)).save(source / f"{k}.png")

    def not_below(pixels, name):
        return np.arange(len(pixels))[:, None].repeat(pixels.shape[1], 1) < 32

    given = {"max_frames": 9, "masks": not_below, "panorama": True}
    told = motion.take_frames(tmp_path / "out", quiet, source=source, **given)
    names = [f"{k}_{face}.jpg" for k in range(2) for face in ("front", "right", "back", "left", "up")]
    assert told["names"] == names and told["kept"] == 10 and told["frames"] == 2
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == [motion.PICTURES, motion.MASKS]
    assert sorted(path.name for path in (tmp_path / "out" / motion.PICTURES).iterdir()) == sorted(names)
    up, front = (np.array(Image.open(tmp_path / "out" / motion.MASKS / f"0_{k}.jpg.png")) for k in ("up", "front"))
    assert up.min() == 255 and front[:18].min() == 255 and front[-18:].max() == 0


def test_a_picture_of_a_lens_is_none_of_all_directions(tmp_path):
    source = tmp_path / "in"
    source.mkdir()
    (tmp_path / "out").mkdir()
    pixels = np.random.default_rng(0).integers(0, 256, (60, 80, 3), dtype=np.uint8)
    Image.fromarray(pixels).save(source / "a.png")
    with pytest.raises(loom.FileError, match=r"a.png: width: expected twice the height of 60.*Leave out --panorama"):
        motion.take_frames(tmp_path / "out", quiet, source=source, max_frames=9, masks=None, panorama=True)
    with pytest.raises(ValueError, match="panorama: faces of a cube have a lens that is known"):
        loom.video.Settings(panorama=True, camera_model="OPENCV_FISHEYE")
