"""The points of a file to a surface through them: `mesh_file`."""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..meshing.mesh import TriangleMesh
from ..meshing.mesh_files import mesh_table
from ..meshing.mesh_topology import count_edges
from ..meshing.poisson import OPPOSED, NormalsWarning
from ..pcd.cloud import PointCloud
from ..pcd.coordinates import finite_box
from ..pcd.search import NearestNeighborSearch
from . import tables
from .clouds import FilePath, closing_fields, make_report, read_cloud
from .console import ReportProgress, format_bounds, format_share
from .mesh_job import Stages
from .pictures.picture_files import check_picture, save_picture
from .pictures.render import render

Cut = Callable[[float], TriangleMesh]

DEPTH = 8
DENSITY_QUANTILE = 0.01  # of Open3D's tutorial: the surface that Poisson makes up where there are no points
NEIGHBORS = 30  # of a normal that is made, and in the graph that orients them
BACKDROP = (0.88, 0.89, 0.91)  # of the picture: white surfaces stand out from it

# What makes a result poor.
TORN = 0.1  # share of edges at a border: 30 x 30 squares have 4 %, a ball that rolls through the gaps makes 30 %
CROWDED = {"poisson": 0.01, "ball": 0.01, "alpha": 0.1}  # share of edges of three triangles or more; some alpha has
ISLANDS = 0.1  # share of the area outside the largest part
MADE_UP = 0.05  # share of Poisson's surface far from all points

SPACING_NEIGHBORS = 10
FAR = 3.0  # times the median distance of a point to its 10th neighbour: Poisson closes smaller gaps well
SURFACE_SAMPLES, POINT_SAMPLES = 10_000, 2_000
QUANTILES = (0.02, 0.05, 0.1, 0.2, 0.4)  # of which the first that mends a surface made up is proposed

_LARGER = {"poisson": "a smaller --density-quantile or --depth", "ball": "larger --radii", "alpha": "a larger --alpha"}


