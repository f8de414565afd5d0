"""What decides what becomes of a video, and where it is written."""

from __future__ import annotations

import os
import secrets
from collections.abc import Sequence
from dataclasses import dataclass, field

from ...cameras.camera import PinholeCameraIntrinsic, read_pinhole_camera_intrinsic
from ...core.checks import check_count, check_seed
from ...core.errors import FileError, FilePath
from ...core.records import digest_of
from ...files.models.camera_files import read_cameras
from ...files.models.sfm_model import SfmModel
from ..sfm.features import MAX_FEATURES, check_camera_model, check_max_features
from ..sfm.frames import check_option
from ..sfm.mapping import MAPPERS
from ..sfm.masks import ALPHA, MakeMask, check_masks
from ..sfm.matches import PAIRS
from .motion import digest_of_source
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
        cameras: Lenses and poses of the pictures of a folder, or the file of them, as `read_cameras` reads it; None
            where they are to be found. A trajectory wants `intrinsic` too; with others that is None.
        units: What is known of the size of things.
        seed: Of what is drawn.
        masks: What of pictures is left out, as `sfm.choose_frames` takes it: a folder, "alpha", or a function.
        camera_model: COLMAP's name of how the lens draws, where it is to be found: "OPENCV_FISHEYE" of a fisheye.
        pairs: Which pictures are matched, as `sfm.match` has it.
        max_features: Of a picture.
        panorama: The pictures show all directions (360 degrees, equirectangular, twice as wide as high): each becomes
            six of a cube's faces, whose lens is known.
        mapper: How pictures are placed, as `sfm.map_pictures` has it.

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
    cameras: FilePath | SfmModel | None = None
    masks: FilePath | MakeMask | None = None
    camera_model: str = "SIMPLE_RADIAL"
    pairs: str = "auto"
    max_features: int = MAX_FEATURES
    panorama: bool = False
    mapper: str = "auto"

    def __post_init__(self):
        check_count("max_frames", self.max_frames, minimum=FEWEST_PICTURES)
        check_count("max_size", self.max_size, minimum=SMALLEST)
        check_seed(self.seed)
        if not isinstance(self.units, Units):
            raise TypeError(f"units: expected Units, got {type(self.units).__name__}")
        if not isinstance(self.intrinsic, str | os.PathLike | PinholeCameraIntrinsic | None):
            kind = type(self.intrinsic).__name__
            raise TypeError(f"intrinsic: expected a path or a PinholeCameraIntrinsic, got {kind}")
        if not isinstance(self.cameras, str | os.PathLike | SfmModel | None):
            raise TypeError(f"cameras: expected a path or an SfmModel, got {type(self.cameras).__name__}")
        if isinstance(self.cameras, SfmModel) and self.intrinsic is not None:
            raise ValueError("intrinsic: the cameras that are given have lenses; leave it out")
        self._check_placing()
        self.read_camera()

    def _check_placing(self) -> None:
        """How pictures are placed: that is settled where poses are known."""
        check_masks(self.masks)
        check_camera_model(self.camera_model)
        check_option("pairs", self.pairs, PAIRS)
        check_option("mapper", self.mapper, MAPPERS)
        check_max_features(self.max_features)
        if not isinstance(self.panorama, bool):
            raise TypeError(f"panorama: expected True or False, got {type(self.panorama).__name__}")
        if self.panorama and (self.intrinsic is not None or self.camera_model != "SIMPLE_RADIAL"):
            raise ValueError(
                "panorama: faces of a cube have a lens that is known; leave out intrinsic and camera_model"
            )
        if self.cameras is None:
            return
        for name, usual in (
            ("camera_model", "SIMPLE_RADIAL"),
            ("pairs", "auto"),
            ("panorama", False),
            ("mapper", "auto"),
        ):
            if getattr(self, name) != usual:
                raise ValueError(f"{name}: goes with pictures whose poses are to be found, and cameras tells them")

    def digest_of_masks(self) -> dict[str, str]:
        """What a record keeps of the masks; of a function what no other run has, since nobody knows what it does."""
        if self.masks is None:
            return {}
        if callable(self.masks):
            return {"masks": secrets.token_hex(16)}
        return {"masks": ALPHA if self.masks == ALPHA else digest_of_source(self.masks)}

    def read_camera(self) -> PinholeCameraIntrinsic | None:
        """The camera that is known, if one is.

        Raises:
            FileError: Its file cannot be read.
        """
        if isinstance(self.intrinsic, str | os.PathLike):
            return read_pinhole_camera_intrinsic(self.intrinsic)
        return self.intrinsic

    def read_posed(self, pictures: Sequence[str]) -> SfmModel | None:
        """The lenses and poses that are known, if any are.

        Args:
            pictures: Names of the pictures.

        Raises:
            FileError: Their file cannot be read, or holds those of no picture.
        """
        if isinstance(self.cameras, str | os.PathLike):
            try:
                return read_cameras(self.cameras, pictures=pictures, intrinsic=self.read_camera())
            except FileError:
                raise
            except ValueError as error:
                raise FileError(self.cameras, str(error)) from error
        return self.cameras

    def digest_of_cameras(self) -> str | None:
        """Of the poses that were given."""
        if isinstance(self.cameras, str | os.PathLike):
            return digest_of_source(self.cameras)
        if self.cameras is None:
            return None
        lenses = [[camera.model, camera.width, camera.height, *camera.params] for camera in self.cameras.cameras]
        return digest_of([list(self.cameras.names), lenses, self.cameras.T_camera_world.tolist()])
