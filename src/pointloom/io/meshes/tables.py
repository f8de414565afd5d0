"""Read and write clouds and meshes as NumPy tables, by extension, without a device."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from ...core.errors import FileError, FilePath
from ...core.paths import path_of, recording_remedy
from ..columns import warn_of_loss
from ..obj_statements import read_statements
from ..points.by_extension import read_points, write_table
from ..points.codecs import WriteOptions
from ..points.e57 import read_frames
from ..points.formats import CLOUD_FORMATS, WITH_SCANS
from ..points.las import open_las
from ..points.las_records import system_of
from ..points.ply_faces import STRIPS
from ..points.ply_header import read_header
from ..points.ptx import read_ptx_frames
from ..source import open_source
from ..table import MeshTable, PointTable
from ..vtk_files import VTK, read_vtk
from .by_extension import read_mesh, write_mesh
from .mesh_formats import MESH_FORMATS

LAS = (".las", ".laz")


def is_mesh_file(path: FilePath) -> bool:
    """True if a file has triangles, for formats of both. False for formats of clouds."""
    suffix = Path(path).suffix.lower()
    if suffix not in CLOUD_FORMATS or suffix not in MESH_FORMATS:
        return suffix in MESH_FORMATS
    if suffix in VTK:
        cells = read_vtk(path).cells
        return len(cells["polygons"].lengths) + len(cells["strips"].lengths) > 0
    if suffix == ".obj":
        return bool(read_statements(path_of(path)).faces)
    header = read_header(path, open_source(path))
    return any(element.name in ("face", STRIPS) and element.count > 0 for element in header.elements)


def read_table(
    path: FilePath, columns: Sequence[str] | None = None, *, up: str | None = None
) -> PointTable | MeshTable:
    """Read a file as a mesh if it has faces, else as a cloud. `columns` as in `read_point_cloud`, `up` for meshes."""
    suffix = Path(path).suffix.lower()
    if columns is None and suffix in MESH_FORMATS and is_mesh_file(path):
        return read_mesh(path, up=up)
    if suffix not in CLOUD_FORMATS:
        remedy = (
            recording_remedy(path, "scans()")
            or f"Clouds are read from {' '.join(CLOUD_FORMATS)}, meshes from {' '.join(MESH_FORMATS)}"
        )
        raise FileError(path, f"unknown extension {suffix!r}", remedy=remedy)
    return read_points(path, columns)


def write_cloud_table(
    path: FilePath,
    table: PointTable,
    *,
    as_text: bool = False,
    overwrite: bool = True,
    source: FilePath | None = None,
    system_only: bool = False,
) -> list[str]:
    """Write a cloud without what the format cannot store. Returns the dropped names.
    From LAS to LAS, `source` provides offset, coordinate system, scale (or finer steps of the table) and, unless
    `system_only`, other records and identification. From E57 or PTX to E57 it provides scan names and poses, unless
    `system_only`."""
    suffix = Path(path).suffix.lower()
    format, left_out = CLOUD_FORMATS[suffix], []
    lost = ["viewpoint"] if table.viewpoint is not None and not format.stores_viewpoint else []
    if format.codec.storable is not None:
        table, left_out = format.codec.storable(path, table)
    kind, frames, like = "" if source is None else Path(source).suffix.lower(), [], None
    if source is not None and suffix in LAS and kind in LAS:
        like = open_las(source).header
        like = system_of(like) if system_only else like
        if table.steps is not None:  # finer than those of the source in merged files
            like = replace(like, scales=tuple(np.minimum(like.scales, table.steps).tolist()))
    elif source is not None and suffix == ".e57" and kind in WITH_SCANS and not system_only:
        frames, beside = read_frames(source) if kind == ".e57" else (read_ptx_frames(source), [])
        if beside:
            warn_of_loss(path, f"{' and the '.join(beside)} of the source", "E57 files are written with points only")
    scale = table.steps if like is None and suffix in LAS else None
    write_table(path, table, WriteOptions(ascii=as_text, overwrite=overwrite, scale=scale, like=like, frames=frames))
    return left_out + lost


def write_mesh_table(
    path: FilePath, mesh: MeshTable, *, as_text: bool = False, overwrite: bool = True, up: str | None = None
) -> list[str]:
    """Write a mesh without what the format cannot store. Returns the dropped names."""
    storable, left_out = MESH_FORMATS[Path(path).suffix.lower()].codec.storable, []
    if storable is not None:
        mesh, left_out = storable(mesh)
    write_mesh(path, mesh, ascii=as_text, overwrite=overwrite, up=up)
    return left_out


def points_of(mesh: MeshTable) -> PointTable:
    return PointTable(
        mesh.vertices, mesh.vertex_normals, mesh.vertex_colors, mesh.attributes, unit=mesh.unit, crs=mesh.crs
    )
