"""The whole chain as one job: a video or a folder of pictures in, a mesh out, and an account of every stage."""

from __future__ import annotations

import contextlib
import os
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ...meshing.mesh_files import read_triangle_mesh
from ...pcd.camera import read_pinhole_camera_intrinsic
from ...pcd.checks import check_callback, check_count, check_seed
from ...pcd.devices import resolve_device
from ...pcd.errors import FileError
from ...pcd.io.atomic import atomic_write
from ...pcd.io.point_cloud import read_point_cloud
from ..console import ReportProgress, say_nothing, to_json
from ..work_folder import check_work_folder, held
from . import motion, surface
from .outputs import Outputs
from .report import is_hopeless, why_depth_poor, why_model_poor
from .stages import Chain, Made, Stage, peak_bytes_of_all
from .units import Units, fit_units

FilePath = str | os.PathLike[str]

STAGES = ("frames", "features", "matches", "model", "undistorted", "depth", "fused", "mesh")
MARKER, REPORT = "video.json", "report.json"
MAX_FRAMES, MAX_SIZE = 150, 960
FEWEST_PICTURES, SMALLEST = 2, 64  # of which something can be made


@dataclass(frozen=True, eq=False)
class Settings:
    """What decides the result, beside the pictures.

    Attributes:
        max_frames: The most pictures that are taken of a video, or of a folder.
        max_size: Longest side of the pictures that depth is estimated in [px].
        intrinsic: File of the camera (Open3D's JSON), or None: it is found.
        units: What is known of the size of things.
        seed: Of what is drawn.
    """

    max_frames: int = MAX_FRAMES
    max_size: int = MAX_SIZE
    intrinsic: FilePath | None = None
    units: Units = field(default_factory=Units)
    seed: int = 0

    def __post_init__(self):
        check_count("max_frames", self.max_frames, minimum=FEWEST_PICTURES)
        check_count("max_size", self.max_size, minimum=SMALLEST)
        check_seed(self.seed)
        if not isinstance(self.units, Units):
            raise TypeError(f"units: expected Units, got {type(self.units).__name__}")
        if self.intrinsic is not None:
            if not isinstance(self.intrinsic, str | os.PathLike):
                raise TypeError(f"intrinsic: expected a path, got {type(self.intrinsic).__name__}")
            read_pinhole_camera_intrinsic(self.intrinsic)


