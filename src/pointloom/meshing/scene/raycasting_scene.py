"""RaycastingScene: posed meshes for ray and distance queries."""

from __future__ import annotations

from .scene_distances import SceneDistances
from .scene_rays import SceneRays


class RaycastingScene(SceneRays, SceneDistances):
    """Posed meshes for queries by rays and points, with the names of Open3D's `t.geometry.RaycastingScene`.

    Results are NumPy arrays in the leading shape of the queries. Each mesh has a search tree and keeps its float64
    origin, so scenes far from zero stay exact.

    Args:
        device: "cpu" (default), "cuda:N" or "auto".

    Raises:
        DeviceError: If the device does not exist.

    Example:
        >>> scene = RaycastingScene()
        >>> scene.add_triangles([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
        0
        >>> hits = scene.cast_rays([[0.25, 0.5, 3, 0, 0, -1], [5, 5, 3, 0, 0, -1]])
        >>> hits["t_hit"].tolist()
        [3.0, inf]
        >>> hits["primitive_uvs"][0].tolist()
        [0.25, 0.5]
    """
