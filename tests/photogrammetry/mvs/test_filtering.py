"""Filtering of depth maps by the agreement of their sources, and fusion to points and meshes."""

import numpy as np
import pytest
from PIL import Image
from scipy.spatial import KDTree

import pointloom as loom
from pointloom.photogrammetry.mvs import filtering, fusion
from pointloom.photogrammetry.mvs.depth_maps import DepthMap, DepthMaps

from .made_maps import BALLS, WALL, cameras, changed, lifted, resized, true_map, true_maps

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
    filtered = loom.photogrammetry.filter_depth_maps(maps, min_support=0, device=device)
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
    loom.photogrammetry.filter_depth_maps(DepthMaps(posed, sources, given))  # correct poses: no warning
    inverted = [loom.photogrammetry.PosedCamera(c.intrinsic, np.linalg.inv(c.T_camera_world)) for c in posed]
    with pytest.warns(UserWarning, match="almost no depth .* check that T_camera_world is world to camera"):
        loom.photogrammetry.filter_depth_maps(DepthMaps(inverted, sources, given))


def test_only_planted_wrong_depth_is_removed(device, rng):
    maps = true_maps(4)
    before = loom.photogrammetry.filter_depth_maps(maps, min_support=0, device=device)
    faced = maps[1].normals[..., 2] < -0.6  # a ball's edge is grazed for centimeters
    planted = (rng.random(faced.shape) < 0.1) & faced
    wrong = np.where(planted, maps[1].depth * rng.choice([0.5, 0.97, 1.03, 2.0], planted.shape), maps[1].depth)
    after = loom.photogrammetry.filter_depth_maps(changed(maps, 1, wrong), min_support=0, device=device)
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
    maps = DepthMaps([loom.photogrammetry.PosedCamera(lens, np.eye(4))] * 2, [(1,), (0,)], [each, each])
    filtered = loom.photogrammetry.filter_depth_maps(maps, device=device)[0].depth
    unfiltered = loom.photogrammetry.filter_depth_maps(maps, min_support=0, device=device)[0].depth
    np.testing.assert_allclose(unfiltered, depth)
    for min_pixels, stays in ((3, True), (3.1, False)):  # each pixel of the large speckle has three neighbors
        speckle = loom.photogrammetry.filter_depth_maps(maps, min_support=min_pixels / 24, device=device)[0].depth[
            4:6, 20:22
        ]
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
    camera = [loom.photogrammetry.PosedCamera(lens, np.eye(4))] * 2
    for normal, fraction in (((0, -1.0, 0), 14 / 30), ((0, 0, -1.0), 0), ((0, 0, 0), 0)):
        each = DepthMap(depth, np.broadcast_to(normal, (30, 40, 3)), (depth > 0) * 1.0)
        maps = DepthMaps(camera, [(1,), (0,)], [each, each])
        assert loom.photogrammetry.filter_depth_maps(maps)[0].fraction == pytest.approx(fraction)


def test_averaging_reduces_noise(rng):
    maps = true_maps(5, balls=())
    factors = [1 + 0.002 * rng.normal(size=each.depth.shape) for each in maps]
    noisy = [DepthMap(m.depth * k, m.normals, m.confidence) for m, k in zip(maps, factors, strict=True)]
    filtered = loom.photogrammetry.filter_depth_maps(DepthMaps(maps.cameras, maps.sources, noisy), min_views=4)
    has = filtered[2].depth > 0
    before = (noisy[2].depth / maps[2].depth - 1)[has].std()
    after = (filtered[2].depth / maps[2].depth - 1)[has].std()
    assert has.mean() > 0.3
    assert after < 0.45 * before  # five values of 2 pixels' weight each would give 0.39


def test_more_views_keep_less():
    filtered = (loom.photogrammetry.filter_depth_maps(true_maps(4), min_views=n) for n in (1, 2, 3))
    one, two, three = (np.mean([each.fraction for each in maps]) for maps in filtered)
    assert one > two > three > 0


