"""Trees over oriented samples for the tests of the octree and of the Poisson equation, in NumPy."""

from functools import cache

import numpy as np

from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import download, upload
from pointloom.kernels.reconstruction.poisson import grow_tree
from pointloom.kernels.reconstruction.sample_cells import Cube, gather_samples, sample_rows

SIDE, CORNER = 2.2, np.array([-1.1, -1.1, -1.1])


@cache
def ball_samples(count: int, share: float = 1.0):
    rng = np.random.default_rng(0)
    points = rng.normal(size=(count, 3))
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    return points[rng.random(count) < np.where(points[:, 2] > 0.6, 1, share)].astype(np.float32)


def tree_of(points, depth, device, normals=None, samples_per_cell=1.5):
    """A DensityPyramid over points, by default of the unit sphere, in a cube of edge 2.2."""

    points, normals = (upload(a, vec3, device) for a in (points, points if normals is None else normals))
    rows = sample_rows(points, normals)
    cells = gather_samples(points, normals, rows, Cube(CORNER, SIDE), depth)
    return grow_tree(cells, rows.size, depth, max(1, depth - 2), samples_per_cell)


def slot_cells(level):
    """int [8 blocks, 3]."""
    corners = np.stack([np.arange(8) >> axis & 1 for axis in range(3)], axis=1)
    return (2 * download(level.positions).reshape(-1, 1, 3) + corners).reshape(-1, 3)


def is_cell(level):
    return np.repeat(download(level.has_cells), 8) == 1


def leaves_of(pyramid):
    cells, depths = [], []
    for level in pyramid.levels[1:]:
        chosen = is_cell(level) & (download(level.divided) == 0)
        cells.append(slot_cells(level)[chosen])
        depths.append(np.full(chosen.sum(), level.depth))
    return np.concatenate(cells), np.concatenate(depths)


def code_cells(codes):
    codes = codes[:, None].astype(np.int64)
    bits = np.arange(21)
    return np.stack([((codes >> (3 * bits + axis) & 1) << bits).sum(axis=1) for axis in range(3)], axis=1)
