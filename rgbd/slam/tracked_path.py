"""What tracking makes of a sequence of frames: the path, and what became of each frame."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.trajectory import Trajectory
from ...core.number_runs import some_frames
from ...core.reports import Fields, in_columns
from ...core.wording import format_share
from ...files.frames.frames import why_out_of_reach
from ...registration.trajectories.trajectory_error import TrajectoryError
from .paths import error_against_truth, path_length

MANY_UNCERTAIN = 0.2  # share of the frames with an uncertain pose, beyond which the path is not to be believed


@dataclasses.dataclass(frozen=True, eq=False)
class TrackedPath:
    """Where frames were taken, and what became of each, by its number in the sequence, from 0.

    `print(path)` tells it, `path.poor` says what speaks against it.

    Attributes:
        trajectory: The poses of the frames that have one, T_world_camera; ids hold the frames' numbers, and it has
            timestamps where all those frames have them.
        true_poses: The true pose of each of these, float64 [4, 4] [m], or None where nobody knows it.
        frame_count: How many frames there were.
        uncertain: Frames whose pose is told with a doubt.
        lost: Frames that could not be placed, and why.
        unreadable: Frames that could not be read, and why.
        residuals: Root mean square distance [m] from the model of each placed frame after the first.
        fitness: Share of its depth that lies on the model.
        depth_share: Share of all pixels that have a depth; 0 where no frame could be read.
        used_share: Share of all pixels that have a depth up to `depth_max`.
        voxel_size: Edge of a voxel of the model that frames were held against [m].
        depth_max: Farther depth was left out [m].
        device: Where it was computed.
        deviations: Standard deviation [m] of the position of each placed frame along its most open direction, by what
            the frames on the way left open and by noise.
        drifted: Frames whose position is open by too much for a pose to be believed; they are among the uncertain.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> v, u = np.mgrid[:48, :64]
        >>> depth = np.float32(1.0 + 0.1 * np.sin(u / 5) * np.cos(v / 7))
        >>> path = loom.track(loom.frames_from([(None, depth)] * 3, camera))
        >>> path.to_json()["tracked"], path.lost, path.poor
        (3, {}, None)
    """

    trajectory: Trajectory
    true_poses: tuple[NDArray[np.float64] | None, ...]
    frame_count: int
    uncertain: tuple[int, ...]
    lost: dict[int, str]
    unreadable: dict[int, str]
    residuals: tuple[float, ...]
    fitness: tuple[float, ...]
    depth_share: float
    used_share: float
    voxel_size: float
    depth_max: float
    device: str
    deviations: tuple[float, ...] = ()
    drifted: tuple[int, ...] = ()

    def __str__(self) -> str:
        return in_columns([*self.fields(), ("model", f"voxels of {self.voxel_size * 1000:g} mm")])

    @property
    def error(self) -> TrajectoryError | None:
        """ATE and RPE where the frames came with true poses, aligned by a rigid motion; None of fewer than two."""
        return error_against_truth(self.trajectory.poses, self.true_poses)

    @property
    def poor(self) -> str | None:
        """What is wrong with the path, in the words of the command line; None where nothing is."""
        count, reach = self.frame_count, why_out_of_reach(self.depth_share, self.used_share, self.depth_max)
        reasons = [] if reach is None else [reach]
        if lost := self.lost:
            first = next(iter(lost.values()))
            reasons.append(
                f"{len(lost)} of {count} frames were lost ({some_frames(list(lost))}) and are left out: {first}"
            )
        if drifted := self.drifted:
            reasons.append(
                f"{len(drifted)} of {count} positions are open by up to {max(self.deviations):.2f} m, which adds up on "
                f"the way ({some_frames(drifted)})"
            )
        if len(self.uncertain) - len(drifted) > MANY_UNCERTAIN * count:
            reasons.append(f"{len(self.uncertain)} of {count} poses are uncertain ({some_frames(self.uncertain)})")
        if unreadable := self.unreadable:
            first = next(iter(unreadable.values()))
            reasons.append(f"{len(unreadable)} of {count} frames cannot be read and are left out: {first}")
        return "; ".join(reasons) or None

    def with_poses(self, poses: Sequence[NDArray[np.float64]]) -> TrackedPath:
        """The same with other poses of the frames that have one."""
        told = self.trajectory
        corrected = np.array(poses, np.float64).reshape(-1, 4, 4)
        return dataclasses.replace(self, trajectory=Trajectory(corrected, timestamps=told.timestamps, ids=told.ids))

    def to_json(self) -> dict[str, Any]:
        """The figures, in JSON's types."""
        return {
            "device": self.device,
            "voxel_size": self.voxel_size,
            "depth_max": self.depth_max,
            "frames": self.frame_count,
            "tracked": len(self.trajectory),
            "uncertain": list(self.uncertain),
            "drifted": list(self.drifted),
            "position_deviation_m": max(self.deviations, default=None),
            "lost": [{"frame": number, "reason": reason} for number, reason in self.lost.items()],
            "unreadable": [{"frame": number, "reason": reason} for number, reason in self.unreadable.items()],
            "depth_share": self.depth_share,
            "used_share": self.used_share,
            "residual_m": _median(self.residuals),
            "fitness": _median(self.fitness),
            "path_length_m": path_length(self.trajectory.poses),
        }

    def fields(self, frames_per_second: float | None = None) -> Fields:
        """The frames and the path as labels and values, with the rate where it was measured."""
        rate = "" if frames_per_second is None else f", {frames_per_second:.1f} frames/s"
        seen = f"{format_share(self.used_share)} of the pixels within {self.depth_max:g} m"
        long = path_length(self.trajectory.poses)
        fields = [
            ("frames", f"{self.frame_count} on {self.device}{rate}; {seen}"),
            ("path", f"{len(self.trajectory)} of {self.frame_count}, {long:.2f} m long"),
        ]
        for name, numbers in (("lost", self.lost), ("unreadable", self.unreadable), ("uncertain", self.uncertain)):
            if numbers:
                fields.append((name, f"{len(numbers)}: {some_frames(list(numbers))}"))
        if self.deviations:
            fields.append(("deviation", f"{max(self.deviations) * 1000:.0f} mm of a position at worst"))
        if self.residuals:
            residual, fitness = float(np.median(self.residuals)), float(np.median(self.fitness))
            fit = f"{residual * 1000:.1f} mm off the model, {format_share(fitness)} of the depth on it"
            fields.append(("fit", f"{fit} (medians)"))
        return fields


def _median(values: Sequence[float]) -> float | None:
    return float(np.median(values)) if values else None
