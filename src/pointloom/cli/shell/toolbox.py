"""The commands clean, cluster, plane, crop and downsample. Nothing expensive is imported here."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import click

from .cloud_command import Answer, from_cloud_to_cloud
from .console import Progress
from .options import FILE, LENGTH, Renamed, refuse

NEIGHBORS, RATIO = 20, 2.0  # defaults of the statistical filter: Open3D's example
MAX_POINTS = 2**31 - 2
MAX_SEED = 2**31 - 1


class Number(click.ParamType):
    """A number that fulfills a condition; never NaN."""

    name = "number"

    def __init__(self, expected: str, accepts: Callable[[float], bool], kind: type[int] | type[float] = float):
        self._expected, self._accepts, self._kind = expected, accepts, kind

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        try:
            number = self._kind(value)
        except ValueError:
            number = math.nan
        if math.isnan(number) or not self._accepts(number):
            self.fail(f"expected {self._expected}, got {value!r}", param, ctx)
        return number


COUNT = Number(f"a whole number from 1 to {MAX_POINTS}", lambda number: 1 <= number <= MAX_POINTS, int)
SEED = Number(f"a whole number from 0 to {MAX_SEED}", lambda number: 0 <= number <= MAX_SEED, int)
FACTOR = Number("a finite number above 0", lambda number: 0 < number < math.inf)
SHARE = Number("a share above 0 and up to 1", lambda number: 0 < number <= 1)
COORDINATE = Number("a coordinate in meters, -inf or inf", lambda number: True)


@click.command(short_help="Remove outliers, duplicates and points that are not finite.")
@click.option("--non-finite", is_flag=True, help="Remove points that are not finite; every other filter does so too.")
@click.option("--duplicates", is_flag=True, help="Remove all but the first of the points at one position.")
@click.option("--neighbors", type=COUNT, metavar="N", help="Statistical filter: neighbors of a mean; 20 if not given.")
@click.option(
    "--deviations", "ratio", cls=Renamed, old="--ratio", type=FACTOR, metavar="R",
    help="Statistical filter: how many above the mean; 2.0 if not given.",
)  # fmt: skip
@click.option("--radius", type=LENGTH, metavar="M", help="Radius filter: how far neighbors may be [m].")
@click.option("--min-neighbors", type=COUNT, metavar="N", help="Radius filter: neighbors a point needs.")
@click.option("--removed", type=FILE, metavar="FILE", help="Write the points that were removed, if any, to this cloud.")
@from_cloud_to_cloud()
def clean(
    source: Path,
    output: Path,
    non_finite: bool,
    duplicates: bool,
    neighbors: int | None,
    ratio: float | None,
    radius: float | None,
    min_neighbors: int | None,
    removed: Path | None,
    **settings: Any,
) -> Answer:
    """Write the cloud IN to OUT without points that should not be there.

    The options choose the filters, which run in this order, each on what the last one left. Without any, the first
    and the third:

    \b
      non-finite   points with a NaN or infinite coordinate. Always removed
      duplicates   (--duplicates) points at the place of an earlier one
      statistical  (--neighbors, --deviations) points farther from their neighbors than the mean of the cloud by more
                   than R standard deviations
      radius       (--radius, --min-neighbors) points with fewer than N others within M meters

    \b
    pointloom clean scan.ply out.ply
    pointloom clean scan.las out.las --duplicates --radius 0.5 --min-neighbors 4 --removed outliers.las
    """
    from ..jobs.clean import clean_file

    if (radius is None) != (min_neighbors is None):
        given, missing = ("--radius", "--min-neighbors") if min_neighbors is None else ("--min-neighbors", "--radius")
        refuse(f"{given} needs {missing}: the radius filter takes both")
    if removed is not None and removed.resolve() == output.resolve():
        refuse(f"--removed is OUT itself, {output}; give another name")
    filters: dict[str, Any] = {"duplicates": duplicates}
    if radius is not None:
        filters["radius"] = (radius, min_neighbors)
    if neighbors or ratio or not (non_finite or duplicates or radius):
        filters["statistical"] = (neighbors or NEIGHBORS, ratio or RATIO)
    with Progress() as progress:
        return clean_file(source, output, removed=removed, progress=progress, **filters, **settings)


@click.command(short_help="Label the points of a cloud by cluster.")
@click.option(
    "--radius", "eps", cls=Renamed, old="--eps", type=LENGTH, required=True, metavar="M",
    help="Neighbors lie closer than this [m]: eps of DBSCAN.",
)  # fmt: skip
@click.option(
    "--neighbors", "min_points", cls=Renamed, old="--min-points", type=COUNT, default=10, show_default=True,
    metavar="N", help="Neighbors that make a core, itself included.",
)  # fmt: skip
@click.option("--largest", type=COUNT, metavar="N", help="Keep the N largest clusters alone; all points if not given.")
@click.option("--paint", is_flag=True, help="Color the points by label (tab20, noise black).")
@from_cloud_to_cloud()
def cluster(source: Path, output: Path, **options: Any) -> Answer:
    """Write the cloud IN to OUT with the cluster of each point (DBSCAN) as the attribute label, -1 for noise.

    A point with at least --neighbors points closer than --radius, itself included, is the core of a cluster; cores
    closer than --radius are of one. Where it does not fit the cloud, the exit code is 3 and a better one is proposed.

    \b
    pointloom cluster scan.ply out.ply --radius 0.05 --paint
    pointloom cluster scan.ply trunk.ply --radius 0.05 --neighbors 20 --largest 1
    """
    from ..jobs.cluster import cluster_file

    with Progress() as progress:
        return cluster_file(source, output, progress=progress, **options)


@click.command(short_help="Find the planes of a cloud.")
@click.option("--distance", type=LENGTH, required=True, metavar="M", help="Points closer than this lie on a plane [m].")
@click.option("--iterations", type=COUNT, default=1000, show_default=True, metavar="N", help="Samples for a plane.")
@click.option("--planes", type=COUNT, metavar="N", help="Label the points of up to N planes, the largest first.")
@click.option("--min-points", type=COUNT, metavar="N", help="With --planes: fewer are no plane; 100 if not given.")
@click.option("--invert", is_flag=True, help="Write the points that do not lie on the plane.")
@click.option("--seed", type=SEED, default=0, show_default=True, metavar="N", help="Chooses the samples.")
@from_cloud_to_cloud()
def plane(
    source: Path, output: Path, planes: int | None, min_points: int | None, invert: bool, **options: Any
) -> Answer:
    """Write to OUT the points of the cloud IN on the plane that has the most of them, and print its a, b, c, d.

    The plane is ax + by + cz + d = 0 with a unit normal (a, b, c), in the coordinates of the file. With --planes all
    points are written, with the plane of each as the attribute plane: 0 for the largest, -1 for none. The exit code
    is 3 where no plane has 5 % of the points.

    \b
    pointloom plane scan.ply floor.ply --distance 0.02
    pointloom plane scan.ply objects.ply --distance 0.02 --invert
    pointloom plane scan.ply labeled.ply --distance 0.02 --planes 6
    """
    from ..jobs.planes import MIN_POINTS, extract_plane, label_planes

    if planes is None and min_points is not None:
        refuse("--min-points goes with --planes")
    if planes is not None and invert:
        refuse("--invert chooses points, --planes labels all of them; give one")
    with Progress() as progress:
        options |= {"progress": progress}
        if planes is None:
            return extract_plane(source, output, invert=invert, **options)
        return label_planes(source, output, most=planes, min_points=min_points or MIN_POINTS, **options)


@click.command(short_help="Keep the points inside a box or polygon.")
@click.option(
    "--box", type=COORDINATE, nargs=6, metavar="X0 Y0 Z0 X1 Y1 Z1", help="Lowest and highest corner [m], both included."
)
@click.option("--polygon", type=FILE, metavar="JSON", help="A polygon volume as Open3D's viewer writes it.")
@click.option("--invert", is_flag=True, help="Keep the points outside instead.")
@from_cloud_to_cloud()
def crop(source: Path, output: Path, box: tuple[float, ...] | None, polygon: Path | None, **options: Any) -> Answer:
    """Write to OUT the points of the cloud IN inside a box or a polygon volume.

    A coordinate of -inf or inf leaves a side of the box open.

    \b
    pointloom crop scan.ply table.ply --box -0.5 0 0.4 1.5 2 1.2
    pointloom crop tile.laz low.laz --box -inf -inf -inf inf inf 120.5
    pointloom crop scan.ply out.ply --polygon cropped.json --invert
    """
    from ..jobs.crop import crop_file

    if (box is None) == (polygon is None):
        refuse("give one of --box and --polygon")
    if box is not None:
        for axis, low, high in zip("XYZ", box[:3], box[3:], strict=True):
            if low > high:
                refuse(f"--box: expected {axis}0 <= {axis}1, got {low:g} and {high:g}")
    with Progress() as progress:
        return crop_file(source, output, box=box, polygon=polygon, progress=progress, **options)


@click.command(short_help="Thin a cloud.")
@click.option("--every", type=COUNT, metavar="K", help="Keep every K-th point.")
@click.option("--ratio", type=SHARE, metavar="R", help="Keep this share of the points, chosen at random.")
@click.option("--farthest", type=COUNT, metavar="N", help="Keep N points, each the farthest from those before it.")
@click.option("--voxel", type=LENGTH, metavar="M", help="One point for each voxel with this edge [m]: the mean.")
@click.option("--nearest", is_flag=True, help="With --voxel: the point nearest to the mean instead.")
@click.option("--seed", type=SEED, metavar="N", help="With --ratio: chooses the choice; 0 if not given.")
@from_cloud_to_cloud()
def downsample(source: Path, output: Path, nearest: bool, seed: int | None, **options: Any) -> Answer:
    """Write to OUT fewer points of the cloud IN: one of --every, --ratio, --farthest and --voxel says which.

    All but the means of --voxel are points of IN as they are, with all their attributes. Means are of normals, colors
    and attributes in floating point too; whole numbers are those of the first point.

    \b
    pointloom downsample scan.ply out.ply --every 10
    pointloom downsample scan.ply out.ply --ratio 0.1 --seed 7
    pointloom downsample scan.ply out.ply --farthest 2048
    pointloom downsample tile.laz out.laz --voxel 0.5 --nearest
    """
    from ..jobs.downsample import downsample_file

    ways = {name: options.pop(name) for name in ("every", "ratio", "farthest", "voxel")}
    given = {name: amount for name, amount in ways.items() if amount is not None}
    if len(given) != 1:
        refuse(f"give one of --every, --ratio, --farthest and --voxel, got {' and '.join(given) or 'none'}")
    ((by, amount),) = given.items()
    if nearest and by != "voxel":
        refuse("--nearest goes with --voxel")
    if seed is not None and by != "ratio":
        refuse("--seed goes with --ratio")
    with Progress() as progress:
        options |= {"progress": progress}
        way = "nearest" if nearest else by
        return downsample_file(source, output, by=way, amount=amount, seed=seed or 0, **options)


COMMANDS = (clean, cluster, plane, crop, downsample)
