"""Views of a synthetic hall from its center, each bent by one camera, with ground truth, for SLAC."""

import itertools

import numpy as np

import pointloom as loom
from pointloom.registration import PoseGraph, PoseGraphEdge, PoseGraphNode
from pointloom.registration.rigid import fit_pose, invert_pose

HALF = np.array([2.0, 1.6, 1.2])  # of the hall [m]
VIEWS = 18  # around the hall


def moved(T, points):
    return points @ T[:3, :3].T + T[:3, 3]


def depth_of_hall(origin, directions):
    """Distances to the wavy walls along rays: the nearest of six, each by fixed-point iteration."""
    nearest = np.full(len(directions), np.inf)
    for axis, side in itertools.product(range(3), (-1, 1)):
        along, facing = np.delete(np.arange(3), axis), side * directions[:, axis] > 1e-3
        rays, ranges = directions[facing], np.zeros(facing.sum())
        for _ in range(30):
            waves = np.sin(3.5 * (origin + ranges[:, None] * rays)[:, along] + axis).prod(axis=1)
            ranges = (side * (HALF[axis] + 0.08 * waves) - origin[axis]) / rays[:, axis]
        nearest[facing] = np.minimum(nearest[facing], ranges)
    return nearest


class BentRoom:
    """Fragments of one view each.

    Args:
        bend: Relative depth error at an image corner, quadratic in the distance from the center.

    Attributes:
        clouds: In their cameras' frames, as the camera bent them.
        points, truths: Their points and the true positions.
        poses, graph, pairs: T_world_fragment, with the edges of overlapping views.
    """

    def __init__(self, bend):
        rng = np.random.default_rng(0)
        v, u = np.mgrid[-0.55:0.55:56j, -0.7:0.7:72j]
        rays = np.stack([u.ravel(), v.ravel(), np.ones(u.size)], axis=1)
        stretch = 1 + bend * (rays[:, :2] ** 2).sum(axis=1) / (0.55**2 + 0.7**2)
        self.clouds, self.points, self.truths, self.poses = [], [], [], []
        for k in range(VIEWS):
            angle, pitch = 2 * np.pi * k / VIEWS, 0.3 * (-1) ** k
            forward = np.array([np.cos(angle) * np.cos(pitch), np.sin(angle) * np.cos(pitch), np.sin(pitch)])
            right = np.cross(forward, [0, 0, 1])
            right /= np.linalg.norm(right)
            T = np.eye(4)
            T[:3, :3] = np.stack([right, np.cross(forward, right), forward], axis=1)
            T[:3, 3] = rng.normal(size=3) * 0.1
            depth = depth_of_hall(T[:3, 3], rays @ T[:3, :3].T)
            self.truths.append(rays * depth[:, None])
            self.points.append(rays * (depth * stretch)[:, None])
            self.clouds.append(loom.PointCloud(self.points[-1]))
            self.poses.append(T)
        self.pairs = [(k, k + 1) for k in range(VIEWS - 1)] + [(0, VIEWS - 1)]
        self.pairs += [(k, k + 2) for k in range(VIEWS - 2)]
        edges = [PoseGraphEdge(i, j, invert_pose(self.poses[j]) @ self.poses[i]) for i, j in self.pairs]
        self.graph = PoseGraph([PoseGraphNode(T) for T in self.poses], edges)

    def error(self, graph, grid=None):
        """Root mean square distance [m] of all points from their true positions, after one rigid fit."""
        clouds = self.clouds if grid is None else [grid.deform(cloud) for cloud in self.clouds]
        estimated = np.concatenate([moved(n.pose, c.points) for n, c in zip(graph.nodes, clouds, strict=True)])
        truth = np.concatenate([moved(T, p) for T, p in zip(self.poses, self.truths, strict=True)])
        return float(np.sqrt(((moved(fit_pose(estimated, truth), estimated) - truth) ** 2).sum(axis=1).mean()))
