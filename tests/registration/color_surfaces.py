"""Painted surfaces, and pointloom's color gradients on them."""

import numpy as np

from pointloom.kernels.icp.color_gradients import estimate_color_gradients
from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import upload
from pointloom.kernels.search.point_tree import PointTree


def gradients_of(points, normals, colors, radius, max_nn, device="cpu"):
    """Intensities and gradients as NumPy arrays."""
    rows = (np.asarray(values, np.float32).reshape(-1, 3) for values in (points, normals, colors))
    points, normals, colors = (upload(values, vec3, device) for values in rows)
    intensities, gradients = estimate_color_gradients(PointTree(points), normals, colors, radius, max_nn)
    return intensities.numpy(), gradients.numpy()


def paint(points, scale=1.0):
    """Colors that vary along a surface."""
    x, y, _ = points.T / scale
    return np.column_stack([0.5 + 0.3 * np.sin(5 * x + c) * np.cos(4 * y) for c in range(3)])


def wavy(rng, count=1500):
    xy = rng.uniform(-1, 1, (count, 2))
    return np.column_stack([xy, 0.2 * np.sin(3 * xy[:, 0]) * np.cos(4 * xy[:, 1])]).astype(np.float32)
