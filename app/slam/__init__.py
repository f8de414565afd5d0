"""Dense SLAM: a moving depth camera without poses in, its path and the surface out.

Each public name is loaded when it is first used, as in `pointloom` itself.
"""

from ...public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__, __all__ = attach(__name__)
