"""Cameras and their extrinsics (world to camera) under Open3D's names."""

from ...public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
