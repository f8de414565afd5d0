"""Ball pivoting and alpha shapes: Open3D's triangles, manifold or closed, independent of order, bad input."""

import math
from collections import Counter
from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom
from pointloom import PointCloud, TriangleMesh
from pointloom.meshing.mesh import reconstruction

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


def missing_from(mesh, theirs):
    """Open3D's triangles that a manifold mesh lacks; it has one of the edges of each."""
    assert_manifold(mesh)
    edges, missing = directed_edges(mesh.triangles), corner_sets(theirs) - corner_sets(mesh.triangles)
    for a, b, c in missing:
        assert sum(edges[e] for e in ((a, b), (b, c), (c, a), (b, a), (c, b), (a, c))) > 0
    return missing


@pytest.mark.parametrize("noise", [0.0, 0.02, 0.1])
def test_open3ds_triangles_are_included_except_at_shared_edges(device, oracle, rng, noise):
    cloud = sphere(1000, rng, device, noise)
    mesh = pivot(cloud, [0.21])
    theirs = oracle(f"meshing/pivoting/sphere_{noise}", open3d_triangles, *as_open3d_has_them(cloud), [0.21])
    missing = missing_from(mesh, theirs)
    assert len(missing) <= 0.06 * len(theirs) and len(mesh) >= len(theirs) - len(missing)


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
    assert len(mesh) > len(theirs) and len(missing_from(mesh, theirs)) < 0.005 * len(theirs)
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
    assert (triangles >= 400).all(axis=1).sum() == 722 and (triangles < 400).all(axis=1).sum() >= 722


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
    "none": np.zeros((0, 3)), "one": np.ones((1, 3)), "two": np.array([[0.0, 0, 0], [1, 0, 0]]),
    "equal": np.ones((50, 3)), "in line": np.outer(np.arange(40), [1.0, 2, -1]), "all NaN": np.full((5, 3), np.nan),
}  # fmt: skip


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


def test_a_search_of_hours_is_rejected_with_its_size(rng, monkeypatch):
    monkeypatch.setattr(reconstruction, "MAX_NEIGHBORS", 50_000)
    cloud = sphere(1000, rng)
    assert len(pivot(cloud, 0.1)) > 0
    with pytest.raises(ValueError, match="radii:"):
        pivot(cloud, 5.0)


FAR = np.array([5.0e5, 5.4e6, 100.0])
alpha_shape = TriangleMesh.create_from_point_cloud_alpha_shape


def grid(*sizes: int) -> np.ndarray:
    return np.array(list(product(*map(range, sizes))), float)


def face_set(faces) -> set[tuple[int, ...]]:
    return {tuple(sorted(face)) for face in np.asarray(faces).tolist()}


def faces_of_cloud(mesh: TriangleMesh, points: np.ndarray) -> set[tuple[int, ...]]:
    """A mesh's triangles as point indices, matched by float32 coordinates relative to the mesh's origin."""
    rows = {tuple(p): i for i, p in reversed(list(enumerate((points - mesh.origin).astype(np.float32).tolist())))}
    indices = [rows[tuple(p)] for p in (mesh.vertices - mesh.origin).astype(np.float32).tolist()]
    return face_set(np.array(indices)[mesh.triangles])


def open3d_faces(o3d, points: np.ndarray, alpha: float) -> np.ndarray:
    """Triangles as sorted point indices."""
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(np.asarray(points, np.float64)))
    mesh = o3d.geometry.TriangleMesh.create_from_point_cloud_alpha_shape(cloud, alpha)
    rows = {tuple(p): i for i, p in enumerate(np.asarray(points, np.float64).tolist())}
    indices = np.array([rows[tuple(p)] for p in np.asarray(mesh.vertices).tolist()])
    return np.unique(np.sort(indices[np.asarray(mesh.triangles)], axis=1), axis=0).astype(np.int32)


