"""The tiles of a finished job as one file."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

from ..core.atomic import atomic_write, check_writable
from ..core.checks import check_positive, check_progress, shown
from ..core.errors import FileError, FilePath
from ..core.paths import path_of
from ..core.progress import ReportProgress, say_nothing
from ..files.foreign import foreign_errors, import_for
from ..files.points.las import open_las
from .borders import JOINED, LEFT
from .buckets import FOLDER as BUCKETS
from .manifest import Manifest
from .plan import Plan, open_plan
from .rasters import write_mosaics
from .status import status_of
from .tree_outputs import FOLDERS, tree_of, write_folder, write_tree
from .work_tile import FOLDER as TILES
from .work_tile import tile_path

BLOCK = 1 << 18


def finish_tiles(
    folder: FilePath,
    path: FilePath | None = None,
    *,
    output: str | None = None,
    overview: float | None = None,
    overwrite: bool = True,
    progress: ReportProgress = say_nothing,
) -> Path:
    """Make one file, or one folder, of all tiles, and remove what the job held beside its tiles.

    Args:
        folder: Of `plan_tiles`, all tiles done.
        path: The file, an octree where it ends in .copc.laz; None takes `result.laz`, or `result.copc.laz` where the
            plan says "copc", in the folder.
        output: What to make of a folder. "tiles" are COPC files with an index `index.vpc`, which QGIS and PDAL open as
            one cloud, and a coarse version of all of them, `overview.copc.laz`. "3dtiles" are 3D Tiles 1.1
            (`tileset.json`), on the globe where the coordinate system is known; "potree" is Potree 2.0
            (`metadata.json`). None makes one file.
        overview: Spacing of the overview's points; None takes the level of which a square of points has a million.
        overwrite: Whether an existing file may be replaced, or a folder of the same kind.
        progress: Called with "points", how many are read, and how many there are to read, twice for an octree.

    Returns:
        The file or folder.

    Raises:
        ValueError: An output that there is not.
        FileError: Tiles wait, failed or were set aside; points are missing; a tile is gone or damaged; for an octree,
            millions of points lie in one place; the file cannot be written.

    Notes:
        A LAZ file is written tile by tile. The octree of a COPC file is that of `write_point_cloud` of all tiles'
        points, in their order; it is made from the tiles on disk, which are read twice. Memory: 1 GB whatever their
        number; no disk but for the file.
    """
    report, spacing = check_progress(progress), None if overview is None else check_positive("overview", overview)
    if output is not None and output not in FOLDERS:
        raise ValueError(f"output: expected None or one of {', '.join(map(repr, FOLDERS))}, got {shown(output)}")
    if output is not None and path is None:
        raise ValueError("path: give the folder that is to be made")
    manifest, plan = open_plan(folder)
    with manifest:
        _check_finished(manifest, plan)
        wanted = "result.copc.laz" if plan.told["output"] == "copc" else "result.laz"
        path = path_of(path if path else manifest.folder / wanted)
        rows = manifest.rows("SELECT id, points_out FROM tiles WHERE state = 'done' ORDER BY id")
        parts = [(tile_path(plan, manifest.folder, row["id"]), row["points_out"]) for row in rows]
        if not parts:
            raise FileError(path, "there is nothing to write: the steps left no point")
        if output is not None:
            write_folder(path, parts, output, spacing, overwrite, report)
        elif path.name.lower().endswith(".copc.laz"):
            check_writable(path, overwrite=overwrite)
            write_tree(path, tree_of(parts, report), overwrite)
        else:
            _merge(path, parts, overwrite)
        write_mosaics(manifest, plan, path)
        for name in (BUCKETS, LEFT, JOINED):
            shutil.rmtree(manifest.folder / name, ignore_errors=True)
        for left in (manifest.folder / TILES).glob(".*.part"):  # of workers that were killed
            left.unlink(missing_ok=True)
        return path


def _check_finished(manifest: Manifest, plan: Plan) -> None:
    told = status_of(manifest)
    if not told.is_finished:
        raise FileError(manifest.folder, f"is not finished: {told}", remedy="Call run_tiles, or retry_tiles before")
    if plan.told["only"] is None and told.points_in != told.points:
        reason = f"the files hold {told.points:,} points, the tiles {told.points_in:,}: an octree or a header lies"
        raise FileError(manifest.folder, reason)


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
