"""The vertices of Wavefront OBJ files without faces, as points with colors and normals."""

from __future__ import annotations

from ...core.errors import FileError, FilePath
from ...core.paths import path_of
from ..columns import stack_normals, warn_of_loss
from ..obj_statements import read_statements, vertices_of
from ..table import PointTable


def read_obj_points(path: FilePath) -> PointTable:
    """Read an OBJ file without faces. Normals need one `vn` per vertex. Lines and texture coordinates are dropped."""
    path = path_of(path)
    statements = read_statements(path)
    if statements.faces:
        raise FileError(path, f"contains a mesh of {len(statements.faces)} faces", remedy="Use read_triangle_mesh")
    points, colors = vertices_of(path, statements.rows(0))
    rows = statements.rows(2)
    rows.check_width(0, rows.row_count, 3)
    normals = None
    if rows.row_count == len(points):
        normals = stack_normals(path, [*rows.numbers().reshape(-1, 3).T])
    elif rows.row_count:
        warn_of_loss(path, "normals", f"there are {rows.row_count} for {len(points)} vertices")
    if statements.counts[1]:
        warn_of_loss(path, "texture coordinates", "a cloud cannot store them")
    if statements.has_lines:
        warn_of_loss(path, "points and lines", "a cloud cannot store them")
    return PointTable(points, normals, colors).checked()
