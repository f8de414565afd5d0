"""The commands register, multiway, odometry and evaluate. Nothing expensive is imported here."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from .answer import answer_with
from .console import Progress
from .options import (
    FILE,
    LENGTH,
    POSES,
    Renamed,
    columns_option,
    device_option,
    force_option,
    json_option,
    record_option,
    refuse,
    refuse_same,
)
from .pipes import from_option, open_pipes
from .toolbox import COUNT, FACTOR, Number

STARTS = ("identity", "global")
MOTIONS = ("x", "y", "z", "roll", "pitch", "yaw")
RANGE = Number("a distance in meters, 0 or above", lambda number: 0 <= number < float("inf"))


@click.command(short_help="Bring one cloud onto another.")
@click.argument("source", type=FILE, metavar="A")
@click.argument("target", type=FILE, metavar="B")
@click.option("-o", "--output", type=FILE, metavar="TXT", help="Write the pose: four rows of four numbers, all digits.")
@click.option(
    "--init",
    default="global",
    show_default=True,
    metavar="global|identity|FILE",
    help="Where to begin: search, as the clouds lie, or a file as -o writes it.",
)
@click.option(
    "--method",
    type=click.Choice(["point-to-point", "point-to-plane", "symmetric", "generalized", "colored"]),
    default="point-to-plane",
    show_default=True,
    help="What ICP brings together.",
)
@click.option("--voxel", "voxel_size", type=LENGTH, metavar="M", help="Thin both to voxels of this edge [m].")
@click.option(
    "--distance",
    "max_correspondence_distance",
    type=LENGTH,
    metavar="M",
    help="Correspondences lie closer than this [m]; 2 voxels if not given.",
)
@click.option("--free", metavar="LIST", help="Move A in these ways alone: x,y,z,yaw keeps it level.")
@click.option("--prior", type=FILE, metavar="FILE", help="A pose that is known beforehand, as -o writes it.")
@click.option(
    "--prior-sigma",
    type=(LENGTH, FACTOR),
    metavar="M DEG",
    help="How well: standard deviations of its translation [m] and rotation [degrees].",
)
@click.option("--aligned", type=FILE, metavar="FILE", help="Write the cloud A where it lies on B.")
@click.option("--picture", type=FILE, metavar="PNG", help="Draw A orange and B blue, before (left) and after (right).")
@record_option("every step of ICP, A orange and B blue")
@columns_option()
@device_option()
@from_option()
@json_option()
@force_option()
def register(
    source: Path,
    target: Path,
    init: str,
    free: str | None,
    read_as: str | None,
    as_json: bool,
    force: bool,
    **options: Any,
) -> int:
    """Find the pose that brings the cloud A onto the cloud B: B's coordinates of a point are T times A's.

    Both are thinned to voxels; --init global then finds a start whatever their poses, and ICP refines it. Without
    --voxel the edge is a 32nd of the distance from the middle within which 3 of 4 points lie, of the smaller cloud.
    From a start that was given, ICP begins with voxels 4 and 2 times as large, unless --distance is given too.
    Methods to planes estimate the normals of clouds that have none, within 3 voxels. One of A and B may be -, standard
    input. --free fixes all motions that it does not name, of x, y, z, roll, pitch and yaw, as --init has them. A search
    takes x,y,z,yaw of level clouds. What the clouds do not determine is held at --prior.

    The exit code is 3 where the surfaces hardly lie on each other (a score below 0.5 of 1), or less than 10 % of A
    has a correspondence. Poses and pictures are written even then.

    \b
    pointloom register scan2.ply scan1.ply -o T.txt --picture both.png
    pointloom register scan2.ply scan1.ply --init T.txt --voxel 0.02 --aligned moved.ply
    pointloom register scan.ply map.ply --free x,y,z,yaw --init T.txt --prior gnss.txt --prior-sigma 0.05 1
    """
    if init not in STARTS and not Path(init).exists():
        refuse(f"--init: expected global, identity or a file of a pose, got {init!r}, which is no file")
    refuse_same(**{name: options[name] for name in ("output", "aligned", "picture")}, record=options["record_as"])
    if (options["prior"] is None) != (options["prior_sigma"] is None):
        refuse("--prior, --prior-sigma: a pose that is known, and how well, are given together")
    options["free"] = _motions(free, init)
    from ..jobs.register import register_files
    from .recording_command import recorded

    with open_pipes([source, target], read_as=read_as) as ends, Progress() as progress:
        report = recorded(register_files, *ends.sources, init=init, overwrite=force, progress=progress, **options)
    return answer_with(ends.rename(report), f"{source} onto {target}", as_json)


def _motions(free: str | None, init: str) -> list[str] | None:
    if free is None:
        return None
    names = [name.strip() for name in free.split(",")]
    wrong = next((name for name in names if name not in MOTIONS or names.count(name) > 1), None)
    if wrong is not None:
        refuse(f"--free: expected motions among {', '.join(MOTIONS)}, each once, got {wrong!r}")
    if init == "global" and set(names) not in ({"x", "y", "z", "yaw"}, set(MOTIONS)):
        refuse(f"--free: a search is of all six motions or of x,y,z,yaw, got {free}; --init takes any")
    return names


@click.command(short_help="Bring all clouds of a folder into one frame.")
@click.argument("folder", type=FILE, metavar="DIR")
@click.option("-o", "--output", type=FILE, required=True, metavar="POSES", help=POSES)
@click.option("--voxel", "voxel_size", type=LENGTH, metavar="M", help="Thin the clouds to voxels of this edge [m].")
@click.option(
    "--loops",
    "neighbors",
    type=COUNT,
    metavar="N",
    help="Try each cloud with the N after it; all of up to 40 clouds, else 5, if not given.",
)
@click.option("--level", is_flag=True, help="All clouds are level, as of a leveled scanner: none is tilted.")
@click.option("--merged", type=FILE, metavar="FILE", help="Write all clouds that could be placed as one.")
@click.option("--graph", type=FILE, metavar="JSON", help="Write the pose graph, as Open3D's .json.")
@click.option("--job", type=FILE, metavar="JOB", help="Work by a folder that the same command goes on with. See above.")
@click.option("--workers", type=COUNT, metavar="N", help="With --job: N processes; this one if not given.")
@click.option(
    "--places", type=FILE, metavar="FILE", help="With --job: rough poses, which say what pairs are tried. See above."
)
@click.option("--place-error", type=LENGTH, metavar="M", help="How far positions of --places may be off [m].")
@record_option("the pairs that are tried, and where the clouds end up")
@columns_option()
@device_option()
@json_option()
@force_option()
def multiway(folder: Path, output: Path, as_json: bool, force: bool, **options: Any) -> int:
    """Find where the clouds of DIR lie on each other, from any poses, and write T_reference_cloud of each.

    They are taken in natural order (scan2 before scan10). Pairs are registered as by pointloom register --init global.
    A pose graph weighs them against each other and drops those that contradict the rest. Without --voxel the edge is
    the median of those that register would choose. POSES names each cloud by its number, from 0 (TUM's time), and
    leaves out those that could not be placed; there are such where the exit code is 3.

    --job is for hundreds of scans: a pair is a task, no process holds more than one scan or two thinned ones, and what
    is done stays in JOB when anything ends. --voxel is needed then. --places is a file of poses as -o writes it, or
    .kitti and .json with one for each scan in order: each scan is tried with the 12 (--loops) nearest whose boxes meet
    its own, and scans that hang with few by what they look like. --json lists why each pair was accepted or rejected.

    \b
    pointloom multiway scans -o poses.log --merged all.ply
    pointloom multiway scans -o poses.log --voxel 0.1 --job job --workers 8 --places gnss.tum --place-error 5
    """
    job, places = options.pop("job"), options.pop("places")
    workers, place_error = options.pop("workers"), options.pop("place_error")
    if job is not None:
        for name, value in (("--merged", options.pop("merged")), ("--record", options.pop("record_as"))):
            if value is not None:
                refuse(f"{name} holds all clouds in memory, which --job does not")
        if options.pop("columns") is not None:
            refuse("--columns does not go with --job, whose processes read the files by their own columns")
        if options["voxel_size"] is None:
            refuse("missing option '--voxel'; --job does not choose it, as it would read all scans before")
        if place_error is not None and places is None:
            refuse("--place-error goes with --places")
        refuse_same(graph=options["graph"], output=output)
        from ..jobs.multiway_job import place_scans

        options |= {"places": places, "place_error": place_error or 0.0, "workers": workers or 0}
        with Progress() as progress:
            report = place_scans(folder, output, job, overwrite=force, progress=progress, **options)
        return answer_with(report, str(folder), as_json)
    if not all(value is None for value in (workers, places, place_error)):
        refuse("--workers, --places and --place-error go with --job")
    refuse_same(**{name: options[name] for name in ("merged", "graph")}, output=output, record=options["record_as"])
    from ..jobs.multiway import register_folder
    from .recording_command import recorded

    with Progress() as progress:
        report = recorded(register_folder, folder, output, overwrite=force, progress=progress, **options)
    return answer_with(report, str(folder), as_json)


@click.command(short_help="Find the path of a LiDAR from its scans.")
@click.argument("folder", type=FILE, metavar="DIR")
@click.option("-o", "--output", type=FILE, required=True, metavar="POSES", help=f"{POSES[:-1]}, .kitti.")
@click.option(
    "--format",
    type=click.Choice(["kitti", "tum", "log"]),
    help="By the extension if not given; kitti for .txt too. Times of tum are the scans' numbers.",
)
@click.option(
    "--voxel", "voxel_size", type=LENGTH, metavar="M", help="Edge of the map's voxels [m]; 1 % of --max-range."
)
@click.option(
    "--max-range", type=LENGTH, default=100.0, show_default=True, metavar="M", help="Farther points do not count [m]."
)
@click.option(
    "--min-range", type=RANGE, default=5.0, show_default=True, metavar="M", help="Nearer points do not count [m]."
)
@click.option("--truth", type=FILE, metavar="FILE", help="The scanner's true poses: print the errors.")
@click.option("--topic", metavar="NAME", help="Of a recording: which clouds; the only ones if not given.")
@columns_option()
@record_option("scan after scan with the map and the path")
@device_option()
@json_option()
@force_option()
def odometry(folder: Path, output: Path, as_json: bool, force: bool, **options: Any) -> int:
    """Register the scans of DIR one after another, and write the pose of each: T_first_scan.

    Scans are .bin files (columns as KITTI has them, unless --columns names others), or clouds, in natural order (scan2
    before scan10); those whose points have times are straightened. Indoors take a smaller --max-range, and
    --min-range 0.5. The exit code is 3 where a scan did not overlap those before it (its pose is then that of constant
    velocity), where one lies beside the map of those before it, or where many did not come to rest: the path is then
    likely lost, and the summary names the scans.

    DIR may be a recording too: a .bag of ROS 1, a .db3 or .mcap file, or a folder of those, with pointloom[ros].

    \b
    pointloom odometry run.mcap --topic /points -o poses.tum
    pointloom odometry velodyne -o poses.txt
    pointloom odometry velodyne -o poses.kitti --truth truth.txt
    pointloom odometry velodyne -o 00.txt --format kitti
    """
    if options["min_range"] >= options["max_range"]:
        refuse(f"--min-range {options['min_range']:g} leaves nothing within --max-range {options['max_range']:g}")
    refuse_same(output=output, record=options["record_as"])
    from ..jobs.odometry import odometry_of_folder
    from .recording_command import recorded

    with Progress(rates=True) as progress:
        report = recorded(odometry_of_folder, folder, output, overwrite=force, progress=progress, **options)
    return answer_with(report, str(folder), as_json)


@click.command(short_help="Hold a trajectory against the true one.")
@click.argument("poses", type=FILE, metavar="POSES")
@click.argument("truth", type=FILE, metavar="TRUTH")
@click.option(
    "--alignment",
    "align",
    cls=Renamed,
    old="--align",
    type=click.Choice(["none", "first", "se3", "sim3"]),
    default="se3",
    show_default=True,
    help="How POSES are brought onto TRUTH.",
)
@click.option(
    "--extrinsic",
    type=FILE,
    metavar="FILE",
    help="T_truth_estimate of two sensors of one body: a 4x4 matrix, or KITTI's calib.txt (Tr).",
)
@click.option("--picture", type=FILE, metavar="PNG", help="Draw both paths, and the error along the way.")
@json_option()
@force_option()
def evaluate(
    poses: Path, truth: Path, align: str, extrinsic: Path | None, picture: Path | None, as_json: bool, force: bool
) -> int:
    """Print how far the trajectory POSES lies from TRUTH: .log, .tum, .kitti, .json, or .txt (TUM or KITTI by columns).

    Poses belong together by time where both files have times (.tum), else by number. They are aligned not at all, by
    the first pose, or in least squares without (se3) or with a scale (sim3).

    \b
      ATE       distances of the aligned positions
      RPE       errors of the motions from each pose to the next
      segments  errors over 100 to 800 m of the path as KITTI has them, for those lengths that the path has

    The exit code is 3 where POSES and TRUTH are the paths of two sensors of one body, such as a LiDAR and a camera:
    their motions differ by a fixed offset, which --extrinsic takes. --picture needs the extra pointloom[plot].

    \b
    pointloom evaluate poses.txt truth.txt --alignment first --picture path.png
    pointloom evaluate lidar.kitti 00.txt --extrinsic calib.txt
    """
    from ..jobs.evaluate import evaluate_files

    report = evaluate_files(poses, truth, align=align, extrinsic=extrinsic, picture=picture, overwrite=force)
    return answer_with(report, f"{poses} against {truth}", as_json)


COMMANDS = (register, multiway, odometry, evaluate)
