"""VTK files of polygonal data by extension: legacy (.vtk) and XML (.vtp)."""

from __future__ import annotations

from pathlib import Path

from ..core.atomic import atomic_write
from ..core.errors import FilePath
from .vtk_data import VtkData
from .vtk_legacy import read_legacy, write_legacy
from .vtk_xml import read_xml, write_xml

VTK = (".vtk", ".vtp")


def read_vtk(path: FilePath) -> VtkData:
    """The points, cells and arrays of a file. Raises `FileError`."""
    path = Path(path)
    return read_xml(path) if path.suffix.lower() == ".vtp" else read_legacy(path)


def write_vtk(path: Path, data: VtkData, *, ascii: bool, overwrite: bool) -> None:
    """Write a file atomically. `ascii` is for .vtk."""
    with atomic_write(path, overwrite=overwrite) as file:
        if path.suffix.lower() == ".vtp":
            write_xml(file, data)
        else:
            write_legacy(file, data, ascii=ascii)
