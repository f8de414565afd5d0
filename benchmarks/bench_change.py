"""M3C2 between two epochs of a bumpy surface, search structures included: normals of one radius, then cylinders.

py4dgeo's epochs are created for each call, so its trees are built in the timed region, as pointloom's are.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import scenes
from contest import POINTLOOM, Contestant, Operation, Trial, anew, thread_count, timed, waiting
from reasons import SPREAD

RAISED = 0.02  # [m] offset of half of the second epoch
ERROR = 0.001  # registration error [m]
Epochs = tuple[np.ndarray, np.ndarray, np.ndarray, float]


def epochs(count: int, cores: int) -> Any:
    """Two samplings of a surface, half of the second raised; core points of a third; a radius with about 30 points.

    py4dgeo may omit a point that is also a core point, so the core points are separate points.
    """

    def make() -> Epochs:
        first, second = (scenes.bumpy_surface(count, seed=seed) for seed in (0, 1))
        second[second[:, 0] > second[:, 0].mean(), 2] += RAISED
        span = np.ptp(first[:, :2], axis=0)
        radius = float(np.sqrt(30 * span.prod() / (np.pi * count)))
        return first, second, scenes.bumpy_surface(cores, seed=2), radius

    return make


def prepare_pointloom(scene: Epochs, device: str) -> Any:
    import pointloom as loom

    first, second, cores = (loom.PointCloud(points, device=device) for points in scene[:3])
    radius = scene[3]

    def measure(pair: Any) -> Any:
        return loom.m3c2(
            *pair, core_points=cores, normal_radii=radius, cylinder_radius=radius, max_distance=10 * radius,
            registration_error=ERROR,
        )  # fmt: skip

    return Trial(waiting(measure, device, "warp"), setup=lambda: (anew(first), anew(second)))


def prepare_py4dgeo(scene: Epochs, device: str) -> Any:
    import py4dgeo

    py4dgeo.set_num_threads(thread_count())
    first, second, cores, radius = scene

    def measure(pair: Any) -> Any:
        m3c2 = py4dgeo.M3C2(
            epochs=pair, corepoints=cores, normal_radii=[radius], cyl_radius=radius, max_distance=10 * radius,
            registration_error=ERROR,
        )  # fmt: skip
        return m3c2.run()

    return Trial(measure, setup=lambda: (py4dgeo.Epoch(first), py4dgeo.Epoch(second)))


def facts(result: Any) -> tuple[np.ndarray, np.ndarray]:
    """Distances and levels of detection of pointloom's result."""
    return result.distances, result.level_of_detection


def peer_facts(result: Any) -> tuple[np.ndarray, np.ndarray]:
    distances, uncertainties = result
    return np.asarray(distances), np.asarray(uncertainties["lodetection"])


def check(actual: Any, reference: Any, peer: str) -> None:
    """Check for equal distances and limits at nearly all core points; points on a cylinder's edge may differ."""
    for own, other, tolerance in zip(actual, reference, (1e-6, 1e-6), strict=True):
        assert (np.isfinite(own) == np.isfinite(other)).mean() > 0.999, f"{peer} has finite values at other points"
        near = np.abs(own - other) < tolerance
        assert near[np.isfinite(own) & np.isfinite(other)].mean() > 0.999, f"the distances differ from {peer}'s"


M3C2 = Operation(
    name="m3c2",
    scenes={"1k": epochs(1000, 1000), "200k": epochs(200_000, 200_000), "1M, 100k cores": epochs(1_000_000, 100_000)},
    quick={"50k": epochs(50_000, 10_000)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, facts, ("cpu", "cuda")),
        Contestant("py4dgeo", prepare_py4dgeo, peer_facts),
    ),
    check=check,
    memory_size="200k",
    targets={"200k": 10, "1M, 100k cores": 10},
    reasons={
        "1M, 100k cores": SPREAD.format(10.3),
        "200k": "Half of the time is tests of points against cylinders, half tests of boxes.",
    },
)
OPERATIONS = (M3C2,)


@timed(M3C2)
def test_m3c2(time_lap) -> None:
    time_lap()
