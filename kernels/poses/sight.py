"""Places from which all of a cloud can have been seen, and what of another cloud stands between them and it.

A sensor sees through the air before it meets a surface, so nothing else stands there. Where it stood is mostly not
known, but not everywhere can it have stood: what it saw does not hide behind itself. So places all over the cloud's box
are tried, and those are kept from which least of the cloud is hidden by the rest. Another cloud that stands in the way
from each of them is not of the same scene, wherever the sensor was.

From a place the cloud is a cube map of distances. A cell holds the least, so that a cloud with gaps hides too little,
never too much, and a point is in the way only if it is nearer than all nine cells around it. The places fit one sensor
that hardly moved; where none sees most of the cloud nothing is known. Places are compared by some of the points, which
hide less than all do.

Some 40 operations a point and place: (PLACES^3 + KEPT) x SAMPLE to find places, KEPT a point and cloud to judge it.
4 B a cell and place.
"""

import numpy as np

from ..algebra.rigid_solve import move
from ..algebra.transform import widen
from ..array_types import Integers, Points
from ..arrays.bounds import bound_points
from ..extent.hull_filter import grid_place, locate_direction
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
from ..memory import contiguous, download, full, upload, zeros

WIDTH = 40  # cells along an edge of a face: 2.25 degrees, some 5 cm at 1.3 m
PLACES = 8  # along each axis of the box in which places are tried: 0.5 to 1 m in a room
SAMPLE = 2048  # points at most by which places are judged
KEPT = 48  # places at most
EQUAL = 0.02  # of the points, by which more may be hidden than from the best place, since sensors move a little
HIDDEN = 0.1  # of the points hidden from the best place, above which no place shows the cloud
SLACK = 0.1  # of a distance, that two surfaces are apart at least: a cell is 2.25 degrees wide and floors are flat
RUN = 32  # points a thread


@struct
class Sight:
    """A cloud as it is seen from some places.

    Attributes:
        places: Where from [m], device array of vec3d.
        ranges: Distance [m] of the nearest point of each place's cells, infinite where there is none.
        place_count, width: How many places; cells along an edge of a face of the cube map.
        margin: Distance [m] that two surfaces are apart at least, beside SLACK.
    """

    places: array(dtype=vec3d)
    ranges: array(dtype=float32)
    place_count: int
    width: int
    margin: float

    def __init__(self, points: Points, places: np.ndarray, margin: float) -> None:
        """Draw a device array of finite points from places, float64 [k, 3]."""
        self.place_count, self.width, self.margin, self.device = len(places), WIDTH, margin, points.device
        self.places = upload(places, vec3d, points.device)
        self.ranges = full(self.place_count * 6 * WIDTH * WIDTH, INFINITY, float32, points.device)
        launch(draw_ranges_kernel, self.place_count * points.size, [points, self, self.ranges])

    def count_hidden(self, points: Points) -> np.ndarray:
        """How many of some points lie behind the surface, as seen from each place: int32 [k]. One sync."""
        counts = zeros(self.place_count, int32, self.device)
        runs = -(-points.size // RUN)
        launch(count_hidden_kernel, self.place_count * runs, [points, points.size, self, counts])
        return download(counts)  # sync

    def count_in_the_way(self, points: Points, pose: np.ndarray) -> Integers:
        """How many of some points under a pose stand before the surface, seen from each place: int32 [k]."""
        counts = zeros(self.place_count, int32, self.device)
        runs = -(-points.size // RUN)
        arguments = [points, points.size, mat44d(*pose.ravel().tolist()), self, counts]
        launch(count_in_the_way_kernel, self.place_count * runs, arguments)
        return counts


@func
def cell_of(p: vec3d, width: int) -> int:
    """The cell of a direction."""
    place = locate_direction(p)
    row = int(place[0]) * width + grid_place(place[1], width)
    return row * width + grid_place(place[2], width)


@kernel
def draw_ranges_kernel(points: array(dtype=vec3), sight: Sight, ranges: array(dtype=float32)):
    """The distance of the nearest point of each cell; the minimum is the same in any order."""
    i = tid()
    place = i % sight.place_count
    p = widen(points[i // sight.place_count]) - sight.places[place]
    cell = place * 6 * sight.width * sight.width + cell_of(p, sight.width)
    distance = float(length(p))
    if distance < ranges[cell]:  # mostly not, so that few threads meet at the atomic
        atomic_min(ranges, cell, distance)


@kernel
def count_hidden_kernel(points: array(dtype=vec3), count: int, sight: Sight, counts: array(dtype=int32)):
    """Count what lies behind the nearest point of its cell; the sum of whole numbers is the same in any order."""
    i = tid()
    place = i % sight.place_count
    first = i // sight.place_count * RUN
    hidden = 0
    for k in range(first, min(first + RUN, count)):
        p = widen(points[k]) - sight.places[place]
        cell = place * 6 * sight.width * sight.width + cell_of(p, sight.width)
        if float(length(p)) > sight.ranges[cell] * float(1.0 + SLACK) + sight.margin:
            hidden += 1
    if hidden > 0:
        atomic_add(counts, place, hidden)


@func
def least_around(sight: Sight, place: int, p: vec3d) -> float:
    """The least distance of the nine cells around a direction's, within its face; 0 where its own is empty."""
    located = locate_direction(p)
    u = grid_place(located[1], sight.width)
    v = grid_place(located[2], sight.width)
    face = (place * 6 + int(located[0])) * sight.width * sight.width
    least = float(0.0)
    if sight.ranges[face + u * sight.width + v] < INFINITY:
        least = sight.ranges[face + u * sight.width + v]
        for a in range(max(u - 1, 0), min(u + 2, sight.width)):
            for b in range(max(v - 1, 0), min(v + 2, sight.width)):
                least = min(least, sight.ranges[face + a * sight.width + b])
    return least


@kernel
def count_in_the_way_kernel(
    points: array(dtype=vec3), count: int, pose: mat44d, sight: Sight, counts: array(dtype=int32)
):
    """Count what is nearer than the cells around it; the sum of whole numbers is the same in any order."""
    i = tid()
    place = i % sight.place_count
    first = i // sight.place_count * RUN
    before = 0
    for k in range(first, min(first + RUN, count)):
        p = move(pose, widen(points[k])) - sight.places[place]
        if float(length(p)) < least_around(sight, place, p) * float(1.0 - SLACK) - sight.margin:
            before += 1
    if before > 0:
        atomic_add(counts, place, before)


def find_sight(points: Points, margin: float) -> Sight | None:
    """How a cloud was seen, from all places of a grid from which it can have been.

    Args:
        points: Device array of finite points.
        margin: Distance [m] that two surfaces are apart at least where one hides the other.

    Returns:
        The sight; None where no place shows the cloud. Two syncs. The same bits from run to run.
    """
    if not points.size:
        return None
    some = contiguous(points[:: max(1, -(-points.size // SAMPLE))])
    low, high = (corner.astype(np.float64) for corner in bound_points(some)[:2])  # sync
    step = (high - low) / PLACES
    axes = [low[k] + step[k] * (np.arange(PLACES) + 0.5) for k in range(3)]
    places = np.stack(np.meshgrid(*axes, indexing="ij"), -1).reshape(-1, 3)
    hidden = Sight(some, places, margin).count_hidden(some) / some.size
    order = np.argsort(hidden, kind="stable")
    kept = order[hidden[order] <= hidden[order[0]] + EQUAL]
    if hidden[order[0]] > HIDDEN:
        return None
    return Sight(points, places[kept[:: -(-len(kept) // KEPT)]], margin)
