"""Normals and covariances of a cloud: fitted to neighbours; normals turned to a side."""

from __future__ import annotations

from typing import Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.checks import check_count, check_finite, check_numeric, check_positive, check_search, check_shape
from ..core.dropped_results import returns_new
from ..kernels.arrays.select import gather_rows
from ..kernels.extent.masks import usable_rows
from ..kernels.memory import download
from ..kernels.search.point_tree import PointTree
from ..kernels.surface.covariances import estimate_covariances
from ..kernels.surface.normal_agreement import share_of_opposed_normals
from ..kernels.surface.normals import align_normals, estimate_normals, orient_normals
from ..kernels.surface.orientation import flip_vectors, normalize_vectors, orient_consistently
from .length_doubts import warn_of_short
from .point_arrays import PointArrays


class Normals(PointArrays):
    """The part of PointCloud that deals with normals."""

    @returns_new
    def estimate_normals(self, *, radius: float | None = None, max_nn: int | None = 30) -> Self:
        """Fit a plane to the neighbours of each point.

        Args:
            radius: Search radius [m], the boundary excluded; with `max_nn` the nearest `max_nn` within it. None
                searches by count alone.
            max_nn: Neighbours a fit, the point itself included; None takes all within the radius.

        Returns:
            The cloud with unit normals, shape [n, 3]; (0, 0, 1) where fewer than 3 neighbours are found, NaN for
            points that are not finite. Each is on the side of the normal that the point had before; without one on
            Open3D's, where neighbours may lie on two sides of one surface. They are turned with
            `orient_normals_towards_camera_location` (a scan, from where it was taken),
            `orient_normals_to_align_with_direction` (terrain) or `orient_normals_consistent_tangent_plane`.

        Raises:
            ValueError: Neither limit given, or one out of range.

        Warns:
            UnitWarning: The radius finds hardly any point another one: it is in another unit.

        Notes:
            O(n) memory. Same bits from run to run. Hoppe et al. 1992, section 3.1. Covariances are centred, so
            coordinates of any size do no harm (Open3D's legacy form turns 57 % of normals at UTM coordinates), and
            one NaN spoils no other point's normal. Stored covariances are not used; Open3D takes them where there
            are some, whatever search it is asked for.

            The side of fresh normals follows from the covariance by the steps of the eigensolver that Open3D has as
            well: of a LiDAR scan all are Open3D's. Where neighbours are equally far, as in depth images, either takes
            some of them, and where the side hangs by these it may be the other (0.5 % of a depth frame).
        """
        reach, count = check_search(radius, max_nn)
        points = self._arrays["points"]
        tree = self.search_tree()
        warn_of_short("radius", tree, radius, self.unit, "normals are (0, 0, 1)")
        normals = estimate_normals(tree, points, count, reach)
        if self.has_normals:
            align_normals(normals, self._arrays["normals"])
        return self._with_arrays(self._arrays | {"normals": normals}, grid=self.grid)

    @property
    def covariances(self) -> NDArray[np.float32]:
        """Covariances [m^2], float32 [n, 3, 3]; on the device the array "covariances" of shape [n, 9], row by row.

        Assign an array-like of shape [n, 3, 3]. float32 is what the coordinates are held in, and half the memory of
        float64; an eigenvalue below 1e-7 of the largest is lost in the rounding.

        Raises:
            ValueError: The cloud has none, or those assigned have another shape.
        """
        rows = self._required_array("covariances", "call estimate_covariances()")
        return download(rows).reshape(-1, 3, 3).astype(np.float32)

    @covariances.setter
    def covariances(self, values: ArrayLike) -> None:
        matrices = check_numeric("covariances", values)
        if matrices.shape != (len(self), 3, 3):
            raise ValueError(f"covariances: expected shape [{len(self)}, 3, 3], got {list(matrices.shape)}")
        self._set("covariances", matrices.reshape(-1, 9).astype(np.float32))

    @returns_new
    def estimate_covariances(self, *, radius: float | None = None, max_nn: int | None = 30) -> Self:
        """Measure how the neighbours of each point spread about their mean.

        Args:
            radius: Search radius [m], the boundary excluded; with `max_nn` the nearest `max_nn` within it. None
                searches by count alone.
            max_nn: Neighbours, the point itself included; None takes all within the radius.

        Returns:
            The cloud with `covariances`, the mean squares divided by the count as in Open3D; the identity where fewer
            than 3 neighbours are found, NaN for points that are not finite.

        Raises:
            ValueError: Neither limit given, or one out of range.

        Notes:
            36 B a point, and 64 MB of lists meanwhile. Same bits from run to run. Moments are taken about each point
            in float64, so coordinates of any size do no harm; Open3D's E[x x'] - E[x] E[x'] cancels at UTM coordinates.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> cloud = loom.PointCloud([[0, 0, 0], [2, 0, 0], [0, 2, 0], [2, 2, 0]]).estimate_covariances()
            >>> cloud.covariances[0].tolist()
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.0]]
        """
        reach, count = check_search(radius, max_nn)
        points = self._arrays["points"]
        covariances = estimate_covariances(self.search_tree(), points, count, reach)
        return self._with_arrays(self._arrays | {"covariances": covariances}, grid=self.grid)

    @returns_new
    def normalize_normals(self) -> Self:
        """The cloud with each normal at length 1; a zero normal stays zero, one with NaN is NaN.

        Raises:
            ValueError: The cloud has no normals.
        """
        normals = self._required_array("normals", "call cloud = cloud.estimate_normals()")
        return self._with_arrays(self._arrays | {"normals": normalize_vectors(normals)}, grid=self.grid)

    @returns_new
    def flip_normals(self) -> Self:
        """The cloud with each normal on the other side.

        Raises:
            ValueError: The cloud has no normals.
        """
        normals = self._required_array("normals", "call cloud = cloud.estimate_normals()")
        return self._with_arrays(self._arrays | {"normals": flip_vectors(normals)}, grid=self.grid)

    @returns_new
    def orient_normals_to_align_with_direction(self, orientation_reference: ArrayLike = (0.0, 0.0, 1.0)) -> Self:
        """The cloud with each normal on the side of a direction; a zero normal becomes the direction.

        Raises:
            ValueError: The cloud has no normals, or a direction of another shape or not finite.
        """
        shaped = check_shape("orientation_reference", orientation_reference, (3,))
        reference = check_finite("orientation_reference", shaped)
        return self._orient(reference, to_point=False)

    @returns_new
    def orient_normals_towards_camera_location(self, camera_location: ArrayLike = (0.0, 0.0, 0.0)) -> Self:
        """The cloud with each normal on the side of a camera [m].

        Raises:
            ValueError: The cloud has no normals, or a place of another shape or not finite.
        """
        location = check_finite("camera_location", check_shape("camera_location", camera_location, (3,)))
        return self._orient(location - self._origin, to_point=True)

    @returns_new
    def orient_normals_consistent_tangent_plane(
        self, k: int, lambda_penalty: float = 0.0, cos_alpha_tol: float = 1.0
    ) -> Self:
        """The cloud with its normals on one side of the surface, as far as neighbours agree on one.

        Signs spread from the lowest point (least z), whose normal is made to look down, along the least spanning tree
        of the graph that joins each point to its k nearest and weighs an edge by `1 - |n . n'|`. Parts that the graph
        leaves apart are joined by their shortest bridges.

        Args:
            k: Neighbours of a point, itself included; 10 to 30 do for most scans.
            lambda_penalty: Above 0, a neighbour is left out whose distance from the point's tangent plane is an
                outlier among the k: above their upper quartile by 1.5 times the width between the quartiles.
            cos_alpha_tol: Below 1, a neighbour is left out where the way to it makes an angle with the normal whose
                cosine exceeds this: the other side of a thin wall.

        Returns:
            The cloud with the same normals, some turned. Zero normals stay; so do normals with NaN and those of points
            that are not finite, and they pass no sign on.

        Raises:
            ValueError: The cloud has no normals; k < 1, a negative penalty, or a cosine outside 0..1.

        Notes:
            4 k B a point for the graph, about 80 B a point beside it. Same bits from run to run. Hoppe et al. 1992,
            section 3.3; the last two parameters follow Piazza, Valentini and Varetti, "Mesh reconstruction from point
            cloud", 2023.

            Open3D's graph is the Euclidean least spanning tree and those of the k nearest that are no edge of the
            Delaunay tetrahedra, so most of the nearest are missing from it; ours holds them all. Its Delaunay step
            fails on coplanar points and takes most of its time. The size of `lambda_penalty` changes nothing here,
            only whether it is 0: Open3D also weighs its Euclidean tree with it.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> sphere = np.random.default_rng(0).normal(size=(2000, 3))
            >>> sphere /= np.linalg.norm(sphere, axis=1, keepdims=True)
            >>> cloud = loom.PointCloud(sphere).estimate_normals(max_nn=12)
            >>> oriented = cloud.orient_normals_consistent_tangent_plane(12)
            >>> bool(((oriented.normals * sphere).sum(axis=1) > 0).all())
            True
        """
        normals = self._required_array("normals", "call cloud = cloud.estimate_normals()")
        neighbors = check_count("k", k)
        penalty = check_positive("lambda_penalty", lambda_penalty, allow_zero=True)
        steepest = check_positive("cos_alpha_tol", cos_alpha_tol, allow_zero=True)
        if steepest > 1:
            raise ValueError(f"cos_alpha_tol: expected a cosine in 0..1, got {cos_alpha_tol!r}")
        points = self._arrays["points"]
        rows = usable_rows(points, normals)
        if not rows.size:
            return self.copy()
        tree = self.search_tree() if rows.size == points.size else PointTree(gather_rows(points, rows))
        oriented = orient_consistently(points, normals, rows, tree, neighbors, steepest, penalty > 0)
        return self._with_arrays(self._arrays | {"normals": oriented}, grid=self.grid)

    def normal_disagreement(self, k: int = 10) -> float:
        """The share of near neighbours whose normals point to opposite sides of the surface: whether to orient them.

        Pairs are a point and each of its `k` nearest. They count where the lines of their normals lie within 60 degrees
        of each other and the way between them within 45 degrees of the tangent plane, so that creases and the two sides
        of a wall do not; they disagree where the normals make more than a right angle.

        Args:
            k: Neighbours of a point, itself not counted.

        Returns:
            0 where all agree, about a half where signs are random. A few per cent may be a seam between two patches of
            opposite sides, each of which agrees in itself. 0, too, where no pair counts. Zero normals, NaN and points
            that are not finite are in no pair.

        Raises:
            ValueError: The cloud has no normals, or k < 1.
            TypeError: No whole number.

        Notes:
            8 B a point beside the search tree. The same number on every device.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> points = np.random.default_rng(0).random((500, 3)) * [1, 1, 0]
            >>> cloud = loom.PointCloud(points, normals=np.where(points[:, :1] < 0.5, [[0, 0, 1]], [[0, 0, -1]]))
            >>> oriented = cloud.orient_normals_consistent_tangent_plane(10)
            >>> 0 < cloud.normal_disagreement() < 0.1, oriented.normal_disagreement()
            (True, 0.0)
        """
        normals = self._required_array("normals", "call cloud = cloud.estimate_normals()")
        neighbors = min(check_count("k", k), max(1, len(self)))
        return share_of_opposed_normals(self.search_tree(), self._arrays["points"], normals, neighbors)

    # ------------------------------------------------------------------------------------------ internals

    def _orient(self, reference: NDArray[np.float64], *, to_point: bool) -> Self:
        normals = self._required_array("normals", "call cloud = cloud.estimate_normals()")
        oriented = orient_normals(self._arrays["points"], normals, reference, to_point)
        return self._with_arrays(self._arrays | {"normals": oriented}, grid=self.grid)
