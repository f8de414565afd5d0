"""Main planes, lines of sight and agreement of pairs: evidence for and against an overlap of two clouds."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.kernels.algebra.transform import transform_points
from pointloom.kernels.lang import int32, int64, uint8, vec3
from pointloom.kernels.memory import download, upload
from pointloom.kernels.poses import line_of_sight, pair_probes
from pointloom.kernels.poses.alignment_rows import PairedSurfaces
from pointloom.kernels.poses.line_of_sight import MAX_VIEWPOINTS, Sight, find_sights
from pointloom.kernels.poses.main_planes import MAX_VOTERS, MainPlanes, find_main_planes, leave_out_planes
from pointloom.kernels.poses.overlap_evidence import Overlaps
from pointloom.kernels.poses.pair_probes import compare_pair
from pointloom.kernels.poses.point_sums import count_agreeing, position_moments
from pointloom.kernels.search import nearest_point
from pointloom.kernels.search.nearest_point import NO_POINT, find_nearest
from pointloom.kernels.surface.hollow_side import Surface

from ...registration.poses import as_pose

LIMITS = (0.02, 0.05, 0.9)  # tight, slab, cosine


def sheets(rng, counts, noise=0.002):
    """Points on planes with normals x, y, z in turn, two meters apart, and their normals."""
    points, normals = [], []
    for k, count in enumerate(counts):
        p = rng.uniform(-1, 1, (count, 3))
        p[:, k % 3] = 2.0 * (k // 3) + 1.5 + rng.normal(0, noise, count)
        n = rng.normal(0, 0.02, (count, 3))
        n[:, k % 3] += rng.choice([-1, 1], count)  # of either side
        points.append(p), normals.append(n / np.linalg.norm(n, axis=1, keepdims=True))
    order = rng.permutation(sum(counts))
    return np.concatenate(points)[order], np.concatenate(normals)[order]


def on_device(points, normals, device, rows=None):
    mask = np.zeros(len(points), np.uint8)
    mask[slice(None) if rows is None else rows] = 1
    return [upload(points, vec3, device), upload(normals, vec3, device), upload(mask, uint8, device)]


def planes_of(arrays, max_planes):
    return find_main_planes(*arrays, max_planes, *LIMITS).read()[0]


def test_moved_surfaces_are_searched_in_the_order_of_their_trees(device, rng, monkeypatch):
    surfaces = [Surface(*on_device(*sheets(rng, (300, 300)), device)[:2]) for _ in range(2)]
    pose, distance = as_pose([0, 0, 0.1], [0.02, 0, 0]), 0.3
    poses = np.array([pose, np.eye(4)])

    with monkeypatch.context() as patch:
        patch.setattr(nearest_point, "order_along_curve", None)  # not called
        overlap = Overlaps([(*surfaces, pose)], distance, distance, 0.9, distance)
        pairs = PairedSurfaces(*surfaces, pose, np.linalg.inv(pose), distance, 0.9)
        rises = compare_pair(*surfaces, len(surfaces[0]), poses, distance, 0.9, 0.1)
    keys = download(find_nearest(surfaces[1].tree, overlap.moved, radius=distance))
    assert (keys != NO_POINT).any()
    for nearest in (overlap.nearest, pairs.nearest_target):
        np.testing.assert_array_equal(download(nearest), keys)
    back = transform_points(surfaces[1].points, *(np.linalg.inv(pose)[:3, k] for k in (slice(3), 3)))
    expected = find_nearest(surfaces[0].tree, back, radius=distance)
    np.testing.assert_array_equal(download(pairs.nearest_source), download(expected))
    monkeypatch.setattr(pair_probes, "find_nearest", lambda *given, radius, order: find_nearest(*given, radius=radius))
    np.testing.assert_array_equal(compare_pair(*surfaces, len(surfaces[0]), poses, distance, 0.9, 0.1), rises)


@pytest.mark.parametrize(
    ("counts", "axes", "heights"),
    [
        ((500, 2000, 1000, 200), [1, 2, 0], [1.5, 1.5, 1.5]),
        ((1500, 20, 20, 1000), [0, 0], [1.5, 3.5]),
        ((6 * MAX_VOTERS, 3 * MAX_VOTERS), [0, 1], [1.5, 1.5]),
    ],
    ids=["planes", "parallel ones are two", "a large cloud is subsampled"],
)
def test_planes_are_ordered_by_their_number_of_points(device, rng, counts, axes, heights):
    middles, directions = planes_of(on_device(*sheets(rng, counts), device), len(axes))
    assert np.abs(directions).argmax(axis=1).tolist() == axes and np.abs(directions).max(axis=1).min() > 0.9999
    np.testing.assert_allclose(middles[range(len(axes)), axes], heights, atol=0.003)


def test_planes_of_several_surfaces_are_those_of_each(device, rng):
    counts = [(500, 2000, 1000), (), (4,), (3 * MAX_VOTERS, MAX_VOTERS), (100, 300), ()]
    surfaces = [sheets(rng, sizes) if sizes else (np.empty((0, 3)),) * 2 for sizes in counts]
    rows = [rng.permutation(len(points))[: 9 * len(points) // 10] for points, _ in surfaces]
    alone = [planes_of(on_device(*surface, device, some), 3) for surface, some in zip(surfaces, rows, strict=True)]
    starts = np.cumsum([0, *(len(points) for points, _ in surfaces)])
    chosen = np.concatenate([some + start for some, start in zip(rows, starts, strict=False)])
    arrays = on_device(*(np.concatenate(parts) for parts in zip(*surfaces, strict=True)), device, chosen)
    together = find_main_planes(*arrays, 3, *LIMITS, upload(starts, int32, arrays[0].device)).read()
    assert [len(middles) for middles, _ in together] == [3, 0, 0, 2, 2, 0]
    for one, other in zip(together, alone, strict=True):
        for values, expected in zip(one, other, strict=True):
            np.testing.assert_array_equal(values, expected)


def test_points_that_are_not_chosen_do_not_count(device, rng):
    points, normals = sheets(rng, (500, 2000, 1000))
    rows = np.flatnonzero(np.abs(normals[:, 1]) < 0.5)
    _, directions = planes_of(on_device(points, normals, device, rows), 3)
    assert np.abs(directions).argmax(axis=1).tolist()[:2] == [2, 0]


@pytest.mark.parametrize(("count", "planes"), [(0, 0), (1, 0), (4, 0), (5, 1)])
def test_five_points_make_a_plane_and_fewer_do_not(device, rng, count, planes):
    result = planes_of(on_device(*sheets(rng, (count,)), device), 3)
    assert [values.shape for values in result] == [(planes, 3)] * 2


def test_points_that_coincide_make_a_plane(device, rng):
    points, normals = (np.tile(rows[:1], (6, 1)) for rows in sheets(rng, (5,)))
    middles, directions = planes_of(on_device(points, normals, device), 3)
    assert np.isfinite(middles).all() and np.isfinite(directions).all()


def test_planes_that_do_not_cross_have_no_edge(device):
    points, normals = np.array([[0, 0, 0.1], [0, 0, 0.01]]), np.array([[1.0, 0, 0], [0, 0.1, 0.995]])
    p, n, _ = on_device(points, normals, device)
    nearest = upload(np.array([4, 5]), int64, p.device)
    middles, directions = np.array([[0, 0, 0.2], [0, 0, 0]]), np.array([[0, 0, 1.0], [0, 0.1, -0.995]])
    planes, starts = MainPlanes.of(middles, directions, p.device), upload(np.array([0, len(points)]), int32, p.device)
    leave_out_planes(p, n, planes, 0.05, 0.8, 0.25, nearest, starts)
    assert download(nearest).tolist() == [4, NO_POINT]


def test_remaining_points_are_on_a_plane_or_an_intersection(device, rng):
    points = rng.uniform(-1, 1, (2000, 3))
    normals = rng.normal(size=(2000, 3))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    middles, directions = np.array([[0.3, 0, 0], [0, -0.2, 0]]), np.array([[1.0, 0, 0], [0, -1, 0]])
    p, n, _ = on_device(points, normals, device)
    nearest = upload(np.arange(2000), int64, p.device)
    planes, starts = MainPlanes.of(middles, directions, p.device), upload(np.array([0, len(points)]), int32, p.device)
    leave_out_planes(p, n, planes, 0.1, 0.8, 0.25, nearest, starts)
    heights = np.abs(np.einsum("kj,ikj->ik", directions, points[:, None] - middles))
    on = ((heights < 0.1) & (np.abs(normals @ directions.T) > 0.8)).any(axis=1)
    left = ~on & ((heights < 0.25).sum(axis=1) < 2)
    assert on.sum() > 50 and (~left & ~on).sum() > 50
    np.testing.assert_array_equal(download(nearest), np.where(left, np.arange(2000), NO_POINT))


EYE = np.zeros((1, 3))


def plate(x, y=(-1.0, 1.0), z=(-1.0, 1.0), step=0.03):
    u, v = (np.arange(low, high + 1e-9, step) for low, high in (y, z))
    return np.stack(np.meshgrid([x], u, v, indexing="ij"), -1).reshape(-1, 3)


def shifted(rows, device):
    cloud = loom.PointCloud(rows, device=device)
    return cloud.arrays["points"], np.asarray(cloud.origin, float)


@pytest.mark.parametrize(
    ("x", "y", "fraction"),
    [(1.0, (-0.4, 0.4), 1), (1.75, (-0.4, 0.4), 0), (3.0, (-0.4, 0.4), 0), (1.0, (2.0, 2.5), 0)],
    ids=["before", "too near to it to tell", "behind", "beside"],
)
def test_an_object_before_a_wall_is_in_the_way(device, x, y, fraction):
    wall, there = shifted(plate(2.0), device)
    screen, origin = shifted(plate(x, y, (-0.4, 0.4)), device)
    counts = Sight(wall, EYE - there, 0.1).count_occluding(screen, as_pose(shift=origin - there))
    assert counts.numpy().tolist() == [fraction * screen.size]


def test_a_surface_behind_another_plate_is_hidden(device):
    rows = np.r_[plate(1.0, (-0.5, 0.5), (-0.5, 0.5)), plate(2.0)]
    points, origin = shifted(rows, device)
    hidden = Sight(points, EYE - origin, 0.1).count_hidden(points).numpy()[0]
    shadow = (rows[:, 0] == 2) & (np.abs(rows[:, 1:]) < 1).all(axis=1)
    assert hidden == pytest.approx(shadow.sum(), rel=0.05)


def test_viewpoints_with_minimal_occlusion_are_selected(device):
    points, _ = shifted(np.r_[plate(1.0, (-0.5, 0.5), (-0.5, 0.5)), plate(2.0), plate(-2.0)], device)
    sight = find_sights([points], [0.1])[0]
    assert sight is not None and 0 < sight.viewpoint_count <= MAX_VIEWPOINTS
    x = np.asarray(sight.viewpoints.numpy())[:, 0]
    assert x.min() > 0.5  # farther back the small plate hides the wall behind it


def test_a_cloud_invisible_from_every_viewpoint_has_no_sight(device, rng, monkeypatch):
    ways = rng.normal(size=(8000, 3))
    ways /= np.linalg.norm(ways, axis=1, keepdims=True)
    ways[:3000] *= 0.6  # a ball in a ball
    points, _ = shifted(ways, device)
    assert find_sights([points], [0.1])[0] is not None
    monkeypatch.setattr(line_of_sight, "MAX_HIDDEN", 0.01)
    assert (
        find_sights([points], [0.1])[0] is None
        and find_sights([shifted(np.empty((0, 3)), device)[0]], [0.1])[0] is None
    )


def test_moments_are_the_sums_of_coordinates_and_their_products(device, rng):
    points, origin = rng.normal(size=(300, 3)).astype(np.float32), np.array([10.0, -20.0, 30.0])
    x, y, z = (points.astype(float) + origin).T
    expected = [np.sum(a) for a in (x**0, x, y, z, x * x, x * y, x * z, y * y, y * z, z * z)]
    np.testing.assert_allclose(position_moments(upload(points, vec3, device), origin), expected, rtol=1e-12)


def test_pairs_agree_where_two_poses_bring_them_within_the_distance(device, rng):
    count = 300
    source, target = rng.random((2, count, 3)).astype(np.float32)
    rows, distances = rng.permutation(count), rng.random(count).astype(np.float32)
    keys = (distances.view(np.int32).astype(np.int64) << 32) | rows
    keys[::7] = NO_POINT
    origins, poses = rng.random((2, 3)), np.tile(np.eye(4), (2, 1, 1))
    poses[:, :3, :3], poses[:, :3, 3] = Rotation.random(2, rng).as_matrix(), rng.random((2, 3))
    a, b = (p.astype(float) + o for p, o in zip((source, target), origins, strict=True))
    a, b = (p @ T[:3, :3].T + T[:3, 3] for p, T in zip((a, b), poses, strict=True))
    is_pair = keys != NO_POINT
    gaps = np.linalg.norm(a - b[rows], axis=1)
    limit = float(np.median(gaps[is_pair]))
    arrays = upload(source, vec3, device), upload(target, vec3, device), upload(keys, int64, device)
    counts = download(count_agreeing(*arrays, tuple(origins), tuple(poses), limit + 1e-9))
    assert np.asarray(counts).reshape(-1).tolist() == [is_pair.sum(), (gaps[is_pair] <= limit + 1e-9).sum()]
