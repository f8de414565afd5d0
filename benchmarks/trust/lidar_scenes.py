"""Synthetic drives of a scanner through sites that do or do not determine its motion, with true poses.

Sites are triangle meshes for ray casting; moving objects are separate meshes. Each scan is a snapshot: its points are
measured at one moment, so only the geometry matters.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np

import pointloom as loom

Box = tuple[float, float, float, float, float, float]  # low and high corner [m]


@dataclass
class Site:
    """Static triangles and moving boxes; each box has a function from the scan index to its center."""

    vertices: list[np.ndarray] = field(default_factory=list)
    triangles: list[np.ndarray] = field(default_factory=list)
    movers: list[tuple[Box, Callable[[int], Sequence[float]]]] = field(default_factory=list)
    count: int = 0

    def add(self, vertices: np.ndarray, triangles: np.ndarray) -> None:
        """Add a mesh."""
        self.vertices.append(np.asarray(vertices, float))
        self.triangles.append(np.asarray(triangles) + self.count)
        self.count += len(vertices)

    def box(self, x0: float, y0: float, z0: float, x1: float, y1: float, z1: float, angle: float = 0.0) -> None:
        """Add a box between two corners, rotated about its vertical axis."""
        corners, faces = box_mesh((x0, y0, z0, x1, y1, z1))
        middle = np.array([(x0 + x1) / 2, (y0 + y1) / 2, 0.0])
        c, s = math.cos(angle), math.sin(angle)
        self.add((corners - middle) @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]) + middle, faces)

    def cylinder(self, x: float, y: float, radius: float, height: float, low: float = 0.0) -> None:
        """Add an upright cylinder."""
        self.add(*tube_mesh(np.array([[x, y, low], [x, y, low + height]]), radius, 16))

    def scene(self) -> tuple[loom.RaycastingScene, list[int]]:
        """The scene for ray casting, and the indices of the moving objects."""
        scene = loom.RaycastingScene()
        scene.add_triangles(np.concatenate(self.vertices), np.concatenate(self.triangles))
        return scene, [scene.add_triangles(*box_mesh(box)) for box, _ in self.movers]


@dataclass(frozen=True)
class Run:
    """Scans in the scanner's frame [m] and its true poses [n, 4, 4]."""

    scans: list[np.ndarray]
    poses: np.ndarray


def box_mesh(box: Box) -> tuple[np.ndarray, np.ndarray]:
    """The 8 corners and 12 triangles of a box."""
    low, high = np.array(box[:3]), np.array(box[3:])
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]) * (high - low) + low
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return corners, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])


def tube_mesh(line: np.ndarray, radius: float, sides: int) -> tuple[np.ndarray, np.ndarray]:
    """A tube about the points of a line [n, 3], open at its ends."""
    ahead = np.gradient(line, axis=0)
    ahead /= np.linalg.norm(ahead, axis=1)[:, None]
    across = np.cross(ahead, [0.0, 0.0, 1.0] if abs(ahead[0, 2]) < 0.9 else [1.0, 0.0, 0.0])
    across /= np.linalg.norm(across, axis=1)[:, None]
    up = np.cross(across, ahead)
    angles = np.arange(sides) * (2 * np.pi / sides)
    rings = line[:, None] + radius * (
        np.cos(angles)[None, :, None] * across[:, None] + np.sin(angles)[None, :, None] * up[:, None]
    )
    k = np.arange(sides)
    faces = []
    for i in range(len(line) - 1):
        a, b = i * sides + k, i * sides + (k + 1) % sides
        faces += [np.column_stack([a, b, b + sides]), np.column_stack([a, b + sides, a + sides])]
    return rings.reshape(-1, 3), np.concatenate(faces)


# ------------------------------------------------------------------------------------------------ places


def corridor(
    length: float = 160.0, *, doors: float = 0.0, depth: float = 0.06, jitter: float = 0.0, width: float = 2.0,
    ends: bool = False, start: float = 0.0, seed: int = 0,
) -> Site:  # fmt: skip
    """A corridor along x with doors on both sides every `doors` meters, up to `jitter` off; walls at its ends."""
    site, half, rng = Site(), width / 2, np.random.default_rng(seed)
    site.box(start, -half, -0.2, length, half, 0.0)
    site.box(start, -half, 2.5, length, half, 2.7)
    site.box(start, -half - 0.2, 0.0, length, -half, 2.5)
    site.box(start, half, 0.0, length, half + 0.2, 2.5)
    if ends:
        site.box(start - 0.2, -half, 0, start, half, 2.5)
        site.box(length, -half, 0, length + 0.2, half, 2.5)
    if doors:
        for x in np.arange(start + doors / 2, length - doors / 2, doors):
            for side in (-1, 1):
                at = x + rng.uniform(-jitter, jitter)
                low, high = sorted((side * half, side * (half - depth)))
                site.box(at - 0.45, low, 0, at + 0.45, high, 2.1)
                knob = sorted((side * (half - depth), side * (half - depth - 0.05)))
                site.box(at + 0.3, knob[0], 0.95, at + 0.42, knob[1], 1.05)
    return site


