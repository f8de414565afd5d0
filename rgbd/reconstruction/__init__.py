"""The reconstruction system: frames of a moving depth camera, without poses, to one model, in stages that can resume.

Each public name is loaded when it is first used, as in `pointloom` itself.

Example:
    >>> import pointloom as loom
    >>> config = loom.reconstruction.ReconstructionConfig(n_frames_per_fragment=50, voxel_size=0.02)
    >>> loom.reconstruction.ReconstructionConfig.from_names(config.to_names()) == config
    True
"""

from ...public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
