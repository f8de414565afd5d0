"""Visibility check: candidate viewpoints of a cloud, and points of another cloud that block the view.

Viewpoints on a grid over the box are kept if few of the cloud's points are hidden. Points of another cloud in front of
the surface from all viewpoints contradict a common scene. Each view is a cube map of minimum distances. A point blocks
only if nearer than all nine cells around it. Assumes one nearly stationary sensor.
"""

from collections.abc import Sequence

import numpy as np

from ..algebra.rigid_solve import move
from ..algebra.transform import widen
from ..array_types import Integers, Points
from ..arrays.bounds import bound_each
from ..arrays.side_by_side import read_together
from ..extent.hull_filter import grid_index, locate_direction
from ..lang import (
    INFINITY,
    array,
    atomic_add,
    atomic_min,
    float32,
    func,
    int32,
    kernel,
    launch,
    length,
    mat44d,
    struct,
    tid,
    vec3,
    vec3d,
)
from ..memory import contiguous, full, upload, zeros

EDGE_CELLS = 40  # cells per face edge: 2.25 degrees, some 5 cm at 1.3 m
VIEWPOINTS_PER_AXIS = 8  # viewpoints per axis of the box: 0.5 to 1 m apart in a room
MAX_COMPARED_POINTS = 2048  # maximum points used to compare viewpoints
MAX_VIEWPOINTS = 48
# Of the points: tolerance on hidden points relative to the best viewpoint, since sensors move a little
HIDDEN_TOLERANCE = 0.02
MAX_HIDDEN = 0.1  # of the points hidden from the best viewpoint, above which no viewpoint is accepted
MIN_SEPARATION = 0.1  # of a distance: minimum separation of two surfaces, since a cell is 2.25 degrees wide
POINTS_PER_THREAD = 32  # points per thread


