"""Open3D's names of `core.nns`."""

from ....public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
