"""A surface and poses for tests of registration."""

import numpy as np


def yaw_pose(angle: float, *shift: float) -> np.ndarray:
    """A rotation about z [degrees] followed by a translation [m]."""
    T, (c, s) = np.eye(4), (np.cos(np.radians(angle)), np.sin(np.radians(angle)))
    T[:2, :2], T[:3, 3] = [[c, -s], [s, c]], shift
    return T


def moved(points: np.ndarray, T: np.ndarray) -> np.ndarray:
    return points @ T[:3, :3].T + T[:3, 3]


def bumpy(rng: np.random.Generator, count: int = 5000) -> np.ndarray:
    """Points on a 2 x 2 m surface without symmetry, which constrains all six degrees of freedom."""
    x, y = rng.uniform(-1, 1, (2, count))
    return np.column_stack([x, y, 0.2 * np.sin(3 * x) * np.cos(4 * y) + 0.1 * np.sin(7 * y + x)])


def colors_at(points: np.ndarray) -> np.ndarray:
    return 0.5 + 0.4 * np.sin(points * [3, 4, 0] + 1)


POSE = yaw_pose(90, 5, 0, 0)  # of the target from the source: far beyond the convergence range of ICP
NEAR = yaw_pose(2, 0.02, -0.03, 0.01)
VOXEL = ["--voxel", 0.06]


def path_of(count: int) -> np.ndarray:
    return np.array([yaw_pose(2 * i, 0.1 * i, 0.02 * i * i, 0) for i in range(count)])
