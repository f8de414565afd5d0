"""Jobs larger than memory: tiles, fusion and registration. Public names are loaded on first use.

Example:
    >>> import numpy as np, pointloom as loom
    >>> points = np.random.default_rng(0).random((5_000, 3)) * (40, 20, 1)
    >>> loom.write_point_cloud("survey.laz", loom.PointCloud(points))
    >>> steps = [{"step": "voxel_down_sample", "voxel_size": 1}]
    >>> waiting = loom.tiling.plan_tiles("survey.laz", steps, "job", size=10).waiting
    >>> done = loom.tiling.run_tiles("job")
    >>> loom.tiling.finish_tiles("job", "thinned.laz").name
    'thinned.laz'
"""

from ..public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
