"""Alpha shapes of clouds: Open3D's faces in general position, closed and unique results for ties, bad input."""

import math
from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom
from pointloom import PointCloud, TriangleMesh

from .test_ball_pivoting import directed_edges

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
    assert len(mesh) == 17234
    assert faces_of_cloud(mesh, points) == face_set(open3d_faces(o3d, points, 6.0))


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
    "no points": np.zeros((0, 3)),
    "a point": np.ones((1, 3)),
    "two": grid(2, 1, 1),
    "three": grid(3, 1, 1) ** [2, 1, 1],
    "equal points": np.full((9, 3), 0.1),
    "a line": np.outer(np.arange(20.0), [1, 2, 3]),
    "a plane": grid(6, 6, 1),
    "no finite points": np.full((5, 3), np.nan),
}


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


@pytest.mark.parametrize("alpha", [0, -1, math.nan, -math.inf, [], [1.0, -1.0], "wide", "0.1"])
def test_an_alpha_out_of_range_is_rejected(alpha):
    with pytest.raises(ValueError, match=r"^alpha:"):
        alpha_shape(PointCloud(grid(2, 2, 2)), alpha)
