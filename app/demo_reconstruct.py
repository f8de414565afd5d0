"""The hard trial run: the furnished room from a camera whose poses nobody tells, and how far it drifted.

The camera is carried about the room and comes back to where it began. Its frames are tracked and fused; the path is
held against the true one, and the surface, brought back by the first pose alone, against the true surface.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..meshing.mesh_files import write_triangle_mesh
from ..pcd.checks import check_count
from ..pcd.devices import resolve_device
from ..pcd.io.trajectory import Trajectory
from .console import Clock, ReportProgress, format_bytes, format_seconds, peak_bytes, say_nothing
from .demo_results import error_table, measure_errors, output_folder, write_report
from .evaluate import error_fields
from .frames import describe_camera
from .pictures.picture_files import save_picture
from .pictures.render import render
from .reconstruct import describe_mesh
from .reconstruct_slam import Reconstruction, loop_fields, run_slam
from .room import room_loop_sequence, surface_errors
from .track import tracking_fields
from .trajectory_report import errors_against_truth, write_poses

Matrix = NDArray[np.float64]

FRAMES = 300
WIDTH, HEIGHT = 640, 480
VOXEL_SIZE = 0.02  # [m]
DEPTH_MAX = 4.0  # [m]

LARGEST_ATE = 0.03  # [m] root mean square
LARGEST_MEDIAN = 0.02  # [m] of the vertices' distances from the true surface

OUTPUTS = ("room.ply", "room.png", "poses.log", "truth.log", "report.json")


def run_reconstruct_demo(
    folder: str | os.PathLike[str],
    *,
    frame_count: int = FRAMES,
    voxel_size: float = VOXEL_SIZE,
    seed: int = 0,
    noise: bool = True,
    device: Any = "auto",
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> dict[str, Any]:
    """Reconstruct the room without poses, and leave room.ply, room.png, poses.log, truth.log and report.json.

    Args:
        folder: Made where it does not exist; its parent must.
        frame_count: Frames of the round through the room.
        voxel_size: Edge of a voxel [m].
        seed: Chooses the noise, 0..2^31 - 1.
        noise: Depth as of a structured-light camera; False takes exact one.
        device: Where to compute.
        overwrite: Replace outputs that exist.
        progress: As `fuse_dataset`.

    Returns:
        The report, in JSON's types: the path's errors, how far its end drifted, the errors of the surface; "poor" says
        why the result is poor, or is None.

    Raises:
        FileError: An output that exists, or a folder that cannot be made or written.
        ValueError: A count or length out of range.
        DeviceError: No such device.
    """
    check_count("frame_count", frame_count, minimum=2)
    where, folder, clock, say = resolve_device(device), Path(folder), Clock(), progress or say_nothing
    with output_folder(folder, OUTPUTS, overwrite=overwrite):
        say("room", 0, 0)
        size: dict[str, Any] = {"width": WIDTH, "height": HEIGHT}
        walk = room_loop_sequence(frame_count, **size, seed=seed, noise=noise, device=where)
        clock.stop("build")
        options: dict[str, Any] = {"voxel_size": voxel_size, "depth_max": DEPTH_MAX, "device": where, "read_ahead": 0}
        made = run_slam(walk, **options, progress=say, clock=clock)
        report = {"command": "demo", "form": "reconstruct", "noise": noise, "seed": seed, "device": str(where)}
        report |= {"left_out": [], "camera": describe_camera(walk, "a made-up camera"), **made.report}
        return _finish(folder, report, made, walk.poses, clock, overwrite)


def _finish(
    folder: Path, report: dict[str, Any], made: Reconstruction, true_poses: Matrix, clock: Clock, overwrite: bool
) -> dict[str, Any]:
    """Measure the path and the surface, complete the report, and write all five."""
    clock.restart()
    path, poor = made.trajectory, [*made.poor]
    if not len(path) or not len(made.mesh):
        raise ValueError("frame_count: no frame could be placed or seen often enough; take more frames")
    assert path.ids is not None
    truths = true_poses[path.ids[:, 0]]
    T = truths[0] @ np.linalg.inv(path.poses[0])  # where the camera began is all that is told
    mesh = made.mesh.transform(T)
    brought = Trajectory(T @ path.poses, ids=path.ids)
    report |= describe_mesh(mesh) | {"path_errors": errors_against_truth(list(path.poses), list(truths))}
    report["drift"] = _drift(brought.poses, truths)
    report["errors"] = measure_errors(surface_errors(mesh.vertices, device=mesh.device), report["voxel_size"])
    clock.stop("measure")
    image = render(mesh, mesh_show_back_face=False)
    clock.stop("picture")
    poor += _why_poor(report)
    files = [str(folder / name) for name in OUTPUTS]
    report |= {"seconds": clock.seconds, "peak_bytes": peak_bytes(), "files": files}
    report["poor"] = "; ".join(reason for reason in poor if reason) or None
    write_triangle_mesh(files[0], mesh, overwrite=overwrite)
    save_picture(files[1], image, overwrite=overwrite)
    write_poses(files[2], brought, overwrite=overwrite)
    write_poses(files[3], Trajectory(true_poses), overwrite=overwrite)
    write_report(files[4], report, overwrite=overwrite)
    return report


def reconstruct_demo_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """The report as labels and values for the terminal."""
    drift = report["drift"]
    return [
        *tracking_fields(report),
        *loop_fields(report),
        ("mesh", f"{report['vertices']:,} vertices, {report['triangles']:,} triangles"),
        *(error_fields(report["path_errors"]) if report["path_errors"] else []),
        (
            "drift",
            f"{drift['end_m'] * 1000:.1f} mm and {drift['end_deg']:.2f} degrees at the end, from the first pose on",
        ),
        ("errors", error_table(report["errors"])),
        ("seconds", format_seconds(report["seconds"])),
        ("memory", f"{format_bytes(report['peak_bytes'])} at most"),
        ("files", ", ".join(report["files"])),
    ]


def _drift(poses: Matrix, truths: Matrix) -> dict[str, float]:
    """How far the last pose lies from the true one where the first is given."""
    apart = np.linalg.inv(truths[-1]) @ poses[-1]
    cosine = np.clip((np.trace(apart[:3, :3]) - 1) / 2, -1, 1)
    return {"end_m": float(np.linalg.norm(apart[:3, 3])), "end_deg": float(np.degrees(np.arccos(cosine)))}


def _why_poor(report: dict[str, Any]) -> list[str]:
    reasons, path, surface = [], report["path_errors"], report["errors"]
    if path is not None and path["absolute"]["m"]["rmse"] > LARGEST_ATE:
        ate = path["absolute"]["m"]["rmse"] * 1000
        reasons.append(f"the path is off by {ate:.1f} mm (ATE), more than {LARGEST_ATE * 1000:g}; take more frames")
    if surface is not None and surface["median"] > LARGEST_MEDIAN:
        median = surface["median"] * 1000
        limit = LARGEST_MEDIAN * 1000
        reasons.append(f"the surface is off by {median:.1f} mm in the median, more than {limit:g}; take more frames")
    return reasons
