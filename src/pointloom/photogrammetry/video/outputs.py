"""Output files of a video reconstruction: the mesh, and optionally cloud, poses, image, training folder, maps."""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import dataclass, fields
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ...cameras.pose_files import check_trajectory_output, write_poses
from ...core.atomic import check_folder
from ...core.checks import check_positive
from ...core.errors import FileError, FilePath
from ...core.outputs import check_output
from ...core.up_axis import check_up
from ...io.meshes.mesh_formats import MESH_FORMATS
from ...io.meshes.tables import write_cloud_table, write_mesh_table
from ...io.points.formats import WRITTEN
from ...io.points.ply import write_ply, write_ply_mesh
from ...io.points.point_cloud import table_of
from ...meshing.mesh.conversion import mesh_table
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.scene.orthophoto import orthophoto
from ...meshing.scene.plan_grid import grid_over
from ...pcd.cloud import PointCloud
from ...pcd.geotiff import check_geotiff
from ...visualization.render.picture_files import check_picture
from ...visualization.render.scene_view import draw_scene
from ..sfm.image_folder import check_path
from ..sfm.training_folder import TRANSFORMS, TrainingFolder, write_training_folder
from .motion import IMAGES, masks_of
from .result import VideoResult
from .surface import poses_of
from .units import Fit, VideoUnits


