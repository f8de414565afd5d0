"""The pictures that go wrong are wrong in the way that they say, and in no other."""

import numpy as np
import pytest
from PIL import Image, ImageOps

import pointloom as loom
from pointloom.data.scenes.room import room_views

from .video_makers import (
    arc_poses,
    blacken_pictures,
    blur_pictures,
    camera_of,
    distorted_pictures,
    pictures_from,
    strong_lens,
    turning_poses,
    two_places_poses,
    write_grey_pngs,
    write_jpegs,
    write_mixed_sizes,
)

TINY = (64, 48)


@pytest.fixture(scope="module")
def pictures():
    return pictures_from(arc_poses(8), TINY)


def test_pictures_turned_by_exif_are_shown_upright(pictures, tmp_path):
    folder = write_jpegs(tmp_path / "turned", pictures, orientations=range(1, 9))
    for k, picture in enumerate(pictures):
        with Image.open(folder / f"{k:03d}.jpg") as stored:
            assert stored.getexif()[0x0112] == k + 1
            assert stored.size == (TINY if k < 4 else TINY[::-1])
            shown = np.asarray(ImageOps.exif_transpose(stored), float)
        assert np.abs(shown - picture).mean() < 6


@pytest.mark.parametrize("model", ["SIMPLE_RADIAL", "RADIAL", "OPENCV", "OPENCV_FISHEYE"])
def test_a_lens_shows_along_each_ray_what_a_pinhole_does(model):
    pose, lens = arc_poses(3)[1], strong_lens((96, 72), model)
    bent = distorted_pictures([pose], lens)[0].astype(float)
    v, u = np.mgrid[4:68:7, 4:92:7].reshape(2, -1)
    rays = lens.unproject(np.column_stack([u, v]).astype(float))
    camera = camera_of((512, 384), 200.0)
    wide = room_views([pose], camera, color_noise=0).read(0).color.astype(float)
    at = np.rint(rays[:, :2] / rays[:, 2:] * 200.0 + (camera.cx, camera.cy)).astype(int)
    seen = ((at >= 0) & (at < (512, 384))).all(axis=1)
    assert seen.mean() > 0.8
    assert np.corrcoef(bent[v, u][seen].ravel(), wide[at[seen, 1], at[seen, 0]].ravel())[0, 1] > 0.95
    straight = (np.column_stack([u, v]) - (47.5, 35.5)) / lens.params[0]
    assert np.abs(rays[:, :2] / rays[:, 2:] - straight).max() > 0.04


def test_a_camera_that_turns_stays_where_it_is():
    poses = turning_poses(5)
    assert np.ptp(poses[:, :3, 3], axis=0).max() == 0
    assert np.ptp(turning_poses(5, tremble=0.01)[:, :3, 3], axis=0).max() > 0.005
    assert np.degrees(np.arccos(poses[0, :3, 2] @ poses[-1, :3, 2])) > 110


def test_two_places_share_nothing_that_is_seen():
    """No place that one half sees lies before a camera of the other, within its picture."""
    poses, camera = two_places_poses(4), camera_of(TINY)
    views = room_views(poses, camera, texture=False)
    for here, there in ((range(4), range(4, 8)), (range(4, 8), range(4))):
        for i in here:
            v, u = np.mgrid[:48, :64].reshape(2, -1)
            z = views.read(i).depth.reshape(-1).astype(float)
            points = np.stack([(u - camera.cx) / camera.fx * z, (v - camera.cy) / camera.fy * z, z, np.ones(z.shape)])
            for j in there:
                x, y, depth, _ = np.linalg.inv(poses[j]) @ poses[i] @ points
                seen = (depth > 0) & (np.abs(x / depth * camera.fx) < 32) & (np.abs(y / depth * camera.fy) < 24)
                assert not seen.any()


def test_blurred_and_black_pictures_are_those_asked_for(pictures):
    blurred, black = blur_pictures(pictures, [2, 5]), blacken_pictures(pictures, [3])
    detail = [np.abs(np.diff(picture.astype(float), axis=1)).mean() for picture in pictures]
    left = [np.abs(np.diff(picture.astype(float), axis=1)).mean() for picture in blurred]
    for k in range(8):
        assert (left[k] < 0.5 * detail[k]) == (k in (2, 5))
        assert (black[k].mean() < 3) == (k == 3)
        assert np.array_equal(blurred[k], pictures[k]) == (k not in (2, 5))


def test_grey_pictures_keep_their_depth(pictures, tmp_path):
    for bits, mode in ((8, "L"), (16, "I;16")):
        folder = write_grey_pngs(tmp_path / str(bits), pictures[:2], bits=bits)
        with Image.open(folder / "001.png") as picture:
            assert picture.mode == mode and picture.size == TINY
            values = np.asarray(picture, float) / (257 if bits == 16 else 1)
        assert np.abs(values - pictures[1].astype(float) @ (0.299, 0.587, 0.114)).max() < 0.51


def test_sizes_are_mixed(tmp_path):
    folder = write_mixed_sizes(tmp_path / "mixed", arc_poses(4), ((64, 48), (48, 64)))
    sizes = []
    for k in range(4):
        with Image.open(folder / f"{k:03d}.jpg") as picture:
            sizes.append(picture.size)
    assert sizes == [(64, 48), (48, 64)] * 2


def test_lenses_are_those_that_undistortion_knows():
    assert isinstance(strong_lens(), loom.CameraModel)
