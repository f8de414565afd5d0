"""The newest frame of a source that is faster than its consumer."""

from __future__ import annotations

import contextvars
import threading
from collections.abc import Iterator

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.checks import check_positive
from .datasets import Frame
from .rgbd_sources import RGBDSource


class LatestFrames:
    """The newest frame of a source for each request. Frames in between are dropped and counted.

    A thread reads the source and stores one frame, so memory is bounded. Source errors are raised after the preceding
    frames. Leaving the loop, an error or Ctrl-C ends the thread after its current frame; `close` and a `with` block do
    too, and close the source.

    Args:
        source: The frames; iterated once.

    Raises:
        TypeError: No source of frames.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> images = ((None, np.full((48, 64), 1000, np.uint16)) for _ in range(50))
        >>> with loom.LatestFrames(loom.frames_from(images, camera)) as latest:
        ...     taken = sum(1 for frame in latest)
        >>> taken + latest.dropped
        50
    """

    def __init__(self, source: RGBDSource):
        if not isinstance(source, RGBDSource):
            kind = type(source).__name__
            raise TypeError(f"source: expected an RGBDSource (intrinsic, depth_scale, iteration), got {kind}")
        self._source, self._changed = source, threading.Condition()
        self._newest: Frame | None = None
        self._error: BaseException | None = None
        self._thread: threading.Thread | None = None
        self._ended = self._closed = False
        self._dropped = 0

    @property
    def intrinsic(self) -> PinholeCameraIntrinsic:
        """The camera of all frames."""
        return self._source.intrinsic

    @property
    def depth_scale(self) -> float:
        """Units per meter of integer depth."""
        return self._source.depth_scale

    @property
    def dropped(self) -> int:
        """Number of frames dropped here and by the source."""
        with self._changed:
            return self._dropped + getattr(self._source, "dropped", 0)

    @property
    def notes(self) -> list[str]:
        """Notes of the source, and the number of dropped frames."""
        notes = list(getattr(self._source, "notes", []))
        return (
            [*notes, f"{self._dropped} frames dropped: newer ones came before they were taken"]
            if self._dropped
            else notes
        )

    def __enter__(self) -> LatestFrames:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __iter__(self) -> Iterator[Frame]:
        if self._thread is not None:
            raise ValueError("source: its frames can be read only once, and iteration has already started")
        context = contextvars.copy_context()  # the caller's compiler choice applies in the thread
        self._thread = threading.Thread(target=context.run, args=(self._read,), name="pointloom-latest", daemon=True)
        self._thread.start()
        return self._take()

    def _take(self) -> Iterator[Frame]:
        try:
            while True:
                with self._changed:
                    self._changed.wait_for(lambda: self._newest is not None or self._ended or self._closed)
                    frame, self._newest = self._newest, None
                if frame is None:
                    break
                yield frame
            if self._error is not None:
                raise self._error
        finally:
            self.close()

    def _read(self) -> None:
        try:
            frames = iter(self._source)
            for frame in frames:
                with self._changed:
                    if self._closed:
                        break
                    self._dropped += self._newest is not None
                    self._newest = frame
                    self._changed.notify_all()
        except BaseException as error:  # re-raised in the consumer
            self._error = error
        finally:
            with self._changed:
                self._ended = True
                self._changed.notify_all()

    def close(self, timeout: float = 10.0) -> None:
        """End the thread after its current frame, waiting at most `timeout` [s], and close the source if possible."""
        timeout = check_positive("timeout", timeout, allow_zero=True, maximum=threading.TIMEOUT_MAX)
        with self._changed:
            self._closed, self._newest = True, None
            self._changed.notify_all()
        if self._thread is not None and self._thread is not threading.current_thread():
            self._thread.join(timeout)
        close = getattr(self._source, "close", None)
        if callable(close) and (self._thread is None or not self._thread.is_alive()):
            close()
