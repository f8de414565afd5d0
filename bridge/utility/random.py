"""Open3D's module `open3d.utility.random`."""

from __future__ import annotations

from ..seeds import set_seed


def seed(seed: int) -> None:
    """Set the seed of all that is random; a process begins with 0, where Open3D begins with another each time."""
    set_seed(seed)
