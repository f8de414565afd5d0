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
from scipy.spatial import KDTree

Array = NDArray[np.float64]
Random = np.random.Generator
Present = Callable[[Array], NDArray[np.bool_]]

CELLS = 56  # of a field along each axis
COUNTS = 60, 6000  # points of a cloud
NOISES = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.002, 0.005, 0.01, 0.03)  # fractions of the diagonal
POOL = 20_000  # points from which a cloud is drawn
SCANNED = "cheburashka", "stanford-bunny", "abc part"
CHOOSING_SCANS = "nefertiti", "fandisk", "blocks", "nefertiti", "fandisk", "balls"  # 357 cases of seed 7
SCAN_COUNTS, SCAN_ROWS = (1000, 10_000), 110  # points, rays of a side
SCAN_NOISES = 0.0, 0.0, 0.01, 0.02  # fractions of the diagonal


@dataclass(frozen=True)
class Sampled:
    """Points of a shape.

    Attributes:
        case: A short description.
        truth: The mesh that the points were drawn from.
        points, normals: Shape (n, 3). `normals` is None if the surface is to be reconstructed without given ones.
        alpha: Radius for an alpha shape. None for the default.
        present: Returns False for positions on the shape in a part without points.
    """

    case: str
    truth: Any
    points: Array
    normals: Array | None
    alpha: float | None
    present: Present


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


def pockets(rng: Random) -> Any:
    """A block with one to three deep pockets, in which scans have few points."""
    half = rng.uniform(0.35, 0.75, 3)
    holes = []
    for _ in range(rng.integers(1, 4)):
        width, depth = rng.uniform(0.1, 0.25, 3) * 2 * half.min(), rng.uniform(0.5, 0.9) * 2 * half[2]
        center = np.append(rng.uniform(-0.6, 0.6, 2) * half[:2], half[2])
        holes.append((center, np.append(width[:2], depth)))
    return _mesh_of(
        lambda p: np.maximum(_box(p, np.zeros(3), half), -np.min([_box(p, *hole) for hole in holes], axis=0))
    )


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
    return _mesh_of(lambda p: KDTree(curve).query(p)[0] - radius)


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
POCKETS: dict[str, Callable[[Random], Any]] = {"pockets": pockets}  # scanned: 150 cases of seed 7
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
    given, present = None, _all
    fault = rng.choice(
        ["none", "half of it missing", "a hole", "outliers", "normals given", "opposite normals"],
        p=[0.67, 0.05, 0.06, 0.07, 0.11, 0.04],
    )
    if fault == "half of it missing":
        middle = np.median(points[:, 0])
        present = partial(_left_of, middle)
        points = points[present(points)]
    elif fault == "a hole":
        present = partial(_outside, points[0], rng.uniform(0.05, 0.3) * size)
        points = points[present(points)]
    elif fault == "outliers":
        points = _with_outliers(points, size, -0.5, rng)
    elif fault == "normals given":
        given = normals
    elif fault == "opposite normals":
        given = normals * np.where(rng.random(len(normals)) < rng.uniform(0.02, 0.5), -1.0, 1.0)[:, None]
    words += [str(fault)] if fault != "none" else []
    alpha = float(rng.uniform(2.5, 8)) * _spacing(points) if rng.random() < 0.5 else None
    return Sampled(f"{name}, {', '.join(words)}", truth, points, given, alpha, present)


def scanned(
    cases: Iterable[int], seed: int, names: tuple[str, ...] = SCANNED, shapes: dict[str, Any] = HELD_OUT
) -> Iterator[Sampled]:
    """Scans of shapes from 4 to 12 sides, with noise of 0 to 2 %, holes and outliers."""
    for k in cases:
        name = names[k % len(names)]
        rng = np.random.default_rng([seed, 1, k])
        try:
            truth = shapes[name](rng)
        except DataMissingError:
            continue
        yield _scan(f"{name} {seed + k}", truth, rng)


