"""Check of given poses and camera: frames at wrong poses do not agree with the fused surface or with each other."""

from __future__ import annotations

import math
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.frame_check import FrameCheck
from ...core.reports import failed
from ...kernels.linear_algebra import matmul
from ...kernels.memory import download
from ...kernels.rgbd.stream_views import MIN_DEPTH_FRACTION
from ...meshing.volume.tsdf import TSDFVolume
from ..odometry.camera_fit import CameraView, ViewPairs, depth_factor
from ..odometry.posed_camera import PosedCameraFit, displacements_of_poses, fit_posed_camera, posed_pairs
from ..slam.camera_check import MIN_RESIDUAL_RATIO, FocalCheck, judge_posed_camera, undetermined_values

Pose = NDArray[np.float64]

MAX_FRAMES = 16  # sampled frames
# The frames n with the smallest fractions of n times this are spread evenly, at distances of Fibonacci numbers: some of
# them, and not all, have the errors of every second or every fourth pose.
GOLDEN_RATIO = 0.5 * (math.sqrt(5.0) - 1.0)
SAMPLED_WIDTH = 80  # [px] of the sampled depth maps
# Each n-th sampled pixel of each n-th row is compared with the surface: 1,200 rays of a frame. The standard error of a
# fraction of 0.15 is 0.010 in a frame, and 0.0032 in the median of 16 frames.
RAY_STEP = 2
AVERAGED_SIDE = 4  # pixels of a cell of the sampled inverse depth, per side
MIN_DEPTH = 1e-12  # [m] sums of larger inverses are finite in 32 bits
CAMERA_RANGE = 2.0  # farthest inverse depth in depth_max: depth in a unit that is too small is farther than that
RELATIVE_DEPTH_NOISE = 0.02  # relative depth noise
# Fraction of the depth off the surface, as the median over frames, and of single frames, of which MAX_OFF_FRAMES are
# accepted. Real recordings have medians of 0.01 to 0.11. Two frames are above 0.5 in none of 121 refined walks with a
# correct surface, and in 20 of 159 with a wrong one that no other check reports (2026-11-29).
MAX_OFF_SURFACE, MAX_OFF_OF_FRAME, MAX_OFF_FRAMES = 0.15, 0.5, 0.1
# ... of all frames, up to which poses are correct though they could not be refined: 0.02 in two walks through a tunnel,
# 0.11 and more in 72 of 73 with such poses and a wrong surface (2026-11-29).
MAX_OFF_UNREFINED = 0.05
# Displacement of the surface [m] by the error of a pair of poses, but at least a voxel, and accepted fraction of the
# pairs. Pairs of right poses of the kitchen are never above, with 20 mm of noise 0.26 and less are. Every second pose
# rotated by 5 degrees displaces 0.51 to 0.75 of the pairs, less where a floor is nearly all (sites of seeds 330 to 333,
# on which both were chosen, 2026-11-30).
MAX_DISPLACEMENT, MAX_DISPLACED = 0.03, 1.0 / 3.0


class _Sample(NamedTuple):
    """Depth [any unit] of one pixel of each cell, mean inverse depth [1/m] of cells, the pose and the unrefined one."""

    depth: NDArray[Any]
    nearness: NDArray[np.float32]
    T_world_camera: Pose
    given: Pose


def _order(number: int) -> float:
    return number * GOLDEN_RATIO % 1.0


