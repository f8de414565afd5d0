"""Separate sheets that share two vertices by more than one edge: all but the first get a vertex at the midpoint."""

from __future__ import annotations

from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from ...kernels.array_types import Indices
from ...kernels.arrays.select import gather_rows
from ...kernels.lang import float64, int32, vec2, vec3i
from ...kernels.memory import download, full, upload
from ...kernels.meshes.corner_vertices import find_doubled_edges
from ...kernels.meshes.mixed_rows import with_vertices_on_edges
from .mesh_arrays import MeshArrays
from .mesh_attributes import each

MeshType = TypeVar("MeshType", bound=MeshArrays)


def part_doubled_edges(mesh: MeshType, twins: Indices) -> MeshType:
    """Add a midpoint to edges that repeat another edge's vertices in sheets. Such a surface touches itself along an
    edge but is connected around both ends, so splitting vertices does not separate it. New vertices and triangles are
    appended. `twins` are the paired half-edges or -1, int32 (3 t,)."""
    count = mesh.arrays["vertices"].size
    half_edges = find_doubled_edges(mesh.arrays["triangles"], count, twins)  # sync
    if not half_edges.size:
        return mesh
    doubled, others = download(half_edges), download(gather_rows(twins, half_edges))  # sync
    triangles = download(mesh.arrays["triangles"]).reshape(-1, 3)  # sync
    pairs = np.where(others >= 0, np.minimum(doubled, others), doubled)
    split_half_edges, middles = np.unique(pairs, return_inverse=True)
    ends = np.column_stack(
        [
            triangles.ravel()[split_half_edges],
            triangles.ravel()[split_half_edges - split_half_edges % 3 + (split_half_edges + 1) % 3],
        ]
    )
    middle_of = dict(zip(doubled.tolist(), (count + middles).tolist(), strict=True))
    pieces, weights, rows = [], [], np.unique(doubled // 3)
    for row in rows.tolist():
        made = _pieces(triangles[row].tolist(), [middle_of.get(3 * row + k) for k in range(3)])
        pieces.append([[vertex for vertex, _ in piece] for piece in made])
        weights.append([[weight for _, weight in piece] for piece in made])
    return _with_pieces(mesh, ends, rows, pieces, weights)


def _pieces(corners: list[int], middles: list[int | None]) -> list[list[tuple[int, list[float]]]]:
    """Split a triangle at vertices on its sides: triangles of (vertex, corner weights)."""
    around: list[tuple[int, list[float]]] = []
    for k in range(3):
        around.append((corners[k], [float(j == k) for j in range(3)]))
        middle = middles[k]
        if middle is not None:
            around.append((middle, [0.0 if j == (k + 2) % 3 else 0.5 for j in range(3)]))
    first = next(k for k, (_, weight) in enumerate(around) if max(weight) < 1)
    around = around[first:] + around[:first]  # start at a midpoint, which is collinear with its neighbors only
    return [[around[0], around[k], around[k + 1]] for k in range(1, len(around) - 1)]


def _with_pieces(
    mesh: MeshType, ends: NDArray[np.int32], rows: NDArray[np.int64], pieces: list[Any], weights: list[Any]
) -> MeshType:
    """Add vertices between ends, and replace the triangles at some rows by pieces."""
    device, count = mesh.device, len(mesh)
    lower, upper = (upload(np.ascontiguousarray(ends[:, k]), int32, device) for k in (0, 1))
    arrays: dict[str, Any] = {}
    for name, values in mesh.arrays.per_vertex().items():
        current, one, other = (
            download(part) for part in (values, gather_rows(values, lower), gather_rows(values, upper))
        )
        middle = one
        if current.dtype.kind == "f":
            middle = (one.astype(np.float64) + other) / 2
            if name == "vertex_normals":
                size = np.linalg.norm(middle, axis=1, keepdims=True)
                middle = np.where(size > 0, middle / np.where(size > 0, size, 1), one)
        arrays[name] = upload(np.concatenate([current, middle.astype(current.dtype)]), values.dtype, device)
    old = mesh.arrays["vertices"].size
    numbers = upload(np.arange(old, old + len(ends), dtype=np.int32), int32, device)
    middles = with_vertices_on_edges(old, numbers, lower, upper, full(len(ends), 0.5, float64, device))
    arrays["vertex_attributes"] = each(mesh.arrays.attributes["vertex_attributes"], middles.of)
    piece_rows = [[row] + [-1] * (len(piece) - 1) for row, piece in zip(rows.tolist(), pieces, strict=True)]
    flat = np.concatenate(piece_rows)
    flat[flat < 0] = count + np.arange((flat < 0).sum())
    source = np.append(np.arange(count), np.empty(len(flat) - len(rows), np.int64)).astype(np.int32)
    source[flat] = np.repeat(rows, [len(piece) for piece in pieces])
    arrays |= mesh.arrays.triangles_at(upload(source, int32, device))
    triangles = download(arrays["triangles"]).reshape(-1, 3).copy()
    triangles[flat] = np.concatenate([np.array(piece) for piece in pieces])
    arrays["triangles"] = upload(triangles, vec3i, device)
    if "triangle_uvs" in arrays:
        uvs = download(arrays["triangle_uvs"]).reshape(-1, 3, 2).copy()
        uvs[flat] = np.einsum("nkj,njc->nkc", np.concatenate([np.array(w) for w in weights]), uvs[flat])
        arrays["triangle_uvs"] = upload(uvs.reshape(-1, 2).astype(np.float32), vec2, device)
    return mesh.with_arrays(**arrays)
