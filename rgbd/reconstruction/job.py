"""The whole system as one job: frames without poses in, a model out, and an account of what is not in it."""

from __future__ import annotations

import itertools
import os
from typing import Any

from ...core import watching
from ...core.checks import check_progress
from ...core.errors import FilePath
from ...core.progress import ReportProgress
from ...core.timing import Clock, peak_bytes
from ...files.frames.datasets import open_frames
from ...files.frames.frames import FrameSource
from ...files.frames.recordings import record_frames
from ...files.frames.rgbd_sources import RGBDSource
from .config import ReconstructionConfig
from .fragments import FragmentSet, make_fragments
from .frames import LostFrame
from .nonrigid import refine_with_slac, slac_params
from .placement import Placement, register_fragments
from .places import Places
from .refinement import refine_registration
from .scene import Scene, integrate_scene

CONFIG_FILE = "config.json"
RECORDING = "frames"


def run_system(
    source: FrameSource,
    config: ReconstructionConfig | None = None,
    folder: FilePath = "reconstruction",
    *,
    resume: bool = False,
    refine: bool = True,
    slac: bool = False,
    device: Any = None,
    progress: ReportProgress | None = None,
) -> dict[str, Any]:
    """Frames of a moving depth camera, without poses, to a mesh and the camera's path.

    `make_fragments`, `register_fragments`, `refine_registration`, `refine_with_slac` where it is asked for, and
    `integrate_scene`, one after the other, in one folder. Each stage writes whole files and then a record of what they
    were made from.

    Args:
        source: Frames of one camera that can be read by their place: `open_frames`, `open_dataset`, `room_sequence`. A
            stream (any other `RGBDSource`) is recorded to `frames/` in the job's folder first, until it ends.
        config: Sizes and names; None for the defaults.
        folder: Of the job; it is made where it is missing, and earlier results in it are replaced.
        resume: Keep what an earlier run finished and what still fits: the same frames, configuration and files. A run
            that was interrupted loses at most the fragment that it was at. Of a stream what was recorded is taken.
        refine: Whether to run `refine_registration`.
        slac: Whether to run `refine_with_slac`, and fuse the frames through its grid.
        device: Where to compute; None for the CPU.
        progress: Called with each stage, how many of its steps are done, and how many there are (0: nobody knows).

    Returns:
        What was done, in JSON's types: "fragments", "frames", "used" (frames in the model), "lost" (runs of frames that
        are not in the model, each with stage and reason), "slac" (its figures, or None), "mesh" with its figures,
        "trajectory_error" where the source knows the true poses, "files", "seconds", "resumed" (what was kept), and
        "poor": why the result is poor, or None. Where nothing hangs together no model is written, and that is said.

    Raises:
        TypeError, ValueError: As of `make_fragments` and, with `slac`, of `refine_with_slac`.
        FileError: A file that cannot be written, as on a full disk; a recording that is there already, without
            `resume`. What was finished stays for `resume`.
        DeviceError: No such device.

    Notes:
        The same bits from run to run, resumed or not, whatever the number of threads.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.app.scenes.room import room_sequence
        >>> frames = room_sequence(300, width=80, height=60)
        >>> class First:
        ...     intrinsic, depth_scale, read = frames.intrinsic, frames.depth_scale, frames.read
        ...     def __len__(self): return 8
        >>> sizes = {"n_frames_per_fragment": 4, "tsdf_voxel_size": 0.02, "depth_max": 4.0}
        >>> report = loom.reconstruction.run_system(First(), loom.reconstruction.ReconstructionConfig(**sizes), "job")
        >>> report["used"], report["lost"], report["trajectory_error"]["rmse"] < 0.02
        (8, [], True)
    """
    config = ReconstructionConfig() if config is None else config
    places, clock = Places.make(folder, config), Clock()
    say = check_progress(progress)
    options: dict[str, Any] = {"resume": resume, "device": device, "progress": say}
    if slac:
        slac_params(config)  # what it does not take is told before the work
    config.write(places.root / CONFIG_FILE)
    frames = _readable(source, places, resume, say)
    clock.stop("record")
    watching.report("stage", name="fragments")
    found = make_fragments(frames, config, folder, **options)
    clock.stop("fragments")
    placement, bent, scene = None, None, None
    if found.fragments:
        watching.report("stage", name="register")
        placement = register_fragments(config, folder, **options)
        clock.stop("register")
        if refine:
            placement = refine_registration(config, folder, **options)
            clock.stop("refine")
        if slac:
            bent = refine_with_slac(config, folder, **options)
            placement = bent.placement
            clock.stop("slac")
        watching.report("stage", name="integrate")
        scene = integrate_scene(frames, config, folder, slac=slac, **options)
        clock.stop("integrate")
    report = {"command": "reconstruct", "method": "fragments", "folder": os.fspath(folder), "frames": len(frames)}
    report |= describe(found, placement, scene, len(frames)) | {"slac": None if bent is None else bent.figures}
    return report | {"seconds": clock.seconds, "peak_bytes": peak_bytes()}


