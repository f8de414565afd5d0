"""Growth of time and memory: every operation at four sizes, each a quarter of the next, in a process of its own.

    python benchmarks/scale.py [--points 2000000] [--only NAME] [--device cpu] [--output FILE]

Mesh operations get as many triangles as the others get points. Each operation first runs on 20,000 of them, to compile
its kernels. At each size the cloud or mesh is created, and the time and the additional resident memory are measured for
one call. For a failing operation, the results contain the error message. A complete run on the CPU is saved in
results/scale-cpu.json, from which write_pages.py makes the tables of docs/measured.md.
"""

from __future__ import annotations

import argparse
import datetime
import json
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER))

import numpy as np  # noqa: E402
import scenes  # noqa: E402
from contest import Trial, limit_threads  # noqa: E402
from memory import peak_bytes  # noqa: E402
from run import in_own_process, machine, write_json  # noqa: E402

RESULTS = FOLDER / "results" / "scale-cpu.json"
SMALL = 20_000
TIME_LIMIT = 900  # [s] per operation
STEPS = 4  # sizes, a factor of 4 apart
Make = Callable[[Any, float], Any]  # (cloud, mean spacing [m]) -> result


def loom() -> Any:
    import pointloom

    return pointloom


def box() -> Any:
    return loom().AxisAlignedBoundingBox([-1, -1, -9], [1, 1, 9])


def oriented_box() -> Any:
    R = np.array([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]])
    return loom().OrientedBoundingBox([0, 0, 0], R, [2, 2, 9])


def there_and_back(cloud: Any, extension: str) -> Any:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"cloud{extension}"
        loom().write_point_cloud(path, cloud)
        return loom().read_point_cloud(path)


def square() -> Any:
    return loom().SelectionPolygonVolume([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], "Z", -9, 9)


def depth_camera() -> Any:
    return loom().PinholeCameraIntrinsic(1280, 960, 1000, 1000, 640, 480)


def before_camera() -> np.ndarray:
    T = np.diag([1.0, -1, -1, 1])
    T[2, 3] = 3
    return T


