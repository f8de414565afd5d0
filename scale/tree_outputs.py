"""What is written from the octree over the tiles: one COPC file, or a folder of COPC tiles, of 3D Tiles, for Potree."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np

from ..core.atomic import atomic_folder, atomic_write
from ..core.coordinates import quiet
from ..core.errors import FileError
from ..core.progress import ReportProgress, say_nothing
from ..files.foreign import foreign_errors
from ..files.points import potree_writer, three_d_tiles_writer
from ..files.points.copc_writer import CopcWriter
from ..files.points.geodetic import Geodesy
from ..files.points.las import LasFile, open_las, table_of
from ..files.points.las_records import describe_together
from ..files.points.las_writer import lay_out
from ..files.points.vpc_writer import Statistics, dimensions_of, item_of, write_index
from ..kernels.sampling.detail_levels import DEPTH, NODE_BITS
from .processes import Processes
from .tile_tree import TileTree

INDEX, OVERVIEW = "index.vpc", "overview.copc.laz"
FOLDERS = {"tiles": INDEX, "3dtiles": three_d_tiles_writer.MARKER, "potree": potree_writer.MARKER}
OVERVIEW_POINTS = 1_000_000  # of a square of points, about, where no spacing is given
_BLOCK = 1 << 18
Parts = list[tuple[Path, int]]


def tree_of(parts: Parts, report: ReportProgress, pool: Processes | None = None) -> TileTree:
    """The octree over tiles, each with its number of points."""
    return TileTree([path for path, _ in parts], [count for _, count in parts], report, pool)


def write_tree(path: Path, tree: TileTree, overwrite: bool, most: int = DEPTH) -> None:
    """Write an octree as COPC, down to a level.

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
        for node in tree.nodes(writer.pack, most):
            record = layout.laspy.PackedPointRecord(node.rows, layout.header.point_format)
            writer.add([node.level], [node.cell], [record], [node.chunk or b""])
        writer.finish(layout.extended)


def write_folder(
    path: Path,
    parts: Parts,
    output: str,
    spacing: float | None,
    overwrite: bool,
    report: ReportProgress,
    pool: Processes | None = None,
) -> None:
    """Write tiles as one of FOLDERS; the folder appears whole or not at all.

    Raises:
        FileError: A tile is gone or damaged, or the folder cannot be written.
    """
    with atomic_folder(path, FOLDERS[output], overwrite=overwrite) as folder:
        if output == "tiles":
            _write_tiles(folder, parts, spacing, report, pool)
            return
        tree, file = tree_of(parts, report, pool), open_las(parts[0][0])
        writer: Any
        if output == "potree":
            system = Geodesy(file.path, file.header).system
            projection = "" if system is None else system.to_wkt()
            writer = potree_writer.PotreeWriter(folder, file, tree.corner, tree.side, path.name, projection)
        else:
            writer = three_d_tiles_writer.ThreeDTilesWriter(folder, file, tree.side)
        try:
            for node in tree.nodes():
                writer.add(*node[:3])
            writer.finish()
        finally:
            writer.close()


def _write_tiles(
    folder: Path, parts: Parts, spacing: float | None, report: ReportProgress, pool: Processes | None
) -> None:
    pool = pool or Processes(0, folder)
    total = tree_of(parts, report, pool)
    level = _level_of(total, spacing)
    write_tree(folder / OVERVIEW, total, True, level)
    tasks = [(path, count, folder / f"{path.name.removesuffix('.laz')}.copc.laz") for path, count in parts]
    items = []
    for number, (task, statistics) in enumerate(zip(tasks, pool.map(_write_tile, tasks), strict=True)):
        path, _, made = task
        items.append(item_of(open_las(path), f"./{made.name}", statistics, f"./{OVERVIEW}"))
        report("tiles", number + 1, len(tasks))
    write_index(folder / INDEX, items)


def _write_tile(path: Path, count: int, made: Path) -> Statistics:
    write_tree(made, tree_of([(path, count)], say_nothing), True)
    return _statistics_of(open_las(path))


def _level_of(tree: TileTree, spacing: float | None) -> int:
    """The first level whose points are as near to each other as wanted."""
    if spacing is None:
        return max(0, round(math.log2(math.sqrt(OVERVIEW_POINTS) / 2**NODE_BITS)))
    return max(0, math.ceil(math.log2(tree.side / 2**NODE_BITS / spacing) - 1e-9))


def _statistics_of(file: LasFile) -> Statistics:
    statistics = Statistics()
    for rows in file.rows(_BLOCK):
        statistics.add(dimensions_of(file, rows))
    return statistics
