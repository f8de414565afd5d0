"""What decides what becomes of pictures whose depth a network estimates."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any

from ...cameras.camera import PinholeCameraIntrinsic, read_pinhole_camera_intrinsic
from ...core.checks import check_count, check_positive, check_seed
from ...core.errors import FilePath
from ..sfm.picture_folder import check_place
from .presets import DEFAULT, find_preset
from .tiles import MOST_TILES


@dataclass(frozen=True, eq=False)
class DepthSettings:
    """What decides the depth of pictures, beside them and the network.

    Attributes:
        preset: Which network it is, see docs/depth.md.
        intrinsic: The camera of all pictures, or the file of one (Open3D's JSON); None as `estimate_depth` has it.
        align: A file or folder of what is known of the depth, as `estimate_depth` takes it; of a folder of pictures
            also a folder of such files with the pictures' names.
        depth_scale: Units a metre of depth maps in whole numbers.
        tiles: Along the longer side; more than 1 shows a large picture to the network in parts as well.
        keep_edges: Keep points that fly between two surfaces.
        seed: Of the alignment.

    Raises:
        TypeError, ValueError: One is out of range; the error names it.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.photos.depth.settings import DepthSettings
        >>> DepthSettings(preset="dpt", tiles=2).align is None
        True
    """

    preset: str = DEFAULT
    intrinsic: FilePath | PinholeCameraIntrinsic | None = None
    align: FilePath | None = None
    depth_scale: float = 1000.0
    tiles: int = 1
    keep_edges: bool = False
    seed: int = 0

    def __post_init__(self):
        find_preset(self.preset)
        if not isinstance(self.intrinsic, PinholeCameraIntrinsic | None):
            check_place("intrinsic", self.intrinsic)
        if self.align is not None:
            check_place("align", self.align)
        check_positive("depth_scale", self.depth_scale)
        check_count("tiles", self.tiles, maximum=MOST_TILES, because="a tile shows too little")
        check_seed(self.seed)

    def of_each_picture(self) -> dict[str, Any]:
        """The options of `estimate_depth` that all pictures share.

        Raises:
            FileError: The file of the camera cannot be read.
        """
        camera = self.intrinsic
        if isinstance(camera, str | os.PathLike):
            camera = read_pinhole_camera_intrinsic(camera)
        return {"intrinsic": camera, "depth_scale": self.depth_scale, "tiles": self.tiles, "seed": self.seed}
