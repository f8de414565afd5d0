"""Triangles of a mesh that meet, of a closed mesh of 76k triangles, beside Open3D, which tests all pairs."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
from contest import OURS, Contestant, Operation, timed
from mesh_scenes import Arrays, in_open3d, in_pointloom, wavy_mesh


def prepare_pointloom(scene: Arrays, device: str) -> Any:
    return in_pointloom(scene, device).get_self_intersecting_triangles  # what it returns is on the host


def prepare_open3d(scene: Arrays, device: str) -> Any:
    return in_open3d(scene).get_self_intersecting_triangles


def facts(pairs: Any) -> np.ndarray:
    return np.sort(np.asarray(pairs).reshape(-1, 2), axis=1)


def check(ours: np.ndarray, theirs: np.ndarray, peer: str) -> None:
    """Much the same number: Open3D rounds what touches."""
    assert abs(len(ours) - len(theirs)) <= 0.01 * max(100, len(theirs)), peer


SELF_INTERSECTION = Operation(
    name="self_intersection",
    scenes={"closed 76k": partial(wavy_mesh, 128)},
    quick={"closed": partial(wavy_mesh, 24)},
    contestants=(
        Contestant(OURS, prepare_pointloom, facts, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d, facts),
    ),
    check=check,
)
OPERATIONS = (SELF_INTERSECTION,)


@timed(SELF_INTERSECTION)
def test_self_intersection(turn) -> None:
    turn()
