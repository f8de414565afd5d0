"""Given poses, moved onto what the frames before saw: `PoseRefiner`, one frame after another."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..registration.odometry.alignment import align_frames
from .console import format_share
from .trajectory_report import some_frames

Pose = NDArray[np.float64]

# A pose that would have to move farther than this is another's place, not this one's error: structure from motion errs
# by some 20 cm and a few degrees at its worst.
FARTHEST_SHIFT = 0.3  # [m]
FARTHEST_TURN = 10.0  # [degrees]

# Posed frames often lie far apart, so that most of what they see was seen by few others: all of it is aligned with.
SEEN_ONCE = 0.0

MANY_KEPT = 0.5  # share of the frames beyond which the refinement did not do what was asked for


class PoseRefiner:
    """Aligns each frame with the model that those before it made, from the pose given.

    Args:
        model: A `slam.Model`; its volume is what is fused.

    Attributes:
        kept: Frames that keep the pose given, by number, and why. The first keeps its own without a reason.
        shifts, turns: How far the others were moved [m], [degrees].
    """

    def __init__(self, model: Any):
        self._model, self._count = model, 0
        self.kept: dict[int, str] = {}
        self.shifts: list[float] = []
        self.turns: list[float] = []

    def integrate(self, frame: Any, T_world_camera: Pose) -> Pose:
        """Fold a frame into the model; gives the pose at which it was."""
        number, self._count = self._count, self._count + 1
        prepared = self._model.prepare(frame)
        pose = T_world_camera
        if number:
            surface = self._model.seen_from(T_world_camera, weight_threshold=SEEN_ONCE)
            found = align_frames(prepared.pyramid, surface)
            moved = found.transformation
            shift, turn = float(np.linalg.norm(moved[:3, 3])), _angle(moved)
            reason = found.reason or _why_too_far(shift, turn)
            if reason:
                self.kept[number] = reason
            else:
                pose = T_world_camera @ moved
                self.shifts.append(shift)
                self.turns.append(turn)
        self._model.integrate(prepared, pose)
        return pose

    def describe(self) -> dict[str, Any]:
        """What became of the poses, in JSON's types."""
        return {
            "refined": len(self.shifts),
            "kept": [{"frame": number, "reason": reason} for number, reason in self.kept.items()],
            "moved_m": float(np.median(self.shifts)) if self.shifts else None,
            "moved_most_m": max(self.shifts, default=None),
            "turned_deg": float(np.median(self.turns)) if self.turns else None,
        }


def refinement_line(figures: dict[str, Any]) -> str:
    """The figures of a refinement as one value for the terminal."""
    kept = [entry["frame"] for entry in figures["kept"]]
    parts = [f"{figures['refined']} refined"]
    if figures["refined"]:
        moved = f"by {figures['moved_m'] * 1000:.1f} mm and {figures['turned_deg']:.3f} degrees (medians)"
        parts[0] += f", {moved}, {figures['moved_most_m'] * 1000:.1f} mm at most"
    if kept:
        parts.append(f"{len(kept)} as given: {some_frames(kept)}")
    return "\n".join(parts)


def why_refinement_poor(figures: dict[str, Any], count: int) -> str | None:
    """Whether so many poses were kept that the refinement did not do what was asked for."""
    kept = figures["kept"]
    if len(kept) <= MANY_KEPT * max(count - 1, 0):
        return None
    return (
        f"{len(kept)} of {count} poses could not be refined and are as given ({format_share(len(kept) / count)}; "
        f"frame {kept[0]['frame']}: {kept[0]['reason']})"
    )


def _why_too_far(shift: float, turn: float) -> str:
    if shift <= FARTHEST_SHIFT and turn <= FARTHEST_TURN:
        return ""
    return f"the model lies {shift * 1000:.0f} mm and {turn:.1f} degrees from the pose given"


def _angle(T: Pose) -> float:
    return math.degrees(math.acos(float(np.clip((np.trace(T[:3, :3]) - 1) / 2, -1, 1))))
