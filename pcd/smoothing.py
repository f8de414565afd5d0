"""Clouds without their noise."""

from __future__ import annotations

import math
from typing import Any, Self

from ..core.checks import check_count, check_number, check_positive, check_search
from ..core.dropped_results import returns_new
from ..kernels.surface.normals import estimate_normals
from ..kernels.surface.smoothing import average_by_sides, average_passes, average_passes_fixed, project_to_planes
from .selection import Selection

NORMAL_NEIGHBORS = 30  # a fit where normals are missing, as estimate_normals() takes by itself
MOST_PASSES = 10_000  # of smoothing


class Smoothing(Selection):
    """The part of PointCloud that smooths."""

    @returns_new
    def smooth_mls(self, *, radius: float | None = 0.05, max_nn: int | None = 30) -> Self:
        """Move each point onto the plane through its neighbours, along the plane's normal.

        Neighbours at distance d weigh exp(-d^2 / radius^2), or all the same where no radius is given. Noise across
        the surface goes, and so do edges and details finer than the radius (see `smooth_bilateral`).

        Args:
            radius: Search radius [m], the boundary excluded; None searches by count alone.
            max_nn: Neighbours a plane, the point itself included; None takes all within the radius.

        Returns:
            The cloud with points moved. A point with fewer than 3 neighbours stays, as does one that is not finite.
            Normals, where there were any, become those of the planes, on the sides they were on.

        Raises:
            ValueError: Neither limit given, or one out of range.

        Notes:
            Open3D's smooth_mls, but for normals: it turns all of them anew along a spanning tree. O(n) memory. Same
            bits from run to run. Alexa et al. 2003, "Computing and rendering point set surfaces", with the plane of
            section 3.1 fitted once and no polynomial over it.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> rng = np.random.default_rng(0)
            >>> plane = np.column_stack([rng.random((2000, 2)), 0.01 * rng.normal(size=2000)])
            >>> smooth = loom.PointCloud(plane).smooth_mls(radius=0.2, max_nn=100)
            >>> bool(smooth.points[:, 2].std() < 0.25 * plane[:, 2].std())
            True
        """
        reach, count = check_search(radius, max_nn)
        normals = self._arrays.get("normals")
        moved, fitted = project_to_planes(self.search_tree(), count, reach, normals)
        return self._moved(moved, {} if normals is None else {"normals": fitted})

    @returns_new
    def smooth_bilateral(
        self, *, radius: float | None = 0.05, max_nn: int | None = 30, sigma_s: float = 0.05, sigma_r: float = 0.05
    ) -> Self:
        """Move each point to the mean of its neighbours, those far off its own tangent plane counting little.

        A neighbour weighs exp(-d^2 / (2 sigma_s^2) - h^2 / (2 sigma_r^2)) at distance d and height h over the tangent
        plane. With `sigma_r` at the size of the noise and below that of the details, edges and steps stay.

        Args:
            radius: Search radius [m], the boundary excluded; None searches by count alone.
            max_nn: Neighbours a mean, the point itself included; None takes all within the radius.
            sigma_s: Deviation of the weight along the surface [m].
            sigma_r: Deviation of the weight across the surface [m].

        Returns:
            The cloud with points moved, normals as they were. A point whose normal is zero or NaN stays, as does one
            that is not finite.

        Raises:
            ValueError: Neither limit given, or a number out of range.

        Notes:
            Open3D's smooth_bilateral. Where there are no normals they are fitted to 30 neighbours for this; Open3D
            also adds them to its result. O(n) memory. Same bits from run to run. Jones et al. 2003, "Non-iterative,
            feature-preserving mesh smoothing"; Digne and de Franchis 2017, "The bilateral filter for point clouds",
            move points along the normal alone, this one also along the surface.
        """
        reach, count = check_search(radius, max_nn)
        spatial, across = check_positive("sigma_s", sigma_s), check_positive("sigma_r", sigma_r)
        tree, normals = self.search_tree(), self._arrays.get("normals")
        if normals is None:
            normals = estimate_normals(tree, tree.source, NORMAL_NEIGHBORS, math.inf)
        return self._moved(average_by_sides(tree, normals, count, reach, spatial, across))

    @returns_new
    def smooth_laplacian(
        self, iterations: int = 10, lambda_: float = 0.5, knn: int = 20, use_fixed_neighborhoods: bool = False
    ) -> Self:
        """Move each point `lambda_` of the way to the mean of its `knn` nearest others, again and again.

        Smooths everything and shrinks what is curved or open; see `smooth_taubin`.

        Args:
            iterations: Passes.
            lambda_: Share of the way a pass.
            knn: Neighbours, the point itself not included.
            use_fixed_neighborhoods: Keep the neighbours of the first pass in all of them: faster, and points cannot
                draw together in clusters; 4 B of memory a neighbour.

        Returns:
            The cloud with points moved, normals as they were. Points that are not finite stay.

        Raises:
            ValueError: iterations outside 0..10,000, knn < 1, or `lambda_` not finite.

        Notes:
            Open3D's smooth_laplacian. O(n) memory, or 4 n (knn + 1) B with fixed neighbourhoods. Same bits from run
            to run. Each pass rounds to float32. Taubin 1995, equation 2, with equal weights over nearest neighbours.
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
        """Smooth without shrinking: each iteration is a pass with `lambda_` and one back with `mu`.

        Args:
            iterations: Pairs of passes.
            lambda_: Share of the way to the mean of the neighbours, > 0.
            mu: The same of the second pass; below `-lambda_`, which lets low frequencies through.
            knn: Neighbours, the point itself not included.
            use_fixed_neighborhoods: Keep the neighbours of the first pass; see `smooth_laplacian`.

        Returns:
            The cloud with points moved, normals as they were. Points that are not finite stay.

        Raises:
            ValueError: iterations outside 0..10,000, knn < 1, or a factor that is not finite.

        Notes:
            Open3D's smooth_taubin; costs as `smooth_laplacian` with twice the passes. Taubin 1995, "A signal
            processing approach to fair surface design", section 3.
        """
        passes = _check_passes(iterations)
        factors = [check_number("lambda_", lambda_), check_number("mu", mu)]
        return self._averaged(factors * passes, knn, use_fixed_neighborhoods)

    # ------------------------------------------------------------------------------------------ internals

    def _averaged(self, factors: list[float], knn: int, fixed: bool) -> Self:
        neighbors = check_count("knn", knn)
        run = average_passes_fixed if fixed else average_passes
        return self._moved(run(self.search_tree(), factors, neighbors))

    def _moved(self, points: Any, others: dict[str, Any] | None = None) -> Self:
        return self._with_arrays(self._arrays | {"points": points} | (others or {}))


def _check_passes(iterations: Any) -> int:
    reason = "by then hardly anything is left but the mean of all points; take fewer"
    return check_count("iterations", iterations, minimum=0, maximum=MOST_PASSES, because=reason)
