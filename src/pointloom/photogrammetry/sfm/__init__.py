"""Structure from motion: posed images and sparse points from a video or photographs.

COLMAP (pycolmap, `pip install "pointloom[sfm]"`) runs in a separate process with time and memory limits.

Example:
    Frames of a video, their poses, and whether these are reliable::

        choice = loom.sfm.choose_frames("house.mp4", "frames")
        result = loom.sfm.reconstruct("frames", "work")
        if not result.reliable:
            print(result.warnings)
        loom.write_trajectory("poses.log", result.model.trajectory())

    Models can be assessed without COLMAP:

    >>> import pointloom as loom
    >>> from pointloom.photogrammetry.sfm.model_quality import assess_model
    >>> assess_model(None, 20).registered_count
    0
"""

from ...public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
