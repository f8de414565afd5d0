"""ICP with selected degrees of freedom as dense float64 least squares: the reference for the kernels.

The motion is `scipy.spatial.transform`'s, the minimum that of `least_squares` with numerical derivatives:
nothing is shared with the library.
"""

import numpy as np
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

MOTIONS = ("roll", "pitch", "yaw", "x", "y", "z")


def motion(x, pivot, frame):
    """The pose of (roll, pitch, yaw, x, y, z, log of scale): Rz Ry Rx along the frame, about the pivot."""
    R = np.exp(x[6]) * frame @ Rotation.from_euler("ZYX", x[2::-1]).as_matrix() @ frame.T
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, pivot + frame @ x[3:6] - R @ pivot
    return T


class DenseICP:
    """A problem; its arguments are those of `registration_icp`, `prior` is (pose, information)."""

    def __init__(
        self, source, target, init=None, *, free=MOTIONS, frame=None, pivot=None, prior=None, weights=None,
        noise=None, normals=None, scaling=False,
    ):  # fmt: skip
        self.source, self.target, self.normals = source, target, normals
        self.init = np.eye(4) if init is None else init
        self.frame = np.eye(3) if frame is None else frame
        moved = source @ self.init[:3, :3].T + self.init[:3, 3]
        self.pivot = moved.mean(axis=0) if pivot is None else np.asarray(pivot, float)
        self.free = [MOTIONS.index(name) for name in free] + [6] * scaling
        self.weights = np.ones(len(source)) if weights is None else weights
        self.prior, self.noise = prior, noise

    def pose(self, free_x):
        x = np.zeros(7)
        x[self.free] = free_x
        return motion(x, self.pivot, self.frame) @ self.init

    def residuals(self, free_x, pairs):
        T = self.pose(free_x)
        i, j = pairs
        d = self.source[i] @ T[:3, :3].T + T[:3, 3] - self.target[j]
        r = d if self.normals is None else (d * self.normals[j]).sum(axis=1, keepdims=True)
        return (np.sqrt(self.weights[i])[:, None] * r).ravel()

    def pull(self, free_x):
        pose, information = self.prior
        T = self.pose(free_x)
        R = T[:3, :3] / np.cbrt(np.linalg.det(T[:3, :3]))
        point = np.linalg.solve(self.init, [*self.pivot, 1])
        xi = [*Rotation.from_matrix(R @ pose[:3, :3].T).as_rotvec(), *((T - pose) @ point)[:3]]
        values, vectors = np.linalg.eigh(information)
        return np.sqrt(np.maximum(values, 0)) * (vectors.T @ xi)

    def minimum(self, pairs, start):
        noise = self.noise
        for _ in range(1 if noise is not None or self.prior is None else 30):
            level = noise
            if self.prior is not None and noise is None:
                r = self.residuals(start, pairs)
                level = np.sqrt((r @ r) / r.size)

            def both(x, level=level):
                r = self.residuals(x, pairs)
                return r if self.prior is None else np.concatenate([r, level * self.pull(x)])

            start = least_squares(both, start, method="lm", xtol=1e-15, ftol=1e-15, gtol=1e-15, x_scale=1.0).x
        return start
