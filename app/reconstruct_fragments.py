"""`pointloom reconstruct --method fragments`: the reconstruction system as a command runs it."""

from __future__ import annotations

import dataclasses
from pathlib import Path
from typing import Any

import numpy as np

from ..meshing.mesh import TriangleMesh
from ..meshing.mesh_files import read_triangle_mesh
from ..pcd.io.datasets import RGBDDataset
from ..pcd.io.trajectory import Trajectory, read_trajectory
from .console import Clock, ReportProgress
from .frames import DEPTH_MAX, FilePath, camera_line
from .reconstruction.config import ReconstructionConfig
from .reconstruction.job import run_system
from .reconstruction.places import Places

_SHOWN = 5  # runs of lost frames


def make_settings(config: FilePath | None, voxel_size: float | None, depth_max: float | None) -> ReconstructionConfig:
    """The configuration of a file, or the usual one, with what else was asked for.

    Raises:
        FileError: A configuration that cannot be read.
        ValueError: Lengths that do not go together.
    """
    settings = ReconstructionConfig(depth_max=DEPTH_MAX) if config is None else ReconstructionConfig.read(config)
    given = {"tsdf_voxel_size": voxel_size, "depth_max": depth_max}
    return dataclasses.replace(settings, **{name: value for name, value in given.items() if value is not None})


def default_work_folder(output: FilePath) -> Path:
    """The folder of the stages beside the mesh: mesh.ply has mesh-fragments."""
    return Path(output).with_name(f"{Path(output).stem}-fragments")


def run_fragments(
    dataset: RGBDDataset,
    settings: ReconstructionConfig,
    work: Path,
    *,
    slac: bool,
    resume: bool,
    device: Any,
    progress: ReportProgress,
    clock: Clock,
) -> tuple[TriangleMesh, Trajectory, dict[str, Any], str | None]:
    """Run the system, and take its mesh and its path.

    Returns:
        The mesh, empty where there is none; the path; what else is to be told, in JSON's types; why it is poor.

    Raises:
        FileError: A file of a stage that cannot be written; what was finished stays.
    """
    report = run_system(dataset, settings, work, slac=slac, resume=resume, device=device, progress=progress)
    clock.seconds |= report["seconds"]
    clock.restart()
    places = Places.make(work, settings)
    mesh, path = TriangleMesh(device=device), Trajectory(np.empty((0, 4, 4)), ids=np.empty((0, 3), np.int64))
    for file in report["files"]:
        if Path(file) == places.scene_mesh:
            mesh = read_triangle_mesh(file, device=device)
        elif Path(file) == places.trajectory:
            path = read_trajectory(file)
    clock.stop("read")
    names = ("frames", "used", "lost", "fragments", "edges", "loops", "slac", "resumed")
    told = {name: report[name] for name in names}
    told |= {"voxel_size": settings.volume_voxel_size, "depth_max": settings.depth_max, "work": str(work)}
    return mesh, path, told, report["poor"]


def fragment_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """The frames, the camera and the fragments as labels and values."""
    frames = f"{report['used']} of {report['frames']} in the model, on {report['device']}"
    if left_out := report["left_out"]:
        frames += f"\n{len(left_out)} left out, the first {left_out[0]}"
    placed = sum(fragment["placed"] for fragment in report["fragments"])
    fragments = f"{placed} of {len(report['fragments'])} joined, {report['loops']} loops"
    if kept := report["resumed"]["fragments"]:
        fragments += f"; {kept} kept from an earlier run"
    fields = [("frames", frames), ("camera", camera_line(report["camera"])), ("fragments", fragments)]
    if report["lost"]:
        runs = [_run_line(run) for run in report["lost"][:_SHOWN]]
        fields.append(("lost", "\n".join([*runs, *(["and more"] if len(report["lost"]) > _SHOWN else [])])))
    if report["slac"]:
        fields.append(("slac", _slac_line(report["slac"])))
    return [*fields, ("stages", report["work"])]


def _slac_line(figures: dict[str, Any]) -> str:
    if not figures["edges"]:
        return "nothing to align: no two fragments overlap; fewer frames a fragment (--config) make more of them"
    apart = f"{figures['rmse_before'] * 1000:.1f} to {figures['rmse'] * 1000:.1f} mm apart"
    bent = f", {figures['anchors']:,} anchors moved by {figures['bent_m'] * 1000:.1f} mm" if figures["anchors"] else ""
    return f"fragments {apart} on {figures['used']} of {figures['edges']} overlaps{bent}"


def _run_line(run: dict[str, Any]) -> str:
    ends = run["first"] if run["count"] == 1 else f"{run['first']} to {run['last']} ({run['count']})"
    return f"{ends}: {run['reason']}"
