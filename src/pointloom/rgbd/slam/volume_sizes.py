"""Checks of volume sizes."""

from __future__ import annotations

from ...core.checks import LARGEST_NUMBER, check_positive, shown

MIN_VOXEL = 1e-6  # [m] below it a frame of a few meters exceeds the range of the volume's keys
MAX_VOXELS = 2**23  # range of the keys in either direction


def check_sizes(voxel_size: object, truncation: object = None) -> tuple[float, float | None]:
    edge = check_positive("voxel_size", voxel_size, maximum=LARGEST_NUMBER)
    if edge < MIN_VOXEL:
        raise ValueError(f"voxel_size: expected at least {MIN_VOXEL:g} m, got {shown(voxel_size)}")
    return edge, None if truncation is None else check_positive("truncation", truncation, maximum=MAX_VOXELS * edge)
