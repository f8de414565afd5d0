"""Clip planes: an axis-aligned box and one free plane."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ....core.checks import check_direction, check_number, check_rows, check_shape, check_transformation
from ....kernels.drawing import picking
from ....meshing.mesh.mesh import TriangleMesh
from ....pcd.cloud import PointCloud

Keep = Callable[[Any], NDArray[np.bool_]]


@dataclasses.dataclass(frozen=True, eq=False)
class Clip:
    """An axis-aligned box (`low`, `high` [m]; infinite values do not clip) and a half-space of the world.

    `normal` points to the visible side and has any length; `offset` is the plane's distance from the origin along the
    unit normal [m]. Borders are visible. Raises ValueError.

    Example:
        >>> clip = Clip([0, 0, 0], [1, 1, 1], normal=[1, 1, 0], offset=0.5)
        >>> clip.keep([[0.1, 0.1, 0.1], [0.5, 0.5, 1.0], [2, 0, 0]]).tolist()
        [False, True, False]
    """

    low: Any = (-math.inf, -math.inf, -math.inf)
    high: Any = (math.inf, math.inf, math.inf)
    normal: Any = None
    offset: float = 0.0

    def __post_init__(self):
        for name in ("low", "high"):
            ends = check_shape(name, getattr(self, name), (3,))
            if np.isnan(ends).any():
                raise ValueError(f"{name}: expected numbers, got NaN")
            object.__setattr__(self, name, ends)
        if (self.low > self.high).any():
            raise ValueError(f"low, high: expected low <= high, got {self.low.tolist()} and {self.high.tolist()}")
        if self.normal is not None:
            object.__setattr__(self, "normal", check_direction("normal", self.normal))
        object.__setattr__(self, "offset", check_number("offset", self.offset))

    @property
    def cuts(self) -> bool:
        return self.normal is not None or bool(np.isfinite(self.low).any() or np.isfinite(self.high).any())

    def heights(self, points: ArrayLike) -> list[NDArray[np.float64]]:
        """Signed distances of points (n, 3) to each active plane [m], positive inside: float64 (n,) each."""
        positions = check_rows("points", points, 3, dtype=np.float64)
        distances = [positions[:, i] - self.low[i] for i in range(3) if np.isfinite(self.low[i])]
        distances += [self.high[i] - positions[:, i] for i in range(3) if np.isfinite(self.high[i])]
        return distances if self.normal is None else [*distances, positions @ self.normal - self.offset]

    def keep(self, points: ArrayLike) -> NDArray[np.bool_]:
        """True for world points (n, 3) inside. False for NaN."""
        positions = check_rows("points", points, 3, dtype=np.float64)
        is_inside = np.isfinite(positions[:, 0]) & np.isfinite(positions[:, 1]) & np.isfinite(positions[:, 2])
        for height in self.heights(positions):
            is_inside &= height >= 0
        return is_inside

    def keeper(self, pose: ArrayLike | None = None) -> Keep:
        """`keep` for points in the coordinates of a geometry at a pose, 4x4 or None."""
        T = None if pose is None else check_transformation("pose", pose)

        return lambda points: self.keep(points if T is None else np.asarray(points) @ T[:3, :3].T + T[:3, 3])


def hidden_points(cloud: PointCloud, clip: Clip, *, pose: ArrayLike | None = None) -> Any:
    """uint8 (n,) on the cloud's device, 1 for hidden points. None without clipping. `pose`: cloud to world, 4x4."""
    if not clip.cuts:
        return None
    T = np.eye(4) if pose is None else check_transformation("pose", pose).copy()
    T[:3, 3] += T[:3, :3] @ cloud.origin
    normal = np.zeros(3) if clip.normal is None else clip.normal
    offset = -math.inf if clip.normal is None else clip.offset
    return picking.mask_clipped(cloud.arrays["points"], T, clip.low, clip.high, normal, offset)


def clip_mesh(mesh: TriangleMesh, clip: Clip, *, pose: ArrayLike | None = None) -> TriangleMesh:
    """Clip a mesh through its triangles, in its own coordinates. Textures are dropped if anything is clipped.

    Returns the mesh itself if it is completely visible.

    Example:
        >>> import pointloom as loom
        >>> mesh = loom.TriangleMesh([[0, 0, 0], [4, 0, 0], [0, 4, 0]], [[0, 1, 2]])
        >>> clip_mesh(mesh, Clip(low=[1, -9, -9], high=[9, 9, 9])).vertices.tolist()
        [[4.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 3.0, 0.0]]
    """
    T = None if pose is None else check_transformation("pose", pose)
    left = mesh
    for number in range(len(clip.heights(np.zeros((0, 3))))):
        if not len(left):
            break
        vertices = left.vertices if T is None else left.vertices @ T[:3, :3].T + T[:3, 3]
        heights = clip.heights(vertices)[number]
        if not np.isfinite(heights).all():  # triangles with a non-finite vertex are dropped
            heights = np.where(np.isfinite(heights), heights, -math.inf)
            left = left.remove_vertices_by_mask(heights == -math.inf)
            heights = heights[heights > -math.inf]
        if len(left) and (heights < 0).any():
            left = left.trim(heights, 0.0, island_ratio=0.0)
    return left
