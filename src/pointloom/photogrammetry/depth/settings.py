"""Settings of monocular depth estimation."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any

from ...cameras.camera import PinholeCameraIntrinsic, is_one_camera, read_pinhole_camera_intrinsic
from ...cameras.depth_range import DEPTH_SCALE
from ...core.checks import check_count, check_positive, check_seed
from ...core.errors import FilePath
from ..sfm.image_folder import check_path
from .presets import DEFAULT, find_preset
from .tiles import MAX_TILES


@dataclass(frozen=True, eq=False)
class DepthSettings:
    """Settings of monocular depth estimation.

    Attributes:
        preset: Type of network, see docs/depth.md.
        intrinsic: Camera of all images, or its file (Open3D's JSON). None as of `estimate_depth`.
        align: File or folder of known depth, as of `estimate_depth`. For a folder also a folder of files by image name.
        depth_scale: Units per meter of integer depth maps.
        tiles: Tiles along the longer side; above 1, tiles refine a large image.
        keep_edges: Keep flying pixels between surfaces.
        seed: Seed of the alignment.

    Raises:
        TypeError, ValueError: One is out of range; named in the message.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.photogrammetry.depth.settings import DepthSettings
        >>> DepthSettings(preset="dpt", tiles=2).align is None
        True
    """

    preset: str = DEFAULT
    intrinsic: FilePath | PinholeCameraIntrinsic | None = None
    align: FilePath | None = None
    depth_scale: float = DEPTH_SCALE
    tiles: int = 1
    keep_edges: bool = False
    seed: int = 0

    def __post_init__(self):
        find_preset(self.preset)
        if self.intrinsic is not None and not is_one_camera(self.intrinsic):
            check_path("intrinsic", self.intrinsic)
        if self.align is not None:
            check_path("align", self.align)
        check_positive("depth_scale", self.depth_scale)
        check_count("tiles", self.tiles, maximum=MAX_TILES, because="smaller tiles lack context")
        check_seed(self.seed)

    def of_each_image(self) -> dict[str, Any]:
        """The common options of `estimate_depth`.

        Raises:
            FileError: The camera file cannot be read.
        """
        camera = self.intrinsic
        if isinstance(camera, str | os.PathLike):
            camera = read_pinhole_camera_intrinsic(camera)
        return {"intrinsic": camera, "depth_scale": self.depth_scale, "tiles": self.tiles, "seed": self.seed}
