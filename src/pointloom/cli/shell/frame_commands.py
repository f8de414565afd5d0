"""The commands fuse, track and reconstruct for folders of RGB-D frames. Nothing expensive is imported here."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ...cameras.trajectory_formats import NUMBERED
from ...io.meshes.mesh_formats import MESH_FORMATS
from .answer import answer_with
from .console import Progress
from .format_lists import with_lists, words
from .options import (
    DEVICE,
    FILE,
    FORCE,
    JSON,
    LENGTH,
    MODEL_UP,
    PICTURE,
    POSES,
    check_up,
    frame_options,
    in_order,
    option,
    record_option,
    refuse,
    refuse_same,
)

if TYPE_CHECKING:
    from ..jobs.frame_folder import FolderOptions
    from ..jobs.model_outputs import ModelOutputs

FOLDER_OPTIONS = ("layout", "intrinsic", "every", "depth_scale", "skip_missing", "topic", "color_topic")
MESH = f"The mesh, {words(MESH_FORMATS)}."
MODEL_VOXEL = "Voxel size of the tracking model [m]."
MESH_VOXEL = "Voxel size of the mesh [m]. Default: 0.02; fragments: from --config, else 0.0059."
ONLY_FRAGMENTS = ("work", "resume", "config", "slac")  # options of --method fragments


@click.command(short_help="Fuse a folder of posed RGB-D frames into a colored mesh.")
@click.argument("dataset", type=FILE)
@option("-o --output=MESH", FILE, MESH, required=True)
@frame_options()
@option("--voxel=M", LENGTH, "Voxel size [m].", default=0.02)
@option("--truncation=M", LENGTH, "Truncation distance of the TSDF [m]. Default: 4 voxels.")
@option("--refine", bool, "Refine each pose against the model of the earlier frames.")
@option("--trajectory=POSES", FILE, f"Write the poses used: {words(NUMBERED)}.")
@in_order(MODEL_UP, DEVICE, PICTURE)
@record_option("the growing surface")
@in_order(JSON, FORCE)
def fuse(dataset: Path, output: Path, voxel: float, as_json: bool, force: bool, **options: Any) -> int:
    """Fuse DATASET, a folder of posed RGB-D frames, into a colored mesh. Without poses use pointloom reconstruct.

    \b
    Layouts (auto detects them from the file names):
      7scenes  frame-000000.depth.png, .color.png or .jpg, .pose.txt
      redwood  depth/, color/ (or image/, rgb/), trajectory.log
      tum      depth.txt, rgb.txt, groundtruth.txt

    The camera is --intrinsic (Open3D's JSON), else a file of the folder (camera.json, camera-intrinsics.txt,
    intrinsics.K.txt, ...), else the default of the layout. The summary names the source. The exit code is 3 if the
    images contradict the camera.

    A voxel belongs to the surface if at least 4 frames observed it (2 of fewer than 30 frames, 1 of fewer than 10).
    Half the voxel size needs about 4 times the memory and doubles the detail, as far as the depth resolution permits.

    --refine aligns each frame with the model, starting from its pose. It improves poses with errors of 1 cm or more,
    and degrades more accurate poses. A frame that does not fit keeps its pose, and the summary lists it.

    \b
    pointloom fuse redkitchen/seq-01 -o kitchen.ply --every 5 --picture kitchen.png
    pointloom fuse redkitchen/seq-01 -o kitchen.ply --refine --trajectory refined.log
    """
    _check_outputs(output, options)
    from ..jobs.fuse import fuse_folder
    from .recording_command import recorded

    outputs, frames = _outputs(output, options), _folder_options(options)
    with Progress() as progress:
        given = {"options": frames, "voxel_size": voxel, "overwrite": force, "progress": progress}
        report = recorded(fuse_folder, dataset, outputs, **given, **options)
    return answer_with(report, f"{dataset} ({report.folder.dataset.layout})", as_json)


@click.command(short_help="Estimate the trajectory of an RGB-D camera.")
@click.argument("frames", type=FILE)
@option("-o --output=POSES", FILE, POSES, required=True)
@frame_options(posed=False)
@option("--voxel voxel_size=M", LENGTH, MODEL_VOXEL, default=0.02)
@DEVICE
@record_option("the trajectory and the model")
@in_order(JSON, FORCE)
@with_lists
def track(frames: Path, output: Path, as_json: bool, force: bool, **options: Any) -> int:
    """Estimate the camera pose T_world_camera of each of FRAMES, a folder of RGB-D frames. The first frame is the
    world frame.

    Each frame is aligned with the model of the earlier frames. Frames that do not fit are lost: they have no pose in
    POSES, and the exit code is 3. A .log file lists frames by number, a .txt file by time, if available. True poses in
    the folder are not used for tracking. The errors against them are printed (ATE, RPE).

    \b
    Layouts of pointloom fuse, with or without poses, and
      images  1.png and 1_depth.png, .... Requires --intrinsic and --depth-scale

    FRAMES may also be a recording, {recordings} or a folder of them. Requires pointloom[ros].

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


