"""The command `mesh`: a cloud to a surface. Nothing expensive is imported here."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import click

from .cloud_command import Answer, from_cloud_to_cloud
from .console import Progress
from .format_lists import with_lists
from .options import FILE, Number, is_positive, option, refuse

METHODS = ("poisson", "ball", "alpha")

# Options of a single method.
_OWN = {"depth": "poisson", "density_quantile": "poisson", "radii": "ball", "alpha": "alpha"}


class Lengths(click.ParamType):
    """Lengths [m], such as 0.01,0.02,0.04."""

    name = "lengths"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> list[float]:
        try:
            lengths = [float(part) for part in value.split(",")]
        except ValueError:
            lengths = [math.nan]
        if not all(math.isfinite(length) and length > 0 for length in lengths):
            self.fail(f"expected lengths in meters above 0, such as 0.01,0.02, got {value!r}", param, ctx)
        return lengths


class LengthOrAuto(Number):
    """A length [m], or auto."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        return value if value == "auto" else super().convert(value, param, ctx)


QUANTILE_TYPE = Number("a fraction from 0 and below 1", lambda number: 0 <= number < 1)


@click.command(short_help="Reconstruct a surface from a cloud.")
@option("--method", click.Choice(METHODS), "Method, see above.", default="poisson")
@option("--depth=N", click.IntRange(2, 20), "poisson: octree depth. Default: 8.")
@option(
    "--density-quantile=Q",
    QUANTILE_TYPE,
    "poisson: remove this fraction of the vertices, with the lowest density. Default: 0.01 if the surface "
    "extends beyond the points, else 0.",
)
@option("--radii=A,B,...", Lengths(), "ball: radii [m]. Default: from the point spacing.")
@option(
    "--alpha=M|auto",
    LengthOrAuto("a length in meters above 0, or auto", is_positive),
    "alpha: radius [m]. Default: from the point spacing.",
)
@option("--new-normals", bool, "Estimate new normals even if IN has normals.")
@option("--picture=PNG", FILE, "Also render the mesh.")
@from_cloud_to_cloud()
@with_lists
def mesh(source: Path, output: Path, method: str, new_normals: bool, **options: Any) -> Answer:
    """Reconstruct a surface from the cloud IN, and write it to OUT ({meshes}).

    \b
    poisson  smooth closed surface, trimmed far from the points. Requires normals
    ball     ball pivoting: triangles between existing points only. Requires normals
    alpha    alpha shape with one radius. Requires no normals

    Missing normals are estimated and oriented, and the summary reports it. The exit code is 3 if the surface is empty,
    torn or fragmented, if a large part of it disagrees with the points, or if neighboring normals are oriented
    inconsistently.

    \b
    pointloom mesh scan.ply mesh.ply --picture mesh.png
    pointloom mesh scan.ply mesh.ply --depth 9 --density-quantile 0.05
    pointloom mesh scan.ply mesh.obj --method ball --radii 0.005,0.01,0.02
    pointloom mesh scan.ply mesh.stl --method alpha --alpha 0.03
    """
    from ..jobs.mesh import mesh_file

    given = {name: value for name, value in options.items() if not (name in _OWN and value is None)}
    for name, owner in _OWN.items():
        if name in given and owner != method:
            refuse(f"--{name.replace('_', '-')} requires --method {owner}")
    if new_normals and method == "alpha":
        refuse("--new-normals requires --method poisson or ball: alpha needs no normals")
    picture = options["picture"]
    if picture is not None and picture.resolve() == output.resolve():
        refuse(f"--picture is the same file as OUT, {output}; pass another name")
    with Progress() as progress:
        return mesh_file(source, output, method=method, new_normals=new_normals, progress=progress, **given)


COMMANDS = (mesh,)
