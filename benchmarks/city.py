"""A procedural city and a scanner that drives through it, with true poses.

The city is a grid of blocks: facades with recessed windows, doors, trees, lamps, parked cars. Some blocks are exact
copies of each other. It has a parking deck of two floors, a tunnel and open ground. Each point is measured from the
scanner's pose at that moment, between moving vehicles. Everything follows from a seed.

    python benchmarks/city.py alike --sensor 64 --seed 3     # writes the drive to build/city_drives

A drive of 1 km with 64 beams of 900 azimuths takes about a minute and 400 MB.
"""

from __future__ import annotations

import argparse
import hashlib
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline
from scipy.ndimage import gaussian_filter1d
from street import Drive

from pointloom.datasets.scenes.drive import SCAN_PERIOD, SENSOR_HEIGHT, rotating_rays
from pointloom.datasets.scenes.painted import PaintedParts

Array = NDArray[np.float64]
Waypoint = tuple[float, float, float]

CACHE = Path(__file__).parents[1] / "build" / "city_drives"

PITCH = (92.0, 76.0)  # [m] between street centers along x and y
STREET_WIDTH = 17.0  # [m] between building lines: two lanes, parked cars, sidewalks
COLUMNS, ROWS = range(-1, 6), range(-1, 5)  # of blocks; block (i, j) is north-east of crossing (i, j)
ALIKE_ROWS = (-1, 0)  # on both sides of the street y = 0: all blocks are copies
OPEN_BLOCKS = {(i, j) for i in (-1, 0, 1) for j in (3, 4)} | {(-1, 2), (0, 2)}
DECK_BLOCK = (3, 1)
TUNNEL = (PITCH[0] + 15.0, 3 * PITCH[0] - 15.0, 2 * PITCH[1])  # [m] first and last x, y of its center
TUNNEL_HALF_WIDTH, TUNNEL_HEIGHT = 5.0, 5.0  # [m]
GROUND_STEP = 4.0  # [m] of the ground's grid
CURB = 0.12  # [m]

LANE = 1.75  # [m] from the center of the street to the right
MAX_SPEED, DECK_SPEED = 15.0, 4.0  # [m/s]
ACCELERATION, BRAKING, LATERAL = 1.5, 2.0, 2.0  # [m/s^2]
CORNER_SIGMA = 3.5  # [m] of the Gaussian that rounds corners: radius of about 6 m
PATH_STEP = 0.1  # [m]
TIME_STEP = 0.02  # [s] between knots of the splines
REST, END_MARGIN = 1.0, 2.0  # [s] at rest before the start; left out at the end, where smoothing brakes hard
PITCH_BY_ACCELERATION, ROLL_BY_ACCELERATION = 0.006, 0.010  # [rad per m/s^2] of the suspension
BUMP_ANGLE, BUMP_HEIGHT = 0.003, 0.012  # [rad], [m] amplitudes

MIN_INCIDENCE = 0.05  # cosine of the incidence angle below which there is no return
LOST_RETURNS = 0.02  # fraction
RAYS_AT_ONCE = 600_000

FLOOR_HEIGHT = 3.3  # [m] of the deck
DECK_SIZE = (PITCH[0] - STREET_WIDTH, PITCH[1] - STREET_WIDTH)  # [m]
DECK_AISLES_U, DECK_AISLES_V = (11.0, 65.0), (10.0, 30.0, 50.0)  # [m] of the aisles' centers; the ramp is in the last
RAMP = (20.0, 55.0)  # [m] its top and foot along the aisle

GRAY = (0.5, 0.5, 0.5)
GROUND, BUILDING, TREE, CAR, POLE, DECK, TUNNEL_WALL = range(7)  # labels of triangles


# ------------------------------------------------------------------------------------------------ city


def ground_height(x: Any, y: Any) -> Any:
    """Height of the road [m]: repeats from block to block, flat around the parking deck."""
    u, v = 2 * np.pi * np.asarray(x) / PITCH[0], 2 * np.pi * np.asarray(y) / PITCH[1]
    waves = 0.22 * np.sin(u + 0.4) + 0.18 * np.sin(v) + 0.05 * np.sin(3 * u) * np.cos(2 * v)
    low_x, low_y = deck_origin()
    beside = np.maximum(np.abs(x - low_x - DECK_SIZE[0] / 2) - DECK_SIZE[0] / 2 - 12, 0)
    across = np.maximum(np.abs(y - low_y - DECK_SIZE[1] / 2) - DECK_SIZE[1] / 2 - 2, 0)
    fade = np.clip(np.hypot(beside, across) / 30, 0, 1)
    return waves * fade * fade * (3 - 2 * fade)


def deck_origin() -> tuple[float, float]:
    """South-west corner of the parking deck [m]."""
    i, j = DECK_BLOCK
    return i * PITCH[0] + STREET_WIDTH / 2, j * PITCH[1] + STREET_WIDTH / 2


def blocks_near(path: Array, distance: float) -> frozenset[tuple[int, int]]:
    """Blocks within a distance [m] of the positions of a path [n, 3]."""
    near = set()
    for i in COLUMNS:
        for j in ROWS:
            low = np.array([i * PITCH[0], j * PITCH[1]])
            beyond = np.maximum(np.maximum(low - path[:, :2], path[:, :2] - low - PITCH), 0)
            if (np.hypot(*beyond.T) < distance).any():
                near.add((i, j))
    return frozenset(near)


