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
from .options import DEVICE, FILE, FORCE, JSON, LENGTH, UP, Number, check_up, in_order, option, refuse, refuse_same
from .toolbox import COUNT_TYPE, FACTOR_TYPE, FRACTION_TYPE, SEED_TYPE

AREA_TYPE = Number("an area in square meters above 0", lambda number: 0 < number < math.inf)
ANY = Number("a finite number", math.isfinite)


@click.command("clean-mesh", short_help="Repair a mesh.")
@option("--merge=M", LENGTH, "Merge vertices closer than this [m].")
@option("--fill=M", LENGTH, "Fill holes of up to this radius [m].")
@option(
    "--min-triangles=N", COUNT_TYPE, "Remove parts with fewer triangles. Default: 1.", default=1, show_default=False
)
@option("--min-area=M2", AREA_TYPE, "Remove parts with a smaller area [m^2].")
@from_cloud_to_cloud(columns=False)
def clean_mesh(source: Path, output: Path, min_area: float | None, **options: Any) -> Answer:
    """Repair the mesh IN, write it to OUT, and report the repairs.

    The steps, in this order: Remove triangles with non-finite corners and degenerate triangles. Sew coinciding borders.
    Split edges with more than two triangles into separate sheets. Remove duplicate triangles and duplicates with the
    opposite orientation. Make the orientation consistent. Fill holes (--fill). Orient closed parts by their nesting.
    Remove small parts. Everything else is unchanged.

    The exit code is 3 if more than 2% of the triangles or 1% of the area were removed (without duplicates), a closed
    mesh is no longer closed, holes within --fill remain, most vertices were merged, a part is not orientable, or the
    result is empty.

    \b
    pointloom clean-mesh scan.ply out.ply
    pointloom clean-mesh scan.obj out.obj --merge 0.0005 --fill 0.05 --min-triangles 100
    """
    from ..jobs.clean_mesh import clean_mesh_file

    with Progress() as progress:
        return clean_mesh_file(source, output, min_area=min_area or 0.0, progress=progress, **options)


@click.command(short_help="Reduce the number of triangles of a mesh.")
@option("--triangles=N", COUNT_TYPE, "Target number of triangles.")
@option("--ratio=R", FRACTION_TYPE, "Target fraction of the triangles.")
@option("--voxel=M", LENGTH, "Vertex clustering with this voxel size [m].")
@option("--max-error=E", FACTOR_TYPE, "Stop if the cost of a step exceeds this.")
@option("--boundary-weight=W", FACTOR_TYPE, "Weight that preserves borders. Default: 1.")
@from_cloud_to_cloud(columns=False)
def simplify(
    source: Path, output: Path, max_error: float | None, boundary_weight: float | None, **options: Any
) -> Answer:
    """Reduce the number of triangles of the mesh IN, write it to OUT, and report the displacement of the surface.

    --triangles and --ratio use quadric decimation and preserve borders, colors and textures. --voxel uses vertex
    clustering, which is faster and coarser.

    The exit code is 3 if the target was missed or the surface moved by more than 1% of its size.

    \b
    pointloom simplify scan.ply small.ply --triangles 50000
    pointloom simplify scan.obj small.obj --ratio 0.1
    pointloom simplify scan.ply small.ply --voxel 0.02
    """
    from ..jobs.simplify import simplify_file

    ways = {name: options.pop(name) for name in ("triangles", "ratio", "voxel")}
    given = {name: amount for name, amount in ways.items() if amount is not None}
    if len(given) != 1:
        refuse(f"expected one of --triangles, --ratio and --voxel, got {' and '.join(given) or 'none'}")
    ((by, amount),) = given.items()
    if by == "voxel" and (max_error is not None or boundary_weight is not None):
        refuse("--max-error and --boundary-weight require --triangles or --ratio")
    options |= {"max_error": math.inf if max_error is None else max_error, "boundary_weight": boundary_weight or 1.0}
    with Progress() as progress:
        return simplify_file(source, output, by=by, amount=amount, progress=progress, **options)


@click.command("smooth-mesh", short_help="Smooth or sharpen a mesh.")
@option("--method", ["taubin", "laplacian", "simple", "sharpen"], "Method, see above.", default="taubin")
@option("--iterations=N", COUNT_TYPE, "Number of iterations.", default=10)
@option("--lambda lambda_filter=L", FACTOR_TYPE, "taubin, laplacian: step. Default: 0.5.")
@option("--mu=MU", ANY, "taubin: inverse step. Default: -0.53.")
@option("--strength=S", FACTOR_TYPE, "sharpen: strength. Default: 1.")
@from_cloud_to_cloud(columns=False)
def smooth_mesh(source: Path, output: Path, method: str, **options: Any) -> Answer:
    """Smooth or sharpen the vertices, normals and colors of the mesh IN, and write it to OUT.

    \b
    taubin     alternating steps with almost no shrinkage
    laplacian  toward the mean of the neighbors, weighted by inverse distance
    simple     mean of each vertex and its neighbors
    sharpen    away from the mean of the neighbors

    The exit code is 3 if smoothing removed more than a tenth of the area.

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
            refuse(f"--{name.split('_')[0]} requires --method {' or '.join(owners[name])}")
    with Progress() as progress:
        return smooth_mesh_file(source, output, method=method, factors=factors, progress=progress, **options)


@click.command("sample-mesh", short_help="Sample points on a mesh.")
@option("--points count=N", COUNT_TYPE, "Number of points.", required=True)
@option("--even", bool, "Evenly spaced points (Poisson disk).")
@option("--triangle-normals", bool, "Use triangle normals.")
@option("--seed=N", SEED_TYPE, "Random seed.", default=0)
@from_cloud_to_cloud(columns=False)
def sample_mesh(source: Path, output: Path, **options: Any) -> Answer:
    """Sample points uniformly on the surface of the mesh IN, and write them to the cloud OUT.

    The exit code is 3 if the mesh has no area.

    \b
    pointloom sample-mesh part.stl part.ply --points 100000
    pointloom sample-mesh part.obj part.pcd --points 5000 --even
    """
    from ..jobs.sample_mesh import sample_mesh_file

    with Progress() as progress:
        return sample_mesh_file(source, output, progress=progress, **options)


@click.command("compare-meshes", short_help="Measure the distances between two meshes.")
@click.argument("first", type=FILE, metavar="A")
@click.argument("second", type=FILE, metavar="B")
@option("--samples=N", COUNT_TYPE, "Number of samples on each mesh.", default=100_000)
@option("--threshold thresholds=A,B,...", Lengths(), "Thresholds of the F-score [m].")
@option("--max-distance limit=M", LENGTH, "Exit code 3 if any distance is larger [m].")
@option("--error-map=OUT", FILE, "Write A, colored by its distance to B.")
@option("--picture=PNG", FILE, "Render A, colored by its distance to B, with a histogram.")
@option("--seed=N", SEED_TYPE, "Random seed.", default=0)
@in_order(DEVICE, UP, JSON, FORCE)
def compare_meshes(
    first: Path, second: Path, error_map: Path | None, picture: Path | None, as_json: bool, force: bool, **options: Any
) -> int:
    """Measure the distances between the surfaces of the meshes A and B in both directions, with exact distances to
    triangles.

    Prints the Chamfer, root-mean-square and Hausdorff distances and the F-score at several thresholds. The exit code is
    3 if a distance exceeds --max-distance, or if the distances indicate different units or coordinate frames. --picture
    requires the extra pointloom[plot].

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
