"""Open3D 0.20's two odometries as they are, for conformance: equal weights or half a Huber loss, no convergence test.

A step is one reduction, read back and solved on the host in float64. What Open3D calls a success is kept; what it
raises or makes NaN of becomes a result that failed, with a reason.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.images import RGBDImage
from ...kernels.images.depth import intensity_of
from ...kernels.images.depth_filters import filter_bilateral, halve_color, halve_depth
from ...kernels.lang import mat44d, reduce, uint8, vec3
from ...kernels.linear_algebra import matmul, solve
from ...kernels.memory import download, empty
from ...kernels.rgbd import open3d_images as images
from ...kernels.rgbd import open3d_rows as rows
from .options import Method, OdometryConvergenceCriteria, OdometryLossParams, OdometryOption
from .results import OdometryResult, spread_information

DEPTH_SHARE = 0.968  # of the legacy hybrid term
HALF_ROOT = 0.707  # of the tensor one, in its digits


def run_legacy(
    source: RGBDImage,
    target: RGBDImage,
    intrinsic: PinholeCameraIntrinsic,
    start: NDArray[np.float64],
    with_depth: bool,
    option: OdometryOption,
) -> OdometryResult:
    """Open3D's `compute_rgbd_odometry`."""
    width, height = intrinsic.width, intrinsic.height
    lens = np.array([intrinsic.fx, intrinsic.fy, intrinsic.cx, intrinsic.cy])
    depths, shades = [], []
    for image in (source, target):
        marked = images.mark_missing(image.depth_array, option.depth_min, option.depth_max)
        depths.append(images.smooth(marked, width, height))
        grey = intensity_of(image.color_array) if image.color_array.dtype == uint8 else image.color_array
        shades.append(images.smooth(grey, width, height))
    paired = rows.Open3DRules(rows.LEGACY, rows.PAIRS, option.depth_diff_max)
    sums = _sum(depths[0], shades[0], _level((width, height), lens, depths[1], shades[1]), start, paired)
    if not sums[rows.COUNT]:
        return _failed(start, "no pixels pair up under the first pose")
    for k, total in enumerate(sums[[rows.SOURCE_SHADE, rows.TARGET_SHADE]]):
        shades[k] = images.scale(shades[k], 0.5 / (total / sums[rows.COUNT]))
    levels = []
    size, depth, shade, camera = (width, height), depths, shades, lens
    for _ in option.iteration_number_per_pyramid_level:
        levels.append((depth[0], shade[0], _level(size, camera, depth[1], shade[1], with_depth=with_depth)))
        shade = [images.halve(images.smooth(s, *size), *size) for s in shade]
        depth = [images.halve(d, *size) for d in depth]
        size, camera = (size[0] // 2, size[1] // 2), camera / 2
    method = rows.HYBRID if with_depth else rows.COLOR
    roots = {"depth_root": DEPTH_SHARE**0.5, "shade_root": (1 - DEPTH_SHARE) ** 0.5} if with_depth else {}
    rules = rows.Open3DRules(rows.LEGACY, method, option.depth_diff_max, **roots)
    pose, steps = start, 0
    for count, level in zip(option.iteration_number_per_pyramid_level, levels[::-1], strict=True):
        for _ in range(count):
            sums = _sum(level[0], level[1], level[2], pose, rules)
            step = _solve(sums)
            if step is None:
                return _failed(pose, "the pixels do not determine a step", steps)
            pose, steps = matmul(step, pose), steps + 1
    information, pixels = _information(depths[0], levels[0][2], pose, rows.LEGACY, option.depth_diff_max)
    inliers = int(information[5, 5])
    return OdometryResult(pose, information, inliers=inliers, fitness=inliers / max(pixels, 1), iterations=steps)


def run_tensor(
    source: RGBDImage,
    target: RGBDImage,
    intrinsic: PinholeCameraIntrinsic,
    start: NDArray[np.float64],
    depth_max: float,
    criteria: Sequence[OdometryConvergenceCriteria],
    method: Method,
    params: OdometryLossParams,
) -> OdometryResult:
    """Open3D's `rgbd_odometry_multi_scale`."""
    levels = _tensor_levels(source, target, intrinsic, depth_max, len(criteria), method, params)
    kind = {Method.Intensity: rows.COLOR, Method.Hybrid: rows.HYBRID, Method.PointToPlane: rows.PLANE}[method]
    root = HALF_ROOT if method is Method.Hybrid else 1.0
    deltas = (params.depth_huber_delta, params.intensity_huber_delta)
    rules = rows.Open3DRules(rows.TENSOR, kind, params.depth_outlier_trunc, *deltas, root, root)
    pose, steps, rmse, fitness = start, 0, 0.0, 1.0
    for criterion, level in zip(criteria, levels[::-1], strict=True):
        for _ in range(criterion.max_iteration):
            sums = _sum(level[0], level[1], level[2], pose, rules)
            count = sums[rows.COUNT]
            step = _solve(sums) if count else None
            if step is None:
                return _failed(pose, "the pixels do not determine a step", steps)
            pose, steps = matmul(step, pose), steps + 1
            new_rmse, new_fitness = sums[rows.SQUARES] / count, count / level[0].size
            settled = abs(fitness - new_fitness) < criterion.relative_fitness * fitness
            if settled and abs(rmse - new_rmse) < criterion.relative_rmse * rmse:
                break
            rmse, fitness = new_rmse, new_fitness
    depths = [images.mark_missing(image.depth_array, 0.0, _below(depth_max)) for image in (source, target)]
    lens = np.array([intrinsic.fx, intrinsic.fy, intrinsic.cx, intrinsic.cy])
    target_level = _level((intrinsic.width, intrinsic.height), lens, depths[1], depths[1])
    information, _ = _information(depths[0], target_level, pose, rows.TENSOR, params.depth_outlier_trunc)
    return OdometryResult(
        pose, information, inliers=int(information[5, 5]), fitness=fitness, inlier_rmse=rmse, iterations=steps
    )


def measure_information(
    source: wp.array,
    target: wp.array,
    intrinsic: PinholeCameraIntrinsic,
    pose: NDArray[np.float64],
    reach: float,
    depth_max: float,
) -> NDArray[np.float64]:
    """Open3D's `compute_odometry_information_matrix` of depths on a device."""
    depths = [images.mark_missing(depth, 0.0, _below(depth_max)) for depth in (source, target)]
    lens = np.array([intrinsic.fx, intrinsic.fy, intrinsic.cx, intrinsic.cy])
    level = _level((intrinsic.width, intrinsic.height), lens, depths[1], depths[1])
    return _information(depths[0], level, pose, rows.TENSOR, reach)[0]


# ---------------------------------------------------------------------------------------------- internals


def _below(depth_max: float) -> float:
    with np.errstate(over="ignore"):  # a limit beyond float32 is none
        limit = np.float32(depth_max)
    return float(np.nextafter(limit, np.float32(0)))  # the tensor form's limit is excluded


def _tensor_levels(
    source: RGBDImage,
    target: RGBDImage,
    intrinsic: PinholeCameraIntrinsic,
    depth_max: float,
    count: int,
    method: Method,
    params: OdometryLossParams,
) -> list[Any]:
    width, height = intrinsic.width, intrinsic.height
    camera = np.array([intrinsic.fx, intrinsic.fy, intrinsic.cx, intrinsic.cy])
    filled = [image.depth_array for image in (source, target)]
    with_color = method is not Method.PointToPlane
    shades = [_grey(image) if with_color else image.depth_array for image in (source, target)]
    levels, size, limit = [], (width, height), _below(depth_max)
    for _ in range(count):
        marked = [images.mark_missing(depth, 0.0, limit) for depth in filled]
        level = _level(size, camera, marked[1], shades[1], with_depth=method is Method.Hybrid)
        if method is Method.PointToPlane:
            smoothed = filter_bilateral(images.fill_missing(marked[1]), *size, 2, 5.0, 10.0)
            smoothed = images.spread_holes(marked[1], smoothed, *size)
            level.normals = images.short_normals(smoothed, *size, camera)
        levels.append((marked[0], shades[0], level))
        kept = [images.fill_missing(depth) for depth in marked]
        filled = [halve_depth(depth, *size, 2 * params.depth_outlier_trunc) for depth in kept]
        shades = [halve_color(shade, *size) for shade in shades] if with_color else filled
        size, camera = (size[0] // 2, size[1] // 2), camera / 2
    return levels


def _grey(image: RGBDImage) -> wp.array:
    """Brightness in whole steps of 1 / 255, as Open3D's tensor images have it."""
    grey = intensity_of(image.color_array) if image.color_array.dtype == uint8 else image.color_array
    return images.round_shades(grey)


def _level(
    size: tuple[int, int], lens: NDArray[np.float64], depth: wp.array, shade: wp.array, *, with_depth: bool = False
) -> rows.Open3DLevel:
    slopes = images.slopes(shade, *size)
    depth_slopes = images.slopes(depth, *size) if with_depth else slopes
    return rows.Open3DLevel(
        size, [float(x) for x in lens], depth, shade, slopes, depth_slopes, empty(0, vec3, depth.device)
    )


def _sum(
    depth: wp.array, shade: wp.array, level: rows.Open3DLevel, pose: NDArray[np.float64], rules: rows.Open3DRules
) -> NDArray[np.float64]:
    arguments = [depth, shade, level, mat44d(*pose.ravel()), rules]
    return download(reduce(rows.sum_open3d_rows, depth.size, arguments))[0]  # sync


def _solve(sums: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """The step of the sums as Rz Ry Rx and a translation; None where there is none."""
    h = np.zeros((6, 6))
    h[np.triu_indices(6)] = sums[:21]
    h = h + np.triu(h, 1).T
    try:
        x = solve(h, -sums[21:27])
    except np.linalg.LinAlgError:
        return None
    if not np.isfinite(x).all() or abs(np.linalg.det(h)) < 1e-6:
        return None
    (sa, sb, sc), (ca, cb, cc) = np.sin(x[:3]), np.cos(x[:3])
    step = np.eye(4)
    step[:3, :3] = [
        [cc * cb, cc * sb * sa - sc * ca, cc * sb * ca + sc * sa],
        [sc * cb, sc * sb * sa + cc * ca, sc * sb * ca - cc * sa],
        [-sb, cb * sa, cb * ca],
    ]
    step[:3, 3] = x[3:]
    return step


def _information(
    depth: wp.array, level: rows.Open3DLevel, pose: NDArray[np.float64], form: int, reach: float
) -> tuple[NDArray[np.float64], int]:
    """The information of the pairs, and how many pixels of the source have depth."""
    arguments = [depth, level, mat44d(*pose.ravel()), form, float(reach)]
    sums = download(reduce(rows.sum_open3d_information, depth.size, arguments))[0]  # sync
    return spread_information(sums[0], sums[1:10]), int(sums[10])


def _failed(pose: NDArray[np.float64], reason: str, steps: int = 0) -> OdometryResult:
    return OdometryResult(pose, np.zeros((6, 6)), (reason,), iterations=steps)