def test_images_with_few_sources_need_all_and_without_sources_lose_all():
    posed = cameras(3)
    maps = DepthMaps(posed, [(1,), (0, 2), ()], [true_map(camera) for camera in posed])
    filtered = loom.photogrammetry.filter_depth_maps(maps, min_views=5)
    pair = loom.photogrammetry.filter_depth_maps(DepthMaps(posed, [(1,), (0, 2), ()], list(maps)), min_views=1)
    np.testing.assert_array_equal(filtered[0].depth, pair[0].depth)
    assert filtered[0].depth.any()
    assert not filtered[2].depth.any()


def test_uncertain_pixels_are_removed():
    maps = true_maps(3)
    assert not any(each.depth.any() for each in loom.photogrammetry.filter_depth_maps(maps, min_confidence=0.8))
    assert same(
        loom.photogrammetry.filter_depth_maps(maps, min_confidence=0.75), loom.photogrammetry.filter_depth_maps(maps)
    )


@pytest.mark.parametrize(("scale", "shift"), [(1.0, UTM), (1e-6, np.zeros(3)), (1e6, np.zeros(3))])
def test_large_coordinates_and_the_unit_of_the_poses_change_little(device, scale, shift):
    near = loom.photogrammetry.filter_depth_maps(true_maps(3), device=device)
    far = loom.photogrammetry.filter_depth_maps(resized(true_maps(3, shift=shift), scale), device=device)
    for a, b in zip(near, far, strict=True):
        both = (a.depth > 0) & (b.depth > 0)
        assert (both == (a.depth > 0) | (b.depth > 0)).mean() > 0.999
        np.testing.assert_allclose(scale * a.depth[both], b.depth[both], rtol=1e-6)


def test_maps_on_disk_and_little_device_memory_change_no_bit(tmp_path, monkeypatch):
    maps = true_maps(4)
    expected = loom.photogrammetry.filter_depth_maps(maps)
    stored = DepthMaps(maps.cameras, maps.sources, list(maps), folder=tmp_path / "raw")
    monkeypatch.setattr(filtering, "CACHE_BYTES", 1)
    filtered = loom.photogrammetry.filter_depth_maps(stored, folder=tmp_path / "kept")
    assert same(filtered, expected)
    assert same(DepthMaps.open(tmp_path / "kept"), expected)


def test_maps_are_not_filtered_into_their_own_folder(tmp_path):
    maps = true_maps(2)
    stored = DepthMaps(maps.cameras, maps.sources, list(maps), folder=tmp_path / "raw")
    with pytest.raises(loom.FileError, match="/raw:"):
        loom.photogrammetry.filter_depth_maps(stored, folder=str(tmp_path / "raw" / ".." / "raw"))
    assert same(DepthMaps.open(tmp_path / "raw"), maps)


def empty_maps():
    maps = true_maps(2)
    return changed(changed(maps, 0, np.zeros_like(maps[0].depth)), 1, np.zeros_like(maps[1].depth))


def test_no_maps_and_empty_maps_stay_so():
    assert len(loom.photogrammetry.filter_depth_maps(DepthMaps([], [], []))) == 0
    assert not any(each.depth.any() for each in loom.photogrammetry.filter_depth_maps(empty_maps()))


def test_progress_reports_each_image():
    steps = []
    loom.photogrammetry.filter_depth_maps(true_maps(3), progress=lambda *step: steps.append(step))
    assert steps == [("filter", k, 3) for k in range(4)]


def distance_to_scene(points, shift=(0.0, 0.0, 0.0)):
    """Distance of points from the nearest surface [m]."""
    p = np.asarray(points) - shift
    distance = np.abs(p[:, 2] - WALL)
    for x, y, z, radius in BALLS:
        distance = np.minimum(distance, np.abs(np.linalg.norm(p - (x, y, z), axis=1) - radius))
    return distance


def images_of(maps):
    """Images of one color, the image's number."""
    return [np.full((*each.depth.shape, 3), 40 * i, np.uint8) for i, each in enumerate(maps)]


