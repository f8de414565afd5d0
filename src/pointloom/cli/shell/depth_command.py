"""The command `depth`: images to clouds by a depth network. Nothing expensive is imported here."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from ...cameras.depth_range import DEPTH_SCALE
from .answer import answer_with
from .console import Progress
from .options import FILE, SCALE, device_option, force_option, json_option, refuse_same

# Names of src/pointloom/photogrammetry/depth/presets.py, which would import NumPy. A test compares them.
PRESETS = (
    "depth-anything-v2", "midas-v2.1", "midas-v2.1-small", "midas-v2.1-onnx", "midas-v2.1-small-onnx", "dpt",
    "depth-anything-v2-metric", "zoedepth", "depth-pro", "moge-2", "unidepth-v2", "metric3d-v2", "metric3d-convnext",
    "depth-anything-3", "depth-anything-3-metric",
)  # fmt: skip


@click.command(short_help="A photograph to a cloud by a depth network.")
@click.argument("picture_in", type=FILE, metavar="PICTURE")
@click.option("--model", type=FILE, required=True, metavar="ONNX", help="The network's .onnx file, which you bring.")
@click.option("-o", "--output", type=FILE, required=True, metavar="OUT", help="The cloud; of a folder, a folder.")
@click.option(
    "--preset", type=click.Choice(PRESETS), default=PRESETS[0], show_default=True, help="Which network it is."
)
@click.option("--intrinsic", type=FILE, metavar="JSON", help="The camera; EXIF's, else 60 degrees, if not given.")
@click.option("--align", type=FILE, metavar="FILE", help="Known depth: a map, distances, or a COLMAP model.")
@click.option(
    "--depth-scale", type=SCALE, default=DEPTH_SCALE, show_default=True, metavar="N", help="Stored depth of one metre."
)
@click.option(
    "--tiles", type=click.IntRange(1, 16), default=1, show_default=True, metavar="N", help="Along the longer side."
)
@click.option("--keep-edges", is_flag=True, help="Keep points that fly between two surfaces.")
@click.option("--depth-map", type=FILE, metavar="NPY", help="Write the depth as well, float32.")
@click.option("--picture", type=FILE, metavar="PNG", help="Draw the cloud as well, from a little aside.")
@click.option("--seed", type=click.IntRange(0, 2**31 - 1), default=0, metavar="N", help="Of the alignment.")
@device_option()
@json_option()
@force_option()
def depth(picture_in: Path, model: Path, output: Path, as_json: bool, force: bool, **options: Any) -> int:
    """Estimate the depth of PICTURE, a PNG or JPEG file or a folder of such, and write its colored points to OUT.

    Nothing is downloaded: the network is yours, as an ONNX file; docs/depth.md lists the presets and their licenses.
    Needs the extra pointloom[depth]. Relative networks give no unit; --align brings meters:

    \b
    .png .npy   a depth map of the same view, 16 bits by --depth-scale or float32 meters
    .txt .csv   distances, a line of column, row and meters each. Two settle scale and shift without a check
    FOLDER      a COLMAP model, whose unit it then is

    The exit code is 3 where the map and what it is aligned to do not agree, and where hardly a point is left.

    \b
    pointloom depth photo.jpg --model depth_anything_v2_vits.onnx -o cloud.ply --picture cloud.png
    pointloom depth photo.jpg --model midas.onnx --preset midas-v2.1 --align distances.txt -o cloud.ply
    pointloom depth photos/ --model metric3d.onnx --preset metric3d-v2 --intrinsic camera.json -o clouds
    """
    from ...photogrammetry.depth.job import depth_of_pictures
    from ...photogrammetry.depth.settings import DepthSettings

    refuse_same(output=output, picture=options["picture"], depth_map=options["depth_map"])
    names = ("preset", "intrinsic", "align", "depth_scale", "tiles", "keep_edges", "seed")
    settings = DepthSettings(**{name: options.pop(name) for name in names})
    with Progress() as progress:
        report = depth_of_pictures(picture_in, model, output, settings, overwrite=force, progress=progress, **options)
    return answer_with(report, report.source, as_json)


COMMANDS = (depth,)
