"""Dense SLAM: camera trajectory and surface from RGB-D frames without poses.

Example:
    >>> import numpy as np, pointloom as loom
    >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
    >>> v, u = np.mgrid[:48, :64]
    >>> frame = loom.RGBDImage(np.zeros((48, 64), np.uint8), 1.0 + 0.1 * np.sin(u / 5) * np.cos(v / 7))
    >>> slam = loom.slam.DenseSLAM(camera, voxel_size=0.02)
    >>> slam.step(frame).status, slam.step(frame).status
    ('tracked', 'tracked')
"""

from ...public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
