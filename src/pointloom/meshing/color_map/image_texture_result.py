"""Result of texturing from the best images: `ImageTextureResult`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.reports import Assessed, Fields, Report, quality
from ...core.wording import format_fraction, plain
from ..mesh.mesh import TriangleMesh

FEW_SEEN = 0.3  # fraction of the triangles seen, below which colors are unreliable


@dataclass(frozen=True, eq=False)
class ImageTextureResult(Report, Assessed):
    """A mesh with a texture from images.

    Attributes:
        mesh: With one texture, without vertex colors.
        views: Source image of each triangle, int32 (t,), or -1 for none.
        image_count, chart_count, pair_count, outlier_count: Number of images, charts (connected triangles of one
            image), visible triangle-image pairs, and excluded pairs.
        size, scale: Texels per side, and per image pixel (at most 1).
        energy: Of the view selection, relative to the cost of an unseen triangle.
        step_before: Mean color difference across seams in the images, 0..255. None without seams.
        step, step_95: Mean and 95th percentile of it in the texture. None without seams.
        turns: Iterations of the seam solver.
        drew_colors: True if unseen triangles have their vertex colors, else they are plain.
    """

    mesh: TriangleMesh
    views: NDArray[np.int32]
    image_count: int
    chart_count: int
    size: int
    scale: float
    pair_count: int
    outlier_count: int
    energy: float
    step_before: float | None
    step: float | None
    step_95: float | None
    turns: int
    drew_colors: bool

    @property
    def seen_count(self) -> int:
        """Number of triangles seen in an image."""
        return int((self.views >= 0).sum())

    @property
    def used_count(self) -> int:
        """Number of images used by a triangle."""
        return len(np.unique(self.views[self.views >= 0]))

    @property
    def seen_fraction(self) -> float:
        """Fraction of the triangles seen in an image."""
        return self.seen_count / len(self.views)

    @property
    def warnings(self) -> tuple[str, ...]:
        if self.seen_fraction >= FEW_SEEN:
            return ()
        return (
            f"the images show only {format_fraction(self.seen_fraction)} of the triangles: use more images, raise "
            "depth_max, or check that mesh and poses belong together and that the triangles face the cameras",
        )

    def to_dict(self) -> dict[str, Any]:
        figures = {
            "device": str(self.mesh.device),
            "images": self.image_count,
            "used": self.used_count,
            "triangles": len(self.views),
            "seen": self.seen_count,
            "charts": self.chart_count,
            "size": self.size,
            "scale": self.scale,
            "pairs": self.pair_count,
            "outliers": self.outlier_count,
            "energy": self.energy,
            "step_before": self.step_before,
            "step": self.step,
            "step_95": self.step_95,
            "turns": self.turns,
            "drew_colors": self.drew_colors,
            **quality(self),
        }
        return plain(figures)

    def fields(self) -> Fields:
        blind = len(self.views) - self.seen_count
        rest = f"; {blind:,} {'with vertex colors' if self.drew_colors else 'plain'}" if blind else ""
        fields = [
            ("triangles", f"{len(self.views):,} on {self.mesh.device}"),
            ("images", f"{self.image_count}, {self.used_count} used"),
            ("seen", f"{format_fraction(self.seen_fraction)} of the triangles{rest}"),
            ("outliers", f"{self.outlier_count:,} of {self.pair_count:,} pairs of triangle and image"),
            ("charts", f"{self.chart_count:,}"),
            ("texture", f"{self.size} x {self.size}, {self.scale:.2f} texels per pixel"),
        ]
        if self.step_before is not None and self.step is not None and self.step_95 is not None:
            before, after, step_95 = self.step_before, self.step, self.step_95
            fields.append(("seams", f"mean step {before:.2f} to {after:.2f} of 255, 95% below {step_95:.2f}"))
        return fields
