"""Surveys of several stations with known poses, for the coverage of their covariances."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

FOLDER = Path(__file__).resolve().parent
sys.path[:0] = [str(FOLDER), str(FOLDER.parent)]

import belief_scenes  # noqa: E402
import places  # noqa: E402
from real_data import DataMissingError  # noqa: E402
from real_scans import Rotation  # noqa: E402

Array = NDArray[np.float64]
COLUMNS, ROWS = 400, 120  # rays of a station
RANGE_NOISE = 0.002  # [m]
SITES = ("hall", "forest", "outdoors")
PARTS, PART_POINTS = 4, 20_000  # stations of a divided real cloud, and their most points


@dataclass(frozen=True)
class Survey:
    """Scans in their own frames [m], the true poses T_survey_station [n, 4, 4], the voxel size [m], and whether z is up
    in the scans.
    """

    kind: str
    scans: list[Array]
    poses: Array
    voxel: float
    level: bool


def courtyards(seeds: range) -> Iterator[Survey]:
    """Three to six stations in a courtyard with random boxes. Every second scanner is tilted."""
    for seed in seeds:
        rng, builder = np.random.default_rng([seed, 82]), places.Builder()
        x, y = rng.uniform(18, 30), rng.uniform(14, 24)
        builder.box((0, 0, -0.2), (x, y, 0))
        for low, high in (((-0.3, 0), (0, y)), ((x, 0), (x + 0.3, y)), ((0, -0.3), (x, 0)), ((0, y), (x, y + 0.3))):
            builder.box((*low, 0), (*high, rng.uniform(3, 9)), rng.normal(0, 0.01))
        for _ in range(rng.integers(6, 14)):
            low, extent = rng.uniform(0.1, 0.85, 2) * (x, y), rng.uniform(0.5, 3.0, 3)
            builder.box((*low, 0), (*(low + extent[:2]), extent[2]), rng.uniform(0, 3))
        spots = rng.uniform(0.1, 0.9, (rng.integers(3, 7), 2)) * (x, y)
        stations = np.column_stack([spots, rng.uniform(1.5, 1.9, len(spots))])
        yield _scanned("courtyards", builder.build(), stations, 0.2, rng, bool(seed % 2))


def sites(seeds: range) -> Iterator[Survey]:
    """Three to six stations, 4 to 7 m apart, in halls, woods and open ground. Every second scanner is tilted."""
    for seed in seeds:
        site = places.KINDS[SITES[seed // 2 % len(SITES)]](seed)
        rng = np.random.default_rng([seed, 83])
        count = rng.integers(3, 7)
        along = -8 + np.cumsum(rng.uniform(4, 7, count))
        stations = np.column_stack([along, rng.uniform(-1.5, 1.5, count), 1.6 + rng.uniform(0, 0.3, count)])
        yield _scanned("sites", site, stations, 0.2, rng, bool(seed % 2))


def parts_of_real(seeds: range) -> Iterator[Survey]:
    """Real clouds, each divided into four random parts, of which a third is removed on different sides.

    As the halves of the pairs: the poses are exact, every second cloud is held out, and errors of the sensor cancel.
    """
    clouds = real_clouds()
    clouds = clouds[::2] if seeds.start < HELD_OUT else clouds[1::2]
    for seed in seeds if clouds else ():
        scan, rng = clouds[seed % len(clouds)], np.random.default_rng([seed, 84])
        points = scan.points
        if len(points) > PARTS * PART_POINTS:
            points = points[np.sort(rng.choice(len(points), PARTS * PART_POINTS, replace=False))]
        part, scans, poses = rng.integers(0, PARTS, len(points)), [], []
        for k in range(PARTS):
            along = (points - points.mean(axis=0)) @ rng.normal(size=3)
            T = np.eye(4)
            T[:3, :3], T[:3, 3] = Rotation.from_rotvec(rng.normal(0, 0.3, 3)).as_matrix(), rng.normal(0, 0.3, 3)
            chosen = points[(part == k) & (along < np.quantile(along, 0.67))]
            scans.append((chosen - T[:3, 3]) @ T[:3, :3])
            poses.append(T)
        yield Survey("parts of real scans", scans, np.array(poses), 0.05 if scan.kind == "room" else 0.5, False)


HELD_OUT = 2000  # first seed of the surveys on which no constant was chosen
KINDS: dict[str, Callable[[range], Iterator[Survey]]] = {
    "courtyards": courtyards,
    "sites": sites,
    "parts of real scans": parts_of_real,
}


def real_clouds() -> list[belief_scenes.Scan]:
    """The real clouds of rooms and streets that are available."""
    clouds: list[belief_scenes.Scan] = []
    for name in ("kitchen", "teaser", "frames", "clouds", "streets"):
        try:
            clouds += list(getattr(belief_scenes, name)())
        except DataMissingError as error:
            print(f"left out {name}: {error}", file=sys.stderr)
    return clouds


def _scanned(
    kind: str, site: places.Site, stations: Array, voxel: float, rng: np.random.Generator, level: bool
) -> Survey:
    import pointloom as loom

    scene = loom.RaycastingScene()
    scene.add_triangles(site.vertices.astype(np.float32), site.triangles.astype(np.uint32))
    scans, poses = [], []
    for station in stations:
        T = np.eye(4)
        tilt = np.zeros(3) if level else rng.normal(0, 0.03, 3)
        T[:3, :3] = (Rotation.from_euler("z", rng.uniform(-3, 3)) * Rotation.from_rotvec(tilt)).as_matrix()
        T[:3, 3] = station
        a, e = np.meshgrid(
            np.linspace(-np.pi, np.pi, COLUMNS, endpoint=False) + rng.uniform(0, 0.02),
            np.linspace(-np.radians(55), np.radians(65), ROWS) + rng.uniform(0, 0.02),
        )
        rays = np.stack([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)], axis=-1).reshape(-1, 3)
        lines = np.concatenate([np.broadcast_to(T[:3, 3], rays.shape), rays @ T[:3, :3].T], 1)
        distances = np.asarray(scene.cast_rays(lines.astype(np.float32))["t_hit"], float)
        is_hit = np.isfinite(distances) & (distances > 0.5) & (distances < 40)
        scans.append(rays[is_hit] * (distances[is_hit] + rng.normal(0, RANGE_NOISE, is_hit.sum()))[:, None])
        poses.append(T)
    return Survey(kind, scans, np.array(poses), voxel, level)
