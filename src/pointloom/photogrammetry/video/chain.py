"""The stages from images to a mesh, with their inputs."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import partial
from importlib import metadata

from ...core.errors import FilePath
from ...core.stages import Chain, Stage, StageResult
from ...kernels.array_types import Device
from . import known_motion, motion, surface
from .settings import VideoSettings

COLMAP_PACKAGES = ("pycolmap", "pycolmap-cuda12")

# Settings that are recorded as they are, and those with another record.
PLAIN_SETTINGS = ("max_frames", "camera_model", "max_features", "mapper", "pairs", "panorama", "max_size", "seed")
OTHER_SETTINGS = ("source", "masks", "intrinsic", "fixed_camera", "units", "posed", "device")


@dataclass(frozen=True)
class DeclaredStage:
    """A stage function and its inputs.

    Attributes:
        inputs: Keyword arguments of `make`: earlier stages or settings, by name.
        version: Increased when the stage changes its output between two releases.
        resumes: If True, `make` gets a folder for checkpoints.
        uses_colmap: If True, another version of pycolmap invalidates the result.
    """

    name: str
    make: Callable[..., Mapping[str, object]]
    inputs: tuple[str, ...]
    version: int = 1
    resumes: bool = False
    uses_colmap: bool = False


def in_order(*stages: DeclaredStage) -> dict[str, DeclaredStage]:
    """Stages by name, in execution order. Raises `ValueError` for an input that is not a setting or earlier stage."""
    known = {*PLAIN_SETTINGS, *OTHER_SETTINGS}
    for stage in stages:
        if unknown := [name for name in stage.inputs if name not in known]:
            raise ValueError(f"{stage.name}: expected settings or earlier stages as inputs, got {', '.join(unknown)}")
        known.add(stage.name)
    return {stage.name: stage for stage in stages}


_SURFACE_STAGES = (
    DeclaredStage("undistorted", surface.straighten, ("frames", "model", "max_size", "device")),
    DeclaredStage("depth", surface.estimate, ("undistorted", "seed", "device"), version=2, resumes=True),
    DeclaredStage("fused", surface.fuse_points, ("undistorted", "depth", "device"), version=2),
    DeclaredStage("mesh", surface.make_mesh, ("model", "undistorted", "fused", "units", "device")),
)

_FEATURE_INPUTS = ("frames", "intrinsic", "camera_model", "max_features", "panorama", "seed")
_MODEL_INPUTS = ("frames", "matches", "fixed_camera", "mapper", "panorama", "seed")

STAGES = in_order(
    DeclaredStage("frames", motion.take_frames, ("source", "max_frames", "masks", "panorama"), version=2),
    DeclaredStage("features", motion.find_features, _FEATURE_INPUTS, uses_colmap=True),
    DeclaredStage("matches", motion.match, ("frames", "features", "pairs", "seed"), version=2, uses_colmap=True),
    DeclaredStage("model", motion.map_images, _MODEL_INPUTS, version=2, uses_colmap=True),
    *_SURFACE_STAGES,
)

# With known lenses and poses.
KNOWN_STAGES = in_order(
    DeclaredStage("frames", known_motion.take_images, ("source", "max_frames", "posed", "masks"), version=2),
    DeclaredStage("features", known_motion.find_features, ("frames", "max_features", "seed"), uses_colmap=True),
    DeclaredStage("matches", known_motion.match, ("frames", "features", "device"), version=2, uses_colmap=True),
    DeclaredStage(
        "model", known_motion.triangulate, ("frames", "features", "matches", "seed"), version=2, uses_colmap=True
    ),
    *_SURFACE_STAGES,
)


@dataclass(frozen=True, eq=False)
class Given:
    """A stage setting: its `value`, and its `recorded` form (JSON types; nothing if it does not affect the files)."""

    value: object
    recorded: Mapping[str, object]


def settings_of_stages(source: FilePath, content: str, settings: VideoSettings, device: Device) -> dict[str, Given]:
    lens = settings.read_camera()
    camera = None if lens is None else [lens.width, lens.height, lens.fx, lens.fy, lens.cx, lens.cy]
    fixed = lens is not None or settings.panorama
    return {name: Given(getattr(settings, name), {name: getattr(settings, name)}) for name in PLAIN_SETTINGS} | {
        "source": Given(source, {"source": content}),
        "masks": Given(settings.masks, settings.digest_of_masks()),
        "intrinsic": Given(lens, {"camera": camera}),
        "fixed_camera": Given(fixed, {"fixed": fixed}),
        "units": Given(settings.units, {"units": settings.units.settings}),
        "posed": Given(settings, {"cameras": settings.digest_of_cameras(), "camera": camera}),
        "device": Given(device, {}),
    }


def run_to(last: str, chain: Chain, given: Mapping[str, Given], stages: Iterable[DeclaredStage]) -> StageResult:
    """Run the stages up to `last` or reuse them. Returns the record of the last."""
    for stage in stages:
        if stage.name not in chain.made:
            chain.run(stage_of(stage, chain.made, given))
        if stage.name == last:
            break
    return chain.made[last]


def stage_of(stage: DeclaredStage, made: Mapping[str, StageResult], given: Mapping[str, Given]) -> Stage:
    files = {name: made[name] for name in stage.inputs if name in made}
    settings = {name: given[name] for name in stage.inputs if name not in made}
    recorded = {key: value for setting in settings.values() for key, value in setting.recorded.items()}
    make = partial(stage.make, **files, **{name: setting.value for name, setting in settings.items()})
    packages = {"pointloom": _version_of("pointloom")}
    if stage.uses_colmap:
        packages["pycolmap"] = _version_of(*COLMAP_PACKAGES)
    return Stage(stage.name, make, recorded, tuple(files.values()), stage.version, packages, stage.resumes)


def _version_of(*names: str) -> str:
    for name in names:
        with contextlib.suppress(metadata.PackageNotFoundError):
            version = metadata.version(name)
            return version if name == names[0] else f"{version} ({name})"
    return "unknown"
