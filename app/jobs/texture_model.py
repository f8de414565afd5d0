"""The pictures of a model of structure from motion onto a mesh of the same place: `texture_model`."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ...core.checks import check_progress
from ...core.devices import resolve_device
from ...core.errors import FileError, FilePath
from ...core.outputs import check_output
from ...core.progress import ReportProgress
from ...core.reports import Assessed, Fields, Report, quality
from ...core.timing import Clock, peak_bytes
from ...core.wording import format_bytes, format_seconds, plain
from ...files.meshes.mesh_formats import UPRIGHT
from ...files.models.colmap import is_colmap_model, read_colmap_model
from ...meshing.color_map.picture_texturing import texture_from_pictures
from ...meshing.color_map.pictured_mesh import PicturedMesh
from ...meshing.color_map.results import NothingSeenError
from ...meshing.mesh.mesh_files import read_triangle_mesh, write_triangle_mesh

WRITTEN = (".obj", ".glb", ".gltf")
PLACED = Path("mesh")  # of a video's work folder: the model in the units of its mesh
STRAIGHT = Path("undistorted") / "images"  # and the pictures that it is of
IMAGES = "images"  # as COLMAP's projects name theirs

_NOTHING = "no picture shows anything of the mesh, and nothing was written; are both in one frame of coordinates?"


def holds_model(folder: FilePath) -> bool:
    """Whether a folder is a project of COLMAP, or the work folder of a video."""
    place = Path(folder)
    return place.is_dir() and (is_colmap_model(place) or is_colmap_model(place / PLACED / "sparse"))


def texture_model(
    mesh: FilePath,
    folder: FilePath,
    output: FilePath,
    *,
    size: int | None = None,
    depth_max: float = float("inf"),
    device: Any = "auto",
    up: str = "y",
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> ModelTextureReport:
    """Write a mesh with a texture cut out of the pictures of a model; the output is checked before the work.

    Args:
        mesh: A mesh, in the frame of the model.
        folder: A project of COLMAP with its pictures in `images`, or the work folder of `pointloom video`.
        output: An .obj, .glb or .gltf.
        size, depth_max: As of `texture_from_pictures`.
        device: Where to compute.
        up: The axis that is up in the frame of the poses, "y" or "z", where the mesh or the output is .glb or .gltf.
        overwrite: Replace an output that exists.
        progress: Called with the stage, how many of its steps are done, and how many there are.

    Raises:
        FileError: A file that cannot be read, or an output that cannot be written.
        ValueError: A number out of range.
        DeviceError: No such device.
    """
    tell = check_progress(progress)
    check_output(output, WRITTEN, what="textures out of pictures", overwrite=overwrite)
    clock, where = Clock(), resolve_device(device)
    shape = read_triangle_mesh(mesh, device=where, up=_up_of(mesh, up))
    if not len(shape):
        raise FileError(
            mesh, "has no triangles, which a texture needs", remedy="Give a mesh, such as of pointloom video"
        )
    model, pictures = _open(Path(folder))
    clock.stop("read")
    try:
        found = texture_from_pictures(shape, pictures, model, size=size, depth_max=depth_max, progress=tell)
    except NothingSeenError:
        found = None
    clock.stop("texture")
    files = []
    if found is not None:
        write_triangle_mesh(output, found.mesh, up=_up_of(output, up), overwrite=overwrite)
        files.append(os.fspath(output))
        clock.stop("write")
    return ModelTextureReport(os.fspath(mesh), os.fspath(folder), len(model), found, clock.seconds, files)


@dataclass(frozen=True)
class ModelTextureReport(Report, Assessed):
    """What `texture_model` did.

    Attributes:
        mesh, folder: As they were given.
        picture_count: Pictures of the model.
        found: The textured mesh; None where no picture shows anything of it.
        seconds: Of each stage.
        files: What was written.
        peak_bytes: The most memory that was held.
    """

    mesh: str
    folder: str
    picture_count: int
    found: PicturedMesh | None
    seconds: dict[str, float]
    files: list[str]
    peak_bytes: int = field(default_factory=peak_bytes)

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks; empty if the result is reliable."""
        return (_NOTHING,) if self.found is None else self.found.warnings

    def to_dict(self) -> dict[str, Any]:
        """All of it in JSON's types."""
        given = {"command": "texture", "mesh": self.mesh, "dataset": self.folder, "layout": "model"}
        found = {"pictures": self.picture_count} if self.found is None else self.found.to_dict()
        cost = {"seconds": self.seconds, "peak_bytes": self.peak_bytes}
        return plain(given | found | cost | {"files": self.files, **quality(self)})

    def fields(self) -> Fields:
        """What the result says, what it took, and what was written."""
        return [
            *(self.found.fields() if self.found else [("pictures", str(self.picture_count))]),
            ("seconds", format_seconds(self.seconds)),
            ("memory", f"{format_bytes(self.peak_bytes)} at most"),
            ("files", ", ".join(self.files) or "none"),
        ]


def _open(folder: Path) -> tuple[Any, Path]:
    """The model, and the folder of its pictures."""
    if is_colmap_model(folder / PLACED / "sparse"):
        return read_colmap_model(folder / PLACED / "sparse"), folder / STRAIGHT
    places = [place / IMAGES for place in (folder, folder.parent, folder.parent.parent)]
    pictures = next((place for place in places if place.is_dir()), None)
    if pictures is None:
        raise FileError(folder, "holds a model, but no folder of its pictures", remedy=f"Put them into {places[0]}")
    return read_colmap_model(folder), pictures


def _up_of(path: FilePath, up: str) -> str:
    """The axis that is to be up, for a file of a format that says which one is."""
    return up if Path(path).suffix.lower() in UPRIGHT else "y"
