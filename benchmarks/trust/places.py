"""Synthetic sites on which no constant of pointloom was chosen: corridor, tunnel, staircase, hall, forest, table,
outdoors.

Each is a triangle mesh generated from a seed, with a solid texture, and a path through it.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

WAVES = 48  # of a texture
FINEST, COARSEST = 0.12, 2.5  # [m] wavelengths


@dataclass(frozen=True)
class Site:
    """A synthetic site.

    Attributes:
        vertices, triangles: Its surface, [v, 3] [m] and [t, 3].
        contrast: Of its texture, in gray levels of 255; 0 for white walls.
        seed: Of its texture.
        period: Length [m] after which the texture repeats along x; 0 for never.
    """

    vertices: Array
    triangles: NDArray[np.int64]
    contrast: float = 28.0
    seed: int = 0
    period: float = 0.0

    def shades(self, points: Array) -> Array:
        """Texture at points of the surface [n, 3], in gray levels about 0."""
        if not self.contrast:
            return np.zeros(len(points))
        rng = np.random.default_rng([self.seed, 9])
        lengths = np.geomspace(FINEST, COARSEST, WAVES)
        directions = rng.normal(size=(WAVES, 3))
        directions /= np.linalg.norm(directions, axis=1, keepdims=True)
        heights = lengths**0.4
        if self.period:
            points = np.column_stack([np.mod(points[:, 0], self.period), points[:, 1:]])
        waves = np.sin(points @ (directions * (2 * math.pi / lengths)[:, None]).T + rng.uniform(0, 2 * math.pi, WAVES))
        return self.contrast * (waves @ heights) / math.sqrt(0.5 * float(heights @ heights))


class Builder:
    """Collects pieces of a surface."""

    def __init__(self) -> None:
        self._vertices: list[Array] = []
        self._triangles: list[NDArray[np.int64]] = []
        self._count = 0

    def mesh(self, vertices: Array, triangles: NDArray[np.int64]) -> None:
        self._vertices.append(np.asarray(vertices, float))
        self._triangles.append(np.asarray(triangles, np.int64) + self._count)
        self._count += len(vertices)

    def box(self, low: tuple[float, ...], high: tuple[float, ...], angle: float = 0.0) -> None:
        """Add a box, rotated about its vertical axis [rad]."""
        a, b = np.array(low, float), np.array(high, float)
        corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
        vertices = a + corners * (b - a)
        c, s, middle = math.cos(angle), math.sin(angle), (a + b) / 2
        vertices = (vertices - middle) @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1.0]]) + middle
        quads = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
        self.mesh(vertices, np.array([t for q in quads for t in ((q[0], q[1], q[2]), (q[0], q[2], q[3]))]))

    def sheet(self, points: Array) -> None:
        """Add a grid of points [rows, columns, 3] as a surface."""
        rows, columns = points.shape[:2]
        at = np.arange(rows * columns).reshape(rows, columns)
        a, b, c, d = at[:-1, :-1].ravel(), at[:-1, 1:].ravel(), at[1:, 1:].ravel(), at[1:, :-1].ravel()
        self.mesh(points.reshape(-1, 3), np.vstack([np.column_stack([a, b, c]), np.column_stack([a, c, d])]))

    def trunk(self, x: float, y: float, low: float, high: float, radius: float, lean: float = 0.0) -> None:
        """Add a vertical cylinder that leans along x by `lean` meters, thinner at its top."""
        angles, heights = np.linspace(0, 2 * math.pi, 17), np.linspace(0, 1, 4)
        a, h = np.meshgrid(angles, heights)
        r = radius * (1 - 0.3 * h)
        self.sheet(np.stack([x + lean * h + r * np.cos(a), y + r * np.sin(a), low + (high - low) * h], axis=-1))

    def ball(self, middle: tuple[float, ...], radius: tuple[float, ...]) -> None:
        """Add an ellipsoid."""
        u, v = np.meshgrid(np.linspace(0, 2 * math.pi, 25), np.linspace(0, math.pi, 13))
        unit = np.stack([np.cos(u) * np.sin(v), np.sin(u) * np.sin(v), np.cos(v)], axis=-1)
        self.sheet(np.array(middle) + unit * np.array(radius))

    def build(self, **options: float) -> Site:
        return Site(np.vstack(self._vertices), np.vstack(self._triangles), **options)  # type: ignore[arg-type]


def bumps(rng: np.random.Generator, low: tuple[float, float], high: tuple[float, float], height: float) -> Array:
    """A ground grid [rows, columns, 3] between two corners with random heights [m]."""
    x, y = np.meshgrid(np.arange(low[0], high[0], 0.25), np.arange(low[1], high[1], 0.25))
    z = np.zeros_like(x)
    for length in np.geomspace(0.8, 8.0, 12):
        heading = rng.uniform(0, 2 * math.pi)
        wave = np.sin((x * math.cos(heading) + y * math.sin(heading)) * 2 * math.pi / length + rng.uniform(0, 6.28))
        z += height * (length / 8) ** 0.7 * wave / 2
    return np.stack([x, y, z], axis=-1)


def corridor(seed: int, *, contrast: float = 28.0, niches: bool = True, doors: float = 0.0) -> Site:
    """A corridor of 60 m along x, with different niches and cupboards, or with doors at one period [m]."""
    rng, b = np.random.default_rng([seed, 1]), Builder()
    half, height = rng.uniform(0.9, 1.3), rng.uniform(2.4, 2.9)
    b.box((-30, -half - 0.2, -0.2), (30, half + 0.2, 0))
    b.box((-30, -half - 0.2, height), (30, half + 0.2, height + 0.2))
    for side in (-1, 1):
        b.box(
            (-30, *sorted((side * half, side * (half + 0.2)))[:1], 0),
            (30, max(side * half, side * (half + 0.2)), height),
        )
    if doors:
        for x in np.arange(-29, 29, doors):
            for side in (-1, 1):
                near = side * (half - 0.06)
                b.box((x, min(near, side * half), 0), (x + 0.9, max(near, side * half), 2.05))
    if niches:
        x = -28.0
        while x < 28:
            side, deep, wide = rng.choice((-1, 1)), rng.uniform(0.1, 0.45), rng.uniform(0.3, 1.2)
            near = side * (half - deep)
            top = rng.uniform(0.5, 2.3)
            b.box((x, min(near, side * half), 0), (x + wide, max(near, side * half), top))
            x += wide + rng.uniform(0.3, 1.6)
    return b.build(contrast=contrast, seed=seed, period=doors)


def tunnel(seed: int, *, contrast: float = 28.0, rough: float = 0.25) -> Site:
    """A round tunnel of 80 m along x; rock with roughness `rough` [m], or a smooth bore."""
    rng, b = np.random.default_rng([seed, 2]), Builder()
    radius = rng.uniform(1.8, 2.6)
    x, a = np.meshgrid(np.arange(-40, 40, 0.2), np.linspace(0, 2 * math.pi, 65))
    r = np.full_like(x, radius)
    for length in np.geomspace(0.7, 6.0, 10):
        k = rng.integers(1, 7)
        r += rough * length / 6 * np.sin(x * 2 * math.pi / length + rng.uniform(0, 6.28)) * np.cos(k * a)
    b.sheet(np.stack([x, r * np.cos(a), 1.5 + r * np.sin(a)], axis=-1))
    return b.build(contrast=contrast, seed=seed)


def staircase(seed: int, *, contrast: float = 28.0) -> Site:
    """Thirty steps that rise along x between two walls; the steps only differ in texture."""
    rng, b = np.random.default_rng([seed, 3]), Builder()
    going, rise, half = rng.uniform(0.26, 0.30), rng.uniform(0.16, 0.18), rng.uniform(0.7, 1.0)
    for k in range(30):
        b.box((k * going, -half, k * rise - 0.4), ((k + 1) * going, half, (k + 1) * rise))
    length = 30 * going
    for side in (-1, 1):
        b.box((-2, min(side * half, side * (half + 0.2)), -1), (length, max(side * half, side * (half + 0.2)), 9))
    b.box((-2, -half, -0.2), (0, half, 0))
    return b.build(contrast=contrast, seed=seed)


def hall(seed: int, *, contrast: float = 28.0) -> Site:
    """A hall of 40 x 24 x 6 m with columns on a grid and random pallets."""
    rng, b = np.random.default_rng([seed, 4]), Builder()
    b.box((-20, -12, -0.2), (20, 12, 0))
    b.box((-20, -12, 6), (20, 12, 6.2))
    for low, high in (
        ((-20.2, -12), (-20, 12)),
        ((20, -12), (20.2, 12)),
        ((-20, -12.2), (20, -12)),
        ((-20, 12), (20, 12.2)),
    ):
        b.box((*low, 0), (*high, 6))
    for x in np.arange(-15, 16, 5.0):
        for y in (-9.0, -3.0, 3.0, 9.0):
            b.box((x - 0.2, y - 0.2, 0), (x + 0.2, y + 0.2, 6))
    for _ in range(40):
        x, y, angle = rng.uniform(-18, 18), rng.uniform(-11, 11), rng.uniform(0, math.pi)
        w, d, h = rng.uniform(0.4, 1.2, 3)
        if abs(y) > 1.2:
            b.box((x - w / 2, y - d / 2, 0), (x + w / 2, y + d / 2, h), angle)
    return b.build(contrast=contrast, seed=seed)


def forest(seed: int, *, contrast: float = 28.0) -> Site:
    """Tree trunks on uneven ground."""
    rng, b = np.random.default_rng([seed, 5]), Builder()
    b.sheet(bumps(rng, (-35, -25), (35, 25), 0.2))
    for _ in range(420):
        x, y, r = rng.uniform(-34, 34), rng.uniform(-24, 24), rng.uniform(0.08, 0.35)
        if abs(y) > 1.2:
            b.trunk(x, y, -1.0, rng.uniform(4, 11), r, rng.uniform(-0.6, 0.6))
    for _ in range(60):
        x, y, r = rng.uniform(-34, 34), rng.uniform(-24, 24), rng.uniform(0.2, 0.6, 3)
        if abs(y) > 1.5:
            b.ball((x, y, 0.2), tuple(r.tolist()))
    return b.build(contrast=contrast, seed=seed)


def table(seed: int, *, contrast: float = 28.0) -> Site:
    """A round table 0.75 m high with objects of 4 to 20 cm, on a floor without walls."""
    rng, b = np.random.default_rng([seed, 6]), Builder()
    b.box((-3, -3, -0.1), (3, 3, 0))
    b.trunk(0, 0, 0, 0.72, 0.08)
    angles, rings = np.meshgrid(np.linspace(0, 2 * math.pi, 49), np.linspace(0.01, 0.7, 8))
    b.sheet(np.stack([rings * np.cos(angles), rings * np.sin(angles), np.full_like(rings, 0.75)], axis=-1))
    for k in range(16):
        r, a = rng.uniform(0.08, 0.6), rng.uniform(0, 2 * math.pi)
        x, y = r * math.cos(a), r * math.sin(a)
        w, d, h = rng.uniform(0.04, 0.12, 3)
        if k % 3 == 0:
            b.box((x - w, y - d, 0.75), (x + w, y + d, 0.75 + 1.5 * h), rng.uniform(0, math.pi))
        elif k % 3 == 1:
            b.ball((x, y, 0.75 + h), (w, d, h))
        else:
            b.trunk(x, y, 0.75, 0.75 + 1.8 * h, 0.7 * w)
    return b.build(contrast=contrast, seed=seed)


def outdoors(seed: int, *, contrast: float = 28.0, things: int = 60, height: float = 0.15) -> Site:
    """Open ground with sheds, bushes and posts; without objects, a field."""
    rng, b = np.random.default_rng([seed, 7]), Builder()
    b.sheet(bumps(rng, (-60, -40), (60, 40), height))
    for k in range(things):
        x, y = rng.uniform(-40, 40), rng.uniform(-25, 25)
        if abs(y) < 2:
            continue
        w, d, h = rng.uniform(0.5, 4), rng.uniform(0.5, 4), rng.uniform(0.6, 4)
        if k % 3 == 0:
            b.box((x - w / 2, y - d / 2, -1), (x + w / 2, y + d / 2, h), rng.uniform(0, math.pi))
        elif k % 3 == 1:
            b.ball((x, y, 0.3), (w / 2, d / 2, h / 2))
        else:
            b.trunk(x, y, -1, 2 + h, rng.uniform(0.04, 0.15))
    return b.build(contrast=contrast, seed=seed)


KINDS: dict[str, Callable[[int], Site]] = {
    "corridor": corridor,
    "tunnel": tunnel,
    "staircase": staircase,
    "hall": hall,
    "forest": forest,
    "table": table,
    "outdoors": outdoors,
}
