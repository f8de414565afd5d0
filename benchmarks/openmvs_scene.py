"""Read cameras and sparse points of an OpenMVS scene file (.mvs), to compare surfaces with that tool's.

The file's layout ("MVSI", version 3) is that of its public interface header; numbers are little-endian, lists and texts
start with their length in 64 bits.
"""

from __future__ import annotations

import dataclasses
import os
import struct
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Matrix = NDArray[np.float64]


@dataclasses.dataclass(frozen=True)
class Scene:
    """Results of another tool: names of images, their poses T_camera_world [n, 4, 4] and K [n, 3, 3], and points."""

    names: list[str]
    T_camera_world: Matrix
    K: Matrix
    points: Matrix

    @property
    def centers(self) -> Matrix:
        """Camera centers, shape [n, 3]."""
        R, t = self.T_camera_world[:, :3, :3], self.T_camera_world[:, :3, 3]
        return -np.einsum("nji,nj->ni", R, t)


class _Reader:
    def __init__(self, data: bytes):
        self._data, self._at = data, 0

    def take(self, layout: str) -> tuple:
        values = struct.unpack_from(f"<{layout}", self._data, self._at)
        self._at += struct.calcsize(f"<{layout}")
        return values

    def count(self) -> int:
        return self.take("Q")[0]

    def text(self) -> str:
        return self.take(f"{self.count()}s")[0].decode()

    def matrix(self, *shape: int) -> Matrix:
        return np.array(self.take(f"{np.prod(shape)}d")).reshape(shape)


def read_openmvs_scene(path: str | os.PathLike[str]) -> Scene:
    """Read a scene.

    Raises:
        ValueError: Unsupported layout or version.
    """
    reader = _Reader(Path(path).read_bytes())
    mark, version, _ = reader.take("4sII")
    if mark != b"MVSI" or version != 3:
        raise ValueError(f"{path}: expected an MVSI file of version 3, got {mark!r} of version {version}")
    platforms = [_platform(reader) for _ in range(reader.count())]
    names, poses, K = [], [], []
    for _ in range(reader.count()):
        name = reader.text()
        platform, camera, pose, _ = reader.take("IIII")
        cameras, camera_poses = platforms[platform]
        R, center = camera_poses[pose]
        T = np.eye(4)
        T[:3, :3], T[:3, 3] = R, -R @ center
        names.append(Path(name).name)
        poses.append(T)
        K.append(cameras[camera])
    points = []
    for _ in range(reader.count()):
        points.append(reader.take("3f"))
        reader.take(f"{8 * reader.count()}x")
    return Scene(names, np.array(poses), np.array(K), np.array(points, np.float64))


def _platform(reader: _Reader) -> tuple[list[Matrix], list[tuple[Matrix, Matrix]]]:
    reader.text()
    cameras = []
    for _ in range(reader.count()):
        reader.text()
        reader.take("II")
        cameras.append(reader.matrix(3, 3))
        reader.matrix(3, 3), reader.matrix(3)  # of the camera on its platform
    return cameras, [(reader.matrix(3, 3), reader.matrix(3)) for _ in range(reader.count())]
