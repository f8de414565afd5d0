"""Scan-to-map alignment by a sequence of robust ICP loops with one sync. Device arrays and the CUDA graph are reused
between scans. 56 B per point of the largest scan, 270 B more on CUDA, and 20 B per place of a map
point for many starts.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..algebra.rigid_solve import TRIANGLE_NUMBERS, UNKNOWN_COUNT
from ..array_types import Array1, Device, Points
from ..lang import DeviceLoop, float64, launch
from ..memory import download, empty, write
from .map_course import (
    FROM_GIVEN,
    MAX_LEGS,
    PLANE_RUN,
    ROWS_PER_SUM,
    Course,
    LegOptions,
    LegResults,
    add_planes_kernel,
    associate_points_kernel,
    begin_course_kernel,
    fold_rows_kernel,
    load_scan_kernel,
    step_pose_kernel,
    sum_planes_kernel,
)
from .map_icp import SYSTEM_SIZE
from .pose_probes import find_map_planes
from .voxel_map import VoxelMap

CPU_RUN = 32  # points per thread: some tens of threads and rows per scan
CUDA_RUN = 1  # a GPU needs the threads. A second stage sums ROWS_PER_SUM rows each
MIN_PAIRS = 6  # fewer do not fix a pose against noise
UPPER_TRIANGLE = np.triu_indices(UNKNOWN_COUNT)
MIN_ROOM = 1024  # minimum room for scan points


# First numbers of the fields of each leg, in the order in which `MapAligner` writes them.
LEG_FIELDS = np.array(
    [
        LegOptions.parts()[name].start
        for name in (
            "max_sqdistances", "kernel_scales", "tolerances", "min_pairs", "max_iterations", "to_planes",
            "first_points", "point_counts", "regularized", "starts", "needed",
        )
    ]
)  # fmt: skip


@dataclass(frozen=True, eq=False)
class Leg:
    """Options of an ICP loop. It starts at `pose`, or elsewhere by `start`. `max_distance` [m] is within 27 voxels,
    Geman-McClure `kernel_scale` [m^2], `tolerance` of the motion (rad, m). At least `min_pairs`, else lost; at most
    `iterations`; `few`: use the reduced scan; `is_regularized`: add the matrix; `is_needed`: stop if lost.
    """

    pose: np.ndarray
    max_distance: float
    kernel_scale: float
    tolerance: float
    min_pairs: float
    iterations: int
    to_planes: bool = False
    few: bool = False
    is_regularized: bool = False
    start: int = FROM_GIVEN
    is_needed: bool = False


@dataclass(frozen=True, eq=False)
class Reached:
    """Result of a leg: T_map_sensor; `state`; `iterations`; before the last motion: pair count, `sqsum` [m^2],
    mean `cost` 0..1 over informative pairs and unpaired points, `disagreement` over informative pairs.
    """

    pose: np.ndarray
    state: int
    iterations: int
    paired: int
    sqsum: float
    cost: float
    disagreement: float


class MapAligner:
    """Scan-to-map alignment. `plane_voxels`: radius in voxel edges of the points that define a plane."""

    def __init__(self, plane_voxels: float) -> None:
        self._plane_voxels = plane_voxels
        self.clear()

    def clear(self) -> None:
        self._course: Course | None = None
        self._arrays: tuple[Any, ...] = ()
        self._counts = (0, 0)
        self._has_map_planes = False

    def load(self, points: Points, few: Points | None, voxel_map: VoxelMap, *, has_many_starts: bool = False) -> None:
        """Load a scan (finite vec3, not empty), an optional reduced scan, and a nonempty map that stays unchanged. For
        many starts the planes around all map points are computed first.
        """
        few_count = 0 if few is None else few.size
        total = points.size + few_count
        table = voxel_map.table
        arrays = (table.keys, table.positions, voxel_map.counts, voxel_map.offsets, voxel_map.voxel_size)
        room = 0 if self._course is None else self._course.points.size
        is_unchanged = len(arrays) == len(self._arrays) and all(map(_is_same, arrays, self._arrays))
        map_points = voxel_map.count * voxel_map.room if has_many_starts else 0
        has_room = self._course is not None and total <= room and map_points <= self._course.map_planes.size
        if not has_room or not is_unchanged:
            self._make(max(MIN_ROOM, room, 1 << (total - 1).bit_length()), voxel_map, points.device, map_points)
            self._arrays = arrays
        self._counts = (points.size, few_count)
        launch(load_scan_kernel, total, [points, points if few is None else few, self._course])
        self._has_map_planes = has_many_starts
        if has_many_starts and self._course is not None:
            find_map_planes(voxel_map, self._radius(voxel_map), self._course.map_planes)

    @property
    def map_planes(self) -> Array1[Any] | None:
        """The planes around all points of the loaded map by their position, if they were computed."""
        return self._course.map_planes if self._course is not None and self._has_map_planes else None

    def _radius(self, voxel_map: VoxelMap) -> float:
        return float(self._plane_voxels * voxel_map.voxel_size)

    def _make(self, room: int, voxel_map: VoxelMap, device: Device, map_points: int) -> None:
        course = Course(room, voxel_map, self._radius(voxel_map), device, map_points)
        run = CUDA_RUN if device.is_cuda else CPU_RUN
        threads = -(-room // run)
        rows = empty((threads, SYSTEM_SIZE), float64, device)
        folded = empty((-(-threads // ROWS_PER_SUM), SYSTEM_SIZE), float64, device) if device.is_cuda else rows
        per_row = run * ROWS_PER_SUM if device.is_cuda else run

        def iterate() -> None:
            launch(associate_points_kernel, threads, [run, course, rows])
            if device.is_cuda:
                launch(fold_rows_kernel, folded.size, [run, course, rows, folded])
            launch(step_pose_kernel, 1, [per_row, course, folded])

        self._course, self._loop = course, DeviceLoop(course.running, iterate)
        self._plane_rows = empty((-(-room // PLANE_RUN), TRIANGLE_NUMBERS), float64, device)

    def run(self, legs: Sequence[Leg], regularization: np.ndarray | None = None) -> tuple[list[Reached], np.ndarray]:
        """Run at most MAX_LEGS legs (else ValueError): (results, information of the planes (6, 6) over rotation [rad]
        about the sensor and translation [m]). `regularization` is in units of the trace over translations. One sync.
        """
        course, corner = self._course, UPPER_TRIANGLE
        assert course is not None
        write(course.options.buffer, self._options(legs, None if regularization is None else regularization[corner]))
        launch(begin_course_kernel, len(legs), [course])
        self._loop.run()
        if legs[-1].to_planes:
            launch(sum_planes_kernel, self._plane_rows.shape[0], [course, self._plane_rows])
            launch(add_planes_kernel, TRIANGLE_NUMBERS, [self._plane_rows, course])
        results = LegResults.in_host(download(course.results.buffer))  # sync
        information = np.zeros((UNKNOWN_COUNT, UNKNOWN_COUNT))
        if legs[-1].to_planes:
            information[corner] = results["plane_information"]
            information += np.triu(information, 1).T
        return [self._reached(leg, k, results) for k, leg in enumerate(legs)], information

    def _options(self, legs: Sequence[Leg], regularization: np.ndarray | None) -> np.ndarray:
        """The buffer of LegOptions."""
        if len(legs) > MAX_LEGS:
            raise ValueError(f"legs: expected up to {MAX_LEGS}, got {len(legs)}")
        assert self._course is not None
        buffer = np.zeros(self._course.options.buffer.size)
        options = LegOptions.in_host(buffer)
        options["poses"][: 16 * len(legs)] = np.array([leg.pose for leg in legs]).reshape(-1)
        for k, leg in enumerate(legs):
            buffer[LEG_FIELDS + k] = (
                np.float32(leg.max_distance) ** 2, leg.kernel_scale, leg.tolerance, max(leg.min_pairs, MIN_PAIRS),
                leg.iterations, leg.to_planes, self._counts[0] if leg.few else 0, self._counts[leg.few],
                leg.is_regularized, leg.start, leg.is_needed,
            )  # fmt: skip
        if regularization is not None:
            options["regularization"][:] = regularization
        options["leg_count"][0] = len(legs)
        options["has_map_planes"][0] = self._has_map_planes
        return buffer

    def _reached(self, leg: Leg, k: int, results: dict[str, np.ndarray]) -> Reached:
        paired, cost, informative = (float(results[name][k]) for name in ("pair_counts", "costs", "informative_counts"))
        unpaired = self._counts[leg.few] - paired
        pose, state, iterations = results["poses"][16 * k : 16 * k + 16], results["states"][k], results["iterations"][k]
        return Reached(
            pose=pose.reshape(4, 4).copy(), state=int(state), iterations=int(iterations), paired=int(paired),
            sqsum=float(results["sqsums"][k]), disagreement=cost / informative if informative > 0 else 0.0,
            cost=(cost + unpaired) / (informative + unpaired) if informative + unpaired > 0 else 1.0,
        )  # fmt: skip


def _is_same(a: Any, b: Any) -> bool:
    return a is b or (isinstance(a, float) and a == b)
