"""Filtering of depth maps by the agreement of their sources: exact scenes with planted faults."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.photogrammetry.mvs import filtering
from pointloom.photogrammetry.mvs.depth_maps import DepthMap, DepthMaps

from .made_maps import BALLS, cameras, changed, lifted, resized, true_map, true_maps

UTM = (512_345.25, 5_403_210.5, 310.0)


def same(a, b):
    """True if two sets of maps are bitwise identical."""
    names = ("depth", "normals", "confidence")
    return all(np.array_equal(getattr(x, n), getattr(y, n)) for x, y in zip(a, b, strict=True) for n in names)


def seen_by_others(maps, i):
    """Number of other cameras that see the point of each pixel unoccluded (within 2%)."""
    depth = maps[i].depth
    world, count = lifted(depth, maps.cameras[i]).reshape(-1, 3), np.zeros(depth.size, int)
    for j in range(len(maps)):
        if j == i:
            continue
        lens, T = maps.cameras[j].intrinsic, maps.cameras[j].T_camera_world
        p = world @ T[:3, :3].T + T[:3, 3]
        column, row = lens.fx * p[:, 0] / p[:, 2] + lens.cx, lens.fy * p[:, 1] / p[:, 2] + lens.cy
        inside = (column > 0) & (row > 0) & (column < lens.width - 1) & (row < lens.height - 1)
        at = np.where(inside[:, None], np.stack([row, column], 1), 0).round().astype(int)
        count += inside & (np.abs(maps[j].depth[at[:, 0], at[:, 1]] / p[:, 2] - 1) < 0.02)
    return count.reshape(depth.shape)


@pytest.mark.parametrize("balls", [(), BALLS], ids=["a wall", "balls before a wall"])
def test_confirmed_true_depth_is_unchanged(device, balls):
    maps = true_maps(4, balls=balls)
    filtered = loom.mvs.filter_depth_maps(maps, min_support=0, device=device)
    for i, each in enumerate(filtered):
        wanted, has = seen_by_others(maps, i) >= 2, each.depth > 0
        error = np.abs(each.depth / maps[i].depth - 1)[has]
        assert has[wanted].mean() > (0.95 if balls else 0.999)  # at 48 columns a ball's edge is 4 % of the pixels
        assert error.max() <= (0.01 if balls else 1e-4)  # ... where its depth bends within a pixel; the border
        assert np.median(error) < 1e-6
        np.testing.assert_array_equal(each.normals, np.where(has[..., None], maps[i].normals, 0))
        np.testing.assert_array_equal(each.confidence, np.where(has, maps[i].confidence, 0))


def test_inverted_poses_are_warned_about():
    """The scene is far from the origin: otherwise a wall would look the same to inverted cameras."""
    far = (5.0, 3.0, 40.0)
    posed = cameras(3, step=0.5, shift=far)
    given = [true_map(camera, shift=far) for camera in posed]
    sources = [(1, 2), (0, 2), (0, 1)]
    loom.mvs.filter_depth_maps(DepthMaps(posed, sources, given))  # correct poses: no warning
    inverted = [loom.mvs.PosedCamera(c.intrinsic, np.linalg.inv(c.T_camera_world)) for c in posed]
    with pytest.warns(UserWarning, match="almost no depth .* check that T_camera_world is world to camera"):
        loom.mvs.filter_depth_maps(DepthMaps(inverted, sources, given))


def test_only_planted_wrong_depth_is_removed(device, rng):
    maps = true_maps(4)
    before = loom.mvs.filter_depth_maps(maps, min_support=0, device=device)
    faced = maps[1].normals[..., 2] < -0.6  # a ball's edge is grazed for centimeters
    planted = (rng.random(faced.shape) < 0.1) & faced
    wrong = np.where(planted, maps[1].depth * rng.choice([0.5, 0.97, 1.03, 2.0], planted.shape), maps[1].depth)
    after = loom.mvs.filter_depth_maps(changed(maps, 1, wrong), min_support=0, device=device)
    assert before[1].depth[planted].astype(bool).mean() > 0.8
    assert not after[1].depth[planted].any()
    np.testing.assert_array_equal(after[1].depth[~planted], before[1].depth[~planted])


def test_speckles_are_removed_and_surfaces_two_pixels_wide_remain(device):
    """Two identical maps of one camera, so that every pixel is confirmed."""
    lens = loom.PinholeCameraIntrinsic(40, 30, 40.0, 40.0, 19.5, 14.5)
    depth = np.full((30, 40), 3.0)
    depth[5:25, 8:10] = 2.0  # a post
    depth[4:6, 20:22], depth[15, 25], depth[20:23, 30] = 2.0, 2.0, 2.5  # speckles
    normals = np.broadcast_to((0, 0, -1.0), (30, 40, 3))
    each = DepthMap(depth, normals, np.ones((30, 40)))
    maps = DepthMaps([loom.mvs.PosedCamera(lens, np.eye(4))] * 2, [(1,), (0,)], [each, each])
    filtered = loom.mvs.filter_depth_maps(maps, device=device)[0].depth
    unfiltered = loom.mvs.filter_depth_maps(maps, min_support=0, device=device)[0].depth
    np.testing.assert_allclose(unfiltered, depth)
    for min_pixels, stays in ((3, True), (3.1, False)):  # each pixel of the large speckle has three neighbors
        speckle = loom.mvs.filter_depth_maps(maps, min_support=min_pixels / 24, device=device)[0].depth[4:6, 20:22]
        assert (speckle > 0).all() == stays
    expected = depth.copy()
    expected[4:6, 20:22], expected[15, 25], expected[20:23, 30] = 0, 0, 0
    expected[[5, 24], 8:10] = 0  # the ends of the post
    np.testing.assert_allclose(filtered, expected)


@pytest.mark.filterwarnings("ignore:almost no depth")
def test_slanted_surfaces_support_themselves_by_their_normals():
    """A floor whose depth changes by 3% a row: with wrong normals no pixel agrees with its neighbors."""
    lens = loom.PinholeCameraIntrinsic(40, 30, 40.0, 40.0, 19.5, 5.0)
    v = np.mgrid[:30, :40][0]
    depth = np.where(v > 15, 40.0 / np.maximum(v - 5.0, 1e-9), 0)
    camera = [loom.mvs.PosedCamera(lens, np.eye(4))] * 2
    for normal, share in (((0, -1.0, 0), 14 / 30), ((0, 0, -1.0), 0), ((0, 0, 0), 0)):
        each = DepthMap(depth, np.broadcast_to(normal, (30, 40, 3)), (depth > 0) * 1.0)
        maps = DepthMaps(camera, [(1,), (0,)], [each, each])
        assert loom.mvs.filter_depth_maps(maps)[0].share == pytest.approx(share)


def test_averaging_reduces_noise(rng):
    maps = true_maps(5, balls=())
    noisy = [
        DepthMap(each.depth * (1 + 0.002 * rng.normal(size=each.depth.shape)), each.normals, each.confidence)
        for each in maps
    ]
    filtered = loom.mvs.filter_depth_maps(DepthMaps(maps.cameras, maps.sources, noisy), min_views=4)
    has = filtered[2].depth > 0
    before = (noisy[2].depth / maps[2].depth - 1)[has].std()
    after = (filtered[2].depth / maps[2].depth - 1)[has].std()
    assert has.mean() > 0.3
    assert after < 0.45 * before  # five values of 2 pixels' weight each would give 0.39


def test_more_views_keep_less():
    shares = [
        np.mean([each.share for each in loom.mvs.filter_depth_maps(true_maps(4), min_views=n)]) for n in (1, 2, 3)
    ]
    assert shares[0] > shares[1] > shares[2] > 0


def test_pictures_with_few_sources_need_all_and_without_sources_lose_all():
    posed = cameras(3)
    maps = DepthMaps(posed, [(1,), (0, 2), ()], [true_map(camera) for camera in posed])
    filtered = loom.mvs.filter_depth_maps(maps, min_views=5)
    pair = loom.mvs.filter_depth_maps(DepthMaps(posed, [(1,), (0, 2), ()], list(maps)), min_views=1)
    np.testing.assert_array_equal(filtered[0].depth, pair[0].depth)
    assert filtered[0].depth.any()
    assert not filtered[2].depth.any()


def test_uncertain_pixels_are_removed():
    maps = true_maps(3)
    assert not any(each.depth.any() for each in loom.mvs.filter_depth_maps(maps, min_confidence=0.8))
    assert same(loom.mvs.filter_depth_maps(maps, min_confidence=0.75), loom.mvs.filter_depth_maps(maps))


def test_large_coordinates_keep_the_same_pixels(device):
    near = loom.mvs.filter_depth_maps(true_maps(3), device=device)
    far = loom.mvs.filter_depth_maps(true_maps(3, shift=UTM), device=device)
    for a, b in zip(near, far, strict=True):
        assert ((a.depth > 0) == (b.depth > 0)).mean() > 0.999
        both = (a.depth > 0) & (b.depth > 0)
        np.testing.assert_allclose(a.depth[both], b.depth[both], rtol=1e-6)


@pytest.mark.parametrize("scale", [1e-6, 1e6])
def test_the_unit_of_the_poses_does_not_matter(scale):
    maps = true_maps(3)
    filtered = loom.mvs.filter_depth_maps(resized(maps, scale))
    for a, b in zip(loom.mvs.filter_depth_maps(maps), filtered, strict=True):
        assert ((a.depth > 0) == (b.depth > 0)).mean() > 0.999


def test_maps_on_disk_and_little_device_memory_change_no_bit(tmp_path, monkeypatch):
    maps = true_maps(4)
    expected = loom.mvs.filter_depth_maps(maps)
    stored = DepthMaps(maps.cameras, maps.sources, list(maps), folder=tmp_path / "raw")
    monkeypatch.setattr(filtering, "CACHE_BYTES", 1)
    filtered = loom.mvs.filter_depth_maps(stored, folder=tmp_path / "kept")
    assert same(filtered, expected)
    assert same(DepthMaps.open(tmp_path / "kept"), expected)


def test_maps_are_not_filtered_into_their_own_folder(tmp_path):
    maps = true_maps(2)
    stored = DepthMaps(maps.cameras, maps.sources, list(maps), folder=tmp_path / "raw")
    with pytest.raises(loom.FileError, match="/raw:"):
        loom.mvs.filter_depth_maps(stored, folder=str(tmp_path / "raw" / ".." / "raw"))
    assert same(DepthMaps.open(tmp_path / "raw"), maps)


def test_no_maps_and_empty_maps_stay_so():
    assert len(loom.mvs.filter_depth_maps(DepthMaps([], [], []))) == 0
    maps = true_maps(2)
    bare = changed(changed(maps, 0, np.zeros_like(maps[0].depth)), 1, np.zeros_like(maps[1].depth))
    assert not any(each.depth.any() for each in loom.mvs.filter_depth_maps(bare))


def test_progress_reports_each_picture():
    steps = []
    loom.mvs.filter_depth_maps(true_maps(3), progress=lambda *step: steps.append(step))
    assert steps == [("filter", k, 3) for k in range(4)]
