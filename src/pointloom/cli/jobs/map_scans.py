"""Map of LiDAR scans with closed loops: `map_of_scans`."""

from __future__ import annotations

import contextlib
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple, Unpack

from ...cameras.trajectory import Trajectory, write_trajectory
from ...core.errors import FileError, FilePath
from ...core.reports import Fields, quality, values_of
from ...core.wording import format_seconds, plain
from ...registration.lidar.lidar_slam import LidarSLAM
from ...registration.lidar.slam_summary import LidarSLAMSummary
from .job import Job, JobReport, Settings
from .odometry import check_poses_output, register_scans
from .scan_source import ScanSource

if TYPE_CHECKING:
    from ...visualization.viewer.viewer import Viewer


class MapOutputs(NamedTuple):
    """Files of a map: the cloud, corrected poses (.txt or .tum, .log, .kitti), and a picture from above with loops."""

    cloud: FilePath
    trajectory: FilePath | None = None
    picture: FilePath | None = None


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
            ("seconds", f"{format_seconds(self.done.seconds)} on {self.device}"),
            ("files", ", ".join(self.done.files) or "none"),
        ]

    @property
    def notes(self) -> tuple[str, ...]:
        return (*super().notes, *self.result.notes)


def map_of_scans(
    folder: FilePath,
    outputs: MapOutputs,
    *,
    voxel_size: float | None = None,
    max_range: float = 100.0,
    min_range: float = 5.0,
    submap_length: float | None = None,
    topics: tuple[str | None, str | None] = (None, None),
    viewer: Viewer | None = None,
    **settings: Unpack[Settings],
) -> MapReport:
    """Map the scans of a folder or recording with `LidarSLAM`. Outputs are checked before the work.

    Nothing is written if no scan has points in range.

    Args:
        folder, topics: As of `odometry_of_folder`.
        outputs: The files to write.
        voxel_size, max_range, min_range, submap_length: As of `LidarSLAM`.
        viewer: Shows the map while it grows.
    """
    job, (output, trajectory, picture) = Job("map", folder, **settings), outputs
    job.check(output)
    form = "" if trajectory is None else check_poses_output(job, trajectory, None)
    if picture is not None:
        from ...visualization.render.plots import check_plot

        check_plot(picture, overwrite=job.form["overwrite"])
    sizes: dict[str, Any] = {"voxel_size": voxel_size, "max_range": max_range, "min_range": min_range}
    slam = LidarSLAM(submap_length=submap_length, device=job.device, **sizes)
    scans = ScanSource.open(folder, topics[0], settings.get("columns"), job.device, imu=topics[1])
    if scans.count < 2:
        raise FileError(folder, f"expected at least two scans, got {scans.first} only", remedy="Pass another folder")
    with contextlib.nullcontext() if viewer is None else viewer.follow(slam):
        points = register_scans(job, slam, scans)
        slam.finish()
    summary, cloud = slam.summary, slam.map
    if summary.odometry.has_seen:
        job.write_cloud(cloud, output)
        if trajectory is not None:
            with job.stage("write", reported=False):
                write_trajectory(trajectory, Trajectory(slam.poses), format=form, overwrite=job.form["overwrite"])
            job.wrote(trajectory)
        if picture is not None:
            _draw(job, slam, picture)
    done = job.done(*summary.warnings)
    settings_used = slam.odometry.voxel_size, max_range, min_range, slam.submap_length
    return MapReport(done, str(job.device), *settings_used, summary, points, len(cloud))


def _draw(job: Job, slam: LidarSLAM, picture: FilePath) -> None:
    from ...visualization.render.picture_files import write_image
    from ...visualization.render.plots import map_plan

    with job.stage("draw"):
        poses = [submap.T_world_submap[:3, 3] for submap in slam.submaps]
        loops = [(poses[loop.source], poses[loop.target]) for loop in slam.loops if loop.reliable]
        image = map_plan(slam.map.points, slam.poses[:, :3, 3], loops)
        write_image(picture, image, overwrite=job.form["overwrite"])
    job.wrote(picture)
