"""Terrain as rasters, and heights above the ground."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.checks import check_count, check_finite, check_positive, check_shape, shown
from ..core.coordinate_systems import map_crs
from ..kernels.lang import float32
from ..kernels.memory import cast
from ..kernels.terrain.ground_in_reach import radius_in_cells
from .cloud import PointCloud
from .ground import CELL_SIZE, MAX_WINDOW, check_window
from .point_arrays import check_cloud
from .raster import MIN_NEIGHBORS, Raster
from .raster_cells import (
    GROUND_CLASSES,
    check_box,
    check_classes,
    check_lengths,
    chosen_points,
    ground_heights,
    heights_above_ground,
    measured_cells,
    raster_values,
    window_of,
)

OF_HEIGHTS = ("dtm", "dsm", "lowest")  # above the datum of the cloud's heights
KINDS = ("dtm", "dsm", "chm", "density", "intensity", "lowest")
METHODS = ("idw", "tin")


def rasterize(
    cloud: PointCloud,
    cell: float,
    kind: str = "dtm",
    *,
    method: str = "idw",
    reach: float | None = None,
    neighbors: int = MIN_NEIGHBORS,
    classes: ArrayLike | None = None,
    corner: ArrayLike = (0.0, 0.0),
    bounds: ArrayLike | None = None,
    crs: str | None = None,
) -> Raster:
    """Rasterize a survey: bare earth, surface, canopy height, density or intensity.

    Cells are half-open and counted from a fixed `corner`, so rasters of parts fit together. "idw" depends only on
    points within `reach`, so tiles give identical results; "tin" is closer on slopes (docs/terrain.md). Bitwise
    reproducible.

    Args:
        cloud: The survey, z up.
        cell: Edge of a cell [m].
        kind: "dtm", ground height at cell centers; "dsm", highest first return; "chm", dsm minus dtm; "density", points
            per square unit; "intensity", mean of the finite values; "lowest", lowest point.
        method: Ground interpolation: "idw", inverse distance; "tin", Delaunay triangles by SciPy on the CPU.
        reach: With "idw" the maximum distance of a cell center to ground points [m], default 20 cells. With "tin" the
            maximum edge of a triangle, default none. Cells beyond are empty.
        neighbors: With "idw" the minimum ground points in the smallest square of cells used.
        classes: LAS classes that count. If None: ground (2) for the ground, otherwise all but noise (7 and 18).
        corner: A corner of cells, x and y.
        bounds: (x0, y0, x1, y1) of the raster. If None: those of the cloud.
        crs: Coordinate system for files as rasterio accepts it: "EPSG:26910", "EPSG:25832+7837" or well-known text. If
            None: that of the cloud, with the system of its heights for "dtm", "dsm" and "lowest".

    Returns:
        A Raster. Cells without points are empty, with density 0.

    Raises:
        TypeError, ValueError: If `cloud` is not a PointCloud, or if an argument is out of range, coordinates are
            degrees, no points or required classes exist, the ground has no triangle, or there are more than 2^28 cells.
        MemoryError: If the raster does not fit into memory.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> rng = np.random.default_rng(0)
        >>> x, y = rng.uniform(0, 50, (2, 20_000))
        >>> tree = np.hypot(x - 25, y - 25) < 5
        >>> z = 0.1 * x + np.where(tree, 8.0, 0.0)
        >>> cloud = loom.PointCloud(np.column_stack([x, y, z]), classification=np.where(tree, 5, 2).astype(np.uint8))
        >>> canopy = loom.rasterize(cloud, 1.0, "chm")
        >>> canopy.values.shape, round(float(np.nanmax(canopy.values)))
        ((50, 50), 8)
    """
    check_cloud("cloud", cloud)
    side = check_positive("cell", cell)
    for name, value, known in (("kind", kind, KINDS), ("method", method, METHODS)):
        if value not in known:
            raise ValueError(f"{name}: expected {' or '.join(map(repr, known))}, got {shown(value)}")
    class_numbers = check_classes(classes)
    far = None if reach is None else check_positive("reach", reach)
    count = check_count("neighbors", neighbors)
    start = check_finite("corner", check_shape("corner", corner, (2,)))
    box = None if bounds is None else check_box(bounds)
    check_lengths(cloud)
    points = cloud.arrays["points"]
    window = window_of(points, start - cloud.origin[:2], side, box, cloud.origin)
    surface = ground = None
    if kind in ("dtm", "chm"):
        chosen = chosen_points(cloud, GROUND_CLASSES if class_numbers is None else class_numbers, is_ground=True)
        ground = ground_heights(chosen, window, method, far, count)
    if kind != "dtm":
        surface = measured_cells(cloud, window, kind, None if kind == "chm" else class_numbers)
    values = raster_values(kind, surface, ground, window, float(cloud.origin[2]))
    low = start + np.array([window.column0, window.row0]) * side
    system = map_crs("crs, cloud", crs, cloud.crs, with_heights=kind in OF_HEIGHTS)
    return Raster(values, low, side, np.zeros(values.shape, bool), kind, system, unit=cloud.unit)


def height_above_ground(
    cloud: PointCloud,
    *,
    reach: float = 20.0,
    neighbors: int = MIN_NEIGHBORS,
    cell: float = 1.0,
    corner: ArrayLike = (0.0, 0.0),
    classes: ArrayLike | None = GROUND_CLASSES,
) -> NDArray[np.float32]:
    """Height of each point above nearby ground points, interpolated by inverse distance in plan.

    Args:
        cloud: A classified survey, z up.
        reach: Maximum distance of ground points in plan [m]. Points farther away do not change the result.
        neighbors: Minimum ground points in the smallest square of cells used, at least 3 x 3.
        cell: Edge of those cells [m], about the ground point spacing.
        corner: A corner of the cells.
        classes: LAS classes of the ground.

    Returns:
        float32 (n,). NaN without ground in reach and for points that are not finite. 28 B per point, 4 B per cell.

    Raises:
        TypeError: If `cloud` is not a PointCloud.
        ValueError: If an argument is out of range, coordinates are degrees, or there is no `classification` or ground.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> ground = np.random.default_rng(0).random((2000, 3)) * (20, 20, 0)
        >>> cloud = loom.PointCloud(np.vstack([ground, [[10, 10, 7]]]), classification=np.array([2] * 2000 + [5]))
        >>> float(loom.height_above_ground(cloud)[-1])
        7.0
    """
    check_cloud("cloud", cloud)
    far, side = check_positive("reach", reach), check_positive("cell", cell)
    count = check_count("neighbors", neighbors)
    start = check_finite("corner", check_shape("corner", corner, (2,)))
    class_numbers = check_classes(classes)
    check_lengths(cloud)
    points = cloud.arrays["points"]
    ground = chosen_points(cloud, GROUND_CLASSES if class_numbers is None else class_numbers, is_ground=True)
    return cloud.arrays.hand_out(
        cast(heights_above_ground(points, ground, start - cloud.origin[:2], side, far, count), float32)
    )


def ground_reach(cell_size: float = CELL_SIZE, max_window: float = MAX_WINDOW) -> float:
    """Radius along x and y [m] that `classify_ground` with a `corner` depends on.

    The sum of the two small fillings, the closing of low points, twice the largest window, the filling of the bare
    earth, and cells of its slope.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.pcd.terrain import ground_reach
        >>> ground_reach(cell_size=1.0, max_window=18.0)
        141.0
    """
    cell, window = check_positive("cell_size", cell_size), check_positive("max_window", max_window)
    check_window(window, cell)
    return (radius_in_cells(math.ceil(window / cell)) + 1) * cell
