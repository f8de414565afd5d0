"""A synthetic street of labeled triangles: winding road, houses, gardens, trees, parked cars, lamps and signs."""

from __future__ import annotations

import math

import numpy as np

from .drive import road
from .painted import Color, PaintedParts

ROAD_LABEL, PAVEMENT_LABEL, GRASS_LABEL, HOUSE_LABEL, CAR_LABEL, TREE_LABEL, POLE_LABEL, FENCE_LABEL = range(1, 9)
STREET_MARGIN = 70.0  # [m] of street before the first and after the last scanner position

_WALL_COLORS: tuple[Color, ...] = (
    (0.88, 0.80, 0.66),
    (0.78, 0.45, 0.36),
    (0.70, 0.78, 0.82),
    (0.93, 0.90, 0.84),
    (0.84, 0.66, 0.42),
)
_ROOF_COLORS: tuple[Color, ...] = ((0.62, 0.27, 0.20), (0.40, 0.30, 0.28), (0.32, 0.36, 0.42))
_CAR_COLORS: tuple[Color, ...] = (
    (0.80, 0.15, 0.14),
    (0.15, 0.32, 0.65),
    (0.90, 0.90, 0.88),
    (0.20, 0.22, 0.24),
    (0.95, 0.72, 0.16),
)
_LEAF_COLORS: tuple[Color, ...] = ((0.24, 0.52, 0.20), (0.36, 0.58, 0.22), (0.55, 0.56, 0.18), (0.20, 0.44, 0.26))
_GLASS_RGB: Color = (0.22, 0.34, 0.44)
_STEEL_RGB: Color = (0.46, 0.48, 0.50)


def painted_street(length: float, seed: int) -> PaintedParts:
    """The street from x = -STREET_MARGIN to length + STREET_MARGIN [m], ground at z = 0."""
    rng, parts = np.random.default_rng(seed), PaintedParts()
    low, high = -STREET_MARGIN, length + STREET_MARGIN
    _ground(parts, low, high)
    for side in (-1, 1):
        x = low
        while x < high:
            width = rng.uniform(9, 15)
            _house(parts, rng, x + width / 2, side, width)
            if rng.random() < 0.75:
                _car(parts, rng, x + rng.uniform(0, width), side)
            gap = rng.uniform(3, 7)
            _tree(parts, rng, x + width + gap / 2, side * rng.uniform(7.2, 10.5))
            if rng.random() < 0.5:
                _tree(parts, rng, x + rng.uniform(0, width), side * rng.uniform(17, 28))
            x += width + gap
        for at in np.arange(low + 6 + 9 * (side > 0), high, 18.0):
            _lamp(parts, at, side)
        for at in np.arange(low + 15, high, 47.0):
            _sign(parts, at + 11 * side, side)
    return parts


def _strip(parts: PaintedParts, xs: np.ndarray, left: float, right: float, height: float, colors: np.ndarray) -> None:
    """A band along the road between two distances from its center, one color per step."""
    middle = road(xs)
    rows = np.stack([np.column_stack([xs, middle + y, np.full(len(xs), height)]) for y in (right, left)], axis=1)
    k = 2 * np.arange(len(xs) - 1)
    faces = np.concatenate([np.column_stack([k, k + 2, k + 3]), np.column_stack([k, k + 3, k + 1])])
    parts.add(rows.reshape(-1, 3), faces, np.concatenate([colors, colors]))


def _ground(parts: PaintedParts, low: float, high: float) -> None:
    xs = np.arange(low, high + 1, 1.0)
    steps = len(xs) - 1
    asphalt, rng = np.full((steps, 3), 0.33), np.random.default_rng(5)
    parts.set_frame(0, 0)
    parts.label = ROAD_LABEL
    _strip(parts, xs, 4.2, -4.2, 0.0, asphalt * rng.uniform(0.92, 1.08, (steps, 1)))
    dashes = np.flatnonzero(np.arange(steps) % 6 < 3)
    for k in dashes:
        _strip(parts, xs[k : k + 2], 0.08, -0.08, 0.004, np.full((1, 3), 0.92))
    for side in (-1, 1):
        parts.label = PAVEMENT_LABEL
        left, right = sorted((side * 4.2, side * 6.4), reverse=True)
        slabs = np.where((np.arange(steps) % 2 == 0)[:, None], 0.62, 0.57) * np.array([[1.0, 0.98, 0.94]])
        _strip(parts, xs, left, right, 0.12, slabs)
        _curb(parts, xs, side * 4.2)
        parts.label = GRASS_LABEL
        left, right = sorted((side * 6.4, side * 60.0), reverse=True)
        meadow = np.array([[0.40, 0.55, 0.25]]) * rng.uniform(0.85, 1.1, (steps, 1))
        _strip(parts, xs, left, right, 0.1, meadow)


def _curb(parts: PaintedParts, xs: np.ndarray, y: float) -> None:
    middle = road(xs) + y
    rows = np.stack([np.column_stack([xs, middle, np.full(len(xs), z)]) for z in (0.0, 0.12)], axis=1)
    k = 2 * np.arange(len(xs) - 1)
    faces = np.concatenate([np.column_stack([k, k + 2, k + 3]), np.column_stack([k, k + 3, k + 1])])
    parts.add(rows.reshape(-1, 3), faces, (0.70, 0.70, 0.68))


def _heading(x: float) -> float:
    return math.atan2(12 / 60 * math.cos(x / 60), 1)


