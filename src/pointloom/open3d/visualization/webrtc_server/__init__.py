"""Open3D's switch for windows in the browser, where windows are anyway."""

from ....public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