def mesh_file(
    source: FilePath,
    output: FilePath,
    *,
    method: str = "poisson",
    depth: int = DEPTH,
    density_quantile: float = DENSITY_QUANTILE,
    radii: list[float] | None = None,
    alpha: float | str = "auto",
    new_normals: bool = False,
    picture: FilePath | None = None,
    device: Any = "auto",
    as_text: bool = False,
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> dict[str, Any]:
    """Write a surface through the points of a cloud, and a picture of it; outputs are checked before the work.

    Args:
        source: A cloud; of a mesh the vertices count.
        output: A .ply, .obj, .stl, .off or .glb file; STL holds no normals and colours, which are then left out.
        method: "poisson", "ball" (pivoting) or "alpha" (shape), by `TriangleMesh.from_point_cloud_...`.
        depth: Poisson: of the octree.
        density_quantile: Poisson: this share of the vertices goes, those with the fewest points about them.
        radii: Ball pivoting: of the balls [m]; None chooses them.
        alpha: Alpha shape: the radius [m] of its balls, or "auto".
        new_normals: Make normals anew though the cloud has some.
        picture: A .png file for a picture of the mesh.
        device: Where to compute.
        as_text: Text instead of binary, for .ply.
        overwrite: Replace outputs that exist.
        progress: Called with each stage when it begins.

    Returns:
        What was done, in JSON's types; "poor" says why the result is poor, or is None. An empty mesh is not written.
        Of the points' attributes a surface has normals and colours; "not_carried" names the others.

    Raises:
        FileError: A file that cannot be read, or an output that cannot be written.
        ValueError: What the method refuses.
        DeviceError: No such device.
    """
    form = {"overwrite": overwrite, "as_text": as_text}
    tables.check_output(output, tables.MESHES, what="meshes", **form)
    if picture is not None:
        check_picture(picture, overwrite=overwrite)
    stages = Stages(progress)
    with stages("read"):
        cloud, left_out, _ = read_cloud(source, device)
        points = cloud.remove_non_finite_points()
    with stages("normals"):
        points, normals = _with_normals(points, method, new_normals)
    with stages(method):
        settings = {"depth": depth, "density_quantile": density_quantile, "radii": radii, "alpha": alpha}
        mesh, cut = _make_surface(points, method, settings) if len(points) else (TriangleMesh(), None)
    with stages("check"):
        figures = describe_surface(mesh) | _find_made_up(points, mesh, cut, density_quantile)
    reasons = [_why_doubted(normals), _why_poor(figures, method, len(points))]
    files: list[str] = []
    if len(mesh):
        with stages("write"):
            left_out += tables.write_mesh_table(output, mesh_table(mesh), **form)
        files.append(os.fspath(output))
        if picture is not None:
            with stages("picture"):
                save_picture(picture, draw_surface(mesh), overwrite=overwrite)
            files.append(os.fspath(picture))
    poor = "; ".join(reason for reason in reasons if reason) or None
    report = make_report("mesh", source, files, stages.clock, left_out, poor=poor)
    used = {name: settings[name] for name in _SETTINGS[method]}
    counts = {"points_in": len(cloud), "points": len(points), "not_carried": [*cloud.attributes]}
    return report | {"device": str(cloud.device), "method": method, **used, **normals} | counts | figures


_SETTINGS = {"poisson": ("depth", "density_quantile"), "ball": ("radii",), "alpha": ("alpha",)}


def mesh_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """What was done as labels and values for the terminal."""
    settings = ", ".join(f"{name.replace('_', ' ')} {_shown(report[name])}" for name in _SETTINGS[report["method"]])
    lost = report["points_in"] - report["points"]
    normals = report["normals"]
    if report["disagreement"] is not None:
        normals += f"; {format_share(report['disagreement'])} of neighbours to opposite sides"
    edges = f"{report['boundary_edges']:,} of {report['edges']:,} at a border"
    if report["crowded_edges"]:
        edges += f", {report['crowded_edges']:,} of three triangles or more"
    parts = f"{report['parts']:,}"
    if report["parts"] > 1:
        parts += f", the largest {format_share(report['largest_share'])} of the area"
    return [
        ("method", f"{report['method']}, {settings}"),
        ("points", f"{report['points']:,}" + (f", {lost:,} not finite left out" if lost else "")),
        ("normals", normals),
        ("mesh", f"{report['vertices']:,} vertices, {report['triangles']:,} triangles, {report['area']:.4g} m^2"),
        ("parts", parts),
        ("edges", edges),
        *([("made up", f"{format_share(report['made_up'])} of the area")] if report["made_up"] else []),
        ("closed", "yes" if report["watertight"] else "no"),
        ("bounds", format_bounds(report["bounds"])),
        *([("not carried", f"{', '.join(report['not_carried'])} of the points")] if report["not_carried"] else []),
        *closing_fields(report),
    ]


def describe_surface(mesh: TriangleMesh) -> dict[str, Any]:
    """The figures of a mesh, in JSON's types."""
    _, _, areas = mesh.cluster_connected_triangles()
    area = float(areas.sum())
    edges = count_edges(mesh)
    vertices = mesh.vertices
    low, high = finite_box(vertices)
    return {
        "vertices": len(vertices),
        "triangles": len(mesh),
        "area": area,
        "parts": len(areas),
        "largest_share": float(areas.max() / area) if area else 0.0,
        "edges": edges.all,
        "boundary_edges": edges.boundary,
        "crowded_edges": edges.crowded,
        "watertight": mesh.is_watertight(),
        "bounds": {"min": low.tolist(), "max": high.tolist()} if len(vertices) else None,
    }


def draw_surface(mesh: TriangleMesh) -> NDArray[np.uint8]:
    """A picture of a mesh. Of one whose faces look inwards, as a room's, those that look away are left out."""
    return render(mesh, background=BACKDROP, mesh_show_back_face=not looks_inwards(mesh))


# ------------------------------------------------------------------------------------------------ internals


def _with_normals(points: PointCloud, method: str, anew: bool) -> tuple[PointCloud, dict[str, Any]]:
    """The cloud with the normals that the method needs, where they come from, and how far they disagree."""
    if method == "alpha":
        return points, {"normals": "not needed", "disagreement": None}
    origin = "of the input"
    if anew or not points.has_normals:
        origin = f"made of the {NEIGHBORS} nearest points of each and oriented"
        origin += "" if points.has_normals else ": the input has none"
        points = points.without("normals") if points.has_normals else points
        points = points.estimate_normals(max_nn=NEIGHBORS).orient_normals_consistent_tangent_plane(NEIGHBORS)
    return points, {"normals": origin, "disagreement": points.normal_disagreement()}


def _make_surface(points: PointCloud, method: str, settings: dict[str, Any]) -> tuple[TriangleMesh, Cut | None]:
    """The surface, and for Poisson's what cuts it at another quantile."""
    if method == "ball":
        return TriangleMesh.from_point_cloud_ball_pivoting(points, settings["radii"]), None
    if method == "alpha":
        return TriangleMesh.from_point_cloud_alpha_shape(points, settings["alpha"]), None
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", NormalsWarning)  # the verdict says so
        mesh, densities = TriangleMesh.from_point_cloud_poisson(points, depth=settings["depth"])

    def cut(quantile: float) -> TriangleMesh:
        if not len(densities):
            return mesh
        return mesh.remove_vertices_by_mask(densities < np.quantile(densities, quantile)).remove_unreferenced_vertices()

    return cut(settings["density_quantile"]), cut


def _find_made_up(points: PointCloud, mesh: TriangleMesh, cut: Cut | None, quantile: float) -> dict[str, Any]:
    """How much of Poisson's surface lies far from all points, how far that is, and a quantile that leaves little."""
    if cut is None or not mesh.get_surface_area() > 0:
        return {"made_up": None, "far": None, "better_quantile": None}
    search = NearestNeighborSearch(points)
    probes = points.points[:: max(1, len(points) // POINT_SAMPLES)]
    farthest = search.knn_search(probes, min(SPACING_NEIGHBORS + 1, len(points))).sqdists[:, -1]
    far = FAR * float(np.sqrt(np.median(farthest)))

    def share_of(surface: TriangleMesh) -> float:
        samples = surface.sample_points_uniformly(SURFACE_SAMPLES).points
        return float(np.mean(search.knn_search(samples, 1).sqdists[:, 0] > far * far))

    made_up, better = share_of(mesh), None
    if made_up > MADE_UP:
        better = next((q for q in QUANTILES if q > quantile and share_of(cut(q)) <= MADE_UP), None)
    return {"made_up": made_up, "far": far, "better_quantile": better}


def looks_inwards(mesh: TriangleMesh) -> bool:
    """Whether most of the surface faces its middle."""
    corners = mesh.vertices[mesh.triangles]
    middles = corners.mean(axis=1)
    crosses = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = np.linalg.norm(crosses, axis=1)
    outwards = middles - np.average(middles, axis=0, weights=areas if areas.sum() > 0 else None)
    heights = np.einsum("ij,ij->i", crosses, outwards)
    return bool(heights.sum() < -0.3 * np.abs(areas * np.linalg.norm(outwards, axis=1)).sum())


def _shown(value: Any) -> str:
    if value is None:
        return "chosen by the spacing of the points"
    return " ".join(f"{part:g}" for part in value) if isinstance(value, list | tuple) else str(value)


def _why_doubted(normals: dict[str, Any]) -> str | None:
    share = normals["disagreement"]
    if share is None or share <= OPPOSED:
        return None
    said = f"{format_share(share)} of neighbouring normals point to opposite sides"
    if normals["normals"] == "of the input":
        return f"{said}; give --new-normals, or orient those of the input"
    return f"{said} though they were oriented: the points hardly lie on a surface; clean or smooth them first"


def _why_poor(figures: dict[str, Any], method: str, point_count: int) -> str | None:
    """Whether the mesh is empty, torn, made up or in pieces."""
    if not point_count:
        return "no point is finite, so there is no surface; nothing was written"
    if not figures["triangles"]:
        return f"the mesh is empty, and nothing was written; take {_LARGER[method]}"
    reasons, edges = [], figures["edges"]
    if figures["boundary_edges"] > TORN * edges:
        share = format_share(figures["boundary_edges"] / edges)
        reasons.append(f"the mesh is torn: {share} of its edges are at a border; take {_LARGER[method]}")
    if figures["crowded_edges"] > CROWDED[method] * edges:
        share = format_share(figures["crowded_edges"] / edges)
        reasons.append(f"{share} of its edges have three triangles or more, so it is no single surface")
    if figures["made_up"] is not None and figures["made_up"] > MADE_UP:
        better = figures["better_quantile"]
        remedy = f"--density-quantile {better:g}" if better else "a larger --density-quantile"
        reasons.append(
            f"{format_share(figures['made_up'])} of the area lie farther than {figures['far']:.3g} m from all points, "
            f"made up to close the surface; take {remedy}"
        )
    if 1 - figures["largest_share"] > ISLANDS:
        share = format_share(1 - figures["largest_share"])
        what = "islands or the walls of hollows" if method == "alpha" else "islands"
        reasons.append(
            f"{share} of the area are {what}, {figures['parts'] - 1:,} of them: clean the cloud first, or take "
            f"{_LARGER[method]}"
        )
    return "; ".join(reasons) or None
