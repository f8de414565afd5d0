"""What tracking makes of a sequence of frames: the path, and what became of each frame."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.trajectory import Trajectory
from ...core.dropped_results import returns_new
from ...core.number_runs import some_frames
from ...core.reports import Assessed, Fields, in_columns
from ...core.wording import format_share
from ...files.frames.frames import why_out_of_reach
from ...registration.trajectories.trajectory_error import TrajectoryError
from .joins import MapJoin
from .paths import error_against_truth, path_length

MANY_UNCERTAIN = 0.2  # share of the frames with an uncertain pose, beyond which the path is unreliable


@dataclasses.dataclass(frozen=True, eq=False)
class TrackedPath(Assessed):
    """Where frames were taken, and what became of each, by its number in the sequence, from 0.

    `print(path)` shows its figures, `path.reliable` whether its checks passed.

    Attributes:
        trajectory: The poses of the frames that have one, T_world_camera, in the map that most of them are of; ids hold
            the frames' numbers, and it has timestamps where all those frames have them.
        true_poses: The true pose of each of these, float64 [4, 4] [m], or None where nobody knows it.
        frame_count: How many frames there were.
        uncertain: Frames whose pose is uncertain.
        lost: Frames that could not be placed, and why.
        unreadable: Frames that could not be read, and why.
        residuals: Root mean square distance [m] from the model of each placed frame after the first.
        fitness: Share of its depth that lies on the model.
        depth_share: Share of all pixels that have a depth; 0 where no frame could be read.
        used_share: Share of all pixels that have a depth up to `depth_max`.
        voxel_size: Edge of a voxel of the model that frames were held against [m].
        depth_max: Farther depth was left out [m].
        device: Where it was computed.
        uncertain_reason: The first reason of an uncertain frame; empty if no frame is uncertain.
        stream: What is wrong with the camera's pictures of colour and depth, one against the other; None where nothing
            is known to be.
        deviations: Standard deviation [m] of the position of each placed frame along its most open direction, by what
            the frames on the way left open and by noise.
        drifted: Frames whose position is too uncertain for a pose to be accepted; they are among the uncertain.
        other_maps: As `trajectory`, of each further map, the largest first, in coordinates of its own: the camera was
            lost for long before it, and nothing tells how it lies to the others.
        joins: A MapJoin for each two maps for which a pose was found: what spoke for it, and why it was refused.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> v, u = np.mgrid[:48, :64]
        >>> depth = np.float32(1.0 + 0.1 * np.sin(u / 5) * np.cos(v / 7))
        >>> path = loom.track(loom.frames_from([(None, depth)] * 3, camera))
        >>> path.to_dict()["tracked"], path.lost, path.reliable
        (3, {}, True)
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
    uncertain_reason: str = ""
    stream: str | None = None
    deviations: tuple[float, ...] = ()
    drifted: tuple[int, ...] = ()
    other_maps: tuple[Trajectory, ...] = ()
    joins: tuple[MapJoin, ...] = ()

    def __str__(self) -> str:
        return in_columns([*self.fields(), ("model", f"voxels of {self.voxel_size * 1000:g} mm")])

    @property
    def error(self) -> TrajectoryError | None:
        """ATE and RPE where the frames came with true poses, aligned by a rigid motion; None of fewer than two."""
        return error_against_truth(self.trajectory.poses, self.true_poses)

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks, each with its remedy; empty if the result is reliable."""
        count, reach = self.frame_count, why_out_of_reach(self.depth_share, self.used_share, self.depth_max)
        reasons = [reason for reason in (reach, self.stream) if reason is not None]
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
        if self.other_maps:
            reasons.append(self._apart())
        if len(self.uncertain) - len(drifted) > MANY_UNCERTAIN * count:
            why = self.uncertain_reason
            which = f"{len(self.uncertain)} of {count} poses are uncertain ({some_frames(self.uncertain)})"
            reasons.append(f"{which}: {why}" if why and why != self.stream else which)
        if unreadable := self.unreadable:
            first = next(iter(unreadable.values()))
            reasons.append(f"{len(unreadable)} of {count} frames cannot be read and are left out: {first}")
        return tuple(reasons)

    def _apart(self) -> str:
        """That not all poses lie relative to each other."""
        own = [_numbers(path) for path in self.other_maps]
        told = " and ".join(some_frames(numbers) for numbers in own)
        kind = "a map of their own" if len(own) == 1 else "maps of their own"
        count = f"{1 + len(own)} maps that do not lie relative to each other"
        return f"{count}: {told} are in {kind}, and are left out of the path"

    @returns_new
    def with_poses(self, poses: Sequence[NDArray[np.float64]]) -> TrackedPath:
        """The same with other poses of the frames that have one."""
        told = self.trajectory
        corrected = np.array(poses, np.float64).reshape(-1, 4, 4)
        return dataclasses.replace(self, trajectory=Trajectory(corrected, timestamps=told.timestamps, ids=told.ids))

    def to_dict(self) -> dict[str, Any]:
        """The figures, in JSON's types."""
        return {
            "device": self.device,
            "voxel_size": self.voxel_size,
            "depth_max": self.depth_max,
            "frames": self.frame_count,
            "tracked": len(self.trajectory),
            "uncertain": list(self.uncertain),
            "uncertain_reason": self.uncertain_reason,
            "stream": self.stream,
            "drifted": list(self.drifted),
            "position_deviation_m": max(self.deviations, default=None),
            "lost": [{"frame": number, "reason": reason} for number, reason in self.lost.items()],
            "unreadable": [{"frame": number, "reason": reason} for number, reason in self.unreadable.items()],
            "depth_share": self.depth_share,
            "used_share": self.used_share,
            "residual_m": _median(self.residuals),
            "fitness": _median(self.fitness),
            "other_maps": [
                {"first": numbers[0], "last": numbers[-1], "tracked": len(numbers)}
                for numbers in map(_numbers, self.other_maps)
            ],
            "joined_maps": sum(not join.refused for join in self.joins),
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
        if self.other_maps:
            told = "; ".join(some_frames(_numbers(path)) for path in self.other_maps)
            fields.append(("other maps", f"{len(self.other_maps)}: {told}"))
        if self.residuals:
            residual, fitness = float(np.median(self.residuals)), float(np.median(self.fitness))
            fit = f"{residual * 1000:.1f} mm off the model, {format_share(fitness)} of the depth on it"
            fields.append(("fit", f"{fit} (medians)"))
        return fields


def _numbers(path: Trajectory) -> list[int]:
    """The numbers of a trajectory's frames."""
    return [] if path.ids is None else path.ids[:, 0].tolist()


def _median(values: Sequence[float]) -> float | None:
    return float(np.median(values)) if values else None
