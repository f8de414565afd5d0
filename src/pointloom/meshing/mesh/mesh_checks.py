"""Checks of a mesh's corners and of vertex indices."""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_numeric
from ...core.exchange import on_host
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


def check_vertices(name: str, values: object, count: int) -> NDArray[np.int32]:
    """Vertex indices as int32 (n,), n >= 1, each in 0..count-1."""
    numbers = check_numeric(name, on_host(name, values))
    if numbers.ndim != 1:
        raise ValueError(f"{name}: expected shape [n], got {list(numbers.shape)}")
    if not numbers.size:
        raise ValueError(f"{name}: expected at least one vertex, got none")
    if numbers.dtype.kind not in "iu":
        raise TypeError(f"{name}: expected whole numbers, got {numbers.dtype}")
    wrong = (numbers < 0) | (numbers >= count)
    if wrong.any():
        raise ValueError(f"{name}: expected vertex indices from 0 to {count - 1}, got {numbers[wrong][0]}")
    return numbers.astype(np.int32)


def check_finite_vertices(name: str, numbers: NDArray[np.int32], positions: object) -> None:
    """Raise ValueError if a vertex (vec3 device array) is not finite."""
    lost = ~np.isfinite(download(positions).reshape(-1, 3)).all(axis=1)
    if lost.any():
        raise ValueError(f"{name}: vertex {numbers[lost][0]} is NaN or infinite. Leave it out")
