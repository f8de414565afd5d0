"""The trial run of pictures alone: the room as a video, without depth or poses, and the mesh that is made of it.

The video goes through the same job as `pointloom video`; the truth settles unit and frame, by the similarity that fits
the centres of the cameras, and everything is then held against the room.
"""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.picture_names import number_of
from ...core.atomic import check_writable
from ...core.reports import Fields, all_of
from ...core.timing import peak_bytes
from ...core.wording import format_seconds, format_share
from ...data.scenes.error_figures import CameraErrors, DepthErrors, MeshErrors
from ...data.scenes.room import RoomSequence, room_views
from ...data.scenes.room_errors import camera_errors, depth_errors, room_mesh_errors
from ...data.scenes.room_video import FRAMES, LOG, room_video_frames, write_room_video
from ...files.models.colmap import read_colmap_model
from ...meshing.mesh.mesh import TriangleMesh
from ...photos.mvs import DepthMaps
from ...photos.video.job import reconstruct
from ...photos.video.outputs import Outputs
from ...photos.video.result import VideoResult
from ...photos.video.settings import Settings
from ...photos.video.surface import MAPS, SPARSE
from ...photos.video.units import Units
from .trial import REPORT, Cost, Place, Trial, text_of

Matrix = NDArray[np.float64]

MAX_FRAMES = 30  # of which as many are taken, 12 degrees and 25 cm apart
MAX_SIZE = 320  # [px] of the pictures that depth is estimated in: all 640 take four times as long

LEAST_REGISTERED = 1.0  # share of the pictures
LARGEST_CENTER = 0.3  # [% of the extent] root mean square of the centres' errors
LEAST_KEPT = 0.75  # share of the pixels that keep their depth
LARGEST_DEPTH = 0.002  # of the true depth, in the median
LEAST_WITHIN = 0.93  # share of what is kept that is within 1 % of the true depth
LARGEST_MEDIAN = 0.01  # [m] of the vertices' distances from the true surface

VIDEO, MESH, PICTURE, POSES, TRUTH = "room.mp4", "mesh.ply", "mesh.png", "poses.log", "truth.log"
OUTPUTS = (VIDEO, MESH, PICTURE, POSES, TRUTH, REPORT)

_SEEN_STEP = 16  # [px] between the true points that a mesh is to cover


@dataclass(frozen=True, eq=False)
class Found:
    """What was made of the video, in the frame and unit of its model.

    Attributes:
        numbers: Of the frames of the video that were placed, int64 [n].
        poses: Camera to world of each, float64 [n, 4, 4].
        cameras: Of each picture without distortion.
        maps: The depth that was kept of each, float32 [h, w], read one at a time; empty where there is none.
    """

    numbers: NDArray[np.int64]
    poses: Matrix
    cameras: tuple[PinholeCameraIntrinsic, ...]
    maps: DepthMaps | tuple[()]


@dataclass(frozen=True)
class Judgement:
    """What was found, held against the room; None where there is nothing to judge.

    Attributes:
        cameras: Their errors.
        depth: That of the depth that was kept, along the rays of the cameras as they were found.
        surface: That of the mesh.
    """

    cameras: CameraErrors | None = None
    depth: DepthErrors | None = None
    surface: MeshErrors | None = None

    def why_poor(self) -> list[str]:
        """Which bars are missed."""
        reasons, cameras, depth, surface = [], self.cameras, self.depth, self.surface
        if cameras and cameras.percent.rmse > LARGEST_CENTER:
            off = f"{cameras.m.rmse * 1000:.1f} mm, {cameras.percent.rmse:.2f} % of the extent"
            reasons.append(f"the cameras are off by {off}, more than {LARGEST_CENTER:g} %")
        if depth and depth.kept < LEAST_KEPT:
            reasons.append(f"{format_share(depth.kept)} of the depth is kept, less than {format_share(LEAST_KEPT)}")
        if depth and not depth.median_relative <= LARGEST_DEPTH:
            reasons.append(f"depth is off by {100 * depth.median_relative:.2f} %, more than {100 * LARGEST_DEPTH:g} %")
        if depth and not depth.within >= LEAST_WITHIN:
            share = format_share(depth.within)
            reasons.append(f"{share} of the depth is within 1 %, less than {format_share(LEAST_WITHIN)}")
        if surface and surface.median > LARGEST_MEDIAN:
            limit = LARGEST_MEDIAN * 1000
            reasons.append(f"the surface is off by {surface.median * 1000:.1f} mm in the median, more than {limit:g}")
        return reasons if cameras and depth and surface else [*reasons, "there is no mesh to hold against the room"]


