"""RGB-D odometry of two images: with reliability checks, and as in Open3D.

The functions `open3d_...` reproduce Open3D 0.20: equal weights or half a Huber loss, no convergence test. Steps are
solved on the host in float64. Where Open3D raises or returns NaN, their result is unreliable.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.depth_range import DEPTH_MAX, OPEN3D_DEPTH_MAX
from ...cameras.images import RGBDImage, check_intrinsic, upload_depth
from ...core.argument_errors import explain_argument_errors
from ...core.checks import check_list, check_positive, check_rigid
from ...core.devices import DeviceLike
from ...core.errors import DeviceError
from ...core.gpu_arrays import device_for
from ...core.observers import report
from ...kernels.images.depth import intensity_of
from ...kernels.images.depth_filters import filter_bilateral, halve_color, halve_depth
from ...kernels.lang import mat44d, reduce, uint8, vec3
from ...kernels.linear_algebra import matmul, solve
from ...kernels.memory import download, empty
from ...kernels.rgbd import open3d_images as images
from ...kernels.rgbd import open3d_rows as rows
from .alignment import align_steps
from .frames import OdometryFrame
from .options import (
    MAX_LEVELS,
    OdometryConvergenceCriteria,
    OdometryLossParams,
    OdometryMethod,
    OdometryOption,
    RGBDOdometryJacobianFromColorTerm,
    RGBDOdometryJacobianFromHybridTerm,
    check_depth_range,
    check_method,
    check_steps,
)
from .results import OdometryResult, spread_information

Jacobian = RGBDOdometryJacobianFromColorTerm | RGBDOdometryJacobianFromHybridTerm


@explain_argument_errors
def compute_rgbd_odometry(
    source: RGBDImage,
    target: RGBDImage,
    pinhole_camera_intrinsic: PinholeCameraIntrinsic | ArrayLike,
    odo_init: ArrayLike | None = None,
    *,
    method: str = "hybrid",
    max_iterations: Sequence[int] = OdometryOption.iteration_number_per_pyramid_level,
    depth_min: float = 0.0,
    depth_max: float = DEPTH_MAX,
) -> OdometryResult:
    """Estimate the motion between two RGB-D images of one camera.

    Args:
        source: The image to move.
        target: The fixed image.
        pinhole_camera_intrinsic: The camera of both, or its matrix [3, 3].
        odo_init: Initial T_target_source, 4x4; None: the identity.
        method: As of `align_frames`.
        max_iterations: Maximum steps per pyramid level, the coarsest first. Further levels repeat the first number.
        depth_min, depth_max: Valid depth range [m].

    Returns:
        The result, which unpacks as Open3D's (reliable, transformation, information).

    Raises:
        ValueError: Different image sizes, a camera of another size, or an initial pose that is not rigid.
        TypeError: An argument has another type.
        DeviceError: Images on different devices.

    Notes:
        Bitwise reproducible for any number of threads. `OdometryFrame` avoids preparing an image twice.
        `pointloom.open3d` has the function with the weights of Open3D and without reliability checks.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> blank = loom.RGBDImage(np.zeros((48, 64), np.uint8), np.zeros((48, 64), np.uint16))
        >>> reliable, transformation, information = loom.rgbd.compute_rgbd_odometry(blank, blank, camera)
        >>> reliable, information.any()
        (False, np.False_)
    """
    camera = _check_pair("pinhole_camera_intrinsic", source, target, pinhole_camera_intrinsic)
    start, residuals = _check_start("odo_init", odo_init), check_method(method)
    steps = check_steps("max_iterations", max_iterations)
    nearest, farthest = check_depth_range(depth_min, depth_max)
    frames = [OdometryFrame.from_image(image, camera, nearest, farthest) for image in (source, target)]
    return _reported(align_steps(frames[0], frames[1], start, residuals, steps), source, target, camera)


def open3d_odometry(
    source: RGBDImage,
    target: RGBDImage,
    pinhole_camera_intrinsic: PinholeCameraIntrinsic,
    odo_init: ArrayLike,
    jacobian: Jacobian,
    option: OdometryOption,
) -> OdometryResult:
    """Open3D's `compute_rgbd_odometry`, without the check of reliability. `inlier_rmse` is 0."""
    camera = _check_pair("pinhole_camera_intrinsic", source, target, pinhole_camera_intrinsic)
    start = _check_start("odo_init", odo_init)
    if not isinstance(jacobian, Jacobian):
        raise TypeError(f"jacobian: expected a RGBDOdometryJacobianFrom...Term, got {type(jacobian).__name__}")
    if not isinstance(option, OdometryOption):
        raise TypeError(f"option: expected an OdometryOption, got {type(option).__name__}")
    _check_levels(camera, len(option.iteration_number_per_pyramid_level))
    with_depth = isinstance(jacobian, RGBDOdometryJacobianFromHybridTerm)
    return _reported(run_legacy(source, target, camera, start, with_depth, option), source, target, camera)


