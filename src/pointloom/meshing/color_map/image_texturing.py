"""Seamless texture from posed images, each triangle from the best one: `texture_from_images`."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import warp as wp

from ...core.checks import check_color, check_count, check_progress
from ...core.errors import FilePath
from ...core.kept_arrays import Arrays, KeptArrays, digest_of_inputs, kept_arrays
from ...core.progress import ReportProgress
from ...io.points.archives import read_part_of_job
from ...kernels.array_types import Indices, Points, Triangles
from ...kernels.arrays.duplicates import find_equal_points
from ...kernels.arrays.sort import positions
from ...kernels.lang import int32, vec3d
from ...kernels.linear_algebra import matmul
from ...kernels.memory import check_room, download, upload
from ...kernels.meshes.merge_vertices import rename_corners
from ...kernels.textures.chart_texels import ChartTexels, finish_texels, paint_texels
from ...kernels.textures.charts import Packing, compute_uvs, cut_charts, find_twins
from ...kernels.textures.color_outliers import keep_likely
from ...kernels.textures.exposures import MAX_VIGNETTING, Exposures, find_exposures, plain_exposures
from ...kernels.textures.face_views import FaceViews, FaceVisibility, keep_views
from ...kernels.textures.hidden_vertices import plant_trees
from ...kernels.textures.seam_joins import SeamSamples, drawn_steps, join_seams
from ...kernels.textures.seam_levels import SeamLevels, Seams
from ...kernels.textures.seam_strips import blend_strips
from ...kernels.textures.stacked_images import StackedImages
from ...kernels.textures.view_labels import MAX_IMAGE_COST, LabelGraph, choose_labels, cost_views, energy_of, name_views
from ..mesh.mesh import TriangleMesh
from ..mesh.mesh_arrays import check_mesh
from ..mesh.posed_images import PosedImages
from .chart_packing import pack_charts
from .image_sources import take_images
from .image_texture_result import ImageTextureResult
from .options import ImageTextureOption
from .results import NothingSeenError

CHART_PADDING = 4  # texels around each chart: two of its image, two of their colors
MAX_SIZE = 16384  # texels per side
MAX_TEXTURE_SIZE = 8192  # default limit
TEXEL_BYTES = 120
MAX_GAIN = 1e6  # between exposures of images with 8 bits
MAX_PAIRS = 1e15  # triangle-image pairs, and their energy: more do not fit into memory


def texture_from_images(
    mesh: TriangleMesh,
    images: Any,
    cameras: Any,
    extrinsics: Any = None,
    option: ImageTextureOption | None = None,
    *,
    size: int | None = None,
    work: FilePath | None = None,
    progress: ReportProgress | None = None,
) -> ImageTextureResult:
    """Texture a mesh from posed images, each triangle from its best image, without seams.

    Views are chosen by size and sharpness of the triangle and by smoothness between neighbors. Colors are adjusted
    until images agree at seams. Sharper than `TriangleMesh.project_images_to_albedo`. Poses are not changed. See
    `optimize_color_map`. Bitwise reproducible on one device. 7 B per pixel, 120 B per texel, about 30 B per
    triangle-image pair. Colors are shifted, not scaled. Waechter, Moehrle and Goesele, "Let There Be Color!", ECCV
    2014.

    Args:
        mesh: In the frame of the poses, triangles facing the cameras.
        images: uint8 (h, w, 3), RGBDImages with colors, or files, one per pose. For an SfmModel also their folder.
        cameras: One PinholeCameraIntrinsic, or one per image; or cameras with poses, such as
            `photogrammetry.PosedCamera`; or an SfmModel, as of `read_cameras`, whose images are undistorted if
            necessary.
        extrinsics: Poses (n, 4, 4), world to camera. If None: those of the cameras.
        option: Steps and limits; None: the defaults.
        size: Texels per side. If None: as many as the images have pixels, up to 8192. Charts are scaled to fit.
        work: Folder for the choice of images, the longest step, 4 B per triangle. After an interruption, a call with
            the same inputs continues from it, with bitwise the same result. Delete it after the result is stored. If
            None, an interruption loses all work.
        progress: Called with the stage ("images", "views", "choice", "seams", "texture"), progress and total or 0.

    Returns:
        A ImageTextureResult: the textured mesh, the image of each triangle, statistics, and `reliable`.

    Raises:
        TypeError: If `mesh` is not a TriangleMesh, or images or cameras have another type.
        ValueError: If the mesh is empty, inputs disagree, a pose is not rigid, a number is out of range, or charts do
            not fit.
        NothingSeenError: If no image sees a triangle. It is a ValueError.
        FileError, MemoryError: If an image cannot be read or the folder `work` contains other files, or if the texture
            does not fit into device memory.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> mesh = loom.TriangleMesh([[-0.1, -0.1, 1], [0.1, -0.1, 1], [0, 0.1, 1]], [[0, 2, 1]])
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> green = np.full((48, 64, 3), (0, 255, 0), np.uint8)
        >>> found = loom.meshing.texture_from_images(mesh, [green], camera, [np.eye(4)])
        >>> found.views.tolist(), found.mesh.textures[0].shape
        ([0], (64, 64, 3))
    """
    check_mesh("mesh", mesh)
    if not len(mesh):
        raise ValueError("mesh: expected triangles to texture, got none")
    if size is not None:
        because = "the texture and its intermediate arrays would not fit into memory. Use fewer texels"
        size = check_count("size", size, minimum=16, maximum=MAX_SIZE, because=because)
    if not isinstance(option, ImageTextureOption | None):
        raise TypeError(f"option: expected an ImageTextureOption, got {type(option).__name__}")
    option, report = option or ImageTextureOption(), check_progress(progress)
    images = take_images(images, cameras, extrinsics, mesh.device, report)
    with kept_arrays(work, lambda: _digest_of(mesh, images, option), report) as kept:
        choice = _choose(mesh, images, option, kept)
    report("seams", 0, 0)
    levels = SeamLevels(mesh.arrays["vertices"], choice.seams, choice.images, choice.exposures)
    before = levels.mean_step()
    if option.seam_leveling:
        levels.solve(level=bool(option.exposures))
    report("texture", 0, 0)
    painted = _paint(mesh, choice, levels, size, option)
    views = download(choice.seams.views).copy()
    counts = {"chart_count": painted.charts, "pair_count": choice.pairs, "outlier_count": choice.outliers}
    mean, step_95 = painted.steps if painted.steps is not None else (None, None)
    figures = {
        "energy": choice.energy,
        "step_before": before,
        "step": mean,
        "step_95": step_95,
        "turns": levels.iterations,
    }
    how = {"size": painted.packing.size, "scale": painted.packing.scale, "drew_colors": painted.drew_colors}
    return ImageTextureResult(painted.mesh, views, choice.images.count, **counts, **figures, **how)


@dataclass(frozen=True, eq=False)
class _Choice:
    """Image of each triangle, with exposures, seams, triangle-image pairs, excluded pairs and energy."""

    images: StackedImages
    exposures: Exposures
    seams: Seams
    pairs: int
    outliers: int
    energy: float


def _digest_of(mesh: TriangleMesh, images: PosedImages, option: ImageTextureOption) -> str:
    """Digest of everything that determines the choice of images."""
    lenses = [(c.width, c.height, c.fx, c.fy, c.cx, c.cy) for c in images.cameras]
    settings = [option.smoothness, option.outliers, option.exposures, option.depth_max]
    shape = [download(mesh.arrays[name]) for name in ("vertices", "triangles")]
    arrays = [*shape, mesh.origin, images.T_camera_world, *map(download, images.colors)]
    return digest_of_inputs([lenses, settings], arrays, mesh.device)


def _choose(mesh: TriangleMesh, images: PosedImages, option: ImageTextureOption, kept: KeptArrays) -> _Choice:
    vertices, device = mesh.arrays["vertices"], mesh.device
    owners = find_equal_points(vertices)
    triangles = rename_corners(mesh.arrays["triangles"], owners, positions(vertices.size, device))
    stack, twins = images.stacked(mesh.origin, 0), find_twins(triangles, vertices.size)
    make = partial(_choose_views, vertices, triangles, twins, stack, option, kept.report)
    arrays = kept.get("choice", make, partial(_read_choice, mesh, images, stack))
    gains = Exposures(*(upload(arrays[name], vec3d, device) for name in ("gains", "bends")))
    seams = Seams(triangles, twins, upload(arrays["views"], int32, device), stack.count, vertices.size)
    pairs, outliers, energy = arrays["pairs"].tolist()
    return _Choice(stack, gains, seams, int(pairs), int(outliers), energy)


def _read_choice(mesh: TriangleMesh, images: PosedImages, stack: StackedImages, path: Path) -> Arrays:
    """The arrays of `_choose_views`. Raises FileError if they do not fit the mesh and the images."""
    colors, count = (np.float64, (stack.count, 3)), stack.count
    expected = {"views": (np.int32, (len(mesh),)), "gains": colors, "bends": colors, "pairs": (np.float64, (3,))}

    def find_fault(arrays: Arrays) -> str:
        views, gains, bends, pairs = (arrays[name] for name in ("views", "gains", "bends", "pairs"))
        is_gain = ((gains > 1 / MAX_GAIN) & (gains < MAX_GAIN)).all()
        if not (is_gain and (np.abs(bends) <= MAX_VIGNETTING).all() and ((pairs >= 0) & (pairs < MAX_PAIRS)).all()):
            return "gains, bends, pairs: numbers that no choice has"
        if not ((views >= -1) & (views < count)).all():
            return f"views: expected -1 to {count - 1}"
        corners, poses = download(mesh.arrays["vertices"])[download(mesh.arrays["triangles"])], download(stack.poses)
        for k, camera in enumerate(images.cameras):
            points = matmul(corners[views == k].reshape(-1, 3).astype(np.float64), poses[k, :3, :3].T) + poses[k, :3, 3]
            pixels = points[:, :2] * (camera.fx, camera.fy) / points[:, 2:] + (camera.cx, camera.cy)
            if not ((points[:, 2:] > 0) & (pixels > -1) & (pixels < (camera.width, camera.height))).all():
                return f"views: a triangle is outside of image {k}"
        return ""

    return read_part_of_job(path, "the choice of images", lambda _: expected, find_fault, "It is computed again")


def _choose_views(
    vertices: Points,
    triangles: Triangles,
    twins: Indices,
    stack: StackedImages,
    option: ImageTextureOption,
    report: ReportProgress,
) -> Arrays:
    """The image of each triangle, exposures, and the numbers of pairs and outliers with the energy."""
    looks = FaceVisibility(vertices, triangles, stack, plant_trees(vertices, triangles), float(option.depth_max))
    all_views = looks.views(lambda done: report("views", done, stack.count))
    if not all_views.count:
        raise NothingSeenError(
            "images: no image shows a triangle of the mesh. Check that the poses are world to camera, in the frame "
            "of the mesh, that its triangles face the cameras, and that it is within depth_max"
        )
    report("choice", 0, 0)
    views: FaceViews = keep_views(all_views, keep_likely(all_views)) if option.outliers else all_views
    gains = find_exposures(vertices, triangles, views, stack) if option.exposures else plain_exposures(stack)
    graph = LabelGraph(views.starts, views.views, cost_views(views), twins, round(option.smoothness * MAX_IMAGE_COST))
    labels = choose_labels(graph)
    energy = energy_of(graph, labels) / MAX_IMAGE_COST
    pairs = np.array([all_views.count, all_views.count - views.count, energy], np.float64)
    named = {"views": name_views(graph, labels), "gains": gains.gains, "bends": gains.bends}
    return {name: download(values) for name, values in named.items()} | {"pairs": pairs}


@dataclass(frozen=True, eq=False)
class _Painted:
    """A textured mesh with its packing, chart count and seam steps (mean, 95th percentile; None without seams)."""

    mesh: TriangleMesh
    packing: Packing
    charts: int
    steps: tuple[float, float] | None
    drew_colors: bool


def _paint(
    mesh: TriangleMesh, choice: _Choice, levels: SeamLevels, size: int | None, option: ImageTextureOption
) -> _Painted:
    vertices, seams, images = mesh.arrays["vertices"], choice.seams, choice.images
    charts = cut_charts(vertices, seams.triangles, seams.twins, seams.views, images)
    colors: wp.array | None = mesh.arrays["vertex_colors"] if mesh.vertex_colors is not None else None
    blind = int((download(seams.views) < 0).sum())  # sync
    packing = pack_charts(charts.boxes(), blind, colors is not None, CHART_PADDING, size, MAX_TEXTURE_SIZE)
    side = packing.size
    check_room(mesh.device, side * side * TEXEL_BYTES, f"size: a texture of {side} x {side} texels")
    uvs = compute_uvs(vertices, seams.triangles, seams.views, images, charts, packing)
    texels = ChartTexels(uvs, side)
    paint_texels(texels, levels, packing.scale, colors, check_color("plain", option.plain))
    seam_samples = SeamSamples(texels, seams)
    if option.local_leveling:
        blend_strips(texels, levels)
        join_seams(seam_samples, texels.colors)
    pixels = finish_texels(texels, CHART_PADDING)
    steps = drawn_steps(seam_samples, pixels)
    image = download(pixels).reshape(side, side, 3)  # sync
    without = mesh.with_arrays(triangle_uvs=None, triangle_material_ids=None, vertex_colors=None)
    textured = without.with_arrays(triangle_uvs=uvs)
    textured.textures = (image.copy(),)
    drew = bool(blind and colors is not None and packing.cells.side)
    return _Painted(textured, packing, charts.count, steps, drew)
