"""The commands clean-mesh, simplify, smooth-mesh, sample-mesh and compare-meshes. No expensive imports here."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import click

from .answer import answer_with
from .cloud_command import Answer, from_cloud_to_cloud
from .console import Progress
from .mesh_command import Lengths
from .options import (
    FILE,
    LENGTH,
    Renamed,
    check_up,
    device_option,
    force_option,
    json_option,
    refuse,
    refuse_same,
    up_option,
)
from .toolbox import COUNT, FACTOR, SEED, SHARE, Number

AREA = Number("an area in square meters above 0", lambda number: 0 < number < math.inf)
ANY = Number("a finite number", math.isfinite)


@click.command("clean-mesh", short_help="Mend a mesh.")
@click.option("--merge", type=LENGTH, metavar="M", help="Make one of vertices closer than this [m].")
@click.option("--fill", type=LENGTH, metavar="M", help="Close holes of up to this radius [m].")
@click.option("--min-triangles", type=COUNT, default=1, metavar="N", help="Drop parts of fewer triangles.")
@click.option("--min-area", type=AREA, default=None, metavar="M2", help="Drop parts of a smaller area [m^2].")
@from_cloud_to_cloud(columns=False)
def clean_mesh(source: Path, output: Path, min_area: float | None, **options: Any) -> Answer:
    """Write the mesh IN to OUT without what is commonly wrong with one, and say what was done.

    In this order: triangles with a corner that is not finite or that name a vertex twice go; borders that lie on each
    other are sewn up. Edges of more than two triangles become sheets; copies and second sides go. The others are wound
    alike; holes are closed (--fill). Closed parts are turned by what they lie within. Small parts go. What is right
    stays as it is.

    The exit code is 3 where more than 2 % of the triangles or 1 % of the area went that were no copies, a closed mesh
    is open, holes of the size asked are left, most vertices were merged, a part has one side only, or nothing is left.

    \b
    pointloom clean-mesh scan.ply out.ply
    pointloom clean-mesh scan.obj out.obj --merge 0.0005 --fill 0.05 --min-triangles 100
    """
    from ..jobs.clean_mesh import clean_mesh_file

    with Progress() as progress:
        return clean_mesh_file(source, output, min_area=min_area or 0.0, progress=progress, **options)


@click.command(short_help="Make a mesh of fewer triangles.")
@click.option("--triangles", type=COUNT, metavar="N", help="How many are to be left.")
@click.option("--ratio", type=SHARE, metavar="R", help="Which share of them is to be left.")
@click.option("--voxel", type=LENGTH, metavar="M", help="Leave one vertex a voxel of this size [m] instead.")
@click.option("--max-error", type=FACTOR, metavar="E", help="End where a step would cost more than this.")
@click.option("--boundary-weight", type=FACTOR, metavar="W", help="How firmly borders stay; 1 if not given.")
@from_cloud_to_cloud(columns=False)
def simplify(
    source: Path, output: Path, max_error: float | None, boundary_weight: float | None, **options: Any
) -> Answer:
    """Write the mesh IN to OUT with fewer triangles, and say how far the surface moved.

    --triangles and --ratio collapse the edges that matter least (quadric decimation): borders, colors and textures
    stay. --voxel is quicker and coarser.

    The exit code is 3 where the target is missed or the surface moved by more than 1 % of its size.

    \b
    pointloom simplify scan.ply small.ply --triangles 50000
    pointloom simplify scan.obj small.obj --ratio 0.1
    pointloom simplify scan.ply small.ply --voxel 0.02
    """
    from ..jobs.simplify import simplify_file

    ways = {name: options.pop(name) for name in ("triangles", "ratio", "voxel")}
    given = {name: amount for name, amount in ways.items() if amount is not None}
    if len(given) != 1:
        refuse(f"give one of --triangles, --ratio and --voxel, got {' and '.join(given) or 'none'}")
    ((by, amount),) = given.items()
    if by == "voxel" and (max_error is not None or boundary_weight is not None):
        refuse("--max-error and --boundary-weight go with --triangles or --ratio")
    options |= {"max_error": math.inf if max_error is None else max_error, "boundary_weight": boundary_weight or 1.0}
    with Progress() as progress:
        return simplify_file(source, output, by=by, amount=amount, progress=progress, **options)


@click.command("smooth-mesh", short_help="Smooth or sharpen a mesh.")
@click.option(
    "--method",
    type=click.Choice(("taubin", "laplacian", "simple", "sharpen")),
    default="taubin",
    show_default=True,
    help="How.",
)
@click.option("--iterations", type=COUNT, default=10, show_default=True, metavar="N", help="How often.")
@click.option("--lambda", "lambda_filter", type=FACTOR, metavar="L", help="taubin, laplacian: step; 0.5 if not given.")
@click.option("--mu", type=ANY, metavar="MU", help="taubin: step back; -0.53 if not given.")
@click.option("--strength", type=FACTOR, metavar="S", help="sharpen: how much; 1 if not given.")
@from_cloud_to_cloud(columns=False)
def smooth_mesh(source: Path, output: Path, method: str, **options: Any) -> Answer:
    """Write the mesh IN to OUT with smoother vertices, normals and colors.

    \b
    taubin     smooths and swells again, so that the shape hardly shrinks
    laplacian  toward the mean of the neighbors, the near ones more
    simple     the mean of a vertex and its neighbors
    sharpen    away from the mean

    The exit code is 3 where more than a tenth of the area is gone with the noise.

    \b
    pointloom smooth-mesh scan.ply out.ply
    pointloom smooth-mesh scan.ply out.ply --method laplacian --iterations 3
    """
    from ..jobs.smooth_mesh import smooth_mesh_file

    owners = {"lambda_filter": ("taubin", "laplacian"), "mu": ("taubin",), "strength": ("sharpen",)}
    given = {name: options.pop(name) for name in owners}
    factors = {name: factor for name, factor in given.items() if factor is not None}
    for name in factors:
        if method not in owners[name]:
            refuse(f"--{name.split('_')[0]} goes with --method {' or '.join(owners[name])}")
    with Progress() as progress:
        return smooth_mesh_file(source, output, method=method, factors=factors, progress=progress, **options)


@click.command("sample-mesh", short_help="Draw points from a mesh.")
@click.option("--points", "count", type=COUNT, required=True, metavar="N", help="How many.")
@click.option("--even", is_flag=True, help="Spread them evenly (Poisson disk).")
@click.option("--triangle-normals", is_flag=True, help="Give them the normals of their triangles.")
@click.option("--seed", type=SEED, default=0, show_default=True, metavar="N", help="Chooses the points.")
@from_cloud_to_cloud(columns=False)
def sample_mesh(source: Path, output: Path, **options: Any) -> Answer:
    """Write to the cloud OUT points on the surface of the mesh IN, each place as likely as any other.

    The exit code is 3 where the mesh has no area.

    \b
    pointloom sample-mesh part.stl part.ply --points 100000
    pointloom sample-mesh part.obj part.pcd --points 5000 --even
    """
    from ..jobs.sample_mesh import sample_mesh_file

    with Progress() as progress:
        return sample_mesh_file(source, output, progress=progress, **options)


@click.command("compare-meshes", short_help="Measure how far two meshes lie apart.")
@click.argument("first", type=FILE, metavar="A")
@click.argument("second", type=FILE, metavar="B")
@click.option("--samples", type=COUNT, default=100_000, show_default=True, metavar="N", help="Points drawn from each.")
@click.option("--threshold", "thresholds", type=Lengths(), metavar="A,B,...", help="Distances [m] of the F-score.")
@click.option(
    "--max-distance", "limit", cls=Renamed, old="--max", type=LENGTH, metavar="M",
    help="Exit with 3 where any place lies farther apart [m].",
)  # fmt: skip
@click.option("--error-map", type=FILE, metavar="OUT", help="Write A colored by its distance from B to this mesh.")
@click.option("--picture", type=FILE, metavar="PNG", help="Draw A colored by its distance from B, with a histogram.")
@click.option("--seed", type=SEED, default=0, show_default=True, metavar="N", help="Chooses the samples.")
@device_option()
@up_option()
@json_option()
@force_option()
def compare_meshes(
    first: Path, second: Path, error_map: Path | None, picture: Path | None, as_json: bool, force: bool, **options: Any
) -> int:
    """Measure how far the surfaces of the meshes A and B lie apart, both ways, by exact distances to triangles.

    Chamfer, root mean square, Hausdorff, and the F-score at some distances. The exit code is 3 where the surfaces lie
    farther apart than --max-distance, or so far that they are likely of other units or frames. --picture needs the
    extra pointloom[plot].

    \b
    pointloom compare-meshes mine.ply truth.ply --threshold 0.005,0.01
    pointloom compare-meshes mine.ply truth.ply --max-distance 0.02 --error-map errors.ply --picture errors.png
    """
    from ..jobs.compare_meshes import ErrorMaps, compare_mesh_files

    refuse_same(error_map=error_map, picture=picture)
    check_up(options["up"], first, second, error_map)
    with Progress() as progress:
        options |= {"maps": ErrorMaps(error_map, picture), "overwrite": force, "progress": progress}
        report = compare_mesh_files(first, second, **options)
    return answer_with(report, f"{first} and {second}", as_json)


COMMANDS = (clean_mesh, simplify, smooth_mesh, sample_mesh, compare_meshes)
