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
from ...core.paths import RECORDINGS
from . import (
    change_command,
    depth_command,
    frame_commands,
    help_commands,
    mesh_command,
    mesh_toolbox,
    registration_commands,
    stations_command,
    survey_commands,
    texture_command,
    tile_command,
    toolbox,
    video_command,
    view,
)
from .answer import answer_with
from .cloud_command import Answer, from_cloud_to_cloud
from .console import Progress, print_fields, print_json
from .format_lists import with_lists
from .group import ERROR_CODE, INTERRUPTED_CODE, TERMINATED_CODE, CommandLine, exit_code, report_error
from .help_commands import VARIABLE
from .options import COLUMNS, DEVICE, FILE, FORCE, JSON, LENGTH, in_order, option, refuse
from .pipes import FROM, open_pipes

_CONTEXT_SETTINGS = {"help_option_names": ["-h", "--help"], "max_content_width": 110}

_EPILOG = """\b
Lengths are in meters, or in the unit of the file if it has another one (`pointloom info` prints it).
Exit codes: 0 success, 1 error, 2 usage error, 3 success with an unreliable result, 130 interrupted.
POINTLOOM_CPU_THREADS=N runs CPU kernels on N threads.
POINTLOOM_TRACEBACK=1 prints the traceback of an error.
"""


@click.group("pointloom", cls=CommandLine, context_settings=_CONTEXT_SETTINGS, epilog=_EPILOG)
@click.version_option(__version__, "-V", "--version", prog_name="pointloom")
@with_lists
def cli() -> None:
    """Process point clouds, meshes, scans and RGB-D frames on a GPU or on all CPU cores.

    \b
    pointloom demo                            test run that needs no data
    pointloom reconstruct FRAMES -o mesh.ply  RGB-D frames to a colored mesh
    pointloom track FRAMES -o poses.txt       RGB-D frames to a camera trajectory
    pointloom fuse FRAMES -o mesh.ply         RGB-D frames with known poses to a mesh
    pointloom video FILE -o mesh.ply          a video or a folder of images to a colored mesh
    pointloom texture mesh.ply FRAMES -o out.glb           RGB-D frames to a mesh texture
    pointloom depth PHOTO --model NET.onnx -o cloud.ply    a photograph to a cloud
    pointloom info FILE                       describe the content of a file
    pointloom view FILES                      show files in the browser or render an image
    pointloom convert scan.las scan.ply       convert to another format without rounding

    \b
    pointloom clean scan.ply out.ply                       remove outliers
    pointloom downsample scan.ply out.ply --voxel 0.05     reduce the number of points
    pointloom crop scan.ply out.ply --box 0 0 0 5 5 2.5    crop to a box
    pointloom plane scan.ply floor.ply --distance 0.02     segment the largest plane
    pointloom cluster scan.ply out.ply --radius 0.05 --paint  segment into clusters
    pointloom mesh scan.ply mesh.ply                       reconstruct a surface
    pointloom transform scan.ply out.ply --pose T.txt      move, scale, change unit or coordinate system
    pointloom merge a.laz b.laz -o both.laz                merge clouds
    pointloom split tile.laz -o parts --by classification  split by an attribute or by cells
    pointloom ground tile.laz ground.laz                   classify the ground
    pointloom dtm ground.laz -o dtm.tif --cell 0.5         terrain model as GeoTIFF
    pointloom contours dtm.tif -o lines.gpkg --interval 1  contour lines
    pointloom volume before.laz after.laz --cell 1         volumes of cut and fill

    \b
    pointloom register scan2.ply scan1.ply -o T.txt        register two clouds, from any pose
    pointloom multiway SCANS -o poses.log                  register all clouds of a folder
    pointloom odometry SCANS -o poses.txt                  LiDAR odometry
    pointloom map SCANS -o map.laz                         LiDAR map with closed loops
    pointloom evaluate poses.txt truth.txt                 trajectory errors
    pointloom change 2023.laz 2024.laz --picture c.png     detect significant change
    pointloom tile plan SURVEY --steps steps.toml -o job   process files larger than memory in tiles

    Clouds are read and written as {written clouds}, with all attributes that the format can store, and read from
    {read-only clouds} (KITTI's .bin). Meshes are {meshes}. The file name - is standard input or output:

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
    *survey_commands.COMMANDS,
    *view.COMMANDS,
    *tile_command.COMMANDS,
    *help_commands.COMMANDS,
):
    cli.add_command(command)


@cli.command(short_help="Describe the content of files and folders.")
@click.argument("files", nargs=-1, required=True, type=FILE, metavar="FILE...")
@in_order(FROM, COLUMNS, JSON)
@with_lists
def info(files: tuple[Path, ...], read_as: str | None, columns: tuple[str, ...] | None, as_json: bool) -> int:
    """Describe the content of each FILE: counts, attributes, bounds, origin, non-finite points.

    \b
    clouds        {clouds}
    meshes        {meshes}
    trajectories  {trajectories}
    cameras       .json, .txt with a 3x3 matrix
    models        COLMAP folders (cameras, images, points3D), Metashape .xml
    images        {images}
    depth maps    {depth maps} (16-bit .png)
    datasets      folders of RGB-D frames
    folders       of clouds and meshes, one line each
    recordings    {recordings} and folders of them: their topics

    The origin is the reference point of float32 positions. It is nonzero for data far from zero. The exit code is 3 if
    a recording is damaged, and 1 if a file cannot be read.

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
    descriptions = [report for report in reports if isinstance(report, Description)]
    broken = [report.broken for report in descriptions if report.broken]
    for error in broken:
        click.echo(escaped(f"error: {error}"), err=True)
    failed = bool(broken) or len(descriptions) < len(reports)
    code = exit_code(warning for report in descriptions for warning in report.warnings)
    if as_json:
        print_json({"command": "info", "files": reports})
        return ERROR_CODE if failed else code
    for report in descriptions:
        print_fields(report.fields(), title=f"{report.path}: {report.kind}")
    return ERROR_CODE if failed else code


