"""Read and write meshes as NumPy tables by extension."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from ...core.checks import shown
from ...core.errors import FilePath
from ...core.up_axis import AXES, UP, Direction, rotation_between
from ..file_formats import listed
from ..points.header_units import in_metres, warn_of_lost_crs, warn_of_lost_reference
from ..source import netted
from ..table import MeshTable
from .mesh_formats import MESH_FORMATS, UPRIGHT, UPS


def read_mesh(path: FilePath, *, up: str | None = None, outside_files: bool = False) -> MeshTable:
    """Read a mesh by extension (one of MESH_FORMATS); `up` is the up axis of the result for formats that define it.
    None restores the axes that `write_mesh` rotated. Raises only `FileError` for invalid content."""
    format = MESH_FORMATS[Path(path).suffix.lower()]
    check_up(path, up)
    options = {"outside_files": True} if outside_files and format.names_files else {}
    mesh = netted(format.codec.read)(path, **options)
    if not format.is_upright:
        return mesh
    return _rotated(mesh, AXES["y"], (mesh.up or AXES["y"]) if up is None else AXES[up])


def write_mesh(path: FilePath, mesh: MeshTable, *, ascii: bool, overwrite: bool, up: str | None = None) -> None:
    """Write a mesh by extension (one of MESH_FORMATS). `ascii` is for formats of either encoding; `up` is the up axis
    of the mesh, converted to y in formats that define it. None: that of the mesh if known, which is then stored."""
    check_up(path, up)
    format = MESH_FORMATS[Path(path).suffix.lower()]
    if format.is_upright:
        warn_of_lost_crs(path, mesh)
        known = _up_of(mesh) if up is None else AXES[up]
        mesh = replace(_rotated(mesh, known, AXES["y"]), up=known if up is None else None)
        mesh = in_metres(path, mesh, "glTF")
    elif not format.stores_reference:
        warn_of_lost_reference(path, mesh)
    options = {"ascii": ascii} if format.encoding == "either" else {}
    format.codec.write(path, mesh, overwrite=overwrite, **options)


def check_up(path: FilePath, up: Any) -> None:
    """Raise `ValueError` for an axis other than y, or z if the format defines the up axis."""
    if up is None:
        return
    if not isinstance(up, str) or up not in UPS:
        raise ValueError(f"up: expected one of {', '.join(UPS)}, got {shown(up)}")
    suffix = Path(path).suffix.lower()
    if up == "z" and suffix not in UPRIGHT:
        raise ValueError(f"up: only {listed(UPRIGHT, 'and')} define an up axis, got {suffix or shown(path)}")


def _up_of(mesh: MeshTable) -> Direction:
    """The known up direction, z for coordinates of a map, else y."""
    return mesh.up or (AXES["y"] if mesh.crs is None else UP)


def _rotated(mesh: MeshTable, start: Direction, end: Direction) -> MeshTable:
    """A mesh rotated from one up direction to another, exactly for axes."""
    mesh = replace(mesh, up=end)
    if start == end:
        return mesh
    R = rotation_between(start, end)
    normals = None if mesh.vertex_normals is None else _product(mesh.vertex_normals, R)
    return replace(mesh, vertices=_product(mesh.vertices, R), vertex_normals=normals)


def _product(vectors: NDArray[Any], R: NDArray[np.float64]) -> NDArray[Any]:
    """Rotated vectors in their own type. A sum from 0 has no -0."""
    columns = np.asarray(vectors).T
    rows = [sum(factor * column for factor, column in zip(row, columns, strict=True) if factor) for row in R.tolist()]
    return np.stack(cast("list[NDArray[Any]]", rows), axis=1)
