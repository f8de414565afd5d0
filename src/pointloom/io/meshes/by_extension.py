"""Read and write meshes as NumPy tables by extension."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import shown
from ...core.errors import FilePath
from ..file_formats import listed
from ..points.header_units import in_metres, warn_of_lost_crs, warn_of_lost_reference
from ..source import netted
from ..table import MeshTable
from .mesh_formats import MESH_FORMATS, UPRIGHT, UPS


def read_mesh(path: FilePath, *, up: str = "y", outside_files: bool = False) -> MeshTable:
    """Read a mesh by extension (one of MESH_FORMATS); `up` is the up axis of the result for formats that define it.
    Raises only `FileError` for invalid content."""
    format = MESH_FORMATS[Path(path).suffix.lower()]
    check_up(path, up)
    options = {"outside_files": True} if outside_files and format.names_files else {}
    mesh = netted(format.codec.read)(path, **options)
    return rotated_to_z_up(mesh) if up == "z" else mesh


def write_mesh(path: FilePath, mesh: MeshTable, *, ascii: bool, overwrite: bool, up: str = "y") -> None:
    """Write a mesh by extension (one of MESH_FORMATS). `ascii` is for formats of either encoding; `up` is the up axis
    of the mesh, converted to y in formats that define it."""
    check_up(path, up)
    format = MESH_FORMATS[Path(path).suffix.lower()]
    mesh = rotated_to_z_up(mesh, back=True) if up == "z" else mesh
    if format.is_upright:
        warn_of_lost_crs(path, mesh)
        mesh = in_metres(path, mesh, "glTF")
    elif not format.stores_reference:
        warn_of_lost_reference(path, mesh)
    options = {"ascii": ascii} if format.encoding == "either" else {}
    format.codec.write(path, mesh, overwrite=overwrite, **options)


def check_up(path: FilePath, up: Any) -> None:
    """Raise `ValueError` for an axis other than y, or z if the format defines the up axis."""
    if not isinstance(up, str) or up not in UPS:
        raise ValueError(f"up: expected one of {', '.join(UPS)}, got {shown(up)}")
    suffix = Path(path).suffix.lower()
    if up == "z" and suffix not in UPRIGHT:
        raise ValueError(f"up: only {listed(UPRIGHT, 'and')} define an up axis, got {suffix or shown(path)}")


def rotated_to_z_up(mesh: MeshTable, *, back: bool = False) -> MeshTable:
    """Rotate a mesh with y up to z up, or `back`, exactly."""
    normals = None if mesh.vertex_normals is None else _rotated(mesh.vertex_normals, back)
    return replace(mesh, vertices=_rotated(mesh.vertices, back), vertex_normals=normals)


def _rotated(vectors: NDArray[Any], back: bool) -> NDArray[Any]:
    x, y, z = np.asarray(vectors).T
    return np.stack([x, z, 0 - y] if back else [x, 0 - z, y], axis=1)
