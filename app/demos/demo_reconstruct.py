"""The hard trial run: the furnished room from a camera whose poses nobody tells, and how far it drifted.

The camera is carried about the room and comes back to where it began. Its frames are tracked and fused; the path is
held against the true one, and the surface, brought back by the first pose alone, against the true surface.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from ...cameras.pose_files import write_poses
from ...cameras.trajectory import Trajectory
from ...core.reports import Fields, all_of
from ...core.timing import peak_bytes
from ...core.wording import plain
from ...data.scenes.room import room_loop_sequence, surface_errors
from ...drawing.render.picture_files import save_picture
from ...drawing.render.render import render
from ...drawing.render.scene_view import as_photographed
from ...files.frames.frames import camera_line, describe_camera
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.mesh.mesh_files import write_triangle_mesh
from ...meshing.mesh.mesh_summary import MeshSummary, describe_mesh
from ...registration.trajectories.trajectory_error import TrajectoryError
from ...rgbd.slam.looped_model import SlamAccount, model_by_slam
from ...rgbd.slam.paths import error_against_truth
from ..jobs.frame_folder import with_camera
from ..jobs.track import rate_of
from .demo_results import SurfaceErrors, error_table
from .trial import REPORT, Cost, Place, Trial, text_of

Matrix = NDArray[np.float64]

FRAMES = 300
WIDTH, HEIGHT = 640, 480
VOXEL_SIZE = 0.02  # [m]
DEPTH_MAX = 4.0  # [m]

LARGEST_ATE = 0.03  # [m] root mean square
LARGEST_MEDIAN = 0.02  # [m] of the vertices' distances from the true surface

OUTPUTS = ("room.ply", "room.png", "poses.log", "truth.log", REPORT)


@dataclass(frozen=True)
class Drift:
    """How far the last pose lies from the true one where the first is given.

    Attributes:
        end_m: Distance [m].
        end_deg: Angle [degrees].
    """

    end_m: float
    end_deg: float

    @classmethod
    def of(cls, poses: Matrix, truths: Matrix) -> Drift:
        """Of poses whose first is the true one, [n, 4, 4]."""
        apart = np.linalg.inv(truths[-1]) @ poses[-1]
        cosine = np.clip((np.trace(apart[:3, :3]) - 1) / 2, -1, 1)
        return cls(float(np.linalg.norm(apart[:3, 3])), float(np.degrees(np.arccos(cosine))))

    def __str__(self) -> str:
        return f"{self.end_m * 1000:.1f} mm and {self.end_deg:.2f} degrees at the end, from the first pose on"


@dataclass(frozen=True)
class ReconstructReport:
    """What became of frames whose poses nobody told.

    Attributes:
        trial: What was asked for.
        camera: The camera and the device, in JSON's types.
        account: What tracking tells of frames and loops.
        mesh: The size of the mesh.
        path_error: Of the path; None of fewer than two poses.
        drift: How far the end of the path is off.
        errors: Of the surface, brought back by the first pose alone.
        cost: Time and memory.
        files: Those that were written.
    """

    trial: ReconstructTrial
    camera: dict[str, Any]
    account: SlamAccount
    mesh: MeshSummary
    path_error: TrajectoryError | None
    drift: Drift
    errors: SurfaceErrors | None
    cost: Cost
    files: tuple[str, ...]

    @property
    def poor(self) -> str | None:
        """Why the result is poor, or None."""
        ate = self.path_error.absolute_translation.rmse if self.path_error else None
        return all_of(self.account.poor, *_why_poor(ate, self.errors))

    @property
    def frames_per_second(self) -> float:
        """Of tracking alone."""
        return rate_of(self.account.path, self.cost.seconds)

    def to_json(self) -> dict[str, Any]:
        """What report.json holds."""
        return {
            "command": "demo",
            "form": "reconstruct",
            "noise": self.trial.noise,
            "seed": self.trial.seed,
            **self.camera,
            **self.account.path.to_json(),
            "frames_per_second": self.frames_per_second,
            **self.account.loops_to_json(),
            **self.mesh.to_json(),
            "path_errors": plain(self.path_error),
            "drift": asdict(self.drift),
            "errors": None if self.errors is None else self.errors.to_json(),
            "seconds": self.cost.seconds,
            "peak_bytes": self.cost.peak_bytes,
            "files": list(self.files),
            "poor": self.poor,
        }

    def fields(self) -> Fields:
        """The same as labels and values for the terminal."""
        told = self.account.fields(self.frames_per_second)
        return [
            *with_camera(told, camera_line(self.camera["camera"]), [], before="path"),
            ("mesh", f"{self.mesh.vertices:,} vertices, {self.mesh.triangles:,} triangles"),
            *(self.path_error.fields() if self.path_error else []),
            ("drift", str(self.drift)),
            ("errors", error_table(self.errors)),
            *self.cost.fields(),
            ("files", ", ".join(self.files)),
        ]

    def __str__(self) -> str:
        return text_of(self)


@dataclass(frozen=True)
class ReconstructTrial(Trial):
    """Reconstruct the room without poses, and leave room.ply, room.png, poses.log, truth.log and report.json.

    Attributes:
        voxel_size: Edge of a voxel [m].
    """

    FEWEST: ClassVar[int] = 2

    frame_count: int = FRAMES
    voxel_size: float = VOXEL_SIZE

    @property
    def outputs(self) -> tuple[str, ...]:
        """The files that it leaves."""
        return OUTPUTS

    def run(self, place: Place) -> ReconstructReport:
        """Track and fuse the frames, and hold path and surface against the truth."""
        place.say("room", 0, 0)
        size: dict[str, Any] = {"width": WIDTH, "height": HEIGHT, "device": place.device}
        walk = room_loop_sequence(self.frame_count, seed=self.seed, noise=self.noise, **size)
        place.clock.stop("build")
        options: dict[str, Any] = {"voxel_size": self.voxel_size, "depth_max": DEPTH_MAX, "read_ahead": 0}
        made = model_by_slam(walk, **options, device=place.device, progress=place.say, clock=place.clock)
        told = {"device": str(place.device), "left_out": [], "camera": describe_camera(walk, "a made-up camera")}
        return self._judged(place, made, told, walk.poses)

    def _judged(
        self, place: Place, made: tuple[TriangleMesh, SlamAccount], told: dict[str, Any], true_poses: Matrix
    ) -> ReconstructReport:
        """Measure the path and the surface, and write all files."""
        (mesh, account), clock = made, place.clock
        path = account.trajectory
        clock.restart()
        if not len(path) or not len(mesh):
            raise ValueError("frame_count: no frame could be placed or seen often enough; take more frames")
        assert path.ids is not None
        truths = true_poses[path.ids[:, 0]]
        T = truths[0] @ np.linalg.inv(path.poses[0])  # where the camera began is all that is told
        mesh, brought = mesh.transform(T), Trajectory(T @ path.poses, ids=path.ids)
        size, path_error = describe_mesh(mesh), error_against_truth(path.poses, list(truths))
        drift = Drift.of(brought.poses, truths)
        errors = SurfaceErrors.of(surface_errors(mesh.vertices, device=mesh.device), self.voxel_size)
        clock.stop("measure")
        image = render(as_photographed(mesh), mesh_show_back_face=False)
        clock.stop("picture")
        cost, files = Cost(clock.seconds, peak_bytes()), place.files(OUTPUTS)
        write_triangle_mesh(files[0], mesh, overwrite=place.overwrite)
        save_picture(files[1], image, overwrite=place.overwrite)
        write_poses(files[2], brought, overwrite=place.overwrite)
        write_poses(files[3], Trajectory(true_poses), overwrite=place.overwrite)
        return ReconstructReport(self, told, account, size, path_error, drift, errors, cost, files)


def _why_poor(ate: float | None, surface: SurfaceErrors | None) -> list[str]:
    reasons = []
    if ate is not None and ate > LARGEST_ATE:
        limit = LARGEST_ATE * 1000
        reasons.append(f"the path is off by {ate * 1000:.1f} mm (ATE), more than {limit:g}; take more frames")
    if surface is not None and surface.median > LARGEST_MEDIAN:
        median, limit = surface.median * 1000, LARGEST_MEDIAN * 1000
        reasons.append(f"the surface is off by {median:.1f} mm in the median, more than {limit:g}; take more frames")
    return reasons
