"""Synthetic photographs of several kinds with ground truth, of scenes that were not used to choose constants.

Scenes are meshes with procedural colors. An image is ray cast at twice its size, reduced, blurred by 0.6 px, its
exposure
changed by up to 15 %, with sensor noise, and written as JPEG with EXIF. Lenses have distortion (`BEND`). The frames of
drone images are east, north, up about `WORLD_ORIGIN`, so `images.world` needs no similarity.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import map_coordinates

import pointloom as loom
from pointloom.datasets.made.views import look_at
from pointloom.datasets.scenes.painted import PaintedParts

Array = NDArray[np.float64]
Paint = Callable[[Array], Array]

WIDTH, HEIGHT = 640, 480
BEND = -0.03  # k1 of COLMAP's SIMPLE_RADIAL
LATTICE = np.random.default_rng(11).random((32, 32, 32))
LIGHT = np.array([0.4, -0.5, 0.77]) / np.linalg.norm([0.4, -0.5, 0.77])
WORLD_ORIGIN = (
    46.95,
    7.45,
    540.0,
)  # latitude, longitude [degrees], altitude [m] of the origin of the drone's world; UTM zone 32
GPS_NOISE = (1.5, 1.5, 3.0)  # [m]
SKY = (0.70, 0.80, 0.92)


@dataclass
class Stage:
    """Meshes with colors, and ray casting.

    Attributes:
        light: Direction to the light in the world, or with `still_light` in the camera (turntables).
    """

    parts: list[tuple[Any, Paint]] = field(default_factory=list)
    still_light: bool = False
    shaded: float = 0.45

    def add(self, mesh: Any, paint: Paint) -> None:
        self.parts.append((mesh, paint))

    def scene(self) -> Any:
        scene = loom.RaycastingScene()
        for mesh, _ in self.parts:
            scene.add_triangles(mesh.vertices.astype(np.float32), mesh.triangles)
        return scene


@dataclass
class View:
    """A camera view: pose, focal length [px], and its metadata."""

    T_world_camera: Array
    focal: float
    film: int  # 35 mm equivalent focal length by the diagonal, for EXIF, integer [mm]
    portrait: bool = False  # the sensor is rotated, as stored in EXIF

    @property
    def sensor(self) -> Array:
        """T_world_camera of the stored image; it is upright after a rotation by 90 degrees clockwise."""
        rotation = np.array([[0.0, -1, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
        return self.T_world_camera @ rotation if self.portrait else self.T_world_camera


@dataclass
class PhotoSet:
    """A set of images.

    Attributes:
        thresholds: [m] for completeness and accuracy.
        masked: True if masks are given, since the background does not turn with the object.
        has_gps: True if the images have GPS positions.
    """

    name: str
    stage: Stage
    views: list[View]
    thresholds: tuple[float, float]
    masked: bool = False
    has_gps: bool = False

    @property
    def names(self) -> list[str]:
        return [f"IMG_{k:04d}.jpg" for k in range(len(self.views))]

    @property
    def poses(self) -> dict[str, Array]:
        """T_world_camera by file name without suffix."""
        return {Path(name).stem: view.T_world_camera for name, view in zip(self.names, self.views, strict=True)}


def noise(points: Array, size: float, octaves: int = 4) -> Array:
    """Noise in 0..1 with coarsest features of this size [m]."""
    total, weight = np.zeros(len(points)), 0.0
    for k in range(octaves):
        at = (points * (2.03**k / size) + 7.7 * k).T
        total += 0.8**k * map_coordinates(LATTICE, at, order=1, mode="grid-wrap")
        weight += 0.8**k
    return total / weight


def grain(color: Any, strength: float = 0.6, size: float = 0.1, octaves: int = 5) -> Paint:
    """A color with noise; half of the strength changes the hue."""

    def paint(points: Array) -> Array:
        light = 1 + 2 * strength * (noise(points, size, octaves) - 0.5)
        hue = strength * (noise(points + 31.0, 2.3 * size, 2) - 0.5)
        return np.asarray(color) * light[:, None] * (1 + hue[:, None] * np.array([0.6, 0.0, -0.6]))

    return paint


def bricks(color: Any, size: tuple[float, float], stain: float) -> Paint:
    """Bricks that repeat exactly along x and z, with stains that do not."""

    def paint(points: Array) -> Array:
        row = np.floor(points[:, 2] / size[1])
        u, v = points[:, 0] / size[0] + 0.5 * (row % 2), points[:, 2] / size[1]
        joint = (np.abs(u % 1 - 0.5) > 0.46) | (np.abs(v % 1 - 0.5) > 0.42)
        base = np.where(joint[:, None], (0.75, 0.72, 0.68), color)
        return base * (1 + 2 * stain * (noise(points, 0.8, 5) - 0.5))[:, None]

    return paint


def box(low: Any, high: Any) -> Any:
    """A box between two corners [m]."""
    size = np.subtract(high, low)
    return loom.TriangleMesh.create_box(*size).translate(np.asarray(low, float))


# ------------------------------------------------------------------------------------------------- sets


def turntable(seed: int = 0) -> PhotoSet:
    """A vase with handles and a lumpy lid that turns in front of a static camera and a static textured wall; 24
    steps.
    """
    stage = Stage(still_light=True)
    angles, height = np.meshgrid(np.linspace(0, 2 * np.pi, 181)[:-1], np.linspace(0, 1, 121), indexing="ij")
    radius = 0.055 + 0.035 * np.sin(2.6 * height + 0.4) + 0.004 * np.cos(9 * angles + 6 * height) * (height < 0.85)
    ring = np.stack([radius * np.cos(angles), radius * np.sin(angles), 0.24 * height - 0.12], -1)
    k = (np.arange(180)[:, None] * 121 + np.arange(120)).reshape(-1)
    right = ((np.arange(180)[:, None] + 1) % 180 * 121 + np.arange(120)).reshape(-1)
    body = loom.TriangleMesh(
        ring.reshape(-1, 3), np.concatenate([np.stack([k, right, right + 1], 1), np.stack([k, right + 1, k + 1], 1)])
    )
    glaze = grain((0.72, 0.50, 0.36), 0.75, 0.03)
    stage.add(body, glaze)
    stage.add(loom.TriangleMesh.create_sphere(0.066, 40).translate([0, 0, 0.10]), grain((0.4, 0.5, 0.62), 0.7, 0.025))
    for side in (-1, 1):
        handle = loom.TriangleMesh.create_torus(0.04, 0.009, 40, 16).rotate(_about("x", 90))
        stage.add(handle.translate([0.1 * side, 0, 0.02]), grain((0.6, 0.62, 0.4), 0.7, 0.02))
    stage.add(
        loom.TriangleMesh.create_cylinder(0.085, 0.02, 60, 1).translate([0, 0, -0.13]),
        grain((0.5, 0.35, 0.3), 0.7, 0.03),
    )
    away, rise = 0.62 * math.cos(math.radians(24)), 0.62 * math.sin(math.radians(24))
    camera_angles = np.linspace(0, 2 * np.pi, 25)[:-1]
    views = [View(look_at([away * math.cos(a), away * math.sin(a), rise]), 820, 44) for a in camera_angles]
    return PhotoSet("turntable", stage, views, (0.001, 0.003), masked=True)


def facade(seed: int = 0) -> PhotoSet:
    """A row of 18 images along a facade of 3 x 9 equal windows, alternately looking ahead and back."""
    rng, stage = np.random.default_rng(seed), Stage()
    wall = bricks((0.62, 0.36, 0.28), (0.25, 0.08), 0.35)
    columns, rows = np.arange(9) * 3.0 + 1.5, (0.9, 4.1, 7.3)
    stage.add(box((0, 0.25, 0), (27, 0.6, 10.5)), grain((0.3, 0.34, 0.4), 0.25, 0.5))  # the panes, behind
    edges = [0.0, *[x + s for x in columns for s in (-0.6, 0.6)], 27.0]
    for a, b in zip(edges[::2], edges[1::2], strict=True):
        stage.add(box((a, 0, 0), (b, 0.3, 10.5)), wall)
    for x in columns:
        for low, high in zip((0.0, *[r + 1.8 for r in rows]), (*rows, 10.5), strict=True):
            stage.add(box((x - 0.6, 0, low), (x + 0.6, 0.3, high)), wall)
        for row in rows:
            stage.add(box((x - 0.75, -0.15, row - 0.12), (x + 0.75, 0.05, row)), grain((0.8, 0.78, 0.72), 0.3, 0.2))
            stage.add(box((x - 0.03, 0.15, row), (x + 0.03, 0.3, row + 1.8)), grain((0.9, 0.9, 0.88), 0.2, 0.1))
    stage.add(box((-6, -9, -0.3), (33, 0, 0)), grain((0.5, 0.5, 0.48), 0.6, 0.4))
    views = []
    for k in range(18):
        eye = np.array([2.0 + 23.0 * k / 17, -6.5, 1.6]) + rng.normal(0, 0.08, 3)
        ahead = (3.0, -3.0, 0.5)[k % 3]
        views.append(View(look_at(eye, np.add(eye, [ahead, 6.5, 2.2 + rng.normal(0, 0.1)])), 430, 23))
    return PhotoSet("facade", stage, views, (0.02, 0.05))


def drone(seed: int = 0) -> PhotoSet:
    """Houses and trees on hills from 45 m above: four rows of four nadir images, and eight oblique ones around."""
    rng, stage = np.random.default_rng(seed), Stage()
    sides = np.linspace(-70, 70, 141)
    x, y = np.meshgrid(sides, sides, indexing="ij")
    z = 3 * np.sin(x / 23) * np.cos(y / 31) + 0.04 * x + 0.25 * np.sin(x / 5) * np.sin(y / 6)
    k = (np.arange(140)[:, None] * 141 + np.arange(140)).reshape(-1)
    faces = np.concatenate([np.stack([k, k + 141, k + 142], 1), np.stack([k, k + 142, k + 1], 1)])
    meadow, path = grain((0.36, 0.46, 0.22), 0.7, 4.0, 6), grain((0.62, 0.58, 0.5), 0.4, 2.0, 6)
    ground = loom.TriangleMesh(np.stack([x, y, z], -1).reshape(-1, 3), faces)
    stage.add(ground, lambda p: np.where(np.abs(p[:, 1:2] - 9 * np.sin(p[:, :1] / 20)) < 2.5, path(p), meadow(p)))
    for px, py, angle in ((-22, 18, 20), (4, 24, -10), (24, 16, 40), (-16, -18, 5), (12, -16, 70), (30, -22, 15)):
        parts = PaintedParts()
        parts.set_frame(px, py, 3 * math.sin(px / 23) * math.cos(py / 31) + 0.04 * px, angle=math.radians(angle))
        parts.box((0, 0, 2), (11, 8, 6), (1, 1, 1))
        stage.add(loom.TriangleMesh(parts.vertices, parts.triangles), grain((0.78, 0.72, 0.62), 0.35, 1.0, 5))
        roof = PaintedParts()
        roof.set_frame(px, py, 3 * math.sin(px / 23) * math.cos(py / 31) + 0.04 * px + 5, angle=math.radians(angle))
        roof.gable((0, 0, 0), (12, 9.4, 3.4), (1, 1, 1), (1, 1, 1))
        stage.add(loom.TriangleMesh(roof.vertices, roof.triangles), grain((0.6, 0.3, 0.22), 0.5, 1.2, 6))
    for _ in range(14):
        px, py = rng.uniform(-45, 45, 2)
        crown = loom.TriangleMesh.create_sphere(2.0 + rng.random(), 10).translate([px, py, 3.5 + 0.04 * px])
        stage.add(crown, grain((0.2, 0.36, 0.14), 0.9, 0.8, 5))
    views = []
    for j in range(4):
        for i in range(4):
            eye = np.array([(-24 + 16 * i) * (1 if j % 2 else -1), -24 + 16 * j, 47]) + rng.normal(0, 0.6, 3)
            tilt = rng.normal(0, 0.02, 2)
            views.append(View(_down(eye, tilt, math.pi * (j % 2)), 560, 30))
    for a in np.linspace(0, 2 * np.pi, 9)[:-1]:
        eye = np.array([48 * math.cos(a), 48 * math.sin(a), 42]) + rng.normal(0, 0.6, 3)
        views.append(View(look_at(eye, rng.normal(0, 2, 3)), 560, 30))
    return PhotoSet("drone", stage, views, (0.15, 0.5), has_gps=True)


def telephone(seed: int = 0) -> PhotoSet:
    """A still life on a table with two lenses of a telephone, 25 and 50 mm, every third image in portrait format."""
    rng, stage = np.random.default_rng(seed), Stage()
    stage.add(box((-0.6, -0.45, -0.05), (0.6, 0.45, 0)), grain((0.66, 0.48, 0.32), 0.6, 0.08, 5))
    stage.add(box((-2, 1.2, -0.8), (2, 1.25, 1.2)), grain((0.75, 0.74, 0.66), 0.4, 0.25, 5))
    stage.add(box((-0.38, 0.05, 0), (-0.14, 0.22, 0.3)), grain((0.3, 0.42, 0.62), 0.7, 0.05, 5))
    stage.add(box((0.1, 0.1, 0), (0.42, 0.3, 0.12)), grain((0.7, 0.3, 0.28), 0.7, 0.05, 5))
    ball = loom.TriangleMesh.create_sphere(0.09, 40).translate([0.24, 0.18, 0.21])
    tin = loom.TriangleMesh.create_cylinder(0.06, 0.24, 60, 1).translate([0.05, -0.15, 0.12])
    tyre = loom.TriangleMesh.create_torus(0.09, 0.03, 60, 30).translate([-0.2, -0.18, 0.03])
    for mesh, color in ((ball, (0.85, 0.7, 0.3)), (tin, (0.4, 0.6, 0.45)), (tyre, (0.6, 0.4, 0.6))):
        stage.add(mesh, grain(color, 0.7, 0.04))
    views = []
    for k, a in enumerate(np.radians(np.linspace(-160, -20, 20))):
        tele = k % 2 == 1
        away = 1.15 if tele else 0.85
        eye = np.array([away * math.cos(a), away * math.sin(a), 0.55 + 0.06 * (k % 3)]) + rng.normal(0, 0.015, 3)
        views.append(
            View(look_at(eye, (0.0, 0.05, 0.08)), 924 if tele else 462, 50 if tele else 25, portrait=k % 3 == 2)
        )
    return PhotoSet("telephone", stage, views, (0.003, 0.01))


def room(seed: int = 0) -> PhotoSet:
    """A room of 4.6 x 3.8 m from inside, 24 images on a small circle looking outward and across; untextured ceiling."""
    rng, stage = np.random.default_rng(seed), Stage(shaded=0.8)
    wood, paper = grain((0.55, 0.40, 0.27), 0.55, 0.15, 5), grain((0.78, 0.76, 0.68), 0.30, 0.2, 5)
    stage.add(box((-2.4, -2.0, -0.1), (2.4, 2.0, 0)), wood)
    stage.add(box((-2.4, -2.0, 2.5), (2.4, 2.0, 2.6)), grain((0.92, 0.92, 0.9), 0.02, 0.5))
    stage.add(box((-2.4, 1.9, 0), (2.4, 2.0, 2.5)), paper)
    stage.add(box((-2.4, -2.0, 0), (2.4, -1.9, 2.5)), paper)
    stage.add(box((-2.4, -2, 0), (-2.3, 2, 2.5)), grain((0.6, 0.66, 0.72), 0.3, 0.2, 5))
    stage.add(box((2.3, -2, 0), (2.4, 2, 2.5)), grain((0.9, 0.88, 0.84), 0.04, 0.3))  # nearly untextured
    stage.add(box((-2.3, 0.3, 0), (-1.8, 1.7, 1.9)), grain((0.45, 0.3, 0.2), 0.5, 0.1, 5))
    stage.add(box((0.2, 1.2, 0), (1.9, 1.9, 0.45)), grain((0.35, 0.42, 0.5), 0.6, 0.06, 5))
    stage.add(box((0.2, 1.65, 0.45), (1.9, 1.9, 0.9)), grain((0.35, 0.42, 0.5), 0.6, 0.06, 5))
    stage.add(box((-1.2, -1.9, 0.7), (0.2, -1.2, 0.75)), wood)
    for x, y in ((-1.2, -1.25), (0.15, -1.25)):
        stage.add(box((x, y, 0), (x + 0.05, y + 0.05, 0.7)), wood)
    stage.add(box((-0.8, -1.88, 0.75), (-0.2, -1.7, 1.15)), grain((0.15, 0.15, 0.17), 0.3, 0.05))
    stage.add(box((2.27, -0.9, 1.0), (2.3, 0.4, 1.8)), grain((0.5, 0.35, 0.5), 0.8, 0.12, 5))
    stage.add(box((1.5, -1.8, 0), (2.2, -1.2, 0.8)), grain((0.5, 0.55, 0.35), 0.5, 0.08, 5))
    views = []
    for k in range(24):
        a = 2 * math.pi * k / 24
        eye = np.array([-0.7 * math.cos(a), -0.55 * math.sin(a), 1.45]) + rng.normal(0, 0.03, 3)
        views.append(View(look_at(eye, np.add(eye, [math.cos(a), math.sin(a), -0.28 + 0.12 * (k % 2)])), 400, 22))
    return PhotoSet("room", stage, views, (0.02, 0.05))


SETS: dict[str, Callable[..., PhotoSet]] = {
    "turntable": turntable, "facade": facade, "drone": drone, "telephone": telephone, "room": room
}  # fmt: skip


def _about(axis: str, degrees: float) -> Array:
    from scipy.spatial.transform import Rotation

    return Rotation.from_euler(axis, degrees, degrees=True).as_matrix()


def _down(eye: Array, tilt: Array, heading: float) -> Array:
    """The pose of a camera that looks down with a tilt, the image's top toward a heading."""
    z = np.array([*tilt, -1.0]) / np.linalg.norm([*tilt, -1.0])
    x = np.cross(z, [math.sin(heading), math.cos(heading), 0.0])
    T = np.eye(4)
    x /= np.linalg.norm(x)
    T[:3, 0], T[:3, 1], T[:3, 2], T[:3, 3] = x, np.cross(z, x), z, eye
    return T
