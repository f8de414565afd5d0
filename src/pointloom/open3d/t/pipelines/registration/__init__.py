"""Open3D's names of `t.pipelines.registration`."""

from .....public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
