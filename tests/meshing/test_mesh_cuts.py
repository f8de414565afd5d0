"""Vertices and triangles removed by mask, as Open3D removes them."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

import pointloom as loom
from pointloom import TriangleMesh


def strip(device=None) -> TriangleMesh:
    rng = np.random.default_rng(0)
    vertices, normals, colors = rng.normal(size=(60, 3)), rng.normal(size=(60, 3)), rng.random((60, 3))
    triangles = rng.permuted(np.tile(np.arange(50), (80, 1)), axis=1)[:, :3]  # ten vertices are in none
    return TriangleMesh(vertices, triangles, vertex_normals=normals, vertex_colors=colors, device=device)


def in_open3d(mesh: TriangleMesh):
    o3d = pytest.importorskip("open3d", exc_type=ImportError)
    vector = o3d.utility.Vector3dVector
    peer = o3d.geometry.TriangleMesh(vector(mesh.vertices.copy()), o3d.utility.Vector3iVector(mesh.triangles.copy()))
    assert mesh.vertex_normals is not None and mesh.vertex_colors is not None
    peer.vertex_normals = vector(mesh.vertex_normals.astype(float))
    peer.vertex_colors = vector(mesh.vertex_colors.astype(float))
    return peer


@pytest.mark.parametrize("share", [0.0, 0.1, 0.5, 1.0])
def test_vertices_go_as_in_open3d(device, share):
    mesh = strip(device)
    mask = np.random.default_rng(1).random(60) < share
    peer = in_open3d(mesh)
    peer.remove_vertices_by_mask(mask)
    left = mesh.remove_vertices_by_mask(mask)
    np.testing.assert_array_equal(left.triangles, np.asarray(peer.triangles).reshape(-1, 3))
    np.testing.assert_array_equal(left.vertices, np.asarray(peer.vertices).reshape(-1, 3))
    np.testing.assert_array_equal(left.vertex_normals, np.asarray(peer.vertex_normals).reshape(-1, 3))
    np.testing.assert_array_equal(left.vertex_colors, np.asarray(peer.vertex_colors).reshape(-1, 3))
    assert len(mesh) == 80 and len(mesh.vertices) == 60


@pytest.mark.parametrize("share", [0.0, 0.1, 0.5, 1.0])
def test_triangles_go_as_in_open3d(device, share):
    mesh = strip(device)
    mask = np.random.default_rng(1).random(80) < share
    peer = in_open3d(mesh)
    peer.remove_triangles_by_mask(mask)
    left = mesh.remove_triangles_by_mask(mask)
    np.testing.assert_array_equal(left.triangles, np.asarray(peer.triangles).reshape(-1, 3))
    np.testing.assert_array_equal(left.vertices, mesh.vertices)
    np.testing.assert_array_equal(left.vertex_colors, mesh.vertex_colors)


def test_a_far_mesh_keeps_its_origin(device):
    far = np.array([5.0e5, 5.4e6, 100.0])
    mesh = TriangleMesh(strip().vertices + far, strip().triangles, device=device)
    mask = np.arange(60) % 3 == 0
    left = mesh.remove_vertices_by_mask(mask)
    np.testing.assert_array_equal(left.vertices, mesh.vertices[~mask])
    np.testing.assert_array_equal(left.origin, mesh.origin)


def test_a_mesh_of_nothing_takes_masks_of_nothing(device):
    mesh = TriangleMesh(device=device)
    for mask in ([], np.zeros(0, bool)):
        assert len(mesh.remove_vertices_by_mask(mask)) == len(mesh.remove_triangles_by_mask(mask)) == 0


@pytest.mark.parametrize("method", ["remove_vertices_by_mask", "remove_triangles_by_mask"])
@pytest.mark.parametrize(
    "mask", [[True], np.zeros((60, 1), bool), np.zeros(60), np.zeros(80), np.arange(80), [], [3, 5]]
)
def test_a_mask_of_another_shape_or_kind_is_refused(method, mask):
    with pytest.raises(ValueError, match=r"mask: expected .* one for each of the mesh's (vertices|triangles), got"):
        getattr(strip(), method)(mask)


@pytest.mark.parametrize("method", ["remove_vertices_by_mask", "remove_triangles_by_mask"])
def test_a_dropped_result_is_warned_of(method):
    things = {"mesh": strip(), "mask": np.zeros(60 if "vertices" in method else 80, bool)}
    with pytest.warns(loom.DroppedResultWarning, match=f"mesh = mesh.{method}"):
        exec(f"mesh.{method}(mask)", things)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        exec(f"taken = mesh.{method}(mask)", things)
