"""Views of a made-up hall from its middle, each bent by one camera, with the truth: what SLAC is measured on."""

import itertools

import numpy as np

import pointloom as loom
from pointloom.registration import PoseGraph, PoseGraphEdge, PoseGraphNode
from pointloom.registration.rigid import fit_pose, invert_pose

HALF = np.array([2.0, 1.6, 1.2])  # of the hall [m]
VIEWS = 18  # round the hall


def moved(T, points):
    return points @ T[:3, :3].T + T[:3, 3]


def depth_of_hall(origin, directions):
    """How far the wavy walls are along rays: the nearest of six, each found by going to where the last guess was."""
    nearest = np.full(len(directions), np.inf)
    for axis, side in itertools.product(range(3), (-1, 1)):
        along, facing = np.delete(np.arange(3), axis), side * directions[:, axis] > 1e-3
        rays, reach = directions[facing], np.zeros(facing.sum())
        for _ in range(30):
            waves = np.sin(3.5 * (origin + reach[:, None] * rays)[:, along] + axis).prod(axis=1)
            reach = (side * (HALF[axis] + 0.08 * waves) - origin[axis]) / rays[:, axis]
        nearest[facing] = np.minimum(nearest[facing], reach)
    return nearest


class BentRoom:
    """Fragments of one view each.

    Args:
        bend: Share that depth grows by at a picture's corner, as the square of the distance from its middle.

    Attributes:
        clouds: In their cameras' frames, as the camera bent them.
        points, truths: Their points, and where these are truly.
        poses, graph, pairs: T_world_fragment, with the edges of views that overlap.
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
        """Root mean square [m] of the distances of all points from where they truly are, after one rigid fit of all."""
        clouds = self.clouds if grid is None else [grid.deform(cloud) for cloud in self.clouds]
        found = np.concatenate([moved(n.pose, c.points) for n, c in zip(graph.nodes, clouds, strict=True)])
        truth = np.concatenate([moved(T, p) for T, p in zip(self.poses, self.truths, strict=True)])
        return float(np.sqrt(((moved(fit_pose(found, truth), found) - truth) ** 2).sum(axis=1).mean()))
