"""The command `depth`: images to clouds by a depth network. Nothing expensive is imported here."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from ...cameras.depth_range import DEPTH_SCALE
from .answer import answer_with
from .console import Progress
from .format_lists import with_lists
from .options import DEVICE, FILE, FORCE, JSON, SCALE, in_order, option, refuse_same

# Names of src/pointloom/photogrammetry/depth/presets.py, which would import NumPy. A test compares them.
PRESETS = (
    "depth-anything-v2", "midas-v2.1", "midas-v2.1-small", "midas-v2.1-onnx", "midas-v2.1-small-onnx", "dpt",
    "depth-anything-v2-metric", "zoedepth", "depth-pro", "moge-2", "unidepth-v2", "metric3d-v2", "metric3d-convnext",
    "depth-anything-3", "depth-anything-3-metric",
)  # fmt: skip


@click.command(short_help="Convert a photograph to a cloud by a depth network.")
@click.argument("picture_in", type=FILE, metavar="PICTURE")
@option("--model=ONNX", FILE, "ONNX file of the network. Not included.", required=True)
@option("-o --output=OUT", FILE, "The cloud. A folder if PICTURE is a folder.", required=True)
@option("--preset", click.Choice(PRESETS), "Type of the network.", default=PRESETS[0])
@option("--intrinsic=JSON", FILE, "The camera. Default: from EXIF, else 60 degrees.")
@option("--align=FILE", FILE, "Known depth: depth map, distances, or COLMAP model.")
@option("--depth-scale=N", SCALE, "Stored value of one meter.", default=DEPTH_SCALE)
@option("--tiles=N", click.IntRange(1, 16), "Number of tiles along the longer side.", default=1)
@option("--keep-edges", bool, "Keep flying pixels at depth edges.")
@option("--depth-map=NPY", FILE, "Also write the depth map, float32.")
@option("--picture=PNG", FILE, "Also render the cloud from the side.")
@option(
    "--seed=N", click.IntRange(0, 2**31 - 1), "Random seed of the alignment. Default: 0.", default=0, show_default=False
)
@in_order(DEVICE, JSON, FORCE)
@with_lists
def depth(picture_in: Path, model: Path, output: Path, as_json: bool, force: bool, **options: Any) -> int:
    """Estimate the depth of PICTURE, a PNG or JPEG file or a folder of them, and write colored points to OUT.

    The network is an ONNX file that you provide. Nothing is downloaded. docs/depth.md lists the presets and their
    licenses. Requires the extra pointloom[depth]. Relative networks have no unit. --align defines meters:

    \b
    {depth maps}   depth map of the same view: 16 bits with --depth-scale, or float32 meters
    .txt .csv   distances: one line of column, row and meters each. Two define scale and shift without a check
    FOLDER      COLMAP model, which defines the unit

    The exit code is 3 if the depth map contradicts the reference depth, or if hardly any points remain.

    \b
    pointloom depth photo.jpg --model depth_anything_v2_vits.onnx -o cloud.ply --picture cloud.png
    pointloom depth photo.jpg --model midas.onnx --preset midas-v2.1 --align distances.txt -o cloud.ply
    pointloom depth photos/ --model metric3d.onnx --preset metric3d-v2 --intrinsic camera.json -o clouds
    """
    from ...photogrammetry.depth.job import DepthOutputs, depth_of_images
    from ...photogrammetry.depth.settings import DepthSettings

    refuse_same(output=output, picture=options["picture"], depth_map=options["depth_map"])
    names = ("preset", "intrinsic", "align", "depth_scale", "tiles", "keep_edges", "seed")
    settings = DepthSettings(**{name: options.pop(name) for name in names})
    outputs = DepthOutputs(output, options.pop("depth_map"), options.pop("picture"))
    with Progress() as progress:
        report = depth_of_images(picture_in, model, outputs, settings, overwrite=force, progress=progress, **options)
    return answer_with(report, report.source, as_json)


COMMANDS = (depth,)
