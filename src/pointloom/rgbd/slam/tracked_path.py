"""Result of tracking: the trajectory, and the status of each frame."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.trajectory import Trajectory
from ...core.dropped_results import returns_new
from ...core.number_ranges import some_frames
from ...core.reports import Assessed, Fields, in_columns, quality
from ...core.wording import format_fraction, plain
from ...io.frames.frames import why_out_of_range
from ...registration.pose_errors import PoseCovariance
from ...registration.trajectories.trajectory_error import TrajectoryError
from .camera_check import FocalCheck
from .map_joins import MapJoin
from .path_statistics import error_against_truth, path_length
from .results import rotated_covariance

MANY_UNCERTAIN = 0.2  # fraction of uncertain frames above which the path is unreliable


@dataclasses.dataclass(frozen=True, eq=False)
class TrackedPath(Assessed):
    """Result of `track`. Frames are numbered from 0.

    Attributes:
        trajectory: Known poses T_world_camera of the largest map. Ids are frame numbers. Timestamps if all have them.
        true_poses: The true pose of each, float64 [4, 4] [m], or None if unknown.
        frame_count: Number of frames.
        uncertain: Frames with an uncertain pose.
        lost: Lost frames, with the reason.
        unreadable: Unreadable frames, with the reason.
        residuals: Root mean square distance [m] of each tracked frame (after the first) from the model.
        fitness: Fraction of its depth on the model.
        depth_fraction: Fraction of all pixels with depth. 0 if no frame could be read.
        used_fraction: Fraction of all pixels with depth up to `depth_max`.
        voxel_size: Voxel edge of the model [m].
        depth_max: Maximum depth [m].
        device: Compute device.
        uncertain_warning: Warning of the first uncertain frame, or empty.
        stream: Inconsistency of the color and depth streams, or None.
        covered: Lost frames of blank gaps up to half a second, after which tracking resumed. They do not make the path
            unreliable.
        notes: Remarks that do not concern reliability: covered frames, objects fixed to the camera, and colors
            that are not exactly registered to depth.
        deviations: Accumulated standard deviation [m] of each position along its least determined direction.
        pose_covariances: Covariance of each pose of `trajectory` relative to the first one, which has zero: rotation
            [rad], then translation [m], along the axes of the first camera, about the position of the pose. Lost frames
            have no pose and no covariance. Loop closure moves the covariances with the poses, but does not reduce them.
        drifted: Uncertain frames whose accumulated deviation is too large.
        other_maps: As `trajectory`, of each further map in its own coordinates, the largest first, after the camera was
            lost for long.
        source_warnings: Failed checks of the frames: an assumed or implausible camera, or mostly unpaired images.
        camera: Whether stored views fit better with another camera. None if they do not determine it.
        joins: A MapJoin for each two maps with a relative pose: the evidence, and the reason if rejected.
    """

    trajectory: Trajectory
    true_poses: tuple[NDArray[np.float64] | None, ...]
    frame_count: int
    uncertain: tuple[int, ...]
    lost: dict[int, str]
    unreadable: dict[int, str]
    residuals: tuple[float, ...]
    fitness: tuple[float, ...]
    depth_fraction: float
    used_fraction: float
    voxel_size: float
    depth_max: float
    device: str
    uncertain_warning: str = ""
    stream: str | None = None
    deviations: tuple[float, ...] = ()
    pose_covariances: tuple[PoseCovariance, ...] = ()
    drifted: tuple[int, ...] = ()
    other_maps: tuple[Trajectory, ...] = ()
    joins: tuple[MapJoin, ...] = ()
    covered: tuple[int, ...] = ()
    notes: tuple[str, ...] = ()
    source_warnings: tuple[str, ...] = ()
    camera: FocalCheck | None = None

    def __str__(self) -> str:
        return in_columns([*self.fields(), ("model", f"voxels of {self.voxel_size * 1000:g} mm")])

    @property
    def error(self) -> TrajectoryError | None:
        """The error for a path that cannot be used."""
        return error_against_truth(self.trajectory.poses, self.true_poses)

    @property
    def warnings(self) -> tuple[str, ...]:
        count, range_warning = (
            self.frame_count,
            why_out_of_range(self.depth_fraction, self.used_fraction, self.depth_max),
        )
        reasons = [reason for reason in (range_warning, self.stream) if reason is not None]
        if lost := {number: reason for number, reason in self.lost.items() if number not in self.covered}:
            first = next(iter(lost.values()))
            reasons.append(
                f"{len(lost)} of {count} frames were lost ({some_frames(list(lost))}) and are left out: {first}"
            )
        if drifted := self.drifted:
            reasons.append(
                f"{len(drifted)} of {count} positions have an uncertainty of up to {max(self.deviations):.2f} m, "
                f"accumulated along the path ({some_frames(drifted)})"
            )
        if self.other_maps:
            reasons.append(self._apart())
        if len(self.uncertain) - len(drifted) > MANY_UNCERTAIN * count:
            why = self.uncertain_warning
            which = f"{len(self.uncertain)} of {count} poses are uncertain ({some_frames(self.uncertain)})"
            reasons.append(f"{which}: {why}" if why and why != self.stream else which)
        if unreadable := self.unreadable:
            first = next(iter(unreadable.values()))
            reasons.append(f"{len(unreadable)} of {count} frames cannot be read and are left out: {first}")
        return (*reasons, *self.source_warnings, *(() if self.camera is None else self.camera.warnings))

    def _apart(self) -> str:
        numbers_by_map = [_numbers(path) for path in self.other_maps]
        frame_lists = " and ".join(some_frames(numbers) for numbers in numbers_by_map)
        kind = "a separate map" if len(numbers_by_map) == 1 else "separate maps"
        count = f"{1 + len(numbers_by_map)} maps without known relative poses"
        return f"{count}: {frame_lists} are in {kind} and are left out of the path"

    @returns_new
    def with_poses(self, poses: Sequence[NDArray[np.float64]] | NDArray[np.float64]) -> TrackedPath:
        """The same path with other poses."""
        original = self.trajectory
        corrected = np.array(poses, np.float64).reshape(-1, 4, 4)
        trajectory = Trajectory(corrected, timestamps=original.timestamps, ids=original.ids, crs=original.crs)
        moved = tuple(
            PoseCovariance(rotated_covariance(one.matrix, before, after), after[:3, 3].copy())
            for one, before, after in zip(
                self.pose_covariances, original.poses, corrected, strict=bool(self.pose_covariances)
            )
        )
        return dataclasses.replace(self, trajectory=trajectory, pose_covariances=moved)

    def to_dict(self) -> dict[str, Any]:
        return {
            "device": self.device,
            "voxel_size": self.voxel_size,
            "depth_max": self.depth_max,
            "frames": self.frame_count,
            "tracked": len(self.trajectory),
            "uncertain": list(self.uncertain),
            "uncertain_warning": self.uncertain_warning,
            "stream": self.stream,
            "drifted": list(self.drifted),
            "position_deviation_m": max(self.deviations, default=None),
            "poses": [
                {"frame": number, "sigma_position": one.sigmas[3:].tolist(), "sigma_rotation": one.sigmas[:3].tolist()}
                for number, one in zip(
                    _numbers(self.trajectory), self.pose_covariances, strict=bool(self.pose_covariances)
                )
            ],
            "lost": [{"frame": number, "reason": reason} for number, reason in self.lost.items()],
            "unreadable": [{"frame": number, "reason": reason} for number, reason in self.unreadable.items()],
            "depth_fraction": self.depth_fraction,
            "used_fraction": self.used_fraction,
            "residual_m": _median(self.residuals),
            "fitness": _median(self.fitness),
            "other_maps": [
                {"first": numbers[0], "last": numbers[-1], "tracked": len(numbers)}
                for numbers in map(_numbers, self.other_maps)
            ],
            "joined_maps": sum(not join.refused for join in self.joins),
            "path_length_m": path_length(self.trajectory.poses),
            "notes": list(self.notes),
            "camera_check": plain(self.camera),
            **quality(self),
        }

    def fields(self, frames_per_second: float | None = None) -> Fields:
        rate = "" if frames_per_second is None else f", {frames_per_second:.1f} frames/s"
        seen = f"{format_fraction(self.used_fraction)} of the pixels within {self.depth_max:g} m"
        long = path_length(self.trajectory.poses)
        fields = [
            ("frames", f"{self.frame_count} on {self.device}{rate}; {seen}"),
            ("path", f"{len(self.trajectory)} of {self.frame_count}, {long:.2f} m long"),
        ]
        for name, numbers in (("lost", self.lost), ("unreadable", self.unreadable), ("uncertain", self.uncertain)):
            if numbers:
                fields.append((name, f"{len(numbers)}: {some_frames(list(numbers))}"))
        if self.deviations:
            fields.append(("deviation", f"{max(self.deviations) * 1000:.0f} mm of a position at most"))
        if self.other_maps:
            frame_lists = "; ".join(some_frames(_numbers(path)) for path in self.other_maps)
            fields.append(("other maps", f"{len(self.other_maps)}: {frame_lists}"))
        if self.residuals:
            residual, fitness = float(np.median(self.residuals)), float(np.median(self.fitness))
            fit = f"{residual * 1000:.1f} mm off the model, {format_fraction(fitness)} of the depth on it"
            fields.append(("fit", f"{fit} (medians)"))
        return [*fields, *(("note", note) for note in self.notes)]


def _numbers(path: Trajectory) -> list[int]:
    return [] if path.ids is None else path.ids[:, 0].tolist()


def _median(values: Sequence[float]) -> float | None:
    return float(np.median(values)) if values else None
