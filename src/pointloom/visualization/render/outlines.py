"""Geometries drawn as lines: boxes, cameras, trajectories, hulls, polygons."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_rows
from ...core.coordinates import split_origin
from ...kernels.lang import int32, vec3
from ...kernels.memory import upload
from ...pcd.polygon_volume import AXIS_ORDERS as PLANES
from .parts import Lines, Triple

AXES_COLORS = np.array([[0.85, 0.15, 0.15], [0.15, 0.65, 0.20], [0.15, 0.30, 0.85]])  # x, y, z
MAX_AXES = 100  # poses of a trajectory drawn with axes
AXIS_FRACTION = 0.03  # length of these axes over the trajectory's extent

# Edges between corners in the order of `get_box_points`.
BOX_EDGES = [[0, 1], [0, 2], [0, 3], [1, 6], [1, 7], [2, 5], [2, 7], [3, 5], [3, 6], [4, 5], [4, 6], [4, 7]]
FRUSTUM_EDGES = [[0, 1], [0, 2], [0, 3], [0, 4], [1, 2], [2, 3], [3, 4], [4, 1], [1, 5], [2, 5]]


@dataclasses.dataclass(frozen=True, eq=False)
class Segments:
    """Segments on the host: points (n, 3) [m], int lines (m, 2), colors (m, 3) from 0 to 1 or None, else `plain`."""

    points: NDArray[np.float64]
    lines: NDArray[Any]
    colors: NDArray[np.float64] | None = None
    plain: Triple | None = None


def upload_lines(segments: Segments, device: Any) -> Lines:
    local, origin = split_origin(segments.points)
    colors = np.empty((0, 3)) if segments.colors is None else segments.colors
    indices = upload(np.asarray(segments.lines, np.int32).reshape(-1), int32, device)
    part = Lines(upload(local, vec3, device), origin, indices, upload(colors, vec3, device))
    return part if segments.plain is None else dataclasses.replace(part, plain=segments.plain)


def of_line_set(lines: Any) -> Segments:
    """Segments of a LineSet or an object with its attributes."""
    points = check_rows("points", lines.points, 3, dtype=np.float64)
    pairs = check_rows("lines", lines.lines, 2)
    if pairs.size and (pairs.min() < 0 or pairs.max() >= len(points)):
        raise ValueError(f"lines: expected indices of {len(points)} points, got {pairs.min()} to {pairs.max()}")
    colors = getattr(lines, "colors", None)
    if colors is None or len(colors) == 0:
        return Segments(points, pairs)
    return Segments(points, pairs, check_rows("colors", colors, 3, rows=len(pairs), dtype=np.float64))


def of_box(box: Any) -> Segments:
    """Edges of a box in its own color unless that is white or black (defaults)."""
    red, green, blue = np.asarray(getattr(box, "color", (0, 0, 0)), np.float64).tolist()
    plain = None if red == green == blue and red in (0, 1) else (red, green, blue)
    return Segments(np.asarray(box.get_box_points(), np.float64), np.array(BOX_EDGES), plain=plain)


def of_frustum(frustum: Any) -> Segments:
    points = np.vstack([frustum.T_world_camera[:3, 3], frustum.corners()])
    return Segments(points, np.array(FRUSTUM_EDGES), plain=frustum.color)


def of_trajectory(trajectory: Any) -> Segments:
    """Path of a trajectory, with axes of some poses."""
    poses = np.asarray(trajectory.poses, np.float64)
    poses = poses[np.isfinite(poses).all(axis=(1, 2))]
    if not len(poses):
        return Segments(np.empty((0, 3)), np.empty((0, 2), int))
    positions, count = poses[:, :3, 3], len(poses)
    path = np.column_stack([np.arange(count - 1), np.arange(1, count)])
    shown = np.unique(np.linspace(0, count - 1, min(count, MAX_AXES)).round().astype(int))
    length = AXIS_FRACTION * float(np.ptp(positions, axis=0).max()) or 0.1
    tips = positions[shown, None] + length * poses[shown, :3, :3].transpose(0, 2, 1)
    axes = np.column_stack([np.repeat(shown, 3), count + np.arange(3 * len(shown))])
    colors = np.vstack([np.tile((0.1, 0.1, 0.1), (count - 1, 1)), np.tile(AXES_COLORS, (len(shown), 1))])
    return Segments(np.vstack([positions, tips.reshape(-1, 3)]), np.vstack([path, axes]), colors)


def of_triangles(vertices: NDArray[np.float64], triangles: NDArray[Any]) -> Segments:
    edges = np.sort(np.asarray(triangles)[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    return Segments(np.asarray(vertices, np.float64), np.unique(edges, axis=0))


def of_volume(volume: Any) -> Segments:
    """Polygon of a SelectionPolygonVolume at both ends of its axis, with connecting edges."""
    corners, axis = volume.bounding_polygon, PLANES[volume.orthogonal_axis][2]
    low, high = corners.copy(), corners.copy()
    low[:, axis], high[:, axis] = volume.axis_min, volume.axis_max
    count = len(corners)
    ring = np.column_stack([np.arange(count), (np.arange(count) + 1) % count])
    sides = np.column_stack([np.arange(count), np.arange(count) + count])
    return Segments(np.vstack([low, high]), np.vstack([ring, ring + count, sides]), plain=(0.80, 0.20, 0.15))
