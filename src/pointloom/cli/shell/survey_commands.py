"""The commands ground, dtm, contours, volume, merge, transform and split. Nothing expensive is imported here."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import click

from ...io.points.formats import WRITTEN
from .answer import answer_with
from .cloud_command import Answer, from_cloud_to_cloud
from .console import Progress
from .format_lists import with_lists
from .options import (
    ASCII,
    COLUMNS,
    DEVICE,
    FILE,
    FORCE,
    JSON,
    LENGTH,
    UP,
    Number,
    check_up,
    in_order,
    option,
    refuse,
    refuse_same,
)
from .registration_commands import RANGE_TYPE
from .toolbox import FACTOR_TYPE

ANY = Number("a finite number", math.isfinite)
KINDS = ["dtm", "dsm", "chm", "density", "intensity", "lowest"]


@click.command(short_help="Classify the ground of a scan.")
@option("--cell cell_size=M", LENGTH, "Edge of the grid's cells [m], about the point spacing.", default=1.0)
@option("--slope=S", FACTOR_TYPE, "Maximum slope of the terrain, as rise over run.", default=0.15)
@option("--window max_window=M", LENGTH, "Radius of the largest window [m].", default=18.0)
@from_cloud_to_cloud()
def ground(source: Path, output: Path, **options: Any) -> Answer:
    """Classify the ground of the cloud IN, z up, and write it to OUT with the attribute classification.

    Ground points get class 2. Other points of class 0 or 2 get class 1, and other classes are kept. --window is more
    than half the width of the largest building.

    \b
    pointloom ground tile.laz ground.laz
    pointloom ground scan.ply ground.ply --cell 0.2 --window 8
    """
    from ..jobs.survey import classify_ground_of_file

    with Progress() as progress:
        return classify_ground_of_file(source, output, progress=progress, **options)


@click.command(short_help="Make a terrain model or another raster of a cloud.")
@click.argument("source", type=FILE, metavar="IN")
@option("-o --output=TIF", FILE, "GeoTIFF of float32 values and of filled cells.", required=True)
@option("--cell=M", LENGTH, "Edge of a cell [m].", default=1.0)
@option("--kind", KINDS, "Values: terrain, surface, canopy height, density, intensity, lowest.", default="dtm")
@option(
    "--method", ["idw", "tin"], "Interpolation between ground points: inverse distance or triangles.", default="idw"
)
@option("--fill=M", LENGTH, "Fill gaps up to this distance from cells with values [m].")
@option("--crs=SYSTEM", str, "Coordinate system, such as EPSG:25832. Default: that of IN.")
@in_order(DEVICE, COLUMNS, JSON, FORCE)
def dtm(source: Path, output: Path, as_json: bool, force: bool, **options: Any) -> int:
    """Make a terrain model of the cloud IN with classified ground, as a GeoTIFF.

    Cell edges are multiples of --cell, so that models of two epochs have one grid. It requires the extra
    pointloom[geo]. `pointloom ground` classifies the ground.

    \b
    pointloom dtm ground.laz -o dtm.tif --cell 0.5 --fill 20
    pointloom dtm tile.laz -o dsm.tif --kind dsm
    """
    from ..jobs.survey import rasterize_file

    report = rasterize_file(source, output, overwrite=force, **options)
    return answer_with(report, str(source), as_json)


@click.command(short_help="Make contour lines of a terrain model.")
@click.argument("source", type=FILE, metavar="IN.TIF")
@option("-o --output=OUT", FILE, "The lines.", required=True)
@option("--interval=M", LENGTH, "Height difference of the lines [m], which are at its multiples.", required=True)
@in_order(JSON, FORCE)
@with_lists
def contours(source: Path, output: Path, interval: float, as_json: bool, force: bool) -> int:
    """Make contour lines of the GeoTIFF IN.TIF, such as a terrain model of `pointloom dtm`, as {contours}.

    Each line has its height as z, and as the attribute elevation of .gpkg and .geojson. Lines end at empty cells.
    GeoJSON has degrees of WGS 84 if the coordinate system is known. Requires the extra pointloom[geo].

    \b
    pointloom contours dtm.tif -o contours.gpkg --interval 1
    pointloom contours dtm.tif -o contours.dxf --interval 0.25
    """
    from ..jobs.rasters import contours_of_file

    report = contours_of_file(source, output, interval=interval, overwrite=force)
    return answer_with(report, str(source), as_json)


@click.command(short_help="Measure cut and fill between two surveys.")
@click.argument("before", type=FILE, metavar="A")
@click.argument("after", type=FILE, metavar="B")
@option("--cell=M", LENGTH, "Edge of a cell [m], for 4 or more points. Default: that of a GeoTIFF.")
@option("--registration-error=M", RANGE_TYPE, "Standard deviation of the height offset [m].", default=0.0)
@option("--max-gap=M", LENGTH, "Maximum width of interpolated gaps [m]. Default: 4 cells.")
@option("-o --output difference=TIF", FILE, "GeoTIFF of the height differences.")
@option("--picture=PNG", FILE, "Render the differences: blue to red, gray if not significant.")
@option("--report=HTML", FILE, "Page with the volumes, the failed checks and the picture.")
@option("--limit=M", LENGTH, "Limit of the color scale [m]. Default: from the data.")
@in_order(COLUMNS, DEVICE, JSON, FORCE)
def volume(before: Path, after: Path, as_json: bool, force: bool, **options: Any) -> int:
    """Measure the volumes of cut and fill from A to B along z, with 95% intervals.

    A and B are clouds, meshes or GeoTIFF files, z up. Only ground points count if a cloud has any. For a stockpile, A
    is the ground without it. Interpolated and missing areas are listed.

    The exit code is 3 if less than half of the area is compared, if change continues into the missing area, or if most
    of the area changed by the same height, as with two height systems. Outputs are still written.

    \b
    pointloom volume 2023.laz 2024.laz --cell 0.5 --registration-error 0.01 --report change.html
    pointloom volume ground.tif pile.laz -o difference.tif
    """
    refuse_same(**{name: options[name] for name in ("difference", "picture", "report")})
    from ..jobs.rasters import VolumeOutputs, change_of_volume

    outputs = VolumeOutputs(*(options.pop(name) for name in ("difference", "picture", "report", "limit")))
    report = change_of_volume(before, after, outputs, overwrite=force, **options)
    return answer_with(report, f"{before} to {after}", as_json)


@click.command(short_help="Merge clouds into one file.")
@click.argument("files", nargs=-1, required=True, type=FILE, metavar="IN...")
@option("-o --output=OUT", FILE, "The merged cloud.", required=True)
@in_order(DEVICE, COLUMNS, UP, ASCII, JSON, FORCE)
def merge(files: tuple[Path, ...], output: Path, as_json: bool, force: bool, up: str | None, **options: Any) -> int:
    """Merge the clouds IN... into OUT, in the order given, with the attributes that all of them have.

    Different coordinate systems are an error. The scale and the coordinate system of a LAS file are those of the first.

    \b
    pointloom merge tile1.laz tile2.laz -o both.laz
    """
    from ..jobs.survey import merge_files

    check_up(up, *files, output)
    with Progress() as progress:
        report = merge_files(files, output, overwrite=force, up=up, progress=progress, **options)
    return answer_with(report, f"{len(files)} files", as_json)


@click.command(short_help="Transform a cloud or mesh: pose, scale, unit, coordinate system.")
@option("--pose=TXT", FILE, "Rigid motion: a 4x4 matrix as written by pointloom register -o.")
@option("--inverse", bool, "With --pose: apply the inverse motion.")
@option("--translate=X Y Z", ANY, "Translation [m].", nargs=3)
@option("--scale=F", FACTOR_TYPE, "Factor of all coordinates.")
@option("--crs epsg=SYSTEM", str, "Target coordinate system, such as EPSG:25832. Requires that of IN, or --from-crs.")
@option("--from-crs=SYSTEM", str, "With --crs: coordinate system of IN. Default: that in its header.")
@option("--unit=NAME", str, "Target unit, such as foot. Requires that of IN.")
@from_cloud_to_cloud()
def transform(source: Path, output: Path, inverse: bool, **options: Any) -> Answer:
    """Transform the cloud or mesh IN by one of --pose, --translate, --scale, --crs and --unit, and write it to OUT.

    Normals are rotated along. --crs requires the extra pointloom[geo].

    \b
    pointloom transform scan2.ply aligned.ply --pose T.txt
    pointloom transform tile.laz utm33.laz --crs EPSG:25833
    pointloom transform feet.laz meters.laz --unit metre
    """
    from ..jobs.survey import transform_file

    ways = {
        name: value for name in ("pose", "translate", "scale", "epsg", "unit") if (value := options[name]) is not None
    }
    if len(ways) != 1:
        refuse("expected one of --pose, --translate, --scale, --crs and --unit")
    if options["from_crs"] is not None and "epsg" not in ways:
        refuse("--from-crs requires --crs")
    if inverse and "pose" not in ways:
        refuse("--inverse requires --pose")
    with Progress() as progress:
        return transform_file(source, output, inverse=inverse, progress=progress, **options)


@click.command(short_help="Split a cloud into files by an attribute or by cells.")
@click.argument("source", type=FILE, metavar="IN")
@option("-o --output folder=DIR", FILE, "Folder of the parts.", required=True)
@option("--by=NAME", str, "One file per value of this attribute, such as classification or scan_index.")
@option("--cell=M", LENGTH, "One file per square cell of this size along x and y [m].")
@option("--format extension=EXT", [extension[1:] for extension in WRITTEN], "Format of the parts. Default: that of IN.")
@in_order(DEVICE, COLUMNS, UP, ASCII, JSON, FORCE)
def split(source: Path, by: str | None, cell: float | None, as_json: bool, force: bool, **options: Any) -> int:
    """Split the cloud IN into files of a folder, one per value of an attribute or per cell of a grid.

    Each point is in one part, unchanged. A part is named by the value, or by the number of the cell along x and y:
    tile_classification_2.laz, tile_824_1130.laz.

    \b
    pointloom split tile.laz -o classes --by classification
    pointloom split survey.laz -o cells --cell 500
    """
    from ..jobs.survey import split_file

    if (by is None) == (cell is None):
        refuse("expected one of --by and --cell")
    check_up(options["up"], source)
    with Progress() as progress:
        report = split_file(source, by=by, cell=cell, overwrite=force, progress=progress, **options)
    return answer_with(report, str(source), as_json)


COMMANDS = (ground, dtm, contours, volume, merge, transform, split)
