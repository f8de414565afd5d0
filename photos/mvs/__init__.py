"""Multi-view stereo: photographs with known poses in, a depth map of each out, and clouds and meshes of those.

`estimate_depth_maps` finds the depth that makes each picture agree with its sources, `filter_depth_maps` keeps what
several pictures say alike, `fuse` makes points or a mesh. Each public name is loaded when it is first used, as in
`pointloom` itself.

Example:
    >>> import numpy as np, pointloom as loom
    >>> camera = loom.PinholeCameraIntrinsic(8, 6, 10.0, 10.0, 3.5, 2.5)
    >>> loom.mvs.PosedCamera(camera, np.eye(4)).center.tolist()
    [0.0, 0.0, 0.0]
"""

from ...public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
