"""Cells of rasters, the points that count in them, and ground heights."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.checks import check_finite, check_numeric, check_shape, shown
from ..core.units import DEGREE, is_same
from ..kernels.array_types import Device, Doubles, Points
from ..kernels.arrays.bounds import bound_points
from ..kernels.arrays.select import gather_rows, positions_of
from ..kernels.lang import NAN, float64, int32, uint8, vec3i
from ..kernels.memory import cast, download, free_bytes, full, upload
from ..kernels.terrain.cells import (
    CELL_COUNT,
    CELL_MAX,
    CELL_MEAN,
    CELL_MIN,
    CellGroups,
    FixedCells,
    check_cell_numbers,
)
from ..kernels.terrain.cells import heights_of as heights_of_points
from ..kernels.terrain.inverse_distance import heights_above, interpolate_centers
from ..kernels.terrain.triangle_heights import TABLE_SIZE, keep_listed, lay_rows, triangle_heights
from .cloud import PointCloud

GROUND_CLASSES, NOISE_CLASSES = (2,), (7, 18)  # LAS classes
DEFAULT_RADIUS = 20  # default, in cells
MAX_CELLS = 2**28
CELL_BYTES = 32  # per cell
Vector = NDArray[np.float64]
BORDER_TOLERANCE = 1e-9  # of a cell: tolerance for bounds at cell borders


def check_classes(classes: object) -> tuple[int, ...] | None:
    if classes is None:
        return None
    given = np.atleast_1d(check_numeric("classes", classes))
    if (
        given.ndim != 1
        or not given.size
        or given.dtype.kind not in "iu"
        or given.min() < 0
        or given.max() >= TABLE_SIZE
    ):
        raise ValueError(f"classes: expected LAS classes from 0 to 255, such as (2, 8), got {shown(classes)}")
    return tuple(sorted({int(value) for value in given}))


def check_box(bounds: object) -> NDArray[np.float64]:
    box = check_finite("bounds", check_shape("bounds", bounds, (4,)))
    if not (box[0] < box[2] and box[1] < box[3]):
        raise ValueError(f"bounds: expected (x0, y0, x1, y1) with x0 < x1 and y0 < y1, got {shown(bounds)}")
    return box


def check_lengths(cloud: PointCloud) -> None:
    if cloud.unit is not None and is_same(cloud.unit, DEGREE):
        raise ValueError("cloud: expected a unit of length, got degrees. Convert it with project_to_utm(cloud)")


def window_of(points: Points, corner: Any, side: float, box: Any, origin: Any) -> FixedCells:
    if box is None:
        low, high, finite = bound_points(points)
        if not finite:
            raise ValueError("cloud: expected finite points, got none. Pass bounds to create a raster without values")
        first, shape = cells_over(low, high, corner, side)
    else:
        first, shape = cells_within(box.reshape(2, 2) - origin[:2] - corner, side)
    check_grid_room(side, shape, points.device)
    check_cell_numbers(first, shape)
    return FixedCells(corner, side, first, shape)


def cells_over(low: Vector, high: Vector, corner: Vector, side: float) -> tuple[Vector, Vector]:
    """Half-open cells that contain a range, both ends included: first cell and count along x and y."""
    with np.errstate(over="ignore", invalid="ignore"):  # overflow means too many cells
        first, last = (np.floor((end.astype(np.float64)[:2] - corner) / side) for end in (low, high))
        return first, last - first + 1


def cells_within(ends: Vector, side: float) -> tuple[Vector, Vector]:
    """Cells of a box with ends at or within cells, as `cells_over`; x and y from the corner."""
    with np.errstate(over="ignore", invalid="ignore"):
        first = np.floor(ends[0] / side + BORDER_TOLERANCE)
        return first, np.maximum(np.ceil(ends[1] / side - BORDER_TOLERANCE) - first, 1.0)


def check_grid_room(side: float, shape: NDArray[np.float64], device: Device, cell_bytes: int = CELL_BYTES) -> None:
    with np.errstate(over="ignore"):
        cells = float(shape.prod())
    message = f"cell: {side:g} gives {shape[0]:,.0f} x {shape[1]:,.0f} cells"
    if not cells <= MAX_CELLS:
        gigabytes = f"{cells * cell_bytes / 1e9:,.0f} GB"
        raise ValueError(f"{message}, {gigabytes}, more than 2^28 cells. Use larger cells or tiles")
    free = free_bytes(device)
    if free is not None and cells * cell_bytes > free:
        message += f", which need {cells * cell_bytes / 1e9:.2f} GB, but {device} has {free / 1e9:.2f} GB free"
        raise MemoryError(f"{message}. Use larger cells or tiles")


def _rings(radius: float, side: float, occupied: Any, queried: Any) -> int:
    """Number of rings of cells that may contain points within reach."""
    span = np.maximum(occupied[0] + occupied[1], queried[0] + queried[1]) - np.minimum(occupied[0], queried[0])
    return int(min(math.ceil(min(radius / side, 2.0**30)), span.max()))


def chosen_points(cloud: PointCloud, classes: tuple[int, ...] | None, *, is_ground: bool = False) -> Points:
    """Points of some classes (None: all but noise). Only first returns, except for the ground."""
    rows = _rows(cloud, classes, is_first=not is_ground, is_needed=is_ground or classes is not None)
    points = cloud.arrays["points"]
    if rows is None:
        return points
    if is_ground and not rows.size:
        raise NoGroundError(
            f"cloud: expected points of class {' or '.join(map(str, classes or GROUND_CLASSES))}, got none. "
            'Classify the ground with classify_ground(cloud) and set cloud["classification"]'
        )
    return gather_rows(points, rows)


class NoGroundError(ValueError):
    """There are no ground points."""


def _rows(cloud: PointCloud, classes: tuple[int, ...] | None, *, is_first: bool, is_needed: bool) -> Any:
    has_classes = "classification" in cloud
    if is_needed and not has_classes:
        raise ValueError(
            'cloud: has no classification; set cloud["classification"] to 2 where classify_ground(cloud) is True'
        )
    table = np.zeros(TABLE_SIZE, np.uint8)
    table[list(range(TABLE_SIZE) if classes is None else classes)] = 1
    if classes is None:
        table[list(NOISE_CLASSES)] = 0
    returns = np.zeros(TABLE_SIZE, np.uint8)
    returns[:2] = 1  # some files do not number returns
    tables = [("classification", table)] if has_classes else []
    tables += [("return_number", returns)] if is_first and "return_number" in cloud else []
    if not tables:
        return None
    mask = full(len(cloud), 1, uint8, cloud.device)
    for name, listed in tables:
        keep_listed(cast(cloud.arrays[name], int32), listed, mask)
    return positions_of(mask)


def ground_heights(ground: Points, window: FixedCells, method: str, radius: float | None, count: int) -> Doubles:
    """Ground height at each cell center, about the points' origin."""
    if method == "tin":
        return triangle_heights(ground, _triangles(ground), window, math.inf if radius is None else radius)
    far = DEFAULT_RADIUS * window.cell if radius is None else radius
    low, high, finite = bound_points(ground)
    nothing = full(window.size, NAN, float64, ground.device)
    if not finite:
        return nothing
    first, shape = cells_over(low, high, np.array([window.x0, window.y0]), window.cell)
    rim = math.ceil(min(far / window.cell, 2.0**30))
    corner, size = np.array([window.column0, window.row0]), np.array([window.columns, window.rows])
    rings = _rings(far, window.cell, (first, shape), (corner, size))
    begin = np.maximum(first, corner - rim)
    shape = np.minimum(first + shape, corner + size + rim) - begin
    if (shape <= 0).any():
        return nothing
    check_grid_room(window.cell, shape, ground.device)
    occupied = FixedCells(np.array([window.x0, window.y0]), window.cell, begin, shape)
    return interpolate_centers(CellGroups(ground, occupied), window, count, far, rings)


