"""Bounding boxes of convex hulls: along principal axes, and of minimal volume."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..kernels.extent.box_fit import smallest_frame
from ..kernels.linear_algebra import eigh, matmul, norm
from .convex_hull import Extremes

COORDINATE_ROUNDING = 4 * float(np.finfo(np.float64).eps)  # of a coordinate: rotation into the box axes, and center

Box = tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]


def fit_principal_box(positions: NDArray[np.float64], origin: NDArray[np.float64], extremes: Extremes) -> Box:
    """Box along the principal axes of the hull's vertices, largest variance first: (center, R, extent)."""
    vertices = positions[extremes.rows]
    arms = vertices - vertices.mean(axis=0)
    _, axes = eigh(matmul(arms.T, arms) / len(arms))
    R = axes[:, ::-1].copy()
    R[:, 2] = np.cross(R[:, 0], R[:, 1])
    return _enclose(positions, origin, R)


def fit_smallest_box(
    positions: NDArray[np.float64], origin: NDArray[np.float64], extremes: Extremes, device: Any
) -> Box:
    """Box of minimal volume, or area if flat: (center, R, extent)."""
    vertices = positions[extremes.rows]
    arms = vertices - (vertices.min(axis=0) + vertices.max(axis=0)) / 2
    size = np.abs(arms).max()
    if extremes.dimension == 3:
        edges, arcs = _edges_of(extremes.triangles, extremes.normals)
        R = smallest_frame(arms / size, edges, arcs, extremes.normals, device)
    elif extremes.dimension == 2:
        R = _smallest_rectangle(arms / size, extremes.triangles)
    elif extremes.dimension == 1:
        R = _frame_along(vertices[1] - vertices[0])
    else:
        R = np.eye(3)
    return _enclose(positions, origin, R)


def _edges_of(
    triangles: NDArray[np.int32], normals: NDArray[np.float64]
) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Edges (e, 2) of a closed surface, and the normals (e, 2, 3) on both sides."""
    ends = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1).astype(np.int64)
    order = np.lexsort((ends[:, 1], ends[:, 0]))
    ends, beside = ends[order], order // 3
    pairs = np.flatnonzero((ends[1:] == ends[:-1]).all(axis=1))
    return ends[pairs], normals[np.column_stack([beside[pairs], beside[pairs + 1]])]


def _smallest_rectangle(arms: NDArray[np.float64], triangles: NDArray[np.int32]) -> NDArray[np.float64]:
    """Frame of the minimal-area rectangle of a flat hull. One side contains an edge."""
    a, b, c = (arms[triangles[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    normal = normals[np.einsum("ij,ij->i", normals, normals).argmax()]
    normal = normal / norm(normal)
    sides = np.concatenate([b - a, c - b, a - c])
    along = sides / np.linalg.norm(sides, axis=1, keepdims=True)
    along = along - np.outer(matmul(along, normal), normal)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    across = np.cross(normal, along)
    areas = [np.ptp(matmul(arms, u)) * np.ptp(matmul(arms, v)) for u, v in zip(along, across, strict=True)]
    best = int(np.argmin(areas))
    return np.stack([along[best], across[best], normal], axis=1)


def _frame_along(direction: NDArray[np.float64]) -> NDArray[np.float64]:
    """Right-handed frame with a given first axis."""
    first = direction / norm(direction)
    second = np.cross(np.eye(3)[np.abs(first).argmin()], first)
    second /= norm(second)
    return np.stack([first, second, np.cross(first, second)], axis=1)


def _enclose(positions: NDArray[np.float64], origin: NDArray[np.float64], R: NDArray[np.float64]) -> Box:
    """Box with axes R around positions, enlarged by a few roundings unless flat along a coordinate. The frame may come
    from a hull without points lost in float32 rounding. The box contains them."""
    middle = (positions.min(axis=0) + positions.max(axis=0)) / 2
    rotated = matmul(positions - middle, R)
    low, high = rotated.min(axis=0), rotated.max(axis=0)
    center = origin + (middle + matmul(R, (low + high) / 2))
    offsets = np.abs(matmul(positions + (origin - center), R)).max(axis=0)  # as in a crop to the box
    extent = np.maximum(high - low, 2 * offsets)
    rounding = COORDINATE_ROUNDING * (np.abs(positions).max() + np.abs(origin - center).max())
    along_coordinate = np.abs(R).max(axis=0) == 1  # zero thickness is exact there, in any order of sums
    return center, R, np.where((extent == 0) & along_coordinate, 0.0, extent + rounding)