def make_city(seed: int, blocks: frozenset[tuple[int, int]] | None = None) -> PaintedParts:
    """All static triangles of the city, or those of some blocks, the ground and the tunnel."""
    parts, rng = PaintedParts(), np.random.default_rng([seed, 1])
    add_ground(parts)
    for j in ROWS:
        for i in COLUMNS:
            own = int(rng.integers(1 << 30))
            x, y = i * PITCH[0], j * PITCH[1]
            if blocks is not None and (i, j) not in blocks:
                continue
            if (i, j) == DECK_BLOCK:
                add_deck(parts, np.random.default_rng(own))
            elif (i, j) in OPEN_BLOCKS:
                add_open_ground(parts, np.random.default_rng(own), x, y)
            else:
                block = seed if j in ALIKE_ROWS else own
                add_block(parts, np.random.default_rng([block, 2]), x, y)
    add_tunnel(parts)
    return parts


def add_ground(parts: PaintedParts) -> None:
    """The road surface everywhere, as a grid."""
    parts.label = GROUND
    parts.set_frame(0, 0)
    xs = np.arange(COLUMNS.start * PITCH[0] - 40, COLUMNS.stop * PITCH[0] + 40, GROUND_STEP)
    ys = np.arange(ROWS.start * PITCH[1] - 40, ROWS.stop * PITCH[1] + 40, GROUND_STEP)
    x, y = np.meshgrid(xs, ys, indexing="ij")
    at = np.arange(x.size).reshape(x.shape)
    a, b, c, d = at[:-1, :-1].ravel(), at[1:, :-1].ravel(), at[1:, 1:].ravel(), at[:-1, 1:].ravel()
    vertices = np.stack([x, y, ground_height(x, y)], axis=-1).reshape(-1, 3)
    parts.add(vertices, np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])]), GRAY)


def is_in_tunnel(x: float, y: float) -> bool:
    return TUNNEL[0] - 2 < x < TUNNEL[1] + 2 and abs(y - TUNNEL[2]) < TUNNEL_HALF_WIDTH + 2


def add_block(parts: PaintedParts, rng: np.random.Generator, x: float, y: float) -> None:
    """Buildings along the four sides of a block, and the things on its sidewalks."""
    half = STREET_WIDTH / 2
    width, depth = PITCH[0] - STREET_WIDTH, PITCH[1] - STREET_WIDTH
    sides = (  # corner, direction along the side, length
        (x + half, y + half, 0.0, width),
        (x + half + width, y + half, math.pi / 2, depth),
        (x + half + width, y + half + depth, math.pi, width),
        (x + half, y + half + depth, -math.pi / 2, depth),
    )
    for corner_x, corner_y, angle, length in sides:
        c, s = math.cos(angle), math.sin(angle)
        parts.label = GROUND
        parts.set_frame(corner_x, corner_y, float(ground_height(corner_x, corner_y)), angle=angle)
        along = 0.0
        while along < length - 4:
            size = min(float(rng.uniform(8, 17)), length - along)
            if length - along - size < 6:
                size = length - along
            add_building(parts, rng, (corner_x, corner_y, angle), along, size)
            along += size + (float(rng.uniform(2, 5)) if rng.random() < 0.25 else 0.0)
        for at in np.arange(float(rng.uniform(4, 9)), length - 3, 1.0):
            here = (corner_x + c * at + s * 3.6, corner_y + s * at - c * 3.6)
            kind = rng.random()
            shape, turn, tall = rng.uniform(0.85, 1.15, 3), rng.normal(0, 0.03), rng.uniform(4, 7.5)
            crowns = int(rng.integers(1 << 30))
            if is_in_tunnel(*here):
                continue
            z = float(ground_height(*here))
            if kind < 0.075:
                parts.set_frame(here[0] - s * 1.6, here[1] + c * 1.6, z, angle=angle)
                add_tree(parts, np.random.default_rng(crowns), tall)
            elif kind < 0.105:
                parts.set_frame(here[0] - s * 1.2, here[1] + c * 1.2, z, angle=angle)
                add_lamp(parts)
            elif 0.4 < kind < 0.48:
                parts.set_frame(*here, z, angle=angle + turn + (math.pi if shape[0] > 1 else 0))
                add_car(parts, shape)