def _triangles(ground: Points) -> Any:
    from scipy.spatial import Delaunay, QhullError  # slow import

    xyz = download(ground).reshape(-1, 3).astype(np.float64)
    rows = np.flatnonzero(np.isfinite(xyz).all(axis=1))  # also finite heights
    try:
        triangles = rows[Delaunay(xyz[rows, :2]).simplices]
    except (QhullError, ValueError) as error:
        reason = (
            f"expected ground points that form a triangle, got {len(rows):,} finite ones, fewer than 3 or collinear"
        )
        raise ValueError(f"cloud: {reason}. Use method='idw'") from error
    return upload(triangles.astype(np.int32), vec3i, ground.device)


def measured_cells(cloud: PointCloud, window: FixedCells, kind: str, classes: tuple[int, ...] | None) -> Doubles:
    is_first = kind in ("dsm", "chm")
    rows = _rows(cloud, classes, is_first=is_first, is_needed=classes is not None)
    points = cloud.arrays["points"]
    chosen = points if rows is None else gather_rows(points, rows)
    groups = CellGroups(chosen, window)
    if kind == "intensity":
        column = cloud.arrays.required("intensity", "it is required for kind='intensity'")
        if column.ndim != 1:
            raise ValueError("intensity: expected one number per point")
        values = cast(column if rows is None else gather_rows(column, rows), float64)
        return groups.measure(values, CELL_MEAN)
    measure = {"density": CELL_COUNT, "lowest": CELL_MIN}.get(kind, CELL_MAX)
    return groups.measure(heights_of_points(chosen), measure)


def raster_values(kind: str, surface: Any, ground: Any, window: FixedCells, base: float) -> NDArray[np.float32]:
    """Raster rows, north first, from values about the origin at height `base`."""
    if kind == "chm":
        laid = lay_rows(surface, window, below=ground)
    elif kind == "density":
        laid = lay_rows(surface, window, divisor=window.cell * window.cell)
    elif kind == "intensity":
        laid = lay_rows(surface, window)
    else:
        laid = lay_rows(ground if kind == "dtm" else surface, window, base=base)
    return np.asarray(download(laid)).reshape(window.rows, window.columns)


def heights_above_ground(
    points: Points, ground: Points, corner: Any, side: float, radius: float, count: int
) -> Doubles:
    """Heights of points above ground. NaN far from ground points."""
    low, high, finite = bound_points(ground)
    if not finite:
        return full(points.size, NAN, float64, points.device)
    first, shape = cells_over(low, high, corner, side)
    check_grid_room(side, shape, points.device)
    check_cell_numbers(first, shape)
    groups = CellGroups(ground, FixedCells(corner, side, first, shape))
    low, high, _ = bound_points(points)
    first_cell, size = cells_over(low, high, corner, side)
    return heights_above(points, groups, count, radius, _rings(radius, side, (first, shape), (first_cell, size)))
