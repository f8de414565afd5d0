"""segment_plane with 1000 samples: a plane of 30 % of the points, clutter, and a nearly flat surface."""

from __future__ import annotations

from typing import Any

import numpy as np
import scenes
from contest import POINTLOOM, Contestant, Operation, load_open3d, timed, waiting

THRESHOLD = 0.01  # [m]
SAMPLES = 1000
PROBABILITY = 0.99999999  # Open3D's default: 30 % of inliers need 673 samples, so the search does not stop at once
FRACTIONS = (0.3, 0.3, 0.4)  # plane, clutter in a box around it, bumpy surface below it


def cluttered_plane(count: int, seed: int = 0) -> np.ndarray:
    """A tilted plane with 2 mm of noise in clutter above a bumpy surface, float64 [n, 3] in random order."""
    rng = np.random.default_rng(seed)
    sizes = [int(fraction * count) for fraction in FRACTIONS[:2]]
    x, y = rng.uniform(-2, 2, (2, sizes[0]))
    plane = np.stack([x, y, 1 + 0.2 * x - 0.1 * y + rng.normal(0, 0.002, sizes[0])], axis=1)
    clutter = rng.uniform((-2, -2, -0.5), (2, 2, 2), (sizes[1], 3))
    points = np.vstack([plane, clutter, scenes.bumpy_surface(count - sum(sizes), seed)])
    return rng.permutation(points).astype(np.float32).astype(np.float64)


def scene(count: int) -> Any:
    return lambda: cluttered_plane(count)


def prepare_pointloom(points: np.ndarray, device: str) -> Any:
    import pointloom as loom

    cloud = loom.PointCloud(points, device=device)
    return waiting(lambda: cloud.segment_plane(THRESHOLD, 3, SAMPLES, PROBABILITY), device, "warp")


def prepare_open3d(points: np.ndarray, device: str) -> Any:
    o3d = load_open3d()
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(points))

    def segment() -> Any:
        o3d.utility.random.seed(0)
        return cloud.segment_plane(THRESHOLD, 3, SAMPLES, PROBABILITY)

    return segment


def facts(result: Any) -> tuple[np.ndarray, int]:
    """Unit normal and number of inliers."""
    model, inliers = result
    normal = np.asarray(model)[:3]
    return normal / np.linalg.norm(normal), len(inliers)


def check(actual: Any, reference: Any, peer: str) -> None:
    """Check for the same plane: normals within a degree, and similar numbers of inliers; the samples differ."""
    assert abs(actual[0] @ reference[0]) > np.cos(np.radians(1)), f"the plane differs from {peer}'s"
    assert actual[1] > 0.95 * reference[1], f"{actual[1]} inliers, {peer} has {reference[1]}"


SEGMENT = Operation(
    name="segment_plane",
    scenes={"1k": scene(1000), "200k": scene(200_000), "1M": scene(1_000_000)},
    quick={"50k": scene(50_000)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, facts, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d, facts),
    ),
    check=check,
    memory_size="1M",
    targets={"200k": 5, "1M": 5},
)
OPERATIONS = (SEGMENT,)


@timed(SEGMENT)
def test_segment_plane(time_lap) -> None:
    time_lap()