@pytest.mark.parametrize("alpha", [0.3, 0.6, 5.0])
def test_the_faces_match_open3d(device, oracle, rng, alpha):
    points = rng.normal(size=(200, 3))
    points *= (1 + 0.1 * rng.random(200) / np.linalg.norm(points, axis=1))[:, None]
    points = points.astype(np.float32).astype(np.float64)
    mesh = alpha_shape(PointCloud(points, device=device), alpha)
    theirs = oracle(f"meshing/alpha_shape/ball_{alpha}", open3d_faces, points, alpha)
    assert faces_of_cloud(mesh, points) == face_set(theirs)


@pytest.mark.slow
@pytest.mark.slow_on_emulated_cuda("8,171 stars")
def test_full_bunny_has_the_faces_of_open3d(device, o3d, real_file):
    path = real_file("reg-bunny-scans/reconstruction/bun_zipper_res2.ply")
    points = np.unique((loom.read_point_cloud(path).points * 1000).astype(np.float32), axis=0).astype(np.float64)
    mesh = alpha_shape(PointCloud(points, device=device), 6.0)
    assert len(mesh) == 17234 and faces_of_cloud(mesh, points) == face_set(open3d_faces(o3d, points, 6.0))


def test_the_hull_is_that_of_the_convex_hull(device, rng):
    cloud = PointCloud(rng.random((200, 3)), device=device)
    hull, rows = cloud.compute_convex_hull()
    mesh, _, point_map = alpha_shape(cloud, math.inf, return_tetrahedra=True)
    np.testing.assert_array_equal(point_map, rows)
    assert face_set(mesh.triangles) == face_set(hull.triangles)
    assert mesh.get_volume() == pytest.approx(hull.volume, rel=1e-6)  # of float32 coordinates
    for alpha in (1e9, 1e300):
        np.testing.assert_array_equal(alpha_shape(cloud, alpha).triangles, mesh.triangles)


@pytest.mark.parametrize(
    ("sizes", "offset"), [((2, 2, 2), 0), ((3, 2, 2), FAR), ((4, 3, 2), 0), ((5, 5, 5), FAR), ((8, 8, 8), 0)]
)
def test_a_grid_gives_one_closed_box(device, sizes, offset):
    mesh = alpha_shape(PointCloud(grid(*sizes) + offset, device=device), 0.9)
    a, b, c = (size - 1 for size in sizes)
    assert len(mesh) == 4 * (a * b + b * c + c * a)
    assert mesh.is_edge_manifold(allow_boundary_edges=False) and mesh.is_watertight()
    assert mesh.get_volume() == pytest.approx(a * b * c, rel=1e-6)


@pytest.mark.filterwarnings("ignore:cloud. .* no alpha gives a surface")  # of points in one plane
@settings(max_examples=25, deadline=None)
@given(st.sets(st.tuples(*[st.integers(0, 3)] * 3), min_size=4, max_size=40), st.sampled_from([0.9, 1.3, 2.0, 50.0]))
def test_grid_remainders_are_closed_in_any_order(chosen, alpha):
    points = np.array(sorted(chosen), float)
    for order in (points, np.random.default_rng(len(points)).permutation(points)):
        mesh, tetrahedra, _ = alpha_shape(PointCloud(order), alpha, return_tetrahedra=True)
        edges = directed_edges(mesh.triangles)
        assert edges == {(b, a): count for (a, b), count in edges.items()}  # closed
        corners = order[tetrahedra]
        volumes = np.linalg.det(corners[:, 1:] - corners[:, :1]) / 6
        assert (volumes > 0.1).all()  # no flat ones; the smallest in a grid is a sixth
        assert np.linalg.det(mesh.vertices[mesh.triangles]).sum() / 6 == pytest.approx(volumes.sum(), abs=1e-9)


def test_non_finite_and_duplicate_points_are_excluded(device, rng):
    points = rng.random((100, 3))
    points[7] = np.nan
    points[50], points[60] = points[20], points[20]
    points[70] = np.inf
    mesh, tetrahedra, point_map = alpha_shape(PointCloud(points, device=device), 0.4, return_tetrahedra=True)
    assert not {7, 50, 60, 70} & set(tetrahedra.ravel().tolist()) and 20 in tetrahedra
    clean = np.delete(points, [7, 50, 60, 70], axis=0)
    remaining = np.delete(np.arange(100), [7, 50, 60, 70])
    other, more, rows = alpha_shape(PointCloud(clean, device=device), 0.4, return_tetrahedra=True)
    np.testing.assert_array_equal(mesh.triangles, other.triangles)
    np.testing.assert_array_equal(tetrahedra, remaining[more])
    np.testing.assert_array_equal(point_map, remaining[rows])


