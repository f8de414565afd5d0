"""Common code of depth camera drivers: frame checks, error messages, undistortion.

Undistortion uses the nearest pixel for depth, which must not be mixed, and bilinear interpolation for color. Unseen
pixels are 0.
"""

from __future__ import annotations

import contextlib
import importlib
import os
import sys
from collections.abc import Iterator
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.lens_projection import PERSPECTIVE, Lens, bend
from ...core.checks import check_positive, shown
from ...core.errors import CameraError
from ...core.interrupts import signal_exception
from .datasets import Frame
from .frame_checks import checked_frame
from .frame_times import TimeWatch

MAX_PINHOLE_SHIFT = 0.05  # [px] smaller displacements count as a pinhole

PARTS_PER_PIXEL = 16  # color is read at 1/16 px: four weights of 1/256 keep the sum within 16 bits

INVERSE_ITERATIONS = 20  # fixed-point iterations of the inverse. 0.001 px remain after a few


class LensMap:
    """Maps pixels of a pinhole camera to `positions` in the distorted image, (2, h, w) [px], at most `shift` [px] away.
    `coefficients` are k1, k2, p1, p2, k3 and optionally k4, k5, k6. If `inverse`, they map distorted to ideal
    positions, as RealSense's "inverse Brown-Conrady"."""

    def __init__(self, intrinsic: PinholeCameraIntrinsic, coefficients: Any, *, inverse: bool = False):
        k, focal, center = np.zeros(8), (intrinsic.fx, intrinsic.fy), (intrinsic.cx, intrinsic.cy)
        k[: len(coefficients)] = coefficients
        terms: Any = {"radial": (k[0], k[1], k[4], 0.0), "rational": k[5:], "tangential": k[2:4]}
        lens, (height, width) = Lens(PERSPECTIVE, focal, center, 0.0, **terms), (intrinsic.height, intrinsic.width)
        v, u = np.mgrid[:height, :width].astype(np.float64)
        ideal = (np.stack([u, v], axis=2).reshape(-1, 2) - center) / focal
        mapped = _undistort(lens, ideal) if inverse else bend(lens, ideal)
        self.positions = mapped_u, mapped_v = (mapped * focal + center).T.reshape(2, height, width)
        self.shift = float(np.hypot(mapped_u - u, mapped_v - v).max())
        self._outside = ~((mapped_u >= 0) & (mapped_v >= 0) & (mapped_u <= width - 1) & (mapped_v <= height - 1))
        mapped_u, mapped_v = np.clip(mapped_u, 0, width - 1), np.clip(mapped_v, 0, height - 1)
        self._nearest = np.rint(mapped_v).astype(np.intp) * width + np.rint(mapped_u).astype(np.intp)
        left, upper = np.floor(mapped_u).astype(np.intp), np.floor(mapped_v).astype(np.intp)
        right, lower = np.minimum(left + 1, width - 1), np.minimum(upper + 1, height - 1)
        x = np.rint((mapped_u - left) * PARTS_PER_PIXEL).astype(np.uint16)
        y = np.rint((mapped_v - upper) * PARTS_PER_PIXEL).astype(np.uint16)
        self._corners = [
            (row * width + column, weight[..., None])
            for row, column, weight in (
                (upper, left, (PARTS_PER_PIXEL - y) * (PARTS_PER_PIXEL - x)),
                (upper, right, (PARTS_PER_PIXEL - y) * x),
                (lower, left, y * (PARTS_PER_PIXEL - x)),
                (lower, right, y * x),
            )
        ]

    def straighten_depth(self, depth: NDArray[np.uint16]) -> NDArray[np.uint16]:
        """Undistort a depth map. Values are unchanged, as depth is measured along the axis."""
        straight = depth.ravel()[self._nearest]
        straight[self._outside] = 0
        return straight

    def straighten_color(self, color: NDArray[np.uint8]) -> NDArray[np.uint8]:
        pixels = color.reshape(-1, 3).astype(np.uint16)
        mixed = np.full(color.shape, PARTS_PER_PIXEL * PARTS_PER_PIXEL // 2, np.uint16)
        for index, weight in self._corners:
            mixed += pixels[index] * weight
        straight = (mixed // (PARTS_PER_PIXEL * PARTS_PER_PIXEL)).astype(np.uint8)
        straight[self._outside] = 0
        return straight


def _undistort(lens: Lens, positions: NDArray[np.float64]) -> NDArray[np.float64]:
    estimate = positions.copy()
    for _ in range(INVERSE_ITERATIONS):
        estimate = estimate - (bend(lens, estimate) - positions)
    return estimate


LONGEST_WAIT = 3600.0  # [s] maximum timeout. Drivers count milliseconds in 32 bits


def import_driver(module: str, camera: str, extra: str) -> Any:
    """The module of a camera driver. Raises `CameraError` if it cannot be imported."""
    try:
        return importlib.import_module(module)
    except ImportError as error:
        remedy = f'pip install "pointloom[{extra}]"'
        raise CameraError(f"{camera} needs the package {module}, which cannot be loaded: {error}. {remedy}") from error


def recording_path(file: Any) -> str | None:
    """The path of a recording. None for a camera."""
    if file is None:
        return None
    if not isinstance(file, str | os.PathLike):
        raise TypeError(f"file: expected the path of a recording, got {shown(file)}")
    return str(os.fspath(file))


@contextlib.contextmanager
def driver_errors(what: str, remedy: str) -> Iterator[None]:
    """Convert driver errors to CameraError, except those of signal handlers."""
    handled = sys.exception()
    try:
        yield
    except (CameraError, MemoryError, TypeError):
        raise
    except Exception as error:
        if (stopped := signal_exception(error, handled)) is not None:
            raise stopped from None
        reason = (str(error).split("\n")[0] or type(error).__name__).rstrip(".")
        raise CameraError(f"{what}: {reason}. {remedy}") from error


class DepthCamera:
    """A camera, or a recording played back, as an RGBDSource. A `with` block closes it.

    Attributes:
        intrinsic: The camera of depth and color.
        depth_scale: Depth units per meter.
        dropped: Number of frames that the driver lost.
        count: Number of frames delivered.
    """

    name = "the camera"
    intrinsic: PinholeCameraIntrinsic
    depth_scale: float

    def __init__(self, timeout: float):
        self.timeout = check_positive("timeout", timeout, maximum=LONGEST_WAIT)
        self.count = self.dropped = 0
        self._watch, self._lens, self._open = TimeWatch(), None, False

    @property
    def notes(self) -> list[str]:
        """Timestamps that repeated, decreased or jumped, and frames that the driver lost."""
        lost = [f"{self.dropped} frames were lost before they reached the program"] if self.dropped else []
        return [*self._watch.notes, *lost]

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __iter__(self) -> Iterator[Frame]:
        while self._open:
            with driver_errors(f"{self.name} stopped after {self.count} frames", "Frames up to there are complete"):
                captured = self._take()
            if captured is None:
                return
            yield self._finish(*captured)

    @contextlib.contextmanager
    def _opening(self, what: str, remedy: str) -> Iterator[None]:
        """Close the device if opening fails in the block."""
        try:
            with driver_errors(what, remedy):
                yield
        except BaseException:
            self.close()
            raise

    def close(self) -> None:
        """Release the device and end the frames; may be called twice."""
        if self._open:
            self._open = False
            with contextlib.suppress(Exception):  # a disconnected device cannot be stopped
                self._stop()

    def _take(self) -> tuple[Any, Any, float] | None:
        """Depth, color or None, and time [s] of the next frame. None at the end of a recording."""
        raise NotImplementedError

    def _stop(self) -> None:
        raise NotImplementedError

    def _use_lens(self, coefficients: Any, *, inverse: bool = False) -> None:
        """Undistort all images, unless no pixel moves."""
        if np.any(coefficients):
            lens = LensMap(self.intrinsic, coefficients, inverse=inverse)
            self._lens = lens if lens.shift > MAX_PINHOLE_SHIFT else None

    def _finish(self, depth: Any, color: Any, time: float) -> Frame:
        frame = checked_frame(Frame(depth, color, None, f"frame-{self.count:06d}", time), self.intrinsic)
        self._watch.see(frame.name, frame.timestamp)
        self.count += 1
        if self._lens is None:
            return frame
        straight = None if frame.color is None else self._lens.straighten_color(frame.color)
        depth = self._lens.straighten_depth(np.asarray(frame.depth, np.uint16))
        return Frame(depth, straight, None, frame.name, frame.timestamp)
