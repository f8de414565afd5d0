"""How a body bent: a graph of nodes, each with a rotation and a place, that bends whatever stands with the body."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_rows
from ...core.devices import check_same_device
from ...kernels.bending.deformation_graph import (
    DeformationGraph,
    Influence,
    bend_normals,
    bend_points,
    bend_wide,
    measure_volumes,
)
from ...kernels.memory import download
from ...pcd.cloud import PointCloud

Array = NDArray[np.float64]


class Deformation:
    """What `register_nonrigid` found: it takes the world coordinates of the body to those of what it was brought to.

    Each point moves with the four nodes nearest to it, as they weigh; a normal by the inverse transpose of the
    Jacobian.

    Attributes:
        device: The device that holds the nodes.
    """

    def __init__(self, graph: DeformationGraph, source_origin: Array, target_origin: Array) -> None:
        self._graph, self._source, self._target = graph, source_origin.copy(), target_origin.copy()
        self.device = graph.nodes.device

    def __len__(self) -> int:
        return self._graph.count

    def __repr__(self) -> str:
        return f"Deformation({len(self):,} nodes, {self.device})"

    @property
    def nodes(self) -> Array:
        """Where the nodes stood [m], float64 [nodes, 3]."""
        return np.asarray(download(self._graph.nodes), np.float64).reshape(-1, 3) + self._source

    @property
    def rotations(self) -> Array:
        """How they turned, float64 [nodes, 3, 3]."""
        return np.array(download(self._graph.rotations), np.float64).reshape(-1, 3, 3)

    @property
    def translations(self) -> Array:
        """How far they went [m], float64 [nodes, 3]."""
        centers = np.asarray(download(self._graph.centers), np.float64).reshape(-1, 3)
        return centers + self._target - self.nodes

    def transform(self, points: PointCloud | ArrayLike) -> Any:
        """Bend a cloud with all that it has, or points such as the vertices of a mesh.

        Args:
            points: A PointCloud on the device of the nodes, or world coordinates [n, 3] [m]: of the body, or near it.

        Returns:
            The cloud, its normals turned with the surface, its covariances left out; or float64 [n, 3]. What is not
            finite stays so.

        Raises:
            TypeError, ValueError: Neither.
            DeviceError: A cloud on another device.
        """
        if not isinstance(points, PointCloud):
            rows = check_rows("points", points, 3, dtype=np.float64)
            cloud = PointCloud(rows, device=self.device)
            return np.array(download(bend_wide(self._graph, self._influence(cloud), self._target))).reshape(-1, 3)
        check_same_device("points", self.device, points.device)
        influence = self._influence(points)
        arrays = {name: values for name, values in points._device_arrays.items() if name != "covariances"}
        arrays["points"] = bend_points(self._graph, influence)
        if "normals" in arrays:
            arrays["normals"] = bend_normals(self._graph, influence, arrays["normals"])
        bent = PointCloud._from_device_arrays(arrays, self._target, points.array_library)
        bent.grid, bent._unit = points.grid, points.unit
        return bent

    def volumes(self, points: PointCloud | ArrayLike) -> NDArray[np.float32]:
        """What becomes of a unit of volume at points, float32 [n]: the Jacobian's determinant, below 0 in a fold."""
        cloud = points if isinstance(points, PointCloud) else PointCloud(points, device=self.device)
        return np.array(download(measure_volumes(self._graph, self._influence(cloud))))

    def _influence(self, cloud: PointCloud) -> Influence:
        return Influence(cloud._points_about(self._source), self._graph)
