"""What gives RGB-D frames one after another: a folder, a generator, a camera."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Protocol, runtime_checkable

from ..camera import PinholeCameraIntrinsic
from .datasets import Frame


@runtime_checkable
class RGBDSource(Protocol):
    """RGB-D frames of one camera, in order of capture; a source that knows how many has a length too."""

    @property
    def intrinsic(self) -> PinholeCameraIntrinsic:
        """The camera of all frames, for depth and colour."""
        ...

    @property
    def depth_scale(self) -> float:
        """Stored depth of one metre where depth is stored in whole numbers; float32 depth is in metres."""
        ...

    def __iter__(self) -> Iterator[Frame]: ...