def add_building(
    parts: PaintedParts, rng: np.random.Generator, side: tuple[float, float, float], along: float, width: float
) -> None:
    """A building with windows recessed between pillars and bands; its front is the x axis, looking towards -y."""
    corner_x, corner_y, angle = side
    depth, floors, setback = rng.uniform(9, 13), int(rng.integers(2, 6)), rng.uniform(0, 1.5)
    recess, first = rng.uniform(0.12, 0.35), rng.uniform(3.2, 4.2)
    columns, pillar = max(2, round(width / rng.uniform(2.4, 3.6))), rng.uniform(0.5, 1.1)
    top, pitch = first + 2.9 * (floors - 1), width / columns
    c, s = math.cos(angle), math.sin(angle)
    x, y = corner_x + c * along - s * setback, corner_y + s * along + c * setback
    parts.label = BUILDING
    parts.set_frame(x, y, float(ground_height(x, y)), angle=angle)
    parts.box((width / 2, recess + depth / 2, top / 2 - 0.5), (width, depth, top + 1), GRAY)
    for k in range(columns + 1):
        middle = min(max(k * pitch, pillar / 4), width - pillar / 4)
        size = pillar if 0 < k < columns else pillar / 2
        parts.box((middle, recess / 2 + 0.01, top / 2 - 0.5), (size, recess + 0.02, top + 1), GRAY)
    levels = [0.35, *(first - 0.45 + 2.9 * k for k in range(floors - 1)), top - 0.2]
    for k, level in enumerate(levels):
        tall = 0.9 if k else 0.7
        parts.box((width / 2, recess / 2 - 0.02, level), (width, recess + 0.08, tall), GRAY)
    door = int(rng.integers(columns))
    parts.box(((door + 0.5) * pitch, 0.05, 1.0), (min(1.4, pitch - 0.3), 0.5, 2.6), GRAY)
    parts.box(((door + 0.5) * pitch, -0.5, 2.7), (min(2.0, pitch), 1.2, 0.12), GRAY)
    for k in range(1, floors):
        for column in range(columns):
            if rng.random() < 0.15:
                low = first + 2.9 * (k - 1) - 0.1
                parts.box(((column + 0.5) * pitch, -0.55, low + 0.5), (min(2.2, pitch), 1.1, 1.0), GRAY)
    if rng.random() < 0.5:
        parts.gable((width / 2, recess + depth / 2, top), (width, depth, rng.uniform(2, 4)), GRAY, GRAY)


def add_tree(parts: PaintedParts, rng: np.random.Generator, tall: float) -> None:
    parts.label = TREE
    parts.cylinder((0, 0, tall * 0.3 - 0.3), 0.12 + 0.02 * tall, tall * 0.6 + 0.6, GRAY)
    for _ in range(2):
        off = rng.normal(0, 0.35, 3)
        parts.crown(np.array([0, 0, tall * 0.75]) + off, rng.uniform(1.0, 1.7) * np.array([1, 1, 0.9]), GRAY, rng)


def add_lamp(parts: PaintedParts) -> None:
    parts.label = POLE
    parts.cylinder((0, 0, 2.9), 0.09, 6.8, GRAY)
    parts.box((0, -0.8, 6.2), (0.12, 1.8, 0.12), GRAY)


def add_car(parts: PaintedParts, shape: Array) -> None:
    parts.label = CAR
    parts.box((0, 0, 0.62), (4.3 * shape[0], 1.75 * shape[1], 0.75), GRAY)
    parts.box((-0.25, 0, 1.2), (2.4 * shape[0], 1.55 * shape[1], 0.6 * shape[2]), GRAY, taper=0.75)
    for along in (-1.35, 1.35):
        for across in (-0.8, 0.8):
            parts.cylinder((along, across, 0.32), 0.32, 0.2, GRAY, axis=1, resolution=8)


def add_open_ground(parts: PaintedParts, rng: np.random.Generator, x: float, y: float) -> None:
    """A field with a few trees and poles, more than 9 m from the streets."""
    for _ in range(4):
        at = x + rng.uniform(10, PITCH[0] - 10), y + rng.uniform(10, PITCH[1] - 10)
        parts.set_frame(*at, float(ground_height(*at)))
        if rng.random() < 0.7:
            add_tree(parts, rng, rng.uniform(4, 8))
        else:
            add_lamp(parts)


def add_tunnel(parts: PaintedParts) -> None:
    """Bare walls and roof over a street, lamps every 8 m, niches every 40 m."""
    first, last, y = TUNNEL
    middle, length, half, tall = (first + last) / 2, last - first, TUNNEL_HALF_WIDTH, TUNNEL_HEIGHT
    parts.label = TUNNEL_WALL
    parts.set_frame(middle, y, 0.0)
    for side in (-1, 1):
        parts.box((0, side * (half + 0.25), tall / 2 - 0.5), (length, 0.5, tall + 2), GRAY)
        for at in np.arange(-length / 2 + 20, length / 2, 40.0):
            parts.box((at, side * (half - 0.15), 1.2), (2.0, 0.3, 3.4), GRAY)
    parts.box((0, 0, tall + 0.25), (length, 2 * half + 1, 0.5), GRAY)
    for at in np.arange(-length / 2 + 4, length / 2, 8.0):
        parts.box((at, 0, tall - 0.1), (1.2, 0.3, 0.2), GRAY)


