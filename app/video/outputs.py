"""What the job leaves outside its own folder: the mesh, and on request the cloud, the poses, a picture."""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from ...meshing.mesh import TriangleMesh
from ...meshing.mesh_files import mesh_table
from ...pcd.cloud import PointCloud
from ...pcd.errors import FileError
from ...pcd.io.formats import WRITTEN
from ...pcd.io.ply import write_ply, write_ply_mesh
from ...pcd.io.point_cloud import table_of
from ...pcd.io.trajectory import Trajectory
from ..pictures.picture_files import check_picture
from ..pictures.scene_view import draw_scene
from ..tables import MESHES, check_output, write_cloud_table, write_mesh_table
from ..trajectory_report import check_trajectory_output, write_poses

FilePath = str | os.PathLike[str]


@dataclass(frozen=True, eq=False)
class Outputs:
    """The files that are asked for.

    Attributes:
        mesh: .ply, .obj, .stl, .off or .glb.
        cloud: Of the points, or None.
        trajectory: Of the poses, .log, .txt or .tum; or None.
        picture: Of the mesh, .png; or None.
        overwrite: Whether files that exist are replaced.
    """

    mesh: FilePath
    cloud: FilePath | None = None
    trajectory: FilePath | None = None
    picture: FilePath | None = None
    overwrite: bool = False

    def check(self) -> None:
        """Hold that all can be written, before any work.

        Raises:
            FileError: One cannot, or two are one file.
        """
        check_output(self.mesh, MESHES, what="meshes", overwrite=self.overwrite)
        if self.cloud is not None:
            check_output(self.cloud, tuple(WRITTEN), what="clouds", overwrite=self.overwrite)
        if self.trajectory is not None:
            check_trajectory_output(self.trajectory, overwrite=self.overwrite)
        if self.picture is not None:
            check_picture(self.picture, overwrite=self.overwrite)
        taken: set[Path] = set()
        for path in self._all():
            if Path(path).resolve() in taken:
                raise FileError(path, "is given for two outputs", remedy="Give each a name of its own")
            taken.add(Path(path).resolve())

    def write(self, mesh: TriangleMesh, cloud: PointCloud | None, path: Trajectory, units: str) -> list[str]:
        """Write what there is; gives the names of the files.

        Raises:
            FileError: One cannot be written.
        """
        comments = [f"units {units}"]
        if Path(self.mesh).suffix.lower() == ".ply":
            write_ply_mesh(self.mesh, mesh_table(mesh), overwrite=self.overwrite, comments=comments)
        else:
            write_mesh_table(self.mesh, mesh_table(mesh), overwrite=self.overwrite)
        if self.cloud is not None and cloud is not None:
            if Path(self.cloud).suffix.lower() == ".ply":
                write_ply(self.cloud, table_of(cloud), overwrite=self.overwrite, comments=comments)
            else:
                write_cloud_table(self.cloud, table_of(cloud), overwrite=self.overwrite)
        if self.trajectory is not None:
            write_poses(self.trajectory, path, overwrite=self.overwrite)
        if self.picture is not None:
            draw_scene(self.picture, mesh, path.poses, overwrite=self.overwrite)
        return [os.fspath(each) for each in self._all()]

    def _all(self) -> Iterator[FilePath]:
        return (path for path in (self.mesh, self.cloud, self.trajectory, self.picture) if path is not None)
