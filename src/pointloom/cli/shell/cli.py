"""The command line `pointloom COMMAND`. Commands are implemented in their own modules, loaded on use.

Nothing expensive is imported here, so that `--help` is fast.
"""

from __future__ import annotations

import os
import signal
from pathlib import Path
from types import FrameType
from typing import Any

import click

from ... import __version__  # pyright: ignore[reportMissingImports]
from ...core.escaped_text import escaped
from . import (
    change_command,
    depth_command,
    frame_commands,
    help_commands,
    mesh_command,
    mesh_toolbox,
    registration_commands,
    stations_command,
    texture_command,
    tile_command,
    toolbox,
    video_command,
    view,
)
from .answer import answer_with
from .cloud_command import Answer, from_cloud_to_cloud
from .console import Progress, print_fields, print_json
from .group import ERROR, INTERRUPTED, TERMINATED, CommandLine, exit_code, report_error
from .help_commands import VARIABLE
from .options import FILE, LENGTH, Renamed, columns_option, device_option, force_option, json_option, refuse
from .pipes import RECORDINGS, from_option, open_pipes

_SETTINGS = {"help_option_names": ["-h", "--help"], "max_content_width": 110}

_EPILOG = """\b
Lengths are in meters; for a file whose unit is another one (`pointloom info` says which) in that unit.
Exit codes: 0 done, 1 error, 2 wrong call, 3 done with an unreliable result, 130 interrupted.
POINTLOOM_CPU_THREADS=N shares CPU kernels by N threads.
POINTLOOM_TRACEBACK=1 shows where an error arose.
"""


@click.group("pointloom", cls=CommandLine, context_settings=_SETTINGS, epilog=_EPILOG)
@click.version_option(__version__, "-V", "--version", prog_name="pointloom")
def cli() -> None:
    """Point clouds, scans and RGB-D frames to clouds and meshes, on a GPU or on all CPU cores.

    \b
    pointloom demo                            a trial run that needs no data
    pointloom reconstruct FRAMES -o mesh.ply  a folder of RGB-D frames to a colored mesh
    pointloom track FRAMES -o poses.txt       ... to the path of the camera
    pointloom fuse FRAMES -o mesh.ply         ... with known poses to a mesh
    pointloom video FILE -o mesh.ply          a video, or a folder of pictures, to a colored mesh
    pointloom texture mesh.ply FRAMES -o out.glb           its colors, sharper
    pointloom depth PHOTO --model NET.onnx -o cloud.ply    ... a photograph to a cloud
    pointloom info FILE                       what a file holds
    pointloom view FILES                      how it looks, in the browser or as a picture
    pointloom convert scan.las scan.ply       another format, nothing rounded

    \b
    pointloom clean scan.ply out.ply                       without outliers
    pointloom downsample scan.ply out.ply --voxel 0.05     fewer points
    pointloom crop scan.ply out.ply --box 0 0 0 5 5 2.5    a part of it
    pointloom plane scan.ply floor.ply --distance 0.02     the floor, and where it lies
    pointloom cluster scan.ply out.ply --radius 0.05 --paint  what hangs together
    pointloom mesh scan.ply mesh.ply                       a surface through it

    \b
    pointloom register scan2.ply scan1.ply -o T.txt        one cloud onto another, from any pose
    pointloom multiway SCANS -o poses.log                  all clouds of a folder
    pointloom odometry SCANS -o poses.txt                  the path of a LiDAR
    pointloom evaluate poses.txt truth.txt                 its errors
    pointloom change 2023.laz 2024.laz --picture c.png     what has moved, and what is noise
    pointloom tile plan SURVEY --steps steps.toml -o job   files larger than the memory, tile by tile

    Clouds are read and written as .ply .pcd .npz .xyz .xyzn .xyzrgb .pts .las .laz .e57, with all their attributes;
    .csv, .txt, .asc, .ptx and KITTI's .bin are read. Meshes are .ply .obj .stl .off .glb .gltf. A - stands for
    standard input or output:

    \b
    zcat scan.ply.gz | pointloom clean - - --from ply --to ply | pointloom info - --from ply
    """


for command in (
    *toolbox.COMMANDS,
    *mesh_command.COMMANDS,
    *mesh_toolbox.COMMANDS,
    *frame_commands.COMMANDS,
    *texture_command.COMMANDS,
    *video_command.COMMANDS,
    *depth_command.COMMANDS,
    *registration_commands.COMMANDS,
    *change_command.COMMANDS,
    *stations_command.COMMANDS,
    *view.COMMANDS,
    *tile_command.COMMANDS,
    *help_commands.COMMANDS,
):
    cli.add_command(command)


