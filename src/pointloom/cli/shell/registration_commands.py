"""The commands register, multiway, odometry, map and evaluate. Nothing expensive is imported here."""

from __future__ import annotations

import contextlib
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from click.core import ParameterSource

from .answer import answer_with
from .console import Progress
from .format_lists import NUMBERED_OR_KITTI, with_lists, words
from .options import (
    COLUMNS,
    DEVICE,
    FILE,
    FORCE,
    JSON,
    LENGTH,
    POSES,
    Number,
    in_order,
    option,
    record_option,
    refuse,
    refuse_same,
)
from .pipes import FROM, open_pipes
from .toolbox import COUNT_TYPE, FACTOR_TYPE

if TYPE_CHECKING:
    from ...visualization.viewer.viewer import Viewer

STARTS = ("identity", "global")
MOTIONS = ("x", "y", "z", "roll", "pitch", "yaw")
RANGE_TYPE = Number("a distance in meters, 0 or above", lambda number: 0 <= number < float("inf"))


@click.command(short_help="Register one cloud to another.")
@click.argument("source", type=FILE, metavar="A")
@click.argument("target", type=FILE, metavar="B")
@option("-o --output=TXT", FILE, "Write the pose as a 4x4 matrix with all digits.")
@option(
    "--init=global|identity|FILE",
    str,
    "Initial pose: global search, identity, or a file as written by -o.",
    default="global",
)
@option(
    "--method",
    ["point-to-point", "point-to-plane", "symmetric", "generalized", "colored"],
    "Objective of ICP.",
    default="point-to-plane",
)
@option("--voxel voxel_size=M", LENGTH, "Voxel size for downsampling both clouds [m].")
@option("--distance max_correspondence_distance=M", LENGTH, "Maximum correspondence distance [m]. Default: 2 voxels.")
@option("--free=LIST", str, "Free motions of A. For example, x,y,z,yaw keeps A level.")
@option("--prior=FILE", FILE, "Prior pose, in the format of -o.")
@option(
    "--prior-sigma=M DEG",
    (LENGTH, FACTOR_TYPE),
    "Standard deviations of the prior: translation [m], rotation [degrees].",
)
@option("--aligned=FILE", FILE, "Write the aligned cloud A.")
@option("--picture=PNG", FILE, "Render A (orange) and B (blue), before (left) and after (right).")
@record_option("every ICP iteration, A orange and B blue")
@in_order(COLUMNS, DEVICE, FROM, JSON, FORCE)
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
    """Estimate the pose T that registers the cloud A to the cloud B. T transforms coordinates of A to coordinates of
    B.

    Both clouds are downsampled to voxels. --init global searches the initial pose, and ICP refines it. Default of
    --voxel: 1/32 of the radius that contains 3/4 of the points, for the smaller cloud. With a given initial pose and
    without --distance, ICP starts with voxels 4 and 2 times as large. Methods with planes estimate missing normals
    within 3 voxels. One of A and B may be -, standard input.

    --free fixes all unlisted motions of x, y, z, roll, pitch and yaw at their values in --init. A global search of
    level clouds accepts x,y,z,yaw. Motions that the clouds do not determine are constrained by --prior.

    The exit code is 3 if the surfaces hardly coincide (score below 0.5 of 1), or less than 10% of A has a
    correspondence. Poses and images are still written.

    \b
    pointloom register scan2.ply scan1.ply -o T.txt --picture both.png
    pointloom register scan2.ply scan1.ply --init T.txt --voxel 0.02 --aligned moved.ply
    pointloom register scan.ply map.ply --free x,y,z,yaw --init T.txt --prior gnss.txt --prior-sigma 0.05 1
    """
    if init not in STARTS and not Path(init).exists():
        refuse(f"--init: expected global, identity or a pose file, got {init!r}, which does not exist")
    refuse_same(**{name: options[name] for name in ("output", "aligned", "picture")}, record=options["record_as"])
    if (options["prior"] is None) != (options["prior_sigma"] is None):
        refuse("--prior, --prior-sigma: expected both or none, the known pose and its uncertainty")
    free_motions = _motions(free, init)
    from ..jobs.register import MotionLimits, RegisterOutputs, register_files
    from .recording_command import recorded

    options["outputs"] = RegisterOutputs(*(options.pop(name) for name in ("output", "aligned", "picture")))
    options["motions"] = MotionLimits(free_motions, options.pop("prior"), options.pop("prior_sigma"))
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
        refuse(f"--free: expected all six or x,y,z,yaw for a global search, got {free}; others need --init")
    return names


