"""The motion of a depth camera between two frames: RGB-D odometry that says when it failed.

Each public name is loaded when it is first used, as in `pointloom` itself.
"""

from ...public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__, __all__ = attach(__name__)
