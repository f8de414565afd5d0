"""Sizes of a volume that frames of a camera can be folded into."""

from __future__ import annotations

from typing import Any

from ...core.checks import LARGEST_NUMBER, check_positive, shown

LEAST_VOXEL = 1e-6  # [m] below it a frame of a few metres reaches beyond the volume's keys
MOST_VOXELS = 2**23  # that keys hold from the origin on, either way


def check_sizes(voxel_size: Any, truncation: Any = None) -> tuple[float, float | None]:
    """The edge of a voxel [m], and the truncation [m] or None, before the first frame is read.

    Raises:
        TypeError: No numbers.
        ValueError: Not positive, or so small or large that no frame can be folded in.
    """
    edge = check_positive("voxel_size", voxel_size, maximum=LARGEST_NUMBER)
    if edge < LEAST_VOXEL:
        raise ValueError(f"voxel_size: expected at least {LEAST_VOXEL:g} m, got {shown(voxel_size)}")
    if truncation is None:
        return edge, None
    return edge, check_positive("truncation", truncation, maximum=MOST_VOXELS * edge)