def _readable(source: Any, places: Places, resume: bool, say: ReportProgress) -> FrameSource:
    """Frames that can be read by their place: the source's own, or a recording of it."""
    if hasattr(source, "read") and hasattr(source, "__len__"):
        return source
    if not isinstance(source, RGBDSource):
        raise TypeError(f"source: expected frames of an RGBDSource, got {type(source).__name__}")
    folder = places.root / RECORDING
    if not (resume and folder.exists()):
        record_frames(source, folder, progress=say)
    return open_frames(folder)


def describe(found: FragmentSet, placement: Placement | None, scene: Scene | None, frame_count: int) -> dict[str, Any]:
    """What stages made, in JSON's types."""
    placed = [False] * len(found.fragments) if placement is None else placement.placed.tolist()
    lost = lost_frames(found, placed, scene)
    fragments = [
        {
            "number": f.number,
            "frames": len(f),
            "first": f.names[0],
            "last": f.names[-1],
            "placed": is_placed,
            "broke": f.broke,
            "joined": f.joint is not None,
            "loops": dict(zip(("tried", "aligned", "kept"), f.loops, strict=True)),
        }
        for f, is_placed in zip(found.fragments, placed, strict=True)
    ]
    edges = [] if placement is None else placement.pose_graph.edges
    files = [] if scene is None else [p for p in (scene.mesh_path, scene.trajectory_path) if p is not None]
    figures = {} if scene is None else dict(scene.figures)
    error = figures.pop("trajectory_error", None)
    return {
        "used": frame_count - sum(run["count"] for run in lost),
        "lost": lost,
        "fragments": fragments,
        "edges": len(edges),
        "loops": sum(edge.uncertain for edge in edges),
        "mesh": figures or None,
        "trajectory_error": error,
        "resumed": {"fragments": found.kept},
        "files": [os.fspath(path) for path in files],
        "poor": _why_poor(lost, scene, frame_count),
    }


def lost_frames(found: FragmentSet, placed: list[bool], scene: Scene | None) -> list[dict[str, Any]]:
    """Runs of frames that are not in the model, in order: first and last name, count, stage and reason."""
    entries = [(frame, "make_fragments") for frame in found.lost]
    for fragment, is_placed in zip(found.fragments, placed, strict=True):
        if not is_placed:
            reason = f"fragment {fragment.number} could not be joined with the others"
            frames = zip(fragment.indices.tolist(), fragment.names, strict=True)
            entries += [(LostFrame(i, name, reason), "register_fragments") for i, name in frames]
    if scene is not None:
        entries += [(frame, "integrate_scene") for frame in scene.lost]
    entries.sort(key=lambda entry: entry[0].index)
    runs = []
    # equal while the reasons are, and the places follow each other
    keys = ((frame.index - k, stage, frame.reason) for k, (frame, stage) in enumerate(entries))
    for (_, stage, reason), run in itertools.groupby(zip(keys, entries, strict=True), key=lambda pair: pair[0]):
        frames = [entry[0] for _, entry in run]
        ends = {"first": frames[0].name, "last": frames[-1].name, "first_index": frames[0].index}
        runs.append(ends | {"count": len(frames), "stage": stage, "reason": reason})
    return runs


def _why_poor(lost: list[dict[str, Any]], scene: Scene | None, frame_count: int) -> str | None:
    if scene is None:
        return f"no two of the {frame_count} frames hang together, and nothing was written; {lost[0]['reason']}"
    reasons = []
    if scene.mesh_path is None:
        reasons.append("the mesh is empty, and was not written: no voxel was seen often enough; take more frames")
    if lost:
        count = sum(run["count"] for run in lost)
        where = f"{lost[0]['first']} and on" if len(lost) == 1 else f"{len(lost)} runs, the first at {lost[0]['first']}"
        reasons.append(f"{count} of {frame_count} frames are not in the model ({where}): {lost[0]['reason']}")
    return "; ".join(reasons) or None