def _house(parts: PaintedParts, rng: np.random.Generator, x: float, side: int, width: float) -> None:
    depth, floors = rng.uniform(8, 11), int(rng.integers(1, 4))
    setback, high = rng.uniform(8.5, 12.5), 2.9 * floors + 0.4
    walls, roof = _WALL_COLORS[rng.integers(len(_WALL_COLORS))], _ROOF_COLORS[rng.integers(len(_ROOF_COLORS))]
    parts.label = HOUSE_LABEL
    parts.set_frame(x, road(x) + side * (setback + depth / 2), 0.1, angle=_heading(x) + (0 if side > 0 else math.pi))
    # the street is at -y in the house's frame
    parts.box((0, 0, high / 2), (width, depth, high), walls)
    parts.gable((0, 0, high), (width + 0.8, depth + 1.0, rng.uniform(2.2, 4.0)), roof, walls)
    front, bays = -depth / 2 - 0.04, max(2, int(width // 3))
    door = int(rng.integers(bays))
    for floor in range(floors):
        for bay in range(bays):
            at = (bay + 0.5) / bays * width - width / 2
            if floor == 0 and bay == door:
                parts.box((at, front, 1.05), (1.0, 0.12, 2.1), (0.40, 0.22, 0.15))
                parts.box((at, front - 0.6, 0.1), (1.6, 1.2, 0.2), (0.66, 0.65, 0.62))
                parts.box((at, front - 0.5, 2.45), (1.8, 1.2, 0.12), roof)
            else:
                parts.box((at, front, 1.7 + 2.9 * floor), (1.25, 0.10, 1.35), (0.96, 0.95, 0.92))
                parts.box((at, front - 0.05, 1.7 + 2.9 * floor), (1.05, 0.06, 1.15), _GLASS_RGB)
    parts.box((width * 0.25, depth * 0.1, high + 2.6), (0.7, 0.7, 2.0), (0.55, 0.32, 0.27))
    if rng.random() < 0.6:
        parts.label = FENCE_LABEL
        y = -depth / 2 - setback + 6.9
        parts.box((width * 0.28, y, 0.45), (width * 0.42, 0.5, 0.9), (0.20, 0.40, 0.18))
        parts.box((-width * 0.28, y, 0.45), (width * 0.42, 0.5, 0.9), (0.20, 0.40, 0.18))


def _car(parts: PaintedParts, rng: np.random.Generator, x: float, side: int) -> None:
    color = _CAR_COLORS[rng.integers(len(_CAR_COLORS))]
    angle = _heading(x) + (math.pi if rng.random() < 0.5 else 0.0)
    parts.label = CAR_LABEL
    parts.set_frame(x, road(x) + side * 3.15, angle=angle)
    parts.box((0, 0, 0.62), (4.2, 1.74, 0.62), color, taper=0.95)
    parts.box((-0.25, 0, 1.2), (2.5, 1.55, 0.58), _GLASS_RGB, taper=0.72)
    parts.box((-0.25, 0, 1.5), (1.75, 1.12, 0.05), color)
    for along in (-1.3, 1.3):
        for across in (-0.8, 0.8):
            parts.cylinder((along, across, 0.32), 0.32, 0.2, (0.10, 0.10, 0.11), axis=1)
    parts.box((2.05, 0, 0.68), (0.1, 1.4, 0.14), (0.95, 0.93, 0.80))
    parts.box((-2.05, 0, 0.70), (0.1, 1.4, 0.12), (0.70, 0.10, 0.10))


def _tree(parts: PaintedParts, rng: np.random.Generator, x: float, y: float) -> None:
    tall, wide, leaf = rng.uniform(4.5, 9), rng.uniform(1.4, 2.6), _LEAF_COLORS[rng.integers(len(_LEAF_COLORS))]
    parts.label = TREE_LABEL
    parts.set_frame(x, road(x) + y, angle=rng.uniform(0, 6))
    parts.cylinder((0, 0, tall * 0.3), 0.16 + 0.02 * tall, tall * 0.6, (0.36, 0.26, 0.18))
    for _ in range(5):
        off = rng.normal(0, 0.35 * wide, 3) * [1, 1, 0.8]
        parts.crown(
            np.array([0, 0, tall * 0.72]) + off, wide * rng.uniform(0.55, 0.8) * np.array([1, 1, 0.9]), leaf, rng
        )


def _lamp(parts: PaintedParts, x: float, side: int) -> None:
    parts.label = POLE_LABEL
    parts.set_frame(x, road(x) + side * 4.7, angle=_heading(x))
    parts.cylinder((0, 0, 2.9), 0.08, 5.8, _STEEL_RGB)
    parts.box((0, -side * 0.75, 5.8), (0.09, 1.6, 0.09), _STEEL_RGB)
    parts.box((0, -side * 1.5, 5.72), (0.26, 0.6, 0.12), (0.95, 0.92, 0.75))


def _sign(parts: PaintedParts, x: float, side: int) -> None:
    parts.label = POLE_LABEL
    parts.set_frame(x, road(x) + side * 5.0, angle=_heading(x))
    parts.cylinder((0, 0, 1.3), 0.04, 2.6, _STEEL_RGB)
    parts.cylinder((-0.05 * side, 0, 2.5), 0.38, 0.03, (0.85, 0.14, 0.12), axis=0, resolution=24)
    parts.box((-0.08 * side, 0, 2.5), (0.02, 0.5, 0.12), (0.96, 0.96, 0.95))
