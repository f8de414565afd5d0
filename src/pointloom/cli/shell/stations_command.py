"""The command `stations`: registration of terrestrial scans. Nothing expensive is imported here."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from .answer import answer_with
from .console import Progress
from .options import FILE, LENGTH, device_option, force_option, json_option, refuse, refuse_same
from .toolbox import SHARE

LEVEL, ALL = "x,y,z,yaw", "x,y,z,roll,pitch,yaw"


@click.command(short_help="Bring terrestrial scans into one frame, with a survey's report.")
@click.argument("scans", type=FILE, metavar="SCANS.E57")
@click.option("-o", "--output", type=FILE, required=True, metavar="E57", help="Write the scans with the poses found.")
@click.option("--targets", type=FILE, metavar="CSV", help="Targets that stations saw: station, name, x, y, z, sigma.")
@click.option(
    "--control", type=FILE, metavar="CSV", help="Where targets are: name, x, y, z, sigma. Poses are then there."
)
@click.option("--report", type=FILE, metavar="DIR", help="Write report.txt, report.json and plan.png there.")
@click.option(
    "--free",
    default=LEVEL,
    show_default=True,
    metavar="LIST",
    help=f"Motions of each station; {ALL} for scans not level.",
)
@click.option("--no-poses", is_flag=True, help="The poses of the file say nothing: search for all pairs.")
@click.option(
    "--rough", type=LENGTH, metavar="M", help="By how much the poses of the file may be off; 2 m if not given."
)
@click.option("--voxel", "voxel_size", type=LENGTH, metavar="M", help="Thin the scans to voxels of this edge [m].")
@click.option("--overlap", type=SHARE, metavar="SHARE", help="Least overlap of a pair; 0.15 if not given.")
@device_option()
@json_option()
@force_option()
def stations(scans: Path, free: str, no_poses: bool, as_json: bool, force: bool, **options: Any) -> int:
    """Find where the stations of SCANS.E57 (or .ptx) stood, and how well that is known.

    Scans that overlap are registered in pairs, from the poses of the file where it has any. Then all poses are adjusted
    together, with targets and control points. Observations that contradict the rest are taken out and named. The
    report has tables of stations with their standard deviations, of residuals with their tests, of how pairs close
    around, and a plan with ellipses of errors. Tables of targets are text: one row each, a head if you like. The
    station is a scan's name or its number, from 0.

    The exit code is 3 where something was taken out, a station floats free, residuals are larger than said, or nothing
    checks the result. All is written even then. --report needs the extra pointloom[plot].

    \b
    pointloom stations scans.e57 -o registered.e57 --report report
    pointloom stations scans.e57 -o registered.e57 --targets targets.csv --control control.csv --report report
    """
    names = [name.strip() for name in free.split(",")]
    if sorted(names) not in (sorted(LEVEL.split(",")), sorted(ALL.split(","))):
        refuse(f"--free: expected {LEVEL} or {ALL}, got {free!r}")
    refuse_same(output=options["output"], scans=scans, targets=options["targets"], control=options["control"])
    from ..jobs.stations import register_scans

    options |= {"free": names, "use_poses": not no_poses}
    with Progress() as progress:
        report = register_scans(scans, overwrite=force, progress=progress, **options)
    return answer_with(report, str(scans), as_json)


COMMANDS = (stations,)
