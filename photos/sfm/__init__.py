"""Structure from motion: a video or a folder of photographs in, posed pictures and sparse points out.

COLMAP does it (package pycolmap, `pip install "pointloom[sfm]"`), in a process of its own with limits of time and
memory. Each public name is loaded when it is first used, as in `pointloom` itself.

Example:
    Frames of a video, their poses, and whether these are reliable::

        choice = loom.sfm.choose_frames("house.mp4", "frames")
        result = loom.sfm.reconstruct("frames", "work")
        if not result.reliable:
            print(result.warnings)
        loom.write_trajectory("poses.log", result.model.trajectory())

    What is found of a set of pictures is judged without COLMAP too:

    >>> import pointloom as loom
    >>> from pointloom.photos.sfm.model_quality import assess_model
    >>> assess_model(None, 20).registered_count
    0
"""

from ...public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
