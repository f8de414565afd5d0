"""Texture a mesh from the images of a structure-from-motion model: `texture_model`."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar, Unpack

from ...cameras.depth_range import UNLIMITED_DEPTH
from ...core.errors import FileError, FilePath
from ...core.kept_arrays import check_kept_arrays, remove_kept_arrays
from ...core.outputs import check_output
from ...core.reports import Fields
from ...io.models.colmap import is_colmap_model, read_colmap_model
from ...meshing.color_map.image_texturing import texture_from_images
from ...meshing.color_map.options import ImageTextureOption
from ...meshing.color_map.results import NothingSeenError
from ...meshing.mesh.mesh_files import read_triangle_mesh, write_triangle_mesh
from ...registration.trajectories.up_direction import up_of_poses
from .job import Job, Settings
from .texture import WITH_ATLAS, TextureReport, work_folder_of

WRITTEN = WITH_ATLAS
SCALED_MODEL = Path("mesh")  # of a video's work folder: the model in the units of its mesh
STRAIGHT = Path("undistorted") / "images"  # and its images
IMAGES = "images"  # as in COLMAP projects


@dataclass(frozen=True)
class ModelTask:
    """Input of the texture."""

    mesh: str
    folder: str
    image_count: int
    nothing: ClassVar[str] = "no image shows the mesh, and nothing was written; are both in the same coordinate frame?"

    def to_dict(self) -> dict[str, Any]:
        return {"command": "texture", "mesh": self.mesh, "dataset": self.folder, "layout": "model"}

    def figures(self) -> dict[str, Any]:
        return {"images": self.image_count}

    def fields(self) -> Fields:
        return [("images", str(self.image_count))]


def is_model_folder(folder: FilePath) -> bool:
    """True for a COLMAP project, or the work folder of a video."""
    path = Path(folder)
    return path.is_dir() and (is_colmap_model(path) or is_colmap_model(path / SCALED_MODEL / "sparse"))


def texture_model(
    mesh: FilePath,
    folder: FilePath,
    output: FilePath,
    *,
    size: int | None = None,
    depth_max: float = UNLIMITED_DEPTH,
    **settings: Unpack[Settings],
) -> TextureReport:
    """Write a mesh with a texture from the images of a model. The output is checked before the work.

    `folder` is a COLMAP project with images in `images`, or the work folder of `pointloom video`; `output` an .obj,
    .glb or .gltf; `up` the up axis in the frame of the poses, "y" or "z", for .glb or .gltf. See
    `texture_from_images` for `size` and `depth_max`. Finished steps are kept in
    `work_folder_of(output)` until the output is written.
    """
    job = Job("texture", mesh, **settings)
    overwrite = job.form["overwrite"]
    check_output(output, WRITTEN, what="textures from images", overwrite=overwrite)
    work = check_kept_arrays(work_folder_of(output)).path
    where, clock = job.device, job.clock
    shape = read_triangle_mesh(mesh, device=where, up=job.up_of(mesh))
    if not len(shape):
        raise FileError(
            mesh, "has no triangles, which a texture needs", remedy="Pass a mesh, such as one of pointloom video"
        )
    model, images = _open(Path(folder))
    clock.stop("read")
    try:
        option = ImageTextureOption(depth_max=depth_max)
        result = texture_from_images(shape, images, model, option=option, size=size, work=work, progress=job.progress)
    except NothingSeenError:
        result = None
    clock.stop("texture")
    files = []
    if result is not None:
        result.mesh.up = shape.up or up_of_poses(model.T_world_camera)
        write_triangle_mesh(output, result.mesh, up=job.up_of(output), overwrite=overwrite)
        files.append(os.fspath(output))
        clock.stop("write")
    remove_kept_arrays(work)
    return TextureReport(ModelTask(os.fspath(mesh), os.fspath(folder), len(model)), result, clock.seconds, files)


def _open(folder: Path) -> tuple[Any, Path]:
    if is_colmap_model(folder / SCALED_MODEL / "sparse"):
        return read_colmap_model(folder / SCALED_MODEL / "sparse"), folder / STRAIGHT
    candidates = [parent / IMAGES for parent in (folder, folder.parent, folder.parent.parent)]
    images = next((path for path in candidates if path.is_dir()), None)
    if images is None:
        raise FileError(
            folder, "contains a model, but no folder with its images", remedy=f"Put the images into {candidates[0]}"
        )
    return read_colmap_model(folder), images
