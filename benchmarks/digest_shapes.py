"""The operations of digests.py on planes, spheres, cylinders, cones and tori."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields
from functools import partial
from typing import Any

import numpy as np
from digest_scenes import UTM, loom

THRESHOLD = 0.02  # [m], four times the noise
PART = 700  # points of each shape


def hall(d: Any) -> Any:
    """A floor, a sphere, a pipe, a cone and a ring with normals and clutter, at UTM coordinates."""
    rng = np.random.default_rng(6)
    angles, fraction, tube = rng.random((3, PART)) * [[2 * np.pi], [1], [2 * np.pi]]
    around, up = np.column_stack([np.cos(angles), np.sin(angles), 0 * angles]), np.array([0.0, 0.0, 1.0])
    height, z = fraction[:, None], 2 * fraction[:, None] - 1
    shapes = [
        np.column_stack([3 * rng.random(PART), 2 * rng.random(PART), np.zeros(PART)]),
        0.3 * (np.sqrt(1 - z * z) * around + z * up) + [0.5, 0.5, 0.6],
        0.2 * around + 0.8 * height * up + [1.2, 0.5, 0.2],
        (0.1 + 0.3 * height) * around + 0.6 * height * up + [2.0, 0.6, 0.3],
        0.35 * around + 0.1 * (np.cos(tube)[:, None] * around + np.sin(tube)[:, None] * up) + [2.3, 1.4, 0.5],
    ]
    points = np.vstack(shapes) + 0.005 * rng.normal(size=(5 * PART, 3))
    points = rng.permutation(np.vstack([points, rng.random((PART, 3)) * [3, 2, 1.2]]))
    return d.cloud(points + UTM).estimate_normals(max_nn=20)


def numbers(shape: Any) -> list[Any]:
    """All values of a shape as numbers; NaN for missing ones."""
    values = (getattr(shape, field.name) for field in fields(shape) if field.name not in ("kind", "reasons"))
    arrays = [np.nan_to_num(np.asarray(value, np.float64), nan=-9.0) for value in values]
    return [*arrays, np.frombuffer("".join((shape.kind, *shape.warnings)).encode(), np.uint8)]


def segmented(d: Any, kind: str) -> list[Any]:
    """The shape of a kind with the most inliers, and these; a pipe is a torus with a large radius."""
    shape, rows = hall(d).segment_shape(kind, THRESHOLD, 25, max_radius=None if kind == "cone" else 1.0)
    return [*numbers(shape), rows]


def detected(d: Any) -> list[Any]:
    """All shapes, labels and distances."""
    result = loom().detect_shapes(hall(d), THRESHOLD, 25, min_support=250)
    return [result.labels, result.distances, *(n for s in result.shapes for n in numbers(s))]


def fitted(d: Any) -> list[Any]:
    """A torus fitted to weighted points."""
    rng = np.random.default_rng(7)
    angles, tube = rng.random((2, 900)) * 2 * np.pi
    ring = 1 + 0.3 * np.cos(tube)
    points = np.column_stack([ring * np.cos(angles), ring * np.sin(angles), 0.3 * np.sin(tube)])
    cloud = d.cloud(points + 0.004 * rng.normal(size=points.shape))
    return numbers(loom().fit_shape(cloud, "torus", weights=rng.uniform(0.5, 2, 900)))


SHAPES: dict[str, Callable[[Any], Any]] = {
    **{f"segment_shape, {kind}": partial(segmented, kind=kind) for kind in ("sphere", "cylinder", "cone", "torus")},
    "detect_shapes": detected,
    "fit_shape": fitted,
}