def add_deck(parts: PaintedParts, rng: np.random.Generator) -> None:
    """A parking deck: two floors with equal columns, a roof, and a ramp. Entry in the west, along the first aisle."""
    parts.label = DECK
    parts.set_frame(*deck_origin(), 0.0)
    (width, depth), gate, (top, foot) = DECK_SIZE, DECK_AISLES_V[0], RAMP
    low, high = DECK_AISLES_V[-1] - 4, DECK_AISLES_V[-1] + 4  # the opening over the ramp
    z = FLOOR_HEIGHT - 0.15
    for u0, u1, v0, v1 in ((0, width, 0, low), (0, width, high, depth), (0, top, low, high), (foot, width, low, high)):
        parts.box(((u0 + u1) / 2, (v0 + v1) / 2, z), (u1 - u0, v1 - v0, 0.3), GRAY)
    parts.box((width / 2, depth / 2, 2 * FLOOR_HEIGHT), (width, depth, 0.3), GRAY)
    parts.add(
        [[foot, low, 0], [foot, high, 0], [top, high, FLOOR_HEIGHT], [top, low, FLOOR_HEIGHT]],
        [[0, 1, 2], [0, 2, 3]],
        GRAY,
    )
    for floor in range(2):
        base = floor * FLOOR_HEIGHT
        for v in (0, depth):
            parts.box((width / 2, v, base + 0.5), (width, 0.2, 1.1), GRAY)
        parts.box((width, depth / 2, base + 0.5), (0.2, depth, 1.1), GRAY)
        opening = (gate - 5, gate + 5) if floor == 0 else (0, 0)
        for v0, v1 in ((0, opening[0]), (opening[1], depth)):
            if v1 > v0:
                parts.box((0, (v0 + v1) / 2, base + 0.5), (0.2, v1 - v0, 1.1), GRAY)
        for u in np.arange(3.0, width, 7.6):
            for v in np.arange(2.0, depth, 7.6):
                if not is_in_aisle(u, v, 4.2):
                    parts.box((u, v, base + FLOOR_HEIGHT / 2), (0.5, 0.5, FLOOR_HEIGHT), GRAY)
    for v in (low, high):
        parts.box(((top + foot) / 2, v, FLOOR_HEIGHT + 0.5), (foot - top, 0.15, 1.0), GRAY)
    parts.box((foot, (low + high) / 2, FLOOR_HEIGHT + 0.5), (0.15, high - low, 1.0), GRAY)
    for floor in range(2):
        for v in (18.0, 22.0, 38.0, 42.0):
            for u in np.arange(20.0, 57.0, 2.7):
                if rng.random() < 0.55:
                    parts.set_frame(
                        deck_origin()[0] + u, deck_origin()[1] + v + 0.2 * rng.normal(), floor * FLOOR_HEIGHT,
                        angle=math.pi / 2,
                    )  # fmt: skip
                    add_car(parts, rng.uniform(0.85, 1.0, 3))
                    parts.label = DECK


def is_in_aisle(u: float, v: float, margin: float) -> bool:
    return any(abs(u - at) < margin for at in DECK_AISLES_U) or any(abs(v - at) < margin for at in DECK_AISLES_V)


# ------------------------------------------------------------------------------------------------ routes


def crossing(i: float, j: float) -> Waypoint:
    return i * PITCH[0], j * PITCH[1], 0.0


def in_deck(u: float, v: float, floor: int = 0) -> Waypoint:
    return deck_origin()[0] + u, deck_origin()[1] + v, floor * FLOOR_HEIGHT


def through_deck() -> list[Waypoint]:
    """From the street in the west up to the second floor, around it, and down again."""
    (west, east), (south, middle, north), (top, foot) = DECK_AISLES_U, DECK_AISLES_V, RAMP
    street = DECK_BLOCK[0] * PITCH[0], in_deck(0, south)[1], 0.0
    return [
        street, in_deck(east, south), in_deck(east, north), in_deck(foot, north), in_deck(top, north, 1),
        in_deck(west, north, 1), in_deck(west, south, 1), in_deck(east, south, 1), in_deck(east, middle, 1),
        in_deck(west, middle, 1), in_deck(west, north, 1), in_deck(top, north, 1), in_deck(foot, north),
        in_deck(east, north), in_deck(east, south), street,
    ]  # fmt: skip


ROUTES: dict[str, list[Waypoint]] = {
    # around two blocks and on over the start, 780 m
    "loop": [crossing(*at) for at in ((2, 3), (4, 3), (4, 4), (2, 4), (2, 3), (4, 3))],
    # back in the opposite lane, 1.1 km
    "return": [crossing(*at) for at in ((2, 3), (5, 3), (5, 4), (4, 4), (4, 3), (2, 3), (2, 2.3))],
    # along copies of one block, around and back, 1.2 km
    "alike": [crossing(*at) for at in ((0, 0), (5, 0), (5, 1), (0, 1), (0, 0), (1, 0))],
    # 160 m of tunnel, back on a street beside it, and through the tunnel again, 1.2 km
    "tunnel": [crossing(*at) for at in ((0.5, 2), (4, 2), (4, 3), (0.5, 3), (0.5, 2), (4, 2))],
    # both floors of the parking deck, 750 m
    "deck": [crossing(2, 1), crossing(3, 1), *through_deck(), crossing(3, 1), crossing(2, 1), crossing(2, 0.5)],
    # around fields with few trees, 700 m
    "open": [crossing(*at) for at in ((2, 3), (2, 4), (0, 4), (0, 3), (2, 3), (2, 4), (1, 4))],
    # all of these, 3.3 km
    "long": [
        *(crossing(*at) for at in ((0, 0), (5, 0), (5, 1), (4, 1), (3, 1))), *through_deck(),
        *(crossing(*at) for at in ((3, 1), (0, 1), (0, 2), (4, 2), (4, 3), (2, 3), (2, 4), (0, 4), (0, 1), (0, 0))),
        *(crossing(*at) for at in ((5, 0), (5, 1), (0, 1))),
    ],
}  # fmt: skip