@click.command(short_help="Reconstruct a mesh from RGB-D frames without poses.")
@click.argument("frames", type=FILE)
@option("-o --output=MESH", FILE, MESH, required=True)
@frame_options(posed=False, depth_max=None)
@option("--method", ["slam", "fragments"], "Method, see above.", default="slam")
@option("--voxel voxel_size=M", LENGTH, MESH_VOXEL)
@option("--trajectory=POSES", FILE, f"Write the poses: {words(NUMBERED)}.")
@option("--work=DIR", FILE, "Folder for intermediate files. Default: next to the mesh.")
@option("--resume", bool, "Reuse the intermediate files of an earlier run.")
@option("--config=JSON", FILE, "Settings, named as in Open3D's reconstruction system.")
@option("--slac", bool, "Also estimate and correct the depth distortion.")
@in_order(MODEL_UP, DEVICE, PICTURE)
@record_option("the trajectory and the model, or the stages of fragments")
@in_order(JSON, FORCE)
def reconstruct(frames: Path, output: Path, as_json: bool, force: bool, **options: Any) -> int:
    """Reconstruct a colored mesh from FRAMES, a folder of RGB-D frames without poses.

    \b
    slam       align each frame with the model of the earlier frames, and close loops at revisited places
    fragments  fuse about 100 frames each into fragments, and register the fragments from any pose. Intermediate
               files are kept, and --resume continues after an interruption. Options: --work, --config, --slac

    The exit code is 3 if frames were lost or fragments could not be joined. The summary lists them, and the mesh is
    still written. A blank gap of up to half a second after which tracking resumes is only a note. True poses in the
    folder are not used. The errors against them are printed (ATE, RPE). The layouts are those of pointloom track.

    \b
    pointloom reconstruct frames -o mesh.ply --picture mesh.png
    pointloom reconstruct frames -o mesh.ply --method fragments --work stages --resume
    pointloom reconstruct frames -o mesh.ply --method fragments --slac
    pointloom reconstruct frames -o mesh.ply --trajectory poses.log --intrinsic camera.json
    """
    _check_outputs(output, options)
    by_fragments, only = options.pop("method") == "fragments", {name: options.pop(name) for name in ONLY_FRAGMENTS}
    for name, value in only.items():
        if value and not by_fragments:
            refuse(f"--{name} requires --method fragments")
    from ..jobs.reconstruct import StageOptions, default_work_folder, reconstruct_folder
    from .recording_command import recorded

    outputs, stages = _outputs(output, options), StageOptions(**only) if by_fragments else None
    given = {"options": _folder_options(options), "stages": stages, "overwrite": force}
    kept = (only["work"] or default_work_folder(output)) if by_fragments else None
    with Progress(kept=kept, resume="" if only["resume"] else "--resume") as progress:
        report = recorded(reconstruct_folder, frames, outputs, progress=progress, **given, **options)
    return answer_with(report, f"{frames} ({report.folder.dataset.layout})", as_json)


def _folder_options(options: dict[str, Any]) -> FolderOptions:
    from ..jobs.frame_folder import FolderOptions

    return FolderOptions(**{name: options.pop(name) for name in FOLDER_OPTIONS if name in options})


def _outputs(mesh: Path, options: dict[str, Any]) -> ModelOutputs:
    from ..jobs.model_outputs import ModelOutputs

    return ModelOutputs(mesh, **{name: options.pop(name) for name in ("picture", "trajectory", "up")})


def _check_outputs(output: Path, options: dict[str, Any]) -> None:
    others = {name: options[name] for name in ("picture", "trajectory")}
    refuse_same(output=output, **others, record=options["record_as"])
    check_up(options["up"], output)


COMMANDS = (fuse, track, reconstruct)