@cli.command(short_help="Check this machine: versions, devices, compilers.")
@JSON
def doctor(as_json: bool) -> int:
    """Check this machine: versions, cores, GPUs, and a small kernel of each compiler on each device.

    The exit code is 3 if CPU kernels fall back to one core, a device fails, or the driver is too old for Warp. The
    command that fixes the problem is printed.

    \b
    pointloom doctor --json
    """
    from .doctor import diagnose

    return answer_with(diagnose(), f"pointloom {__version__}", as_json)


@cli.command(short_help="Convert a cloud, mesh or recording to another format.")
@option("--topic=NAME", str, "Recordings: topic of the clouds. Default: the only one with clouds.")
@option("--frame=NAME", str, "Recordings: tf frame into which the clouds are transformed.")
@option("--poses=POSES", FILE, "Recordings: file with one pose per scan, instead of --frame.")
@from_cloud_to_cloud(device=False)
@with_lists
def convert(
    source: Path, output: Path, topic: str | None, frame: str | None, poses: Path | None, **options: Any
) -> Answer:
    """Convert the cloud or mesh IN to OUT. The extension of OUT defines the format.

    \b
    clouds      {written clouds}
    read only   {read-only clouds}
    meshes      {meshes}
    recordings  from {recordings} and folders of them: to a folder of scans, or to one cloud

    Values are rounded only if the format of OUT requires it. Data that it does not support is omitted, and the summary
    lists it. For example, a mesh written to a cloud format becomes a cloud of its vertices. LAS and LAZ store
    coordinates in fixed steps: the steps of IN if IN is LAS or LAZ, else 0.001. An attribute with an unsupported name
    is renamed. An intensity that LAS cannot store is written as intensity_value. Both cause a warning.

    The scans of a recording are merged into one cloud if --frame or --poses defines their poses. If the recording is
    damaged, the readable part is written and the exit code is 3.

    \b
    pointloom convert scan.las scan.ply
    pointloom convert run.mcap scans --topic /points
    pointloom convert run.mcap map.ply --topic /points --frame odom
    """
    if frame is not None and poses is not None:
        refuse("--frame and --poses both define the positions of the scans; pass one of them")
    if source.suffix.lower() in RECORDINGS or source.is_dir():
        from ..jobs.recorded_clouds import convert_recording

        options.pop("up")
        if options.pop("columns") is not None:
            refuse("--columns is for clouds; a recording defines its columns")
        return convert_recording(source, output, topic=topic, frame=frame, poses=poses, **options)
    for name, value in (("topic", topic), ("frame", frame), ("poses", poses)):
        if value is not None:
            refuse(f"--{name} requires a recording, got {source}")
    from ..jobs.clouds import convert_file

    return convert_file(source, output, **options)


@cli.command(short_help="Estimate the normals of a cloud.")
@option("--radius=M", LENGTH, "Maximum distance of neighbors [m]. Default: unlimited.")
@option(
    "--neighbors max_nn=N",
    click.IntRange(min=3),
    "Maximum number of neighbors, including the point itself.",
    default=30,
)
@option("--toward=X Y Z", float, "Orient normals toward this position, such as a scanner.", nargs=3)
@option("--direction=X Y Z", float, "Orient normals along this direction.", nargs=3)
@from_cloud_to_cloud()
def normals(source: Path, output: Path, **options: Any) -> Answer:
    """Estimate a normal for each point of the cloud IN from its nearest neighbors, and write the cloud to OUT.

    Normals keep the orientation of the normals of IN, if any. --toward and --direction define another orientation.

    \b
    pointloom normals scan.ply out.ply --radius 0.1 --toward 0 0 1.5
    """
    from ..jobs.clouds import estimate_normals_of_file

    if options["toward"] is not None and options["direction"] is not None:
        refuse("--toward and --direction define different orientations; pass one of them")
    return estimate_normals_of_file(source, output, **options)


@cli.command(short_help="Fuse rendered frames of a room. Needs no data.")
@option("-o --output folder=FOLDER", FILE, "Output folder.", default="pointloom-demo")
@option("--frames frame_count=N", click.IntRange(min=1), "Number of frames.", default=120)
@option("--voxel voxel_size=M", LENGTH, "Voxel size [m].", default=0.02)
@option("--seed=N", click.IntRange(min=0), "Random seed of the noise.", default=0)
@option(
    "--noise/--no-noise",
    bool,
    "Simulate camera noise in depth and color (default), or not.",
    default=True,
    show_default=False,
)
@in_order(DEVICE, JSON, FORCE)
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
    raise SystemExit(TERMINATED_CODE)


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
        raise SystemExit(INTERRUPTED_CODE) from None


if __name__ == "__main__":
    main()
