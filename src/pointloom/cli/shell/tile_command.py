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
from .options import FILE, LENGTH, DeviceName, force_option, json_option, refuse

# Names of src/pointloom/tiling/plan.py, which would import NumPy. A test compares them.
OUTPUTS = ("laz", "copc")
AREAS = (".geojson", ".json", ".wkt")  # of src/pointloom/tiling/polygons.py
FILES = ("laz", "las", "copc")  # of src/pointloom/tiling/finish.py, likewise
_EPILOG = """\b
What earlier runs have done stays: the same plan and run again go on where they ended, after Ctrl-C too. Another plan,
files that have changed and another version are refused, and what differs is said.
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
        found = re.fullmatch(r"(\d{1,9})/(\d{1,9})", value)
        which, of = map(int, found.groups()) if found else (0, 0)
        if not 1 <= which <= of:
            self.fail(f"expected WHICH/OF from 1/OF to OF/OF, such as 17/400, got {value!r}", param, ctx)
        return which, of


class TileName(click.ParamType):
    """3_4: column and row of a tile. Its existence is checked later."""

    name = "tile"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> str:
        if not re.fullmatch(r"\d{1,9}_\d{1,9}", value):
            self.fail(f"expected COLUMN_ROW such as 3_4, got {value!r}", param, ctx)
        return value


FOLDER = click.argument("folder", type=FILE, metavar="DIR")
COUNT = click.IntRange(min=1)


@click.group("tile", cls=Commands, short_help="Surveys larger than the memory, tile by tile.", epilog=_EPILOG)
def tile() -> None:
    """Work LAS, LAZ and COPC files off tile by tile, with the answer of one machine that holds them all.

    Every command takes --json. docs/tiles.md says which steps there are, and what is promised of them.

    \b
    pointloom tile plan survey/ --steps steps.toml -o job
    pointloom tile run job --workers 8
    pointloom tile status job
    pointloom tile finish job -o thinned.laz

    steps.toml has a table for each step, in their order:

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


@tile.command("plan", short_help="Write down what is to be done.")
@click.argument("sources", nargs=-1, required=True, type=FILE, metavar="SOURCES...")
@click.option("--steps", type=FILE, required=True, metavar="TOML", help="What to do: a [[step]] table for each step.")
@click.option(
    "-o",
    "--folder",
    "folder",
    type=FILE,
    required=True,
    metavar="DIR",
    help="Folder of the job; made where it is missing.",
)
@click.option("--size", type=LENGTH, metavar="M", help="Edge of a tile [m].")
@click.option("--points", type=COUNT, metavar="N", help="Points a tile, about; 2 million if neither is given.")
@click.option("--only", type=Area(), metavar="AREA", help="Only tiles that X0,Y0,X1,Y1 or a .geojson, .wkt file touch.")
@click.option(
    "--only-crs", metavar="CRS", help="Of the polygons of --only, such as EPSG:4326; that of the files if none."
)
@click.option("--to-crs", metavar="CRS", help="Write points in this projected system, such as EPSG:25832.")
@click.option("--from-crs", metavar="CRS", help="With --to-crs: the files' system; what they tell if none.")
@click.option(
    "--output", type=click.Choice(OUTPUTS), default=OUTPUTS[0], show_default=True, help="What `tile finish` makes."
)
@json_option()
def plan(
    sources: tuple[Path, ...],
    folder: Path,
    as_json: bool,
    steps: Path,
    to_crs: str | None,
    from_crs: str | None,
    **options: Any,
) -> int:
    """Plan the tiles of SOURCES in the folder DIR: .las and .laz files, folders of them, a .vpc that lists them.

    Of these only headers are read. .ply, .pcd, .e57, .ptx and text (.xyz, .pts, .csv ...) are written over as LAZ into
    DIR first.

    \b
    pointloom tile plan survey/ --steps steps.toml -o job
    pointloom tile plan a.laz b.laz --steps steps.toml -o job --size 250 --output copc
    """
    if options["size"] is not None and options["points"] is not None:
        refuse("--size and --points both choose the tiles; give one")
    if from_crs is not None and to_crs is None:
        refuse("--from-crs goes with --to-crs")
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


