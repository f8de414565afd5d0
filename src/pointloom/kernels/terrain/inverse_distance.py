"""Inverse distance weighting, sum(z / d^2) / sum(1 / d^2) (Shepard, "A two-dimensional interpolation function for
irregularly-spaced data", ACM 1968). Uses the points within a radius in the smallest square of cells that has enough of
them, so results do not depend on ties or search order.
"""

from ..array_types import Doubles, Points
from ..lang import NAN, array, float64, floor, func, isfinite, kernel, launch, tid, vec3
from ..memory import empty
from .cells import CellGroups, FixedCells


@func
def height_near(
    x: float64,
    y: float64,
    column: int,
    row: int,
    min_rings: int,
    max_rings: int,
    neighbors: int,
    max_sqdist: float64,
    window: FixedCells,
    groups: CellGroups,
) -> float64:
    """Height at a position. NaN if no point is within the radius."""
    total = float64(0.0)
    weights = float64(0.0)
    here = float64(0.0)  # of coincident points
    there = float64(0.0)
    count = int(0)
    for m in range(max_rings + 1):
        if m <= min_rings or count < neighbors:
            for a in range(2 * m + 1):
                u = column + a - m
                steps = 2  # inner columns of a square's border have a cell at either end
                stride = 2 * m
                if a == 0 or a == 2 * m:
                    steps = 2 * m + 1
                    stride = 1
                if u >= 0 and u < window.columns:
                    for b in range(steps):
                        v = row - m + b * stride
                        if v >= 0 and v < window.rows:
                            k = u * window.rows + v
                            for at in range(groups.starts[k], groups.starts[k + 1]):
                                p = groups.points[groups.order[at]]
                                dx = float64(p[0]) - x
                                dy = float64(p[1]) - y
                                sqdist = dx * dx + dy * dy
                                if sqdist <= max_sqdist:
                                    count += 1
                                    if sqdist == 0.0:
                                        here += float64(p[2])
                                        there += 1.0
                                    else:
                                        weight = 1.0 / sqdist
                                        total += weight * float64(p[2])
                                        weights += weight
    height = float64(NAN)
    if there > 0.0:
        height = here / there
    elif weights > 0.0:
        height = total / weights
    return height


@kernel
def interpolate_centers_kernel(
    cells: FixedCells,
    max_rings: int,
    neighbors: int,
    max_sqdist: float64,
    window: FixedCells,
    groups: CellGroups,
    heights: array(dtype=float64),
):
    i = tid()
    column = i // cells.rows
    row = i % cells.rows
    x = cells.x0 + (cells.column0 + float64(column) + 0.5) * cells.cell
    y = cells.y0 + (cells.row0 + float64(row) + 0.5) * cells.cell
    u = int(cells.column0 - window.column0) + column
    v = int(cells.row0 - window.row0) + row
    heights[i] = height_near(x, y, u, v, 0, max_rings, neighbors, max_sqdist, window, groups)


@kernel
def measure_heights_kernel(
    points: array(dtype=vec3),
    max_rings: int,
    neighbors: int,
    max_sqdist: float64,
    window: FixedCells,
    groups: CellGroups,
    heights: array(dtype=float64),
):
    """Height of each point above the interpolated surface. NaN if unknown."""
    i = tid()
    p = points[i]
    height = float64(NAN)
    if isfinite(p):
        x = float64(p[0])
        y = float64(p[1])
        u = floor((x - window.x0) / window.cell) - window.column0
        v = floor((y - window.y0) / window.cell) - window.row0
        rim = float64(max_rings)
        if u >= -rim and v >= -rim and u < float64(window.columns) + rim and v < float64(window.rows) + rim:
            height = float64(p[2]) - height_near(
                x, y, int(u), int(v), 1, max_rings, neighbors, max_sqdist, window, groups
            )
    heights[i] = height


def interpolate_centers(groups: CellGroups, cells: FixedCells, neighbors: int, radius: float, rings: int) -> Doubles:
    """Heights at cell centers, float64 device array; `cells` are of the groups' grid."""
    heights = empty(cells.size, float64, groups.points.device)
    arguments = [cells, rings, neighbors, radius * radius, groups.cells, groups, heights]
    launch(interpolate_centers_kernel, cells.size, arguments)
    return heights


def heights_above(points: Points, groups: CellGroups, neighbors: int, radius: float, rings: int) -> Doubles:
    """Heights of points above the groups' surface, float64 device array (n)."""
    heights = empty(points.size, float64, points.device)
    arguments = [points, rings, neighbors, radius * radius, groups.cells, groups, heights]
    launch(measure_heights_kernel, points.size, arguments)
    return heights