@dataclass(frozen=True)
class VideoOutputs:
    """Output files of a video reconstruction. None if not requested.

    Attributes:
        mesh: The mesh, in a format of `write_triangle_mesh`. STL has no colors.
        cloud: The fused points, in a format of `write_point_cloud`.
        trajectory: The poses, as TUM or Open3D's .log.
        picture: Image of the mesh, .png.
        training: Folder of `photogrammetry.write_training_folder`, at full image size, in the mesh frame.
        ortho: Orthophoto of the mesh, a GeoTIFF (.tif) in UTM. Requires georeferenced photographs and `cell`.
        dem: Elevation model, likewise.
        cell: Cell size of both [m].
        up: Up axis of the mesh, "y" or "z". If None: z with GPS, else that of the cameras, level in most images.

    Raises:
        TypeError, ValueError: Not a path or a length; `cell` without maps or vice versa; named in the message.

    Example:
        >>> import pointloom as loom
        >>> loom.photogrammetry.VideoOutputs(mesh="room.ply", picture="room.png").cloud is None
        True
    """

    mesh: FilePath | None = None
    cloud: FilePath | None = None
    trajectory: FilePath | None = None
    picture: FilePath | None = None
    training: FilePath | None = None
    ortho: FilePath | None = None
    dem: FilePath | None = None
    cell: float | None = None
    up: str | None = None

    def __post_init__(self):
        for field in fields(self):
            if field.name not in ("cell", "up") and getattr(self, field.name) is not None:
                check_path(field.name, getattr(self, field.name))
        if self.up is not None:
            check_up(self.up)
        if self.cell is not None:
            object.__setattr__(self, "cell", check_positive("cell", self.cell))
        if self._maps and self.cell is None:
            raise ValueError("cell: expected the cell size [m] of ortho and dem, got None")
        if self.cell is not None and not self._maps:
            raise ValueError("cell: only used with ortho or dem; give one of them, or leave it out")

    def check(self, *, overwrite: bool) -> None:
        """Check before any work that all files can be written.

        Raises:
            FileError: One cannot be written, or two are the same file.
        """
        if self.mesh is not None:
            check_output(self.mesh, MESH_FORMATS, what="meshes", overwrite=overwrite)
        if self.cloud is not None:
            check_output(self.cloud, WRITTEN, what="clouds", overwrite=overwrite)
        if self.trajectory is not None:
            check_trajectory_output(self.trajectory, overwrite=overwrite)
        if self.picture is not None:
            check_picture(self.picture, overwrite=overwrite)
        if self.training is not None:
            check_folder(self.training, TRANSFORMS, overwrite=overwrite)
        for path in self._maps:
            check_geotiff(path, overwrite=overwrite)
        taken: set[Path] = set()
        for path in self._all():
            if Path(path).resolve() in taken:
                raise FileError(path, "is given for two outputs", remedy="Give each output its own name")
            taken.add(Path(path).resolve())

    def check_units(self, units: VideoUnits) -> None:
        """Check before any work that maps can be georeferenced.

        Raises:
            FileError: They cannot.
        """
        if self._maps and not units.may_place:
            raise self._not_georeferenced("no input determines the position of the model on the Earth")

    def check_fit(self, fit: Fit, points: NDArray[np.float64]) -> None:
        """Check that maps can be made, before the mesh is computed.

        Args:
            fit: The georeference of the model.
            points: Points of the model in that frame, shape [n, 3].

        Raises:
            FileError, ValueError: The model is not georeferenced, or the maps would have too many cells.
        """
        if self._maps and fit.frame is None:
            raise self._not_georeferenced("the given data do not determine the position of the model on the Earth")
        if self.cell is not None and len(points):
            low, high = np.percentile(points[:, :2], (5, 95), axis=0)  # ignores outliers
            grid_over(low, high, np.zeros(2), self.cell)

    def _not_georeferenced(self, reason: str) -> FileError:
        remedy = "Give a folder of photographs with GPS, or --control in a known system; or leave --ortho and --dem out"
        return FileError(self._maps[0], f"is a map, but {reason}", remedy=remedy)

    def write(self, result: VideoResult, *, overwrite: bool) -> tuple[str, ...]:
        """Write the outputs of a result with a mesh. Returns the file names.

        Raises:
            FileError: One cannot be written.
        """
        assert result.mesh is not None and result.cloud is not None and result.model is not None
        assert result.fit is not None
        path, comments = poses_of(result.model), result.fit.comments
        if self.mesh is not None:
            _write_mesh(self.mesh, result.mesh, comments, overwrite=overwrite)
        if self.cloud is not None:
            _write_cloud(self.cloud, result.cloud, comments, overwrite=overwrite)
        if self.trajectory is not None:
            write_poses(self.trajectory, path, overwrite=overwrite)
        if self.picture is not None:
            draw_scene(self.picture, result.mesh, path.poses, overwrite=overwrite)
        if self.cell is not None:
            made = orthophoto(result.mesh, self.cell, frame=result.fit.frame)
            if self.ortho is not None:
                made.write(self.ortho, overwrite=overwrite)
            if self.dem is not None:
                made.heights.write(self.dem, overwrite=overwrite)
        return tuple(os.fspath(each) for each in self._all())

    def write_training(self, result: VideoResult, frames: Path, *, overwrite: bool) -> TrainingFolder | None:
        """Write the training folder if requested.

        Args:
            result: A result with a model.
            frames: The record of the frames stage: the model's images and masks.
            overwrite: Replace such a folder.

        Raises:
            FileError: It cannot be written.
        """
        if self.training is None or result.model is None:
            return None
        given = {"masks": masks_of(frames), "device": result.device, "overwrite": overwrite}
        return write_training_folder(self.training, result.model, frames / IMAGES, **given)

    @property
    def _maps(self) -> list[FilePath]:
        return [path for path in (self.ortho, self.dem) if path is not None]

    def _all(self) -> Iterator[FilePath]:
        paths = (self.mesh, self.cloud, self.trajectory, self.picture, self.training, self.ortho, self.dem)
        return (path for path in paths if path is not None)


def _write_mesh(path: FilePath, mesh: TriangleMesh, comments: list[str], *, overwrite: bool) -> None:
    if Path(path).suffix.lower() == ".ply":
        write_ply_mesh(path, mesh_table(mesh), overwrite=overwrite, comments=comments)
    else:
        write_mesh_table(path, mesh_table(mesh), overwrite=overwrite)


def _write_cloud(path: FilePath, cloud: PointCloud, comments: list[str], *, overwrite: bool) -> None:
    if Path(path).suffix.lower() == ".ply":
        write_ply(path, table_of(cloud), overwrite=overwrite, comments=comments)
    else:
        write_cloud_table(path, table_of(cloud), overwrite=overwrite)
