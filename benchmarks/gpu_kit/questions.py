"""Checks that need a real GPU, one line per result; a failing check does not stop the others.

python -m gpu_kit.questions STATE SECONDS
"""

from __future__ import annotations

import subprocess
import sys
import threading
import time
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from gpu_kit import device as devices
from gpu_kit.documents import keep_part

DEVICE = devices.NAME
SMALL = devices.is_dry()
BEGIN = time.time()
QUESTIONS: dict[str, Callable[[], Any]] = {}


def question(text: str) -> Callable[[Callable[[], Any]], Callable[[], Any]]:
    """Register a check."""

    def register(check: Callable[[], Any]) -> Callable[[], Any]:
        QUESTIONS[text] = check
        return check

    return register


def surface(count: int, seed: int, waves: float = 5.0) -> np.ndarray:
    """Points of a wavy surface."""
    rng = np.random.default_rng(seed)
    xy = rng.uniform(-1, 1, (500 if SMALL else count, 2))
    return np.column_stack([xy, 0.1 * np.sin(waves * xy[:, 0]) * np.cos(4 * xy[:, 1])]).astype(np.float32)


def pair(count: int = 20_000) -> tuple[Any, Any]:
    """Two clouds for ICP, with a translation between them."""
    import pointloom as loom

    points = surface(count, 0)
    target = loom.PointCloud(points, device=DEVICE).estimate_normals(max_nn=20)
    return loom.PointCloud(points + np.float32([0.01, 0.005, 0.0]), device=DEVICE), target


def icp(source: Any, target: Any) -> np.ndarray:
    from pointloom import registration

    method = registration.TransformationEstimationPointToPlane()
    return registration.registration_icp(source, target, 0.1, None, method).transformation


@question("what pointloom's doctor says")
def _() -> str:
    done = subprocess.run([sys.executable, "-m", "pointloom", "doctor"], capture_output=True, text=True, check=False)
    return f"\n{done.stdout}" if done.returncode == 0 else f"FAILED, exit {done.returncode}: {done.stdout}"


@question("which kernels compiled ahead are used")
def _() -> str:
    from pointloom.kernels.language import compiled_ahead

    return compiled_ahead.described()


@question("does a loop in a graph end where the device says: ICP")
def _() -> str:
    source, target = pair()
    T = icp(source, target)
    off, cpu = np.abs(T[:3, 3] + [0.01, 0.005, 0.0]).max(), icp(source.to("cpu"), target.to("cpu"))
    return f"the shift is off by {off:.1e} m, the CPU's pose is {np.abs(T - cpu).max():.1e} away"