@click.command(short_help="Register all clouds of a folder.")
@click.argument("folder", type=FILE, metavar="DIR")
@option("-o --output=POSES", FILE, POSES, required=True)
@option("--voxel voxel_size=M", LENGTH, "Voxel size for downsampling the clouds [m].")
@option(
    "--loops neighbors=N", COUNT_TYPE, "Register each cloud with the next N. Default: all if at most 40 clouds, else 5."
)
@option("--level", bool, "All clouds are level, as from a leveled scanner.")
@option("--merged=FILE", FILE, "Write all registered clouds as one.")
@option("--graph=JSON", FILE, "Write the pose graph in Open3D's format.")
@option("--job=JOB", FILE, "Job folder, which makes the work resumable. See above.")
@option("--workers=N", COUNT_TYPE, "With --job: number of processes. Default: this process.")
@option("--places=FILE", FILE, "With --job: approximate poses for selecting pairs. See above.")
@option("--place-error=M", LENGTH, "Maximum position error of --places [m].")
@record_option("the pairs and the final poses of the clouds")
@in_order(COLUMNS, DEVICE, JSON, FORCE)
def multiway(folder: Path, output: Path, as_json: bool, force: bool, **options: Any) -> int:
    """Register the clouds of DIR from any poses, and write T_reference_cloud of each.

    The clouds are sorted in natural order (scan2 before scan10). Pairs are registered as by pointloom register --init
    global. A pose graph optimization combines the pairs and rejects inconsistent ones. Default of --voxel: the median
    of the defaults of register. POSES lists each cloud by its number, from 0 (the time in TUM files). The exit code is
    3 if clouds could not be registered. POSES omits them.

    --job is for hundreds of scans. Each pair is a task, and no process loads more than one scan or two downsampled
    scans. Finished tasks remain in JOB after an interruption, and the same command resumes. --job requires --voxel.

    --places is a file of poses in a format of -o, or .kitti or .json with one pose per scan in order. Each scan is
    registered with the 12 (--loops) nearest scans with an overlapping bounding box. Scans with few such pairs are also
    matched by appearance. --json lists the reason for accepting or rejecting each pair.

    \b
    pointloom multiway scans -o poses.log --merged all.ply
    pointloom multiway scans -o poses.log --voxel 0.1 --job job --workers 8 --places gnss.tum --place-error 5
    """
    job, places = options.pop("job"), options.pop("places")
    workers, place_error = options.pop("workers"), options.pop("place_error")
    if job is not None:
        for name, value in (("--merged", options.pop("merged")), ("--record", options.pop("record_as"))):
            if value is not None:
                refuse(f"{name} needs all clouds in memory, which --job does not")
        if options.pop("columns") is not None:
            refuse("--columns is not supported with --job, whose processes use the columns of the files")
        if options["voxel_size"] is None:
            refuse("missing option '--voxel'; --job cannot choose it without reading all scans first")
        if place_error is not None and places is None:
            refuse("--place-error requires --places")
        refuse_same(graph=options["graph"], output=output)
        from ..jobs.multiway_job import register_in_job

        options |= {"places": places, "place_error": place_error or 0.0, "workers": workers or 0}
        with Progress(kept=job) as progress:
            report = register_in_job(folder, output, job, overwrite=force, progress=progress, **options)
        return answer_with(report, str(folder), as_json)
    if not all(value is None for value in (workers, places, place_error)):
        refuse("--workers, --places and --place-error require --job")
    refuse_same(**{name: options[name] for name in ("merged", "graph")}, output=output, record=options["record_as"])
    from ..jobs.multiway import register_folder
    from .recording_command import recorded

    with Progress() as progress:
        report = recorded(register_folder, folder, output, overwrite=force, progress=progress, **options)
    return answer_with(report, str(folder), as_json)


RANGE_OPTIONS = in_order(
    option("--max-range=M", LENGTH, "Maximum range of used points [m].", default=100.0),
    option("--min-range=M", RANGE_TYPE, "Minimum range of used points [m].", default=5.0),
)
TOPIC_OPTIONS = in_order(
    option("--topic=NAME", str, "Recordings: topic of the clouds. Default: the only one with clouds."),
    option("--imu=NAME", str, "Recordings: topic of IMU readings, for the motion between and during scans."),
    COLUMNS,
)