def in_lane(waypoints: list[Waypoint]) -> Array:
    """The lane right of a line of waypoints [n, 3], whose corners are moved accordingly."""
    line = np.array(waypoints, float)
    line = line[np.concatenate([[True], np.linalg.norm(np.diff(line[:, :2], axis=0), axis=1) > 1e-6])]
    ahead = np.diff(line[:, :2], axis=0)
    ahead /= np.linalg.norm(ahead, axis=1)[:, None]
    right = LANE * np.column_stack([ahead[:, 1], -ahead[:, 0]])
    moved = line.copy()
    moved[0, :2] += right[0]
    moved[-1, :2] += right[-1]
    for k in range(1, len(line) - 1):
        sine = ahead[k - 1, 0] * ahead[k, 1] - ahead[k - 1, 1] * ahead[k, 0]
        if abs(sine) < 1e-3:
            moved[k, :2] += right[k]
        else:
            moved[k, :2] += right[k - 1] + ahead[k - 1] * (
                LANE * math.tan(math.atan2(sine, ahead[k - 1] @ ahead[k]) / 2)
            )
    return moved


@dataclass(frozen=True)
class Motion:
    """Positions and angles of the sensor as smooth functions of time [s]; it is at rest at first."""

    coordinates: CubicSpline  # x, y, z [m], yaw, pitch, roll [rad]
    distance: CubicSpline  # traveled [m]
    end: float  # [s]

    def positions(self, times: Array) -> Array:
        return self.coordinates(times)[..., :3]

    def rotations(self, times: Array) -> Array:
        """R_world_sensor, [..., 3, 3]: yaw about z, then pitch about y (nose down), then roll about x."""
        yaw, pitch, roll = np.moveaxis(self.coordinates(times)[..., 3:], -1, 0)
        (cy, sy), (cp, sp), (cr, sr) = ((np.cos(a), np.sin(a)) for a in (yaw, pitch, roll))
        rows = (
            (cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr),
            (sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr),
            (-sp, cp * sr, cp * cr),
        )
        return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)

    def poses(self, times: Array) -> Array:
        """T_world_sensor, [..., 4, 4]."""
        T = np.zeros((*np.shape(times), 4, 4))
        T[..., :3, :3], T[..., :3, 3], T[..., 3, 3] = self.rotations(times), self.positions(times), 1
        return T


def drive_along(waypoints: list[Waypoint], seed: int, max_speed: float = MAX_SPEED) -> Motion:
    """The motion of a car along a lane, as fast as the limits of speed and acceleration allow."""
    rng, corners = np.random.default_rng([seed, 4]), in_lane(waypoints)
    at = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(corners[:, :2], axis=0), axis=1))])
    sampled = np.arange(0, at[-1], PATH_STEP)
    line = np.stack([np.interp(sampled, at, corners[:, k]) for k in range(3)], axis=1)
    line = gaussian_filter1d(line, CORNER_SIGMA / PATH_STEP, axis=0, mode="nearest")
    # the ends do not move under smoothing
    steps = np.linalg.norm(np.diff(line[:, :2], axis=0), axis=1)
    line = line[np.concatenate([[True], steps > 0.2 * PATH_STEP])]
    s = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(line[:, :2], axis=0), axis=1))])
    heading = np.unwrap(np.arctan2(*np.gradient(line[:, :2], s, axis=0).T[::-1]))
    curvature = np.gradient(heading, s)
    limit = np.minimum(max_speed, np.sqrt(LATERAL / np.maximum(np.abs(curvature), 1e-6)))
    low_x, low_y = deck_origin()
    inside = (line[:, 0] > low_x - 5) & (line[:, 0] < low_x + DECK_SIZE[0])
    inside &= (line[:, 1] > low_y) & (line[:, 1] < low_y + DECK_SIZE[1])
    limit[inside] = np.minimum(limit[inside], DECK_SPEED)
    limit[0] = 0.0
    gaps = np.diff(s)
    for k in range(1, len(s)):
        limit[k] = min(limit[k], math.sqrt(limit[k - 1] ** 2 + 2 * ACCELERATION * gaps[k - 1]))
    for k in range(len(s) - 2, -1, -1):
        limit[k] = min(limit[k], math.sqrt(limit[k + 1] ** 2 + 2 * BRAKING * gaps[k]))
    times = REST + np.concatenate([[0], np.cumsum(2 * gaps / (limit[1:] + limit[:-1]))])
    knots = np.arange(0, times[-1], TIME_STEP)
    traveled = gaussian_filter1d(np.interp(knots, times, s), 0.3 / TIME_STEP, mode="nearest")
    speed = np.gradient(traveled, TIME_STEP)
    forward = gaussian_filter1d(np.gradient(speed, TIME_STEP), 0.2 / TIME_STEP)
    height = line[:, 2] + ground_height(line[:, 0], line[:, 1])
    slopes = gaussian_filter1d(np.gradient(height, s), 1.0 / PATH_STEP)
    columns = (line[:, 0], line[:, 1], height, heading, curvature, slopes)
    x, y, z, yaw, bend, slope = (np.interp(traveled, s, column) for column in columns)
    smooth = 0.2 / TIME_STEP
    z = gaussian_filter1d(z, smooth)
    moving = np.clip(speed / 5, 0, 1)
    frequencies, phases = rng.uniform(0.5, 1.8, (3, 3)), rng.uniform(0, 6.28, (3, 3))
    bumps = np.sin(2 * np.pi * frequencies[..., None] * knots + phases[..., None]).mean(axis=1) * moving
    pitch = -np.arctan(slope) - PITCH_BY_ACCELERATION * forward + BUMP_ANGLE * bumps[0]
    roll = ROLL_BY_ACCELERATION * gaussian_filter1d(speed**2 * bend, smooth) + BUMP_ANGLE * bumps[1]
    z = z + SENSOR_HEIGHT + BUMP_HEIGHT * bumps[2]
    yaw = gaussian_filter1d(yaw, smooth)
    states = np.stack([x, y, z, yaw, gaussian_filter1d(pitch, smooth), roll], axis=1)
    return Motion(CubicSpline(knots, states), CubicSpline(knots, traveled), float(knots[-1]) - END_MARGIN)


