"""Convex hulls: Open3D's on real scans, brute force on small clouds, and degenerate clouds on which Open3D fails."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import pointloom as loom

from .any_cloud import clouds, examples, parts
from .open3d_clouds import cloud_of

ROTATION = np.array([[0.8, 0.0, 0.6], [0.36, 0.8, -0.48], [-0.48, 0.6, 0.64]])


def rows_of(points):
    return {tuple(p) for p in np.asarray(points).tolist()}


def edge_balance(triangles):
    """Each directed edge of a closed, consistently oriented surface occurs as often as its opposite."""
    ends = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]).astype(np.int64)
    forth, back = (np.sort(e[:, 0] * (ends.max() + 1) + e[:, 1]) for e in (ends, ends[:, ::-1]))
    return np.array_equal(forth, back)


def signed_volume(hull):
    a, b, c = (hull.vertices[hull.triangles[:, k]] - hull.vertices[0] for k in range(3))
    return np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6


def assert_encloses(hull, points, limit):
    """Check that no point is farther than the limit outside any non-degenerate triangle."""
    a, b, c = (hull.vertices[hull.triangles[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    sizes = np.linalg.norm(normals, axis=1)
    large = sizes > 1e-6 * np.ptp(points, axis=0).max() ** 2
    normals, a = normals[large] / sizes[large, None], a[large]
    for rows in np.array_split(points, max(1, len(points) * len(a) // 5_000_000)):
        assert (rows @ normals.T - np.einsum("ij,ij->i", normals, a)).max() <= limit


def open3d_hull(o3d, points):
    """Vertices of Open3D's hull as rows of the cloud, volume and area."""
    mesh, indices = cloud_of(o3d, points).compute_convex_hull()
    mesh.orient_triangles()
    return np.sort(indices), abs(mesh.get_volume()), mesh.get_surface_area()


@pytest.mark.parametrize(("shape", "stretch"), [("ball", (1, 1, 1)), ("slab", (100, 30, 1))])
def test_the_hull_of_a_made_cloud_is_open3ds(device, shape, stretch, rng, oracle, tolerances):
    points = (rng.normal(size=(6000, 3)) * stretch).astype(np.float32).astype(float)
    hull, indices = loom.PointCloud(points, device=device, origin=np.zeros(3)).compute_convex_hull()
    expected, volume, area = oracle(f"pcd/hulls/{shape}", open3d_hull, points)
    np.testing.assert_array_equal(indices, expected)
    np.testing.assert_array_equal(hull.vertices, points[indices])
    assert edge_balance(hull.triangles)
    np.testing.assert_allclose([hull.volume, hull.area], [volume, area], rtol=tolerances.hull_measure)
    assert abs(signed_volume(hull) / hull.volume - 1) < tolerances.hull_measure
    assert_encloses(hull, points, tolerances.hull_outside * np.ptp(points))


@pytest.mark.parametrize("shape", ["ball", "needle", "corner", "lattice"])
def test_the_points_that_kernels_rule_out_are_no_vertices(device, shape, rng):
    """Above the point count at which the filter is used, compared with Qhull on all points."""
    from scipy.spatial import ConvexHull as Qhull

    points = rng.normal(size=(6_001, 3))
    if shape == "ball":
        points /= np.linalg.norm(points, axis=1, keepdims=True)
    elif shape == "needle":
        points *= [100, 0.1, 1e-4]
    elif shape == "corner":  # the center of its box is outside
        points = rng.dirichlet([1, 1, 1, 1], 6_001)[:, :3]
    elif shape == "lattice":
        points = rng.integers(0, 12, (6_001, 3)).astype(float)
    points = points.astype(np.float32).astype(float)
    hull, indices = loom.PointCloud(points, device=device, origin=np.zeros(3)).compute_convex_hull()
    assert rows_of(points[indices]) == rows_of(points[Qhull(points).vertices])
    assert edge_balance(hull.triangles)


def test_the_filter_leaves_few_points(device, rng):
    from pointloom.kernels.extent.hull_filter import scale_points
    from pointloom.pcd.convex_hull import outer_rows

    points = rng.random((50_000, 3))
    cloud = loom.PointCloud(points, device=device)
    left = outer_rows(scale_points(cloud.array("points"), np.full(3, 0.5), np.full(3, 2.0)))
    assert 100 < len(left) < 10_000


@given(
    points=clouds(parts(4, 8), parts(256, 1024), min_size=1, max_size=14), gaps=st.sets(st.integers(0, 13), max_size=3)
)
@examples(25)
def test_hulls_of_small_clouds_enclose_them_by_their_own_points(device, points, gaps):
    points = points.copy()
    points[[g for g in gaps if g < len(points)]] = np.nan
    cloud = loom.PointCloud(points, device=device)
    finite = points[np.isfinite(points).all(axis=1)]
    arms = finite - finite[:1]
    rank = np.linalg.matrix_rank(arms, tol=1e-9) if len(finite) else 0
    if rank < 2:
        with pytest.raises(ValueError, match="points: "):
            cloud.compute_convex_hull()
        return
    hull, indices = cloud.compute_convex_hull()
    np.testing.assert_array_equal(hull.vertices, points[indices])
    assert_encloses(hull, finite, 1e-6)
    if rank == 2:
        assert hull.volume == 0 and hull.area > 0 and edge_balance(hull.triangles)
    else:
        assert abs(signed_volume(hull) - hull.volume) < 1e-6


def test_points_in_a_plane_have_a_flat_hull(device):
    """Open3D raises QH6154."""
    square = np.array([[0, 0, 3], [2, 0, 3], [2, 2, 3], [0, 2, 3], [1, 1, 3], [1, 0, 3]], float)
    for points in (square, square @ ROTATION.T, square[:3]):
        hull, indices = loom.PointCloud(points, device=device, origin=np.zeros(3)).compute_convex_hull()
        corners = min(4, len(points))
        assert indices.tolist() == list(range(corners)) and len(hull.triangles) == 2 * (corners - 2)
        assert hull.volume == 0 and hull.area == pytest.approx(8.0 if corners == 4 else 4.0, rel=1e-6)
        assert edge_balance(hull.triangles)


@pytest.mark.parametrize("count", [100, 8000])
def test_a_flat_hull_of_many_points_is_their_polygon(device, count, rng):
    from scipy.spatial import ConvexHull as Qhull

    flat = rng.normal(size=(count, 2)).astype(np.float32)
    points = np.column_stack([flat, np.full(count, 0.5)])
    hull, indices = loom.PointCloud(points, device=device).compute_convex_hull()
    expected = Qhull(flat.astype(float))
    assert indices.tolist() == sorted(expected.vertices)
    assert hull.area == pytest.approx(2 * expected.volume)
