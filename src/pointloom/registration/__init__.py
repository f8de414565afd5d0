"""Registration of clouds: the ICP family, global registration, LiDAR odometry and pose graphs.

Example:
    >>> import numpy as np, pointloom as loom
    >>> points = np.random.default_rng(0).random((2000, 3)) * [1, 1, 0.1]
    >>> target, source = loom.PointCloud(points), loom.PointCloud(points + [0.01, 0, 0])
    >>> result = loom.registration.registration_icp(source, target, max_correspondence_distance=0.05)
    >>> np.abs(result.transformation[:3, 3] + [0.01, 0, 0]).max() < 1e-5, result.fitness
    (np.True_, 1.0)
"""

from ..public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
