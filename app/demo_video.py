"""The trial run of pictures alone: the room as a video, without depth or poses, and the mesh that is made of it.

The video goes through the same job as `pointloom video`; the truth settles unit and frame, by the similarity that fits
the centres of the cameras, and everything is then held against the room.
"""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..meshing.mesh import TriangleMesh
from ..meshing.mesh_files import read_triangle_mesh
from ..pcd.camera import PinholeCameraIntrinsic
from ..pcd.checks import check_count
from ..pcd.devices import resolve_device
from ..pcd.io.atomic import check_writable
from ..pcd.picture_names import number_of
from .console import Clock, ReportProgress, format_bytes, format_seconds, format_share, peak_bytes, say_nothing
from .demo_results import output_folder, write_report
from .mvs import DepthMaps
from .room import RoomSequence, room_views
from .room_errors import camera_errors, depth_errors, room_mesh_errors
from .room_video import FRAMES, LOG, room_video_frames, write_room_video
from .video.job import Settings, mesh_video
from .video.surface import MAPS, SPARSE
from .video.units import Units

Matrix = NDArray[np.float64]

MAX_FRAMES = 30  # of which as many are taken, 12 degrees and 25 cm apart
MAX_SIZE = 320  # [px] of the pictures that depth is estimated in: all 640 take four times as long

LEAST_REGISTERED = 1.0  # share of the pictures
LARGEST_CENTER = 0.3  # [% of the extent] root mean square of the centres' errors
LEAST_KEPT = 0.75  # share of the pixels that keep their depth
LARGEST_DEPTH = 0.002  # of the true depth, in the median
LEAST_WITHIN = 0.93  # share of what is kept that is within 1 % of the true depth
LARGEST_MEDIAN = 0.01  # [m] of the vertices' distances from the true surface

VIDEO, MESH, PICTURE, POSES, TRUTH, REPORT = "room.mp4", "mesh.ply", "mesh.png", "poses.log", "truth.log", "report.json"
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


