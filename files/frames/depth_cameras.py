"""What the drivers of depth cameras have in common: frames checked, counted, and errors that say what to do."""

from __future__ import annotations

import contextlib
import importlib
import os
import sys
from collections.abc import Iterator
from typing import Any, Self

import numpy as np

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.checks import check_positive, shown
from ...core.errors import CameraError
from ...core.interrupts import signal_exception
from .datasets import Frame
from .frame_checks import checked_frame
from .frame_times import TimeWatch
from .lens import NEGLIGIBLE, LensMap

LONGEST_WAIT = 3600.0  # [s] for a frame; drivers count milliseconds in 32 bits


def import_driver(module: str, camera: str, extra: str) -> Any:
    """The module of a camera's driver.

    Raises:
        CameraError: It is not installed, or cannot be loaded.
    """
    try:
        return importlib.import_module(module)
    except ImportError as error:
        remedy = f'pip install "pointloom[{extra}]"'
        raise CameraError(f"{camera} needs the package {module}, which cannot be loaded: {error}. {remedy}") from error


def recording_path(file: Any) -> str | None:
    """The path of a recording; None for a camera."""
    if file is None:
        return None
    if not isinstance(file, str | os.PathLike):
        raise TypeError(f"file: expected the path of a recording, got {shown(file)}")
    return str(os.fspath(file))


@contextlib.contextmanager
def driver_errors(what: str, remedy: str) -> Iterator[None]:
    """Turn whatever a driver raises into a CameraError, but not what a signal handler raises meanwhile."""
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
    """A camera, or a recording played back, as an RGBDSource; a `with` block closes it.

    Attributes:
        intrinsic: The camera of both pictures.
        depth_scale: Stored depth of one metre.
        dropped: Frames that the driver numbered and never gave.
        count: Frames given.
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
        """Time stamps that stood still, went back or jumped, and frames that the driver lost."""
        lost = [f"{self.dropped} frames were lost before they reached the program"] if self.dropped else []
        return [*self._watch.notes, *lost]

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __iter__(self) -> Iterator[Frame]:
        while self._open:
            with driver_errors(f"{self.name} stopped after {self.count} frames", "Frames up to there are whole"):
                taken = self._take()
            if taken is None:
                return
            yield self._finish(*taken)

    @contextlib.contextmanager
    def _opening(self, what: str, remedy: str) -> Iterator[None]:
        """A device that is opened in the block is closed again where that fails half-way."""
        try:
            with driver_errors(what, remedy):
                yield
        except BaseException:
            self.close()
            raise

    def close(self) -> None:
        """Release the device; frames end. Calling it twice does no harm."""
        if self._open:
            self._open = False
            with contextlib.suppress(Exception):  # a device that was pulled out cannot be stopped, and need not be
                self._stop()

    def _take(self) -> tuple[Any, Any, float] | None:
        """Depth, colour or None, and time [s] of the next frame; None at the end of a recording."""
        raise NotImplementedError

    def _stop(self) -> None:
        raise NotImplementedError

    def _use_lens(self, coefficients: Any, *, inverse: bool = False) -> None:
        """Take the lens out of all pictures, if it moves any pixel."""
        if np.any(coefficients):
            lens = LensMap(self.intrinsic, coefficients, inverse=inverse)
            self._lens = lens if lens.shift > NEGLIGIBLE else None

    def _finish(self, depth: Any, color: Any, time: float) -> Frame:
        frame = checked_frame(Frame(depth, color, None, f"frame-{self.count:06d}", time), self.intrinsic)
        self._watch.see(frame.name, frame.timestamp)
        self.count += 1
        if self._lens is None:
            return frame
        straight = None if frame.color is None else self._lens.straighten_color(frame.color)
        depth = self._lens.straighten_depth(np.asarray(frame.depth, np.uint16))
        return Frame(depth, straight, None, frame.name, frame.timestamp)
