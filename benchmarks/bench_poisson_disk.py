"""sample_points_poisson_disk of a mesh of 76k triangles, initial random points included, beside Open3D."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
from contest import POINTLOOM, Contestant, Operation, timed, waiting
from mesh_scenes import Arrays, in_open3d, in_pointloom, wavy_mesh

Scene = tuple[Arrays, int]


def surface(count: int, cells: int = 128) -> Scene:
    """A mesh and the number of samples."""
    return wavy_mesh(cells), count


def prepare_pointloom(scene: Scene, device: str) -> Any:
    mesh = in_pointloom(scene[0], device)
    return waiting(lambda: mesh.sample_points_poisson_disk(scene[1]), device, "warp")


def prepare_open3d(scene: Scene, device: str) -> Any:
    mesh = in_open3d(scene[0])
    return lambda: mesh.sample_points_poisson_disk(scene[1])


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    """Check for the same number of points and similar distances between them."""
    from scipy.spatial import cKDTree

    assert len(actual) == len(reference)
    spacings = [cKDTree(points).query(points, k=2)[0][:, 1] for points in (actual, reference)]
    low, middle = (np.quantile(spacings[0], q) / np.quantile(spacings[1], q) for q in (0.01, 0.5))
    assert low > 0.97 and abs(middle - 1) < 0.03, f"{low:.3f} and {middle:.3f} of {peer}'s distances"


POISSON_DISK = Operation(
    name="poisson_disk",
    scenes={str(count): partial(surface, count) for count in (750, 3_000, 10_000, 100_000)},
    quick={"500": partial(surface, 500, 32)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, lambda cloud: cloud.points, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d, lambda cloud: np.asarray(cloud.points)),
    ),
    check=check,
    targets={"10000": 3, "100000": 3},
)
OPERATIONS = (POISSON_DISK,)


@timed(POISSON_DISK)
def test_poisson_disk(time_lap) -> None:
    time_lap()
