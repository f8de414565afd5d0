"""Distance fields beside scipy and edt, and occupancy beside OctoMap."""

from __future__ import annotations

from functools import cache, partial
from typing import Any

import numpy as np
from contest import POINTLOOM, Contestant, Operation, Trial, thread_count, timed
from numpy.typing import NDArray

Box = NDArray[np.bool_]
Scan = tuple[NDArray[np.float32], NDArray[np.float32]]

EDGE = 0.1  # voxel size of the occupancy grid [m]


@cache
def crowd(size: int) -> Box:
    """A box with 1 % of occupied voxels."""
    return np.random.default_rng(0).random((size,) * 3) < 0.01


@cache
def walls(size: int) -> Box:
    """A box with a floor, a wall and half a wall."""
    occupied = np.zeros((size,) * 3, bool)
    occupied[:, :, 0], occupied[0], occupied[:, size // 3, : size // 2] = True, True, True
    return occupied


def prepare_pointloom(occupied: Box, device: str) -> Any:
    import pointloom as loom

    return lambda: loom.DistanceField.from_array(occupied, device=device)


def prepare_scipy(occupied: Box, device: str) -> Any:
    from scipy import ndimage

    free = ~occupied
    return lambda: ndimage.distance_transform_edt(free, return_indices=True)[
        0
    ]  # also the nearest voxel, which pointloom stores too


def prepare_edt(occupied: Box, device: str) -> Any:
    import edt

    free, threads = np.ascontiguousarray(~occupied), thread_count()
    return lambda: edt.edt(free, parallel=threads)


def check_fields(actual: NDArray[Any], reference: NDArray[Any], peer: str) -> None:
    """Check for equal squared distances."""
    assert np.array_equal(actual, reference), peer


def squared(distances: Any) -> NDArray[np.int32]:
    """Squared distances as integers."""
    return np.rint(np.asarray(distances, np.float64) ** 2).astype(np.int32)


DISTANCE_FIELD = Operation(
    name="distance_field",
    scenes={"1 % of 256^3": partial(crowd, 256), "walls in 256^3": partial(walls, 256)},
    quick={"1 % of 32^3": partial(crowd, 32)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, lambda field: field.to_array(values="squared"), ("cpu", "cuda")),
        Contestant("scipy", prepare_scipy, squared),
        Contestant("edt", prepare_edt, squared),
    ),
    check=check_fields,
)


@cache
def room_scan(count: int) -> Scan:
    """Points on the walls of a room of 20 x 16 x 6 m with 10 % noise, and the sensor position in its center."""
    rng = np.random.default_rng(0)
    start, directions = np.array([0.3, 0.2, 0.1], np.float32), rng.normal(size=(count, 3))
    ranges = rng.uniform(0.9, 1.0, (count, 1)) / np.abs(directions / [10, 8, 3]).max(axis=1, keepdims=True)
    return (directions * ranges).astype(np.float32) + start, start


def insert_into_pointloom(scan: Scan, device: str) -> Any:
    import pointloom as loom

    ends, start = scan
    cloud = loom.PointCloud(ends, device=device)

    def fresh() -> Any:
        return loom.OccupancyGrid(EDGE, device=device)

    def insert(grid: Any) -> Any:
        grid.insert_scan(cloud, start)
        return grid

    return Trial(insert, fresh)


def insert_into_octomap(scan: Scan, device: str) -> Any:
    import pyoctomap

    ends, start = (np.asarray(values, np.float64) for values in scan)

    def insert(tree: Any) -> Any:
        tree.insertPointCloud(ends, start)
        return tree

    def fresh() -> Any:
        tree = pyoctomap.OcTree(EDGE)
        model = (("ProbHit", 0.7), ("ProbMiss", 0.4), ("ClampingThresMin", 0.1192), ("ClampingThresMax", 0.971))
        for name, value in model:
            getattr(tree, f"set{name}")(value)
        return tree

    return Trial(insert, fresh)


def known_of_pointloom(grid: Any) -> NDArray[np.int64]:
    """Numbers of occupied and free voxels."""
    odds = grid.to_array()
    return np.array([(odds >= 0.5).sum(), (odds < 0.5).sum()])


def known_of_octomap(tree: Any) -> NDArray[np.int64]:
    """Numbers of occupied and free voxels; a pruned leaf counts for all its voxels."""
    known = np.zeros(2, np.int64)
    for leaf in tree.begin_leafs():
        known[int(leaf.current_node.getLogOdds() < 0)] += round(leaf.getSize() / EDGE) ** 3
    return known


OCCUPANCY = Operation(
    name="occupancy_insert",
    scenes={"100k points": partial(room_scan, 100_000)},
    quick={"2k points": partial(room_scan, 2000)},
    contestants=(
        Contestant(POINTLOOM, insert_into_pointloom, known_of_pointloom, ("cpu", "cuda")),
        Contestant("octomap", insert_into_octomap, known_of_octomap),
    ),
    check=check_fields,
)
OPERATIONS = (DISTANCE_FIELD, OCCUPANCY)


@timed(DISTANCE_FIELD)
def test_distance_field(time_lap) -> None:
    time_lap()


@timed(OCCUPANCY)
def test_occupancy_insert(time_lap) -> None:
    time_lap()
