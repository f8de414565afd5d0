"""Normals and covariances from neighbors, their orientation, and smoothing of points."""

from __future__ import annotations

import math
from typing import Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.checks import (
    check_count,
    check_direction,
    check_finite,
    check_number,
    check_numeric,
    check_positive,
    check_search,
    check_shape,
)
from ..core.dropped_results import returns_new
from ..kernels.arrays.select import gather_rows
from ..kernels.extent.masks import usable_rows
from ..kernels.memory import download
from ..kernels.search.distinct_points import without_copies
from ..kernels.search.point_tree import PointTree
from ..kernels.surface.covariances import estimate_covariances
from ..kernels.surface.normal_agreement import fraction_of_opposed_normals
from ..kernels.surface.normals import align_normals, estimate_normals, orient_normals
from ..kernels.surface.orientation import flip_vectors, normalize_vectors, orient_consistently
from ..kernels.surface.smoothing import average_by_sides, average_passes, average_passes_fixed, project_to_planes
from .length_checks import warn_of_complete_graph, warn_of_sparse
from .selection import Selection

NORMAL_NEIGHBORS = 30  # default of estimate_normals()
PLANE_POINTS = 3  # that determine a plane
MAX_PASSES = 10_000  # of smoothing


class Normals(Selection):
    """Methods of PointCloud that estimate normals and smooth points."""

    @returns_new
    def estimate_normals(self, *, radius: float | None = None, max_nn: int | None = 30) -> Self:
        """Estimate normals by fitting a plane to the neighbors of each point.

        O(n) memory, bitwise reproducible. Covariances are centered, so large coordinates are safe. Hoppe et al.,
        "Surface reconstruction from unorganized points", SIGGRAPH 1992, section 3.1.

        Args:
            radius: Exclusive search radius [m]. If None: the `max_nn` nearest neighbors.
            max_nn: Maximum neighbors, including the point itself. If None: all within the radius. Copies of a position
                that would fill more than a fifth of a neighborhood count once in it.

        Returns:
            The cloud with unit normals (n, 3); (0, 0, 1) with fewer than 3 distinct neighbors, NaN for non-finite
            points. Existing normals determine the sign. Otherwise it is Open3D's, which is not consistent. Orient with
            `orient_normals_towards_camera_location` (a scan), `orient_normals_to_align_with_direction` (terrain) or
            `orient_normals_consistent_tangent_plane`.

        Raises:
            ValueError: If both limits are None, or a limit is out of range.

        Warns:
            UnitWarning: If most points have fewer than 3 points in the radius.
        """
        search_radius, count = check_search(radius, max_nn)
        tree = self.arrays.tree.tree()
        if radius is not None:
            outcome = "their normals are (0, 0, 1)"
            warn_of_sparse("radius", without_copies(tree), search_radius, PLANE_POINTS, self._unit, outcome)
        normals = estimate_normals(tree, count, search_radius)
        if "normals" in self.arrays:
            align_normals(normals, self.arrays["normals"])
        return self.with_arrays(self.arrays | {"normals": normals}, grid=self.grid)

    @property
    def covariances(self) -> NDArray[np.float32]:
        """Covariances [m^2], float32 (n, 3, 3). Stored as device array "covariances" of shape (n, 9). Assignable.

        Eigenvalues below 1e-7 of the largest are lost in rounding.

        Raises:
            ValueError: If the cloud has none, or assigned ones have another shape.
        """
        rows = self.arrays.required("covariances", "call estimate_covariances()")
        return download(rows).reshape(-1, 3, 3).astype(np.float32)

    @covariances.setter
    def covariances(self, values: ArrayLike) -> None:
        matrices = check_numeric("covariances", values)
        if matrices.shape != (len(self), 3, 3):
            raise ValueError(f"covariances: expected shape [{len(self)}, 3, 3], got {list(matrices.shape)}")
        self._set("covariances", matrices.reshape(-1, 9).astype(np.float32))

    @returns_new
    def estimate_covariances(self, *, radius: float | None = None, max_nn: int | None = 30) -> Self:
        """Compute the covariance of the neighbors of each point.

        Args:
            radius: Exclusive search radius [m]. If None: the `max_nn` nearest neighbors.
            max_nn: Maximum neighbors, including the point itself. If None: all within the radius. Copies of a position
                that would fill more than a fifth of a neighborhood count once in it.

        Returns:
            The cloud with `covariances`, divided by the count as in Open3D; identity with fewer than 3 neighbors, NaN
            for points that are not finite. 36 B per point. Bitwise reproducible.

        Raises:
            ValueError: If both limits are None, or a limit is out of range.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> cloud = loom.PointCloud([[0, 0, 0], [2, 0, 0], [0, 2, 0], [2, 2, 0]]).estimate_covariances()
            >>> cloud.covariances[0].tolist()
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.0]]
        """
        search_radius, count = check_search(radius, max_nn)
        tree = self.arrays.tree.tree()
        if radius is not None:
            outcome = "their covariances are the identity"
            warn_of_sparse("radius", without_copies(tree), search_radius, PLANE_POINTS, self._unit, outcome)
        covariances = estimate_covariances(tree, count, search_radius)
        return self.with_arrays(self.arrays | {"covariances": covariances}, grid=self.grid)

    @returns_new
    def normalize_normals(self) -> Self:
        """Scale normals to unit length. Zero normals stay zero, those with NaN become NaN.

        Raises:
            ValueError: If the cloud has no normals.
        """
        normals = self.arrays.required("normals", "call cloud = cloud.estimate_normals()")
        return self.with_arrays(self.arrays | {"normals": normalize_vectors(normals)}, grid=self.grid)

    @returns_new
    def flip_normals(self) -> Self:
        """Negate all normals.

        Raises:
            ValueError: If the cloud has no normals.
        """
        normals = self.arrays.required("normals", "call cloud = cloud.estimate_normals()")
        return self.with_arrays(self.arrays | {"normals": flip_vectors(normals)}, grid=self.grid)

    @returns_new
    def orient_normals_to_align_with_direction(self, orientation_reference: ArrayLike = (0.0, 0.0, 1.0)) -> Self:
        """Flip normals to the side of a direction. Zero normals become the direction.

        Raises:
            ValueError: If the cloud has no normals, or the direction is zero, not finite or has another shape.
        """
        check_direction("orientation_reference", orientation_reference)
        return self._orient(np.asarray(orientation_reference, np.float64), to_point=False)

    @returns_new
    def orient_normals_towards_camera_location(self, camera_location: ArrayLike = (0.0, 0.0, 0.0)) -> Self:
        """Flip normals toward a camera position [m].

        Raises:
            ValueError: If the cloud has no normals, or the position is not finite or has another shape.
        """
        location = check_finite("camera_location", check_shape("camera_location", camera_location, (3,)))
        return self._orient(location - self.arrays.origin, to_point=True)

    @returns_new
    def orient_normals_consistent_tangent_plane(
        self, k: int, lambda_penalty: float = 0.0, cos_alpha_tol: float = 1.0
    ) -> Self:
        """Orient normals consistently along the surface.

        Signs propagate from the lowest point, which faces down, along the minimum spanning tree of the
        k-nearest-neighbor graph with edge weights `1 - |n . n'|`. Disconnected parts are joined by their shortest
        bridges. About 4 k + 80 B per point. Bitwise reproducible. Hoppe et al. 1992, section 3.3. Piazza, Valentini and
        Varetti, "Mesh reconstruction from point cloud", 2023. Open3D's graph lacks edges of its Delaunay step.

        Args:
            k: Neighbors of a point, including itself. 10 to 30 suit most scans. Warns if it joins all points: then
                opposite sides of a surface exchange signs.
            lambda_penalty: If positive, ignore neighbors whose distance from the tangent plane is an outlier: above the
                upper quartile by 1.5 interquartile ranges. Only its sign matters.
            cos_alpha_tol: If below 1, ignore neighbors whose direction has a larger cosine (thin walls).

        Returns:
            The cloud with flipped normals. Zero, NaN and non-finite ones stay and do not propagate signs.

        Raises:
            ValueError: If the cloud has no normals, k < 1, the penalty is negative, or the cosine is outside 0..1.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> sphere = np.random.default_rng(0).normal(size=(2000, 3))
            >>> sphere /= np.linalg.norm(sphere, axis=1, keepdims=True)
            >>> cloud = loom.PointCloud(sphere).estimate_normals(max_nn=12)
            >>> oriented = cloud.orient_normals_consistent_tangent_plane(12)
            >>> bool(((oriented.normals * sphere).sum(axis=1) > 0).all())
            True
        """
        normals = self.arrays.required("normals", "call cloud = cloud.estimate_normals()")
        neighbors = check_count("k", k)
        penalty = check_positive("lambda_penalty", lambda_penalty, allow_zero=True)
        steepest = check_positive("cos_alpha_tol", cos_alpha_tol, allow_zero=True)
        if steepest > 1:
            raise ValueError(f"cos_alpha_tol: expected a cosine in 0..1, got {cos_alpha_tol!r}")
        points = self.arrays["points"]
        rows = usable_rows(points, normals)
        if not rows.size:
            return self.copy()
        warn_of_complete_graph(neighbors, rows.size)
        tree = self.search_tree() if rows.size == points.size else PointTree(gather_rows(points, rows))
        oriented = orient_consistently(points, normals, rows, tree, neighbors, steepest, penalty > 0)
        return self.with_arrays(self.arrays | {"normals": oriented}, grid=self.grid)

    def normal_disagreement(self, max_nn: int = 10) -> float:
        """Fraction of neighbor pairs whose normals are on opposite sides of the surface.

        Pairs are a point and each of its `max_nn` nearest. They count if their normal lines differ by less than 60
        degrees and their connection is within 45 degrees of the tangent plane, which excludes creases and thin walls.

        Args:
            max_nn: Neighbors of a point, without itself.

        Returns:
            0 if all agree or no pair counts, about 0.5 for random signs. A few percent may be a seam. The same number
            on every device.

        Raises:
            ValueError, TypeError: If the cloud has no normals, or `max_nn` is not an integer >= 1.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> points = np.random.default_rng(0).random((500, 3)) * [1, 1, 0]
            >>> cloud = loom.PointCloud(points, normals=np.where(points[:, :1] < 0.5, [[0, 0, 1]], [[0, 0, -1]]))
            >>> oriented = cloud.orient_normals_consistent_tangent_plane(10)
            >>> 0 < cloud.normal_disagreement() < 0.1, oriented.normal_disagreement()
            (True, 0.0)
        """
        normals = self.arrays.required("normals", "call cloud = cloud.estimate_normals()")
        neighbors = min(check_count("max_nn", max_nn), max(1, len(self)))
        return fraction_of_opposed_normals(self.search_tree(), self.arrays["points"], normals, neighbors)

    def _orient(self, reference: NDArray[np.float64], *, to_point: bool) -> Self:
        normals = self.arrays.required("normals", "call cloud = cloud.estimate_normals()")
        oriented = orient_normals(self.arrays["points"], normals, reference, to_point)
        return self.with_arrays(self.arrays | {"normals": oriented}, grid=self.grid)

    @returns_new
    def smooth_mls(self, *, radius: float | None = 0.05, max_nn: int | None = 30) -> Self:
        """Project each point along the normal onto the plane fitted to its neighbors.

        Neighbors at distance d have weight exp(-d^2 / radius^2), or 1 without a radius. Removes noise, but also edges
        and details finer than the radius (see `smooth_bilateral`). O(n) memory, bitwise reproducible. Alexa et al.,
        "Computing and rendering point set surfaces", TVCG 2003, section 3.1, without the polynomial.

        Args:
            radius: Exclusive search radius [m]. If None: the `max_nn` nearest neighbors.
            max_nn: Maximum neighbors, including the point itself. If None: all within the radius.

        Returns:
            The cloud with moved points, without covariances. Points with fewer than 3 neighbors and those not finite
            stay. Existing normals become those of the planes, on the same side.

        Raises:
            ValueError: If both limits are None, or a limit is out of range.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> rng = np.random.default_rng(0)
            >>> plane = np.column_stack([rng.random((2000, 2)), 0.01 * rng.normal(size=2000)])
            >>> smooth = loom.PointCloud(plane).smooth_mls(radius=0.2, max_nn=100)
            >>> bool(smooth.points[:, 2].std() < 0.25 * plane[:, 2].std())
            True
        """
        search_radius, count = check_search(radius, max_nn)
        normals = self.arrays.get("normals")
        moved, fitted = project_to_planes(self.search_tree(), count, search_radius, normals)
        return self.with_points(moved, None if normals is None else fitted)

    @returns_new
    def smooth_bilateral(
        self, *, radius: float | None = 0.05, max_nn: int | None = 30, sigma_s: float = 0.05, sigma_r: float = 0.05
    ) -> Self:
        """Move each point to the mean of its neighbors, with low weight for those off its tangent plane.

        Weights are exp(-d^2 / (2 sigma_s^2) - h^2 / (2 sigma_r^2)) at distance d and height h over the tangent plane.
        Edges stay if `sigma_r` is near the noise level. Missing normals are estimated from 30 neighbors. O(n) memory,
        bitwise reproducible. Jones et al., "Non-iterative, feature-preserving mesh smoothing", SIGGRAPH 2003.

        Args:
            radius: Exclusive search radius [m]. If None: the `max_nn` nearest neighbors.
            max_nn: Maximum neighbors, including the point itself. If None: all within the radius.
            sigma_s, sigma_r: Standard deviations along and across the surface [m].

        Returns:
            The cloud with moved points and unchanged normals, without covariances. Points without a valid normal or not
            finite stay.

        Raises:
            ValueError: If both limits are None, or a number is out of range.
        """
        search_radius, count = check_search(radius, max_nn)
        spatial, across = check_positive("sigma_s", sigma_s), check_positive("sigma_r", sigma_r)
        tree, normals = self.search_tree(), self.arrays.get("normals")
        if normals is None:
            normals = estimate_normals(tree, NORMAL_NEIGHBORS, math.inf)
        return self.with_points(average_by_sides(tree, normals, count, search_radius, spatial, across))

    @returns_new
    def smooth_laplacian(
        self, iterations: int = 10, lambda_: float = 0.5, knn: int = 20, use_fixed_neighborhoods: bool = False
    ) -> Self:
        """Move each point repeatedly by `lambda_` toward the mean of its `knn` nearest neighbors.

        Shrinks curved and open surfaces. See `smooth_taubin`. Taubin, "A signal processing approach to fair surface
        design", SIGGRAPH 1995, equation 2, with equal weights.

        Args:
            iterations: Number of passes.
            lambda_: Fraction of the displacement applied per pass.
            knn: Neighbors, without the point itself.
            use_fixed_neighborhoods: Keep the neighbors of the first pass: faster, avoids clustering. 4 B per neighbor.

        Returns:
            The cloud with moved points and unchanged normals, without covariances. Points that are not finite stay.
            Bitwise reproducible.

        Raises:
            ValueError: If iterations are outside 0..10,000, knn < 1, or `lambda_` is not finite.
        """
        passes = _check_passes(iterations)
        return self._averaged([check_number("lambda_", lambda_)] * passes, knn, use_fixed_neighborhoods)

    @returns_new
    def smooth_taubin(
        self,
        iterations: int = 10,
        lambda_: float = 0.5,
        mu: float = -0.53,
        knn: int = 20,
        use_fixed_neighborhoods: bool = False,
    ) -> Self:
        """Smooth without shrinking: each iteration is a pass with `lambda_` and one with `mu`.

        Args:
            iterations: Number of pass pairs.
            lambda_: Fraction of the displacement to the mean of the neighbors, > 0.
            mu: Factor of the second pass, below `-lambda_`.
            knn, use_fixed_neighborhoods: As of `smooth_laplacian`.

        Returns:
            As `smooth_laplacian`. Taubin, SIGGRAPH 1995, section 3.

        Raises:
            ValueError: If iterations are outside 0..10,000, knn < 1, or a factor is not finite.
        """
        passes = _check_passes(iterations)
        factors = [check_number("lambda_", lambda_), check_number("mu", mu)]
        return self._averaged(factors * passes, knn, use_fixed_neighborhoods)

    def _averaged(self, factors: list[float], knn: int, fixed: bool) -> Self:
        neighbors = check_count("knn", knn)
        run = average_passes_fixed if fixed else average_passes
        return self.with_points(run(self.search_tree(), factors, neighbors))


def _check_passes(iterations: object) -> int:
    reason = "more iterations leave little but the mean of all points"
    return check_count("iterations", iterations, minimum=0, maximum=MAX_PASSES, because=reason)
