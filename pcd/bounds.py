"""Bounds, hulls, distances and affine maps of a cloud."""

from __future__ import annotations

from typing import TYPE_CHECKING, Self

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ..core.array_libraries import hand_out_host
from ..core.checks import check_finite, check_positive, check_shape, check_transformation
from ..core.coordinates import FLOAT32_MAX, origin_under
from ..core.devices import check_same_device
from ..core.dropped_results import returns_new
from ..core.units import common_unit
from ..kernels.algebra.transform import transform_covariances, transform_directions, transform_points
from ..kernels.arrays.bounds import bound_points
from ..kernels.arrays.select import gather_rows
from ..kernels.extent.mean_covariance import mahalanobis_distances, mean_and_covariance
from ..kernels.extent.visibility import visible_rows
from ..kernels.lang import float32, int32
from ..kernels.linear_algebra import inv, matmul, pinvh
from ..kernels.memory import download, upload
from ..kernels.search.hilbert_order import HilbertOrder
from ..kernels.search.neighbor_distances import nearest_distances
from .boxes import AxisAlignedBoundingBox, OrientedBoundingBox
from .convex_hull import ConvexHull, VisibleSurface, find_extremes, hull_of_cloud
from .minimal_box import fit_principal_box, fit_smallest_box
from .motion import Movable
from .point_arrays import PointArrays, check_cloud
from .selection import Selection
from .units import unit_under

if TYPE_CHECKING:
    from .cloud import PointCloud

FLAT = 1e-12  # a variance below this share of the largest is rounding of float32 coordinates, not spread


