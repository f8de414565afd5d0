"""What giving each triangle of a mesh the best of its pictures comes to: `PicturedMesh`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.reports import Assessed, Fields, Report, quality
from ...core.wording import format_share, plain
from ..mesh.mesh import TriangleMesh

FEW_SEEN = 0.3  # share of the triangles that some picture shows, below which colors are unreliable


@dataclass(frozen=True, eq=False)
class PicturedMesh(Report, Assessed):
    """A mesh with a texture cut out of pictures, and what there is to say of it; `print` tells it.

    Attributes:
        mesh: With one texture, without vertex colours.
        views: The picture that each triangle has its colours from, int32 [t]; -1 for none.
        picture_count: Pictures that were given.
        chart_count: Charts: triangles that hang together and have one picture.
        size: Texels a side.
        scale: Texels a pixel of the pictures, 1 at most.
        pair_count: Pairs of a triangle and a picture that shows it.
        outlier_count: Pairs that were left out, since the triangle has another colour there than in most.
        energy: Of the choice of pictures, in units of what a triangle costs that is not shown.
        step_before: The mean step of colour across seams as pictures have it, of 255; None without seams.
        step, step_95: The mean step of the finished texture, and what 95 % of it are below, at two places a texel of
            each seam, bilinear, of 255; None without seams.
        turns: Of the solve for the shifts.
        drew_colors: Whether triangles that no picture shows have the colours of their vertices; else they are plain.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> mesh = loom.TriangleMesh([[-0.1, -0.1, 1], [0.1, -0.1, 1], [0, 0.1, 1]], [[0, 2, 1]])
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> green = np.full((48, 64, 3), (0, 255, 0), np.uint8)
        >>> found = loom.color_map.texture_from_pictures(mesh, [green], camera, [np.eye(4)])
        >>> found.seen_count, found.chart_count, found.step
        (1, 1, None)
    """

    mesh: TriangleMesh
    views: NDArray[np.int32]
    picture_count: int
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
        """How many triangles some picture shows."""
        return int((self.views >= 0).sum())

    @property
    def used_count(self) -> int:
        """How many pictures some triangle has its colours from."""
        return len(np.unique(self.views[self.views >= 0]))

    @property
    def seen_share(self) -> float:
        """The share of the triangles that some picture shows."""
        return self.seen_count / len(self.views)

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks, each with its remedy; empty if the result is reliable."""
        if self.seen_share >= FEW_SEEN:
            return ()
        return (
            f"the images show only {format_share(self.seen_share)} of the triangles: use more images, raise depth_max, "
            "or check that mesh and poses belong together and that the triangles face the cameras",
        )

    def to_dict(self) -> dict[str, Any]:
        """All but the mesh in JSON's types."""
        figures = {
            "device": str(self.mesh.device),
            "pictures": self.picture_count,
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
        """What was done as labels and values."""
        blind = len(self.views) - self.seen_count
        rest = f"; {blind:,} {'in the colours of vertices' if self.drew_colors else 'plain'}" if blind else ""
        fields = [
            ("triangles", f"{len(self.views):,} on {self.mesh.device}"),
            ("pictures", f"{self.picture_count}, {self.used_count} of them used"),
            ("seen", f"{format_share(self.seen_share)} of the triangles{rest}"),
            ("outliers", f"{self.outlier_count:,} of {self.pair_count:,} pairs of triangle and picture"),
            ("charts", f"{self.chart_count:,}"),
            ("texture", f"{self.size} x {self.size}, {self.scale:.2f} texels a pixel"),
        ]
        if self.step_before is not None and self.step is not None and self.step_95 is not None:
            before, after, most = self.step_before, self.step, self.step_95
            fields.append(("seams", f"steps of {before:.2f} to {after:.2f} of 255 in the mean, 95 % below {most:.2f}"))
        return fields