def mesh_video(
    source: FilePath,
    output: FilePath,
    *,
    settings: Settings | None = None,
    cloud: FilePath | None = None,
    trajectory: FilePath | None = None,
    picture: FilePath | None = None,
    work: FilePath | None = None,
    resume: bool = False,
    device: Any = "auto",
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> dict[str, Any]:
    """Make a mesh of a video, or of a folder of pictures; outputs are checked before the work.

    Sharp frames are taken where the camera has moved (`frames`), what they share is found (`features`, `matches`) and
    tells where they were taken (`model`); pictures without distortion (`undistorted`) are matched pixel by pixel
    (`depth`), what several agree on is fused to points (`fused`) and to a surface (`mesh`).

    Args:
        source: A video that ffmpeg reads, or a folder of pictures.
        output: A .ply, .obj, .stl, .off or .glb file; STL holds no colours, which are then left out.
        settings: How many and how large pictures, the unit, the camera; None for the usual.
        cloud: A file for the fused points.
        trajectory: A file for the poses: .txt or .tum (TUM's format), .log.
        picture: A .png file for a picture of the mesh.
        work: Folder of the stages' files and of report.json; None for one that is removed at the end.
        resume: Keep what an earlier run left there and what still fits.
        device: Where to compute.
        overwrite: Replace outputs that exist.
        progress: Called with the stage, how many of its steps are done, and how many there are (0: nobody knows).

    Returns:
        What was done, in JSON's types: "stages" with what each cost and whether it was kept; "frames", "model",
        "undistorted", "depth", "fused", "mesh" (what each says, or None where it was not reached); "units" ("metres" or
        "arbitrary"), "fit"; "files"; "poor": why the result is poor or missing, or None.

    Raises:
        TypeError, ValueError: Settings out of range, or a picture that `known` names and that is not there.
        FileError: A source that is no video or folder of pictures, an output that cannot be written, a work folder that
            holds an earlier run, without `resume`. What stages finished stays there.
        DeviceError: No such device.

    Notes:
        The same bits from run to run, resumed or not.
    """
    settings = Settings() if settings is None else settings
    if not isinstance(settings, Settings):
        raise TypeError(f"settings: expected Settings, got {type(settings).__name__}")
    outputs = Outputs(output, cloud, trajectory, picture, overwrite)
    outputs.check()
    where, say = resolve_device(device), check_callback("progress", progress) or say_nothing
    content = motion.digest_of_source(source)
    if resume and work is None:
        raise ValueError("resume: goes with work, the folder of the earlier run")
    with _work_folder(work, output, resume=resume, overwrite=overwrite) as root:
        _write_json(root / MARKER, {"command": "video", "source": os.fspath(source)})
        (root / REPORT).unlink(missing_ok=True)  # of an earlier run: it would tell of files that are made again
        chain = Chain(root, STAGES, resume=resume, progress=say)
        report = _run(chain, source, content, settings, outputs, where)
        report = {"command": "video", "source": os.fspath(source), "device": str(where), **report}
        report["work"] = None if work is None else os.fspath(work)
        if work is not None:
            _write_json(root / REPORT, report)
    return report


def _run(
    chain: Chain, source: FilePath, content: str, settings: Settings, outputs: Outputs, device: Any
) -> dict[str, Any]:
    """Run the stages as far as they lead, and write what comes out."""
    files: list[str] = []
    model = _find_motion(chain, source, content, settings)
    poor = why_model_poor(model.told)
    if is_hopeless(model.told):
        return _account(chain, None, [], poor)
    placed = motion.read_model(model)
    fit = fit_units(settings.units, placed)  # before the long work: it may be refused
    poor += [] if fit.poor is None else [fit.poor]
    fused, mesh = _find_surface(chain, model, settings, device)
    poor += [reason] if (reason := why_depth_poor(fused.told)) is not None else []
    if mesh.told["triangles"]:
        path = surface.poses_of(placed.transform(fit.T_world_model))
        points = read_point_cloud(fused.folder / surface.CLOUD, device=device) if outputs.cloud is not None else None
        points = points if points is None else points.transform(fit.T_world_model)
        whole = read_triangle_mesh(mesh.folder / surface.MESH, device=device)
        files = outputs.write(whole, points, path, fit.told["units"])
    else:
        poor.append("the mesh is empty, and nothing was written; take more pictures")
    return _account(chain, fit, files, poor)


def _find_motion(chain: Chain, source: FilePath, content: str, settings: Settings) -> Made:
    """The stages up to the model."""
    frames = chain.run(
        Stage(
            "frames",
            lambda folder, say: motion.take_frames(folder, say, source=source, max_frames=settings.max_frames),
            {"source": content, "max_frames": settings.max_frames},
        )
    )
    settings.units.check_names(motion.picture_names(frames))
    lens = None if settings.intrinsic is None else read_pinhole_camera_intrinsic(settings.intrinsic)
    camera = None if lens is None else [lens.width, lens.height, lens.fx, lens.fy, lens.cx, lens.cy]
    seed = settings.seed
    features = chain.run(
        Stage(
            "features",
            lambda folder, say: motion.find_features(folder, say, frames=frames, intrinsic=lens, seed=seed),
            {"camera": camera, "seed": seed},
            (frames,),
        )
    )
    matches = chain.run(
        Stage(
            "matches",
            lambda folder, say: motion.match(folder, say, frames=frames, features=features, seed=seed),
            {"seed": seed},
            (frames, features),
        )
    )
    return chain.run(
        Stage(
            "model",
            lambda folder, say: motion.map_pictures(
                folder, say, frames=frames, matches=matches, fixed_camera=lens is not None, seed=seed
            ),
            {"fixed": lens is not None, "seed": seed},
            (frames, matches),
        )
    )


def _find_surface(chain: Chain, model: Made, settings: Settings, device: Any) -> tuple[Made, Made]:
    """The stages from the model on: the fused points, and the mesh."""
    frames, seed, size, units = chain.made["frames"], settings.seed, settings.max_size, settings.units
    undistorted = chain.run(
        Stage(
            "undistorted",
            lambda folder, say: surface.straighten(
                folder, say, frames=frames, model=model, max_size=size, device=device
            ),
            {"max_size": size},
            (frames, model),
        )
    )
    depth = chain.run(
        Stage(
            "depth",
            lambda folder, say: surface.estimate(folder, say, undistorted=undistorted, seed=seed, device=device),
            {"seed": seed},
            (undistorted,),
        )
    )
    fused = chain.run(
        Stage(
            "fused",
            lambda folder, say: surface.fuse_points(folder, say, undistorted=undistorted, depth=depth, device=device),
            {},
            (undistorted, depth),
        )
    )
    mesh = chain.run(
        Stage(
            "mesh",
            lambda folder, say: surface.make_mesh(
                folder, say, undistorted=undistorted, fused=fused, units=units, device=device
            ),
            {"units": units.settings},
            (undistorted, fused),
        )
    )
    return fused, mesh


def _account(chain: Chain, fit: Any, files: list[str], poor: list[str]) -> dict[str, Any]:
    """What was done, in JSON's types."""
    stages = {name: {"kept": made.kept, **made.cost} for name, made in chain.made.items()}
    told = {name: chain.made[name].told if name in chain.made else None for name in STAGES}
    units = {"units": "arbitrary" if fit is None else fit.told["units"], "fit": None if fit is None else fit.told}
    return {
        "stages": stages,
        **told,
        **units,
        "files": files,
        "peak_bytes": peak_bytes_of_all(),
        "poor": "; ".join(poor) or None,
    }


@contextlib.contextmanager
def _work_folder(work: FilePath | None, output: FilePath, *, resume: bool, overwrite: bool) -> Iterator[Path]:
    """The folder of the stages: the one that is asked for, or one beside the mesh that is removed at the end."""
    if work is not None:
        folder = check_work_folder(work, marker=MARKER, resume=resume, overwrite=overwrite)
        try:
            folder.mkdir(exist_ok=True)
        except OSError as error:
            raise FileError(folder, f"cannot be made: {error.strerror or error}") from error
        with held(folder):
            yield folder
        return
    parent = Path(output).absolute().parent  # not the system's folder for such, which is often small or in memory
    with tempfile.TemporaryDirectory(prefix=f".{Path(output).stem}-video-", dir=parent) as name:
        yield Path(name)


def _write_json(path: Path, content: dict[str, Any]) -> None:
    with atomic_write(path) as file:
        file.write(to_json(content).encode() + b"\n")
