"""A scan against a voxel map, by as many loops of robust ICP as are asked for, with one wait for the device.

What stands on the device stays there from scan to scan: on CUDA the graph is made once for the arrays of a map, which
move when it grows or is cut. 56 B a point of the largest scan so far, 270 B more on CUDA.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..algebra.rigid_solve import TRIANGLE, UNKNOWNS
from ..array_types import Device, Points
from ..lang import DeviceLoop, float64, launch
from ..memory import download, empty, write
from . import map_course
from .map_course import (
    FOLD,
    GIVEN,
    MOST_LEGS,
    ORDER,
    PLANE_RUN,
    RESULT,
    SQSUM,
    STATE,
    TAKEN,
    Course,
    add_planes_kernel,
    associate_points_kernel,
    begin_course_kernel,
    fold_rows_kernel,
    load_scan_kernel,
    step_pose_kernel,
    sum_planes_kernel,
)
from .map_icp import SUMS
from .voxel_map import VoxelMap

CPU_RUN = 32  # points a thread: some tens of threads for a scan, and as few rows to add up
CUDA_RUN = 1  # a GPU needs the threads; a second stage adds up FOLD rows each
LEAST_PAIRS = 6  # fewer do not fix a pose against noise
LEAST_ROOM = 1024  # points of a scan


@dataclass(frozen=True, eq=False)
class Leg:
    """What a leg of a course is asked for.

    Attributes:
        pose: Where it begins, T_map_sensor, float64 [4, 4], if `start` is GIVEN.
        max_distance: Correspondences are closer than this [m], and in the 27 voxels around.
        kernel_scale: Geman-McClure's scale [m^2].
        tolerance: Length of the motion (rad, m) of a turn that ends it.
        least: Fewer correspondences end it, lost.
        turns: At most so many.
        to_planes: Whether distances from the map's planes count, not those from its points.
        few: Whether the scan's fewer points are taken.
        is_held: Whether the course's matrix is added to the system.
        start: GIVEN, OF_FIRST or CHEAPEST.
        is_needed: Whether the course ends if this leg is lost.
    """

    pose: np.ndarray
    max_distance: float
    kernel_scale: float
    tolerance: float
    least: float
    turns: int
    to_planes: bool = False
    few: bool = False
    is_held: bool = False
    start: int = GIVEN
    is_needed: bool = False


@dataclass(frozen=True, eq=False)
class Reached:
    """Where a leg ended.

    Attributes:
        pose: T_map_sensor, float64 [4, 4].
        state: CONVERGED, EXHAUSTED or LOST; RUNNING if the course ended before it.
        turns: Turns taken.
        paired: Correspondences; this and what follows as they were before the last motion.
        sqsum: Sum of their squared distances [m^2].
        cost: Mean of Geman-McClure's, 0..1, over the points whose correspondences tell something and those that have
            none.
        disagreement: The same over the former alone.
    """

    pose: np.ndarray
    state: int
    turns: int
    paired: int
    sqsum: float
    cost: float
    disagreement: float


class MapAligner:
    """Scans against maps, one after the other.

    Args:
        plane_voxels: Edges of a voxel: points this near to the nearest one make up its plane.
    """

    def __init__(self, plane_voxels: float) -> None:
        self._plane_voxels = plane_voxels
        self.clear()

    def clear(self) -> None:
        """Release the memory."""
        self._course: Course | None = None
        self._arrays: tuple[Any, ...] = ()
        self._counts = (0, 0)

    def load(self, points: Points, few: Points | None, voxel_map: VoxelMap) -> None:
        """Take a scan and the map that it is brought onto, which stays as it is until the next scan.

        Args:
            points: The scan, device array of vec3, finite, at least one.
            few: Fewer points of it, at least one; None: none that legs could take.
            voxel_map: The map, not empty.
        """
        few = points[:0] if few is None else few
        total = points.size + few.size
        table = voxel_map.table
        arrays = (table.keys, table.positions, voxel_map.counts, voxel_map.places, voxel_map.voxel_size)
        room = 0 if self._course is None else self._course.points.size
        is_kept = len(arrays) == len(self._arrays) and all(map(_is_same, arrays, self._arrays))
        if total > room or not is_kept:
            self._make(max(LEAST_ROOM, room, 1 << (total - 1).bit_length()), voxel_map, points.device)
            self._arrays = arrays
        self._counts = (points.size, few.size)
        launch(load_scan_kernel, total, [points, few, self._course])

    def _make(self, room: int, voxel_map: VoxelMap, device: Device) -> None:
        course = Course(room, voxel_map, float(self._plane_voxels * voxel_map.voxel_size), device)
        run = CUDA_RUN if device.is_cuda else CPU_RUN
        threads = -(-room // run)
        rows = empty((threads, SUMS), float64, device)
        folded = empty((-(-threads // FOLD), SUMS), float64, device) if device.is_cuda else rows
        per_row = run * FOLD if device.is_cuda else run

        def turn() -> None:
            launch(associate_points_kernel, threads, [run, course, rows])
            if device.is_cuda:
                launch(fold_rows_kernel, folded.size, [run, course, rows, folded])
            launch(step_pose_kernel, 1, [per_row, course, folded])

        self._course, self._loop = course, DeviceLoop(course.running, turn)
        self._told = empty((-(-room // PLANE_RUN), TRIANGLE), float64, device)

    def run(self, legs: Sequence[Leg], held: np.ndarray | None = None) -> tuple[list[Reached], np.ndarray]:
        """Where the legs of a course end.

        Args:
            legs: At most MOST_LEGS.
            held: float64 [6, 6], what is added to the matrix of legs that are held, in units of its trace over
                translations.

        Returns:
            (results, told): a result a leg, and what planes tell at the end of the last one: a matrix [6, 6] over
            turns [rad] about the sensor and its translation [m], zero without planes. One sync.

        Raises:
            ValueError: Too many legs.
        """
        course, corner = self._course, np.triu_indices(UNKNOWNS)
        assert course is not None
        write(course.orders, self._orders(legs, None if held is None else held[corner]))
        launch(begin_course_kernel, len(legs), [course])
        self._loop.run()
        if legs[-1].to_planes:
            launch(sum_planes_kernel, self._told.shape[0], [course, self._told])
            launch(add_planes_kernel, TRIANGLE, [self._told, course])
        found = download(course.results)  # sync
        told = np.zeros((UNKNOWNS, UNKNOWNS))
        if legs[-1].to_planes:
            told[corner] = found[MOST_LEGS, :TRIANGLE]
            told += np.triu(told, 1).T
        return [self._reached(leg, row) for leg, row in zip(legs, found, strict=False)], told

    def _orders(self, legs: Sequence[Leg], held: np.ndarray | None) -> np.ndarray:
        """The legs as the device reads them."""
        if len(legs) > MOST_LEGS:
            raise ValueError(f"legs: expected up to {MOST_LEGS}, got {len(legs)}")
        orders = np.zeros((MOST_LEGS + 1, ORDER))
        for row, leg in zip(orders, legs, strict=False):
            row[:16] = leg.pose.ravel()
            row[16:] = (
                np.float32(leg.max_distance) ** 2, leg.kernel_scale, leg.tolerance, max(leg.least, LEAST_PAIRS),
                leg.turns, leg.to_planes, self._counts[0] if leg.few else 0, self._counts[leg.few], leg.is_held,
                leg.start, leg.is_needed,
            )  # fmt: skip
        if held is not None:
            orders[MOST_LEGS, :TRIANGLE] = held
        orders[MOST_LEGS, map_course.LEGS] = len(legs)
        return orders

    def _reached(self, leg: Leg, row: np.ndarray) -> Reached:
        sqsum, paired, cost, telling = row[SQSUM:RESULT].tolist()
        alone = self._counts[leg.few] - paired
        disagreement = cost / telling if telling > 0 else 0.0
        cost = (cost + alone) / (telling + alone) if telling + alone > 0 else 1.0
        pose = row[:16].reshape(4, 4).copy()
        return Reached(pose, int(row[STATE]), int(row[TAKEN]), int(paired), sqsum, cost, disagreement)


def _is_same(a: Any, b: Any) -> bool:
    return a is b or (isinstance(a, float) and a == b)
