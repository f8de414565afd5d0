"""The command `change`: change between two surveys. Nothing expensive is imported here."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from .answer import answer_with
from .console import Progress
from .mesh_command import Lengths
from .mesh_toolbox import ANY
from .options import FILE, LENGTH, columns_option, device_option, force_option, json_option, refuse, refuse_same
from .registration_commands import RANGE


@click.command(short_help="Measure what has moved between two surveys.")
@click.argument("earlier", type=FILE, metavar="A")
@click.argument("later", type=FILE, metavar="B")
@click.option("-o", "--output", type=FILE, metavar="OUT", help="Write the points measured at, with their distances.")
@click.option("--picture", type=FILE, metavar="PNG", help="Draw them: blue to red, gray where it is noise.")
@click.option("--painted", type=FILE, metavar="FILE", help="Write them in the colors of the picture.")
@click.option("--cores", type=LENGTH, metavar="M", help="Measure at one point a cell of this edge [m]; else at all.")
@click.option(
    "--normals", "normal_radii", type=Lengths(), metavar="M,...", help="Radii that normals are fitted in [m]."
)
@click.option("--cylinder", "cylinder_radius", type=LENGTH, metavar="M", help="Radius of the cylinders [m].")
@click.option("--max-distance", type=LENGTH, metavar="M", help="How far they reach to either side [m].")
@click.option(
    "--registration-error", type=RANGE, default=0.0, show_default=True, metavar="M",
    help="Of A and B against each other [m].",
)  # fmt: skip
@click.option(
    "--toward", "orientation", type=ANY, nargs=3, default=(0.0, 0.0, 1.0), show_default=True, metavar="X Y Z",
    help="Distances are positive to this side.",
)  # fmt: skip
@click.option("--limit", type=LENGTH, metavar="M", help="The distance of the darkest colors [m]; fitted if not given.")
@columns_option()
@device_option()
@json_option()
@force_option()
def change(earlier: Path, later: Path, as_json: bool, force: bool, **options: Any) -> int:
    """Measure how far the surface of A has moved by the time of B, and tell what of that is noise.

    Two clouds are compared by M3C2: along the normals of A, by the means of both within cylinders, with a level of
    detection from their spreads and numbers. Where A is a mesh, a design or a model, B is held against it point by
    point, or with --cylinder by means. Without --cylinder half of A's points have 20 neighbors within it, normals are
    of 1, 2 and 4 times its radius, and cylinders reach 6 times as far.

    The exit code is 3 where the two hardly overlap, or nearly all points have moved one way, as they do where A and B
    are not registered.

    \b
    pointloom change 2023.laz 2024.laz -o change.laz --picture change.png --cores 1 --registration-error 0.02
    pointloom change design.ply scan.ply --picture deviation.png --limit 0.05
    """
    if not any(options["orientation"]):
        refuse("--toward: expected a direction, got 0 0 0")
    refuse_same(**{name: options[name] for name in ("output", "picture", "painted")})
    from ..jobs.change import change_files

    with Progress() as progress:
        report = change_files(earlier, later, overwrite=force, progress=progress, **options)
    return answer_with(report, f"{earlier} to {later}", as_json)


COMMANDS = (change,)
