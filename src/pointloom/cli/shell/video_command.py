"""The command `video`: images to a mesh. Nothing expensive is imported here."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import click

from ...cameras.trajectory_formats import NUMBERED
from ...io.meshes.mesh_formats import MESH_FORMATS
from ...io.points.formats import WRITTEN
from .answer import answer_with
from .console import Progress
from .format_lists import words
from .options import (
    DEVICE,
    FILE,
    FORCE,
    JSON,
    MODEL_UP,
    PICTURE,
    SCALE,
    CompletedPath,
    check_up,
    in_order,
    option,
    refuse,
    refuse_same,
)


class KnownDistance(click.ParamType):
    """Two images and the distance of their cameras [m], such as 12,48,1.5."""

    name = "images"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> tuple[str, str, float]:
        parts = [part.strip() for part in value.split(",")]
        try:
            meters = float(parts[-1])
        except ValueError:
            meters = math.nan
        if len(parts) != 3 or not all(parts) or not (math.isfinite(meters) and meters > 0):
            self.fail(f"expected two images and meters above 0, such as 12,48,1.5, got {value!r}", param, ctx)
        return parts[0], parts[1], meters


class Alignment(CompletedPath):
    """A file of known positions, "exif" or "none"."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        return value if value in ("exif", "none") else super().convert(value, param, ctx)


ALIGN = "Known camera positions: poses, or lines `name x y z` [m]; exif: GPS of the images; none: no alignment."
CONTROL = "Ground control points, marked in images: ODM's gcp_list.txt, or a CSV."
BARS = "Known distances between points marked in images, lines `bar A B meters`."
MESH = f"The mesh, {words(MESH_FORMATS)}; or the points, in another format of clouds."
CAMERA_MODEL = "COLMAP's name of the camera model: OPENCV, OPENCV_FISHEYE ..."
TRAINING = "Write a training folder for gsplat, 3DGS and nerfstudio."
CAMERAS = "Known poses: Metashape's .xml, COLMAP's folder, transforms.json, Polycam, a trajectory."


