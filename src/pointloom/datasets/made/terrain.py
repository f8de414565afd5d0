"""A synthetic airborne scan (scenes/country.py)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_seed
from ...pcd.cloud import PointCloud
from ..array_cache import Arrays, cached
from ..scenes.country import COUNTRY_SIDE, TREE_CLASS, Country, painted_country

UTM_ORIGIN = np.array([447_800.0, 5_411_300.0, 312.0])  # [m] south-west corner in zone 32 north, and height of zero
FLIGHT_HEIGHT = 500.0  # [m] flight height
STRIP_POSITIONS = (-60.0, 60.0)  # [m] y of the two flight lines
PULSE_COUNT = 310_000
CROWN_PENETRATION = 0.45  # fraction of pulses that penetrate a crown
RANGE_NOISE = 0.03  # [m] standard deviation


def terrain(*, seed: int = 0) -> PointCloud:
    """A synthetic airborne laser scan of 200 x 200 m of hills with a lane, houses, fields and trees, with true classes.

    Two strips from 500 m height, about 7 pulses per square meter. A pulse that hits a crown returns from inside it and
    with 45 % probability also from below. Range noise is 3 cm.

    Args:
        seed: Seed of the positions of houses and trees, and of the noise.

    Returns:
        About 300,000 points [m] in UTM coordinates (zone 32 north, EPSG 32632) with aerial `colors` and the attributes
        `classification` (uint8, LAS, ground truth: 2 ground, 5 trees, 6 houses), `return_number` and
        `number_of_returns` (uint8), `intensity` (uint16) and `point_source_id` (uint16, the strip: 1 or 2).

    Raises:
        TypeError, ValueError: An invalid seed.

    Notes:
        Bitwise reproducible. Cached in the user's cache folder if it took long.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> cloud = loom.datasets.terrain()
        >>> ground = loom.classify_ground(cloud)
        >>> wrong = np.asarray(ground) != (cloud["classification"] == 2)
        >>> bool(wrong.mean() < 0.05)
        True
    """
    seed = check_seed(seed)
    arrays = cached("terrain", {"seed": seed}, lambda: _fly(seed))
    return PointCloud(arrays.pop("points"), **arrays)


def _fly(seed: int) -> Arrays:
    country, rng = painted_country(seed), np.random.default_rng([seed, 1])
    strips = [_strip(country, y, number + 1, rng) for number, y in enumerate(STRIP_POSITIONS)]
    columns = {name: np.concatenate([strip[name] for strip in strips]) for name in strips[0]}
    inside = (np.abs(columns["points"][:, :2]) <= COUNTRY_SIDE / 2).all(axis=1)
    columns = {name: values[inside] for name, values in columns.items()}
    columns["points"] = np.round(columns["points"] + [COUNTRY_SIDE / 2, COUNTRY_SIDE / 2, 0] + UTM_ORIGIN, 3)
    return columns


def _strip(country: Country, y: float, number: int, rng: np.random.Generator) -> Arrays:
    """The returns of one flight line along x."""
    count = PULSE_COUNT // len(STRIP_POSITIONS)
    margin = 10.0
    target = np.column_stack(
        [
            rng.uniform(-COUNTRY_SIDE / 2 - 2, COUNTRY_SIDE / 2 + 2, count),
            np.sort(rng.uniform(0, COUNTRY_SIDE / 2 + margin, count)) - (COUNTRY_SIDE / 2 if y < 0 else margin),
            np.zeros(count),
        ]
    )
    origin = np.column_stack([target[:, 0], np.full(count, y), np.full(count, FLIGHT_HEIGHT)])
    directions = (target - origin) / np.linalg.norm(target - origin, axis=1, keepdims=True)
    rays = np.concatenate([origin, directions], axis=1)
    below, above = country.solid.scene().cast_rays(rays), country.crowns.scene().cast_rays(rays)
    floor, leaves = below["t_hit"].astype(np.float64), above["t_hit"].astype(np.float64)
    in_crown = leaves < floor
    deep = np.minimum(leaves + rng.exponential(0.8, count), floor - 0.5)
    both = in_crown & (rng.random(count) < CROWN_PENETRATION)
    first = _returns(origin, directions, np.where(in_crown, deep, floor), rng)
    last = _returns(origin, directions, floor, rng)[both]
    solid, crown = (
        below["primitive_ids"].astype(np.int64),
        np.where(in_crown, above["primitive_ids"], 0).astype(np.int64),
    )
    colors = np.where(in_crown[:, None], country.crowns.colors[crown], country.solid.colors[solid])
    labels = np.where(in_crown, TREE_CLASS, country.solid.labels[solid]).astype(np.uint8)
    steep = np.abs((directions * below["primitive_normals"]).sum(axis=1))
    bright = np.where(in_crown, 0.5, 0.3 + 0.7 * steep) * colors.mean(axis=1)
    returns = 1 + both.astype(np.uint8)
    return {
        "points": np.concatenate([first, last]),
        "colors": np.concatenate([colors, country.solid.colors[solid][both]]).astype(np.float32),
        "classification": np.concatenate([labels, country.solid.labels[solid][both]]),
        "return_number": np.concatenate([np.ones(count, np.uint8), np.full(both.sum(), 2, np.uint8)]),
        "number_of_returns": np.concatenate([returns, returns[both]]),
        "intensity": np.rint(20_000 * np.concatenate([bright, 0.5 * bright[both]])).astype(np.uint16),
        "point_source_id": np.full(count + both.sum(), number, np.uint16),
    }


def _returns(
    origin: NDArray[np.float64], directions: NDArray[np.float64], ranges: NDArray[np.float64], rng: np.random.Generator
) -> NDArray[np.float64]:
    return origin + directions * (ranges + rng.normal(0, RANGE_NOISE, len(ranges)))[:, None]
