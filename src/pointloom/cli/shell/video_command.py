"""The command `video`: images to a mesh. Nothing expensive is imported here."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import click

from .answer import answer_with
from .console import Progress
from .options import (
    FILE,
    SCALE,
    CompletedPath,
    device_option,
    force_option,
    json_option,
    picture_option,
    refuse,
    refuse_same,
)


class KnownDistance(click.ParamType):
    """Two images and the distance of their cameras [m], such as 12,48,1.5."""

    name = "pictures"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> tuple[str, str, float]:
        parts = [part.strip() for part in value.split(",")]
        try:
            meters = float(parts[-1])
        except ValueError:
            meters = math.nan
        if len(parts) != 3 or not all(parts) or not (math.isfinite(meters) and meters > 0):
            self.fail(f"expected two pictures and meters above 0, such as 12,48,1.5, got {value!r}", param, ctx)
        return parts[0], parts[1], meters


class Alignment(CompletedPath):
    """A file of known positions, "exif" or "none"."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        return value if value in ("exif", "none") else super().convert(value, param, ctx)


ALIGN = "Known places of cameras: poses, or lines `name x y z` [m]; exif: GPS of the pictures; none: leave the frame."
CONTROL = "Points with coordinates, marked in pictures: ODM's gcp_list.txt, or a CSV."
BARS = "Known lengths between points that are marked in pictures, lines `bar A B meters`."
MESH = "The mesh, .ply .obj .stl .off .glb .gltf; the points, .pcd .las .xyz ..."
CAMERA_MODEL = "How the lens draws, COLMAP's name: OPENCV, OPENCV_FISHEYE ..."
TRAINING = "Write a folder that gsplat, 3DGS and nerfstudio train from."
CAMERAS = "Known poses: Metashape's .xml, COLMAP's folder, transforms.json, Polycam, a trajectory."