# ------------------------------------------------------------------------------------------------ sensors


@dataclass(frozen=True)
class Sensor:
    """A scanner: `rays` returns the directions [n, 3] of scan k and their times within it [n], as fractions."""

    rays: Callable[[int, np.random.Generator], tuple[Array, Array]]
    max_range: float = 100.0  # [m]
    min_range: float = 1.5  # [m]
    noise: float = 0.015  # [m]


def spinning(beams: int, azimuths: int, low: float, high: float, **options: Any) -> Sensor:
    """A spinning scanner with beams between two elevations [degrees]."""
    rise = np.radians(np.linspace(low, high, beams))
    return Sensor(lambda _, rng: rotating_rays(rise, azimuths, rng), **options)


ROSETTE_RATES = (7294 / 60, -4664 / 60)  # [Hz] of the two prisms, as of a Livox Mid-40
ROSETTE_ANGLE = math.radians(17.5)  # deflection of each: a field of view of 70 degrees


def rosette(count: int) -> Sensor:
    """A scanner with a pattern that does not repeat, ahead only."""

    def rays(k: int, rng: np.random.Generator) -> tuple[Array, Array]:
        fraction = np.arange(1, count + 1) / count
        times = (k + fraction) * SCAN_PERIOD
        u, v = (
            sum(ROSETTE_ANGLE * wave(2 * np.pi * rate * times) for rate in ROSETTE_RATES) for wave in (np.cos, np.sin)
        )
        directions = np.stack([np.ones(count), np.tan(u), np.tan(v)], axis=1)
        return directions / np.linalg.norm(directions, axis=1)[:, None], fraction

    return Sensor(rays, noise=0.02)


SENSORS = {
    "16": spinning(16, 900, -15, 15),
    "16 full": spinning(16, 1800, -15, 15),
    "32": spinning(32, 900, -25, 15),
    "64": spinning(64, 450, -24.8, 2, noise=0.01),  # thinned to a quarter of the azimuths
    "64 full": spinning(64, 1800, -24.8, 2, noise=0.01),
    "128 full": spinning(128, 1800, -25, 15, noise=0.01),
    "livox": rosette(20_000),
}


# ------------------------------------------------------------------------------------------------ traffic