@question("two threads of Python: ICP beside down-sampling")
def _() -> str:
    source, target = pair()
    poses: list[bytes] = []
    sizes: list[int] = []
    errors: list[str] = []
    rounds = 2 if SMALL else 40

    def guarded(work: Callable[[], None]) -> threading.Thread:
        def run() -> None:
            try:
                for _ in range(rounds):
                    work()
            except Exception as error:
                errors.append(f"{type(error).__name__}: {error}"[:200])

        return threading.Thread(target=run)

    threads = [
        guarded(lambda: poses.append(icp(source, target).tobytes())),
        guarded(lambda: sizes.append(len(target.voxel_down_sample(0.02).points))),
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    same = len(set(poses)) == 1 and len(set(sizes)) == 1 and len(poses) == len(sizes) == rounds
    return f"{'the same each time' if same else 'DIFFERENT RESULTS'}; errors: {errors[:2]}"


@question("torch on its default stream in another thread while graphs are recorded")
def _() -> str:
    try:
        import torch
    except ImportError:
        return "no torch here"
    if SMALL:
        return "not in a dry run: torch has no emulated device"
    source, target = pair(5_000)
    stop, errors, iterations = threading.Event(), [], 0

    def work() -> None:
        nonlocal iterations
        x = torch.zeros(1 << 20, device="cuda")
        try:
            while not stop.is_set():
                x += 1
                float(x[0])
                iterations += 1
        except Exception as error:
            errors.append(f"torch: {error}"[:300])

    thread = threading.Thread(target=work)
    thread.start()
    try:
        for _ in range(100):
            icp(source, target)
    except Exception as error:
        errors.append(f"pointloom: {type(error).__name__}: {error}"[:300])
    stop.set()
    thread.join()
    return f"{iterations} turns of torch; errors: {errors}"


def _calls(cloud: Any) -> dict[str, np.ndarray]:
    spacing = 0.2 if SMALL else 0.02
    normals = cloud.estimate_normals(max_nn=30)
    inliers, _ = cloud.remove_statistical_outlier(20, 2.0)
    return {
        "normals": np.asarray(normals.normals),
        "voxels": np.asarray(cloud.voxel_down_sample(0.03).points),
        "dbscan": np.asarray(cloud.cluster_dbscan(spacing, 8)),
        "outliers": np.asarray(inliers.points),
        "orientation": np.asarray(normals.orient_normals_consistent_tangent_plane(10).normals),
    }


@question("the same bits from run to run, at 300k points")
def _() -> str:
    import pointloom as loom

    points, rounds = surface(300_000, 1, 3.0), 2 if SMALL else 8
    results: dict[str, set[bytes]] = {}
    for _ in range(rounds):
        for name, value in _calls(loom.PointCloud(points, device=DEVICE)).items():
            results.setdefault(name, set()).add(value.tobytes())
    different = {name: len(values) for name, values in results.items() if len(values) > 1}
    return f"DIFFERENT: {different} of {rounds} runs" if different else f"yes, in {rounds} runs of {', '.join(results)}"


@question("the CPU's bits, at 50k points")
def _() -> dict[str, str]:
    import pointloom as loom

    points = surface(50_000, 2, 3.0)
    on_gpu, on_cpu = (_calls(loom.PointCloud(points, device=d)) for d in (DEVICE, "cpu"))
    comparison = {}
    for name, x in on_gpu.items():
        y = on_cpu[name]
        if x.shape != y.shape:
            comparison[name] = f"DIFFERENT SHAPES {x.shape} and {y.shape}"
        elif (x == y).all():
            comparison[name] = "the same"
        else:
            comparison[name] = f"up to {np.abs(x.astype(float) - y.astype(float)).max():.1e} apart"
    return comparison


@question("kernels that were compiled here")
def _() -> str:
    import warp as wp

    folder = wp.config.kernel_cache_dir
    made = [path.stem for path in Path(folder).rglob("*.cu") if path.stat().st_mtime > BEGIN] if folder else []
    return f"{len(made)}, of them {', '.join(made[:6])}" if made else "none"


def answer_to(name: str) -> Any:
    """The result of a check, or its error."""
    try:
        return QUESTIONS[name]()
    except Exception as error:
        traceback.print_exc(limit=4)
        return f"FAILED {type(error).__name__}: {str(error)[:400]}"


def main() -> int:
    """Run all checks."""
    state, end = Path(sys.argv[1]), time.monotonic() + float(sys.argv[2])
    device = devices.start()
    print(f"{device.name}, sm_{device.architecture}, {device.processors} SMs, {device.memory_gib} GiB, driver")
    print(f"  {device.driver}, toolkit {device.toolkit}")
    results: dict[str, Any] = {}
    for name in QUESTIONS:
        if time.monotonic() > end:
            print(f"no time left before: {name}")
            break
        print(f"-- {name}", file=sys.stderr, flush=True)  # between the driver's own messages
        start = time.monotonic()
        results[name] = answer_to(name)
        print(f"{name}: {results[name]}   [{time.monotonic() - start:.1f} s]", flush=True)
        keep_part(state, device, "questions", results)
    return 1 if any(str(check).startswith("FAILED") for check in results.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
