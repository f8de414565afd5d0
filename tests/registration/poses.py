"""Poses and points under them."""

import numpy as np
from scipy.spatial.transform import Rotation


def as_pose(vector=(0, 0, 0), shift=(0, 0, 0)) -> np.ndarray:
    """The pose of a rotation vector [rad] and a shift [m]."""
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = Rotation.from_rotvec(vector).as_matrix(), shift
    return T


def moved(points, T) -> np.ndarray:
    return points @ T[:3, :3].T + T[:3, 3]


def pose_within(rng, size=2.0) -> np.ndarray:
    """Any rotation, and a shift of up to `size` [m] along each axis."""
    T = np.eye(4)
    T[:3, :3] = Rotation.random(random_state=int(rng.integers(1 << 30))).as_matrix()
    T[:3, 3] = rng.uniform(-size, size, 3)
    return T


def random_pose(rng, size=1.0) -> np.ndarray:
    """Any rotation, and a shift of about `size` [m]."""
    return as_pose(Rotation.random(random_state=int(rng.integers(2**31))).as_rotvec(), size * rng.normal(size=3))


def shift_between(A, B) -> float:
    return float(np.linalg.norm(A[:3, 3] - B[:3, 3]))


def bunny_pose() -> np.ndarray:
    """The scan from 45 degrees onto that from 0, by Stanford's bun.conf, whose quaternions are conjugates."""
    T = as_pose([0, 0, 0], [-0.0520211, -0.000383981, -0.0109223])
    T[:3, :3] = Rotation.from_quat([0.00548449, -0.294635, -0.0038555, 0.955586]).inv().as_matrix()
    return T