@dataclass(frozen=True, eq=False)
class VideoReport:
    """What became of the video.

    Attributes:
        trial: What was asked for.
        device: Where it was computed.
        made: What the job gave back.
        judged: Its errors.
        cost: Time and memory.
        files: Those that were written.
    """

    trial: VideoTrial
    device: str
    made: VideoResult
    judged: Judgement
    cost: Cost
    files: tuple[str, ...] = ()

    @property
    def poor(self) -> str | None:
        """Why the result is poor, or None."""
        verdict = self.made.figures.verdict
        reasons = [self.made.poor]
        if verdict.registered_count < LEAST_REGISTERED * verdict.picture_count:
            placed = f"{verdict.registered_count} of {verdict.picture_count} pictures were placed"
            reasons.append(f"{placed}, and all should be")
        return all_of(*reasons, *self.judged.why_poor())

    def to_json(self) -> dict[str, Any]:
        """What report.json holds; of the job's report all but the names of files, which lay elsewhere then."""
        made = self.made.to_json()
        errors = {name: getattr(self.judged, name) for name in ("cameras", "depth", "surface")}
        return {
            "command": "demo",
            "form": "video",
            "noise": self.trial.noise,
            "seed": self.trial.seed,
            "device": self.device,
            "frames": self.trial.frame_count,
            "video": {name: value for name, value in made.items() if name not in ("source", "files", "work")},
            **{name: None if found is None else found.to_json() for name, found in errors.items()},
            "seconds": self.cost.seconds,
            "peak_bytes": self.cost.peak_bytes,
            "poor": self.poor,
            "files": list(self.files),
        }

    def fields(self) -> Fields:
        """The same as labels and values for the terminal."""
        found, judged = self.made.figures, self.judged
        placed = f"{found.verdict.registered_count} placed of {found.picture_count}"
        return [
            ("pictures", f"{placed}, of a video of {self.trial.frame_count} frames, on {self.device}"),
            *([("cameras", str(judged.cameras))] if judged.cameras else []),
            *([("depth", str(judged.depth))] if judged.depth else []),
            *([("surface", str(judged.surface))] if judged.surface else []),
            ("stages", format_seconds({name: stage.cost["seconds"] for name, stage in self.made.reached.items()})),
            *self.cost.fields(),
            ("files", ", ".join(self.files)),
        ]

    def __str__(self) -> str:
        return text_of(self)


