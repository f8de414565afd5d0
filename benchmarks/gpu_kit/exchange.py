"""Arrays of other libraries on a real GPU, and operations in the caller's CUDA graph.

    python -m gpu_kit.exchange STATE SECONDS

The tests of array libraries run with torch, CuPy and JAX if installed. An operation is captured on the caller's stream
by Warp, and by torch if it has a GPU, replayed twice, and its result compared bitwise with that of a plain call.
"""

from __future__ import annotations

import importlib.util
import sys
import time
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from gpu_kit import device as devices
from gpu_kit.documents import keep_part
from gpu_kit.suite import DRY_TESTS, failures, run, summary

TESTS = ["tests/core/test_array_libraries.py"]
SIZE, REPLAYS = (200_000, 2) if not devices.is_dry() else (1000, 2)
CAPTURE_SECONDS = 12.0  # kept for the captures
Captured = Callable[[Callable[[], Any]], Callable[[], Any]]


def calls() -> dict[str, Callable[[], Any]]:
    """Operations that need no wait of the host, on points of the caller."""
    import warp as wp
    from gpu_operation import surface_of

    import pointloom as loom

    points = wp.array(surface_of(SIZE), dtype=wp.vec3, device=devices.NAME)
    cloud = loom.PointCloud(points, frozen=True)
    search = loom.NearestNeighborSearch(cloud)
    return {
        "normals": lambda: cloud.estimate_normals(max_nn=30).array("normals"),
        "knn": lambda: search.knn_search(cloud, 20)[1],
        "distances": lambda: cloud.compute_nearest_neighbor_distance(),
    }


def by_warp(call: Callable[[], Any]) -> Callable[[], Any]:
    """Capture a call on a stream of Warp; returns the replay."""
    import warp as wp

    stream = wp.Stream(devices.NAME)
    with wp.ScopedStream(stream), wp.ScopedCapture(stream=stream, force_module_load=False) as capture:
        result = call()

    def replay() -> Any:
        with wp.ScopedStream(stream):
            wp.capture_launch(capture.graph)
        wp.synchronize_device(devices.NAME)
        return result

    return replay


def by_torch(call: Callable[[], Any]) -> Callable[[], Any]:
    """Capture a call in torch's graph; returns the replay."""
    import torch
    import warp as wp

    graph, stream = torch.cuda.CUDAGraph(), torch.cuda.Stream()
    own = wp.stream_from_torch(stream)
    torch.cuda.synchronize()
    recorded = wp.ScopedCapture(stream=own, force_module_load=False, external=True)
    with torch.cuda.graph(graph, stream=stream), wp.ScopedStream(own), recorded:
        result = call()

    def replay() -> Any:
        graph.replay()
        torch.cuda.synchronize()
        return result

    return replay


def captured(call: Callable[[], Any], capture: Captured) -> str:
    """Whether the replayed call has the bitwise result of a plain one, or the error."""
    import warp as wp

    try:
        expected = call().numpy()
        wp.synchronize_device(devices.NAME)
        replay = capture(call)
        for _ in range(REPLAYS):
            result = replay()
            if not np.array_equal(result.numpy(), expected, equal_nan=True):
                return "DIFFERENT RESULT"
            result.zero_()  # so that the next replay has to write it
    except Exception as error:
        traceback.print_exc(limit=6)
        return f"FAILED {type(error).__name__}: {str(error)[:300]}"
    return "the same result"


def libraries() -> list[str]:
    """Libraries that can have arrays on this device."""
    names = [name for name in ("torch", "cupy", "jax") if importlib.util.find_spec(name)]
    return [] if devices.is_dry() else names


def main() -> int:
    """Run the captures, then the tests."""
    state, end = Path(sys.argv[1]), time.monotonic() + float(sys.argv[2])
    device = devices.start()
    results: dict[str, Any] = {"libraries": libraries(), "captures": {}}
    ways: dict[str, Captured] = {"Warp": by_warp}
    if "torch" in results["libraries"]:
        ways["torch"] = by_torch
    for way, capture in ways.items():
        for name, call in calls().items():
            results["captures"][f"{name} by {way}"] = outcome = captured(call, capture)
            print(f"{name} captured by {way}: {outcome}", flush=True)
    keep_part(state, device, "exchange", results)
    tests = DRY_TESTS if devices.is_dry() else TESTS
    ran = run(tests, end - time.monotonic() - 3, state, "exchange")
    failed, lacking = failures(state, "exchange")
    results |= {"tests": summary(ran), "failed": failed, "lacking": lacking}
    print(f"tests of arrays: {results['tests']}; failed: {', '.join(failed) or 'none'}")
    keep_part(state, device, "exchange", results)
    return 1 if failed or any(outcome != "the same result" for outcome in results["captures"].values()) else 0


if __name__ == "__main__":
    sys.exit(main())
