"""Convert triangles to manifold sheets: no edge of more than two, no vertex of several fans, no duplicates."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Generic

import numpy as np
from numpy.typing import NDArray

from ...kernels.array_types import Device, Indices, Mask, Triangles
from ...kernels.arrays.duplicates import find_equal_points
from ...kernels.arrays.prefix_sum import sum_counts
from ...kernels.arrays.select import gather_rows, mark_negative, positions_of
from ...kernels.arrays.sort import positions
from ...kernels.arrays.subsets import other_rows
from ...kernels.lang import float64, int32, uint8, vec2, vec3i
from ...kernels.memory import download, empty, full, upload
from ...kernels.meshes import clean_triangles, merge_vertices
from ...kernels.meshes.copies import find_copies
from ...kernels.meshes.corner_vertices import CornerVertices, find_doubled_edges, keep_corners
from ...kernels.meshes.mesh_edits import count_referenced, repeated_positions
from ...kernels.meshes.mixed_rows import with_vertices_on_edges
from ...kernels.meshes.orientation import Orientation, flip_some, flip_some_corners, flip_some_normals
from ...kernels.meshes.part_votes import keep_alone
from ...kernels.meshes.sheets import Sheets, mask_loose
from .closed_parts import Copies, find_covered, find_doubled
from .measures import get_surface_area
from .mesh_arrays import Mesh, MeshArrays
from .mesh_store import each
from .selection import remove_degenerate_triangles

MAX_PASSES = 8
SUMMED = "copies", "copied_area", "crowding", "halved", "merged", "unused", "degenerate"


@dataclass(frozen=True)
class Stitched(Generic[Mesh]):
    """A mesh of sheets, and counts of changes. `copies`, `copied_area`: removed duplicates, either orientation.
    `crowding`: triangles without a partner. `halved`: triangles added to separate double edges. `merged`, `split`,
    `unused`: vertices. `open_sides`: boundary half-edges. `degenerate`: triangles with a repeated vertex or
    position. `can_change`: True if another pass can find more to do. `flipped`: triangles reversed
    between passes."""

    mesh: Mesh
    copies: int
    copied_area: float
    crowding: int
    halved: int
    merged: int
    split: int
    unused: int
    open_sides: int
    degenerate: int = 0
    can_change: bool = False
    flipped: int = 0

    @property
    def is_unchanged(self) -> bool:
        return not (self.degenerate or self.copies or self.crowding or self.halved or self.merged or self.split)

    def after(self, first: Stitched[Mesh], flipped: int) -> Stitched[Mesh]:
        """Add the counts of the passes before. Vertices that one pass splits and the next one merges do not count."""
        undone = min(first.split, self.merged)
        sums = {name: getattr(first, name) + getattr(self, name) for name in SUMMED}
        sums["merged"] -= undone
        return replace(self, split=first.split - undone + self.split, flipped=first.flipped + flipped, **sums)


def cut_and_stitch(mesh: Mesh) -> Stitched[Mesh]:
    """Cut finite triangles at edges of more than two and stitch them in pairs. See kernels/meshes/sheets.py. Closed,
    consistently oriented parts stay. Of all others, degenerate and duplicate triangles, parts that copy others, and
    single triangles without a partner are removed. If one triangle per vertex set leaves less border, it is kept.

    A removed triangle or a cut can leave other partners at its edges, so this is repeated until nothing changes."""
    result = _stitch_once(mesh)
    for _ in range(MAX_PASSES - 1):
        if not result.can_change:
            break
        flips = find_flips(result.mesh)
        again = _stitch_once(flipped_mesh(result.mesh, flips))
        if again.is_unchanged:
            break
        result = again.after(result, positions_of(flips).size)  # sync
    return result


def find_flips(mesh: MeshArrays) -> Mask:
    """uint8 [t]: 1 for triangles oriented against most of their part."""
    orientation = Orientation(mesh.arrays["triangles"], mesh.arrays.vertex_count)
    orientation.follow_majority()
    return orientation.flips


def flipped_mesh(mesh: Mesh, flips: Mask) -> Mesh:
    arrays: dict[str, Any] = {"triangles": flip_some(mesh.arrays["triangles"], flips)}
    if "triangle_uvs" in mesh.arrays:
        arrays["triangle_uvs"] = flip_some_corners(mesh.arrays["triangle_uvs"], flips)
    if "vertex_normals" in mesh.arrays:
        surface = mesh.arrays["vertices"], arrays["triangles"]
        arrays["vertex_normals"] = flip_some_normals(mesh.arrays["vertex_normals"], *surface, flips)
    return mesh.with_arrays(**arrays)


def _stitch_once(mesh: Mesh) -> Stitched[Mesh]:
    clean = remove_degenerate_triangles(mesh, zero_area=False)
    vertices, triangles = clean.arrays["vertices"], clean.arrays["triangles"]
    owners = find_equal_points(vertices)
    merged_triangles = merge_vertices.rename_corners(triangles, owners, positions(vertices.size, vertices.device))
    loose = mask_loose(triangles, vertices.size)
    folded, repeated, oriented_repeats = _find_worthless(clean, merged_triangles, loose)
    result = _sew(clean, merged_triangles, loose, folded, repeated)
    if result.open_sides and oriented_repeats.size > repeated.size:
        other = _sew(clean, merged_triangles, loose, folded, oriented_repeats)
        result = other if other.open_sides < result.open_sides else result
    return replace(result, degenerate=len(mesh) - triangles.size + folded.size)


def _sew(mesh: Mesh, merged_triangles: Triangles, loose: Mask, folded: Indices, repeated: Indices) -> Stitched[Mesh]:
    """`cut_and_stitch` without some triangles."""
    vertices, copied_area = mesh.arrays["vertices"], _area_of(mesh, repeated)
    rows = other_rows(_joined(folded, repeated), merged_triangles.size, are_distinct=True)
    clean = mesh.with_arrays(**mesh.arrays.triangles_at(rows))
    merged_triangles, loose = gather_rows(merged_triangles, rows), gather_rows(loose, rows)
    sheets = Sheets(vertices, clean.arrays["triangles"], merged_triangles, loose)
    covered, crowding = _find_parts_to_drop(clean, sheets, merged_triangles, loose)
    copied_area += _area_of(clean, covered)
    rows = other_rows(_joined(covered, crowding), merged_triangles.size, are_distinct=True)
    sets, twins = keep_corners(sheets.corner_sets(), rows), keep_corners(sheets.twins, rows)
    clean = clean.with_arrays(**clean.arrays.triangles_at(rows))
    used = count_referenced(clean.arrays["triangles"], vertices.size)
    corner_vertices = CornerVertices(clean.arrays["triangles"], vertices.size, sets)
    sewn = clean.with_arrays(triangles=corner_vertices.triangles, **clean.arrays.vertices_at(corner_vertices.rows))
    result = part_doubled_edges(sewn, twins)
    return Stitched(
        mesh=result,
        copies=repeated.size + covered.size,
        copied_area=copied_area,
        crowding=crowding.size,
        halved=len(result) - len(sewn),
        merged=used - corner_vertices.kept_count,
        split=result.arrays["vertices"].size - corner_vertices.kept_count,
        unused=vertices.size - used,
        open_sides=sum_counts(mark_negative(twins)),  # sync
        can_change=sheets.had_choice or covered.size > 0 or len(result) > len(sewn),
    )


def _find_worthless(mesh: MeshArrays, merged_triangles: Triangles, loose: Mask) -> tuple[Indices, Indices, Indices]:
    """Rows of loose triangles: degenerate, duplicate, duplicate in either orientation."""
    rows = positions_of(loose)  # sync
    candidates = gather_rows(merged_triangles, rows)
    vertices = mesh.arrays["vertices"]
    folded = positions_of(clean_triangles.mask_degenerate(vertices, candidates, zero_area=False))  # sync
    rest = other_rows(folded, rows.size, are_distinct=True)
    triangles, rows_left = gather_rows(candidates, rest), gather_rows(rows, rest)
    repeats = positions_of(clean_triangles.mask_repeats(triangles))  # sync
    classes, count = find_copies(triangles, vertices.size)  # sync
    oriented_repeats = repeats
    if count < rest.size:
        oriented_repeats = repeated_positions(classes, count)
    return gather_rows(rows, folded), gather_rows(rows_left, repeats), gather_rows(rows_left, oriented_repeats)


def _find_parts_to_drop(
    mesh: MeshArrays, sheets: Sheets, merged_triangles: Triangles, loose: Mask
) -> tuple[Indices, Indices]:
    """(rows of parts that copy others, rows of single triangles without a partner)."""
    count, device = merged_triangles.size, merged_triangles.device
    classes, class_count = find_copies(merged_triangles, mesh.arrays["vertices"].size)  # sync
    covered = np.zeros(count, np.bool_)
    if class_count < count:
        names = download(sheets.parts())  # sync
        copies = Copies(download(classes), download(merged_triangles).reshape(-1, 3))  # sync
        doubled = find_doubled(copies, names, download(loose) != 0)  # sync
        if doubled.any():
            sheets.part_copies(upload(doubled, uint8, device))
            names = download(sheets.parts())  # sync
        covered = find_covered(mesh, copies, names, download(sheets.twins))  # sync
    alone = positions_of(sheets.crowding)  # sync
    if alone.size:
        keep_alone(sheets.parts(), sheets.crowding)
        alone = positions_of(sheets.crowding)  # sync
    if not covered.any():
        return empty(0, int32, device), alone
    crowding = download(sheets.crowding) != 0  # sync
    return _rows_of(covered, device), _rows_of(crowding & ~covered, device)


def _rows_of(mask: NDArray[np.bool_], device: Device) -> Indices:
    return upload(np.flatnonzero(mask).astype(np.int32), int32, device)


def _joined(first: Indices, second: Indices) -> Indices:
    if not first.size or not second.size:
        return first if first.size else second
    return upload(np.concatenate([download(first), download(second)]), int32, first.device)  # sync


def _area_of(mesh: Any, rows: Indices) -> float:
    return get_surface_area(mesh.with_arrays(**mesh.arrays.triangles_at(rows))) if rows.size else 0.0


def part_doubled_edges(mesh: Mesh, twins: Indices) -> Mesh:
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
    mesh: Mesh, ends: NDArray[np.int32], rows: NDArray[np.int64], pieces: list[Any], weights: list[Any]
) -> Mesh:
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
