"""Output files of a model from RGB-D frames: mesh, image and camera path."""

from __future__ import annotations

import dataclasses
import os
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ...cameras.pose_files import check_trajectory_output, write_poses
from ...cameras.trajectory import Trajectory
from ...core.errors import FilePath
from ...core.outputs import check_output
from ...core.up_axis import check_up
from ...io.meshes.mesh_formats import MESH_FORMATS
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.mesh.mesh_files import write_triangle_mesh
from ...visualization.render.picture_files import check_picture
from ...visualization.render.scene_view import draw_scene


@dataclasses.dataclass(frozen=True)
class ModelOutputs:
    """Output files of a model: mesh (STL has no colors), image and poses. `up`: its up axis, else by its cameras."""

    mesh: FilePath
    picture: FilePath | None = None
    trajectory: FilePath | None = None
    up: str | None = None

    def check(self, *, overwrite: bool) -> None:
        check_output(self.mesh, MESH_FORMATS, what="meshes", overwrite=overwrite)
        if self.trajectory is not None:
            check_trajectory_output(self.trajectory, overwrite=overwrite)
        if self.picture is not None:
            check_picture(self.picture, overwrite=overwrite)

    def write_mesh(self, mesh: TriangleMesh, T_world_camera: NDArray[np.float64], *, overwrite: bool) -> list[str]:
        """Write a mesh and its image from the side of the cameras. Returns the file names."""
        if self.up is not None:
            mesh.up = check_up(self.up)
        written = mesh
        if Path(self.mesh).suffix.lower() == ".stl":
            arrays = {name: mesh.arrays[name] for name in ("vertices", "triangles")}
            written = TriangleMesh.from_device_arrays(arrays, mesh.origin)
        write_triangle_mesh(self.mesh, written, overwrite=overwrite)
        if self.picture is None:
            return [os.fspath(self.mesh)]
        draw_scene(self.picture, mesh, T_world_camera, overwrite=overwrite)
        return [os.fspath(self.mesh), os.fspath(self.picture)]

    def write_trajectory(self, trajectory: Trajectory, *, overwrite: bool) -> list[str]:
        if self.trajectory is None:
            return []
        write_poses(self.trajectory, trajectory, overwrite=overwrite)
        return [os.fspath(self.trajectory)]
