"""STL, written in its binary form: triangles alone, each with its own corners and facet normal in float32.

Not held: which triangles share a vertex, float64 positions (rounded), vertex normals (left out: the format stores facet
normals, which are computed from the corners), colours and attributes (refused).

Source: 3D Systems, "StereoLithography Interface Specification" (1989).
"""

from __future__ import annotations

import os

import numpy as np

from ..errors import FileError
from .ascii_rows import CHUNK_ROWS
from .atomic import atomic_write, check_writable
from .table import MeshTable

_FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute_bytes", "<u2")])

# Must not begin with "solid", by which readers tell the text form.
_HEADER = b"binary STL written by pointloom".ljust(80)


def write_stl(path: str | os.PathLike[str], mesh: MeshTable, *, overwrite: bool = True) -> None:
    """Write a triangle mesh as binary STL.

    Args:
        path: The file; it appears whole or not at all.
        mesh: The mesh. A triangle without area gets the normal (0, 0, 0), as the specification allows.
        overwrite: Whether an existing file may be replaced.

    Raises:
        FileError: The place cannot be written, the mesh has colours or attributes, a vertex that a triangle uses is not
            finite in float32, or there are 2^32 triangles or more.
        ValueError: An array of the mesh has the wrong shape, or a triangle names a missing vertex.
    """
    path = check_writable(path, overwrite=overwrite)
    mesh = mesh.checked()
    lost = [*mesh.attributes] + ([] if mesh.vertex_colors is None else ["vertex_colors"])
    if lost:
        raise FileError(path, f"STL cannot hold {', '.join(lost)}", remedy="Write .ply, or drop them first")
    if len(mesh.triangles) >= 2**32:
        raise FileError(path, f"STL cannot count {len(mesh.triangles)} triangles", remedy="Write .ply")
    with np.errstate(over="ignore"):
        single = mesh.vertices.astype(np.float32)
    bad = ~np.isfinite(single[mesh.triangles]).all(axis=(1, 2))
    if bad.any():
        raise FileError(path, "a corner is not finite in float32", where=f"triangle {int(np.flatnonzero(bad)[0])}")
    with atomic_write(path, overwrite=overwrite) as file:
        file.write(_HEADER + np.uint32(len(mesh.triangles)).astype("<u4").tobytes())
        for begin in range(0, len(mesh.triangles), CHUNK_ROWS):
            rows = mesh.triangles[begin : begin + CHUNK_ROWS]
            corners = mesh.vertices[rows].astype(np.float64)
            normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
            lengths = np.linalg.norm(normals, axis=1, keepdims=True)
            facets = np.zeros(len(rows), _FACET)
            facets["normal"] = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0)
            facets["corners"] = single[rows]
            file.write(facets.tobytes())
