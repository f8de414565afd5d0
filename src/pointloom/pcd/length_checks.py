"""Warnings for lengths that do not fit a cloud, for example in another unit or swapped with a count."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.units import LengthUnit, called_by_user, symbol_of, warn_of_units
from ..kernels.arrays.sort import positions
from ..kernels.search.point_tree import PointTree
from ..kernels.search.tree_search import count_around

MAX_UNCHECKED_POINTS = 10  # points without a warning
MAX_SINGLE_GROUP_POINTS = 100  # points above which one voxel, cluster or plane is suspicious
MIN_RADIUS_SPACINGS = 0.25  # of the surface spacing: smaller radii are checked
MIN_MEAN_NEIGHBORS = 1.1  # mean points within a radius, including the point itself: 90% have no neighbor
MAX_DISTANCE_RATIO = 1000.0  # ratio of distance to extent of unrelated data

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
