"""Random access to source frames, with the reason for unusable ones."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Generator, Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.depth_range import DEPTH_SCALE
from ...core.checks import check_positive
from ...core.errors import FileError
from ...core.records import digest_of_bytes
from ...io.frames.frames import read_in_order
from .config import ReconstructionConfig

HARDLY_ANY = 0.01  # minimum fraction of valid depth pixels


@dataclass(frozen=True)
class LostFrame:
    index: int
    name: str
    reason: str


@dataclass(frozen=True, eq=False)
class ReadFrame:
    """A frame: depth float32 [h, w] [m] (0: invalid), color uint8 [h, w, 3]; `reason` if unusable, else empty."""

    index: int
    name: str
    depth: NDArray[np.float32] | None
    color: NDArray[np.uint8] | None
    T_world_camera: NDArray[np.float64] | None
    digest: str
    reason: str


class Frames:
    def __init__(self, source: Any, config: ReconstructionConfig):
        for name in ("__len__", "read", "intrinsic"):
            if not hasattr(source, name):
                raise TypeError(
                    f"source: expected frames with random access (open_frames, open_dataset), got "
                    f"{type(source).__name__} without {name}; record a stream to a folder first"
                )
        if not isinstance(source.intrinsic, PinholeCameraIntrinsic):
            given = type(source.intrinsic).__name__
            raise TypeError(f"source.intrinsic: expected a PinholeCameraIntrinsic, got {given}")
        self.source, self.config, self.count = source, config, len(source)
        if not self.count:
            raise ValueError("source: expected at least one frame, got none")
        scale = config.depth_scale or getattr(source, "depth_scale", DEPTH_SCALE)
        self.depth_scale = check_positive("source.depth_scale", scale)

    @property
    def intrinsic(self) -> PinholeCameraIntrinsic:
        return self.source.intrinsic

    @property
    def name(self) -> str:
        folder = getattr(self.source, "folder", None)
        return type(self.source).__name__ if folder is None else os.fspath(folder)

    def digest(self, index: int) -> str:
        """Digest of a frame's files (by name, size and modification time) or images. Empty if unreadable."""
        stamp = self._stamp(index)
        return self.read(index).digest if stamp is None else stamp

    def read(self, index: int) -> ReadFrame:
        stamp = self._stamp(index)
        try:
            frame = self.source.read(index)
        except (FileError, OSError) as error:
            return ReadFrame(index, f"frame {index}", None, None, None, stamp or "", f"cannot be read: {error}")
        name = str(getattr(frame, "name", f"frame {index}"))
        pose = getattr(frame, "T_world_camera", None)
        depth, color = np.asarray(frame.depth), frame.color
        digest = stamp
        if digest is None:
            digest = digest_of_bytes([np.ascontiguousarray(a) for a in (depth, color) if a is not None])
        reason = self._fault(depth, color)
        if reason:
            return ReadFrame(index, name, None, None, pose, digest, reason)
        meters = depth.astype(np.float32) / np.float32(self.depth_scale if depth.dtype.kind in "iu" else 1.0)
        near, far = self.config.depth_min, self.config.depth_max
        in_range = (meters >= near) & (meters <= far)  # False for NaN
        fraction = float(np.mean(in_range))
        if fraction < HARDLY_ANY:
            reason = f"{fraction:.1%} of its pixels have a depth from {near:g} to {far:g} m"
            return ReadFrame(index, name, None, color, pose, digest, reason)
        return ReadFrame(index, name, np.where(in_range, meters, np.float32(0)), color, pose, digest, "")

    def read_all(self, indices: Iterable[int]) -> Generator[ReadFrame, None, None]:
        with contextlib.closing(read_in_order(self.read, indices)) as frames:
            for take in frames:
                yield take()

    def closing(self, indices: Iterable[int]) -> contextlib.closing[Generator[ReadFrame, None, None]]:
        return contextlib.closing(self.read_all(indices))

    def _stamp(self, index: int) -> str | None:
        """Digest of the state of a frame's files, empty if one is missing. None without files."""
        try:
            files = self.source.frames[index]
            paths = [Path(path) for path in (files.depth, files.color) if path is not None]
        except (TypeError, AttributeError, IndexError):
            return None
        try:
            states = [(path.name, path.stat()) for path in paths]
        except OSError:
            return ""
        return digest_of_bytes(f"{name} {state.st_size} {state.st_mtime_ns}\n".encode() for name, state in states)

    def _fault(self, depth: NDArray[Any], color: ArrayLike) -> str:
        size = (self.intrinsic.height, self.intrinsic.width)
        if depth.shape != size:
            return f"its depth has shape {list(depth.shape)}, expected {list(size)} of the camera"
        if depth.dtype.kind not in "iuf" or depth.dtype.itemsize == 1:
            return f"its depth is {depth.dtype}; expected integers of 16 bits or more, or floats in meters"
        if color is not None and (np.asarray(color).dtype != np.uint8 or np.shape(color) != (*size, 3)):
            given = f"{np.asarray(color).dtype} {list(np.shape(color))}"
            return f"its color is {given}; expected uint8 {[*size, 3]}"
        return ""