@struct
class Sight:
    """A cloud seen from viewpoints: `ranges` [m] per cube-map cell, infinite if empty. Surface `margin` [m]."""

    viewpoints: array(dtype=vec3d)
    ranges: array(dtype=float32)
    viewpoint_count: int
    width: int
    margin: float

    def __init__(self, points: Points, viewpoints: np.ndarray, margin: float) -> None:
        """Render finite points from viewpoints, float64 (k, 3)."""
        self.viewpoint_count, self.width, self.margin, self.device = len(viewpoints), EDGE_CELLS, margin, points.device
        self.viewpoints = upload(viewpoints, vec3d, points.device)
        self.ranges = full(self.viewpoint_count * 6 * EDGE_CELLS * EDGE_CELLS, INFINITY, float32, points.device)
        launch(draw_ranges_kernel, self.viewpoint_count * points.size, [points, self, self.ranges])

    def count_hidden(self, points: Points) -> Integers:
        """Points behind the surface from each viewpoint: int32 (k)."""
        counts = zeros(self.viewpoint_count, int32, self.device)
        runs = -(-points.size // POINTS_PER_THREAD)
        launch(count_hidden_kernel, self.viewpoint_count * runs, [points, points.size, self, counts])
        return counts

    def count_occluding(self, points: Points, pose: np.ndarray) -> Integers:
        """Posed points in front of the surface from each viewpoint: int32 (k)."""
        counts = zeros(self.viewpoint_count, int32, self.device)
        runs = -(-points.size // POINTS_PER_THREAD)
        arguments = [points, points.size, mat44d(*pose.ravel().tolist()), self, counts]
        launch(count_occluding_kernel, self.viewpoint_count * runs, arguments)
        return counts


@func
def cell_of(p: vec3d, width: int) -> int:
    location = locate_direction(p)
    row = int(location[0]) * width + grid_index(location[1], width)
    return row * width + grid_index(location[2], width)


@kernel
def draw_ranges_kernel(points: array(dtype=vec3), sight: Sight, ranges: array(dtype=float32)):
    i = tid()
    viewpoint = i % sight.viewpoint_count
    p = widen(points[i // sight.viewpoint_count]) - sight.viewpoints[viewpoint]
    cell = viewpoint * 6 * sight.width * sight.width + cell_of(p, sight.width)
    distance = float(length(p))
    if distance < ranges[cell]:  # usually false, which limits contention
        atomic_min(ranges, cell, distance)  # minimum: order-independent


@kernel
def count_hidden_kernel(points: array(dtype=vec3), count: int, sight: Sight, counts: array(dtype=int32)):
    i = tid()
    viewpoint = i % sight.viewpoint_count
    first = i // sight.viewpoint_count * POINTS_PER_THREAD
    hidden = 0
    for k in range(first, min(first + POINTS_PER_THREAD, count)):
        p = widen(points[k]) - sight.viewpoints[viewpoint]
        cell = viewpoint * 6 * sight.width * sight.width + cell_of(p, sight.width)
        if float(length(p)) > sight.ranges[cell] * float(1.0 + MIN_SEPARATION) + sight.margin:
            hidden += 1
    if hidden > 0:
        atomic_add(counts, viewpoint, hidden)  # integer sum: order-independent


@func
def min_range_around(sight: Sight, viewpoint: int, p: vec3d) -> float:
    """Minimum over the nine cells around a direction, within its face. 0 if its own is empty."""
    location = locate_direction(p)
    u = grid_index(location[1], sight.width)
    v = grid_index(location[2], sight.width)
    face = (viewpoint * 6 + int(location[0])) * sight.width * sight.width
    minimum = float(0.0)
    if sight.ranges[face + u * sight.width + v] < INFINITY:
        minimum = sight.ranges[face + u * sight.width + v]
        for a in range(max(u - 1, 0), min(u + 2, sight.width)):
            for b in range(max(v - 1, 0), min(v + 2, sight.width)):
                minimum = min(minimum, sight.ranges[face + a * sight.width + b])
    return minimum


@kernel
def count_occluding_kernel(
    points: array(dtype=vec3), count: int, pose: mat44d, sight: Sight, counts: array(dtype=int32)
):
    i = tid()
    viewpoint = i % sight.viewpoint_count
    first = i // sight.viewpoint_count * POINTS_PER_THREAD
    before = 0
    for k in range(first, min(first + POINTS_PER_THREAD, count)):
        p = move(pose, widen(points[k])) - sight.viewpoints[viewpoint]
        if float(length(p)) < min_range_around(sight, viewpoint, p) * float(1.0 - MIN_SEPARATION) - sight.margin:
            before += 1
    if before > 0:
        atomic_add(counts, viewpoint, before)  # integer sum: order-independent


def find_sights(clouds: Sequence[Points], margins: Sequence[float]) -> list[Sight | None]:
    """Candidate viewpoints of finite points of each cloud, or None if none sees most of it. Deterministic, two syncs.

    `margins` [m]: of the surfaces.
    """
    sights: list[Sight | None] = [None] * len(clouds)
    rows = [k for k, points in enumerate(clouds) if points.size]
    if not rows:
        return sights
    some = [contiguous(clouds[k][:: max(1, -(-clouds[k].size // MAX_COMPARED_POINTS))]) for k in rows]
    viewpoints = [_grid_in(low, high) for low, high, _ in bound_each(some)]  # sync
    views = [Sight(points, grid, margins[k]) for points, grid, k in zip(some, viewpoints, rows, strict=True)]
    hidden = read_together([view.count_hidden(points) for view, points in zip(views, some, strict=True)])  # sync
    for k, points, grid, counts in zip(rows, some, viewpoints, hidden, strict=True):
        fractions = counts / points.size
        order = np.argsort(fractions, kind="stable")
        selected = order[fractions[order] <= fractions[order[0]] + HIDDEN_TOLERANCE]
        if fractions[order[0]] <= MAX_HIDDEN:
            sights[k] = Sight(clouds[k], grid[selected[:: -(-len(selected) // MAX_VIEWPOINTS)]], margins[k])
    return sights


def _grid_in(low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """Viewpoints on a grid over a box, float64 (k, 3)."""
    low, high = low.astype(np.float64), high.astype(np.float64)
    step = (high - low) / VIEWPOINTS_PER_AXIS
    axes = [low[k] + step[k] * (np.arange(VIEWPOINTS_PER_AXIS) + 0.5) for k in range(3)]
    return np.stack(np.meshgrid(*axes, indexing="ij"), -1).reshape(-1, 3)