def test_normals_and_colors_are_copied_and_vertices_keep_their_order(device, rng):
    points, normals, colors = rng.random((3, 150, 3)).astype(np.float32)
    cloud = PointCloud(points, normals=normals, colors=colors, device=device)
    mesh, _, point_map = alpha_shape(cloud, 0.3, return_tetrahedra=True)
    assert (np.diff(point_map) > 0).all() and len(point_map) == len(mesh.vertices) < 150
    np.testing.assert_array_equal(mesh.vertices, cloud.points[point_map])
    np.testing.assert_array_equal(mesh.vertex_normals, normals[point_map])
    np.testing.assert_array_equal(mesh.vertex_colors, colors[point_map])
    assert set(mesh.triangles.ravel().tolist()) == set(range(len(point_map)))
    assert alpha_shape(PointCloud(points, device=device), 0.3).vertex_normals is None


def test_several_alphas_give_shapes_in_the_given_order(device, rng):
    cloud = PointCloud(rng.random((150, 3)), device=device)
    alphas = [0.3, 0.2, 5.0, 0.3]
    for mesh, alpha in zip(alpha_shape(cloud, alphas), alphas, strict=True):
        alone = alpha_shape(cloud, alpha)
        np.testing.assert_array_equal(mesh.triangles, alone.triangles)
        np.testing.assert_array_equal(mesh.vertices, alone.vertices)
    assert isinstance(alpha_shape(cloud, np.array([0.3])), list)
    (mesh, tetrahedra, _), _ = alpha_shape(cloud, (0.3, 0.2), return_tetrahedra=True)
    assert tetrahedra.shape[1] == 4 and len(mesh) == len(alpha_shape(cloud, 0.3))


def test_auto_gives_one_closed_shape_for_an_even_surface(device):
    i = np.arange(500) + 0.5  # a Fibonacci ball
    z, angle = 1 - i / 250, i * 2.399963
    ball = np.column_stack([np.sqrt(1 - z * z) * np.cos(angle), np.sqrt(1 - z * z) * np.sin(angle), z])
    mesh = alpha_shape(PointCloud(ball, device=device))
    assert len(mesh.vertices) == 500 and len(mesh) == 996 and mesh.is_watertight()  # a ball, by Euler


FLAT = {
    "no points": np.zeros((0, 3)), "a point": np.ones((1, 3)), "two": grid(2, 1, 1),
    "equal points": np.full((9, 3), 0.1), "a line": np.outer(np.arange(20.0), [1, 2, 3]), "a plane": grid(6, 6, 1),
    "no finite points": np.full((5, 3), np.nan), "three": grid(3, 1, 1) ** [2, 1, 1],
}  # fmt: skip


@pytest.mark.parametrize("name", FLAT)
def test_points_without_a_tetrahedron_give_an_empty_mesh_and_the_reason(device, name):
    reason = "one plane" if name == "a plane" else "one line" if name == "a line" else "distinct finite points, fewer"
    for alpha in (1.0, "auto", math.inf):
        with pytest.warns(UserWarning, match=f"cloud: .*{reason}.*so no alpha gives a surface"):
            result = alpha_shape(PointCloud(FLAT[name], device=device), alpha, return_tetrahedra=True)
        assert len(result[0].vertices) == 0 and [len(part) for part in result] == [0, 0, 0]


def test_a_too_small_alpha_gives_an_empty_mesh(device, rng):
    cloud = PointCloud(rng.random((50, 3)), device=device)
    with pytest.warns(loom.UnitWarning, match=r"^alpha:.*1e-05.*1e-09.*4"):
        assert [len(mesh) > 0 for mesh in alpha_shape(cloud, [1e-5, 0.5, 1e-9, 5e-324])] == [False, True, False, False]
