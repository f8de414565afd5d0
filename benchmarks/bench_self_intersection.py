"""Self-intersections of a closed mesh of 76k triangles, beside Open3D, which tests all pairs."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
from contest import POINTLOOM, Contestant, Operation, timed
from mesh_scenes import Arrays, in_open3d, in_pointloom, wavy_mesh
from reasons import CALL


def prepare_pointloom(scene: Arrays, device: str) -> Any:
    return in_pointloom(scene, device).get_self_intersecting_triangles  # the result is on the host


def prepare_open3d(scene: Arrays, device: str) -> Any:
    return in_open3d(scene).get_self_intersecting_triangles


def facts(pairs: Any) -> np.ndarray:
    return np.sort(np.asarray(pairs).reshape(-1, 2), axis=1)


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    """Check for the same pairs, except for a few that are closer than Open3D's tolerance."""
    own_pairs, reported = ({tuple(pair) for pair in pairs.tolist()} for pairs in (actual, reference))
    assert own_pairs <= reported and len(reported - own_pairs) <= 10, peer


SELF_INTERSECTION = Operation(
    name="self_intersection",
    scenes={"closed 1k": partial(wavy_mesh, 16), "closed 76k": partial(wavy_mesh, 128)},
    quick={"closed": partial(wavy_mesh, 24)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, facts, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d, facts),
    ),
    check=check,
    targets={"closed 76k": 10},
    reasons={"closed 1k": CALL},
)
OPERATIONS = (SELF_INTERSECTION,)


@timed(SELF_INTERSECTION)
def test_self_intersection(time_lap) -> None:
    time_lap()