@cli.command(short_help="Say what files and folders hold.")
@click.argument("files", nargs=-1, required=True, type=FILE, metavar="FILE...")
@from_option()
@columns_option()
@json_option()
def info(files: tuple[Path, ...], read_as: str | None, columns: tuple[str, ...] | None, as_json: bool) -> int:
    """Say what each FILE holds: counts, attributes, bounds, origin, points that are not finite.

    \b
    clouds        .ply .pcd .npz .xyz .xyzn .xyzrgb .pts .csv .txt .asc .bin .las .laz .e57 .ptx
    meshes        .ply .obj .stl .off .glb .gltf
    trajectories  .log .tum .kitti .txt .json
    cameras       .json, .txt of a 3x3 matrix
    models        folders of COLMAP (cameras, images, points3D), .xml of Metashape
    pictures      .png .jpg, depth maps as 16-bit .png or .npy
    data sets     folders of RGB-D frames
    folders       of clouds and meshes, one line each
    recordings    .bag of ROS 1, .db3 and .mcap of ROS 2, and folders of those: their topics

    The origin is the point that positions are counted from in float32 (other than zero for data far from zero).
    The exit code is 3 where a recording is damaged, 1 where a file cannot be read at all.

    \b
    pointloom info scan.ply trajectory.log frames/
    """
    from ..jobs.info import BrokenFile, Description, describe

    reports: list[Description | BrokenFile] = []
    with open_pipes(files, read_as=read_as) as ends:
        for path, source in zip(files, ends.sources, strict=True):
            try:
                with ends.errors_renamed():
                    reports.append(ends.rename(describe(source, columns=columns)))
            except (ValueError, TypeError, OSError) as error:
                reports.append(BrokenFile(str(path), report_error(error)))
    found = [report for report in reports if isinstance(report, Description)]
    broken = [report.broken for report in found if report.broken]
    for error in broken:
        click.echo(escaped(f"error: {error}"), err=True)
    failed = bool(broken) or len(found) < len(reports)
    code = exit_code(warning for report in found for warning in report.warnings)
    if as_json:
        print_json({"command": "info", "files": reports})
        return ERROR if failed else code
    for report in found:
        print_fields(report.fields(), title=f"{report.path}: {report.kind}")
    return ERROR if failed else code


@cli.command(short_help="Check this machine: versions, devices, compilers.")
@json_option()
def doctor(as_json: bool) -> int:
    """Check this machine: versions, cores, GPUs, and a small kernel by each compiler on each device.

    Exit code 3 where CPU kernels fall back to one core, a device fails, or the driver is too old for Warp. The line
    that mends it is shown.

    \b
    pointloom doctor --json
    """
    from .doctor import diagnose

    return answer_with(diagnose(), f"pointloom {__version__}", as_json)


@cli.command(short_help="Write a cloud, mesh or recording in another format.")
@click.option("--topic", metavar="NAME", help="Of a recording: which clouds; the only ones if not given.")
@click.option("--frame", metavar="NAME", help="Of a recording: the frame of tf that its clouds are brought into.")
@click.option("--poses", type=FILE, metavar="POSES", help="Of a recording: a pose a scan, instead of --frame.")
@from_cloud_to_cloud(device=False)
def convert(
    source: Path, output: Path, topic: str | None, frame: str | None, poses: Path | None, **options: Any
) -> Answer:
    """Write the cloud or mesh IN to OUT, whose extension names the format. No value is rounded that OUT can hold.

    \b
    clouds      .ply .pcd .npz .xyz .xyzn .xyzrgb .pts .las .laz .e57, and from .csv .txt .asc .bin .ptx
    meshes      .ply .obj .stl .off .glb .gltf
    recordings  from .bag .mcap .db3 and folders of those: to a folder of scans, or to one cloud

    What OUT cannot hold is left out, and the summary names it. A mesh becomes a cloud of its vertices that way. LAS and
    LAZ hold coordinates in steps: those of IN where it is such a file, else thousandths. An attribute whose name OUT
    cannot hold gets another, and an intensity that LAS cannot hold becomes intensity_value; warnings name them.

    Several scans of a recording become one cloud where --frame or --poses says how they stand to each other. Where the
    recording is damaged what is left is written, and the exit code is 3.

    \b
    pointloom convert scan.las scan.ply
    pointloom convert run.mcap scans --topic /points
    pointloom convert run.mcap map.ply --topic /points --frame odom
    """
    if frame is not None and poses is not None:
        refuse("--frame and --poses both say where scans stand; give one")
    if source.suffix.lower() in RECORDINGS or source.is_dir():
        from ..jobs.recorded_clouds import convert_recording

        options.pop("up")
        if options.pop("columns") is not None:
            refuse("--columns is for a cloud; a recording names its columns")
        return convert_recording(source, output, topic=topic, frame=frame, poses=poses, **options)
    for name, value in (("topic", topic), ("frame", frame), ("poses", poses)):
        if value is not None:
            refuse(f"--{name} goes with a recording, and {source} is none")
    from ..jobs.clouds import convert_file

    return convert_file(source, output, **options)


