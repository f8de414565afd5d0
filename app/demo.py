"""A trial run that needs no data: a furnished room is rendered as RGB-D frames, fused, and held against the truth.

Then its sofa is scanned, and a surface made of the points.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from ..meshing.mesh import TriangleMesh
from ..meshing.mesh_files import write_triangle_mesh
from ..pcd.checks import check_count
from ..pcd.devices import resolve_device
from .console import Clock, ReportProgress, peak_bytes
from .demo_object import make_sofa, sofa_line, why_poor
from .demo_results import error_table, measure_errors, output_folder, write_report
from .fuse import describe_fusion, fuse_dataset, fusion_fields
from .mesh import draw_surface
from .pictures.picture_files import save_picture
from .pictures.render import render
from .room import room_sequence, surface_errors

FRAMES = 120
VOXEL_SIZE = 0.02  # [m]
DEPTH_MAX = 4.0  # [m]

# The most that the root mean square error may be, in voxels: a fusion that works stays well below.
LARGEST_RMSE = {"noise": 1.0, "no noise": 0.3}

OUTPUTS = ("room.ply", "room.png", "sofa.ply", "sofa.png", "report.json")


def run_demo(
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
    """Render the room, fuse it, and leave room.ply, room.png, sofa.ply, sofa.png and report.json in a folder.

    Args:
        folder: Made where it does not exist; its parent must.
        frame_count: Frames of the walk through the room.
        voxel_size: Edge of a voxel [m].
        seed: Chooses the noise, 0..2^31 - 1.
        noise: Depth and points as of a structured-light camera; False takes exact ones.
        device: Where to compute.
        overwrite: Replace outputs that exist.
        progress: As `fuse_dataset`.

    Returns:
        The report, in JSON's types: times, sizes, and errors against the true surface; "poor" says why the result is
        poor, or is None.

    Raises:
        FileError: An output that exists, or a folder that cannot be made or written.
        ValueError: A count or length out of range.
        DeviceError: No such device.
    """
    check_count("frame_count", frame_count)
    where, folder = resolve_device(device), Path(folder)
    with output_folder(folder, OUTPUTS, overwrite=overwrite):
        if progress is not None:
            progress("room", 0, 0)
        clock = Clock()
        sequence = room_sequence(frame_count, seed=seed, noise=noise, device=where)
        clock.stop("build")
        options: dict[str, Any] = {"voxel_size": voxel_size, "depth_max": DEPTH_MAX}
        result = fuse_dataset(sequence, **options, device=where, read_ahead=0, progress=progress)
        report = {"command": "demo", "noise": noise, "seed": seed, **describe_fusion(result, **options)}
        clock.seconds |= {"render" if stage == "read" else stage: value for stage, value in result.seconds.items()}
        if progress is not None:
            progress("sofa", 0, 0)
        surface, report["sofa"], seconds = make_sofa(seed=seed, noise=noise, device=where)
        clock.seconds |= seconds
        return _finish(folder, report, result.mesh, surface, clock, overwrite)


def _finish(
    folder: Path, report: dict[str, Any], room: TriangleMesh, sofa: TriangleMesh, clock: Clock, overwrite: bool
) -> dict[str, Any]:
    """Measure and draw the meshes, complete the report, and write all five."""
    clock.restart()
    errors = measure_errors(surface_errors(room.vertices, device=room.device), report["voxel_size"])
    clock.stop("measure")
    images = [render(room, mesh_show_back_face=False), draw_surface(sofa)]
    clock.stop("picture")
    files = [str(folder / name) for name in OUTPUTS]
    report |= {"errors": errors, "seconds": clock.seconds, "peak_bytes": peak_bytes(), "files": files}
    reasons = [_why_poor(errors, report["noise"]), why_poor(report["sofa"])]
    report["poor"] = "; ".join(reason for reason in reasons if reason) or None
    for mesh, image, k in zip((room, sofa), images, (0, 2), strict=True):
        write_triangle_mesh(files[k], mesh, overwrite=overwrite)
        save_picture(files[k + 1], image, overwrite=overwrite)
    write_report(files[-1], report, overwrite=overwrite)
    return report


def demo_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """The report as labels and values for the terminal."""
    return [*fusion_fields(report), ("errors", error_table(report["errors"])), ("sofa", sofa_line(report["sofa"]))]


def _why_poor(errors: dict[str, float] | None, noise: bool) -> str | None:
    if errors is None:
        return "the mesh is empty; take more frames (--frames)"
    limit = LARGEST_RMSE["noise" if noise else "no noise"]
    if errors["rmse_voxels"] <= limit:
        return None
    return f"the root mean square error is {errors['rmse_voxels']:.2f} voxels, more than {limit:g}; take more frames"
