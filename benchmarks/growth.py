"""Growth beside other libraries: time and memory of 20 operations at 10k to 50M points, a process for each call.

    python benchmarks/growth.py [--largest 50000000] [--only NAME] [--limit 60] [--output FILE]

The operations and data are those of `make bench`; radii fall with the distance of points. Beside pointloom runs the
best baseline of the last size of the saved `make bench`. A contestant leaves before a size where the call would exceed
the limit [s], or its memory that of the machine, if both grow as the size. Rows are saved after each operation, and a
run goes on where one of the same commit ended. The results in results/growth-cpu.json become a table of
docs/measured.md by write_pages.py.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER))

import scenes  # noqa: E402
from contest import POINTLOOM, Trial, limit_threads, operations  # noqa: E402
from memory import peak_bytes, warm_up  # noqa: E402
from run import continued, in_own_process, write_json  # noqa: E402

RESULTS = FOLDER / "results" / "growth-cpu.json"
BENCH_RESULTS = FOLDER / "results" / "operations-cpu.json"
SIZES = (10_000, 100_000, 1_000_000, 10_000_000, 50_000_000)
CALLS, CALL_SECONDS = 6, 5.0  # at most so many calls, while all take less [s]; the best counts
MEMORY_FRACTION = 0.7  # of the machine's memory for a call beside its data
PROCESS_SECONDS = 900.0  # with its data and compilation


def radius(at_a_million: float, count: int) -> float:
    """A radius [m] that contains as many points of the surface at any count as `at_a_million` at a million."""
    return at_a_million * (1e6 / count) ** 0.5


def made_by(module: str, function: str) -> Callable[..., Any]:
    """A function of a bench module, which is imported when it is called."""

    def make(*arguments: Any) -> Any:
        return getattr(__import__(module), function)(*arguments)

    return make


def surface_of(module: str) -> Callable[[int], Any]:
    return lambda count: made_by(module, "surface")(count)()


def thinned(count: int) -> Any:
    """The bumpy surface as a mesh of about `count` triangles, to a tenth."""
    mesh, _ = made_by("scale", "bumpy_mesh")(count, "cpu")
    triangles = mesh.triangles
    return made_by("bench_decimation", "Thinning")((mesh.vertices, triangles), len(triangles) // 10)


# operation of `make bench`: count -> scene
SCENES: dict[str, Callable[[int], Any]] = {
    "voxel_down_sample": scenes.bumpy_surface,
    "normals_hybrid": lambda n: made_by("bench_normals", "surface")(n, radius(0.0135, n))(),
    "knn20_with_build": scenes.bumpy_surface,
    "cloud_distance": lambda n: made_by("bench_cloud_distance", "samplings")(n)(),
    "statistical_outliers": surface_of("bench_outliers"),
    "radius_outliers": surface_of("bench_outliers"),
    "dbscan": lambda n: made_by("bench_dbscan", "surface")(n, radius(0.009, n))(),
    "segment_plane": lambda n: made_by("bench_segment_plane", "scene")(n)(),
    "farthest_points": scenes.bumpy_surface,
    "orient_consistently": surface_of("bench_orientation"),
    "hidden_points": surface_of("bench_hidden_points"),
    "convex_hull": surface_of("bench_convex_hull"),
    "fpfh": lambda n: made_by("bench_fpfh", "surface")(n, radius(0.01, n))(),
    "smooth_laplacian": lambda n: made_by("bench_smoothing", "surface")(n, radius(0.0135, n))(),
    "icp_plane": surface_of("bench_icp"),
    "ply_read": scenes.colored_points,
    "ply_write": scenes.colored_points,
    "render": made_by("bench_render", "cloud_scene"),
    "decimation": thinned,
    "marching_cubes": lambda n: scenes.wavy_ball(round(n ** (1 / 3))),
}


def run_one(name: str, count: int, label: str) -> dict[str, float]:
    """Seconds and additional bytes of a contestant's call, in this process."""
    _, operation = operations()[name]
    contestant, device = operation.contestant(label, "cpu")
    warm_up(operation, contestant, device)
    scene = SCENES[name](count)
    trial = contestant.trial(scene, device)
    seconds: list[float] = []

    def timed_call(*arguments: Any) -> Any:
        begin = time.perf_counter()
        result = trial.call(*arguments)
        seconds.append(time.perf_counter() - begin)
        return result

    taken = peak_bytes(Trial(timed_call, trial.setup))
    while len(seconds) < CALLS and sum(seconds) < CALL_SECONDS:
        timed_call(*trial.arguments())
    units = operation.unit_count(scene)
    return {"seconds": min(seconds) / units, "bytes": float(taken)}


def attempt(name: str, count: int, label: str) -> dict[str, Any]:
    """`run_one` in a process of its own, or the error."""
    command = [sys.executable, __file__, "--one", name, str(count), label]
    row, error = in_own_process(command, PROCESS_SECONDS)
    return row if error is None else {"error": error}


def grow(name: str, sizes: list[int], limit: float, total_bytes: float) -> dict[str, Any]:
    """The measurements of an operation: contestant -> size -> seconds and bytes, or why it left."""
    measured = [row for row in json.loads(BENCH_RESULTS.read_text())["results"] if row["operation"] == name]
    rows: dict[str, dict[str, Any]] = {}
    for label in (POINTLOOM, measured[-1]["best_peer"]):
        rows[label] = {}
        for count in sizes:
            rows[label][str(count)] = row = attempt(name, count, label)
            text = row.get("error") or f"{row['seconds']:9.4f} s {row['bytes'] / 1e6:9.1f} MB"
            print(f"{name:22} {label:20} {count:>11,} {text}", flush=True)
            later = [size for size in sizes if size > count]
            if "error" in row or not later:
                break
            factor = later[0] / count
            if row["seconds"] * factor > limit:
                rows[label][str(later[0])] = {"error": f"expected more than {limit:g} s"}
                break
            if row["bytes"] * factor > MEMORY_FRACTION * total_bytes:
                rows[label][str(later[0])] = {"error": "expected more memory than the machine has"}
                break
    return rows


def main() -> int:
    if sys.argv[1:2] == ["--one"]:
        limit_threads("cpu")
        print(json.dumps(run_one(sys.argv[2], int(sys.argv[3]), sys.argv[4])))
        return 0
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--largest", type=int, default=SIZES[-1], help="the largest number of points")
    parser.add_argument("--limit", type=float, default=60.0, help="seconds of a call that ends a contestant's growth")
    parser.add_argument("--only", action="append", help="operations whose names start with this")
    parser.add_argument("--output", type=Path, default=RESULTS, metavar="FILE", help="JSON file of the rows")
    options = parser.parse_args()
    limit_threads("cpu")
    run = continued(options.output, {"limit": options.limit})
    for name in SCENES:
        if name in run["rows"] or (options.only and not any(name.startswith(start) for start in options.only)):
            continue
        sizes = [size for size in SIZES if size <= options.largest]
        run["rows"][name] = grow(name, sizes, options.limit, run["about"]["machine"]["memory_gib"] * 2**30)
        write_json(options.output, run)
    return 0


if __name__ == "__main__":
    sys.exit(main())
