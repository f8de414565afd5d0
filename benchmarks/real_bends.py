"""register_nonrigid on scanned bodies that are bent by known fields: its errors, and its warnings.

    POINTLOOM_DATA=<folder> python benchmarks/real_bends.py          # some minutes; the table of docs/bending.md

Scans are brought to a root mean squared radius of 1. The source and the target are other points of the same body, the
target bent, with noise of 0.005, and where "hole" stands without a ball of radius 0.5 about one of its points. Errors
of points are against where the field takes each, of the surface against the bent body's points without noise or hole.
The sources' own points are in that surface, so an unbent copy would have none.
"""

from __future__ import annotations

import argparse
import time
from pathlib import Path

import numpy as np
from real_data import DataMissingError, real_data
from scipy.spatial import cKDTree

import pointloom as loom

Array = np.ndarray
BODIES = {
    "bunny": "mesh-common3d/stanford-bunny.obj",
    "nefertiti": "mesh-common3d/nefertiti.obj",
    "cheburashka": "mesh-common3d/cheburashka.obj",
    "dragon scan": "reg-simpleicp/dragon1.xyz",
    "bunny scan": "reg-simpleicp/bunny_part1.xyz",
}
COUNT, NOISE, HOLE = 3000, 0.005, 0.5
SURFACE = 40_000


def swayed(points: Array) -> Array:
    """A smooth field that moves points by up to 0.2."""
    x, y, z = points.T
    return points + 0.12 * np.column_stack([np.sin(1.5 * y), np.sin(1.3 * z + 0.4), np.cos(1.2 * x) - 1])


def bowed(points: Array) -> Array:
    """Bent along y as an arc of a radius of 4."""
    angle, reach = points[:, 1] / 4, 4 + points[:, 0]
    return np.column_stack([reach * np.cos(angle) - 4, reach * np.sin(angle), points[:, 2]])


def twisted(points: Array) -> Array:
    """Turned about y by 14 degrees a unit."""
    c, s = np.cos(0.25 * points[:, 1]), np.sin(0.25 * points[:, 1])
    return np.column_stack([c * points[:, 0] + s * points[:, 2], points[:, 1], c * points[:, 2] - s * points[:, 0]])


FIELDS = {"swayed": swayed, "bowed": bowed, "twisted": twisted}


def points_of(path: Path, seed: int) -> Array:
    """Points of a body: all of a scan's in a random order, samples of a mesh."""
    rng = np.random.default_rng(seed)
    if path.suffix == ".obj":
        mesh = loom.read_triangle_mesh(path)
        return np.asarray(mesh.sample_points_uniformly(SURFACE + 2 * COUNT, seed=seed).points)
    return rng.permutation(np.loadtxt(path)[:, :3])[: SURFACE + 2 * COUNT]


def measure(points: Array, bend, hole: bool) -> str:
    """One row."""
    center = points.mean(axis=0)
    points = (points - center) / np.sqrt(((points - center) ** 2).sum(axis=1).mean())
    source, scan, surface = points[:COUNT], bend(points[COUNT : 2 * COUNT]), bend(points)
    scan = scan + np.random.default_rng(1).normal(0, NOISE, scan.shape)
    if hole:
        scan = scan[np.linalg.norm(scan - scan[0], axis=1) > HOLE]
    start = time.process_time()
    found = loom.registration.register_nonrigid(loom.PointCloud(source), loom.PointCloud(scan))
    spent = time.process_time() - start
    warped, truth = found.warped.points, bend(source)
    near, tree = np.linalg.norm(warped - truth, axis=1), cKDTree(surface)
    rigid = source @ found.rigid_pose[:3, :3].T + found.rigid_pose[:3, 3]
    away, stiff = tree.query(warped)[0], tree.query(rigid)[0]
    figures = f"{np.median(stiff):.4f} | {np.median(away):.4f} | {np.quantile(away, 0.95):.4f} | {np.median(near):.3f}"
    return f"{figures} | {spent:.1f} | {'; '.join(found.warnings) or 'none'} |"


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bodies", nargs="+", default=list(BODIES))
    options = parser.parse_args()
    print("| body | bend | surface, rigid | surface | 95 % | points | CPU [s] | warnings |")
    print("|---|---|---|---|---|---|---|---|")
    for name in options.bodies:
        try:
            path = real_data(BODIES[name])
        except DataMissingError as error:
            print(f"left out: {error}")
            continue
        points = points_of(path, 0)
        for field, bend in FIELDS.items():
            for hole in (False, True):
                row = measure(points, bend, hole)
                print(f"| {name} | {field}{', hole' if hole else ''} | {row}", flush=True)


if __name__ == "__main__":
    main()
