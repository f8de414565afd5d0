"""Heights of triangles at cell centers, and raster rows (north first). The lowest triangle containing a center wins
(atomic minimum). Edges are evaluated from their lower vertex, so no center falls between two.
"""

import numpy as np

from ..array_types import Doubles, Indices, Integers, Mask, Points, Scalars, Triangles
from ..lang import (
    NAN,
    array,
    atomic_min,
    compute,
    float32,
    float64,
    floor,
    func,
    int32,
    kernel,
    launch,
    tid,
    uint8,
    vec3,
    vec3i,
)
from ..memory import empty, full, upload
from .cells import FixedCells

TABLE_SIZE = 256


@kernel
def keep_listed_kernel(values: array(dtype=int32), table: array(dtype=uint8), mask: array(dtype=uint8)):
    i = tid()
    value = values[i]
    if value < 0 or value >= TABLE_SIZE:
        mask[i] = uint8(0)
    elif table[value] == 0:
        mask[i] = uint8(0)


def keep_listed(values: Integers, table: np.ndarray, mask: Mask) -> None:
    """Clear a mask where `table`, bool (256), excludes a value."""
    launch(keep_listed_kernel, values.size, [values, upload(table, uint8, values.device), mask])


@kernel
def lay_rows_kernel(
    values: array(dtype=float64),
    below: array(dtype=float64),
    is_above: int,
    divisor: float64,
    base: float64,
    cells: FixedCells,
    out: array(dtype=float32),
):
    """(value / divisor) minus `below`, or plus `base`."""
    i = tid()
    row = i // cells.columns
    cell = (i - row * cells.columns) * cells.rows + (cells.rows - 1 - row)
    value = values[cell] / divisor
    if is_above != 0:
        value = value - below[cell]
    else:
        value = value + base
    out[i] = float32(value)


def lay_rows(
    values: Doubles, cells: FixedCells, *, below: Doubles | None = None, divisor: float = 1.0, base: float = 0.0
) -> Scalars:
    """Raster, float32 (rows * columns): `values` / `divisor`, minus `below`, or plus `base` if that is None."""
    out = empty(cells.size, float32, values.device)
    other = values if below is None else below
    launch(lay_rows_kernel, cells.size, [values, other, int(below is not None), divisor, base, cells, out])
    return out


NO_TRIANGLE = 2**31 - 1


@func
def side_of(points: array(dtype=vec3), a: int, b: int, x: float64, y: float64) -> float64:
    """Twice the signed area of two vertices and a position; positive to the left."""
    low = min(a, b)
    high = max(a, b)
    p = points[low]
    q = points[high]
    ux = float64(q[0]) - float64(p[0])
    uy = float64(q[1]) - float64(p[1])
    side = ux * (y - float64(p[1])) - uy * (x - float64(p[0]))
    if low != a:
        side = -side
    return side


@kernel
def claim_cells_kernel(
    points: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    longest: float64,
    cells: FixedCells,
    owners: array(dtype=int32),
):
    """Lowest triangle at each cell center (atomic minimum)."""
    i = tid()
    t = triangles[i]
    p = points[t[0]]
    q = points[t[1]]
    r = points[t[2]]
    edge = float64(0.0)
    for k in range(3):
        here = points[t[k]]
        there = points[t[(k + 1) % 3]]
        dx = float64(there[0]) - float64(here[0])
        dy = float64(there[1]) - float64(here[1])
        edge = max(edge, dx * dx + dy * dy)
    if edge <= longest * longest:
        x0 = floor((float64(min(min(p[0], q[0]), r[0])) - cells.x0) / cells.cell) - cells.column0
        x1 = floor((float64(max(max(p[0], q[0]), r[0])) - cells.x0) / cells.cell) - cells.column0
        y0 = floor((float64(min(min(p[1], q[1]), r[1])) - cells.y0) / cells.cell) - cells.row0
        y1 = floor((float64(max(max(p[1], q[1]), r[1])) - cells.y0) / cells.cell) - cells.row0
        first = int(min(max(x0, 0.0), float64(cells.columns)))
        end = int(min(max(x1 + 1.0, 0.0), float64(cells.columns)))
        low = int(min(max(y0, 0.0), float64(cells.rows)))
        high = int(min(max(y1 + 1.0, 0.0), float64(cells.rows)))
        for u in range(first, end):
            x = cells.x0 + (cells.column0 + float64(u) + 0.5) * cells.cell
            for v in range(low, high):
                y = cells.y0 + (cells.row0 + float64(v) + 0.5) * cells.cell
                a = side_of(points, t[0], t[1], x, y)
                b = side_of(points, t[1], t[2], x, y)
                c = side_of(points, t[2], t[0], x, y)
                if (a >= 0.0 and b >= 0.0 and c >= 0.0) or (a <= 0.0 and b <= 0.0 and c <= 0.0):
                    atomic_min(owners, u * cells.rows + v, i)


@kernel
def weigh_corners_kernel(
    points: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    cells: FixedCells,
    owners: array(dtype=int32),
    heights: array(dtype=float64),
):
    i = tid()
    height = float64(NAN)
    if owners[i] != NO_TRIANGLE:
        t = triangles[owners[i]]
        x = cells.x0 + (cells.column0 + float64(i // cells.rows) + 0.5) * cells.cell
        y = cells.y0 + (cells.row0 + float64(i % cells.rows) + 0.5) * cells.cell
        a = side_of(points, t[1], t[2], x, y)
        b = side_of(points, t[2], t[0], x, y)
        c = side_of(points, t[0], t[1], x, y)
        total = a * float64(points[t[0]][2]) + b * float64(points[t[1]][2]) + c * float64(points[t[2]][2])
        height = total / (a + b + c)
    heights[i] = height


def triangle_heights(points: Points, triangles: Triangles, cells: FixedCells, longest: float) -> Doubles:
    """Heights of triangles at cell centers, float64, NaN for none. Edges above `longest` in plan are skipped."""
    owners: Indices = full(cells.size, NO_TRIANGLE, int32, points.device)
    launch(claim_cells_kernel, triangles.size, [points, triangles, longest, cells, owners])
    return compute(weigh_corners_kernel, cells.size, [points, triangles, cells, owners], float64, points.device)
