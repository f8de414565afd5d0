"""Folders of RGB-D frames as the commands take them: opened, read ahead, and their camera told."""

from __future__ import annotations

import contextlib
import contextvars
import os
from collections import deque
from collections.abc import Callable, Generator, Iterable
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any, Protocol, TypeGuard, TypeVar

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic, read_pinhole_camera_intrinsic
from ...core.checks import check_positive
from ...core.errors import FileError, FilePath
from ...core.wording import format_share
from .datasets import RGBDDataset, open_frames
from .rgbd_sources import RGBDSource

Frame = TypeVar("Frame")

DEPTH_MAX = 4.0  # [m] beyond it the noise of depth cameras passes 2 cm

# Frames decoded while earlier ones are worked on. Decoding takes about as long as integrating, on one core.
READ_AHEAD = 4

# Below this share of pixels with a depth in reach the frames are likely read in the wrong unit, or to the wrong reach.
HARDLY_ANY = 0.02


class FrameSource(Protocol):
    """What can be fused, tracked or reconstructed: frames with depth, color and name, all of one camera.

    Fusing wants T_world_camera too; else it is the truth, where it is there, and tells nothing.
    """

    @property
    def intrinsic(self) -> PinholeCameraIntrinsic:
        """The camera of all frames."""
        ...

    @property
    def depth_scale(self) -> float:
        """Stored depth of one metre, where depth is stored in whole numbers."""
        ...

    def __len__(self) -> int: ...

    def read(self, index: int, /) -> Any:
        """A frame by its place."""
        ...


def check_frames(name: str, frames: Any) -> FrameSource | RGBDSource:
    """Frames of one camera, to be read by their place or one after another.

    Raises:
        TypeError: Neither, or no camera beside them.
        ValueError: A depth scale that is not positive.
    """
    can_give = can_read(frames) or hasattr(frames, "__iter__")
    if not can_give or not isinstance(getattr(frames, "intrinsic", None), PinholeCameraIntrinsic):
        remedy = "loom.frames_from(pictures, intrinsic) makes them of pictures, loom.open_frames of a folder"
        raise TypeError(f"{name}: expected RGB-D frames of one camera, got {type(frames).__name__}; {remedy}")
    check_positive(f"{name}: depth_scale", getattr(frames, "depth_scale", None))
    return frames


def can_read(frames: Any) -> TypeGuard[FrameSource]:
    """Whether frames can be read by their place, in any order and again."""
    return hasattr(frames, "read") and hasattr(frames, "__len__")


def count_of(frames: Any) -> int:
    """How many frames there are; 0 where nobody knows yet, as of a generator's or a camera's."""
    return len(frames) if hasattr(frames, "__len__") else 0


def depth_unit(frames: FrameSource | RGBDSource, frame: Any) -> float:
    """What one metre is in the numbers of a frame's depth map."""
    return frames.depth_scale if frame.depth.dtype.kind in "iu" else 1.0


def open_folder(
    folder: FilePath,
    *,
    layout: str = "auto",
    intrinsic: FilePath | None = None,
    every: int = 1,
    depth_scale: float | None = None,
) -> RGBDDataset:
    """A folder of frames that need no poses, as `open_frames` takes it; what lacks a picture is left out and listed.

    Raises:
        FileError: A camera that cannot be read, and what `open_frames` raises.
    """
    camera = None if intrinsic is None else read_pinhole_camera_intrinsic(intrinsic)
    options = {"layout": layout, "every": every, "depth_scale": depth_scale}
    return open_frames(folder, intrinsic=camera, skip_missing="pictures", **options)


def describe_folder(folder: FilePath, dataset: RGBDDataset, intrinsic: FilePath | None) -> dict[str, Any]:
    """What was opened, in JSON's types."""
    report = {"dataset": os.fspath(folder), "layout": dataset.layout, "left_out": dataset.left_out}
    return report | {"camera": describe_camera(dataset, intrinsic)}


