"""What decides what becomes of a video, and where it is written."""

from __future__ import annotations

import os
from dataclasses import dataclass, field

from ...cameras.camera import PinholeCameraIntrinsic, read_pinhole_camera_intrinsic
from ...core.checks import check_count, check_seed
from ...core.errors import FilePath
from .units import Units

MAX_FRAMES, MAX_SIZE = 150, 960
FEWEST_PICTURES, SMALLEST = 2, 64  # of which something can be made


@dataclass(frozen=True, eq=False)
class Settings:
    """What decides the result, beside the pictures.

    Attributes:
        max_frames: The most pictures that are taken of a video, or of a folder.
        max_size: Longest side of the pictures that depth is estimated in [px].
        intrinsic: The camera, or the file of one (Open3D's JSON); None where it is to be found.
        units: What is known of the size of things.
        seed: Of what is drawn.

    Raises:
        TypeError, ValueError: One is out of range; the error names it.
        FileError: The file of the camera cannot be read.

    Example:
        >>> import pointloom as loom
        >>> loom.video.Settings(max_frames=60, units=loom.video.Units(known=("IMG_1", "IMG_7", 2.5))).units.known
        ('IMG_1', 'IMG_7', 2.5)
    """

    max_frames: int = MAX_FRAMES
    max_size: int = MAX_SIZE
    intrinsic: FilePath | PinholeCameraIntrinsic | None = None
    units: Units = field(default_factory=Units)
    seed: int = 0

    def __post_init__(self):
        check_count("max_frames", self.max_frames, minimum=FEWEST_PICTURES)
        check_count("max_size", self.max_size, minimum=SMALLEST)
        check_seed(self.seed)
        if not isinstance(self.units, Units):
            raise TypeError(f"units: expected Units, got {type(self.units).__name__}")
        if not isinstance(self.intrinsic, str | os.PathLike | PinholeCameraIntrinsic | None):
            kind = type(self.intrinsic).__name__
            raise TypeError(f"intrinsic: expected a path or a PinholeCameraIntrinsic, got {kind}")
        self.read_camera()

    def read_camera(self) -> PinholeCameraIntrinsic | None:
        """The camera that is known, if one is.

        Raises:
            FileError: Its file cannot be read.
        """
        if isinstance(self.intrinsic, str | os.PathLike):
            return read_pinhole_camera_intrinsic(self.intrinsic)
        return self.intrinsic
