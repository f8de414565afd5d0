"""The tiles of a finished job as one file."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

from ..core.atomic import atomic_write, check_writable
from ..core.errors import FileError, FilePath
from ..files.foreign import foreign_errors, import_for
from ..files.points.copc_writer import write_copc
from ..files.points.las import open_las, read_las
from .buckets import FOLDER as BUCKETS
from .manifest import Manifest
from .plan import Plan, open_plan
from .rasters import write_mosaics
from .status import status_of
from .work_tile import FOLDER as TILES
from .work_tile import offset_of, tile_path

BLOCK = 1 << 18


def finish_tiles(folder: FilePath, path: FilePath | None = None, *, overwrite: bool = True) -> Path:
    """Make one file of all tiles, in their order, and remove what the job held beside its tiles.

    Args:
        folder: Of `plan_tiles`, all tiles done.
        path: The file; None takes `result.laz`, or `result.copc.laz` where the plan says "copc", in the folder.
        overwrite: Whether an existing file may be replaced.

    Returns:
        The file.

    Raises:
        FileError: Tiles wait, failed or were set aside; points are missing; the file cannot be written.

    Notes:
        A LAZ file is written tile by tile. COPC is made in memory, of the whole result: some 200 B a point.
    """
    manifest, plan = open_plan(folder)
    with manifest:
        _check_finished(manifest, plan)
        is_copc = plan.told["output"] == "copc"
        path = Path(path) if path else manifest.folder / ("result.copc.laz" if is_copc else "result.laz")
        rows = manifest.rows("SELECT id, points_out FROM tiles WHERE state = 'done' ORDER BY id")
        parts = [(tile_path(plan, manifest.folder, row["id"]), row["points_out"]) for row in rows]
        if not parts:
            raise FileError(path, "there is nothing to write: the steps left no point")
        path = check_writable(path, overwrite=overwrite)
        merged = path.with_name(f".{path.name}.merged.laz") if is_copc else path
        _merge(merged, parts, overwrite or is_copc)
        if is_copc:
            try:
                header = open_las(merged).header
                write_copc(
                    path,
                    read_las(merged),
                    scale=header.scales,
                    offset=offset_of(plan),
                    like=header,
                    overwrite=overwrite,
                )
            finally:
                merged.unlink(missing_ok=True)
        write_mosaics(manifest, plan, path)
        shutil.rmtree(manifest.folder / BUCKETS, ignore_errors=True)
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
