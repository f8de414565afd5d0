"""Convert triangles to manifold sheets: no edge of more than two, no vertex of several fans, no duplicates."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from ...kernels.array_types import Device, Indices, Mask, Triangles
from ...kernels.arrays.duplicates import find_equal_points
from ...kernels.arrays.prefix_sum import sum_counts
from ...kernels.arrays.select import gather_rows, mark_negative, positions_of
from ...kernels.arrays.sort import positions
from ...kernels.arrays.subsets import other_rows
from ...kernels.lang import int32, uint8
from ...kernels.memory import download, empty, upload
from ...kernels.meshes import clean_triangles, merge_vertices
from ...kernels.meshes.copies import find_copies
from ...kernels.meshes.corner_vertices import CornerVertices, keep_corners
from ...kernels.meshes.mesh_edits import count_referenced, repeated_positions
from ...kernels.meshes.orientation import Orientation, flip_some, flip_some_corners, flip_some_normals
from ...kernels.meshes.part_votes import keep_alone
from ...kernels.meshes.sheets import Sheets, mask_loose
from .covered_parts import Copies, find_covered, find_doubled
from .doubled_edges import part_doubled_edges
from .measures import get_surface_area
from .mesh_arrays import MeshArrays
from .selection import remove_degenerate_triangles

MeshType = TypeVar("MeshType", bound=MeshArrays)
MAX_PASSES = 8
SUMMED = "copies", "copied_area", "crowding", "halved", "merged", "unused", "degenerate"


@dataclass(frozen=True)
class Stitched(Generic[MeshType]):
    """A mesh of sheets, and counts of changes. `copies`, `copied_area`: removed duplicates, either orientation.
    `crowding`: triangles without a partner. `halved`: triangles added to separate double edges. `merged`, `split`,
    `unused`: vertices. `open_sides`: boundary half-edges. `degenerate`: triangles with a repeated vertex or
    position. `can_change`: True if another pass can find more to do. `flipped`: triangles reversed
    between passes."""

    mesh: MeshType
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

    def after(self, first: Stitched[MeshType], flipped: int) -> Stitched[MeshType]:
        """Add the counts of the passes before. Vertices that one pass splits and the next one merges do not count."""
        undone = min(first.split, self.merged)
        sums = {name: getattr(first, name) + getattr(self, name) for name in SUMMED}
        sums["merged"] -= undone
        return replace(self, split=first.split - undone + self.split, flipped=first.flipped + flipped, **sums)


def cut_and_stitch(mesh: MeshType) -> Stitched[MeshType]:
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


def flipped_mesh(mesh: MeshType, flips: Mask) -> MeshType:
    arrays: dict[str, Any] = {"triangles": flip_some(mesh.arrays["triangles"], flips)}
    if "triangle_uvs" in mesh.arrays:
        arrays["triangle_uvs"] = flip_some_corners(mesh.arrays["triangle_uvs"], flips)
    if "vertex_normals" in mesh.arrays:
        surface = mesh.arrays["vertices"], arrays["triangles"]
        arrays["vertex_normals"] = flip_some_normals(mesh.arrays["vertex_normals"], *surface, flips)
    return mesh.with_arrays(**arrays)


def _stitch_once(mesh: MeshType) -> Stitched[MeshType]:
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


def _sew(
    mesh: MeshType, merged_triangles: Triangles, loose: Mask, folded: Indices, repeated: Indices
) -> Stitched[MeshType]:
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
