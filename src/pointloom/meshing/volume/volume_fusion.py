"""Fusion of posed volumes into one."""

from __future__ import annotations

import hashlib
from collections import Counter
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_list, check_positive, check_rigid
from ...core.coordinates import origin_of_sensor
from ...core.devices import check_same_device
from ...core.serialized import locked_objects
from ...kernels.linear_algebra import inv, matmul
from ...kernels.memory import download
from ...kernels.volumes.volume_fusion import check_range, fuse_moved
from .tsdf import FrameState, TSDFVolume

Matrix = NDArray[np.float64]


class _Moved(NamedTuple):
    """A volume and its pose T_world_volume."""

    volume: TSDFVolume
    pose: Matrix

    @property
    def sort_key(self) -> tuple[Any, ...]:
        """Sort key independent of input order: poses and sizes."""
        volume = self.volume
        sizes = (volume.voxel_size, volume.truncation, volume.block_count, volume.frame_count)
        return (*self.pose[:3].ravel().tolist(), *volume.origin.tolist(), *sizes)

    @property
    def digest(self) -> bytes:
        """Second sort key: hash of the voxels."""
        arrays = self.volume.downloaded()
        order = np.argsort(arrays["keys"])
        digest = hashlib.sha256(arrays["keys"][order].tobytes())
        for name in ("distances", "weights", "colors"):
            if name in arrays:
                digest.update(arrays[name].reshape(len(order), -1)[order].tobytes())
        return digest.digest()


def fuse_volumes(
    volumes: Sequence[TSDFVolume],
    poses: ArrayLike,
    *,
    voxel_size: float | None = None,
    truncation: float | None = None,
    color: bool | None = None,
) -> TSDFVolume:
    """Fuse volumes with rigid poses into one.

    A voxel is the mean of the volumes at its position, weighted by frames; trilinear where all eight voxels were seen,
    exact where grids coincide. Independent of the order of volumes. Distances are not changed by motion, since all are
    zero on the surface; observed regions shrink by up to a voxel. 12 B per voxel. Bitwise reproducible. Curless and
    Levoy, "A volumetric method for building complex models from range images", SIGGRAPH 1996, section 3.3.

    Args:
        volumes: At least one, all on one device. Not changed.
        poses: T_world_volume of each, shape (n, 4, 4).
        voxel_size: Of the result [m]. If None: the largest of the inputs.
        truncation: Of the result [m], at most the smallest of the inputs, the default.
        color: Keep color. If None: if all volumes with frames have it.

    Returns:
        The volume. Its `frame_count` is the sum. Weights are limited to 65535. More frames can be integrated.

    Raises:
        ValueError: If there is no volume, poses are not rigid or disagree in number, a size, truncation or color is
            invalid, or the result exceeds 2^20 blocks each way or 32-bit indices.
        TypeError, DeviceError: If an item is not a TSDFVolume, or if the volumes are on different devices.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> volume = loom.TSDFVolume(voxel_size=0.02, color=False)
        >>> touched = volume.integrate(np.full((48, 64), 1000, np.uint16), camera, np.eye(4))
        >>> pose = np.eye(4)
        >>> pose[2, 3] = 0.5  # half a metre further along z
        >>> mesh = loom.meshing.fuse_volumes([volume], [pose]).extract_triangle_mesh(weight_threshold=0)
        >>> bool(np.allclose(mesh.vertices[:, 2], 1.5, atol=1e-5))
        True
    """
    moved = _check_volumes(volumes, poses)
    with locked_objects(m.volume for m in moved):
        return _fuse(moved, voxel_size, truncation, color)


def _fuse(moved: list[_Moved], voxel_size: float | None, truncation: float | None, color: bool | None) -> TSDFVolume:
    first = moved[0].volume
    filled = [m.volume for m in moved if m.volume.frame_count]
    coarsest = max(m.volume.voxel_size for m in moved)
    thinnest = min(m.volume.truncation for m in moved)
    size = coarsest if voxel_size is None else check_positive("voxel_size", voxel_size)
    limit = thinnest if truncation is None else check_positive("truncation", truncation)
    if limit > thinnest:
        raise ValueError(
            f"truncation: expected at most {thinnest} m, the smallest truncation of the volumes, got {limit} m"
        )
    if limit < size:
        raise ValueError(f"truncation: {limit} m is below one voxel ({size} m)")
    has_color = all(v.has_frame_colors for v in filled or [first]) if color is None else bool(color)
    if color and not all(v.has_frame_colors for v in filled):
        raise ValueError(
            "color: a volume has no colors. Pass color=False, or None to keep colors if all volumes have them"
        )
    result = TSDFVolume(voxel_size=size, truncation=limit, color=has_color, device=first.device)
    if not filled:
        return result
    moved = _in_fixed_order([m for m in moved if m.volume.frame_count])
    origin = origin_of_sensor(matmul(moved[0].pose[:3, :3], moved[0].volume.origin) + moved[0].pose[:3, 3])
    if (moved[0].pose == np.eye(4)).all():
        origin = moved[0].volume.origin  # keeps its grid
    backs = [_way_back(m, origin, size) for m in moved]
    for m, back in zip(moved, backs, strict=True):
        if m.volume.block_count:
            check_range(download(m.volume.blocks.keys[: m.volume.block_count]), back)
    blocks = [m.volume.blocks for m in moved]
    fused = fuse_moved(blocks, backs, has_color, size, limit, has_color, first.device)
    frames = FrameState(sum(v.frame_count for v in filled), origin, has_color)
    result.set_content(fused, frames, first.array_library)
    return result


def _check_volumes(volumes: Sequence[TSDFVolume], poses: ArrayLike) -> list[_Moved]:
    items = check_list("volumes", volumes, "TSDFVolumes")
    if not items:
        raise ValueError("volumes: expected at least one, got none")
    for i, volume in enumerate(items):
        if not isinstance(volume, TSDFVolume):
            raise TypeError(f"volumes[{i}]: expected a TSDFVolume, got {type(volume).__name__}")
        check_same_device(f"volumes[{i}]", items[0].device, volume.device)
    matrices = check_list("poses", poses, "poses")  # type: ignore[arg-type]
    if len(matrices) != len(items):
        raise ValueError(f"poses: expected {len(items)}, one for each volume, got {len(matrices)}")
    return [_Moved(v, check_rigid(f"poses[{i}]", T)) for i, (v, T) in enumerate(zip(items, matrices, strict=True))]


def _in_fixed_order(moved: list[_Moved]) -> list[_Moved]:
    sort_keys = [m.sort_key for m in moved]
    alike = {sort_key for sort_key, count in Counter(sort_keys).items() if count > 1}
    complete_keys = [
        (sort_key, m.digest if sort_key in alike else b"") for sort_key, m in zip(sort_keys, moved, strict=True)
    ]
    return [moved[i] for i in sorted(range(len(moved)), key=complete_keys.__getitem__)]


def _way_back(moved: _Moved, origin: Matrix, voxel_size: float) -> Matrix:
    """Map voxels of the result to those of a volume; exactly the identity if both grids coincide."""
    volume, R, t = moved.volume, moved.pose[:3, :3], moved.pose[:3, 3]
    back = np.eye(4)
    inverse = inv(R)  # exact inverse, since rotations from files may be rounded
    back[:3, :3] = inverse * (voxel_size / volume.voxel_size)
    back[:3, 3] = (matmul(inverse, origin - t) - volume.origin) / volume.voxel_size
    return back
