"""Texture coordinates, material numbers and images follow their triangles."""

import copy
import pickle

import numpy as np

from pointloom import TriangleMesh

PICTURE = np.arange(4 * 5 * 3, dtype=np.uint8).reshape(4, 5, 3)


def textured(device=None) -> TriangleMesh:
    rng = np.random.default_rng(0)
    triangles = rng.permuted(np.tile(np.arange(30), (40, 1)), axis=1)[:, :3]
    return TriangleMesh(
        rng.normal(size=(32, 3)),
        triangles,
        triangle_uvs=rng.random((120, 2)),
        triangle_material_ids=rng.integers(0, 2, 40),
        textures=[PICTURE, PICTURE[::-1]],
        device=device,
    )


def corner_table(mesh: TriangleMesh) -> np.ndarray:
    """Position, texture coordinates and material of each corner: the appearance, independent of numbering."""
    assert mesh.triangle_uvs is not None and mesh.triangle_material_ids is not None
    corners, materials = mesh.vertices[mesh.triangles.reshape(-1)], np.repeat(mesh.triangle_material_ids, 3)
    return np.column_stack([corners, mesh.triangle_uvs, materials])


def test_a_reflection_preserves_texture_corners(device):
    mesh = textured(device)
    mirrored = mesh.transform(np.diag([-1.0, 1, 1, 1]))
    there = corner_table(mesh) * [-1, 1, 1, 1, 1, 1]
    np.testing.assert_array_equal(np.sort(corner_table(mirrored), axis=0), np.sort(there, axis=0))
    np.testing.assert_array_equal(corner_table(mirrored)[::3], there[::3])
    np.testing.assert_array_equal(corner_table(mirrored)[1::3], there[2::3])


def test_texture_survives_copies_pickles_and_devices(device):
    mesh = textured(device)
    for again in (mesh.copy(), copy.deepcopy(mesh), pickle.loads(pickle.dumps(mesh)), mesh.to("cpu")):
        np.testing.assert_array_equal(corner_table(again), corner_table(mesh))
        np.testing.assert_array_equal(again.textures[1], PICTURE[::-1])


def test_dropping_texture_coordinates_drops_images():
    mesh = textured()
    mesh.triangle_uvs = None
    assert mesh.triangle_uvs is None and mesh.triangle_material_ids is None and mesh.textures == ()
