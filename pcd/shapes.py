"""Spheres, cylinders, cones and tori in a cloud."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.checks import check_count, check_positive, check_seed, check_share, shown
from ..core.told_arguments import told_arguments
from ..kernels.segmentation.shape_models import CONE, CYLINDER, SPHERE, TORUS
from ..kernels.segmentation.shape_rows import ascending, usable_in_order
from ..kernels.segmentation.shape_search import ShapeLimits, ShapeSearch
from .planes import MOST_SAMPLES, Planes
from .shape import KINDS, UNKNOWNS, Shape
from .shape_verdicts import shape_of

NORMALS = "call cloud = cloud.estimate_normals()"


class Shapes(Planes):
    """The part of PointCloud that finds round shapes, one of a kind at a time."""

    @told_arguments
    def segment_sphere(
        self,
        distance_threshold: float = 0.01,
        normal_threshold_deg: float = 20.0,
        num_iterations: int = 20_000,
        probability: float = 0.9999,
        *,
        min_radius: float = 0.0,
        max_radius: float | None = None,
        seed: int = 0,
    ) -> tuple[Shape, NDArray[np.int32]]:
        """Find the sphere with the most points on it (RANSAC with normals); the cloud needs normals.

        Args:
            distance_threshold: Distance [m] from the surface below which a point may be an inlier.
            normal_threshold_deg: Largest angle [degrees] between the point's normal and the surface's, whichever way
                the normal faces; 90 looks at distances alone.
            num_iterations: Samples at most.
            probability: Ends the search once a sample of inliers alone was drawn with this probability; 1 draws all.
            min_radius: Smallest radius of a sample's shape [m].
            max_radius: Largest radius of a sample's shape [m]; None for the diagonal of the cloud.
            seed: Of the samples.

        Returns:
            (shape, inliers): the shape of least squared distances with its covariance, and the indices of the points
            within the limits of it, int32, ascending. `shape.reasons` says what speaks against it: points that lie as
            well on a plane, too small a part to determine the radius or the kind, no more points on the surface than
            beside it.

        Raises:
            ValueError: The cloud has no normals, fewer finite points than the shape has unknowns, no sample spans a
                shape, or an argument is out of range.

        Notes:
            Samples are points near each other: of a run of the cloud's order along a curve, as long as the cloud or a
            power of two shorter. They are made in float64, scored in float32 relative to the middle of the cloud, on
            some 2,000 points first and the best on all; the best six are fitted in float64, each to its points again
            while these grow in number. The same bits from run to run. 24 B of memory a point. Schnabel, Wahl and Klein
            2007; the fit is to true distances (Lukacs, Martin and Marshall 1998).

        Example:
            >>> import numpy as np, pointloom as loom
            >>> ball = 0.5 * (d := np.random.default_rng(0).normal(size=(2000, 3))) / np.linalg.norm(d, axis=1)[:, None]
            >>> cloud = loom.PointCloud(np.vstack([ball, np.random.default_rng(1).random((500, 3))])).estimate_normals()
            >>> shape, inliers = cloud.segment_sphere(0.01)
            >>> round(shape.radius, 3), shape.is_sure
            (0.5, True)
        """
        limits = limits_of(distance_threshold, normal_threshold_deg, min_radius, max_radius)
        return self._segment_shape(SPHERE, limits, num_iterations, probability, seed)

    @told_arguments
    def segment_cylinder(
        self,
        distance_threshold: float = 0.01,
        normal_threshold_deg: float = 20.0,
        num_iterations: int = 20_000,
        probability: float = 0.9999,
        *,
        min_radius: float = 0.0,
        max_radius: float | None = None,
        seed: int = 0,
    ) -> tuple[Shape, NDArray[np.int32]]:
        """Find the cylinder with the most points on it (RANSAC with normals); the cloud needs normals.

        Arguments, result and errors are those of `segment_sphere`. The cylinder has no ends; `shape.extent` says how
        far its points reach along the axis.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> turn, height = np.random.default_rng(0).random((2, 3000)) * [[2 * np.pi], [1.0]]
            >>> pipe = np.column_stack([0.2 * np.cos(turn), 0.2 * np.sin(turn), height])
            >>> shape, inliers = loom.PointCloud(pipe).estimate_normals().segment_cylinder(0.005)
            >>> round(shape.radius, 3), round(float(shape.axis[2]), 3)
            (0.2, 1.0)
        """
        limits = limits_of(distance_threshold, normal_threshold_deg, min_radius, max_radius)
        return self._segment_shape(CYLINDER, limits, num_iterations, probability, seed)

    @told_arguments
    def segment_cone(
        self,
        distance_threshold: float = 0.01,
        normal_threshold_deg: float = 20.0,
        num_iterations: int = 20_000,
        probability: float = 0.9999,
        *,
        seed: int = 0,
    ) -> tuple[Shape, NDArray[np.int32]]:
        """Find the cone with the most points on it (RANSAC with normals); the cloud needs normals.

        Arguments, result and errors are those of `segment_sphere`. Half angles lie between 2 and 86 degrees; of the two
        halves of a double cone one is found.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> turn, height = np.random.default_rng(0).random((2, 3000)) * [[2 * np.pi], [1.0]] + [[0], [0.2]]
            >>> hat = np.column_stack([0.5 * height * np.cos(turn), 0.5 * height * np.sin(turn), height])
            >>> shape, inliers = loom.PointCloud(hat).estimate_normals().segment_cone(0.005)
            >>> round(float(np.tan(shape.half_angle)), 3)
            0.5
        """
        limits = limits_of(distance_threshold, normal_threshold_deg, 0.0, None)
        return self._segment_shape(CONE, limits, num_iterations, probability, seed)

    @told_arguments
    def segment_torus(
        self,
        distance_threshold: float = 0.01,
        normal_threshold_deg: float = 20.0,
        num_iterations: int = 20_000,
        probability: float = 0.9999,
        *,
        min_radius: float = 0.0,
        max_radius: float | None = None,
        seed: int = 0,
    ) -> tuple[Shape, NDArray[np.int32]]:
        """Find the torus with the most points on it (RANSAC with normals); the cloud needs normals.

        Arguments, result and errors are those of `segment_sphere`. Its tube is thinner than its ring; `min_radius` is
        of the tube, `max_radius` of the ring.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> u, v = np.random.default_rng(0).random((2, 4000)) * 2 * np.pi
            >>> q = 0.5 + 0.15 * np.cos(v)
            >>> ring = np.column_stack([q * np.cos(u), q * np.sin(u), 0.15 * np.sin(v)])
            >>> shape, inliers = loom.PointCloud(ring).estimate_normals().segment_torus(0.005)
            >>> round(shape.radius, 2), round(shape.minor_radius, 2)
            (0.5, 0.15)
        """
        limits = limits_of(distance_threshold, normal_threshold_deg, min_radius, max_radius)
        return self._segment_shape(TORUS, limits, num_iterations, probability, seed)

    # ------------------------------------------------------------------------------------------ internals

    def _segment_shape(
        self, kind: int, limits: ShapeLimits, num_iterations: Any, probability: Any, seed: Any
    ) -> tuple[Shape, NDArray[np.int32]]:
        most, chance, start = check_samples(num_iterations, probability, seed)
        name = KINDS[kind]
        search, limits = search_of(self, limits)
        unknowns, rows = len(UNKNOWNS[name]), search.rows
        if rows.size <= unknowns:
            have = f"the cloud has {rows.size} finite points with normals"
            raise ValueError(f"a {name} has {unknowns} unknowns, but {have}")
        if search.size <= 0.0:
            raise ValueError(f"points: all {rows.size:,} are equal, which is no {name}")
        found = search.find(kind, limits, most, chance, start)
        if found is None or not found.rows.size:
            raise ValueError(
                f"no {name} found: none of {most:,} samples spans one within the limits; raise distance_threshold or "
                "normal_threshold_deg, or the normals may be poor: estimate_normals with a larger max_nn"
            )
        shape = shape_of(search, found, limits, self._origin)
        return shape, self._handed_out(ascending(found.rows, len(self)))


def limits_of(distance: Any, degrees: Any, smallest: Any, largest: Any) -> ShapeLimits:
    """What makes a point one of a shape, checked; a largest radius of zero stands for none."""
    reach = check_positive("distance_threshold", distance)
    angle = check_positive("normal_threshold_deg", degrees)
    if angle > 90:
        raise ValueError(f"normal_threshold_deg: expected degrees in 0..90, 0 excluded, got {shown(degrees)}")
    least = check_positive("min_radius", smallest, allow_zero=True)
    most = 0.0 if largest is None else check_positive("max_radius", largest)
    if largest is not None and most < least:
        raise ValueError(f"max_radius: expected at least min_radius = {least:g} m, got {shown(largest)}")
    return ShapeLimits(reach, max(0.0, math.cos(math.radians(angle))), least, most)


def search_of(cloud: Shapes, limits: ShapeLimits) -> tuple[ShapeSearch, ShapeLimits]:
    """The search among the points that are finite and have normals; the limits with a largest radius."""
    points, normals = cloud._device_array("points"), cloud._required_array("normals", NORMALS)
    search = ShapeSearch(points, normals, usable_in_order(cloud.search_tree(), points, normals))
    largest = limits.largest or 2 * math.sqrt(3) * search.size
    return search, ShapeLimits(limits.distance, limits.cosine, limits.smallest, largest)


def check_samples(num_iterations: Any, probability: Any, seed: Any) -> tuple[int, float, int]:
    """Samples at most, probability and seed of a search, checked."""
    most = check_count(
        "num_iterations", num_iterations, maximum=MOST_SAMPLES, because="a shape not found by then is none"
    )
    return most, check_share("probability", probability), check_seed(seed)
