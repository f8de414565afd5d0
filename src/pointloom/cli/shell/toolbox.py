"""The commands clean, cluster, plane, crop and downsample. Nothing expensive is imported here."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from .cloud_command import Answer, from_cloud_to_cloud
from .console import Progress
from .options import FILE, LENGTH, Number, is_positive, option, refuse

DEFAULT_NEIGHBORS, DEFAULT_DEVIATIONS = 20, 2.0  # defaults of the statistical filter: Open3D's example
MAX_POINTS = 2**31 - 2
MAX_SEED = 2**31 - 1


COUNT_TYPE = Number(f"a whole number from 1 to {MAX_POINTS}", lambda number: 1 <= number <= MAX_POINTS, int)
SEED_TYPE = Number(f"a whole number from 0 to {MAX_SEED}", lambda number: 0 <= number <= MAX_SEED, int)
FACTOR_TYPE = Number("a finite number above 0", is_positive)
FRACTION_TYPE = Number("a fraction above 0 and up to 1", lambda number: 0 < number <= 1)
COORDINATE = Number("a coordinate in meters, -inf or inf", lambda number: True)


@click.command(short_help="Remove outliers, duplicates and non-finite points.")
@option("--non-finite", bool, "Remove non-finite points, as every other filter does.")
@option("--duplicates", bool, "Remove all but the first point at each position.")
@option("--neighbors=N", COUNT_TYPE, "Statistical filter: number of neighbors. Default: 20.")
@option("--deviations ratio=R", FACTOR_TYPE, "Statistical filter: standard deviations above the mean. Default: 2.0.")
@option("--radius=M", LENGTH, "Radius filter: maximum distance of neighbors [m].")
@option("--min-neighbors=N", COUNT_TYPE, "Radius filter: minimum number of neighbors.")
@option("--removed=FILE", FILE, "Write the removed points, if any, to this cloud.")
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
    """Remove outliers and invalid points from the cloud IN, and write it to OUT.

    The options enable the filters, which run in this order, each on the result of the previous one. Without options,
    non-finite and statistical are enabled:

    \b
      non-finite   points with a NaN or infinite coordinate. Always removed
      duplicates   (--duplicates) points at the position of an earlier one
      statistical  (--neighbors, --deviations) points with a mean neighbor distance of more than R standard deviations
                   above the mean of the cloud
      radius       (--radius, --min-neighbors) points with fewer than N other points within M meters

    \b
    pointloom clean scan.ply out.ply
    pointloom clean scan.las out.las --duplicates --radius 0.5 --min-neighbors 4 --removed outliers.las
    """
    from ..jobs.clean import clean_file

    if (radius is None) != (min_neighbors is None):
        given, missing = ("--radius", "--min-neighbors") if min_neighbors is None else ("--min-neighbors", "--radius")
        refuse(f"{given} requires {missing}: the radius filter needs both")
    if removed is not None and removed.resolve() == output.resolve():
        refuse(f"--removed is the same file as OUT, {output}; pass another name")
    filters: dict[str, Any] = {"duplicates": duplicates}
    if radius is not None:
        filters["radius"] = (radius, min_neighbors)
    if neighbors or ratio or not (non_finite or duplicates or radius):
        filters["statistical"] = (neighbors or DEFAULT_NEIGHBORS, ratio or DEFAULT_DEVIATIONS)
    with Progress() as progress:
        return clean_file(source, output, removed=removed, progress=progress, **filters, **settings)


@click.command(short_help="Label the points of a cloud by cluster.")
@option("--radius eps=M", LENGTH, "Maximum distance of neighbors [m]: eps of DBSCAN.", required=True)
@option("--neighbors min_points=N", COUNT_TYPE, "Minimum neighbors of a core point, including itself.", default=10)
@option("--largest=N", COUNT_TYPE, "Keep only the N largest clusters. Default: all points.")
@option("--paint", bool, "Color the points by label (tab20, noise black).")
@from_cloud_to_cloud()
def cluster(source: Path, output: Path, **options: Any) -> Answer:
    """Cluster the cloud IN by DBSCAN, and write it to OUT with the attribute label (-1 for noise).

    A core point has at least --neighbors points closer than --radius, including itself. Core points closer than
    --radius belong to one cluster. If --radius does not fit the cloud, the exit code is 3 and a better value is
    suggested.

    \b
    pointloom cluster scan.ply out.ply --radius 0.05 --paint
    pointloom cluster scan.ply trunk.ply --radius 0.05 --neighbors 20 --largest 1
    """
    from ..jobs.cluster import cluster_file

    with Progress() as progress:
        return cluster_file(source, output, progress=progress, **options)


@click.command(short_help="Segment planes of a cloud.")
@option("--distance=M", LENGTH, "Maximum distance of inliers from the plane [m].", required=True)
@option("--iterations=N", COUNT_TYPE, "RANSAC iterations per plane.", default=1000)
@option("--planes=N", COUNT_TYPE, "Label the points of up to N planes, the largest first.")
@option("--min-points=N", COUNT_TYPE, "With --planes: minimum points of a plane. Default: 100.")
@option("--invert", bool, "Write the points outside the plane.")
@option("--seed=N", SEED_TYPE, "Random seed.", default=0)
@from_cloud_to_cloud()
def plane(
    source: Path, output: Path, planes: int | None, min_points: int | None, invert: bool, **options: Any
) -> Answer:
    """Segment the plane with the most points of the cloud IN, write its points to OUT, and print its a, b, c, d.

    The plane is ax + by + cz + d = 0 with a unit normal (a, b, c), in the coordinates of the file. With --planes all
    points are written, with the attribute plane: 0 for the largest, -1 for none. The exit code is 3 if no plane has 5%
    of the points.

    \b
    pointloom plane scan.ply floor.ply --distance 0.02
    pointloom plane scan.ply objects.ply --distance 0.02 --invert
    pointloom plane scan.ply labeled.ply --distance 0.02 --planes 6
    """
    from ..jobs.planes import MIN_POINTS, extract_plane, label_planes

    if planes is None and min_points is not None:
        refuse("--min-points requires --planes")
    if planes is not None and invert:
        refuse("--invert selects points, --planes labels all of them; pass one of them")
    with Progress() as progress:
        options |= {"progress": progress}
        if planes is None:
            return extract_plane(source, output, invert=invert, **options)
        return label_planes(source, output, max_planes=planes, min_points=min_points or MIN_POINTS, **options)


@click.command(short_help="Keep the points inside a box or polygon.")
@option("--box=X0 Y0 Z0 X1 Y1 Z1", COORDINATE, "Minimum and maximum corner [m], inclusive.", nargs=6)
@option("--polygon=JSON", FILE, "Polygon volume in the format of Open3D's viewer.")
@option("--invert", bool, "Keep the points outside instead.")
@from_cloud_to_cloud()
def crop(source: Path, output: Path, box: tuple[float, ...] | None, polygon: Path | None, **options: Any) -> Answer:
    """Write the points of the cloud IN inside a box or a polygon volume to OUT.

    A coordinate of -inf or inf leaves a side of the box open.

    \b
    pointloom crop scan.ply table.ply --box -0.5 0 0.4 1.5 2 1.2
    pointloom crop tile.laz low.laz --box -inf -inf -inf inf inf 120.5
    pointloom crop scan.ply out.ply --polygon cropped.json --invert
    """
    from ..jobs.crop import crop_file

    if (box is None) == (polygon is None):
        refuse("expected one of --box and --polygon")
    if box is not None:
        for axis, low, high in zip("XYZ", box[:3], box[3:], strict=True):
            if low > high:
                refuse(f"--box: expected {axis}0 <= {axis}1, got {low:g} and {high:g}")
    with Progress() as progress:
        return crop_file(source, output, box=box, polygon=polygon, progress=progress, **options)


@click.command(short_help="Downsample a cloud.")
@option("--every=K", COUNT_TYPE, "Keep every K-th point.")
@option("--ratio=R", FRACTION_TYPE, "Keep this fraction of the points, selected at random.")
@option("--farthest=N", COUNT_TYPE, "Keep N points by farthest point sampling.")
@option("--voxel=M", LENGTH, "Keep the mean of the points of each voxel of this size [m].")
@option("--nearest", bool, "With --voxel: keep the point nearest to the mean instead.")
@option("--seed=N", SEED_TYPE, "With --ratio: random seed. Default: 0.")
@from_cloud_to_cloud()
def downsample(source: Path, output: Path, nearest: bool, seed: int | None, **options: Any) -> Answer:
    """Downsample the cloud IN by one of --every, --ratio, --farthest and --voxel, and write it to OUT.

    All methods except the means of --voxel keep points of IN unchanged, with all attributes. --voxel averages
    positions, normals, colors and floating-point attributes. Integer attributes are those of the first point of the
    voxel.

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
        refuse(f"expected one of --every, --ratio, --farthest and --voxel, got {' and '.join(given) or 'none'}")
    ((by, amount),) = given.items()
    if nearest and by != "voxel":
        refuse("--nearest requires --voxel")
    if seed is not None and by != "ratio":
        refuse("--seed requires --ratio")
    with Progress() as progress:
        options |= {"progress": progress}
        way = "nearest" if nearest else by
        return downsample_file(source, output, by=way, amount=amount, seed=seed or 0, **options)


COMMANDS = (clean, cluster, plane, crop, downsample)