@dataclass(frozen=True)
class VideoTrial(Trial):
    """Film the room, make a mesh of the video, and leave it with its errors, a picture, both paths and report.json.

    Without the program ffmpeg the job gets a folder of JPEG pictures, which is not kept.

    Attributes:
        max_frames: At most so many frames of the video are taken.
        max_size: Longest side of the pictures that depth is estimated in [px].
    """

    FEWEST: ClassVar[int] = 3

    frame_count: int = FRAMES
    max_frames: int = MAX_FRAMES
    max_size: int = MAX_SIZE

    @property
    def outputs(self) -> tuple[str, ...]:
        """The files that it leaves: no video without ffmpeg."""
        return OUTPUTS if shutil.which("ffmpeg") else OUTPUTS[1:]

    def run(self, place: Place) -> VideoReport:
        """Film the room, have a mesh made, and hold it against the truth; files take their place when all are there."""
        noise, names = None if self.noise else 0.0, self.outputs
        frames = room_video_frames(self.frame_count, seed=self.seed, color_noise=noise, device=place.device)
        with tempfile.TemporaryDirectory(prefix=".video-", dir=place.folder) as name:
            work = Path(name)
            source = work / (VIDEO if VIDEO in names else "pictures")
            write_room_video(source, frames, truth=work / "truth", progress=place.say)
            (work / "truth" / LOG).replace(work / TRUTH)
            place.clock.stop("film")
            report = self._judged(place, work, source, frames)
            kept = tuple(name for name in names if (work / name).exists())
            for name in kept:
                check_writable(place.folder / name, overwrite=place.overwrite)
                (work / name).replace(place.folder / name)
        return replace(report, files=place.files((*kept, REPORT)))

    def _judged(self, place: Place, work: Path, source: Path, frames: RoomSequence) -> VideoReport:
        """Make a mesh of the video as the command does, and hold it against the room."""
        made = reconstruct(
            source,
            Settings(self.max_frames, self.max_size, units=Units(align=work / TRUTH), seed=self.seed),
            outputs=Outputs(work / MESH, trajectory=work / POSES, picture=work / PICTURE),
            work=work / "stages",
            device=place.device,
            progress=place.say,
        )
        place.clock.stop("make")
        place.say("measure", 0, 0)
        found = None if made.stages["undistorted"] is None else read_found(work / "stages")
        judged = judge(found, made.mesh, frames, device=place.device)
        place.clock.stop("measure")
        return VideoReport(self, str(place.device), made, judged, Cost(place.clock.seconds, peak_bytes()))


def read_found(work: Path) -> Found:
    """What the stages of a job left in its folder."""
    model = read_colmap_model(work / "undistorted" / SPARSE)
    maps = work / "fused" / MAPS
    numbers = [number_of(name) for name in model.names]
    return Found(
        np.array(numbers, np.int64),
        model.T_world_camera,
        tuple(camera.intrinsic for camera in model.cameras),
        DepthMaps.open(maps) if maps.is_dir() else (),
    )


def judge(found: Found | None, mesh: TriangleMesh | None, frames: RoomSequence, *, device: Any = "cpu") -> Judgement:
    """Hold cameras, depth and surface against the room.

    Args:
        found: What was found, in any unit and frame.
        mesh: The surface, in the frame of the room [m].
        frames: The video, which knows the truth.
        device: Where to compute.
    """
    truths = None if found is None else frames.poses[found.numbers]
    if found is None or truths is None or (cameras := camera_errors(found.poses, truths)) is None:
        return Judgement()
    pairs = _depth_pairs(found, np.array(cameras.transformation), cameras.scale, device)
    surface = None if mesh is None else room_mesh_errors(mesh, seen_points(truths, frames.intrinsic, device=device))
    return Judgement(cameras, depth_errors(pairs) if len(found.maps) else None, surface)


def seen_points(poses: Matrix, intrinsic: PinholeCameraIntrinsic, *, device: Any = "cpu") -> Matrix:
    """Points of the room's true surface that cameras see, one for each 16 x 16 pixels, shape [n, 3] [m]."""
    camera = intrinsic.scaled(1 / _SEEN_STEP)
    v, u = np.mgrid[: camera.height, : camera.width].reshape(2, -1)
    rays = np.column_stack([(u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, np.ones(len(u))])
    seen = []
    for frame in room_views(poses, camera, texture=False, device=device):
        z = np.asarray(frame.depth, np.float64).reshape(-1, 1)
        T = frame.T_world_camera
        seen.append(((rays * z) @ T[:3, :3].T + T[:3, 3])[z[:, 0] > 0])
    return np.concatenate(seen)


def _depth_pairs(
    found: Found, T: Matrix, scale: float, device: Any
) -> Iterator[tuple[NDArray[np.float32], NDArray[np.float32]]]:
    """The depth of each picture [m], and the true one along the same rays."""
    for pose, camera, each in zip(found.poses, found.cameras, found.maps, strict=True):
        placed = T @ pose
        placed[:3, :3] /= scale
        truth = room_views([placed], camera, texture=False, device=device).read(0)
        yield each.depth * np.float32(scale), np.asarray(truth.depth, np.float32)
