"""The planes of pictures between the phases of their search, on the device, in memory or in files."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.atomic import atomic_write
from ...kernels.array_types import Array1
from ...kernels.lang import vec4
from ...kernels.memory import clone, download, upload
from .posed_pictures import PosedCamera


@dataclasses.dataclass(frozen=True)
class Found:
    """The planes of a picture so far: vec4 [pixels] on the device, or float32 [pixels, 4] in memory or in a file."""

    planes: Array1[vec4] | NDArray[np.float32] | Path
    camera: PinholeCameraIntrinsic

    def read(self) -> Any:
        """The planes."""
        return np.load(self.planes) if isinstance(self.planes, Path) else self.planes

    def on(self, device: Any) -> Array1[vec4]:
        """The planes on the device, to be changed."""
        planes = self.read()
        return upload(planes, vec4, device) if isinstance(planes, np.ndarray) else clone(planes)


class PlaneFiles:
    """What a search has found so far, a file a picture and phase, each whole: an interrupted one goes on from it.

    Args:
        folder: Where they lie; None keeps nothing.
    """

    def __init__(self, folder: Path | None):
        self.folder = folder

    def write(self, phase: int, index: int, planes: Any) -> None:
        """Keep the planes of a picture after a phase."""
        if self.folder is not None:
            values = np.array(download(planes)).reshape(-1, 4)  # sync
            with atomic_write(self._place(phase, index)) as file:
                np.lib.format.write_array(file, values, allow_pickle=False)

    def read(self, phase: int, index: int, camera: PinholeCameraIntrinsic) -> Found | None:
        """What is kept of a picture after a phase; None where nothing is, or what is no planes of this size."""
        if self.folder is None:
            return None
        place = self._place(phase, index)
        try:
            kept = np.load(place, mmap_mode="r", allow_pickle=False)
        except (OSError, ValueError, EOFError):
            return None
        fits = kept.shape == (camera.width * camera.height, 4) and kept.dtype == np.float32
        return Found(place, camera) if fits else None

    def last_whole(
        self, scales: Sequence[float], cameras: Sequence[PosedCamera], sources: Sequence[Sequence[int]]
    ) -> tuple[int, list[Found | None]]:
        """The phase to go on with, and what the one before left of all pictures that have sources.

        Args:
            scales: Of the pictures in each phase.
            cameras, sources: Of the pictures.
        """
        for number in range(len(scales) - 2, -1, -1) if self.folder is not None else ():
            found = [
                self.read(number, i, camera.intrinsic.scaled(scales[number])) if sources[i] else None
                for i, camera in enumerate(cameras)
            ]
            if all(each is not None for each, mine in zip(found, sources, strict=True) if mine):
                return number + 1, found
        return 0, [None] * len(cameras)

    def _place(self, phase: int, index: int) -> Path:
        assert self.folder is not None
        return self.folder / f"{phase}-{index:06d}.npy"
