"""Meshes cut by planes: what lies above one, with or without a lid, and the lines in which planes meet a mesh."""

from __future__ import annotations

import warnings
from typing import Any, NamedTuple, Self, overload

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_direction, check_finite, check_numeric, check_shape, shown
from ...core.dropped_results import returns_new
from ...kernels.arrays.bounds import bound_points
from ...kernels.arrays.concatenation import concatenate_rows
from ...kernels.arrays.select import positions_of
from ...kernels.lang import int32, vec3i
from ...kernels.linear_algebra import matmul, norm
from ...kernels.memory import upload
from ...kernels.meshes import clean_triangles, mesh_edits, plane_cut
from ...kernels.meshes.holes import spread_corners
from ...kernels.meshes.level_cut import LevelCut
from ...pcd.line_set import LineSet
from .flat_polygons import fill_loops, load_manifold, turn_by_depth
from .mesh_cleaning import MeshCleaning
from .mesh_trim import MeshTrim
from .section_paths import join_lines, lines_in_plane, outline, run_alike


class _Plane(NamedTuple):
    """A plane about a mesh's origin."""

    normal: NDArray[np.float64]  # of unit length
    offset: float  # [m], the height of the origin
    slack: float  # [m], what rounding moves vertices by

    def axes(self) -> NDArray[np.float64]:
        """Two axes in the plane, [2, 3], to the left of each other seen against the normal."""
        u = np.cross(np.eye(3)[np.abs(self.normal).argmin()], self.normal)
        u /= norm(u)
        return np.array([u, np.cross(self.normal, u)])


