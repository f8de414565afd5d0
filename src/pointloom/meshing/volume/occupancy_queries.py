"""Queries and conversions of an OccupancyGrid."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.argument_errors import explain_argument_errors
from ...core.array_libraries import NUMPY, Form, form_of, hand_out_host, view_as
from ...core.checks import check_finite, check_positive, check_rows, is_on_gpu
from ...core.devices import check_same_device
from ...core.dropped_results import returns_new
from ...core.exchange import on_host
from ...core.gpu_arrays import take_numbers, take_rows, take_vectors_in_float64
from ...core.serialized import Serialized
from ...kernels.array_types import Cells, Points, Scalars
from ...kernels.lang import vec3, vec3d
from ...kernels.memory import check_room, download, upload
from ...kernels.volumes import occupancy_blocks as odds
from ...kernels.volumes.occupancy_blocks import KNOWN_BELOW, MAX_KEY_VOXELS, OddsBlocks
from ...pcd.cloud import PointCloud
from ..mesh.voxel_grid import VoxelGrid
from .voxel_boxes import Corners, check_positions, voxels_in_bounds, voxels_of_blocks

OCCUPIED_LOG_ODDS = 0.0  # log odds of probability 0.5
_WILD_DIRECTION = "directions: expected finite numbers up to 1e+100, got others"
_ZERO_DIRECTION = "directions: expected nonzero vectors, got some of length 0"
_FAR_RAY = "origins, max_range: rays extend more than 2^22 voxels from the grid's origin"


@dataclass(frozen=True, eq=False)
class RayHits:
    """First voxel on each ray that is not known to be free.

    Attributes:
        states: int8 (n,): 1 occupied, -1 unknown, 0 none up to the ray's end.
        distances: From the ray's origin to the voxel [m], float64 (n,), infinite if none.
        voxels: int32 (n, 3), as `OccupancyGrid.voxel_indices`, or zeros if none.
    """

    states: NDArray[np.int8]
    distances: NDArray[np.float64]
    voxels: NDArray[np.int32]


class OccupancyQuestions(Serialized):
    """Queries at points and along rays. Dense arrays, clouds and voxels."""

    device: Any
    voxel_size: float
    blocks: OddsBlocks
    _internal = ("blocks", "device_voxels")
    _library: str = NUMPY  # library of returned arrays, see src/pointloom/core/array_libraries.py

    @property
    def array_library(self) -> str:
        """Library of the arrays that operations without an array argument return: that of the last scan."""
        return self._library

    @property
    def origin(self) -> NDArray[np.float64]:
        """Origin of the grid's coordinates [m]."""
        raise NotImplementedError

    @property
    def bounds(self) -> NDArray[np.float64]:
        """Lowest and highest corner of the blocks [m], float64 (2, 3). Both the origin if empty."""
        low, high = self._voxel_bounds()
        return self.origin + np.array([low, high]) * self.voxel_size

    @explain_argument_errors
    def states(self, points: PointCloud | ArrayLike) -> NDArray[np.int8]:
        """State of the voxels of points [m], shape (n, 3): 1 occupied, 0 free, -1 unknown; int8 (n,).

        Raises:
            ValueError: If the shape is wrong.
        """
        value, form = self._odds_of(points)
        return form.hand_out(odds.find_states(value, OCCUPIED_LOG_ODDS), dtype=np.int8)

    @explain_argument_errors
    def occupied(self, points: PointCloud | ArrayLike) -> NDArray[np.bool_]:
        """True where the voxels of points [m], shape (n, 3), are occupied.

        Raises:
            ValueError: If the shape is wrong.
        """
        value, form = self._odds_of(points)
        return form.hand_out(odds.mask_occupied(value, OCCUPIED_LOG_ODDS), dtype=np.bool_)

    @explain_argument_errors
    def probabilities(self, points: PointCloud | ArrayLike) -> NDArray[np.float64]:
        """Occupancy probabilities of the voxels of points [m], shape (n, 3). NaN if unknown.

        Raises:
            ValueError: If the shape is wrong.
        """
        value, form = self._odds_of(points)
        return form.hand_out_host(_probability(download(value)), self.device)

    @explain_argument_errors
    def log_odds(self, points: PointCloud | ArrayLike) -> NDArray[np.float32]:
        """Log odds of the voxels of points [m], shape (n, 3). NaN if unknown.

        Raises:
            ValueError: If the shape is wrong.
        """
        value, form = self._odds_of(points)
        return form.hand_out(odds.hide_unknown(value))

    @explain_argument_errors
    def cast_rays(self, origins: ArrayLike, directions: ArrayLike, max_range: float) -> RayHits:
        """Find the first voxel on each ray that is not known to be free.

        Args:
            origins: Start points [m], shape (n, 3) or (3,).
            directions: Shape (n, 3), any nonzero length.
            max_range: Length of the rays [m].

        Raises:
            ValueError: If a shape is wrong, a direction is zero, or a ray leaves the supported range.

        Example:
            >>> import pointloom as loom
            >>> grid = loom.OccupancyGrid(0.5)
            >>> touched = grid.insert_scan([[2.2, 0.2, 0.2]], origin=[0.2, 0.2, 0.2])
            >>> hits = grid.cast_rays([0.25, 0.25, 0.25], [[1, 0, 0], [0, 1, 0]], max_range=5)
            >>> hits.states.tolist(), hits.distances.round(2).tolist()
            ([1, -1], [1.75, 0.25])
        """
        length = check_positive("max_range", max_range)
        starts, stops = (self._device_rays if is_on_gpu(directions) else self._host_rays)(origins, directions, length)
        form = form_of(directions)
        self.blocks.count  # noqa: B018  what was interrupted is settled
        states, distances, voxels = odds.cast_rays(starts, stops, OCCUPIED_LOG_ODDS, self.blocks)
        return RayHits(form.hand_out(states, dtype=np.int8), form.hand_out(distances), form.hand_out(voxels))

    def _host_rays(self, origins: ArrayLike, directions: ArrayLike, length: float) -> tuple[Points, Points]:
        vectors = check_finite("directions", check_rows("directions", directions, 3, dtype=np.float64))
        origins = on_host("origins", origins)
        lengths = np.linalg.norm(vectors, axis=1, keepdims=True)
        if not (lengths > 0).all():
            raise ValueError(_ZERO_DIRECTION)
        start_points = np.broadcast_to(check_positions("origins", origins, len(vectors)), vectors.shape) - self.origin
        ends = start_points + vectors / lengths * length
        if not max(np.abs(start_points).max(initial=0), np.abs(ends).max(initial=0)) < MAX_KEY_VOXELS * self.voxel_size:
            raise ValueError(_FAR_RAY)
        starts, stops = (upload(a.astype(np.float32), vec3, self.device) for a in (start_points, ends))
        return starts, stops

    def _device_rays(self, origins: ArrayLike, directions: ArrayLike, length: float) -> tuple[Points, Points]:
        vectors = take_vectors_in_float64("directions", directions, self.device)
        if is_on_gpu(origins):
            given = take_numbers("origins", origins, self.device)
            given = view_as(given, given.dtype, (1, 3)) if tuple(given.shape) == (3,) else given
            starts = take_vectors_in_float64("origins", given, self.device)
            if starts.size not in (1, vectors.size):
                expected = f"[3], or [{vectors.size}, 3], one row per point"
                raise ValueError(f"origins: expected shape {expected}, got [{starts.size}, 3]")
        else:
            starts = upload(check_positions("origins", origins, vectors.size), vec3d, self.device)
        x, y, z = self.origin.tolist()
        *ends, faults = odds.prepare_queries(
            starts, vectors, (x, y, z), length, MAX_KEY_VOXELS * self.voxel_size
        )  # sync
        for is_wrong, message in zip(faults, (_WILD_DIRECTION, _ZERO_DIRECTION, _FAR_RAY), strict=True):
            if is_wrong:
                raise ValueError(message)
        return ends[0], ends[1]

    def voxel_indices(self) -> NDArray[np.int32]:
        """Occupied voxels, int32 (k, 3), sorted by x, y, z on the host. Voxel i starts at `origin + i * voxel_size`."""
        return hand_out_host(self._sorted_voxels(), self._library, self.device)

    def _sorted_voxels(self) -> NDArray[np.int32]:
        voxels = np.array(download(self.device_voxels()), np.int32).reshape(-1, 3)
        return voxels[np.lexsort(voxels.T[::-1])]

    def device_voxels(self) -> Cells:
        """Occupied voxels on the device, vec3i, in block order."""
        return odds.list_occupied(self.blocks, OCCUPIED_LOG_ODDS)

    @returns_new
    def to_point_cloud(self) -> PointCloud:
        """Centers of the occupied voxels, in block order."""
        voxels = self.device_voxels()
        centers = odds.voxel_centers(voxels, self.blocks.lattice)
        return PointCloud.from_device_arrays({"points": centers}, self.origin, self._library)

    def to_voxel_grid(self) -> VoxelGrid:
        """Occupied voxels as a VoxelGrid."""
        voxels = self._sorted_voxels()
        low = voxels.min(axis=0, initial=0) if not len(voxels) else voxels.min(axis=0)
        x, y, z = (voxels - low).max(axis=0, initial=-1) + 1
        corner = self.origin + low * self.voxel_size
        return VoxelGrid(corner, self.voxel_size, (int(x), int(y), int(z)), voxels - low)

    @explain_argument_errors
    def to_array(self, bounds: ArrayLike | None = None) -> NDArray[np.float32]:
        """Probabilities as a dense array, float32 (x, y, z). NaN if unknown.

        Args:
            bounds: Lowest and highest corner [m], shape (2, 3). Overlapping voxels are included. If None: `bounds`.

        Raises:
            ValueError: If the bounds are invalid or contain more than 2^31 voxels.
            MemoryError: If the array does not fit into memory.

        Example:
            >>> import pointloom as loom
            >>> grid = loom.OccupancyGrid(0.5)
            >>> touched = grid.insert_scan([[2.2, 0.2, 0.2]], origin=[0.2, 0.2, 0.2])
            >>> grid.to_array([[0, 0, 0], [3, 0.5, 0.5]]).ravel().round(2).tolist()
            [0.4000000059604645, 0.4000000059604645, 0.4000000059604645, 0.4000000059604645, 0.699999988079071, nan]
        """
        low, high = self._voxel_bounds() if bounds is None else self._voxels_in(bounds)
        size = (high - low).tolist()
        count = math.prod(size)
        if count >= 2**31:
            raise ValueError(f"bounds: {' x '.join(map(str, size))} voxels are more than 2^31. Use smaller bounds")
        check_room(self.device, 12 * count, f"{count:,} voxels")
        x, y, z = low.tolist()
        self.blocks.count  # noqa: B018  what was interrupted is settled
        log_odds = np.array(download(odds.look_up_box((x, y, z), (size[0], size[1], size[2]), self.blocks)))
        return hand_out_host(_probability(log_odds).astype(np.float32).reshape(size), self._library, self.device)

    def _voxels_in(self, bounds: ArrayLike) -> Corners:
        beyond = "extend more than 2^22 voxels from the grid's origin"
        return voxels_in_bounds(bounds, self.origin, self.voxel_size, MAX_KEY_VOXELS, beyond)

    def _voxel_bounds(self) -> Corners:
        count = self.blocks.count
        return voxels_of_blocks(download(self.blocks.keys)[:count])

    def _cloud_of(self, name: str, points: ArrayLike) -> PointCloud:
        if isinstance(points, PointCloud):
            check_same_device(name, self.device, points.device)
            return points
        if is_on_gpu(points):
            return PointCloud(take_rows(name, points, 3, self.device))
        return PointCloud(check_rows(name, points, 3), device=self.device)

    def _odds_of(self, points: ArrayLike) -> tuple[Scalars, Form]:
        """Log odds at points, and the form of the result."""
        cloud = self._cloud_of("points", points)
        form = Form(points.array_library, False) if isinstance(points, PointCloud) else form_of(points)
        x, y, z = (cloud.origin - self.origin).tolist()
        self.blocks.count  # noqa: B018  what was interrupted is settled
        return odds.look_up(cloud.arrays["points"], (x, y, z), self.blocks), form


def _probability(log_odds: NDArray[np.float32]) -> NDArray[np.float64]:
    value = np.where(log_odds > KNOWN_BELOW, np.nan, log_odds.astype(np.float64))
    return 1.0 / (1.0 + np.exp(-value))
