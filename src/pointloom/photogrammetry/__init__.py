"""Photographs and videos to cameras, depth maps and meshes. Names are loaded on first use.

Examples:
    >>> import numpy as np, pointloom as loom
    >>> camera = loom.PinholeCameraIntrinsic(8, 6, 10.0, 10.0, 3.5, 2.5)
    >>> loom.photogrammetry.PosedCamera(camera, np.eye(4)).center.tolist()
    [0.0, 0.0, 0.0]

    Frames of a video, their poses, and whether these are reliable::

        choice = loom.photogrammetry.choose_frames("house.mp4", "frames")
        result = loom.photogrammetry.reconstruct_images("frames", "work")
        if not result.reliable:
            print(result.warnings)
        loom.write_trajectory("poses.log", result.model.trajectory())

    Models can be assessed without COLMAP:

    >>> import pointloom as loom
    >>> from pointloom.photogrammetry.sfm.model_quality import assess_model
    >>> assess_model(None, 20).registered_count
    0

    `pointloom video walk.mp4 -o room.ply` in Python:

        outputs = loom.photogrammetry.VideoOutputs(mesh="room.ply")
        result = loom.photogrammetry.reconstruct_video("walk.mp4", outputs=outputs)
        print(result.warnings or result)  # what the command prints
        result.mesh, result.cloud, result.model

    Settings are checked before any work:

    >>> import pointloom as loom
    >>> loom.photogrammetry.VideoSettings(max_frames=1)
    Traceback (most recent call last):
    ValueError: max_frames: expected an integer >= 2, got 1
"""

from ..public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
