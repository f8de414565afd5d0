"""PointCloud: points with named attributes, as a structure of arrays on one device."""

from __future__ import annotations

from typing import Any

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ..kernels.bounds import bound_points
from ..kernels.depth import color_pixels, unproject_depth
from ..kernels.lang import float64, int32, vec3
from ..kernels.masks import mask_aligned_box, mask_finite, mask_oriented_box
from ..kernels.memory import cast, upload
from ..kernels.normals import align_normals, estimate_normals, orient_normals
from ..kernels.point_tree import PointTree
from ..kernels.segments import average_vec3, first_rows, sum_columns
from ..kernels.select import gather_rows, invert_mask, positions_of
from ..kernels.transform import transform_directions, transform_points
from ..kernels.voxel_keys import VoxelGroups
from .boxes import AxisAlignedBoundingBox, OrientedBoundingBox
from .camera import PinholeCameraIntrinsic
from .checks import (
    check_count,
    check_finite,
    check_numeric,
    check_positive,
    check_rigid,
    check_rows,
    check_shape,
    check_transformation,
)
from .coordinates import FLOAT32_MAX, split_origin
from .devices import resolve_device
from .images import RGBDImage, check_intrinsic, upload_depth
from .point_arrays import VECTORS, PointArrays


class PointCloud(PointArrays):
    """Points in space with attributes, on one device.

    Positions are float32 relative to a float64 `origin`, which moves by itself where coordinates exceed 1e4, so
    kernels stay exact at UTM coordinates. Reading `points`, `normals`, `colors` gives NumPy arrays; `array(name)`
    gives the device array without a copy. Every operation returns a new cloud that shares what it did not change, and
    carries all attributes along. Points that are not finite are kept and never counted: they are nobody's neighbour.

    Args:
        points: Shape [n, 3] [m].
        normals: Shape [n, 3].
        colors: Shape [n, 3], 0..1; uint8 is divided by 255.
        device: "cpu", "cuda:0", "auto"; None for the CPU.
        origin: Where the float32 coordinates start [m], shape [3]; chosen where not given.
        **attributes: Further arrays of shape [n] or [n, c], such as intensity, ring, label.

    Raises:
        ValueError: Wrong shapes or lengths, colours out of range.
        TypeError: Not numeric.
        DeviceError: No such device.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> cloud = loom.PointCloud(np.random.default_rng(0).random((1000, 3)), intensity=np.arange(1000))
        >>> small = cloud.voxel_down_sample(0.5).estimate_normals(radius=1.0, max_nn=30)
        >>> len(small), small.normals.shape, list(small.attributes)
        (27, (27, 3), ['intensity'])
    """

    def __init__(
        self,
        points: ArrayLike = (),
        *,
        normals: ArrayLike | None = None,
        colors: ArrayLike | None = None,
        device: Any = None,
        origin: ArrayLike | None = None,
        **attributes: ArrayLike,
    ):
        where = resolve_device(device)
        positions = check_rows("points", points, 3)
        start = None if origin is None else check_finite("origin", check_shape("origin", origin, (3,)))
        local, self._origin = split_origin(positions, start)
        self._arrays = {"points": upload(local, vec3, where)}
        self.grid = None
        if normals is not None:
            self._set("normals", normals)
        if colors is not None:
            self._set("colors", colors)
        for name, values in attributes.items():
            self._set(name, values)

    # ------------------------------------------------------------------------------------------ selection

    def select_by_index(self, indices: ArrayLike, invert: bool = False) -> PointCloud:
        """The points at some indices, in the order given, repeats kept; or with `invert` all others in their order.

        Open3D's legacy form sorts the indices and drops repeats; this one follows its tensor form.

        Raises:
            IndexError: An index beyond the cloud.
            TypeError: Not whole numbers.
        """
        rows = check_numeric("indices", indices)
        if rows.dtype.kind not in "iu" and rows.size:
            raise TypeError(f"indices: expected whole numbers, got {rows.dtype}; for a mask see select_by_mask")
        rows = rows.reshape(-1)
        if rows.size and (rows.min() < -len(self) or rows.max() >= len(self)):
            raise IndexError(f"indices: {rows.min()}..{rows.max()} reach beyond a cloud of {len(self)} points")
        rows = rows.astype(np.int64)
        rows = np.where(rows < 0, rows + len(self), rows)
        if invert:
            mask = np.ones(len(self), bool)
            mask[rows] = False
            rows = np.flatnonzero(mask)
        return self._select(upload(rows.astype(np.int32), int32, self.device))

    def select_by_mask(self, mask: ArrayLike, invert: bool = False) -> PointCloud:
        """The points where a boolean mask of shape [n] is set (or, inverted, is not).

        Raises:
            ValueError: Not booleans, or another shape.
        """
        chosen = np.asarray(mask)
        if chosen.dtype != np.bool_ or chosen.shape != (len(self),):
            raise ValueError(f"mask: expected booleans of shape [{len(self)}], got {chosen.dtype} {list(chosen.shape)}")
        return self._select(upload(np.flatnonzero(chosen != invert).astype(np.int32), int32, self.device))

    def crop(self, bounding_box: AxisAlignedBoundingBox | OrientedBoundingBox, invert: bool = False) -> PointCloud:
        """The points inside a box, its faces included; or with `invert` all others.

        Raises:
            TypeError: No bounding box.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[0, 0, 0], [1, 1, 1], [2, 2, 2]])
            >>> len(cloud.crop(loom.AxisAlignedBoundingBox([0.5] * 3, [2] * 3)))
            2
        """
        points = self._arrays["points"]
        if isinstance(bounding_box, AxisAlignedBoundingBox):
            mask = mask_aligned_box(points, self._origin, bounding_box.min_bound, bounding_box.max_bound)
        elif isinstance(bounding_box, OrientedBoundingBox):
            offset = self._origin - bounding_box.center
            mask = mask_oriented_box(points, offset, bounding_box.R.T, bounding_box.extent / 2)
        else:
            raise TypeError(f"bounding_box: expected a bounding box, got {type(bounding_box).__name__}")
        return self._select_mask(mask, invert)

    def remove_non_finite_points(self, remove_nan: bool = True, remove_infinite: bool = True) -> PointCloud:
        """The cloud without points that have a NaN or an infinite coordinate."""
        return self._select_mask(mask_finite(self._arrays["points"], remove_nan, remove_infinite))

    def voxel_down_sample(self, voxel_size: float) -> PointCloud:
        """One point for each occupied voxel: the mean of its points and of all their attributes.

        The grid starts half a voxel below the lowest corner, as Open3D's legacy form does. Means are summed in
        float64 in the order of the points, normals are not made unit again, and integer attributes take the value of
        the voxel's first point. Points that are not finite are dropped (Open3D emits a NaN point), and a NaN normal
        does not count in a mean (Open3D counts it in the divisor).

        Args:
            voxel_size: Edge of a voxel [m].

        Returns:
            The means in the order of the voxels, x slowest. O(n) memory, the same bits from run to run.

        Raises:
            ValueError: Not a positive number, or so small that the grid has more than 2^62 cells.
        """
        size = check_positive("voxel_size", voxel_size)
        points = self._arrays["points"]
        low, high, finite = bound_points(points)
        if not finite:
            return self._select(upload(np.zeros(0, np.int32), int32, self.device))
        corner = low.astype(np.float64) - size / 2
        with np.errstate(over="ignore"):
            cells = np.floor((high.astype(np.float64) - corner) / size) + 1
        groups = VoxelGroups(points, corner, size, cells)
        means: dict[str, wp.array] = {}
        rows = None
        for name, values in self._arrays.items():
            if name in VECTORS:
                means[name] = average_vec3(values, groups.order, groups.starts)
            elif np.dtype(wp.dtype_to_numpy(values.dtype)).kind == "f":
                means[name] = self._average(values, groups)
            else:
                rows = first_rows(groups.order, groups.starts) if rows is None else rows
                means[name] = gather_rows(values, rows)
        return self._with(means)

    # ------------------------------------------------------------------------------------------ geometry

    def get_min_bound(self) -> NDArray[np.float64]:
        """The lowest coordinates of the finite points [m], shape [3]; zeros for an empty cloud."""
        return self._bounds()[0]

    def get_max_bound(self) -> NDArray[np.float64]:
        """The highest coordinates of the finite points [m], shape [3]; zeros for an empty cloud."""
        return self._bounds()[1]

    def transform(self, transformation: ArrayLike) -> PointCloud:
        """The cloud under a 4x4 affine map, computed in float64; normals are turned, and keep their lengths.

        Raises:
            ValueError: Not finite, not invertible, or the last row is not (0, 0, 0, 1).
        """
        T = check_transformation("transformation", transformation)
        A, t = T[:3, :3], T[:3, 3]
        low, high = self._bounds()
        middle, half = A @ ((low + high) / 2) + t, np.abs(A) @ ((high - low) / 2)
        corners = np.stack([middle - half, middle + half])
        _, origin = split_origin(corners)
        carried = np.round(A @ self._origin + t)  # near most of the points still, whatever a stray one does to the box
        if origin.any() and np.abs(corners - carried).max() < FLOAT32_MAX:
            origin = carried
        arrays = dict(self._arrays)
        arrays["points"] = transform_points(arrays["points"], A, A @ self._origin + t - origin)
        if self.has_normals:
            arrays["normals"] = transform_directions(arrays["normals"], np.linalg.inv(A).T)
        cloud = self._with(arrays, grid=self.grid)
        cloud._origin = origin
        return cloud

    def estimate_normals(self, *, radius: float | None = None, max_nn: int | None = 30) -> PointCloud:
        """Fit a plane to the neighbours of each point.

        Args:
            radius: Search radius [m], the boundary excluded; with `max_nn` the nearest `max_nn` within it. None
                searches by count alone.
            max_nn: Neighbours a fit, the point itself included; None takes all within the radius.

        Returns:
            The cloud with unit normals, shape [n, 3]; (0, 0, 1) where fewer than 3 neighbours are found, NaN for
            points that are not finite. The sign follows earlier normals where there were any.

        Raises:
            ValueError: Neither limit given, or one out of range.

        Notes:
            O(n) memory. Same bits from run to run. Hoppe et al. 1992, section 3.1. Covariances are centred, so
            coordinates of any size do no harm (Open3D's legacy form turns 57 % of normals at UTM coordinates), and
            one NaN spoils no other point's normal.
        """
        if radius is None and max_nn is None:
            raise ValueError("radius, max_nn: give at least one of them")
        reach = np.inf if radius is None else check_positive("radius", radius)
        count = None if max_nn is None else check_count("max_nn", max_nn, minimum=1)
        points = self._arrays["points"]
        normals = estimate_normals(PointTree(points), points, count, reach)
        if self.has_normals:
            align_normals(normals, self._arrays["normals"])
        return self._with(self._arrays | {"normals": normals}, grid=self.grid)

    def orient_normals_to_align_with_direction(self, orientation_reference: ArrayLike = (0.0, 0.0, 1.0)) -> PointCloud:
        """The cloud with each normal on the side of a direction; a zero normal becomes the direction.

        Raises:
            ValueError: The cloud has no normals, or a direction of another shape or not finite.
        """
        shaped = check_shape("orientation_reference", orientation_reference, (3,))
        reference = check_finite("orientation_reference", shaped)
        return self._orient(reference, to_point=False)

    def orient_normals_towards_camera_location(self, camera_location: ArrayLike = (0.0, 0.0, 0.0)) -> PointCloud:
        """The cloud with each normal on the side of a camera [m].

        Raises:
            ValueError: The cloud has no normals, or a place of another shape or not finite.
        """
        location = check_finite("camera_location", check_shape("camera_location", camera_location, (3,)))
        return self._orient(location - self._origin, to_point=True)

    # ------------------------------------------------------------------------------------------ from images

    @classmethod
    def from_depth_image(
        cls,
        depth: ArrayLike,
        intrinsic: PinholeCameraIntrinsic,
        extrinsic: ArrayLike | None = None,
        depth_scale: float = 1000.0,
        depth_trunc: float = 1000.0,
        stride: int = 1,
        project_valid_depth_only: bool = True,
        *,
        device: Any = None,
    ) -> PointCloud:
        """The points of a depth image, row by row.

        Args:
            depth: Shape [h, w]; integers are divided by `depth_scale`, floats are metres.
            intrinsic: The camera, of the image's size.
            extrinsic: T_camera_world, shape [4, 4]; None for the identity.
            depth_scale: Integer units a metre.
            depth_trunc: Farthest depth kept [m] (Open3D drops it itself), also for float depth (Open3D ignores it
                there).
            stride: Takes every stride-th pixel of every stride-th row.
            project_valid_depth_only: False keeps the grid: NaN points where there is no depth, `cloud.grid` set.
            device: Where the cloud goes.

        Raises:
            ValueError: Wrong shapes, sizes that disagree, an extrinsic that is no rigid motion.
        """
        where = resolve_device(device)
        metric, _, height, width = upload_depth(depth, depth_scale, depth_trunc, where, limit="depth_trunc")
        return cls._unproject(metric, None, height, width, intrinsic, extrinsic, stride, project_valid_depth_only)

    @classmethod
    def from_rgbd_image(
        cls,
        image: RGBDImage,
        intrinsic: PinholeCameraIntrinsic,
        extrinsic: ArrayLike | None = None,
        project_valid_depth_only: bool = True,
        *,
        stride: int = 1,
    ) -> PointCloud:
        """The coloured points of an RGB-D image; arguments as in `from_depth_image`."""
        size = (image.height, image.width)
        return cls._unproject(image._depth, image._color, *size, intrinsic, extrinsic, stride, project_valid_depth_only)

    # ------------------------------------------------------------------------------------------ internals

    @classmethod
    def _unproject(cls, depth, color, height, width, intrinsic, extrinsic, stride, valid_only) -> PointCloud:
        camera = check_intrinsic(intrinsic, width, height)
        step = check_count("stride", stride)
        T_world_camera = np.eye(4)
        if extrinsic is not None:
            T_world_camera = np.linalg.inv(check_rigid("extrinsic", extrinsic))
        _, origin = split_origin(T_world_camera[None, :3, 3])
        local = T_world_camera.copy()
        local[:3, 3] -= origin
        focal = (camera.fx, camera.fy, camera.cx, camera.cy)
        points, valid, rows, columns = unproject_depth(depth, width, height, step, focal, local)
        arrays = {"points": points}
        if color is not None:
            arrays["colors"] = color_pixels(color, width, rows, columns, step)
        cloud = cls._from_arrays(arrays, origin)
        if valid_only:
            return cloud._select_mask(valid)
        cloud.grid = (rows, columns)
        return cloud

    def _select(self, rows: wp.array) -> PointCloud:
        return self._with({name: gather_rows(values, rows) for name, values in self._arrays.items()})

    def _select_mask(self, mask: wp.array, invert: bool = False) -> PointCloud:
        return self._select(positions_of(invert_mask(mask) if invert else mask))

    def _average(self, values: wp.array, groups: VoxelGroups) -> wp.array:
        shape = values.shape
        columns = cast(values.reshape((shape[0], shape[1] if len(shape) > 1 else 1)), float64)
        means = sum_columns(columns, groups.order, groups.starts, mean=True)
        return cast(means, values.dtype).reshape((groups.count, *shape[1:]))

    def _bounds(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        low, high, finite = bound_points(self._arrays["points"])
        if not finite:
            return np.zeros(3), np.zeros(3)
        return low.astype(np.float64) + self._origin, high.astype(np.float64) + self._origin

    def _orient(self, reference: NDArray[np.float64], *, to_point: bool) -> PointCloud:
        normals = self._require("normals", "call estimate_normals() first")
        oriented = orient_normals(self._arrays["points"], normals, reference, to_point)
        return self._with(self._arrays | {"normals": oriented}, grid=self.grid)
