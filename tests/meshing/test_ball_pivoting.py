"""TriangleMesh.create_from_point_cloud_ball_pivoting: contains Open3D's triangles, manifold, independent of order."""

from collections import Counter

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom
from pointloom.meshing.mesh import mesh_reconstruction

pivot = loom.TriangleMesh.create_from_point_cloud_ball_pivoting
UP = (0.0, 0.0, 1.0)


def jittered(corner, spacing, count, rng):
    """A flat patch of points near grid positions."""
    x, y = np.meshgrid(np.arange(count), np.arange(count), indexing="ij")
    plane = np.stack([x.ravel(), y.ravel()], axis=1) * spacing
    plane = plane + rng.uniform(-0.1, 0.1, plane.shape) * spacing
    return np.c_[plane, np.zeros(len(plane))] + corner


def flat(points, device=None):
    return loom.PointCloud(points, normals=np.tile(UP, (len(points), 1)), device=device)


def sphere(count, rng, device=None, noise=0.0):
    directions = rng.normal(size=(count, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    points = directions * (1 + noise * rng.normal(size=(count, 1)))
    return loom.PointCloud(points, normals=directions, device=device)


def directed_edges(triangles):
    return Counter((t[k], t[(k + 1) % 3]) for t in triangles.tolist() for k in range(3))


def corner_sets(triangles):
    return {tuple(sorted(t)) for t in triangles.tolist()}


def open3d_triangles(o3d, points, normals, radii):
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(points))
    cloud.normals = o3d.utility.Vector3dVector(normals)
    mesh = o3d.geometry.TriangleMesh.create_from_point_cloud_ball_pivoting(cloud, o3d.utility.DoubleVector(radii))
    return np.array(mesh.triangles, np.int32).reshape(-1, 3)


def as_open3d_has_them(cloud):
    return cloud.points.copy(), cloud.normals.astype(float)


def assert_manifold(mesh):
    """No duplicate directed edge: no edge has more than two triangles, and neighbors are consistently oriented."""
    assert max(directed_edges(mesh.triangles).values()) == 1


@pytest.mark.parametrize("noise", [0.0, 0.02, 0.1])
def test_open3ds_triangles_are_included_except_at_shared_edges(device, oracle, rng, noise):
    cloud = sphere(1000, rng, device, noise)
    mesh = pivot(cloud, [0.21])
    theirs = oracle(f"meshing/pivoting/sphere_{noise}", open3d_triangles, *as_open3d_has_them(cloud), [0.21])
    edge_counts = directed_edges(mesh.triangles)
    assert_manifold(mesh)
    missing = corner_sets(theirs) - corner_sets(mesh.triangles)
    for a, b, c in missing:
        assert sum(edge_counts[e] for e in ((a, b), (b, c), (c, a), (b, a), (c, b), (a, c))) > 0
    assert len(missing) <= 0.06 * len(theirs)
    assert len(mesh) >= len(theirs) - len(missing)


@pytest.mark.parametrize("radius", [0.002, 0.003])
def test_the_bunny_has_open3ds_triangles_and_no_more_hole_edges(o3d, real_file, radius):
    path = real_file("reg-bunny-scans/reconstruction/bun_zipper_res2.ply")
    bunny = loom.read_triangle_mesh(path).remove_unreferenced_vertices().compute_vertex_normals()
    cloud = loom.PointCloud(bunny.vertices, normals=bunny.vertex_normals)
    # Open3D's area threshold rejects triangles of 2 mm in meters: use millimeters
    millimeters = loom.PointCloud(bunny.vertices.astype(np.float32) * 1000.0, normals=bunny.vertex_normals)
    mesh = pivot(cloud, [radius])
    theirs = open3d_triangles(o3d, *as_open3d_has_them(millimeters), [radius * 1000])
    edge_counts, others = directed_edges(mesh.triangles), directed_edges(theirs)
    missing = corner_sets(theirs) - corner_sets(mesh.triangles)
    assert_manifold(mesh)
    assert len(mesh) > len(theirs)
    assert len(missing) < 0.005 * len(theirs)
    for a, b, c in missing:
        assert sum(edge_counts[e] for e in ((a, b), (b, c), (c, a), (b, a), (c, b), (a, c))) > 0
    if radius == 0.003:  # a ball of 2 mm falls through
        assert sum((b, a) not in edge_counts for a, b in edge_counts) <= sum((b, a) not in others for a, b in others)


def test_vertices_are_all_points_in_order(device, rng):
    cloud = sphere(200, rng, device)
    cloud.colors = rng.random((200, 3))
    mesh = pivot(cloud, 0.1)  # the majority has no triangle
    np.testing.assert_array_equal(mesh.vertices, cloud.points)
    np.testing.assert_array_equal(mesh.vertex_normals, cloud.normals)
    np.testing.assert_array_equal(mesh.vertex_colors, cloud.colors)


@pytest.mark.parametrize("radii", [[1.2, 3.6], [3.6, 1.2], [3.6]])
def test_a_patch_that_only_the_large_ball_can_cover_is_covered(device, rng, radii):
    fine, coarse = jittered([0, 0, 0], 1.0, 20, rng), jittered([100, 0, 0], 3.0, 20, rng)
    mesh = pivot(flat(np.r_[fine, coarse], device), radii)
    triangles = mesh.triangles
    assert_manifold(mesh)
    assert (triangles >= 400).all(axis=1).sum() == 722
    assert (triangles < 400).all(axis=1).sum() >= 722


@settings(max_examples=15, deadline=None)
@given(st.integers(0, 2**31), st.lists(st.sampled_from([0.1, 0.2, 0.4, 1.0]), min_size=1, max_size=3))
def test_any_cloud_and_radii_give_a_manifold_that_faces_the_normals(seed, radii):
    rng = np.random.default_rng(seed)
    points = rng.random((120, 3)) * [1, 1, rng.choice([0.02, 0.2, 1.0])]
    points[::7] = points[3]  # some coincident
    normals = rng.normal(size=(120, 3)) * 0.5 + UP
    mesh = pivot(loom.PointCloud(points, normals=normals), radii)
    triangles = mesh.triangles
    if len(triangles):
        assert_manifold(mesh)
        assert mesh.is_edge_manifold()
        facing = (mesh.compute_triangle_normals()[:, None] * normals[triangles]).sum(axis=2)
        assert (facing > -1e-6).all()  # of unit normals rounded to float32
        assert not set(triangles.ravel().tolist()) & set(range(7, 120, 7))


@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e6])
def test_radii_from_the_spacing_close_a_sphere_of_any_size(device, rng, scale):
    cloud = sphere(2000, rng)
    mesh = pivot(loom.PointCloud(cloud.points * scale, normals=cloud.normals, device=device))
    edges = directed_edges(mesh.triangles)
    assert len(mesh) > 3980  # of 3,996
    assert sum((b, a) not in edges for a, b in edges) < 20


