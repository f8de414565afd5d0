"""Masks of pictures: COLMAP's names, transparency, functions; no features in black pixels."""

import sqlite3
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.photogrammetry.sfm.features import find_features

from .conftest import has_pycolmap, left_half, write_pictures

SIZE = (120, 160)


def masks_of(folder: Path) -> dict[str, np.ndarray]:
    return {path.name: np.array(Image.open(path)) for path in sorted(folder.iterdir())}


@pytest.mark.parametrize("name", ["a.jpg.png", "a.png", "a.jpg.jpg"])
def test_masks_with_common_names_are_matched(panned, tmp_path, name):
    source = write_pictures(tmp_path / "in", panned[:2], ["a.jpg", "b.jpg"])
    masks = write_pictures(tmp_path / "masks", [left_half(SIZE)], [name])
    choice = loom.sfm.choose_frames(source, tmp_path / "out", masks=masks)
    written = masks_of(tmp_path / "out_masks")
    assert list(written) == ["a.jpg.png"] and np.array_equal(written["a.jpg.png"], left_half(SIZE))
    assert choice.notes == ("1 image without a mask, used completely: b.jpg",)


def test_masks_are_rotated_and_scaled_with_their_pictures(panned, tmp_path):
    (tmp_path / "in").mkdir()
    exif = Image.Exif()
    exif[0x0112] = 6
    Image.fromarray(panned[0]).save(tmp_path / "in" / "a.jpg", exif=exif)
    top = np.ascontiguousarray(np.rot90(left_half(SIZE), 3))
    for drawn in (left_half(SIZE), top):  # on the picture as it is stored, or upright
        masks = write_pictures(tmp_path / f"masks {len(drawn)}", [drawn], ["a.png"])
        out = tmp_path / f"out {len(drawn)}"
        loom.sfm.choose_frames(tmp_path / "in", out, masks=masks, max_size=80)
        (mask,) = masks_of(out.with_name(out.name + "_masks")).values()
        assert mask.shape == (80, 60) and mask[:40].min() == 255 and mask[40:].max() == 0


def test_transparent_pixels_are_masked(panned, tmp_path):
    rgba = np.dstack([*[panned[0]] * 3, left_half(SIZE)])
    source = tmp_path / "in"
    source.mkdir()
    Image.fromarray(rgba).save(source / "a.png")
    Image.fromarray(rgba).save(source / "b.webp", lossless=True)
    loom.sfm.choose_frames(source, tmp_path / "out", masks="alpha")
    written = masks_of(tmp_path / "out_masks")
    assert len(written) == 2 and all(np.array_equal(mask, left_half(SIZE)) for mask in written.values())
    write_pictures(tmp_path / "plain", panned[:2])
    with pytest.raises(loom.FileError, match="/plain:"):
        loom.sfm.choose_frames(tmp_path / "plain", tmp_path / "new", masks="alpha")
    assert not (tmp_path / "new").exists() and not (tmp_path / "new_masks").exists()


def test_a_function_masks_pixels_or_complete_pictures(panned, tmp_path):
    source, calls = write_pictures(tmp_path / "in", panned[:3], ["a.jpg", "b.jpg", "c.jpg"]), []

    def mask_of(pixels, name):
        calls.append((name, pixels.shape))
        return {"a.jpg": left_half(SIZE), "b.jpg": np.zeros(SIZE, bool), "c.jpg": None}[name]

    choice = loom.sfm.choose_frames(source, tmp_path / "out", masks=mask_of)
    assert calls == [(name, (*SIZE, 3)) for name in ("a.jpg", "b.jpg", "c.jpg")]
    assert choice.names == ("a.jpg", "c.jpg") and choice.left_out == {"b.jpg": "its mask excludes all pixels"}
    assert not (tmp_path / "out" / "b.jpg").exists() and list(masks_of(tmp_path / "out_masks")) == ["a.jpg.png"]


def test_masks_that_do_not_fit_are_named(panned, tmp_path):
    source = write_pictures(tmp_path / "in", panned[:2], ["a.jpg", "b.jpg"])
    wide = write_pictures(tmp_path / "wide", [left_half((120, 180))], ["a.png"])
    with pytest.raises(loom.FileError, match=r"a\.png:"):
        loom.sfm.choose_frames(source, tmp_path / "out", masks=wide)
    (tmp_path / "none").mkdir()
    with pytest.raises(loom.FileError, match=r"/in:.*a\.jpg\.png"):
        loom.sfm.choose_frames(source, tmp_path / "out", masks=tmp_path / "none")
    black = write_pictures(tmp_path / "black", [np.zeros(SIZE, np.uint8)] * 2, ["a.png", "b.png"])
    with pytest.raises(loom.FileError, match=r"/in:.*2"):
        loom.sfm.choose_frames(source, tmp_path / "out", masks=black)
    with pytest.raises(TypeError, match=r"masks\(a\.jpg\):.*uint8"):
        loom.sfm.choose_frames(source, tmp_path / "out", masks=lambda pixels, name: np.ones(SIZE))
    with pytest.raises(ValueError, match=r"masks\(a\.jpg\):.*120.*160"):
        loom.sfm.choose_frames(source, tmp_path / "out", masks=lambda pixels, name: np.ones((5, 5), bool))
    with pytest.raises(loom.FileError, match=r"^nowhere:"):
        loom.sfm.choose_frames(source, tmp_path / "out", masks="nowhere")
    assert not (tmp_path / "out").exists() and not (tmp_path / "out_masks").exists()


@pytest.mark.skipif(not has_pycolmap(), reason="pycolmap is not installed")
def test_no_feature_is_detected_in_black_mask_pixels(scene_pictures, tmp_path):
    pictures = write_pictures(tmp_path / "in", scene_pictures[:2], ["a.png", "b.png"])
    masks = write_pictures(tmp_path / "masks", [left_half(scene_pictures[0].shape)], ["a.png.png"])
    features = find_features(pictures, tmp_path / "f.db", masks=masks, max_features=500)
    with sqlite3.connect(tmp_path / "f.db") as database:
        rows = dict(database.execute("SELECT image_id, data FROM keypoints"))
    columns = [np.frombuffer(rows[k + 1], np.float32).reshape(n, -1)[:, 0] for k, n in enumerate(features.counts)]
    middle = scene_pictures[0].shape[1] / 2
    assert columns[0].max() <= middle + 1 and len(columns[0]) > 30 and columns[1].max() > 1.5 * middle
    (masks / "b.png.png").write_bytes((masks / "a.png.png").read_bytes()[:-9])
    with pytest.raises(loom.FileError, match=r"b\.png\.png"):
        find_features(pictures, tmp_path / "f.db", masks=masks)
