"""Windows and their controls under Open3D's names, as browser pages or images."""

from ...public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
