"""Structure from motion: a video or a folder of photographs in, posed pictures and sparse points out."""

from ...public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__, __all__ = attach(__name__)
