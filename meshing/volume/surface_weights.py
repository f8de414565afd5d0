"""How often a voxel has to be seen to count as surface."""

from __future__ import annotations

# A voxel counts as surface when it was seen more often than this; with few frames most are seen once or twice.
WEIGHTS = ((30, 3.0), (10, 1.0), (0, 0.0))  # (from so many frames on, the threshold)


def least_weight(frame_count: int) -> float:
    """A voxel of so many frames counts as surface where it was seen more often than this."""
    return least_weights(frame_count)[0]


def least_weights(frame_count: int) -> list[float]:
    """That, and those of fewer frames behind it, for a surface that it leaves nothing of."""
    return [threshold for frames, threshold in WEIGHTS if frame_count >= frames]
