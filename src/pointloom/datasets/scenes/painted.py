"""Triangle scenes with colors and labels, for simulated scanners."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.devices import DeviceLike
from ...kernels.linear_algebra import matmul
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.scene.raycasting_scene import RaycastingScene

Color = tuple[float, float, float]

_BOX_FACES = np.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])


class PaintedParts:
    """Collects triangles in the frame set by `set_frame`, with the current `label`."""

    def __init__(self) -> None:
        self._vertices: list[NDArray[np.float64]] = []
        self._triangles: list[NDArray[np.int64]] = []
        self._colors: list[NDArray[np.float64]] = []
        self._labels: list[NDArray[np.uint8]] = []
        self._count, self.label = 0, 0
        self.set_frame(0, 0)

    def set_frame(self, x: float, y: float, z: float = 0.0, *, angle: float = 0.0) -> None:
        """Set the frame: a position [m] and a rotation [rad] about z."""
        c, s = math.cos(angle), math.sin(angle)
        self._R, self._t = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]), np.array([x, y, z])

    def add(self, vertices: ArrayLike, triangles: ArrayLike, color: ArrayLike) -> None:
        faces = np.asarray(triangles, np.int64)
        self._vertices.append(matmul(np.asarray(vertices, np.float64), self._R.T) + self._t)
        self._triangles.append(faces + self._count)
        self._colors.append(np.broadcast_to(np.asarray(color, np.float64), (len(faces), 3)))
        self._labels.append(np.full(len(faces), self.label, np.uint8))
        self._count += len(self._vertices[-1])

    def box(self, center: ArrayLike, size: ArrayLike, color: Color, *, taper: float = 1.0) -> None:
        """A box of full `size` [m]; `taper` scales length and width of its top."""
        corners = np.array([[i & 1, i >> 1 & 1, i >> 2 & 1] for i in range(8)]) - 0.5
        corners[4:, :2] *= taper
        quads = _BOX_FACES
        faces = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
        self.add(corners * np.asarray(size) + np.asarray(center), faces, color)

    def gable(self, center: ArrayLike, size: ArrayLike, color: Color, walls: Color) -> None:
        """A gable roof with its end walls, ridge along x: base center, and length, width and height [m]."""
        x, y, z = np.asarray(size) * [0.5, 0.5, 1.0]
        corners = [[-x, -y, 0], [x, -y, 0], [x, y, 0], [-x, y, 0], [-x, 0, z], [x, 0, z]]
        at = np.array(corners) + np.asarray(center)
        self.add(at, [[0, 1, 5], [0, 5, 4], [2, 3, 4], [2, 4, 5]], color)
        self.add(at, [[1, 2, 5], [3, 0, 4]], walls)

    def cylinder(
        self, center: ArrayLike, radius: float, height: float, color: Color, *, axis: int = 2, resolution: int = 12
    ) -> None:
        """A cylinder of full height [m] along an axis."""
        mesh = TriangleMesh.create_cylinder(radius, height, resolution, split=1)
        self.add(np.roll(mesh.vertices, axis - 2, axis=1) + np.asarray(center), mesh.triangles, color)

    def crown(self, center: ArrayLike, radii: ArrayLike, color: Color, rng: np.random.Generator) -> None:
        """Leaves: an irregular ball with triangles in shades of a color."""
        mesh = TriangleMesh.create_sphere(1.0, 10)
        bumps = 1 + 0.16 * rng.standard_normal(len(mesh.vertices))[:, None]
        shades = np.asarray(color) * rng.uniform(0.7, 1.25, (len(mesh), 1))
        self.add(mesh.vertices * bumps * np.asarray(radii) + np.asarray(center), mesh.triangles, np.clip(shades, 0, 1))

    @property
    def colors(self) -> NDArray[np.float32]:
        return np.concatenate(self._colors).astype(np.float32)

    @property
    def labels(self) -> NDArray[np.uint8]:
        return np.concatenate(self._labels)

    @property
    def vertices(self) -> NDArray[np.float64]:
        return np.concatenate(self._vertices)

    @property
    def triangles(self) -> NDArray[np.int64]:
        return np.concatenate(self._triangles)

    def scene(self, device: DeviceLike = "cpu") -> RaycastingScene:
        """All triangles as one geometry. Triangle ids are rows of `colors` and `labels`."""
        scene = RaycastingScene(device)
        scene.add_triangles(self.vertices.astype(np.float32), self.triangles)
        return scene
