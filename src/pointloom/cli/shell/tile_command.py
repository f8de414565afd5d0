"""The commands `tile`: surveys larger than memory. Nothing expensive is imported here."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import Any

import click

from .answer import answer_with
from .console import Progress
from .group import Commands
from .options import DEVICE_NAME, FILE, FORCE, JSON, LENGTH, Word, in_order, option, refuse

# Names of src/pointloom/tiling/plan.py, which would import NumPy. A test compares them.
OUTPUTS = ("laz", "copc")
AREAS = (".geojson", ".json", ".wkt")  # of src/pointloom/tiling/polygons.py
FILES = ("laz", "las", "copc")  # of src/pointloom/tiling/finish.py, likewise
_EPILOG = """\b
Finished tiles are kept. The same plan and run resume after an interruption, such as Ctrl-C.
A different plan, changed files and a different version are errors that list the differences.
"""


class Area(click.ParamType):
    """X0,Y0,X1,Y1 in file coordinates, or a polygon file."""

    name = "area"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        if value.lower().endswith(AREAS):
            return Path(value)
        try:
            numbers = tuple(float(part) for part in value.split(","))
        except ValueError:
            numbers = ()
        ordered = len(numbers) == 4 and numbers[0] <= numbers[2] and numbers[1] <= numbers[3]
        if not ordered or not all(map(math.isfinite, numbers)):
            wanted = f"X0,Y0,X1,Y1 with the low corner first, or a {', '.join(AREAS)} file"
            self.fail(f"expected {wanted}, got {value!r}", param, ctx)
        return numbers


class Part(click.ParamType):
    """17/400: index and number of parts."""

    name = "part"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> tuple[int, int]:
        match = re.fullmatch(r"(\d{1,9})/(\d{1,9})", value)
        which, of = map(int, match.groups()) if match else (0, 0)
        if not 1 <= which <= of:
            self.fail(f"expected WHICH/OF from 1/OF to OF/OF, such as 17/400, got {value!r}", param, ctx)
        return which, of


TILE_NAME = Word("tile", r"\d{1,9}_\d{1,9}", "COLUMN_ROW such as 3_4")
FOLDER = click.argument("folder", type=FILE, metavar="DIR")
COUNT_TYPE = click.IntRange(min=1)


@click.group("tile", cls=Commands, short_help="Process surveys larger than memory in tiles.", epilog=_EPILOG)
def tile() -> None:
    """Process LAS, LAZ and COPC files in tiles. The result equals that of processing all points in memory.

    The grid of voxels starts half a voxel below the lowest coordinates of all files.

    Every command accepts --json. docs/tiles.md lists the steps and their guarantees.

    \b
    pointloom tile plan survey/ --steps steps.toml -o job
    pointloom tile run job --workers 8
    pointloom tile status job
    pointloom tile finish job -o thinned.laz

    steps.toml has one table per step, in order:

    \b
    [[step]]
    step = "remove_statistical_outlier"
    nb_neighbors = 20
    std_ratio = 3.0

    \b
    [[step]]
    step = "voxel_down_sample"
    voxel_size = 0.5
    """


@tile.command("plan", short_help="Plan the tiles.")
@click.argument("sources", nargs=-1, required=True, type=FILE, metavar="SOURCES...")
@option("--steps=TOML", FILE, "Processing steps: one [[step]] table each.", required=True)
@option("-o --folder folder=DIR", FILE, "Job folder. Created if missing.", required=True)
@option("--size=M", LENGTH, "Tile size [m].")
@option("--points=N", COUNT_TYPE, "Approximate points per tile. Default without --size: 2 million.")
@option("--only=AREA", Area(), "Only tiles that intersect X0,Y0,X1,Y1 or a .geojson or .wkt file.")
@option("--only-crs=CRS", str, "CRS of the polygons of --only, such as EPSG:4326. Default: that of the files.")
@option("--to-crs=CRS", str, "Reproject points to this projected CRS, such as EPSG:25832.")
@option("--from-crs=CRS", str, "With --to-crs: CRS of the files. Default: from their headers.")
@option("--output", click.Choice(OUTPUTS), "Output format of `tile finish`.", default=OUTPUTS[0])
@JSON
def plan(
    sources: tuple[Path, ...],
    folder: Path,
    as_json: bool,
    steps: Path,
    to_crs: str | None,
    from_crs: str | None,
    **options: Any,
) -> int:
    """Plan the tiles of SOURCES in the folder DIR: .las and .laz files, folders of them, or a .vpc that lists them.

    Only their headers are read. .ply, .pcd, .e57, .ptx and text files (.xyz, .pts, .csv ...) are first converted to LAZ
    in DIR.

    \b
    pointloom tile plan survey/ --steps steps.toml -o job
    pointloom tile plan a.laz b.laz --steps steps.toml -o job --size 250 --output copc
    """
    if options["size"] is not None and options["points"] is not None:
        refuse("--size and --points both define the tiles; pass one of them")
    if from_crs is not None and to_crs is None:
        refuse("--from-crs requires --to-crs")
    chain: Any = steps
    if to_crs is not None:
        from ...tiling.steps.parse import parse_steps, read_toml

        parse_steps(steps)  # so that errors name the file
        chain = [*read_toml(steps), {"step": "reproject", "to_crs": to_crs, "from_crs": from_crs}]
    from ...tiling.plan import plan_tiles
    from ..jobs.tiles import report_of

    with Progress() as progress:
        status = plan_tiles(sources, chain, folder, progress=progress, **options)
    return answer_with(report_of("plan", status), str(folder), as_json)


@tile.command("run", short_help="Process the tiles.")
@FOLDER
@option("--serial", bool, "Run in this process (default).")
@option("--workers=N", COUNT_TYPE, "Run in N local processes (dask.distributed).")
@option("--scheduler=ADDRESS", str, "Run on the workers of a dask scheduler, such as tcp://host:8786.")
@option("--part=K/N", Part(), "Only the K-th of N parts of the tiles, for array jobs.")
@option("--tile name=X_Y", TILE_NAME, "Only this tile, also if it failed.")
@option("--device=cpu|cuda|cuda:N", DEVICE_NAME, "Device. With cuda, one GPU per worker.", default="cpu")
@JSON
def run(
    folder: Path,
    serial: bool,
    workers: int | None,
    scheduler: str | None,
    part: tuple[int, int] | None,
    name: str | None,
    device: str,
    as_json: bool,
) -> int:
    """Process the tiles of DIR. Finished tiles are kept, and the same command resumes after any interruption.

    Several runs may share one DIR. The exit code is 3 if tiles failed or were quarantined. The summary lists them with
    the command that repeats each.

    \b
    pointloom tile run job
    pointloom tile run job --workers 8
    pointloom tile run /shared/job --scheduler tcp://head:8786
    pointloom tile run /shared/job --part $SLURM_ARRAY_TASK_ID/400
    pointloom tile run job --tile 3_4
    """
    if serial + bool(workers) + bool(scheduler) > 1:
        refuse("--serial, --workers and --scheduler exclude each other; pass one of them")
    if part and name:
        refuse("--part and --tile both select tiles; pass one of them")
    from ...tiling.runners import run_tiles
    from ..jobs.tiles import report_of

    with Progress(kept=folder) as progress:
        runner = {"workers": workers or 0, "scheduler": scheduler, "device": device}
        status = run_tiles(folder, part=part, tile=name, progress=progress, **runner)
    return answer_with(report_of("run", status, is_part=bool(part or name)), str(folder), as_json)


@tile.command("status", short_help="Show the progress of the tiles.")
@in_order(FOLDER, JSON)
def status(folder: Path, as_json: bool) -> int:
    """Show the number of waiting, done, failed and quarantined tiles of DIR, also during a run.

    The exit code is 3 if tiles failed or were quarantined.

    \b
    pointloom tile status job --json
    """
    from ...tiling.status import tile_status
    from ..jobs.tiles import report_of

    return answer_with(report_of("status", tile_status(folder)), str(folder), as_json)


@tile.command("retry", short_help="Reset failed tiles.")
@in_order(FOLDER, JSON)
def retry(folder: Path, as_json: bool) -> int:
    """Reset failed and quarantined tiles and files of DIR to waiting. `tile run` then processes them.

    \b
    pointloom tile retry job
    """
    from ...tiling.runners import retry_tiles
    from ..jobs.tiles import report_of

    return answer_with(report_of("retry", retry_tiles(folder)), str(folder), as_json)


@tile.command("finish", short_help="Merge all tiles into one file.")
@FOLDER
@option("-o path=OUT", FILE, "Output file. Default: result.laz in DIR.")
@option("--output", click.Choice(FILES), "Format. Default: by the name of OUT, else the plan.")
@option("--workers=N", COUNT_TYPE, "Number of processes for copc, 1 GB each.")
@in_order(JSON, FORCE)
def finish(folder: Path, path: Path | None, output: str | None, workers: int | None, as_json: bool, force: bool) -> int:
    """Merge all tiles of DIR into one file after all are done, and remove the intermediate data of the job.

    OUT is written atomically, also with Ctrl-C.

    \b
    pointloom tile finish job -o thinned.laz
    pointloom tile finish job -o thinned.copc.laz
    """
    from ..jobs.tiles import finish_job

    options: dict[str, Any] = {"output": output, "workers": workers or 0}
    with Progress() as progress:
        report = finish_job(folder, path, overwrite=force, progress=progress, **options)
    return answer_with(report, str(folder), as_json)


COMMANDS = (tile,)
