"""coherent_point_drift beside pycpd: a body of 2,000 and 10,000 points, rotated or bent, the same iterations in both.

pycpd stores a row of all targets for each source in several float64 arrays, and solves a system of all sources for a
deformation. So few iterations are timed at 10,000 points. They are pointloom's slowest ones: later iterations only use
near points.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from bending import OUTLIERS, STIFFNESS, WIDTH, body, moved
from contest import POINTLOOM, Contestant, Operation, timed

APART = 2e-6  # of the body's size: pointloom rounds sources and results to float32


@dataclass(frozen=True)
class Drifting:
    """A body, its target, the type of motion, and the number of iterations."""

    source: np.ndarray
    target: np.ndarray
    kind: str
    steps: int


def drifting(count: int, kind: str, steps: int) -> Callable[[], Drifting]:
    return functools.partial(_drifting, count, kind, steps)


def _drifting(count: int, kind: str, steps: int) -> Drifting:
    return Drifting(body(count, 0), moved(body(count, 1), kind), kind, steps)


def prepare_pointloom(scene: Drifting, device: str) -> Callable[[], Any]:
    import pointloom as loom

    source, target = (loom.PointCloud(points, device=device) for points in (scene.source, scene.target))
    options: dict[str, Any] = {"outliers": OUTLIERS, "width": WIDTH, "stiffness": STIFFNESS, "tolerance": 1e-300}
    drift = loom.registration.coherent_point_drift
    return lambda: drift(source, target, kind=scene.kind, max_iterations=scene.steps, **options).warped.points


def prepare_pycpd(scene: Drifting, device: str) -> Callable[[], Any]:
    import pycpd

    center = scene.source.mean(axis=0)
    radius = np.sqrt(((scene.source - center) ** 2).sum(axis=1).mean())
    field: dict[str, Any] = {"alpha": STIFFNESS, "beta": WIDTH} if scene.kind == "deformable" else {}
    method = getattr(pycpd, f"{scene.kind.capitalize()}Registration")
    given = {"X": (scene.target - center) / radius, "Y": (scene.source - center) / radius, "w": OUTLIERS}

    def call() -> np.ndarray:
        registration = method(**given, max_iterations=scene.steps, tolerance=0, **field)
        registration.register()
        return registration.TY * radius + center

    return call


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    np.testing.assert_allclose(actual, reference, rtol=0, atol=APART, err_msg=f"the points differ from {peer}'s")


CONTESTANTS = (
    Contestant(POINTLOOM, prepare_pointloom, np.asarray, ("cpu", "cuda")),
    Contestant("pycpd", prepare_pycpd, np.asarray),
)
RIGID = Operation(
    name="drift_rigid",
    scenes={"2k, 10 steps": drifting(2000, "rigid", 10), "10k, 3 steps": drifting(10_000, "rigid", 3)},
    quick={"300, 10 steps": drifting(300, "rigid", 10)},
    contestants=CONTESTANTS,
    check=check,
    memory_size="2k, 10 steps",
    targets={"10k, 3 steps": 20},
)
DEFORMABLE = Operation(
    name="drift_deformable",
    scenes={"2k, 10 steps": drifting(2000, "deformable", 10), "10k, 2 steps": drifting(10_000, "deformable", 2)},
    quick={"300, 10 steps": drifting(300, "deformable", 10)},
    contestants=CONTESTANTS,
    check=check,
    memory_size="2k, 10 steps",
    targets={"10k, 2 steps": 20},
)
OPERATIONS = (RIGID, DEFORMABLE)


@timed(RIGID)
def test_drift_rigid(time_lap) -> None:
    time_lap()


@timed(DEFORMABLE)
def test_drift_deformable(time_lap) -> None:
    time_lap()
