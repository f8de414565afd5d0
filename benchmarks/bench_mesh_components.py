"""cluster_connected_triangles of a closed mesh of 76k triangles and of one of 10,000 parts, beside Open3D."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
from contest import POINTLOOM, Contestant, Operation, timed
from mesh_scenes import Arrays, in_open3d, in_pointloom, torn_mesh, wavy_mesh
from reasons import CALL


def prepare_pointloom(scene: Arrays, device: str) -> Any:
    mesh = in_pointloom(scene, device)
    return mesh.cluster_connected_triangles  # the result is on the host


def prepare_open3d(scene: Arrays, device: str) -> Any:
    return in_open3d(scene).cluster_connected_triangles


def facts(parts: Any) -> tuple[np.ndarray, ...]:
    return tuple(np.asarray(values) for values in parts)


def check(actual: tuple[np.ndarray, ...], reference: tuple[np.ndarray, ...], peer: str) -> None:
    """Check for the same labels and counts, and areas equal to rounding."""
    for own, other in zip(actual[:2], reference[:2], strict=True):
        np.testing.assert_array_equal(own, other, err_msg=peer)
    np.testing.assert_allclose(actual[2], reference[2], rtol=1e-5, err_msg=peer)


MESH_COMPONENTS = Operation(
    name="mesh_components",
    scenes={
        "closed 1k": partial(wavy_mesh, 16),
        "closed 76k": partial(wavy_mesh, 128),
        "torn 38k": partial(torn_mesh, 128),
    },
    quick={"torn": partial(torn_mesh, 24)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, facts, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d, facts),
    ),
    check=check,
    targets={"closed 76k": 5},
    reasons={"closed 1k": CALL},
)
OPERATIONS = (MESH_COMPONENTS,)


@timed(MESH_COMPONENTS)
def test_mesh_components(time_lap) -> None:
    time_lap()
