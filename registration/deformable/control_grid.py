"""The control grid of SLAC: what a camera's distortion looks like in the frame of the fragments it took."""

from __future__ import annotations

from typing import Any

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.images import RGBDImage
from ...core.checks import LARGEST_NUMBER, check_finite, check_positive, check_rows
from ...core.devices import check_same_device, resolve_device
from ...kernels.lang import launch, vec3, vec3d
from ...kernels.memory import download, empty, upload, write
from ...kernels.poses.control_lattice import (
    FARTHEST,
    ControlLattice,
    bend_normals,
    bend_points,
    make_lattice,
    place_anchors_kernel,
)
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud

GRID_SIZE = 3 / 8  # [m] Open3D's, and the paper's: 8 cells along the 3 m of a fragment


class ControlGrid:
    """Anchors on a regular grid, where there are points, each with a shift: it bends what lies between them.

    A point moves by the trilinear mean of the shifts of the eight anchors about it, a normal by the inverse transpose
    of the Jacobian, so it stays perpendicular to the surface. The grid lives in the frame of a fragment, which is that
    of its camera, and is shared by all fragments: a camera bends all that it sees alike.

    Args:
        grid_size: Edge of a cell [m].
        device: "cpu", "cuda:0", "auto".

    Raises:
        TypeError, ValueError: A size that is no number above 0.
        DeviceError: No such device.

    Notes:
        About 300 B an anchor. The same bits from run to run, whatever the order of the points. Zhou and Koltun,
        "Simultaneous localization and calibration: self-calibration of consumer depth cameras", CVPR 2014.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> grid = loom.reconstruction.ControlGrid(grid_size=1.0)
        >>> cloud = loom.PointCloud([[0.5, 0.5, 0.5]])
        >>> grid.touch(cloud)
        >>> grid.set_positions(1.01 * grid.get_init_positions())
        >>> len(grid), grid.deform(cloud).points.round(3).tolist()
        (8, [[0.505, 0.505, 0.505]])
    """

    def __init__(self, grid_size: float = GRID_SIZE, *, device: Any = None):
        size = check_positive("grid_size", grid_size, maximum=LARGEST_NUMBER)
        self._origin: NDArray[np.float64] = np.zeros(3)
        where = resolve_device(device)
        self._lattice: ControlLattice = make_lattice(size, empty(0, vec3, where))

    def __len__(self) -> int:
        return self._lattice.anchor_count

    def __repr__(self) -> str:
        return f"ControlGrid({len(self):,} anchors, {self.grid_size:g} m apart, {self.device})"

    @property
    def grid_size(self) -> float:
        """Edge of a cell [m]."""
        return self._lattice.cell_size

    @property
    def device(self) -> Any:
        """The device that holds the anchors."""
        return self._lattice.shifts.device

    @property
    def origin(self) -> NDArray[np.float64]:
        """Where the cells are counted from [m], float64 [3]: the origin of the first cloud."""
        return self._origin.copy()

    def touch(self, cloud: PointCloud) -> None:
        """Add the anchors about a cloud's points, unshifted; those that are there keep their shifts.

        Raises:
            TypeError: Not a cloud.
            ValueError: Points farther than 2^19 cells from the origin of the grid.
            DeviceError: The cloud lies on another device.
        """
        points = self._points_of("cloud", cloud, first=True)
        low, high = (np.asarray(bound) for bound in cloud._device_bounds())
        reach = max(np.abs(low - self._origin).max(), np.abs(high - self._origin).max()) if len(cloud) else 0.0
        if reach >= (FARTHEST - 2) * self.grid_size:
            raise ValueError(
                f"cloud: expected points within {(FARTHEST - 2) * self.grid_size:g} m of the grid's origin "
                f"{self._origin.tolist()}, got one {reach:g} m away; take a larger grid_size, or remove stray points"
            )
        self._lattice = make_lattice(self.grid_size, points, self._lattice)

    def get_init_positions(self) -> NDArray[np.float64]:
        """Where the anchors are with nothing shifted, float64 [anchors, 3] [m]."""
        return self._positions(np.zeros((len(self), 3)))

    def get_curr_positions(self) -> NDArray[np.float64]:
        """Where the anchors are now, float64 [anchors, 3] [m]."""
        return self._positions(download(self._lattice.shifts))

    def set_positions(self, positions: ArrayLike) -> None:
        """Move the anchors.

        Args:
            positions: Shape [anchors, 3] [m], in the order of `get_init_positions`.

        Raises:
            TypeError, ValueError: Not numbers, not finite, or of another shape.
        """
        found = check_rows("positions", positions, 3, rows=len(self), dtype=np.float64)
        write(self._lattice.shifts, check_finite("positions", found) - self.get_init_positions())

    def deform(self, cloud: PointCloud) -> PointCloud:
        """A cloud in the frame of the fragments, bent; its normals turn with the surface.

        Points in cells without anchors stay; where some of the eight are missing, the others count as they weigh.
        (Open3D drops such points.) Covariances are left out, as they no longer fit.

        Raises:
            TypeError: Not a cloud.
            DeviceError: The cloud lies on another device.
        """
        points = self._points_of("cloud", cloud)
        moved = bend_points(points, self._lattice)
        arrays = {name: values for name, values in cloud._device_arrays.items() if name != "covariances"}
        arrays["points"] = moved
        if "normals" in arrays:
            arrays["normals"] = bend_normals(points, arrays["normals"], self._lattice)
        bent = PointCloud._from_device_arrays(arrays, self._origin if len(self) else cloud.origin, cloud.array_library)
        bent.grid = cloud.grid
        return bent

    def deform_depth(
        self,
        depth: ArrayLike,
        intrinsic: PinholeCameraIntrinsic,
        extrinsic: ArrayLike | None = None,
        depth_scale: float | None = None,
        depth_max: float = 3.0,
    ) -> NDArray[np.float32]:
        """A depth picture as a camera without the distortion would have taken it: each pixel's point, bent and seen.

        Args:
            depth: Shape [h, w]; integers of 16 bits and more, or floats.
            intrinsic: The camera, of the picture's size.
            extrinsic: T_camera_fragment, shape [4, 4]: where in the fragment the picture was taken; None where the
                fragment began.
            depth_scale: Units of depth a metre; None for 1000 of integers and 1 of floats.
            depth_max: Farthest depth that is taken [m].

        Returns:
            Depth [m], float32 [h, w]; 0 where nothing is seen. The nearest point wins a pixel; where the picture is
            stretched a pixel between two may stay empty.

        Raises:
            TypeError, ValueError: Wrong shapes or sizes, an extrinsic that is no rigid motion.
            DeviceError: The depth lies on another GPU.
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
        depth_max: float = 3.0,
    ) -> RGBDImage:
        """An RGB-D picture, bent as `deform_depth` does; each colour goes with its point."""
        cloud = self.deform(PointCloud.create_from_rgbd_image(image, intrinsic, extrinsic))
        size = intrinsic.width, intrinsic.height
        return cloud.project_to_rgbd_image(*size, intrinsic, extrinsic, depth_max=depth_max)

    # ------------------------------------------------------------------------------------------ internals

    def _points_of(self, name: str, cloud: PointCloud, *, first: bool = False) -> wp.array:
        """A cloud's points about the grid's origin, which the first cloud decides."""
        check_cloud(name, cloud)
        check_same_device(name, self.device, cloud.device)
        if not len(self):
            if not first:
                return cloud._points_about(cloud.origin)
            self._origin = cloud.origin.copy()
        return cloud._points_about(self._origin)

    def _positions(self, shifts: NDArray[np.float64]) -> NDArray[np.float64]:
        """The anchors' places under shifts, from the grid's own frame to the fragments'."""
        lattice = self._lattice
        places = empty(len(self), vec3d, self.device)
        given = upload(shifts, vec3d, self.device)
        launch(place_anchors_kernel, len(self), [lattice.anchor_keys, lattice.cell_size, given, places])
        return np.asarray(download(places), np.float64).reshape(-1, 3) + self._origin
