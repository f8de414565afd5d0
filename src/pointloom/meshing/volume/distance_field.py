"""DistanceField: Euclidean distances to the nearest occupied voxel."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...core.argument_errors import explain_argument_errors
from ...core.array_libraries import NUMPY, check_library, hand_out, library_of, view_as
from ...core.attribute_hints import HintedNames
from ...core.checks import check_finite, check_numeric, check_positive, check_rows, check_shape, is_on_gpu
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import values_of_file
from ...core.exchange import on_host
from ...core.gpu_arrays import device_for, take_numbers
from ...core.pickled_arrays import device_like, unpickling
from ...core.serialized import locked_objects
from ...kernels.array_types import Cells, Device, Mask
from ...kernels.arrays.bounds import bound_points
from ...kernels.lang import uint8, vec3i
from ...kernels.memory import clone, download, upload
from ...kernels.volumes.distance_blocks import DistanceBlocks, find_distances, limits_for, limits_for_box
from ...kernels.volumes.distance_cells import find_cells, find_set_cells
from ...kernels.volumes.distance_queries import DistanceGrid
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud
from ...pcd.raster_cells import check_lengths
from ..mesh.voxel_grid import VoxelGrid
from .distance_field_files import (
    MAX_COORDINATE,
    FieldSource,
    arrays_of,
    check_field_arrays,
    read_field,
    source_of,
    write_field,
)
from .distance_field_queries import FieldQueries
from .distance_field_views import FieldViews
from .occupancy import OccupancyGrid
from .voxel_boxes import check_voxel_size


class DistanceField(FieldQueries, FieldViews, HintedNames):
    """Exact Euclidean distances to the nearest occupied voxel, in blocks of 8^3 voxels; immutable.

    Created by `from_point_cloud`, `from_array`, `from_voxel_grid`, `from_occupancy_grid` or `from_voxels`. Distances
    are between voxel centers. With a `max_distance`, farther voxels return `max_distance`, a lower bound. Without one,
    all distances in a dense box are known, and those outside are NaN. The true clearance is up to one voxel diagonal
    smaller; `collides` and `collides_bodies` include this.

    Attributes:
        device: Device of the field.
        voxel_size: Edge of a voxel [m].
        max_distance: Maximum known distance [m]. None for a dense box.
        origin: Lowest corner of voxel (0, 0, 0) [m], float64 (3,).
        shape: Shape of the source array (x, y, z). None for other sources.
        is_signed: True if occupied voxels have negative distances to the nearest free voxel.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> cloud = loom.PointCloud([[0.05, 0.05, 0.05], [0.95, 0.05, 0.05]])
        >>> field = loom.DistanceField.from_point_cloud(cloud, voxel_size=0.1, max_distance=1)
        >>> field.distances([[0.35, 0.45, 0.05], [5, 5, 5]]).round(3).tolist()
        [0.5, 1.0]
        >>> field.collides([[0.5, 0.05, 0.05]], 0.2).tolist()
        [False]
    """

    _fixed = ("device", "voxel_size", "max_distance", "shape", "origin", "is_signed")
    _internal = ("blocks", "set_source")
    is_signed: bool

    def __init__(self) -> None:
        raise TypeError(
            "DistanceField: create one with from_point_cloud, from_array, from_voxel_grid, from_voxels or load"
        )

    @classmethod
    @explain_argument_errors
    def from_point_cloud(
        cls, cloud: PointCloud, voxel_size: float, max_distance: float, *, origin: ArrayLike | None = None
    ) -> DistanceField:
        """Compute the field around the voxels that contain points of a cloud.

        Time and memory are proportional to the voxels within `max_distance`: 8 B each, plus 24 B for about twice as
        many during construction. Ties go to the first voxel along x, then y, then z. Bitwise identical on every device.
        Meijster et al., "A general algorithm for computing distance transforms in linear time", 2000.

        Args:
            cloud: The points; those that are not finite are ignored.
            voxel_size: Edge of a voxel [m].
            max_distance: Maximum known distance [m], at most 16,383 voxels.
            origin: Lowest corner of voxel (0, 0, 0) [m], shape (3,). If None: the cloud's own `origin`.

        Raises:
            TypeError, ValueError: If `cloud` is not a PointCloud, or if a size is not positive, the unit is degrees,
                points are beyond 2^20 blocks from the origin, or there are more than 2^32 blocks.
            MemoryError: If the blocks do not fit into device memory.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[500000.5, 5400000.5, 20.5]])
            >>> field = loom.DistanceField.from_point_cloud(cloud, voxel_size=0.1, max_distance=2)
            >>> float(field.distances([[500001.51, 5400000.51, 20.51]])[0])
            1.0
        """
        check_cloud("cloud", cloud)
        check_lengths(cloud)
        edge = check_voxel_size(voxel_size)
        start = cloud.origin if origin is None else check_finite("origin", check_shape("origin", origin, (3,)))
        points = cloud.arrays["points"]
        x, y, z = (cloud.origin - start).tolist()
        source = FieldSource(start, edge, check_positive("max_distance", max_distance))
        try:
            return cls._of(find_cells(points, (x, y, z), edge), source, cloud.array_library)
        except ValueError as error:
            raise ValueError(f"{error}{_extent(cloud)}") from None

    @classmethod
    @explain_argument_errors
    def from_array(
        cls,
        occupied: ArrayLike,
        voxel_size: float = 1.0,
        *,
        origin: ArrayLike = (0.0, 0.0, 0.0),
        max_distance: float | None = None,
        signed: bool = False,
        device: DeviceLike = None,
    ) -> DistanceField:
        """Compute the field of a dense box of voxels.

        `to_array()` equals `scipy.ndimage.distance_transform_edt(~occupied) * voxel_size` (if signed, minus that of
        `occupied`) with bitwise equal squared distances. Infinite if nothing is occupied. 8 B per voxel, temporarily 32
        B.

        Args:
            occupied: Shape (x, y, z): booleans, or integers that are occupied if not 0.
            voxel_size: Edge of a voxel [m].
            origin: Lowest corner of voxel (0, 0, 0) [m], shape (3,).
            max_distance: Maximum known distance [m]. If None: the complete box, up to a diagonal of 32,767 voxels.
            signed: Give occupied voxels negative distances to the nearest free voxel of the box.
            device: "cpu", "cuda:0" or "auto". If None: the array's GPU, or the CPU.

        Raises:
            TypeError: If the array is neither boolean nor integer.
            ValueError: If the shape is wrong or empty, or a size is not positive or too large.
            MemoryError: If the box does not fit into device memory.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> occupied = np.zeros((4, 1, 1), bool)
            >>> occupied[1:3] = True
            >>> loom.DistanceField.from_array(occupied, signed=True).to_array().ravel().tolist()
            [1.0, -1.0, -1.0, 1.0]
        """
        mask, shape = _take_mask(occupied, device)
        edge = check_voxel_size(voxel_size)
        limit = None if max_distance is None else check_positive("max_distance", max_distance)
        corner = check_finite("origin", check_shape("origin", origin, (3,)))
        source = FieldSource(corner, edge, limit, shape, bool(signed))
        return cls._of(find_set_cells(mask, shape), source, library_of(occupied))

    @classmethod
    @explain_argument_errors
    def from_voxel_grid(cls, grid: VoxelGrid, max_distance: float, *, device: DeviceLike = None) -> DistanceField:
        """Compute the field around the voxels of a VoxelGrid, for example from `TriangleMesh.voxelize`.

        Args:
            grid: The voxels, their size and origin.
            max_distance: Maximum known distance [m].
            device: "cpu" (default), "cuda:0" or "auto".

        Raises:
            TypeError: If `grid` is not a VoxelGrid.
            ValueError, MemoryError: As `from_voxels`.

        Example:
            >>> import pointloom as loom
            >>> grid = loom.TriangleMesh.create_box().voxelize(0.25)
            >>> field = loom.DistanceField.from_voxel_grid(grid, max_distance=1)
            >>> field.voxel_count == len(grid)
            True
        """
        if not isinstance(grid, VoxelGrid):
            raise TypeError(f"grid: expected a VoxelGrid, got {type(grid).__name__}")
        return cls.from_voxels(grid.coordinates, grid.voxel_size, max_distance, origin=grid.origin, device=device)

    @classmethod
    @explain_argument_errors
    def from_voxels(
        cls,
        coordinates: ArrayLike,
        voxel_size: float,
        max_distance: float,
        *,
        origin: ArrayLike = (0.0, 0.0, 0.0),
        device: DeviceLike = None,
    ) -> DistanceField:
        """Compute the field around listed voxels.

        Args:
            coordinates: Occupied voxels, integers (n, 3), in any order. Repeats count once.
            voxel_size: Edge of a voxel [m].
            max_distance: Maximum known distance [m], at most 16,383 voxels.
            origin: Lowest corner of voxel (0, 0, 0) [m], shape (3,).
            device: "cpu", "cuda:0" or "auto". If None: the array's GPU, or the CPU.

        Raises:
            TypeError, ValueError: If the coordinates are not integers, or if the shape is wrong, a size is not
                positive, a voxel is about 2^23 from the origin, or there are more than 2^32 blocks.
            MemoryError: If the blocks do not fit into device memory.

        Example:
            >>> import pointloom as loom
            >>> field = loom.DistanceField.from_voxels([[0, 0, 0], [4, 0, 0]], 1.0, max_distance=3)
            >>> field.to_array([[-1, 0, 0], [6, 1, 1]], values="squared").ravel().tolist()
            [1, 0, 1, 4, 1, 0, 1]
        """
        library, where = library_of(coordinates), device_for(coordinates, device)
        cells = check_rows("coordinates", on_host("coordinates", coordinates), 3)
        if cells.dtype.kind not in "iu" and cells.size:
            raise TypeError(f"coordinates: expected whole numbers, got {cells.dtype}")
        if cells.size and not (cells.min() > -MAX_COORDINATE and cells.max() < MAX_COORDINATE):
            raise ValueError(f"coordinates: {cells.min()}..{cells.max()} exceed 30 bits")
        edge, limit = check_voxel_size(voxel_size), check_positive("max_distance", max_distance)
        corner = check_finite("origin", check_shape("origin", origin, (3,)))
        return cls._of(upload(cells, vec3i, where), FieldSource(corner, edge, limit), library)

    @classmethod
    @explain_argument_errors
    def from_occupancy_grid(cls, grid: OccupancyGrid, max_distance: float) -> DistanceField:
        """Compute the field around the occupied voxels of an OccupancyGrid, on its device.

        Args:
            grid: The grid. Unknown voxels count as free.
            max_distance: Maximum known distance [m].

        Raises:
            TypeError: If `grid` is not an OccupancyGrid.
            ValueError, MemoryError: As `from_voxels`.

        Example:
            >>> import pointloom as loom
            >>> grid = loom.OccupancyGrid(0.5)
            >>> touched = grid.insert_scan([[2.2, 0.2, 0.2]], origin=[0.2, 0.2, 0.2])
            >>> field = loom.DistanceField.from_occupancy_grid(grid, max_distance=2)
            >>> field.distances([[1.2, 0.2, 0.2]]).tolist()
            [1.0]
        """
        if not isinstance(grid, OccupancyGrid):
            raise TypeError(f"grid: expected an OccupancyGrid, got {type(grid).__name__}")
        limit = check_positive("max_distance", max_distance)
        with locked_objects([grid]):
            source = FieldSource(grid.origin, grid.voxel_size, limit)
            return cls._of(grid.device_voxels(), source, grid.array_library)

    @classmethod
    def _of(cls, cells: Cells, source: FieldSource, library: str = NUMPY) -> DistanceField:
        """Compute the field around voxels on the device, vec3i, in any order with repeats."""
        radius = (
            limits_for_box(source.shape or (0, 0, 0))
            if source.max_distance is None
            else limits_for(source.max_distance / source.voxel_size)
        )
        field = cls.__new__(cls)
        blocks = find_distances(cells, radius, source.shape if source.signed else None)
        field.set_source(source, cells, blocks, library)
        return field

    def set_source(self, source: FieldSource, cells: Cells, blocks: DistanceBlocks, library: str) -> None:
        self.device, self._source, self.blocks, self._library = cells.device, source, blocks, library
        self.origin, self.voxel_size, self.max_distance = source.origin, source.voxel_size, source.max_distance
        self.shape, self.is_signed = source.shape, source.signed
        self._grid = DistanceGrid(blocks, source.origin.tolist(), source.voxel_size, source.max_distance)

    def __repr__(self) -> str:
        extent = "of a box" if self.max_distance is None else f"up to {self.max_distance:g} m"
        size = f"{self.voxel_count:,} occupied voxels of {self.voxel_size:g} m, {extent}, {self.block_count:,} blocks"
        return f"DistanceField({size}{', signed' * self.is_signed}, {self.device})"

    @property
    def voxel_count(self) -> int:
        """Number of occupied voxels."""
        return self.blocks.occupied.size

    @property
    def block_count(self) -> int:
        """Number of blocks of 8^3 voxels."""
        return self.blocks.keys.size

    @property
    def memory_bytes(self) -> int:
        """Device memory of voxels, keys and hash table [B]."""
        return self.blocks.memory_bytes

    @property
    def occupied_voxels(self) -> NDArray[np.int32]:
        """Coordinates of the occupied voxels, int32 (k, 3), indexed by `nearest_obstacles`. A copy."""
        return hand_out(clone(self.blocks.occupied), self._library)

    def save(self, path: str | os.PathLike[str], *, overwrite: bool = True) -> None:
        """Write the occupied voxels to an .npz file atomically; `load` recomputes the distances.

        Raises:
            FileError: If the file cannot be written, or exists and `overwrite` is False.
        """
        write_field(path, self._arrays(), overwrite=overwrite)

    @classmethod
    def load(cls, path: str | os.PathLike[str], *, device: DeviceLike = None) -> DistanceField:
        """Read a field written by `save` and recompute its distances.

        Raises:
            FileError: If the file is missing, damaged or of another kind.
            MemoryError: If the field does not fit into device memory.
        """
        arrays, where = read_field(path), resolve_device(device)
        with values_of_file(path):
            return cls._of_arrays(arrays, where)

    def _arrays(self) -> dict[str, NDArray[Any]]:
        return arrays_of(self._source, np.array(download(self.blocks.occupied)).reshape(-1, 3))

    @classmethod
    def _of_arrays(cls, arrays: dict[str, NDArray[Any]], device: Device, library: str = NUMPY) -> DistanceField:
        return cls._of(upload(arrays["voxels"], vec3i, device), source_of(arrays), library)

    def __getstate__(self) -> dict[str, Any]:
        return {"arrays": self._arrays(), "device": str(self.device), "library": self._library}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Restore on the saved device, or the first GPU if its index does not exist."""
        with unpickling("distance field"):
            where = device_like("distance field", state["device"])
            arrays, library = check_field_arrays(state["arrays"]), check_library("library", state.get("library", NUMPY))
            made = self._of_arrays(arrays, where, library)
        vars(self).update(vars(made))


def _take_mask(occupied: ArrayLike, device: DeviceLike) -> tuple[Mask, tuple[int, int, int]]:
    """Upload voxels as uint8 (x * y * z,). Also returns their shape."""
    where = device_for(occupied, device)
    if is_on_gpu(occupied):
        given: Any = take_numbers("occupied", occupied, where)
        kind, shape = ("b" if given.dtype in (wp.bool, uint8) else "?"), tuple(given.shape)
    else:
        given = check_numeric("occupied", occupied)
        kind, shape = given.dtype.kind, given.shape
    if kind not in "biu":
        raise TypeError(f"occupied: expected booleans or whole numbers, got {given.dtype}")
    if len(shape) != 3 or not min(shape):
        raise ValueError(f"occupied: expected shape [x, y, z] with at least one voxel, got {list(shape)}")
    if is_on_gpu(occupied):
        return view_as(given, uint8, (given.size,)), shape
    return upload((given != 0).ravel(), uint8, where), shape


def _extent(cloud: PointCloud) -> str:
    low, high, count = bound_points(cloud.arrays["points"])
    if not count:
        return ""
    box = (np.array([low, high], np.float64) + cloud.origin).round(3).tolist()
    return f"; the points extend from {box[0]} to {box[1]}"
