"""The command `mesh`: a cloud to a surface. Nothing expensive is imported here."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import click

from .cloud_command import Answer, from_cloud_to_cloud
from .console import Progress
from .options import FILE, refuse
from .toolbox import Number

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


class LengthOrAuto(click.ParamType):
    """A length [m], or auto."""

    name = "meters"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float | str:
        if value == "auto":
            return value
        try:
            number = float(value)
        except ValueError:
            number = math.nan
        if not (math.isfinite(number) and number > 0):
            self.fail(f"expected a length in meters above 0, or auto, got {value!r}", param, ctx)
        return number


QUANTILE = Number("a share from 0 and below 1", lambda number: 0 <= number < 1)


@click.command(short_help="Make a surface of a cloud.")
@click.option("--method", type=click.Choice(METHODS), default="poisson", show_default=True, help="How.")
@click.option("--depth", type=click.IntRange(2, 20), metavar="N", help="poisson: depth of the octree; 8 if not given.")
@click.option(
    "--density-quantile",
    type=QUANTILE,
    metavar="Q",
    help="poisson: drop this share of the vertices, where points are fewest; if not given 0.01 where any of "
    "the surface is made up, else none.",
)
@click.option(
    "--radii", type=Lengths(), metavar="A,B,...", help="ball: radii [m]; by the points' spacing if not given."
)
@click.option(
    "--alpha", type=LengthOrAuto(), metavar="M|auto", help="alpha: radius [m]; by the points' spacing if not given."
)
@click.option("--new-normals", is_flag=True, help="Make normals anew, though IN has some.")
@click.option("--picture", type=FILE, metavar="PNG", help="Draw the mesh as well.")
@from_cloud_to_cloud()
def mesh(source: Path, output: Path, method: str, new_normals: bool, **options: Any) -> Answer:
    """Write to OUT (.ply .obj .stl .off .glb .gltf) a surface through the points of the cloud IN.

    \b
    poisson  a smooth closed surface, cut off where it is made up. Needs normals
    ball     triangles between points that a ball rolls over, nothing added. Needs normals
    alpha    the hull of the points as seen by balls of one radius. Needs no normals

    Where IN has no normals they are made and oriented, and the summary says so. The exit code is 3 where the surface
    is empty, torn or in pieces, where much of it lies far from all points, or where neighboring normals point to
    opposite sides.

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
            refuse(f"--{name.replace('_', '-')} goes with --method {owner}")
    if new_normals and method == "alpha":
        refuse("--new-normals goes with --method poisson or ball: alpha needs none")
    picture = options["picture"]
    if picture is not None and picture.resolve() == output.resolve():
        refuse(f"--picture is OUT itself, {output}; give another name")
    with Progress() as progress:
        return mesh_file(source, output, method=method, new_normals=new_normals, progress=progress, **given)


COMMANDS = (mesh,)
