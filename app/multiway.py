"""The clouds of a folder brought into one frame: `register_folder`."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np

from ..pcd.cloud import PointCloud
from ..pcd.devices import resolve_device
from ..pcd.errors import FileError
from ..pcd.io.formats import WRITTEN
from ..pcd.io.point_cloud import table_of
from ..pcd.io.trajectory import Trajectory, write_trajectory
from ..registration.multiway import FragmentsResult, register_fragments
from ..registration.pose_graph_files import write_pose_graph
from ..registration.scan_files import list_scans
from . import tables
from .clouds import FilePath, closing_fields, make_report
from .console import Clock, ReportProgress, say_nothing
from .register import choose_voxel_size, read_cloud

_SHOWN = 5  # clouds that could not be placed, by name


def register_folder(
    folder: FilePath,
    output: FilePath,
    *,
    voxel_size: float | None = None,
    neighbors: int | None = None,
    merged: FilePath | None = None,
    graph: FilePath | None = None,
    device: Any = "auto",
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> dict[str, Any]:
    """Find where the clouds of a folder lie, and write their poses; outputs are checked before the work.

    Args:
        folder: Clouds of one kind, taken in natural order of their names.
        output: A .log file of poses, T_reference_cloud; the first number of each is that of its cloud, from 0.
        voxel_size: Edge of the voxels that the clouds are thinned to [m]; None chooses it from them.
        neighbors: As of `register_fragments`.
        merged: A cloud of all that could be placed, with the attributes that all of them have.
        graph: A .json file for the pose graph.
        device: Where to compute.
        overwrite: Replace outputs that exist.
        progress: Called with each stage, and in that of the pairs with how many are done and how many there are.

    Returns:
        What was done, in JSON's types; "poor" says why the result is poor, or is None: clouds that could not be placed,
        which the outputs leave out. Nothing is written where no two clouds lie on each other.

    Raises:
        FileError: A file that cannot be read or written, or fewer than two clouds.
        ValueError: A length that is not positive, or no neighbours.
        DeviceError: No such device.
    """
    _check_outputs(folder, output, merged, graph, overwrite)
    say, clock, where = progress or say_nothing, Clock(), resolve_device(device)
    paths = _list_clouds(folder)
    clouds = []
    for done, path in enumerate(paths):
        say("read", done, len(paths))
        clouds.append(read_cloud(path, where))
    say("read", len(paths), len(paths))
    clock.stop("read")
    size = choose_voxel_size(*clouds) if voxel_size is None else voxel_size
    clock.stop("voxels")
    found = register_fragments(
        clouds, voxel_size=size, neighbors=neighbors, progress=lambda done, total: say("pairs", done, total)
    )
    clock.stop("register")
    names = [path.name for path in paths]
    lost = [name for name, is_placed in zip(names, found.placed, strict=True) if not is_placed]
    is_written = int(found.placed.sum()) > 1
    left_out, files = [], []
    if is_written:
        say("write", 0, 0)
        left_out = _write_results(found, clouds, output, merged, graph, overwrite)
        files = [os.fspath(path) for path in (output, graph, merged) if path is not None]
    clock.stop("write")
    poor = _why_poor(lost, len(names), is_written)
    report = make_report("multiway", folder, files, clock, left_out, poor=poor)
    sizes = {"device": str(where), "voxel_size": size, "voxel_size_given": voxel_size is not None}
    return report | sizes | _describe(found, names, lost, clouds)


def multiway_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """What was done as labels and values for the terminal."""
    chosen = "" if report["voxel_size_given"] else ", chosen from the clouds"
    placed = len(report["clouds"]) - len(report["not_placed"])
    edges = f"{report['pairs']:,} that lie on each other, {report['edges']:,} of them kept in the pose graph"
    return [
        ("clouds", f"{placed} of {len(report['clouds'])} placed, {report['points']:,} points"),
        ("voxels", f"{report['voxel_size']:g} m{chosen}"),
        ("pairs", f"{edges}, {report['loops']:,} to close loops"),
        ("frame", f"that of {report['reference']}"),
        *closing_fields(report),
    ]


def _check_outputs(folder: FilePath, output: FilePath, merged: Any, graph: Any, overwrite: bool) -> None:
    tables.check_output(output, (".log",), what="poses", overwrite=overwrite)
    if merged is not None:
        tables.check_output(merged, WRITTEN, what="clouds", overwrite=overwrite)
        if Path(merged).resolve().parent == Path(folder).resolve():
            reason = f"lies in {os.fspath(folder)}, where the next run would take it for one of the clouds"
            raise FileError(merged, reason, remedy="Choose another folder")
    if graph is not None:
        tables.check_output(graph, (".json",), what="pose graphs", overwrite=overwrite)


def _list_clouds(folder: FilePath) -> list[Path]:
    paths = list_scans(folder)
    if len(paths) < 2:
        raise FileError(folder, f"holds one cloud, {paths[0].name}; two are needed", remedy="Give another folder")
    return paths


def _write_results(
    found: FragmentsResult, clouds: list[PointCloud], output: Any, merged: Any, graph: Any, overwrite: bool
) -> list[str]:
    """Write what is asked for; returns the names of what the merged cloud cannot hold, or not all clouds have."""
    placed = np.flatnonzero(found.placed)
    ids = np.stack([placed, placed, np.full(len(placed), len(clouds))], axis=1)
    write_trajectory(output, Trajectory(found.poses[placed], ids=ids), overwrite=overwrite)
    if graph is not None:
        write_pose_graph(graph, found.pose_graph, overwrite=overwrite)
    if merged is None:
        return []
    parts = [clouds[i].transform(found.poses[i]) for i in placed]
    whole = PointCloud.concatenate(parts)
    named = dict.fromkeys(name for part in parts for name in _names_of(part))
    lost = [name for name in named if name not in _names_of(whole)]
    return [*lost, *tables.write_cloud_table(merged, table_of(whole), overwrite=overwrite)]


def _names_of(cloud: PointCloud) -> list[str]:
    vectors = {"normals": cloud.has_normals, "colors": cloud.has_colors}
    return [*(name for name, is_there in vectors.items() if is_there), *cloud.attributes]


def _why_poor(lost: list[str], count: int, is_written: bool) -> str | None:
    if not lost:
        return None
    if not is_written:
        return f"no two of the {count} clouds lie on each other; nothing was written; try another --voxel"
    names = ", ".join(lost[:_SHOWN]) + (" and more" if len(lost) > _SHOWN else "")
    return f"{len(lost)} of {count} clouds could not be placed: {names}; try another --voxel, or more --loops"


def _describe(found: FragmentsResult, names: list[str], lost: list[str], clouds: list[PointCloud]) -> dict[str, Any]:
    """The figures of a registration, in JSON's types."""
    edges = found.pose_graph.edges
    return {
        "clouds": names,
        "points": sum(len(cloud) for cloud in clouds),
        "not_placed": lost,
        "reference": names[found.reference],
        "poses": [T.tolist() if placed else None for T, placed in zip(found.poses, found.placed, strict=True)],
        "pairs": len(found.pairs),
        "edges": len(edges),
        "loops": sum(edge.uncertain for edge in edges),
        "registered": [
            {"source": names[p.source], "target": names[p.target], "fitness": p.fitness, "score": p.score}
            for p in found.pairs
        ],
    }
