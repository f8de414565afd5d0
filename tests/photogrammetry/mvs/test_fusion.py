"""Depth maps of an exact scene fused to points and meshes."""

import numpy as np
import pytest
from PIL import Image
from scipy.spatial import KDTree

import pointloom as loom
from pointloom.photogrammetry.mvs import fusion
from pointloom.photogrammetry.mvs.depth_maps import DepthMaps

from .made_maps import BALLS, WALL, changed, lifted, true_maps

UTM = (512_345.25, 5_403_210.5, 310.0)


def distance_to_scene(points, shift=(0.0, 0.0, 0.0)):
    """Distance of points from the nearest surface [m]."""
    p = np.asarray(points) - shift
    distance = np.abs(p[:, 2] - WALL)
    for x, y, z, radius in BALLS:
        distance = np.minimum(distance, np.abs(np.linalg.norm(p - (x, y, z), axis=1) - radius))
    return distance


def pictures_of(maps):
    """Pictures of one color, the picture's number."""
    return [np.full((*each.depth.shape, 3), 40 * i, np.uint8) for i, each in enumerate(maps)]


def points_of(maps, i):
    return lifted(maps[i].depth, maps.cameras[i])[maps[i].depth > 0]


@pytest.mark.parametrize("shift", [(0.0, 0.0, 0.0), UTM], ids=["near zero", "in UTM coordinates"])
def test_points_cover_the_visible_surface_once(device, shift):
    maps = true_maps(5, shift=shift)
    cloud = loom.mvs.fuse(maps, pictures_of(maps), min_views=1, device=device)
    assert np.quantile(distance_to_scene(cloud.points, shift), 0.99) < 2e-3
    assert distance_to_scene(cloud.points, shift).max() < 0.02  # where a ball is grazed
    all_points = np.concatenate([points_of(maps, i) for i in range(5)])
    pixel = 3.0 / 50  # [m] of the smaller pictures, at the wall
    assert KDTree(cloud.points).query(all_points)[0].max() < 2 * pixel
    assert len(cloud) < 0.45 * len(all_points)
    near = KDTree(cloud.points).query(cloud.points, k=2)[0][:, 1]
    assert np.quantile(near, 0.02) > 0.2 * 1.5 / 66  # a fifth of the finest pixels on the balls


def test_normals_colors_views_and_confidence_are_fused(device):
    maps = true_maps(3, balls=())
    cloud = loom.mvs.fuse(maps, pictures_of(maps), device=device)
    assert set(cloud.attributes) == {"confidence", "views"}
    assert cloud["views"].dtype == np.int32
    assert set(np.unique(cloud["views"]).tolist()) == {2, 3}
    np.testing.assert_allclose(cloud["confidence"], 0.75)
    np.testing.assert_allclose(cloud.normals, np.broadcast_to((0, 0, -1.0), (len(cloud), 3)), atol=1e-6)
    seen_by_all = cloud["views"] == 3
    np.testing.assert_allclose(cloud.colors[seen_by_all], 40 / 255, atol=1e-6)  # the mean of 0, 40 and 80


def test_points_in_too_few_pictures_are_removed():
    maps = true_maps(3)
    counts = [len(loom.mvs.fuse(maps, None, min_views=n)) for n in (1, 2, 3, 4)]
    assert counts[0] > counts[1] > counts[2] > counts[3] == 0
    views = loom.mvs.fuse(maps, None, min_views=1)["views"]
    assert counts == [(views >= n).sum() for n in (1, 2, 3, 4)]


def test_overlapping_pictures_are_merged_without_being_sources():
    maps = true_maps(3)
    strangers = DepthMaps(maps.cameras, [(), (), ()], list(maps))
    np.testing.assert_array_equal(loom.mvs.fuse(strangers, None).points, loom.mvs.fuse(maps, None).points)


def test_a_volume_keeps_what_enough_pictures_show():
    maps = true_maps(3)
    counts = [len(loom.mvs.fuse(maps, None, to="tsdf", min_views=n)) for n in (1, 2, 3, 4)]
    assert counts[0] > counts[1] > counts[2] > counts[3] == 0


def test_there_is_no_surface_far_from_all_points():
    maps = true_maps(4)
    mesh, points = (loom.mvs.fuse(maps, None, to=to) for to in ("poisson", "points"))
    away = KDTree(points.points).query(mesh.vertices)[0]
    assert away.max() < 0.3  # three cells of two pixels of 4.6 cm; Poisson's surface goes 63 cm away