# name: (operation, whether the cloud has normals)
OPERATIONS: dict[str, tuple[Make, bool]] = {
    "voxel_down_sample": (lambda c, s: c.voxel_down_sample(4 * s), False),
    "voxel_down_sample, nearest": (lambda c, s: c.voxel_down_sample(4 * s, reduction="nearest"), False),
    "voxel_down_sample_and_trace": (lambda c, s: c.voxel_down_sample_and_trace(4 * s), False),
    "uniform_down_sample": (lambda c, s: c.uniform_down_sample(5), False),
    "random_down_sample": (lambda c, s: c.random_down_sample(0.3), False),
    "farthest_point_down_sample, 1000": (lambda c, s: c.farthest_point_down_sample(1000), False),
    "select_by_index": (lambda c, s: c.select_by_index(np.arange(0, len(c), 3), invert=True), False),
    "crop": (lambda c, s: c.crop(box()), False),
    "crop, oriented box": (lambda c, s: c.crop(oriented_box()), False),
    "crop, polygon": (lambda c, s: square().crop_point_cloud(c), False),
    "remove_non_finite_points": (lambda c, s: c.remove_non_finite_points(), False),
    "remove_duplicated_points": (lambda c, s: c.remove_duplicated_points(), False),
    "paint_uniform_color": (lambda c, s: c.paint_uniform_color([1, 0, 0]), False),
    "+": (lambda c, s: c + c, False),
    "transform": (lambda c, s: c.transform(before_camera()), False),
    "estimate_normals, 30 within r": (lambda c, s: c.estimate_normals(radius=3.4 * s, max_nn=30), False),
    "estimate_covariances, 20": (lambda c, s: c.estimate_covariances(max_nn=20), False),
    "orient_normals_consistent_tangent_plane(15)": (lambda c, s: c.orient_normals_consistent_tangent_plane(15), True),
    "orient_normals_towards_camera_location": (lambda c, s: c.orient_normals_towards_camera_location([0, 0, 9]), True),
    "compute_point_cloud_distance": (lambda c, s: c.compute_point_cloud_distance(c.uniform_down_sample(2)), False),
    "compute_nearest_neighbor_distance": (lambda c, s: c.compute_nearest_neighbor_distance(), False),
    "compute_mean_and_covariance": (lambda c, s: c.compute_mean_and_covariance(), False),
    "compute_mahalanobis_distance": (lambda c, s: c.compute_mahalanobis_distance(), False),
    "compute_metrics": (lambda c, s: loom().compute_metrics(c, c.uniform_down_sample(2)), False),
    "remove_statistical_outlier(20, 2)": (lambda c, s: c.remove_statistical_outlier(20, 2.0), False),
    "remove_radius_outlier(10, r)": (lambda c, s: c.remove_radius_outlier(10, 2.3 * s), False),
    "cluster_dbscan(r, 10)": (lambda c, s: c.cluster_dbscan(2.3 * s, 10), False),
    "cluster_dbscan, all pairs near": (lambda c, s: c.cluster_dbscan(10.0, 10), False),
    "cluster_euclidean": (lambda c, s: c.cluster_euclidean(1.5 * s), False),
    "segment_plane, 1000": (lambda c, s: c.segment_plane(0.02, 3, 1000), False),
    "segment_planes": (lambda c, s: c.segment_planes(0.02, max_planes=3), False),
    "detect_planar_patches": (lambda c, s: c.detect_planar_patches(), True),
    "hidden_point_removal": (lambda c, s: c.hidden_point_removal([0, 0, 6], 600), False),
    "compute_convex_hull": (lambda c, s: c.compute_convex_hull(), False),
    "get_oriented_bounding_box": (lambda c, s: c.get_oriented_bounding_box(), False),
    "get_minimal_oriented_bounding_box": (lambda c, s: c.get_minimal_oriented_bounding_box(), False),
    "compute_iss_keypoints": (lambda c, s: loom().compute_iss_keypoints(c), False),
    "compute_fpfh_feature, 30": (lambda c, s: loom().compute_fpfh_feature(c, radius=3.2 * s, max_nn=30), True),
    "compute_eigen_features": (lambda c, s: loom().compute_eigen_features(c, max_nn=20), False),
    "estimate_curvature": (lambda c, s: loom().estimate_curvature(c, max_nn=20), False),
    "smooth_mls": (lambda c, s: c.smooth_mls(radius=3.4 * s, max_nn=30), False),
    "smooth_bilateral": (lambda c, s: c.smooth_bilateral(radius=3.4 * s, max_nn=30), True),
    "smooth_laplacian, 2 iterations": (lambda c, s: c.smooth_laplacian(2), False),
    "smooth_taubin, 1 iteration": (lambda c, s: c.smooth_taubin(1), False),
    "project_to_depth_image": (
        lambda c, s: c.project_to_depth_image(1280, 960, depth_camera(), before_camera(), depth_max=9.0), False,
    ),
    "classify_ground": (lambda c, s: loom().classify_ground(c), False),
    "mesh by Poisson, width 4 s": (
        lambda c, s: loom().TriangleMesh.create_from_point_cloud_poisson(c, width=4 * s), True,
    ),
    "mesh by ball pivoting, 1.2 s, 2.4 s": (
        lambda c, s: loom().TriangleMesh.create_from_point_cloud_ball_pivoting(c, [1.2 * s, 2.4 * s]), True,
    ),
    "mesh by alpha shape, 2 s": (lambda c, s: loom().TriangleMesh.create_from_point_cloud_alpha_shape(c, 2 * s), False),
    "write and read .ply": (lambda c, s: there_and_back(c, ".ply"), False),
    "write and read .las": (lambda c, s: there_and_back(c, ".las"), False),
    "write and read .laz": (lambda c, s: there_and_back(c, ".laz"), False),
}  # fmt: skip


def scene_of(mesh: Any) -> Any:
    scene = loom().RaycastingScene()
    scene.add_triangles(mesh)
    return scene


def cast_an_image(mesh: Any) -> Any:
    rays = loom().RaycastingScene.create_rays_pinhole(
        fov_deg=60, center=[0, 0, 0], eye=[0, -3, 3], up=[0, 0, 1], width_px=1280, height_px=960
    )
    return scene_of(mesh).cast_rays(rays)


def random_positions(count: int = 1_000_000) -> Any:
    return np.random.default_rng(1).uniform([-2, -2, -0.5], [2, 2, 0.5], (count, 3)).astype(np.float32)


