"""LiDAR scans fused into a TSDF volume: surface error, completeness and time.

    python benchmarks/lidar_volumes.py                    # a synthetic hall, ten scans of 64 beams with 2 cm of noise
    python benchmarks/lidar_volumes.py --noise 0.03 --picture hall.png

There is no baseline: Open3D fuses depth images only, VDBFusion has wheels for Python 3.7 to 3.10.
"""

from __future__ import annotations

import argparse
import time

import numpy as np

import pointloom as loom

POSES, BEAMS, COLUMNS = 10, 64, 900


def hall() -> loom.TriangleMesh:
    """Floor and four walls of 12 x 8 m, a box, a pillar, a sphere."""
    parts = [
        ((12, 8, 0.1), (0, 0, -0.1)),
        ((12, 0.1, 3), (0, -0.1, 0)),
        ((0.1, 8, 3), (-0.1, 0, 0)),
        ((12, 0.1, 3), (0, 8, 0)),
        ((0.1, 8, 3), (12, 0, 0)),
        ((2, 1.2, 0.8), (2, 3, 0)),
        ((0.6, 0.6, 2.4), (9.5, 2, 0)),
    ]
    boxes = [loom.TriangleMesh.create_box(*size).translate(position) for size, position in parts]
    ball = loom.TriangleMesh.create_sphere(0.6, resolution=60).translate([6, 5.5, 0.9])
    return sum([ball, *boxes[1:]], boxes[0])


def scan_of(scene: loom.RaycastingScene, position: np.ndarray, noise: float, seed: int) -> np.ndarray:
    """A scan of a spinning scanner at a position: points in the world [m]."""
    up, around = np.deg2rad(np.linspace(-45, 30, BEAMS)), np.linspace(0, 2 * np.pi, COLUMNS, endpoint=False)
    e, a = (angles.ravel() for angles in np.meshgrid(up, around, indexing="ij"))
    directions = np.stack([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)], axis=1)
    rays = np.hstack([np.tile(position, (len(directions), 1)), directions]).astype(np.float32)
    ranges = np.asarray(scene.cast_rays(rays)["t_hit"], np.float64)
    is_hit = np.isfinite(ranges)
    measured = ranges[is_hit] + np.random.default_rng(seed).normal(0, noise, is_hit.sum())
    return position + directions[is_hit] * measured[:, None]


def main() -> None:
    """Print a row for each voxel size."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--noise", type=float, default=0.02, help="standard deviation of ranges [m]")
    parser.add_argument("--voxels", type=float, nargs="+", default=[0.05, 0.08, 0.12], help="[m]")
    parser.add_argument("--picture", help="image of the surface at the first voxel size")
    options = parser.parse_args()
    truth = loom.RaycastingScene()
    truth.add_triangles(hall())
    t = np.linspace(0, 1, POSES)
    positions = np.column_stack([1.5 + 9 * t, 4 + 1.2 * np.sin(6 * t), np.full(POSES, 1.4)])
    scans = [scan_of(truth, position, options.noise, seed) for seed, position in enumerate(positions)]
    covered = np.vstack([scan_of(truth, position, 0.0, 0) for position in positions])[::20].astype(np.float32)
    print("| voxel [m] | points per scan | s per scan | blocks | triangles | error, median, 95 % [mm] | completeness |")
    print("|---|---|---|---|---|---|---|")
    for voxel in options.voxels:
        volume = loom.TSDFVolume(voxel_size=voxel, color=False)
        start = time.process_time()
        for points, position in zip(scans, positions, strict=True):
            volume.integrate_points(points, position)
        seconds = (time.process_time() - start) / POSES
        mesh = volume.extract_triangle_mesh(weight_threshold=0)
        if options.image and voxel == options.voxels[0]:
            above = {"front": [-0.4, -0.7, 1.0], "lookat": [6, 4, 0.5], "up": [0, 0, 1], "zoom": 0.55}
            loom.write_image(options.image, loom.render(mesh.compute_vertex_normals(), above, (900, 600)))
        samples = mesh.sample_points_uniformly(60_000, seed=0).points.astype(np.float32)
        errors = 1000 * np.quantile(np.asarray(truth.compute_distance(samples)), [0.5, 0.95])
        surface = loom.RaycastingScene()
        surface.add_triangles(mesh)
        completeness = np.mean(np.asarray(surface.compute_distance(covered)) < voxel)
        cells = f"{len(scans[0]):,} | {seconds:.3f} | {volume.block_count:,} | {len(mesh.triangles):,}"
        print(f"| {voxel:g} | {cells} | {errors[0]:.1f}, {errors[1]:.1f} | {completeness:.2%} |", flush=True)


if __name__ == "__main__":
    main()
