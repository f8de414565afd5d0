"""Settings of a video reconstruction."""

from __future__ import annotations

import os
import secrets
from collections.abc import Sequence
from dataclasses import dataclass, field

from ...cameras.camera import PinholeCameraIntrinsic, read_pinhole_camera_intrinsic
from ...core.checks import check_count
from ...core.errors import FileError, FilePath
from ...core.records import digest_of
from ...io.models.camera_files import read_cameras
from ...io.models.sfm_model import SfmModel
from ..sfm.masks import ALPHA, MakeMask, check_masks
from ..sfm.settings import MAX_FEATURES, SfmSettings
from .motion import digest_of_source
from .units import VideoUnits

MAX_FRAMES, MAX_SIZE = 150, 960
MIN_IMAGES, MIN_IMAGE_SIZE = 2, 64  # minimum images, and minimum size


@dataclass(frozen=True, eq=False)
class VideoSettings:
    """Settings of a video reconstruction.

    Attributes:
        max_frames: Maximum number of images.
        max_size: Maximum image side for depth estimation [px].
        intrinsic: The camera, or its file (Open3D's JSON); None: estimated.
        cameras: Lenses and poses of a folder's images, or their file as of `read_cameras`; None: estimated. A
            trajectory also requires `intrinsic`, which is otherwise None.
        units: Known scale or position.
        seed: Random seed.
        masks: As of `photogrammetry.choose_frames`: a folder, "alpha", or a function.
        camera_model: COLMAP camera model if estimated: "OPENCV_FISHEYE" for a fisheye.
        pairs: As of `photogrammetry.match_features`.
        max_features: Maximum number per image.
        panorama: The images are equirectangular (360 degrees, aspect 2:1). Each becomes six cube faces.
        mapper: As of `photogrammetry.map_images`.

    Raises:
        TypeError, ValueError: One is out of range; named in the message.
        FileError: The camera file cannot be read.

    Example:
        >>> import pointloom as loom
        >>> units = loom.photogrammetry.VideoUnits(known=("IMG_1", "IMG_7", 2.5))
        >>> loom.photogrammetry.VideoSettings(max_frames=60, units=units).units.known
        ('IMG_1', 'IMG_7', 2.5)
    """

    max_frames: int = MAX_FRAMES
    max_size: int = MAX_SIZE
    intrinsic: FilePath | PinholeCameraIntrinsic | None = None
    units: VideoUnits = field(default_factory=VideoUnits)
    seed: int = 0
    cameras: FilePath | SfmModel | None = None
    masks: FilePath | MakeMask | None = None
    camera_model: str = "SIMPLE_RADIAL"
    pairs: str = "auto"
    max_features: int = MAX_FEATURES
    panorama: bool = False
    mapper: str = "auto"

    def __post_init__(self):
        check_count("max_frames", self.max_frames, minimum=MIN_IMAGES)
        check_count("max_size", self.max_size, minimum=MIN_IMAGE_SIZE)
        if not isinstance(self.units, VideoUnits):
            raise TypeError(f"units: expected VideoUnits, got {type(self.units).__name__}")
        if not isinstance(self.intrinsic, str | os.PathLike | PinholeCameraIntrinsic | None):
            remedy = "create one with PinholeCameraIntrinsic.from_matrix(K, width, height)"
            got = type(self.intrinsic).__name__
            raise TypeError(f"intrinsic: expected a path or a PinholeCameraIntrinsic, got {got}; {remedy}")
        if not isinstance(self.cameras, str | os.PathLike | SfmModel | None):
            raise TypeError(f"cameras: expected a path or an SfmModel, got {type(self.cameras).__name__}")
        if isinstance(self.cameras, SfmModel) and self.intrinsic is not None:
            raise ValueError("intrinsic: the given cameras include the lens; leave it out")
        self._check_placing()
        self.read_camera()

    def _check_placing(self) -> None:
        check_masks(self.masks)
        names = ("camera_model", "pairs", "mapper", "max_features", "seed")
        SfmSettings(**{name: getattr(self, name) for name in names})  # checks them
        if not isinstance(self.panorama, bool):
            raise TypeError(f"panorama: expected True or False, got {type(self.panorama).__name__}")
        if self.panorama and (self.intrinsic is not None or self.camera_model != "SIMPLE_RADIAL"):
            raise ValueError("panorama: the camera of cube faces is known; leave out intrinsic and camera_model")
        if self.cameras is None:
            return
        for name, usual in (
            ("camera_model", "SIMPLE_RADIAL"),
            ("pairs", "auto"),
            ("panorama", False),
            ("mapper", "auto"),
        ):
            if getattr(self, name) != usual:
                raise ValueError(f"{name}: only used to estimate poses, but cameras gives them; leave it out")

    def digest_of_masks(self) -> dict[str, str]:
        """Digest of the masks for records. Unique for functions, which cannot be compared."""
        if self.masks is None:
            return {}
        if callable(self.masks):
            return {"masks": secrets.token_hex(16)}
        return {"masks": ALPHA if self.masks == ALPHA else digest_of_source(self.masks)}

    def read_camera(self) -> PinholeCameraIntrinsic | None:
        """The known camera, or None.

        Raises:
            FileError: Its file cannot be read.
        """
        if isinstance(self.intrinsic, str | os.PathLike):
            return read_pinhole_camera_intrinsic(self.intrinsic)
        return self.intrinsic

    def read_posed(self, images: Sequence[str]) -> SfmModel | None:
        """The known lenses and poses of the images of these names, or None.

        Raises:
            FileError: Their file cannot be read, or contains no such image.
        """
        if isinstance(self.cameras, str | os.PathLike):
            try:
                return read_cameras(self.cameras, images=images, intrinsic=self.read_camera())
            except FileError:
                raise
            except ValueError as error:
                raise FileError(self.cameras, str(error)) from error
        return self.cameras

    def digest_of_cameras(self) -> str | None:
        """Digest of the given poses."""
        if isinstance(self.cameras, str | os.PathLike):
            return digest_of_source(self.cameras)
        if self.cameras is None:
            return None
        lenses = [[camera.model, camera.width, camera.height, *camera.params] for camera in self.cameras.cameras]
        return digest_of([list(self.cameras.names), lenses, self.cameras.T_camera_world.tolist()])
