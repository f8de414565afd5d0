"""Vertex colors from posed images."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.trajectory import Trajectory
from ...core.kept_arrays import Arrays, KeptArrays
from ...core.progress import ReportProgress, ignore_progress
from ...kernels.arrays.select import gather_rows, invert_mask, positions_of
from ...kernels.arrays.side_by_side import read_together
from ...kernels.lang import loop_while
from ...kernels.linear_algebra import inv, matmul
from ...kernels.memory import download
from ...kernels.search.tree_search import search_nearest
from ...kernels.textures.color_steps import COUNT_COLUMN, SQUARES_COLUMN, ColorSearch
from ...kernels.textures.hidden_vertices import plant_trees, render_depth
from ...kernels.textures.stacked_images import StackedImages, Warps
from ...kernels.textures.vertex_views import (
    DepthRule,
    Sightings,
    average_colors,
    fill_colors,
    list_sightings,
    mask_by_depth,
)
from ...kernels.textures.warp_steps import WarpSearch
from ...pcd.cloud import PointCloud
from ..mesh.mesh import TriangleMesh
from ..mesh.mesh_arrays import check_mesh
from ..mesh.posed_images import Names, PosedImages, check_images
from .options import ColorMapOption
from .results import ColorMapResult, NothingSeenError

OCCLUSIONS = ("depth", "rays")
METHODS = ("rigid", "non-rigid")
NAMES = Names("images_rgbd", "intrinsic", "camera_trajectory.poses")


def optimize_color_map(
    mesh: TriangleMesh,
    images_rgbd: Sequence[Any],
    camera_trajectory: Trajectory,
    option: ColorMapOption | None = None,
    *,
    intrinsic: PinholeCameraIntrinsic | ArrayLike,
    method: str = "rigid",
    occlusion: str | None = None,
) -> ColorMapResult:
    """Color a mesh from posed images, and refine the poses, and optionally warps, so that the images agree.

    A vertex takes the mean color of the images that see it under the given poses. Vertex intensities and Gauss-Newton
    pose steps alternate. Unlike in Open3D, steps have full length, steps that increase the residual are reverted, and
    the search ends below a gain of 1e-6. Bitwise reproducible on one device. 7 B per pixel, 12 B per image-vertex pair.
    Zhou and Koltun, "Color map optimization for 3D reconstruction with consumer depth cameras", SIGGRAPH 2014.

    Args:
        mesh: The mesh. Its colors are replaced, all else is kept.
        images_rgbd: RGBDImages with colors, or images uint8 (h, w, 3) without depth.
        camera_trajectory: T_world_camera of each image.
        option: None for the defaults, which move no pose.
        intrinsic: The camera of all images, or a list of one per image.
        method: "rigid" optimizes poses. "non-rigid" also optimizes a bilinear warp of each image by a grid of anchors,
            which compensates lens distortion and mesh errors: 100 B more per image-vertex pair and 8 (2 rows + 12) B
            per anchor unknown.
        occlusion: Occlusion test by "depth" of the images or by "rays" on the mesh, one per pixel. If None: depth if
            present.

    Returns:
        A ColorMapResult, which unpacks as (colored mesh, poses). `warp` and `unwarped_image` describe the warps.

    Raises:
        TypeError: If an argument has another type.
        ValueError: If images, poses and cameras disagree, a pose is not rigid, or depth for occlusion is missing.
        NothingSeenError: If no image sees a vertex. It is a ValueError.
        DeviceError: If images are on another device than the mesh.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> mesh = loom.TriangleMesh([[-0.1, -0.1, 1], [0.1, -0.1, 1], [0, 0.1, 1]], [[0, 2, 1]])
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> frame = loom.RGBDImage(np.full((48, 64, 3), (0, 255, 0), np.uint8), np.full((48, 64), 1000, np.uint16))
        >>> path = loom.Trajectory([np.eye(4), np.eye(4)])
        >>> colored, path = loom.meshing.optimize_color_map(mesh, [frame, frame], path, intrinsic=camera)
        >>> colored.vertex_colors.tolist()
        [[0.0, 1.0, 0.0], [0.0, 1.0, 0.0], [0.0, 1.0, 0.0]]
    """
    return color_mesh(mesh, images_rgbd, camera_trajectory, option, intrinsic, method, occlusion)


def color_mesh(
    mesh: TriangleMesh,
    images_rgbd: Sequence[Any],
    camera_trajectory: Trajectory,
    option: ColorMapOption | None,
    intrinsic: PinholeCameraIntrinsic | ArrayLike,
    method: str,
    occlusion: str | None = None,
    *,
    kept: KeptArrays | None = None,
) -> ColorMapResult:
    """As `optimize_color_map`. `kept` keeps the result by the name of the method, and receives the progress."""
    chosen = ColorMapOption() if option is None else option
    if not isinstance(chosen, ColorMapOption):
        raise TypeError(f"option: expected a ColorMapOption, got {type(chosen).__name__}")
    if not isinstance(method, str) or method not in METHODS:
        raise ValueError(f"method: expected one of {', '.join(METHODS)}, got {method!r}")
    images = _check_input(mesh, images_rgbd, camera_trajectory, intrinsic)
    results: list[ColorMapResult] = []

    def optimize() -> Arrays:
        report = ignore_progress if kept is None else kept.report
        search = _optimize(mesh, images, chosen, method, occlusion, report)
        results.append(_conclude(mesh, images, camera_trajectory, chosen, search))
        return {} if kept is None else results[0].to_arrays()

    stack: list[StackedImages] = []

    def read(path: Path) -> Arrays:
        stack.append(images.stacked(mesh.origin, chosen.image_boundary_margin))
        rows = 0 if method == "rigid" else chosen.number_of_vertical_anchors
        return ColorMapResult.read_arrays(path, mesh, stack[0], rows)

    arrays = optimize() if kept is None else kept.get(method, optimize, read)
    if results:
        return results[0]
    return ColorMapResult.from_arrays(arrays, mesh, stack[0], camera_trajectory)


def _optimize(
    mesh: TriangleMesh,
    images: PosedImages,
    option: ColorMapOption,
    method: str,
    occlusion: str | None,
    report: ReportProgress,
) -> ColorSearch:
    stack, sightings = _look(mesh, images, option, occlusion)
    vertices, iterations = mesh.arrays["vertices"], option.maximum_iteration
    if method == "rigid":
        search = ColorSearch(vertices, sightings, stack, Warps(stack.layout, 0, mesh.device), iterations)
        if mesh.device.is_cuda:
            loop_while(search.state.running, search.iterate_rigid)
        else:
            _iterate(search.iterate_rigid, lambda: bool(download(search.state.running)[0]), iterations, report)
        return search
    warps = Warps(stack.layout, option.number_of_vertical_anchors, mesh.device)
    search = WarpSearch(vertices, sightings, stack, warps, iterations, option.non_rigid_anchor_point_weight)
    _iterate(lambda: None, search.iterate, iterations, report)
    return search


def _iterate(step: Callable[[], object], goes_on: Callable[[], bool], maximum: int, report: ReportProgress) -> None:
    """Run a step and its test until it is False, with progress. The maximum is the total: the search may end before."""
    for done in itertools.count(1):
        step()
        if not goes_on():
            break
        report("colors", min(done, maximum), maximum)


def _check_input(mesh: TriangleMesh, images: object, trajectory: object, intrinsic: object) -> PosedImages:
    check_mesh("mesh", mesh)
    if not isinstance(trajectory, Trajectory):
        kind = type(trajectory).__name__
        raise TypeError(
            f"camera_trajectory: expected a Trajectory, got {kind}. Build one with Trajectory(poses), camera to world"
        )
    if not len(mesh.arrays["vertices"]):
        raise ValueError("mesh: expected vertices to color, got none")
    checked = check_images(NAMES, images, intrinsic, trajectory.poses, mesh.device)
    inverse = [inv(pose) for pose in checked.T_camera_world]
    return PosedImages(checked.colors, checked.depths, checked.cameras, np.array(inverse))


def _look(
    mesh: TriangleMesh, images: PosedImages, option: ColorMapOption, occlusion: str | None
) -> tuple[StackedImages, Sightings]:
    without = [i for i, depth in enumerate(images.depths) if depth is None]
    if occlusion is None:
        occlusion = "rays" if without else "depth"
    if occlusion not in OCCLUSIONS:
        raise ValueError(f"occlusion: expected one of {', '.join(OCCLUSIONS)}, got {occlusion!r}")
    if occlusion == "rays" and not len(mesh):
        raise ValueError("mesh: expected triangles for ray casting, got none. Pass images with depth instead")
    if occlusion == "depth" and without:
        raise ValueError(f"occlusion: images_rgbd[{without[0]}] has no depth. Use occlusion='rays'")
    stack = images.stacked(mesh.origin, option.image_boundary_margin)
    depths = _depths_by_rays(mesh, stack) if occlusion == "rays" else images.depths
    sightings = list_sightings(_masks(mesh, depths, stack, option))
    if not sightings.count:
        raise NothingSeenError(
            "images_rgbd: no image shows a vertex of the mesh. Check that the poses are camera to world, in the "
            f"frame of the mesh, and that it is within {option.maximum_allowable_depth:g} m (maximum_allowable_depth)"
        )
    return stack, sightings


def _masks(
    mesh: TriangleMesh, depths: Iterable[Any], stack: StackedImages, option: ColorMapOption
) -> Iterator[wp.array]:
    rule = DepthRule(
        option.maximum_allowable_depth,
        option.depth_threshold_for_visibility_check,
        option.depth_threshold_for_discontinuity_check,
        option.half_dilation_kernel_size_for_discontinuity_map,
    )
    for i, depth in enumerate(depths):
        yield mask_by_depth(mesh.arrays["vertices"], i, stack, depth, rule)


def _depths_by_rays(mesh: TriangleMesh, stack: StackedImages) -> Iterator[wp.array]:
    """Depth of the mesh in each image."""
    trees = plant_trees(mesh.arrays["vertices"], mesh.arrays["triangles"])
    for i in range(stack.count):
        yield render_depth(i, stack, trees)


def _conclude(
    mesh: TriangleMesh, images: PosedImages, given: Trajectory, option: ColorMapOption, search: ColorSearch
) -> ColorMapResult:
    colors, seen = average_colors(search.vertices, search.sightings, search.images, search.warps)
    _fill_unseen(mesh, colors, seen, option.invisible_vertex_color_knn)
    state = search.state
    downloaded = read_together([search.best_sums, state.error, state.iterations, search.images.poses, seen])  # sync
    sums, error, iterations, poses, is_seen = downloaded
    count = max(float(sums[:, COUNT_COLUMN].sum()), 1.0)
    return ColorMapResult(
        mesh.with_arrays(vertex_colors=colors),
        Trajectory(_world_poses(mesh, images, given, poses), given.timestamps, given.ids, given.crs),
        is_seen.astype(bool),
        search.sightings.counts.copy(),
        float(np.sqrt(error[0])),
        float(np.sqrt(sums[:, SQUARES_COLUMN].sum() / count)),
        int(iterations[0]) - 1,  # the first iteration evaluates the given poses
        search.images,
        search.warps,
    )


def _fill_unseen(mesh: TriangleMesh, colors: wp.array, seen: wp.array, neighbor_count: int) -> None:
    """Give unseen vertices the mean color of the nearest seen ones."""
    known = positions_of(seen)  # sync
    rows = positions_of(invert_mask(seen), seen.size - known.size)
    if not neighbor_count or not known.size or not rows.size:
        return
    vertices = mesh.arrays["vertices"]
    known_points = PointCloud.from_device_arrays({"points": gather_rows(vertices, known)}, mesh.origin)
    nearest = min(neighbor_count, known.size)
    neighbors, _, _ = search_nearest(known_points.search_tree(), gather_rows(vertices, rows), nearest)
    fill_colors(colors, rows, neighbors, known)


def _world_poses(
    mesh: TriangleMesh, images: PosedImages, given: Trajectory, poses: NDArray[Any]
) -> NDArray[np.float64]:
    """T_world_camera of each image. Unmoved poses stay bitwise equal."""
    start = images.T_camera_world.copy()
    start[:, :3, 3] += matmul(start[:, :3, :3], mesh.origin)
    result = given.poses.copy()
    for i, pose in enumerate(np.array(poses, np.float64)):
        if (pose != start[i]).any():
            result[i] = inv(pose)
            result[i, :3, 3] += mesh.origin
    return result