def points_of(maps, i):
    return lifted(maps[i].depth, maps.cameras[i])[maps[i].depth > 0]


@pytest.mark.parametrize("shift", [(0.0, 0.0, 0.0), UTM], ids=["near zero", "in UTM coordinates"])
def test_points_cover_the_visible_surface_once(device, shift):
    maps = true_maps(5, shift=shift)
    cloud = loom.photogrammetry.fuse_depth_maps(maps, images_of(maps), min_views=1, device=device)
    assert np.quantile(distance_to_scene(cloud.points, shift), 0.99) < 2e-3
    assert distance_to_scene(cloud.points, shift).max() < 0.02  # where a ball is grazed
    all_points = np.concatenate([points_of(maps, i) for i in range(5)])
    pixel = 3.0 / 50  # [m] of the smaller images, at the wall
    assert KDTree(cloud.points).query(all_points)[0].max() < 2 * pixel
    assert len(cloud) < 0.45 * len(all_points)
    near = KDTree(cloud.points).query(cloud.points, k=2)[0][:, 1]
    assert np.quantile(near, 0.02) > 0.2 * 1.5 / 66  # a fifth of the finest pixels on the balls


def test_normals_colors_views_and_confidence_are_fused(device):
    maps = true_maps(3, balls=())
    cloud = loom.photogrammetry.fuse_depth_maps(maps, images_of(maps), device=device)
    assert set(cloud.attributes) == {"confidence", "views"}
    assert cloud["views"].dtype == np.int32
    assert set(np.unique(cloud["views"]).tolist()) == {2, 3}
    np.testing.assert_allclose(cloud["confidence"], 0.75)
    np.testing.assert_allclose(cloud.normals, np.broadcast_to((0, 0, -1.0), (len(cloud), 3)), atol=1e-6)
    seen_by_all = cloud["views"] == 3
    np.testing.assert_allclose(cloud.colors[seen_by_all], 40 / 255, atol=1e-6)  # the mean of 0, 40 and 80


@pytest.mark.parametrize("to", ["points", "tsdf"])
def test_a_surface_in_too_few_images_is_removed(to):
    maps = true_maps(3)
    counts = [len(loom.photogrammetry.fuse_depth_maps(maps, None, to=to, min_views=n)) for n in (1, 2, 3, 4)]
    assert counts[0] > counts[1] > counts[2] > counts[3] == 0
    if to == "points":
        views = loom.photogrammetry.fuse_depth_maps(maps, None, min_views=1)["views"]
        assert counts == [(views >= n).sum() for n in (1, 2, 3, 4)]


def test_overlapping_images_are_merged_without_being_sources():
    maps = true_maps(3)
    strangers = DepthMaps(maps.cameras, [(), (), ()], list(maps))
    np.testing.assert_array_equal(
        loom.photogrammetry.fuse_depth_maps(strangers, None).points,
        loom.photogrammetry.fuse_depth_maps(maps, None).points,
    )


def test_there_is_no_surface_far_from_all_points():
    maps = true_maps(4)
    mesh, points = (loom.photogrammetry.fuse_depth_maps(maps, None, to=to) for to in ("poisson", "points"))
    away = KDTree(points.points).query(mesh.vertices)[0]
    assert away.max() < 0.3  # three cells of two pixels of 4.6 cm; Poisson's surface goes 63 cm away


def test_maps_and_images_on_disk_change_no_bit(tmp_path, monkeypatch):
    maps = true_maps(4)
    rng = np.random.default_rng(3)
    images = [rng.integers(0, 256, (*each.depth.shape, 3)).astype(np.uint8) for each in maps]
    paths = []
    for i, image in enumerate(images):
        paths.append(tmp_path / f"{i}.png")
        Image.fromarray(image).save(paths[-1])
    expected = loom.photogrammetry.fuse_depth_maps(maps, images)
    stored = DepthMaps(maps.cameras, maps.sources, list(maps), folder=tmp_path / "maps")
    monkeypatch.setattr(fusion, "CACHE_BYTES", 1)
    again = loom.photogrammetry.fuse_depth_maps(stored, paths)
    for name in ("points", "normals", "colors", "confidence", "views"):
        np.testing.assert_array_equal(again[name], expected[name])


