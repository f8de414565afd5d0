"""Pictures of operations in the reference: their code, the public names that they belong to, and their drawing.

docs/operations.py has a function for each picture. Its statements are the code below the picture. It returns the scenes
of the panels by title.
"""

from __future__ import annotations

import hashlib
import importlib
import inspect
import re
import textwrap
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

import pointloom as loom
from pointloom.visualization.render.canvas import Canvas

from .public import all_names, members_of
from .texts import indented, plain
from .usage import result_of

SIZE = (640, 400)  # [px] of a picture
TITLE = 24  # [px] above each panel
GAP = 4  # [px] between panels
QUALITY = 80  # of JPEG: 5 to 50 kB a picture
VIEW = ((0.6, -0.65, 0.5), (0.0, 0.0, 1.0), 0.6)  # front, up and zoom: from the front right, as fitted views
FOLDER = "reference/pictures"  # of docs/
DOCS = Path(__file__).parents[1]

# Pictures of the gallery and of guides: page, file, names.
REUSED = (
    ("chapters/plot_06_monocular_depth", 1, "photogrammetry.estimate_depth "
     "photogrammetry.DepthEstimate.to_point_cloud"),
    ("chapters/plot_09_photographs_to_a_cloud", 2, "photogrammetry.estimate_depth_maps photogrammetry.fuse_depth_maps "
     "photogrammetry.filter_depth_maps photogrammetry.DepthMaps photogrammetry.DepthBundle.fuse"),
    ("chapters/plot_10_colored_icp", 2, "registration.TransformationEstimationForColoredICP"),
    ("gallery/clouds/plot_large_clouds", 1, "DetailTree DetailTree.sample DetailTree.from_cloud DetailTree.from_file"),
    ("gallery/clouds/plot_neighbor_search", 1, "NearestNeighborSearch NearestNeighborSearch.radius_search "
     "NearestNeighborSearch.hybrid_search"),
    ("gallery/images/plot_photographs_to_mesh", 1, "photogrammetry.triangulate SfmModel SfmModel.point_cloud"),
    ("gallery/images/plot_undistort", 2, "undistort_image Undistortion CameraModel CameraModel.undistorted"),
    ("gallery/meshes/plot_deform", 1, "TriangleMesh.deform_as_rigid_as_possible"),
    ("gallery/registration/plot_batch_icp", 1, "registration.registration_icp_batch registration.deskew_point_cloud"),
    ("gallery/registration/plot_object_from_ten_views", 1, "registration.register_multiway "
     "registration.FragmentsResult registration.FragmentsResult.merge"),
    ("gallery/registration/plot_pose_graph_loop_closure", 1, "registration.global_optimization registration.PoseGraph"),
    ("gallery/rgbd/plot_odometry", 1, "rgbd.compute_rgbd_odometry rgbd.align_frames"),
    ("gallery/rgbd/plot_reconstruct_a_room", 1, "rgbd.reconstruct rgbd.ReconstructionResult"),
    ("gallery/rgbd/plot_reconstruct_in_stages", 1, "rgbd.run_reconstruction_system "
     "rgbd.run_slac_optimizer_for_fragments"),
    ("gallery/rgbd/plot_submaps", 1, "rgbd.fuse_submaps rgbd.close_loops rgbd.SubmapRecorder meshing.fuse_volumes "
     "rgbd.Submap rgbd.Submap.cloud"),
    ("gallery/rgbd/plot_texture_a_scan", 1, "meshing.texture_mesh meshing.optimize_color_map"),
    ("gallery/rgbd/plot_track_live", 1, "rgbd.DenseSLAM rgbd.DenseSLAM.extract_triangle_mesh rgbd.track "
     "rgbd.DenseSLAM.extract_point_cloud rgbd.DenseSLAM.render rgbd.SlamModel rgbd.SlamModel.extract_triangle_mesh "
     "rgbd.SlamModel.extract_point_cloud rgbd.SlamModel.render"),
    ("registration", "loops.png", "registration.LidarSLAM"),
    ("stations", "stations.png", "registration.register_stations registration.StationsResult "
     "registration.StationsResult.merge"),
    ("meshes", "textures.png", "meshing.texture_from_images TriangleMesh.project_images_to_albedo"),
    ("terrain", "terrain.png", "profile Profile meshing.orthophoto volume_change"),
    ("surfaces", "lidar-volumes.png", "TSDFVolume.integrate_points PagedTSDFVolume.integrate_points"),
)  # fmt: skip

