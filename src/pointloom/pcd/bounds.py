"""Bounds, hulls, distances and affine maps of a cloud."""

from __future__ import annotations

from typing import Self

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ..core.array_libraries import hand_out_host
from ..core.checks import check_finite, check_positive, check_shape, check_transformation
from ..core.coordinate_systems import Reprojection
from ..core.coordinates import FLOAT32_MAX, origin_under
from ..core.devices import check_same_device
from ..core.dropped_results import returns_new
from ..kernels.algebra.transform import transform_covariances, transform_directions, transform_points
from ..kernels.arrays.select import gather_rows
from ..kernels.extent.mean_covariance import mahalanobis_distances, mean_and_covariance
from ..kernels.extent.visibility import direct_positions, visible_rows
from ..kernels.lang import float32, int32, vec3
from ..kernels.linear_algebra import inv, matmul, pinvh
from ..kernels.memory import cast, download, upload
from ..kernels.search.hilbert_order import HilbertOrder
from ..kernels.search.neighbor_distances import nearest_distances
from .boxes import AxisAlignedBoundingBox, OrientedBoundingBox
from .convex_hull import ConvexHull, VisibleSurface, find_outer_facets, hull_of_cloud
from .minimal_box import fit_principal_box, fit_smallest_box
from .motion import Movable
from .point_arrays import COVARIANCES, PointArrays, check_cloud, place_points
from .point_store import sample_about
from .selection import Selection
from .units import common_reference, crs_under, unit_under

MIN_VARIANCE_RATIO = 1e-12  # of the largest variance: below it is float32 rounding


