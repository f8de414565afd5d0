"""Convex hulls and hidden points: Open3D's, brute force on small clouds, and degenerate clouds and views."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial import ConvexHull as Qhull

import pointloom as loom
from pointloom.kernels.extent.hull_filter import scale_points
from pointloom.kernels.extent.visibility import visible_rows
from pointloom.pcd.convex_hull import outer_rows

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
    points = rng.random((50_000, 3))
    cloud = loom.PointCloud(points, device=device)
    left = outer_rows(scale_points(cloud.arrays["points"], np.full(3, 0.5), np.full(3, 2.0)))
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


@pytest.mark.parametrize("shift", [0.0, 1000.0, 5e5])
@pytest.mark.parametrize("shape", ["ball", "sphere", "thin", "duplicates", "tetrahedron", "grid"])
def test_small_bodies_have_the_hull_of_qhull(device, shape, shift, rng):
    """Bodies whose facets are triangles, and one whose facets are squares."""
    points = rng.standard_normal((300, 3))
    if shape == "sphere":
        points /= np.linalg.norm(points, axis=1)[:, None]
    elif shape == "thin":
        points *= (1.0, 1.0, 1e-3)
    elif shape == "duplicates":
        points = np.repeat(points, 3, axis=0)
    elif shape == "tetrahedron":
        points = points[:4]
    elif shape == "grid":
        points = np.stack(np.meshgrid(*[np.arange(5.0)] * 3), axis=-1).reshape(-1, 3)
    cloud = loom.PointCloud(points + shift, device=device)
    hull, rows = cloud.compute_convex_hull()
    positions = cloud.points.astype(np.float64)
    expected = Qhull(positions - shift, qhull_options="Qt")
    assert np.array_equal(hull.vertices, positions[rows])
    assert set(map(tuple, hull.vertices)) == set(map(tuple, positions[expected.vertices]))
    assert hull.volume == pytest.approx(expected.volume, rel=1e-9)
    assert hull.area == pytest.approx(expected.area, rel=1e-9)
    a, b, c = (hull.vertices[hull.triangles[:, k]] - hull.vertices.mean(axis=0) for k in range(3))
    assert (np.einsum("ij,ij->i", a, np.cross(b, c)) > 0).all(), "triangles face inwards"


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
    flat = rng.normal(size=(count, 2)).astype(np.float32)
    points = np.column_stack([flat, np.full(count, 0.5)])
    hull, indices = loom.PointCloud(points, device=device).compute_convex_hull()
    expected = Qhull(flat.astype(float))
    assert indices.tolist() == sorted(expected.vertices)
    assert hull.area == pytest.approx(2 * expected.volume)


def visible_by_brute_force(points, camera, radius):
    """Positions of the visible points by Qhull on all mirrored points in float64."""
    arms = points - camera
    sizes = np.linalg.norm(arms, axis=1, keepdims=True)
    mirrored = np.concatenate([arms * (2 * radius - sizes) / sizes, np.zeros((1, 3))])
    hull_rows = Qhull(mirrored).vertices
    return rows_of(points[hull_rows[hull_rows < len(points)]])


def visible(points, camera, radius, device):
    cloud = loom.PointCloud(points, device=device, origin=np.zeros(3))
    surface, indices = cloud.hidden_point_removal(camera, radius)
    assert (np.diff(indices) > 0).all()
    np.testing.assert_array_equal(surface.vertices, cloud.points[indices])
    return surface, rows_of(cloud.points[indices])


def open3d_views(o3d, points, views):
    """The visible rows and the number of triangles of each view."""
    results = [cloud_of(o3d, points).hidden_point_removal(camera, radius) for camera, radius in views]
    return [(np.sort(indices).astype(np.int16), len(mesh.triangles)) for mesh, indices in results]


def test_the_visible_points_of_a_made_scan_are_open3ds(device, rng, oracle):
    """A hilly surface, seen from its center, from the side and from an airplane."""
    xy = rng.random((6000, 2)) * 40 - 20
    heights = 2 * np.sin(xy[:, 0] / 3) * np.cos(xy[:, 1] / 4)
    points = np.column_stack([xy, heights]).astype(np.float32).astype(float)
    views = [(np.array([0.0, 0, 3]), 6e3), (np.array([10.0, -40, 5]), 6e4), (np.array([0, 0, 1e3]), 5e4)]
    expected = oracle("pcd/visibility/hills", open3d_views, points, views)
    for (camera, radius), (rows, triangles) in zip(views, expected, strict=True):
        surface, result = visible(points, camera, radius, device)
        assert result == rows_of(points[rows])
        assert abs(len(surface.triangles) - triangles) <= 0.001 * triangles


SCENES = [("noise", 0.45), ("noise", 100.0), ("two walls", 100.0), ("all around", 1.5), ("grazing", 1e5)]
SCENES += [("lattice", 100.0)]


@pytest.mark.parametrize(("scene", "scale"), SCENES)
def test_the_points_that_kernels_rule_out_are_hidden(device, scene, scale, rng):
    """Above the point count at which the filter is used, compared with Qhull on all points."""
    points, camera = rng.random((6001, 3)), np.array([0.3, 0.4, 3.0])
    if scene == "two walls":
        points[:, 2] = rng.integers(0, 2, 6001) * 0.5
    elif scene == "all around":
        points = rng.normal(size=(6001, 3))
        points *= rng.uniform(1, 1.2, (6001, 1)) / np.linalg.norm(points, axis=1, keepdims=True)
        camera = np.array([0.1, 0, 0])
    elif scene == "grazing":
        points[:, 2] *= 0.01
        camera = np.array([2.0, 0.5, 0.05])
    elif scene == "lattice":
        points = rng.integers(0, 20, (6001, 3)) / 16.0
    points = points.astype(np.float32).astype(float)
    radius = scale * np.linalg.norm(points - camera, axis=1).max()
    _, result = visible(points, camera, radius, device)
    assert result == visible_by_brute_force(points, camera, radius)


def test_filter_removes_the_bulk_of_hidden_points(device, rng):
    points = rng.random((40_000, 3))
    points[:, 2] = np.where(rng.random(40_000) < 0.5, 0, -1)
    cloud = loom.PointCloud(points, device=device)
    rows, _ = visible_rows(cloud.arrays["points"], cloud.origin - np.array([0.5, 0.5, 3]), 400.0)
    assert 15_000 < rows.size < 25_000


@given(points=clouds(parts(2, 2), parts(256, 1024), max_size=14), gap=st.integers(0, 20))
@examples(25)
def test_small_clouds_are_seen_as_by_brute_force(device, points, gap):
    camera, radius = np.array([0.3, 0.2, 6.0]), 50.0
    arms = points - camera
    cloud = points.copy()
    if gap < len(points):
        cloud[gap] = np.nan
    finite = points[np.isfinite(cloud).all(axis=1)]
    _, result = visible(cloud, camera, radius, device)
    assert result <= rows_of(finite) and bool(result) == bool(len(finite))
    if len(finite) > 3 and np.linalg.svd(arms[np.isfinite(cloud).all(axis=1)], compute_uv=False)[2] > 0.1:
        assert result == visible_by_brute_force(finite, camera, radius)


def test_triangles_face_the_camera(device, rng):
    points = rng.normal(size=(6000, 3))
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    camera = np.array([1.0, 2.0, 4.0])
    surface, _ = visible(points.astype(np.float32), camera, 500.0, device)
    a, b, c = (surface.vertices[surface.triangles[:, k]] for k in range(3))
    assert (np.einsum("ij,ij->i", np.cross(b - a, c - a), camera - a) > 0).mean() > 0.99
    assert len(loom.TriangleMesh(surface.vertices, surface.triangles).triangles) == len(surface.triangles)


def test_a_view_in_one_plane_sees_the_nearest(device):
    """Open3D raises QH6154 there, and QH6214 for one or two points."""
    camera = np.array([0.0, 0, 3])
    fan = np.array([[x, 0, z] for x in (-1, 0, 1) for z in (0, -20)], float)
    assert visible(fan, camera, 100, device)[1] == rows_of(fan[::2])
    assert visible(fan[:1], camera, 100, device)[1] == rows_of(fan[:1])
    assert visible(fan[2:4], camera, 100, device)[1] == rows_of(fan[2:3]), "one hides the other"
    assert visible(fan[:3], camera, 100, device)[1] == rows_of(fan[[0, 2]])


def test_no_point_and_a_point_at_the_camera_are_not_seen(device, rng):
    for points in (np.zeros((0, 3)), np.full((3, 3), np.nan), [[1, 2, 3]]):
        surface, indices = loom.PointCloud(points, device=device).hidden_point_removal([1, 2, 3], 10)
        assert len(indices) == len(surface.vertices) == len(surface.triangles) == 0
    points = rng.random((6000, 3)).astype(np.float32).astype(float)
    camera = points[17]
    result = visible(points, camera, 50.0, device)[1]
    assert tuple(camera) not in result
    assert result == visible_by_brute_force(np.delete(points, 17, axis=0), camera, 50.0)


@pytest.mark.parametrize("joggle", [False, True])
def test_joggled_inputs_keep_points_inside_facets(device, joggle):
    """Of 27 points of a cube of 2 m, all but the middle one may be vertices if facets are not merged."""
    grid = np.stack(np.meshgrid(*[np.arange(3.0)] * 3), -1).reshape(-1, 3)
    for shape in (loom.PointCloud(grid, device=device), loom.TriangleMesh(grid, [[0, 1, 3]], device=device)):
        _, rows = shape.compute_convex_hull(joggle_inputs=joggle)
        assert 8 < len(rows) <= 26 if joggle else len(rows) == 8
        assert {0, 2, 6, 8, 18, 20, 24, 26} <= set(np.asarray(rows).tolist())
