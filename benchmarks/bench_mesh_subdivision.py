"""One iteration of midpoint and of Loop subdivision of a closed mesh of 76k triangles, beside Open3D."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
from contest import POINTLOOM, Contestant, Operation, timed, waiting
from mesh_scenes import Arrays, in_open3d, in_pointloom, wavy_mesh
from reasons import CALL


def prepare_pointloom(method: str, scene: Arrays, device: str) -> Any:
    mesh = in_pointloom(scene, device)
    return waiting(lambda: getattr(mesh, method)(1), device, "warp")


def prepare_open3d(method: str, scene: Arrays, device: str) -> Any:
    mesh = in_open3d(scene)
    return lambda: getattr(mesh, method)(1)


def facts(mesh: Any) -> tuple[np.ndarray, np.ndarray]:
    return np.asarray(mesh.vertices), np.asarray(mesh.triangles)


def check(actual: tuple[np.ndarray, np.ndarray], reference: tuple[np.ndarray, np.ndarray], peer: str) -> None:
    """Check for the same triangles, and vertices equal to rounding of inputs and results."""
    np.testing.assert_array_equal(actual[1], reference[1], err_msg=peer)
    np.testing.assert_allclose(actual[0], reference[0], rtol=0, atol=1e-6 * np.abs(reference[0]).max(), err_msg=peer)


def subdivision(name: str, method: str) -> Operation:
    return Operation(
        name=name,
        scenes={"closed 1k": partial(wavy_mesh, 16), "closed 76k": partial(wavy_mesh, 128)},
        quick={"closed": partial(wavy_mesh, 24)},
        contestants=(
            Contestant(POINTLOOM, partial(prepare_pointloom, method), facts, ("cpu", "cuda")),
            Contestant("open3d-legacy", partial(prepare_open3d, method), facts),
        ),
        check=check,
    )


MESH_MIDPOINT = replace(
    subdivision("mesh_midpoint", "subdivide_midpoint"), targets={"closed 76k": 1}, reasons={"closed 1k": CALL}
)
MESH_LOOP = replace(subdivision("mesh_loop", "subdivide_loop"), targets={"closed 76k": 10})
OPERATIONS = (MESH_MIDPOINT, MESH_LOOP)


@timed(MESH_MIDPOINT)
def test_mesh_midpoint(time_lap) -> None:
    time_lap()


@timed(MESH_LOOP)
def test_mesh_loop(time_lap) -> None:
    time_lap()