def read_frames(dataset: FrameSource | RGBDSource, ahead: int = READ_AHEAD) -> Generator[Any, None, None]:
    """The frames in order, some of them read in threads before they are asked for (Pillow decodes without the GIL).

    Frames that only come one after another come in the caller's thread.

    Raises:
        FileError: A frame that cannot be read, when its turn comes.
    """
    if can_read(dataset):
        with contextlib.closing(read_in_order(dataset.read, range(len(dataset)), ahead)) as frames:
            for take in frames:
                yield take()
    else:
        yield from iter(dataset)  # type: ignore[call-overload]


def read_frames_or_errors(dataset: FrameSource | RGBDSource, ahead: int = READ_AHEAD) -> Generator[Any, None, None]:
    """As `read_frames`, with the FileError in the place of a frame that cannot be read by its place."""
    if not can_read(dataset):
        yield from read_frames(dataset)
        return
    with contextlib.closing(read_in_order(dataset.read, range(len(dataset)), ahead)) as frames:
        for take in frames:
            try:
                frame = take()
            except FileError as error:
                frame = error
            yield frame


def read_in_order(
    read: Callable[[int], Frame], indices: Iterable[int], ahead: int = READ_AHEAD
) -> Generator[Callable[[], Frame], None, None]:
    """For each index in order a call that gives what `read` makes of it, some of it made in threads before its turn."""
    if not ahead:
        for i in indices:
            yield lambda i=i: read(i)
        return
    pending: deque[Future[Frame]] = deque()
    with ThreadPoolExecutor(2, thread_name_prefix="pointloom-read") as pool:
        try:
            for i in indices:
                # a context of its own: which compiler the caller chose holds in the thread too
                pending.append(pool.submit(contextvars.copy_context().run, read, i))
                if len(pending) > ahead:
                    yield pending.popleft().result
            while pending:
                yield pending.popleft().result
        finally:
            for future in pending:
                future.cancel()


def measured_shares(depth: NDArray[Any], farthest: float) -> tuple[float, float]:
    """Share of pixels with a depth at all, and with one up to `farthest`, in the picture's unit."""
    measured = depth > 0
    return float(np.mean(measured)), float(np.mean(measured & (depth <= farthest)))


def describe_camera(dataset: Any, given: FilePath | None) -> dict[str, Any]:
    """The camera that is used, and where it comes from."""
    camera = dataset.intrinsic
    source = dataset.intrinsic_source if given is None else os.fspath(given)
    size = {"width": camera.width, "height": camera.height}
    return size | {"fx": camera.fx, "fy": camera.fy, "cx": camera.cx, "cy": camera.cy, "source": source}


def camera_line(camera: dict[str, Any]) -> str:
    """The camera as one value for the terminal."""
    numbers = f"f {camera['fx']:g} {camera['fy']:g}, c {camera['cx']:g} {camera['cy']:g}"
    return f"{camera['width']} x {camera['height']}, {numbers}, from {camera['source']}"


def camera_problem(dataset: Any, source: str) -> str | None:
    """Why the camera may be that of other images, or None."""
    problem = dataset.intrinsic_doubt
    return f"the camera may be wrong ({source}): {problem}" if problem else None


def why_out_of_reach(depth_share: float, used_share: float, depth_max: float) -> str | None:
    """Why hardly any pixel of the frames counts, if that is so."""
    used, measured = format_share(used_share), format_share(depth_share)
    if used_share >= HARDLY_ANY:
        return None
    if depth_share >= HARDLY_ANY:
        return (
            f"only {used} of the pixels have a depth within {depth_max:g} m, though {measured} have one; "
            "raise depth_max, or check the layout (its depth unit)"
        )
    return f"only {used} of the pixels have a depth; check the depth maps"


def why_incomplete(dataset: RGBDDataset) -> str | None:
    """Whether pictures are missing; that some of a TUM folder find no partner in time is usual."""
    lost = dataset.left_out
    if not lost or dataset.layout == "tum":
        return None
    count = len(lost) + len(dataset)
    return f"{len(lost)} of {count} frames lack a picture and are left out, the first {lost[0]}"
