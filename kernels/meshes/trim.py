"""Which parts of the two sides of a cut are too small to count: islands to be dropped, holes to be kept.

Source: SurfaceTrimmer of PoissonRecon (Kazhdan), whose islands and holes are these.
"""

from ..array_types import Mask, Points, Triangles
from ..arrays.pair_sort import argsort_pairs
from ..arrays.select import invert_mask, positions_of
from ..lang import array, atomic_max, int32, int64, kernel, launch, tid, uint8
from ..memory import download, empty, full, zeros
from .level_cut import LevelCut
from .mesh_components import Components
from .mesh_edits import keep_triangles
from .mesh_measures import measure
from .mesh_topology import list_edge_keys_kernel


@kernel
def spread_mask_kernel(rows: array(dtype=int32), chosen: array(dtype=uint8), value: int, mask: array(dtype=uint8)):
    """Set the mask to a value at the chosen ones of some rows."""
    i = tid()
    if chosen[i] == 1:
        mask[rows[i]] = uint8(value)


@kernel
def spread_parts_kernel(rows: array(dtype=int32), labels: array(dtype=int64), parts: array(dtype=int32)):
    """The part of each of some rows."""
    i = tid()
    parts[rows[i]] = int(labels[i])


@kernel
def find_edges_of_parts_kernel(
    keys: array(dtype=int64),
    order: array(dtype=int32),
    parts: array(dtype=int32),
    is_open: array(dtype=int32),
    touches: array(dtype=int32),
):
    """Which parts end at the mesh's own border, and which touch what is in none; any thread may set it to 1."""
    i = tid()
    part = parts[order[i] // 3]
    if part >= 0:
        first = i
        while first > 0 and keys[max(first - 1, 0)] == keys[i]:
            first -= 1
        last = i + 1
        while last < keys.shape[0] and keys[min(last, keys.shape[0] - 1)] == keys[i]:
            last += 1
        if last - first == 1:
            atomic_max(is_open, part, 1)
        for j in range(first, last):
            if parts[order[j] // 3] < 0:
                atomic_max(touches, part, 1)


def drop_islands(vertices: Points, triangles: Triangles, mask: Mask, least: float) -> None:
    """Clear the mask (uint8 [t]) of parts of the chosen triangles whose area is below `least`."""
    rows = positions_of(mask)  # sync
    parts = Components(vertices, keep_triangles(triangles, mask))
    chosen = parts.mask(parts.areas < least)
    launch(spread_mask_kernel, rows.size, [rows, chosen, 0, mask])


def keep_holes(vertices: Points, triangles: Triangles, mask: Mask, least: float) -> None:
    """Set the mask of parts of the other triangles whose area is below `least` and that chosen ones enclose."""
    device = triangles.device
    others = invert_mask(mask)
    rows = positions_of(others)  # sync
    found = Components(vertices, keep_triangles(triangles, others))
    parts = full(triangles.size, -1, int32, device)
    launch(spread_parts_kernel, rows.size, [rows, found.labels, parts])
    bits = max(1, vertices.size.bit_length())
    keys = empty(3 * triangles.size, int64, device)
    launch(list_edge_keys_kernel, triangles.size, [triangles, bits, keys])
    keys, order = argsort_pairs(keys, bits, vertices.size)
    is_open, touches = (zeros(len(found.counts), int32, device) for _ in range(2))
    launch(find_edges_of_parts_kernel, keys.size, [keys, order, parts, is_open, touches])
    enclosed = (download(is_open) == 0) & (download(touches) == 1)  # sync
    chosen = found.mask(enclosed & (found.areas < least))
    launch(spread_mask_kernel, rows.size, [rows, chosen, 1, mask])


def mask_trimmed(vertices: Points, cut: LevelCut, whole: Triangles, island_ratio: float) -> Mask:
    """Which pieces of a cut stay.

    Args:
        vertices: vec3, those of the pieces.
        cut: The mesh cut at the level.
        whole: vec3i [t], the triangles before.
        island_ratio: Parts of less than this share of the whole area change sides.

    Returns:
        uint8 [p].
    """
    area, mask = measure(vertices, whole)[0], cut.above
    if island_ratio > 0:
        drop_islands(vertices, cut.pieces, mask, island_ratio * area)
        keep_holes(vertices, cut.pieces, mask, island_ratio * area)
    return mask