def test_radii_double_until_the_majority_has_a_neighbor(device, rng):
    near, far = jittered([0, 0, 0], 1.0, 20, rng), jittered([1000, 0, 0], 16.0, 10, rng)
    triangles = pivot(flat(np.r_[near, far], device)).triangles
    assert (triangles >= 400).all(axis=1).sum() >= 150  # of 162


def test_triangles_do_not_depend_on_point_order(device, rng):
    cloud = sphere(1500, rng, noise=0.03)
    order = rng.permutation(1500)
    mixed = loom.PointCloud(cloud.points[order], normals=cloud.normals[order], device=device)
    expected = corner_sets(pivot(cloud.to(device), [0.1, 0.2]).triangles)
    assert corner_sets(order[pivot(mixed, [0.1, 0.2]).triangles]) == expected


def test_points_without_finite_position_or_normal_are_ignored(device, rng):
    points, normals = jittered([0, 0, 0], 1.0, 12, rng), np.tile(UP, (144, 1))
    points[10], points[77, 1] = np.nan, np.inf
    normals[30], normals[50, 0], normals[99, 2] = 0, np.nan, np.inf
    out = [10, 77, 30, 50, 99]
    mesh = pivot(loom.PointCloud(points, normals=normals, device=device), [1.2, 2.0])
    rest = np.setdiff1d(np.arange(144), out)
    alone = pivot(flat(points[rest], device), [1.2, 2.0])
    assert not set(mesh.triangles.ravel().tolist()) & set(out)
    np.testing.assert_array_equal(mesh.triangles, rest[alone.triangles])
    assert len(mesh.vertices) == 144


SETS = {
    "none": np.zeros((0, 3)),
    "one": np.ones((1, 3)),
    "two": np.array([[0.0, 0, 0], [1, 0, 0]]),
    "equal": np.ones((50, 3)),
    "in line": np.outer(np.arange(40), [1.0, 2, -1]),
    "all NaN": np.full((5, 3), np.nan),
}


@pytest.mark.parametrize("points", SETS.values(), ids=SETS)
def test_points_without_a_triangle_give_an_empty_mesh(device, points):
    for radii in (None, 1.0, [1.0, 5.0, 2.0]):
        mesh = pivot(flat(points, device), radii)
        assert len(mesh) == 0
        np.testing.assert_array_equal(mesh.vertices, points)


def test_too_small_or_too_large_balls_are_no_error(device, rng):
    cloud = flat(jittered([0, 0, 0], 1.0, 8, rng), device)
    for radius in (1e-300, 5e-324):
        with pytest.warns(loom.UnitWarning, match=r"^radii:"):
            assert len(pivot(cloud, radius)) == 0
    assert len(pivot(cloud, 0.3)) == 0
    assert 98 <= len(pivot(cloud, 5e4)) <= 98 + 28  # including slivers of the hull's boundary


def test_invalid_radii_are_rejected_by_name(rng):
    wrong = {ValueError: ([], 0.0, [0.1, -1.0], np.nan, [np.inf], 1e9), TypeError: ("0.1", ["0.1"], True, object())}
    for error, radii in [(error, radii) for error, many in wrong.items() for radii in many]:
        with pytest.raises(error, match=r"^radii: "):
            pivot(sphere(50, rng), radii)


def test_a_search_of_hours_is_rejected_with_its_size(rng, monkeypatch):
    monkeypatch.setattr(mesh_reconstruction, "MAX_NEIGHBORS", 50_000)
    cloud = sphere(1000, rng)
    assert len(pivot(cloud, 0.1)) > 0
    with pytest.raises(ValueError, match="radii:"):
        pivot(cloud, 5.0)
