"""Refinement of given poses by frame-to-model alignment: `PoseRefiner`."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.number_ranges import some_frames
from ...core.reports import Assessed, quality
from ...core.wording import format_fraction
from ...kernels.linear_algebra import matmul, norm
from ..odometry.alignment import align_frames
from ..slam.model import SlamModel

Pose = NDArray[np.float64]

# Larger corrections indicate a wrong match: errors of structure from motion are at most about 20 cm and a few degrees.
MAX_SHIFT = 0.3  # [m]
MAX_ROTATION = 10.0  # [degrees]

# Posed frames are often far apart, so most surfaces were seen by few others: use all of them.
SEEN_ONCE = 0.0

MAX_UNREFINED = 0.5  # fraction of unrefined frames above which the refinement failed


@dataclasses.dataclass(frozen=True)
class PoseRefinement(Assessed):
    """Unrefined frames with the reason, and corrections of the others: `shifts` [m], `rotations` [degrees]."""

    unrefined: dict[int, str]
    shifts: tuple[float, ...]
    rotations: tuple[float, ...]

    def __str__(self) -> str:
        parts = [f"{len(self.shifts)} refined"]
        if self.shifts:
            medians = f"by {np.median(self.shifts) * 1000:.1f} mm and {np.median(self.rotations):.3f} degrees (medians)"
            parts[0] += f", {medians}, {max(self.shifts) * 1000:.1f} mm at most"
        if self.unrefined:
            parts.append(f"{len(self.unrefined)} unchanged: {some_frames(list(self.unrefined))}")
        return "\n".join(parts)

    @property
    def frame_count(self) -> int:
        return 1 + len(self.unrefined) + len(self.shifts)

    @property
    def warnings(self) -> tuple[str, ...]:
        unrefined, count = self.unrefined, self.frame_count
        if len(unrefined) <= MAX_UNREFINED * (count - 1):
            return ()
        first, reason = next(iter(unrefined.items()))
        fraction = format_fraction(len(unrefined) / count)
        return (
            f"{len(unrefined)} of {count} poses could not be refined and are unchanged "
            f"({fraction}; frame {first}: {reason})",
        )

    def to_dict(self) -> dict[str, Any]:
        return {
            "refined": len(self.shifts),
            "kept": [{"frame": number, "reason": reason} for number, reason in self.unrefined.items()],
            "moved_m": float(np.median(self.shifts)) if self.shifts else None,
            "moved_most_m": max(self.shifts, default=None),
            "turned_deg": float(np.median(self.rotations)) if self.rotations else None,
            **quality(self),
        }


class PoseRefiner:
    """Aligns each frame with the model of the previous frames, from the given pose."""

    def __init__(self, model: SlamModel):
        self._model, self._count = model, 0
        self._unrefined: dict[int, str] = {}
        self._shifts: list[float] = []
        self._rotations: list[float] = []

    def integrate(self, frame: object, T_world_camera: Pose) -> Pose:
        number, self._count = self._count, self._count + 1
        prepared = self._model.prepare(frame)
        pose = T_world_camera
        if number:
            surface = self._model.seen_from(T_world_camera, weight_threshold=SEEN_ONCE)
            result = align_frames(prepared.pyramid, surface)
            moved = result.transformation
            shift, angle = float(norm(moved[:3, 3])), _angle(moved)
            reason = "; ".join(result.warnings) or _why_too_far(shift, angle)
            if reason:
                self._unrefined[number] = reason
            else:
                pose = matmul(T_world_camera, moved)
                self._shifts.append(shift)
                self._rotations.append(angle)
        self._model.integrate(prepared, pose)
        return pose

    @property
    def refinement(self) -> PoseRefinement:
        return PoseRefinement(dict(self._unrefined), tuple(self._shifts), tuple(self._rotations))


def _why_too_far(shift: float, angle: float) -> str:
    if shift <= MAX_SHIFT and angle <= MAX_ROTATION:
        return ""
    return f"the refined pose differs by {shift * 1000:.0f} mm and {angle:.1f} degrees from the given one"


def _angle(T: Pose) -> float:
    return math.degrees(math.acos(float(np.clip((np.trace(T[:3, :3]) - 1) / 2, -1, 1))))
