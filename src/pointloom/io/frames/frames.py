"""Folders of RGB-D frames for the commands: open, prefetch, describe the camera."""

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
from ...cameras.frame_check import MAX_FRAMES, FrameCheck, why_implausible
from ...core.checks import check_positive
from ...core.errors import FileError, FilePath
from ...core.matched_counts import why_few_matched
from ...core.reports import failed
from ...core.wording import format_fraction
from .datasets import RGBDDataset, open_frames
from .rgbd_sources import RGBDSource

Frame = TypeVar("Frame")

# Frames decoded ahead. Decoding takes about as long as integration, on one core.
READ_AHEAD = 4

# Below this fraction of pixels with depth within the limit, the unit or the limit is probably wrong.
HARDLY_ANY = 0.02


class FrameSource(Protocol):
    """Indexed frames of one camera: depth, color, name. T_world_camera is required for fusion, else ground truth."""

    @property
    def intrinsic(self) -> PinholeCameraIntrinsic: ...

    @property
    def depth_scale(self) -> float:
        """Units per meter of integer depth."""
        ...

    def __len__(self) -> int: ...

    def read(self, index: int, /) -> Any: ...


def check_frames(name: str, frames: Any) -> FrameSource | RGBDSource:
    can_give = can_read(frames) or hasattr(frames, "__iter__")
    if not can_give or not isinstance(getattr(frames, "intrinsic", None), PinholeCameraIntrinsic):
        remedy = "loom.frames_from(images, intrinsic) creates them from images, loom.open_frames from a folder"
        raise TypeError(f"{name}: expected RGB-D frames of one camera, got {type(frames).__name__}; {remedy}")
    check_positive(f"{name}: depth_scale", getattr(frames, "depth_scale", None))
    return frames


def can_read(frames: Any) -> TypeGuard[FrameSource]:
    """True if frames can be read by index repeatedly."""
    return hasattr(frames, "read") and hasattr(frames, "__len__")


def count_of(frames: Any) -> int:
    """Number of frames. 0 if unknown, as for a generator or camera."""
    return len(frames) if hasattr(frames, "__len__") else 0


def depth_unit(frames: FrameSource | RGBDSource, frame: Any) -> float:
    return frames.depth_scale if frame.depth.dtype.kind in "iu" else 1.0


def open_folder(
    folder: FilePath,
    *,
    layout: str = "auto",
    intrinsic: FilePath | None = None,
    every: int = 1,
    depth_scale: float | None = None,
) -> RGBDDataset:
    """Open a folder with `open_frames`, poses optional. Incomplete frames are skipped and listed. Color gets the size
    of depth."""
    camera = None if intrinsic is None else read_pinhole_camera_intrinsic(intrinsic)
    options = {"layout": layout, "every": every, "depth_scale": depth_scale}
    return open_frames(folder, intrinsic=camera, skip_missing="images", resize_color=True, **options)


def describe_folder(folder: FilePath, dataset: RGBDDataset, intrinsic: FilePath | None) -> dict[str, Any]:
    report = {"dataset": os.fspath(folder), "layout": dataset.layout, "left_out": dataset.left_out}
    return report | {"camera": describe_camera(dataset, intrinsic)}


def read_frames(dataset: FrameSource | RGBDSource, ahead: int = READ_AHEAD) -> Generator[Any, None, None]:
    """Iterate over frames, prefetched in threads (Pillow decodes without the GIL) if they are indexed."""
    if can_read(dataset):
        with contextlib.closing(read_in_order(dataset.read, range(len(dataset)), ahead)) as frames:
            for take in frames:
                yield take()
    else:
        yield from iter(dataset)  # type: ignore[call-overload]


def read_frames_or_errors(dataset: FrameSource | RGBDSource, ahead: int = READ_AHEAD) -> Generator[Any, None, None]:
    """`read_frames`, with a FileError in place of an unreadable indexed frame."""
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
    """For each index in order, a callable that returns `read(index)`. Some are computed ahead in threads."""
    if not ahead:
        for i in indices:
            yield lambda i=i: read(i)
        return
    pending: deque[Future[Frame]] = deque()
    with ThreadPoolExecutor(2, thread_name_prefix="pointloom-read") as pool:
        try:
            for i in indices:
                # a copied context, so that the caller's compiler choice applies in the thread
                pending.append(pool.submit(contextvars.copy_context().run, read, i))
                if len(pending) > ahead:
                    yield pending.popleft().result
            while pending:
                yield pending.popleft().result
        finally:
            for future in pending:
                future.cancel()


