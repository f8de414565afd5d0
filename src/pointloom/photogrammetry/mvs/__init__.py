"""Multi-view stereo: depth maps of posed photographs, and clouds and meshes of these.

Example:
    >>> import numpy as np, pointloom as loom
    >>> camera = loom.PinholeCameraIntrinsic(8, 6, 10.0, 10.0, 3.5, 2.5)
    >>> loom.mvs.PosedCamera(camera, np.eye(4)).center.tolist()
    [0.0, 0.0, 0.0]
"""

from ...public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
