"""Reconstruction system: RGB-D frames without poses to one model, in resumable stages.

Example:
    >>> import pointloom as loom
    >>> config = loom.reconstruction.ReconstructionConfig(n_frames_per_fragment=50, voxel_size=0.02)
    >>> loom.reconstruction.ReconstructionConfig.from_names(config.to_names()) == config
    True
"""

from ...public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
