"""Open3D's two odometries under its names, with a verdict that it does not have."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.images import RGBDImage, upload_depth
from ...core.checks import check_finite, check_list, check_positive, check_rigid, check_shape
from ...core.errors import DeviceError
from ...core.gpu_arrays import device_for
from ...core.told_arguments import told_arguments
from ...core.watching import report
from .alignment import align_steps
from .frames import OdometryFrame
from .open3d_weights import measure_information, run_legacy, run_tensor
from .options import (
    MOST_LEVELS,
    Method,
    OdometryConvergenceCriteria,
    OdometryLossParams,
    OdometryOption,
    RGBDOdometryJacobianFromColorTerm,
    RGBDOdometryJacobianFromHybridTerm,
)
from .results import OdometryResult

WEIGHTS = ("robust", "open3d")
WIDEST = 20.0  # sides of a picture to a focal length: 168 degrees
Jacobian = RGBDOdometryJacobianFromColorTerm | RGBDOdometryJacobianFromHybridTerm


@told_arguments
def compute_rgbd_odometry(
    source: RGBDImage,
    target: RGBDImage,
    pinhole_camera_intrinsic: PinholeCameraIntrinsic | ArrayLike,
    odo_init: ArrayLike | None = None,
    jacobian: Jacobian | None = None,
    option: OdometryOption | None = None,
    *,
    weights: str = "robust",
) -> OdometryResult:
    """The motion between two RGB-D images of one camera.

    Args:
        source: The image that is moved.
        target: The image that stays.
        pinhole_camera_intrinsic: The camera of both, or its matrix [3, 3].
        odo_init: Where to begin, T_target_source, 4x4; None: the identity.
        jacobian: Brightness alone or with surfaces; None: RGBDOdometryJacobianFromHybridTerm().
        option: None: OdometryOption().
        weights: "robust" weighs each pixel by the noise of the frames, as `align_frames`, and judges the result;
            "open3d" does what Open3D 0.20 does, without a verdict.

    Returns:
        The result, which unpacks as Open3D's (reliable, transformation, information).

    Raises:
        ValueError: Images of different sizes, a camera of another size, a start that is no rigid motion.
        TypeError: An argument of another kind.
        DeviceError: Images on different devices.

    Notes:
        The same bits from run to run, for any number of threads. `OdometryFrame` saves preparing an image twice.
        Park, Zhou and Koltun 2017; Steinbruecker, Sturm and Cremers 2011.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> blank = loom.RGBDImage(np.zeros((48, 64), np.uint8), np.zeros((48, 64), np.uint16))
        >>> reliable, transformation, information = loom.odometry.compute_rgbd_odometry(blank, blank, camera)
        >>> reliable, information.any()
        (False, np.False_)
    """
    camera = _check_pair("pinhole_camera_intrinsic", source, target, pinhole_camera_intrinsic)
    start = _check_start("odo_init", odo_init)
    term = RGBDOdometryJacobianFromHybridTerm() if jacobian is None else jacobian
    if not isinstance(term, Jacobian):
        raise TypeError(f"jacobian: expected a RGBDOdometryJacobianFrom...Term, got {type(term).__name__}")
    chosen = OdometryOption() if option is None else option
    if not isinstance(chosen, OdometryOption):
        raise TypeError(f"option: expected an OdometryOption, got {type(chosen).__name__}")
    with_depth = isinstance(term, RGBDOdometryJacobianFromHybridTerm)
    if _check_weights(weights) == "open3d":
        _check_levels(camera, len(chosen.iteration_number_per_pyramid_level))
        return _told(run_legacy(source, target, camera, start, with_depth, chosen), source, target, camera)
    frames = [OdometryFrame.from_image(image, camera, chosen.depth_min, chosen.depth_max) for image in (source, target)]
    method = Method.Hybrid if with_depth else Method.Intensity
    found = align_steps(frames[0], frames[1], start, method, chosen.iteration_number_per_pyramid_level)
    return _told(found, source, target, camera)


def rgbd_odometry_multi_scale(
    source: RGBDImage,
    target: RGBDImage,
    intrinsics: PinholeCameraIntrinsic | ArrayLike,
    init_source_to_target: ArrayLike | None = None,
    depth_scale: float = 1000.0,
    depth_max: float = 3.0,
    criteria_list: Sequence[OdometryConvergenceCriteria] | None = None,
    method: Method = Method.Hybrid,
    params: OdometryLossParams | None = None,
    *,
    weights: str = "robust",
) -> OdometryResult:
    """The motion between two RGB-D images of one camera, by one of three methods.

    Args:
        source: The image that is moved.
        target: The image that stays.
        intrinsics: The camera of both, or its matrix [3, 3].
        init_source_to_target: Where to begin, 4x4; None: the identity.
        depth_scale: As Open3D has it; an RGBDImage is in metres, so nothing is divided by it.
        depth_max: Depths from there on are no measurement [m].
        criteria_list: One for each level, the coarsest first; None: 10, 5 and 3 steps.
        method: Surfaces, brightness, or both.
        params: None: OdometryLossParams().
        weights: As in `compute_rgbd_odometry`.

    Returns:
        The result. With "open3d" its `inlier_rmse` is Open3D's, the mean Huber loss.

    Raises:
        ValueError, TypeError, DeviceError: As `compute_rgbd_odometry`.

    Notes:
        Where Open3D raises ("Singular 6x6", "Invalid inlier_count"), the result says that it failed, and why.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.rgbd.odometry.rgbd_odometry import rgbd_odometry_multi_scale
        >>> blank = loom.RGBDImage(np.zeros((48, 64), np.uint8), np.zeros((48, 64), np.uint16))
        >>> K = [[60.0, 0, 31.5], [0, 60.0, 23.5], [0, 0, 1]]
        >>> rgbd_odometry_multi_scale(blank, blank, K).warnings[0]
        'the source has no depth'
    """
    camera = _check_pair("intrinsics", source, target, intrinsics)
    start = _check_start("init_source_to_target", init_source_to_target)
    check_positive("depth_scale", depth_scale)
    farthest, told = check_positive("depth_max", depth_max), (source, target, camera)
    criteria = _check_criteria(criteria_list)
    if not isinstance(method, Method):
        raise TypeError(f"method: expected a loom.odometry.Method, got {type(method).__name__}")
    limits = OdometryLossParams() if params is None else params
    if not isinstance(limits, OdometryLossParams):
        raise TypeError(f"params: expected an OdometryLossParams, got {type(limits).__name__}")
    if _check_weights(weights) == "open3d":
        _check_levels(camera, len(criteria))
        return _told(run_tensor(source, target, camera, start, farthest, criteria, method, limits), *told)
    frames = [OdometryFrame.from_image(image, camera, 0.0, farthest) for image in (source, target)]
    return _told(align_steps(frames[0], frames[1], start, method, [c.max_iteration for c in criteria]), *told)


def compute_odometry_information_matrix(
    source_depth: ArrayLike,
    target_depth: ArrayLike,
    intrinsic: PinholeCameraIntrinsic | ArrayLike,
    source_to_target: ArrayLike,
    dist_threshold: float,
    depth_scale: float | None = None,
    depth_max: float = 3.0,
) -> NDArray[np.float64]:
    """The information of the pixels of two depth images that lie on each other, for a pose graph.

    Args:
        source_depth, target_depth: Shape [h, w]; integers of 16 bits and more, or floats.
        intrinsic: The camera of both, or its matrix [3, 3].
        source_to_target: Their pose, 4x4.
        dist_threshold: Points farther apart do not count [m].
        depth_scale: Units of depth a metre; None for 1000 of integers and 1 of floats.
        depth_max: Depths from there on are no measurement [m].

    Returns:
        Sum of G^T G, G = [-[q]x, I], over the target points q, float64 [6, 6], rotation first; zero without any.

    Raises:
        ValueError, TypeError: Wrong shapes or numbers.

    Notes:
        Choi, Zhou and Koltun 2015, "Robust reconstruction of indoor scenes". Sums in float64 in a fixed order.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.rgbd.odometry.rgbd_odometry import compute_odometry_information_matrix
        >>> depth, K = np.full((48, 64), 1.0), [[60.0, 0, 31.5], [0, 60.0, 23.5], [0, 0, 1]]
        >>> float(compute_odometry_information_matrix(depth, depth, K, np.eye(4), 0.07)[5, 5])
        3072.0
    """
    reach, farthest = check_positive("dist_threshold", dist_threshold), check_positive("depth_max", depth_max)
    device = device_for(source_depth, None)
    first, height, width = _upload("source_depth", source_depth, depth_scale, device)
    second, *size = _upload("target_depth", target_depth, depth_scale, device)
    if size != [height, width]:
        have = f"{size[1]} x {size[0]}"
        raise ValueError(f"target_depth: {have} pixels, but the source has {width} x {height}; resize one of them")
    camera = _check_camera("intrinsic", intrinsic, width, height)
    pose = check_rigid("source_to_target", source_to_target)
    return measure_information(first, second, camera, pose, reach, farthest)


# ---------------------------------------------------------------------------------------------- internals


def _told(result: OdometryResult, source: RGBDImage, target: RGBDImage, camera: Any) -> OdometryResult:
    """The result, once those who watch know of it."""
    report("rgbd_odometry", source=source, target=target, intrinsic=camera, result=result)
    return result


def _check_images(source: RGBDImage, target: RGBDImage) -> None:
    for name, image in (("source", source), ("target", target)):
        if not isinstance(image, RGBDImage):
            raise TypeError(f"{name}: expected an RGBDImage, got {type(image).__name__}; align_frames takes frames")
    if (source.width, source.height) != (target.width, target.height):
        sizes = [f"{image.width} x {image.height}" for image in (source, target)]
        raise ValueError(f"target: {sizes[1]} pixels, but the source has {sizes[0]}; resize one of them")
    if source.device != target.device:
        raise DeviceError(f"source lies on {source.device}, target on {target.device}; make both on one device")


def _check_pair(name: str, source: RGBDImage, target: RGBDImage, intrinsic: Any) -> PinholeCameraIntrinsic:
    _check_images(source, target)
    return _check_camera(name, intrinsic, source.width, source.height)


def _check_camera(name: str, camera: Any, width: int, height: int) -> PinholeCameraIntrinsic:
    """The camera of pictures of a size, given as one or as its matrix."""
    if not isinstance(camera, PinholeCameraIntrinsic):
        matrix = check_finite(name, check_shape(name, camera, (3, 3)))
        try:
            found = PinholeCameraIntrinsic.from_matrix(matrix, width, height)
        except ValueError as error:
            raise ValueError(f"{name}: {error}") from None
        if found.fx * WIDEST < width or found.fy * WIDEST < height:
            raise ValueError(
                f"{name}: focal lengths of {found.fx:g} and {found.fy:g} px see nearly a half-space in {width} x "
                f"{height} pixels: no camera's matrix; expected fx and fy in pixels, or a PinholeCameraIntrinsic"
            )
        return found
    if (camera.width, camera.height) != (width, height):
        made = f"{camera.width} x {camera.height}"
        raise ValueError(f"{name}: made for {made} pixels, but the images have {width} x {height}")
    return camera


def _upload(name: str, depth: ArrayLike, depth_scale: float | None, device: Any) -> tuple[Any, int, int]:
    """A depth image on a device; errors call it by its own name."""
    try:
        metric, _, height, width = upload_depth(depth, depth_scale, np.inf, device)
    except (ValueError, TypeError) as error:
        if str(error).startswith("depth:"):
            raise type(error)(name + str(error).removeprefix("depth")) from None
        raise
    return metric, height, width


def _check_start(name: str, pose: ArrayLike | None) -> NDArray[np.float64]:
    return np.eye(4) if pose is None else check_rigid(name, pose)


def _check_weights(weights: str) -> str:
    if not isinstance(weights, str) or weights not in WEIGHTS:
        raise ValueError(f"weights: expected 'robust' or 'open3d', got {weights!r}")
    return weights


def _check_levels(camera: PinholeCameraIntrinsic, count: int) -> None:
    if min(camera.width, camera.height) >> (count - 1) < 1:
        size = f"{camera.width} x {camera.height}"
        raise ValueError(f"option: {count} levels, but pictures of {size} pixels cannot be halved so often")


def _check_criteria(criteria: Sequence[OdometryConvergenceCriteria] | None) -> list[OdometryConvergenceCriteria]:
    if criteria is None:
        return [OdometryConvergenceCriteria(steps) for steps in (10, 5, 3)]
    listed = check_list("criteria_list", criteria, "OdometryConvergenceCriteria")
    for given in listed:
        if not isinstance(given, OdometryConvergenceCriteria):
            raise TypeError(f"criteria_list: expected OdometryConvergenceCriteria, got {type(given).__name__}")
    if not 1 <= len(listed) <= MOST_LEVELS:
        raise ValueError(f"criteria_list: expected 1 to {MOST_LEVELS} levels, got {len(listed)}")
    return listed
