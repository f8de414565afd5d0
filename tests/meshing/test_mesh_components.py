"""The parts of a mesh: Open3D's labels, counts and areas; the small ones dropped."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom import TriangleMesh
from pointloom.kernels.lang import cpu_compiler

# Two squares, and a triangle apart; the squares share a vertex.
CORNERS = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 1, 0], [2, 2, 0], [1, 2, 0], [5, 5, 5], [6, 5, 5], [5, 8, 5]]
PARTS = [[2, 4, 5], [7, 8, 9], [0, 1, 2], [2, 5, 6], [3, 0, 2]]


def in_open3d(mesh: TriangleMesh):
    o3d = pytest.importorskip("open3d", exc_type=ImportError)
    vertices, triangles = mesh.vertices.copy(), mesh.triangles.copy()
    return o3d.geometry.TriangleMesh(o3d.utility.Vector3dVector(vertices), o3d.utility.Vector3iVector(triangles))


def assert_parts_are_those_of_open3d(mesh: TriangleMesh) -> None:
    labels, counts, areas = mesh.cluster_connected_triangles()
    wanted = [np.asarray(values) for values in in_open3d(mesh).cluster_connected_triangles()]
    np.testing.assert_array_equal(labels, wanted[0])
    np.testing.assert_array_equal(counts, wanted[1])
    np.testing.assert_allclose(areas, wanted[2], rtol=1e-12)


def test_parts_are_those_of_open3d(device):
    rng = np.random.default_rng(0)
    o3d = pytest.importorskip("open3d", exc_type=ImportError)
    peer = o3d.geometry.TriangleMesh.create_sphere(1.0, resolution=30)
    triangles = rng.permutation(np.asarray(peer.triangles))[: int(0.45 * len(peer.triangles))]  # some 200 parts
    mesh = TriangleMesh(np.asarray(peer.vertices), triangles, device=device)
    assert len(mesh.cluster_connected_triangles()[1]) > 100
    assert_parts_are_those_of_open3d(mesh)


@settings(deadline=None, max_examples=60)
@given(st.lists(st.tuples(*[st.integers(0, 7)] * 3), min_size=1, max_size=12))
def test_parts_are_those_of_open3d_whatever_the_triangles(triangles):
    """Among them edges of three triangles, triangles of one corner, and the same triangle twice."""
    with cpu_compiler("warp"):
        mesh = TriangleMesh(np.random.default_rng(0).normal(size=(8, 3)), triangles)
        assert_parts_are_those_of_open3d(mesh)


def test_parts_that_share_but_a_vertex_are_two(device):
    labels, counts, areas = TriangleMesh(CORNERS, PARTS, device=device).cluster_connected_triangles()
    assert labels.dtype == np.int32 and labels.tolist() == [0, 1, 2, 0, 2]
    assert (counts.tolist(), areas.tolist()) == ([2, 1, 2], [1.0, 1.5, 1.0])


def test_a_mesh_without_triangles_has_no_parts(device):
    for mesh in (TriangleMesh(device=device), TriangleMesh([[0, 0, 0]], device=device)):
        assert [len(values) for values in mesh.cluster_connected_triangles()] == [0, 0, 0]
        assert len(mesh.remove_small_components(min_triangles=5)) == 0


def test_triangles_that_are_not_finite_have_no_area(device):
    mesh = TriangleMesh([*CORNERS, [np.nan, 0, 0]], [*PARTS, [7, 8, 10]], device=device)
    _, counts, areas = mesh.cluster_connected_triangles()
    assert (counts.tolist(), areas.tolist()) == ([2, 2, 2], [1.0, 1.5, 1.0])


def test_parts_far_from_zero_have_the_areas_of_those_near_it(device):
    mesh = TriangleMesh(np.add(CORNERS, [5.0e5, 5.4e6, 100.0]), PARTS, device=device)
    assert mesh.cluster_connected_triangles()[2].tolist() == [1.0, 1.5, 1.0]


def test_areas_of_large_parts_are_summed_in_one_order_everywhere(device):
    rng = np.random.default_rng(2)
    count = 5000
    corners = np.cumsum(rng.random((count + 2, 3)), axis=0).astype(np.float32)
    strip = np.arange(count)[:, None] + [0, 1, 2]
    (area,) = TriangleMesh(corners, strip, device=device, origin=[0, 0, 0]).cluster_connected_triangles()[2]
    a, b, c = (corners[strip[:, k]].astype(float) for k in range(3))
    u, v = b - a, c - a
    cross = u[:, [1, 2, 0]] * v[:, [2, 0, 1]] - u[:, [2, 0, 1]] * v[:, [1, 2, 0]]
    twice = np.sqrt(cross[:, 0] * cross[:, 0] + cross[:, 1] * cross[:, 1] + cross[:, 2] * cross[:, 2])
    total = 0.0
    for first in range(0, count, 1024):
        total += np.cumsum(twice[first : first + 1024])[-1]
    assert area == total / 2


@pytest.mark.parametrize(
    ("limits", "kept"),
    [
        ({}, [0, 1, 2, 3, 4]),
        ({"min_triangles": 2}, [0, 2, 3, 4]),
        ({"min_triangles": 3}, []),
        ({"min_area": 1.0}, [0, 1, 2, 3, 4]),
        ({"min_area": 1.01}, [1]),
        ({"min_triangles": 2, "min_area": 1.2}, []),
    ],
)
def test_small_parts_go_with_their_vertices(device, limits, kept):
    colors = np.random.default_rng(0).random((len(CORNERS), 3)).astype(np.float32)
    mesh = TriangleMesh(CORNERS, PARTS, vertex_colors=colors, device=device)
    left = mesh.remove_small_components(**limits)
    triangles = np.array(PARTS)[kept].reshape(-1, 3)
    used = np.unique(triangles)
    np.testing.assert_array_equal(left.triangles, np.searchsorted(used, triangles))
    np.testing.assert_array_equal(left.vertices, np.array(CORNERS)[used])
    np.testing.assert_array_equal(left.vertex_colors, colors[used])


@pytest.mark.parametrize(
    ("limits", "error", "message"),
    [
        ({"min_triangles": 0}, ValueError, "min_triangles: .* >= 1"),
        ({"min_triangles": 1.5}, TypeError, "min_triangles"),
        ({"min_area": -1}, ValueError, "min_area"),
        ({"min_area": np.nan}, ValueError, "min_area"),
    ],
)
def test_limits_out_of_range_are_refused(limits, error, message):
    with pytest.raises(error, match=message):
        TriangleMesh(CORNERS, PARTS).remove_small_components(**limits)
