"""A mesh with the colors of frames, and its reliability: `TexturedMesh`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ...cameras.trajectory import Trajectory
from ...core.reports import Assessed, Fields, Report, quality
from ...core.wording import format_fraction, plain
from ...kernels.linear_algebra import inv, matmul
from ..mesh.mesh import TriangleMesh
from .results import ColorMapResult


@dataclass(frozen=True)
class TexturedMesh(Report, Assessed):
    """A mesh colored from frames.

    Attributes:
        mesh: With a texture if requested, else with vertex colors.
        colors: ColorMapResult: the mesh with vertex colors, and the poses.
        method: "rigid", "non-rigid" or "none".
        depth_max: Maximum depth of used pixels [m].
        turned, moved: Mean rotation [degrees] and translation [m] of the poses.
        size, texel_fraction: Texels per side, and fraction of texels seen. None without a texture.
        source_warnings: Failed checks of the frames: an assumed or implausible camera, or mostly unpaired images.
        reliable, warnings: True if all quality checks passed, and those that failed.
    """

    mesh: TriangleMesh
    colors: ColorMapResult
    method: str
    depth_max: float
    turned: float
    moved: float
    size: int | None = None
    texel_fraction: float | None = None
    source_warnings: tuple[str, ...] = ()

    @property
    def frame_count(self) -> int:
        """Number of frames."""
        return len(self.colors.view_counts)

    @property
    def seen_fraction(self) -> float:
        """Fraction of the vertices seen in a frame."""
        return self.colors.seen_fraction

    @property
    def blind_frames(self) -> int:
        """Number of frames that see nothing of the mesh."""
        return self.colors.blind_count

    @property
    def warnings(self) -> tuple[str, ...]:
        refined = self.method != "none"
        reasons = self.colors.failed_checks("depth_max", "method='none'", is_refined=refined)
        return (*reasons, *self.source_warnings)

    def to_dict(self) -> dict[str, Any]:
        colors, shape = self.colors, self.colors.mesh
        figures = {
            "device": str(shape.device),
            "method": self.method,
            "frames": self.frame_count,
            "depth_max": self.depth_max,
            "vertices": shape.arrays["vertices"].size,
            "triangles": len(shape),
            "seen_fraction": self.seen_fraction,
            "blind_frames": self.blind_frames,
            "residual_before": colors.residual_before,
            "residual": colors.residual,
            "turns": colors.iterations,
            "turned": self.turned,
            "moved": self.moved,
            "size": self.size,
            "texel_fraction": self.texel_fraction,
            **quality(self),
        }
        return plain(figures)

    def fields(self) -> Fields:
        colors, blind = self.colors, self.blind_frames
        seen = f"{format_fraction(self.seen_fraction)} of the vertices" + (
            f"; {blind} frames see nothing" if blind else ""
        )
        fields = [
            *task_fields(colors.mesh, self.frame_count, self.depth_max),
            ("seen", seen),
            ("method", f"{self.method}, {colors.iterations} iterations"),
            ("residual", f"{colors.residual_before:.4f} to {colors.residual:.4f} of full brightness"),
            ("poses", f"rotated {self.turned:.3f} deg, moved {self.moved * 1000:.1f} mm on average"),
        ]
        if self.texel_fraction is not None:
            fields.append(("texture", f"{self.size} x {self.size}, {format_fraction(self.texel_fraction)} seen"))
        return fields


def task_fields(mesh: TriangleMesh, frame_count: int, depth_max: float) -> Fields:
    return [
        ("mesh", f"{mesh.arrays['vertices'].size:,} vertices, {len(mesh):,} triangles"),
        ("frames", f"{frame_count} up to {depth_max:g} m, on {mesh.device}"),
    ]


def mean_motion(before: Trajectory, after: Trajectory) -> tuple[float, float]:
    """Mean rotation [degrees] and translation [m] between poses."""
    T = matmul(inv(before.poses), after.poses)
    cosines = (np.trace(T[:, :3, :3], axis1=1, axis2=2) - 1) / 2
    mean_angle = float(np.degrees(np.arccos(np.clip(cosines, -1, 1))).mean())
    return mean_angle, float(np.linalg.norm(T[:, :3, 3], axis=1).mean())
