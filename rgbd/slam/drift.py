"""How far a frame's pose may be off by all that was open on the way to it: a covariance that adds up.

A frame stands on the surface that it sees, and so it is off as those frames were that the surface came from, and by
its own noise beside it. Keyframes stand for the frames of the model. Each point of a frame is put down to the keyframes
that saw it; by the normal equations of these points the frame's error is a mean of theirs, and its covariance follows
from the joint one of all keyframes. Who sees what the first keyframes saw is as sure as they are, however long the way;
before a wall what the surface leaves open comes from frame to frame and grows.

Errors are twists about the world's origin, rotation first. Smith, Self and Cheeseman 1990, "Estimating uncertain
spatial relationships in robotics".
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import matmul, solve
from ...registration.rigid import adjoint_of, make_pose
from ..odometry.frames import OdometryFrame
from .frames import coarsest_level
from .keyframes import Keyframes

Pose = NDArray[np.float64]
Matrix = NDArray[np.float64]

STRIDE = 2  # pixels of the coarsest level from one point to the next
NEAR, NEAR_SHARE = 0.05, 0.03  # [m] and of the depth: how far a keyframe's depth may be from a point that it saw
OPEN = 1e-3  # of the normal equations' largest number: below it points count by their number alone


class Drift:
    """The covariance of keyframes, and that of frames by them.

    Args:
        keyframes: The Keyframes, whose poses may be corrected on the way.
    """

    def __init__(self, keyframes: Keyframes):
        self.keyframes = keyframes
        self._views: list[tuple[NDArray[np.float32], NDArray[np.float64]]] = []  # depth [h, w] and lens of each
        self._joint = np.zeros((0, 0))
        self._latest = np.zeros((6, 0)), np.zeros((6, 6))  # the latest frame's row and own covariance

    def of(self, frame: OdometryFrame, pose: Pose, own: Matrix) -> Matrix:
        """The covariance [rad, m] of a frame's pose about its camera, in the world's directions, float64 [6, 6].

        Args:
            frame: Its pyramid.
            pose: T_world_camera.
            own: That of its alignment with the model, about the camera.
        """
        count = len(self._views)
        if not count:  # the first frame is the world
            return np.zeros((6, 6))
        parts = self._parts(frame, pose)
        to_world = adjoint_of(pose)
        noise = matmul(to_world, own, to_world.T)
        whole = parts.sum(0)
        scale = np.abs(whole).max()
        if scale > 0:
            shares = np.trace(parts, axis1=1, axis2=2)
            even = OPEN * scale * np.eye(6)
            parts += even * (shares / shares.sum())[:, None, None]
            row = solve(whole + even, np.concatenate(list(parts), 1))
        else:  # what no keyframe saw hangs on the latest
            row = np.concatenate([np.zeros((6, 6 * (count - 1))), np.eye(6)], 1)
        self._latest = row, noise
        total = matmul(row, self._joint, row.T) + noise
        about = _about(pose[:3, 3])
        return matmul(about, total, about.T)

    def keep(self, frame: OdometryFrame) -> None:
        """The frame that was asked about last became a keyframe."""
        row, noise = self._latest
        cross = matmul(row, self._joint)
        corner = matmul(cross, row.T) + noise
        self._joint = np.block([[self._joint, cross.T], [cross, corner]])
        depth, lens, _ = coarsest_level(frame)
        self._views.append((depth.astype(np.float32), lens))

    def take_over(self, other: Drift, T_here_other: Pose, deviation: float) -> None:
        """Another map's keyframes, which follow one's own, lie so to them.

        Args:
            other: Its Drift.
            T_here_other: How it lies, 4 x 4.
            deviation: Standard deviation of that [m], and at 1 m from the other's origin of its turn.
        """
        count, more = len(self._views), len(other._views)
        to_here = adjoint_of(T_here_other)
        blocks = np.kron(np.eye(more), to_here)
        way = matmul(to_here, to_here.T) * deviation**2
        joint = np.zeros((6 * (count + more),) * 2)
        joint[: 6 * count, : 6 * count] = self._joint
        joint[6 * count :, 6 * count :] = matmul(blocks, other._joint, blocks.T) + np.kron(np.ones((more, more)), way)
        self._joint, self._views = joint, [*self._views, *other._views]
        row, noise = self._latest
        self._latest = np.concatenate([row, np.zeros((6, 6 * more))], 1), noise

    def _parts(self, frame: OdometryFrame, pose: Pose) -> NDArray[np.float64]:
        """The normal equations of a frame's points, by the keyframes that saw them, float64 [keyframes, 6, 6]."""
        depth, lens, planes = coarsest_level(frame)
        v, u = np.mgrid[: depth.shape[0] : STRIDE, : depth.shape[1] : STRIDE]
        z, plane = depth[v, u], planes[v, u]
        chosen = (z > 0) & (plane[..., 3] < 0)
        z, plane, u, v = z[chosen], plane[chosen], u[chosen], v[chosen]
        at = np.stack([(u - lens[2]) / lens[0] * z, (v - lens[3]) / lens[1] * z, z], 1)
        points = matmul(at, pose[:3, :3].T) + pose[:3, 3]
        normals = matmul(plane[:, :3], pose[:3, :3].T)
        rows = np.concatenate([np.cross(points, normals), normals], 1) / (1.0 + z * z)[:, None]
        seen = np.stack([self._sees(k, points) for k in range(len(self._views))]).astype(np.float64)
        seen /= np.maximum(seen.sum(0), 1.0)
        return matmul(seen, (rows[:, :, None] * rows[:, None]).reshape(len(rows), 36)).reshape(-1, 6, 6)

    def _sees(self, index: int, points: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Which points a keyframe saw."""
        depth, lens = self._views[index]
        pose = self.keyframes.poses[index]
        local = matmul(points - pose[:3, 3], pose[:3, :3])
        z = np.maximum(local[:, 2], 1e-6)
        u = np.rint(lens[0] * local[:, 0] / z + lens[2])
        v = np.rint(lens[1] * local[:, 1] / z + lens[3])
        inside = (local[:, 2] > 0) & (u >= 0) & (v >= 0) & (u < depth.shape[1]) & (v < depth.shape[0])
        there = depth[np.where(inside, v, 0).astype(int), np.where(inside, u, 0).astype(int)]
        return inside & (there > 0) & (np.abs(there - z) < NEAR + NEAR_SHARE * z)


def _about(place: NDArray[np.float64]) -> Matrix:
    """From twists about the origin to those about a place, in the same directions."""
    return adjoint_of(make_pose(np.eye(3), -place))
