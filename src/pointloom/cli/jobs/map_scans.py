"""Map of LiDAR scans with closed loops: `map_of_scans`."""

from __future__ import annotations

import contextlib
import math
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, Unpack

import numpy as np
from numpy.typing import NDArray

from ...cameras.trajectory import Trajectory, write_trajectory
from ...core.coordinate_systems import check_crs
from ...core.errors import FileError, FilePath
from ...core.reports import Fields, quality, values_of
from ...core.wording import format_seconds, plain
from ...kernels.linear_algebra import matmul
from ...registration.lidar.lidar_slam import LidarSLAM
from ...registration.lidar.slam_summary import LidarSLAMSummary
from .job import Job, JobReport, Settings
from .odometry import check_poses_output, register_scans
from .recorded_positions import read_positions
from .scan_source import ScanSource

if TYPE_CHECKING:
    from ...visualization.viewer.viewer import Viewer


Rows = NDArray[np.float64]


class MapOutputs(NamedTuple):
    """Files of a map: the cloud, corrected poses, and a picture from above with loops.

    `folder` is for the submaps and their graph, which a later session can continue.
    """

    cloud: FilePath
    trajectory: FilePath | None = None
    picture: FilePath | None = None
    folder: FilePath | None = None


class MapInputs(NamedTuple):
    """Data besides the scans: topics as of `odometry_of_folder`, a file of positions, and the folder of a map.

    `positions` is as of `read_positions`, with the sigma [m] for files without. `crs` is their coordinate system, in
    which the cloud and the path are then written. `earlier` is the `folder` of earlier sessions, which is continued
    with the sizes of its map.
    """

    topics: tuple[str | None, str | None] = (None, None)
    positions: FilePath | None = None
    position_sigma: float = 1.0
    crs: str | None = None
    earlier: FilePath | None = None


SCANS_ONLY = MapInputs()


@dataclass(frozen=True)
class MapReport(JobReport):
    """Report of `map_of_scans`."""

    device: str
    voxel_size: float
    max_range: float
    min_range: float
    submap_length: float
    result: LidarSLAMSummary
    points: int
    map_points: int
    T_reference_world: list[list[float]] | None
    position_notes: tuple[str, ...] = ()

    @property
    def scans_per_second(self) -> float:
        return self.result.odometry.scan_count / max(self.done.seconds["register"], 1e-9)

    def to_dict(self) -> dict[str, Any]:
        found = self.result.to_dict()
        found["submap_points"] = found.pop("points")
        own = {name: value for name, value in values_of(self).items() if name not in ("done", "result")}
        ending = {"seconds": self.done.seconds, "files": self.done.files, **quality(self)}
        beginning = {"command": self.done.command, "folder": self.done.source}
        return plain(beginning | own | {"scans_per_second": self.scans_per_second} | found | ending)

    def fields(self) -> Fields:
        (_, scans), *path = self.result.fields()
        ranges = f"from {self.min_range:g} to {self.max_range:g} m"
        return [
            ("scans", f"{scans}, {self.points:,} points, {self.scans_per_second:.1f} scans/s"),
            ("map", f"{self.map_points:,} points, voxels of {self.voxel_size:g} m, points {ranges}"),
            *path,
            *([] if self.T_reference_world is None else [("reference", _shown_pose(self.T_reference_world))]),
            ("seconds", f"{format_seconds(self.done.seconds)} on {self.device}"),
            ("files", ", ".join(self.done.files) or "none"),
        ]

    @property
    def notes(self) -> tuple[str, ...]:
        return (*super().notes, *self.result.notes, *self.position_notes)


