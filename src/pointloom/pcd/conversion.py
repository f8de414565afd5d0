"""Clouds to and from depth images, arrays of other libraries, Open3D and pickle."""

from __future__ import annotations

import sys
from typing import Any, Self, cast

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ..cameras.camera import PinholeCameraIntrinsic, check_pixels
from ..cameras.depth_checks import warn_of_scale
from ..cameras.depth_range import OPEN3D_DEPTH_MAX
from ..cameras.images import RGBDImage, check_intrinsic, upload_depth
from ..core.argument_errors import explain_argument_errors
from ..core.array_libraries import check_library, hand_out, library_for, library_of
from ..core.checks import check_count, check_finite, check_positive, check_rigid, check_shape
from ..core.coordinates import origin_of_sensor
from ..core.devices import DeviceLike, check_same_device
from ..core.escaped_text import escaped
from ..core.exchange import share_numbers, share_vectors
from ..core.gpu_arrays import device_for
from ..core.other_geometry import OtherGeometry, conversion_of, read_or_refuse
from ..core.pickled_arrays import device_like, pickled, unpickled, unpickling
from ..core.to_other_libraries import import_library, to_meshio, to_pyvista, to_trimesh
from ..kernels.images.depth import PixelGrid, color_pixels, pixel_normals, unproject_depth
from ..kernels.images.depth_projection import project_points, read_colors, read_depth
from ..kernels.lang import vec2, vec3, vec3i
from ..kernels.linear_algebra import inv, matmul
from ..kernels.memory import clone, download
from .cached_tree import CachedTree
from .point_arrays import VECTORS
from .selection import Selection

IMPLAUSIBLE_DEPTH = 1000.0  # [m] beyond the range of depth cameras
OTHER_UNIT = 30.0  # times the maximum depth: a larger scene suggests another unit
_COVARIANCES = "covariances"  # (n, 9) here, (n, 3, 3) in Open3D


