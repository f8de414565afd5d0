"""Time of the first use of an operation in a new process: seconds until the first result, and of the second call.

    python benchmarks/first_use.py [--cold] [--together 4] [--laps 3] [--only PREFIX] [--device cpu] [--output FILE]

Each lap is a separate process with this one's environment that imports pointloom, creates small data (about 400 points,
or one small depth frame) and runs the operation twice. The columns are the wall seconds of

- import: `import pointloom`, which is lazy: names are loaded on first use;
- data: creating the data, which loads NumPy and the modules of clouds and starts the runtime of the CPU's compiler;
- first: the first call, which loads the rest, and compiles kernels or loads them from the caches;
- second: the same call again;
- process: the full process, including start and exit of the interpreter;

and cpu, the CPU seconds of all cores up to the second result, which depend less on other load. All values are medians
over the laps. A run before the laps fills the kernel caches; with `--cold` there is no such run, and each process gets
empty caches (`.pyc` files stay). `POINTLOOM_CPU` selects the compiler.

With `--together N` a lap consists of N such processes, started at once with shared caches. Each column is the maximum
over the processes; an operation fails if one of the processes fails.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Any

TIME_LIMIT = 900  # [s] per process
COUNT = 400  # points
COLUMNS = ("import", "data", "first", "second", "process", "cpu")
CACHES = ("TI_OFFLINE_CACHE_FILE_PATH", "WARP_CACHE_PATH")


@dataclass(frozen=True)
class FirstUse:
    """An operation and its data.

    Attributes:
        make: Device -> the data.
        work: Called twice with the data.
    """

    make: Callable[[str], Any]
    work: Callable[[Any], Any]


def loom() -> Any:
    import pointloom

    return pointloom


def cloud(device: str, seed: int = 0) -> Any:
    import scenes

    return loom().PointCloud(scenes.bumpy_surface(COUNT, seed), device=device)


def pair(device: str) -> tuple[Any, Any]:
    """A source and a target with normals."""
    import scenes

    surfaces = [scenes.bumpy_surface(COUNT, seed) for seed in (0, 1)]
    up = [[[0.0, 0.0, 1.0]] * COUNT] * 2  # given, so that the first call is the registration alone
    source, target = (loom().PointCloud(p, normals=n, device=device) for p, n in zip(surfaces, up, strict=True))
    return source, target


def frame(device: str) -> tuple[Any, ...]:
    """An empty volume, and a depth frame of 80 x 60 pixels with its camera and pose."""
    import scenes

    frames = scenes.room_frames(1, 80, 60)
    camera = loom().PinholeCameraIntrinsic(80, 60, *frames.intrinsic)
    return (
        loom().TSDFVolume(voxel_size=0.05, color=False, device=device),
        frames.depths[0],
        camera,
        frames.extrinsics[0],
    )


def field(device: str) -> tuple[Any, str]:
    import scenes

    return scenes.wavy_ball(16), device


def fuse(data: tuple[Any, ...]) -> Any:
    volume, *view = data
    volume.integrate(*view, depth_max=6.0)
    return volume.extract_triangle_mesh(weight_threshold=0)


def every_name(_: None) -> list[Any]:
    modules = loom(), loom().registration
    return [getattr(module, name) for module in modules for name in module.__all__]


def icp(data: tuple[Any, Any]) -> Any:
    registration = loom().registration
    return registration.registration_icp(*data, 0.3, None, registration.TransformationEstimationPointToPlane())


OPERATIONS: dict[str, FirstUse] = {
    "import, every public name": FirstUse(lambda device: None, every_name),
    "voxel_down_sample": FirstUse(cloud, lambda c: c.voxel_down_sample(0.4)),
    "estimate_normals": FirstUse(cloud, lambda c: c.estimate_normals(radius=0.6, max_nn=20)),
    "orient_normals_consistent_tangent_plane": FirstUse(
        lambda device: pair(device)[0], lambda c: c.orient_normals_consistent_tangent_plane(10)
    ),
    "knn_search": FirstUse(cloud, lambda c: loom().NearestNeighborSearch(c).knn_search(c, 10)),
    "remove_statistical_outlier": FirstUse(cloud, lambda c: c.remove_statistical_outlier(10, 2.0)),
    "cluster_dbscan": FirstUse(cloud, lambda c: c.cluster_dbscan(0.3, 5)),
    "segment_plane": FirstUse(cloud, lambda c: c.segment_plane(0.05, 3, 100)),
    "get_minimal_oriented_bounding_box": FirstUse(cloud, lambda c: c.get_minimal_oriented_bounding_box()),
    "compute_fpfh_feature": FirstUse(
        lambda device: pair(device)[0], lambda c: loom().compute_fpfh_feature(c, radius=0.8, max_nn=50)
    ),
    "registration_icp, point to plane": FirstUse(pair, icp),
    "register_globally": FirstUse(pair, lambda p: loom().registration.register_globally(*p, voxel_size=0.25)),
    "tsdf, integrate and mesh": FirstUse(frame, fuse),
    "create_from_point_cloud_poisson": FirstUse(
        lambda device: pair(device)[0], lambda c: loom().TriangleMesh.create_from_point_cloud_poisson(c, depth=6)
    ),
    "marching_cubes": FirstUse(field, lambda f: loom().meshing.marching_cubes(f[0], device=f[1])),
}


def run_one(name: str, device: str) -> dict[str, float]:
    """The times of this process, which has not loaded the library yet."""
    use, moments = OPERATIONS[name], [time.perf_counter()]
    loom()
    moments.append(time.perf_counter())
    data = use.make(device)
    moments.append(time.perf_counter())
    for _ in range(2):
        use.work(data)
        moments.append(time.perf_counter())
    steps = {column: moments[k + 1] - moments[k] for k, column in enumerate(COLUMNS[:4])}
    return steps | {"cpu": time.process_time()}


def run_process(name: str, device: str, caches: dict[str, str]) -> dict[str, float]:
    """The times of a new process.

    Raises:
        RuntimeError: The process failed or exceeded the time limit.
    """
    command = [sys.executable, __file__, "--one", name, "--device", device]
    begin = time.perf_counter()
    try:
        done = subprocess.run(
            command, capture_output=True, text=True, timeout=TIME_LIMIT, check=False, env=os.environ | caches
        )
    except subprocess.TimeoutExpired as error:
        raise RuntimeError(f"took more than {TIME_LIMIT} s") from error
    duration = time.perf_counter() - begin
    if done.returncode:
        lines = done.stderr.strip().splitlines() or [f"ended by signal {-done.returncode}"]
        raise RuntimeError(lines[-1][:200])
    return json.loads(done.stdout.strip().splitlines()[-1]) | {"process": duration}


def run_together(name: str, options: argparse.Namespace, caches: dict[str, str]) -> dict[str, float]:
    """The maximum times of processes that are started at once, for each column.

    Raises:
        RuntimeError: A process failed or exceeded the time limit.
    """
    with ThreadPoolExecutor(options.together) as threads:
        jobs = [threads.submit(run_process, name, options.device, caches) for _ in range(options.together)]
    errors = [error for job in jobs if (error := job.exception())]
    if errors:
        raise RuntimeError(f"{len(errors)} of {len(jobs)} processes: {errors[0]}")
    return {column: max(job.result()[column] for job in jobs) for column in COLUMNS}


def measure(name: str, options: argparse.Namespace) -> list[dict[str, float]]:
    """The times of each lap."""
    if not options.cold:
        run_process(name, options.device, {})
        return [run_together(name, options, {}) for _ in range(options.laps)]
    laps = []
    for _ in range(options.laps):
        with tempfile.TemporaryDirectory(prefix="bench-cache-") as folder:
            laps.append(run_together(name, options, dict.fromkeys(CACHES, folder)))
    return laps


def main() -> int:
    """Run the measurements. Returns the exit code: 1 if an operation failed."""
    options = parse_options()
    if options.one:
        print(json.dumps(run_one(options.one, options.device)))
        return 0
    names = [name for name in OPERATIONS if name.startswith(tuple(options.only or [""]))]
    about, operations, failed = describe(options), {}, {}
    print(f"{'':42s}" + "".join(f"{column:>9s}" for column in COLUMNS) + "  [s]", flush=True)
    for name in names:
        try:
            laps = measure(name, options)
        except RuntimeError as error:
            failed[name] = str(error)
            print(f"{name:42s} FAILED: {error}", flush=True)
            continue
        medians = {column: statistics.median(lap[column] for lap in laps) for column in COLUMNS}
        operations[name] = {"seconds": medians, "laps": laps}
        print(f"{name:42s}" + "".join(f"{medians[column]:9.3f}" for column in COLUMNS), flush=True)
    if options.output:
        content = about | {"operations": operations, "failed": failed}
        options.output.write_text(json.dumps(content, indent=1) + "\n")
    return int(bool(failed) or not operations)


def describe(options: argparse.Namespace) -> dict[str, Any]:
    """The conditions that the times depend on."""
    return {
        "kernel_caches": "empty" if options.cold else "filled",
        "laps": options.laps,
        "processes": options.together,
        "device": options.device,
        "compiler": os.environ.get("POINTLOOM_CPU", ""),
        "cores": os.cpu_count(),
        "load_before": round(os.getloadavg()[0], 2),
        "python": platform.python_version(),
    }


def parse_options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cold", action="store_true", help="start each process with empty kernel caches")
    parser.add_argument("--together", type=int, default=1, metavar="N", help="simultaneous processes (default 1)")
    parser.add_argument("--laps", type=int, default=3, help="number of laps; the table shows medians (default 3)")
    parser.add_argument("--only", action="append", metavar="PREFIX", help="operations whose names start with this")
    parser.add_argument("--device", default="cpu")
    parser.add_argument("--output", type=Path, metavar="FILE", help="write the times of each lap as JSON")
    parser.add_argument("--one", help=argparse.SUPPRESS)
    options = parser.parse_args()
    for name in ("laps", "together"):
        if getattr(options, name) < 1:
            parser.error(f"--{name}: expected at least 1, got {getattr(options, name)}")
    if not any(name.startswith(tuple(options.only or [""])) for name in OPERATIONS):
        parser.error(f"--only: expected a prefix of one of {', '.join(OPERATIONS)}")
    return options


if __name__ == "__main__":
    sys.exit(main())
