"""RGB-D frames: the motion between them, tracking, and the reconstruction of scenes. Names are loaded on first use.

Examples:
    >>> import numpy as np, pointloom as loom
    >>> camera = loom.PinholeCameraIntrinsic(80, 60, 70.0, 70.0, 39.5, 29.5)
    >>> v, u = np.mgrid[:60, :80]
    >>> depth = 1.0 + 0.1 * np.sin(u / 6) * np.cos(v / 8)
    >>> frame, nearer = (loom.rgbd.OdometryFrame(z, camera) for z in (depth, depth - 0.01))
    >>> reliable, T_target_source, information = loom.rgbd.align_frames(nearer, frame)
    >>> reliable, bool(abs(T_target_source[2, 3] - 0.01) < 2e-3)
    (True, True)

    >>> import pointloom as loom
    >>> config = loom.rgbd.ReconstructionConfig(n_frames_per_fragment=50, voxel_size=0.02)
    >>> loom.rgbd.ReconstructionConfig.from_names(config.to_names()) == config
    True

    >>> import numpy as np, pointloom as loom
    >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
    >>> v, u = np.mgrid[:48, :64]
    >>> frame = loom.RGBDImage(np.zeros((48, 64), np.uint8), 1.0 + 0.1 * np.sin(u / 5) * np.cos(v / 7))
    >>> slam = loom.rgbd.DenseSLAM(camera, voxel_size=0.02)
    >>> slam.step(frame).status, slam.step(frame).status
    ('tracked', 'tracked')
"""

from ..public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
