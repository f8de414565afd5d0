"""Weight thresholds of surface voxels."""

from __future__ import annotations

# Frame counts above which a voxel is surface. With few frames most voxels are seen once or twice.
FRAME_THRESHOLDS = ((30, 3.0), (10, 1.0), (0, 0.0))  # (minimum number of frames, threshold)


def min_weight(frame_count: int) -> float:
    """Default threshold: a voxel is surface if it was seen more often than this."""
    return min_weights(frame_count)[0]


def min_weights(frame_count: int) -> list[float]:
    """Default threshold, then lower ones for surfaces that it leaves empty."""
    return [threshold for frames, threshold in FRAME_THRESHOLDS if frame_count >= frames]
