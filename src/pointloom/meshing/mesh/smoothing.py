"""Smoothing, sharpening and deformation of a mesh."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_count, check_finite, check_number, check_positive, check_rows, shown
from ...core.exchange import on_host
from ...kernels.algebra.transform import narrow_rows, widen_rows
from ...kernels.arrays.select import gather_rows
from ...kernels.lang import int32, vec3d
from ...kernels.memory import download, upload
from ...kernels.remeshing.mesh_filters import approach_mean_kernel, average_kernel, filter_values, sharpen_kernel
from ...kernels.remeshing.rigid_deformation import deform_rigidly, rotate_directions
from ...kernels.remeshing.vertex_values import narrow_directions
from .measures import finite_area
from .mesh_arrays import Mesh
from .mesh_checks import check_finite_vertices, check_vertices
from .mesh_store import PER_VERTEX
from .value_transfer import sew

MAX_PASSES = 10_000
SCOPES = {"all": tuple(PER_VERTEX), "vertex": ("vertices",), "normal": ("vertex_normals",), "color": ("vertex_colors",)}
MAX_DEFORM_ITERATIONS = 10_000
ENERGIES = ("spokes", "smoothed")


def filter_smooth_simple(mesh: Mesh, number_of_iterations: int, filter_scope: object) -> Mesh:
    """As `TriangleMesh.filter_smooth_simple`."""
    return _filtered(mesh, [(average_kernel, 0.0)], number_of_iterations, filter_scope)


def filter_smooth_laplacian(mesh: Mesh, number_of_iterations: int, lambda_filter: float, filter_scope: object) -> Mesh:
    """As `TriangleMesh.filter_smooth_laplacian`."""
    factor = check_number("lambda_filter", lambda_filter)
    return _filtered(mesh, [(approach_mean_kernel, factor)], number_of_iterations, filter_scope)


def filter_smooth_taubin(
    mesh: Mesh, number_of_iterations: int, lambda_filter: float, mu: float, filter_scope: object
) -> Mesh:
    """As `TriangleMesh.filter_smooth_taubin`."""
    factors = (check_number("lambda_filter", lambda_filter), check_number("mu", mu))
    return _filtered(mesh, [(approach_mean_kernel, f) for f in factors], number_of_iterations, filter_scope)


def filter_sharpen(mesh: Mesh, number_of_iterations: int, strength: float, filter_scope: object) -> Mesh:
    """As `TriangleMesh.filter_sharpen`."""
    factor = check_number("strength", strength)
    return _filtered(mesh, [(sharpen_kernel, factor)], number_of_iterations, filter_scope)


def deform_as_rigid_as_possible(
    mesh: Mesh,
    constraint_vertex_indices: ArrayLike,
    constraint_vertex_positions: ArrayLike,
    max_iter: int,
    energy: object,
    smoothed_alpha: float,
) -> Mesh:
    """As `TriangleMesh.deform_as_rigid_as_possible`."""
    count = mesh.arrays["vertices"].size
    fixed = check_vertices("constraint_vertex_indices", constraint_vertex_indices, count)
    positions = on_host("constraint_vertex_positions", constraint_vertex_positions)
    targets = check_rows("constraint_vertex_positions", positions, 3, dtype=np.float64)
    if len(targets) != len(fixed):
        raise ValueError(
            f"constraint_vertex_positions: expected shape [{len(fixed)}, 3], one row per constrained vertex, got "
            f"{list(targets.shape)}"
        )
    check_finite("constraint_vertex_positions", targets)
    numbers, repeats = np.unique(fixed, return_counts=True)
    if len(numbers) < len(fixed):
        raise ValueError(
            f"constraint_vertex_indices: vertex {numbers[repeats > 1][0]} is duplicated. Pass each vertex once"
        )
    reason = "vertices no longer move after that"
    iterations = check_count("max_iter", max_iter, minimum=0, maximum=MAX_DEFORM_ITERATIONS, because=reason)
    alpha = check_positive("smoothed_alpha", smoothed_alpha, allow_zero=True)
    likeness = alpha * finite_area(mesh) if _energy_of(energy) == "smoothed" else 0.0
    if iterations == 0:
        return mesh.with_arrays()
    rows = upload(fixed, int32, mesh.device)
    check_finite_vertices("constraint_vertex_indices", fixed, gather_rows(mesh.arrays["vertices"], rows))
    sewn = sew(mesh)
    if sewn.sewn_indices is not None:
        fixed, targets = _once(fixed, download(gather_rows(sewn.sewn_indices, rows)), targets)  # sync
        rows = upload(fixed, int32, mesh.device)
    positions, arrays = upload(targets - mesh.arrays.origin, vec3d, mesh.device), sewn.mesh.arrays
    moved, rotations = deform_rigidly(arrays["vertices"], arrays["triangles"], rows, positions, iterations, likeness)
    deformed: dict[str, Any] = {"vertices": sewn.spread(narrow_rows(moved))}
    if "vertex_normals" in mesh.arrays:
        deformed["vertex_normals"] = rotate_directions(rotations, mesh.arrays["vertex_normals"], sewn.sewn_indices)
    return mesh.with_arrays(**deformed)


def _filtered(mesh: Mesh, passes: list[tuple[Any, float]], iterations: int, scope: object) -> Mesh:
    reason = "more iterations shrink the mesh to the mean of its vertices"
    count = check_count("number_of_iterations", iterations, minimum=0, maximum=MAX_PASSES, because=reason)
    names = [name for name in _names_of(scope) if name in mesh.arrays]
    if not names:
        raise ValueError(f"filter_scope: the mesh has no {_names_of(scope)[0]} to filter")
    if count == 0 or not len(mesh):
        return mesh.with_arrays()
    sewn = sew(mesh)
    arrays = sewn.mesh.arrays
    wide = {name: widen_rows(arrays[name]) for name in {"vertices", *names}}
    values = filter_values(arrays["triangles"], wide["vertices"], names, wide, passes, count, sewn.in_order)
    narrow: dict[str, Any] = {}
    for name, rows in values.items():
        if name == "vertex_normals":
            narrow[name] = sewn.spread(narrow_directions(rows, arrays[name]))
        else:
            narrow[name] = sewn.spread(narrow_rows(rows))
    return mesh.with_arrays(**narrow)


def _names_of(scope: object) -> tuple[str, ...]:
    name = scope if isinstance(scope, str) else getattr(scope, "name", None)
    if not isinstance(name, str):
        raise TypeError(f"filter_scope: expected one of {', '.join(SCOPES)}, got {shown(scope)}")
    if name.lower() not in SCOPES:
        raise ValueError(f"filter_scope: expected one of {', '.join(SCOPES)}, got {shown(name)}")
    return SCOPES[name.lower()]


def _once(
    vertices: NDArray[np.int32], sewn_indices: NDArray[np.int32], targets: NDArray[np.float64]
) -> tuple[NDArray[np.int32], NDArray[np.float64]]:
    """Unique constrained vertices of a seam-welded mesh and their targets. ValueError if targets contradict."""
    distinct, firsts, members = np.unique(sewn_indices, return_index=True, return_inverse=True)
    unlike = np.flatnonzero((targets != targets[firsts][members]).any(axis=1))
    if len(unlike):
        pair = f"{vertices[firsts[members[unlike[0]]]]} and {vertices[unlike[0]]}"
        raise ValueError(f"constraint_vertex_positions: vertices {pair} coincide at a seam. Give them the same target")
    return distinct.astype(np.int32), targets[firsts]


def _energy_of(energy: object) -> str:
    name = energy if isinstance(energy, str) else getattr(energy, "name", None)
    if not isinstance(name, str):
        raise TypeError(f"energy: expected one of {', '.join(ENERGIES)}, got {shown(energy)}")
    if name.lower() not in ENERGIES:
        raise ValueError(f"energy: expected one of {', '.join(ENERGIES)}, got {shown(name)}")
    return name.lower()
