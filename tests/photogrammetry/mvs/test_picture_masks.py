"""Masked pixels have no depth and give no points."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.io.pictures.image_files import write_png

from .made_pictures import HEIGHT, WIDTH, scene, three


@pytest.fixture(scope="module")
def masks():
    """A mask that excludes the right half of each picture."""
    mask = np.zeros((HEIGHT, WIDTH), np.uint8)
    mask[:, : WIDTH // 2] = 255
    return mask


def test_masked_pixels_have_no_depth_and_no_points(masks, tmp_path):
    cameras = three()
    pictures, sparse = scene(cameras)
    write_png(tmp_path / "m.png", masks)
    given = [tmp_path / "m.png", masks, masks > 0]
    unmasked = loom.mvs.estimate_depth_maps(pictures, cameras, sparse)
    maps = loom.mvs.estimate_depth_maps(pictures, cameras, sparse, masks=given)
    for each, all_of_it in zip(maps, unmasked, strict=True):
        out = masks == 0
        assert not each.depth[out].any() and not each.confidence[out].any() and not each.normals[out].any()
        assert np.array_equal(each.depth[~out], all_of_it.depth[~out]) and each.depth[~out].any()
    cloud = loom.mvs.fuse(maps, pictures)
    inside = np.zeros(len(cloud), bool)
    for camera in cameras:
        p = cloud.points @ camera.T_camera_world[:3, :3].T + camera.T_camera_world[:3, 3]
        inside |= camera.intrinsic.fx * p[:, 0] / p[:, 2] + camera.intrinsic.cx < WIDTH // 2 + 1
    assert len(cloud) > 100 and inside.all()
    maps = loom.mvs.estimate_depth_maps(pictures, cameras, sparse, masks=[None, masks, None])
    assert np.array_equal(maps[0].depth, unmasked[0].depth) and not np.array_equal(maps[1].depth, unmasked[1].depth)


def test_masks_that_do_not_fit_are_refused(masks, tmp_path):
    cameras = three()
    pictures, sparse = scene(cameras)
    write_png(tmp_path / "m.png", masks[:-1])
    for wrong, error, match in [
        ([masks], ValueError, "masks: expected one, or None, for each of the 3 images, got 1"),
        ([masks, masks, masks[1:]], ValueError, r"masks\[2\]: expected shape"),
        ([masks, masks, 1.0 * masks], TypeError, r"masks\[2\]: expected a path, or an array of bool or uint8"),
        ([masks, masks, tmp_path / "m.png"], loom.FileError, "m.png: expected a mask of 48 x 36 pixels"),
    ]:
        with pytest.raises(error, match=match):
            loom.mvs.estimate_depth_maps(pictures, cameras, sparse, masks=wrong)
