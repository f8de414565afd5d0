"""The command `stations`: registration of terrestrial scans. Nothing expensive is imported here."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from .answer import answer_with
from .console import Progress
from .options import DEVICE, FILE, FORCE, JSON, LENGTH, in_order, option, refuse, refuse_same
from .toolbox import FRACTION_TYPE

LEVEL, ALL = "x,y,z,yaw", "x,y,z,roll,pitch,yaw"


@click.command(short_help="Register terrestrial scans, with a survey report.")
@click.argument("scans", type=FILE, metavar="SCANS.E57")
@option("-o --output=E57", FILE, "Write the scans with the estimated poses.", required=True)
@option("--targets=CSV", FILE, "Observed targets: station, name, x, y, z, sigma.")
@option("--control=CSV", FILE, "Control points: name, x, y, z, sigma. They define the coordinate frame.")
@option("--report=DIR", FILE, "Folder for report.html, report.txt, report.json and plan.png.")
@option("--free=LIST", str, f"Free motions of each station; {ALL} if scans are not level.", default=LEVEL)
@option("--no-poses", bool, "Ignore the poses of the file, and search all pairs globally.")
@option("--rough=M", LENGTH, "Maximum error of the poses of the file [m]. Default: 2.")
@option("--voxel voxel_size=M", LENGTH, "Voxel size for downsampling the scans [m].")
@option("--overlap=FRACTION", FRACTION_TYPE, "Minimum overlap of a pair. Default: 0.15.")
@in_order(DEVICE, JSON, FORCE)
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
