"""The sphere or cylinder with the most inliers, with a third outliers and 5 mm of noise, normals included.

pyransac3d uses no normals, scores all of its samples, does no refinement and gives no uncertainty; it runs on one core.
pointloom estimates normals, stops when a better sample is unlikely, refines the best by least squares and tests
alternative explanations of the points.
"""

from __future__ import annotations

import random
from dataclasses import replace
from typing import Any

import numpy as np
from contest import POINTLOOM, Contestant, Operation, timed, waiting

NOISE, THRESHOLD = 0.005, 0.0125  # [m]
OUTLIERS = 1 / 3
SAMPLES = 1000  # pyransac3d's default
NORMAL_ANGLE = 25.0  # [degrees]


def scene(kind: str, count: int, seed: int = 0) -> Any:
    """Points of a shape of 1 m among others in a box around it, float64 [n, 3] in random order."""

    def make() -> tuple[str, np.ndarray]:
        rng = np.random.default_rng(seed)
        on = count - int(OUTLIERS * count)
        if kind == "sphere":
            points = rng.normal(size=(on, 3))
            points /= np.linalg.norm(points, axis=1)[:, None]
        else:
            angles = rng.uniform(0, 2 * np.pi, on)
            points = np.column_stack([np.cos(angles), np.sin(angles), rng.uniform(-1.5, 1.5, on)])
        points += NOISE * rng.normal(size=points.shape)
        return kind, rng.permutation(np.vstack([points, rng.uniform(-1.5, 1.5, (count - on, 3))]))

    return make


def prepare_pointloom(scene: tuple[str, np.ndarray], device: str) -> Any:
    import pointloom as loom

    kind, points = scene
    neighbors = 20 if len(points) < 100_000 else 80  # enough to cover an extent larger than the noise

    def find() -> Any:
        cloud = loom.PointCloud(points, device=device).estimate_normals(max_nn=neighbors)
        return cloud.segment_shape(kind, THRESHOLD, NORMAL_ANGLE)

    return waiting(find, device, "warp")


def prepare_pyransac3d(scene: tuple[str, np.ndarray], device: str) -> Any:
    import pyransac3d

    kind, points = scene

    def find() -> Any:
        random.seed(0)
        np.random.seed(0)  # it uses NumPy's global generator
        return getattr(pyransac3d, kind.capitalize())().fit(points, THRESHOLD, SAMPLES)

    return find


def facts(result: Any) -> tuple[float, int]:
    """Radius and number of inliers."""
    shape, rows = result
    return shape.radius, len(rows)


def check(actual: tuple[float, int], reference: tuple[float, int], peer: str) -> None:
    """Check that pointloom's radius is within a twentieth of the noise and that it has no fewer inliers; the baseline
    is not refined.
    """
    assert abs(actual[0] - 1) < NOISE / 20, f"the radius is {actual[0]:.5f} m, {reference[0]:.5f} for {peer}"
    assert actual[1] > 0.95 * reference[1], f"{actual[1]} inliers, {peer} has {reference[1]}"


def operation(kind: str) -> Operation:
    """The operation for one kind of shape."""
    sizes = {"15k": 15_000, "150k": 150_000}
    return Operation(
        name=f"segment_{kind}",
        scenes={name: scene(kind, count) for name, count in sizes.items()},
        quick={"15k": scene(kind, 15_000)},
        contestants=(
            Contestant(POINTLOOM, prepare_pointloom, facts, ("cpu", "cuda")),
            Contestant("pyransac3d", prepare_pyransac3d, lambda result: (float(result[-2]), len(result[-1]))),
        ),
        check=check,
        long=("150k",),
    )


SPHERE = replace(
    operation("sphere"),
    targets={"15k": 20, "150k": 20},
    reasons=dict.fromkeys(
        ["15k", "150k"], ("The result is refined, with normals and uncertainty; pyransac3d stops after the samples.")
    ),
)
CYLINDER = replace(operation("cylinder"), targets={"15k": 20, "150k": 20})
OPERATIONS = (SPHERE, CYLINDER)


@timed(SPHERE)
def test_segment_sphere(time_lap) -> None:
    time_lap()


@timed(CYLINDER)
def test_segment_cylinder(time_lap) -> None:
    time_lap()