def test_maps_and_pictures_on_disk_change_no_bit(tmp_path, monkeypatch):
    maps = true_maps(4)
    rng = np.random.default_rng(3)
    pictures = [rng.integers(0, 256, (*each.depth.shape, 3)).astype(np.uint8) for each in maps]
    paths = []
    for i, picture in enumerate(pictures):
        paths.append(tmp_path / f"{i}.png")
        Image.fromarray(picture).save(paths[-1])
    expected = loom.mvs.fuse(maps, pictures)
    stored = DepthMaps(maps.cameras, maps.sources, list(maps), folder=tmp_path / "maps")
    monkeypatch.setattr(fusion, "CACHE_BYTES", 1)
    again = loom.mvs.fuse(stored, paths)
    for name in ("points", "normals", "colors", "confidence", "views"):
        np.testing.assert_array_equal(again[name], expected[name])


def test_pictures_of_another_size_and_gray_ones_are_taken():
    maps = true_maps(2, balls=())
    sizes = [each.depth.shape for each in maps]
    large = [np.full((2 * h, 2 * w, 3), 90, np.uint8) for h, w in sizes]
    gray = [np.full(size, 90, np.uint8) for size in sizes]
    for pictures in (large, gray):
        np.testing.assert_allclose(loom.mvs.fuse(maps, pictures).colors, 90 / 255, atol=1e-6)


@pytest.mark.parametrize("to", ["tsdf", "poisson"])
def test_mesh_vertices_are_on_the_surface(device, to):
    maps = true_maps(5)
    mesh = loom.mvs.fuse(maps, pictures_of(maps), to=to, device=device)
    off = distance_to_scene(mesh.vertices)
    assert len(mesh) > 2000
    assert np.median(off) < 5e-3  # a pixel is 5 cm wide
    assert np.quantile(off, 0.9) < 0.06
    assert mesh.vertex_colors is not None
    seen = KDTree(mesh.vertices).query(points_of(maps, 2))[0]
    assert np.quantile(seen, 0.95) < 0.12


@pytest.mark.parametrize("to", ["tsdf", "poisson"])
def test_a_mesh_in_utm_coordinates_is_that_near_zero(to):
    near, far = (loom.mvs.fuse(true_maps(3, shift=shift), None, to=to) for shift in ((0.0, 0.0, 0.0), UTM))
    assert len(near) == pytest.approx(len(far), rel=0.02)  # voxel centers differ
    assert np.median(distance_to_scene(far.vertices, UTM)) == pytest.approx(
        np.median(distance_to_scene(near.vertices)), abs=2e-3
    )


@pytest.mark.parametrize("to", ["tsdf", "poisson"])
def test_a_mesh_may_be_finer_and_without_colors(to):
    maps = true_maps(3)
    coarse, fine = (loom.mvs.fuse(maps, None, to=to, voxel_size=size) for size in (0.2, 0.08))
    assert len(fine) > 2 * len(coarse) > 0
    assert fine.vertex_colors is None


@pytest.mark.parametrize("to", ["points", "tsdf", "poisson"])
def test_nothing_to_fuse_gives_nothing(to):
    assert len(loom.mvs.fuse(DepthMaps([], [], []), [], to=to)) == 0
    maps = true_maps(2)
    bare = changed(changed(maps, 0, np.zeros_like(maps[0].depth)), 1, np.zeros_like(maps[1].depth))
    assert len(loom.mvs.fuse(bare, pictures_of(maps), to=to)) == 0


def test_one_map_alone_gives_its_points():
    maps = DepthMaps(true_maps(1).cameras, [()], [true_maps(1)[0]])
    assert len(loom.mvs.fuse(maps, None, min_views=1)) == maps[0].depth.size
    assert len(loom.mvs.fuse(maps, None)) == 0


@pytest.mark.parametrize(
    ("pictures", "error", "match"),
    [
        ([np.zeros((36, 48, 3), np.uint8)], ValueError, "pictures: expected one for each of the 2 maps, got 1"),
        ([np.zeros((36, 48, 3))] * 2, TypeError, r"pictures\[0\]: expected a path or uint8, got float64"),
        ([np.zeros((36, 48, 4), np.uint8)] * 2, ValueError, r"pictures\[0\]: expected shape"),
        ([np.zeros((48, 36, 3), np.uint8)] * 2, ValueError, r"pictures\[0\]: is 36 x 48"),
        (["none.png", "none.png"], loom.FileError, "none.png"),
        ("picture.png", TypeError, "pictures: expected a list"),
    ],
)
def test_pictures_that_do_not_fit_are_refused(pictures, error, match):
    with pytest.raises(error, match=match):
        loom.mvs.fuse(true_maps(2), pictures)