@dataclass(frozen=True)
class Vehicle:
    """A box of a size [m] that moves: `place` returns its center on the ground [x, y, z] and heading at times [s]."""

    size: tuple[float, float, float]
    place: Callable[[Array], tuple[Array, Array]]

    def cut(self, origins: Array, directions: Array, times: Array, reach: float) -> tuple[NDArray[np.int64], Array]:
        """Indices of rays that hit it, and the distances."""
        middle, _ = self.place(times[len(times) // 2 : len(times) // 2 + 1])
        if np.linalg.norm(middle[0] - origins[0]) > reach:
            return np.empty(0, np.int64), np.empty(0)
        center, heading = self.place(times)
        offset = origins - center
        c, s = np.cos(heading), np.sin(heading)
        local = np.stack([c * offset[:, 0] + s * offset[:, 1], c * offset[:, 1] - s * offset[:, 0], offset[:, 2]])
        ray = np.stack(
            [c * directions[:, 0] + s * directions[:, 1], c * directions[:, 1] - s * directions[:, 0], directions[:, 2]]
        )
        half = np.array([self.size[0] / 2, self.size[1] / 2, self.size[2]])[:, None]
        low = np.array([-half[0], -half[1], [0.25]])
        with np.errstate(divide="ignore", invalid="ignore"):
            a, b = (low - local) / ray, (half - local) / ray
        enter, leave = np.minimum(a, b).max(axis=0), np.maximum(a, b).min(axis=0)
        hit = np.flatnonzero((enter < leave) & (enter > 0))
        return hit, enter[hit]


def make_traffic(motion: Motion, seed: int, count: int, companions: int) -> list[Vehicle]:
    """Vehicles on the streets that never touch the scanner's car, and cars or trucks before and behind it."""
    rng, vehicles = np.random.default_rng([seed, 6]), []
    moments = np.arange(0, motion.end, 0.2)
    own = motion.positions(moments)[:, :2]
    for _ in range(40 * count):
        if len(vehicles) == count:
            break
        size = (4.4, 1.8, 1.5) if rng.random() < 0.7 else (9.0, 2.5, 3.4)
        is_east, sign, speed = rng.random() < 0.6, 1 if rng.random() < 0.5 else -1, float(rng.uniform(6, 14))
        street = float(rng.integers(0, 5) * PITCH[1 if is_east else 0] - sign * (LANE if is_east else -LANE))
        # meets the scanner's surroundings at a random moment
        moment = float(rng.uniform(0, motion.end))
        near = motion.positions(np.array(moment))[0 if is_east else 1] + rng.uniform(-60, 60)

        def place(
            t: Array, is_east: bool = is_east, street: float = street, speed: float = sign * speed,
            moment: float = moment, near: float = near,
        ) -> tuple[Array, Array]:  # fmt: skip
            along, across = near + speed * (t - moment), np.full(np.shape(t), street)
            x, y = (along, across) if is_east else (across, along)
            angle = (0.0 if is_east else np.pi / 2) + (0.0 if speed > 0 else np.pi)
            return np.stack([x, y, ground_height(x, y)], axis=-1), np.full(np.shape(t), angle)

        gap = np.abs(place(moments)[0][:, :2] - own)
        is_touching = (gap[:, 0 if is_east else 1] < 8) & (gap[:, 1 if is_east else 0] < 2.4)
        if not is_touching.any():
            vehicles.append(Vehicle(size, place))
    for k in range(companions):
        lead = (1.8, 9.0) if k % 2 == 0 else (-1.8, -9.0)  # [s], [m]
        size = (9.0, 2.5, 3.4) if k < 2 and companions > 1 else (4.4, 1.8, 1.5)

        def follow(t: Array, lead: tuple[float, float] = lead) -> tuple[Array, Array]:
            path = motion.distance
            s = np.clip(path(np.clip(t + lead[0], 0, motion.end)) + lead[1], path(0.0), path(motion.end))
            states = motion.coordinates(time_at(motion, s))
            return states[..., :3] - [0, 0, SENSOR_HEIGHT], states[..., 3]

        vehicles.append(Vehicle(size, follow))
    return vehicles


def time_at(motion: Motion, distances: Array) -> Array:
    """Times [s] at which the scanner has traveled some distances [m]."""
    knots = motion.distance.x
    return np.interp(distances, np.maximum.accumulate(motion.distance(knots)), knots)


# ------------------------------------------------------------------------------------------------ drives


@dataclass(frozen=True)
class Scenario:
    """A drive through a city.

    Attributes:
        route: Key of ROUTES.
        sensor: Key of SENSORS.
        seed: Of the city, traffic and noise.
        length: [m] after which the drive ends; 0 for the entire route.
        traffic: Number of vehicles on the streets.
        companions: 1 for a car ahead, 2 for trucks ahead and behind.
        gaps: Number of gaps, spread evenly over the drive.
        gap_scans: Missing scans of each.
        max_speed: [m/s]
        start: [m] of the route before the first scan, which is not at rest then.
    """

    route: str
    sensor: str = "16"
    seed: int = 0
    length: float = 0.0
    traffic: int = 0
    companions: int = 0
    gaps: int = 0
    gap_scans: int = 8
    max_speed: float = MAX_SPEED
    start: float = 0.0

    @property
    def name(self) -> str:
        parts = [self.route, self.sensor.replace(" ", ""), f"s{self.seed}"]
        parts += [f"{self.length:.0f}m"] if self.length else []
        parts += [f"from{self.start:.0f}m"] if self.start else []
        parts += [f"t{self.traffic}"] if self.traffic else []
        parts += [f"c{self.companions}"] if self.companions else []
        parts += [f"g{self.gaps}x{self.gap_scans}"] if self.gaps else []
        return "-".join(parts + ([f"v{self.max_speed:.0f}"] if self.max_speed != MAX_SPEED else []))

    @cached_property
    def motion(self) -> Motion:
        return drive_along(ROUTES[self.route], self.seed, self.max_speed)

    @property
    def scene(self) -> Any:
        """The static triangles in the sensor's range, for ray casting."""
        first = self.first_scan
        path = self.motion.positions(np.arange(first, first + self.scan_count + 1) * SCAN_PERIOD)
        return scene_of(self.seed, blocks_near(path, SENSORS[self.sensor].max_range + 5))

    @property
    def first_scan(self) -> int:
        return int(time_at(self.motion, np.array(self.start)) / SCAN_PERIOD) if self.start else 0

    @property
    def scan_count(self) -> int:
        end = float(time_at(self.motion, np.array(self.start + self.length))) if self.length else self.motion.end
        return int(min(end, self.motion.end) / SCAN_PERIOD) - self.first_scan

    @property
    def kept_scans(self) -> list[int]:
        """Numbers of the scans that are not missing."""
        count = self.scan_count
        starts = [int(count * (k + 1) / (self.gaps + 1)) for k in range(self.gaps)]
        missing = {start + k for start in starts for k in range(self.gap_scans)}
        return [self.first_scan + k for k in range(count) if k not in missing]


@dataclass(frozen=True)
class CityDrive(Drive):
    """A drive; `times` [s] and the numbers of the scans, whose ends are at (number + 1) times SCAN_PERIOD."""

    numbers: NDArray[np.int64] = field(default_factory=lambda: np.zeros(0, np.int64))

    @property
    def distance(self) -> float:
        """Length of the path [m]."""
        return float(np.linalg.norm(np.diff(self.poses[:, :3, 3], axis=0), axis=1).sum())


@lru_cache(maxsize=2)
def scene_of(seed: int, blocks: frozenset[tuple[int, int]]) -> Any:
    return make_city(seed, blocks).scene()


def scan_city(scenario: Scenario) -> Iterator[tuple[NDArray[np.float32], Array]]:
    """Points in the sensor's frame at their moment, and times [s], of each scan that is not missing."""
    sensor, motion, scene = SENSORS[scenario.sensor], scenario.motion, scenario.scene
    vehicles = make_traffic(motion, scenario.seed, scenario.traffic, scenario.companions)
    batch: list[tuple[int, Array, Array, Array, Array]] = []
    kept = scenario.kept_scans
    for k in kept:
        directions, fraction = sensor.rays(k, np.random.default_rng([scenario.seed, k, 8]))
        times = (k + fraction) * SCAN_PERIOD
        moments, which = np.unique(times, return_inverse=True)
        R, positions = motion.rotations(moments), motion.positions(moments)
        world = np.einsum("nij,nj->ni", R[which], directions)
        batch.append((k, directions, times, positions[which], world))
        if k == kept[-1] or sum(len(rays) for _, rays, *_ in batch) > RAYS_AT_ONCE:
            yield from measured(batch, sensor, scene, vehicles, scenario.seed)
            batch = []


def measured(
    batch: list[tuple[int, Array, Array, Array, Array]], sensor: Sensor, scene: Any, vehicles: list[Vehicle], seed: int
) -> Iterator[tuple[NDArray[np.float32], Array]]:
    rays = np.concatenate([np.hstack([at, world]) for *_, at, world in batch]).astype(np.float32)
    hits, first = scene.cast_rays(rays), 0
    for k, directions, times, positions, world in batch:
        rows = slice(first, first + len(times))
        first += len(times)
        t = hits["t_hit"][rows].astype(float)
        cosines = np.abs((hits["primitive_normals"][rows] * world).sum(axis=1))
        t[cosines < MIN_INCIDENCE] = np.inf
        for vehicle in vehicles:
            struck, distances = vehicle.cut(positions, world, times, sensor.max_range)
            t[struck] = np.minimum(t[struck], distances)
        rng = np.random.default_rng([seed, k, 9])
        ranges = t + rng.normal(0, sensor.noise, len(t))
        is_seen = (ranges < sensor.max_range) & (ranges > sensor.min_range) & (rng.random(len(t)) > LOST_RETURNS)
        yield (directions[is_seen] * ranges[is_seen, None]).astype(np.float32), times[is_seen]


def make_drive(scenario: Scenario) -> CityDrive:
    """Scan a city; poses are those at the ends of the scans."""
    scans, times = zip(*scan_city(scenario), strict=True)
    numbers = np.array(scenario.kept_scans)
    return CityDrive(list(scans), list(times), scenario.motion.poses((numbers + 1) * SCAN_PERIOD), numbers)


def load_drive(scenario: Scenario, folder: Path = CACHE) -> CityDrive:
    """The drive from a file in the cache folder, which is written if it does not exist or this module has changed."""
    code = hashlib.sha256(Path(__file__).read_bytes()).hexdigest()[:8]
    path = folder / f"{scenario.name}-{code}.npz"
    if not path.exists():
        folder.mkdir(parents=True, exist_ok=True)
        made = make_drive(scenario)
        ends = np.cumsum([len(points) for points in made.scans])
        part = path.with_suffix(".part.npz")
        np.savez(
            part, points=np.concatenate(made.scans), times=np.concatenate(made.times), ends=ends,
            poses=made.poses, numbers=made.numbers,
        )  # fmt: skip
        part.replace(path)
        return made
    with np.load(path) as stored:
        ends = stored["ends"][:-1]
        scans, times = np.split(stored["points"], ends), np.split(stored["times"], ends)
        return CityDrive(scans, times, stored["poses"], stored["numbers"])


def add_scenario_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("routes", nargs="*", help=f"of {', '.join(ROUTES)}")
    parser.add_argument("--sensor", nargs="+", default=["16"], choices=SENSORS)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--length", type=float, default=0.0, help="[m]; 0 for the entire route")
    parser.add_argument("--traffic", type=int, default=0, help="vehicles on the streets")
    parser.add_argument("--companions", type=int, default=0, help="1: a car ahead; 2: trucks ahead and behind")
    parser.add_argument("--gaps", type=int, default=0, help="gaps in the sequence of scans")
    parser.add_argument("--gap-scans", type=int, default=8, help="missing scans of each gap")
    parser.add_argument("--max-speed", type=float, default=MAX_SPEED, help="[m/s]")


def scenarios_of(options: argparse.Namespace) -> list[Scenario]:
    if unknown := set(options.routes) - set(ROUTES):
        raise SystemExit(f"unknown routes: {', '.join(sorted(unknown))}. Use {', '.join(ROUTES)}")
    return [
        Scenario(
            route, sensor, options.seed, options.length, options.traffic, options.companions, options.gaps,
            options.gap_scans, options.max_speed,
        )
        for route in options.routes
        for sensor in options.sensor
    ]  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_scenario_options(parser)
    for scenario in scenarios_of(parser.parse_args()):
        made = load_drive(scenario)
        scans, points = len(made.scans), sum(len(scan) for scan in made.scans)
        print(f"{scenario.name}: {made.distance:.0f} m, {scans} scans, {points / scans:,.0f} points each")


if __name__ == "__main__":
    main()
