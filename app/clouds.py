"""Files of points to files of points: `convert_file`, `downsample_file` and `estimate_normals_of_file`.

Each checks its output before the work and returns what was done in JSON's types; "poor" says why a result is poor.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np

from ..pcd.errors import FileError
from ..pcd.io.formats import WRITTEN
from ..pcd.io.table import MeshTable
from . import tables
from .console import Clock, format_share

FilePath = str | os.PathLike[str]


def convert_file(source: FilePath, output: FilePath, *, as_text: bool = False, overwrite: bool = False) -> dict:
    """Write a cloud or mesh in another format, every value as the file has it.

    A mesh becomes a cloud of its vertices where the output holds no triangles. In .las and .laz coordinates are rounded
    to thousandths, unless the source is such a file too: then its steps and coordinate system are kept.

    Args:
        source: A cloud, or a mesh (.ply .obj .stl .off .glb).
        output: A cloud (.ply .pcd .npz .xyz .xyzn .xyzrgb .pts .las .laz .e57) or a mesh (as the source).
        as_text: Text instead of binary, for .ply and .pcd.
        overwrite: Replace the output if it exists.

    Returns:
        What was done; "left_out" names what the output's format cannot hold.

    Raises:
        FileError: A file that cannot be read or written, or a cloud for a format of meshes.
    """
    allowed = (*WRITTEN, *(suffix for suffix in tables.MESHES if suffix not in WRITTEN))
    tables.check_output(output, allowed, what="clouds and meshes", overwrite=overwrite, as_text=as_text)
    clock, table = Clock(), tables.read_table(source)
    clock.stop("read")
    suffix = Path(output).suffix.lower()
    form = {"as_text": as_text, "overwrite": overwrite}
    if isinstance(table, MeshTable) and suffix in tables.MESHES:
        kind, count, triangles = "mesh", len(table.vertices), len(table.triangles)
        left_out = tables.write_mesh_table(output, table, **form)
    elif suffix not in WRITTEN:
        raise FileError(source, f"holds no triangles, which {suffix} needs", remedy="Write .ply or .pcd")
    else:
        is_mesh, kind, triangles = isinstance(table, MeshTable), "point cloud", None
        cloud = tables.points_of(table) if isinstance(table, MeshTable) else table
        count = len(cloud.points)
        lost = ["triangles"] * is_mesh + ["textures"] * (
            isinstance(table, MeshTable) and table.triangle_uvs is not None
        )
        left_out = lost + tables.write_cloud_table(output, cloud, source=source, **form)
    clock.stop("write")
    report = make_report("convert", source, [os.fspath(output)], clock, left_out) | {"kind": kind, "points": count}
    return report | ({"triangles": triangles} if triangles is not None else {})


def downsample_file(
    source: FilePath,
    output: FilePath,
    voxel_size: float,
    *,
    device: Any = "auto",
    as_text: bool = False,
    overwrite: bool = False,
) -> dict:
    """Write one point for each occupied voxel of a cloud: the mean of its points and of their attributes.

    Args:
        source: A cloud; of a mesh the vertices count.
        output: A cloud.
        voxel_size: Edge of a voxel [m].
        device: Where to compute.
        as_text: As `convert_file`.
        overwrite: As `convert_file`.

    Raises:
        FileError: A file that cannot be read or written.
        ValueError: A voxel size that is not positive, or far too small.
        DeviceError: No such device.
    """
    tables.check_output(output, WRITTEN, what="clouds", overwrite=overwrite, as_text=as_text)
    cloud, left_out, clock = read_cloud(source, device)
    small = cloud.voxel_down_sample(voxel_size)
    clock.stop("downsample")
    poor = None if len(small) else "no point is finite, so none is left; nothing was written"
    files = []
    if len(small):
        left_out += _write(source, output, small, clock, as_text, overwrite)
        files = [os.fspath(output)]
    report = make_report("downsample", source, files, clock, left_out, poor=poor)
    return report | {
        "device": str(cloud.device),
        "voxel_size": voxel_size,
        "points_in": len(cloud),
        "points": len(small),
    }


def estimate_normals_of_file(
    source: FilePath,
    output: FilePath,
    *,
    radius: float | None = None,
    max_nn: int = 30,
    towards: tuple[float, float, float] | None = None,
    direction: tuple[float, float, float] | None = None,
    device: Any = "auto",
    as_text: bool = False,
    overwrite: bool = False,
) -> dict:
    """Write a cloud with a normal at each point, from the plane through its neighbours.

    Args:
        source: A cloud; of a mesh the vertices count.
        output: A cloud in a format that holds normals (.ply .pcd .npz .xyzn .las .laz .e57).
        radius: Neighbours lie closer than this [m]; None takes the nearest however far.
        max_nn: Neighbours at most, the point itself included.
        towards: Turn normals to the side of this place [m].
        direction: Turn normals to the side of this direction.
        device: Where to compute.
        as_text: As `convert_file`.
        overwrite: As `convert_file`.

    Raises:
        FileError: A file that cannot be read or written.
        ValueError: A limit out of range.
        DeviceError: No such device.
    """
    formats = (".ply", ".pcd", ".npz", ".xyzn", ".las", ".laz", ".e57")
    tables.check_output(output, formats, what="normals", overwrite=overwrite, as_text=as_text)
    cloud, left_out, clock = read_cloud(source, device)
    with_normals = cloud.estimate_normals(radius=radius, max_nn=max_nn)
    if towards is not None:
        with_normals = with_normals.orient_normals_towards_camera_location(towards)
    if direction is not None:
        with_normals = with_normals.orient_normals_to_align_with_direction(direction)
    clock.stop("normals")
    poor = None if radius is None else _why_poor(cloud, radius)
    clock.stop("check")
    left_out += _write(source, output, with_normals, clock, as_text, overwrite)
    options = {"device": str(cloud.device), "radius": radius, "max_nn": max_nn, "points": len(cloud)}
    return make_report("normals", source, [os.fspath(output)], clock, left_out, poor=poor) | options


def _why_poor(cloud: Any, radius: float) -> str | None:
    """Whether the radius is so small that most points find no plane, by a sample of them."""
    from ..pcd.search import NearestNeighborSearch
    from .probes import distance_of_nearest, probe_points, rounded_up

    probes, search = probe_points(cloud), NearestNeighborSearch(cloud)
    if not len(probes):
        return "no point is finite, so none has a normal"
    lonely = float(np.mean(search.hybrid_search(probes, radius, 3).counts < 3))
    if lonely <= 0.5:
        return None
    few = f"{format_share(lonely)} of the points have fewer than 3 neighbours within {radius:g} m"
    reason = f"{few}, so their normals say nothing"
    third = distance_of_nearest(search, probes, 3)
    if third is None:
        return f"{reason}; the cloud has not so many"
    return f"{reason}; half of them have 3 within {rounded_up(third):g} m: take a larger --radius"


def read_cloud(source: FilePath, device: Any) -> tuple[Any, list[str], Clock]:
    """A cloud on a device, what was left behind, and the clock that timed it."""
    from ..pcd.devices import resolve_device
    from ..pcd.io.point_cloud import cloud_of

    where = resolve_device(device)
    clock = Clock()
    table, left_out = tables.read_table(source), []
    if isinstance(table, MeshTable):
        table, left_out = tables.points_of(table), ["triangles"]
    cloud = cloud_of(table, source, device=where)
    clock.stop("read")
    return cloud, left_out, clock


def _write(source: FilePath, output: FilePath, cloud: Any, clock: Clock, as_text: bool, overwrite: bool) -> list[str]:
    from ..pcd.io.point_cloud import table_of

    form = {"as_text": as_text, "overwrite": overwrite, "source": source}
    left_out = tables.write_cloud_table(output, table_of(cloud), **form)
    clock.stop("write")
    return left_out


def make_report(
    command: str, source: FilePath, files: list[str], clock: Clock, left_out: list[str], *, poor: str | None = None
) -> dict[str, Any]:
    """What every command on a file of points reports, in JSON's types."""
    return {
        "command": command,
        "source": os.fspath(source),
        "seconds": clock.seconds,
        "left_out": left_out,
        "files": files,
        "poor": poor,
    }


def cloud_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """What was done as labels and values for the terminal."""
    count = f"{report['points']:,}"
    if "points_in" in report:
        count = f"{count} of {report['points_in']:,}, one a voxel of {report['voxel_size']:g} m"
    fields = [("points", count)]
    if "triangles" in report:
        fields = [("vertices", count), ("triangles", f"{report['triangles']:,}")]
    return [*fields, *closing_fields(report)]


def closing_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """What a summary of any command on a file of points ends in: what was lost, seconds and files."""
    fields = []
    if report.get("replaced"):
        fields.append(("replaced", f"{', '.join(report['replaced'])} of the input"))
    if report["left_out"]:
        fields.append(("left out", f"{', '.join(report['left_out'])} (the output cannot hold them)"))
    parts = ", ".join(f"{stage} {value:.2f}" for stage, value in report["seconds"].items())
    where = f" on {report['device']}" if "device" in report else ""
    return [*fields, ("seconds", parts + where), ("files", ", ".join(report["files"]) or "none")]
