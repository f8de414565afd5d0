"""Connected components of a mesh: Open3D's labels, counts and areas; removal of small ones."""

import numpy as np
import pytest

from pointloom import TriangleMesh

from .mesh_soups import fixed_soups
from .open3d_meshes import for_each, in_open3d, one_by_one

# Two squares and a separate triangle; the squares share a vertex.
CORNERS = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 1, 0], [2, 2, 0], [1, 2, 0], [5, 5, 5], [6, 5, 5], [5, 8, 5]]
PARTS = [[2, 4, 5], [7, 8, 9], [0, 1, 2], [2, 5, 6], [3, 0, 2]]


def open3d_parts(o3d, mesh):
    labels, counts, areas = in_open3d(o3d, mesh).cluster_connected_triangles()
    return np.array(labels, np.int32), np.array(counts, np.int32), np.array(areas)


def assert_parts_are(mesh: TriangleMesh, wanted) -> None:
    labels, counts, areas = mesh.cluster_connected_triangles()
    np.testing.assert_array_equal(labels, wanted[0])
    np.testing.assert_array_equal(counts, wanted[1])
    np.testing.assert_allclose(areas, wanted[2], rtol=1e-12)


def test_components_match_open3d(device, oracle):
    ball = TriangleMesh.create_sphere(1.0, 20)
    triangles = np.random.default_rng(0).permutation(ball.triangles)[: int(0.45 * len(ball))]
    mesh = TriangleMesh(ball.vertices, triangles, device=device)
    wanted = oracle("meshing/components/ball", open3d_parts, mesh)
    assert len(wanted[1]) > 60
    assert_parts_are(mesh, wanted)


def test_components_match_open3d_for_any_triangles(oracle):
    """Includes edges of three triangles, triangles with coincident corners, and duplicate triangles."""
    soups = [mesh for mesh in fixed_soups() if len(mesh)]
    answers = oracle("meshing/components/soups", for_each, open3d_parts, [(mesh,) for mesh in soups])
    for mesh, wanted in zip(soups, one_by_one(answers), strict=True):
        assert_parts_are(mesh, wanted)


def test_components_that_share_only_a_vertex_are_separate(device):
    labels, counts, areas = TriangleMesh(CORNERS, PARTS, device=device).cluster_connected_triangles()
    assert labels.dtype == np.int32 and labels.tolist() == [0, 1, 2, 0, 2]
    assert (counts.tolist(), areas.tolist()) == ([2, 1, 2], [1.0, 1.5, 1.0])


def test_a_mesh_without_triangles_has_no_components(device):
    for mesh in (TriangleMesh(device=device), TriangleMesh([[0, 0, 0]], device=device)):
        assert [len(values) for values in mesh.cluster_connected_triangles()] == [0, 0, 0]
        assert len(mesh.remove_small_components(min_triangles=5)) == 0


@pytest.mark.parametrize(
    ("limits", "selected"),
    [
        ({}, [0, 1, 2, 3, 4]),
        ({"min_triangles": 2}, [0, 2, 3, 4]),
        ({"min_triangles": 3}, []),
        ({"min_area": 1.0}, [0, 1, 2, 3, 4]),
        ({"min_area": 1.01}, [1]),
        ({"min_triangles": 2, "min_area": 1.2}, []),
    ],
)
def test_small_parts_go_with_their_vertices(device, limits, selected):
    colors = np.random.default_rng(0).random((len(CORNERS), 3)).astype(np.float32)
    mesh = TriangleMesh(CORNERS, PARTS, vertex_colors=colors, device=device)
    left = mesh.remove_small_components(**limits)
    triangles = np.array(PARTS)[selected].reshape(-1, 3)
    used = np.unique(triangles)
    np.testing.assert_array_equal(left.triangles, np.searchsorted(used, triangles))
    np.testing.assert_array_equal(left.vertices, np.array(CORNERS)[used])
    np.testing.assert_array_equal(left.vertex_colors, colors[used])
