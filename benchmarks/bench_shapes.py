"""The sphere and the cylinder with the most points among a third of outliers, 5 mm of noise, normals included.

pyransac3d uses no normals, scores all of its samples, fits none of them and tells nothing of how sure a shape is; it
runs on one core. Ours makes normals, stops when a better sample is unlikely, fits the best in least squares and asks
what else may explain the points.
"""

from __future__ import annotations

import random
from typing import Any

import numpy as np
from contest import OURS, Contestant, Operation, timed, waiting

NOISE, THRESHOLD = 0.005, 0.0125  # [m]
OUTLIERS = 1 / 3
SAMPLES = 1000  # pyransac3d's default
NORMAL_ANGLE = 25.0  # [degrees]


def scene(kind: str, count: int, seed: int = 0) -> Any:
    """Points of a shape of one metre amid others in a box about it, float64 [n, 3] in random order."""

    def make() -> tuple[str, np.ndarray]:
        rng = np.random.default_rng(seed)
        on = count - int(OUTLIERS * count)
        if kind == "sphere":
            points = rng.normal(size=(on, 3))
            points /= np.linalg.norm(points, axis=1)[:, None]
        else:
            turn = rng.uniform(0, 2 * np.pi, on)
            points = np.column_stack([np.cos(turn), np.sin(turn), rng.uniform(-1.5, 1.5, on)])
        points += NOISE * rng.normal(size=points.shape)
        return kind, rng.permutation(np.vstack([points, rng.uniform(-1.5, 1.5, (count - on, 3))]))

    return make


def prepare_pointloom(made: tuple[str, np.ndarray], device: str) -> Any:
    import pointloom as loom

    kind, points = made
    neighbors = 20 if len(points) < 100_000 else 80  # as many as span something against the noise

    def find() -> Any:
        cloud = loom.PointCloud(points, device=device).estimate_normals(max_nn=neighbors)
        return getattr(cloud, f"segment_{kind}")(THRESHOLD, NORMAL_ANGLE)

    return waiting(find, device, "warp")


def prepare_pyransac3d(made: tuple[str, np.ndarray], device: str) -> Any:
    import pyransac3d

    kind, points = made

    def find() -> Any:
        random.seed(0)
        np.random.seed(0)  # it draws from the global one
        return getattr(pyransac3d, kind.capitalize())().fit(points, THRESHOLD, SAMPLES)

    return find


def facts(found: Any) -> tuple[float, int]:
    """The radius and how many inliers."""
    shape, rows = found
    return shape.radius, len(rows)


def check(ours: tuple[float, int], theirs: tuple[float, int], peer: str) -> None:
    """Ours is within a twentieth of the noise of the true metre and has no fewer points; theirs is of samples alone."""
    assert abs(ours[0] - 1) < NOISE / 20, f"a radius of {ours[0]:.5f} m, {peer} has {theirs[0]:.5f}"
    assert ours[1] > 0.95 * theirs[1], f"{ours[1]} inliers, {peer} has {theirs[1]}"


def operation(kind: str) -> Operation:
    """Finding one kind."""
    sizes = {"15k": 15_000, "150k": 150_000}
    return Operation(
        name=f"segment_{kind}",
        scenes={name: scene(kind, count) for name, count in sizes.items()},
        quick={"15k": scene(kind, 15_000)},
        contestants=(
            Contestant(OURS, prepare_pointloom, facts, ("cpu", "cuda")),
            Contestant("pyransac3d", prepare_pyransac3d, lambda found: (float(found[-2]), len(found[-1]))),
        ),
        check=check,
    )


SPHERE, CYLINDER = operation("sphere"), operation("cylinder")
OPERATIONS = (SPHERE, CYLINDER)


@timed(SPHERE)
def test_segment_sphere(turn) -> None:
    turn()


@timed(CYLINDER)
def test_segment_cylinder(turn) -> None:
    turn()
