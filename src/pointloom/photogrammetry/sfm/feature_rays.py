"""Features of COLMAP's database as rays of known cameras."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.camera_models import CameraModel
from ...core.errors import FileError
from .colmap_jobs import names_by_number, open_database

DESCRIPTOR_LENGTH = 128  # numbers per descriptor
MAX_RAY_TANGENT = np.tan(np.radians(75.0))  # tan of 75 degrees: beyond it a fisheye pixel spans many pinhole pixels


@dataclasses.dataclass(frozen=True, eq=False)
class FeatureRays:
    """Features of all images: offsets [n + 1], pixels [m, 2], rays at z = 1 (or NaN), descriptors uint8 [m, 128]."""

    firsts: NDArray[np.int64]
    pixels: NDArray[np.float64]
    rays: NDArray[np.float64]
    descriptors: NDArray[np.uint8]

    def of(self, image: int) -> slice:
        return slice(int(self.firsts[image]), int(self.firsts[image + 1]))


def read_feature_rays(database: Path, names: Sequence[str], cameras: Sequence[CameraModel]) -> FeatureRays:
    pixels, descriptors = [], []
    with open_database(database) as connection:
        numbers = {name: number for number, name in names_by_number(connection, database).items()}
        for name in names:
            if name not in numbers:
                raise FileError(
                    database, f"contains no image {name}", remedy="photogrammetry.find_features creates one"
                )
            pixels.append(table_of(connection, "keypoints", numbers[name], np.float32, database)[:, :2])
            descriptors.append(table_of(connection, "descriptors", numbers[name], np.uint8, database))
    for keypoints, kinds in zip(pixels, descriptors, strict=True):
        if len(keypoints) != len(kinds) or (len(kinds) and kinds.shape[1] != DESCRIPTOR_LENGTH):
            raise FileError(
                database, "contains features other than SIFT", remedy="photogrammetry.find_features creates one"
            )
    firsts = np.concatenate([[0], np.cumsum([len(each) for each in pixels])]).astype(np.int64)
    at = [each.astype(np.float64) - 0.5 for each in pixels]  # COLMAP's first pixel center is at 0.5
    rays = [camera.unproject(each)[:, :2] for camera, each in zip(cameras, at, strict=True)]
    joined = np.concatenate(rays) if rays else np.zeros((0, 2))
    with np.errstate(invalid="ignore"):
        joined[~(np.linalg.norm(joined, axis=1) < MAX_RAY_TANGENT)] = np.nan
    kinds = [each.reshape(-1, DESCRIPTOR_LENGTH) for each in descriptors]
    return FeatureRays(firsts, np.concatenate(at), joined, np.concatenate(kinds))


def table_of(connection, name: str, number: int, kind: type, database: Path, *, column: str = "image_id") -> NDArray:
    row = connection.execute(f"SELECT rows, cols, data FROM {name} WHERE {column} = ?", (number,)).fetchone()
    rows, columns, data = row if row is not None else (0, 2, b"")
    if not rows:
        return np.zeros((0, 2), kind)
    if len(data) != rows * columns * np.dtype(kind).itemsize:
        raise FileError(
            database, f"is damaged: {name} of image {number}", remedy="photogrammetry.find_features creates one"
        )
    return np.frombuffer(data, kind).reshape(rows, columns)


def focal_of(camera: CameraModel) -> float:
    """Pixels per ray unit at z = 1 near the center."""
    straight = pinhole_of(camera)
    return float(np.sqrt(straight.fx * straight.fy))


def pinhole_of(camera: CameraModel) -> PinholeCameraIntrinsic:
    """The undistorted camera with the same pixel size in the center."""
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
