"""Merge the tiles of a finished job into one file."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

import numpy as np

from ..core.atomic import atomic_write, check_writable
from ..core.checks import check_count, check_progress, shown
from ..core.coordinates import quiet
from ..core.errors import FileError, FilePath
from ..core.paths import path_of
from ..core.progress import ReportProgress
from ..io.optional_imports import foreign_errors, import_for
from ..io.points.copc_writer import CopcWriter
from ..io.points.las import open_las, table_of
from ..io.points.las_records import describe_together
from ..io.points.las_writer import lay_out, open_writer
from .border_merging import LEFT
from .buckets import FOLDER as BUCKETS
from .manifest import Manifest, clear_locks, exclusive
from .plan import Plan, open_plan
from .processes import Processes
from .rasters import mosaics_of, write_mosaics
from .schema import CHECKSUMS
from .status import status_of
from .tasks import reset_missing_buckets
from .tile_tree import TileTree
from .work_tile import FOLDER as TILES
from .work_tile import checksum_of, tile_path

POINTS_PER_BLOCK = 1 << 18
FILES = {"laz": ".laz", "las": ".las", "copc": ".copc.laz"}  # file extension by kind


def finish_tiles(
    folder: FilePath,
    path: FilePath | None = None,
    *,
    output: str | None = None,
    workers: int = 0,
    overwrite: bool = True,
    progress: ReportProgress | None = None,
) -> Path:
    """Merge all tiles into one file and remove the job's intermediate data.

    LAZ is written tile by tile. The octree equals that of `write_point_cloud`, from two passes over the tiles. Bitwise
    independent of workers. Memory: 1 GB. No temporary disk space.

    Args:
        folder: Folder of `plan_tiles`, all tiles done.
        path: The file. If None: `result.laz` or, if planned, `result.copc.laz` in the folder.
        output: "laz", "las" or "copc". If None: by the name, or the plan.
        workers: Processes for an octree, 1 GB of memory each, as of `run_tiles`. 0 uses this process.
        overwrite: Allow replacing an existing file.
        progress: Called with "points", the points read and to read (twice for an octree).

    Returns:
        The file. The first raster if no point remains and `rasterize` is a step.

    Raises:
        ValueError, FileError: If the output is unknown, or if tiles are not done, missing or damaged, millions of
            points coincide in an octree, or the file has a wrong name or cannot be written.
    """
    report = check_progress(progress)
    _check_output(path, output)
    count = check_count("workers", workers, minimum=0)
    manifest, plan = open_plan(folder)
    with manifest, exclusive(manifest.folder, "finish"):
        _check_finished(manifest, plan)
        path = path_of(path if path else manifest.folder / f"result{FILES[output or plan.data['output']]}")
        rows = manifest.rows("SELECT id, points_out FROM tiles WHERE state = 'done' ORDER BY id")
        parts = [(tile_path(plan, manifest.folder, row["id"]), row["points_out"]) for row in rows]
        _check_tiles(manifest, plan)
        mosaics = mosaics_of(plan, path)
        for mosaic in mosaics:
            check_writable(mosaic, overwrite=overwrite)
            _clear_parts(mosaic)
        if not parts and not mosaics:
            raise FileError(path, "no points are left after the steps, so there is nothing to write")
        _clear_parts(path)
        if not parts:
            path = mosaics[0]
        elif path.name.lower().endswith(".copc.laz"):
            check_writable(path, overwrite=overwrite)
            with Processes(count, path) as pool:
                tree = TileTree([file for file, _ in parts], [points for _, points in parts], report, pool)
                write_tree(path, tree, overwrite)
        else:
            _merge(path, parts, overwrite, report)
        write_mosaics(manifest, plan, mosaics, overwrite)
        for name in (BUCKETS, LEFT):  # join results stay: a damaged tile is recomputed from them
            shutil.rmtree(manifest.folder / name, ignore_errors=True)
        for left in (manifest.folder / TILES).glob(".*.part"):  # of killed workers
            left.unlink(missing_ok=True)
        clear_locks(manifest.folder)
        return path


def _check_output(path: FilePath | None, output: Any) -> None:
    if output is not None and (not isinstance(output, str) or output not in FILES):
        raise ValueError(f"output: expected None or one of {', '.join(map(repr, FILES))}, got {shown(output)}")
    if path is None:
        return
    name = path_of(path).name.lower()
    suffix_kind = (
        "copc" if name.endswith(FILES["copc"]) else next((kind for kind in FILES if name.endswith(FILES[kind])), None)
    )
    if not suffix_kind or output not in (None, suffix_kind):
        wanted = " or ".join(FILES.values()) if output is None else FILES[output]
        expected = "of a LAS or LAZ file" if output is None else f"for output={output!r}"
        raise FileError(path_of(path), f"is not a file name {expected}", remedy=f"Use the extension {wanted}")


def _clear_parts(path: Path) -> None:
    for part in path.parent.glob(f".{path.name}.*.part"):
        part.unlink(missing_ok=True)


def _check_finished(manifest: Manifest, plan: Plan) -> None:
    status = status_of(manifest)
    if not status.is_finished:
        raise FileError(manifest.folder, f"is not finished: {status}", remedy="Call run_tiles, or first retry_tiles")
    if plan.data["only"] is None and status.points_in != status.points:
        reason = f"expected {status.points:,} points as in the files, got {status.points_in:,} in the tiles"
        raise FileError(manifest.folder, f"{reason}: an octree or a header is wrong")


def _check_tiles(manifest: Manifest, plan: Plan) -> None:
    """Check that tile files are those that were written. Reset others."""
    with manifest.change() as base:
        base.execute(CHECKSUMS)
    query = "SELECT id, crc FROM tiles LEFT JOIN checksums ON tile = id WHERE state = 'done' ORDER BY id"
    bad = []
    for row in manifest.rows(query):
        path = tile_path(plan, manifest.folder, row["id"])
        if not path.is_file():
            bad.append((row["id"], path, "is missing"))
        elif row["crc"] is not None and checksum_of(path) != row["crc"]:
            bad.append((row["id"], path, "is damaged: its checksum differs from that of the written file"))
    if not bad:
        return
    with manifest.change() as base:
        base.executemany("UPDATE tiles SET state = 'waiting' WHERE id = ?", [(tile,) for tile, _, _ in bad])
    reset_missing_buckets(manifest)
    _, path, reason = bad[0]
    tiles = f"This and {len(bad) - 1} other tiles are" if len(bad) > 1 else "This tile is"
    raise FileError(path, reason, remedy=f"{tiles} waiting again: call run_tiles, then finish_tiles")


def _merge(path: Path, parts: list[tuple[Path, int]], overwrite: bool, report: ReportProgress) -> None:
    path = check_writable(path, overwrite=overwrite)
    laspy: Any = import_for(path, "laspy", "las")
    with laspy.open(parts[0][0]) as first:
        header = first.header
    describe_together(laspy, header, (open_las(part, layers_too=False).header for part, _ in parts))
    compress, done, total = path.suffix.lower() == ".laz", 0, sum(count for _, count in parts)
    with (
        atomic_write(path, overwrite=overwrite) as file,
        foreign_errors(path, "cannot be written"),
        open_writer(laspy, file, header, compress=compress) as writer,
    ):
        for part, count in parts:
            tile = open_las(part)
            if tile.header.point_count != count or tile.header.offsets != tuple(header.offsets):
                raise FileError(
                    part, f"is not the tile that was written: {tile.header.point_count} points, not {count}"
                )
            with laspy.open(part) as reader:
                for points in reader.chunk_iterator(POINTS_PER_BLOCK):
                    writer.write_points(points)
                    done += len(points)
                    report("points", done, total)
        if header.evlrs:
            writer.write_evlrs(header.evlrs)


def write_tree(path: Path, tree: TileTree, overwrite: bool) -> None:
    """Write an octree as COPC. FileError if a tile is damaged or the file cannot be written."""
    first = open_las(tree.files[0].path)
    table = table_of(first, first.decode(np.zeros(1, first.layout.dtype())))
    layout = lay_out(path, table, tree.scales, tree.offsets, first.header, is_part=True)
    describe_together(layout.laspy, layout.header, (file.header for file in tree.files))
    if layout.header.point_format.dtype() != tree.files[0].row:
        raise FileError(first.path, "is not a tile of this version", remedy="Plan it again in another folder")
    with atomic_write(path, overwrite=overwrite) as file, foreign_errors(path, "cannot be written"), quiet():
        writer = CopcWriter(path, file, layout, tree.corner, tree.side)
        for node in tree.nodes(writer.pack):
            record = layout.laspy.PackedPointRecord(node.rows, layout.header.point_format)
            writer.add([node.level], [node.cell], [record], [node.chunk or b""])
        writer.finish(layout.extended)