@click.command(short_help="A video, or a folder of pictures, to a mesh.")
@click.argument("source", type=FILE, metavar="VIDEO|FOLDER")
@click.option("-o", "--output", type=FILE, required=True, metavar="MESH", help=MESH)
@click.option("--work", type=FILE, metavar="DIR", help="Keep the stages' files and report.json in this folder.")
@click.option("--resume", is_flag=True, help="Keep what an earlier run left in that folder.")
@click.option(
    "--max-frames",
    type=click.IntRange(min=2),
    default=150,
    show_default=True,
    metavar="N",
    help="The most pictures that are used.",
)
@click.option(
    "--max-size",
    type=click.IntRange(min=64),
    default=960,
    show_default=True,
    metavar="PX",
    help="Longest side of the pictures that depth is found in.",
)
@click.option("--intrinsic", type=FILE, metavar="JSON", help="The camera (Open3D's JSON); found if not given.")
@click.option("--cameras", type=FILE, metavar="FILE", help=CAMERAS)
@click.option("--scale", type=SCALE, metavar="F", help="Meters in a unit of the model.")
@click.option("--known", type=KnownDistance(), metavar="A,B,M", help="Pictures A and B were taken M meters apart.")
@click.option("--align", type=Alignment(path_type=Path), metavar="FILE|exif|none", help=ALIGN)
@click.option("--control", type=FILE, metavar="FILE", help=CONTROL)
@click.option("--scale-bars", type=FILE, metavar="FILE", help=BARS)
@click.option("--masks", metavar="DIR|alpha", help="Leave out what is black in masks, or transparent in the pictures.")
@click.option("--camera-model", metavar="NAME", default="SIMPLE_RADIAL", show_default=True, help=CAMERA_MODEL)
@click.option(
    "--pairs",
    type=click.Choice(("auto", "sequential", "exhaustive", "retrieval")),
    default="auto",
    show_default=True,
    help="Which pictures are matched.",
)
@click.option(
    "--mapper",
    type=click.Choice(("auto", "incremental", "global")),
    default="auto",
    show_default=True,
    help="How pictures are placed: one by one, or all at once.",
)
@click.option(
    "--max-features",
    type=click.IntRange(min=64),
    default=4096,
    show_default=True,
    metavar="N",
    help="The most features of a picture.",
)
@click.option("--panorama", is_flag=True, help="The pictures show all directions (360 degrees).")
@click.option("--cloud", type=FILE, metavar="FILE", help="Write the fused points as well.")
@click.option("--trajectory", type=FILE, metavar="POSES", help="Write the poses: .txt or .tum (TUM), .log.")
@click.option("--training", type=FILE, metavar="DIR", help=TRAINING)
@click.option("--ortho", type=FILE, metavar="TIF", help="Write the mesh from above, in UTM; wants GPS and --cell.")
@click.option("--dem", type=FILE, metavar="TIF", help="Write its heights likewise.")
@click.option("--cell", type=SCALE, metavar="M", help="The side of the cells of --ortho and --dem, in meters.")
@click.option("--seed", type=click.IntRange(min=0), default=0, show_default=True, metavar="N", help="Of what is drawn.")
@device_option()
@picture_option()
@json_option()
@force_option()
def video(source: Path, output: Path, as_json: bool, force: bool, **options: Any) -> int:
    """Make a colored mesh of VIDEO, or of the pictures in FOLDER: nothing else is needed.

    \b
    frames             sharp frames, where the camera has moved
    features, matches  what can be recognized in them, and what they share of it
    model              where they were taken, and what the lens is like
    undistorted        the pictures as a lens without distortion shows them
    depth              each picture matched with others, pixel by pixel
    fused, mesh        what several pictures agree on, as points and as a surface

    The size of things cannot be seen in pictures: the unit is arbitrary unless --scale, --known, --align, --control or
    --scale-bars tells it, or photographs tell where they were taken (GPS): then z is up, and the report has the origin
    and the UTM zone. Pictures are named in --known, --align and --control by their file or by the number of the frame.

    --control brings the model to surveyed points: three or more that are not on a line, each marked in two or more
    pictures. Points named CHK... are check points, which are measured against alone. The residual of each point and
    each scale bar is told. One that contradicts the others is left out and named, with exit code 3.

    With --work each stage's files stay, and --resume makes only what is missing or made from something else: another
    --max-size begins at undistorted, another --scale makes the mesh alone.

    With --cameras nothing is placed: points and depth are found at the poses and lenses of the file, in its unit.
    Pictures are those that it names, with or without their ending. A trajectory (.log, TUM, KITTI) wants --intrinsic
    too. Poses that the pictures contradict are told, with the likely mistake.

    The exit code is 3 where fewer than 60 % of the pictures could be placed, where they fall apart into several
    models, where the camera turned without moving, where the pictures ask for another focal length than --intrinsic
    has or fix none and EXIF tells none, and where less than 20 % of the depth is confirmed. The remedy is told, and a
    mesh is written where there is one.

    \b
    pointloom video walk.mp4 -o room.ply --picture room.png
    pointloom video photos/ -o room.ply --work stages --known IMG_0012,IMG_0040,1.5
    pointloom video walk.mp4 -o room.ply --work stages --resume --max-size 1280 --force
    pointloom video photos/ -o house.ply --cameras cameras.xml --cloud points.ply
    pointloom video photos/ -o house.ply --training scene
    pointloom video flight/ -o field.ply --ortho field.tif --dem heights.tif --cell 0.05
    pointloom video flight/ -o site.ply --control gcp_list.txt --scale-bars bars.txt
    """
    bars = () if options["control"] is not None else ("scale_bars",)
    given = [n for n in ("scale", "known", "align", "control", *bars) if options[n] not in (None, "none")]
    given = [name.replace("_", "-") for name in given]
    if len(given) > 1:
        refuse(f"--{given[0]} and --{given[1]} both settle the unit; give one")
    if options["resume"] and options["work"] is None:
        refuse("--resume goes with --work, the folder of the earlier run")
    files = ("cloud", "trajectory", "picture", "training", "ortho", "dem")
    refuse_same(output=output, **{name: options[name] for name in files})
    if (options["cell"] is None) == (options["ortho"] is not None or options["dem"] is not None):
        refuse("--ortho and --dem go with --cell, the side of their cells in meters")
    from ...io.meshes.tables import MESHES
    from ...io.points.formats import WRITTEN
    from ...photogrammetry.video.job import reconstruct
    from ...photogrammetry.video.outputs import Outputs
    from ...photogrammetry.video.settings import Settings
    from ...photogrammetry.video.units import Units

    units = Units(**{name: options.pop(name) for name in ("scale", "known", "align", "control", "scale_bars")})
    names = ("max_frames", "max_size", "intrinsic", "seed", "cameras")
    names += ("masks", "camera_model", "pairs", "max_features", "panorama", "mapper")
    settings = Settings(units=units, **{name: options.pop(name) for name in names})
    points_alone = output.suffix.lower() in set(WRITTEN) - set(MESHES) and options["cloud"] is None
    if points_alone:
        options["cloud"] = output
    outputs = Outputs(None if points_alone else output, **{name: options.pop(name) for name in (*files, "cell")})
    with Progress() as progress:
        result = reconstruct(source, settings, outputs=outputs, overwrite=force, progress=progress, **options)
    return answer_with(result, result.source, as_json)


COMMANDS = (video,)
