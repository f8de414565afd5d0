"""Reconstruction of a mesh from a video or a folder of images.

`reconstruct` runs all stages; `loom.sfm` and `loom.mvs` contain them.

Example:
    `pointloom video walk.mp4 -o room.ply` in Python:

        result = loom.video.reconstruct("walk.mp4", outputs=loom.video.Outputs(mesh="room.ply"))
        print(result.warnings or result)  # what the command prints
        result.mesh, result.cloud, result.model

    Settings are checked before any work:

    >>> import pointloom as loom
    >>> loom.video.Settings(max_frames=1)
    Traceback (most recent call last):
    ValueError: max_frames: expected an integer >= 2, got 1
"""

from ...public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
