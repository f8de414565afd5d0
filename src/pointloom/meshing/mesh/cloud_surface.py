"""Surface reconstruction with normals and quality checks: `create_surface`."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_count, check_fraction, check_name, check_positive, check_progress
from ...core.progress import ReportProgress
from ...core.units import without_warnings
from ...kernels.linear_algebra import matmul
from ...kernels.memory import download
from ...kernels.rays.surface_hausdorff import distances_to
from ...kernels.rays.triangle_tree import TriangleTree
from ...kernels.reconstruction.sample_cells import MAX_DEPTH
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud
from ...pcd.search import NearestNeighborSearch
from .mesh import TriangleMesh
from .mesh_summary import describe_surface
from .metrics import points_about
from .reconstruction import MIN_DEPTH, NormalsWarning, why_flat
from .surface_result import MADE_UP, NEAR_DISTANCE, MadeUp, NormalsUsed, PointsOff, Support, SurfaceResult

Cut = Callable[[float], TriangleMesh]

METHODS = ("poisson", "ball", "alpha")
OCTREE_DEPTH = 8
DENSITY_QUANTILE = 0.01  # as in Open3D's tutorial: surface that Poisson extrapolates
MADE_UP_AT_ALL = 0.001  # fraction of the area: ten samples of 10,000; below, the surface is not trimmed
NORMAL_NEIGHBORS = 30  # for normal estimation, and in the orientation graph

SPACING_NEIGHBORS = 10
MAX_SPACINGS = 3.0  # times the median distance of a point to its 10th neighbor: Poisson closes smaller gaps well. More
# is an outlier and has no larger weight
SURFACE_SAMPLES, POINT_SAMPLES, SUPPORT_SAMPLES = 10_000, 2_000, 2_000
MAX_GAP = 0.6  # times the distance of a point to its 10th neighbor
ADJUGATE_SQUARINGS = 6  # of an adjugate: the 64th power
MIN_COSINE = 0.6  # of the angle between the surface and a tangent plane
ONE_SIDED = 0.7  # distance to the mean of the 10 nearest points along the surface, relative to their mean distance
ROUGH_NEIGHBORS, MIN_ROUGH_POINTS = 100, 2_000  # 5% of these points or less, so that the plane follows the shape
ROUGH_POINTS = 10_000  # as many to twice as many of a larger cloud, so that the planes are wider than the noise
MIN_FLATNESS = 0.08  # thickness of 10 neighbors relative to the distance of the farthest: a thicker group is isolated
# points, if it is also wider than MAX_SPACINGS
NOISE_DEVIATIONS = 3.0
NOISE_MEDIANS = NOISE_DEVIATIONS / 0.6745  # three standard deviations of normal errors, in medians of their magnitudes
PROPOSED_QUANTILES = (0.02, 0.05, 0.1, 0.2, 0.4)  # the first that removes the extrapolated surface is proposed

_OWNERS = {"depth": "poisson", "density_quantile": "poisson", "radii": "ball", "alpha": "alpha"}
_DEFAULTS = {"depth": OCTREE_DEPTH, "density_quantile": None, "radii": None, "alpha": "auto"}


@dataclass(frozen=True)
class _Made:
    """A mesh, with the densities of Poisson reconstruction."""

    mesh: TriangleMesh
    cut: Cut | None = None


def create_surface(
    cloud: PointCloud,
    method: str = "poisson",
    *,
    depth: int | None = None,
    density_quantile: float | None = None,
    radii: ArrayLike | None = None,
    alpha: float | str | None = None,
    new_normals: bool = False,
    progress: ReportProgress | None = None,
) -> SurfaceResult:
    """Reconstruct a surface from a cloud, with normals if missing, and check its reliability, as `pointloom mesh`.

    Missing normals are estimated from 30 neighbors and oriented. Poisson surfaces are trimmed where points are sparse.
    See `TriangleMesh.create_from_point_cloud_poisson`, `..._ball_pivoting` and `..._alpha_shape`. Bitwise reproducible.

    Args:
        cloud: The points. Existing normals are used.
        method: "poisson", "ball" (pivoting) or "alpha" (shape).
        depth: Poisson: octree depth, 2..20, default 8.
        density_quantile: Poisson: fraction of the vertices with the lowest densities to remove, below 1. If None: 0.01
            if parts of the surface are far from all points, else 0.
        radii: Ball pivoting: radii [m]. If None: from the point spacing.
        alpha: Alpha shape: radius [m]. If None or "auto": from the point spacing.
        new_normals: Replace existing normals.
        progress: Called with each stage when it begins: "normals", the method's name, "check".

    Returns:
        A SurfaceResult: the mesh with normals and colors, statistics, `reliable` and `warnings`. The mesh is empty if
        there is no surface. Inconsistent normals are reported in `warnings`.

    Raises:
        TypeError: If `cloud` is not a PointCloud, or an argument is not a number.
        ValueError: If the method is unknown, or a setting is of another method, out of range or rejected.
        MemoryError: If Poisson's tree does not fit.

    Example:
        >>> import pointloom as loom
        >>> points = loom.TriangleMesh.create_sphere().sample_points_uniformly(1000).points
        >>> result = loom.meshing.create_surface(loom.PointCloud(points), depth=4, density_quantile=0)
        >>> result.mesh.is_watertight(), result.normals.origin[:34], result.reliable
        (True, 'made of the 30 nearest points of e', True)
    """
    check_cloud("cloud", cloud)
    settings = _settings_of(
        method, {"depth": depth, "density_quantile": density_quantile, "radii": radii, "alpha": alpha}
    )
    report = check_progress(progress)
    report("normals", 0, 0)
    plain = cloud.to(cloud.device, arrays="numpy").remove_non_finite_points()
    points, normals = _with_normals(plain, method, bool(new_normals))
    report(method, 0, 0)
    flat = why_flat(points) if method == "alpha" else None
    empty = flat is not None or not len(points)
    made = _Made(TriangleMesh(device=cloud.device)) if empty else _make(points, method, settings)
    made.mesh.unit, made.mesh.crs = cloud.unit, cloud.crs
    report("check", 0, 0)
    positions = points.remove_duplicated_points()  # copies would make the spacing 0
    mesh, made_up = _without_made_up(positions, made, method, settings)
    off, support = _find_fit(positions, mesh, method)
    if made.cut is not None:
        made_up = _with_remedy(positions, made.cut, made_up, support, settings["density_quantile"])
    return SurfaceResult(
        mesh=mesh.to(mesh.device, arrays=cloud.array_library),
        method=method,
        settings=settings,
        normals=normals,
        points_in=len(cloud),
        points=len(points),
        not_carried=(*cloud.attributes,),
        summary=describe_surface(mesh),
        made_up=made_up,
        off=off,
        support=support,
        flat=flat,
    )


def _settings_of(method: str, given: dict[str, Any]) -> dict[str, Any]:
    if check_name("method", method) not in METHODS:
        raise ValueError(f"method: expected one of {', '.join(METHODS)}, got {method!r}")
    for name, value in given.items():
        if value is not None and _OWNERS[name] != method:
            raise ValueError(f"{name}: applies to method {_OWNERS[name]!r}, not to {method!r}")
    applicable = {name: value for name, value in given.items() if _OWNERS[name] == method}
    settings = {name: _DEFAULTS[name] if value is None else value for name, value in applicable.items()}
    if method == "poisson":
        because = "cell codes support no deeper trees"
        check_count("depth", settings["depth"], minimum=MIN_DEPTH, maximum=MAX_DEPTH, because=because)
        quantile = settings["density_quantile"]
        if quantile is not None and check_fraction("density_quantile", quantile) == 1:
            raise ValueError("density_quantile: expected a fraction >= 0 and < 1, got 1, which removes all triangles")
    if method == "alpha" and not (isinstance(settings["alpha"], str) and settings["alpha"] == "auto"):
        check_positive("alpha", settings["alpha"], allow_infinite=True)
    return settings


def _with_normals(points: PointCloud, method: str, anew: bool) -> tuple[PointCloud, NormalsUsed]:
    """Cloud with the required normals, their source and disagreement."""
    if method == "alpha":
        return points, NormalsUsed("not needed", given=False, disagreement=None)
    given, origin = bool(points.has_normals) and not anew, "of the input"
    if not given:
        origin = f"made of the {NORMAL_NEIGHBORS} nearest points of each and oriented"
        origin += "" if points.has_normals else ": the input has none"
        points = points.without("normals") if points.has_normals else points
        points = points.estimate_normals(max_nn=NORMAL_NEIGHBORS).orient_normals_consistent_tangent_plane(
            NORMAL_NEIGHBORS
        )
    return points, NormalsUsed(origin, given, points.normal_disagreement())


def _make(points: PointCloud, method: str, settings: dict[str, Any]) -> _Made:
    if method == "ball":
        return _Made(TriangleMesh.create_from_point_cloud_ball_pivoting(points, settings["radii"]))
    if method == "alpha":
        return _Made(TriangleMesh.create_from_point_cloud_alpha_shape(points, settings["alpha"]))
    with without_warnings(NormalsWarning):  # `warnings` of the result reports it
        mesh, densities = TriangleMesh.create_from_point_cloud_poisson(points, depth=settings["depth"])

    def cut(quantile: float) -> TriangleMesh:
        if not len(densities):
            return mesh
        return mesh.remove_vertices_by_mask(densities < np.quantile(densities, quantile)).remove_unreferenced_vertices()

    return _Made(mesh, cut)


def _without_made_up(
    points: PointCloud, made: _Made, method: str, settings: dict[str, Any]
) -> tuple[TriangleMesh, MadeUp]:
    """Mesh trimmed by density, and its fraction far from points; sets a default quantile in `settings`."""
    quantile = settings.get("density_quantile")
    mesh = made.mesh if quantile is None or made.cut is None else made.cut(quantile)
    if method != "poisson" or not mesh.get_surface_area() > 0:
        if method == "poisson":
            settings["density_quantile"] = quantile or 0.0
        return mesh, MadeUp()
    search = NearestNeighborSearch(points)
    probes = points.points[:: max(1, len(points) // POINT_SAMPLES)]
    farthest = search.knn_search(probes, min(SPACING_NEIGHBORS + 1, len(points))).sqdists[:, -1]
    far = MAX_SPACINGS * float(np.sqrt(np.median(farthest)))

    fraction = _made_up_fraction(search, mesh, far)
    if made.cut is not None and quantile is None:
        quantile = settings["density_quantile"] = DENSITY_QUANTILE if fraction > MADE_UP_AT_ALL else 0.0
        if quantile:
            mesh = made.cut(quantile)
            fraction = _made_up_fraction(search, mesh, far)
    return mesh, MadeUp(fraction, far)


def _made_up_fraction(search: NearestNeighborSearch, mesh: TriangleMesh, far: float) -> float:
    samples = mesh.sample_points_uniformly(SURFACE_SAMPLES).points
    return float(np.mean(search.knn_search(samples, 1).sqdists[:, 0] > far * far))


def _with_remedy(points: PointCloud, cut: Cut, made_up: MadeUp, support: Support, quantile: float) -> MadeUp:
    """`made_up` with the smallest larger quantile that makes the surface agree with its points, if any."""
    can_cut = support.largest_stray == "outer" and support.problem("poisson", None, None) is not None
    if made_up.fraction is None or made_up.far is None or (made_up.fraction <= MADE_UP and not can_cut):
        return made_up
    search = NearestNeighborSearch(points)
    for larger in (tried for tried in PROPOSED_QUANTILES if tried > quantile):
        mesh = cut(larger)
        fraction, (_, support) = _made_up_fraction(search, mesh, made_up.far), _find_fit(points, mesh, "poisson")
        if fraction <= MADE_UP and support.problem("poisson", None, None) is None:
            return replace(made_up, better_quantile=larger)
    return made_up


def _find_fit(points: PointCloud, mesh: TriangleMesh, method: str) -> tuple[PointsOff, Support]:
    """Distances of the points from the surface, and its agreement with the points near it."""
    if not mesh.get_surface_area() > 0:
        return PointsOff(), Support()
    host, search = points.points, NearestNeighborSearch(points)
    tree = TriangleTree(mesh.arrays["vertices"], mesh.arrays["triangles"])

    def distances_of(positions: NDArray[np.float64]) -> NDArray[np.float32]:
        cloud = PointCloud(positions, device=points.device)
        return download(distances_to(points_about(cloud.arrays["points"], cloud.origin, mesh.origin), tree))

    probes = host[:: max(1, len(host) // POINT_SAMPLES)]
    distances = distances_of(probes)
    size = math.dist(points.get_min_bound(), points.get_max_bound())
    near, median = NEAR_DISTANCE * size, float(np.median(distances))
    noisy = max(near, NOISE_MEDIANS * median if method == "poisson" else 0.0)
    around = _Neighborhoods.of(search, probes, host)
    samples = mesh.sample_points_uniformly(SUPPORT_SAMPLES, use_triangle_normal=True)
    indices, sqdists, _ = search.knn_search(samples, min(SPACING_NEIGHBORS, len(host)))
    nearest = np.sqrt(sqdists[:, 0])
    offsets = host[indices] - samples.points[:, None]
    offsets -= np.sum(offsets * samples.normals[:, None], axis=2, keepdims=True) * samples.normals[:, None]
    to_mean, lengths = (np.sqrt(np.sum(x * x, axis=-1)) for x in (offsets.mean(axis=1), offsets))
    rows, owners = np.unique(indices[:, 0], return_inverse=True)
    neighbors = search.knn_search(host[rows], min(SPACING_NEIGHBORS + 1, len(host)))
    spacing = np.sqrt(neighbors.sqdists[:, -1])[owners]
    tangents = _normals_of(host[neighbors.indices])[owners]
    heights = np.abs(np.sum((samples.points - host[rows][owners]) * tangents, axis=1))
    is_missed = distances > (np.maximum(near, NOISE_DEVIATIONS * around.thickness) if method == "alpha" else noisy)
    support = Support(
        near=near,
        sparse=float(np.mean(nearest > np.maximum(near, MAX_GAP * spacing))),
        bent=float(np.mean(heights > near)),
        turned=_turned_fraction(samples, tangents),
        missed=around.fraction(is_missed) if method == "alpha" else float(np.mean(is_missed)),
        outer=float(np.mean((nearest > near) & (to_mean > ONE_SIDED * lengths.mean(axis=1)))),
        noise=float(np.median(around.thickness / around.spacing)),
        lost=around.fraction((distances > near) & (distances_of(around.means) > noisy), ~around.is_isolated),
        rough=_rough_fraction(samples, points),
    )
    return PointsOff(median, size, points.unit, float(np.quantile(distances, 0.9, method="higher"))), support


def _turned_fraction(samples: PointCloud, tangents: NDArray[np.float64]) -> float:
    return float(np.mean(np.abs(np.sum(samples.normals * tangents, axis=1)) < MIN_COSINE))


def _rough_fraction(samples: PointCloud, points: PointCloud) -> float:
    """`rough` of `Support`."""
    host = points.points[:: max(1, len(points) // ROUGH_POINTS)]
    if len(host) < MIN_ROUGH_POINTS:
        return 0.0
    search = NearestNeighborSearch(PointCloud(host, device=points.device))
    return _turned_fraction(samples, _normals_of(host[search.knn_search(samples, ROUGH_NEIGHBORS).indices]))


@dataclass(frozen=True)
class _Neighborhoods:
    """Points and their 10 neighbors: means, distances to the farthest, root mean square distances to their planes."""

    means: NDArray[np.float64]
    spacing: NDArray[np.float64]
    thickness: NDArray[np.float64]

    @classmethod
    def of(
        cls, search: NearestNeighborSearch, probes: NDArray[np.float64], host: NDArray[np.float64]
    ) -> _Neighborhoods:
        neighbors = search.knn_search(probes, min(SPACING_NEIGHBORS + 1, len(host)))
        groups = host[neighbors.indices]
        means = groups.mean(axis=1)
        groups = groups - means[:, None]
        heights = np.sum(groups * _normals_of(groups)[:, None], axis=2)
        thickness = np.nan_to_num(np.sqrt(np.mean(heights * heights, axis=1)))  # NaN for points on one line
        return cls(means, np.sqrt(neighbors.sqdists[:, -1]), thickness)

    @property
    def max_spacing(self) -> float:
        return MAX_SPACINGS * float(np.median(self.spacing))

    @property
    def is_isolated(self) -> NDArray[np.bool_]:
        """True for points far from others and not on a plane with them: outliers."""
        return (self.spacing > self.max_spacing) & (self.thickness >= MIN_FLATNESS * self.spacing)

    def fraction(self, chosen: NDArray[np.bool_], valid: NDArray[np.bool_] | bool = True) -> float:
        """Fraction of the points, each with the weight of its squared distance to the 10th neighbor."""
        areas = np.minimum(self.spacing, self.max_spacing) ** 2 * valid
        return float(areas[chosen].sum() / areas.sum()) if areas.any() else 0.0


def _normals_of(groups: NDArray[np.float64]) -> NDArray[np.float64]:
    """Normals of the planes through groups of points, shape (n, k, 3). NaN for points on one line.

    A power of the adjugate of the covariance tends to the product of the smallest axis with itself.
    """
    spread = groups - groups.mean(axis=1, keepdims=True)
    a, b, c = np.moveaxis(np.sum(spread[:, :, :, None] * spread[:, :, None, :], axis=1), 1, 0)
    powers = np.stack([np.cross(b, c), np.cross(c, a), np.cross(a, b)], axis=1)
    with np.errstate(invalid="ignore", divide="ignore"):
        for _ in range(ADJUGATE_SQUARINGS):
            powers /= np.abs(powers).max(axis=(1, 2), keepdims=True)
            powers = matmul(powers, powers)
        longest = np.argmax(np.sum(powers * powers, axis=2), axis=1)
        rows = powers[np.arange(len(powers)), longest]
        return rows / np.sqrt(np.sum(rows * rows, axis=1, keepdims=True))
