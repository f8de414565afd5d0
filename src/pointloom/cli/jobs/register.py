"""Registration of two cloud files: `register_files` writes the pose and the moved source."""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Unpack

import numpy as np

from ...cameras.pose_files import write_pose
from ...cameras.pose_text import read_pose
from ...core.devices import DeviceLike
from ...core.errors import FileError, FilePath
from ...core.reports import Fields, quality
from ...io.meshes import tables
from ...io.points.by_extension import columns_of
from ...io.points.point_cloud import cloud_of, table_of
from ...io.table import MeshTable, PointTable
from ...pcd.cloud import PointCloud
from ...pcd.point_spacing import probe_points
from ...pcd.units import common_reference
from ...registration.globally.pair import METHODS, PairRegistration, UnfitCloudError, register_pair
from ...registration.icp.constraint import Constraint, Prior
from ...visualization.render.pair_picture import draw_pair
from ...visualization.render.picture_files import check_picture
from .announced_stages import AnnouncedStages
from .job import Job, JobReport, Settings
from .rows import moved_exactly

IDENTITY, GLOBAL = "identity", "global"

_REMEDIES = {
    "colors": "Choose another --method, such as point-to-plane",
    "voxels": "Use a smaller --voxel, or a cloud with more points",
}


@dataclass(frozen=True)
class RegisterReport(JobReport):
    """Report of `register_files`. The `init` of `registration` is as given by the user."""

    target: str
    device: str
    registration: PairRegistration

    def to_dict(self) -> dict[str, Any]:
        report = super().to_dict()
        return report | report.pop("registration") | quality(self)

    def fields(self) -> Fields:
        return [*self.registration.fields(), *self.closing(self.device)]


@dataclass(frozen=True)
class RegisterOutputs:
    """Files that `register_files` writes.

    Attributes:
        pose: A .txt file for T_target_source, 4 rows of 4 numbers with all digits.
        aligned: File for the moved source with all attributes.
        picture: A .png file of both clouds before (left) and after (right).
    """

    pose: FilePath | None = None
    aligned: FilePath | None = None
    picture: FilePath | None = None

    def check(self, job: Job) -> None:
        job.check(self.pose, (".txt",), what="poses")
        job.check(self.aligned)
        if self.picture is not None:
            check_picture(self.picture, overwrite=job.form["overwrite"])

    def write(
        self, job: Job, stored: PointTable, clouds: tuple[PointCloud, PointCloud], T: np.ndarray, target: FilePath
    ) -> None:
        """Write the pose, the `stored` source moved in float64, and the picture."""
        form = job.form
        if self.pose is not None:
            write_pose(self.pose, T, overwrite=form["overwrite"])
            job.wrote(self.pose)
        if self.aligned is not None:
            table = moved_exactly(stored, table_of(clouds[0].transform(T)), T)
            left_out = tables.write_cloud_table(self.aligned, table, source=target, system_only=True, **form)
            job.wrote(self.aligned, left_out)
        if self.picture is not None:
            draw_pair(self.picture, *clouds, T, overwrite=form["overwrite"])
            job.wrote(self.picture)


@dataclass(frozen=True)
class MotionLimits:
    """Free motions of the source, and a file with a known pose.

    `sigma` are the standard deviations of its translation [m] and rotation [degrees].
    """

    free: Sequence[str] | None = None
    prior: FilePath | None = None
    sigma: tuple[float, float] | None = None

    def constraint(self) -> Constraint:
        """Read the prior pose. Raises FileError, or ValueError for a pose without deviations or the reverse."""
        if self.prior is None and self.sigma is None:
            return Constraint(self.free)
        if self.prior is None or self.sigma is None:
            raise ValueError("prior, prior_sigma: expected both or none, the known pose and its uncertainty")
        translation, rotation = self.sigma
        prior = Prior(read_pose(self.prior), sigma_translation=translation, sigma_rotation=math.radians(rotation))
        return Constraint(self.free, prior=prior)


def register_files(
    source: FilePath,
    target: FilePath,
    *,
    outputs: RegisterOutputs | None = None,
    init: FilePath = GLOBAL,
    method: str = "point-to-plane",
    voxel_size: float | None = None,
    max_correspondence_distance: float | None = None,
    motions: MotionLimits | None = None,
    **settings: Unpack[Settings],
) -> RegisterReport:
    """Register a source file to a target file. Outputs are checked first, and not written without correspondences.

    Args:
        init: "global", "identity", or a file with an initial pose.
    """
    if method not in METHODS:
        raise ValueError(f"method: expected one of {', '.join(METHODS)}, got {method!r}")
    job, outputs, motions = Job("register", source, **settings), outputs or RegisterOutputs(), motions or MotionLimits()
    outputs.check(job)
    where, start, constraint = job.device, _start(init), motions.constraint()
    with job.stage("read"):
        first, second = columns_of([source, target], settings.get("columns"))
        stored, cloud = read_with_table(source, where, first)
        clouds = cloud, read_cloud(target, where, second)
    job.unit = common_reference("source, target", clouds)[0]
    try:
        with AnnouncedStages(job.clock, job.progress, silent=("voxels", "rate")) as stages:
            options: dict[str, Any] = {"method": method, "voxel_size": voxel_size}
            options["max_correspondence_distance"] = max_correspondence_distance
            registration = register_pair(*clouds, init=start, constraint=constraint, progress=stages, **options)
    except UnfitCloudError as error:
        path = source if error.role == "source" else target
        reason = error.reason.replace(f"method={method!r}", f"--method {method}")
        raise FileError(path, reason, remedy=_REMEDIES[error.lacks]) from error
    with job.stage("write"):
        if registration.result.fitness > 0:
            outputs.write(job, stored, clouds, registration.transformation, target)
    return RegisterReport(
        job.done(_warning(registration, str(init))),
        os.fspath(target),
        str(where),
        replace(registration, init=os.fspath(init)),
    )


def read_cloud(path: FilePath, device: DeviceLike, columns: Sequence[str] | None = None) -> PointCloud:
    """A cloud with all attributes, or the vertices of a mesh. Raises FileError without finite points."""
    return read_with_table(path, device, columns)[1]


def read_with_table(
    path: FilePath, device: DeviceLike, columns: Sequence[str] | None = None
) -> tuple[PointTable, PointCloud]:
    """The points as stored in a file, and the cloud of `read_cloud`."""
    table = tables.read_table(path, columns)
    points = tables.points_of(table) if isinstance(table, MeshTable) else table
    cloud = cloud_of(points, path, device=device)
    if not len(probe_points(cloud)):
        contents = f"{len(cloud):,} points, all of them not finite" if len(cloud) else "no points"
        raise FileError(path, f"expected finite points, got {contents}", remedy="Pass another cloud")
    return points, cloud


def _start(init: FilePath) -> np.ndarray | None:
    """The initial pose. None for a search."""
    if str(init) == GLOBAL:
        return None
    return np.eye(4) if str(init) == IDENTITY else read_pose(init)


def _warning(registration: PairRegistration, init: str) -> str | None:
    if registration.reliable:
        return None
    written = "" if registration.result.fitness > 0 else "; nothing was written"
    return (
        f"{'; '.join(registration.warnings)}{written}; try {'another --voxel' if init == GLOBAL else '--init global'}"
    )