class PoseCheck:
    """Keeps a few small depth maps of a stream, and compares them with the surface.

    Args:
        intrinsic, depth_unit: The camera, and integer depth units per meter.
        depth_max: Maximum depth [m].
        frame_count: Expected number of frames; 0: unknown. Others are not sampled then.

    Attributes:
        images: The FrameCheck of depth and color.
    """

    def __init__(self, intrinsic: PinholeCameraIntrinsic, depth_unit: float, depth_max: float, frame_count: int = 0):
        self._unit, self.depth_max, self._intrinsic = depth_unit, depth_max, intrinsic
        self._step = max(1, intrinsic.width // SAMPLED_WIDTH)
        self._samples: dict[int, _Sample] = {}  # by the numbers of the frames, in their order
        self._count = 0
        self._last_order = sorted(map(_order, range(frame_count)))[MAX_FRAMES - 1] if frame_count > MAX_FRAMES else 1.0
        self.images = FrameCheck(intrinsic, depth_unit)

    def add(self, depth: ArrayLike, color: ArrayLike | None, T_world_camera: Pose, given: Pose) -> None:
        self.images.add(depth, color)
        number, self._count = self._count, self._count + 1
        if _order(number) > self._last_order:
            return
        if len(self._samples) == MAX_FRAMES:
            last = max(self._samples, key=_order)
            if _order(last) < _order(number):
                return
            del self._samples[last]
        image = np.asarray(depth)
        small = np.array(image[:: self._step, :: self._step])
        self._samples[number] = _Sample(small, self._mean_nearness(image), T_world_camera, given)

    @property
    def _offsets(self) -> range:
        """Rows and columns of the averaged pixels of a cell."""
        return range(0, self._step, -(-self._step // AVERAGED_SIDE))

    def _mean_nearness(self, depth: NDArray[Any]) -> NDArray[np.float32]:
        """Mean inverse depth [1/m] of whole cells, 0 if sparse. Single pixels are too noisy for the fit of a camera."""
        s, n = self._step, len(self._offsets)
        rows, columns = (length // s for length in depth.shape)
        cells = depth[: rows * s, : columns * s].reshape(rows, s, columns, s)
        cells = cells[:, :: self._offsets.step, :, :: self._offsets.step]
        z = self._in_meters(cells).reshape(rows, n, columns * n)
        seen = self._is_valid(z, CAMERA_RANGE)
        total = np.divide(np.float32(1.0), z, out=np.zeros(z.shape, np.float32), where=seen).sum(axis=1)
        total = total.reshape(rows, columns, n).sum(axis=2)
        count = seen.sum(axis=1, dtype=np.uint8).reshape(rows, columns, n).sum(axis=2, dtype=np.uint8)
        return np.where(count >= MIN_DEPTH_FRACTION * n**2, total / np.maximum(count, 1), np.float32(0.0))

    @cached_property
    def _depths(self) -> list[NDArray[np.float32]]:
        """Depth [m] of the sampled pixels, 0 if invalid, after the last frame."""
        depths = [self._in_meters(each.depth) for each in self._samples.values()]
        return [np.where(self._is_valid(z), z, np.float32(0.0)) for z in depths]

    def _camera_of(self, step: int) -> PinholeCameraIntrinsic:
        """The camera of each `step`-th pixel of each `step`-th row."""
        K = self._intrinsic
        rows, columns = (len(range(0, n, step)) for n in (K.height, K.width))
        return PinholeCameraIntrinsic(columns, rows, K.fx / step, K.fy / step, K.cx / step, K.cy / step)

    def seen_extent(self) -> float:
        """Longest side of the bounding box of the sampled frames [m]. 0 if empty."""
        K, ends = self._camera_of(self._step), []
        rows, columns = np.mgrid[: K.height, : K.width].reshape(2, -1)
        rays = np.stack([(columns - K.cx) / K.fx, (rows - K.cy) / K.fy, np.ones(len(rows))]).astype(np.float32)
        for z, sample in zip(self._depths, self._samples.values(), strict=True):
            z, R = z.ravel(), sample.T_world_camera[:3, :3].astype(np.float32)
            if (seen := z > 0).any():
                points = (matmul(R, rays) * z)[:, seen]
                position = sample.T_world_camera[:3, 3]
                ends += [points.min(axis=1) + position, points.max(axis=1) + position]
        return float(np.ptp(ends, axis=0).max()) if ends else 0.0

    def _in_meters(self, depth: NDArray[Any]) -> NDArray[np.float32]:
        with np.errstate(all="ignore"):  # what is infinite or no number is invalid, too
            z = depth.astype(np.float32)
            return z / np.float32(self._unit) if depth.dtype.kind in "iu" else z

    def _is_valid(self, z: NDArray[np.float32], depths: float = 1.0) -> NDArray[np.bool_]:
        return np.isfinite(z) & (z > MIN_DEPTH) & (z <= min(depths * self.depth_max, float(np.finfo(np.float32).max)))

    @property
    def _views(self) -> list[CameraView]:
        K, s, middle = self._intrinsic, self._step, float(np.mean(self._offsets))
        lens = K.fx / s, K.fy / s, (K.cx - middle) / s, (K.cy - middle) / s
        return [CameraView(sample.nearness, lens) for sample in self._samples.values()]

    @cached_property
    def _given_pairs(self) -> ViewPairs:
        """The pairs at the given poses, after the last frame."""
        return posed_pairs(self._views, [each.given for each in self._samples.values()])

    @cached_property
    def _given_fits(self) -> list[PosedCameraFit]:
        return fit_posed_camera(self._views, [each.given for each in self._samples.values()], self._given_pairs)

    @property
    def notes(self) -> tuple[str, ...]:
        """Remarks on colors, and values that the frames do not determine, after the last frame."""
        return (*self.images.notes, *failed(undetermined_values(self._given_fits, self._intrinsic)))

    def fraction_displaced(self, voxel_size: float) -> float:
        """Fraction of the pairs whose poses displace the surface by MAX_DISPLACEMENT and by a voxel. 0 if unknown."""
        samples, pairs = self._samples.values(), self._given_pairs
        if any(each.T_world_camera is not each.given for each in samples):
            pairs = posed_pairs(self._views, [each.T_world_camera for each in samples])
        limit = max(MAX_DISPLACEMENT, voxel_size)
        found = displacements_of_poses(pairs, limit)
        return float((found > limit).mean()) if len(found) else 0.0

    def camera_and_factor(self, is_off: bool) -> tuple[FocalCheck | None, float, float]:
        """The camera and the factor of the depth that fit the given poses better, and the deviation of the factor.

        None if the frames do not determine the camera, and 1 without a better factor. A factor far from 1 is searched
        only if the frames are off the surface (`is_off`), or do not fit: correct frames then cost one fit.
        """
        views, K = self._views, self._intrinsic
        given = [each.given for each in self._samples.values()]
        fits = self._given_fits
        found = judge_posed_camera(fits, K)
        is_fitting = bool(fits) and fits[0].residual < MIN_RESIDUAL_RATIO * fits[0].fitted_residual
        is_fitting &= found[0] is None or found[0].reliable
        if is_fitting and not is_off and found[1] == 1.0:
            return found
        if (factor := depth_factor(views, given)) == 1.0:
            return found
        scaled = [CameraView(view.nearness / np.float32(factor), view.lens) for view in views]
        return judge_posed_camera(fit_posed_camera(scaled, given), K, factor)

    def fractions_off(self, volume: TSDFVolume) -> tuple[float, ...]:
        """Fraction of pixels off the surface by half the truncation, by frame. Empty for fewer than two frames."""
        fractions, camera = [], self._camera_of(self._step * RAY_STEP)
        for z, sample in zip(self._depths, self._samples.values(), strict=True):
            z = z[::RAY_STEP, ::RAY_STEP]
            seen = z > 0
            if not seen.any():
                continue
            near = min(0.1, 0.5 * float(z[seen].min()))
            limits = {"depth_min": near, "depth_max": self.depth_max, "weight_threshold": 0}
            view = volume.render_maps(camera, sample.T_world_camera, normals=False, **limits)
            model = download(view.depth).reshape(z.shape)
            met = seen & (model > 0)
            if met.any():
                limit = np.maximum(0.5 * volume.truncation, RELATIVE_DEPTH_NOISE * z[met])
                fractions.append(float((np.abs(z[met] - model[met]) > limit).mean()))
        return tuple(fractions) if len(fractions) > 1 else ()