class Conversion(Selection):
    """Methods of PointCloud that convert it to and from images and other libraries.

    A pickled cloud is restored on the saved device, or the first GPU if its index does not exist. `copy.copy` shares
    arrays, `copy.deepcopy` copies them.
    """

    _internal = ("from_device_depth",)

    @classmethod
    @explain_argument_errors
    def create_from_depth_image(
        cls,
        depth: ArrayLike,
        intrinsic: PinholeCameraIntrinsic,
        extrinsic: ArrayLike | None = None,
        depth_scale: float | None = None,
        depth_trunc: float = 1000.0,
        stride: int = 1,
        project_valid_depth_only: bool = True,
        *,
        with_normals: bool = False,
        device: DeviceLike = None,
        arrays: str | None = None,
    ) -> Self:
        """Create a cloud from a depth image, row by row.

        Args:
            depth: Shape (h, w). Integers of 16 bits and more, or floats.
            intrinsic: The camera, of the image's size.
            extrinsic: T_camera_world, shape (4, 4). If None: identity.
            depth_scale: Depth units per meter. If None: 1000 for integers, 1 for floats.
            depth_trunc: Maximum depth kept [m], also for float depth.
            stride: Use every stride-th pixel and row.
            project_valid_depth_only: If False, keep the grid: NaN points without depth, and `cloud.grid` is set.
            with_normals: Add unit normals toward the camera from differences to the next grid points, see
                `create_normal_map`. Points without one are dropped, or get NaN if the grid is kept. Smooth the depth
                first with `filter_depth_bilateral` or `create_depth_pyramid`.
            device: Target device. If None: the depth's GPU, or the CPU.
            arrays: Library of returned arrays, as of `to`. If None: that of the depth.

        Raises:
            ValueError: If shapes or sizes disagree, or the extrinsic is not rigid.
        """
        where, library = device_for(depth, device), library_for(arrays, depth)
        metric, scale, height, width = upload_depth(depth, depth_scale, depth_trunc, where, limit="depth_trunc")
        camera = check_intrinsic(intrinsic, width, height)
        times = 1.0 if depth_trunc >= IMPLAUSIBLE_DEPTH else OTHER_UNIT
        warn_of_scale(depth, scale, depth_trunc, times=times)
        cloud = cls.from_device_depth(metric, None, camera, extrinsic, stride, project_valid_depth_only, with_normals)
        cloud.arrays.library = library
        return cloud

    create_from_depth_image = create_from_depth_image

    @classmethod
    @explain_argument_errors
    def create_from_rgbd_image(
        cls,
        image: RGBDImage,
        intrinsic: PinholeCameraIntrinsic,
        extrinsic: ArrayLike | None = None,
        project_valid_depth_only: bool = True,
        *,
        stride: int = 1,
        with_normals: bool = False,
    ) -> Self:
        """Create a colored cloud from an RGB-D image, gray if it has intensity only. See `create_from_depth_image`."""
        if not isinstance(image, RGBDImage):
            raise TypeError(f"image: expected an RGBDImage, got {type(image).__name__}")
        camera = check_intrinsic(intrinsic, image.width, image.height)
        cloud = cls.from_device_depth(
            image.depth_array, image.color_array, camera, extrinsic, stride, project_valid_depth_only, with_normals
        )
        cloud.arrays.library = image.array_library
        return cloud

    create_from_rgbd_image = create_from_rgbd_image

    def project_to_depth_image(
        self,
        width: int,
        height: int,
        intrinsic: PinholeCameraIntrinsic,
        extrinsic: ArrayLike | None = None,
        depth_scale: float = 1.0,
        depth_max: float = OPEN3D_DEPTH_MAX,
    ) -> NDArray[np.float32]:
        """Render a depth image of the cloud: the depth of the nearest point in each pixel.

        Args:
            width, height: Size of the image [px].
            intrinsic: The camera, of that size.
            extrinsic: T_camera_world, shape (4, 4). If None: identity.
            depth_scale: Units per meter of the result. 1000 for millimeters (Open3D's default).
            depth_max: Maximum depth [m].

        Returns:
            Depth times `depth_scale`, float32 (height, width). 0 without a point. Bitwise reproducible. 8 B per pixel.

        Raises:
            ValueError: If sizes disagree, a number is out of range, or the extrinsic is not rigid.

        Example:
            >>> import pointloom as loom
            >>> camera = loom.PinholeCameraIntrinsic(3, 2, 1.0, 1.0, 1.0, 0.0)
            >>> loom.PointCloud([[0, 0, 2], [2, 2, 2], [0, 0, 1]]).project_to_depth_image(3, 2, camera)
            array([[0., 1., 0.],
                   [0., 0., 2.]], dtype=float32)
        """
        scale = check_positive("depth_scale", depth_scale)
        words, rows, columns = self._project(width, height, intrinsic, extrinsic, depth_max)
        return hand_out(read_depth(words, scale), self.arrays.library, shape=(rows, columns))

    def project_to_rgbd_image(
        self,
        width: int,
        height: int,
        intrinsic: PinholeCameraIntrinsic,
        extrinsic: ArrayLike | None = None,
        *,
        depth_max: float = OPEN3D_DEPTH_MAX,
    ) -> RGBDImage:
        """Render an RGB-D image of the cloud: depth [m] and 8-bit color of the nearest point in each pixel.

        Arguments as `project_to_depth_image`, without `depth_scale`.

        Raises:
            ValueError: As `project_to_depth_image`, or if the cloud has no colors.
        """
        colors = self.arrays.required("colors", "assign cloud.colors, or use project_to_depth_image")
        words, rows, columns = self._project(width, height, intrinsic, extrinsic, depth_max)
        return RGBDImage.from_device_arrays(
            read_colors(words, colors), read_depth(words), rows, columns, self.arrays.library
        )

    @classmethod
    def from_device_depth(
        cls,
        depth: wp.array,
        color: wp.array | None,
        camera: PinholeCameraIntrinsic,
        extrinsic: ArrayLike | None,
        stride: int,
        valid_only: bool,
        with_normals: bool,
    ) -> Self:
        """`create_from_depth_image` for device arrays: depth [m], float32 (h * w,), and colors (h * w, 3)."""
        step = check_count("stride", stride)
        T_world_camera = np.eye(4) if extrinsic is None else inv(check_rigid("extrinsic", extrinsic))
        origin = origin_of_sensor(T_world_camera[:3, 3])
        local = T_world_camera.copy()
        local[:3, 3] -= origin
        grid = PixelGrid(camera.width, camera.height, step)
        points, valid = unproject_depth(depth, grid, camera, local)
        arrays = {"points": points}
        if with_normals:
            normals, valid = pixel_normals(depth, grid, camera, local[:3, :3])
            arrays["normals"] = normals
        if color is not None:
            arrays["colors"] = color_pixels(color, grid)
        cloud = cls.from_device_arrays(arrays, origin)
        if valid_only:
            return cloud.select_mask(valid)
        cloud.grid = (grid.rows, grid.columns)
        return cloud

    def _project(
        self, width: int, height: int, intrinsic: PinholeCameraIntrinsic, extrinsic: ArrayLike | None, depth_max: float
    ) -> tuple[wp.array, int, int]:
        """(nearest point per pixel as of project_points, rows, columns)."""
        columns, rows = check_pixels("width", width), check_pixels("height", height)
        camera = check_intrinsic(intrinsic, columns, rows)
        farthest = check_positive("depth_max", depth_max, allow_infinite=True)
        T_camera_world = np.eye(4) if extrinsic is None else check_rigid("extrinsic", extrinsic)
        T_camera_points = T_camera_world.copy()
        T_camera_points[:3, 3] += matmul(T_camera_world[:3, :3], self.arrays.origin)
        return project_points(self.arrays["points"], T_camera_points, camera, farthest), rows, columns

    @classmethod
    def from_dlpack(
        cls,
        points: ArrayLike,
        *,
        normals: ArrayLike | None = None,
        colors: ArrayLike | None = None,
        origin: ArrayLike | None = None,
        frozen: bool = False,
        **attributes: Any,
    ) -> Self:
        """Create a cloud from arrays of another library without a copy: torch, cupy, jax, NumPy, Warp.

        Arrays must be contiguous and support DLPack or `__cuda_array_interface__`. In-place changes affect the cloud.
        Make them only while no operation runs. Later operations detect changed points by a sum over the points, for
        which the host waits. With `frozen=True` they do not check. An existing NearestNeighborSearch does not either.

        Args:
            points: float32 (n, 3) [m], relative to the origin.
            normals: float32 (n, 3).
            colors: float32 (n, 3), 0..1, not checked.
            origin: Origin of the coordinates [m], shape (3,). If None: zero. float32 resolves 1 mm up to 10 km.
            frozen: Promise that `points` and `array("points")` are not written as long as this cloud or another cloud
                over the same points exists. If broken, results are wrong without an error.
            **attributes: Other arrays of shape (n,) or (n, c).

        Raises:
            TypeError: If a type is wrong, or an array cannot be shared (a list, a read-only array).
            ValueError: If a shape or length is wrong, or an array is not contiguous.
            DeviceError: If arrays are on different or unavailable devices.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> points = np.zeros((4, 3), np.float32)
            >>> cloud = loom.PointCloud.from_dlpack(points)
            >>> points[0] = 1, 2, 3
            >>> cloud.points[0].tolist()
            [1.0, 2.0, 3.0]
            >>> np.shares_memory(np.from_dlpack(cloud.array("points")), points)
            True
        """
        start = np.zeros(3) if origin is None else check_finite("origin", check_shape("origin", origin, (3,)))
        arrays = {"points": share_vectors("points", points)}
        for name, values in {"normals": normals, "colors": colors}.items():
            if values is not None:
                arrays[name] = share_vectors(name, values)
        for name, values in attributes.items():
            arrays[name] = share_numbers(name, values)
        for name, array in arrays.items():
            check_same_device(name, arrays["points"].device, array.device)
            if array.shape[0] != arrays["points"].size:
                raise ValueError(
                    f"{escaped(name)}: expected {arrays['points'].size} rows, one per point, got {array.shape[0]}"
                )
        cloud = cls.from_device_arrays(arrays, start, library_of(points))
        cloud.arrays.tree = CachedTree(arrays["points"], is_shared=True, frozen=frozen)
        return cloud

    @classmethod
    def from_open3d(cls, cloud: Any, *, device: Any = None, arrays: str | None = None) -> Self:
        """Copy an Open3D cloud, legacy (`open3d.geometry`) or tensor (`open3d.t.geometry`), with all attributes.

        Float64 positions keep their precision through the origin. Covariances become `covariances` of shape (n, 9).
        Other tensors are flattened to two axes. GPU tensors pass through the host; `from_dlpack` shares them.

        Args:
            cloud: The Open3D cloud.
            device: Target device. If None: the tensor cloud's GPU, or the CPU.
            arrays: Library of returned arrays, as of `to`. If None: "numpy".

        Raises:
            TypeError: If `cloud` is not an Open3D cloud.
            DeviceError: If the device does not exist.
        """
        o3d = sys.modules.get("open3d")  # without it, there are no objects of its classes
        if o3d is None or not isinstance(cloud, o3d.geometry.PointCloud | o3d.t.geometry.PointCloud):
            given = f"{type(cloud)}{conversion_of(cloud, expected='cloud')}"
            raise TypeError(f"cloud: expected an open3d.geometry or open3d.t.geometry PointCloud, got {given}")
        make: Any = cls
        return cast(Self, make(cloud, device=device, arrays=library_for(arrays)))

    def to_open3d(self) -> Any:
        """Copy to a legacy `open3d.geometry.PointCloud` in float64: points, normals, colors and covariances.

        Raises:
            ImportError: If Open3D is not installed.

        Warns:
            UserWarning: If there are other attributes, which `to_open3d_tensor` keeps.
        """
        o3d = import_library("open3d")
        cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(self.points.copy()))
        if "normals" in self.arrays:
            cloud.normals = o3d.utility.Vector3dVector(self.normals.astype(np.float64))
        if "colors" in self.arrays:
            cloud.colors = o3d.utility.Vector3dVector(self.colors.astype(np.float64))
        if _COVARIANCES in self and self[_COVARIANCES].shape[1:] == (9,):
            matrices = self[_COVARIANCES].astype(np.float64).reshape(-1, 3, 3)
            cloud.covariances = o3d.utility.Matrix3dVector(matrices)
        left_out = [name for name in self.arrays if name not in ("points", *VECTORS, _COVARIANCES)]
        OtherGeometry("open3d.geometry.PointCloud", self.points, left_out=left_out).warn()
        return cloud

    def to_trimesh(self) -> Any:
        """Copy to a `trimesh.PointCloud`, with colors in 8 bits. The unit and `crs` are in its metadata.

        Raises:
            ImportError: If trimesh is not installed.

        Warns:
            UserWarning: If there are normals or attributes, which it cannot store.
        """
        return to_trimesh(self._other("trimesh.PointCloud"))

    def to_pyvista(self) -> Any:
        """Copy to a `pyvista.PolyData` with all attributes, and colors in 8 bits as "RGB".

        The unit and the coordinate system are in its field data. `loom.PointCloud(data)` is the inverse.

        Raises:
            ImportError: If PyVista is not installed.
        """
        return to_pyvista(self._other("pyvista.PolyData"))

    def to_meshio(self) -> Any:
        """Copy to a `meshio.Mesh` of vertices with all attributes, and colors in 8 bits as "RGB".

        The unit and the coordinate system are in its `info`. `loom.PointCloud(mesh)` is the inverse.

        Raises:
            ImportError: If meshio is not installed.
        """
        return to_meshio(self._other("meshio.Mesh"))

    def _other(self, source: str) -> OtherGeometry:
        """All arrays on the host, with float64 positions if the origin is not zero."""
        own = self.arrays
        return OtherGeometry(
            source,
            self.points.copy() if own.origin.any() else download(own["points"]).copy(),
            self.normals if "normals" in own else None,
            self.colors if "colors" in own else None,
            dict(self.attributes),
            unit=self.unit,
            crs=self.crs,
        )

    def to_open3d_tensor(self) -> Any:
        """Copy to an `open3d.t.geometry.PointCloud` on the CPU with all attributes, those of shape (n,) as (n, 1).

        Positions are float32, or float64 if the origin is not zero.

        Raises:
            ImportError: If Open3D is not installed.
            TypeError: If Open3D does not support an attribute's type (float16).
        """
        o3d = import_library("open3d")
        cloud = o3d.t.geometry.PointCloud()
        positions = self.points if self.arrays.origin.any() else download(self.arrays["points"])
        cloud.point.positions = o3d.core.Tensor(np.ascontiguousarray(positions))
        for name in self.arrays:
            if name == "points":
                continue
            values = self[name]
            if values.dtype == np.float16:
                raise TypeError(f"{escaped(name)}: Open3D has no float16; assign it as float32 first")
            if name == _COVARIANCES and values.shape[1:] == (9,):
                values = values.reshape(-1, 3, 3)
            cloud.point[name] = o3d.core.Tensor(values[:, None] if values.ndim == 1 else values)
        return cloud

    def __getstate__(self) -> dict[str, Any]:
        own = self.arrays
        state = {"origin": own.origin, "grid": self.grid, "device": str(self.device), "library": own.library}
        return {"arrays": pickled(own), "unit": self._unit, "crs": self._crs, **state}

    def __setstate__(self, state: dict[str, Any]) -> None:
        with unpickling("cloud"):
            arrays = unpickled(state["arrays"], device_like("cloud", state["device"]))
            origin = check_finite("origin", check_shape("origin", state["origin"], (3,)))
            count = arrays["points"].size
            for name, values in arrays.items():
                is_right = values.dtype == vec3 if name in VECTORS else values.dtype not in (vec2, vec3, vec3i)
                if not is_right or values.ndim not in (1, 2) or values.shape[0] != count:
                    raise ValueError(f"{escaped(name)}: expected a row for each of {count} points, got {values}")
            cloud = self.from_device_arrays(arrays, origin, check_library("library", state["library"]))
            if (grid := state["grid"]) is not None:
                height, width = (check_count("grid", extent, minimum=0) for extent in grid)
                if height * width != count:
                    raise ValueError(f"grid: expected height x width = {count} points, got {height} x {width}")
                cloud.grid = height, width
            cloud.unit, cloud.crs = state.get("unit"), state.get("crs")  # missing in older pickles
        vars(self).update(vars(cloud))

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        return self.with_arrays({name: clone(array) for name, array in self.arrays.items()}, grid=self.grid)


def cloud_arguments(name: str, given: object) -> OtherGeometry | None:
    """The arrays of a cloud of another library. None for other objects, such as arrays."""
    other = read_or_refuse(name, given, "cloud")
    if other is not None and other.corners is not None:
        raise TypeError(
            f"{name}: expected an array or a cloud, got {other.source} with {other.face_count} faces. "
            "loom.TriangleMesh(x) makes a mesh, its vertices are a cloud: loom.PointCloud(mesh.vertices)"
        )
    if other is not None:
        other.warn()
    return other
