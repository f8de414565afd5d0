"""A synthetic landscape: hills with a lane, houses and trees [m], centered at the origin."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import elementwise
from .painted import Color, PaintedParts

COUNTRY_SIDE = 200.0  # [m] side of the square
GRID_STEP = 1.0  # [m] ground grid spacing
GROUND_CLASS, TREE_CLASS, BUILDING_CLASS = 2, 5, 6  # LAS: ground, high vegetation, building
HOUSE_COUNT, TREE_COUNT = 18, 170
LANE_WIDTH = 5.0  # [m]

_ROOF_COLORS: tuple[Color, ...] = ((0.66, 0.28, 0.20), (0.55, 0.24, 0.20), (0.40, 0.36, 0.36), (0.72, 0.40, 0.28))
_CROWN_COLORS: tuple[Color, ...] = ((0.16, 0.38, 0.15), (0.24, 0.46, 0.18), (0.35, 0.48, 0.16), (0.13, 0.32, 0.20))


@dataclasses.dataclass(frozen=True, eq=False)
class Country:
    """Surfaces for airborne scanning: `solid` ground and houses, and tree `crowns` that a laser may penetrate."""

    solid: PaintedParts
    crowns: PaintedParts


def ground_height(x: NDArray[Any], y: NDArray[Any]) -> NDArray[Any]:
    hills = 7 * np.sin(x / 47 + 0.6) * np.cos(y / 61) + 4 * np.sin(y / 37 - x / 90) + 0.035 * x
    ditch = -1.6 * elementwise(math.exp, -(((y - 12 * np.sin(x / 35) + 55) / 5) ** 2))
    rough = 0.06 * np.sin(1.3 * x + 0.4 * y) * np.sin(1.1 * y) + 0.25 * np.sin(x / 6.3) * np.sin(y / 7.7)
    return hills + ditch + rough


def lane(x: Any) -> Any:
    return 18 * np.sin(np.asarray(x) / 42) + 6


def painted_country(seed: int) -> Country:
    rng = np.random.default_rng(seed)
    solid, crowns = PaintedParts(), PaintedParts()
    _ground(solid)
    house_positions = _houses(solid, rng)
    _trees(crowns, rng, house_positions)
    return Country(solid, crowns)


def _ground(parts: PaintedParts) -> None:
    steps = round((COUNTRY_SIDE + 40) / GRID_STEP)
    sides = (np.arange(steps + 1) - steps / 2) * GRID_STEP
    x, y = np.meshgrid(sides, sides, indexing="ij")
    corners = np.stack([x, y, ground_height(x, y)], axis=-1).reshape(-1, 3)
    k = (np.arange(steps)[:, None] * (steps + 1) + np.arange(steps)).reshape(-1)
    faces = np.concatenate([np.stack([k, k + steps + 1, k + steps + 2], 1), np.stack([k, k + steps + 2, k + 1], 1)])
    middle = corners[faces].mean(axis=1)
    parts.label = GROUND_CLASS
    parts.add(corners, faces, _meadow(middle[:, 0], middle[:, 1]))


def _meadow(x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.float64]:
    """Ground colors: striped fields, grass, the lane."""
    grass = np.array([0.44, 0.56, 0.27]) * (1 + 0.12 * np.sin(x / 9) * np.sin(y / 7))[:, None]
    field = np.array([0.74, 0.66, 0.36]) * (0.94 + 0.06 * np.sign(np.sin(2.2 * (x + 0.3 * y))))[:, None]
    plough = np.array([0.50, 0.38, 0.27]) * (0.92 + 0.08 * np.sign(np.sin(2.6 * y)))[:, None]
    colors = np.where(((x > 20) & (y < -30))[:, None], field, grass)
    colors = np.where(((x < -25) & (y > 45))[:, None], plough, colors)
    return np.where((np.abs(y - lane(x)) < LANE_WIDTH / 2)[:, None], (0.60, 0.58, 0.55), colors)


def _houses(parts: PaintedParts, rng: np.random.Generator) -> NDArray[np.float64]:
    """Houses on both sides of the lane. Returns positions (n, 2)."""
    house_positions = []
    parts.label = BUILDING_CLASS
    for k in range(HOUSE_COUNT):
        along = (k // 2 + 0.5) / (HOUSE_COUNT // 2) * (COUNTRY_SIDE - 20) - (COUNTRY_SIDE - 20) / 2 + rng.uniform(-3, 3)
        side = 1 if k % 2 else -1
        x, y = along, float(lane(along)) + side * rng.uniform(11, 17)
        length, width, high = rng.uniform(9, 14), rng.uniform(7, 10), rng.uniform(3.0, 6.5)
        angle = math.atan(18 / 42 * math.cos(along / 42)) + rng.uniform(-0.15, 0.15)
        floor = float(ground_height(np.array(x), np.array(y)))
        roof = _ROOF_COLORS[rng.integers(len(_ROOF_COLORS))]
        parts.set_frame(x, y, floor, angle=angle)
        walls = (0.88, 0.84, 0.76)
        parts.box((0, 0, high / 2 - 1.5), (length, width, high + 3), walls)
        parts.gable((0, 0, high), (length + 0.6, width + 0.8, rng.uniform(2.0, 3.8)), roof, walls)
        parts.box((length * 0.2, 0.8, high + 2.2), (0.8, 0.8, 2.6), (0.55, 0.33, 0.28))
        if rng.random() < 0.5:
            parts.box((-length / 2 - 2.2, 0.5, 0.3), (3.6, 5.5, 5.0), (0.55, 0.55, 0.56))
        house_positions.append((x, y))
    return np.array(house_positions)


def _trees(parts: PaintedParts, rng: np.random.Generator, house_positions: NDArray[np.float64]) -> None:
    parts.label, planted = TREE_CLASS, 0
    while planted < TREE_COUNT:
        in_wood = planted < TREE_COUNT * 0.6
        x, y = rng.uniform((-96, -96), (-10, -35)) if in_wood else rng.uniform(-97, 97, 2)
        near_house = np.hypot(house_positions[:, 0] - x, house_positions[:, 1] - y).min() < 11
        if near_house or abs(y - lane(x)) < 5:
            continue
        tall, wide = rng.uniform(7, 16), rng.uniform(2.0, 3.6)
        floor, leaf = float(ground_height(np.array(x), np.array(y))), _CROWN_COLORS[rng.integers(len(_CROWN_COLORS))]
        parts.set_frame(x, y, floor, angle=rng.uniform(0, 6))
        if rng.random() < 0.35:  # a conifer
            for fraction in (0.35, 0.55, 0.75, 0.92):
                radius = 0.8 * wide * (1.15 - fraction)
                parts.crown((0, 0, fraction * tall), (radius, radius, 0.16 * tall), _CROWN_COLORS[3], rng)
        else:
            for _ in range(3):
                off = rng.normal(0, 0.3 * wide, 3)
                parts.crown(np.array([0, 0, 0.72 * tall]) + off, (wide, wide, 0.28 * tall), leaf, rng)
        planted += 1
