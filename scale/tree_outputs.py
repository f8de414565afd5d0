"""Write the octree over the tiles as one COPC file."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from ..core.atomic import atomic_write
from ..core.coordinates import quiet
from ..core.errors import FileError
from ..core.progress import ReportProgress
from ..files.foreign import foreign_errors
from ..files.points.copc_writer import CopcWriter
from ..files.points.las import open_las, table_of
from ..files.points.las_records import describe_together
from ..files.points.las_writer import lay_out
from .processes import Processes
from .tile_tree import TileTree

Parts = list[tuple[Path, int]]


def tree_of(parts: Parts, report: ReportProgress, pool: Processes | None = None) -> TileTree:
    """The octree over tiles, each with its number of points."""
    return TileTree([path for path, _ in parts], [count for _, count in parts], report, pool)


def write_tree(path: Path, tree: TileTree, overwrite: bool) -> None:
    """Write an octree as COPC.

    Raises:
        FileError: A tile is gone or damaged, or the file cannot be written.
    """
    first = open_las(tree.files[0].path)
    table = table_of(first, first.decode(np.zeros(1, first.layout.dtype())))
    layout = lay_out(path, table, tree.scales, tree.offsets, first.header, is_part=True)
    describe_together(layout.laspy, layout.header, (file.header for file in tree.files))
    if layout.header.point_format.dtype() != tree.files[0].row:
        raise FileError(first.path, "is not a tile of this version", remedy="Plan it anew in another folder")
    with atomic_write(path, overwrite=overwrite) as file, foreign_errors(path, "cannot be written"), quiet():
        writer = CopcWriter(path, file, layout, tree.corner, tree.side)
        for node in tree.nodes(writer.pack):
            record = layout.laspy.PackedPointRecord(node.rows, layout.header.point_format)
            writer.add([node.level], [node.cell], [record], [node.chunk or b""])
        writer.finish(layout.extended)
