"""Meshes with triangles that are all alike."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Self

import numpy as np

from ...core.checks import LARGEST_NUMBER, check_count, check_number, check_positive
from ...core.dropped_results import returns_new
from ...kernels.array_types import Integers
from ...kernels.arrays.bounds import bound_points
from ...kernels.lang import int32
from ...kernels.memory import check_room, download, fill, zeros
from ...kernels.meshes import clean_triangles
from ...kernels.meshes.mesh_measures import measure
from ...kernels.rays.surface_places import SurfacePlaces
from ...kernels.rays.triangle_tree import TriangleTree
from ...kernels.remeshing.creased_mesh import CreasedMesh, crease_segments, find_features
from ...kernels.remeshing.flipped_edges import flip_edges
from ...kernels.remeshing.long_edges import split_long_edges
from ...kernels.remeshing.relaxed_vertices import choose_places, move_where_nothing_turns, relaxed
from ...kernels.remeshing.short_edges import collapse_short_edges
from .mesh_cleaning import MeshCleaning
from .mesh_rows import TEXTURE
from .surface_values import with_attributes_of, with_vectors_of

MOST_TRIANGLES = 2**29  # half-edges and what they become are counted in 32 bits
LONG, SHORT = 4 / 3, 4 / 5  # of the length asked for: edges beyond are split or collapse (Botsch and Kobbelt 2004)
RELAXED = 2  # times that vertices move in an iteration
ROUNDS = 3  # of collapses and of flips in an iteration; each is a set of edges of which none is next to another
LEAST_CREASE = 3.0  # of the length asked for: what hangs together over less is roughness
MOST_ITERATIONS = 1000
TRIANGLE_BYTES = 400  # while it works
FEW = 0.002  # of all edges: where a round changes fewer, it is the last


class MeshRemeshing(MeshCleaning):
    """The part of TriangleMesh that makes its triangles alike."""

    @returns_new
    def remesh_isotropic(self, edge_length: float, iterations: int = 10, *, feature_angle: float = 30.0) -> Self:
        """The same surface in triangles that are nearly equilateral, with edges of about one length.

        Long edges split, short ones collapse, others flip where vertices have more or fewer than six triangles;
        vertices move along the surface to where triangles become alike, and are put back onto the surface as it was.

        Args:
            edge_length: [m]; edges come to lie between 4/5 and 4/3 of it, where creases leave room.
            iterations: How often all that is done.
            feature_angle: Edges at which triangles meet at more than this [degrees] are creases: they stay where they
                are, in other parts; so do borders, and edges that are not manifold. Where creases bend by more, or
                meet, vertices stay. Creases that hang together over less than three edges are roughness, and none. 180
                keeps borders alone.

        Returns:
            The remeshed surface. It keeps its pieces, holes and handles; a watertight mesh stays so, and no triangle
            turns by more than 60 degrees in one step. Colours, normals (of unit length) and attributes are those of
            the nearest place of the mesh as it was. Textures are left behind: `bake_vertex_colors` keeps colours.
            Triangles that repeat another, name a vertex twice or are not finite go first.

        Raises:
            ValueError: No length above 0, one so small that there would be more than 2^29 triangles, a count below 0
                or above 1000, or no angle from 0 to 180.
            MemoryError: There is no room for so many triangles.
            TypeError: No numbers.

        Notes:
            Some 400 B of memory a triangle. Same bits from run to run and on every device. Botsch and Kobbelt, "A
            remeshing approach to multiresolution modeling", 2004, with edges taken many at a time, and triangles' areas
            for weights.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> box = loom.TriangleMesh.create_box().remesh_isotropic(0.1)
            >>> box.is_watertight(), round(box.get_volume(), 6), round(box.get_surface_area(), 6)
            (True, 1.0, 6.0)
        """
        target = check_positive("edge_length", edge_length, maximum=LARGEST_NUMBER)
        count = check_count(
            "iterations", iterations, minimum=0, maximum=MOST_ITERATIONS, because="ten bring most of it"
        )
        angle = check_number("feature_angle", feature_angle)
        if not 0 <= angle <= 180:
            raise ValueError(f"feature_angle: expected 0 to 180 degrees, got {angle:g}")
        source = self._without_waste()  # sync
        if not count or not len(source):
            return source._with_arrays(**dict.fromkeys(TEXTURE))
        vertices, triangles = source._arrays["vertices"], source._arrays["triangles"]
        low, high, _ = bound_points(vertices)  # sync
        span, area = float(np.abs([low, high]).max()), measure(vertices, triangles)[0]  # sync
        if target < 2.0**-20 * span or area > MOST_TRIANGLES * 0.25 * target**2:
            raise ValueError(
                f"edge_length: {target:g} m is too small for a mesh of {area:g} m2 that reaches {span:g} m"
            )
        expected = area / (0.43 * target**2)  # of equilateral triangles
        check_room(self._device, int(TRIANGLE_BYTES * expected), f"some {expected:,.0f} triangles")
        surface = TriangleTree(vertices, triangles, all_finite=True)
        mesh = _remesh(surface, target, count, math.radians(angle))
        bare = source._bare()._with_arrays(vertex_normals=None, vertex_colors=None, **dict.fromkeys(TEXTURE))
        made = bare._with_arrays(vertices=mesh.vertices, triangles=mesh.triangles)._without_gone()
        return with_attributes_of(with_vectors_of(made, source, surface), source, surface)

    def _without_gone(self) -> Self:
        """Without triangles that name a vertex three times, and vertices that none has; one sync."""
        triangles, count = self._arrays["triangles"], self._vertex_count
        gone = clean_triangles.mask_degenerate(self._arrays["vertices"], triangles, zero_area=False)
        return self._left(gone, clean_triangles.mask_used(triangles, gone, count))


def _remesh(surface: TriangleTree, target: float, iterations: int, angle: float) -> CreasedMesh:
    vertices, triangles = surface.vertices, surface.triangles
    creases, fixed = find_features(vertices, triangles, angle, LEAST_CREASE * target)
    mesh = CreasedMesh(vertices, triangles, creases, fixed)
    segments = crease_segments(mesh)  # sync
    lines = TriangleTree(vertices, segments, all_finite=True) if segments.size else surface
    course = Course(mesh, (surface, lines), target)
    for _ in range(iterations):
        course.iterate()
    return course.end()


class Course:
    """The iterations of a mesh.

    On CUDA the device counts the rounds of a step where all of them were made in the iteration before: the host makes
    ROUNDS then, and those after the last do nothing. What it has to know of an iteration it reads with the number of
    edges that split in the next.
    """

    def __init__(self, mesh: CreasedMesh, trees: tuple[TriangleTree, TriangleTree], target: float) -> None:
        self.mesh, self.trees = mesh, trees
        self.longest, self.shortest = LONG * target, SHORT * target
        self.steps: tuple[Callable[..., tuple[CreasedMesh, int | None]], ...] = (self._collapse, flip_edges)
        self.all_rounds = [mesh.vertices.device.is_cuda for _ in self.steps]
        self.state: Integers | None = None  # two numbers of `end_rounds` a step, then `taken` for each relaxation
        self.before = mesh.vertices

    def iterate(self) -> None:
        """Split, collapse, flip, move."""
        split, device = 1, self.before.device
        while split:
            made, split, found = split_long_edges(self.mesh, self.longest, self.state)  # sync
            if self._is_settled(found):
                self.mesh = made
            else:
                split = 1
        state = zeros(2 * len(self.steps) + RELAXED, int32, device)
        for k, step in enumerate(self.steps):
            self._make_rounds(k, step, state[2 * k : 2 * k + 2])
        if not device.is_cuda:
            self._relax()
            return
        self.state, self.before = state, self.mesh.vertices
        self._relax(state[2 * len(self.steps) :])

    def end(self) -> CreasedMesh:
        """The mesh."""
        if self.state is not None:
            self._is_settled(download(self.state).tolist())  # sync
        return self.mesh

    def _is_settled(self, found: list[int]) -> bool:
        """Read what the last iteration says; False where its vertices had to move anew, so that the mesh is another."""
        if self.state is None:
            return True
        self.state = None
        self.all_rounds = [found[2 * k + 1] == ROUNDS for k in range(len(self.steps))]
        if not any(found[2 * len(self.steps) :]):
            return True
        self.mesh.vertices = self.before
        self._relax()  # sync
        return False

    def _collapse(
        self, mesh: CreasedMesh, few: float, rounds: Integers | None = None
    ) -> tuple[CreasedMesh, int | None]:
        return collapse_short_edges(mesh, self.shortest, self.longest, few, rounds)

    def _make_rounds(self, k: int, step: Callable[..., tuple[CreasedMesh, int | None]], rounds: Integers) -> None:
        """The rounds of a step: without a look at them, or with one after each (sync)."""
        for turn in range(1, ROUNDS + 1):
            self.mesh, changed = step(self.mesh, FEW, rounds if self.all_rounds[k] else None)
            if changed is not None and (changed <= FEW * self.mesh.edges.count or turn == ROUNDS):
                fill(rounds[1:], turn)
                break

    def _relax(self, taken: Integers | None = None) -> None:
        """Move vertices along the surface and their lines, RELAXED times; one sync each where `taken` is not given."""
        for k in range(RELAXED):
            moved = relaxed(self.mesh)
            on_surface, on_lines = (SurfacePlaces(moved, tree).points for tree in self.trees)
            places = choose_places(self.mesh, on_surface, on_lines)
            move_where_nothing_turns(self.mesh, places, None if taken is None else taken[k : k + 1])
