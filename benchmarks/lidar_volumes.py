"""LiDAR scans fused into a TSDF volume: how far the surface lies from the truth, how much of it there is, seconds.

    python benchmarks/lidar_volumes.py                    # a made hall, ten scans of 64 beams with 2 cm of noise
    python benchmarks/lidar_volumes.py --noise 0.03 --picture hall.png

Nothing beside it does the same here: Open3D fuses depth pictures alone, VDBFusion has wheels for Python 3.7 to 3.10.
"""

from __future__ import annotations

import argparse
import time

import numpy as np

import pointloom as loom

POSES, BEAMS, COLUMNS = 10, 64, 900


def hall() -> loom.TriangleMesh:
    """Floor and four walls of 12 x 8 m, a box, a pillar, a ball."""
    parts = [
        ((12, 8, 0.1), (0, 0, -0.1)),
        ((12, 0.1, 3), (0, -0.1, 0)),
        ((0.1, 8, 3), (-0.1, 0, 0)),
        ((12, 0.1, 3), (0, 8, 0)),
        ((0.1, 8, 3), (12, 0, 0)),
        ((2, 1.2, 0.8), (2, 3, 0)),
        ((0.6, 0.6, 2.4), (9.5, 2, 0)),
    ]
    boxes = [loom.TriangleMesh.create_box(*size).translate(place) for size, place in parts]
    ball = loom.TriangleMesh.create_sphere(0.6, resolution=60).translate([6, 5.5, 0.9])
    return sum([ball, *boxes[1:]], boxes[0])


def scan_of(scene: loom.RaycastingScene, place: np.ndarray, noise: float, seed: int) -> np.ndarray:
    """What a spinning scanner at a place measures: points in the world [m]."""
    up, around = np.deg2rad(np.linspace(-45, 30, BEAMS)), np.linspace(0, 2 * np.pi, COLUMNS, endpoint=False)
    e, a = (angles.ravel() for angles in np.meshgrid(up, around, indexing="ij"))
    ways = np.stack([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)], axis=1)
    rays = np.hstack([np.tile(place, (len(ways), 1)), ways]).astype(np.float32)
    ranges = np.asarray(scene.cast_rays(rays)["t_hit"], np.float64)
    met = np.isfinite(ranges)
    measured = ranges[met] + np.random.default_rng(seed).normal(0, noise, met.sum())
    return place + ways[met] * measured[:, None]


def main() -> None:
    """Print a row a voxel size."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--noise", type=float, default=0.02, help="standard deviation of ranges [m]")
    parser.add_argument("--voxels", type=float, nargs="+", default=[0.05, 0.08, 0.12], help="[m]")
    parser.add_argument("--picture", help="of the surface of the first voxel size")
    options = parser.parse_args()
    truth = loom.RaycastingScene()
    truth.add_triangles(hall())
    way = np.linspace(0, 1, POSES)
    places = np.column_stack([1.5 + 9 * way, 4 + 1.2 * np.sin(6 * way), np.full(POSES, 1.4)])
    scans = [scan_of(truth, place, options.noise, seed) for seed, place in enumerate(places)]
    seen = np.vstack([scan_of(truth, place, 0.0, 0) for place in places])[::20].astype(np.float32)
    print("| voxel [m] | points a scan | s a scan | blocks | triangles | off, median, 95 % [mm] | of what was seen |")
    print("|---|---|---|---|---|---|---|")
    for voxel in options.voxels:
        volume = loom.TSDFVolume(voxel_size=voxel, color=False)
        start = time.process_time()
        for points, place in zip(scans, places, strict=True):
            volume.integrate_points(points, place)
        seconds = (time.process_time() - start) / POSES
        mesh = volume.extract_triangle_mesh(weight_threshold=0)
        if options.picture and voxel == options.voxels[0]:
            above = {"front": [-0.4, -0.7, 1.0], "lookat": [6, 4, 0.5], "up": [0, 0, 1], "zoom": 0.55}
            loom.save_picture(options.picture, loom.render(mesh.compute_vertex_normals(), above, (900, 600)))
        samples = mesh.sample_points_uniformly(60_000, seed=0).points.astype(np.float32)
        off = 1000 * np.quantile(np.asarray(truth.compute_distance(samples)), [0.5, 0.95])
        found = loom.RaycastingScene()
        found.add_triangles(mesh)
        whole = np.mean(np.asarray(found.compute_distance(seen)) < voxel)
        cells = f"{len(scans[0]):,} | {seconds:.3f} | {volume.block_count:,} | {len(mesh.triangles):,}"
        print(f"| {voxel:g} | {cells} | {off[0]:.1f}, {off[1]:.1f} | {whole:.2%} |", flush=True)


if __name__ == "__main__":
    main()
