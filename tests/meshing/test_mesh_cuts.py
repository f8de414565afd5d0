"""Vertices and triangles removed by mask, as Open3D removes them."""

from __future__ import annotations

import numpy as np
import pytest

from pointloom import TriangleMesh

from .open3d_meshes import open3d_arrays


def strip(device=None) -> TriangleMesh:
    rng = np.random.default_rng(0)
    vertices, normals, colors = rng.random((3, 60, 3)).astype(np.float32)
    triangles = rng.permuted(np.tile(np.arange(50), (80, 1)), axis=1)[:, :3]  # ten vertices are in none
    return TriangleMesh(vertices, triangles, vertex_normals=normals, vertex_colors=colors, device=device)


NAMES = ("triangles", "vertices", "vertex_normals", "vertex_colors")


@pytest.mark.parametrize("method", ["remove_vertices_by_mask", "remove_triangles_by_mask"])
def test_what_is_left_is_as_in_open3d(device, oracle, method):
    mesh = strip(device)
    chances = np.random.default_rng(1).random(60 if "vertices" in method else 80)
    for share in (0.0, 0.1, 0.5, 1.0):
        mask = chances < share
        wanted = oracle(f"meshing/cuts/{method}_{share}", open3d_arrays, mesh, method, mask, names=NAMES)
        left = getattr(mesh, method)(mask)
        for name, values in zip(NAMES, wanted, strict=True):
            np.testing.assert_array_equal(getattr(left, name), values)
    assert len(mesh) == 80 and len(mesh.vertices) == 60


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
def test_a_mask_of_another_shape_or_kind_is_refused(method):
    for mask in ([True], np.zeros((60, 1), bool), np.zeros(60), np.zeros(80), np.arange(80), [], [3, 5]):
        with pytest.raises(ValueError, match=r"mask: expected .* one for each"):
            getattr(strip(), method)(mask)
