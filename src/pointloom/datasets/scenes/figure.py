"""A synthetic figure: an owl on a stump, as a colored signed distance function.

Quadratic smooth minimum of Quilez ("Smooth minimum", iquilezles.org/articles/smin).
"""

from __future__ import annotations

import functools
import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...kernels.linear_algebra import elementwise
from ...meshing.mesh.isosurface import marching_cubes
from ...meshing.mesh.mesh import TriangleMesh

Field = NDArray[Any]

FIELD_STEP = 0.0025  # [m] sampling step of the field
LOW_CORNER, HIGH_CORNER = np.array([-0.108, -0.108, -0.158]), np.array([0.108, 0.108, 0.158])  # [m] sampled box
MIN_SLOPE = 1e-9

_BROWN_RGB, _DARK_RGB, _CREAM_RGB = (0.50, 0.32, 0.18), (0.30, 0.18, 0.11), (0.93, 0.85, 0.68)
_TAN_RGB = (0.65, 0.50, 0.34)
_GOLD_RGB, _BLACK_RGB, _ORANGE_RGB = (0.98, 0.74, 0.16), (0.06, 0.05, 0.05), (0.93, 0.52, 0.13)
_BARK_RGB, _WOOD_RGB, _RING_RGB = (0.38, 0.28, 0.19), (0.80, 0.62, 0.40), (0.58, 0.40, 0.23)


def _sin(values: Field) -> Field:
    return elementwise(math.sin, values).astype(np.float32)


def _arctan2(y: Field, x: Field) -> Field:
    return elementwise(math.atan2, y, x).astype(np.float32)


def _ellipsoid(p: Field, center: ArrayLike, radii: ArrayLike, *, lean: float = 0.0) -> Field:
    """Approximate distance (a bound) from an ellipsoid tilted about x by `lean` [rad]."""
    q = p - np.asarray(center, np.float32)
    c, s = np.float32(math.cos(lean)), np.float32(math.sin(lean))
    x, y, z = q[..., 0], c * q[..., 1] + s * q[..., 2], c * q[..., 2] - s * q[..., 1]
    r = np.asarray(radii, np.float32)
    near = np.sqrt((x / r[0]) ** 2 + (y / r[1]) ** 2 + (z / r[2]) ** 2)
    slope = np.sqrt((x / r[0] ** 2) ** 2 + (y / r[1] ** 2) ** 2 + (z / r[2] ** 2) ** 2)
    return near * (near - 1) / np.maximum(slope, np.float32(MIN_SLOPE))


def _cone(p: Field, foot: ArrayLike, tip: ArrayLike, radius: float, end: float) -> Field:
    """Approximate distance from a capsule whose radius shrinks from foot to tip."""
    a, b = np.asarray(foot, np.float32), np.asarray(tip, np.float32)
    axis = b - a
    along = np.clip(((p - a) * axis).sum(axis=-1) / (axis * axis).sum(), 0, 1)
    return np.linalg.norm(p - a - along[..., None] * axis, axis=-1) - (radius + (end - radius) * along)


def _join(a: Field, b: Field, width: float) -> Field:
    """Smooth union over a width [m]."""
    overlap = np.maximum(width - np.abs(a - b), 0) / width
    return np.minimum(a, b) - overlap * overlap * width / 4


def _feathers(p: Field, size: float) -> Field:
    """Rows of scales around the axis, 0 between them to 1 on them."""
    angle = _arctan2(p[..., 1], p[..., 0]) * (0.075 / size)
    row = p[..., 2] / size
    odd = np.mod(np.floor(row), 2)
    u, v = np.mod(angle + 0.5 * odd, 1) - 0.5, np.mod(row, 1)
    return np.clip(1.6 * (v - 1.4 * u * u), 0, 1)


