"""The tiles of a finished job as one file."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from ..core.atomic import atomic_write, check_writable
from ..core.checks import check_progress
from ..core.coordinates import quiet
from ..core.errors import FileError, FilePath
from ..core.progress import ReportProgress, say_nothing
from ..files.foreign import foreign_errors, import_for
from ..files.points.copc_writer import CopcWriter
from ..files.points.las import open_las, table_of
from ..files.points.las_writer import lay_out
from .buckets import FOLDER as BUCKETS
from .buckets import folder_of
from .manifest import CHECKSUMS, Manifest, clear_locks
from .plan import Plan, open_plan
from .rasters import write_mosaics
from .status import status_of
from .tile_tree import Node, TileTree
from .work_tile import FOLDER as TILES
from .work_tile import checksum_of, tile_path

BLOCK = 1 << 18
AT_ONCE = 1 << 19  # points of nodes that are compressed together


def finish_tiles(
    folder: FilePath, path: FilePath | None = None, *, overwrite: bool = True, progress: ReportProgress = say_nothing
) -> Path:
    """Make one file of all tiles, in their order, and remove what the job held beside its tiles.

    Args:
        folder: Of `plan_tiles`, all tiles done.
        path: The file, an octree where it ends in .copc.laz; None takes `result.laz`, or `result.copc.laz` where the
            plan says "copc", in the folder.
        overwrite: Whether an existing file may be replaced.
        progress: Called with "points", how many are read, and how many there are to read, twice for an octree.

    Returns:
        The file.

    Raises:
        FileError: Tiles wait, failed or were set aside; points are missing; a tile is gone or damaged; for an octree,
            millions of points lie in one place; the file cannot be written.

    Notes:
        A LAZ file is written tile by tile. The octree of a COPC file is that of `write_point_cloud` of all tiles'
        points, in their order; it is made from the tiles on disk, which are read twice. Memory: 1 GB whatever their
        number; no disk but for the file.
    """
    report = check_progress(progress)
    manifest, plan = open_plan(folder)
    with manifest:
        _check_finished(manifest, plan)
        wanted = "result.copc.laz" if plan.told["output"] == "copc" else "result.laz"
        path = check_writable(path if path else manifest.folder / wanted, overwrite=overwrite)
        is_copc = path.name.lower().endswith(".copc.laz")
        rows = manifest.rows("SELECT id, points_out FROM tiles WHERE state = 'done' ORDER BY id")
        parts = [(tile_path(plan, manifest.folder, row["id"]), row["points_out"]) for row in rows]
        _check_tiles(manifest, plan)
        if not parts:
            raise FileError(path, "there is nothing to write: the steps left no point")
        if is_copc:
            _write_copc(path, TileTree([part for part, _ in parts], [count for _, count in parts], report), overwrite)
        else:
            _merge(path, parts, overwrite)
        write_mosaics(manifest, plan, path)
        shutil.rmtree(manifest.folder / BUCKETS, ignore_errors=True)
        for left in (manifest.folder / TILES).glob(".*.part"):  # of workers that were killed
            left.unlink(missing_ok=True)
        clear_locks(manifest.folder)
        return path


def _check_finished(manifest: Manifest, plan: Plan) -> None:
    told = status_of(manifest)
    if not told.is_finished:
        raise FileError(manifest.folder, f"is not finished: {told}", remedy="Call run_tiles, or retry_tiles before")
    if plan.told["only"] is None and told.points_in != told.points:
        reason = f"the files hold {told.points:,} points, the tiles {told.points_in:,}: an octree or a header lies"
        raise FileError(manifest.folder, reason)


def _check_tiles(manifest: Manifest, plan: Plan) -> None:
    """Hold that the files of tiles are those that were written; others wait to be made again."""
    with manifest.change() as base:
        base.execute(CHECKSUMS)
    query = "SELECT id, crc FROM tiles JOIN checksums ON tile = id WHERE state = 'done' ORDER BY id"
    bad = []
    for row in manifest.rows(query):
        path = tile_path(plan, manifest.folder, row["id"])
        if not path.is_file():
            bad.append((row["id"], path, "is gone"))
        elif checksum_of(path) != row["crc"]:
            bad.append((row["id"], path, "is damaged: it is not the file that was written"))
    if not bad:
        return
    with manifest.change() as base:
        base.executemany("UPDATE tiles SET state = 'waiting' WHERE id = ?", [(tile,) for tile, _, _ in bad])
        for number, source in enumerate(plan.sources):
            if source["kind"] != "copc" and not folder_of(manifest.folder, number).is_dir():
                base.execute("UPDATE sources SET state = 'waiting' WHERE id = ?", (number,))
    _, path, reason = bad[0]
    others = f"It and {len(bad) - 1} others wait" if len(bad) > 1 else "It waits"
    raise FileError(path, reason, remedy=f"{others} to be made again: call run_tiles, then this")


def _write_copc(path: Path, tree: TileTree, overwrite: bool) -> None:
    first = open_las(tree.files[0].path)
    table = table_of(first, first.decode(np.zeros(1, first.layout.dtype())))
    layout = lay_out(path, table, tree.scales, tree.offsets, first.header)
    layout_row = layout.header.point_format.dtype()
    if layout_row != tree.files[0].row:
        raise FileError(first.path, "is not a tile of this version", remedy="Plan it anew in another folder")
    with atomic_write(path, overwrite=overwrite) as file, foreign_errors(path, "cannot be written"), quiet():
        writer = CopcWriter(path, file, layout, tree.corner, tree.side)
        for nodes in _batches(tree.nodes()):
            rows = [layout.laspy.PackedPointRecord(node.rows, layout.header.point_format) for node in nodes]
            writer.add([node.level for node in nodes], [node.cell for node in nodes], rows)
        writer.finish(layout.extended)


def _batches(nodes: Iterator[Node]) -> Iterator[list[Node]]:
    """Nodes that are compressed at a time."""
    batch: list[Node] = []
    for node in nodes:
        batch.append(node)
        if sum(len(held.rows) for held in batch) >= AT_ONCE:
            yield batch
            batch = []
    if batch:
        yield batch


def _merge(path: Path, parts: list[tuple[Path, int]], overwrite: bool) -> None:
    path = check_writable(path, overwrite=overwrite)
    laspy: Any = import_for(path, "laspy", "las")
    with laspy.open(parts[0][0]) as first:
        header = first.header
    compress = path.suffix.lower() == ".laz"
    with (
        atomic_write(path, overwrite=overwrite) as file,
        foreign_errors(path, "cannot be written"),
        laspy.LasWriter(file, header, do_compress=compress, closefd=False) as writer,
    ):
        for part, count in parts:
            told = open_las(part)
            if told.header.point_count != count or told.header.offsets != tuple(header.offsets):
                raise FileError(
                    part, f"is not the tile that was written: {told.header.point_count} points, not {count}"
                )
            with laspy.open(part) as reader:
                for points in reader.chunk_iterator(BLOCK):
                    writer.write_points(points)
        if header.evlrs:
            writer.write_evlrs(header.evlrs)