def run_video_demo(
    folder: str | os.PathLike[str],
    *,
    frame_count: int = FRAMES,
    max_frames: int = MAX_FRAMES,
    max_size: int = MAX_SIZE,
    seed: int = 0,
    noise: bool = True,
    device: Any = "auto",
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> dict[str, Any]:
    """Film the room, make a mesh of the video, and leave it with its errors, a picture, both paths and report.json.

    Args:
        folder: Made where it does not exist; its parent must.
        frame_count: Frames of the video, one round through the room.
        max_frames: At most so many of them are taken.
        max_size: Longest side of the pictures that depth is estimated in [px].
        seed: Chooses the noise of the pictures, and what the job draws.
        noise: Pictures with the noise of a sensor; False takes clean ones.
        device: Where to compute.
        overwrite: Replace outputs that exist.
        progress: Called with the stage, how many of its steps are done, and how many there are.

    Returns:
        The report, in JSON's types: "video" (that of `mesh_video`), "cameras", "depth", "surface" (their errors, or
        None where it did not come to that), "files"; "poor" says why the result is poor, or is None.

    Raises:
        FileError: An output that exists, a folder that cannot be made or written, or a program that is missing.
        ValueError: A count out of range.
        DeviceError: No such device.

    Notes:
        Without the program ffmpeg the job gets a folder of JPEG pictures, which is not kept.
    """
    check_count("frame_count", frame_count, minimum=3)
    where, folder, clock, say = resolve_device(device), Path(folder), Clock(), progress or say_nothing
    names = OUTPUTS if shutil.which("ffmpeg") else OUTPUTS[1:]
    with output_folder(folder, names, overwrite=overwrite):
        frames = room_video_frames(frame_count, seed=seed, color_noise=None if noise else 0.0, device=where)
        with tempfile.TemporaryDirectory(prefix=".video-", dir=folder) as name:
            work = Path(name)  # files take their place when all are there
            source = work / (VIDEO if VIDEO in names else "pictures")
            write_room_video(source, frames, truth=work / "truth", progress=say)
            (work / "truth" / LOG).replace(work / TRUTH)
            clock.stop("film")
            made = mesh_video(
                source,
                work / MESH,
                settings=Settings(max_frames, max_size, units=Units(align=work / TRUTH), seed=seed),
                trajectory=work / POSES,
                picture=work / PICTURE,
                work=work / "stages",
                device=where,
                progress=say,
            )
            clock.stop("make")
            say("measure", 0, 0)
            found = read_found(work / "stages") if made["undistorted"] else None
            mesh = read_triangle_mesh(work / MESH, device=where) if made["files"] else None
            judged = judge(found, mesh, frames, device=where)
            clock.stop("measure")
            report = {"command": "demo", "form": "video", "noise": noise, "seed": seed, "device": str(where)}
            report |= {"frames": frame_count, "video": _without_places(made), **judged}
            report |= {"seconds": clock.seconds, "peak_bytes": peak_bytes()}
            report["poor"] = "; ".join(reason for reason in [made["poor"], *_why_poor(report)] if reason) or None
            kept = [name for name in names if (work / name).exists()]
            report["files"] = [str(folder / name) for name in [*kept, REPORT]]
            for name in kept:
                check_writable(folder / name, overwrite=overwrite)
                (work / name).replace(folder / name)
            write_report(str(folder / REPORT), report, overwrite=overwrite)
        return report


def _without_places(made: dict[str, Any]) -> dict[str, Any]:
    """The job's report without the names of files that lay elsewhere then."""
    return {name: value for name, value in made.items() if name not in ("source", "files", "work")}


def read_found(work: Path) -> Found:
    """What the stages of a job left in its folder."""
    from ..pcd.io.colmap import read_colmap_model

    model = read_colmap_model(work / "undistorted" / SPARSE)
    maps = work / "fused" / MAPS
    numbers = [number_of(name) for name in model.names]
    return Found(
        np.array(numbers, np.int64),
        model.T_world_camera,
        tuple(camera.intrinsic for camera in model.cameras),
        DepthMaps.open(maps) if maps.is_dir() else (),
    )


def judge(
    found: Found | None, mesh: TriangleMesh | None, frames: RoomSequence, *, device: Any = "cpu"
) -> dict[str, Any]:
    """Hold cameras, depth and surface against the room.

    Args:
        found: What was found, in any unit and frame.
        mesh: The surface, in the frame of the room [m].
        frames: The video, which knows the truth.
        device: Where to compute.

    Returns:
        "cameras" as `camera_errors`, "depth" as `depth_errors` (along the rays of the cameras as they were found),
        "surface" as `room_mesh_errors`; None where there is nothing to judge.
    """
    nothing = {"cameras": None, "depth": None, "surface": None}
    if found is None:
        return nothing
    truths = frames.poses[found.numbers]
    cameras = camera_errors(found.poses, truths)
    if cameras is None:
        return nothing
    pairs = _depth_pairs(found, np.array(cameras["transformation"]), cameras["scale"], device)
    surface = None if mesh is None else room_mesh_errors(mesh, seen_points(truths, frames.intrinsic, device=device))
    return {"cameras": cameras, "depth": depth_errors(pairs) if len(found.maps) else None, "surface": surface}


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


def _why_poor(report: dict[str, Any]) -> list[str]:
    """Which bars are missed, beside what the job itself says."""
    model, cameras, depth, surface = report["video"]["model"], report["cameras"], report["depth"], report["surface"]
    reasons = []
    if model and model["registered_count"] < LEAST_REGISTERED * model["picture_count"]:
        reasons.append(
            f"{model['registered_count']} of {model['picture_count']} pictures were placed, and all should be"
        )
    if cameras and cameras["percent"]["rmse"] > LARGEST_CENTER:
        off = f"{cameras['m']['rmse'] * 1000:.1f} mm, {cameras['percent']['rmse']:.2f} % of the extent"
        reasons.append(f"the cameras are off by {off}, more than {LARGEST_CENTER:g} %")
    if depth and depth["kept"] < LEAST_KEPT:
        reasons.append(f"{format_share(depth['kept'])} of the depth is kept, less than {format_share(LEAST_KEPT)}")
    if depth and not depth["median_relative"] <= LARGEST_DEPTH:
        reasons.append(f"depth is off by {100 * depth['median_relative']:.2f} %, more than {100 * LARGEST_DEPTH:g} %")
    if depth and not depth["within"] >= LEAST_WITHIN:
        share = format_share(depth["within"])
        reasons.append(f"{share} of the depth is within 1 %, less than {format_share(LEAST_WITHIN)}")
    if surface and surface["median"] > LARGEST_MEDIAN:
        limit = LARGEST_MEDIAN * 1000
        reasons.append(f"the surface is off by {surface['median'] * 1000:.1f} mm in the median, more than {limit:g}")
    return reasons if cameras and depth and surface else [*reasons, "there is no mesh to hold against the room"]


def video_demo_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """The report as labels and values for the terminal."""
    made = report["video"]
    frames, model = made["frames"], made["model"]
    placed = f"{model['registered_count']} placed of {frames['kept']}" if model else f"{frames['kept']}"
    return [
        ("pictures", f"{placed}, of a video of {report['frames']} frames, on {report['device']}"),
        *([("cameras", _camera_line(report["cameras"]))] if report["cameras"] else []),
        *([("depth", _depth_line(report["depth"]))] if report["depth"] else []),
        *([("surface", _surface_line(report["surface"]))] if report["surface"] else []),
        ("stages", format_seconds({name: stage["seconds"] for name, stage in made["stages"].items()})),
        ("seconds", format_seconds(report["seconds"])),
        ("memory", f"{format_bytes(report['peak_bytes'])} at most"),
        ("files", ", ".join(report["files"])),
    ]


def _camera_line(errors: dict[str, Any]) -> str:
    metres, percent, turn = errors["m"], errors["percent"], errors["deg"]
    return (
        f"off by {metres['rmse'] * 1000:.2f} mm root mean square ({percent['rmse']:.3f} % of "
        f"{errors['extent_m']:.2f} m), {metres['max'] * 1000:.2f} at most; {turn['rmse']:.3f} degrees"
    )


def _depth_line(errors: dict[str, Any]) -> str:
    return (
        f"{format_share(errors['kept'])} of the pixels kept, off by {100 * errors['median_relative']:.2f} % in the "
        f"median, {format_share(errors['within'])} within 1 %"
    )


def _surface_line(errors: dict[str, Any]) -> str:
    return (
        f"off by {errors['median'] * 1000:.2f} mm in the median, {format_share(errors['within'])} of "
        f"{errors['vertices']:,} vertices within 2 cm; covers {format_share(errors['covered'])} of what was seen"
    )