class MeshCutting(MeshTrim, MeshCleaning):
    """The part of TriangleMesh that cuts it by planes."""

    @returns_new
    def clip_plane(self, point: ArrayLike, normal: ArrayLike, *, cap: bool = False) -> Self:
        """What lies on the side of a plane to which its normal points.

        Args:
            point: A point of the plane [m], shape [3].
            normal: Where to keep the mesh, shape [3], of any length.
            cap: Close the mesh where the plane opens it. Outlines are filled as the triangles at them turn, so a cavity
                stays one; where these turn different ways, what lies within an odd number of outlines is filled.

        Returns:
            Triangles in their order, cut ones as two or one; vertices in their order, then one for each edge that the
            plane cuts, shared by the triangles there, with normals (of unit length), colours, texture coordinates and
            attributes between those of its ends. Vertices in the plane stay what they are. Without a lid triangles in
            the plane stay; with one those that face up go. The lid's triangles come last and have the vertices of the
            border alone, so a watertight mesh stays watertight; the texture coordinates, materials and attributes of
            its triangles are those of a triangle beside it. Triangles with a corner that is not finite go.

        Raises:
            ValueError: Not three finite numbers, or a normal without a length.
            TypeError: No numbers.
            ImportError: A lid was asked for, and manifold3d is not installed.

        Warns:
            UserWarning: Some outlines are not closed, because the mesh is not: there is no lid.

        Notes:
            A vertex lies in the plane where it is nearer than float32 rounds the largest coordinate about `origin`.
            Some 150 B of memory a triangle. Same bits from run to run and on every device.

        Example:
            >>> import pointloom as loom
            >>> half = loom.TriangleMesh.create_box().clip_plane([0.5, 0, 0], [1, 0, 0], cap=True)
            >>> half.is_watertight(), half.get_volume()
            (True, 0.5)
        """
        plane, mesh = self._plane(point, normal)
        if cap:
            load_manifold("cap")
        cut, sides, whole = mesh._cut_by(plane)
        kept = plane_cut.mask_above(sides, with_up=not cap)
        if not cap:
            return whole._with_triangles(kept)  # sync
        above, half_edges = whole._above(cut, sides, kept)  # sync
        return above._with_lid(half_edges, plane)

    @overload
    def slice_plane(self, point: ArrayLike, normal: ArrayLike, contour_values: ArrayLike = (0.0,)) -> LineSet: ...
    @overload
    def slice_plane(
        self, point: ArrayLike, normal: ArrayLike, contour_values: ArrayLike = (0.0,), *, cap: bool
    ) -> Self: ...
    def slice_plane(
        self, point: ArrayLike, normal: ArrayLike, contour_values: ArrayLike = (0.0,), *, cap: bool | None = None
    ) -> Any:
        """The lines in which one or more parallel planes meet the mesh.

        Args:
            point: A point of the plane [m], shape [3].
            normal: Across the plane, shape [3], of any length.
            contour_values: How far above the point the planes lie along the normal [m].
            cap: The mesh above the one plane instead, as trimesh calls it: `clip_plane(point, normal, cap=cap)`.

        Returns:
            A LineSet: the lines of each plane in turn, with one point for each edge that it cuts, shared by the lines
            there. Lines of a mesh that is wound alike run so that it lies to their left, seen against the normal. A
            mesh that only touches a plane from above has no line there; one that stands on it has its outline.

        Raises:
            ValueError: Not three finite numbers, a normal without a length, or contours that are no finite numbers.
            TypeError: No numbers.

        Notes:
            As `clip_plane`, plane by plane.

        Example:
            >>> import pointloom as loom
            >>> ball = loom.TriangleMesh.create_sphere()
            >>> ball.slice_plane([0, 0, 0], [0, 0, 1], contour_values=[-0.5, 0, 0.5])
            LineSet(200 points, 200 lines)
        """
        if cap is not None:
            if not isinstance(cap, bool | np.bool_):
                raise TypeError(f"cap: expected True, False or None, got {shown(cap)}")
            return self.clip_plane(point, normal, cap=bool(cap))
        heights = check_finite("contour_values", np.atleast_1d(check_numeric("contour_values", contour_values)))
        if heights.ndim != 1:
            raise ValueError(f"contour_values: expected shape [k], got {list(heights.shape)}")
        (plane, mesh), points, lines = self._plane(point, normal), [np.zeros((0, 3))], []
        for height in heights.tolist():
            places, ends = mesh._section(plane._replace(offset=plane.offset - height))
            lines.append(ends + sum(map(len, points)))
            points.append(places)
        return LineSet(np.concatenate(points), np.concatenate([np.zeros((0, 2), np.int64), *lines]).astype(np.int32))

    def section_loops(self, point: ArrayLike, normal: ArrayLike) -> list[NDArray[np.float64]]:
        """The lines in which a plane meets the mesh, joined: closed loops first, then paths that end at borders.

        Args:
            point: A point of the plane [m], shape [3].
            normal: Across the plane, shape [3], of any length.

        Returns:
            Points [m] of shape [k, 3] each; the last one of a loop is its first one again. Loops of a mesh that is
            wound alike and outwards run to the left seen against the normal, those of cavities to the right. Where
            loops touch they are parted there.

        Raises:
            ValueError, TypeError: As `slice_plane`.

        Example:
            >>> import pointloom as loom
            >>> [loop] = loom.TriangleMesh.create_box().section_loops([0, 0, 0.25], [0, 0, 1])
            >>> len(loop), loop[0].tolist() == loop[-1].tolist(), loop[:, 2].tolist()[:2]
            (9, True, [0.25, 0.25])
        """
        plane, mesh = self._plane(point, normal)
        points, ends = mesh._section(plane)
        flat = matmul(points - self._origin, plane.axes().T)
        loops, paths = join_lines(ends, dict(enumerate(flat)))
        return [points[[*loop, loop[0]]] for loop in loops] + [points[path] for path in paths]

    # ------------------------------------------------------------------------------------------------ internals

    def _plane(self, point: ArrayLike, normal: ArrayLike) -> tuple[_Plane, Self]:
        """The plane, and the mesh without triangles that have a corner which is not finite; one sync, two with such."""
        place = check_finite("point", check_shape("point", point, (3,)))
        way, vertices = check_direction("normal", normal), self._arrays["vertices"]
        low, high, count = bound_points(vertices)  # sync
        largest = np.abs([low, high]).max(axis=0).astype(np.float64) if count else np.zeros(3)
        slack = float(
            matmul(
                np.abs(way), plane_cut.ROUNDING * largest + plane_cut.COARSE * (np.abs(self._origin) + np.abs(place))
            )
        )
        mesh = self
        if count < vertices.size:
            mesh = self._without(clean_triangles.mask_not_finite(vertices, self._arrays["triangles"]))  # sync
        return _Plane(way, float(matmul(way, self._origin - place)), slack), mesh

    def _cut_by(self, plane: _Plane) -> tuple[LevelCut, wp.array, Self]:
        """(the cut, the side of each piece, all pieces as a mesh)."""
        heights = plane_cut.measure_heights(self._arrays["vertices"], *plane)
        cut = LevelCut(self._arrays["triangles"], heights, 0.0)
        whole = self._cut_up(cut)
        return cut, plane_cut.find_sides(whole._arrays["vertices"], cut.pieces, cut.sides, plane.normal), whole

    def _section(self, plane: _Plane) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
        """(points [m] [n, 3], lines between them [k, 2])."""
        cut, sides, whole = self._cut_by(plane)
        rows = positions_of(plane_cut.mark_in_plane(cut))  # sync
        found = plane_cut.read_half_edges(whole._arrays["vertices"], cut.pieces, sides, rows)  # sync
        ends = lines_in_plane(found.rows, self._arrays["vertices"].size)
        used, numbers = np.unique(ends, return_inverse=True)
        return found.places(used) + self._origin, numbers.reshape(-1, 2)

    def _above(self, cut: LevelCut, sides: wp.array, kept: wp.array) -> tuple[Self, plane_cut.HalfEdges]:
        """The pieces that are kept with the vertices that they use, and their half-edges in the plane; two syncs."""
        mesh, rows, chosen, found = self._chosen(kept, plane_cut.mark_in_plane(cut, kept))  # sync
        vertices, pieces = self._arrays["vertices"], cut.pieces
        places = [mesh_edits.mark_places(*listed)[1] for listed in ((chosen, vertices.size), (rows, pieces.size))]
        return mesh, plane_cut.read_half_edges(vertices, pieces, sides, found, (places[0], places[1]))  # sync

    def _with_lid(self, found: plane_cut.HalfEdges, plane: _Plane) -> Self:
        """The pieces above a plane, closed along it."""
        ends = outline(found.rows)[:, ::-1]  # as the lid's triangles run
        used = np.unique(ends)
        flat = matmul(found.places(used), plane.axes()[::-1].T)  # seen from below
        loops, paths = join_lines(ends, dict(zip(used.tolist(), flat, strict=True)))
        if paths:
            warnings.warn(f"cap: {len(paths)} outlines are not closed, as the mesh is not; no lid there", stacklevel=4)
        loops = [loop for loop in loops if len(loop) > 2]
        places = [flat[np.searchsorted(used, loop)] for loop in loops]
        if not run_alike(loops, ends):
            turned = turn_by_depth(places)
            loops = [loop[::-1] if turn else loop for loop, turn in zip(loops, turned, strict=True)]
            places = [place[::-1] if turn else place for place, turn in zip(places, turned, strict=True)]
        numbers = np.array([v for loop in loops for v in loop], np.int32)
        return self._with_more(numbers[fill_loops("cap", places)], found.rows)

    def _with_more(self, lid: NDArray[np.int32], half_edges: NDArray[np.int32]) -> Self:
        """The mesh with more triangles, whose corners take what belongs to the first of some half-edges there."""
        numbers = half_edges[:, 3]
        ends = np.concatenate([half_edges[:, 0], half_edges[:, 1]])
        held = np.concatenate([numbers, numbers - numbers % 3 + (numbers + 1) % 3])
        vertices, first = np.unique(ends, return_index=True)
        corners = held[first][np.searchsorted(vertices, lid.reshape(-1))].astype(np.int32)
        own = self._arrays["triangles"]
        rows = np.concatenate([np.arange(own.size, dtype=np.int32), corners[::3] // 3])
        arrays = self._triangles_at(upload(rows, int32, self._device))
        arrays["triangles"] = concatenate_rows([own, upload(lid, vec3i, self._device)])
        if "triangle_uvs" in self._arrays:
            more = upload(corners, int32, self._device)
            arrays["triangle_uvs"] = spread_corners(self._arrays["triangle_uvs"], more)
        return self._with_arrays(**arrays)
