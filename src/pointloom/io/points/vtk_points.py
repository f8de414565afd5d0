"""Points as VTK files: legacy (.vtk) and XML (.vtp)."""

from __future__ import annotations

from ...core.atomic import check_writable
from ...core.errors import FilePath
from ..attribute_names import NameRules
from ..table import PointTable
from ..vtk_data import RESERVED, data_of, points_of
from ..vtk_files import read_vtk, write_vtk


def read_vtk_points(path: FilePath) -> PointTable:
    """Read the points of a .vtk or .vtp file without polygons."""
    return points_of(path, read_vtk(path))


def write_vtk_points(path: FilePath, table: PointTable, *, ascii: bool = False, overwrite: bool = True) -> None:
    """Write points with all attributes, and colors in 8 bits, atomically. `ascii` is for .vtk."""
    path = check_writable(path, overwrite=overwrite)
    data = data_of(table.checked())
    write_vtk(path, data, ascii=ascii, overwrite=overwrite)


def name_rules(_path: FilePath, table: PointTable) -> NameRules:
    return NameRules(lambda letter: letter.isprintable(), RESERVED, in_parts=False)
