"""The stages from images to a mesh.

The parameters of a stage function are its inputs: earlier stages by name, or settings.
"""

from __future__ import annotations

import contextlib
import inspect
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from importlib import metadata
from typing import Any

from ...core.stages import Chain, Stage, StageResult
from . import known_motion, motion, surface
from .settings import VideoSettings

# In execution order.
STAGES: dict[str, Callable[..., Mapping[str, Any]]] = {
    "frames": motion.take_frames,
    "features": motion.find_features,
    "matches": motion.match,
    "model": motion.map_images,
    "undistorted": surface.straighten,
    "depth": surface.estimate,
    "fused": surface.fuse_points,
    "mesh": surface.make_mesh,
}

# With known lenses and poses.
KNOWN_STAGES: dict[str, Callable[..., Mapping[str, Any]]] = STAGES | {
    "frames": known_motion.take_images,
    "features": known_motion.find_features,
    "matches": known_motion.match,
    "model": known_motion.triangulate,
}

# Increased when a stage changes its output between two releases.
STAGE_VERSIONS = {"frames": 2, "matches": 2, "model": 2, "depth": 2, "fused": 2}
OF_COLMAP = ("features", "matches", "model")
COLMAP_PACKAGES = ("pycolmap", "pycolmap-cuda12")


@dataclass(frozen=True, eq=False)
class Given:
    """A stage setting: its `value`, and its `recorded` form (JSON types; nothing if it does not affect the files)."""

    value: Any
    recorded: Mapping[str, Any]


def settings_of_stages(source: Any, content: str, settings: VideoSettings, device: Any) -> dict[str, Given]:
    lens = settings.read_camera()
    camera = None if lens is None else [lens.width, lens.height, lens.fx, lens.fy, lens.cx, lens.cy]
    return {
        "source": Given(source, {"source": content}),
        "max_frames": Given(settings.max_frames, {"max_frames": settings.max_frames}),
        "masks": Given(settings.masks, settings.digest_of_masks()),
        "camera_model": Given(settings.camera_model, {"camera_model": settings.camera_model}),
        "max_features": Given(settings.max_features, {"max_features": settings.max_features}),
        "mapper": Given(settings.mapper, {"mapper": settings.mapper}),
        "pairs": Given(settings.pairs, {"pairs": settings.pairs}),
        "intrinsic": Given(lens, {"camera": camera}),
        "fixed_camera": Given(lens is not None or settings.panorama, {"fixed": lens is not None or settings.panorama}),
        "panorama": Given(settings.panorama, {"panorama": settings.panorama}),
        "max_size": Given(settings.max_size, {"max_size": settings.max_size}),
        "units": Given(settings.units, {"units": settings.units.settings}),
        "seed": Given(settings.seed, {"seed": settings.seed}),
        "posed": Given(settings, {"cameras": settings.digest_of_cameras(), "camera": camera}),
        "device": Given(device, {}),
    }


def run_to(
    last: str, chain: Chain, given: Mapping[str, Given], stages: Mapping[str, Callable[..., Mapping[str, Any]]] = STAGES
) -> StageResult:
    """Run the stages up to `last` or reuse them. Returns the record of the last."""
    for name, make in stages.items():
        if name not in chain.made:
            chain.run(stage_of(name, make, chain.made, given))
        if name == last:
            break
    return chain.made[last]


def stage_of(
    name: str, make: Callable[..., Mapping[str, Any]], made: Mapping[str, StageResult], given: Mapping[str, Given]
) -> Stage:
    _folder, _report, *wanted = inspect.signature(make).parameters
    goes_on = "checkpoints" in wanted
    wanted = [each for each in wanted if each != "checkpoints"]
    files = {each: made[each] for each in wanted if each in made}
    settings = {each: given[each] for each in wanted if each not in made}
    recorded = {key: value for each in settings.values() for key, value in each.recorded.items()}
    arguments = files | {each: setting.value for each, setting in settings.items()}
    given_to = partial(make, **arguments)
    return Stage(name, given_to, recorded, tuple(files.values()), STAGE_VERSIONS.get(name, 1), code_of(name), goes_on)


def code_of(name: str) -> dict[str, str]:
    packages = {"pointloom": ("pointloom",)} | ({"pycolmap": COLMAP_PACKAGES} if name in OF_COLMAP else {})
    return {package: _version_of(names) for package, names in packages.items()}


def _version_of(names: tuple[str, ...]) -> str:
    for name in names:
        with contextlib.suppress(metadata.PackageNotFoundError):
            version = metadata.version(name)
            return version if name == names[0] else f"{version} ({name})"
    return "unknown"
