"""Clouds to and from depth images, arrays of other libraries, Open3D and pickle."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ..cameras.camera import PinholeCameraIntrinsic, check_pixels
from ..cameras.depth_doubts import warn_of_scale
from ..cameras.images import RGBDImage, check_intrinsic, upload_depth
from ..core.array_libraries import check_library, hand_out, library_of
from ..core.checks import check_count, check_finite, check_positive, check_rigid, check_shape
from ..core.coordinates import origin_of_sensor, split_origin
from ..core.devices import check_same_device, resolve_device
from ..core.exchange import share_numbers, share_vectors
from ..core.gpu_arrays import device_for
from ..core.pickled_arrays import device_like, pickled, unpickled, unpickling
from ..core.told_arguments import told_arguments
from ..kernels.images.depth import PixelGrid, color_pixels, pixel_normals, unproject_depth
from ..kernels.images.depth_projection import project_points, read_colors, read_depth
from ..kernels.lang import vec2, vec3, vec3i
from ..kernels.linear_algebra import inv, matmul
from ..kernels.memory import clone, download, upload
from .kept_tree import KeptTree
from .point_arrays import VECTORS
from .selection import Selection

NOBODY_MEASURES = 1000.0  # [m] and more, by a depth camera
OTHER_UNIT = 30.0  # times the farthest depth kept: a limit cuts off less
_COVARIANCES = "covariances"  # [n, 9] here, [n, 3, 3] in Open3D


class Conversion(Selection):
    """The part of PointCloud that converts it to and from images and other libraries.

    A pickled cloud contains NumPy arrays. It returns to the device of the same name, else to the first GPU if it was on
    one. `copy.copy` shares the arrays as `copy()` does, `copy.deepcopy` copies them on their device.
    """

    @classmethod
    @told_arguments
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
        device: Any = None,
    ) -> Self:
        """The points of a depth image, row by row.

        Args:
            depth: Shape [h, w]; integers of 16 bits and more, or floats.
            intrinsic: The camera, of the image's size.
            extrinsic: T_camera_world, shape [4, 4]; None for the identity.
            depth_scale: Units of depth a metre; None for 1000 of integers and 1 of floats.
            depth_trunc: Farthest depth kept [m] (Open3D drops it itself), also for float depth (Open3D ignores it
                there).
            stride: Takes every stride-th pixel of every stride-th row.
            project_valid_depth_only: False keeps the grid: NaN points where there is no depth, `cloud.grid` set.
            with_normals: Adds unit normals towards the camera, from the differences to the next points of the grid
                to the right and below; see `create_normal_map`. Points without one (beside holes, and the last row
                and column) are dropped, or get NaN where the grid is kept. Open3D's tensor form blurs the depth
                first, across edges too; do that with `filter_depth_bilateral`, which does not, or `pyrdown_depth`.
            device: Where the cloud goes; None for the GPU that the depth lies on, else the CPU.

        Raises:
            ValueError: Wrong shapes, sizes that disagree, an extrinsic that is no rigid motion.
        """
        where = device_for(depth, device)
        metric, scale, height, width = upload_depth(depth, depth_scale, depth_trunc, where, limit="depth_trunc")
        camera = check_intrinsic(intrinsic, width, height)
        times = 1.0 if depth_trunc >= NOBODY_MEASURES else OTHER_UNIT
        warn_of_scale(depth, scale, depth_trunc, times=times)
        cloud = cls._from_device_depth(metric, None, camera, extrinsic, stride, project_valid_depth_only, with_normals)
        cloud._library = library_of(depth)
        return cloud

    create_from_depth_image = create_from_depth_image

    @classmethod
    @told_arguments
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
        """The colored points of an RGB-D image, gray if it has brightness only; see `create_from_depth_image`."""
        if not isinstance(image, RGBDImage):
            raise TypeError(f"image: expected an RGBDImage, got {type(image).__name__}")
        camera = check_intrinsic(intrinsic, image.width, image.height)
        cloud = cls._from_device_depth(
            image.depth_array, image.color_array, camera, extrinsic, stride, project_valid_depth_only, with_normals
        )
        cloud._library = image.array_library
        return cloud

    create_from_rgbd_image = create_from_rgbd_image

    def project_to_depth_image(
        self,
        width: int,
        height: int,
        intrinsic: PinholeCameraIntrinsic,
        extrinsic: ArrayLike | None = None,
        depth_scale: float = 1.0,
        depth_max: float = 3.0,
    ) -> NDArray[np.float32]:
        """What a depth camera would measure of the cloud: the depth of the nearest point in each pixel.

        Args:
            width: Columns of the image [px].
            height: Rows of the image [px].
            intrinsic: The camera, of that size.
            extrinsic: T_camera_world, shape [4, 4]; None for the identity.
            depth_scale: Units of the result a metre; 1000 for millimetres. `create_from_depth_image` with the same one
                gives the points back.
            depth_max: Farthest depth that is seen [m].

        Returns:
            Depth times `depth_scale`, float32 [height, width]; 0 where no point is seen. Rounded to whole numbers
            it is what a 16-bit depth map holds.

        Raises:
            ValueError: Wrong sizes, numbers out of range, an extrinsic that is no rigid motion.

        Notes:
            Open3D's tensor form, whose depth_scale is 1000 by default. A point is seen in the pixel whose centre is
            nearest; there are no surfaces between points. A depth image comes back whole from its own cloud. 8 B of
            memory a pixel; same bits from run to run.

        Example:
            >>> import pointloom as loom
            >>> camera = loom.PinholeCameraIntrinsic(3, 2, 1.0, 1.0, 1.0, 0.0)
            >>> loom.PointCloud([[0, 0, 2], [2, 2, 2], [0, 0, 1]]).project_to_depth_image(3, 2, camera)
            array([[0., 1., 0.],
                   [0., 0., 2.]], dtype=float32)
        """
        scale = check_positive("depth_scale", depth_scale)
        words, rows, columns = self._project(width, height, intrinsic, extrinsic, depth_max)
        return hand_out(read_depth(words, scale), self._library, shape=(rows, columns))

    def project_to_rgbd_image(
        self,
        width: int,
        height: int,
        intrinsic: PinholeCameraIntrinsic,
        extrinsic: ArrayLike | None = None,
        *,
        depth_max: float = 3.0,
    ) -> RGBDImage:
        """What an RGB-D camera would measure of the cloud: depth and 8-bit colour of the nearest point in each pixel.

        Arguments as in `project_to_depth_image`, without a depth_scale (which Open3D's tensor form has): an RGBDImage
        holds metres.

        Raises:
            ValueError: As there, or the cloud has no colours.
        """
        colors = self._required_array("colors", "assign cloud.colors, or use project_to_depth_image")
        words, rows, columns = self._project(width, height, intrinsic, extrinsic, depth_max)
        return RGBDImage._from_device_arrays(
            read_colors(words, colors), read_depth(words), rows, columns, self._library
        )

    @classmethod
    def _from_device_depth(
        cls,
        depth: wp.array,
        color: wp.array | None,
        camera: PinholeCameraIntrinsic,
        extrinsic: ArrayLike | None,
        stride: int,
        valid_only: bool,
        with_normals: bool,
    ) -> Self:
        """`create_from_depth_image` for depth [m] on the device, float32 [h * w], and colors [h * w, 3]."""
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
        cloud = cls._from_device_arrays(arrays, origin)
        if valid_only:
            return cloud._select_mask(valid)
        cloud.grid = (grid.rows, grid.columns)
        return cloud

    def _project(
        self, width: int, height: int, intrinsic: Any, extrinsic: ArrayLike | None, depth_max: float
    ) -> tuple[wp.array, int, int]:
        """What each pixel sees (see project_points), rows and columns."""
        columns, rows = check_pixels("width", width), check_pixels("height", height)
        camera = check_intrinsic(intrinsic, columns, rows)
        farthest = check_positive("depth_max", depth_max, allow_infinite=True)
        T_camera_world = np.eye(4) if extrinsic is None else check_rigid("extrinsic", extrinsic)
        T_camera_points = T_camera_world.copy()
        T_camera_points[:3, 3] += matmul(T_camera_world[:3, :3], self._origin)
        return project_points(self._arrays["points"], T_camera_points, camera, farthest), rows, columns

    @classmethod
    def from_dlpack(
        cls, points: Any, *, normals: Any = None, colors: Any = None, origin: ArrayLike | None = None, **attributes: Any
    ) -> Self:
        """A cloud over the arrays of another library, without a copy: torch, cupy, jax, NumPy, Warp and so on.

        Each array speaks DLPack or `__cuda_array_interface__`, is contiguous, and stays where it is: that is the
        cloud's device. It stays alive as long as the cloud needs it. To change it in place changes the cloud (and what
        operations returned unchanged of it); do so only while no operation runs, on a GPU once your stream is done.
        The next operation notices changed points; a NearestNeighborSearch keeps those of its making.

        Args:
            points: float32 [n, 3] [m], relative to the origin.
            normals: float32 [n, 3].
            colors: float32 [n, 3], 0..1, which is not checked.
            origin: Where the points' coordinates start [m], shape [3]; None for zero. Beyond 10 km of it float32
                resolves less than a millimetre.
            **attributes: Further arrays of shape [n] or [n, c], of any number type.

        Raises:
            TypeError: Another type, or an array that cannot be shared (a list, one that is read-only).
            ValueError: Another shape or length, or not contiguous.
            DeviceError: Arrays on different devices, or on one that is not here.

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
                raise ValueError(f"{name}: expected {arrays['points'].size} rows, one a point, got {array.shape[0]}")
        cloud = cls._from_device_arrays(arrays, start, library_of(points))
        cloud._kept = KeptTree(arrays["points"], lent=True)
        return cloud

    @classmethod
    def from_open3d(cls, cloud: Any, *, device: Any = None) -> Self:
        """A copy of an Open3D cloud, legacy (`open3d.geometry`) or tensor (`open3d.t.geometry`), with all it holds.

        Positions in float64 keep their place through the origin. Covariances become the attribute `covariances`, shape
        [n, 9]; other tensors of more than two axes are flattened likewise. A tensor cloud on a GPU passes through the
        host; to share its float32 tensors as they lie there, give them to `from_dlpack`.

        Args:
            cloud: The Open3D cloud.
            device: Where the copy goes; None for the CPU, or the GPU of a tensor cloud that is on one.

        Raises:
            TypeError: No Open3D cloud.
            ImportError: Open3D is not installed.
            DeviceError: No such device.
        """
        o3d = _import_open3d()
        if isinstance(cloud, o3d.geometry.PointCloud):
            arrays = {name: np.asarray(getattr(cloud, name)) for name in (*VECTORS, _COVARIANCES)}
            present = {name: values for name, values in arrays.items() if len(values) or name == "points"}
        elif isinstance(cloud, o3d.t.geometry.PointCloud):
            present = {name: cloud.point[name].cpu().numpy() for name in cloud.point}
            present = {"points": present.pop("positions", np.empty((0, 3), np.float32)), **present}
            if device is None and cloud.device.get_type() == o3d.core.Device.CUDA:
                device = f"cuda:{cloud.device.get_id()}"
        else:
            raise TypeError(f"cloud: expected an open3d.geometry or open3d.t.geometry PointCloud, got {type(cloud)}")
        local, origin = split_origin(present.pop("points"))
        copied = cls._from_device_arrays({"points": upload(local, vec3, resolve_device(device))}, origin)
        for name, values in present.items():
            if name == "colors" and values.dtype == np.uint16:
                values = values.astype(np.float32) / np.float32(65535)
            copied[name] = values.reshape(len(values), -1) if values.ndim > 2 else values
        return copied

    def to_open3d(self) -> Any:
        """A copy as a legacy `open3d.geometry.PointCloud`, in float64: points, normals, colours and covariances.

        The legacy form holds no other attribute; `to_open3d_tensor` keeps them all.

        Raises:
            ImportError: Open3D is not installed.
        """
        o3d = _import_open3d()
        cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(self.points.copy()))
        if self.has_normals:
            cloud.normals = o3d.utility.Vector3dVector(self.normals.astype(np.float64))
        if self.has_colors:
            cloud.colors = o3d.utility.Vector3dVector(self.colors.astype(np.float64))
        if _COVARIANCES in self and self[_COVARIANCES].shape[1:] == (9,):
            matrices = self[_COVARIANCES].astype(np.float64).reshape(-1, 3, 3)
            cloud.covariances = o3d.utility.Matrix3dVector(matrices)
        return cloud

    def to_open3d_tensor(self) -> Any:
        """A copy as an `open3d.t.geometry.PointCloud` on the CPU, with all attributes, those of shape [n] as [n, 1].

        Positions are float32 as they are held, or float64 where the cloud's origin is not zero.

        Raises:
            ImportError: Open3D is not installed.
            TypeError: An attribute of a type that Open3D does not have (float16).
        """
        o3d = _import_open3d()
        cloud = o3d.t.geometry.PointCloud()
        positions = self.points if self._origin.any() else download(self._arrays["points"])
        cloud.point.positions = o3d.core.Tensor(np.ascontiguousarray(positions))
        for name in self._arrays:
            if name == "points":
                continue
            values = self[name]
            if values.dtype == np.float16:
                raise TypeError(f"{name}: Open3D has no float16; assign it as float32 first")
            if name == _COVARIANCES and values.shape[1:] == (9,):
                values = values.reshape(-1, 3, 3)
            cloud.point[name] = o3d.core.Tensor(values[:, None] if values.ndim == 1 else values)
        return cloud

    # ------------------------------------------------------------------------------------------ pickle and copy

    def __getstate__(self) -> dict[str, Any]:
        """The cloud as NumPy arrays and the name of its device."""
        state = {"origin": self._origin, "grid": self.grid, "device": str(self.device), "library": self._library}
        return {"arrays": pickled(self._arrays), "unit": self._unit, **state}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """The cloud on the device that it was on.

        Raises:
            ValueError: The state is damaged: arrays of wrong types or lengths, or a grid of another number of points.
            DeviceError: It was on a GPU, and here is none.
        """
        with unpickling("cloud"):
            arrays = unpickled(state["arrays"], device_like("cloud", state["device"]))
            origin = check_finite("origin", check_shape("origin", state["origin"], (3,)))
            count = arrays["points"].size
            for name, values in arrays.items():
                is_right = values.dtype == vec3 if name in VECTORS else values.dtype not in (vec2, vec3, vec3i)
                if not is_right or values.ndim not in (1, 2) or values.shape[0] != count:
                    raise ValueError(f"{name}: expected a row for each of {count} points, got {values}")
            cloud = self._from_device_arrays(arrays, origin, check_library("library", state["library"]))
            if (grid := state["grid"]) is not None:
                height, width = (check_count("grid", extent, minimum=0) for extent in grid)
                if height * width != count:
                    raise ValueError(f"grid: expected height x width = {count} points, got {height} x {width}")
                cloud.grid = height, width
            cloud.unit = state.get("unit")  # which older pickles lack
        vars(self).update(vars(cloud))

    def __copy__(self) -> Self:
        return self.copy()

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        return self._with_arrays({name: clone(array) for name, array in self._arrays.items()}, grid=self.grid)


def _import_open3d() -> Any:
    try:
        import open3d
    except ImportError as error:
        raise ImportError("this needs the package open3d: pip install open3d") from error
    return open3d
