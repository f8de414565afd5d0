"""Triangle meshes from clouds, volumes and frames; their smoothing, comparison, colors and textures.

Examples:
    >>> import numpy as np, pointloom as loom
    >>> mesh = loom.TriangleMesh([[-0.1, -0.1, 1], [0.1, -0.1, 1], [0, 0.1, 1]], [[0, 2, 1]])
    >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
    >>> frame = loom.RGBDImage(np.full((48, 64, 3), (255, 0, 0), np.uint8), np.full((48, 64), 1000, np.uint16))
    >>> option = loom.meshing.ColorMapOption(maximum_iteration=20)
    >>> path = loom.Trajectory([np.eye(4)])
    >>> colored, path = loom.meshing.optimize_color_map(mesh, [frame], path, option, intrinsic=camera)
    >>> colored.vertex_colors[0].tolist()
    [1.0, 0.0, 0.0]
"""

from ..public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
