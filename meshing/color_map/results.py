"""Result of color map optimization."""

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
    """No image sees a vertex of the mesh."""


@dataclass(frozen=True, eq=False)
class ColorMapResult:
    """A colored mesh and the refined poses; unpacks as (mesh, trajectory), as in Open3D.

    Attributes:
        mesh: The mesh with vertex colors.
        trajectory: T_world_camera of each image.
        seen: Vertices seen in an image, bool (m,). The others took their neighbors' colors.
        view_counts: Number of vertices seen in each image, int (n,).
        residual_before, residual: RMS difference of image and vertex intensity (0..1), before and after.
        iterations: Number of iterations.
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
        return f"ColorMapResult({self.mesh!r}, {len(self.view_counts)} images, {residuals})"

    def warp(self, index: int) -> NDArray[np.float64]:
        """Anchor positions of an image [px], float64 (rows, columns, 2). Empty without warps."""
        columns, rows, first = self._warps.layout[self._index(index)].tolist()
        shifts = download(self._warps.shifts)[first : first + columns * rows]  # sync
        return np.array(shifts, np.float64).reshape(columns, rows, 2).swapaxes(0, 1)

    def unwarped_image(self, index: int) -> NDArray[np.uint8]:
        """Unwarped image for `project_images_to_albedo`, uint8 (h, w, 3), bilinear, black outside."""
        width, height, _ = self._pictures.layout[self._index(index)].tolist()
        pixels = unwarp_pixels(self._index(index), self._pictures, self._warps)
        return download(pixels).reshape(height, width, 3).copy()  # sync

    def _index(self, index: int) -> int:
        if not -len(self.view_counts) <= index < len(self.view_counts):
            raise IndexError(f"index: expected an image index from 0 to {len(self.view_counts) - 1}, got {index}")
        return index % len(self.view_counts)
