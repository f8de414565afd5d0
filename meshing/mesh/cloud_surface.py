"""A surface through the points of a cloud, normals, cut and verdict included: `create_surface`."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...core.checks import check_count, check_name, check_positive, check_progress, check_share
from ...core.progress import ReportProgress
from ...core.units import without_warnings
from ...kernels.memory import download
from ...kernels.rays.surface_hausdorff import distances_to
from ...kernels.rays.triangle_tree import TriangleTree
from ...kernels.reconstruction.sample_cells import MAX_DEPTH
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud
from ...pcd.search import NearestNeighborSearch
from .alpha_shape import why_flat
from .mesh import TriangleMesh
from .mesh_metrics import points_about
from .mesh_summary import describe_surface
from .poisson import MIN_DEPTH, NormalsWarning
from .surface_result import MADE_UP, MadeUp, NormalsUsed, PointsOff, SurfaceResult

Cut = Callable[[float], TriangleMesh]

METHODS = ("poisson", "ball", "alpha")
DEPTH = 8
DENSITY_QUANTILE = 0.01  # of Open3D's tutorial: the surface that Poisson makes up where there are no points
MADE_UP_AT_ALL = 0.001  # share of the area: ten samples of 10,000; a surface of which less is made up stays whole
NEIGHBORS = 30  # of a normal that is made, and in the graph that orients them

SPACING_NEIGHBORS = 10
# Times the median distance of a point to its 10th neighbour. Poisson closes smaller gaps well; an alpha shape hides a
# hollow behind one.
FAR = {"poisson": 3.0, "alpha": 1.0}
SURFACE_SAMPLES, POINT_SAMPLES = 10_000, 2_000
QUANTILES = (0.02, 0.05, 0.1, 0.2, 0.4)  # of which the first that mends a surface made up is proposed

_OWNERS = {"depth": "poisson", "density_quantile": "poisson", "radii": "ball", "alpha": "alpha"}
_DEFAULTS = {"depth": DEPTH, "density_quantile": None, "radii": None, "alpha": "auto"}


@dataclass(frozen=True)
class _Made:
    """A mesh, and for Poisson's what cuts it at a quantile of its densities."""

    mesh: TriangleMesh
    cut: Cut | None = None


def create_surface(
    cloud: PointCloud,
    method: str = "poisson",
    *,
    depth: int | None = None,
    density_quantile: float | None = None,
    radii: Any = None,
    alpha: float | str | None = None,
    new_normals: bool = False,
    progress: ReportProgress | None = None,
) -> SurfaceResult:
    """Make a surface through the points of a cloud, with normals where there are none, and say what it is worth.

    What `pointloom mesh` does: points that are not finite are left out; normals that the method needs are made of the
    30 nearest points and oriented; Poisson's surface is cut where points are fewest; the surface is measured. The
    methods alone are `TriangleMesh.create_from_point_cloud_poisson`, `..._ball_pivoting` and `..._alpha_shape`.

    Args:
        cloud: Its normals are used where it has some.
        method: "poisson", "ball" (pivoting) or "alpha" (shape).
        depth: Poisson: of the octree, 2..20; None takes 8.
        density_quantile: Poisson: this share of the vertices goes, those with the fewest points about them, 0 and up
            but below 1; None takes 0.01 where any of the surface lies far from all points, else nothing goes.
        radii: Ball pivoting: of the balls [m]; None takes them from the points' spacing.
        alpha: Alpha shape: the radius of its balls [m]; None or "auto" takes it from the points' spacing.
        new_normals: Make normals anew though the cloud has some.
        progress: Called with each stage when it begins: "normals", the method's name, "check".

    Returns:
        A SurfaceResult: the mesh, figures, `reliable` and `warnings`. The mesh has no
        triangles where the points give none. Of the points' attributes it has normals and colours.

    Raises:
        TypeError: Not a PointCloud, or no numbers.
        ValueError: An unknown method, a setting of another method or out of range, or what the method refuses.
        MemoryError: Poisson's tree would not fit.

    Notes:
        Same bits from run to run. Normals that disagree are reported in `warnings`, without a NormalsWarning. Beside
        the method's memory 60 B a triangle, and some 20,000 samples on the surface.

    Example:
        >>> import pointloom as loom
        >>> points = loom.TriangleMesh.create_sphere().sample_points_uniformly(1000).points
        >>> result = loom.create_surface(loom.PointCloud(points), depth=4, density_quantile=0)
        >>> result.mesh.is_watertight(), result.normals.origin[:34], result.reliable
        (True, 'made of the 30 nearest points of e', True)
    """
    check_cloud("cloud", cloud)
    settings = _settings_of(
        method, {"depth": depth, "density_quantile": density_quantile, "radii": radii, "alpha": alpha}
    )
    say = check_progress(progress)
    say("normals", 0, 0)
    plain = cloud.to(cloud.device, arrays="numpy").remove_non_finite_points()
    points, normals = _with_normals(plain, method, bool(new_normals))
    say(method, 0, 0)
    flat = why_flat(points) if method == "alpha" else None
    empty = flat is not None or not len(points)
    made = _Made(TriangleMesh(device=cloud.device)) if empty else _make(points, method, settings)
    made.mesh.unit = cloud.unit
    say("check", 0, 0)
    mesh, made_up = _without_made_up(points, made, method, settings)
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
        off=_find_off(points, mesh),
        flat=flat,
    )


