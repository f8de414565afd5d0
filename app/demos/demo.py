"""A trial run that needs no data: a furnished room is rendered as RGB-D frames, fused, and held against the truth.

Then its sofa is scanned, and a surface made of the points.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from ...core.reports import Fields, failed
from ...core.timing import Clock, peak_bytes
from ...data.scenes.room import room_sequence, surface_errors
from ...drawing.render.picture_files import save_picture
from ...drawing.render.render import render
from ...drawing.render.scene_view import as_photographed
from ...drawing.render.surface_picture import draw_surface
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.mesh.mesh_files import write_triangle_mesh
from ...rgbd.fusion.fuse import fuse
from ...rgbd.fusion.results import FusionResult
from ..jobs.fuse import fusion_fields
from .demo_object import SofaFigures, make_sofa
from .demo_results import SurfaceErrors, error_table
from .trial import REPORT, Cost, Place, Trial, text_of

FRAMES = 120
VOXEL_SIZE = 0.02  # [m]
DEPTH_MAX = 4.0  # [m]

# The most that the root mean square error may be, in voxels: a fusion that works stays well below.
LARGEST_RMSE = {"noise": 1.0, "no noise": 0.3}

OUTPUTS = ("room.ply", "room.png", "sofa.ply", "sofa.png", REPORT)


@dataclass(frozen=True)
class FuseReport:
    """What became of the frames and of the sofa's points.

    Attributes:
        trial: What was asked for.
        fusion: The mesh and the figures of the fusion.
        sofa: The sofa's surface.
        errors: Of the room's surface; None of an empty one.
        cost: Time and memory.
        files: Those that were written.
    """

    trial: FuseTrial
    fusion: FusionResult
    sofa: SofaFigures
    errors: SurfaceErrors | None
    cost: Cost
    files: tuple[str, ...]

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks; empty if the result is reliable."""
        return failed(_problem(self.errors, self.trial.noise), self.sofa.problem)

    def to_json(self) -> dict[str, Any]:
        """What report.json holds."""
        fusion = self.fusion.to_json()
        del fusion["refinement"]  # the poses are true
        return {
            "command": "demo",
            "noise": self.trial.noise,
            "seed": self.trial.seed,
            **fusion,
            "sofa": self.sofa.to_json(),
            "errors": None if self.errors is None else self.errors.to_json(),
            "seconds": self.cost.seconds,
            "peak_bytes": self.cost.peak_bytes,
            "files": list(self.files),
            "poor": self.poor,
        }

    def fields(self) -> Fields:
        """The same as labels and values for the terminal."""
        told = fusion_fields(self.fusion.fields(), self.cost.seconds, self.cost.peak_bytes, self.files)
        return [*told, ("errors", error_table(self.errors)), ("sofa", str(self.sofa))]

    def __str__(self) -> str:
        return text_of(self)


@dataclass(frozen=True)
class FuseTrial(Trial):
    """Render the room, fuse it, and leave room.ply, room.png, sofa.ply, sofa.png and report.json.

    Attributes:
        voxel_size: Edge of a voxel [m].
    """

    frame_count: int = FRAMES
    voxel_size: float = VOXEL_SIZE

    @property
    def outputs(self) -> tuple[str, ...]:
        """The files that it leaves."""
        return OUTPUTS

    def run(self, place: Place) -> FuseReport:
        """Fuse the frames, make the sofa, and hold both against the truth."""
        clock, noise = place.clock, {"seed": self.seed, "noise": self.noise}
        place.say("room", 0, 0)
        sequence = room_sequence(self.frame_count, **noise, device=place.device)
        clock.stop("build")
        options: dict[str, Any] = {"voxel_size": self.voxel_size, "depth_max": DEPTH_MAX}
        fusing = Clock()
        result = fuse(sequence, **options, device=place.device, read_ahead=0, progress=place.say, clock=fusing)
        clock.seconds |= {"render" if stage == "read" else stage: value for stage, value in fusing.seconds.items()}
        clock.restart()
        place.say("sofa", 0, 0)
        surface, sofa = make_sofa(**noise, device=place.device, clock=clock)
        clock.restart()
        room = result.mesh
        errors = SurfaceErrors.of(surface_errors(room.vertices, device=room.device), self.voxel_size)
        clock.stop("measure")
        files = _write(place, room, surface)
        cost = Cost(clock.seconds, peak_bytes())
        return FuseReport(self, result, sofa, errors, cost, files)


def _write(place: Place, room: TriangleMesh, sofa: TriangleMesh) -> tuple[str, ...]:
    """Draw and write the meshes; gives the names of all files."""
    images = [render(as_photographed(room), mesh_show_back_face=False), draw_surface(sofa)]
    place.clock.stop("picture")
    files = place.files(OUTPUTS)
    for mesh, image, k in zip((room, sofa), images, (0, 2), strict=True):
        write_triangle_mesh(files[k], mesh, overwrite=place.overwrite)
        save_picture(files[k + 1], image, overwrite=place.overwrite)
    return files


def _problem(errors: SurfaceErrors | None, noise: bool) -> str | None:
    if errors is None:
        return "the mesh is empty; take more frames (--frames)"
    limit = LARGEST_RMSE["noise" if noise else "no noise"]
    if errors.rmse_voxels <= limit:
        return None
    return f"the root mean square error is {errors.rmse_voxels:.2f} voxels, more than {limit:g}; take more frames"