def test_images_of_another_size_and_gray_ones_are_taken():
    maps = true_maps(2, balls=())
    sizes = [each.depth.shape for each in maps]
    large = [np.full((2 * h, 2 * w, 3), 90, np.uint8) for h, w in sizes]
    gray = [np.full(size, 90, np.uint8) for size in sizes]
    for images in (large, gray):
        np.testing.assert_allclose(loom.photogrammetry.fuse_depth_maps(maps, images).colors, 90 / 255, atol=1e-6)


@pytest.mark.parametrize("to", ["tsdf", "poisson"])
def test_mesh_vertices_are_on_the_surface(device, to):
    maps = true_maps(5)
    mesh = loom.photogrammetry.fuse_depth_maps(maps, images_of(maps), to=to, device=device)
    off = distance_to_scene(mesh.vertices)
    assert len(mesh) > 2000
    assert np.median(off) < 5e-3  # a pixel is 5 cm wide
    assert np.quantile(off, 0.9) < 0.06
    assert mesh.vertex_colors is not None
    seen = KDTree(mesh.vertices).query(points_of(maps, 2))[0]
    assert np.quantile(seen, 0.95) < 0.12


@pytest.mark.parametrize("to", ["tsdf", "poisson"])
def test_a_mesh_in_utm_coordinates_is_that_near_zero(to):
    near, far = (
        loom.photogrammetry.fuse_depth_maps(true_maps(3, shift=shift), None, to=to) for shift in ((0.0, 0.0, 0.0), UTM)
    )
    assert len(near) == pytest.approx(len(far), rel=0.02)  # voxel centers differ
    expected = np.median(distance_to_scene(near.vertices))
    assert np.median(distance_to_scene(far.vertices, UTM)) == pytest.approx(expected, abs=2e-3)


@pytest.mark.parametrize("to", ["tsdf", "poisson"])
def test_a_mesh_may_be_finer_and_without_colors(to):
    maps = true_maps(3)
    coarse, fine = (loom.photogrammetry.fuse_depth_maps(maps, None, to=to, voxel_size=size) for size in (0.2, 0.08))
    assert len(fine) > 2 * len(coarse) > 0
    assert fine.vertex_colors is None


@pytest.mark.parametrize("to", ["points", "tsdf", "poisson"])
def test_nothing_to_fuse_gives_nothing(to):
    assert len(loom.photogrammetry.fuse_depth_maps(DepthMaps([], [], []), [], to=to)) == 0
    assert len(loom.photogrammetry.fuse_depth_maps(empty_maps(), images_of(empty_maps()), to=to)) == 0


def test_one_map_alone_gives_its_points():
    maps = DepthMaps(true_maps(1).cameras, [()], [true_maps(1)[0]])
    assert len(loom.photogrammetry.fuse_depth_maps(maps, None, min_views=1)) == maps[0].depth.size
    assert len(loom.photogrammetry.fuse_depth_maps(maps, None)) == 0


@pytest.mark.parametrize(
    ("images", "error", "match"),
    [
        ([np.zeros((36, 48, 3), np.uint8)], ValueError, "images: expected one for each of the 2 maps, got 1"),
        ([np.zeros((36, 48, 3))] * 2, TypeError, r"images\[0\]: expected a path or uint8, got float64"),
        ([np.zeros((36, 48, 4), np.uint8)] * 2, ValueError, r"images\[0\]: expected shape"),
        ([np.zeros((48, 36, 3), np.uint8)] * 2, ValueError, r"images\[0\]: is 36 x 48"),
        (["none.png", "none.png"], loom.FileError, "none.png"),
        ("picture.png", TypeError, "images: expected a list"),
    ],
)
def test_images_that_do_not_fit_are_refused(images, error, match):
    with pytest.raises(error, match=match):
        loom.photogrammetry.fuse_depth_maps(true_maps(2), images)
