"""Windows and their controls under Open3D's names, as pages of the browser or as pictures."""

from ...public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
