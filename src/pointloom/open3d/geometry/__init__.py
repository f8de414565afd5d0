"""Geometries and searches under Open3D's names, changed in place as there."""

from ...public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