def tunnel(length: float = 160.0, *, radius: float = 2.5, bend: float = 0.0) -> Site:
    """A round tunnel along x, at the scanner's height, that bends by `bend` meters to either side."""
    x = np.linspace(-40, length, 400)
    site = Site()
    site.add(*tube_mesh(np.column_stack([x, bend * np.sin(x / 25), np.full_like(x, 1.2)]), radius, 48))
    return site


def field_of(bumps: float = 0.0, *, length: float = 220.0, things: int = 0, seed: int = 0) -> Site:
    """Ground with waves of `bumps` meters, and boxes on it."""
    rng, site = np.random.default_rng(seed), Site()
    x, y = np.meshgrid(np.linspace(-60, length, 200), np.linspace(-60, 60, 90), indexing="ij")
    z = bumps * (np.sin(x / 3.1) * np.cos(y / 2.3) + 0.6 * np.sin(x / 1.7 + y / 2.9))
    rows = np.arange(199)[:, None] * 90 + np.arange(89)
    faces = np.concatenate([np.stack([rows, rows + 90, rows + 91], -1), np.stack([rows, rows + 91, rows + 1], -1)])
    site.add(np.stack([x, y, z], -1).reshape(-1, 3), faces.reshape(-1, 3))
    for _ in range(things):
        a, b, size = rng.uniform(-20, length - 60), rng.choice([-1, 1]) * rng.uniform(4, 25), rng.uniform(0.5, 3, 3)
        site.box(a, b, 0, a + size[0], b + size[1], size[2], rng.uniform(0, 3))
    return site


def street(*, seed: int = 0, length: float = 160.0, porches: bool = True) -> Site:
    """Houses on both sides of a straight road, with porches, parked cars and poles."""
    rng, site = np.random.default_rng(seed), Site()
    site.box(-60, -30, -0.2, length + 60, 30, 0.0)
    for side in (-1, 1):
        x = -50.0
        while x < length + 40:
            width, setback, height = rng.uniform(8, 16), rng.uniform(7, 10), rng.uniform(5, 11)
            low, high = sorted((side * setback, side * (setback + 8)))
            site.box(x, low, 0, x + width, high, height)
            if porches:
                low, high = sorted((side * setback, side * (setback - 1.4)))
                site.box(x + 2, low, 0, x + 4.4, high, 2.9)
            if rng.random() < 0.7:
                at = x + rng.uniform(0, width)
                site.box(at, side * 4.6 - 0.9, 0, at + 4.2, side * 4.6 + 0.9, 1.5)
            site.cylinder(x + width + 1.2, side * 6.2, 0.12, 6.0)
            x += width + rng.uniform(2, 6)
    return site


def with_lorries(site: Site, which: Sequence[tuple[float, float]], speed: float) -> Site:
    """Add lorries (8 x 2.5 x 3.6 m) that drive along x by `speed` meters per scan, from (x, y) at scan 0."""
    for x, y in which:
        site.movers.append(((-4.0, -1.25, 0.3, 4.0, 1.25, 3.9), lambda k, x=x, y=y: (x + speed * k, y, 0.0)))
    return site


def hall(*, seed: int = 0, size: tuple[float, float, float] = (90.0, 40.0, 9.0), racks: int = 10) -> Site:
    """A warehouse: walls, equally spaced columns, racks and crates."""
    rng, site, (x, y, z) = np.random.default_rng(seed), Site(), size
    site.box(-10, -y / 2, -0.2, x, y / 2, 0)
    site.box(-10, -y / 2, z, x, y / 2, z + 0.2)
    for low in (-y / 2 - 0.2, y / 2):
        site.box(-10, low, 0, x, low + 0.2, z)
    site.box(-10.2, -y / 2, 0, -10, y / 2, z)
    site.box(x, -y / 2, 0, x + 0.2, y / 2, z)
    for a in np.arange(0, x, 10.0):
        for b in (-10.0, 10.0):
            site.box(a - 0.25, b - 0.25, 0, a + 0.25, b + 0.25, z)
    for _ in range(racks):
        a, b = rng.uniform(0, x - 12), rng.choice([-1, 1]) * rng.uniform(4, 15)
        site.box(a, b, 0, a + rng.uniform(2, 12), b + 1.2, rng.uniform(2, 6))
    return site


def forest(*, seed: int = 0, trunks: int = 500) -> Site:
    """Uneven ground with tree trunks."""
    rng, site = np.random.default_rng(seed), field_of(0.15, seed=seed)
    for _ in range(trunks):
        x, y = rng.uniform(-40, 160), rng.uniform(-40, 40)
        if abs(y) > 1.2:
            site.cylinder(x, y, rng.uniform(0.1, 0.35), rng.uniform(5, 12), -0.5)
    return site


# ------------------------------------------------------------------------------------------------ scanners