class Bounds(Selection, Movable):
    """Methods of PointCloud for bounds, hulls, distances and affine maps."""

    def get_min_bound(self) -> NDArray[np.float64]:
        """Minimum coordinates of the finite points [m], shape (3,); zeros if there are none."""
        return self.arrays.bounds()[0]

    def get_max_bound(self) -> NDArray[np.float64]:
        """Maximum coordinates of the finite points [m], shape (3,); zeros if there are none."""
        return self.arrays.bounds()[1]

    def get_center(self) -> NDArray[np.float64]:
        """Mean of the finite points [m], shape (3,); zeros if there are none."""
        count, mean, _ = mean_and_covariance(self.arrays["points"])
        return mean + self.arrays.origin if count else np.zeros(3)

    def get_axis_aligned_bounding_box(self) -> AxisAlignedBoundingBox:
        """Smallest axis-aligned box of the finite points. At zero if there are none."""
        return AxisAlignedBoundingBox(*self.arrays.bounds())

    def get_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """Box along the principal axes of the convex hull's vertices, largest variance first.

        Contains every finite point, with a margin of a few float64 roundings. Degenerate clouds give zero extents.

        Args:
            robust: Let Qhull joggle its input, as `compute_convex_hull(joggle_inputs=True)`.

        Raises:
            ValueError: If no point is finite.

        Example:
            >>> import pointloom as loom
            >>> square = loom.PointCloud([[0, 0, 7], [4, 0, 7], [0, 2, 7], [4, 2, 7]])
            >>> square.get_oriented_bounding_box().extent.round(6).tolist()
            [4.0, 2.0, 0.0]
        """
        extremes, _, positions = hull_of_cloud(self.arrays["points"], bool(robust))
        return OrientedBoundingBox(*fit_principal_box(positions, self.arrays.origin, extremes))

    def get_minimal_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """Box of minimal volume of the finite points, or of minimal area if they are coplanar.

        Contains every finite point, with a margin of a few float64 roundings. Degenerate clouds give zero extents.
        Tests all frames in which two adjacent faces each contain a hull edge, so time grows with the square of the
        hull's edges. Bitwise reproducible. O'Rourke, "Finding minimal enclosing boxes", IJCIS 1985. Jylänki, "An exact
        algorithm for finding minimum oriented bounding boxes", 2015.

        Args:
            robust: Let Qhull joggle its input, as `compute_convex_hull(joggle_inputs=True)`.

        Raises:
            ValueError: If no point is finite.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [3, 4, 0], [-4, 3, 0], [0, 0, 2], [3, 4, 2], [-4, 3, 2]]
            >>> round(loom.PointCloud(corners).get_minimal_oriented_bounding_box().volume(), 6)
            50.0
        """
        extremes, _, positions = hull_of_cloud(self.arrays["points"], bool(robust))
        return OrientedBoundingBox(*fit_smallest_box(positions, self.arrays.origin, extremes, self.device))

    @returns_new
    def transform(self, transformation: ArrayLike) -> Self:
        """Apply a 4x4 affine map in float64. Normals are rotated and keep their lengths.

        Covariances C become A C A^T with the 3x3 part A. If lengths change by more than 1%, the unit becomes unknown.

        Raises:
            ValueError: If the matrix is not finite or not invertible, or its last row is not (0, 0, 0, 1).
        """
        return self._mapped("transformation", check_transformation("transformation", transformation))

    def _mapped(self, name: str, T: NDArray[np.float64]) -> Self:
        """Apply an affine map; `name` is the argument reported in errors."""
        A, t = T[:3, :3], T[:3, 3]
        moved = matmul(A, self.arrays.origin) + t
        own, points = self.arrays.origin, self.arrays["points"]
        sample = (lambda: sample_about(points, own)) if own.any() else None
        origin = origin_under(name, A, t, *self.arrays.bounds(), moved, in_degrees=self._in_degrees, sample=sample)
        cloud = self._under(A, moved - origin, origin)
        if self._unit is not None or self._crs is not None:
            cloud.unit, cloud.crs = unit_under(self._unit, A), crs_under(self._crs, A)
        return cloud

    def _enlarged(self, factor: float) -> Self:
        max_coordinate = np.abs(np.array(self.arrays.bounds()) - self.arrays.origin).max() * factor
        if not max_coordinate <= FLOAT32_MAX:
            raise ValueError(
                f"unit: moves points to {max_coordinate:.3g} from their origin, beyond float32. Use a larger unit"
            )
        return self._under(factor * np.eye(3), np.zeros(3), self.arrays.origin * factor)

    def _reprojected(self, way: Reprojection) -> Self:
        if COVARIANCES in self.arrays:
            raise ValueError('cloud: covariances cannot be reprojected. Reproject cloud.without("covariances")')
        positions = self.arrays.positions()
        points, origin, _ = place_points(way.points(positions), None, self.device, in_degrees=way.unit_name == "degree")
        arrays = {**self.arrays, "points": points}
        if "normals" in arrays:
            normals = way.normals(positions, download(arrays["normals"]))
            arrays["normals"] = upload(normals.astype(np.float32), vec3, self.device)
        cloud = self.with_arrays(arrays, grid=self.grid)
        cloud.arrays.origin = origin
        return cloud

    def _under(self, A: NDArray[np.float64], shift: NDArray[np.float64], origin: NDArray[np.float64]) -> Self:
        """Change the origin and map the arrays from the old to the new one."""
        arrays = dict(self.arrays)
        arrays["points"] = transform_points(arrays["points"], A, shift)
        is_shift = len(arrays) == 1 or np.array_equal(A, np.eye(3))  # normals and covariances do not change
        if "normals" in arrays and not is_shift:
            arrays["normals"] = transform_directions(arrays["normals"], inv(A).T)
        if not is_shift and COVARIANCES in arrays and arrays[COVARIANCES].shape[1:] == (9,):
            rows = arrays[COVARIANCES]
            arrays[COVARIANCES] = transform_covariances(rows if rows.dtype == float32 else cast(rows, float32), A)
        cloud = self.with_arrays(arrays, grid=self.grid)
        cloud.arrays.origin = origin
        return cloud

    def compute_convex_hull(self, joggle_inputs: bool = False) -> tuple[ConvexHull, NDArray[np.int64]]:
        """Convex hull of the finite points.

        Kernels discard points inside a coarse hull. The rest are inserted one by one in float64, or passed to Qhull if
        a facet has more than three. Coplanar points (to float32 rounding) give a flat, two-sided polygon. 40 B per
        point. Bitwise reproducible. Barber et al., "The Quickhull algorithm for convex hulls", TOMS 1996.

        Args:
            joggle_inputs: Let Qhull perturb its input by about 1e-11 of its size instead of merging facets.

        Returns:
            (hull, ascending indices of its vertices in the cloud, int64 (m,)).

        Raises:
            ValueError: If no point is finite, or all are collinear.
        """
        extremes, indices, positions = hull_of_cloud(self.arrays["points"], bool(joggle_inputs))
        if extremes.dimension < 2:
            degeneracy = "are equal" if extremes.dimension == 0 else "are collinear"
            raise ValueError(
                f"points: all {len(self):,} {degeneracy}, so they have no convex hull. Use get_oriented_bounding_box()"
            )
        vertices = positions[extremes.rows] + self.arrays.origin
        hull = ConvexHull(vertices, extremes.triangles, extremes.volume, extremes.area)
        return hull, hand_out_host(indices[extremes.rows], self.arrays.library, self.device)

    def hidden_point_removal(
        self, camera_location: ArrayLike, radius: float
    ) -> tuple[VisibleSurface, NDArray[np.int64]]:
        """Find the points visible from a camera by spherical inversion and the convex hull.

        A point at the camera is not visible. Coplanar input is solved in its plane. 40 B per point. Bitwise
        reproducible. Katz, Tal and Basri, "Direct visibility of point sets", SIGGRAPH 2007.

        Args:
            camera_location: World coordinates [m], shape (3,).
            radius: Sphere radius [m], at least the distance of the farthest point. Larger values accept more visible
                and more hidden points. Start with 1,000 times the cloud's size.

        Returns:
            (surface of the visible points, their ascending indices, int64 (m,)).

        Raises:
            ValueError: If the radius is not positive, or the camera is not finite.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> u = np.linspace(0, np.pi, 40)
            >>> ball = [[np.sin(a) * np.cos(2 * b), np.sin(a) * np.sin(2 * b), np.cos(a)] for a in u for b in u]
            >>> cloud = loom.PointCloud(ball)
            >>> _, indices = cloud.hidden_point_removal([0, 0, 5], 100)
            >>> bool(cloud.points[indices, 2].min() > 0)
            True
        """
        camera = check_finite("camera_location", check_shape("camera_location", camera_location, (3,)))
        points = self.arrays["points"]
        candidates, flipped = visible_rows(points, self.arrays.origin - camera, check_positive("radius", radius))
        along = download(HilbertOrder(direct_positions(flipped)).order)  # sync
        rows, mirrored = download(candidates).astype(np.int64)[along], download(flipped)[along]  # sync
        visible, triangles = find_outer_facets(mirrored)
        ascending = np.argsort(rows[visible])
        indices = rows[visible][ascending]
        new_indices = np.empty(len(visible), np.int32)
        new_indices[ascending] = np.arange(len(visible), dtype=np.int32)
        triangles = new_indices[triangles]
        vertices = download(gather_rows(points, upload(indices, int32, self.device))) + self.arrays.origin
        surface = VisibleSurface(vertices, np.ascontiguousarray(triangles[:, ::-1]))
        return surface, hand_out_host(indices, self.arrays.library, self.device)

    def compute_point_cloud_distance(self, target: PointArrays) -> NDArray[np.float64]:
        """Distance of each point to the nearest point of another cloud.

        Args:
            target: The other cloud, on the same device.

        Returns:
            Distances [m], float64 (n,): infinite if the target has no finite point (Open3D: 0) or is beyond 1.8e19 m, 0
            below 1e-19 m, NaN for points that are not finite. O(n + m) memory, bitwise reproducible.

        Raises:
            TypeError, ValueError: If `target` is not a cloud, or if the extent exceeds `NearestNeighborSearch`.
            DeviceError: If the clouds are on different devices.

        Example:
            >>> import pointloom as loom
            >>> loom.PointCloud([[0, 0, 0], [0, 0, 3]]).compute_point_cloud_distance(loom.PointCloud([[0, 4, 0]]))
            array([4., 5.])
        """
        check_cloud("target", target)
        return self.arrays.hand_out(measure_to(self, target))

    def compute_nearest_neighbor_distance(self) -> NDArray[np.float64]:
        """Distance of each point to its nearest other point.

        Returns:
            Distances [m], float64 (n,): 0 for coincident points or without another point, as in Open3D. NaN for points
            that are not finite. O(n) memory, bitwise reproducible.

        Raises:
            ValueError: If the extent exceeds `NearestNeighborSearch`.
        """
        points = self.arrays["points"]
        return self.arrays.hand_out(nearest_distances(self.search_tree(), points, others=True, missing=0.0))

    def compute_mean_and_covariance(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Mean [m], (3,), and centered covariance [m^2], (3, 3), of the finite points, divided by n. NaN if none."""
        _, mean, covariance = mean_and_covariance(self.arrays["points"])
        return mean + self.arrays.origin, covariance

    def compute_mahalanobis_distance(self) -> NDArray[np.float64]:
        """Mahalanobis distance of each point from the mean, float64 (n,). NaN for points that are not finite.

        Directions without extent are ignored (Open3D returns NaN for flat clouds).
        """
        points = self.arrays["points"]
        count, mean, covariance = mean_and_covariance(points)
        inverse = pinvh(covariance, MIN_VARIANCE_RATIO) if count else np.zeros((3, 3))
        return self.arrays.hand_out(mahalanobis_distances(points, np.nan_to_num(mean), inverse))


def measure_to(source: PointArrays, target: PointArrays) -> wp.array:
    """Distance of each point to the nearest point of another cloud, a float64 device array."""
    check_same_device("queries", source.device, target.device)
    common_reference("source, target", (source, target))
    return nearest_distances(target.search_tree(), source.arrays.about(target.origin))
