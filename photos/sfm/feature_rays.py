"""Features of COLMAP's database as rays of cameras that are known, all pictures in one table."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.camera_models import CameraModel
from ...core.errors import FileError
from .colmap_jobs import open_database

DESCRIPTOR = 128  # numbers of one
WIDEST = np.tan(np.radians(75.0))  # off the axis, at z = 1: beyond it a pixel of a fisheye's is many of a pinhole's


@dataclasses.dataclass(frozen=True, eq=False)
class FeatureRays:
    """What was found in pictures, and where each of it lies before its camera.

    Args:
        firsts: The first feature of each picture, and the number of all, [n + 1].
        pixels: Where each is in its picture, float64 [m, 2] [px], pixel centres being whole numbers.
        rays: x and y at z = 1, float64 [m, 2]; NaN where the lens has none.
        descriptors: uint8 [m, 128].
    """

    firsts: NDArray[np.int64]
    pixels: NDArray[np.float64]
    rays: NDArray[np.float64]
    descriptors: NDArray[np.uint8]

    def of(self, picture: int) -> slice:
        """The rows of a picture."""
        return slice(int(self.firsts[picture]), int(self.firsts[picture + 1]))


def read_feature_rays(database: Path, names: Sequence[str], cameras: Sequence[CameraModel]) -> FeatureRays:
    """The features of some of a database's pictures, in this order.

    Raises:
        FileError: A picture that the database does not have, or features that are not SIFT's.
    """
    pixels, descriptors = [], []
    with open_database(database) as connection:
        numbers = dict(connection.execute("SELECT name, image_id FROM images").fetchall())
        for name in names:
            if name not in numbers:
                raise FileError(database, f"has no picture {name}", remedy="sfm.find_features makes one")
            pixels.append(table_of(connection, "keypoints", numbers[name], np.float32, database)[:, :2])
            descriptors.append(table_of(connection, "descriptors", numbers[name], np.uint8, database))
    for places, kinds in zip(pixels, descriptors, strict=True):
        if len(places) != len(kinds) or (len(kinds) and kinds.shape[1] != DESCRIPTOR):
            raise FileError(database, "holds features that are not SIFT's", remedy="sfm.find_features makes one")
    firsts = np.concatenate([[0], np.cumsum([len(each) for each in pixels])]).astype(np.int64)
    at = [each.astype(np.float64) - 0.5 for each in pixels]  # COLMAP has the middle of the first pixel at a half
    rays = [camera.unproject(each)[:, :2] for camera, each in zip(cameras, at, strict=True)]
    joined = np.concatenate(rays) if rays else np.zeros((0, 2))
    with np.errstate(invalid="ignore"):
        joined[~(np.linalg.norm(joined, axis=1) < WIDEST)] = np.nan
    kinds = [each.reshape(-1, DESCRIPTOR) for each in descriptors]
    return FeatureRays(firsts, np.concatenate(at), joined, np.concatenate(kinds))


def table_of(connection, name: str, number: int, kind: type, database: Path) -> NDArray:
    """The rows of a picture in a table of numbers."""
    row = connection.execute(f"SELECT rows, cols, data FROM {name} WHERE image_id = ?", (number,)).fetchone()
    rows, columns, data = row if row is not None else (0, 2, b"")
    if not rows:
        return np.zeros((0, 2), kind)
    if len(data) != rows * columns * np.dtype(kind).itemsize:
        raise FileError(database, f"is damaged: {name} of picture {number}", remedy="sfm.find_features makes one")
    return np.frombuffer(data, kind).reshape(rows, columns)


def focal_of(camera: CameraModel) -> float:
    """Pixels of a camera's picture in one of a ray at z = 1, about its middle."""
    straight = pinhole_of(camera)
    return float(np.sqrt(straight.fx * straight.fy))


def pinhole_of(camera: CameraModel) -> PinholeCameraIntrinsic:
    """The camera without distortion whose pixels are as large as this one's in the middle of its picture."""
    if camera.is_pinhole:
        return camera.intrinsic
    middle = np.array([(camera.width - 1) / 2, (camera.height - 1) / 2])
    around = camera.unproject(middle + np.array([(0, 0), (0.5, 0), (-0.5, 0), (0, 0.5), (0, -0.5)]))
    fx, fy = 1 / np.linalg.norm(around[1] - around[2]), 1 / np.linalg.norm(around[3] - around[4])
    if not (np.isfinite(fx) and np.isfinite(fy)):
        fx = fy = float(max(camera.width, camera.height))
    off = around[0, :2] if np.isfinite(around[0]).all() else np.zeros(2)
    cx, cy = (middle - off * np.array([fx, fy])).tolist()
    return PinholeCameraIntrinsic(camera.width, camera.height, float(fx), float(fy), cx, cy)
