"""Image of two clouds before and after registration: `draw_pair`."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.coordinates import split_origin
from ...pcd.cloud import PointCloud
from .picture_files import write_image
from .render import render
from .view import Triple, fit_view

Matrix = NDArray[np.float64]

SOURCE_COLOR, TARGET_COLOR = (1.0, 0.706, 0.0), (0.0, 0.651, 0.929)  # as in Open3D's tutorials: source, target

_PANEL_WIDTH, _PANEL_GAP = 960, 8  # [px]
_DISC_DIAMETER = 3.0  # [px]
_VIEW_TILT = 0.35  # tilt of the view against its axis
_MAX_FLATNESS = 0.35  # a cloud thinner than this times its width (standard deviations) is seen from above
_MIN_CAMERA_DISTANCE = 0.5  # [standard deviations of z] minimum distance of a camera from the points

# Fraction of the points that may be outside the image: far hits of a scanner.
_LEFT_OUT = 0.02
_MAX_VIEW_POINTS = 100_000  # points for choosing the view


def draw_pair(path: Any, source: PointCloud, target: PointCloud, T: Matrix, *, overwrite: bool = True) -> None:
    """Render target (blue) and source (orange), left as given, right under T_target_source, to a .png file."""
    still = _some(target)
    direction, up = usual_look(still)
    panels = []
    for moved in (source, source.transform(T)):
        core = np.vstack([_core(still), _core(_some(moved))])
        view = fit_view(core, direction=direction, up=up, width=_PANEL_WIDTH, height=_PANEL_WIDTH)
        pair = [{"geometry": _bare(target), "color": TARGET_COLOR}, {"geometry": _bare(moved), "color": SOURCE_COLOR}]
        panels.append(render(pair, view, point_size=_DISC_DIAMETER))
    gap = np.full((_PANEL_WIDTH, _PANEL_GAP, 3), 255, np.uint8)
    write_image(path, np.hstack([panels[0], gap, panels[1]]), overwrite=overwrite)


def _bare(cloud: PointCloud) -> PointCloud:
    """The cloud without normals, so that eye-dome lighting shows depth."""
    return cloud.without("normals") if cloud.has_normals else cloud


def _some(cloud: PointCloud) -> Matrix:
    points = cloud.uniform_down_sample(max(1, len(cloud) // _MAX_VIEW_POINTS)).points
    return points[np.isfinite(points).all(axis=1)]


def _core(points: Matrix) -> Matrix:
    gaps = np.linalg.norm(points - np.median(points, axis=0), axis=1)
    return points[gaps <= np.quantile(gaps, 1 - _LEFT_OUT)]


def usual_look(points: Matrix) -> tuple[Triple, Triple]:
    """View direction and up for a cloud.

    If all points have z > 0, the view is that of a camera at the origin, with y down. Other clouds are displayed along
    their flattest axis: from above if they are as flat as streets and terrain, else from the front. The up axis is
    z, or y if the view is along z.
    """
    spreads = (points - np.median(points, axis=0)).std(axis=0)
    x, y, z = np.eye(3)
    nearest = np.quantile(points[:, 2], _LEFT_OUT)
    if nearest > _MIN_CAMERA_DISTANCE * spreads[2] and not split_origin(points)[1].any():
        return _triple(z + _VIEW_TILT * (0.5 * x + y)), _triple(-y)
    axis = int(np.argmin(spreads))
    flat, up = np.eye(3)[axis], y if axis == 2 else z
    lean = 2 * _VIEW_TILT if spreads[axis] < _MAX_FLATNESS * np.sort(spreads)[1] else -_VIEW_TILT
    return _triple(-flat + lean * up), _triple(up)


def _triple(vector: NDArray[np.float64]) -> Triple:
    x, y, z = vector.tolist()
    return x, y, z
