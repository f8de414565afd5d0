"""Files under Open3D's names, read and written by ours: what is missing or damaged is an error, not an empty object.

Writers return True; what cannot be written is an error, too.
"""

from ...public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