# Results that can be drawn. reference/coverage lists the operations that return one, have no picture and are not in
# NEEDS_NONE.
VISIBLE = {
    "PointCloud", "TriangleMesh", "LineSet", "VoxelGrid", "AxisAlignedBoundingBox", "OrientedBoundingBox", "ConvexHull",
    "VisibleSurface", "Raster", "Profile", "GaussianSplats", "SplatImage", "DistanceField", "TSDFVolume", "Trajectory",
    "RGBDImage", "M3C2Result", "DetectedShapes", "Shape", "BoxShape", "RayCast", "SurfaceResult", "RegistrationResult",
}  # fmt: skip
# Reasons for no picture, and the last parts of the names to which they apply.
NEEDS_NONE = {
    "reads, converts or copies": r"(read|load|open|from|to)(_\w+)?|copy|scans"
    r"|create_from_\w+_(format|depth|box)|extract_parts|in_world|project_to_utm",
    "moves, joins or paints": r"transform|translate|rotate|scale|scaled|concatenate|merge|paint_uniform_color|reproject"
    r"|with_poses|trajectory|trajectory_of|transformed|deform(_rgbd)?|join_maps|set_positions",
    "selects given elements or removes defective ones": r"(select|remove)_\w+|clear|without|crop|clean"
    r"|merge_close_vertices|split_non_manifold_vertices|orient_triangles|normalize_normals|flip_normals"
    r"|compute_vertex_normals",
    "box of a geometry that is not a cloud or mesh": r"get_\w*bounding_box|create_camera_visualization",
    "computes the colors of a texture": r"compute_uvatlas|bake_vertex_colors",
}

Vector = tuple[float, float, float]
Panels = dict[str, Any]


@dataclass(frozen=True)
class Operation:
    """A picture: the function that returns its panels, its public names, and the camera of all panels."""

    panels: Callable[[], Panels]
    names: tuple[str, ...]
    front: Vector
    up: Vector
    zoom: float

    @property
    def stem(self) -> str:
        """Name of the file."""
        return self.panels.__name__

    @property
    def caption(self) -> str:
        """The docstring of the function."""
        return " ".join((self.panels.__doc__ or "").split())

    @property
    def code(self) -> str:
        """The statements of the function before its result, after the colors that they use."""
        body = inspect.getsource(self.panels).partition('"""\n')[2]
        statements = textwrap.dedent(body.partition("    return ")[0]).strip()
        used = dict.fromkeys(re.findall(r"\b[A-Z]{3,}\b", statements))
        colors = [f"{name} = {value}" for name in used if (value := self.panels.__globals__.get(name))]
        return "\n".join([*colors, statements])


OPERATIONS: dict[str, Operation] = {}  # by the name of the file


def picture(
    *names: str, front: Vector = VIEW[0], up: Vector = VIEW[1], zoom: float = VIEW[2]
) -> Callable[[Callable[[], Panels]], Callable[[], Panels]]:
    """Decorator: the picture of these names, relative to `pointloom`."""

    def add(panels: Callable[[], Panels]) -> Callable[[], Panels]:
        OPERATIONS[panels.__name__] = Operation(panels, names, front, up, zoom)
        return panels

    return add


@cache
def operations() -> dict[str, Operation]:
    """All pictures of docs/operations.py by the name of their file."""
    importlib.import_module("operations")
    return OPERATIONS


def draw(operation: Operation, size: tuple[int, int] = SIZE) -> Image.Image:
    """Draw the panels side by side, seen from one camera that shows them all, with their titles above."""
    panels = operation.panels()
    width, height = (size[0] - GAP * (len(panels) - 1)) // len(panels), size[1] - TITLE
    bounds = [bound for scene in panels.values() for bound in bounds_of(scene)]
    sheet = Canvas.blank(*size, (1, 1, 1), "cpu")
    for number, (title, scene) in enumerate(panels.items()):
        left = number * (width + GAP)
        sheet.image(draw_panel(operation, scene, bounds, (width, height)), left, TITLE)
        sheet.text(title, left + 6, TITLE / 2, size=14, color=(0.1, 0.1, 0.1))
    return Image.fromarray(sheet.to_numpy())


