"""The reconstruction system: frames of a moving depth camera, without poses, to one model, in stages that can resume.

Each public name is loaded when it is first used, as in `pointloom` itself.
"""

from ...public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__, __all__ = attach(__name__)
