"""Meshes bent to where some of their vertices are put."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_count, check_finite, check_positive, check_rows, shown
from ...core.dropped_results import returns_new
from ...kernels.arrays.select import gather_rows
from ...kernels.lang import int32, vec3d
from ...kernels.memory import download, upload
from ...kernels.remeshing.rigid_deformation import deform_rigidly, turn_directions
from ...kernels.remeshing.vertex_values import narrow_rows
from .mesh_measures import MeshMeasures
from .mesh_seams import sew
from .vertex_numbers import check_finite_vertices, check_vertices

MOST_TURNS = 10_000
ENERGIES = ("spokes", "smoothed")


class MeshDeformation(MeshMeasures):
    """The part of TriangleMesh that bends it."""

    @returns_new
    def deform_as_rigid_as_possible(
        self,
        constraint_vertex_indices: Any,
        constraint_vertex_positions: Any,
        max_iter: int,
        energy: Any = "spokes",
        smoothed_alpha: float = 0.01,
    ) -> Self:
        """Put some vertices somewhere, and let the others follow so that the surface around each stays as it was.

        Args:
            constraint_vertex_indices: Vertices that are put, each once: those that move and those that are to stay.
            constraint_vertex_positions: Where [m], shape [k, 3].
            max_iter: Turns, of rotations and then positions.
            energy: "spokes" (Sorkine and Alexa 2007) or "smoothed", which keeps neighbouring rotations alike (Levi and
                Gotsman 2014); or a member of Open3D's DeformAsRigidAsPossibleEnergy.
            smoothed_alpha: How much, in areas of the mesh.

        Returns:
            The bent mesh. Normals turn with their vertices, all else stays; Open3D drops it. Parts of the mesh that
            hang together with none of the given vertices stay where they are, where Open3D finds no solution; so do
            vertices that are not finite. A triangle without area weighs nothing. Vertices at one place of a seam, where
            borders lie on each other as texture leaves them, move together; it is enough to give one of them.

        Raises:
            ValueError: No vertex, one that does not exist, is given twice or is not finite; another number of
                positions, one that is not finite, or two for vertices at one place of a seam; max_iter outside
                0..10,000; an unknown energy; a smoothed_alpha below 0.
            TypeError: No numbers.
            ArithmeticError: Triangles so thin that positions do not settle; not seen so far.

        Notes:
            Each turn solves for the positions to a billionth of the mesh's stretch, so it agrees with Open3D's direct
            solver to rounding to float32. O(m + t) memory, about 1 kB a vertex. Sums in float64 in fixed orders: the
            same bits from run to run. Cotangent weights as in Open3D, not below 0. With max_iter=0 nothing moves.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 2, 0], [1, 2, 0]]
            >>> strip = loom.TriangleMesh(corners, [[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 5]])
            >>> moved = strip.deform_as_rigid_as_possible([0, 1], [[0, 0, 5], [1, 0, 5]], max_iter=30)
            >>> moved.vertices[4].round(3).tolist()
            [0.0, 2.0, 5.0]
        """
        count = self._arrays["vertices"].size
        held = check_vertices("constraint_vertex_indices", constraint_vertex_indices, count)
        targets = check_rows("constraint_vertex_positions", constraint_vertex_positions, 3, dtype=np.float64)
        if len(targets) != len(held):
            raise ValueError(
                f"constraint_vertex_positions: expected shape [{len(held)}, 3], one row for each of the vertices, got "
                f"{list(targets.shape)}"
            )
        check_finite("constraint_vertex_positions", targets)
        numbers, repeats = np.unique(held, return_counts=True)
        if len(numbers) < len(held):
            raise ValueError(
                f"constraint_vertex_indices: vertex {numbers[repeats > 1][0]} is given twice; give it once"
            )
        reason = "by then nothing moves any more; take fewer"
        turns = check_count("max_iter", max_iter, minimum=0, maximum=MOST_TURNS, because=reason)
        alpha = check_positive("smoothed_alpha", smoothed_alpha, allow_zero=True)
        likeness = alpha * self._finite_area() if _energy_of(energy) == "smoothed" else 0.0
        if turns == 0:
            return self._with_arrays()
        rows = upload(held, int32, self._device)
        check_finite_vertices("constraint_vertex_indices", held, gather_rows(self._arrays["vertices"], rows))
        sewn = sew(self)
        if sewn.places is not None:
            held, targets = _once(held, download(gather_rows(sewn.places, rows)), targets)  # sync
            rows = upload(held, int32, self._device)
        places, arrays = upload(targets - self._origin, vec3d, self._device), sewn.mesh._device_arrays
        moved, rotations = deform_rigidly(arrays["vertices"], arrays["triangles"], rows, places, turns, likeness)
        bent: dict[str, Any] = {"vertices": sewn.spread(narrow_rows(moved))}
        if "vertex_normals" in self._arrays:
            bent["vertex_normals"] = turn_directions(rotations, self._arrays["vertex_normals"], sewn.places)
        return self._with_arrays(**bent)


def _once(
    held: NDArray[np.int32], places: NDArray[np.int32], targets: NDArray[np.float64]
) -> tuple[NDArray[np.int32], NDArray[np.float64]]:
    """Places of a sewn mesh once each, and where they are put.

    Raises:
        ValueError: Two of them lie at one place and are put elsewhere each.
    """
    found, firsts, members = np.unique(places, return_index=True, return_inverse=True)
    unlike = np.flatnonzero((targets != targets[firsts][members]).any(axis=1))
    if len(unlike):
        pair = f"{held[firsts[members[unlike[0]]]]} and {held[unlike[0]]}"
        raise ValueError(
            f"constraint_vertex_positions: vertices {pair} lie at one place of a seam; put them at one place"
        )
    return found.astype(np.int32), targets[firsts]


def _energy_of(energy: Any) -> str:
    """One of ours by name, or a member of Open3D's enum."""
    name = energy if isinstance(energy, str) else getattr(energy, "name", None)
    if not isinstance(name, str):
        raise TypeError(f"energy: expected one of {', '.join(ENERGIES)}, got {shown(energy)}")
    if name.lower() not in ENERGIES:
        raise ValueError(f"energy: expected one of {', '.join(ENERGIES)}, got {shown(name)}")
    return name.lower()
