"""How the surface of a mesh bends at its vertices."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...core.array_libraries import view_as
from ...kernels.lang import float64
from ...kernels.memory import contiguous, empty
from ...kernels.meshes.mesh_curvature import measure_curvatures
from .mesh_arrays import MeshArrays
from .mesh_seams import sew


class MeshCurvature(NamedTuple):
    """Curvature at the vertices of a mesh, float64 [m] each; NaN where there is none.

    Attributes:
        mean: Half the sum of the principal curvatures [1/m]; above 0 where the surface bulges towards its outside.
        gaussian: Their product [1/m^2].
        least, largest: The principal curvatures [1/m].
    """

    mean: NDArray[np.float64]
    gaussian: NDArray[np.float64]
    least: NDArray[np.float64]
    largest: NDArray[np.float64]


class MeshCurvatures(MeshArrays):
    """The part of TriangleMesh that measures how it bends."""

    def compute_vertex_curvature(self) -> MeshCurvature:
        """The mean, Gaussian and principal curvatures of the surface at each vertex.

        Returns:
            A `MeshCurvature`. All four are NaN at vertices that the triangles do not close a ring around (at the rim,
            at edges of three triangles or more, without triangles), where two neighbouring triangles there turn
            different ways, and next to a triangle without area or a vertex that is not finite. Seams, where borders lie
            on each other as texture leaves them, are no rim.

        Notes:
            O(m + t) memory. Sums run in float64 by ascending triangle: the same bits from run to run and on every
            device. Noise of the positions is blown up by one over the square of the edges: smooth first. Meyer et al.,
            "Discrete differential-geometry operators for triangulated 2-manifolds", VisMath 2003, equations 8 to 11.

        Example:
            >>> import pointloom as loom
            >>> corners = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]
            >>> faces = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]
            >>> curvature = loom.TriangleMesh(corners, faces).compute_vertex_curvature()
            >>> curvature.gaussian.round(3).tolist()
            [1.814, 1.814, 1.814, 1.814, 1.814, 1.814]
        """
        sewn = sew(self)
        found = measure_curvatures(sewn.mesh._device_arrays["vertices"], sewn.mesh._device_arrays["triangles"])
        columns: Any = view_as(found, float64, (found.size, 4))
        columns = [contiguous(columns[:, k]) if found.size else empty(0, float64, self.device) for k in range(4)]
        parts = [sewn.spread(column) for column in columns]
        return MeshCurvature(*map(self._handed_out, parts))
