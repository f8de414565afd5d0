"""Cameras and where they stood, under Open3D's names: extrinsics are world to camera."""

from ...public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