def open3d_multi_scale_odometry(
    source: RGBDImage,
    target: RGBDImage,
    intrinsics: PinholeCameraIntrinsic | ArrayLike,
    init_source_to_target: ArrayLike,
    depth_max: float,
    criteria_list: Sequence[OdometryConvergenceCriteria] | None,
    method: OdometryMethod,
    params: OdometryLossParams | None,
) -> OdometryResult:
    """Open3D's `rgbd_odometry_multi_scale`, without the check of reliability.

    `inlier_rmse` is the mean Huber loss. Where Open3D raises ("Singular 6x6", "Invalid inlier_count"), the result is
    failed, with the reason.
    """
    camera = _check_pair("intrinsics", source, target, intrinsics)
    start = _check_start("init_source_to_target", init_source_to_target)
    farthest, criteria = check_positive("depth_max", depth_max), _check_criteria(criteria_list)
    if not isinstance(method, OdometryMethod):
        raise TypeError(f"method: expected one of {', '.join(map(str, OdometryMethod))}, got {type(method).__name__}")
    limits = OdometryLossParams() if params is None else params
    if not isinstance(limits, OdometryLossParams):
        raise TypeError(f"params: expected an OdometryLossParams, got {type(limits).__name__}")
    _check_levels(camera, len(criteria))
    result = run_tensor(source, target, camera, start, farthest, criteria, method, limits)
    return _reported(result, source, target, camera)


def compute_odometry_information_matrix(
    source_depth: ArrayLike,
    target_depth: ArrayLike,
    intrinsic: PinholeCameraIntrinsic | ArrayLike,
    source_to_target: ArrayLike,
    dist_threshold: float,
    depth_scale: float | None = None,
    depth_max: float = OPEN3D_DEPTH_MAX,
) -> NDArray[np.float64]:
    """Compute the information matrix of the matching pixels of two depth images, for a pose graph.

    Args:
        source_depth, target_depth: Shape [h, w]. Integers of 16 bits and more, or floats.
        intrinsic: The camera of both, or its matrix [3, 3].
        source_to_target: Relative pose, 4x4.
        dist_threshold: Maximum point distance [m].
        depth_scale: Depth units per meter; None: 1000 for integers and 1 for floats.
        depth_max: Exclusive maximum depth [m].

    Returns:
        Sum of G^T G, G = [-[q]x, I], over the target points q, float64 [6, 6], rotation first. Zero without any.

    Raises:
        ValueError, TypeError: Wrong shapes or numbers.

    Notes:
        Choi, Zhou and Koltun, "Robust reconstruction of indoor scenes", CVPR 2015. Float64 sums in a fixed order.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.rgbd.odometry.rgbd_odometry import compute_odometry_information_matrix
        >>> depth, K = np.full((48, 64), 1.0), [[60.0, 0, 31.5], [0, 60.0, 23.5], [0, 0, 1]]
        >>> float(compute_odometry_information_matrix(depth, depth, K, np.eye(4), 0.07)[5, 5])
        3072.0
    """
    max_distance, farthest = check_positive("dist_threshold", dist_threshold), check_positive("depth_max", depth_max)
    device = device_for(source_depth, None)
    first, height, width = _upload("source_depth", source_depth, depth_scale, device)
    second, *size = _upload("target_depth", target_depth, depth_scale, device)
    if size != [height, width]:
        have = f"{size[1]} x {size[0]}"
        raise ValueError(
            f"target_depth: expected {width} x {height} pixels as the source, got {have}; resize one of them"
        )
    camera = check_intrinsic(intrinsic, width, height)
    pose = check_rigid("source_to_target", source_to_target)
    return measure_information(first, second, camera, pose, max_distance, farthest)


