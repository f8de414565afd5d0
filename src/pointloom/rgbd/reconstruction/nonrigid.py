"""The SLAC stage: joint alignment of fragments and camera distortion."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from ...core.checks import check_progress
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FileError, FilePath
from ...core.json_fields import Checks, has_fields, is_count, is_number, is_pose, is_text, list_of, optional
from ...core.paths import job_file
from ...core.progress import ReportProgress
from ...core.records import digest_of, files_below, read_record, write_record
from ...registration.deformable.control_grid import ControlGrid
from ...registration.deformable.control_grid_files import read_control_grid, write_control_grid
from ...registration.deformable.slac import (
    SLACOptimizerParams,
    run_rigid_optimizer_for_fragments,
    run_slac_optimizer_for_fragments,
)
from ...registration.pose_graphs.pose_graph import PoseGraph
from ...registration.pose_graphs.pose_graph_files import read_pose_graph, write_pose_graph
from ...registration.pose_graphs.reports import RefinementReport
from .config import ReconstructionConfig
from .fragments import Fragment, fragments_in
from .job_files import JobFiles
from .placement import Placement, read_clouds
from .refinement import latest_placement

STAGE = "slac"
SETTINGS = ("max_iterations", "voxel_size", "distance_threshold", "fitness_threshold", "regularizer_weight")


@dataclass(frozen=True, eq=False)
class BentPlacement:
    """Result of the SLAC stage.

    Attributes:
        placement: The fragment poses. Its pose graph has no `report`.
        grid: Distortion grid in fragment coordinates. Without anchors if rigid.
        figures: "method", "anchors", "bent_m" (root mean square displacement), "rmse_before" and "rmse" (point-to-plane
            [m]), "edges", and the number "used".
    """

    placement: Placement
    grid: ControlGrid
    figures: dict[str, Any]


def slac_params(config: ReconstructionConfig) -> SLACOptimizerParams:
    return SLACOptimizerParams(**{name: getattr(config, name) for name in SETTINGS})


def refine_with_slac(
    config: ReconstructionConfig,
    folder: FilePath,
    *,
    resume: bool = False,
    device: DeviceLike = None,
    progress: ReportProgress | None = None,
) -> BentPlacement:
    """Align the fragments in a job's folder together with the distortion of their camera.

    `run_slac_optimizer_for_fragments` (or `run_rigid_optimizer_for_fragments` if `config.method` is "rigid") from the
    latest placement. `integrate_scene` with `slac=True` then uses the grid.

    Args:
        config, folder, device: As of `register_fragments`. Shorter fragments model the distortion better.
        resume: Keep a valid earlier result.
        progress: Called with ("slac", steps done, steps).

    Returns:
        The fragment poses, the grid, and the figures.

    Raises:
        TypeError, ValueError: Not a configuration, invalid SLAC options, or no point pairs within `distance_threshold`.
        FileError, DeviceError: No placement, a file that cannot be read or written, or no such device.

    Notes:
        Bitwise reproducible. A single fragment, or fragments without an edge, are unchanged.
    """
    job, where, params = JobFiles.make(folder, config), resolve_device(device), slac_params(config)
    report_progress = check_progress(progress)
    fragments = fragments_in(job)
    before = latest_placement(job, fragments)
    settings = {name: getattr(config, name) for name in (*SETTINGS, "method")}
    made_from = digest_of([before.made_from, settings])
    if resume:
        done = _read(job, before, where, made_from)
        if done is not None:
            return done
    clouds = read_clouds([fragments[i] for i in before.members], config, where)
    graph, grid = before.pose_graph, ControlGrid(device=where)
    if graph.edges:
        if config.method == "rigid":
            graph = run_rigid_optimizer_for_fragments(clouds, graph, params, progress=report_progress)
        else:
            graph, grid = run_slac_optimizer_for_fragments(clouds, graph, params, progress=report_progress)
    result = BentPlacement(_placement(before, graph, made_from), grid, _figures(config.method, grid, graph.report))
    _write(job, result)
    return result


def placement_with_slac(job: JobFiles, fragments: list[Fragment], device: DeviceLike) -> BentPlacement:
    """The current result of `refine_with_slac`. FileError if missing or outdated."""
    result = _read(job, latest_placement(job, fragments), device)
    if result is None:
        raise FileError(
            job.root, "contains no result of refine_with_slac", remedy="Run refine_with_slac with this folder first"
        )
    return result


def _placement(before: Placement, graph: PoseGraph, made_from: str) -> Placement:
    poses = before.poses.copy()
    poses[before.members] = [node.pose for node in graph.nodes]
    graph = PoseGraph(graph.nodes, graph.edges)
    return replace(before, poses=poses, pose_graph=graph, made_from=made_from, before=before.made_from)


def _figures(method: str, grid: ControlGrid, report: object) -> dict[str, Any]:
    shifts = grid.get_curr_positions() - grid.get_init_positions()
    bent = float(np.sqrt((shifts**2).sum(axis=1).mean())) if len(grid) else 0.0
    values = {"method": method, "anchors": len(grid), "bent_m": bent}
    if not isinstance(report, RefinementReport):
        return values | {"rmse_before": None, "rmse": None, "edges": 0, "used": 0}
    used = sum(overlap.used for overlap in report.overlaps)
    ends = {"rmse_before": float(report.rmse[0]), "rmse": float(report.rmse[-1])}
    return values | ends | {"edges": len(report.overlaps), "used": used}


def _grid_path(job: JobFiles) -> Path:
    return job.slac_graph.with_name("control_grid.npz")


def _write(job: JobFiles, bent: BentPlacement) -> None:
    paths, placement = [job_file(path, job.root) for path in (job.slac_graph, _grid_path(job))], bent.placement
    write_pose_graph(paths[0], placement.pose_graph)
    write_control_grid(paths[1], bent.grid)
    result = {"poses": placement.poses.tolist(), "before": placement.before, "figures": bent.figures}
    write_record(job.record(STAGE), STAGE, placement.made_from, files_below(job.root, paths), result)


def _read(job: JobFiles, before: Placement, device: DeviceLike, made_from: str | None = None) -> BentPlacement | None:
    checks: Checks = {"poses": list_of(is_pose, len(before.poses)), "before": is_text, "figures": _is_figures}
    result = read_record(job.record(STAGE), STAGE, job.root, has_fields(checks), made_from)
    if result is None or result["before"] != before.made_from:
        return None
    graph = read_pose_graph(job.slac_graph)
    if len(graph.nodes) != len(before.members):
        return None
    names = {"poses": np.array(result["poses"]), "made_from": result["made_from"], "before": result["before"]}
    placement = replace(before, pose_graph=graph, **names)
    return BentPlacement(placement, read_control_grid(_grid_path(job), device=device), result["figures"])


def _is_figures(value: Any) -> bool:
    """True for the result of `_figures`."""
    ends = dict.fromkeys(("rmse_before", "rmse"), optional(is_number))
    checks: Checks = {"method": is_text, "bent_m": is_number, **dict.fromkeys(("anchors", "edges", "used"), is_count)}
    return has_fields(checks | ends)(value) and not (value["edges"] and None in [value[name] for name in ends])
