"""Clouds larger than memory: tiles whose answer is that of one machine, planned on disk and worked off by processes.

Each public name is loaded when it is first used, as in `pointloom` itself.
"""

from ..public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