def _scan(name: str, truth: Any, rng: Random) -> Sampled:
    size, views = float(np.linalg.norm(np.ptp(truth.vertices, axis=0))), int(rng.integers(4, 13))
    hits, normals = _visible_points(truth, size, views, rng)
    low, high = SCAN_COUNTS
    rows = rng.choice(len(hits), min(int(low * (high / low) ** rng.random()), len(hits)), replace=False)
    points, given = hits[rows], normals[rows] if rng.random() < 0.5 else None
    words, noise = [f"{views} sides", f"{len(points)} points"], rng.choice(SCAN_NOISES)
    if noise:
        points = points + rng.normal(0, noise * size, points.shape)
        words.append(f"noise of {100 * noise:g} %")
    words += ["normals given"] if given is not None else []
    fault, is_present = rng.choice(["none", "a hole", "outliers"], p=[0.5, 0.25, 0.25]), _all
    if fault == "a hole":
        is_present = partial(_outside, points[0], rng.uniform(0.05, 0.15) * size)
        rows = is_present(points)
        points, given = points[rows], None if given is None else given[rows]
    elif fault == "outliers":
        points = _with_outliers(points, size, -1.0, rng)
    words += [str(fault)] if fault != "none" else []
    alpha = float(rng.uniform(2.5, 8)) * _spacing(points) if rng.random() < 0.5 else None
    present = partial(_seen, KDTree(hits), 0.01 * size, is_present)
    return Sampled(f"{name}, {', '.join(words)}", truth, points, given, alpha, present)


def _visible_points(truth: Any, size: float, views: int, rng: Random) -> tuple[Array, Array]:
    """Points that rays from evenly spaced directions hit, and normals toward the sensor."""
    import pointloom as loom

    scene = loom.RaycastingScene()
    scene.add_triangles(truth)
    k = np.arange(views) + 0.5
    z, turn = 1 - 2 * k / views, math.pi * (1 + math.sqrt(5)) * k
    flat = np.sqrt(1 - z * z)
    directions = np.column_stack([flat * np.cos(turn), flat * np.sin(turn), z]) @ _rotation(rng).T
    center, axis = (truth.vertices.min(0) + truth.vertices.max(0)) / 2, np.linspace(-0.52, 0.52, SCAN_ROWS) * size
    right, up = (part.reshape(-1, 1) for part in np.meshgrid(axis, axis))
    points, normals = [], []
    for direction in directions:
        frame = np.linalg.svd(direction[None])[2]  # the last two rows are orthogonal to the direction
        eye, targets = center + 2 * size * direction, center + right * frame[1] + up * frame[2]
        rays = np.hstack([np.broadcast_to(eye, targets.shape), targets - eye]).astype(np.float32)
        hits = scene.cast_rays(rays)
        hit = np.isfinite(hits["t_hit"])
        points.append(rays[hit, :3] + hits["t_hit"][hit, None] * rays[hit, 3:])
        found = hits["primitive_normals"][hit]
        normals.append(found * -np.sign(np.sum(found * rays[hit, 3:], axis=1, keepdims=True)))
    return np.vstack(points).astype(float), np.vstack(normals).astype(float)


def _with_outliers(points: Array, size: float, max_power: float, rng: Random) -> Array:
    """Replace a fraction of 10^-2.5 to 10^max_power of the points."""
    low, high = points.min(0) - 0.1 * size, points.max(0) + 0.1 * size
    rows = rng.random(len(points)) < 10 ** rng.uniform(-2.5, max_power)
    return np.where(rows[:, None], rng.uniform(low, high, points.shape), points)


def _seen(tree: KDTree, distance: float, is_present: Present, points: Array) -> NDArray[np.bool_]:
    return is_present(points) & (tree.query(points)[0] < distance)


def _all(points: Array) -> NDArray[np.bool_]:
    return np.ones(len(points), bool)


def _left_of(x: float, points: Array) -> NDArray[np.bool_]:
    return points[:, 0] < x


def _outside(center: Array, radius: float, points: Array) -> NDArray[np.bool_]:
    return np.linalg.norm(points - center, axis=1) > radius


def _spacing(points: Array) -> float:
    """Median distance to the nearest neighbor."""
    return float(np.median(KDTree(points).query(points, 2)[0][:, 1]))
