"""The hard trial run: the furnished room from a camera whose poses nobody tells, and how far it drifted.

The camera is carried about the room and comes back to where it began. Its frames are tracked and fused; the path is
held against the true one, and the surface, brought back by the first pose alone, against the true surface.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np

from ..meshing.mesh import TriangleMesh
from ..meshing.mesh_files import write_triangle_mesh
from ..pcd.checks import check_count
from ..pcd.devices import resolve_device
from ..pcd.io.trajectory import Trajectory, write_trajectory
from .console import Clock, ReportProgress, format_seconds, peak_bytes, say_nothing
from .demo_results import error_table, measure_errors, output_folder, write_report
from .evaluate import error_fields
from .picture import render_mesh, save_picture
from .reconstruct import describe_mesh, make_model
from .room import room_loop_sequence, surface_errors
from .track import tracking_fields

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
        size = {"width": WIDTH, "height": HEIGHT}
        walk = room_loop_sequence(frame_count, **size, seed=seed, noise=noise, device=where)
        clock.stop("build")
        options = {"voxel_size": voxel_size, "depth_max": DEPTH_MAX, "device": where, "read_ahead": 0}
        made = make_model(walk, **options, progress=say, clock=clock)
        report = {"command": "demo", "noise": noise, "seed": seed, "device": str(where), **made.report}
        truth = Trajectory(walk.poses)
        ...
