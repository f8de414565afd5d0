"""File input and output under Open3D's names. Missing or damaged files raise errors. Writers return True or raise."""

from ...public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
