"""Ten iterations of Taubin smoothing of a closed mesh of 76k triangles, beside Open3D."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
from contest import POINTLOOM, Contestant, Operation, timed, waiting
from mesh_scenes import Arrays, in_open3d, in_pointloom, wavy_mesh
from reasons import CALL

ITERATIONS = 10


def prepare_pointloom(scene: Arrays, device: str) -> Any:
    mesh = in_pointloom(scene, device)
    return waiting(lambda: mesh.filter_smooth_taubin(ITERATIONS), device, "warp")


def prepare_open3d(scene: Arrays, device: str) -> Any:
    mesh = in_open3d(scene)
    return lambda: mesh.filter_smooth_taubin(ITERATIONS)


def facts(mesh: Any) -> np.ndarray:
    return np.asarray(mesh.vertices)


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    """Check for the same vertices, to rounding of inputs and results."""
    np.testing.assert_allclose(actual, reference, rtol=0, atol=1e-6 * np.abs(reference).max(), err_msg=peer)


MESH_TAUBIN = Operation(
    name="mesh_taubin",
    scenes={"closed 1k": partial(wavy_mesh, 16), "closed 76k": partial(wavy_mesh, 128)},
    quick={"closed": partial(wavy_mesh, 24)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, facts, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d, facts),
    ),
    check=check,
    targets={"closed 76k": 3},
    reasons={
        "closed 1k": CALL,
        "closed 76k": "Two thirds are 5 ns a neighbor, with a root and a division, a fifth sorts edges.",
    },
)
OPERATIONS = (MESH_TAUBIN,)


@timed(MESH_TAUBIN)
def test_mesh_taubin(time_lap) -> None:
    time_lap()