class Bounds(Selection, Movable):
    """The part of PointCloud that bounds, measures and transforms it."""

    def get_min_bound(self) -> NDArray[np.float64]:
        """The lowest coordinates of the finite points [m], shape [3]; zeros for an empty cloud."""
        return self._device_bounds()[0]

    def get_max_bound(self) -> NDArray[np.float64]:
        """The highest coordinates of the finite points [m], shape [3]; zeros for an empty cloud."""
        return self._device_bounds()[1]

    def get_center(self) -> NDArray[np.float64]:
        """The mean of the finite points [m], shape [3]; zeros where there is none."""
        count, mean, _ = mean_and_covariance(self._arrays["points"])
        return mean + self._origin if count else np.zeros(3)

    def get_axis_aligned_bounding_box(self) -> AxisAlignedBoundingBox:
        """The smallest aligned box around the finite points; at zero for an empty cloud."""
        return AxisAlignedBoundingBox(*self._device_bounds())

    def get_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """The box along the principal axes of the convex hull's vertices, that of the largest variance first.

        Points in a plane, on a line or all equal have boxes with extents of zero (Open3D raises errors of Qhull).

        Args:
            robust: Let Qhull joggle its input, as `compute_convex_hull(joggle_inputs=True)`.

        Returns:
            A box that holds every finite point: it is wider than they are by a few roundings of float64.

        Raises:
            ValueError: No point is finite.

        Example:
            >>> import pointloom as loom
            >>> square = loom.PointCloud([[0, 0, 7], [4, 0, 7], [0, 2, 7], [4, 2, 7]])
            >>> square.get_oriented_bounding_box().extent.round(6).tolist()
            [4.0, 2.0, 0.0]
        """
        extremes, _, positions = hull_of_cloud(self._arrays["points"], bool(robust))
        return OrientedBoundingBox(*fit_principal_box(positions, self._origin, extremes))

    def get_minimal_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """The box of least volume around the finite points; where they lie in a plane, that of least area.

        Kernels search the frames in which two faces of the box that meet hold an edge of the convex hull each, which
        the smallest box is among. Points in a plane, on a line or all equal have boxes with extents of zero (Open3D
        raises errors of Qhull).

        Args:
            robust: Let Qhull joggle its input, as `compute_convex_hull(joggle_inputs=True)`.

        Returns:
            A box that holds every finite point: it is wider than they are by a few roundings of float64.

        Raises:
            ValueError: No point is finite.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [3, 4, 0], [-4, 3, 0], [0, 0, 2], [3, 4, 2], [-4, 3, 2]]
            >>> round(loom.PointCloud(corners).get_minimal_oriented_bounding_box().volume(), 6)
            50.0

        Notes:
            Time grows with the square of the hull's edges: seconds on two cores for 3,000 vertices. The same from run
            to run. O'Rourke, "Finding minimal enclosing boxes", IJCIS 1985; Jylanki, "An exact algorithm for finding
            minimum oriented bounding boxes", 2015.
        """
        extremes, _, positions = hull_of_cloud(self._arrays["points"], bool(robust))
        return OrientedBoundingBox(*fit_smallest_box(positions, self._origin, extremes, self.device))

    def _device_bounds(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The lowest and highest corner [m] of the finite points, [3] each; zeros where there is none."""
        low, high, finite = bound_points(self._arrays["points"])
        if not finite:
            return np.zeros(3), np.zeros(3)
        return low.astype(np.float64) + self._origin, high.astype(np.float64) + self._origin

    @returns_new
    def transform(self, transformation: ArrayLike) -> Self:
        """The cloud under a 4x4 affine map, computed in float64; normals are turned, and keep their lengths.

        Covariances C become A C A^T, with A the map's 3x3 part (Open3D's are right for rotations alone). A map that
        changes lengths by more than rounding of a rotation may (1 %) leaves the cloud without a known unit.

        Raises:
            ValueError: Not finite, not invertible, or the last row is not (0, 0, 0, 1).
        """
        return self._mapped("transformation", check_transformation("transformation", transformation))

    def _mapped(self, name: str, T: NDArray[np.float64]) -> Self:
        """The cloud under an affine map; errors call it by the argument that it was made of."""
        A, t = T[:3, :3], T[:3, 3]
        moved = matmul(A, self._origin) + t
        origin = origin_under(name, A, t, *self._device_bounds(), moved)
        cloud = self._under(A, moved - origin, origin)
        cloud._unit = unit_under(self._unit, A)
        return cloud

    def _enlarged(self, factor: float) -> Self:
        reach = np.abs(np.array(self._device_bounds()) - self._origin).max() * factor
        if not reach <= FLOAT32_MAX:
            raise ValueError(f"unit: takes points {reach:.3g} from their origin, farther than float32 holds")
        return self._under(factor * np.eye(3), np.zeros(3), self._origin * factor)

    def _under(self, A: NDArray[np.float64], shift: NDArray[np.float64], origin: NDArray[np.float64]) -> Self:
        """The cloud about another origin, its arrays under a map from the old one to the new one."""
        arrays = dict(self._arrays)
        arrays["points"] = transform_points(arrays["points"], A, shift)
        is_shift = np.array_equal(A, np.eye(3))  # normals and covariances stay what they are
        if self.has_normals and not is_shift:
            arrays["normals"] = transform_directions(arrays["normals"], inv(A).T)
        if (
            not is_shift
            and "covariances" in arrays
            and arrays["covariances"].dtype == float32
            and arrays["covariances"].shape[1:] == (9,)
        ):
            arrays["covariances"] = transform_covariances(arrays["covariances"], A)
        cloud = self._with_arrays(arrays, grid=self.grid)
        cloud._origin = origin
        return cloud

    def compute_convex_hull(self, joggle_inputs: bool = False) -> tuple[ConvexHull, NDArray[np.int64]]:
        """The convex hull of the finite points.

        Kernels rule out the points inside a coarse hull of the farthest ones; Qhull makes the hull of the rest from
        float64 positions relative to the origin. Points that lie in one plane, to the rounding of float32, have a flat
        hull: their polygon, seen from both sides (Open3D raises Qhull's error QH6154).

        Args:
            joggle_inputs: Let Qhull move its input by some 1e-11 of its size instead of merging facets.

        Returns:
            The hull, and the index of the cloud's point at each of its vertices, ascending, int64 [m].

        Raises:
            ValueError: No point is finite, or all lie on one line.

        Notes:
            40 B of memory a point. The same bits from run to run. Barber et al., "The Quickhull algorithm for convex
            hulls", TOMS 1996.
        """
        extremes, indices, positions = hull_of_cloud(self._arrays["points"], bool(joggle_inputs))
        if extremes.dimension < 2:
            place = "are equal" if extremes.dimension == 0 else "lie on one line"
            raise ValueError(
                f"points: all {len(self):,} {place}, which has no convex hull; get_oriented_bounding_box() bounds them"
            )
        vertices = positions[extremes.rows] + self._origin
        hull = ConvexHull(vertices, extremes.triangles, extremes.volume, extremes.area)
        return hull, hand_out_host(indices[extremes.rows], self._library, self.device)

    def hidden_point_removal(
        self, camera_location: ArrayLike, radius: float
    ) -> tuple[VisibleSurface, NDArray[np.int64]]:
        """The points that a camera sees: those not hidden behind the surface that the others stand for.

        Points are mirrored about a sphere around the camera; those that become vertices of the convex hull of all and
        the camera are seen. Kernels mirror in float64 and rule out what lies inside a coarse hull, Qhull does the rest.
        A point at the camera itself is not seen (Open3D's hull is of NaN then). Where all points and the camera lie in
        one plane, what is seen in that plane is found (Open3D raises Qhull's error QH6154).

        Args:
            camera_location: World coordinates [m], shape [3].
            radius: Of the sphere [m], at least the distance of the farthest point. Larger radii see more of the
                points, and more of the hidden ones; a thousand times the cloud's size is a start. Test it from the
                scanner's own place, where nearly all should be seen: fewer, and a larger one is needed.

        Returns:
            The surface of the visible points, and their indices, ascending, int64 [m].

        Raises:
            ValueError: The radius is not positive, or the camera not finite.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> u = np.linspace(0, np.pi, 40)
            >>> ball = [[np.sin(a) * np.cos(2 * b), np.sin(a) * np.sin(2 * b), np.cos(a)] for a in u for b in u]
            >>> cloud = loom.PointCloud(ball)
            >>> _, indices = cloud.hidden_point_removal([0, 0, 5], 100)
            >>> bool(cloud.points[indices, 2].min() > 0)
            True

        Notes:
            40 B of memory a point. The same bits from run to run. Katz, Tal and Basri, "Direct visibility of point
            sets", SIGGRAPH 2007.
        """
        camera = check_finite("camera_location", check_shape("camera_location", camera_location, (3,)))
        points = self._arrays["points"]
        candidates, flipped = visible_rows(points, self._origin - camera, check_positive("radius", radius))
        # Qhull is a fifth faster on points that follow a curve through space
        along = download(HilbertOrder(gather_rows(points, candidates)).order)  # sync
        rows, mirrored = download(candidates).astype(np.int64)[along], download(flipped)[along]  # sync
        extremes = find_extremes(np.concatenate([mirrored, np.zeros((1, 3))]))
        seen = extremes.rows[extremes.rows < len(rows)]  # the camera, last of the rows, is no point of the cloud
        triangles = extremes.triangles[(extremes.triangles < len(seen)).all(axis=1)]
        ascending = np.argsort(rows[seen])
        indices = rows[seen][ascending]
        places = np.empty(len(seen), np.int32)
        places[ascending] = np.arange(len(seen), dtype=np.int32)
        triangles = places[triangles]
        vertices = download(gather_rows(points, upload(indices, int32, self.device))) + self._origin
        surface = VisibleSurface(vertices, np.ascontiguousarray(triangles[:, ::-1]))
        return surface, hand_out_host(indices, self._library, self.device)

    def compute_point_cloud_distance(self, target: PointCloud) -> NDArray[np.float64]:
        """The distance of each point to the nearest point of another cloud.

        Args:
            target: The other cloud, on the same device.

        Returns:
            Distances [m], float64 [n]; infinite where the target has no finite point (Open3D: 0, which reads as a
            perfect match) or all lie farther than 1.8e19 m, 0 below 1e-19 m, NaN for points that are not finite.

        Raises:
            TypeError: The target is no cloud.
            ValueError: Points that `NearestNeighborSearch` refuses for what they span.
            DeviceError: The clouds are on different devices.

        Notes:
            O(n + m) memory, the same bits from run to run.

        Example:
            >>> import pointloom as loom
            >>> loom.PointCloud([[0, 0, 0], [0, 0, 3]]).compute_point_cloud_distance(loom.PointCloud([[0, 4, 0]]))
            array([4., 5.])
        """
        check_cloud("target", target)
        return self._handed_out(measure_to(self, target))

    def compute_nearest_neighbor_distance(self) -> NDArray[np.float64]:
        """The distance of each point to the nearest other point of the cloud.

        Returns:
            Distances [m], float64 [n]; 0 where another point lies at the same place, and, as Open3D has it, where
            there is no other point. NaN for points that are not finite.

        Raises:
            ValueError: Points that `NearestNeighborSearch` refuses for what they span.

        Notes:
            O(n) memory, the same bits from run to run.
        """
        points = self._arrays["points"]
        return self._handed_out(nearest_distances(self.search_tree(), points, others=True, missing=0.0))

    def compute_mean_and_covariance(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The mean [m], shape [3], and the covariance [m^2], shape [3, 3], of the finite points.

        The covariance is divided by their number, as Open3D's is, and taken about the mean, so that coordinates of any
        size do no harm. NaN where no point is finite.
        """
        _, mean, covariance = mean_and_covariance(self._arrays["points"])
        return mean + self._origin, covariance

    def compute_mahalanobis_distance(self) -> NDArray[np.float64]:
        """How far each point lies from the mean, in standard deviations of the cloud in that direction.

        Returns:
            float64 [n]; NaN for points that are not finite. Directions in which the cloud has no extent do not count,
            so a flat cloud has distances within its plane (Open3D gives NaN for all of it).
        """
        points = self._arrays["points"]
        count, mean, covariance = mean_and_covariance(points)
        inverse = pinvh(covariance, FLAT) if count else np.zeros((3, 3))
        return self._handed_out(mahalanobis_distances(points, np.nan_to_num(mean), inverse))


def measure_to(source: PointArrays, target: PointArrays) -> wp.array:
    """The distance of each point of a cloud to the nearest of another, a float64 device array."""
    check_same_device("queries", source.device, target.device)
    common_unit("source, target", (source.unit, target.unit))
    return nearest_distances(target.search_tree(), source._points_about(target.origin))
