"""The parts of a mesh that hang together, and a mesh without the small ones."""

from __future__ import annotations

from typing import Self

import numpy as np
from numpy.typing import NDArray

from ...core.array_libraries import hand_out_host
from ...core.checks import check_count, check_positive
from ...core.dropped_results import returns_new
from ...kernels.arrays.select import positions_of
from ...kernels.memory import download
from ...kernels.meshes.clean_triangles import mask_not_finite
from ...kernels.meshes.mesh_components import Parts
from .mesh_edits import MeshEdits


class MeshComponents(MeshEdits):
    """The part of TriangleMesh that knows its parts."""

    def cluster_connected_triangles(self) -> tuple[NDArray[np.int32], NDArray[np.int32], NDArray[np.float64]]:
        """Find the parts of the mesh whose triangles hang together by shared edges.

        Triangles that share but a vertex are of two parts. Vertices at one place with two numbers are two vertices.

        Returns:
            (labels, counts, areas): the part of each triangle, int32 [t]; how many triangles each part has, int32 [c];
            its area [m^2], float64 [c], NaN if a triangle of it has a corner that is not finite. Parts are numbered by
            their first triangles, as Open3D numbers them.

        Notes:
            O(t) memory. Same bits from run to run and on every device.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [5, 0, 0], [6, 0, 0], [5, 3, 0]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 1, 2], [4, 5, 6], [2, 1, 3]])
            >>> labels, counts, areas = mesh.cluster_connected_triangles()
            >>> labels.tolist(), counts.tolist(), areas.tolist()
            ([0, 1, 0], [2, 1], [1.0, 1.5])
        """
        parts = self._parts()
        counts, areas = parts.read()
        broken = positions_of(mask_not_finite(self._arrays["vertices"], self._arrays["triangles"]))
        if broken.size:
            areas[download(parts.labels)[download(broken)]] = np.nan
        found = (hand_out_host(values, self._library, self._device) for values in (counts, areas))
        return self._handed_out(parts.labels, dtype=np.int32), *found

    @returns_new
    def remove_small_components(self, min_triangles: int = 1, min_area: float = 0.0) -> Self:
        """Drop the parts of the mesh, as of `cluster_connected_triangles`, that are too small.

        To keep the largest part alone: `mesh.remove_small_components(min_area=areas.max())`.

        Args:
            min_triangles: A part with fewer triangles goes.
            min_area: A part with a smaller area [m^2] goes.

        Returns:
            The other triangles, in their order, and the vertices that they use.

        Raises:
            ValueError: A count below 1, or an area that is negative or not finite.
            TypeError: No numbers.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [5, 0, 0], [6, 0, 0], [5, 3, 0]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 1, 2], [4, 5, 6], [2, 1, 3]])
            >>> mesh.remove_small_components(min_triangles=2)
            TriangleMesh(4 vertices, 2 triangles, cpu)
        """
        count, area = check_count("min_triangles", min_triangles), check_positive("min_area", min_area, allow_zero=True)
        return self._with_triangles(self._parts().mask_large(count, area))  # sync

    def _parts(self) -> Parts:
        return Parts(self._arrays["vertices"], self._arrays["triangles"])