# name: operation on a mesh with the given edge length
MESH_OPERATIONS: dict[str, Callable[[Any, float], Any]] = {
    "mesh.repair": lambda m, s: m.repair(),
    "mesh.merge_close_vertices": lambda m, s: m.merge_close_vertices(0.5 * s),
    "mesh.orient_triangles": lambda m, s: m.orient_triangles(),
    "mesh.cluster_connected_triangles": lambda m, s: m.cluster_connected_triangles(),
    "mesh.is_watertight": lambda m, s: m.is_watertight(),
    "mesh.compute_vertex_normals": lambda m, s: m.compute_vertex_normals(),
    "mesh.compute_vertex_curvature": lambda m, s: m.compute_vertex_curvature(),
    "mesh.crop": lambda m, s: m.crop(box()),
    "mesh.filter_smooth_taubin, 10": lambda m, s: m.filter_smooth_taubin(10),
    "mesh.subdivide_loop": lambda m, s: m.subdivide_loop(1),
    "mesh.subdivide_midpoint": lambda m, s: m.subdivide_midpoint(1),
    "mesh.simplify_vertex_clustering": lambda m, s: m.simplify_vertex_clustering(4 * s),
    "mesh.simplify_quadric_decimation, to a tenth": lambda m, s: m.simplify_quadric_decimation(len(m) // 10),
    "mesh.get_self_intersecting_triangles": lambda m, s: m.get_self_intersecting_triangles(),
    "mesh.compute_metrics, with itself moved": lambda m, s: m.compute_metrics(m.transform(moved(s))),
    "mesh.voxelize": lambda m, s: m.voxelize(4 * s),
    "mesh, a picture of 1280 x 960 by rays": lambda m, s: cast_an_image(m),
    "mesh, distances of 1M points": lambda m, s: scene_of(m).compute_distance(random_positions()),
    "mesh.sample_points_uniformly, 1M": lambda m, s: m.sample_points_uniformly(1_000_000),
}


def moved(distance: float) -> np.ndarray:
    T = np.eye(4)
    T[2, 3] = distance
    return T


def bumpy_mesh(count: int, device: str) -> tuple[Any, float]:
    """About `count` triangles on the bumpy surface with some roughness, and their edge length [m]."""
    side = int((count / 2) ** 0.5) + 1
    line = np.linspace(-scenes.SURFACE_EDGE / 2, scenes.SURFACE_EDGE / 2, side, dtype=np.float32)
    x, y = (values.ravel() for values in np.meshgrid(line, line, indexing="ij"))
    edge = scenes.SURFACE_EDGE / (side - 1)
    z = 0.15 * np.sin(3 * x) * np.cos(2 * y) + 0.03 * np.sin(11 * x + 5 * y)
    z += np.random.default_rng(0).normal(0, 0.1 * edge, len(z)).astype(np.float32)
    first = (np.arange(side - 1, dtype=np.int32)[:, None] * side + np.arange(side - 1, dtype=np.int32)).ravel()
    lower = np.stack([first, first + side, first + 1], axis=1)
    triangles = np.concatenate([lower, np.stack([first + 1, first + side, first + side + 1], axis=1)])
    return loom().TriangleMesh(np.stack([x, y, z], axis=1), triangles, device=device), edge


def run_one(name: str, largest: int, device: str) -> list[dict[str, Any]]:
    """Time and memory of one operation in this process, by size."""
    limit_threads(device)
    work, normals = (MESH_OPERATIONS[name], False) if name in MESH_OPERATIONS else OPERATIONS[name]

    def scene(n: int) -> tuple[Any, float]:
        if name in MESH_OPERATIONS:
            return bumpy_mesh(n, device)
        data = loom().PointCloud(scenes.bumpy_surface(n), device=device)
        return (data.estimate_normals(max_nn=12) if normals else data), scenes.SURFACE_EDGE / n**0.5

    work(*scene(min(SMALL, largest)))
    records = []
    for step in reversed(range(STEPS)):
        count = largest // 4**step
        arguments = scene(count)
        seconds: list[float] = []

        def call(arguments: tuple[Any, float] = arguments, seconds: list[float] = seconds) -> Any:
            begin = time.perf_counter()
            result = work(*arguments)
            seconds.append(time.perf_counter() - begin)
            return result

        records.append({"count": count, "bytes": peak_bytes(Trial(call)), "seconds": seconds[0]})
    return records


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--points", type=int, default=2_000_000, help="the largest size")
    parser.add_argument("--only", action="append", help="operations whose names start with this")
    parser.add_argument("--device", default="cpu")
    parser.add_argument(
        "--output", type=Path, metavar="FILE", help="JSON file; without it only complete runs are saved"
    )
    parser.add_argument("--one", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.one:
        print(json.dumps(run_one(options.one, options.points, options.device)))
        return 0
    about = {
        "date": datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds"),
        "device": options.device,
        "machine": machine(options.device),
    }
    rows = []
    for name in [*OPERATIONS, *MESH_OPERATIONS]:
        if options.only and not any(name.startswith(start) for start in options.only):
            continue
        rows.append({"operation": name, **attempt(name, options)})
        print(f"{name:45s} {text_of(rows[-1])}", flush=True)
    path = options.output or (None if options.only or options.device != "cpu" else RESULTS)
    if path is not None:
        write_json(path, {"about": about, "rows": rows})
    return 0


def attempt(name: str, options: argparse.Namespace) -> dict[str, Any]:
    """Times and memory by size, or the error."""
    command = [sys.executable, __file__, "--one", name, "--points", str(options.points), "--device", options.device]
    sizes, error = in_own_process(command, TIME_LIMIT)
    return {"sizes": sizes} if error is None else {"error": error}


def text_of(row: dict[str, Any]) -> str:
    """Times [s] and memory [GiB] by size in one line, or the error."""
    if "error" in row:
        return row["error"]
    return "  ".join(f"{size['seconds']:8.3f} s {size['bytes'] / 2**30:6.3f} GiB" for size in row["sizes"])


if __name__ == "__main__":
    sys.exit(main())
