"""The control grid of SLAC, which models the camera distortion in the frame of the fragments."""

from __future__ import annotations

from typing import Any

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.depth_range import OPEN3D_DEPTH_MAX
from ...cameras.images import RGBDImage
from ...core.array_libraries import NUMPY, hand_out_host
from ...core.checks import LARGEST_NUMBER, check_finite, check_positive, check_rows
from ...core.devices import DeviceLike, check_same_device, resolve_device
from ...core.exchange import on_host
from ...core.serialized import Serialized
from ...kernels.lang import launch, vec3, vec3d
from ...kernels.memory import download, empty, upload, write
from ...kernels.poses.control_lattice import (
    MAX_CELL,
    ControlLattice,
    anchor_positions_kernel,
    bend_normals,
    bend_points,
    make_lattice,
)
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud

GRID_SIZE = 3 / 8  # [m] as in Open3D and the paper: 8 cells per 3 m fragment


class ControlGrid(Serialized):
    """A sparse regular grid of displaced anchors that deforms the space between them.

    Points move by trilinear interpolation of eight anchors, normals by the inverse transpose of the Jacobian. The grid
    is in the frame of a fragment, that of its camera, and shared by all fragments.

    Args:
        grid_size: Cell edge [m].
        device: "cpu", "cuda:0", "auto".

    Raises:
        TypeError, ValueError: The size is not a positive number.
        DeviceError: No such device.

    Notes:
        About 300 B per anchor. Bitwise reproducible for any order of points. Zhou and Koltun, "Simultaneous
        localization and calibration: self-calibration of consumer depth cameras", CVPR 2014.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> grid = loom.rgbd.ControlGrid(grid_size=1.0)
        >>> cloud = loom.PointCloud([[0.5, 0.5, 0.5]])
        >>> grid.touch(cloud)
        >>> grid.set_positions(1.01 * grid.get_init_positions())
        >>> len(grid), grid.deform(cloud).points.round(3).tolist()
        (8, [[0.505, 0.505, 0.505]])
    """

    def __init__(self, grid_size: float = GRID_SIZE, *, device: DeviceLike = None):
        size = check_positive("grid_size", grid_size, maximum=LARGEST_NUMBER)
        self._origin: NDArray[np.float64] = np.zeros(3)
        where = resolve_device(device)
        self.lattice: ControlLattice = make_lattice(size, empty(0, vec3, where))
        self._library = NUMPY

    def __len__(self) -> int:
        return self.lattice.anchor_count

    def __repr__(self) -> str:
        return f"ControlGrid({len(self):,} anchors, {self.grid_size:g} m apart, {self.device})"

    @property
    def grid_size(self) -> float:
        """Cell edge [m]."""
        return self.lattice.cell_size

    @property
    def device(self) -> Any:
        """The device of the anchors."""
        return self.lattice.shifts.device

    @property
    def array_library(self) -> str:
        """Library of the arrays that operations return: that of the last touched cloud."""
        return self._library

    @property
    def origin(self) -> NDArray[np.float64]:
        """Origin of the grid [m], float64 [3]: that of the first cloud."""
        return self._origin.copy()

    def touch(self, cloud: PointCloud) -> None:
        """Add the anchors around a cloud's points without displacement. Existing ones are unchanged.

        Raises:
            TypeError, ValueError: Not a cloud, or points more than 2^19 cells from the grid origin.
            DeviceError: The cloud is on another device.
        """
        points = self._points_of("cloud", cloud, first=True)
        low, high = (np.asarray(bound) for bound in cloud.arrays.bounds())
        max_offset = max(np.abs(low - self._origin).max(), np.abs(high - self._origin).max()) if len(cloud) else 0.0
        if max_offset >= (MAX_CELL - 2) * self.grid_size:
            raise ValueError(
                f"cloud: expected points within {(MAX_CELL - 2) * self.grid_size:g} m of the grid's origin "
                f"{self._origin.tolist()}, got one {max_offset:g} m away. Take a larger grid_size or remove outliers"
            )
        self.lattice, self._library = make_lattice(self.grid_size, points, self.lattice), cloud.array_library

    def get_init_positions(self) -> NDArray[np.float64]:
        """Initial anchor positions, float64 [anchors, 3] [m]."""
        return hand_out_host(self._positions(np.zeros((len(self), 3))), self._library, self.device)

    def get_curr_positions(self) -> NDArray[np.float64]:
        """Current anchor positions, float64 [anchors, 3] [m]."""
        return hand_out_host(self._positions(download(self.lattice.shifts)), self._library, self.device)

    def set_positions(self, positions: ArrayLike) -> None:
        """Move the anchors.

        Args:
            positions: Shape [anchors, 3] [m], in the order of `get_init_positions`.

        Raises:
            TypeError, ValueError: Not numbers, not finite, or a wrong shape.
        """
        given = check_rows("positions", on_host("positions", positions), 3, rows=len(self), dtype=np.float64)
        write(self.lattice.shifts, check_finite("positions", given) - self._positions(np.zeros((len(self), 3))))

    def deform(self, cloud: PointCloud) -> PointCloud:
        """Deform a cloud in the frame of the fragments, with its normals. Covariances are dropped.

        Points in cells without anchors are unchanged. If some anchors are missing, the others are reweighted.

        Raises:
            TypeError, DeviceError: Not a cloud, or one on another device.
        """
        points = self._points_of("cloud", cloud)
        moved = bend_points(points, self.lattice)
        arrays = {name: values for name, values in cloud.arrays.items() if name != "covariances"}
        arrays["points"] = moved
        if "normals" in arrays:
            arrays["normals"] = bend_normals(points, arrays["normals"], self.lattice)
        bent = PointCloud.from_device_arrays(arrays, self._origin if len(self) else cloud.origin, cloud.array_library)
        bent.grid, bent.unit, bent.crs = cloud.grid, cloud.unit, cloud.crs
        return bent

    def deform_depth(
        self,
        depth: ArrayLike,
        intrinsic: PinholeCameraIntrinsic,
        extrinsic: ArrayLike | None = None,
        depth_scale: float | None = None,
        depth_max: float = OPEN3D_DEPTH_MAX,
    ) -> NDArray[np.float32]:
        """Remove the distortion from a depth image: each pixel's point is deformed and projected again.

        Args:
            depth: Shape [h, w]. Integers of 16 bits and more, or floats.
            intrinsic: The camera, of the image size.
            extrinsic: T_camera_fragment, shape [4, 4]; None: the identity.
            depth_scale: Depth units per meter; None: 1000 for integers and 1 for floats.
            depth_max: Maximum depth [m].

        Returns:
            Depth [m], float32 [h, w]. 0 where empty. The nearest point wins a pixel. Stretched regions may have holes.

        Raises:
            TypeError, ValueError: Wrong shapes or sizes, or an extrinsic that is not rigid.
            DeviceError: The depth is on another GPU.
        """
        farthest = check_positive("depth_max", depth_max, allow_infinite=True)
        cloud = PointCloud.create_from_depth_image(
            depth, intrinsic, extrinsic, depth_scale, farthest, device=self.device
        )
        size = intrinsic.width, intrinsic.height
        return self.deform(cloud).project_to_depth_image(
            *size, intrinsic, extrinsic, depth_scale=1.0, depth_max=depth_max
        )

    def deform_rgbd(
        self,
        image: RGBDImage,
        intrinsic: PinholeCameraIntrinsic,
        extrinsic: ArrayLike | None = None,
        *,
        depth_max: float = OPEN3D_DEPTH_MAX,
    ) -> RGBDImage:
        """Deform an RGB-D image as `deform_depth` does. Colors move with their points."""
        cloud = self.deform(PointCloud.create_from_rgbd_image(image, intrinsic, extrinsic))
        size = intrinsic.width, intrinsic.height
        return cloud.project_to_rgbd_image(*size, intrinsic, extrinsic, depth_max=depth_max)

    def _points_of(self, name: str, cloud: PointCloud, *, first: bool = False) -> wp.array:
        """A cloud's points about the grid origin, which the first cloud defines."""
        check_cloud(name, cloud)
        check_same_device(name, self.device, cloud.device)
        if not len(self):
            if not first:
                return cloud.arrays.about(cloud.origin)
            self._origin = cloud.origin.copy()
        return cloud.arrays.about(self._origin)

    def _positions(self, shifts: NDArray[np.float64]) -> NDArray[np.float64]:
        lattice = self.lattice
        anchors = empty(len(self), vec3d, self.device)
        given = upload(shifts, vec3d, self.device)
        launch(anchor_positions_kernel, len(self), [lattice.anchor_keys, lattice.cell_size, given, anchors])
        return np.asarray(download(anchors), np.float64).reshape(-1, 3) + self._origin
