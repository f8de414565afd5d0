"""The command `change`: change between two surveys. Nothing expensive is imported here."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from .answer import answer_with
from .console import Progress
from .mesh_command import Lengths
from .mesh_toolbox import ANY
from .options import COLUMNS, DEVICE, FILE, FORCE, JSON, LENGTH, in_order, option, refuse, refuse_same
from .registration_commands import RANGE_TYPE

_MEASURE = ("cores", "normal_radii", "cylinder_radius", "max_distance", "registration_error", "orientation")


@click.command(short_help="Measure change between two surveys.")
@click.argument("earlier", type=FILE, metavar="A")
@click.argument("later", type=FILE, metavar="B")
@option("-o --output=OUT", FILE, "Write the core points with their distances.")
@option("--picture=PNG", FILE, "Render the distances: blue to red, gray if not significant.")
@option("--report=HTML", FILE, "Page with the figures, the failed checks and the picture.")
@option("--painted=FILE", FILE, "Write the points in the colors of --picture.")
@option("--cores=M", LENGTH, "Cell size of core points [m]. Default: all points.")
@option("--normals normal_radii=M,...", Lengths(), "Radii of normal estimation [m].")
@option("--cylinder cylinder_radius=M", LENGTH, "Radius of the cylinders [m].")
@option("--max-distance=M", LENGTH, "Length of the cylinders to each side [m].")
@option("--registration-error=M", RANGE_TYPE, "Registration error between A and B [m].", default=0.0)
@option("--toward orientation=X Y Z", ANY, "Direction of positive distances.", nargs=3, default=(0.0, 0.0, 1.0))
@option("--limit=M", LENGTH, "Limit of the color scale [m]. Default: from the data.")
@in_order(COLUMNS, DEVICE, JSON, FORCE)
def change(earlier: Path, later: Path, as_json: bool, force: bool, **options: Any) -> int:
    """Measure the displacement of the surface from A to B, and test its significance.

    Two clouds are compared by M3C2. The distance is measured along the normals of A, between the means of both clouds
    within cylinders. The level of detection is computed from their standard deviations and point counts. If A is a mesh
    (design or model), B is compared point by point, or by means with --cylinder. For clouds, the default of --cylinder
    is the radius within which half of the points of A have 20 neighbors. Normals then use 1, 2 and 4 times this radius,
    and cylinders extend by 6 times this radius.

    The exit code is 3 if A and B hardly overlap, or if nearly all points moved in the same direction, which indicates
    that A and B are not registered.

    \b
    pointloom change 2023.laz 2024.laz -o change.laz --picture change.png --cores 1 --registration-error 0.02
    pointloom change design.ply scan.ply --picture deviation.png --limit 0.05
    """
    if not any(options["orientation"]):
        refuse("--toward: expected a direction, got 0 0 0")
    refuse_same(**{name: options[name] for name in ("output", "picture", "painted", "report")})
    from ..jobs.change import ChangeMeasure, ChangeOutputs, change_files

    options["outputs"] = ChangeOutputs(
        *(options.pop(name) for name in ("output", "painted", "picture", "report", "limit"))
    )
    options["measure"] = ChangeMeasure(**{name: options.pop(name) for name in _MEASURE})
    with Progress() as progress:
        report = change_files(earlier, later, overwrite=force, progress=progress, **options)
    return answer_with(report, f"{earlier} to {later}", as_json)


COMMANDS = (change,)