# ------------------------------------------------------------------------------------------------ internals


def _settings_of(method: Any, given: dict[str, Any]) -> dict[str, Any]:
    """The method's own settings, checked, with their defaults.

    Raises:
        TypeError, ValueError: No such method, a setting of another one, or one out of range.
    """
    if check_name("method", method) not in METHODS:
        raise ValueError(f"method: expected one of {', '.join(METHODS)}, got {method!r}")
    for name, value in given.items():
        if value is not None and _OWNERS[name] != method:
            raise ValueError(f"{name}: goes with method {_OWNERS[name]!r}, not with {method!r}")
    own = {name: value for name, value in given.items() if _OWNERS[name] == method}
    settings = {name: _DEFAULTS[name] if value is None else value for name, value in own.items()}
    if method == "poisson":
        because = "codes of cells end there"
        check_count("depth", settings["depth"], minimum=MIN_DEPTH, maximum=MAX_DEPTH, because=because)
        quantile = settings["density_quantile"]
        if quantile is not None and check_share("density_quantile", quantile) == 1:
            raise ValueError("density_quantile: expected a share from 0 and below 1, got 1, which leaves nothing")
    if method == "alpha" and not (isinstance(settings["alpha"], str) and settings["alpha"] == "auto"):
        check_positive("alpha", settings["alpha"], allow_infinite=True)
    return settings


def _with_normals(points: PointCloud, method: str, anew: bool) -> tuple[PointCloud, NormalsUsed]:
    """The cloud with the normals that the method needs, where they come from, and how far they disagree."""
    if method == "alpha":
        return points, NormalsUsed("not needed", given=False, disagreement=None)
    given, origin = bool(points.has_normals) and not anew, "of the input"
    if not given:
        origin = f"made of the {NEIGHBORS} nearest points of each and oriented"
        origin += "" if points.has_normals else ": the input has none"
        points = points.without("normals") if points.has_normals else points
        points = points.estimate_normals(max_nn=NEIGHBORS).orient_normals_consistent_tangent_plane(NEIGHBORS)
    return points, NormalsUsed(origin, given, points.normal_disagreement())


def _make(points: PointCloud, method: str, settings: dict[str, Any]) -> _Made:
    if method == "ball":
        return _Made(TriangleMesh.create_from_point_cloud_ball_pivoting(points, settings["radii"]))
    if method == "alpha":
        return _Made(TriangleMesh.create_from_point_cloud_alpha_shape(points, settings["alpha"]))
    with without_warnings(NormalsWarning):  # the verdict says so
        mesh, densities = TriangleMesh.create_from_point_cloud_poisson(points, depth=settings["depth"])

    def cut(quantile: float) -> TriangleMesh:
        if not len(densities):
            return mesh
        return mesh.remove_vertices_by_mask(densities < np.quantile(densities, quantile)).remove_unreferenced_vertices()

    return _Made(mesh, cut)


def _without_made_up(
    points: PointCloud, made: _Made, method: str, settings: dict[str, Any]
) -> tuple[TriangleMesh, MadeUp]:
    """The mesh as its density is cut, and how much of it lies far from all points.

    Where nobody gave a quantile, `settings` has the one that was taken.
    """
    quantile = settings.get("density_quantile")
    mesh = made.mesh if quantile is None or made.cut is None else made.cut(quantile)
    if method not in FAR or not mesh.get_surface_area() > 0:
        if method == "poisson":
            settings["density_quantile"] = quantile or 0.0
        return mesh, MadeUp()
    search = NearestNeighborSearch(points)
    probes = points.points[:: max(1, len(points) // POINT_SAMPLES)]
    farthest = search.knn_search(probes, min(SPACING_NEIGHBORS + 1, len(points))).sqdists[:, -1]
    far = FAR[method] * float(np.sqrt(np.median(farthest)))

    def share_of(surface: TriangleMesh) -> float:
        samples = surface.sample_points_uniformly(SURFACE_SAMPLES).points
        return float(np.mean(search.knn_search(samples, 1).sqdists[:, 0] > far * far))

    share = share_of(mesh)
    if made.cut is None:
        return mesh, MadeUp(share, far)
    if quantile is None:
        quantile = settings["density_quantile"] = DENSITY_QUANTILE if share > MADE_UP_AT_ALL else 0.0
        if quantile:
            mesh = made.cut(quantile)
            share = share_of(mesh)
    larger = [tried for tried in QUANTILES if tried > quantile and share > MADE_UP]
    better = next((tried for tried in larger if share_of(made.cut(tried)) <= MADE_UP), None)
    return mesh, MadeUp(share, far, better)


def _find_off(points: PointCloud, mesh: TriangleMesh) -> PointsOff:
    """How far the points lie from a surface, by a sample of them."""
    if not mesh.get_surface_area() > 0:
        return PointsOff()
    probes = PointCloud(points.points[:: max(1, len(points) // POINT_SAMPLES)], device=points.device)
    tree = TriangleTree(mesh._device_arrays["vertices"], mesh._device_arrays["triangles"])
    distances = distances_to(points_about(probes._device_arrays["points"], probes.origin, mesh.origin), tree)
    size = math.dist(points.get_min_bound(), points.get_max_bound())
    return PointsOff(float(np.median(download(distances))), size, points.unit)
