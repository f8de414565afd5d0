"""Meshes with textures for file tests."""

import numpy as np

from pointloom.io.table import MeshTable

# The corners of the image differ: red above left, green above right, blue below left, yellow below right.
IMAGE = np.zeros((8, 8, 3), np.uint8)
IMAGE[:4] = [[255, 0, 0]] * 4 + [[0, 255, 0]] * 4
IMAGE[4:] = [[0, 0, 255]] * 4 + [[255, 255, 0]] * 4
CORNERS = {(0.0, 0.0): (0, 0, 255), (1.0, 0.0): (255, 255, 0), (0.0, 1.0): (255, 0, 0), (1.0, 1.0): (0, 255, 0)}


def square() -> MeshTable:
    """A square whose corners show the corners of the image."""
    return MeshTable(
        np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], np.float32),
        np.array([[0, 1, 2], [0, 2, 3]]),
        triangle_uvs=np.array([[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]], np.float32),
        textures=(IMAGE,),
    )


def textured(dtype=np.float32, *, normals=True, colors=True) -> MeshTable:
    """A mesh with seams, two images and a color, in no order."""
    rng = np.random.default_rng(3)
    vectors = rng.normal(size=(20, 3))
    return MeshTable(
        rng.normal(size=(20, 3)).astype(dtype),
        rng.permuted(np.tile(np.arange(19), (30, 1)), axis=1)[:, :3],
        (vectors / np.linalg.norm(vectors, axis=1, keepdims=True)).astype(np.float32) if normals else None,
        rng.integers(0, 256, (20, 3)).astype(np.float32) / np.float32(255) if colors else None,
        triangle_uvs=rng.random((90, 2)).astype(np.float32),
        triangle_material_ids=rng.integers(0, 3, 30).astype(np.int32),
        textures=(IMAGE, np.full((1, 1, 3), 77, np.uint8), np.dstack([IMAGE[::-1], IMAGE[..., 0]])),
    )


def corner_table(mesh) -> np.ndarray:
    """Position, coordinates and material of each corner; rows of 3 corners, sorted."""
    at = mesh.triangles.reshape(-1)
    columns = [mesh.vertices[at], mesh.triangle_uvs]
    ids = mesh.triangle_material_ids
    columns.append(np.repeat(np.zeros(len(mesh.triangles)) if ids is None else ids, 3)[:, None])
    columns += [values[at] for values in (mesh.vertex_normals, mesh.vertex_colors) if values is not None]
    rows = np.hstack(columns).reshape(len(mesh.triangles), -1)
    return rows[np.lexsort(rows.T)]


def seen_at_corners(mesh) -> dict:
    """The image's color at each corner of a mesh; rows from above, v from below."""
    colors = {}
    for at, (u, v) in zip(mesh.triangles.reshape(-1), mesh.triangle_uvs, strict=True):
        image = mesh.textures[0]
        row, column = round((1 - float(v)) * (len(image) - 1)), round(float(u) * (image.shape[1] - 1))
        colors[tuple(mesh.vertices[at, :2].tolist())] = tuple(image[row, column].tolist())
    return colors
