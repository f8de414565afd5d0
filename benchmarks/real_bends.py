"""register_nonrigid on scanned bodies deformed by known fields: errors and warnings.

    POINTLOOM_DATA=<folder> python benchmarks/real_bends.py          # some minutes; the table of docs/bending.md

Scans are scaled to an RMS radius of 1. Source and target are different points of the same body. The target is deformed,
with noise of 0.005, and for "hole" without a ball of radius 0.5 around one of its points. Point errors are relative to
the field at each point, surface errors to the deformed body's points without noise or hole. The sources' points are
part
of that surface, so an undeformed copy would have no error.
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
    """A smooth displacement field of up to 0.2."""
    x, y, z = points.T
    return points + 0.12 * np.column_stack([np.sin(1.5 * y), np.sin(1.3 * z + 0.4), np.cos(1.2 * x) - 1])


def bowed(points: Array) -> Array:
    """Bent along y as an arc of radius 4."""
    angle, radius = points[:, 1] / 4, 4 + points[:, 0]
    return np.column_stack([radius * np.cos(angle) - 4, radius * np.sin(angle), points[:, 2]])


def twisted(points: Array) -> Array:
    """Rotated about y by 14 degrees per unit."""
    c, s = np.cos(0.25 * points[:, 1]), np.sin(0.25 * points[:, 1])
    return np.column_stack([c * points[:, 0] + s * points[:, 2], points[:, 1], c * points[:, 2] - s * points[:, 0]])


FIELDS = {"swayed": swayed, "bowed": bowed, "twisted": twisted}


def points_of(path: Path, seed: int) -> Array:
    """Points of a body: all points of a scan in random order, or samples of a mesh."""
    rng = np.random.default_rng(seed)
    if path.suffix == ".obj":
        mesh = loom.read_triangle_mesh(path)
        return np.asarray(mesh.sample_points_uniformly(SURFACE + 2 * COUNT, seed=seed).points)
    return rng.permutation(np.loadtxt(path)[:, :3])[: SURFACE + 2 * COUNT]


def measure(points: Array, bend, hole: bool) -> str:
    """One row of the table."""
    center = points.mean(axis=0)
    points = (points - center) / np.sqrt(((points - center) ** 2).sum(axis=1).mean())
    source, scan, surface = points[:COUNT], bend(points[COUNT : 2 * COUNT]), bend(points)
    scan = scan + np.random.default_rng(1).normal(0, NOISE, scan.shape)
    if hole:
        scan = scan[np.linalg.norm(scan - scan[0], axis=1) > HOLE]
    start = time.process_time()
    result = loom.registration.register_nonrigid(loom.PointCloud(source), loom.PointCloud(scan))
    seconds = time.process_time() - start
    warped, truth = result.warped.points, bend(source)
    near, tree = np.linalg.norm(warped - truth, axis=1), cKDTree(surface)
    rigid = source @ result.rigid_pose[:3, :3].T + result.rigid_pose[:3, 3]
    surface, stiff = tree.query(warped)[0], tree.query(rigid)[0]
    figures = (
        f"{np.median(stiff):.4f} | {np.median(surface):.4f} | {np.quantile(surface, 0.95):.4f} | {np.median(near):.3f}"
    )
    return f"{figures} | {seconds:.1f} | {'; '.join(result.warnings) or 'none'} |"


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
