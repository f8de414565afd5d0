"""Color a mesh from posed frames: `texture_folder`."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, ClassVar, Unpack

from ...cameras.camera import read_pinhole_camera_intrinsic
from ...cameras.depth_range import DEPTH_MAX
from ...core.checks import check_count
from ...core.errors import FileError, FilePath
from ...core.kept_arrays import check_kept_arrays, remove_kept_arrays
from ...core.outputs import check_output
from ...core.reports import Assessed, Fields, Report, quality
from ...core.timing import peak_bytes
from ...core.wording import format_bytes, format_seconds, plain
from ...io.frames.datasets import REQUIRED, RGBDDataset, open_frames
from ...io.meshes.mesh_formats import storing
from ...meshing.color_map.image_texture_result import ImageTextureResult
from ...meshing.color_map.results import NothingSeenError
from ...meshing.color_map.textured_mesh import TexturedMesh, task_fields
from ...meshing.color_map.texturing import texture_mesh
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.mesh.mesh_files import read_triangle_mesh, write_triangle_mesh
from ...registration.trajectories.up_direction import up_of_poses
from ...visualization.render.picture_files import check_picture
from ...visualization.render.scene_view import draw_scene
from .announced_stages import AnnouncedStages
from .job import Job, Settings

WITH_ATLAS = tuple(extension for extension in storing("textures") if extension != ".ply")  # that gets vertex colors
WRITTEN = (".ply", *WITH_ATLAS)
DEFAULT_TEXTURE_SIZE = 2048  # texels per side: 3 mm each on the walls of a room


def texture_folder(
    mesh: FilePath,
    folder: FilePath,
    output: FilePath,
    *,
    layout: dict[str, Any],
    method: str = "rigid",
    size: int = DEFAULT_TEXTURE_SIZE,
    depth_max: float = DEPTH_MAX,
    picture: FilePath | None = None,
    **settings: Unpack[Settings],
) -> TextureReport:
    """Write a mesh with the colors of posed frames. Outputs are checked before the work. Finished steps are kept in
    `work_folder_of(output)` until the output is written.

    Args:
        folder: See `open_frames`, with the options `layout`. Its "intrinsic" is a camera as Open3D's JSON, which
            replaces that of the folder.
        output: A .ply for vertex colors, or a format of WITH_ATLAS for a texture of `size` texels per side.
        picture: A .png file of the mesh with vertex colors.
    """
    check_count("size", size)
    job = Job("texture", mesh, **settings)
    overwrite = job.form["overwrite"]
    check_output(output, WRITTEN, what="colored meshes", overwrite=overwrite)
    if picture is not None:
        check_picture(picture, overwrite=overwrite)
    work = check_kept_arrays(work_folder_of(output)).path
    where, clock, with_atlas = job.device, job.clock, Path(output).suffix.lower() in WITH_ATLAS
    intrinsic = layout["intrinsic"]
    camera = None if intrinsic is None else read_pinhole_camera_intrinsic(intrinsic)
    shape = read_triangle_mesh(mesh, device=where, up=job.up_of(mesh))
    if with_atlas and not len(shape):
        raise FileError(mesh, "has no triangles, which a texture needs", remedy="Write a .ply file for vertex colors")
    dataset = _open_colored(folder, **layout | {"intrinsic": camera})
    clock.stop("read")
    task = Task(os.fspath(mesh), os.fspath(folder), dataset.layout, shape, method, len(dataset), float(depth_max))
    how: dict[str, Any] = {"method": method, "size": size if with_atlas else None, "depth_max": depth_max, "work": work}
    try:
        with AnnouncedStages(clock, job.progress, first="read", part_of={"frames": "read"}) as stages:
            result = texture_mesh(shape, dataset, **how, progress=stages)
    except NothingSeenError:
        return TextureReport(task, None, clock.seconds, [])
    result.mesh.up = shape.up or up_of_poses(result.colors.trajectory.poses)
    files = _write(result, output, picture, up=job.up_of(output), overwrite=overwrite)
    clock.stop("write")
    remove_kept_arrays(work)
    return TextureReport(task, result, clock.seconds, files)


def work_folder_of(output: FilePath) -> Path:
    """Folder of finished steps beside the output: mesh-texture for mesh.glb."""
    return Path(output).with_name(f"{Path(output).stem}-texture")


@dataclass(frozen=True)
class Task:
    """Input of the coloring. Pixels beyond `depth_max` [m] are ignored."""

    mesh: str
    dataset: str
    layout: str
    shape: TriangleMesh
    method: str
    frame_count: int
    depth_max: float
    nothing: ClassVar[str] = "no frame shows the mesh, and nothing was written; are both in the same coordinate frame?"

    def to_dict(self) -> dict[str, Any]:
        files = {"command": "texture", "mesh": self.mesh, "dataset": self.dataset, "layout": self.layout}
        how = {"device": str(self.shape.device), "method": self.method, "frames": self.frame_count}
        sizes = {"vertices": self.shape.arrays["vertices"].size, "triangles": len(self.shape)}
        return files | how | {"depth_max": self.depth_max} | sizes

    def figures(self) -> dict[str, Any]:
        return {}

    def fields(self) -> Fields:
        return task_fields(self.shape, self.frame_count, self.depth_max)


@dataclass(frozen=True)
class TextureReport(Report, Assessed):
    """Report of `texture_folder` and `texture_model`; `result` is None if no image shows the mesh."""

    task: Any  # Task or ModelTask
    result: TexturedMesh | ImageTextureResult | None
    seconds: dict[str, float]
    files: list[str]
    peak_bytes: int = field(default_factory=peak_bytes)

    @property
    def warnings(self) -> tuple[str, ...]:
        return (self.task.nothing,) if self.result is None else self.result.warnings

    def to_dict(self) -> dict[str, Any]:
        figures = self.task.figures() if self.result is None else self.result.to_dict()
        cost = {"seconds": self.seconds, "peak_bytes": self.peak_bytes}
        return plain(self.task.to_dict() | figures | cost | {"files": self.files, **quality(self)})

    def fields(self) -> Fields:
        return [
            *(self.result or self.task).fields(),
            ("seconds", format_seconds(self.seconds)),
            ("memory", f"{format_bytes(self.peak_bytes)} at most"),
            ("files", ", ".join(self.files) or "none"),
        ]


def _open_colored(folder: FilePath, **options: Any) -> RGBDDataset:
    dataset = open_frames(folder, poses=REQUIRED, resize_color=True, **options)
    if any(files.color is None for files in dataset.frames):
        raise FileError(dataset.folder, "expected frames with color images, got frames without")
    return dataset


def _write(
    result: TexturedMesh, output: FilePath, picture: FilePath | None, *, up: str | None, overwrite: bool
) -> list[str]:
    write_triangle_mesh(output, result.mesh, up=up, overwrite=overwrite)
    if picture is None:
        return [os.fspath(output)]
    draw_scene(picture, result.colors.mesh, result.colors.trajectory.poses, overwrite=overwrite)
    return [os.fspath(output), os.fspath(picture)]
