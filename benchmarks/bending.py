"""Coherent point drift beside pycpd and a deformation graph: run times and errors.

    python benchmarks/bending.py                 # 500 to 2,000 points, fifty iterations each (a minute)
    python benchmarks/bending.py --sizes 10000 --steps 5

pycpd is not a dependency: `pip install pycpd`. It stores all pairs: about 1 GB per thousand points at 10,000.
"""

from __future__ import annotations

import argparse
import time
from typing import Any

import numpy as np

import pointloom as loom

Array = np.ndarray
reg = loom.registration
OUTLIERS, WIDTH, STIFFNESS = 0.1, 2.0, 3.0


def body(count: int, seed: int) -> Array:
    """Points on a flattened sphere with bumps."""
    v = np.random.default_rng(seed).normal(size=(count, 3))
    v /= np.linalg.norm(v, axis=1)[:, None]
    size = 1 + 0.15 * np.sin(3 * v[:, :1]) * np.cos(2 * v[:, 1:2]) + 0.1 * np.sin(4 * v[:, 2:] + 1)
    return v * size * [1, 0.8, 0.6]


def moved(points: Array, kind: str) -> Array:
    """Points rotated and scaled, or bent by up to 0.2."""
    if kind != "deformable":
        c, s = np.cos(0.5), np.sin(0.5)
        return 1.3 * points @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]).T + [0.2, 0.1, 0.0]
    x, y, z = points.T
    return points + 0.12 * np.column_stack([np.sin(1.5 * y), np.sin(1.3 * z + 0.4), np.cos(1.2 * x) - 1])


def peer(source: Array, target: Array, kind: str, steps: int) -> tuple[float, Array]:
    """Run time of pycpd and the moved source."""
    import pycpd

    center = source.mean(axis=0)
    radius = np.sqrt(((source - center) ** 2).sum(axis=1).mean())
    field: dict[str, Any] = {"alpha": STIFFNESS, "beta": WIDTH} if kind == "deformable" else {}
    method = getattr(pycpd, f"{kind.capitalize()}Registration")
    given = {"X": (target - center) / radius, "Y": (source - center) / radius, "w": OUTLIERS}
    start = time.perf_counter()
    registration = method(**given, max_iterations=steps, tolerance=0, **field)
    registration.register()
    return time.perf_counter() - start, registration.TY * radius + center


def main() -> None:
    """Print a row for each size and kind."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sizes", type=int, nargs="+", default=[500, 1000, 2000])
    parser.add_argument("--steps", type=int, default=50)
    parser.add_argument("--kinds", nargs="+", default=["rigid", "affine", "deformable"])
    parser.add_argument("--alone", action="store_true", help="without pycpd")
    options = parser.parse_args()
    drift: dict[str, Any] = {"outliers": OUTLIERS, "width": WIDTH, "stiffness": STIFFNESS, "tolerance": 1e-300}
    print("| kind | points | pointloom [s] | pycpd [s] | ratio | difference | error | error of a deformation graph |")
    print("|---|---|---|---|---|---|---|---|")
    for kind in options.kinds:
        for count in options.sizes:
            source, target = body(count, 0), moved(body(count, 1), kind)
            clouds = loom.PointCloud(source), loom.PointCloud(target)
            reg.coherent_point_drift(*clouds, kind=kind, max_iterations=1, **drift)  # compiles
            start = time.perf_counter()
            result = reg.coherent_point_drift(*clouds, kind=kind, max_iterations=options.steps, **drift)
            seconds = time.perf_counter() - start
            baseline_seconds, baseline_points = (
                (np.nan, np.nan) if options.alone else peer(source, target, kind, options.steps)
            )
            difference, truth = np.abs(result.warped.points - baseline_points).max(), moved(source, kind)
            error = np.median(np.linalg.norm(result.warped.points - truth, axis=1))
            graph = np.nan
            if kind == "deformable":
                bent = reg.register_nonrigid(*clouds).warped.points
                graph = np.median(np.linalg.norm(bent - truth, axis=1))
            ratio = baseline_seconds / seconds
            row = f"{seconds:.2f} | {baseline_seconds:.2f} | {ratio:.1f} | {difference:.1e} | {error:.4f} | {graph:.4f}"
            print(f"| {kind} | {count} | {row} |", flush=True)


if __name__ == "__main__":
    main()
