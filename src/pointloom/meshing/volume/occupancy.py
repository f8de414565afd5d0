"""OccupancyGrid: occupied, free and unknown voxels from range scans."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.argument_errors import explain_argument_errors
from ...core.array_libraries import NUMPY, check_library, library_of
from ...core.attribute_hints import HintedNames
from ...core.checks import check_number, check_positive
from ...core.coordinates import origin_of_sensor
from ...core.devices import DeviceLike, resolve_device
from ...core.dropped_results import returns_new
from ...core.errors import values_of_file
from ...core.exchange import on_host
from ...core.pickled_arrays import device_like, unpickling
from ...kernels.array_types import Device
from ...kernels.lang import float32, int64, vec3
from ...kernels.memory import download, upload
from ...kernels.volumes import occupancy_blocks as odds
from ...kernels.volumes.occupancy_blocks import MAX_KEY_VOXELS, OddsBlocks
from ...kernels.volumes.occupancy_rays import Lattice
from ...kernels.volumes.tsdf_blocks import BLOCK_VOXELS
from ...pcd.cloud import PointCloud
from .occupancy_files import check_grid_arrays, find_fault_of_model, log_odds_of, read_grid, write_grid
from .occupancy_queries import OccupancyQuestions
from .voxel_boxes import check_positions, check_voxel_size

UNLIMITED_RANGE = 3.0e38  # [m] default of max_range


class OccupancyGrid(OccupancyQuestions, HintedNames):
    """Occupancy of voxels as log odds from range scans, in blocks allocated along rays.

    Per scan, a voxel with an end point gets a hit, and one that rays pass without an end point a miss. Log odds are
    summed and clamped, bitwise equal to OctoMap's `insertPointCloud`. Voxels are at multiples of `voxel_size` from
    `origin` and occupied from probability 0.5. Scans are inserted atomically. See `scan_count`. 4 B per voxel of the
    allocated blocks. Bitwise identical on every device. Hornung et al., "OctoMap: an efficient probabilistic 3D mapping
    framework based on octrees", Autonomous Robots 2013.

    Args:
        voxel_size: Edge of a voxel [m].
        hit, miss: Occupancy probability of a voxel with an end point, and of one that a ray passes.
        min, max: Limits of the probability.
        device: "cpu" (default), "cuda:0" or "auto".

    Raises:
        ValueError: If the size is not positive, or not 0.5 < hit < 1, 0 < miss < 0.5, 0 < min < 0.5 < max < 1.

    Example:
        >>> import pointloom as loom
        >>> grid = loom.OccupancyGrid(0.5)
        >>> touched = grid.insert_scan([[2.2, 0.2, 0.2]], origin=[0.2, 0.2, 0.2])
        >>> grid.states([[0.2, 0.2, 0.2], [2.2, 0.2, 0.2], [3.2, 0.2, 0.2]]).tolist()
        [0, 1, -1]
        >>> grid.probabilities([[0.2, 0.2, 0.2], [2.2, 0.2, 0.2], [3.2, 0.2, 0.2]]).round(3).tolist()
        [0.4, 0.7, nan]
    """

    device: Any
    voxel_size: float
    _fixed = ("device", "voxel_size")
    _internal = ("downloaded", "from_downloaded")

    @explain_argument_errors
    def __init__(
        self,
        voxel_size: float,
        hit: float = 0.7,
        miss: float = 0.4,
        min: float = 0.1192,
        max: float = 0.971,
        *,
        device: DeviceLike = None,
    ):
        edge = check_voxel_size(voxel_size)
        given = {"hit": hit, "miss": miss, "min": min, "max": max}
        self._model = tuple(check_number(name, value) for name, value in given.items())
        fault = find_fault_of_model(*self._model)
        if fault:
            raise ValueError(fault)
        self.device, self.voxel_size = resolve_device(device), edge
        self._origin: NDArray[np.float64] | None = None
        lattice = Lattice(edge, float(np.float32(edge * 0.5)))
        hit_odds, miss_odds, low, high = (log_odds_of(p) for p in self._model)
        self.blocks = OddsBlocks(lattice, (hit_odds, miss_odds, low, high), self.device)
        self._scans_before = 0

    def __repr__(self) -> str:
        size = f"{self.voxel_size:g} m voxels, {self.block_count:,} blocks"
        return f"OccupancyGrid({size}, {self.scan_count} scans, {self.device})"

    @property
    def origin(self) -> NDArray[np.float64]:
        """Origin of the grid's coordinates [m]: zero, or whole meters near the first scan if that is beyond 128 m."""
        return np.zeros(3) if self._origin is None else self._origin.copy()

    @property
    def block_count(self) -> int:
        """Number of blocks of 8^3 voxels."""
        return self.blocks.count

    @property
    def scan_count(self) -> int:
        """Number of inserted scans with points."""
        return self.blocks.scan_count + self._scans_before

    @property
    def memory_bytes(self) -> int:
        """Device memory of voxels, keys and hash table [B]."""
        return self.blocks.memory_bytes

    @explain_argument_errors
    def insert_scan(
        self, points: PointCloud | ArrayLike, origin: ArrayLike | None = None, *, max_range: float | None = None
    ) -> int:
        """Insert a scan. Returns the number of touched blocks, 0 without finite points.

        Rays are traversed as OctoMap's `computeRayKeys`, in float32 about the grid's origin.

        Args:
            points: End points of rays: a cloud on the grid's device, or shape (n, 3) [m]. Points with NaN are ignored.
            origin: Sensor position [m], shape (3,), or start of each ray, shape (n, 3).
            max_range: Longer rays [m] are free up to this range and have no end point. If None: no limit.

        Raises:
            ValueError: If there is no origin, points are infinite, shapes disagree, or the scan spans more than 2^26
                blocks or 2^22 voxels from the origin. The grid stays unchanged.

        Example:
            >>> import pointloom as loom
            >>> grid = loom.OccupancyGrid(0.1)
            >>> grid.insert_scan([[1.05, 0.05, 0.05], [9.0, 0.05, 0.05]], origin=[0.05, 0.05, 0.05], max_range=3)
            4
            >>> len(grid.voxel_indices())
            1
        """
        if origin is None:
            raise ValueError(
                "origin: expected the sensor position [m] of shape [3], or one per point of shape [n, 3], got None. It "
                "defines the free space. For a registered cloud use the positions of its trajectory"
            )
        cloud = self._cloud_of("points", points)
        starts = check_positions("origin", on_host("origin", origin), len(cloud))
        longest = UNLIMITED_RANGE if max_range is None else check_positive("max_range", max_range)
        if not len(cloud):
            return 0
        new_origin = self._origin if self._origin is not None else origin_of_sensor(starts[0])
        local = starts - new_origin
        if not np.abs(local).max() < MAX_KEY_VOXELS * self.voxel_size:
            raise ValueError(
                f"origin: a ray starts {np.abs(local).max():.6g} m from the grid's origin {new_origin.tolist()}"
            )
        x, y, z = (cloud.origin - new_origin).tolist()
        lattice, ray_starts = self.blocks.lattice, upload(local.astype(np.float32), vec3, self.device)
        rays, infinite = odds.prepare_rays(cloud.arrays["points"], (x, y, z), ray_starts, longest, lattice)
        if infinite:
            raise ValueError(
                "points: expected finite points. Use remove_non_finite_points(), or max_range to shorten long rays"
            )
        before = self._origin
        try:
            self._origin = new_origin
            count = odds.fold_scan(rays, self.blocks)
        except odds.WildScanError as error:
            self._origin = before
            raise ValueError(f"points: {error}; an outlier may be far away: use max_range or larger voxels") from None
        if not self.scan_count:
            self._origin = before
        self._library = cloud.array_library if isinstance(points, PointCloud) else library_of(points)
        return count

    def save(self, path: str | os.PathLike[str], *, overwrite: bool = True) -> None:
        """Write the grid to an .npz file atomically.

        Raises:
            FileError: If the file cannot be written, or exists and `overwrite` is False.
        """
        write_grid(path, self.downloaded(), overwrite=overwrite)

    @classmethod
    def load(cls, path: str | os.PathLike[str], *, device: DeviceLike = None) -> OccupancyGrid:
        """Read a grid written by `save`.

        Raises:
            FileError: If the file is missing, damaged or of another kind.
        """
        arrays, where = read_grid(path), resolve_device(device)
        with values_of_file(path):
            return cls.from_downloaded(arrays, where)

    def downloaded(self) -> dict[str, Any]:
        count = self.block_count
        return {
            "voxel_size": np.array(self.voxel_size),
            "probabilities": np.array(self._model),
            "origin": self.origin,
            "scan_count": np.array(self.scan_count),
            "keys": download(self.blocks.keys)[:count],
            "odds": download(self.blocks.odds)[: count * BLOCK_VOXELS],
        }

    @classmethod
    def from_downloaded(cls, arrays: dict[str, Any], device: Device, library: str = NUMPY) -> OccupancyGrid:
        grid = cls(float(arrays["voxel_size"]), *arrays["probabilities"].tolist(), device=device)
        count = int(arrays["scan_count"])
        vars(grid).update(_scans_before=count, _origin=arrays["origin"] if count else None, _library=library)
        keys = upload(np.ascontiguousarray(arrays["keys"]), int64, grid.device)
        values = upload(np.ascontiguousarray(arrays["odds"]), float32, grid.device)
        grid.blocks.fill(keys, values)
        return grid

    @returns_new
    def copy(self) -> OccupancyGrid:
        """Independent copy with the same voxels."""
        grid = OccupancyGrid(self.voxel_size, *self._model, device=self.device)
        state: dict[str, Any] = {"_origin": self._origin, "_library": self._library, "blocks": self.blocks.clone()}
        vars(grid).update(state, _scans_before=self.scan_count)
        return grid

    def __copy__(self) -> OccupancyGrid:
        return self.copy()

    def __deepcopy__(self, memo: dict[int, Any]) -> OccupancyGrid:
        return self.copy()

    def __getstate__(self) -> dict[str, Any]:
        return {"arrays": self.downloaded(), "device": str(self.device), "library": self._library}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Restore on the saved device, or the first GPU if its index does not exist."""
        with unpickling("occupancy grid"):
            where = device_like("occupancy grid", state["device"])
            library = check_library("library", state.get("library", NUMPY))
            made = self.from_downloaded(check_grid_arrays(state["arrays"]), where, library)
        vars(self).update(vars(made))
