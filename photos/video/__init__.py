"""A video, or a folder of pictures, to a mesh: the stages one after the other, each whole or not at all.

`reconstruct` is the whole chain; `loom.sfm` and `loom.mvs` hold its parts. Each public name is loaded when it is first
used, as in `pointloom` itself.

Example:
    What `pointloom video walk.mp4 -o room.ply` does, with what comes out as objects:

        result = loom.video.reconstruct("walk.mp4", outputs=loom.video.Outputs(mesh="room.ply"))
        print(result.warnings or result)  # what the command prints
        result.mesh, result.cloud, result.model

    Settings are checked before any work:

    >>> import pointloom as loom
    >>> loom.video.Settings(max_frames=1)
    Traceback (most recent call last):
    ValueError: max_frames: expected a whole number >= 2, got 1
"""

from ...public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
