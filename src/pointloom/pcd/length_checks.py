"""Warnings for lengths that do not fit a cloud, for example in another unit or swapped with a count."""

from __future__ import annotations

import math
import sys
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.units import LengthUnit, called_by_user, symbol_of, warn_of_units
from ..core.wording import format_fraction
from ..kernels.arrays.select import gather_rows
from ..kernels.arrays.sort import positions
from ..kernels.lang import int32
from ..kernels.memory import download, upload
from ..kernels.search.point_tree import PointTree
from ..kernels.search.tree_search import count_around, search_nearest

MAX_UNCHECKED_POINTS = 10  # points without a warning
MAX_SINGLE_GROUP_POINTS = 100  # points above which one voxel, cluster or plane is suspicious
MIN_RADIUS_SPACINGS = 0.25  # of the surface spacing: smaller radii are checked
MIN_MEAN_NEIGHBORS = 1.1  # mean points within a radius, including the point itself: 90% have no neighbor
MAX_DISTANCE_RATIO = 1000.0  # ratio of distance to extent of unrelated data
MAX_SPARSE_FRACTION = 0.5  # of the points: more have too few neighbors for a radius of another cloud or unit
SAMPLE_POINTS = 200  # for the distance of the usual neighbor, whose rank then has a deviation of 4 %
MAX_NEIGHBORS = 1000  # of each of them: 8 B each
MIN_PLANE_FRACTION = 0.05  # of the points: with a smaller largest plane, the distance is probably too small

Bounds = tuple[NDArray[np.float64], NDArray[np.float64]]


def check_order(count_name: str, count: object, length_name: str, length: object) -> None:
    if isinstance(count, float) and isinstance(length, int) and not isinstance(length, bool):
        given = f"{count_name}={length}, {length_name}={count}"
        raise TypeError(f"{count_name}: expected an integer, got {count!r}; swapped? write {given}")


def warn_of_short(name: str, tree: PointTree, radius: float | None, unit: LengthUnit | None, so: str) -> None:
    """Warn if a radius finds no neighbors. Points are counted only if it is short for their extent."""
    if radius is None or tree.count <= MAX_UNCHECKED_POINTS:
        return
    extent = float(np.max(np.asarray(tree.high, np.float64) - tree.low))
    usual = extent / float(np.sqrt(tree.count))  # spacing of a surface
    if radius > MIN_RADIUS_SPACINGS * usual:
        return
    neighbor_count = count_around(tree, positions(tree.count, tree.device), radius)
    if neighbor_count < MIN_MEAN_NEIGHBORS:
        m = symbol_of(unit)
        others = f"{neighbor_count - 1:.2g} other points on average"
        warn_of_units(
            f"{name}: {radius:g} {m} contains {others}, so {so}. The cloud's {tree.count:,} points "
            f"span {extent:.3g} {m}. Give the {name} in the cloud's unit, about {2 * usual:.2g} {m}"
        )


def distance_of_nearest(tree: PointTree, count: int) -> float | None:
    """Distance [m] within which half of a sample has `count` points, themselves included. None if unknown."""
    if count > min(MAX_NEIGHBORS, tree.count):
        return None
    rows = np.arange(0, tree.count, max(1, tree.count // SAMPLE_POINTS), dtype=np.int32)
    sample = gather_rows(tree.points, upload(rows, int32, tree.device))
    nearest = download(search_nearest(tree, sample, count)[1]).reshape(len(rows), count)[:, -1]  # sync
    return float(np.sqrt(np.quantile(nearest.astype(np.float64), MAX_SPARSE_FRACTION)))


def warn_of_sparse(
    name: str, tree: PointTree, radius: float | None, count: int, unit: LengthUnit | None, so: str
) -> None:
    """Warn if most points have fewer than `count` points within a radius, themselves included."""
    if radius is None or tree.count <= MAX_UNCHECKED_POINTS:
        return
    if not called_by_user():
        warn_of_short(name, tree, radius, unit, so)
        return
    distance = distance_of_nearest(tree, count)
    if distance is not None and radius >= distance:
        return
    m = symbol_of(unit)
    message = f"{name}: most points have fewer than {count} points within {radius:g} {m}, themselves included, so {so}"
    if distance is None:
        warn_of_units(f"{message}. Give a larger {name}, or fewer neighbors")
    else:
        warn_of_units(
            f"{message}. Half of them have that many within {rounded_up(distance):g} {m}: give a larger {name}"
        )


def warn_of_complete_graph(neighbors: int, count: int) -> None:
    """Warn if signs of normals propagate between all pairs of points, themselves included in the neighbors."""
    if count > MAX_UNCHECKED_POINTS and neighbors >= count - 1:
        warn_of_units(
            f"k: {neighbors} neighbors join each of the {count} points to all others, so opposite sides of the surface "
            "exchange signs and about half of the normals may point inward. Give 10 to 30, fewer than the points",
            UserWarning,
        )


def warn_of_small_plane(count: int, limit: int, finite: int, distance: float, unit: LengthUnit | None) -> None:
    """Warn if the largest plane has few of the finite points, or if none has `limit` points (`count` 0)."""
    if finite < max(limit, MAX_SINGLE_GROUP_POINTS) or count >= MIN_PLANE_FRACTION * finite or not called_by_user():
        return
    m, remedy = symbol_of(unit), "Use a larger distance_threshold, or more num_iterations"
    if count:
        fraction = format_fraction(count / finite)
        warn_of_units(f"plane: the largest one has only {fraction} of the points within {distance:g} {m}. {remedy}")
    else:
        warn_of_units(f"plane: none has {limit:,} points within {distance:g} {m}. {remedy}")


def rounded_up(length: float) -> float:
    """A length rounded up to two digits."""
    step = 10.0 ** (math.floor(math.log10(max(length, sys.float_info.min))) - 1)
    return float(f"{math.floor(length / step + 1) * step:.2g}")


def warn_of_long(name: str, length: float, low: Any, high: Any, count: int, unit: LengthUnit | None, so: str) -> None:
    """Warn if a length exceeds the extent of the points."""
    extent = float(np.max(np.asarray(high, np.float64) - low)) if count >= MAX_SINGLE_GROUP_POINTS else 0.0
    if not (0 < extent < length and called_by_user()):
        return
    m, usual = symbol_of(unit), extent / float(np.sqrt(count))
    warn_of_units(
        f"{name}: {length:g} {m} exceeds the extent of the cloud's {count:,} points, {extent:.3g} {m}, so "
        f"{so}. Give the {name} in the cloud's unit: evenly spread points are about {usual:.2g} {m} apart"
    )


def warn_of_far(name: str, box: Bounds, cloud_box: Bounds, count: int, unit: LengthUnit | None) -> None:
    """Warn if a box is so far from a large cloud that position or unit differ."""
    (low, high), (cloud_low, cloud_high) = (map(np.asarray, each) for each in (box, cloud_box))
    gap = float(np.max(np.maximum(low - cloud_high, cloud_low - high)))
    span = float(max(np.max(high - low), np.max(cloud_high - cloud_low)))
    if count >= MAX_SINGLE_GROUP_POINTS and gap > MAX_DISTANCE_RATIO * span > 0 and called_by_user():
        m = symbol_of(unit)
        warn_of_units(
            f"{name}: is {gap:.3g} {m} from the cloud, which spans at most {span:.3g} {m}. The cloud begins at "
            f"{[round(float(x), 3) for x in cloud_low]}. Give the box in the cloud's coordinates"
        )