@tile.command("run", short_help="Work the tiles off.")
@FOLDER
@click.option("--serial", is_flag=True, help="In this process; the default.")
@click.option("--workers", type=COUNT, metavar="N", help="By N processes of this machine (dask.distributed).")
@click.option("--scheduler", metavar="ADDRESS", help="By the workers of a dask scheduler, as tcp://host:8786.")
@click.option("--part", type=Part(), metavar="K/N", help="Only the K-th of N shares of the tiles, for array jobs.")
@click.option("--tile", "name", type=TileName(), metavar="X_Y", help="Only this tile, again if it failed.")
@click.option(
    "--device", type=DeviceName(), default="cpu", show_default=True, metavar="cpu|cuda|cuda:N", help="A GPU a worker."
)
@json_option()
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
    """Work the tiles of DIR off. What is done stays, so that the same command goes on after an end of any kind.

    Any number of runs may work on one DIR at once. Exit code 3 where tiles failed or were set aside, with their names.
    Each has the command that repeats it alone.

    \b
    pointloom tile run job
    pointloom tile run job --workers 8
    pointloom tile run /shared/job --scheduler tcp://head:8786
    pointloom tile run /shared/job --part $SLURM_ARRAY_TASK_ID/400
    pointloom tile run job --tile 3_4
    """
    if serial + bool(workers) + bool(scheduler) > 1:
        refuse("--serial, --workers and --scheduler exclude each other; give one")
    if part and name:
        refuse("--part and --tile both choose tiles; give one")
    from ...tiling.runners import run_tiles
    from ..jobs.tiles import report_of

    with Progress() as progress:
        runner = {"workers": workers or 0, "scheduler": scheduler, "device": device}
        told = run_tiles(folder, part=part, tile=name, progress=progress, **runner)
    return answer_with(report_of("run", told, is_part=bool(part or name)), str(folder), as_json)


@tile.command("status", short_help="Say how far the tiles are.")
@FOLDER
@json_option()
def status(folder: Path, as_json: bool) -> int:
    """Say how many tiles of DIR wait, are done, failed or were set aside. Also while others work on it.

    Exit code 3 where tiles failed or were set aside.

    \b
    pointloom tile status job --json
    """
    from ...tiling.status import tile_status
    from ..jobs.tiles import report_of

    return answer_with(report_of("status", tile_status(folder)), str(folder), as_json)


@tile.command("retry", short_help="Have tiles that failed wait again.")
@FOLDER
@json_option()
def retry(folder: Path, as_json: bool) -> int:
    """Have the tiles of DIR that failed or were set aside, and such files, wait again; `tile run` then does them.

    \b
    pointloom tile retry job
    """
    from ...tiling.runners import retry_tiles
    from ..jobs.tiles import report_of

    return answer_with(report_of("retry", retry_tiles(folder)), str(folder), as_json)


@tile.command("finish", short_help="Make one file of all tiles.")
@FOLDER
@click.option("-o", "path", type=FILE, metavar="OUT", help="The file; result.laz in DIR if not given.")
@click.option("--output", type=click.Choice(FILES), help="The format; else what OUT's name says, or the plan.")
@click.option("--workers", type=COUNT, metavar="N", help="Processes that make copc; 1 GB each.")
@json_option()
@force_option()
def finish(folder: Path, path: Path | None, output: str | None, workers: int | None, as_json: bool, force: bool) -> int:
    """Make one file of all tiles of DIR, once all are done, and remove what lay there beside them.

    OUT appears whole or not at all, after Ctrl-C too.

    \b
    pointloom tile finish job -o thinned.laz
    pointloom tile finish job -o thinned.copc.laz
    """
    from ..jobs.tiles import finish_job

    options: dict[str, Any] = {"output": output, "workers": workers or 0}
    with Progress() as progress:
        told = finish_job(folder, path, overwrite=force, progress=progress, **options)
    return answer_with(told, str(folder), as_json)


COMMANDS = (tile,)
