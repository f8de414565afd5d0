"""The command `stations`: registration of terrestrial scans. Nothing expensive is imported here."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from .answer import answer_with
from .console import Progress
from .options import FILE, LENGTH, device_option, force_option, json_option, refuse, refuse_same
from .toolbox import FRACTION_TYPE

LEVEL, ALL = "x,y,z,yaw", "x,y,z,roll,pitch,yaw"


@click.command(short_help="Register terrestrial scans, with a survey report.")
@click.argument("scans", type=FILE, metavar="SCANS.E57")
@click.option(
    "-o", "--output", type=FILE, required=True, metavar="E57", help="Write the scans with the estimated poses."
)
@click.option("--targets", type=FILE, metavar="CSV", help="Observed targets: station, name, x, y, z, sigma.")
@click.option(
    "--control",
    type=FILE,
    metavar="CSV",
    help="Control points: name, x, y, z, sigma. They define the coordinate frame.",
)
@click.option("--report", type=FILE, metavar="DIR", help="Folder for report.txt, report.json and plan.png.")
@click.option(
    "--free",
    default=LEVEL,
    show_default=True,
    metavar="LIST",
    help=f"Free motions of each station; {ALL} if scans are not level.",
)
@click.option("--no-poses", is_flag=True, help="Ignore the poses of the file, and search all pairs globally.")
@click.option("--rough", type=LENGTH, metavar="M", help="Maximum error of the poses of the file [m]. Default: 2.")
@click.option("--voxel", "voxel_size", type=LENGTH, metavar="M", help="Voxel size for downsampling the scans [m].")
@click.option("--overlap", type=FRACTION_TYPE, metavar="FRACTION", help="Minimum overlap of a pair. Default: 0.15.")
@device_option()
@json_option()
@force_option()
def stations(scans: Path, free: str, no_poses: bool, as_json: bool, force: bool, **options: Any) -> int:
    """Estimate the poses of the stations of SCANS.E57 (or .ptx) and their accuracy.

    Overlapping scans are registered in pairs, starting from the poses of the file, if any. All poses are then adjusted
    together with targets and control points. Inconsistent observations are removed and listed. The report has tables of
    the stations with standard deviations, of the residuals with tests, and of the loop closure errors of pairs, and a
    plan with error ellipses. Tables of targets are text files with one row each and an optional header. A station is
    identified by the name or the number of the scan, from 0.

    The exit code is 3 if observations were removed, a station is not connected, residuals exceed the given accuracy, or
    there is no redundancy. All outputs are still written. --report requires the extra pointloom[plot].

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