def _parts(p: Field) -> dict[str, Field]:
    """Distance from each part; `p` (..., 3) is mirrored in x where the figure is symmetric."""
    m = p.copy()
    m[..., 0] = np.abs(p[..., 0])
    angle, radius = _arctan2(p[..., 1], p[..., 0]), np.hypot(p[..., 0], p[..., 1])
    bark = 0.003 * _sin(17 * angle + 30 * p[..., 2]) + 0.0018 * _sin(41 * angle - 55 * p[..., 2])
    flare = 0.012 * np.clip((-0.10 - p[..., 2]) / 0.05, 0, 1) ** 2
    stump = np.maximum(radius - (0.078 + flare + bark), np.abs(p[..., 2] + 0.1225) - 0.0275)
    body = _ellipsoid(p, (0, 0, -0.025), (0.068, 0.062, 0.085)) - 0.0032 * _feathers(p, 0.017)
    head = _ellipsoid(p, (0, -0.006, 0.077), (0.062, 0.054, 0.047))
    tuft = _cone(m, (0.036, -0.012, 0.105), (0.058, -0.022, 0.147), 0.017, 0.004)
    return {
        "stump": stump,
        "body": body,
        "head": _join(head, tuft, 0.014),
        "wing": _ellipsoid(m, (0.061, 0.012, -0.030), (0.021, 0.046, 0.074), lean=0.22) - 0.0025 * _feathers(p, 0.012),
        "tail": _ellipsoid(p, (0, 0.058, -0.078), (0.028, 0.020, 0.050), lean=0.5),
        "disc": _ellipsoid(m, (0.026, -0.047, 0.080), (0.029, 0.016, 0.029)),
        "eye": _ellipsoid(m, (0.025, -0.061, 0.082), (0.0165, 0.010, 0.0165)),
        "pupil": _ellipsoid(m, (0.0245, -0.069, 0.082), (0.0085, 0.0052, 0.0085)),
        "beak": _cone(p, (0, -0.060, 0.069), (0, -0.077, 0.048), 0.0105, 0.003),
        "foot": functools.reduce(
            lambda a, b: _join(a, b, 0.004),
            (_cone(m, (0.027, -0.030, -0.088), (x, -0.070, -0.091), 0.009, 0.006) for x in (0.012, 0.028, 0.045)),
        ),
    }


def _join_parts(parts: dict[str, Field]) -> Field:
    field = _join(parts["body"], parts["head"], 0.022)
    for name, width in (("wing", 0.012), ("tail", 0.015), ("disc", 0.006), ("foot", 0.004), ("beak", 0.003)):
        field = _join(field, parts[name], width)
    field = np.minimum(np.minimum(field, parts["eye"]), parts["pupil"])
    return _join(field, parts["stump"], 0.004)


def _colors(p: Field, parts: dict[str, Field]) -> NDArray[np.float32]:
    """Colors (n, 3) of the nearest part."""
    x, y, z = p.T
    scales, fine = _feathers(p, 0.017), _feathers(p, 0.012)
    radius = np.hypot(x, y)
    rings = 0.5 + 0.5 * _sin(650 * radius + 2.2 * _sin(3 * _arctan2(y, x)))
    top = (z > -0.0965) & (radius < 0.077)
    front = np.clip(1.5 - np.abs(x) / 0.034, 0, 1) * (y < 0.0)
    plume = _mix(_DARK_RGB, _BROWN_RGB, scales)
    table = {
        "stump": np.where(top[:, None], _mix(_WOOD_RGB, _RING_RGB, rings**2), _mix(_BARK_RGB, _DARK_RGB, rings * 0.5)),
        "body": _mix(plume, _mix(_ORANGE_RGB, _CREAM_RGB, np.clip(1.5 * scales, 0, 1)), front),
        "head": _mix(_BROWN_RGB, _DARK_RGB, 0.5 + 0.5 * _sin(260 * z) * _sin(220 * x)),
        "wing": _mix(_DARK_RGB, _TAN_RGB, fine),
        "tail": _mix(_DARK_RGB, _BROWN_RGB, 0.5 + 0.5 * _sin(400 * z)),
        "disc": _mix(_CREAM_RGB, _BROWN_RGB, 0.35 + 0.35 * _sin(34 * _arctan2(z - 0.080, np.abs(x) - 0.026))),
        "eye": _mix(_GOLD_RGB, _GOLD_RGB, z),
        "pupil": _mix(_BLACK_RGB, _BLACK_RGB, z),
        "beak": _mix(_ORANGE_RGB, _DARK_RGB, np.clip((0.056 - z) / 0.03, 0, 1)),
        "foot": _mix(_ORANGE_RGB, _GOLD_RGB, 0.5 + 0.5 * _sin(900 * y)),
    }
    nearest = np.argmin(np.stack([parts[name] for name in table]), axis=0)
    return np.stack(list(table.values()))[nearest, np.arange(len(p))].astype(np.float32)


def _mix(first: ArrayLike, second: ArrayLike, fraction: NDArray[np.floating]) -> NDArray[np.floating]:
    weight = np.asarray(fraction)[:, None]
    return np.asarray(first) * (1 - weight) + np.asarray(second) * weight


def owl() -> TriangleMesh:
    counts = np.ceil((HIGH_CORNER - LOW_CORNER) / FIELD_STEP).astype(int) + 1
    axes = [LOW_CORNER[k] + FIELD_STEP * np.arange(counts[k]) for k in range(3)]
    grid = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).astype(np.float32)
    mesh = marching_cubes(_join_parts(_parts(grid)), spacing=[FIELD_STEP] * 3, origin=LOW_CORNER)
    labels, counts, _ = mesh.cluster_connected_triangles()
    mesh = mesh.remove_triangles_by_mask(np.asarray(labels) != np.argmax(counts)).remove_unreferenced_vertices()
    at = mesh.vertices.astype(np.float32)
    mesh.vertex_colors = np.clip(_colors(at, _parts(at)), 0, 1)
    return mesh.compute_vertex_normals()
