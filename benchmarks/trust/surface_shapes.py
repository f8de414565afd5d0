"""Shapes and points for `surfaces.py`, in two families without a common shape.

Constants of the checks may be chosen on `CHOOSING`. No constant may be chosen on `HELD_OUT`. A shape is a triangle mesh
with a diagonal of about one, generated from a seed or read from a file of the real data.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cache, partial
from typing import Any

import numpy as np
from numpy.typing import NDArray
from real_data import DataMissingError, real_data

Array = NDArray[np.float64]
Random = np.random.Generator

CELLS = 56  # of a field along each axis
COUNTS = 60, 6000  # points of a cloud
NOISES = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.002, 0.005, 0.01, 0.03)  # fractions of the diagonal
POOL = 20_000  # points from which a cloud is drawn


@dataclass(frozen=True)
class Sampled:
    """Points of a shape.

    Attributes:
        case: A short description.
        truth: The mesh that the points were drawn from.
        points, normals: Shape (n, 3). `normals` is None if the surface is to be reconstructed without given ones.
        is_complete: False if points are missing in a part of the shape.
        alpha: Radius for an alpha shape. None for the default.
        present: Selects the points of the shape that are not in a part without points.
    """

    case: str
    truth: Any
    points: Array
    normals: Array | None
    is_complete: bool
    alpha: float | None
    present: Callable[[Array], NDArray[np.bool_]]


def _mesh_of(field: Callable[[Array], Array]) -> Any:
    """Zero level of a field that is negative inside, in the cube from -1 to 1."""
    import pointloom as loom

    axis = np.linspace(-1, 1, CELLS + 1)
    grid = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), axis=-1)
    values = field(grid.reshape(-1, 3)).reshape(grid.shape[:3])
    values[[0, -1]] = np.maximum(values[[0, -1]], 1e-3)  # closed at the cube
    values[:, [0, -1]] = np.maximum(values[:, [0, -1]], 1e-3)
    values[:, :, [0, -1]] = np.maximum(values[:, :, [0, -1]], 1e-3)
    return loom.meshing.marching_cubes(values, spacing=[2 / CELLS] * 3, origin=[-1, -1, -1])


def _sheet(height: Callable[[Array, Array], Array]) -> Any:
    """Open surface of a height above the square from -1 to 1."""
    import pointloom as loom

    n = CELLS + 1
    x, y = np.meshgrid(np.linspace(-1, 1, n), np.linspace(-1, 1, n), indexing="ij")
    rows = np.arange(n * n).reshape(n, n)
    a, b, c, d = rows[:-1, :-1].ravel(), rows[1:, :-1].ravel(), rows[1:, 1:].ravel(), rows[:-1, 1:].ravel()
    triangles = np.vstack([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    return loom.TriangleMesh(np.column_stack([x.ravel(), y.ravel(), height(x, y).ravel()]), triangles)


def _box(points: Array, center: Array, half: Array) -> Array:
    away = np.abs(points - center) - half
    return np.linalg.norm(np.maximum(away, 0), axis=1) + np.minimum(away.max(axis=1), 0)


# Shapes for choosing constants.


def balls(rng: Random) -> Any:
    """Smooth union of balls."""
    centers, radii = rng.uniform(-0.5, 0.5, (rng.integers(2, 7), 3)), rng.uniform(0.15, 0.4)
    return _mesh_of(lambda p: 0.6 - np.exp(-((p[:, None] - centers) ** 2).sum(2) / radii**2).sum(1))


def blocks(rng: Random) -> Any:
    """Union of boxes, one of them thin, without a further box."""
    parts = [(rng.uniform(-0.4, 0.4, 3), rng.uniform(0.08, 0.5, 3)) for _ in range(rng.integers(1, 4))]
    thin = rng.permutation([rng.uniform(0.04, 0.1), rng.uniform(0.3, 0.8), rng.uniform(0.3, 0.8)])
    hole = rng.uniform(-0.5, 0.5, 3), rng.uniform(0.1, 0.3, 3)
    return _mesh_of(
        lambda p: np.maximum(
            np.minimum(np.min([_box(p, *part) for part in parts], axis=0), _box(p, np.zeros(3), thin)), -_box(p, *hole)
        )
    )


def ring(rng: Random) -> Any:
    """A torus."""
    import pointloom as loom

    return loom.TriangleMesh.create_torus(0.7, rng.uniform(0.05, 0.3), 60, 30)


def waves(rng: Random) -> Any:
    """An open sheet of plane waves."""
    ways, phases = rng.normal(0, rng.uniform(1, 4), (4, 2)), rng.uniform(0, 2 * math.pi, 4)
    height = rng.uniform(0.02, 0.15)
    return _sheet(lambda x, y: height * sum(np.sin(u * x + v * y + p) for (u, v), p in zip(ways, phases, strict=True)))


def tall_box(rng: Random) -> Any:
    import pointloom as loom

    return loom.TriangleMesh.create_box(*rng.uniform(0.1, 1, 3))


# Shapes on which no constant is chosen.


def star(rng: Random) -> Any:
    """A sphere with smooth bumps: polynomials of the direction up to degree 5."""
    ways, powers = rng.normal(size=(12, 3)), rng.integers(2, 6, 12)
    ways /= np.linalg.norm(ways, axis=1, keepdims=True)
    heights = rng.normal(0, rng.uniform(0.03, 0.2), 12)

    def field(p: Array) -> Array:
        lengths = np.linalg.norm(p, axis=1) + 1e-9
        bumps = (((p / lengths[:, None]) @ ways.T) ** powers) @ heights
        return lengths - np.clip(0.6 + bumps, 0.1, 0.95)

    return _mesh_of(field)


def machined(rng: Random) -> Any:
    """Plates and cylinders with drilled holes."""
    plate = rng.permutation([rng.uniform(0.05, 0.25), rng.uniform(0.4, 0.85), rng.uniform(0.4, 0.85)])
    pins = [(rng.uniform(-0.4, 0.4, 3), rng.integers(3), rng.uniform(0.08, 0.3)) for _ in range(3)]

    def cylinder(p: Array, center: Array, axis: int, radius: float, half: float) -> Array:
        q = p - center
        return np.maximum(np.linalg.norm(np.delete(q, axis, axis=1), axis=1) - radius, np.abs(q[:, axis]) - half)

    def field(p: Array) -> Array:
        solid = _box(p, np.zeros(3), plate)
        for center, axis, radius in pins[:2]:
            solid = np.minimum(solid, cylinder(p, center, axis, radius, 0.5))
        center, axis, radius = pins[2]
        return np.maximum(solid, -cylinder(p, center, axis, radius, 2.0))

    return _mesh_of(field)


def knot(rng: Random) -> Any:
    """A tube along a closed curve."""
    from scipy.spatial import cKDTree

    t = np.linspace(0, 2 * math.pi, 400, endpoint=False)
    amplitudes, phases = rng.normal(size=(3, 3)) / [1, 2, 3], rng.uniform(0, 2 * math.pi, (3, 3))
    curve = np.column_stack(
        [
            (a[:, None] * np.sin(np.outer([1, 2, 3], t) + p[:, None])).sum(0)
            for a, p in zip(amplitudes, phases, strict=True)
        ]
    )
    curve *= 0.7 / np.abs(curve).max()
    radius = float(rng.uniform(0.08, 0.25))
    return _mesh_of(lambda p: cKDTree(curve).query(p)[0] - radius)


def hills(rng: Random) -> Any:
    """An open sheet of round hills on a saddle."""
    centers, widths = rng.uniform(-1, 1, (8, 2)), rng.uniform(0.15, 0.5, 8)
    heights, saddle = rng.normal(0, rng.uniform(0.05, 0.25), 8), rng.normal(0, 0.3, 2)

    def height(x: Array, y: Array) -> Array:
        bumps = sum(
            h * np.exp(-((x - c[0]) ** 2 + (y - c[1]) ** 2) / w**2)
            for h, c, w in zip(heights, centers, widths, strict=True)
        )
        return saddle[0] * x * x + saddle[1] * y * y + bumps

    return _sheet(height)


def rounded(rng: Random) -> Any:
    """A superquadric: from a rounded box to a double cone."""
    half, power = rng.uniform(0.15, 0.8, 3), rng.uniform(0.9, 6)
    return _mesh_of(lambda p: (np.abs(p / half) ** power).sum(1) ** (1 / power) - 1)


def _file(name: str) -> Callable[[Random], Any]:
    def read(rng: Random) -> Any:
        return _read(name).rotate(_rotation(rng), (0, 0, 0))

    return read


@cache
def _read(name: str) -> Any:
    import pointloom as loom

    mesh = loom.read_triangle_mesh(real_data(name))
    return mesh.scale(1 / float(np.ptp(mesh.vertices, axis=0).max()), (0, 0, 0))


def _rotation(rng: Random) -> Array:
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q *= np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else -q


COMMON = "mesh-common3d/{}.obj"
CHOOSING: dict[str, Callable[[Random], Any]] = {
    "balls": balls,
    "blocks": blocks,
    "ring": ring,
    "waves": waves,
    "tall box": tall_box,
    "nefertiti": _file(COMMON.format("nefertiti")),
    "fandisk": _file(COMMON.format("fandisk")),
}
HELD_OUT: dict[str, Callable[[Random], Any]] = {
    "star": star,
    "machined": machined,
    "knot": knot,
    "hills": hills,
    "rounded": rounded,
    "cheburashka": _file(COMMON.format("cheburashka")),
    "stanford-bunny": _file(COMMON.format("stanford-bunny")),
    "abc part": _file("mesh-points2surf-abc/03_meshes/00011084_fddd53ce45f640f3ab922328_trimesh_019.ply"),
}


def sampled(shapes: dict[str, Callable[[Random], Any]], cases: Iterable[int], seed: int) -> Iterator[Sampled]:
    """Points of shapes from ample to far too few, with noise, gaps, uneven density, and opposite normals."""
    names = list(shapes)
    for k in cases:
        name = names[k % len(names)]
        rng = np.random.default_rng([seed, k])
        try:
            truth = shapes[name](rng)
        except DataMissingError:
            continue
        if len(truth):
            yield _sample(f"{name} {seed + k}", truth, rng)


def _sample(name: str, truth: Any, rng: Random) -> Sampled:
    size = float(np.linalg.norm(np.ptp(truth.vertices, axis=0)))
    few, many = COUNTS
    count = int(few * (many / few) ** math.sqrt(rng.random()))
    words = [f"{count} points"]
    seed = int(rng.integers(1 << 30))
    kind = rng.choice(["random", "even", "dense to one side"], p=[0.35, 0.5, 0.15])
    if kind == "even":
        cloud = truth.sample_points_poisson_disk(count, use_triangle_normal=True, seed=seed)
    else:
        cloud = truth.sample_points_uniformly(POOL, use_triangle_normal=True, seed=seed)
    points, normals = cloud.points, cloud.normals
    if kind != "even":
        x = points[:, 0] - points[:, 0].min()
        weights = np.ones(POOL) if kind == "random" else np.exp(-3 * x / x.max())
        rows = rng.choice(POOL, count, replace=False, p=weights / weights.sum())
        points, normals = points[rows], normals[rows]
    words.append(str(kind))
    noise = rng.choice(NOISES)
    if noise:
        points = points + rng.normal(0, noise * size, points.shape)
        words.append(f"noise of {100 * noise:g} %")
    is_complete, given, present = True, None, _all
    fault = rng.choice(
        ["none", "half of it missing", "a hole", "outliers", "normals given", "opposite normals"],
        p=[0.67, 0.05, 0.06, 0.07, 0.11, 0.04],
    )
    if fault == "half of it missing":
        middle = np.median(points[:, 0])
        present = partial(_left_of, middle)
        points, is_complete = points[present(points)], False
    elif fault == "a hole":
        present = partial(_outside, points[0], rng.uniform(0.05, 0.3) * size)
        points, is_complete = points[present(points)], False
    elif fault == "outliers":
        low, high = points.min(0) - 0.1 * size, points.max(0) + 0.1 * size
        rows = rng.random(len(points)) < 10 ** rng.uniform(-2.5, -0.5)
        points = np.where(rows[:, None], rng.uniform(low, high, points.shape), points)
    elif fault == "normals given":
        given = normals
    elif fault == "opposite normals":
        given = normals * np.where(rng.random(len(normals)) < rng.uniform(0.02, 0.5), -1.0, 1.0)[:, None]
    words += [str(fault)] if fault != "none" else []
    alpha = float(rng.uniform(2.5, 8)) * _spacing(points) if rng.random() < 0.5 else None
    return Sampled(f"{name}, {', '.join(words)}", truth, points, given, is_complete, alpha, present)


def _all(points: Array) -> NDArray[np.bool_]:
    return np.ones(len(points), bool)


def _left_of(x: float, points: Array) -> NDArray[np.bool_]:
    return points[:, 0] < x


def _outside(center: Array, radius: float, points: Array) -> NDArray[np.bool_]:
    return np.linalg.norm(points - center, axis=1) > radius


def _spacing(points: Array) -> float:
    """Median distance to the nearest neighbor."""
    from scipy.spatial import cKDTree

    return float(np.median(cKDTree(points).query(points, 2)[0][:, 1]))
