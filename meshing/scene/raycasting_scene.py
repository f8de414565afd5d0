"""RaycastingScene: meshes in places, and what rays and points find there; one file a subject."""

from __future__ import annotations

from .scene_distances import SceneDistances
from .scene_rays import SceneRays


class RaycastingScene(SceneRays, SceneDistances):
    """Meshes, each in one place or several, for queries by rays and points.

    The names are those of Open3D's `t.geometry.RaycastingScene`; results are NumPy arrays in the leading shape of the
    rays or points. A search tree over each mesh is built when it is added. Meshes far from zero keep their float64
    origin: rays and points are taken relative to it before anything is rounded to float32.

    Args:
        device: "cpu" (default), "cuda:N" or "auto".

    Raises:
        DeviceError: No such device.

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
