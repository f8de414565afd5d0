"""Synthetic scenes with ground truth, and public data sets by name. Names are loaded on first use.

Example:
    >>> import pointloom as loom
    >>> frame = loom.datasets.room_frames(1, width=32, height=24)[0]
    >>> frame.color.shape, frame.depth.shape
    ((24, 32, 3), (24, 32))
"""

from ..public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
