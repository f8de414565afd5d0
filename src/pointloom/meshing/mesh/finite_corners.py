"""Check that all corners of a mesh's triangles are finite."""

from __future__ import annotations

from typing import Protocol

import numpy as np

from ...kernels.arrays.select import gather_rows, positions_of
from ...kernels.memory import download
from ...kernels.meshes.clean_triangles import mask_not_finite
from .mesh_store import MeshStore

REMEDY = "repair() removes such triangles"


class Stored(Protocol):
    """A mesh."""

    arrays: MeshStore


def find_wrong_corner(mesh: Stored) -> str | None:
    """First triangle with a corner that is not finite, as a clause. None if there is none."""
    vertices, triangles = mesh.arrays["vertices"], mesh.arrays["triangles"]
    if vertices.device.is_cpu and np.isfinite(download(vertices)).all():
        return None
    rows = positions_of(mask_not_finite(vertices, triangles))  # sync
    if not rows.size:
        return None
    corners = download(gather_rows(triangles, rows[:1])).reshape(3)
    corner_positions = download(vertices).reshape(-1, 3)[corners]
    lost = corners[~np.isfinite(corner_positions).all(axis=1)][0]
    return f"triangle {int(download(rows[:1])[0])} has the vertex {lost}, which is NaN or infinite"


def check_finite_corners(operation: str, mesh: Stored) -> None:
    """Raise ValueError if a triangle has a corner that is not finite. Unused vertices are not checked."""
    fault = find_wrong_corner(mesh)
    if fault is not None:
        raise ValueError(f"{operation}: expected triangles with finite corners, but {fault}; {REMEDY}")
