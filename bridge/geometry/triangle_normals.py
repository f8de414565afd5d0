"""Normals of triangles, which a mesh of pointloom does not store: `TriangleNormals` stores them beside it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import inv, matmul
from ..held import Rows, ours
from ..vectors import Vector3dVector
from .mesh_factories import MeshFactories

ROWS = "triangle normals of pointloom.open3d"  # attribute of triangles while an operation selects some of them


class TriangleNormals(MeshFactories):
    """Normals of triangles: computed or assigned, and kept until they are computed again, as in Open3D.

    `_faces` is None without normals, a mesh of ours for the unit normals of its triangles, or an array (t, 3).
    Computed normals follow the triangles of the mesh as long as its arrays are not written to.
    """

    _arrays: ClassVar = {"vertices": "points", "vertex_normals": "normals", "triangle_normals": "normals"}
    _faces: Any = None

    triangle_normals = Rows(Vector3dVector)

    def _face_rows(self) -> NDArray[np.float64]:
        """The normals as an array; no rows without normals."""
        if self._faces is None:
            return np.zeros((0, 3))
        return self._faces if isinstance(self._faces, np.ndarray) else self._faces.triangle_normals.astype(np.float64)

    def _become(self, new: Any) -> Self:
        """Replace ours; computed normals become those of the new triangles, assigned ones stay."""
        before, old = self._faces, self._held
        super()._become(new)
        if before is not old:
            return self
        arrays, others = old._device_arrays, new._device_arrays
        self._faces = new
        if any(arrays[name] is not others[name] for name in ("vertices", "triangles")):
            self._show_faces()
        return self

    def _set_faces(self, faces: Any) -> Self:
        self._faces = faces
        self._show_faces()
        return self

    def _show_faces(self) -> None:
        """Copy the normals into the vector that was handed out."""
        out = self._out.get("triangle_normals")
        if out is not None:
            out.vector._fill(self._face_rows())
            out.keep()

    def _moved(self, new: Any, A: NDArray[np.float64]) -> Self:
        """Replace ours by what a map with the 3x3 part A made of it; assigned normals turn with the surface."""
        self._become(new)
        if self._faces is None or self._faces is new:
            return self
        rows = self._face_rows()
        turned = matmul(rows, inv(A))
        lengths = [np.linalg.norm(part, axis=1, keepdims=True) for part in (rows, turned)]
        return self._set_faces(turned * np.divide(lengths[0], lengths[1], where=lengths[1] > 0, out=lengths[1]))

    def _selected(self, operation: Callable[[Any], Any]) -> tuple[Any, Any]:
        """The mesh that an operation makes by selecting triangles, and the normals of those."""
        current = self._ours
        rows = self._face_rows()
        if self._faces is None or self._faces is current or len(rows) != len(current):
            made = operation(current)
            return made, made if self._faces is current else self._faces
        marked = current.copy()
        marked.triangle_attributes[ROWS] = rows
        made = operation(marked)
        return made, made.triangle_attributes.pop(ROWS)

    def _keep(self, operation: Callable[[Any], Any]) -> Self:
        """Drop the triangles that an operation does not select."""
        made, faces = self._selected(operation)
        return self._become(made)._set_faces(faces)

    def _sampled(self, use_triangle_normal: bool) -> tuple[Any, bool]:
        """A mesh to draw samples from, and whether they take the normals that its triangles have by themselves.

        Assigned normals are given to the corners of triangles that share no vertices.
        """
        current = self._ours
        if use_triangle_normal and self._faces is None:
            self._set_faces(current)
        rows = self._face_rows() if use_triangle_normal and self._faces is not current else ()
        if not len(rows) or len(rows) != len(current):
            return current, use_triangle_normal
        corners, colors = current.triangles.reshape(-1), current.vertex_colors
        apart = type(current)(
            current.vertices[corners],
            np.arange(len(corners), dtype=np.int32).reshape(-1, 3),
            vertex_normals=np.repeat(rows, 3, axis=0),
            vertex_colors=None if colors is None else colors[corners],
            device=current.device,
            origin=current.origin,
        )
        return apart, False

    def _new(self, made: Any, *, faces: Any = None) -> Any:
        """Another mesh with these normals of triangles."""
        other = type(self)._of(made)
        other._faces = faces
        return other

    def _recomputed(self, made: Any) -> Any:
        """Another mesh, with computed normals of triangles where this one has some."""
        return self._new(made, faces=None if self._faces is None else made)

    def _joined(self, other: Any) -> tuple[Any, Any]:
        """Both meshes as one; the normals stay where all triangles have some."""
        parts = [(self._ours, self), (ours(other, type(self), "other"), other)]
        made = parts[0][0] + parts[1][0]
        held = [(mesh, getattr(part, "_faces", None), part) for mesh, part in parts if len(mesh)]
        if not held or any(faces is None for _, faces, _ in held):
            return made, None
        if all(faces is mesh for mesh, faces, _ in held):
            return made, made
        return made, np.concatenate([part._face_rows() for _, _, part in held])

    def __add__(self, other: Any) -> Any:
        made, faces = self._joined(other)
        return self._new(made, faces=faces)

    def __iadd__(self, other: Any) -> Self:
        made, faces = self._joined(other)
        return self._become(made)._set_faces(faces)

    def compute_triangle_normals(self, normalized: bool = True) -> Self:
        """Give each triangle its normal, of length 1 or of twice its area."""
        current = self._ours
        return self._set_faces(current if normalized else _area_vectors(current))

    def compute_vertex_normals(self, normalized: bool = True) -> Self:
        """Give each vertex the sum of the area vectors of its triangles, and each triangle its normal.

        All have length 1; with `normalized=False` their lengths are areas.
        """
        current = self._ours
        if normalized:
            return self._become(current.compute_vertex_normals()).compute_triangle_normals()
        areas = _area_vectors(current)
        sums = np.zeros((len(current.vertices), 3))
        np.add.at(sums, current.triangles.reshape(-1), np.repeat(areas, 3, axis=0))
        made = current.copy()
        made.vertex_normals = sums
        return self._become(made)._set_faces(areas)

    def normalize_normals(self) -> Self:
        """Bring normals of vertices and of triangles to length 1."""
        self._become(self._ours.normalize_normals())
        if not isinstance(self._faces, np.ndarray):
            return self
        lengths = np.linalg.norm(self._faces, axis=1, keepdims=True)
        return self._set_faces(np.divide(self._faces, lengths, where=lengths > 0, out=self._faces.copy()))


def _area_vectors(mesh: Any) -> NDArray[np.float64]:
    """The normal of each triangle with a length of twice its area, shape (t, 3)."""
    corners = (mesh.vertices - mesh.origin)[mesh.triangles]
    return np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