def _reported(
    result: OdometryResult, source: RGBDImage, target: RGBDImage, camera: PinholeCameraIntrinsic
) -> OdometryResult:
    report("rgbd_odometry", source=source, target=target, intrinsic=camera, result=result)
    return result


def _check_images(source: RGBDImage, target: RGBDImage) -> None:
    for name, image in (("source", source), ("target", target)):
        if not isinstance(image, RGBDImage):
            raise TypeError(f"{name}: expected an RGBDImage, got {type(image).__name__}; use align_frames for frames")
    if (source.width, source.height) != (target.width, target.height):
        sizes = [f"{image.width} x {image.height}" for image in (source, target)]
        raise ValueError(f"target: expected {sizes[0]} pixels as the source, got {sizes[1]}; resize one of them")
    if source.device != target.device:
        raise DeviceError(
            f"target: expected the device of the source, {source.device}, got {target.device}; use one device"
        )


def _check_pair(name: str, source: RGBDImage, target: RGBDImage, intrinsic: object) -> PinholeCameraIntrinsic:
    _check_images(source, target)
    return check_intrinsic(intrinsic, source.width, source.height, name)


def _upload(name: str, depth: ArrayLike, depth_scale: float | None, device: DeviceLike) -> tuple[Any, int, int]:
    try:
        metric, _, height, width = upload_depth(depth, depth_scale, np.inf, device)
    except (ValueError, TypeError) as error:
        if str(error).startswith("depth:"):
            raise type(error)(name + str(error).removeprefix("depth")) from None
        raise
    return metric, height, width


def _check_start(name: str, pose: ArrayLike | None) -> NDArray[np.float64]:
    return np.eye(4) if pose is None else check_rigid(name, pose)


def _check_levels(camera: PinholeCameraIntrinsic, count: int) -> None:
    if min(camera.width, camera.height) >> (count - 1) < 1:
        size = f"{camera.width} x {camera.height}"
        raise ValueError(f"option: expected fewer pyramid levels for images of {size} pixels, got {count}")


def _check_criteria(criteria: Sequence[OdometryConvergenceCriteria] | None) -> list[OdometryConvergenceCriteria]:
    if criteria is None:
        return [OdometryConvergenceCriteria(steps) for steps in (10, 5, 3)]
    listed = check_list("criteria_list", criteria, "OdometryConvergenceCriteria")
    for given in listed:
        if not isinstance(given, OdometryConvergenceCriteria):
            raise TypeError(f"criteria_list: expected OdometryConvergenceCriteria, got {type(given).__name__}")
    if not 1 <= len(listed) <= MAX_LEVELS:
        raise ValueError(f"criteria_list: expected 1 to {MAX_LEVELS} levels, got {len(listed)}")
    return listed


DEPTH_FRACTION = 0.968  # in the legacy hybrid term
HALF_ROOT = 0.707  # in the tensor hybrid term, with its digits