def draw_panel(operation: Operation, scene: Any, bounds: list[Any], size: tuple[int, int]) -> np.ndarray:
    """Draw one panel: geometries, arguments of `loom.render`, or an image, which is scaled."""
    if isinstance(scene, np.ndarray):
        image = Image.fromarray(np.ascontiguousarray(scene)).convert("RGB")
        factor = min(size[0] / image.width, size[1] / image.height)
        fitted = image.resize((round(image.width * factor), round(image.height * factor)), Image.Resampling.LANCZOS)
        panel = Image.new("RGB", size, "white")
        panel.paste(fitted, ((size[0] - fitted.width) // 2, (size[1] - fitted.height) // 2))
        return np.asarray(panel)
    options = scene if isinstance(scene, dict) and "geometries" in scene else {"geometries": scene}
    low, high = np.min([low for low, _ in bounds], axis=0), np.max([high for _, high in bounds], axis=0)
    view = loom.View.from_open3d((low, high), zoom=operation.zoom, front=list(operation.front), up=list(operation.up),
                                 width=size[0], height=size[1])  # fmt: skip
    return np.asarray(loom.render(**{"camera": view, "size": size, **options}))


def bounds_of(scene: Any) -> list[tuple[np.ndarray, np.ndarray]]:
    """Corners of the bounding boxes of all geometries of a scene."""
    if isinstance(scene, dict):
        inner = scene.get("geometries", scene.get("geometry"))
        return bounds_of(list(scene.values()) if inner is None else inner)
    if isinstance(scene, list | tuple):
        return [bound for part in scene for bound in bounds_of(part)]
    if not hasattr(scene, "get_min_bound"):
        return []
    return [(np.asarray(scene.get_min_bound()), np.asarray(scene.get_max_bound()))]


def write_pictures(docs: Path) -> None:
    """Draw all pictures whose code has changed since the last call."""
    folder = docs / FOLDER
    folder.mkdir(parents=True, exist_ok=True)
    sources = b"".join(Path(path).read_bytes() for path in (__file__, docs / "operations.py"))
    stamp, digest = folder / "digest.txt", hashlib.sha256(sources).hexdigest()
    if not stamp.exists() or stamp.read_text(encoding="utf-8") != digest:
        for operation in operations().values():
            draw(operation).save(folder / f"{operation.stem}.jpg", quality=QUALITY, optimize=True)
        stamp.write_text(digest, encoding="utf-8")
    for path in folder.glob("*.jpg"):
        if path.stem not in operations():
            path.unlink()


@cache
def pictures() -> dict[str, tuple[str, str]]:
    """File of the picture in docs/ and its page, or its operation, by public name."""
    found = {}
    for page, image, names in REUSED:
        folder, _, stem = page.rpartition("/")
        file = image if isinstance(image, str) else f"{folder}/images/sphx_glr_{stem}_{image:03}.png"
        found.update({f"pointloom.{name}": (file, page) for name in names.split()})
    for operation in operations().values():
        found.update({f"pointloom.{name}": (f"{FOLDER}/{operation.stem}.jpg", "") for name in operation.names})
    return found


def page_name(name: str) -> str:
    """The name whose page of the reference contains a public name: the class of a method."""
    return name if name in all_names() else name.rpartition(".")[0]


def picture_of(name: str) -> list[str]:
    """reST lines with the picture of a public name: on each page once, then a link. Empty if there is none."""
    file, page = pictures().get(name, ("", ""))
    if not file or not (DOCS / file).exists():
        return []
    first = next(
        other for other, known in pictures().items() if known[0] == file and page_name(other) == page_name(name)
    )
    if first != name:
        return ["", f"Picture: :py:obj:`~{first}`", ""]
    figure = ["", f".. figure:: /{file}", "   :class: loom-operation", f"   :alt: {name.rpartition('.')[2]}", ""]
    if page:
        return [*figure, f"   From :doc:`/{page}`", ""]
    operation = operations()[Path(file).stem]
    code = indented(operation.code, 6).splitlines()
    return [*figure, f"   {plain(operation.caption)}", "", ".. dropdown:: Code of the picture", "",
            "   .. code-block:: python", "", *code, ""]  # fmt: skip


def without_picture() -> list[str]:
    """Functions and methods with a visible result that have no picture and no reason for it."""
    return [name for name in visible() if name not in pictures() and not reason_for_none(name)]


def visible() -> list[str]:
    """Functions and methods of pointloom that return something that can be drawn. `pointloom.open3d` repeats them."""
    names = []
    for name, public in all_names().items():
        if public.module in {"pointloom.open3d", "pointloom.datasets"}:
            continue  # the scenes of datasets are those of the pictures
        members = [f"{name}.{key}" for key in members_of(name)] if inspect.isclass(public.value) else [name]
        methods = [
            each for each in members if each in all_names() or callable(getattr(public.value, each.split(".")[-1]))
        ]
        for each in methods:
            kinds = result_of(each)
            kinds = kinds if isinstance(kinds, list) else [kinds]
            if any(kind and kind.rpartition(".")[2].lstrip("*") in VISIBLE for kind in kinds):
                names.append(each)
    return names


def reason_for_none(name: str) -> str:
    """The reason of NEEDS_NONE that applies to a name. Empty if there is none."""
    last = name.rpartition(".")[2]
    return next((reason for reason, pattern in NEEDS_NONE.items() if re.fullmatch(pattern, last)), "")