@click.command(short_help="Estimate the trajectory of a LiDAR from its scans.")
@click.argument("folder", type=FILE, metavar="DIR")
@option("-o --output=POSES", FILE, f"The poses, {words(NUMBERED_OR_KITTI)}.", required=True)
@option(
    "--format",
    ["kitti", "tum", "log"],
    "Format. Default: by extension, with kitti for .txt. Times of tum are those of a recording or of times.txt, or "
    "scan numbers.",
)
@option(
    "--voxel voxel_size=M", LENGTH, "Voxel size of the map [m]. Default: 1% of --max-range, more if ranges are noisy."
)
@RANGE_OPTIONS
@option("--truth=FILE", FILE, "True poses of the scanner, one per scan or timed, for printing the errors.")
@TOPIC_OPTIONS
@record_option("each scan with the map and the trajectory")
@in_order(DEVICE, JSON, FORCE)
@with_lists
def odometry(folder: Path, output: Path, as_json: bool, force: bool, **options: Any) -> int:
    """Register the scans of DIR in sequence, and write the pose of each: T_first_scan.

    Scans are .bin files (KITTI's columns, unless --columns is given) or clouds, in natural order (scan2 before scan10).
    DIR may be a sequence of KITTI with the folder velodyne, whose times.txt has the times.
    Scans with point times are deskewed. Indoors use a smaller --max-range and --min-range 0.5.

    The exit code is 3 if a scan did not overlap the earlier ones (its pose is then extrapolated with constant
    velocity), a scan contradicts the map, or ICP did not converge for many scans. The trajectory is then probably
    wrong, and the summary lists the scans.

    DIR may also be a recording, {recordings} or a folder of them. Requires pointloom[ros].
    --imu uses the recorded IMU, which handheld sensors need. Its clock must be that of the clouds, and its pose is the
    static transform to the frame of the clouds, if there is one.

    \b
    pointloom odometry run.mcap --topic /points -o poses.tum
    pointloom odometry run.mcap --topic /points --imu /imu/data -o poses.tum
    pointloom odometry velodyne -o poses.txt
    pointloom odometry velodyne -o poses.kitti --truth truth.txt
    pointloom odometry velodyne -o 00.txt --format kitti
    """
    if options["min_range"] >= options["max_range"]:
        refuse(f"--min-range {options['min_range']:g} leaves nothing within --max-range {options['max_range']:g}")
    refuse_same(output=output, record=options["record_as"])
    options["topics"] = options.pop("topic"), options.pop("imu")
    from ..jobs.odometry import odometry_of_folder
    from .recording_command import recorded

    with Progress(rates=True) as progress:
        report = recorded(odometry_of_folder, folder, output, overwrite=force, progress=progress, **options)
    return answer_with(report, str(folder), as_json)


