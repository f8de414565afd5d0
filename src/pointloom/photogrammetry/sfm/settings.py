"""Settings of structure from motion."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.camera_models import CameraModel
from ...core.checks import check_count, check_name, check_seed, shown
from .colmap_jobs import MAX_SECONDS
from .frames import check_option
from .limited_process import check_limits

CAMERA_MODELS = (
    *("SIMPLE_PINHOLE", "PINHOLE", "SIMPLE_RADIAL", "RADIAL", "OPENCV", "OPENCV_FISHEYE", "FULL_OPENCV", "FOV"),
    *("SIMPLE_RADIAL_FISHEYE", "RADIAL_FISHEYE", "THIN_PRISM_FISHEYE"),
)
FEATURE_KINDS = ("sift", "aliked")
MAX_FEATURES = 4096
PAIRS = ("auto", "sequential", "exhaustive", "retrieval")
SEQUENCE_OVERLAP = 10
PARTNERS_PER_IMAGE = 10
MAPPERS = ("auto", "incremental", "global")

_LONGEST_SIDE = 2**16
_MAX_FEATURES = 2**17
_MAX_NEIGHBORS = 10_000
_MAX_OVERLAP = 30  # powers of two


@dataclass(frozen=True)
class SfmSettings:
    """Settings of structure from motion, the same for all of its stages.

    Attributes:
        camera_model: COLMAP camera model whose parameters are estimated. Images with the same size and the same EXIF
            make, model and focal length share a camera.
        intrinsic: Known camera of all images, scaled to their size; None: estimated.
        fix_intrinsic: Keep the known camera; None: if there is one.
        max_size: Maximum image side for feature extraction [px].
        max_features: Maximum number per image.
        kind: Features: "sift", or "aliked" (Zhao et al. 2023) if pycolmap was built with ONNX (not that of PyPI).
        use_gpu: Use a GPU (requires pycolmap-cuda12); None: if available. Features differ from the CPU's.
        pairs: Matched images. "sequential" for images in capture order (video); "exhaustive" for all pairs;
            "retrieval" for the most similar images; "auto": exhaustive up to 40 images, else sequential and retrieval.
        overlap: Sequential: number of later images per image, at distances 1, 2, 4, 8, ...
        neighbors: Retrieval: number of most similar images per image.
        mapper: "incremental" (Schoenberger and Frahm 2016), "global" (GLOMAP, Pan et al. 2024), or "auto": incremental
            up to 150 images (measured in docs/sfm.md).
        seed: Random seed.
        max_seconds: Time limit per stage [s]; None: no limit.
        max_memory: Memory limit of COLMAP [B]; None: nine tenths of the free memory.

    Raises:
        TypeError, ValueError: One is out of range; named in the message.

    Example:
        >>> import pointloom as loom
        >>> settings = loom.photogrammetry.SfmSettings(camera_model="OPENCV_FISHEYE", mapper="global")
        >>> settings.max_features, settings.keeps_intrinsic
        (4096, False)
    """

    camera_model: str = "SIMPLE_RADIAL"
    intrinsic: PinholeCameraIntrinsic | CameraModel | None = None
    fix_intrinsic: bool | None = None
    max_size: int = 1600
    max_features: int = MAX_FEATURES
    kind: str = "sift"
    use_gpu: bool | None = None
    pairs: str = "auto"
    overlap: int = SEQUENCE_OVERLAP
    neighbors: int = PARTNERS_PER_IMAGE
    mapper: str = "auto"
    seed: int = 0
    max_seconds: float | None = MAX_SECONDS
    max_memory: int | None = None

    def __post_init__(self):
        if check_name("camera_model", self.camera_model) not in CAMERA_MODELS:
            known = ", ".join(CAMERA_MODELS)
            raise ValueError(f"camera_model: expected one of {known}, got {shown(self.camera_model)}")
        _check_intrinsic(self.intrinsic)
        for name in ("fix_intrinsic", "use_gpu"):
            if not isinstance(value := getattr(self, name), bool | None):
                raise TypeError(f"{name}: expected True, False or None, got {type(value).__name__}")
        pixels, slow = "no camera has more pixels", "the matching time grows with its square"
        every = 'pairs="exhaustive" matches all'
        check_count("max_size", self.max_size, minimum=64, maximum=_LONGEST_SIDE, because=pixels)
        check_count("max_features", self.max_features, minimum=64, maximum=_MAX_FEATURES, because=slow)
        check_count("overlap", self.overlap, maximum=_MAX_OVERLAP, because=every)
        check_count("neighbors", self.neighbors, maximum=_MAX_NEIGHBORS, because=every)
        check_option("kind", self.kind, FEATURE_KINDS)
        check_option("pairs", self.pairs, PAIRS)
        check_option("mapper", self.mapper, MAPPERS)
        check_seed(self.seed)
        check_limits(self.max_seconds, self.max_memory)

    @property
    def keeps_intrinsic(self) -> bool:
        """True if the cameras of the features are not refined."""
        return self.intrinsic is not None if self.fix_intrinsic is None else self.fix_intrinsic


def check_settings(settings: Any) -> SfmSettings:
    if not isinstance(settings, SfmSettings | None):
        raise TypeError(f"settings: expected SfmSettings, got {type(settings).__name__}")
    return SfmSettings() if settings is None else settings


def _check_intrinsic(intrinsic: Any) -> None:
    if intrinsic is not None and not isinstance(intrinsic, PinholeCameraIntrinsic | CameraModel):
        kind = type(intrinsic).__name__
        remedy = "create one with PinholeCameraIntrinsic.from_matrix(K, width, height)"
        raise TypeError(f"intrinsic: expected a PinholeCameraIntrinsic, a CameraModel or None, got {kind}; {remedy}")
    if isinstance(intrinsic, CameraModel) and intrinsic.model.startswith("METASHAPE"):
        raise ValueError(f"intrinsic: COLMAP has no model {intrinsic.model}; undistort the images first")
