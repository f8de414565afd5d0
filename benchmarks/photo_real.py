"""Real sets of photographs for photo_chain.py, with the available ground truth."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from real_data import real_data

LONGEST = 1024  # [px] maximum size; larger images are reduced


@dataclass
class RealSet:
    """Images, and the poses of some.

    Attributes:
        poses: T_world_camera by file name without suffix.
    """

    images: list[Path]
    poses: dict[str, NDArray[np.float64]]

    def write(self, folder: Path) -> None:
        (folder / "images").mkdir(parents=True)
        for path in self.images:
            with Image.open(path) as image:
                if max(image.size) <= LONGEST:
                    shutil.copy(path, folder / "images")
                    continue
                exif: Any = image.getexif()
                image.thumbnail((LONGEST, LONGEST), Image.Resampling.LANCZOS)
                image.save(folder / "images" / f"{path.stem}.jpg", quality=95, exif=exif)


def temple() -> RealSet:
    """templeSparseRing (Seitz et al. 2006): 16 images on black background, about 20 degrees apart."""
    folder, poses = real_data("mvs-temple"), {}
    for line in (folder / "templeSR_par.txt").read_text().splitlines()[1:]:
        name, *numbers = line.split()
        values = np.array(numbers, float)
        T = np.eye(4)
        T[:3, :3], T[:3, 3] = values[9:18].reshape(3, 3), values[18:]
        poses[Path(name).stem] = np.linalg.inv(T)
    return RealSet(sorted(folder.glob("*.png")), poses)


def fountain() -> RealSet:
    """fountain-P11 (Strecha et al. 2008): eleven images with poses from a laser scanner."""
    folder, poses = real_data("mvs-fountain-p11"), {}
    for path in sorted((folder / "gt_dense_cameras").glob("*.camera")):
        values = np.array(path.read_text().split()[:24], float)
        T = np.eye(4)
        T[:3, :3], T[:3, 3] = values[12:21].reshape(3, 3), values[21:24]
        poses[Path(path.stem).stem] = T
    return RealSet(sorted((folder / "images").glob("*.jpg")), poses)


def sceaux() -> RealSet:
    """Sceaux Castle (openMVG): eleven images of a facade, without poses."""
    return RealSet(sorted((real_data("mvs-sceaux") / "images").glob("*.JPG")), {})


REAL: dict[str, Callable[[], RealSet]] = {"temple": temple, "fountain": fountain, "sceaux": sceaux}
