"""Images of change detection: `loom.draw_change`."""

from __future__ import annotations

import dataclasses
import os
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.argument_errors import explain_argument_errors
from ...core.checks import check_numeric, check_positive
from ...core.exchange import asnumpy, on_host
from ...core.units import symbol_of
from ...meshing.scene.cloud_change import CloudToMeshResult
from ...pcd.change import M3C2Result
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud
from ..render.coloring import Coloring, color_cloud
from ..render.colormaps import MISSING_COLOR
from ..render.picture import Picture
from ..render.picture_files import write_image
from ..render.render import render
from ..render.view import ViewLike

COLORMAP = "coolwarm"  # blue below, red above, neutral at zero
MAX_COLORED_DISTANCE = 1e100  # maximum distance for colors
LAST_COLOR_QUANTILE = 0.98  # quantile of the changes at the last color: outliers must not compress the colors
VIEW_FROM_ABOVE = {
    "front": [0.0, 0.0, 1.0],
    "up": [0.0, 1.0, 0.0],
    "zoom": 0.58,
    "field_of_view": 20.0,
}  # as on a map, y up
UNCHANGED, UNKNOWN = "not significant", "no distance"


@explain_argument_errors
def paint_change(
    cloud: PointCloud, change: M3C2Result | CloudToMeshResult | ArrayLike, *, limit: float | None = None
) -> PointCloud:
    """Color the points of a cloud by signed distance: red positive, blue negative, gray not significant.

    Args:
        cloud: Core points of the measurement.
        change: Result of `m3c2` or `compare_cloud_to_mesh`, or distances (n,) [m], all taken as significant.
        limit: Distance of the darkest red [m]. Blue is its negative. If None, the 98th percentile of the changes.

    Returns:
        The colored cloud. Points without significant change or without a distance are gray.

    Raises:
        ValueError, TypeError: Wrong number of distances, `limit` not positive, or unsupported types.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.visualization.change.pictures import paint_change
        >>> cloud = loom.PointCloud([[0, 0, 0], [1, 0, 0], [2, 0, 0]])
        >>> paint_change(cloud, [0.5, -0.5, 0], limit=0.5).colors.astype(float).round(2).tolist()
        [[0.71, 0.02, 0.15], [0.23, 0.3, 0.75], [0.87, 0.87, 0.87]]
    """
    return _painted(cloud, change, limit)[0]


@explain_argument_errors
def draw_change(
    cloud: PointCloud,
    change: M3C2Result | CloudToMeshResult | ArrayLike,
    path: str | os.PathLike[str] | None = None,
    *,
    limit: float | None = None,
    title: str = "change",
    camera: ViewLike = None,
    size: tuple[int, int] = (1280, 960),
    point_size: float | None = None,
    overwrite: bool = True,
) -> Picture:
    """Render changes with a color bar in the cloud's unit, a scale bar and a legend for gray.

    Args:
        cloud, change, limit: See `paint`.
        path: A .png or .webp file to write, or None.
        title: Title of the color bar. The unit is appended.
        camera: See `render`. If None, a view from above with y up, as on a map.
        size: Width and height [px].
        point_size: Diameter of points [px]. If None, large enough to close most gaps.
        overwrite: Replace an existing file.

    Returns:
        A Picture, uint8 RGB. Bitwise identical on every device.

    Raises:
        ValueError, TypeError: See `paint` and `render`.
        FileError: The image cannot be written.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> cloud = loom.PointCloud(np.random.default_rng(0).random((2_000, 3)) * (10, 10, 0))
        >>> picture = loom.draw_change(cloud, cloud.points[:, 0] - 5, "change.png", size=(320, 240))
        >>> picture.shape
        (240, 320, 3)
    """
    painted, bar, entries = _painted(cloud, change, limit)
    picture = render(
        painted,
        dict(VIEW_FROM_ABOVE) if camera is None else camera,
        size,
        point_size=point_size,
        shading="none",
        legend=entries or None,
        color_bar=dataclasses.replace(bar, title=f"{title} [{symbol_of(cloud.unit)}]"),
        scale_bar=True,
    )
    if path is not None:
        write_image(path, picture, overwrite=overwrite)
    return picture


def _painted(cloud: Any, change: Any, limit: float | None) -> tuple[PointCloud, Coloring, list[tuple[str, Any]]]:
    """The colored cloud, its coloring, and the legend entries for gray."""
    check_cloud("cloud", cloud)
    distances, changed = _distances_of(change)
    if distances.shape != (len(cloud),):
        raise ValueError(f"change: expected {len(cloud)} distances, one per point, got {list(distances.shape)}")
    known = np.isfinite(distances)
    shown = np.where(changed & known, distances, np.nan)
    max_change = _limit_of(shown) if limit is None else check_positive("limit", limit, maximum=MAX_COLORED_DISTANCE)
    coloring = color_cloud(cloud, shown, colormap=COLORMAP, limits=(-max_change, max_change))
    gray = [UNCHANGED] * bool((known & ~changed).any()) + [UNKNOWN] * (not known.all())
    painted = cloud.with_arrays(cloud.arrays | {"colors": coloring.colors}, grid=cloud.grid)
    return painted, dataclasses.replace(coloring, has_missing=False), [(", ".join(gray), MISSING_COLOR)] if gray else []


def _distances_of(change: M3C2Result | CloudToMeshResult | ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    if isinstance(change, M3C2Result | CloudToMeshResult):
        return asnumpy(change.distances), asnumpy(change.is_significant)
    values = check_numeric("change", on_host("change", change)).astype(np.float64)
    return values, np.ones(values.shape, np.bool_)


def _limit_of(shown: NDArray[np.float64]) -> float:
    """98th percentile of the changes, rounded up to 2 digits. 1 if there are none."""
    sizes = np.abs(shown[np.isfinite(shown)])
    largest = float(np.quantile(sizes, LAST_COLOR_QUANTILE)) if len(sizes) else 0.0
    if largest <= 0:
        return 1.0
    step = 10.0 ** (np.floor(np.log10(largest)) - 1)
    return float(np.ceil(largest / step - 1e-9) * step)
