"""The commands that take folders of RGB-D frames: fuse, track, reconstruct.

As in cli.py nothing heavy is imported here; what a command does lies in the module of its name.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from .answer import give_answer
from .console import Progress
from .options import (
    FILE,
    LENGTH,
    device_option,
    force_option,
    frame_options,
    json_option,
    picture_option,
    refuse_same,
)

MESH = "The mesh, .ply .obj .stl .off .glb."
ONLY_FRAGMENTS = ("work", "resume", "config", "slac")  # options of --method fragments


@click.command(short_help="Fuse a folder of posed RGB-D frames into a coloured mesh.")
@click.argument("dataset", type=FILE)
@click.option("-o", "--output", type=FILE, required=True, metavar="MESH", help=MESH)
@frame_options()
@click.option("--voxel", type=LENGTH, default=0.02, show_default=True, metavar="M", help="Edge of a voxel [m].")
@click.option(
    "--truncation", type=LENGTH, metavar="M", help="How far depth acts around the surface [m]; 4 voxels if not given."
)
@device_option()
@picture_option()
@json_option()
@force_option()
def fuse(dataset: Path, output: Path, voxel: float, as_json: bool, force: bool, **options: Any) -> int:
    """Fuse DATASET, a folder of posed RGB-D frames, into a coloured mesh.

    \b
    Layouts (auto tells them apart by their files):
      7scenes  frame-000000.depth.png, .color.png or .jpg, .pose.txt
      redwood  depth/, color/ (or image/, rgb/), trajectory.log
      tum      depth.txt, rgb.txt, groundtruth.txt

    The camera is --intrinsic (Open3D's JSON), else what lies in the folder (camera.json, camera-intrinsics.txt,
    intrinsics.K.txt, ...), else the layout's own; the summary says which, and the exit code is 3 where the pictures
    contradict it. A voxel counts as surface once 4 frames saw it; of fewer than 30 frames 2 are enough, of fewer
    than 10 one. Voxels of half the size take about 4 times the memory and show twice the detail, where depth has it.

    \b
    pointloom fuse redkitchen/seq-01 -o kitchen.ply --every 5 --picture kitchen.png
    """
    refuse_same(output=output, picture=options["picture"])
    from .fuse import fuse_folder, fusion_fields

    with Progress() as progress:
        report = fuse_folder(dataset, output, voxel_size=voxel, overwrite=force, progress=progress, **options)
    return give_answer(report, fusion_fields, f"{dataset} ({report['layout']})", as_json)


COMMANDS = (fuse,)