@click.command(short_help="Reconstruct a mesh from a video or a folder of images.")
@click.argument("source", type=FILE, metavar="VIDEO|FOLDER")
@option("-o --output=MESH", FILE, MESH, required=True)
@option("--work=DIR", FILE, "Folder for intermediate files and report.json. Default: next to the output.")
@option("--resume", bool, "Reuse the intermediate files of an earlier run.")
@option("--max-frames=N", click.IntRange(min=2), "Maximum number of images.", default=150)
@option("--max-size=PX", click.IntRange(min=64), "Longest side of the images for depth estimation.", default=960)
@option("--intrinsic=JSON", FILE, "The camera (Open3D's JSON). Default: estimated.")
@option("--cameras=FILE", FILE, CAMERAS)
@option("--scale=F", SCALE, "Meters per unit of the model.")
@option("--known=A,B,M", KnownDistance(), "Distance M [m] between the cameras of images A and B.")
@option("--align=FILE|exif|none", Alignment(path_type=Path), ALIGN)
@option("--control=FILE", FILE, CONTROL)
@option("--scale-bars=FILE", FILE, BARS)
@option("--masks=DIR|alpha", str, "Ignore black pixels of masks, or transparent pixels of the images.")
@option("--camera-model=NAME", str, CAMERA_MODEL, default="SIMPLE_RADIAL")
@option(
    "--pairs",
    ["auto", "sequential", "exhaustive", "retrieval"],
    "Selection of image pairs for matching.",
    default="auto",
)
@option(
    "--mapper",
    ["auto", "incremental", "global"],
    "Incremental (one image at a time) or global structure from motion.",
    default="auto",
)
@option("--max-features=N", click.IntRange(min=64), "Maximum number of features per image.", default=4096)
@option("--panorama", bool, "The images are 360-degree panoramas.")
@option("--cloud=FILE", FILE, "Also write the fused points.")
@option("--trajectory=POSES", FILE, f"Write the poses: {words(NUMBERED)}.")
@option("--training=DIR", FILE, TRAINING)
@option("--ortho=TIF", FILE, "Write an orthophoto in UTM. Requires GPS and --cell.")
@option("--dem=TIF", FILE, "Write an elevation model in UTM, likewise.")
@option("--cell=M", SCALE, "Cell size of --ortho and --dem [m].")
@option("--seed=N", click.IntRange(min=0), "Random seed.", default=0)
@in_order(MODEL_UP, DEVICE, PICTURE, JSON, FORCE)
def video(source: Path, output: Path, as_json: bool, force: bool, **options: Any) -> int:
    """Reconstruct a colored mesh from VIDEO, or from the images in FOLDER. No other input is required.

    \b
    frames             selection of sharp frames with camera motion
    features, matches  feature detection and matching
    model              camera poses and lens (structure from motion)
    undistorted        images without lens distortion
    depth              dense matching of each image with others
    fused, mesh        points confirmed by several images, and a surface

    Images do not determine the scale. The unit is arbitrary unless --scale, --known, --align, --control, --scale-bars
    or GPS tags of the photographs define it. With GPS, z is up and the report has the origin and the UTM zone. In
    --known, --align and --control an image is identified by its file name or frame number.

    --control aligns the model with surveyed points: at least three, not collinear, each marked in at least two images.
    Points named CHK... are check points, which are used only for validation. The summary lists the residual of each
    point and scale bar. Inconsistent ones are excluded and listed, with exit code 3.

    Intermediate files are kept: in room-video next to room.ply, or in --work. The same command computes only missing
    or outdated stages, so it continues after an interruption. For example, another --max-size restarts at undistorted,
    and another --scale repeats only the mesh. With --work this requires --resume. Delete the folder to start again.

    With --cameras poses and lenses are taken from the file, in its unit, and only points and depth are estimated. The
    images are those listed in the file, with or without extension. A trajectory (.log, TUM, KITTI) also requires
    --intrinsic. Poses that contradict the images are reported with the probable cause.

    The exit code is 3 if fewer than 60% of the images were registered, the images split into several models, the camera
    rotated without translation, less than 20% of the depth was confirmed, or the focal length is unreliable:
    --intrinsic contradicts the images, or neither the images nor EXIF determine it. The remedy is printed. The mesh is
    still written, if any.

    \b
    pointloom video walk.mp4 -o room.ply --picture room.png
    pointloom video photos/ -o room.ply --work stages --known IMG_0012,IMG_0040,1.5
    pointloom video walk.mp4 -o room.ply --max-size 1280 --force
    pointloom video photos/ -o house.ply --cameras cameras.xml --cloud points.ply
    pointloom video photos/ -o house.ply --training scene
    pointloom video flight/ -o field.ply --ortho field.tif --dem heights.tif --cell 0.05
    pointloom video flight/ -o site.ply --control gcp_list.txt --scale-bars bars.txt
    """
    bars = () if options["control"] is not None else ("scale_bars",)
    given = [n for n in ("scale", "known", "align", "control", *bars) if options[n] not in (None, "none")]
    given = [name.replace("_", "-") for name in given]
    if len(given) > 1:
        refuse(f"--{given[0]} and --{given[1]} both define the unit; pass one of them")
    files = ("cloud", "trajectory", "picture", "training", "ortho", "dem")
    refuse_same(output=output, **{name: options[name] for name in files})
    check_up(options["up"], output)
    if (options["cell"] is None) == (options["ortho"] is not None or options["dem"] is not None):
        refuse("--ortho and --dem require --cell, the side of their cells in meters")
    from ...photogrammetry.video.job import default_work_folder, reconstruct_video
    from ...photogrammetry.video.outputs import VideoOutputs
    from ...photogrammetry.video.settings import VideoSettings
    from ...photogrammetry.video.units import VideoUnits

    units = VideoUnits(**{name: options.pop(name) for name in ("scale", "known", "align", "control", "scale_bars")})
    names = ("max_frames", "max_size", "intrinsic", "seed", "cameras")
    names += ("masks", "camera_model", "pairs", "max_features", "panorama", "mapper")
    settings = VideoSettings(units=units, **{name: options.pop(name) for name in names})
    points_alone = output.suffix.lower() in set(WRITTEN) - set(MESH_FORMATS) and options["cloud"] is None
    if points_alone:
        options["cloud"] = output
    outputs = VideoOutputs(
        None if points_alone else output, **{name: options.pop(name) for name in (*files, "cell", "up")}
    )
    folder = options["work"] or default_work_folder(source, outputs)
    resume = "--resume" if options["work"] and not options["resume"] else ""
    with Progress(kept=folder, resume=resume) as progress:
        result = reconstruct_video(source, settings, outputs=outputs, overwrite=force, progress=progress, **options)
    return answer_with(result, result.source, as_json)


COMMANDS = (video,)
