"""Sample data sets under Open3D's names, read from a folder. Nothing is downloaded."""

from ...public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
