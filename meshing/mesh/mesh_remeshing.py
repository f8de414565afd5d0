"""Meshes with triangles that are all alike."""

from __future__ import annotations

import math
from typing import Self

import numpy as np

from ...core.checks import LARGEST_NUMBER, check_count, check_number, check_positive
from ...core.dropped_results import returns_new
from ...kernels.array_types import Points, Triangles
from ...kernels.arrays.bounds import bound_points
from ...kernels.memory import check_room
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
        source = self._without(clean_triangles.mask_not_finite(self._arrays["vertices"], self._arrays["triangles"]))
        source = source.remove_degenerate_triangles().remove_duplicated_triangles().remove_unreferenced_vertices()
        if not count or not len(source):
            return source.with_arrays(**dict.fromkeys(TEXTURE))
        vertices, triangles = source._arrays["vertices"], source._arrays["triangles"]
        low, high, _ = bound_points(vertices)
        span, area = float(np.abs([low, high]).max()), measure(vertices, triangles)[0]
        if target < 2.0**-20 * span or area > MOST_TRIANGLES * 0.25 * target**2:
            raise ValueError(
                f"edge_length: {target:g} m is too small for a mesh of {area:g} m2 that reaches {span:g} m"
            )
        expected = area / (0.43 * target**2)  # of equilateral triangles
        check_room(self._device, int(TRIANGLE_BYTES * expected), f"some {expected:,.0f} triangles")
        mesh = _remesh(vertices, triangles, target, count, math.radians(angle))
        bare = source._bare().with_arrays(vertex_normals=None, vertex_colors=None, **dict.fromkeys(TEXTURE))
        made = bare.with_arrays(vertices=mesh.vertices, triangles=mesh.triangles).remove_unreferenced_vertices()
        return with_attributes_of(with_vectors_of(made, source), source)


def _remesh(vertices: Points, triangles: Triangles, target: float, iterations: int, angle: float) -> CreasedMesh:
    creases, fixed = find_features(vertices, triangles, angle, LEAST_CREASE * target)
    mesh = CreasedMesh(vertices, triangles, creases, fixed)
    surface, segments = TriangleTree(vertices, triangles), crease_segments(mesh)
    lines = TriangleTree(vertices, segments) if segments.size else surface
    longest, shortest = LONG * target, SHORT * target
    for _ in range(iterations):
        split = 1
        while split:
            mesh, split = split_long_edges(mesh, longest)
        for step in (lambda m: collapse_short_edges(m, shortest, longest), flip_edges):
            for _ in range(ROUNDS):
                mesh, changed = step(mesh)
                if changed <= FEW * mesh.edges.count:
                    break
        for _ in range(2):
            moved = relaxed(mesh)
            on_surface, on_lines = SurfacePlaces(moved, surface).points, SurfacePlaces(moved, lines).points
            move_where_nothing_turns(mesh, choose_places(mesh, on_surface, on_lines))
    return mesh