@cli.command(short_help="Estimate the normals of a cloud.")
@click.option(
    "--radius", type=LENGTH, metavar="M", help="Neighbors lie closer than this [m]; any distance if not given."
)
@click.option(
    "--neighbors",
    "max_nn",
    cls=Renamed,
    old="--max-nn",
    type=click.IntRange(min=3),
    default=30,
    show_default=True,
    metavar="N",
    help="Neighbors at most, itself included.",
)
@click.option("--toward", type=float, nargs=3, metavar="X Y Z", help="Turn normals toward this place, as a scanner's.")
@click.option("--direction", type=float, nargs=3, metavar="X Y Z", help="Turn normals to the side of this direction.")
@from_cloud_to_cloud()
def normals(source: Path, output: Path, **options: Any) -> Answer:
    """Write the cloud IN to OUT with a normal at each point, from the plane through its nearest neighbors.

    Normals keep the side of those that IN has; --toward and --direction choose one.

    \b
    pointloom normals scan.ply out.ply --radius 0.1 --toward 0 0 1.5
    """
    from ..jobs.clouds import estimate_normals_of_file

    if options["toward"] is not None and options["direction"] is not None:
        refuse("--toward and --direction choose different sides; give one")
    return estimate_normals_of_file(source, output, **options)


@cli.command(short_help="Fuse frames of a made-up room; needs no data.")
@click.option(
    "-o",
    "--output",
    "folder",
    type=FILE,
    default="pointloom-demo",
    show_default=True,
    metavar="FOLDER",
    help="Where results go.",
)
@click.option(
    "--frames",
    "frame_count",
    type=click.IntRange(min=1),
    default=120,
    show_default=True,
    metavar="N",
    help="Number of frames.",
)
@click.option(
    "--voxel", "voxel_size", type=LENGTH, default=0.02, show_default=True, metavar="M", help="Edge of a voxel [m]."
)
@click.option(
    "--seed", type=click.IntRange(min=0), default=0, show_default=True, metavar="N", help="Chooses the noise."
)
@click.option("--noise/--no-noise", default=True, help="Depth and pictures as of a camera (default), or exact.")
@device_option()
@json_option()
@force_option()
def demo(folder: Path, as_json: bool, force: bool, **options: Any) -> int:
    """Render a furnished room as RGB-D frames, fuse them, and compare the mesh with the true surface.

    Writes room.ply, room.png and report.json to the folder, which is created if missing.

    \b
    pointloom demo -o demo --frames 60
    """
    from ..jobs.demo import TITLE, run_demo

    with Progress() as progress:
        report = run_demo(folder, **options, overwrite=force, progress=progress)
    return answer_with(report, TITLE, as_json)


def _terminate(number: int, frame: FrameType | None) -> None:
    raise SystemExit(TERMINATED)


def main() -> None:
    """Run the command of the process; termination signals leave no partial files."""
    try:
        if signal.getsignal(signal.SIGINT) is not signal.SIG_IGN:  # as in a script that starts the command with &
            signal.signal(signal.SIGINT, signal.default_int_handler)
        signal.signal(signal.SIGTERM, _terminate)
        if os.environ.get(VARIABLE):
            from . import completion as completion  # registers its shells with click
        cli()
    except KeyboardInterrupt:  # between two commands of click, which handles all others
        click.echo("interrupted", err=True)
        raise SystemExit(INTERRUPTED) from None


if __name__ == "__main__":
    main()
