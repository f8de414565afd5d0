"""Queries of a DistanceField at points, for spheres and for bodies of spheres."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.argument_errors import explain_argument_errors
from ...core.array_libraries import Form, form_of
from ...core.checks import RIGID_TOLERANCE, check_finite, check_numeric, check_rigid, check_rows, is_on_gpu
from ...core.devices import check_same_device
from ...core.exchange import on_host
from ...core.gpu_arrays import take_numbers, take_vectors_in_float64
from ...kernels.array_types import Positions
from ...kernels.arrays.origins import add_origin
from ...kernels.lang import float64, mat44d, vec3d
from ...kernels.linear_algebra import det, matmul
from ...kernels.memory import download, upload
from ...kernels.volumes import distance_queries as queries
from ...kernels.volumes.distance_queries import HALF_DIAGONAL, DistanceGrid
from ...pcd.cloud import PointCloud


@dataclass(frozen=True, eq=False)
class NearestObstacles:
    """Occupied voxels nearest to points; -1 or NaN if unknown.

    Attributes:
        rows: Rows in `occupied_voxels`, int32 (n,).
        positions: Their centers [m], float64 (n, 3).
        distances: Distances to these centers [m], float32 (n,). If unknown `max_distance`, a lower bound minus half a
            voxel diagonal, or NaN outside a dense box.
    """

    rows: NDArray[np.int32]
    positions: NDArray[np.float64]
    distances: NDArray[np.float32]


class BodyCollisions(NamedTuple):
    """Collision state of a body at m poses.

    Attributes:
        collides: True if it may touch an occupied voxel, bool (m,).
        clearance: Lower bound of the clearance of all spheres [m], float64 (m,), up to two voxel diagonals too small
            and limited by `max_distance`; minus infinity outside a dense box.
    """

    collides: NDArray[np.bool_]
    clearance: NDArray[np.float64]


class FieldQueries:
    """Batch queries on the field's device."""

    device: Any
    voxel_size: float
    max_distance: float | None
    _grid: DistanceGrid

    @explain_argument_errors
    def distances(self, points: ArrayLike, *, interpolate: bool = False) -> NDArray[np.float32]:
        """Distances at points.

        Exact between voxel centers. A point's error is up to half a voxel diagonal. 29 B per point.

        Args:
            points: A PointCloud on the field's device, or positions [m], shape (n, 3).
            interpolate: Interpolate between the eight nearest voxel centers if all are known.

        Returns:
            [m], float32 (n,): `max_distance`, a lower bound, if unknown. NaN outside a dense box or not finite.

        Raises:
            TypeError, ValueError: If the points are not numeric or have another shape.
            DeviceError: If the points are on another device.
        """
        positions, form = self._points_and_form("points", points)
        return form.hand_out(queries.find_distances_at(positions, self._grid, interpolate=bool(interpolate)).distances)

    @explain_argument_errors
    def is_known(self, points: ArrayLike) -> NDArray[np.bool_]:
        """True where the distance is known, not only at least `max_distance`; bool (n,).

        Args:
            points: As of `distances`, including errors.
        """
        positions, form = self._points_and_form("points", points)
        known = queries.find_distances_at(positions, self._grid, interpolate=False).known
        return form.hand_out(known, dtype=np.bool_)

    @explain_argument_errors
    def gradients(self, points: ArrayLike) -> NDArray[np.float32]:
        """Gradients of the interpolated distances by central differences over one voxel.

        Args:
            points: As of `distances`, including errors.

        Returns:
            Change along x, y and z, float32 (n, 3), of length about 1, away from obstacles. NaN if unknown.

        Example:
            >>> import pointloom as loom
            >>> field = loom.DistanceField.from_voxels([[0, 0, 0]], 1.0, max_distance=5)
            >>> field.gradients([[3.0, 0.5, 0.5]]).tolist()
            [[1.0, 0.0, 0.0]]
        """
        positions, form = self._points_and_form("points", points)
        return form.hand_out(queries.find_gradients(positions, self._grid))

    @explain_argument_errors
    def nearest_obstacles(self, points: ArrayLike) -> NearestObstacles:
        """Occupied voxels nearest to the voxels of points, ties to the first along x, then y, then z.

        Nearest to the voxel's center. Another one may be nearer to the point itself by up to a voxel diagonal.

        Args:
            points: As of `distances`, including errors.

        Example:
            >>> import pointloom as loom
            >>> field = loom.DistanceField.from_voxels([[0, 0, 0], [6, 0, 0]], 1.0, max_distance=5)
            >>> found = field.nearest_obstacles([[4.5, 0.5, 0.5], [20, 0, 0]])
            >>> found.positions.tolist(), found.distances.tolist()
            ([[6.5, 0.5, 0.5], [nan, nan, nan]], [2.0, 5.0])
        """
        queried, form = self._points_and_form("points", points)
        rows, positions, distances = queries.find_obstacles(queried, self._grid)
        return NearestObstacles(form.hand_out(rows), form.hand_out(positions), form.hand_out(distances))

    @explain_argument_errors
    def collides(self, centers: ArrayLike, radii: ArrayLike) -> NDArray[np.bool_]:
        """Test whether spheres may touch occupied voxels.

        Args:
            centers: As of `distances`.
            radii: [m], one or one per sphere, >= 0.

        Returns:
            bool (n,). False is certain. True means nearer than two voxel diagonals (3.5 `voxel_size`) to the center of
            an occupied voxel, or unknown: outside a dense box, or a center that is not finite.

        Raises:
            TypeError, ValueError, DeviceError: As `distances`. Also if radii are negative or too large.
        """
        positions, form = self._points_and_form("centers", centers)
        sizes = np.atleast_1d(self._radii("radii", radii))
        if sizes.shape not in ((1,), (positions.size,)):
            raise ValueError(f"radii: expected one, or {positions.size}, one per center, got {list(sizes.shape)}")
        hits = queries.find_hits(positions, upload(sizes, float64, self.device), self._grid)
        return form.hand_out(hits, dtype=np.bool_)

    @explain_argument_errors
    def collides_bodies(self, spheres: ArrayLike, poses: ArrayLike) -> BodyCollisions:
        """Test whether a body of spheres may touch occupied voxels at many poses.

        Args:
            spheres: Centers in the body frame and radii [m], rows (x, y, z, radius), shape (k, 4).
            poses: T_world_body, rigid motions, shape (m, 4, 4).

        Returns:
            (collides, clearance), bool (m,) and float64 (m,). No collision is certain, see `collides`. 136 B per pose.

        Raises:
            TypeError, ValueError: If an argument is not numeric, or if a shape is wrong, there is no sphere, a pose is
                not rigid, or radii are invalid as in `collides`.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> field = loom.DistanceField.from_voxels([[0, 0, 0]], 0.1, max_distance=3)
            >>> poses = np.tile(np.eye(4), (2, 1, 1))
            >>> poses[:, 0, 3] = 0.4, 2.05
            >>> found = field.collides_bodies([[0, 0, 0, 0.3], [0.5, 0, 0, 0.3]], poses)
            >>> found.collides.tolist(), found.clearance.round(2).tolist()
            ([True, False], [-0.07, 1.54])
        """
        body = check_finite("spheres", check_rows("spheres", on_host("spheres", spheres), 4, dtype=np.float64))
        if not len(body):
            raise ValueError("spheres: expected at least one row (x, y, z, radius), got none")
        self._radii("spheres", body[:, 3])
        motions = check_poses("poses", poses)
        room = queries.find_body_room(
            upload(body, float64, self.device), upload(motions, mat44d, self.device), self._grid
        )
        clearance, form = np.array(download(room)), form_of(spheres)
        return BodyCollisions(
            form.hand_out_host(~(clearance > 0), self.device), form.hand_out_host(clearance, self.device)
        )

    def _radii(self, name: str, radii: ArrayLike | None) -> NDArray[np.float64]:
        """Validate radii against `max_distance`."""
        if is_on_gpu(radii):
            radii = download(take_numbers(name, radii))
        sizes = check_finite(name, check_numeric(name, radii).astype(np.float64))
        if sizes.size and sizes.min() < 0:
            raise ValueError(f"{name}: expected radii >= 0, got {sizes.min():g}")
        margin = 2 * HALF_DIAGONAL * self.voxel_size
        if self.max_distance is not None and sizes.size and sizes.max() + margin >= self.max_distance:
            raise ValueError(
                f"{name}: a radius of {sizes.max():g} m and a voxel's diagonal of {margin:g} m exceed the "
                f"{self.max_distance:g} m that are known. Build the field with a larger max_distance"
            )
        return sizes

    def _points_and_form(self, name: str, points: ArrayLike) -> tuple[Positions, Form]:
        """Positions in float64 on the field's device, and the form of the result."""
        if isinstance(points, PointCloud):
            check_same_device(name, points.device, self.device)
            positions = add_origin(points.arrays["points"], points.origin)
            return positions, Form(points.array_library, points.device.is_cpu)
        if is_on_gpu(points):
            return take_vectors_in_float64(name, points, self.device), form_of(points)
        rows = check_rows(name, points, 3, dtype=np.float64)
        return upload(rows, vec3d, self.device), form_of(points)


def check_poses(name: str, poses: object) -> NDArray[np.float64]:
    motions = check_numeric(name, poses).astype(np.float64)
    if motions.ndim != 3 or motions.shape[1:] != (4, 4):
        raise ValueError(f"{name}: expected shape [m, 4, 4], got {list(motions.shape)}")
    with np.errstate(over="ignore", invalid="ignore"):
        R = motions[:, :3, :3]
        error = np.abs(matmul(R, R.transpose(0, 2, 1)) - np.eye(3)).max(axis=(1, 2), initial=0.0)
        is_right = (error <= RIGID_TOLERANCE) & (det(R) > 0) & np.isfinite(motions).all(axis=(1, 2))
        is_right &= (motions[:, 3] == (0, 0, 0, 1)).all(axis=1)
    if not is_right.all():
        row = int(np.flatnonzero(~is_right)[0])
        check_rigid(f"{name}[{row}]", motions[row])
    return motions
