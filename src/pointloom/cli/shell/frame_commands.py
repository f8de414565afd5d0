"""The commands fuse, track and reconstruct for folders of RGB-D frames. Nothing expensive is imported here."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from .answer import answer_with
from .console import Progress
from .options import (
    FILE,
    LENGTH,
    POSES,
    device_option,
    force_option,
    frame_options,
    json_option,
    picture_option,
    record_option,
    refuse,
    refuse_same,
)

if TYPE_CHECKING:
    from ..jobs.frame_folder import FolderOptions
    from ..jobs.model_outputs import ModelOutputs

FOLDER_OPTIONS = ("layout", "intrinsic", "every", "depth_scale", "skip_missing", "topic", "color_topic")
MESH = "The mesh, .ply .obj .stl .off .glb .gltf."
MODEL_VOXEL = "Edge of a voxel of the model that frames are held against [m]."
MESH_VOXEL = "Edge of a voxel of the mesh [m]; 0.02, with fragments what --config says or 0.0059, if not given."
ONLY_FRAGMENTS = ("work", "resume", "config", "slac")  # options of --method fragments


@click.command(short_help="Fuse a folder of posed RGB-D frames into a colored mesh.")
@click.argument("dataset", type=FILE)
@click.option("-o", "--output", type=FILE, required=True, metavar="MESH", help=MESH)
@frame_options()
@click.option("--voxel", type=LENGTH, default=0.02, show_default=True, metavar="M", help="Edge of a voxel [m].")
@click.option(
    "--truncation", type=LENGTH, metavar="M", help="How far depth acts around the surface [m]; 4 voxels if not given."
)
@click.option("--refine", is_flag=True, help="Move each pose onto what the frames before it saw.")
@click.option(
    "--trajectory",
    type=FILE,
    metavar="POSES",
    help="Write the poses that were used: .txt or .tum (TUM), .log (Open3D).",
)
@device_option()
@picture_option()
@record_option("the surface as it grows")
@json_option()
@force_option()
def fuse(dataset: Path, output: Path, voxel: float, as_json: bool, force: bool, **options: Any) -> int:
    """Fuse DATASET, a folder of posed RGB-D frames, into a colored mesh. For frames without see pointloom reconstruct.

    \b
    Layouts (auto tells them apart by their files):
      7scenes  frame-000000.depth.png, .color.png or .jpg, .pose.txt
      redwood  depth/, color/ (or image/, rgb/), trajectory.log
      tum      depth.txt, rgb.txt, groundtruth.txt

    The camera is --intrinsic (Open3D's JSON), else what lies in the folder (camera.json, camera-intrinsics.txt,
    intrinsics.K.txt, ...), else the layout's own. The summary says which, and the exit code is 3 where the pictures
    contradict it. A voxel counts as surface once 4 frames saw it. Of fewer than 30 frames 2 are enough, of fewer
    than 10 one. Voxels of half the size take about 4 times the memory and show twice the detail, where depth has it.

    --refine aligns each frame with the model, from its pose. It pays where poses err by a centimetre or more, and takes
    from poses that are better than that. A frame that does not fit keeps its pose. The summary names those.

    \b
    pointloom fuse redkitchen/seq-01 -o kitchen.ply --every 5 --picture kitchen.png
    pointloom fuse redkitchen/seq-01 -o kitchen.ply --refine --trajectory refined.log
    """
    _refuse_same_outputs(output, options)
    from ..jobs.fuse import fuse_folder
    from .recording_command import recorded

    outputs, frames = _outputs(output, options), _folder_options(options)
    with Progress() as progress:
        given = {"options": frames, "voxel_size": voxel, "overwrite": force, "progress": progress}
        report = recorded(fuse_folder, dataset, outputs, **given, **options)
    return answer_with(report, f"{dataset} ({report.folder.dataset.layout})", as_json)


@click.command(short_help="Find the path of a depth camera from its frames.")
@click.argument("frames", type=FILE)
@click.option("-o", "--output", type=FILE, required=True, metavar="POSES", help=POSES)
@frame_options(posed=False)
@click.option("--voxel", "voxel_size", type=LENGTH, default=0.02, show_default=True, metavar="M", help=MODEL_VOXEL)
@device_option()
@record_option("the camera's path and the model")
@json_option()
@force_option()
def track(frames: Path, output: Path, as_json: bool, force: bool, **options: Any) -> int:
    """Find where each of FRAMES, a folder of RGB-D frames, was taken: T_world_camera, the first frame as the world.

    Each frame is held against the model that those before it make. Frames that do not fit are lost: they have no pose
    in POSES (.log names frames by number, .txt by time where there are times), and the exit code is 3.
    Where true poses lie beside the frames they tell the tracker nothing, and the errors are printed (ATE, RPE).

    \b
    Layouts as of pointloom fuse, with or without poses, and
      pictures  1.png and 1_depth.png, .... Take --intrinsic and --depth-scale with it

    FRAMES may be a recording too: a .bag of ROS 1, a .db3 or .mcap file, or a folder of those, with pointloom[ros].

    \b
    pointloom track frames -o poses.txt
    pointloom track frames -o poses.log --intrinsic camera.json --every 2
    pointloom track run.mcap -o poses.txt --topic /camera/depth/image_raw
    """
    refuse_same(output=output, record=options["record_as"])
    from ..jobs.track import track_folder
    from .recording_command import recorded

    given = {"options": _folder_options(options), "overwrite": force}
    with Progress(rates=True) as progress:
        report = recorded(track_folder, frames, output, progress=progress, **given, **options)
    return answer_with(report, f"{frames} ({report.folder.dataset.layout})", as_json)


@click.command(short_help="A folder of RGB-D frames without poses to a mesh.")
@click.argument("frames", type=FILE)
@click.option("-o", "--output", type=FILE, required=True, metavar="MESH", help=MESH)
@frame_options(posed=False, depth_max=None)
@click.option(
    "--method", type=click.Choice(["slam", "fragments"]), default="slam", show_default=True, help="See above."
)
@click.option("--voxel", "voxel_size", type=LENGTH, metavar="M", help=MESH_VOXEL)
@click.option("--trajectory", type=FILE, metavar="POSES", help="Write the poses: .txt or .tum (TUM), .log (Open3D).")
@click.option("--work", type=FILE, metavar="DIR", help="Folder of the stages' files; beside the mesh if not given.")
@click.option("--resume", is_flag=True, help="Keep what an earlier run left in that folder.")
@click.option("--config", type=FILE, metavar="JSON", help="Settings with the names of Open3D's system.")
@click.option("--slac", is_flag=True, help="Find the distortion of the camera's depth too, and take it out.")
@device_option()
@picture_option()
@record_option("the camera's path and the model, or the stages of fragments")
@json_option()
@force_option()
def reconstruct(frames: Path, output: Path, as_json: bool, force: bool, **options: Any) -> int:
    """Make a colored mesh of FRAMES, a folder of RGB-D frames whose poses nobody knows.

    \b
    slam       each frame is held against the model of those before it. Where the camera comes back to a place the loop
               is closed
    fragments  runs of some 100 frames become fragments, which are registered with each other from any pose. In stages,
               whose files stay: after an interruption --resume goes on. --work, --config and --slac go with it

    The exit code is 3 where frames were lost or fragments could not be joined. The summary names them, and the mesh is
    written all the same. Where true poses lie beside the frames they are not used, and the errors are printed (ATE,
    RPE). Layouts as of pointloom track.

    \b
    pointloom reconstruct frames -o mesh.ply --picture mesh.png
    pointloom reconstruct frames -o mesh.ply --method fragments --work stages --resume
    pointloom reconstruct frames -o mesh.ply --method fragments --slac
    pointloom reconstruct frames -o mesh.ply --trajectory poses.log --intrinsic camera.json
    """
    _refuse_same_outputs(output, options)
    by_fragments, only = options.pop("method") == "fragments", {name: options.pop(name) for name in ONLY_FRAGMENTS}
    for name, value in only.items():
        if value and not by_fragments:
            refuse(f"--{name} goes with --method fragments")
    from ..jobs.reconstruct import StageOptions, reconstruct_folder
    from .recording_command import recorded

    outputs, stages = _outputs(output, options), StageOptions(**only) if by_fragments else None
    given = {"options": _folder_options(options), "stages": stages, "overwrite": force}
    with Progress() as progress:
        report = recorded(reconstruct_folder, frames, outputs, progress=progress, **given, **options)
    return answer_with(report, f"{frames} ({report.folder.dataset.layout})", as_json)


def _folder_options(options: dict[str, Any]) -> FolderOptions:
    from ..jobs.frame_folder import FolderOptions

    return FolderOptions(**{name: options.pop(name) for name in FOLDER_OPTIONS if name in options})


def _outputs(mesh: Path, options: dict[str, Any]) -> ModelOutputs:
    from ..jobs.model_outputs import ModelOutputs

    return ModelOutputs(mesh, picture=options.pop("picture"), trajectory=options.pop("trajectory"))


def _refuse_same_outputs(output: Path, options: dict[str, Any]) -> None:
    others = {name: options[name] for name in ("picture", "trajectory")}
    refuse_same(output=output, **others, record=options["record_as"])


COMMANDS = (fuse, track, reconstruct)