@click.command("map", short_help="Map the scans of a LiDAR, with loops.")
@click.argument("folder", type=FILE, metavar="DIR")
@option("-o --output=MAP", FILE, "Write the map as a cloud.", required=True)
@option("--trajectory=POSES", FILE, f"Write the corrected poses, {words(NUMBERED_OR_KITTI)}.")
@option("--picture=PNG", FILE, "Plot the map from above with the path and the loops.")
@option("--voxel voxel_size=M", LENGTH, "Voxel size of the odometry [m]. The map has half of it.")
@RANGE_OPTIONS
@option("--submap-length=M", LENGTH, "Path length of a submap [m]. Default: 30% of --max-range.")
@option("--submaps=DIR", FILE, "Write the submaps and their graph to a new folder, for --continue.")
@option("--continue earlier=DIR", FILE, "Continue the map of --submaps with a new session, and write it there.")
@option(
    "--positions=FILE",
    FILE,
    "Positions of GNSS: lines of time x y z [sigma], a TUM trajectory, a recording of NavSatFix, or a topic of these.",
)
@option("--position-sigma=M", LENGTH, "Standard deviation of positions without one [m].", default=1.0)
@option(
    "--crs=SYSTEM", str, "Coordinate system of --positions, such as EPSG:25832. MAP and POSES are then written in it."
)
@option("--show", bool, "Show the map in the browser while it grows. The command then ends with the page.")
@TOPIC_OPTIONS
@record_option("each scan with the map and the trajectory of the odometry")
@in_order(DEVICE, JSON, FORCE)
def map_scans(folder: Path, output: Path, as_json: bool, force: bool, **options: Any) -> int:
    """Register the scans of DIR in sequence, close loops at places that are visited again, and write the map.

    Scans are as of `pointloom odometry`. Their z axis should point up. Consecutive scans form submaps. A pair of
    submaps closes a loop if their surfaces agree in one pose only, and if the drift of the path explains it. Places
    that only look alike are reported and not used.

    Times of --positions are those of the recording [s] or of times.txt, or the numbers of the scans in a folder, from
    0. Their frame is level and of their own: its pose is estimated. Positions that contradict the map are refused.
    The map has the frame of the first scan, or that of the positions with --crs.
    Those of NavSatFix have the times of their headers, their covariances, and a frame of east, north and up. Their
    antenna is where the static transforms of the recording place it.

    --continue maps a second drive in the frame of the first, with its sizes, if three submaps recognize their place.

    The exit code is 3 if the odometry is unreliable, as of `pointloom odometry`, if most positions are refused, or if
    no place of the continued map is recognized. --picture requires pointloom[plot].
    --show prints an address, and opens it if there is a display. All files are written before the command waits.

    \b
    pointloom map velodyne -o map.ply --show
    pointloom map run.mcap -o map.laz --trajectory path.tum --picture map.png
    pointloom map velodyne -o map.ply --max-range 80
    pointloom map first.bag -o first.laz --submaps submaps --positions gnss.csv --crs EPSG:25832
    pointloom map run.mcap -o map.laz --positions /gps/fix
    pointloom map second.bag -o both.laz --continue submaps
    """
    earlier = options.pop("earlier")
    if earlier is not None:
        context = click.get_current_context()
        names = ("voxel_size", "max_range", "min_range", "submap_length", "submaps")
        given = [name for name in names if context.get_parameter_source(name) is ParameterSource.COMMANDLINE]
        if given:
            refuse(f"--{given[0].removesuffix('_size').replace('_', '-')} is that of the map to --continue")
    if options["min_range"] >= options["max_range"]:
        refuse(f"--min-range {options['min_range']:g} leaves nothing within --max-range {options['max_range']:g}")
    if options["crs"] is not None and options["positions"] is None:
        refuse("--crs is the coordinate system of --positions, which is missing")
    refuse_same(
        **{name: options[name] for name in ("trajectory", "picture")}, output=output, record=options["record_as"]
    )
    from ..jobs.map_scans import MapInputs, MapOutputs, map_of_scans
    from .recording_command import recorded

    outputs = MapOutputs(output, *(options.pop(name) for name in ("trajectory", "picture", "submaps")))
    topics = options.pop("topic"), options.pop("imu")
    given = {name: options.pop(name) for name in ("positions", "position_sigma", "crs")}
    options["inputs"] = MapInputs(topics, **given, earlier=earlier)
    with _viewer(folder.name) if options.pop("show") else contextlib.nullcontext() as viewer:
        with Progress(rates=True) as progress:
            options |= {"overwrite": force, "progress": progress, "viewer": viewer}
            report = recorded(map_of_scans, folder, outputs, **options)
        status = answer_with(report, str(folder), as_json)
        if viewer is not None:
            from ...visualization.viewer.draw import wait_for_pages

            wait_for_pages(viewer)
    return status


def _viewer(title: str) -> Viewer:
    from ...visualization.viewer.draw import announce, open_page
    from ...visualization.viewer.viewer import Viewer

    viewer = Viewer(title=title)
    announce(viewer)
    open_page(viewer)
    return viewer


@click.command(short_help="Compare a trajectory with the true one.")
@click.argument("poses", type=FILE, metavar="POSES")
@click.argument("truth", type=FILE, metavar="TRUTH")
@option("--alignment align", ["none", "first", "se3", "sim3"], "Alignment of POSES with TRUTH.", default="se3")
@option(
    "--extrinsic=FILE", FILE, "T_truth_estimate between two sensors of one rig: 4x4 matrix, or KITTI's calib.txt (Tr)."
)
@option("--picture=PNG", FILE, "Plot both trajectories and the error along the path.")
@in_order(JSON, FORCE)
@with_lists
def evaluate(
    poses: Path, truth: Path, align: str, extrinsic: Path | None, picture: Path | None, as_json: bool, force: bool
) -> int:
    """Compute the errors of the trajectory POSES against TRUTH: {trajectories}. The columns of
    a .txt file determine its format, TUM or KITTI.

    Poses are matched by time if both files have times (.tum), else by number. They are aligned by the first pose
    (first), by least squares without scale (se3) or with scale (sim3), or not aligned (none).

    \b
      ATE       distances between aligned positions
      RPE       errors of the motion between consecutive poses
      segments  KITTI's errors over 100 to 800 m of the path, for lengths up to that of the path

    The exit code is 3 if POSES and TRUTH appear to be trajectories of two sensors of one rig, such as a LiDAR and a
    camera. Their motions differ by a fixed transformation: pass it as --extrinsic. --picture requires the extra
    pointloom[plot].

    \b
    pointloom evaluate poses.txt truth.txt --alignment first --picture path.png
    pointloom evaluate lidar.kitti 00.txt --extrinsic calib.txt
    """
    from ..jobs.evaluate import evaluate_files

    report = evaluate_files(poses, truth, align=align, extrinsic=extrinsic, picture=picture, overwrite=force)
    return answer_with(report, f"{poses} against {truth}", as_json)


COMMANDS = (register, multiway, odometry, map_scans, evaluate)
