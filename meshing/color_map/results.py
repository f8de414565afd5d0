"""What a colour map comes to."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.trajectory import Trajectory
from ...kernels.memory import download
from ...kernels.textures.posed_pictures import PosedPictures, Warps, unwarp_pixels
from ..mesh.mesh import TriangleMesh


class NothingSeenError(ValueError):
    """No picture shows a vertex of the mesh, so there are no colours to be had.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.meshing.color_map.results import NothingSeenError
        >>> mesh = loom.TriangleMesh([[0, 0, -1], [1, 0, -1], [0, 1, -1]], [[0, 1, 2]])
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> frame = loom.RGBDImage(np.zeros((48, 64, 3), np.uint8), np.full((48, 64), 1000, np.uint16))
        >>> try:
        ...     loom.color_map.run_rigid_optimizer(mesh, [frame], loom.Trajectory([np.eye(4)]), intrinsic=camera)
        ... except NothingSeenError as error:
        ...     print("nothing seen")
        nothing seen
    """


@dataclass(frozen=True, eq=False)
class ColorMapResult:
    """A coloured mesh and the poses that its colours were read at; unpacks as the pair that Open3D returns.

    Attributes:
        mesh: The mesh with vertex colours.
        trajectory: T_world_camera of each picture.
        seen: Whether a picture showed each vertex, bool [m]; the others took their neighbours' colours.
        view_counts: Vertices that each picture shows, int [n].
        residual_before, residual: Root mean square over pairs of picture and vertex of the picture's brightness there
            less the vertex's own (0..1), under the poses given and those returned.
        iterations: Turns of the search.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> mesh = loom.TriangleMesh([[-0.1, -0.1, 1], [0.1, -0.1, 1], [0, 0.1, 1]], [[0, 2, 1]])
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> frame = loom.RGBDImage(np.zeros((48, 64, 3), np.uint8), np.full((48, 64), 1000, np.uint16))
        >>> result = loom.color_map.run_rigid_optimizer(mesh, [frame], loom.Trajectory([np.eye(4)]), intrinsic=camera)
        >>> result.seen.tolist(), result.view_counts.tolist(), result.residual
        ([True, True, True], [3], 0.0)
    """

    mesh: TriangleMesh
    trajectory: Trajectory
    seen: NDArray[np.bool_]
    view_counts: NDArray[np.int64]
    residual_before: float
    residual: float
    iterations: int
    _pictures: PosedPictures
    _warps: Warps

    def __iter__(self) -> Iterator[Any]:
        return iter((self.mesh, self.trajectory))

    def __repr__(self) -> str:
        residuals = f"residual {self.residual_before:.4g} to {self.residual:.4g}"
        return f"ColorMapResult({self.mesh!r}, {len(self.view_counts)} pictures, {residuals})"

    def warp(self, index: int) -> NDArray[np.float64]:
        """Where the anchors of a picture went [px], along its columns and rows: float64 [rows, columns, 2].

        No rows and columns where the pictures were not bent.

        Raises:
            IndexError: No such picture.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> mesh = loom.TriangleMesh([[-0.1, -0.1, 1], [0.1, -0.1, 1], [0, 0.1, 1]], [[0, 2, 1]])
            >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
            >>> frame = loom.RGBDImage(np.zeros((48, 64, 3), np.uint8), np.full((48, 64), 1000, np.uint16))
            >>> option = loom.color_map.NonRigidOptimizerOption(number_of_vertical_anchors=4)
            >>> path = loom.Trajectory([np.eye(4)])
            >>> result = loom.color_map.run_non_rigid_optimizer(mesh, [frame], path, option, intrinsic=camera)
            >>> result.warp(0).shape
            (4, 5, 2)
        """
        columns, rows, first = self._warps.layout[self._index(index)].tolist()
        shifts = download(self._warps.shifts)[first : first + columns * rows]  # sync
        return np.array(shifts, np.float64).reshape(columns, rows, 2).swapaxes(0, 1)

    def unwarped_image(self, index: int) -> NDArray[np.uint8]:
        """A picture as it would be had its camera not bent it, uint8 [h, w, 3]: what `project_images_to_albedo` takes.

        Bilinear; black where the bent picture ends. The picture itself where it was not bent.

        Raises:
            IndexError: No such picture.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> mesh = loom.TriangleMesh([[-0.1, -0.1, 1], [0.1, -0.1, 1], [0, 0.1, 1]], [[0, 2, 1]])
            >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
            >>> frame = loom.RGBDImage(np.full((48, 64, 3), 7, np.uint8), np.full((48, 64), 1000, np.uint16))
            >>> path = loom.Trajectory([np.eye(4)])
            >>> result = loom.color_map.run_rigid_optimizer(mesh, [frame], path, intrinsic=camera)
            >>> result.unwarped_image(0)[0, 0].tolist()
            [7, 7, 7]
        """
        width, height, _ = self._pictures.layout[self._index(index)].tolist()
        pixels = unwarp_pixels(self._index(index), self._pictures, self._warps)
        return download(pixels).reshape(height, width, 3).copy()  # sync

    def _index(self, index: int) -> int:
        if not -len(self.view_counts) <= index < len(self.view_counts):
            raise IndexError(f"index: expected a picture from 0 to {len(self.view_counts) - 1}, got {index}")
        return index % len(self.view_counts)