Look = Callable[[int, np.random.Generator], np.ndarray]  # from the scan index to directions [n, 3]


def spinning(beams: int = 16, azimuths: int = 600, spread: float = 15.0) -> Look:
    """Directions [n, 3] of a spinning scanner; consecutive revolutions have different directions."""
    rise = np.radians(np.linspace(-spread, spread, beams))

    def look(_: int, rng: np.random.Generator) -> np.ndarray:
        angles = 2 * np.pi * (np.arange(azimuths) + rng.random()) / azimuths
        a, e = np.repeat(angles, beams), np.tile(rise, azimuths)
        return np.stack([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)], axis=1)

    return look


def rosette(count: int = 6000, cone: float = 70.4) -> Look:
    """Directions [n, 3] of a scanner with a round field of view [deg] around x and a non-repeating rosette pattern."""

    def look(k: int, _: np.random.Generator) -> np.ndarray:
        t = (k + np.arange(count) / count) * 0.1
        r = np.radians(cone / 2) * np.cos(2 * np.pi * 121.57 * t)
        a = 2 * np.pi * 77.7 * t
        return np.stack([np.cos(r), np.sin(r) * np.cos(a), np.sin(r) * np.sin(a)], axis=1)

    return look


# ------------------------------------------------------------------------------------------------ runs


def scan_run(
    site: Site, poses: np.ndarray, look: Look, *, max_range: float = 30.0, noise: float = 0.01, seed: int = 0
) -> Run:
    """The scans at these poses."""
    rng = np.random.default_rng(seed)
    scene, movers = site.scene()
    scans = []
    for k, T in enumerate(poses):
        for number, (_, where) in zip(movers, site.movers, strict=True):
            pose = np.eye(4)
            pose[:3, 3] = where(k)
            scene.set_pose(number, pose)
        rays = look(k, rng)
        ahead = rays @ T[:3, :3].T
        hit = scene.cast_rays(np.hstack([np.broadcast_to(T[:3, 3], ahead.shape), ahead]).astype(np.float32))["t_hit"]
        is_hit = np.isfinite(hit) & (hit < max_range)
        far = hit[is_hit] + rng.normal(0, noise, int(is_hit.sum()))
        scans.append((rays[is_hit] * far[:, None]).astype(np.float32))
    return Run(scans, poses)


def along_x(
    count: int, speed: float, *, start: float = 20.0, height: float = 1.2, standing: int = 0, sway: float = 0.1
) -> np.ndarray:
    """Poses along x at a constant speed [m per scan] after some stationary scans, swaying sideways and in heading."""
    distances = np.maximum(np.arange(count) - standing, 0) * speed
    poses = np.tile(np.eye(4), (count, 1, 1))
    heading = 0.3 * sway * np.sin(distances / 7)
    poses[:, 0, 0], poses[:, 1, 1] = np.cos(heading), np.cos(heading)
    poses[:, 0, 1], poses[:, 1, 0] = -np.sin(heading), np.sin(heading)
    poses[:, :3, 3] = np.stack([start + distances, sway * np.sin(distances / 5), np.full(count, height)], axis=1)
    return poses


def in_hand(count: int, fastest: float, *, seed: int = 0) -> np.ndarray:
    """Poses of a handheld scanner, rotating by up to `fastest` degrees per scan."""
    rng, k = np.random.default_rng(seed), np.arange(count)
    first, second = rng.uniform(0, 6, 2)
    ramp = np.clip(k / 6, 0, 1)
    rate = np.sin(2 * np.pi / 24 * k + first) + 0.5 * np.sin(2 * np.pi / 9.84 * k + second)
    yaw = np.cumsum(rate * math.radians(fastest) / np.abs(rate).max() * ramp)
    pitch, roll = (math.radians(3) * np.sin(f * k + p) * ramp for f, p in ((0.7, first), (0.5, second)))
    poses = np.tile(np.eye(4), (count, 1, 1))
    for i in range(count):
        (cy, sy), (cp, sp), (cr, sr) = ((math.cos(a), math.sin(a)) for a in (yaw[i], pitch[i], roll[i]))
        about_z, about_y = (
            np.array([[cy, -sy, 0], [sy, cy, 0], [0, 0, 1]]),
            np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]]),
        )
        poses[i, :3, :3] = about_z @ about_y @ np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]])
    poses[:, :3, 3] = np.stack([20 + 0.2 * k * ramp, 0.5 * np.sin(k / 9), 1.5 + 0.05 * np.sin(k / 3)], axis=1)
    return poses


def campus(*, seed: int = 0) -> Site:
    """A street between two buildings, with trees."""
    site, rng = street(seed=seed, length=80), np.random.default_rng(seed + 100)
    for _ in range(25):
        site.cylinder(rng.uniform(0, 80), rng.choice([-1, 1]) * rng.uniform(3, 6), rng.uniform(0.1, 0.3), 6)
    site.box(70, -6, 0, 80, 6, 10)
    site.box(-30, -6, 0, -20, 6, 8)
    return site
