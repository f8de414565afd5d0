"""RGB-D odometry: the motion between two depth camera frames, with reliability checks.

Example:
    >>> import numpy as np, pointloom as loom
    >>> camera = loom.PinholeCameraIntrinsic(80, 60, 70.0, 70.0, 39.5, 29.5)
    >>> v, u = np.mgrid[:60, :80]
    >>> depth = 1.0 + 0.1 * np.sin(u / 6) * np.cos(v / 8)
    >>> frame, nearer = (loom.odometry.OdometryFrame(z, camera) for z in (depth, depth - 0.01))
    >>> reliable, T_target_source, information = loom.odometry.align_frames(nearer, frame)
    >>> reliable, bool(abs(T_target_source[2, 3] - 0.01) < 2e-3)
    (True, True)
"""

from ...public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