def measured_fractions(depth: NDArray[Any], farthest: float) -> tuple[float, float]:
    """Fraction of pixels with depth, and with depth up to `farthest` [unit of the image]."""
    measured = depth > 0
    if depth.dtype.kind in "iu":  # comparisons of integers with integers are faster
        farthest = int(min(farthest, np.iinfo(depth.dtype).max))
    counts = np.count_nonzero(measured), np.count_nonzero(measured & (depth <= farthest))
    return counts[0] / max(depth.size, 1), counts[1] / max(depth.size, 1)


def describe_camera(dataset: Any, given: FilePath | None) -> dict[str, Any]:
    camera = dataset.intrinsic
    source = dataset.intrinsic_source if given is None else os.fspath(given)
    size = {"width": camera.width, "height": camera.height}
    return size | {"fx": camera.fx, "fy": camera.fy, "cx": camera.cx, "cy": camera.cy, "source": source}


def camera_line(camera: dict[str, Any]) -> str:
    numbers = f"f {camera['fx']:g} {camera['fy']:g}, c {camera['cx']:g} {camera['cy']:g}"
    return f"{camera['width']} x {camera['height']}, {numbers}, from {camera['source']}"


def camera_problem(dataset: Any, source: str) -> str | None:
    """Why the camera may belong to other images, or None."""
    problem = "; ".join(dataset.warnings)
    return f"the camera may be wrong ({source}): {problem}" if problem else None


def source_warnings(frames: Any) -> tuple[str, ...]:
    """Failed checks of a source of frames: damage, unpaired or omitted images, an assumed or implausible camera."""
    unpaired, camera = None, None
    if pairing := getattr(frames, "pairing", ()):
        remedy = "check that the clocks of depth, color and poses agree"
        paired, possible = pairing
        unpaired = why_few_matched(paired, possible, "frames have all images and a pose at their time", remedy)
    incomplete = why_incomplete(frames) if hasattr(frames, "left_out") else None
    if getattr(frames, "warnings", ()):
        camera = camera_problem(frames, getattr(frames, "intrinsic_source", "") or "of the frames")
    elif not isinstance(frames, RGBDDataset) and (reason := why_implausible(frames.intrinsic)):
        camera = f"the camera may be wrong: {reason}"
    return failed(getattr(frames, "damage", None), unpaired, incomplete, camera)


def image_warnings(frames: FrameSource) -> tuple[str, ...]:
    """Failed checks of the images of a few frames, which are read. See `FrameCheck`."""
    check = FrameCheck(frames.intrinsic, frames.depth_scale)
    for index in np.unique(np.linspace(0, len(frames) - 1, MAX_FRAMES).round().astype(int)).tolist():
        with contextlib.suppress(FileError, OSError):  # reported by the caller
            frame = frames.read(index)
            check.add(frame.depth, frame.color)
    return check.warnings


def why_out_of_range(depth_fraction: float, used_fraction: float, depth_max: float) -> str | None:
    """Why hardly any pixel is within the depth limit, or None."""
    used, measured = format_fraction(used_fraction), format_fraction(depth_fraction)
    if used_fraction >= HARDLY_ANY:
        return None
    if depth_fraction >= HARDLY_ANY:
        return (
            f"only {used} of the pixels have a depth within {depth_max:g} m, though {measured} have one; "
            "raise depth_max, or check the layout (its depth unit)"
        )
    return f"only {used} of the pixels have a depth; check the depth maps"


def why_incomplete(dataset: RGBDDataset) -> str | None:
    lost = dataset.left_out
    if not lost or dataset.layout == "tum":
        return None
    count = len(lost) + len(dataset)
    return f"{len(lost)} of {count} frames lack an image and are left out, the first {lost[0]}"
