"""Materials under Open3D's names. The rendering engine itself is missing."""

from ....public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