def map_of_scans(
    folder: FilePath,
    outputs: MapOutputs,
    *,
    voxel_size: float | None = None,
    max_range: float = 100.0,
    min_range: float = 5.0,
    submap_length: float | None = None,
    inputs: MapInputs = SCANS_ONLY,
    viewer: Viewer | None = None,
    **settings: Unpack[Settings],
) -> MapReport:
    """Map the scans of a folder or recording with `LidarSLAM`. Outputs are checked before the work.

    Nothing is written if no scan has points in range.

    Args:
        folder: As of `odometry_of_folder`.
        outputs: The files to write.
        inputs: Topics, positions and an earlier map.
        voxel_size, max_range, min_range, submap_length: As of `LidarSLAM`.
        viewer: Shows the map while it grows.
    """
    job, (output, trajectory, picture, submaps) = Job("map", folder, **settings), outputs
    job.check(output)
    form = "" if trajectory is None else check_poses_output(job, trajectory, None)
    if picture is not None:
        from ...visualization.render.plots import check_plot

        check_plot(picture, overwrite=job.form["overwrite"])
    system = check_crs("--crs", inputs.crs)
    topic, imu = inputs.topics
    given = read_positions(inputs.positions, inputs.position_sigma, folder, topic, system)
    scans = ScanSource.open(
        folder, topic, settings.get("columns"), job.device, imu=imu, is_numbered=given.readings is not None
    )
    if scans.count < 2:
        raise FileError(folder, f"expected at least two scans, got {scans.first} only", remedy="Pass another folder")
    if inputs.earlier is None:
        sizes: dict[str, Any] = {"voxel_size": voxel_size, "max_range": max_range, "min_range": min_range}
        slam = LidarSLAM(submap_length=submap_length, folder=submaps, device=job.device, **sizes)
    else:
        slam = LidarSLAM.open(inputs.earlier, device=job.device)
    with contextlib.nullcontext() if viewer is None else viewer.follow(slam):
        points, times = register_scans(job, slam, scans, given.readings)
        slam.finish()
    summary, cloud, poses, T = slam.summary, slam.map, slam.poses, slam.T_reference_world
    undetermined, placed = None, np.eye(4)
    if system is not None and T is not None:
        cloud, poses, placed = cloud.transform(T), matmul(T, poses), T
        cloud.crs = system
    elif system is not None:
        undetermined = (
            "the positions do not determine the pose of the map: it has the frame of the first scan, no --crs"
        )
    if summary.odometry.has_seen:
        job.write_cloud(cloud, output)
        if trajectory is not None:
            with job.stage("write", reported=False):
                path = Trajectory(poses, times)
                write_trajectory(trajectory, path, format=form, overwrite=job.form["overwrite"])
            job.wrote(trajectory)
        if picture is not None:
            frame = "first scan" if cloud.crs is None else cloud.crs.name
            _draw(job, slam, picture, cloud.points, placed, frame)
        if slam.folder is not None:
            job.wrote(slam.folder)
    done, used = job.done(*summary.warnings, undetermined), slam.odometry
    settings_used = used.voxel_size, used.max_range, used.min_range, slam.submap_length
    reference = None if T is None else T.tolist()
    return MapReport(done, str(job.device), *settings_used, summary, points, len(cloud), reference, given.notes)


def _shown_pose(T: list[list[float]]) -> str:
    position = " ".join(f"{row[3]:.2f}" for row in T[:3])
    return f"the first scan is at {position} m, heading {math.degrees(math.atan2(T[1][0], T[0][0])):.1f} degrees"


def _draw(job: Job, slam: LidarSLAM, picture: FilePath, points: Rows, T_frame_world: Rows, frame: str) -> None:
    """`points` of the map are in the named frame."""
    from ...visualization.render.picture_files import write_image
    from ...visualization.render.plots import map_plan

    with job.stage("draw"):
        poses = matmul(T_frame_world, slam.poses)
        places = [matmul(T_frame_world, submap.T_world_submap)[:3, 3] for submap in slam.submaps]
        loops = [(places[loop.source], places[loop.target]) for loop in slam.loops if loop.reliable]
        title = f"{Path(job.source).name}: {len(poses):,} scans, frame: {frame}"
        write_image(picture, map_plan(points, poses[:, :3, 3], loops, title), overwrite=job.form["overwrite"])
    job.wrote(picture)