def run_legacy(
    source: RGBDImage,
    target: RGBDImage,
    intrinsic: PinholeCameraIntrinsic,
    start: NDArray[np.float64],
    with_depth: bool,
    option: OdometryOption,
) -> OdometryResult:
    width, height = intrinsic.width, intrinsic.height
    lens = np.array([intrinsic.fx, intrinsic.fy, intrinsic.cx, intrinsic.cy])
    depths, shades = [], []
    for image in (source, target):
        marked = images.mark_missing(image.depth_array, option.depth_min, option.depth_max)
        depths.append(images.smooth(marked, width, height))
        gray = intensity_of(image.color_array) if image.color_array.dtype == uint8 else image.color_array
        shades.append(images.smooth(gray, width, height))
    paired = rows.Open3DRules(rows.LEGACY_FORM, rows.PAIRS_ONLY, option.depth_diff_max)
    sums = _sum(depths[0], shades[0], _level((width, height), lens, depths[1], shades[1]), start, paired)
    if not sums[rows.PAIR_COUNT_AT]:
        return _failed(start, "no pixels correspond at the initial pose")
    for k, total in enumerate(sums[[rows.SOURCE_SHADE_AT, rows.TARGET_SHADE_AT]]):
        shades[k] = images.scale(shades[k], 0.5 / (total / sums[rows.PAIR_COUNT_AT]))
    levels = []
    size, depth, shade, camera = (width, height), depths, shades, lens
    for _ in option.iteration_number_per_pyramid_level:
        levels.append((depth[0], shade[0], _level(size, camera, depth[1], shade[1], with_depth=with_depth)))
        shade = [images.halve(images.smooth(s, *size), *size) for s in shade]
        depth = [images.halve(d, *size) for d in depth]
        size, camera = (size[0] // 2, size[1] // 2), camera / 2
    method = rows.HYBRID_TERM if with_depth else rows.COLOR_TERM
    roots = {"depth_root": DEPTH_FRACTION**0.5, "shade_root": (1 - DEPTH_FRACTION) ** 0.5} if with_depth else {}
    rules = rows.Open3DRules(rows.LEGACY_FORM, method, option.depth_diff_max, **roots)
    pose, steps = start, 0
    for count, level in zip(option.iteration_number_per_pyramid_level, levels[::-1], strict=True):
        for _ in range(count):
            sums = _sum(level[0], level[1], level[2], pose, rules)
            step = _solve(sums)
            if step is None:
                return _failed(pose, "the pixels do not determine the motion", steps)
            pose, steps = matmul(step, pose), steps + 1
    information, pixels = _information(depths[0], levels[0][2], pose, rows.LEGACY_FORM, option.depth_diff_max)
    inliers = int(information[5, 5])
    return OdometryResult(pose, information, inliers=inliers, fitness=inliers / max(pixels, 1), iterations=steps)


def run_tensor(
    source: RGBDImage,
    target: RGBDImage,
    intrinsic: PinholeCameraIntrinsic,
    start: NDArray[np.float64],
    depth_max: float,
    criteria: Sequence[OdometryConvergenceCriteria],
    method: OdometryMethod,
    params: OdometryLossParams,
) -> OdometryResult:
    levels = _tensor_levels(source, target, intrinsic, depth_max, len(criteria), method, params)
    kind = {
        OdometryMethod.Intensity: rows.COLOR_TERM,
        OdometryMethod.Hybrid: rows.HYBRID_TERM,
        OdometryMethod.PointToPlane: rows.PLANE_TERM,
    }[method]
    root = HALF_ROOT if method is OdometryMethod.Hybrid else 1.0
    deltas = (params.depth_huber_delta, params.intensity_huber_delta)
    rules = rows.Open3DRules(rows.TENSOR_FORM, kind, params.depth_outlier_trunc, *deltas, root, root)
    pose, steps, rmse, fitness = start, 0, 0.0, 1.0
    for criterion, level in zip(criteria, levels[::-1], strict=True):
        for _ in range(criterion.max_iteration):
            sums = _sum(level[0], level[1], level[2], pose, rules)
            count = sums[rows.PAIR_COUNT_AT]
            step = _solve(sums) if count else None
            if step is None:
                return _failed(pose, "the pixels do not determine the motion", steps)
            pose, steps = matmul(step, pose), steps + 1
            new_rmse, new_fitness = sums[rows.SQUARED_SUM_AT] / count, count / level[0].size
            has_converged = abs(fitness - new_fitness) < criterion.relative_fitness * fitness
            if has_converged and abs(rmse - new_rmse) < criterion.relative_rmse * rmse:
                break
            rmse, fitness = new_rmse, new_fitness
    depths = [images.mark_missing(image.depth_array, 0.0, _below(depth_max)) for image in (source, target)]
    lens = np.array([intrinsic.fx, intrinsic.fy, intrinsic.cx, intrinsic.cy])
    target_level = _level((intrinsic.width, intrinsic.height), lens, depths[1], depths[1])
    information, _ = _information(depths[0], target_level, pose, rows.TENSOR_FORM, params.depth_outlier_trunc)
    return OdometryResult(
        pose, information, inliers=int(information[5, 5]), fitness=fitness, inlier_rmse=rmse, iterations=steps
    )


def measure_information(
    source: wp.array,
    target: wp.array,
    intrinsic: PinholeCameraIntrinsic,
    pose: NDArray[np.float64],
    max_distance: float,
    depth_max: float,
) -> NDArray[np.float64]:
    """Open3D's `compute_odometry_information_matrix` on device arrays."""
    depths = [images.mark_missing(depth, 0.0, _below(depth_max)) for depth in (source, target)]
    lens = np.array([intrinsic.fx, intrinsic.fy, intrinsic.cx, intrinsic.cy])
    level = _level((intrinsic.width, intrinsic.height), lens, depths[1], depths[1])
    return _information(depths[0], level, pose, rows.TENSOR_FORM, max_distance)[0]


def _below(depth_max: float) -> float:
    with np.errstate(over="ignore"):  # limits beyond float32 are infinite
        limit = np.float32(depth_max)
    return float(np.nextafter(limit, np.float32(0)))  # the tensor form's limit is exclusive


def _tensor_levels(
    source: RGBDImage,
    target: RGBDImage,
    intrinsic: PinholeCameraIntrinsic,
    depth_max: float,
    count: int,
    method: OdometryMethod,
    params: OdometryLossParams,
) -> list[Any]:
    width, height = intrinsic.width, intrinsic.height
    camera = np.array([intrinsic.fx, intrinsic.fy, intrinsic.cx, intrinsic.cy])
    filled = [image.depth_array for image in (source, target)]
    with_color = method is not OdometryMethod.PointToPlane
    shades = [_gray(image) if with_color else image.depth_array for image in (source, target)]
    levels, size, limit = [], (width, height), _below(depth_max)
    for _ in range(count):
        marked = [images.mark_missing(depth, 0.0, limit) for depth in filled]
        level = _level(size, camera, marked[1], shades[1], with_depth=method is OdometryMethod.Hybrid)
        if method is OdometryMethod.PointToPlane:
            smoothed = filter_bilateral(images.fill_missing(marked[1]), *size, 2, 5.0, 10.0)
            smoothed = images.spread_holes(marked[1], smoothed, *size)
            level.normals = images.short_normals(smoothed, *size, camera)
        levels.append((marked[0], shades[0], level))
        depths = [images.fill_missing(depth) for depth in marked]
        filled = [halve_depth(depth, *size, 2 * params.depth_outlier_trunc) for depth in depths]
        shades = [halve_color(shade, *size) for shade in shades] if with_color else filled
        size, camera = (size[0] // 2, size[1] // 2), camera / 2
    return levels


def _gray(image: RGBDImage) -> wp.array:
    """Brightness in integer steps of 1 / 255, as in Open3D's tensor images."""
    gray = intensity_of(image.color_array) if image.color_array.dtype == uint8 else image.color_array
    return images.round_shades(gray)


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
    """The step as Rz Ry Rx and a translation. None if singular."""
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
    depth: wp.array, level: rows.Open3DLevel, pose: NDArray[np.float64], form: int, max_distance: float
) -> tuple[NDArray[np.float64], int]:
    arguments = [depth, level, mat44d(*pose.ravel()), form, float(max_distance)]
    sums = download(reduce(rows.sum_open3d_information, depth.size, arguments))[0]  # sync
    return spread_information(sums[0], sums[1:10]), int(sums[10])


def _failed(pose: NDArray[np.float64], reason: str, steps: int = 0) -> OdometryResult:
    return OdometryResult(pose, np.zeros((6, 6)), (reason,), iterations=steps)
