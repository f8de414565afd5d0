"""Volumes fused into one, each moved by a pose."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_list, check_positive, check_rigid
from ...core.coordinates import origin_of_sensor
from ...core.devices import check_same_device
from ...kernels.linear_algebra import inv, matmul
from ...kernels.memory import download
from ...kernels.volumes.volume_fusion import check_reach, fuse_moved
from .tsdf import TSDFVolume

Matrix = NDArray[np.float64]


class _Moved(NamedTuple):
    """A volume and its pose T_world_volume."""

    volume: TSDFVolume
    pose: Matrix

    @property
    def place(self) -> tuple[Any, ...]:
        """What orders volumes, whatever order they were given in: their poses and sizes."""
        volume = self.volume
        sizes = (volume.voxel_size, volume.truncation, volume.block_count, volume.frame_count)
        return (*self.pose[:3].ravel().tolist(), *volume.origin.tolist(), *sizes)

    @property
    def digest(self) -> bytes:
        """What orders those that are alike in that: their voxels."""
        arrays = self.volume._downloaded()
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
    """One volume of several, each moved by a rigid pose: what their frames would have made of one.

    Each voxel of the result is the mean of what the volumes hold at its place, weighted by the frames that saw it
    there: trilinear between eight voxels, all of which have to have been seen. Where a voxel falls on another it takes
    its bits over: a single volume that is moved by whole voxels is the same volume. The order in which volumes are
    given does not matter.

    Args:
        volumes: At least one, all on one device. They stay as they are.
        poses: T_world_volume of each, shape [n, 4, 4]; the identity for volumes that hold world coordinates.
        voxel_size: Of the result [m]; None for the largest of theirs. Finer ones hold no more than the volumes do, and
            coarser ones look at single voxels of them, without a mean over more.
        truncation: Of the result [m], at most the smallest of theirs; None for that.
        color: Whether the result keeps colour; None where all volumes with frames have it.

    Returns:
        The volume. Its `frame_count` is the sum of theirs; weights stop at 65535. Its origin is zero or, if the
        poses put volumes beyond 128 m, near the first in the order of their poses. More frames can be integrated.

    Raises:
        ValueError: No volumes, poses that are not as many or no rigid motions, sizes that are not positive, a
            truncation below a voxel or above the smallest of the volumes', colour where a volume has none, volumes
            without a common frame of 2^20 blocks each way, or more blocks than 32 bits can index.
        TypeError: Not TSDFVolumes.
        DeviceError: Volumes on different devices.

    Notes:
        Distances are along the cameras' z: no motion changes them, and all have their zero on the surface. A voxel
        beside an unseen one gives nothing where a place lies between, so what was seen ends up to a voxel earlier.
        Some 2 blocks are looked at, and held with the result, for each that the volumes have: 12 B a voxel. The same
        bits from run to run, whatever the number of threads. Curless and Levoy, SIGGRAPH 1996, section 3.3.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> volume = loom.TSDFVolume(voxel_size=0.02, color=False)
        >>> touched = volume.integrate(np.full((48, 64), 1000, np.uint16), camera, np.eye(4))
        >>> pose = np.eye(4)
        >>> pose[2, 3] = 0.5  # half a metre further along z
        >>> mesh = loom.fuse_volumes([volume], [pose]).extract_triangle_mesh(weight_threshold=0)
        >>> bool(np.allclose(mesh.vertices[:, 2], 1.5, atol=1e-5))
        True
    """
    moved = _check_volumes(volumes, poses)
    first = moved[0].volume
    filled = [m.volume for m in moved if m.volume.frame_count]
    coarsest = max(m.volume.voxel_size for m in moved)
    thinnest = min(m.volume.truncation for m in moved)
    size = coarsest if voxel_size is None else check_positive("voxel_size", voxel_size)
    limit = thinnest if truncation is None else check_positive("truncation", truncation)
    if limit > thinnest:
        raise ValueError(f"truncation: {limit} m is beyond {thinnest} m, where distances of a volume are cut already")
    if limit < size:
        raise ValueError(f"truncation: {limit} m is below one voxel ({size} m)")
    has_color = all(v.has_frame_colors for v in filled or [first]) if color is None else bool(color)
    if color and not all(v.has_frame_colors for v in filled):
        raise ValueError("color: a volume has no colours; give color=False, or None to keep them where all have them")
    result = TSDFVolume(voxel_size=size, truncation=limit, color=has_color, device=first.device)
    if not filled:
        return result
    moved = _in_fixed_order([m for m in moved if m.volume.frame_count])
    origin = origin_of_sensor(matmul(moved[0].pose[:3, :3], moved[0].volume.origin) + moved[0].pose[:3, 3])
    if (moved[0].pose == np.eye(4)).all():
        origin = moved[0].volume.origin  # its grid stays
    backs = [_way_back(m, origin, size) for m in moved]
    for m, back in zip(moved, backs, strict=True):
        if m.volume.block_count:
            check_reach(download(m.volume._blocks.keys[: m.volume.block_count]), back)
    blocks = [m.volume._blocks for m in moved]
    fused = fuse_moved(blocks, backs, has_color, size, limit, has_color, first.device)
    result._adopt(fused, sum(v.frame_count for v in filled), origin, has_color, first.array_library)
    return result


def _check_volumes(volumes: Sequence[TSDFVolume], poses: ArrayLike) -> list[_Moved]:
    """Volumes and their poses, once they are sound."""
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
    """The volumes by their poses and sizes, and by their voxels where these are the same."""
    places = [m.place for m in moved]
    alike = {place for place in places if places.count(place) > 1}
    keys = [(place, m.digest if place in alike else b"") for place, m in zip(places, moved, strict=True)]
    return [moved[i] for i in sorted(range(len(moved)), key=keys.__getitem__)]


def _way_back(moved: _Moved, origin: Matrix, voxel_size: float) -> Matrix:
    """The voxels of the result in those of a volume: exactly the identity where both grids are one."""
    volume, R, t = moved.volume, moved.pose[:3, :3], moved.pose[:3, 3]
    back = np.eye(4)
    turn = inv(R)  # of a matrix that files rounded to a few digits the way back, not the transpose
    back[:3, :3] = turn * (voxel_size / volume.voxel_size)
    back[:3, 3] = (matmul(turn, origin - t) - volume.origin) / volume.voxel_size
    return back
