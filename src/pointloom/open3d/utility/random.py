"""Open3D's module `open3d.utility.random`."""

from __future__ import annotations

from ..seeds import set_seed


def seed(seed: int) -> None:
    """Set the global seed. It is initially 0 (in Open3D random)."""
    set_seed(seed)
