"""Result of color map optimization."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from ...cameras.trajectory import Trajectory
from ...core.checks import check_rigid
from ...core.kept_arrays import Arrays
from ...core.reports import Assessed, failed, quality
from ...core.wording import format_fraction, plain
from ...io.points.archives import read_part_of_job
from ...kernels.lang import mat44d, vec2d, vec3
from ...kernels.memory import download, upload
from ...kernels.textures.stacked_images import StackedImages, Warps, unwarp_pixels
from ..mesh.mesh import TriangleMesh

# Thresholds of the quality checks.
FEW_SEEN = 0.3  # fraction of the vertices seen
MAX_BLIND_FRACTION = 0.5  # fraction of the frames that see nothing of the mesh
MAX_RESIDUAL_RATIO = 0.99  # maximum ratio of residuals after and before, unless the residual is
MAX_NUMBER = 1e12  # in kept results: larger ones are damage, and their squares overflow
MIN_RESIDUAL = 0.01  # below this: the level of 8-bit colors and their noise


class NothingSeenError(ValueError):
    """No image sees a vertex of the mesh."""


@dataclass(frozen=True, eq=False)
class ColorMapResult(Assessed):
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
    _images: StackedImages
    _warps: Warps

    _internal = ("from_arrays", "read_arrays", "to_arrays")

    def __iter__(self) -> Iterator[Any]:
        return iter((self.mesh, self.trajectory))

    def __repr__(self) -> str:
        residuals = f"residual {self.residual_before:.4g} to {self.residual:.4g}"
        return f"ColorMapResult({self.mesh!r}, {len(self.view_counts)} images, {residuals})"

    @property
    def seen_fraction(self) -> float:
        """Fraction of the vertices seen in an image."""
        return float(self.seen.mean())

    @property
    def blind_count(self) -> int:
        """Number of images that see nothing of the mesh."""
        return int((self.view_counts == 0).sum())

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks, each with its remedy. Empty if the result is reliable."""
        return self.failed_checks("maximum_allowable_depth", "maximum_iteration=0", is_refined=self.iterations > 0)

    def failed_checks(self, limit: str, unrefined: str, *, is_refined: bool) -> tuple[str, ...]:
        """The warnings, with the names of the arguments for the depth limit and for colors without refinement."""
        blind, count = self.blind_count, len(self.view_counts)
        before, after = self.residual_before, self.residual
        few = (
            f"the frames show only {format_fraction(self.seen_fraction)} of the vertices: use more frames, raise "
            f"{limit}, or check that mesh and poses belong together"
        )
        worse = (
            f"the images do not agree better than before (residual {before:.4f} to {after:.4f}): the pose errors are "
            f"too large, or the colors change with the lighting. Compare with {unrefined}"
        )
        return failed(
            few if self.seen_fraction < FEW_SEEN else None,
            f"{blind} of {count} frames show nothing of the mesh" if blind > MAX_BLIND_FRACTION * count else None,
            worse if is_refined and before > MIN_RESIDUAL and after > MAX_RESIDUAL_RATIO * before else None,
        )

    def to_dict(self) -> dict[str, Any]:
        """The measures in JSON types, with `reliable` and `warnings`."""
        figures = {
            "vertices": len(self.seen),
            "frames": len(self.view_counts),
            "seen_fraction": self.seen_fraction,
            "blind_frames": self.blind_count,
            "residual_before": self.residual_before,
            "residual": self.residual,
            "iterations": self.iterations,
            **quality(self),
        }
        return plain(figures)

    def warp(self, index: int) -> NDArray[np.float64]:
        """Anchor positions of an image [px], float64 (rows, columns, 2). Empty without warps."""
        columns, rows, first = self._warps.layout[self._index(index)].tolist()
        shifts = download(self._warps.shifts)[first : first + columns * rows]  # sync
        return np.array(shifts, np.float64).reshape(columns, rows, 2).swapaxes(0, 1)

    def unwarped_image(self, index: int) -> NDArray[np.uint8]:
        """Unwarped image for `project_images_to_albedo`, uint8 (h, w, 3), bilinear, black outside."""
        width, height, _ = self._images.layout[self._index(index)].tolist()
        pixels = unwarp_pixels(self._index(index), self._images, self._warps)
        return download(pixels).reshape(height, width, 3).copy()  # sync

    def to_arrays(self) -> Arrays:
        """Everything but the mesh and the images."""
        return {
            "colors": download(self.mesh.arrays["vertex_colors"]),
            "poses": self.trajectory.poses,
            "seen": self.seen,
            "view_counts": self.view_counts,
            "residuals": np.array([self.residual_before, self.residual]),
            "counts": np.array([self.iterations, self._warps.rows]),
            "T_camera_world": download(self._images.poses),
            "shifts": download(self._warps.shifts),
        }

    @staticmethod
    def read_arrays(path: Path, mesh: TriangleMesh, stack: StackedImages, rows: int) -> Arrays:
        """The arrays of `to_arrays`. Raises FileError if they do not fit the mesh, the images and the warps."""
        points, images = mesh.arrays["vertices"].size, stack.count
        shifts = Warps(stack.layout, rows, stack.device).shifts.size
        expected = {
            "colors": (np.float32, (points, 3)), "poses": (np.float64, (images, 4, 4)), "seen": (np.bool_, (points,)),
            "view_counts": (np.int64, (images,)), "residuals": (np.float64, (2,)), "counts": (np.int64, (2,)),
            "T_camera_world": (np.float64, (images, 4, 4)), "shifts": (np.float64, (shifts, 2)),
        }  # fmt: skip

        def find_fault(arrays: Arrays) -> str:
            wrong = [name for name, values in arrays.items() if not (np.abs(values) < MAX_NUMBER).all()]
            counts, least = arrays["counts"], {"view_counts": 0, "residuals": 0, "colors": 0, "counts": 0}
            wrong += [name for name, minimum in least.items() if (arrays[name] < minimum).any()]
            wrong += ["view_counts"] * bool((arrays["view_counts"] > points).any()) + ["counts"] * bool(
                counts[1] != rows
            )
            if wrong:
                return f"{', '.join(wrong)}: numbers that no result has"
            try:
                for T in (*arrays["poses"], *arrays["T_camera_world"]):
                    check_rigid("poses", T)
            except ValueError as error:
                return str(error)
            return ""

        return read_part_of_job(path, "the colors", lambda _: expected, find_fault, "They are computed again")

    @classmethod
    def from_arrays(cls, arrays: Arrays, mesh: TriangleMesh, stack: StackedImages, given: Trajectory) -> Self:
        """The result of `to_arrays` for the mesh, the images in their given poses and the given trajectory."""
        iterations, rows = arrays["counts"].tolist()
        stack.poses = upload(arrays["T_camera_world"], mat44d, mesh.device)
        warps = Warps(stack.layout, rows, mesh.device)
        warps.shifts = upload(arrays["shifts"], vec2d, mesh.device)
        colored = mesh.with_arrays(vertex_colors=upload(arrays["colors"], vec3, mesh.device))
        poses = Trajectory(arrays["poses"], given.timestamps, given.ids, given.crs)
        before, after = arrays["residuals"].tolist()
        seen, counts = arrays["seen"], arrays["view_counts"]
        return cls(colored, poses, seen, counts, before, after, iterations, stack, warps)

    def _index(self, index: int) -> int:
        if not -len(self.view_counts) <= index < len(self.view_counts):
            raise IndexError(f"index: expected an image index from 0 to {len(self.view_counts) - 1}, got {index}")
        return index % len(self.view_counts)
