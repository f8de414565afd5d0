"""The command `texture`: the colors of posed frames onto a mesh. Nothing expensive is imported here."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click
from click.core import ParameterSource

from ...io.meshes.mesh_formats import storing
from .answer import answer_with
from .console import Progress
from .format_lists import words
from .options import DEVICE, FILE, FORCE, JSON, PICTURE, UP, check_up, frame_options, in_order, option, refuse_same

METHODS = ("rigid", "non-rigid", "none")


@click.command(short_help="Texture a mesh from posed RGB-D frames.")
@click.argument("mesh", type=FILE)
@click.argument("frames", type=FILE)
@option("-o --output=OUT", FILE, f"The colored mesh, {words(storing('textures'))}.", required=True)
@option("--method", click.Choice(METHODS), "Optimization of the images, see above.", default="rigid")
@option("--size=N", click.IntRange(16, 16384), "Texture size [texels].", default=2048)
@frame_options()
@in_order(DEVICE, UP, PICTURE, JSON, FORCE)
def texture(mesh: Path, frames: Path, output: Path, as_json: bool, force: bool, **options: Any) -> int:
    """Color MESH from FRAMES, a folder of posed RGB-D frames as of pointloom fuse, and write it to OUT.

    \b
    .ply    vertex colors
    others  a texture. Missing texture coordinates are computed

    FRAMES may also be a COLMAP project with the folder images, or the work folder of pointloom video. Each triangle
    then takes its texture from the best image, with exposure compensation and without seams. Poses are not changed.

    \b
    rigid      optimize the poses until the images agree at each vertex
    non-rigid  also warp the images, which compensates lens distortion
    none       use poses and images unchanged

    Finished steps are kept in sharp-texture next to sharp.glb until the output is written. After an interruption the
    same command continues from them, and writes bitwise the same output.

    The exit code is 3 if the frames show little or nothing of the mesh, or if the optimization did not improve the
    agreement of the images.

    \b
    pointloom fuse redkitchen/seq-01 -o kitchen.ply --every 5
    pointloom texture kitchen.ply redkitchen/seq-01 -o sharp.ply --every 5 --picture sharp.png
    pointloom texture kitchen.ply redkitchen/seq-01 -o kitchen.glb --method non-rigid --size 4096
    pointloom texture room.ply room-work -o room.glb --size 4096
    """
    from ..jobs.texture import texture_folder, work_folder_of
    from ..jobs.texture_model import is_model_folder, texture_model

    refuse_same(output=output, picture=options["picture"])
    check_up(options["up"], mesh, output)
    work = work_folder_of(output)
    if is_model_folder(frames):
        chosen = _for_model(options)
        with Progress(kept=work) as progress:
            model_report = texture_model(mesh, frames, output, overwrite=force, progress=progress, **chosen)
        return answer_with(model_report, f"{mesh} and {frames} (model)", as_json)
    options["layout"] = {name: options.pop(name) for name in ("layout", "intrinsic", "every", "skip_missing")}
    with Progress(kept=work) as progress:
        report = texture_folder(mesh, frames, output, overwrite=force, progress=progress, **options)
    return answer_with(report, f"{mesh} and {frames} ({report.task.layout})", as_json)


def _for_model(options: dict[str, Any]) -> dict[str, Any]:
    """Options for a model of images. Others cause a usage error."""
    context = click.get_current_context()
    taken = ("size", "depth_max", "device", "up")
    given = [name for name in options if context.get_parameter_source(name) == ParameterSource.COMMANDLINE]
    for name in given:
        if name not in taken:
            words = f"--{name.replace('_', '-')}"
            raise click.UsageError(f"{words} is for RGB-D frames; the poses of a model are not changed")
    chosen = {name: options[name] for name in ("size", "device", "up")}
    return chosen | ({"depth_max": options["depth_max"]} if "depth_max" in given else {})


COMMANDS = (texture,)
