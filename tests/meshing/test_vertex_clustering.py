"""Vertex clustering: Open3D's vertices and triangles, scale-invariant."""

import numpy as np
import pytest

from pointloom import TriangleMesh

from .open3d_meshes import for_each, one_by_one
from .simplification_scenes import bumpy_torus, open3d_simplified, rms_from

METHOD = "simplify_vertex_clustering"


def assert_it_is_open3ds(mesh: TriangleMesh, voxel_size: float, vertices, triangles) -> None:
    """The same vertices in the same order, and the same triangles in any order."""
    thin = mesh.simplify_vertex_clustering(voxel_size)
    np.testing.assert_allclose(thin.vertices, vertices, rtol=1e-6, atol=1e-6)  # float32 of its float64
    assert len(thin) == len(triangles)
    assert set(map(tuple, thin.triangles.tolist())) == set(map(tuple, triangles.tolist()))


@pytest.mark.parametrize("voxel_size", [0.05, 0.3, 1.0, 10.0])
def test_vertices_and_triangles_match_open3d(device, oracle, voxel_size):
    mesh, name = TriangleMesh(*bumpy_torus(), device=device), f"meshing/clustering/torus_{voxel_size}"
    wanted = oracle(name, open3d_clusters, mesh, voxel_size)
    assert_it_is_open3ds(mesh, voxel_size, *wanted)


def open3d_clusters(o3d, mesh, voxel_size):
    """Triangles in a fixed order: Open3D's order differs between runs."""
    vertices, triangles = open3d_simplified(o3d, mesh, 1.0, METHOD, voxel_size, "Average")
    return vertices, triangles[np.lexsort(triangles.T)]


def test_results_match_open3d_for_any_triangles(oracle):
    scenes = []
    for seed in range(30):
        rng = np.random.default_rng(seed)
        mesh = TriangleMesh(rng.random((12, 3)).astype(np.float32), rng.integers(0, 12, (rng.integers(0, 40), 3)))
        scenes.append((mesh, float(rng.choice([0.2, 0.5, 0.9]))))
    answers = oracle("meshing/clustering/soups", for_each, open3d_clusters, scenes)
    for (mesh, voxel_size), wanted in zip(scenes, one_by_one(answers), strict=True):
        assert_it_is_open3ds(mesh, voxel_size, *wanted)


def test_triangles_keep_the_order_of_first_appearance(device):
    """Each vertex is a separate voxel; the fourth triangle is a rotated copy of the first, the fifth its reverse."""
    corners = np.eye(3)[[0, 1, 2, 0, 1]] * np.array([1, 1, 1, 2, 2])[:, None]
    triangles = [[2, 0, 1], [4, 3, 2], [1, 0, 3], [0, 1, 2], [1, 0, 2], [3, 3, 1]]
    thin = TriangleMesh(corners, triangles, device=device).simplify_vertex_clustering(0.1)
    assert thin.triangles.tolist() == [[0, 1, 2], [2, 4, 3], [0, 3, 1], [0, 2, 1]]
    np.testing.assert_array_equal(thin.vertices, corners)


def test_quadrics_are_at_least_as_accurate_as_those_of_open3d(device, oracle):
    """In a unit where Open3D's threshold has no effect; otherwise its error is 1.7 times as large."""
    mesh = TriangleMesh(*bumpy_torus(60, 36), device=device)
    points = mesh.sample_points_uniformly(5000, seed=1).points
    quadric, mean = (mesh.simplify_vertex_clustering(0.2, way) for way in ("quadric", "average"))
    peer = oracle("meshing/clustering/quadric", open3d_simplified, mesh, 1000.0, METHOD, 200.0, "Quadric")
    np.testing.assert_array_equal(quadric.triangles, mean.triangles)
    assert rms_from(quadric, points) <= 1.02 * rms_from(TriangleMesh(*peer), points)
    assert rms_from(quadric, points) < 0.7 * rms_from(mean, points)


def test_open3ds_kinds_are_accepted(o3d):
    mesh = TriangleMesh(*bumpy_torus())
    for name in ("Average", "Quadric"):
        kind = getattr(o3d.geometry.SimplificationContraction, name)
        result = mesh.simplify_vertex_clustering(0.3, name.lower())
        np.testing.assert_array_equal(mesh.simplify_vertex_clustering(0.3, kind).vertices, result.vertices)


def test_normals_and_colors_are_means(device):
    corners = [[0, 0, 0], [0.1, 0, 0], [2, 0, 0], [0, 2, 0]]
    normals = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 2], [np.nan, 0, 0]])
    colors = np.array([[1, 0, 0], [0, 0.5, 0], [0, 0, 1], [1, 1, 1]])
    mesh = TriangleMesh(
        corners, [[0, 2, 3], [1, 2, 3]], vertex_normals=normals, vertex_colors=colors,
        triangle_uvs=np.zeros((6, 2)), triangle_material_ids=[0, 1], textures=[np.zeros((1, 1, 3), np.uint8)] * 2,
        device=device,
    )  # fmt: skip
    thin = mesh.simplify_vertex_clustering(1)
    assert thin.triangles.tolist() == [[0, 1, 2]]
    np.testing.assert_array_equal(thin.vertex_colors, [[0.5, 0.25, 0], [0, 0, 1], [1, 1, 1]])
    assert thin.vertex_normals is not None
    np.testing.assert_allclose(thin.vertex_normals[:2], [[0.5**0.5, 0.5**0.5, 0], [0, 0, 1]], rtol=1e-7)
    assert np.isnan(thin.vertex_normals[2]).all()
    assert (thin.triangle_uvs, thin.triangle_material_ids, thin.textures) == (None, None, ())


@pytest.mark.parametrize("way", ["average", "quadric"])
def test_meshes_with_at_most_one_triangle(device, way):
    assert len(TriangleMesh(device=device).simplify_vertex_clustering(1, way)) == 0
    one = TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[1, 2, 0]], device=device)
    assert one.simplify_vertex_clustering(0.1, way).triangles.tolist() == [[0, 1, 2]]
    assert len(one.simplify_vertex_clustering(10, way)) == 0
    alone = TriangleMesh([[1, 2, 3]], device=device).simplify_vertex_clustering(0.1, way)
    np.testing.assert_array_equal(alone.vertices, [[1, 2, 3]])
