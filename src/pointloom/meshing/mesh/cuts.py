"""Cuts of a mesh by planes and levels: trim, clip, slice, section."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...core.checks import (
    check_direction,
    check_finite,
    check_fraction,
    check_number,
    check_numeric,
    check_shape,
    shown,
)
from ...core.exchange import on_host
from ...core.units import warn_of_units
from ...kernels.arrays.bounds import bound_points
from ...kernels.arrays.concatenation import concatenate_rows
from ...kernels.arrays.select import gather_rows, positions_of
from ...kernels.lang import float64, int32, vec3i
from ...kernels.linear_algebra import matmul, norm
from ...kernels.memory import upload
from ...kernels.meshes import clean_triangles, mesh_edits, plane_cut
from ...kernels.meshes.holes import spread_corners
from ...kernels.meshes.level_cut import LevelCut
from ...kernels.meshes.trim import mask_trimmed
from ...pcd.line_set import LineSet
from .mesh_arrays import Mesh, MeshArrays
from .mesh_store import each
from .outlines import fill_loops, join_lines, lines_in_plane, load_manifold, loops_to_reverse, outline, run_alike
from .selection import drop_triangles, keep_triangles


class _Plane(NamedTuple):
    normal: NDArray[np.float64]  # unit length
    offset: float  # [m] height of the origin
    slack: float  # [m] rounding of vertices

    def axes(self) -> NDArray[np.float64]:
        """Two axes in the plane, shape (2, 3), counterclockwise seen against the normal."""
        u = np.cross(np.eye(3)[np.abs(self.normal).argmin()], self.normal)
        u /= norm(u)
        return np.array([u, np.cross(self.normal, u)])


def trim(mesh: Mesh, vertex_values: ArrayLike, level: float, *, island_ratio: float) -> Mesh:
    """As `TriangleMesh.trim`."""
    values = check_numeric("vertex_values", on_host("vertex_values", vertex_values))
    count = mesh.arrays["vertices"].size
    if values.shape != (count,):
        raise ValueError(f"vertex_values: expected shape [{count}], one number per vertex, got {list(values.shape)}")
    values = check_finite("vertex_values", values.astype(np.float64))
    where, ratio = check_number("level", level), check_fraction("island_ratio", island_ratio)
    cut = LevelCut(mesh.arrays["triangles"], upload(values, float64, mesh.device), where)
    cut_mesh = _cut_up(mesh, cut)
    mask = mask_trimmed(cut_mesh.arrays["vertices"], cut, mesh.arrays["triangles"], ratio)
    return keep_triangles(cut_mesh, mask)[0]  # sync


def clip_plane(mesh: Mesh, point: ArrayLike, normal: ArrayLike, *, cap: bool) -> Mesh:
    """As `TriangleMesh.clip_plane`."""
    plane, finite = _plane_and_mesh(mesh, point, normal)
    if cap:
        load_manifold("cap")
    cut, sides, cut_mesh = _cut_by(finite, plane)
    mask = plane_cut.mask_above(sides, with_up=not cap)
    if not cap:
        return keep_triangles(cut_mesh, mask)[0]  # sync
    above, half_edges = _part_above(cut_mesh, cut, sides, mask)  # sync
    return _with_lid(above, half_edges, plane)


def slice_plane(
    mesh: MeshArrays, point: ArrayLike, normal: ArrayLike, contour_values: ArrayLike, *, cap: bool | None
) -> Any:
    """As `TriangleMesh.slice_plane`."""
    heights = check_finite("contour_values", np.atleast_1d(check_numeric("contour_values", contour_values)))
    if heights.ndim != 1:
        raise ValueError(f"contour_values: expected shape [k], got {list(heights.shape)}")
    if cap is not None:
        if not isinstance(cap, bool | np.bool_):
            raise TypeError(f"cap: expected True, False or None, got {shown(cap)}")
        return clip_plane(mesh, point, normal, cap=bool(cap))
    (plane, finite), points, lines = _plane_and_mesh(mesh, point, normal), [np.zeros((0, 3))], []
    for height in heights.tolist():
        positions, ends = _section_at(finite, plane._replace(offset=plane.offset - height))
        lines.append(ends + sum(map(len, points)))
        points.append(positions)
    return LineSet(np.concatenate(points), np.concatenate([np.zeros((0, 2), np.int64), *lines]).astype(np.int32))


def section_loops(mesh: MeshArrays, point: ArrayLike, normal: ArrayLike) -> list[NDArray[np.float64]]:
    """As `TriangleMesh.section_loops`."""
    plane, finite = _plane_and_mesh(mesh, point, normal)
    points, ends = _section_at(finite, plane)
    flat = matmul(points - mesh.arrays.origin, plane.axes().T)
    loops, paths = join_lines(ends, dict(enumerate(flat)))
    return [points[[*loop, loop[0]]] for loop in loops] + [points[path] for path in paths]


def _plane_and_mesh(mesh: Mesh, point: ArrayLike, normal: ArrayLike) -> tuple[_Plane, Mesh]:
    """(plane, mesh without non-finite triangles). One sync, two if there are such triangles."""
    center = check_finite("point", check_shape("point", point, (3,)))
    direction, vertices = check_direction("normal", normal), mesh.arrays["vertices"]
    low, high, count = bound_points(vertices)  # sync
    largest = np.abs([low, high]).max(axis=0).astype(np.float64) if count else np.zeros(3)
    slack = float(
        matmul(
            np.abs(direction),
            plane_cut.FLOAT32_ROUNDING * largest
            + plane_cut.FLOAT64_ROUNDING * (np.abs(mesh.arrays.origin) + np.abs(center)),
        )
    )
    finite = mesh
    if count < vertices.size:
        finite = drop_triangles(mesh, clean_triangles.mask_not_finite(vertices, mesh.arrays["triangles"]))  # sync
    return _Plane(direction, float(matmul(direction, mesh.arrays.origin - center)), slack), finite


def _with_more(mesh: Mesh, lid: NDArray[np.int32], half_edges: NDArray[np.int32]) -> Mesh:
    """Add cap triangles whose corners take the attributes of the first of the given half-edges there."""
    numbers = half_edges[:, 3]
    ends = np.concatenate([half_edges[:, 0], half_edges[:, 1]])
    end_corners = np.concatenate([numbers, numbers - numbers % 3 + (numbers + 1) % 3])
    vertices, first = np.unique(ends, return_index=True)
    corners = end_corners[first][np.searchsorted(vertices, lid.reshape(-1))].astype(np.int32)
    current = mesh.arrays["triangles"]
    rows = np.concatenate([np.arange(current.size, dtype=np.int32), corners[::3] // 3])
    arrays = mesh.arrays.triangles_at(upload(rows, int32, mesh.device))
    arrays["triangles"] = concatenate_rows([current, upload(lid, vec3i, mesh.device)])
    if "triangle_uvs" in mesh.arrays:
        more = upload(corners, int32, mesh.device)
        arrays["triangle_uvs"] = spread_corners(mesh.arrays["triangle_uvs"], more)
    return mesh.with_arrays(**arrays)


def _cut_up(mesh: Mesh, cut: LevelCut) -> Mesh:
    """All pieces of a cut as a mesh, with interpolated attributes."""
    rows = mesh.arrays.per_vertex()
    arrays: dict[str, Any] = {name: cut.rows_of(rows[name], name == "vertex_normals") for name in rows}
    columns = mesh.arrays.attributes["vertex_attributes"]
    if columns:
        arrays["vertex_attributes"] = each(columns, cut.mixed().of)
    arrays |= mesh.arrays.attributes_at("triangle_attributes", cut.sources)
    if "triangle_uvs" in mesh.arrays:
        arrays["triangle_uvs"] = cut.corners_of(mesh.arrays["triangle_uvs"])
    if "triangle_material_ids" in mesh.arrays:
        arrays["triangle_material_ids"] = gather_rows(mesh.arrays["triangle_material_ids"], cut.sources)
    return mesh.with_arrays(triangles=cut.pieces, **arrays)


def _cut_by(mesh: Mesh, plane: _Plane) -> tuple[LevelCut, wp.array, Mesh]:
    """(cut, side of each piece, mesh of all pieces)."""
    heights = plane_cut.measure_heights(mesh.arrays["vertices"], *plane)
    cut = LevelCut(mesh.arrays["triangles"], heights, 0.0)
    cut_mesh = _cut_up(mesh, cut)
    return cut, plane_cut.find_sides(cut_mesh.arrays["vertices"], cut.pieces, cut.sides, plane.normal), cut_mesh


def _section_at(mesh: MeshArrays, plane: _Plane) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """(points (n, 3) [m], lines (k, 2))."""
    cut, sides, cut_mesh = _cut_by(mesh, plane)
    rows = positions_of(plane_cut.mark_in_plane(cut))  # sync
    half_edges = plane_cut.read_half_edges(cut_mesh.arrays["vertices"], cut.pieces, sides, rows)  # sync
    ends = lines_in_plane(half_edges.rows, mesh.arrays["vertices"].size)
    used, numbers = np.unique(ends, return_inverse=True)
    return half_edges.positions(used) + mesh.arrays.origin, numbers.reshape(-1, 2)


def _part_above(cut_mesh: Mesh, cut: LevelCut, sides: wp.array, mask: wp.array) -> tuple[Mesh, plane_cut.HalfEdges]:
    """(kept pieces with their vertices, their half-edges in the plane). Two syncs."""
    mesh, rows, chosen, half_edges = keep_triangles(cut_mesh, mask, plane_cut.mark_in_plane(cut, mask))  # sync
    vertices, pieces = cut_mesh.arrays["vertices"], cut.pieces
    new_indices = [mesh_edits.mask_and_index(*listed)[1] for listed in ((chosen, vertices.size), (rows, pieces.size))]
    return mesh, plane_cut.read_half_edges(
        vertices, pieces, sides, half_edges, (new_indices[0], new_indices[1])
    )  # sync


def _with_lid(mesh: Mesh, half_edges: plane_cut.HalfEdges, plane: _Plane) -> Mesh:
    ends = outline(half_edges.rows)[:, ::-1]  # in the direction of the cap's triangles
    used = np.unique(ends)
    flat = matmul(half_edges.positions(used), plane.axes()[::-1].T)  # seen from below
    loops, paths = join_lines(ends, dict(zip(used.tolist(), flat, strict=True)))
    if paths:
        warn_of_units(
            f"cap: {len(paths)} outlines are not closed, because the mesh is not, and are not capped", UserWarning
        )
    loops = [loop for loop in loops if len(loop) > 2]
    polygons = [flat[np.searchsorted(used, loop)] for loop in loops]
    if not run_alike(loops, ends):
        is_reversed = loops_to_reverse(polygons)
        loops = [loop[::-1] if reverse else loop for loop, reverse in zip(loops, is_reversed, strict=True)]
        polygons = [
            polygon[::-1] if reverse else polygon for polygon, reverse in zip(polygons, is_reversed, strict=True)
        ]
    numbers = np.array([v for loop in loops for v in loop], np.int32)
    return _with_more(mesh, numbers[fill_loops("cap", polygons)], half_edges.rows)
