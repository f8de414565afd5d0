"""What the job leaves outside its own folder: the mesh, and on request the cloud, the poses, a picture."""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import dataclass, fields
from pathlib import Path

from ...cameras.pose_files import check_trajectory_output, write_poses
from ...core.atomic import check_folder
from ...core.errors import FileError, FilePath
from ...core.outputs import check_output
from ...drawing.render.picture_files import check_picture
from ...drawing.render.scene_view import draw_scene
from ...files.meshes.tables import MESHES, write_cloud_table, write_mesh_table
from ...files.points.formats import WRITTEN
from ...files.points.ply import write_ply, write_ply_mesh
from ...files.points.point_cloud import table_of
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.mesh.mesh_files import mesh_table
from ...pcd.cloud import PointCloud
from ..sfm.picture_folder import check_place
from ..sfm.training_folder import TRANSFORMS, TrainingFolder, write_training_folder
from .motion import MASKS, PICTURES
from .result import VideoResult
from .surface import poses_of


@dataclass(frozen=True)
class Outputs:
    """Files to be written of a video; None where one is not asked for.

    Attributes:
        mesh: .ply, .obj, .stl, .off, .glb or .gltf; STL holds no colours, which are then left out.
        cloud: Of the fused points.
        trajectory: Of the poses, .log, .txt or .tum (TUM's format).
        picture: Of the mesh, .png.
        training: A folder that gsplat, 3DGS and nerfstudio train from, as `sfm.write_training_folder` writes it: the
            pictures at their full size, straightened, in the frame of the mesh.

    Raises:
        TypeError, ValueError: No path; the error names it.

    Example:
        >>> import pointloom as loom
        >>> loom.video.Outputs(mesh="room.ply", picture="room.png").cloud is None
        True
    """

    mesh: FilePath | None = None
    cloud: FilePath | None = None
    trajectory: FilePath | None = None
    picture: FilePath | None = None
    training: FilePath | None = None

    def __post_init__(self):
        for field in fields(self):
            if getattr(self, field.name) is not None:
                check_place(field.name, getattr(self, field.name))

    def check(self, *, overwrite: bool) -> None:
        """Hold that all can be written, before any work.

        Raises:
            FileError: One cannot, or two are one file.
        """
        if self.mesh is not None:
            check_output(self.mesh, MESHES, what="meshes", overwrite=overwrite)
        if self.cloud is not None:
            check_output(self.cloud, tuple(WRITTEN), what="clouds", overwrite=overwrite)
        if self.trajectory is not None:
            check_trajectory_output(self.trajectory, overwrite=overwrite)
        if self.picture is not None:
            check_picture(self.picture, overwrite=overwrite)
        if self.training is not None:
            check_folder(self.training, TRANSFORMS, overwrite=overwrite)
        taken: set[Path] = set()
        for path in self._all():
            if Path(path).resolve() in taken:
                raise FileError(path, "is given for two outputs", remedy="Give each a name of its own")
            taken.add(Path(path).resolve())

    def write(self, result: VideoResult, *, overwrite: bool) -> tuple[str, ...]:
        """Write what a result with a mesh holds; gives the names of the files.

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
        return tuple(os.fspath(each) for each in self._all())

    def write_training(self, result: VideoResult, frames: Path, *, overwrite: bool) -> TrainingFolder | None:
        """Write the folder to train from, where one is asked for.

        Args:
            result: With a model.
            frames: What the stage of that name left: the pictures of the model, and their masks.
            overwrite: Replace such a folder.

        Raises:
            FileError: It cannot be written.
        """
        if self.training is None or result.model is None:
            return None
        masks = frames / MASKS
        given = {"masks": masks if masks.is_dir() else None, "device": result.device, "overwrite": overwrite}
        return write_training_folder(self.training, result.model, frames / PICTURES, **given)

    def _all(self) -> Iterator[FilePath]:
        paths = (self.mesh, self.cloud, self.trajectory, self.picture, self.training)
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
