"""The stages from images to a mesh, with their inputs."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cache, partial
from importlib import metadata

from ...core.errors import FilePath
from ...core.json_fields import (
    Check,
    builds,
    has_fields,
    is_count,
    is_flag,
    is_number,
    is_object,
    is_text,
    list_of,
    numbers,
    optional,
    record_of,
)
from ...core.stages import Chain, Stage, StageResult
from ...kernels.array_types import Device
from ..sfm.model_quality import ModelQuality
from ..sfm.pose_check import PoseCheck
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
        is_report: Check of the fields of its record.
    """

    name: str
    make: Callable[..., Mapping[str, object]]
    inputs: tuple[str, ...]
    version: int = 1
    resumes: bool = False
    uses_colmap: bool = False
    is_report: Check = is_object


_TEXTS, _NOTES = list_of(is_text), ("notes", "warnings")  # which older records lack
_FRAMES = {"frames": is_count, "kept": is_count, "notes": _TEXTS, "warnings": _TEXTS}
_MODEL = {"cameras": _TEXTS, "turned": is_flag, "notes": _TEXTS}
_CORNERS = has_fields({"min": numbers(3), "max": numbers(3)})
_MESH = {**dict.fromkeys(("vertices", "triangles", "floaters"), is_count), "bounds": optional(_CORNERS)}


def _is_model(value: object) -> bool:
    is_quality = has_fields(_MODEL, _NOTES)(value) and record_of(ModelQuality)(value)
    return is_quality and builds(lambda record: ModelQuality.from_json(record).notes)(value)


def _is_pose_check(value: object) -> bool:
    return record_of(PoseCheck)(value) and builds(lambda record: PoseCheck.from_json(record).reasons(1))(value)


# The fields that `VideoFigures` and later stages read from the record of a stage, by its function.
REPORTS: dict[Callable[..., object], Check] = {
    motion.take_frames: has_fields(_FRAMES, ("warnings",)),
    motion.find_features: has_fields({"notes": _TEXTS}, _NOTES),
    motion.map_images: _is_model,
    known_motion.take_images: has_fields({**_FRAMES, "missing": is_count}, ("warnings",)),
    known_motion.find_features: has_fields({"notes": _TEXTS}, _NOTES),
    known_motion.match: has_fields({"poses": _is_pose_check}),
    known_motion.triangulate: _is_model,
    surface.straighten: has_fields({"sizes": lambda value: value != [] and list_of(list_of(is_count, 2))(value)}),
    surface.fuse_points: has_fields({"fraction": is_number, "points": is_count}),
    surface.make_mesh: has_fields(_MESH),
}


def in_order(*stages: DeclaredStage) -> dict[str, DeclaredStage]:
    """Stages by name, in execution order. Raises `ValueError` for an input that is not a setting or earlier stage."""
    known = {*PLAIN_SETTINGS, *OTHER_SETTINGS}
    for stage in stages:
        if unknown := [name for name in stage.inputs if name not in known]:
            raise ValueError(f"{stage.name}: expected settings or earlier stages as inputs, got {', '.join(unknown)}")
        known.add(stage.name)
    return {stage.name: replace(stage, is_report=REPORTS.get(stage.make, is_object)) for stage in stages}


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
    how = stage.version, packages, stage.resumes, stage.is_report
    return Stage(stage.name, make, recorded, tuple(files.values()), *how)


@cache
def _version_of(*names: str) -> str:
    for name in names:
        with contextlib.suppress(metadata.PackageNotFoundError):
            version = metadata.version(name)
            return version if name == names[0] else f"{version} ({name})"
    return "unknown"
