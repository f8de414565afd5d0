"""Small components on both sides of a cut: islands to drop and holes to keep.

Source: SurfaceTrimmer of PoissonRecon (Kazhdan).
"""

from ..array_types import Array1, Mask, Points, Triangles
from ..arrays.select import invert_mask
from ..lang import array, atomic_max, float64, func, int32, int64, kernel, launch, reduce, tid, uint8, vec2d
from ..memory import zeros
from .level_cut import LevelCut
from .mesh_components import Parts
from .mesh_measures import measure_triangle
from .mesh_topology import sorted_edges


@func
def is_small(part: int, parts: Parts, ratio: float64, twice: array(dtype=vec2d)) -> int:
    """1 if a component has less than a fraction of the mesh area; `twice` is twice that area."""
    total = twice[0]
    return 1 if parts.doubled[part] / 2.0 < ratio * (total[0] / 2.0) else 0


@kernel
def drop_islands_kernel(parts: Parts, ratio: float64, twice: array(dtype=vec2d), mask: array(dtype=uint8)):
    i = tid()
    if mask[i] != 0:
        small = is_small(int(parts.labels[i]), parts, ratio, twice)
        if small == 1:
            mask[i] = uint8(0)


@kernel
def keep_holes_kernel(
    parts: Parts,
    ratio: float64,
    twice: array(dtype=vec2d),
    is_open: array(dtype=int32),
    touches: array(dtype=int32),
    mask: array(dtype=uint8),
):
    i = tid()
    part = int(parts.labels[i])
    if part < mask.shape[0]:
        small = is_small(part, parts, ratio, twice)
        if small == 1 and is_open[part] == 0 and touches[part] == 1:
            mask[i] = uint8(1)


@kernel
def find_edges_of_parts_kernel(
    keys: array(dtype=int64),
    order: array(dtype=int32),
    labels: array(dtype=int64),
    is_open: array(dtype=int32),
    touches: array(dtype=int32),
):
    """Components at the mesh boundary, and those adjacent to triangles of none. All threads write 1."""
    i = tid()
    count = labels.shape[0]
    part = int(labels[order[i] // 3])
    if part < count:
        first = i
        while first > 0 and keys[max(first - 1, 0)] == keys[i]:
            first -= 1
        last = i + 1
        while last < keys.shape[0] and keys[min(last, keys.shape[0] - 1)] == keys[i]:
            last += 1
        if last - first == 1:
            atomic_max(is_open, part, 1)
        for j in range(first, last):
            if labels[order[j] // 3] == int64(count):
                atomic_max(touches, part, 1)


def change_small_parts(vertices: Points, pieces: Triangles, mask: Mask, ratio: float, twice: Array1[vec2d]) -> None:
    """Clear `mask` of small selected components, then set it for small others that selected ones enclose."""
    device, count = pieces.device, pieces.size
    edges = sorted_edges(pieces, vertices.size)
    islands = Parts(vertices, pieces, mask, edges)
    launch(drop_islands_kernel, count, [islands, ratio, twice, mask])
    holes = Parts(vertices, pieces, invert_mask(mask), edges)
    is_open, touches = zeros(count, int32, device), zeros(count, int32, device)
    keys, order = edges
    launch(find_edges_of_parts_kernel, keys.size, [keys, order, holes.labels, is_open, touches])
    launch(keep_holes_kernel, count, [holes, ratio, twice, is_open, touches, mask])


def mask_trimmed(vertices: Points, cut: LevelCut, uncut: Triangles, island_ratio: float) -> Mask:
    """Pieces of a cut that remain, uint8 [p]. Components below a fraction of the area change sides. No sync."""
    if island_ratio > 0:
        twice = reduce(measure_triangle, uncut.size, [vertices, uncut])
        change_small_parts(vertices, cut.pieces, cut.above, island_ratio, twice)
    return cut.above
