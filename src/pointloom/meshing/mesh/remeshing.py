"""Simplification, isotropic remeshing and subdivision of a mesh."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from ...core.checks import LARGEST_NUMBER, check_count, check_name, check_number, check_positive
from ...core.units import warn_of_units
from ...kernels.algebra.transform import narrow_rows, widen_rows
from ...kernels.array_types import Integers
from ...kernels.arrays.bounds import bound_points
from ...kernels.lang import int32
from ...kernels.memory import check_room, download, fill, upload, zeros
from ...kernels.meshes.mesh_edges import SortedEdges
from ...kernels.meshes.mesh_measures import measure
from ...kernels.rays.surface_positions import SurfacePositions
from ...kernels.rays.triangle_tree import TriangleTree
from ...kernels.remeshing import subdivision
from ...kernels.remeshing.creased_mesh import CreasedMesh, crease_segments, find_features
from ...kernels.remeshing.decimation import Decimation
from ...kernels.remeshing.flipped_edges import flip_edges
from ...kernels.remeshing.long_edges import count_lengths, split_long_edges
from ...kernels.remeshing.relaxed_vertices import choose_positions, move_without_flips, relaxed
from ...kernels.remeshing.short_edges import collapse_short_edges
from ...kernels.remeshing.vertex_clustering import cluster_vertices
from ...kernels.remeshing.vertex_values import narrow_directions
from .mesh_arrays import Mesh
from .mesh_store import TEXTURE, each
from .selection import drop_degenerate_triangles, drop_invalid_triangles, remove_unreferenced_vertices
from .value_transfer import Sewn, sew, with_attributes_of, with_vectors_of

CONTRACTIONS = ("average", "quadric")
MAX_TRIANGLES = 2**29  # 32-bit half-edge indices, also of the result
# Limits of splits and collapses, of the target length (Botsch and Kobbelt 2004).
SPLIT_LENGTH, COLLAPSE_LENGTH = 4 / 3, 4 / 5
RELAXATION_STEPS = 2  # relaxation steps per iteration
ROUNDS_PER_ITERATION = 3  # of collapses and flips per iteration. Each uses independent edges
MIN_CREASE = 3.0  # of the target length: shorter creases are roughness
MAX_ITERATIONS = 1000
TRIANGLE_BYTES = 400  # temporary memory
MIN_WITHIN = 0.8  # fraction of the edges: of fewer within the limits, the length is not reached
# Of the target length: collapses of a lattice of right triangles with legs of 2/3 to 4/5 pass 4/3.
COARSE_LENGTH = 3 / 2
MAX_COARSENING = 100  # more iterations: each removes a fifth of the edges, so a mesh a million times finer ends
MIN_CHANGED_FRACTION = 0.002  # of all edges: a round that changes fewer is the last
MAX_CORNERS = 2**31 - 1  # 32-bit half-edge indices


def simplify_vertex_clustering(mesh: Mesh, voxel_size: float, contraction: object) -> Mesh:
    """As `TriangleMesh.simplify_vertex_clustering`."""
    size, contraction_name = check_positive("voxel_size", voxel_size), _check_contraction(contraction)
    rows = mesh.arrays.per_vertex()
    unit = [name == "vertex_normals" for name in rows][1:]
    triangles, arrays = cluster_vertices(
        mesh.arrays["triangles"], [*rows.values()], unit, size, contraction_name == "quadric"
    )
    without: dict[str, Any] = dict.fromkeys(TEXTURE)
    left: dict[str, Any] = without | dict(zip(rows, arrays, strict=True))
    return with_attributes_of(mesh.without_attributes().with_arrays(triangles=triangles, **left), mesh)


def simplify_quadric_decimation(
    mesh: Mesh, target_number_of_triangles: int, maximum_error: float, boundary_weight: float
) -> Mesh:
    """As `TriangleMesh.simplify_quadric_decimation`."""
    target = check_count("target_number_of_triangles", target_number_of_triangles, minimum=0)
    error = check_positive("maximum_error", maximum_error, allow_zero=True, allow_infinite=True)
    weight = check_positive("boundary_weight", boundary_weight, allow_zero=True)
    if len(mesh) <= target:
        return mesh.copy()
    rows = mesh.arrays.per_vertex()
    unit = [name == "vertex_normals" for name in rows][1:]
    uvs, materials = (mesh.arrays.get(name) for name in TEXTURE)
    job = Decimation(mesh.arrays["triangles"], [*rows.values()], unit, uvs, materials, target, error, weight)
    job.run()
    triangles, arrays, *texture = job.result()
    remaining: dict[str, Any] = dict(zip((*TEXTURE, *rows), (*texture, *arrays), strict=True))
    left = mesh.without_attributes().with_arrays(triangles=triangles, **remaining)
    if len(left) > target and np.isinf(error):
        warn_of_units(
            f"{len(left)} triangles remain instead of {target}: no other edge can collapse without tearing it",
            UserWarning,
        )
    return with_attributes_of(remove_unreferenced_vertices(left), mesh)


def remesh_isotropic(mesh: Mesh, edge_length: float, iterations: int, *, feature_angle: float) -> Mesh:
    """As `TriangleMesh.remesh_isotropic`."""
    target = check_positive("edge_length", edge_length, maximum=LARGEST_NUMBER)
    count = check_count(
        "iterations", iterations, minimum=0, maximum=MAX_ITERATIONS, because="10 iterations achieve most of the effect"
    )
    angle = check_number("feature_angle", feature_angle)
    if not 0 <= angle <= 180:
        raise ValueError(f"feature_angle: expected 0 to 180 degrees, got {angle:g}")
    source = drop_invalid_triangles(mesh)  # sync
    if not count or not len(source):
        return source.with_arrays(**dict.fromkeys(TEXTURE))
    vertices, triangles = source.arrays["vertices"], source.arrays["triangles"]
    low, high, _ = bound_points(vertices)  # sync
    span, area = float(np.abs([low, high]).max()), measure(vertices, triangles)[0]  # sync
    if target < 2.0**-20 * span or area > MAX_TRIANGLES * 0.25 * target**2:
        raise ValueError(
            f"edge_length: {target:g} m is too small for a mesh of {area:g} m2 with an extent of {span:g} m"
        )
    expected = area / (0.43 * target**2)  # for equilateral triangles
    check_room(mesh.device, int(TRIANGLE_BYTES * expected), f"about {expected:,.0f} triangles")
    surface = TriangleTree(vertices, triangles, all_finite=True)
    fine = _remesh(surface, target, count, math.radians(angle))
    dropped = dict.fromkeys(("vertex_normals", "vertex_colors", *TEXTURE))
    bare = source.without_attributes().with_arrays(**dropped)
    made = drop_degenerate_triangles(bare.with_arrays(vertices=fine.vertices, triangles=fine.triangles))
    return with_attributes_of(with_vectors_of(made, source, surface), source, surface)


def subdivide_midpoint(mesh: Mesh, number_of_iterations: int) -> Mesh:
    """As `TriangleMesh.subdivide_midpoint`."""
    return _subdivided(mesh, number_of_iterations, subdivision.halve, mesh.arrays["vertices"].size)


def subdivide_loop(mesh: Mesh, number_of_iterations: int) -> Mesh:
    """As `TriangleMesh.subdivide_loop`."""
    count = check_count("number_of_iterations", number_of_iterations, minimum=0)
    sewn = sew(mesh) if count and len(mesh) else Sewn(mesh, None)
    return _subdivided(sewn.mesh, count, subdivision.mask, 0, sewn.in_order)


def _subdivided(
    mesh: Mesh, iterations: int, rule: Callable[..., list[Any]], first_new: int, in_order: SortedEdges | None = None
) -> Mesh:
    """Apply a subdivision rule. Normals before `first_new` stay unchanged. `in_order`: known `sorted_edges`."""
    count = check_count("number_of_iterations", iterations, minimum=0)
    if count == 0 or not len(mesh):
        return mesh.with_arrays()
    if count > 16 or 3 * len(mesh) * 4**count > MAX_CORNERS:
        raise ValueError(
            f"number_of_iterations: {count} iterations produce {len(mesh)} * 4^{count} triangles, more than the "
            f"{MAX_CORNERS // 3:,} that 32 bits can index. Use fewer iterations"
        )
    arrays: dict[str, Any] = mesh.arrays | {kind: dict(columns) for kind, columns in mesh.arrays.attributes.items()}
    names = list(mesh.arrays.per_vertex())
    values = [widen_rows(arrays[name]) for name in names]
    for _ in range(count):
        triangles = arrays["triangles"]
        split, in_order = subdivision.EdgeSplit(triangles, values[0].size, in_order), None
        values = rule(triangles, split, values)
        arrays["triangles"] = subdivision.split_triangles(triangles, split)
        if arrays["vertex_attributes"]:
            arrays["vertex_attributes"] = each(arrays["vertex_attributes"], subdivision.mixed_ends(split).of)
        if "triangle_uvs" in arrays:
            arrays["triangle_uvs"] = subdivision.split_corners(arrays["triangle_uvs"])
        if "triangle_material_ids" in arrays:
            arrays["triangle_material_ids"] = subdivision.repeat_four_times(arrays["triangle_material_ids"])
    if arrays["triangle_attributes"]:
        quarters = upload(np.repeat(np.arange(len(mesh), dtype=np.int32), 4**count), int32, mesh.device)
        arrays |= mesh.arrays.attributes_at("triangle_attributes", quarters)
    for name, rows in zip(names, values, strict=True):
        if name == "vertex_normals":
            arrays[name] = narrow_directions(rows, mesh.arrays[name], first_new)
        else:
            arrays[name] = narrow_rows(rows)
    return mesh.with_arrays(**arrays)


def _check_contraction(contraction: object) -> str:
    given = contraction if isinstance(contraction, str) else getattr(contraction, "name", contraction)
    name = check_name("contraction", given).lower()
    if name not in CONTRACTIONS:
        raise ValueError(f"contraction: expected one of {', '.join(CONTRACTIONS)}, got {given!r}")
    return name


def _remesh(surface: TriangleTree, target: float, iterations: int, angle: float) -> CreasedMesh:
    vertices, triangles = surface.vertices, surface.triangles
    creases, fixed = find_features(vertices, triangles, angle, MIN_CREASE * target)
    mesh = CreasedMesh(vertices, triangles, creases, fixed)
    segments = crease_segments(mesh)  # sync
    lines = TriangleTree(vertices, segments, all_finite=True) if segments.size else surface
    course = Course(mesh, (surface, lines), target)
    for _ in range(iterations):
        course.iterate()
    return course.coarsen()


class Course:
    """State and steps of isotropic remeshing. On CUDA the device counts the rounds of a step. The host launches ROUNDS
    of them, and rounds after the last do nothing. Their counts are read with the number of split edges in the next
    iteration, which saves syncs."""

    def __init__(self, mesh: CreasedMesh, trees: tuple[TriangleTree, TriangleTree], target: float) -> None:
        self.mesh, self.trees = mesh, trees
        self.longest, self.shortest = SPLIT_LENGTH * target, COLLAPSE_LENGTH * target
        self.steps: tuple[Callable[..., tuple[CreasedMesh, int | None]], ...] = (self._collapse, flip_edges)
        self.all_rounds = [mesh.vertices.device.is_cuda for _ in self.steps]
        self.state: Integers | None = None  # two numbers of `end_rounds` per step, then `reverted` for each relaxation
        self.before = mesh.vertices
        self.collapse_limit, self.target = self.longest, target
        self.is_fast = False  # collapse more edges per round

    def iterate(self) -> None:
        split, device = 1, self.before.device
        while split:
            made, split, counts = split_long_edges(self.mesh, self.longest, self.state)  # sync
            if self._is_converged(counts):
                self.mesh = made
            else:
                split = 1
        state = zeros(2 * len(self.steps) + RELAXATION_STEPS, int32, device)
        for k, step in enumerate(self.steps):
            self._make_rounds(k, step, state[2 * k : 2 * k + 2])
        if not device.is_cuda:
            self._relax()
            return
        self.state, self.before = state, self.mesh.vertices
        self._relax(state[2 * len(self.steps) :])

    def end(self) -> CreasedMesh:
        if self.state is not None:
            self._is_converged(download(self.state).tolist())  # sync
        return self.mesh

    def coarsen(self) -> CreasedMesh:
        """End, iterate on while many edges are too short, and warn if the length is not reached."""
        counts = self._count_lengths()
        self.is_fast = _is_far(*counts) and counts[0] > counts[2]
        for _ in range(MAX_COARSENING if self.is_fast else 0):
            short, within, _ = counts
            self.collapse_limit = (COARSE_LENGTH if short > within else SPLIT_LENGTH) * self.target
            self.iterate()
            counts = self._count_lengths()
            if counts[1] <= within and counts[0] >= short:
                break
        if _is_far(*counts):
            short, within, long = (f"{count / sum(counts):.0%}" for count in counts)
            smaller = "a smaller edge_length, or a larger feature_angle if creases prevent longer edges"
            warn_of_units(
                f"edge_length: expected most edges at 4/5 to 4/3 of {self.target:g} m, got {within} of them, {short} "
                f"shorter and {long} longer. Pass {smaller if counts[0] > counts[2] else 'more iterations'}",
                UserWarning,
            )
        return self.mesh

    def _count_lengths(self) -> list[int]:
        self.end()
        return count_lengths(self.mesh, self.shortest, self.longest)  # sync

    def _is_converged(self, counts: list[int]) -> bool:
        """Read counts of the last iteration. False if vertices moved again, so that the mesh changed."""
        if self.state is None:
            return True
        self.state = None
        self.all_rounds = [counts[2 * k + 1] == ROUNDS_PER_ITERATION for k in range(len(self.steps))]
        if not any(counts[2 * len(self.steps) :]):
            return True
        self.mesh.vertices = self.before
        self._relax()  # sync
        return False

    def _collapse(
        self, mesh: CreasedMesh, few: float, rounds: Integers | None = None
    ) -> tuple[CreasedMesh, int | None]:
        return collapse_short_edges(mesh, self.shortest, self.collapse_limit, few, rounds, is_fast=self.is_fast)

    def _make_rounds(self, k: int, step: Callable[..., tuple[CreasedMesh, int | None]], rounds: Integers) -> None:
        """Run the rounds of a step, without a host check or with one after each (sync)."""
        for round_number in range(1, ROUNDS_PER_ITERATION + 1):
            self.mesh, changed = step(self.mesh, MIN_CHANGED_FRACTION, rounds if self.all_rounds[k] else None)
            if changed is not None and (
                changed <= MIN_CHANGED_FRACTION * self.mesh.edges.count or round_number == ROUNDS_PER_ITERATION
            ):
                fill(rounds[1:], round_number)
                break

    def _relax(self, reverted: Integers | None = None) -> None:
        """Relax vertices RELAXED times along the surface and creases. One sync each if `reverted` is None."""
        for k in range(RELAXATION_STEPS):
            moved = relaxed(self.mesh)
            on_surface, on_lines = (SurfacePositions(moved, tree).points for tree in self.trees)
            targets = choose_positions(self.mesh, on_surface, on_lines)
            move_without_flips(self.mesh, targets, None if reverted is None else reverted[k : k + 1])


def _is_far(short: int, within: int, long: int) -> bool:
    """True if the edges do not have the target length, from the numbers of those below, within and above its limits."""
    return within < MIN_WITHIN * (short + within + long)
