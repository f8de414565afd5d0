"""VoxelGrid, changed in place as in Open3D: occupied voxels of clouds, meshes, octrees and dense boxes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.attribute_hints import KnownNames
from ...core.checks import check_positive, check_shape
from ...kernels.linear_algebra import inv, matmul
from ...meshing.mesh import mesh, voxel_grid
from .. import geometry
from ..argument_types import CloudLike, MeshLike, VectorLike
from ..camera import PinholeCameraParameters
from ..vectors import Vector3dVector
from ..wrapper import PlainWrapper, as_array, column, unwrap
from .boxes import AxisAlignedBoundingBox, OrientedBoundingBox
from .enums import VoxelPoolingMode
from .geometry import Geometry3D
from .image import Image
from .point_cloud import PointCloud
from .triangle_mesh import TriangleMesh

# In Open3D's order, with the x axis slower than the z axis within a face
VOXEL_CORNERS = np.array([[0, 0, 0], [0, 0, 1], [1, 0, 0], [1, 0, 1], [0, 1, 0], [0, 1, 1], [1, 1, 0], [1, 1, 1]])
CUBE_TRIANGLES = np.array(  # of the corners
    [[0, 1, 2], [1, 3, 2], [4, 6, 5], [5, 6, 7], [0, 4, 1], [1, 4, 5],
     [2, 3, 6], [3, 7, 6], [0, 2, 4], [2, 6, 4], [1, 5, 3], [3, 5, 7]]
)  # fmt: skip
LARGEST_INDEX = 2.0**31

Cells = NDArray[np.int32]
Colors = NDArray[np.float64]


class Voxel(KnownNames):
    grid_index: Cells
    color: Colors

    def __init__(self, grid_index: object = (0, 0, 0), color: ArrayLike = (0.0, 0.0, 0.0)):
        if isinstance(grid_index, Voxel):
            grid_index, color = grid_index.grid_index, grid_index.color
        self.grid_index, self.color = np.array(grid_index, np.int32), np.array(color, np.float64)

    def __repr__(self) -> str:
        index, color = (", ".join(f"{value:g}" for value in row) for row in (self.grid_index, self.color))
        return f"Voxel with grid_index: ({index}), color: ({color})"


class VoxelGrid(PlainWrapper, Geometry3D):
    """Occupied voxels with colors, sorted by index. Voxel (0, 0, 0) begins at `origin`, its axes are `rotation`."""

    _internal = ("from_cells", "cells_and_colors")

    VoxelPoolingMode = VoxelPoolingMode
    _kind = voxel_grid.VoxelGrid

    def __init__(self, grid: VoxelGrid | None = None):
        self._shared = {}
        if grid is not None:
            vars(self).update(vars(grid.__copy__()))
            return
        self._place(np.zeros(3), 0.0)
        self._store(np.zeros((0, 3), np.int32), np.zeros((0, 3)))

    @classmethod
    def from_cells(cls, origin: NDArray[np.float64], voxel_size: float, cells: Cells, colors: Colors | None) -> Self:
        """A grid of the voxels with these indices, black without colors."""
        made = cls()
        place = {"_origin": np.array(origin, np.float64), "_voxel_size": voxel_size}
        vars(made).update(place, _cells=cells, _colors=np.zeros((len(cells), 3)) if colors is None else colors)
        return made

    @classmethod
    def from_native(cls, native: voxel_grid.VoxelGrid) -> Self:
        return cls.from_cells(native.origin, native.voxel_size, native.coordinates, None)

    def _place(self, origin: NDArray[np.float64], voxel_size: float) -> None:
        self._origin, self._voxel_size, self._rotation = origin, voxel_size, np.eye(3)

    def _store(self, cells: Cells, colors: Colors) -> Self:
        self._cells, self._colors, self._edits = cells, colors, {}
        return self

    def cells_and_colors(self) -> tuple[Cells, Colors]:
        """Indices and colors, with the added and removed voxels."""
        if self._edits:
            edited = np.array(list(self._edits), np.int32)
            removed = np.array([color is None for color in self._edits.values()])
            colors = np.array([(0, 0, 0) if color is None else color for color in self._edits.values()], np.float64)
            cells, order, starts = _sorted_cells(np.concatenate([edited, self._cells]))
            first = order[starts]
            kept = ~np.concatenate([removed, np.zeros(len(self._cells), bool)])[first]
            self._store(cells[kept], np.concatenate([colors, self._colors])[first[kept]])
        return self._cells, self._colors

    @property
    def native(self) -> Any:
        """A `loom.VoxelGrid`. A mesh of the voxels if the grid is rotated."""
        cells, colors = self.cells_and_colors()
        if not np.array_equal(self._rotation, np.eye(3)):
            corners = self._located(cells[:, None] + VOXEL_CORNERS).reshape(-1, 3)
            triangles = (8 * np.arange(len(cells))[:, None, None] + CUBE_TRIANGLES).reshape(-1, 3)
            return mesh.TriangleMesh(corners, triangles, vertex_colors=np.repeat(np.clip(colors, 0, 1), 8, axis=0))
        low = cells.min(axis=0, initial=0)
        x, y, z = (cells.max(axis=0) - low + 1).tolist() if len(cells) else (0, 0, 0)
        return self._kind(self._origin + low * self._voxel_size, self._voxel_size, (x, y, z), cells - low)

    def _located(self, positions: ArrayLike) -> NDArray[np.float64]:
        """World coordinates of positions in voxels."""
        return self._origin + matmul(np.asarray(positions) * self._voxel_size, self._rotation.T)

    @classmethod
    def create_dense(
        cls, origin: ArrayLike, color: ArrayLike, voxel_size: float, width: float, height: float, depth: float
    ) -> Self:
        """All voxels of a box."""
        edge = check_positive("voxel_size", voxel_size)
        sizes = [check_positive(n, v) for n, v in (("width", width), ("height", height), ("depth", depth))]
        cells = np.indices([round(size / edge) for size in sizes], np.int32).reshape(3, -1).T.copy()
        return cls.from_cells(column("origin", origin), edge, cells, np.tile(column("color", color), (len(cells), 1)))

    @classmethod
    def create_from_triangle_mesh(cls, input: MeshLike, voxel_size: float) -> Self:
        return cls.from_native(unwrap(input, TriangleMesh, "input").voxelize(voxel_size))

    @classmethod
    def create_from_triangle_mesh_within_bounds(
        cls, input: MeshLike, voxel_size: float, min_bound: ArrayLike, max_bound: ArrayLike
    ) -> Self:
        corners = column("min_bound", min_bound), column("max_bound", max_bound)
        return cls.from_native(unwrap(input, TriangleMesh, "input").voxelize(voxel_size, *corners))

    @classmethod
    def create_from_point_cloud(
        cls, input: CloudLike, voxel_size: float, pooling_mode: VoxelPoolingMode = VoxelPoolingMode.AVG
    ) -> Self:
        """Voxels of a cloud, from half a voxel below its minimum."""
        lowest = (
            input.get_min_bound()
            if isinstance(input, PointCloud)
            else unwrap(input, PointCloud, "input").get_min_bound()
        )
        return cls._pooled(input, voxel_size, lowest - check_positive("voxel_size", voxel_size) / 2, pooling_mode)

    @classmethod
    def create_from_point_cloud_within_bounds(
        cls,
        input: CloudLike,
        voxel_size: float,
        min_bound: ArrayLike,
        max_bound: ArrayLike,
        pooling_mode: VoxelPoolingMode = VoxelPoolingMode.AVG,
    ) -> Self:
        """Voxels of a cloud, from `min_bound` on. As in Open3D, points outside the bounds are included."""
        column("max_bound", max_bound)
        return cls._pooled(input, voxel_size, column("min_bound", min_bound), pooling_mode)

    @classmethod
    def _pooled(cls, cloud: CloudLike, voxel_size: float, origin: ArrayLike, mode: VoxelPoolingMode) -> Self:
        if not isinstance(mode, VoxelPoolingMode):
            raise TypeError(f"pooling_mode: expected a VoxelGrid.VoxelPoolingMode, got {type(mode).__name__}")
        edge, low = check_positive("voxel_size", voxel_size), np.asarray(origin, np.float64)
        ours = unwrap(cloud, PointCloud, "input")
        assigned = cloud.assigned_points() if isinstance(cloud, PointCloud) else None
        points = ours.points if assigned is None else assigned
        rows = np.flatnonzero(np.isfinite(points).all(axis=1))
        indices = np.floor((points[rows] - low) / edge)
        if not (np.abs(indices) < LARGEST_INDEX).all():
            raise ValueError(f"voxel_size: expected fewer than 2**31 voxels along each axis, got voxels of {edge:g}")
        cells, order, starts = _sorted_cells(indices.astype(np.int32))
        colors = _pool(ours.colors[rows[order]].astype(np.float64), starts, mode) if ours.has_colors else None
        return cls.from_cells(low, edge, cells, colors)

    def create_from_octree(self, octree: Any) -> None:
        """Replace the voxels by the leaves of an octree."""
        vars(self).update(vars(octree.to_voxel_grid()))

    def to_octree(self, max_depth: int) -> Any:
        made = geometry.Octree(max_depth)
        made.create_from_voxel_grid(self)
        return made

    @property
    def origin(self) -> NDArray[np.float64]:
        """Corner of voxel (0, 0, 0)."""
        return self._origin

    @origin.setter
    def origin(self, value: ArrayLike) -> None:
        self._origin = column("origin", value).astype(np.float64)

    @property
    def voxel_size(self) -> float:
        return float(self._voxel_size)

    @voxel_size.setter
    def voxel_size(self, value: float) -> None:
        self._voxel_size = check_positive("voxel_size", value, allow_zero=True)

    @property
    def rotation(self) -> NDArray[np.float64]:
        """Axes of the grid, shape (3, 3)."""
        return self._rotation

    @rotation.setter
    def rotation(self, value: ArrayLike) -> None:
        self._rotation = check_shape("rotation", value, (3, 3)).astype(np.float64)

    def add_voxel(self, voxel: Voxel) -> None:
        """Add a voxel, or replace its color."""
        self._edits[tuple(column("grid_index", voxel.grid_index).tolist())] = column("color", voxel.color)

    def remove_voxel(self, idx: ArrayLike) -> None:
        self._edits[tuple(column("idx", idx).tolist())] = None

    def get_voxels(self) -> list[Voxel]:
        return [Voxel(*both) for both in zip(*self.cells_and_colors(), strict=True)]

    def get_voxel(self, point: ArrayLike) -> Cells:
        """Index of the voxel of a point, occupied or not."""
        return self._cells_of(column("point", point)).astype(np.int32)

    def _cells_of(self, points: NDArray[Any]) -> NDArray[np.float64]:
        return np.floor(matmul(points - self._origin, inv(self._rotation).T) / self._voxel_size)

    def get_voxel_center_coordinate(self, idx: ArrayLike) -> NDArray[np.float64]:
        """Center of an occupied voxel. Zero for others."""
        index = column("idx", idx)
        is_there = bool((self.cells_and_colors()[0] == index).all(axis=1).any())
        return self._located(index + 0.5) if is_there else np.zeros(3)

    def get_voxel_bounding_points(self, index: ArrayLike) -> Vector3dVector:
        """Corners of a voxel."""
        return Vector3dVector(self._located(column("index", index) + VOXEL_CORNERS))

    def check_if_included(self, queries: VectorLike) -> list[bool]:
        """For each point, True if it is in an occupied voxel."""
        occupied = set(map(tuple, self.cells_and_colors()[0].tolist()))
        return [tuple(cell) in occupied for cell in self._cells_of(as_array(queries).reshape(-1, 3)).tolist()]

    def carve_depth_map(
        self, depth_map: object, camera_params: object, keep_voxels_outside_image: bool = False
    ) -> Self:
        """Remove voxels of which no corner is at or behind the depth of its pixel. The image is float32 [m]."""
        return self._carve("depth_map", depth_map, camera_params, keep_voxels_outside_image, by_depth=True)

    def carve_silhouette(
        self, silhouette_mask: object, camera_params: object, keep_voxels_outside_image: bool = False
    ) -> Self:
        """Remove voxels of which no corner projects to a pixel above 0 of a float32 mask."""
        return self._carve("silhouette_mask", silhouette_mask, camera_params, keep_voxels_outside_image)

    def _carve(self, name: str, image: object, camera: object, keep_outside: bool, *, by_depth: bool = False) -> Self:
        if not isinstance(camera, PinholeCameraParameters):
            raise TypeError(f"camera_params: expected PinholeCameraParameters, got {type(camera).__name__}")
        if not isinstance(image, Image):
            raise TypeError(f"{name}: expected a geometry.Image, got {type(image).__name__}")
        pixels, intrinsic = np.asarray(image), camera.intrinsic
        if pixels.dtype != np.float32 or pixels.ndim != 2:
            raise TypeError(f"{name}: expected float32 of shape [h, w], got {pixels.dtype} of {list(pixels.shape)}")
        if pixels.shape != (intrinsic.height, intrinsic.width):
            raise ValueError(
                f"{name}: expected {intrinsic.width} x {intrinsic.height} pixels as in camera_params, got "
                f"{pixels.shape[1]} x {pixels.shape[0]}"
            )
        cells, colors = self.cells_and_colors()
        kept = np.zeros(len(cells), bool)
        for corner in VOXEL_CORNERS:
            local = matmul(self._located(cells + corner), camera.extrinsic[:3, :3].T) + camera.extrinsic[:3, 3]
            values, inside = _values_at(pixels, matmul(local, intrinsic.intrinsic_matrix.T))
            kept |= inside & (values > 0) & (local[:, 2] >= values if by_depth else True) | (~inside & keep_outside)
        return self._store(cells[kept], colors[kept])

    def has_voxels(self) -> bool:
        return len(self.cells_and_colors()[0]) > 0

    def has_colors(self) -> bool:
        """Always True, as in Open3D: voxels without colors are black."""
        return True

    def is_empty(self) -> bool:
        return not self.has_voxels()

    def clear(self) -> Self:
        self.__init__()
        return self

    def _corners(self) -> NDArray[np.float64]:
        return self._located(self.cells_and_colors()[0][:, None] + VOXEL_CORNERS).reshape(-1, 3)

    def _bound(self, extreme: Callable[..., Any]) -> NDArray[np.float64]:
        cells = self.cells_and_colors()[0]
        if not len(cells):
            return self._origin.copy()
        return extreme([extreme(self._located(cells + corner), axis=0) for corner in VOXEL_CORNERS], axis=0)

    def get_min_bound(self) -> NDArray[np.float64]:
        return self._bound(np.min)

    def get_max_bound(self) -> NDArray[np.float64]:
        return self._bound(np.max)

    def get_center(self) -> NDArray[np.float64]:
        """Mean of the voxel centers."""
        return self._located(self.cells_and_colors()[0].mean(axis=0) + 0.5) if self.has_voxels() else np.zeros(3)

    def get_axis_aligned_bounding_box(self) -> AxisAlignedBoundingBox:
        return AxisAlignedBoundingBox(self.get_min_bound(), self.get_max_bound())

    def get_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        return OrientedBoundingBox.create_from_points(self._corners(), robust)

    def get_minimal_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        return OrientedBoundingBox.create_from_points_minimal(self._corners(), robust)

    def transform(self, arg0: ArrayLike) -> Self:
        """Transform `origin` and `rotation` by a 4x4 matrix."""
        T = check_shape("transformation", arg0, (4, 4)).astype(np.float64)
        self._origin = matmul(T[:3, :3], self._origin) + T[:3, 3]
        self._rotation = matmul(T[:3, :3], self._rotation)
        return self

    def translate(self, translation: ArrayLike, relative: bool = True) -> Self:
        """Translate by a vector. With `relative=False`, move the center there."""
        self._origin = self._origin + column("translation", translation) - (0 if relative else self.get_center())
        return self

    def scale(self, scale: float, center: ArrayLike) -> Self:
        """Scale the voxels about a point."""
        middle, factor = column("center", center), check_positive("scale", scale)
        self._origin, self._voxel_size = (self._origin - middle) * factor + middle, self._voxel_size * factor
        return self

    def rotate(self, R: ArrayLike, center: ArrayLike | None = None) -> Self:
        """Rotate about a point, by default the center."""
        A, middle = check_shape("R", R, (3, 3)), self.get_center() if center is None else column("center", center)
        self._origin = matmul(A, self._origin - middle) + middle
        self._rotation = matmul(A, self._rotation)
        return self

    def __iadd__(self, other: object) -> Self:
        """Voxels of both. Colors of common voxels are averaged."""
        if not isinstance(other, VoxelGrid):
            raise TypeError(f"other: expected a VoxelGrid, got {type(other).__name__}")
        mine, theirs = ((g.voxel_size, *g.origin, *g.rotation.flat) for g in (self, other))
        if mine != theirs:
            raise ValueError(f"other: expected the same voxel_size, origin and rotation, {mine[:4]}, got {theirs[:4]}")
        (cells, colors), (more, others) = self.cells_and_colors(), other.cells_and_colors()
        joined, order, starts = _sorted_cells(np.concatenate([cells, more]))
        return self._store(joined, _pool(np.concatenate([colors, others])[order], starts, VoxelPoolingMode.AVG))

    def __add__(self, other: object) -> VoxelGrid:
        made = self.__copy__()
        made += other
        return made

    def __copy__(self) -> Self:
        made = type(self).__new__(type(self))
        vars(made).update(vars(self) | {"_edits": dict(self._edits), "_origin": self._origin.copy()})
        return made

    def __repr__(self) -> str:
        return f"VoxelGrid with {len(self.cells_and_colors()[0])} voxels."


def _sorted_cells(cells: Cells) -> tuple[Cells, NDArray[np.intp], NDArray[np.intp]]:
    """Distinct cells by x, y, z; a stable order of the given ones; and the start of each distinct cell in it."""
    order = np.lexsort(cells.T[::-1])
    rows = cells[order]
    starts = np.flatnonzero(np.r_[True, (rows[1:] != rows[:-1]).any(axis=1)]) if len(rows) else order
    return rows[starts], order, starts


def _pool(colors: Colors, starts: NDArray[np.intp], mode: VoxelPoolingMode) -> Colors:
    """Combine the colors from each start to the next."""
    if not len(starts):
        return colors
    ways = {VoxelPoolingMode.MIN: np.minimum, VoxelPoolingMode.MAX: np.maximum}
    pooled = ways.get(mode, np.add).reduceat(colors, starts)
    return pooled / np.diff(np.r_[starts, len(colors)])[:, None] if mode is VoxelPoolingMode.AVG else pooled


def _values_at(pixels: NDArray[Any], uvz: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """Bilinear values at projected points, and whether these are in front of the camera and inside the image."""
    height, width = pixels.shape
    with np.errstate(divide="ignore", invalid="ignore"):
        u, v = uvz[:, :2].T / uvz[:, 2]
        inside = (uvz[:, 2] > 0) & (u >= 0) & (v >= 0) & (u <= width - 1) & (v <= height - 1)
    u, v = np.where(inside, u, 0.0), np.where(inside, v, 0.0)
    x, y = np.minimum(u.astype(int), max(width - 2, 0)), np.minimum(v.astype(int), max(height - 2, 0))
    right, below, a, b = np.minimum(x + 1, width - 1), np.minimum(y + 1, height - 1), u - x, v - y
    upper, lower = (pixels[row, x] * (1 - a) + pixels[row, right] * a for row in (y, below))
    return np.where(inside, upper * (1 - b) + lower * b, 0.0), inside
