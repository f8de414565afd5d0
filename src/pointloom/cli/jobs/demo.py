"""Render a furnished room as RGB-D frames, fuse them, and compare the mesh with the true surface: `run_demo`."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.depth_range import DEPTH_MAX
from ...core.atomic import atomic_write, check_writable
from ...core.checks import check_count, check_progress
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FileError, FilePath
from ...core.progress import ReportProgress
from ...core.reports import Assessed, Fields, Report, failed, quality
from ...core.timing import Clock, peak_bytes
from ...core.wording import format_fraction, json_text
from ...datasets.scenes.room import room_sequence, surface_errors
from ...meshing.mesh.mesh_files import write_triangle_mesh
from ...rgbd.fusion.fuse import fuse
from ...rgbd.fusion.results import FusionResult
from ...visualization.render.picture_files import write_image
from ...visualization.render.render import render
from ...visualization.render.scene_view import as_photographed
from .fuse import fusion_fields

TITLE = "a furnished room"
DEFAULT_FRAMES = 120
VOXEL_SIZE = 0.02  # [m]

# Maximum root mean square error in voxels. Correct fusion stays well below.
LARGEST_RMSE = {"noise": 1.0, "no noise": 0.3}

MESH, PICTURE, REPORT = OUTPUTS = ("room.ply", "room.png", "report.json")

_SHOWN = (("median", "median"), ("root mean square", "rmse"), ("95 % below", "p95"), ("largest", "largest"))


@dataclass(frozen=True)
class SurfaceErrors:
    """Distances of a mesh's vertices from the true surface [m], and the fraction within half a voxel."""

    median: float
    rmse: float
    p95: float
    largest: float
    within_half_voxel: float
    voxel_size: float

    @classmethod
    def of(cls, errors: NDArray[np.float64], voxel_size: float) -> SurfaceErrors | None:
        """Statistics of distances from the true surface [m]. None if none is finite."""
        errors = errors[np.isfinite(errors)]
        if not len(errors):
            return None
        return cls(
            median=float(np.median(errors)),
            rmse=float(np.sqrt(np.mean(errors**2))),
            p95=float(np.quantile(errors, 0.95)),
            largest=float(errors.max()),
            within_half_voxel=float(np.mean(errors <= voxel_size / 2)),
            voxel_size=voxel_size,
        )

    @property
    def rmse_voxels(self) -> float:
        return self.rmse / self.voxel_size

    def to_dict(self) -> dict[str, float]:
        meters = {name: getattr(self, name) for _, name in _SHOWN}
        voxels = {f"{name}_voxels": value / self.voxel_size for name, value in meters.items()}
        return meters | voxels | {"within_half_voxel": self.within_half_voxel}

    def __str__(self) -> str:
        rows = [(label, getattr(self, name)) for label, name in _SHOWN]
        lines = [f"{label:<18}{m * 1000:>8.2f} mm{m / self.voxel_size:>8.3f} voxels" for label, m in rows]
        near = f"{'within half a voxel':<18}{format_fraction(self.within_half_voxel):>9} of the vertices"
        return "\n".join([*lines, near])


@dataclass(frozen=True)
class DemoReport(Report, Assessed):
    """Report of `run_demo`; `noise` is True if the frames have camera noise, `errors` is None for an empty mesh."""

    noise: bool
    seed: int
    fusion: FusionResult
    errors: SurfaceErrors | None
    seconds: dict[str, float]
    peak_bytes: int
    files: tuple[str, ...]

    @property
    def warnings(self) -> tuple[str, ...]:
        return failed(_problem(self.errors, self.noise))

    def to_dict(self) -> dict[str, Any]:
        fusion = self.fusion.to_dict()
        del fusion["refinement"]  # the poses are true
        return {
            "command": "demo",
            "noise": self.noise,
            "seed": self.seed,
            **fusion,
            "errors": None if self.errors is None else self.errors.to_dict(),
            "seconds": self.seconds,
            "peak_bytes": self.peak_bytes,
            "files": list(self.files),
            **quality(self),
        }

    def fields(self) -> Fields:
        fields = fusion_fields(self.fusion.fields(), self.seconds, self.peak_bytes, self.files)
        return [*fields, ("errors", "none: the mesh is empty" if self.errors is None else str(self.errors))]


def run_demo(
    folder: FilePath,
    *,
    frame_count: int = DEFAULT_FRAMES,
    voxel_size: float = VOXEL_SIZE,
    seed: int = 0,
    noise: bool = True,
    device: DeviceLike = "auto",
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> DemoReport:
    """Render the room, fuse the frames, and write room.ply, room.png and report.json to a folder, created if missing.

    Without `noise`, depth and images are exact. `progress` is called with the stage, the finished steps and their
    number.
    """
    check_count("frame_count", frame_count)
    device, report_progress, clock = resolve_device(device), check_progress(progress), Clock()
    with _output_folder(Path(folder), overwrite=overwrite) as (mesh, picture, report_file):
        report_progress("room", 0, 0)
        frames = room_sequence(frame_count, seed=seed, noise=noise, device=device)
        clock.stop("build")
        options: dict[str, Any] = {"voxel_size": voxel_size, "depth_max": DEPTH_MAX, "read_ahead": 0}
        fusing = Clock()
        result = fuse(frames, **options, device=device, progress=report_progress, clock=fusing)
        clock.seconds |= {"render" if stage == "read" else stage: value for stage, value in fusing.seconds.items()}
        clock.restart()
        errors = SurfaceErrors.of(surface_errors(result.mesh.vertices, device=result.mesh.device), voxel_size)
        clock.stop("measure")
        image = render(as_photographed(result.mesh), mesh_show_back_face=False)
        clock.stop("picture")
        write_triangle_mesh(mesh, result.mesh, overwrite=overwrite)
        write_image(picture, image, overwrite=overwrite)
        report = DemoReport(noise, seed, result, errors, clock.seconds, peak_bytes(), (mesh, picture, report_file))
        with atomic_write(report_file, overwrite=overwrite) as file:
            file.write(json_text(report.to_dict()).encode() + b"\n")
    return report


@contextlib.contextmanager
def _output_folder(folder: Path, *, overwrite: bool) -> Iterator[tuple[str, ...]]:
    """Paths of the outputs in a folder, created if missing and removed if it stays empty. Raises FileError."""
    if folder.exists() and not folder.is_dir():
        raise FileError(folder, "is not a folder", remedy="Pass the name of a folder")
    made = not folder.exists()
    if made:
        try:
            folder.mkdir()
        except OSError as error:
            reason = f"the folder cannot be created: {error.strerror or error}"
            raise FileError(folder, reason, remedy="Choose an existing folder with write permission") from error
    try:
        for name in OUTPUTS:
            check_writable(folder / name, overwrite=overwrite)
        yield tuple(str(folder / name) for name in OUTPUTS)
    finally:
        if made:
            with contextlib.suppress(OSError):  # it contains the outputs
                folder.rmdir()


def _problem(errors: SurfaceErrors | None, noise: bool) -> str | None:
    if errors is None:
        return "the mesh is empty; use more frames (--frames)"
    limit = LARGEST_RMSE["noise" if noise else "no noise"]
    if errors.rmse_voxels <= limit:
        return None
    return (
        f"expected a root mean square error of at most {limit:g} voxels, got {errors.rmse_voxels:.2f}; use more frames"
    )
