"""Sources of RGB-D frames: folders, generators, cameras."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any, Protocol, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike

from ...cameras.camera import PinholeCameraIntrinsic, check_camera
from ...cameras.depth_range import DEPTH_SCALE
from ...core.checks import check_positive, shown
from .datasets import Frame
from .frame_checks import checked_frame
from .frame_times import TimeWatch


@runtime_checkable
class RGBDSource(Protocol):
    """RGB-D frames of one camera in order of capture, with a length if known.

    Optional: `dropped` counts lost frames, `notes` lists observations.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.io.frames.rgbd_sources import RGBDSource
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> images = [(np.zeros((48, 64, 3), np.uint8), np.full((48, 64), 1500, np.uint16))] * 2
        >>> source = loom.frames_from(images, camera)
        >>> isinstance(source, RGBDSource), len(list(source))
        (True, 2)
    """

    @property
    def intrinsic(self) -> PinholeCameraIntrinsic:
        """The camera of depth and color."""
        ...

    @property
    def depth_scale(self) -> float:
        """Units per meter of integer depth. Float32 depth is in meters."""
        ...

    def __iter__(self) -> Iterator[Frame]: ...


class FrameStream:
    """Frames from images in memory, checked lazily. See `frames_from`."""

    def __init__(self, items: Iterable[Any], intrinsic: PinholeCameraIntrinsic, depth_scale: float, resize: bool):
        self.intrinsic, self.depth_scale = intrinsic, depth_scale
        self._items, self._resize, self._watch, self._begun = items, resize, TimeWatch(), False

    def __iter__(self) -> Iterator[Frame]:
        iterator = iter(self._items)
        if self._begun and iterator is self._items:
            raise ValueError("frames: a generator can be iterated only once, and was already consumed")
        self._begun, self._watch = True, TimeWatch()
        return self._check(iterator)

    def _check(self, iterator: Iterator[Any]) -> Iterator[Frame]:
        for i, item in enumerate(iterator):
            frame = checked_frame(_frame_of(item, f"frame-{i:06d}"), self.intrinsic, resize=self._resize)
            self._watch.see(frame.name, frame.timestamp)
            yield frame

    @property
    def notes(self) -> list[str]:
        """Timestamps that repeated, decreased or jumped so far, each with its frame."""
        return list(self._watch.notes)


class CountedFrameStream(FrameStream):
    def __len__(self) -> int:
        return len(self._items)  # type: ignore[arg-type]


def frames_from(
    frames: Iterable[Any],
    intrinsic: PinholeCameraIntrinsic | ArrayLike,
    *,
    depth_scale: float = DEPTH_SCALE,
    resize_color: bool = False,
) -> FrameStream:
    """RGB-D frames from images in memory: a list, a generator, a camera loop.

    Args:
        frames: Each is (color, depth) or (color, depth, time [s]), or an object with `color`, `depth` and optionally
            `T_world_camera`, `timestamp`, `name`. Depth is uint16 or float [m], shape (h, w), 0 without measurement.
            Color is uint8 RGB (h, w, 3) or None, registered to depth.
        intrinsic: The camera, or its matrix [3, 3] if `frames` is a list.
        depth_scale: Units per meter of integer depth.
        resize_color: Resize color to the size of depth. Both must show the same view.

    Returns:
        A source that copies each frame lazily and stores none; `notes` lists irregular timestamps.

    Raises:
        TypeError: No iterable or no camera; while iterating, depth of an invalid type, with its frame.
        ValueError: A scale that is not positive; while iterating, sizes that differ, with their frame.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> images = [(None, np.full((48, 64), 1000 + i, np.uint16), 0.1 * i) for i in range(2)]
        >>> [(f.name, f.timestamp) for f in loom.frames_from(images, camera)]
        [('frame-000000', 0.0), ('frame-000001', 0.1)]
    """
    if isinstance(frames, str | bytes | dict) or not hasattr(frames, "__iter__"):
        raise TypeError(f"frames: expected pairs of color and depth to iterate over, got {shown(frames)}")
    camera = check_camera("intrinsic", intrinsic, _size_of_first(frames))
    kind = CountedFrameStream if hasattr(frames, "__len__") else FrameStream
    return kind(frames, camera, check_positive("depth_scale", depth_scale), bool(resize_color))


def _size_of_first(frames: Iterable[Any]) -> tuple[int, int] | None:
    """Width and height of the first depth image of a list. None if it cannot be read without the others."""
    if not isinstance(frames, list | tuple) or not frames:
        return None
    first = frames[0]
    depth = first[1] if isinstance(first, list | tuple) and len(first) > 1 else getattr(first, "depth", None)
    shape = getattr(depth, "shape", ())
    return (shape[1], shape[0]) if len(shape) == 2 else None


def _frame_of(item: Any, name: str) -> Frame:
    if isinstance(item, tuple | list):
        if len(item) not in (2, 3):
            raise ValueError(f"{name}: expected (color, depth) or (color, depth, time), got {len(item)} values")
        if len(item) == 3 and np.shape(item[2]) == (4, 4):
            raise TypeError(
                f"{name}: the third of (color, depth, time) is the time, got a pose; give poses as "
                "SimpleNamespace(color=..., depth=..., T_world_camera=...), of the module types"
            )
        return Frame(item[1], item[0], None, name, item[2] if len(item) == 3 else None)
    if not hasattr(item, "depth") or not hasattr(item, "color"):
        raise TypeError(f"{name}: expected (color, depth) or an object with color and depth, got {type(item).__name__}")
    own_name, pose, time = (getattr(item, attribute, None) for attribute in ("name", "T_world_camera", "timestamp"))
    return Frame(item.depth, item.color, pose, own_name if isinstance(own_name, str) else name, time)
